"""The emitted governors: free of warnings, equal to NumPy and CasADi, robust, and quick enough."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from dataclasses import fields, replace
from pathlib import Path

import casadi as ca
import numpy as np
import pytest
from governor_problems import Problems, Sizes, compiled, governed_block, random_problems, tables, write_sources
from reference_program import ReferenceProgram

from ptgen.block.block import Call
from ptgen.block.casadi_evaluator import CasadiBlock
from ptgen.emit.block_files import block_files, common_context
from ptgen.emit.c_expressions import Precision
from ptgen.emit.governor_source import uses_governor
from ptgen.shaping.optimal import LIMITED, NOT_SOLVED, optimal_governor
from ptgen.shaping.sequential import sequential_governor

STRICT = ["-std=c99", "-O2", "-Wall", "-Wextra", "-Wconversion", "-Wdouble-promotion", "-pedantic", "-Werror"]

SIZES = {
    "three machines": Sizes(),
    "one machine": Sizes(m=1, n=2, counts=(0,), group=(0,), order=(0, 0)),
    "two machines": Sizes(m=2, n=5, counts=(13, 1), group=(0, 0), order=(1, 1, 0, 0), seed=2),
    "five machines": Sizes(
        m=5, n=17, counts=(50, 47, 0, 60, 52), group=(0, 1, 1, 2, 2), order=(1, 1, 2, 2, 3, 3, 4, 4, 0, 0), seed=3
    ),
}

Values = dict[str, np.ndarray]

RESULTS = ("sequential", "shaped", "slack", "iterations", "status")


@pytest.fixture(params=SIZES, scope="module")
def sizes(request: pytest.FixtureRequest) -> Sizes:
    return SIZES[request.param]


def by_numpy(sizes: Sizes, p: Problems) -> Values:
    rows_x, rows_r = tables(sizes)
    shared = (p.wanted, p.before, p.free, p.gain, p.least, p.most)
    group = np.array(sizes.group)
    sequential = sequential_governor(*shared, p.reserve, p.rate_step, p.tie, p.modified, group, *sizes.order)
    optimal = (p.deviation, rows_x, rows_r, p.weight, p.tie, group, sequential)
    results = optimal_governor(np.array(1.0), *shared, *optimal, *sizes.counts, sizes.iterations)
    return dict(zip(RESULTS, (sequential, *results), strict=True))


def states(p: Problems) -> Values:
    values = {f.name: getattr(p, f.name) for f in fields(p) if f.name != "gain"}
    return {**values, "gains": p.gain.reshape(len(p), -1), "chosen": np.ones(len(p))}


def by_c(sizes: Sizes, p: Problems, precision: Precision = "double") -> Values:
    block = compiled(sizes, precision)
    params = block.defaults()
    status, state = block.init(params)
    assert status == 0
    rows: dict[str, list[np.ndarray]] = {name: [] for name in RESULTS}
    given = states(p)
    for k in range(len(p)):
        for name, values in given.items():
            block.write(state, name, values[k])
        block.step(state, params, {"time": 0.0})
        for name in RESULTS:
            rows[name].append(block.read(state, name))
    return {name: np.array(values) for name, values in rows.items()}


def by_casadi(sizes: Sizes, p: Problems) -> Values:
    block = governed_block(sizes)
    given, size = states(p), len(p)
    table = [given.get(s.name, np.zeros((size, s.size))).reshape(size, -1).T for s in block.states]
    after, _ = CasadiBlock(block).step(ca.DM.ones(1, size), ca.DM(0, size), np.concatenate(table), ca.DM.zeros(1, size))
    ends = np.cumsum([s.size for s in block.states])
    parts = np.split(np.array(after), ends[:-1])
    found = {s.name: part.T if s.shape else part[0] for s, part in zip(block.states, parts, strict=True)}
    return {name: found[name] for name in RESULTS}


@pytest.mark.compile
def test_three_evaluators_agree(sizes: Sizes) -> None:
    p = random_problems(sizes, 1500, 11)
    expected = by_numpy(sizes, p)
    assert len({*expected["status"]}) == 3 and not np.any(expected["status"] == NOT_SOLVED)
    for other in (by_c(sizes, p), by_casadi(sizes, p)):
        assert np.array_equal(other["iterations"], expected["iterations"])
        assert np.array_equal(other["status"], expected["status"])
        for name in ("sequential", "shaped", "slack"):
            size = np.abs(p.before).max() if name != "slack" else np.abs(p.most).max()
            assert np.abs(other[name] - expected[name]).max() <= 1e-12 * size, name


@pytest.mark.compile
def test_evaluators_agree_when_the_bound_is_hit() -> None:
    sizes = Sizes(iterations=2)
    p = random_problems(sizes, 500, 12)
    expected = by_numpy(sizes, p)
    assert 20 < np.sum(expected["status"] == NOT_SOLVED) < 480
    for other in (by_c(sizes, p), by_casadi(sizes, p)):
        for name in RESULTS:
            assert other[name] == pytest.approx(expected[name], rel=1e-12, abs=1e-9), name


@pytest.mark.compile
def test_single_precision(sizes: Sizes) -> None:
    """Limits are kept, and nothing of worth is lost, to what single precision can tell."""
    p = random_problems(sizes, 1500, 13)
    expected, got = by_numpy(sizes, p), by_c(sizes, p, "float")
    assert not np.any(got["status"] == NOT_SOLVED)
    assert np.mean(got["status"] == expected["status"]) > 0.98
    size = np.maximum(np.abs(p.before), np.abs(p.wanted))
    assert np.all(got["shaped"] >= np.minimum(p.before, p.wanted) - 1e-6 * size)
    assert np.all(got["shaped"] <= np.maximum(p.before, p.wanted) + 1e-6 * size)
    for k in range(0, len(p), 5):
        program = ReferenceProgram(sizes, p[k])
        largest = max(np.abs(values).max() for values in program.values(p.wanted[k]))
        scale = (p.most - p.least)[k] + largest + np.abs(p.gain[k]) @ size[k]
        assert np.all(program.violation(got["shaped"][k]) <= got["slack"][k] + 1e-4 * scale)
        if expected["status"][k] == got["status"][k] <= LIMITED:
            difference = program.worth(program.share(got["shaped"][k])) - program.worth(
                program.share(expected["shaped"][k])
            )
            change = np.abs(p.wanted - p.before)[k]
            lost = 1e-4 + 1e-5 * np.max(size[k] / np.where(change > 0, change, np.inf))
            assert difference >= -lost * sizes.m * p.weight[k].sum()


@pytest.mark.compile
@pytest.mark.parametrize("precision", ["double", "float"])
@pytest.mark.parametrize("compiler", ["gcc", "clang"])
def test_compiles_without_warnings(compiler: str, precision: Precision, sizes: Sizes, tmp_path: Path) -> None:
    if shutil.which(compiler) is None:
        pytest.skip(f"{compiler} is not installed")
    for source in write_sources(sizes, tmp_path, precision):
        command = [compiler, *STRICT, "-c", str(source), "-o", str(source.with_suffix(".o"))]
        result = subprocess.run(command, capture_output=True, text=True, check=False)
        assert result.returncode == 0 and result.stderr == "", result.stderr


def test_obeys_the_rules_for_embedded_code(sizes: Sizes) -> None:
    text = block_files([governed_block(sizes)], common_context("bed", "", "", "double"))["bed_governor.c"]
    assert not re.search(r"\b(malloc|calloc|realloc|free|alloca) *\(|\bgoto\b", text)
    assert [line for line in re.findall(r"^static (?!const).*", text, re.M) if "(" not in line] == []


@pytest.mark.compile
@pytest.mark.parametrize("precision", ["double", "float"])
@pytest.mark.parametrize("size", ["three machines", "five machines", "two machines"])
def test_numbers_of_every_sort_under_sanitizers(size: str, precision: Precision, tmp_path: Path) -> None:
    sources = [path for path in write_sources(SIZES[size], tmp_path, precision) if not path.name.endswith("shaper.c")]
    program = tmp_path / "fuzz"
    checks = "-fsanitize=address,undefined,float-cast-overflow"
    flags = ["-std=c99", "-O1", checks, "-fno-sanitize-recover=all", f"-I{tmp_path}"]
    fuzz = Path(__file__).with_name("governor_fuzz.c")
    subprocess.run(["cc", *flags, "-o", program, fuzz, *sources, "-lm"], check=True)
    result = subprocess.run([program], capture_output=True, text=True, check=False)
    assert result.returncode == 0, result.stdout + result.stderr
    assert all(int(count) > 0 for count in result.stdout.split())


@pytest.mark.compile
def test_work_is_bounded(root: Path, tmp_path: Path) -> None:
    """Instructions of one solution with 240 rows, 9 states, 3 machines: 1 us is some 5000 of them at least."""
    if shutil.which("valgrind") is None:
        pytest.skip("valgrind is not installed")
    sys.path.insert(0, str(root / "bench"))
    import governor_kernels

    iterations, _ = governor_kernels.solve()
    for count, bound in ((0, 7_000), (5, 30_000)):
        program = governor_kernels.build(tmp_path, "double", int(np.flatnonzero(iterations == count)[0]), "cc")
        assert governor_kernels.instructions(program, "optimal") <= bound
        assert governor_kernels.instructions(program, "sequential") <= 5_000


def test_blocks_without_governor_have_no_code_for_it() -> None:
    block = governed_block(SIZES["two machines"])
    plain = replace(block, step=block.step[:4], tables=())
    assert uses_governor(plain, "double") is None
    assert "bed_governor.c" not in block_files([plain], common_context("bed", "", "", "double"))


def test_governors_of_one_block_are_the_same() -> None:
    block = governed_block(SIZES["two machines"])
    call = next(s for s in block.step if isinstance(s, Call) and s.kernel == "sequential_governor")
    other = replace(block, step=(*block.step, replace(call, numbers=(0, 0, 1, 1))))
    with pytest.raises(ValueError, match="differ in size or order"):
        uses_governor(other, "double")


def test_results_do_not_replace_inputs() -> None:
    block = governed_block(SIZES["two machines"])
    call = next(s for s in block.step if isinstance(s, Call) and s.kernel == "sequential_governor")
    other = replace(block, step=(*block.step, replace(call, outputs=("before",))))
    with pytest.raises(ValueError, match=r"\['before'\] cannot be both"):
        uses_governor(other, "double")

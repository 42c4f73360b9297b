"""Imports point the way the data flows, and knowledge that belongs in one place stays there."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

PACKAGE = Path(__file__).resolve().parents[2] / "ptgen"

# A part may import itself and what stands above it. Parts are modules and packages directly below ``ptgen``.
ORDER = (
    "errors",
    "files",
    "units",
    "elements",
    "components",
    "gears",
    "testbed",
    "mechanism",
    "friction",
    "shaping",
    "block",
    "plant",
    "control",
    "analysis",
    "governor",
    "project",
    "emit",
    "simulate",
    "loops",
    "report",
    "api",
    "cli",
    "__main__",
)

FILES = sorted(PACKAGE.rglob("*.py"))


def part_of(file: Path) -> str:
    return file.relative_to(PACKAGE).parts[0].removesuffix(".py")


def imports(file: Path) -> Iterator[tuple[int, str]]:
    """Yield line and dotted name of everything that a file imports, wherever in the file it does."""
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from ((node.lineno, alias.name) for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{file}:{node.lineno}: write the whole name of the module"
            module = node.module or ""
            if module == "ptgen":
                yield from ((node.lineno, f"ptgen.{alias.name}") for alias in node.names)
            else:
                yield node.lineno, module


def name_of(path: object) -> str:
    return str(Path(str(path)).relative_to(PACKAGE))


def test_every_part_has_its_place() -> None:
    found = {part_of(file) for file in FILES} - {"__init__", "_templates"}
    assert found <= set(ORDER), "add the new part to ORDER, where it belongs"
    assert set(ORDER) <= found


@pytest.mark.parametrize("file", FILES, ids=name_of)
def test_imports_point_upstream(file: Path) -> None:
    own = part_of(file)
    for line, name in imports(file):
        root, _, rest = name.partition(".")
        other = rest.partition(".")[0]
        if root != "ptgen" or other in ("", "__version__"):
            continue
        assert own != "__init__", f"line {line}: the package itself imports no part"
        assert ORDER.index(other) <= ORDER.index(own), f"line {line}: {own} comes before {other}"


def test_direction_check_sees_a_backward_import(tmp_path: Path) -> None:
    file = tmp_path / "wrong.py"
    file.write_text("def f():\n    from ptgen.control.lie import derivatives\n    import ptgen.plant.plant\n")
    assert [name for _, name in imports(file)] == ["ptgen.control.lie", "ptgen.plant.plant"]


def users(module: str) -> set[str]:
    return {name_of(file) for file in FILES if any(name.partition(".")[0] == module for _, name in imports(file))}


def test_one_module_knows_units() -> None:
    assert users("pint") == {"units.py"}


def strings(file: Path) -> Iterator[str]:
    """Yield all texts of a file that are no docstrings."""
    tree = ast.parse(file.read_text(encoding="utf-8"))
    documentation = {
        id(node.body[0].value)
        for node in ast.walk(tree)
        if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef)) and node.body
        if isinstance(node.body[0], ast.Expr)
    }
    for node in ast.walk(tree):
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in documentation:
            yield node.value


def test_one_module_knows_where_templates_lie() -> None:
    knowing = {name_of(file) for file in FILES if {"templates", "_templates"} & set(strings(file))}
    assert knowing == {"emit/templates.py"}
    assert users("jinja2") <= {"emit/templates.py"}


def test_catalogue_is_the_only_list_of_components() -> None:
    """No other module names the component types one by one or imports their modules."""
    from ptgen.components.catalogue import CATALOGUE

    modules = {component.__module__ for component in CATALOGUE.values()}
    for file in FILES:
        if name_of(file) == "components/catalogue.py":
            continue
        imported = {name for _, name in imports(file)} & modules
        assert not imported, f"{name_of(file)} imports {imported}; go through the catalogue"


def test_every_component_file_is_in_the_catalogue() -> None:
    from ptgen.components.catalogue import CATALOGUE
    from ptgen.components.component import Component
    from ptgen.components.part import Part

    def below(kind: type) -> set[type]:
        return {kind}.union(*(below(sub) for sub in kind.__subclasses__()))

    concrete = {kind for kind in below(Component) if kind.__module__.startswith("ptgen.") and "type_name" in vars(kind)}
    assert concrete == {*CATALOGUE.values(), Part}
    partials = {"clutched_gearbox_partial.py", "differential_partial.py", "friction_partial.py", "sensor_partial.py"}
    maps = {"converter_maps.py", "fluid_sectors.py", "map_table.py"}
    shared = {"__init__.py", "catalogue.py", "component.py", "friction.py", "part.py", *partials, *maps}
    stems = {component.__module__.rpartition(".")[2] + ".py" for component in CATALOGUE.values()}
    assert {file.name for file in (PACKAGE / "components").glob("*.py")} == stems | shared


@pytest.mark.parametrize("file", FILES, ids=name_of)
def test_nothing_is_left_for_later(file: Path) -> None:
    text = file.read_text(encoding="utf-8")
    for mark in ("TO" + "DO", "FIX" + "ME", "XXX", "HACK"):
        assert mark not in text


@pytest.mark.parametrize("file", sorted((PACKAGE.parent / "tests").rglob("*.py")), ids=lambda path: path.name)
def test_tests_leave_nothing_for_later(file: Path) -> None:
    text = file.read_text(encoding="utf-8")
    assert "TO" + "DO" not in text and "FIX" + "ME" not in text

"""A wheel in an environment of its own works from any folder, templates included."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import sysconfig
import venv
from pathlib import Path

import pytest


@pytest.mark.compile
def test_wheel_works_from_any_folder(root: Path, tmp_path: Path) -> None:
    wheels = tmp_path / "wheels"
    build = [
        sys.executable,
        "-m",
        "pip",
        "wheel",
        "--quiet",
        "--no-deps",
        "--no-build-isolation",
        "-w",
        str(wheels),
        str(root),
    ]
    subprocess.run(build, check=True, capture_output=True)
    (wheel,) = wheels.glob("ptgen-*.whl")

    environment = tmp_path / "environment"
    venv.create(environment, with_pip=False)
    python = environment / "bin" / "python"
    own = Path(
        subprocess.run(
            [python, "-c", "import sysconfig; print(sysconfig.get_path('purelib'))"],
            check=True,
            capture_output=True,
            text=True,
        ).stdout.strip()
    )
    shutil.unpack_archive(wheel, own, "zip")
    # Third-party packages come from here; ptgen itself does not, as its editable link lies in a .pth file there.
    (own / "dependencies.pth").write_text(sysconfig.get_path("purelib") + "\n")

    folder = tmp_path / "elsewhere"
    folder.mkdir()
    shutil.copy(root / "testbeds" / "back-to-back.toml", folder / "bed.toml")
    shutil.copy(root / "scenarios" / "back-to-back-steps.toml", folder / "scenario.toml")
    clean = {key: value for key, value in os.environ.items() if not key.startswith("PYTHON")}

    def ptgen(*arguments: str) -> str:
        command = [str(python), "-m", "ptgen", *arguments]
        result = subprocess.run(command, cwd=folder, env=clean, capture_output=True, text=True, check=False)
        assert result.returncode == 0, result.stderr
        return result.stdout

    where = [str(python), "-c", "import ptgen; print(ptgen.__file__)"]
    assert str(own) in subprocess.run(where, cwd=folder, env=clean, check=True, capture_output=True, text=True).stdout
    ptgen("generate", "bed.toml", "-o", "out")
    assert (folder / "out" / "back_to_back_controller.c").read_bytes() == (
        root / "generated" / "back-to-back" / "back_to_back_controller.c"
    ).read_bytes().replace(b"back-to-back.toml", b"bed.toml")
    summary = json.loads(ptgen("simulate", "bed.toml", "--scenario", "scenario.toml", "--json"))
    assert summary["steps"] > 0

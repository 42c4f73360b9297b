"""What the tests of the command line share: a runner in this process, and one in a process of its own."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner, Result

from ptgen.cli import app

ROOT = Path(__file__).parents[2]


class Cli:
    """Runs commands in this process, from the root of the repository."""

    def __init__(self) -> None:
        self._runner = CliRunner()

    def __call__(self, *arguments: object, code: int = 0) -> Result:
        result = self._runner.invoke(app, [str(argument) for argument in arguments])
        assert result.exit_code == code, (result.output, result.exception)
        assert "Traceback" not in result.output
        return result

    def json(self, *arguments: object, code: int = 0) -> Any:
        """Return the document on stdout, which must hold nothing else."""
        return json.loads(self(*arguments, "--json", code=code).stdout)


@pytest.fixture
def cli(monkeypatch: pytest.MonkeyPatch) -> Cli:
    monkeypatch.chdir(ROOT)
    monkeypatch.delenv("PTGEN_DEBUG", raising=False)
    return Cli()


@pytest.fixture
def process() -> Callable[..., subprocess.Popen[bytes]]:
    """Return a function that starts ``python -m ptgen`` in the root of the repository."""

    def start(*arguments: object, **options: Any) -> subprocess.Popen[bytes]:
        command = [sys.executable, "-m", "ptgen", *map(str, arguments)]
        return subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.PIPE, **options)

    return start

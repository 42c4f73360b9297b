"""How a command ends: the one place that turns errors into messages and exit codes.

==== ==========================================================================
0    done
1    a defect of ptgen: an unexpected exception
2    an error of the user: a problem in a file, a wrong option
130  interrupted from the keyboard
141  nobody reads the output any more, as in ``ptgen derive bed.toml | head``
==== ==========================================================================
"""

from __future__ import annotations

import functools
import os
import sys
from collections.abc import Callable
from typing import ParamSpec

import typer

from ptgen.cli.output import print_json
from ptgen.errors import PtgenError

__all__ = ["DEBUG", "abandon_output", "defect", "reported"]

DEBUG = "PTGEN_DEBUG"
"""Environment variable; set to 1, unexpected exceptions show their traceback."""

P = ParamSpec("P")


def reported(command: Callable[P, None]) -> Callable[P, None]:
    """Decorate a command so that each of its errors ends in a message and an exit code.

    With a keyword argument ``as_json`` that is true, problems are printed as JSON on stdout too.
    """

    @functools.wraps(command)
    def run(*args: P.args, **kwargs: P.kwargs) -> None:
        try:
            command(*args, **kwargs)
            sys.stdout.flush()
        except PtgenError as error:
            _report(error, as_json=bool(kwargs.get("as_json")))
            raise typer.Exit(2) from None
        except KeyboardInterrupt:
            _say("interrupted")
            raise typer.Exit(130) from None
        except BrokenPipeError:
            abandon_output()
            raise typer.Exit(141) from None
        except (typer.Exit, typer.Abort, typer.BadParameter):
            raise
        except Exception as error:
            if os.environ.get(DEBUG) == "1":
                raise
            defect(error)
            raise typer.Exit(1) from None

    return run


def defect(error: BaseException) -> None:
    """Tell about an unexpected exception, without its traceback."""
    _say(f"ptgen met a defect of its own: {type(error).__name__}: {error}")
    _say(f"set {DEBUG}=1 to see the traceback, and report it together with the file")


def abandon_output() -> None:
    """Send what is still to be written to nowhere, so that the interpreter ends in silence."""
    devnull = os.open(os.devnull, os.O_WRONLY)
    os.dup2(devnull, sys.stdout.fileno())
    os.close(devnull)


def _report(error: PtgenError, *, as_json: bool) -> None:
    for problem in error.problems:
        _say(problem.text(error.file))
    if as_json:
        problems = [
            {"file": error.file, "where": problem.where, "what": problem.what, "remedy": problem.remedy}
            for problem in error.problems
        ]
        print_json({"problems": problems})


def _say(line: str) -> None:
    typer.echo(line, err=True)

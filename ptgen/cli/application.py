"""The application: its commands and its entry point.

Commands import what they need when they run, so that ``ptgen --help`` starts at once.
"""

from __future__ import annotations

import os
import sys
from typing import Annotated

import typer

from ptgen import __version__
from ptgen.cli import code, gears, govern, loops, queries, simulation, tuning
from ptgen.cli.outcome import DEBUG, abandon_output, defect
from ptgen.cli.output import prepare_streams

__all__ = ["app", "common", "main"]

app = typer.Typer(
    name="ptgen",
    help="From one file that describes a power train test bed to its model, its decoupling controller and the C "
    "code of both.",
    epilog=f"Exit codes: 0 done, 2 a problem in a file or an option, 1 a defect of ptgen ({DEBUG}=1 shows its "
    "traceback).",
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
)


def _version(wanted: bool) -> None:
    if wanted:
        typer.echo(f"ptgen {__version__}")
        raise typer.Exit()


@app.callback()
def common(
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Print the version and exit.")
    ] = False,
) -> None:
    """Take the options that stand before the command."""


for _command in (
    queries.check,
    queries.show,
    queries.derive,
    queries.modal,
    gears.gears,
    loops.analyse,
    govern.govern,
    tuning.tune,
    code.generate,
    code.build,
    simulation.simulate,
    queries.schema,
):
    app.command()(_command)


def main() -> None:
    """Run the command line; the console script ``ptgen``."""
    prepare_streams()
    try:
        code = _run()
        sys.stdout.flush()
    except BrokenPipeError:
        abandon_output()
        code = 141
    except KeyboardInterrupt:
        code = 130
    except Exception as error:
        if os.environ.get(DEBUG) == "1":
            raise
        defect(error)
        code = 1
    sys.exit(code)


def _run() -> int | str | None:
    """Run the application and return its exit code."""
    try:
        app(prog_name="ptgen")
    except SystemExit as end:
        return end.code
    return 0

"""The command that finds gains: tune."""

from __future__ import annotations

from typing import Annotated

import typer

from ptgen.cli.options import AsJson, BedFile
from ptgen.cli.outcome import reported
from ptgen.cli.output import print_json, print_parts, progress

__all__ = ["tune"]


@reported
def tune(
    file: BedFile,
    speed_bandwidth: Annotated[
        str | None, typer.Option("--speed-bandwidth", metavar="QUANTITY", help='Of the speed control, as "5 Hz".')
    ] = None,
    torque_bandwidth: Annotated[
        str | None,
        typer.Option("--torque-bandwidth", metavar="QUANTITY", help='Of the torque control, as "30 rad/s".'),
    ] = None,
    torque_rise_time: Annotated[
        str | None,
        typer.Option("--torque-rise-time", metavar="QUANTITY", help='From 10 to 90 %, instead of it, as "70 ms".'),
    ] = None,
    damping_ratio: Annotated[
        str | None, typer.Option("--damping-ratio", metavar="NUMBER", help="Of the torque poles.")
    ] = None,
    delay_margin: Annotated[
        str | None,
        typer.Option("--delay-margin", metavar="QUANTITY", help='Delay that must leave it stable, as "300 us".'),
    ] = None,
    disk_margin: Annotated[
        str | None, typer.Option("--disk-margin", metavar="NUMBER", help="Disk margin that must be left.")
    ] = None,
    lock: Annotated[
        list[str] | None, typer.Option("--lock", metavar="ELEMENT", help="A friction element that sticks; repeatable.")
    ] = None,
    free: Annotated[
        list[str] | None,
        typer.Option(
            "--free", metavar="ELEMENT", help="A friction element that slips, though the file takes it for locked."
        ),
    ] = None,
    write: Annotated[
        bool, typer.Option("--write", help="Write the wishes that hold into section [control] of the file.")
    ] = False,
    as_json: AsJson = False,
) -> None:
    """Find the largest wishes that keep the margins, and what stands in the way; wishes default to the file's."""
    from ptgen.loops.loop_tuning import tune as run
    from ptgen.loops.loop_tuning import write_wishes
    from ptgen.project import Project

    project = Project.read(file)
    options = {
        "speed_bandwidth": speed_bandwidth,
        "torque_bandwidth": torque_bandwidth,
        "torque_rise_time": torque_rise_time,
        "damping_ratio": damping_ratio,
        "delay_margin": delay_margin,
        "disk_margin": disk_margin,
    }
    elements = {"locked": lock or (), "free": free or ()}
    with progress(project.testbed.title) as (show, advance):
        show("tune")
        found = run(project, options, **elements, progress=advance)
        if write:
            show("write")
        written = write_wishes(project, found, **elements) if write else None
    if as_json:
        from ptgen.report.loop_tuning_plain import tuning_json

        print_json(tuning_json(found, bool(written)))
    else:
        from ptgen.report.loop_tuning_text import tuning_text

        print_parts(tuning_text(found, written))

"""A tuning as plain data: what ``ptgen tune --json`` prints, in SI units and Hz."""

from __future__ import annotations

from typing import Any

from ptgen.analysis.demands import Check
from ptgen.loops.loop_tuning import LoopTuning, Obstacle, WishResult
from ptgen.report.loop_plain import mode_json

__all__ = ["tuning_json"]


def tuning_json(found: LoopTuning, written: bool = False) -> dict[str, Any]:
    """Return a tuning as plain data; numbers that are not finite stand for "never" or "any".

    Parameters
    ----------
    found : LoopTuning
    written : bool
        Whether the bed file was changed.
    """
    return {
        "name": found.name,
        "title": found.title,
        "locked": list(found.locked),
        "free": list(found.free),
        "sample_time": found.sample_time,
        "demands": {"delay_margin": found.demands.delay, "disk_margin": found.demands.disk},
        "holds_as_wished": found.holds_as_wished,
        "found": found.is_found,
        "robust": found.is_robust,
        "common": found.common,
        "wishes": [_wish(result) for result in found.wishes],
        "obstacle": _obstacle(found.obstacle),
        "least_obstacle": _obstacle(found.least),
        "wished_checks": [_check(check) for check in found.wished_checks],
        "held_checks": [_check(check) for check in found.held_checks],
        "gains": [
            {"name": g.name, "value": g.value, "unit": g.unit, "intervals": [list(pair) for pair in g.intervals]}
            for g in found.gains
        ],
        "helps": [{"name": x.name, "value": x.value, "switch": x.is_switch} for x in found.helps],
        "notes": list(found.notes),
        "evaluations": found.evaluations,
        "changes": dict(found.changes),
        "written": written,
    }


def _wish(result: WishResult) -> dict[str, Any]:
    return {
        "key": result.wish.key,
        "wanted": result.wish.wanted,
        "wanted_text": result.wish.text,
        "held": result.held,
        "held_text": result.text or None,
        "share": result.share,
        "alone": result.alone,
        "reduced": result.is_reduced,
        "obstacle": _obstacle(result.obstacle),
    }


def _check(check: Check) -> dict[str, Any]:
    return {
        "kind": check.kind,
        "machine": check.machine or None,
        "value": check.value,
        "wanted": check.wanted,
        "frequency_hz": check.frequency_hz,
        "holds": check.holds,
    }


def _obstacle(obstacle: Obstacle | None) -> dict[str, Any] | None:
    if obstacle is None:
        return None
    return {
        **_check(obstacle.check),
        "controls": obstacle.controls or None,
        "mode": mode_json(obstacle.mode),
        "phase_budget_deg": None if obstacle.budget is None else dict(obstacle.budget.degrees),
    }

"""The governors of a bed as plain data: what ``ptgen govern --json`` prints, in SI units."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

from ptgen.governor.constraint_set import ConstraintSet
from ptgen.loops.governed_run import GovernedRun
from ptgen.loops.governor_study import GovernorStudy

__all__ = ["STATUS_NAMES", "governor_json"]

STATUS_NAMES = {
    0: "nothing is held back",
    1: "a reference is held back",
    2: "a limit cannot be kept",
    3: "not solved",
    4: "parameters differ from the design",
}
"""What ``governor_status`` tells."""


def governor_json(study: GovernorStudy) -> dict[str, Any]:
    """Return a study as plain data."""
    limits = study.stationary
    return {
        "name": study.name,
        "title": study.title,
        "governor": study.settings.kind,
        "settings": study.settings.model_dump(),
        "sample_time": study.prediction.sample_time,
        "limits": [
            {
                "machine": machine,
                "torque_max": float(limits.torque_max[k]),
                "speed_rated": float(limits.speed_rated[k]),
                "speed_max": float(limits.speed_max[k]),
                "torque_at_rest": float(limits.torque_share[k] * limits.torque_max[k]),
                "speed_at_rest": float(limits.speed_share * limits.speed_max[k]),
            }
            for k, machine in enumerate(limits.machines)
        ],
        "stationary": {
            "references": list(limits.references),
            "torque": limits.torque.tolist(),
            "speed": limits.speed.tolist(),
            "largest": {
                reference: dict(zip(("value", "machine"), limits.largest(k), strict=True))
                for k, reference in enumerate(limits.references)
                if limits.units[k] == "N m"
            },
        },
        "order": [asdict(step) for step in study.order],
        "set": None if study.constraints is None else _set(study, study.constraints),
        "check": None if study.check is None else asdict(study.check),
        "scenario": study.scenario,
        "beyond": [asdict(entry) for entry in study.beyond],
        "runs": [_run(run) for run in study.runs],
    }


def _set(study: GovernorStudy, found: ConstraintSet) -> dict[str, Any]:
    return {
        "horizon": found.horizon * found.prediction.sample_time,
        "horizon_steps": found.horizon,
        "automatic": study.settings.horizon is None,
        "looked_at_steps": found.looked_at,
        "inequalities": found.all_rows,
        "kept_inequalities": found.kept_rows,
        "rows": {
            machine: {"all": found.horizon + 1, "kept": len(steps) + 1, "steps": [0, *map(int, steps)]}
            for machine, steps in zip(found.prediction.machines, found.steps, strict=True)
        },
        "removal": found.removal,
        "loss": found.loss,
        "programs": found.programs,
        "binding": dict(zip(found.prediction.machines, map(float, found.binding.max(axis=1)), strict=True)),
        "shorter": [
            {
                "horizon": entry.steps * found.prediction.sample_time,
                "steps": entry.steps,
                "kept_rows": entry.kept,
                "binding": dict(zip(found.prediction.machines, map(float, entry.binding), strict=True)),
            }
            for entry in study.shorter
        ],
    }


def _run(run: GovernedRun) -> dict[str, Any]:
    work = run.solver
    return {
        "bed": run.bed,
        "label": run.choice.label,
        "governor": run.choice.kind,
        "horizon": run.choice.horizon,
        "torque_weight": run.choice.torque_weight,
        "speed_weight": run.choice.speed_weight,
        "beyond_limit": [asdict(entry) for entry in run.beyond_limit],
        "beyond_reserve": [asdict(entry) for entry in run.beyond_reserve],
        "set_points": [asdict(point) for point in run.set_points],
        "statuses": {STATUS_NAMES.get(code, str(code)): count for code, count in sorted(work.statuses.items())},
        "mean_iterations": work.mean_iterations,
        "most_iterations": work.most_iterations,
        "slack": dict(work.slack),
    }

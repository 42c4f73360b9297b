"""How much a step of the testing torque moves a speed when the law runs sampled on the reduced plant."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import scipy.linalg

from ptgen.mechanism.model import evaluate_matrix
from ptgen.project import Project

BED = Path(__file__).resolve().parents[2] / "testbeds" / "differential.toml"


def coupling_by_sample_time(steps: list[float]) -> list[tuple[float, float]]:
    """Return (sample time, largest speed of M2 (rad/s) after a step of 100 N m of the torque controller).

    The continuous law keeps the speed at zero; sampled, the load torque compensation comes up to one step late.
    """
    design = Project.read(BED).design.decoupling
    values = {**design.values, **dict(zip(design.damping, [260.0], strict=True))}
    A, B = evaluate_matrix(design.system.A, values), evaluate_matrix(design.system.B, values)
    U_v, U_x = (evaluate_matrix(part, values) for part in (design.state_law.v, design.state_law.x))
    speed = evaluate_matrix(design.chains[1].rows[0], values)[0]
    result = []
    for h in steps:
        n, m = A.shape[0], B.shape[1]
        exponent = np.zeros((n + m, n + m))
        exponent[:n, :n], exponent[:n, n:] = A, B
        step = scipy.linalg.expm(exponent * h)[:n]
        x, worst = np.zeros(n), 0.0
        for _ in range(round(0.2 / h)):
            u = U_v @ np.array([100.0, 0.0, 0.0]) + U_x @ x
            x = step @ np.concatenate([x, u])
            worst = max(worst, abs(float(speed @ x)))
        result.append((h, worst))
    return result

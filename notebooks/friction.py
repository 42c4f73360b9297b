# ---
# jupyter:
#   jupytext:
#     formats: py:percent
#     text_representation:
#       extension: .py
#       format_name: percent
#       format_version: "1.3"
#   kernelspec:
#     display_name: Python 3
#     language: python
#     name: python3
# ---

# %% [markdown]
# # Friction torques of two coupled elements: nine sectors and three clamps
#
# The source divides the plane of (4.35) into nine sectors by lines and lists the friction torques of each
# sector in Table 4.1. `ptgen.friction.box.solve_box` finds them with three clamps and without any case
# distinction. Here both are compared on random problems; the source's lines are taken with (4.55) and (4.61)
# exchanged (docs/errata.md).
#
# Notation: K is K22 of (4.23), x and y the coordinates (4.35), m1 and m2 the largest static torques. In
# `solve_box` the velocity w at the end of the step without friction takes the place of (x, y).

# %%
import beds  # makes ptgen known
import numpy as np
from checking import check, summary

from ptgen.friction.box import solve_box

rng = np.random.default_rng(4)
COUNT = 100_000


def random_problems(count):
    """Positive definite matrices of all shapes, points of the plane around the sectors, limits."""
    angle, size = rng.uniform(0, np.pi, count), 10 ** rng.uniform(-2, 2, (count, 2))
    c, s = np.cos(angle), np.sin(angle)
    rotation = np.stack([np.stack([c, -s], -1), np.stack([s, c], -1)], -2)
    K = np.einsum("nij,nj,nkj->nik", rotation, size, rotation)
    m = 10 ** rng.uniform(-2, 2, (count, 2))
    xy = np.einsum("nij,nj->ni", K, rng.uniform(-3, 3, (count, 2)) * m)
    return K, xy, m


def wrong(found, expected, scale):
    """How many entries differ by more than rounding."""
    return int(np.sum(np.abs(found - expected) > 1e-9 * scale))


# %% [markdown]
# ## The nine sectors of Table 4.1
# Each sector is a set of inequalities between x, y and the lines of Figure 4.7.


# %%
def sectors(K, xy, m):
    """Return nine masks and the torques of Table 4.1 for each of them."""
    k11, k12, k21, k22 = K[:, 0, 0], K[:, 0, 1], K[:, 1, 0], K[:, 1, 1]
    (x, y), (m1, m2) = xy.T, m.T
    det = k11 * k22 - k12 * k21
    both1, both2 = (k22 * x - k12 * y) / det, (k11 * y - k21 * x) / det  # (4.32)

    def beyond(sign):
        """On the outer side of (4.55) or (4.61), exchanged; the side depends on the sign of k12."""
        return sign * k12 * (k22 / k12 * x - sign * det * m1 / k12 - y) >= 0

    masks = [
        (abs(both1) <= m1) & (abs(both2) <= m2),  # (4.36), (4.37)
        (abs(x - k12 * m2) <= k11 * m1) & (y >= k21 / k11 * x + det * m2 / k11),  # (4.42), (4.43)
        (abs(x + k12 * m2) <= k11 * m1) & (y <= k21 / k11 * x - det * m2 / k11),  # (4.48), (4.49)
        (abs(y - k21 * m1) <= k22 * m2) & beyond(+1),  # (4.54), (4.55)
        (abs(y + k21 * m1) <= k22 * m2) & beyond(-1),  # (4.60), (4.61)
        (x >= k11 * m1 + k12 * m2) & (y >= k22 * m2 + k21 * m1),  # (4.66), (4.67)
        (x <= -k11 * m1 + k12 * m2) & (y >= k22 * m2 - k21 * m1),
        (x >= k11 * m1 - k12 * m2) & (y <= -k22 * m2 + k21 * m1),
        (x <= -k11 * m1 - k12 * m2) & (y <= -k22 * m2 - k21 * m1),
    ]
    torques = [
        (both1, both2),
        ((x - k12 * m2) / k11, m2),
        ((x + k12 * m2) / k11, -m2),
        (m1, (y - k21 * m1) / k22),
        (-m1, (y + k21 * m1) / k22),
        (m1, m2),
        (-m1, m2),
        (m1, -m2),
        (-m1, -m2),
    ]
    return np.array(masks), np.array([np.stack(pair, -1) for pair in torques])


K, xy, m = random_problems(COUNT)
masks, listed = sectors(K, xy, m)
print("problems per sector:", masks.sum(axis=1))
check("Figure 4.7", int(np.sum(masks.sum(axis=0) != 1)), 0)  # every point lies in exactly one sector

by_sector = np.take_along_axis(listed, masks.argmax(axis=0)[None, :, None], 0)[0]
torque, rate = solve_box(K, xy, m)
check("Table 4.1", wrong(torque, by_sector, m), 0)
for sector in range(9):
    if not masks[sector].any():
        raise AssertionError(f"no random problem in sector {sector + 1}")

# %% [markdown]
# The conditions behind the sectors hold for the result: a torque inside its limits holds its element, one at
# its limit opposes the motion that is left.

# %%
inside = abs(torque) < m
check("4.33", int(np.sum(rate[inside] != 0)), 0)
check("4.34", int(np.sum(abs(torque) > m)), 0)
outside = ~inside
check("4.39", int(np.sum((rate * torque)[outside] < -1e-9 * (abs(xy) * m)[outside])), 0)

# %% [markdown]
# ## The other cases, (4.26) to (4.31)
# Elements that slide at the start of a short step. With w = x(0) + h (x, y) and K h the step gives the
# torques of the four cases of Section 4.2.2 as soon as the step is too short to stop them.

# %%
h = 1e-9
speed = rng.choice([-1.0, 1.0], (COUNT, 2)) * 10 ** rng.uniform(-1, 1, (COUNT, 2))
(x, y), (m1, m2) = xy.T, m.T
k11, k12, k21, k22 = K[:, 0, 0], K[:, 0, 1], K[:, 1, 0], K[:, 1, 1]

sliding = solve_box(h * K, speed + h * xy, m)[0]
check("4.26", wrong(sliding, m * np.sign(speed), m), 0)

first_at_rest = np.stack([np.zeros(COUNT), speed[:, 1]], -1)
found, left = solve_box(h * K, first_at_rest + h * xy, m)
holding = (x - k12 * m2 * np.sign(speed[:, 1])) / k11
check("4.28", wrong(found[:, 1], m2 * np.sign(speed[:, 1]), m2), 0)
check(
    "4.29",
    wrong(found[:, 0][abs(holding) < m1], holding[abs(holding) < m1], (abs(x) / k11 + m1)[abs(holding) < m1] * 1e2),
    0,
)
check("4.30", wrong(found[:, 0], np.clip(holding, -m1, m1), (abs(x) / k11 + m1) * 1e2), 0)
check("4.31", int(np.sum(left[:, 0][abs(found[:, 0]) < m1] != 0)), 0)

# %% [markdown]
# ## One element, (4.8) to (4.12)

# %%
k, force, limit, w0 = K[:, 0, 0], x, m1, speed[:, 0]


def one(w):
    """The box problem of one element over a step of length h."""
    T, w_plus = solve_box(h * k[:, None, None], w[:, None], limit[:, None])
    return T[:, 0], w_plus[:, 0]


check("4.8", wrong(one(w0 + h * force)[0], limit * np.sign(w0), limit), 0)
at_rest, moved = one(h * force)
check(
    "4.10",
    wrong(at_rest[abs(force / k) < limit], (force / k)[abs(force / k) < limit], limit[abs(force / k) < limit]),
    0,
)
check("4.11", wrong(at_rest, np.where(abs(force / k) <= limit, force / k, limit * np.sign(force / k)), limit), 0)
check(
    "4.12",
    wrong(moved, np.where(abs(force / k) <= limit, 0, h * (force - k * limit * np.sign(force))), h * k * limit),
    0,
)

# %% [markdown]
# ## Clipping is not enough
# Limiting the torques of (4.32) one by one, as a step would do that treats the elements apart, gives other
# torques wherever one of them is at its limit and K has a coupling. No step size cures that.

# %%
clipped = np.clip(np.linalg.solve(K, xy[..., None])[..., 0], -m, m)
share = np.mean(np.any(abs(clipped - torque) > 1e-6 * m, axis=1))
largest = np.max(abs(clipped - torque) / m)
print(f"clipping is wrong in {100 * share:.0f} % of these problems, by up to {largest:.2f} of the limit")
if not share > 0.2:
    raise AssertionError("clipping should fail on a good part of the problems")

# %%
summary()

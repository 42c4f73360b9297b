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
# # Friction torques: laws, nine sectors, and what limiting gets wrong
#
# At rest a friction torque is not a function of the velocity: it is what keeps the velocity at zero, as long as its
# limit allows that. The source finds the torques of one element by a case distinction, (4.5) to (4.12), and those of
# two by dividing a plane into nine sectors, Figure 4.7 and Table 4.1. `ptgen.friction.box` finds those of any number
# as the solution of one problem, and for two elements with three clamps and without any case distinction. Here both
# are compared on random problems, the figures of Sections 4.1 and 4.2 are drawn, and the two simulation examples are
# run by the emitted C and by the event-driven reference.
#
# The source's lines are taken with (4.55) and (4.61) exchanged (docs/errata.md). Notation: K is K22 of (4.23), x and y
# the coordinates (4.35), m1 and m2 the largest static torques.

# %%
import matplotlib.pyplot as plt
import numpy as np
import sympy as sp
from beds import bed, machine, table
from checking import check, show, summary
from matplotlib.colors import LinearSegmentedColormap
from matplotlib.patches import Patch
from runs import run_by_events, run_emitted

from ptgen.block.block import Assign
from ptgen.friction.box import solve_box
from ptgen.friction.step import friction_step
from ptgen.report.figures import BLUE, GREEN, GREY, INK, LIGHT, ORANGE, PALETTE

rng = np.random.default_rng(4)
COUNT, MANY = 4_000, 100_000


def random_problems(count):
    """Positive definite matrices of all shapes, points of the plane around the sectors, limits."""
    angle, size = rng.uniform(0, np.pi, count), 10 ** rng.uniform(-2, 2, (count, 2))
    c, s = np.cos(angle), np.sin(angle)
    rotation = np.stack([np.stack([c, -s], -1), np.stack([s, c], -1)], -2)
    K = np.einsum("nij,nj,nkj->nik", rotation, size, rotation)
    m = 10 ** rng.uniform(-2, 2, (count, 2))
    xy = np.einsum("nij,nj->ni", K, rng.uniform(-3, 3, (count, 2)) * m)
    return K, xy, m


def three_clamps(K, w, m):
    """Return the torques of two elements, for arrays of problems: the closed form of `solve_box`."""
    k11, k12, k21, k22 = K[..., 0, 0], K[..., 0, 1], K[..., 1, 0], K[..., 1, 1]
    (w1, w2), (m1, m2) = np.moveaxis(w, -1, 0), np.moveaxis(m, -1, 0)
    t2 = np.clip((k11 * w2 - k21 * w1) / (k11 * k22 - k12 * k21), -m2, m2)
    T1 = np.clip((w1 - k12 * t2) / k11, -m1, m1)
    T2 = np.clip((w2 - k21 * T1) / k22, -m2, m2)
    return np.stack([T1, T2], -1)


def solve_all(K, w, m):
    """Return torques and rates of `solve_box`, problem by problem."""
    solutions = [solve_box(*problem) for problem in zip(K, w, -m, m, strict=True)]
    return np.array([s.T for s in solutions]), np.array([s.w_plus for s in solutions])


def wrong(found, expected, scale):
    """How many entries differ by more than rounding."""
    return int(np.sum(np.abs(found - expected) > 1e-9 * scale))


# %% [markdown]
# ## Friction laws, Figure 4.1
# Four bearings: what the emitted plant takes as capacity in motion and at rest, over the velocity.

# %%
laws = {
    "Coulomb": {"coulomb": "3 N m"},
    "Coulomb, viscous": {"coulomb": "3 N m", "viscous": "0.2 N m s/rad"},
    "Coulomb, viscous, static": {"coulomb": "3 N m", "viscous": "0.2 N m s/rad", "static": "5 N m"},
    "Stribeck": {"coulomb": "3 N m", "viscous": "0.2 N m s/rad", "static": "5 N m", "stribeck_speed": "1.5 rad/s"},
}


def law_of(project, name):
    """Return the torque of an element over its velocity, and the largest one at rest."""
    given = {s.target: s.expression for s in project.plant.step if isinstance(s, Assign)}
    values = {symbol.name: value for symbol, value in project.model.values.items()}

    def number(target, speed):
        known = {**values, f"{name}_mid_speed": abs(speed)}
        return float(given[target].subs({s: known[s.name] for s in given[target].free_symbols}))

    return lambda w: number("slide[0]", w) * np.sign(w) + values[f"{name}_viscous"] * w, number("rest[0]", 0.0)


figure, axes = plt.subplots(1, 4, figsize=(11, 2.8), sharex=True, sharey=True, layout="constrained")
for axis, (title, law) in zip(axes, laws.items(), strict=True):
    torque_at, at_rest = law_of(
        bed(["M1 - bearing1"], machine("M1"), table("bearing1", "bearing", **law), torque={}, speed=["M1"]), "bearing1"
    )
    speeds = np.linspace(0.001, 10, 60)
    for sign in (-1, 1):
        axis.plot(sign * speeds, [torque_at(sign * w) for w in speeds], color=BLUE, label="in motion")
    axis.plot([0, 0], [-at_rest, at_rest], color=ORANGE, label="at rest")
    axis.set(title=title, xlabel="velocity (rad/s)")
    axis.axhline(0, color=LIGHT, zorder=0)
    if title == "Stribeck":
        found = [torque_at(w) - 0.2 * w for w in (0.5, 1.5, 8.0)]
        check("Figure 4.1d", wrong(np.array(found), 3 + 2 * np.exp(-np.array([0.5, 1.5, 8.0]) / 1.5), 1), 0)
        check("Figure 4.1d at rest", at_rest, 5.0)
axes[0].set_ylabel("torque (N m)")
axes[0].legend(handles=axes[0].lines[1:3], frameon=False, loc="upper left")
show(figure)

# %% [markdown]
# ## One element, (4.8) to (4.12)
# Steps so short that nothing stops in them, with the rules of the emitted plant (`ptgen.friction.step`): an element in
# motion, and one at rest. The torque at its limit belongs to an instant; if the capacity in motion is smaller, it
# acts from there on.

# %%
K, xy, m = random_problems(COUNT)
h = 1e-9
speed = rng.choice([-1.0, 1.0], (COUNT, 2)) * 10 ** rng.uniform(-1, 1, (COUNT, 2))
(x, y), (m1, m2) = xy.T, m.T
k11, k12, k21, k22 = K[:, 0, 0], K[:, 0, 1], K[:, 1, 0], K[:, 1, 1]


def short_step(K, w, force, slide, rest=None):
    """Return the torques at the end of a step of length h, and the accelerations in it."""
    rest = slide if rest is None else rest
    unknown = np.zeros_like(w)  # nothing is known of a step before
    _, torque, _, left, status = friction_step(h * K, w, w + h * force, slide, rest, unknown, unknown, 0, 0)
    check("4.5 solved", int(np.sum(status != 0)), 0)
    return torque, (left - w) / h


one = K[:, :1, :1], speed[:, :1], xy[:, :1], m[:, :1]
size = abs(x) + k11 * m1 + 1e-6 / h * abs(speed[:, 0])  # of an acceleration that is the difference of two velocities
sliding, rate = short_step(*one)
check("4.8", wrong(sliding[:, 0], m1 * np.sign(speed[:, 0]), m1), 0)
check("4.9", wrong(rate[:, 0], x - k11 * m1 * np.sign(speed[:, 0]), size), 0)
at_rest, rate = short_step(one[0], 0 * one[1], *one[2:])
needed = x / k11
holds = abs(needed) <= m1
check("4.10", wrong(at_rest[holds, 0], needed[holds], m1[holds]), 0)
check("4.11", wrong(at_rest[:, 0], np.where(holds, needed, m1 * np.sign(needed)), m1), 0)
check("4.12", wrong(rate[:, 0], np.where(holds, 0, x - k11 * m1 * np.sign(needed)), size), 0)
check("4.12 exactly", int(np.sum(rate[holds, 0] != 0)), 0)
kinetic, rate = short_step(one[0], 0 * one[1], one[2], 0.7 * one[3], one[3])
check("4.11 static above kinetic", wrong(kinetic[:, 0], np.where(holds, needed, 0.7 * m1 * np.sign(needed)), m1), 0)

# %% [markdown]
# Figure 4.2: the torque at rest over a1'x + b1'u, and the acceleration that is left.

# %%
k, limit = 1.0, 1.0
force = np.linspace(-2.5, 2.5, 201)
torque, left = solve_all(np.full((201, 1, 1), k), force[:, None], np.full((201, 1), limit))
figure, axis = plt.subplots(figsize=(5.5, 3.2), layout="constrained")
axis.plot(force, torque, color=INK, label="friction torque")
axis.plot(force, left, color=BLUE, linestyle="--", label="acceleration")
for sign, text in ((-1, "dx/dt < 0"), (1, "dx/dt > 0")):
    axis.axvspan(sign * k * limit, sign * 2.5, color=BLUE, alpha=0.1)
    axis.text(sign * 1.75, -sign * 0.6, text, ha="center", color=BLUE)
axis.set(xlabel="torque from outside, over k11 Tfr,s", ylabel="over Tfr,s, k11 Tfr,s", xlim=(-2.5, 2.5))
axis.legend(frameon=False, loc="upper left")
show(figure)
check("Figure 4.2", wrong(torque[:, 0], np.clip(force / k, -limit, limit), 1), 0)

# %% [markdown]
# ## Two elements in motion, or one of them at rest, (4.26) to (4.31)

# %%
size = abs(xy) + np.einsum("nij,nj->ni", abs(K), m) + 1e-6 / h * abs(speed)
sliding, rate = short_step(K, speed, xy, m)
check("4.26", wrong(sliding, m * np.sign(speed), m), 0)
check("4.6", wrong(sliding, m * np.sign(speed), m), 0)
check("4.19", wrong(sliding, m * np.sign(speed), m), 0)
check("4.7", int(np.sum(sliding * speed <= 0)), 0)
check("4.20", int(np.sum(sliding * speed <= 0)), 0)
gains = sliding / speed
check("4.24", wrong(gains * speed, sliding, m), 0)
check("4.24", int(np.sum(gains <= 0)), 0)
check("4.27", wrong(rate, xy - np.einsum("nij,nj->ni", K, m * np.sign(speed)), size), 0)

first_at_rest = np.stack([np.zeros(COUNT), speed[:, 1]], -1)
found, rate = short_step(K, first_at_rest, xy, m)
check("4.28", wrong(found[:, 1], m2 * np.sign(speed[:, 1]), m2), 0)
needed = (x - k12 * found[:, 1]) / k11
room, holds = (abs(x) + abs(k12) * m2) / k11 + m1, abs(needed) < m1
check("4.29", wrong(found[holds, 0], needed[holds], room[holds]), 0)
check("4.30", wrong(found[:, 0], np.clip(needed, -m1, m1), room), 0)
check("4.31", wrong(rate, xy - np.einsum("nij,nj->ni", K, found), size), 0)
check("4.31 exactly", int(np.sum(rate[holds, 0] != 0)), 0)

# %% [markdown]
# ## Both at rest: the nine sectors of Figure 4.7 and Table 4.1
# Each sector is a set of inequalities between x, y and the lines of Figure 4.7.


# %%
def sectors(K, xy, m, exchanged=1):
    """Return nine masks and the torques of Table 4.1 for each of them; with `exchanged` -1 the lines as printed."""
    k11, k12, k21, k22 = K[:, 0, 0], K[:, 0, 1], K[:, 1, 0], K[:, 1, 1]
    (x, y), (m1, m2) = xy.T, m.T
    det = k11 * k22 - k12 * k21
    both1, both2 = (k22 * x - k12 * y) / det, (k11 * y - k21 * x) / det  # (4.32)

    def beyond(sign):
        """On the outer side of (4.55) or (4.61); the side depends on the sign of k12."""
        return sign * k12 * (k22 / k12 * x - exchanged * sign * det * m1 / k12 - y) >= 0

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


many = random_problems(MANY)
masks, listed = sectors(*many)
print("problems per sector:", masks.sum(axis=1))
check("Figure 4.7", int(np.sum(masks.sum(axis=0) != 1)), 0)  # every point lies in exactly one sector
by_sector = np.take_along_axis(listed, masks.argmax(axis=0)[None, :, None], 0)[0]
check("Table 4.1", wrong(three_clamps(*many), by_sector, many[2]), 0)
as_printed = sectors(*many, exchanged=-1)[0].sum(axis=0)
print(f"with (4.55), (4.61) as printed {np.mean(as_printed > 1):.0%} of the points are in more than one sector")
if not (np.any(as_printed > 1) and masks.any(axis=1).all()):
    raise AssertionError("every sector has its problems, and the printed lines do not divide the plane")

torque, rate = solve_all(K, xy, m)
check("4.6", int(np.sum(abs(torque) > m)), 0)
check("4.19", int(np.sum(abs(torque) > m)), 0)
check("Table 4.1", wrong(torque, three_clamps(K, xy, m), m), 0)

# %% [markdown]
# The conditions that the source demands of each sector hold for the result, and only there: a torque inside its limits
# holds its element, one at its limit opposes the motion that is left.

# %%
masks = sectors(K, xy, m)[0]
(T1, T2), (rate1, rate2) = torque.T, rate.T
slack = 1e-9 * (abs(xy) + np.einsum("nij,nj->ni", abs(K), m))
inside = abs(torque) < m
check("4.33", int(np.sum(rate[inside] != 0)), 0)
check("4.34", int(np.sum(abs(torque) > m)), 0)
check("4.34 only there", int(np.sum(np.all(inside, axis=1) & ~masks[0])), 0)
s = masks[1]
check("4.38", wrong(T2[s], m2[s], m2[s]), 0)
check("4.39", int(np.sum(rate2[s] < 0)), 0)
check("4.41", int(np.sum(abs(T1[s]) > m1[s]) + np.sum(abs(rate1[s]) > slack[s, 0])), 0)
s = masks[2]
check("4.44", wrong(T2[s], -m2[s], m2[s]), 0)
check("4.45", int(np.sum(rate2[s] > 0)), 0)
check("4.47", int(np.sum(abs(T1[s]) > m1[s]) + np.sum(abs(rate1[s]) > slack[s, 0])), 0)
s = masks[3]
check("4.50", wrong(T1[s], m1[s], m1[s]), 0)
check("4.51", int(np.sum(rate1[s] < 0)), 0)
check("4.53", int(np.sum(abs(T2[s]) > m2[s]) + np.sum(abs(rate2[s]) > slack[s, 1])), 0)
s = masks[4]
check("4.56", wrong(T1[s], -m1[s], m1[s]), 0)
check("4.57", int(np.sum(rate1[s] > 0)), 0)
check("4.59", int(np.sum(abs(T2[s]) > m2[s]) + np.sum(abs(rate2[s]) > slack[s, 1])), 0)
s = masks[5]
check("4.62", wrong(T2[s], m2[s], m2[s]), 0)
check("4.63", int(np.sum(rate2[s] < 0)), 0)
check("4.64", wrong(T1[s], m1[s], m1[s]), 0)
check("4.65", int(np.sum(rate1[s] < 0)), 0)

# %% [markdown]
# Figure 4.7 with the torques as colour, for the two clutches of Figure 4.10: unit inertias in the first and last body,
# two in the middle, 4 N m and 8 N m. Every change of colour is continuous, and both torques are within their limits
# everywhere.

# %%
K_pair, m_pair = np.array([[1.5, -0.5], [-0.5, 1.5]]), np.array([4.0, 8.0])
REACH = np.array([20.0, 26.0])
grid = np.stack(np.meshgrid(*(np.linspace(-reach, reach, 401) for reach in REACH)), -1)
proposed = three_clamps(K_pair, grid, m_pair)
conventional = np.clip(grid @ np.linalg.inv(K_pair).T, -m_pair, m_pair)
left = {"proposed": grid - proposed @ K_pair.T, "conventional": grid - conventional @ K_pair.T}
held = np.all(abs(grid @ np.linalg.inv(K_pair).T) <= m_pair, axis=-1)
COLOURS = LinearSegmentedColormap.from_list("torques", [BLUE, "white", ORANGE])


def coloured(axis, element, torques, title):
    """Draw a torque over the plane."""
    mesh = axis.imshow(
        torques[..., element] / m_pair[element],
        extent=(-REACH[0], REACH[0], -REACH[1], REACH[1]),
        origin="lower",
        cmap=COLOURS,
        vmin=-1,
        vmax=1,
        aspect="auto",
        interpolation="bilinear",
    )
    axis.set(title=title, xlabel="a1'x + b1'u (rad/s²)", ylabel="a2'x + b2'u (rad/s²)")
    return mesh


def parallelogram(axis, **style):
    """Draw the border of sector 1."""
    corners = np.array([(1, 1), (-1, 1), (-1, -1), (1, -1), (1, 1)]) * m_pair @ K_pair.T
    axis.plot(*corners.T, **style)
    return corners


figure, axes = plt.subplots(1, 2, figsize=(11, 4.8), layout="constrained")
for element, axis in enumerate(axes):
    mesh = coloured(axis, element, proposed, f"torque of clutch {element + 1}")
    corners = parallelogram(axis, color=INK)
    for corner, (s1, s2) in zip(corners, [(1, 1), (-1, 1), (-1, -1), (1, -1)], strict=False):
        axis.plot([corner[0], corner[0]], [corner[1], s2 * REACH[1]], color=INK, linewidth=1)
        axis.plot([corner[0], s1 * REACH[0]], [corner[1], corner[1]], color=INK, linewidth=1)
    places = [(0, 0), (-4, 19), (4, -19), (15, -2), (-15, 2), (11, 19), (-15, 19), (15, -19), (-11, -19)]
    for number, (px, py) in enumerate(places, 1):
        axis.text(px, py, number, ha="center", va="center", fontweight="bold")
        mask = sectors(K_pair[None], np.array([[px, py]], dtype=float), m_pair[None])[0]
        check("Figure 4.7 numbers", int(mask[:, 0].argmax()), number - 1)
figure.colorbar(mesh, ax=axes, label="torque over its limit")
show(figure)

# %% [markdown]
# ## Figures 4.8 and 4.9: proposed against conventional
# The conventional step limits the torques of (4.32) one by one. Hatched is where the velocity leaves zero; green is
# the border of the region where it stays there, and every line on which its acceleration changes its sign. Proposed,
# an element slips only where its torque is at the limit. Limited one by one, an element stays at rest in the
# parallelogram alone, and in the dark regions it moves against its friction torque: friction drives it.

# %%
figure, axes = plt.subplots(2, 2, figsize=(11, 9), layout="constrained")
against = {}
for element in (0, 1):
    for axis, (title, rates) in zip(axes[element], left.items(), strict=True):
        torques = proposed if title == "proposed" else conventional
        rates = rates[..., element]
        mesh = coloured(axis, element, torques, f"clutch {element + 1}, {title}")
        extent = (-REACH[0], REACH[0], -REACH[1], REACH[1])
        moving = np.where(rates > 1e-9, 1.0, np.where(rates < -1e-9, -1.0, 0.0))
        opposed = moving * torques[..., element] < 0
        against[title, element] = opposed.mean()
        for sense, hatch in ((1, "///"), (-1, "\\\\\\")):
            shown = np.where(moving == sense, 1.0, 0.0)
            axis.contourf(shown, [0.5, 1.5], extent=extent, colors="none", hatches=[hatch])
        if opposed.any():
            axis.contourf(np.where(opposed, 1.0, 0.0), [0.5, 1.5], extent=extent, colors=[INK], alpha=0.45)
        if title == "proposed":
            axis.contour(np.abs(moving), [0.5], extent=extent, colors=[GREEN], linewidths=2)
        else:
            axis.contour(np.where(held, np.nan, rates), [0], extent=extent, colors=[GREEN], linewidths=2)
            parallelogram(axis, color=GREEN, linewidth=2)
figure.colorbar(mesh, ax=axes, label="torque over its limit")
figure.legend(
    handles=[
        Patch(facecolor="none", edgecolor=INK, hatch="///", label="dx/dt > 0"),
        Patch(facecolor="none", edgecolor=INK, hatch="\\\\\\", label="dx/dt < 0"),
        Patch(facecolor=INK, alpha=0.45, label="moves against its friction torque"),
    ],
    loc="outside lower center",
    ncols=3,
    frameon=False,
)
show(figure)
print({f"{title}, clutch {element + 1}": f"{100 * share:.1f} %" for (title, element), share in against.items()})
check("Figure 4.8a", against["proposed", 0], 0)
check("Figure 4.9a", against["proposed", 1], 0)
if not (against["conventional", 0] > 0 and against["conventional", 1] > 0):
    raise AssertionError("Figures 4.8b, 4.9b show regions where friction drives")

# %% [markdown]
# Both statements of the source about the conventional step hold at every point of the plane: it keeps an element at
# rest in the parallelogram only, and the proposed one leaves no element at rest with its torque at the limit but on
# the border of its strip.

# %%
for element in (0, 1):
    stays = abs(left["conventional"][..., element]) < 1e-9 * REACH[element]
    on_lines = int(np.sum(stays & ~held))
    check("Figure 4.8b", int(np.sum(held & ~stays)), 0)
    if on_lines > 0.005 * stays.size:
        raise AssertionError("outside the parallelogram rest is a matter of single lines")
    at_limit = abs(proposed[..., element]) >= m_pair[element] * (1 - 1e-12)
    still = abs(left["proposed"][..., element]) < 1e-9 * REACH[element]
    if np.sum(at_limit & still) > 0.005 * still.size:
        raise AssertionError("at its limit and at rest on borders only")

# %% [markdown]
# ## How often and how far limiting is wrong
# Two families of problems with n elements at rest: random matrices K = R R' with R of n times 2 n normal numbers, and
# n clutches in a row between bodies of 0.1 to 10 kg m^2, in which only neighbours are coupled. Limits are from 1 to
# 10 N m; torques from outside are such that (4.32) asks each element for up to twice its limit in either sense. A
# problem is wrong if a torque is off by more than 1e-6 of its limit. An element has the wrong sign if it moves against
# its friction torque; that makes power. The error does not depend on any step: it is one of accelerations.

# %%
PROBLEMS = 1_000


def random_matrix(n):
    """Return K of no particular system."""
    R = rng.normal(size=(n, 2 * n))
    return R @ R.T


def clutches_in_a_row(n):
    """Return K of n clutches between n + 1 bodies."""
    G = np.eye(n, n + 1) - np.eye(n, n + 1, 1)
    return G @ np.diag(10 ** rng.uniform(-1, 1, n + 1)) @ G.T


def limiting(family, n):
    """Return the error of each problem over its limit, and the share of problems with a wrong sign."""
    errors, against = [], 0
    for _ in range(PROBLEMS):
        K, m = family(n), 10 ** rng.uniform(0, 1, n)
        asked = rng.uniform(-2, 2, n) * m
        w = K @ asked
        solution = solve_box(K, w, -m, m, deficient=False)
        if not solution.solved:
            raise AssertionError("every problem has a solution")
        limited = np.clip(asked, -m, m)
        rates = w - K @ limited
        errors.append(np.max(abs(limited - solution.T) / m))
        against += bool(np.any(rates * limited < -1e-9 * np.max(abs(w)) * m))
        if np.any(solution.w_plus * solution.T < 0):
            raise AssertionError("the solution never drives")
    return np.array(errors), against / PROBLEMS


print(f"{'':20}{'n':>4}{'wrong':>9}{'wrong sign':>13}{'median error':>15}{'largest':>10}  (limits)")
for name, family in (("random matrices", random_matrix), ("clutches in a row", clutches_in_a_row)):
    shares = []
    for n in range(2, 7):
        errors, opposed = limiting(family, n)
        off = errors > 1e-6
        shares.append(off.mean())
        print(f"{name:20}{n:4d}{off.mean():9.0%}{opposed:13.0%}{np.median(errors[off]):15.2f}{errors.max():10.2f}")
        if not (off.mean() > 0.4 and opposed > 0.2 and errors.max() > 1):
            raise AssertionError("limiting fails on a good part of the problems")
    if shares != sorted(shares):
        raise AssertionError("the more elements, the more often")

# %% [markdown]
# ## Figure 4.3: a scalar system that sticks, slips and sticks again
# (4.14), dx/dt = u - T(x), with 1 N m of Coulomb friction. The input is chosen here, so that x reaches zero at 1.3 s,
# leaves it at 2.0 s and comes back at 3.5 s, as in the figure. The emitted C takes steps of 100 us; the reference
# integrates from event to event. Between events the motion is a polynomial of the kind that the steps represent
# exactly, so only the torque of a ramp differs: that of a step belongs to its middle.
#
# These events lie on the grid of the steps. With steps of 137 us they do not, and neither do the jumps of the input;
# both runs are compared with that step too.

# %%
STEP, EVERY = 1e-4, 200
scalar = bed(
    ["M1 - bearing1"], machine("M1", 1.0), table("bearing1", "bearing", coulomb="1 N m"), torque={}, speed=["M1"]
)


def push(t):
    """Return the input u (N m)."""
    if t < 1.5:
        return 1.5 if t < 0.5 else -0.5625
    return -0.5625 + 3.125 * (t - 1.5) if t < 2.5 else 0.609375


def compare(project, velocities, torques, breakpoints, duration, quantities, step=STEP):
    """Run both, return them, and print and check the largest difference of each quantity."""
    emitted = run_emitted(project, velocities, torques, {}, duration, step)
    reference = run_by_events(project, velocities, torques, {}, breakpoints, emitted.time[EVERY::EVERY])
    for name, bound in quantities.items():
        largest = np.max(abs(emitted[name][EVERY::EVERY] - reference[name]))
        print(f"emitted C at {1e6 * step:.0f} us against events, {name}: at most {largest:.1e}")
        if not largest < bound:
            raise AssertionError(f"{name} differs by {largest}")
    return emitted, reference


def events_as_printed(number, reference, expected):
    """Check the transitions of a run, and their times to 1e-9 s."""
    found = [(t.element, t.before, t.after) for t in reference.transitions]
    if found != [tuple(change) for _, *change in expected]:
        raise AssertionError(f"{number} has other transitions: {found}")
    late = [abs(t.time - time) for t, (time, *_) in zip(reference.transitions, expected, strict=True)]
    print(f"{number}: {[f'{t.element} at {t.time:.4f} s' for t in reference.transitions]}, off by {max(late):.0e} s")
    check(number, int(max(late) > 1e-9), 0)


emitted, reference = compare(
    scalar, [1.0], {"M1": push}, (0.5, 1.5, 2.5), 4.0, {"M1_speed": 1e-9, "bearing1_torque": 1e-3}
)
compare(scalar, [1.0], {"M1": push}, (0.5, 1.5, 2.5), 4.0, {"M1_speed": 1e-3}, 137e-6)
expected = [(1.3, "bearing1", 1, 0), (2.0, "bearing1", 0, 1), (3.5, "bearing1", 1, 0)]
events_as_printed("Figure 4.3", reference, expected)

figure, axes = plt.subplots(2, 1, figsize=(7, 4.5), sharex=True, layout="constrained")
axes[0].plot(emitted.time, emitted["M1_speed"], color=BLUE)
axes[0].plot(reference.time[::2], reference["M1_speed"][::2], ".", color=ORANGE, markersize=4)
axes[0].set_ylabel("x (rad/s)")
axes[1].plot(emitted.time, [push(t) for t in emitted.time], color=GREY, label="u")
axes[1].plot(emitted.time[1:], emitted["bearing1_torque"][1:], color=BLUE, label="friction, emitted C")
axes[1].plot(reference.time[::2], reference["bearing1_torque"][::2], ".", color=ORANGE, markersize=4, label="events")
axes[1].set(xlabel="time (s)", ylabel="torque (N m)")
axes[1].legend(frameon=False, ncols=3)
for axis in axes:
    axis.axvspan(1.3, 2.0, color=LIGHT, alpha=0.5)
    axis.axvspan(3.5, 4.0, color=LIGHT, alpha=0.5)
show(figure)

# %% [markdown]
# ## Figure 4.11: two clutches
# The chain (4.69) with unit inertias, in the states (4.70). Clutches of 4 N m and 8 N m; no torques until 0.65 s, then
# T1 = -T2 = 40 N m/s (t - 0.65 s). By hand: x2' = 2 - 12 = -10 takes x2 = 2.5 rad/s to zero at 0.25 s; clutch 1 follows
# at 0.6 s; Tc1 = T1 reaches 4 N m at 0.75 s, and Tc2 = 4/3 N m + 2/3 T1 reaches 8 N m at 0.9 s: the times of the figure.

# %%
chain = bed(
    ["M1 - clutch1 - clutch2 - M2"],
    machine("M1", 1.0),
    machine("M2", 1.0),
    table("clutch1", "clutch", capacity="4 N m", inertia_output="1 kg m^2") + "actuated = false\n",
    table("clutch2", "clutch", capacity="8 N m", inertia_input="1 kg m^2") + "actuated = false\n",
    torque={},
    speed=["M1", "M2"],
)


def ramp(t):
    """Return T1 (N m)."""
    return max(0.0, 40.0 * (t - 0.65))


run = chain, [0.5 + 0.35 * 16 / 3, 2.5, 10.0], {"M1": ramp, "M2": lambda t: -ramp(t)}, (0.65,), 1.0
speeds = ["clutch1_speed", "clutch2_speed", "M1_speed", "M2_speed"]
emitted, reference = compare(*run, dict.fromkeys(speeds, 1e-9) | {"clutch1_torque": 0.01, "clutch2_torque": 0.01})
compare(*run, dict.fromkeys(speeds, 1e-5), 137e-6)
expected = [
    (0.25, "clutch2", 1, 0),
    (0.6, "clutch1", 1, 0),
    (0.75, "clutch1", 0, 1),
    (0.9, "clutch2", 0, 1),
]
events_as_printed("Figure 4.11", reference, expected)
for clutch, begin, end in (("clutch1", 0.6, 0.75), ("clutch2", 0.25, 0.9)):
    stuck = (emitted.time > begin + 1.5 * STEP) & (emitted.time < end - 1.5 * STEP)
    check("Figure 4.11 sticks exactly", int(np.sum(emitted[f"{clutch}_speed"][stuck] != 0)), 0)

figure, axes = plt.subplots(2, 1, figsize=(8, 6.5), sharex=True, layout="constrained")
middle = emitted["M1_speed"] - emitted["clutch1_speed"]
for values, label, style in (
    (emitted["M1_speed"], "ω1", "-"),
    (middle, "ω2", "-"),
    (emitted["M2_speed"], "ω3", "-"),
    (emitted["clutch1_speed"], "x1 = ω1 - ω2", "--"),
    (emitted["clutch2_speed"], "x2 = ω2 - ω3", "--"),
):
    colour = PALETTE[len(axes[0].lines)]
    axes[0].plot(emitted.time, values, style, color=colour, label=label)
axes[0].set_ylabel("velocity (rad/s)")
axes[0].legend(frameon=False, ncols=5)
drive = np.array([ramp(t) for t in emitted.time])
axes[1].plot(emitted.time, drive, color=GREY, label="T1 = -T2")
for clutch, limit, colour in (("clutch1", 4.0, BLUE), ("clutch2", 8.0, ORANGE)):
    axes[1].axhline(limit, color=colour, linestyle=":", linewidth=1)
    axes[1].plot(emitted.time[1:], emitted[f"{clutch}_torque"][1:], color=colour, label=f"{clutch[:-1]} {clutch[-1]}")
    axes[1].plot(reference.time, reference[f"{clutch}_torque"], ".", color=INK, markersize=2)
axes[1].plot([], [], ".", color=INK, markersize=2, label="events")
axes[1].set(xlabel="time (s)", ylabel="torque (N m)")
axes[1].legend(frameon=False, ncols=4, loc="upper left")
for axis in axes:
    for time, *_ in expected:
        axis.axvline(time, color=LIGHT, zorder=0)
show(figure)

# %%
summary()

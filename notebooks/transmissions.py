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
# # Transmissions: Table 3.1, the rigid model (3.42), and what is left of it in the simplified ones
#
# The nine-speed gear set of Figure 3.16, by hand and by ptgen. Elsewhere: the torque converter (3.37)-(3.41), the
# planetary set (3.47)-(3.50) and both simplified gearboxes (3.51)-(3.54) in `components.py`; a clutch between a rigid
# and a stiff shaft, (3.43)-(3.46), in `modular.py`; the two clutches in transformed states, (4.74)-(4.76), in
# `friction_forms.py`; the bed with two machines and its control, Sections 5.3.3 and 5.4.1, in `reduction.py` and
# `decoupling.py`.

# %%
import itertools

import numpy as np
import sympy as sp
from beds import ROOT, bed, machine, rename, table
from checking import check, summary

from ptgen.friction.box import solve_box
from ptgen.gears import analyse_gears, layout_of_part, simplified_gearbox

# %% [markdown]
# ## The layout
# Four sets obey w_s + g w_r = (1 + g) w_c with g of (3.36), the quotient of the radii, which is that of the numbers of
# teeth. Eight members less four equations: four velocities are free. Here they are those of input, output, member a
# (ring of the first set, carrier of the second) and member b (ring of the second set, suns of the third and fourth).

# %%
g = g1, g2, g3, g4 = sp.symbols("g1:5", positive=True)
w_in, w_out, w_a, w_b = x = sp.symbols("omega_in omega_out omega_a omega_b", real=True)
members = {
    "input": w_in,
    "output": w_out,
    "a": w_a,
    "b": w_b,
    "carrier1": (w_in + g1 * w_a) / (1 + g1),
    "sun2": (1 + g2) * w_a - g2 * w_b,
    "ring3": ((1 + g3) * w_out - w_b) / g3,
    "carrier4": (w_b + g4 * w_out) / (1 + g4),
}
elements = {
    "A": members["carrier1"],
    "B": members["sun2"],
    "C": members["ring3"],
    "D": w_in - members["carrier1"],
    "E": w_b - members["carrier1"],
    "F": w_in - members["carrier4"],
}
rig = bed(
    ["M1 - gears - M2"],
    machine("M1", 0.4),
    machine("M2", 4.5),
    table("gears", "part", file="nine-speed.toml"),
    torque={},
    speed=["M1", "M2"],
)
part = rig.testbed.components["gears"]
layout = layout_of_part(part)
found = analyse_gears(layout, part.description.gears)
teeth = {
    symbol: sp.Rational(part.description.components[name].teeth.ring, part.description.components[name].teeth.sun)
    for symbol, name in zip(g, ("P1", "P2", "P3", "P4"), strict=True)
}
check("3.36", list(teeth.values()), [sp.Rational(str(layout.values[symbol])) for symbol in g])
print("teeth:", {str(symbol): str(value) for symbol, value in teeth.items()})

# %% [markdown]
# ## Table 3.1
# Three elements held leave one velocity. The ratio comes out by hand and, from the part file alone, by `ptgen gears`;
# both are compared with the printed formula, and the value at the teeth with the printed digits.

# %%
PRINTED = {
    "R": ("ABC", -g1 * g2 * (1 + g3) / (1 + g2), "-4.932"),
    "1": ("BCE", (1 + g1 + g2) * (1 + g3) / (1 + g2), "5.503"),
    "2": ("CDE", 1 + g3, "3.333"),
    "3": ("BCD", (1 + g3) * g2 / (1 + g2), "2.315"),
    "4": ("BCF", (1 + g3 + g4) / (1 + g4), "1.661"),
    "5": ("BDF", g2 * g4 / (g2 * g4 - 1), "1.211"),
    "6": ("DEF", sp.Integer(1), "1.000"),
    "7": ("BEF", g4 / (1 + g4 - (1 + g2) / (1 + g1 + g2)), "0.865"),
    "8": ("AEF", g4 / (1 + g4), "0.717"),
    "9": ("ABF", g1 * g2 * g4 / (1 + g2 + g1 * g2 + g1 * g2 * g4), "0.601"),
}
for name, (held, ratio, digits) in PRINTED.items():
    solved = sp.solve([elements[element] for element in held], [w_out, w_a, w_b], dict=True)[0]
    check(f"Table 3.1 gear {name}", ratio, w_in / solved[w_out])
    gear = found.gear(name)
    check(f"Table 3.1 gear {name}", ratio, gear.formula)
    check(f"Table 3.1 gear {name}", ratio.subs(teeth), sp.Rational(str(gear.ratio)))
    value = float(ratio.subs(teeth))
    if f"{value:.3f}" != digits:
        raise AssertionError(f"gear {name}: {value} is not {digits}")
    print(f"gear {name}: {' '.join(held)}  {digits}")
if {name: "".join(gear) for name, gear in part.description.gears.items()} != {n: p[0] for n, p in PRINTED.items()}:
    raise AssertionError("the shift table of the part file is Table 3.1")

# %% [markdown]
# What the table does not say: fourth gear needs C and F alone, B is idle in it. Of the 20 combinations of three elements
# 13 are gears, some of them the same, and 7 tie up.

# %%
without = sp.solve([elements["C"], elements["F"]], [w_out, w_a, w_b], dict=True)[0]
check("Table 3.1 gear 4 without B", PRINTED["4"][1], w_in / without[w_out])
check("Table 3.1 no other gears", len(PRINTED), len(found.gears))
threes = [one for one in found.combinations if len(one.engaged) == 3]
print({state: sum(one.state.value == state for one in threes) for state in ("gear", "tie-up", "neutral")})

# %% [markdown]
# ## The rigid model (3.42)
# With v = N x, the rows R of the elements on the members and the inertias J of the members, virtual power gives
#
#     M dx/dt = B_0 u - (R N)' T_fr,   M = N' J N,   so   A = 0, B = M^-1 B_0, K = M^-1 (R N)'.
#
# A is zero, since nothing in the set depends on the speeds but the friction elements. Planets turn with
# 2 g / (g - 1) (w_r - w_c), (3.50). ptgen chooses four velocities of elements as states; S is the way back.

# %%
N = sp.Matrix([[sp.diff(velocity, own) for own in x] for velocity in members.values()])
RN = sp.Matrix([[sp.diff(velocity, own) for own in x] for velocity in elements.values()])
model = rig.model
names = {f"gears_P{k}_ratio": symbol for k, symbol in enumerate(g, 1)}
S = sp.Matrix.vstack(
    *[rename(model.velocity_rows[f"gears.{member}"], names) for member in ("input", "output", "a", "b")]
)
for position, member in enumerate(members):
    check("3.42 velocities", N[position, :] * S, rename(model.velocity_rows[f"gears.{member}"], names))
check("3.42 elements", RN * S, rename(model.friction_rows, names))
check("3.42 inputs", S[:2, :], rename(model.input_rows, names))
check("3.42 A", sp.zeros(6), model.viscous)
if model.twists:
    raise AssertionError("nothing is elastic in the rigid model")

ring_and_carrier = {1: ("a", "carrier1"), 2: ("b", "a"), 3: ("ring3", "output"), 4: ("output", "carrier4")}
planets = [
    2 * gk / (gk - 1) * (N[list(members).index(ring), :] - N[list(members).index(carrier), :])
    for gk, (ring, carrier) in zip(g, ring_and_carrier.values(), strict=True)
]
for k, row in enumerate(planets, 1):
    check("3.42 planets", row * S, rename(model.velocity_rows[f"gears.P{k}.planets"], names))

inertia = {name: sp.Rational(str(value)) for name, value in layout.inertias.items()}
rows = N.col_join(sp.Matrix.vstack(*planets)).subs(teeth)
J = sp.diag(*(inertia[member] for member in members), *(inertia[f"P{k}.planets"] for k in range(1, 5)))
machines = sp.diag(sp.Rational("0.4"), sp.Rational("4.5"), 0, 0)
M = rows.T * J * rows
numeric = model.numeric()
S_n, RN_n = (np.array(matrix.subs(teeth), dtype=float) for matrix in (S, RN))
by_hand = S_n.T @ np.array(M + machines, dtype=float) @ S_n
check("3.42 M", int(np.abs(by_hand - numeric.mass).max() > 1e-12 * np.abs(by_hand).max()), 0)

# %% [markdown]
# With the inertias of the part file and those of two machines: K has six columns and rank four. So two combinations of
# torques move nothing, and mechanics alone does not tell how much of them there is while all six elements stick.

# %%
inverse = np.linalg.inv(numeric.mass)
K = S_n @ inverse @ (RN_n @ S_n).T
B = S_n @ inverse @ S_n[:2].T
print("K, rows input, output, a, b; columns A to F (1/(kg m^2)):")
print(np.array2string(K, precision=3, suppress_small=True))
at_teeth = RN.subs(teeth)
check("3.42 rank", 4, at_teeth.rank())
check("3.42 rank", 4, int(np.linalg.matrix_rank(K)))
check("3.42 columns", 6, K.shape[1])
inside = at_teeth.T.nullspace()
check("3.42 torques that move nothing", [sp.zeros(4, 1)] * 2, [at_teeth.T * vector for vector in inside])

# %% [markdown]
# Standstill with all six pressed: the velocities stay zero, and the torques are those of least norm, weighted with the
# diagonal of K22 = R N K as the bed's parameters have it.

# %%
K66 = RN_n @ K
w = RN_n @ B @ np.array([100.0, -250.0])
solution = solve_box(K66, w, np.full(6, -1e4), np.full(6, 1e4))
root = np.sqrt(np.diag(K66))
least = np.linalg.pinv(K66 / np.outer(root, root)) @ (w / root) / root
left = np.abs(w - K66 @ solution.T).max() / np.abs(w).max()
print("torques (N m):", np.round(solution.T, 3), " what is left of the accelerations:", f"{left:.1e}")
if not (left < 1e-10 and np.allclose(solution.T, least, rtol=0, atol=1e-7 * np.abs(least).max())):
    raise AssertionError("six elements at rest")

# %% [markdown]
# ## What a simplified gearbox can keep
# With the elements locked that two gears share, input and output are left, with the kinetic energy of m11, m12, m22. The
# models (3.51), (3.53) have two inertias. They can be right in both gears, and then differ by a product of both slips:
# nothing is lost while one of the two clutches sticks.

# %%
m11, m12, m22, i1, i2, I_gbi, I_gbo, wi, wo = sp.symbols("m11 m12 m22 i_gb1 i_gb2 I_gbi I_gbo omega_gbi omega_gbo")
in_gear = [I_gbi * i**2 + I_gbo - (m11 * i**2 + 2 * m12 * i + m22) for i in (i1, i2)]
reduced = sp.solve(in_gear, [I_gbi, I_gbo])
check("3.53 inertias", m11 + 2 * m12 / (i1 + i2), reduced[I_gbi])
check("3.53 inertias", m22 + 2 * m12 * i1 * i2 / (i1 + i2), reduced[I_gbo])
energy = (m11 * wi**2 + 2 * m12 * wi * wo + m22 * wo**2) / 2
lost = energy - (reduced[I_gbi] * wi**2 + reduced[I_gbo] * wo**2) / 2
check("3.53 energy", -m12 / (i1 + i2) * (wi - i1 * wo) * (wi - i2 * wo), lost)

# %% [markdown]
# First and second gear of the nine-speed set, which share C and E, by hand and by `ptgen gears --simplify 1,2`.

# %%
box = simplified_gearbox(found, ["1", "2"])
shared = sp.solve([elements["C"], elements["E"]], [w_a, w_b], dict=True)[0]
motion = sp.Matrix([sp.sympify(own).subs(shared) for own in x]).jacobian([w_in, w_out]).subs(teeth)
two = motion.T * M * motion
for own, symbol in zip(box.masses, (two[0, 0], two[0, 1], two[1, 1]), strict=True):
    check("3.53 of gears 1 and 2", int(abs(own / float(symbol) - 1) > 1e-12), 0)
exact = dict(zip((m11, m12, m22), (two[0, 0], two[0, 1], two[1, 1]), strict=True))
exact |= {i1: PRINTED["1"][1].subs(teeth), i2: PRINTED["2"][1].subs(teeth)}
for own, symbol in ((box.inertia_input, I_gbi), (box.inertia_output, I_gbo)):
    check("3.53 of gears 1 and 2", int(abs(own / float(reduced[symbol].subs(exact)) - 1) > 1e-12), 0)
for clutch, element, gear in zip(box.clutches, ("B", "D"), ("1", "2"), strict=True):
    slip = sp.expand(elements[element].subs(shared).subs(teeth))
    alpha = slip.coeff(w_in)
    check("3.54 of gears 1 and 2", alpha * (w_in - PRINTED[gear][1].subs(teeth) * w_out), slip)
    print(f"gear {gear}: {element} is a clutch at the input with {float(abs(alpha)):.4f} times its torque")
    check("3.54 of gears 1 and 2", int(abs(clutch.factor / float(alpha) - 1) > 1e-12), 0)
print(f"m11, m12, m22: {', '.join(f'{own:.5f}' for own in box.masses)} kg m^2")
print(f"I_gbi, I_gbo: {box.inertia_input:.5f}, {box.inertia_output:.5f} kg m^2")

# %% [markdown]
# ## Equal ratios: (4.74) singular
# For igb1 = igb2 both slips are one velocity, (4.74) has no inverse and K22 of (4.75) the rank one. ptgen does not need
# the transformation: the ratios stand in rows of friction elements only, velocities of input and output stay states. Both
# clutches can stick, and share the torque that is needed in the way of least norm; while the gears differ, they do so
# only where the output stands still, w_gbo = 0.

# %%
i, T_gbi, T_gbo, T_c1, T_c2 = sp.symbols("i_gb T_gbi T_gbo T_c1 T_c2", positive=True)
slips = sp.Matrix([[1, -i1], [1, -i2]])
K22 = slips * sp.diag(1 / I_gbi, 1 / I_gbo) * slips.T
free = slips * sp.Matrix([T_gbi / I_gbi, -T_gbo / I_gbo])
check("4.74 rank", 1, slips.subs({i1: i, i2: i}).rank())
check("4.75 rank", 1, K22.subs({i1: i, i2: i}).rank())
check("4.35", list(free), [T_gbi / I_gbi + k * T_gbo / I_gbo for k in (i1, i2)])  # x and y of the sector plane
numbers = {i1: 2, i2: 2, I_gbi: sp.Rational(1, 20), I_gbo: sp.Rational(1, 5), T_gbi: 30, T_gbo: 10}
K_equal, w_equal = (np.array(matrix.subs(numbers), dtype=float) for matrix in (K22, free))
solution = solve_box(K_equal, w_equal[:, 0], np.full(2, -100.0), np.full(2, 100.0))
print("equal ratios, both clutches stick with", solution.T, "N m")
if not np.allclose(solution.T, w_equal[0, 0] / K_equal[0, 0] / 2, rtol=1e-12):
    raise AssertionError("two equal clutches share the torque")
both = sp.solve(list(slips * sp.Matrix([wi, wo])), [wi, wo])
check("4.74 both stick", [0, 0], [both[wi], both[wo]])

# %% [markdown]
# ## The synchronising torque of Section 5.4.1
# Seen from the control, Section 5.3.3, a transmission is the ratio of Table 3.1 that just holds. The drive at the input
# accelerates with the rate of igb w_2 if the twist is to stay: I_m1 d(igb w_2)/dt, the term of (5.46) and (5.62), is the
# torque that keeps the slip of an open clutch at zero while the ratio changes from gear to gear.

# %%
t = sp.symbols("t")
I_m1 = sp.symbols("I_m1", positive=True)
ratio, w2 = sp.Function("i_gb")(t), sp.Function("omega_2")(t)
T_ag = I_m1 * (ratio * sp.diff(w2, t) + sp.diff(ratio, t) * w2)
w1_rate = T_ag / I_m1  # open clutch, (3.51a) with T_c = 0 and the rotor as inertia
check("5.46 slip", 0, sp.simplify(w1_rate - sp.diff(ratio * w2, t)))
turn, seconds = 300 * 2 * np.pi / 60, 0.3
needed = {
    (start, end): 0.4 * turn * float((PRINTED[end][1] - PRINTED[start][1]).subs(teeth)) / seconds
    for start, end in itertools.pairwise("123456789")
}
print("I_m1 = 0.4 kg m^2, output at 300 rpm, 0.3 s, N m:", {"-".join(k): round(v) for k, v in needed.items()})

# %%
summary()

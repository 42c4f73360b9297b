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
# # Shafts, clutches and the form that friction simulation wants: Sections 3.3, 3.5, 4.1, 4.2
#
# Friction torques can be found in a simulation if each depends on one state only, and that state is its velocity: the
# form (4.5), (4.13), (4.18) of the source. The source brings each system into it by a transformation found by hand,
# (4.15), (4.70), (4.74). ptgen always chooses the velocities of the friction elements as first coordinates, so the
# same equations come out of its general procedure. This notebook compares them, coefficient by coefficient; the
# solution of the friction torques themselves is in `friction.py`.

# %%
import itertools

import numpy as np
import sympy as sp
from beds import bed, machine, rates, rename, table
from checking import check, erratum, summary

from ptgen.block.block import Assign
from ptgen.elements import Body, Drive, Friction, FrictionRole, Torque
from ptgen.friction.backlash import backlash_step
from ptgen.friction.box import solve_box
from ptgen.mechanism.assembly import assemble
from ptgen.mechanism.mechanism import Mechanism


def expression(block, target):
    """Return what the emitted plant assigns to `target` in a step."""
    found = [s.expression for s in block.step if isinstance(s, Assign) and s.target == target]
    return found[0]


def unit(position, size):
    """Return a row with a one at `position`."""
    return sp.Matrix([[int(k == position) for k in range(size)]])


def friction_matrix(model):
    """Return K of dw/dt = ... - K T, w being the velocities of the friction elements: K = G M^-1 G'."""
    return (-model.friction_rows * model.accelerations().f).applyfunc(sp.cancel)


# %% [markdown]
# ## Shaft with and without backlash, (3.4), (3.5)
# Two machines and a shaft. The twist e is integrated from de/dt = omega_1 - omega_2, never from two angles.

# %%
c_s, d_s, theta = sp.symbols("c_s d_s theta_bl", positive=True)
w1, w2, e = sp.symbols("omega1 omega2 e", real=True)
shaft = {"stiffness": "5 kN m/rad", "damping": "3 N m s/rad"}
linear = bed(
    ["M1 - shaft1 - M2"], machine("M1"), machine("M2"), table("shaft1", "shaft", **shaft), torque={}, speed=["M1", "M2"]
)
I_m1, I_m2 = sp.symbols("I_m1 I_m2", positive=True)
names = {"shaft1_stiffness": c_s, "shaft1_damping": d_s, "M1_inertia": I_m1, "M2_inertia": I_m2}
model = linear.model
S = sp.Matrix.vstack(model.velocity_rows["M1.shaft"], model.velocity_rows["M2.shaft"])
z = list(S.inv() * sp.Matrix([w1, w2]))
accelerations = S * sp.Matrix(rates(model, names, [0, 0], [], [*z, e]))
linear_torque = d_s * (w1 - w2) + c_s * e
check("3.4", [-linear_torque / I_m1, linear_torque / I_m2], accelerations)
check("3.4 twist", w1 - w2, (model.twist_rows * sp.Matrix(z))[0])

# %% [markdown]
# With backlash the shaft's torque at the end of a step is the dead zone (3.5) itself; its three cases are compared one
# by one. For a gap of zero width they become (3.4).

# %%
backlash = bed(
    ["M1 - shaft1 - M2"],
    machine("M1"),
    machine("M2"),
    table("shaft1", "shaft", **shaft, backlash="2 deg"),
    torque={},
    speed=["M1", "M2"],
)
model = backlash.plant_model
emitted = expression(backlash.plant, "contact_torque[0]")
rate = (model.contact_rows * sp.Matrix([sp.Symbol(f"x[{k}]", real=True) for k in range(2)]))[0]
beyond, twist, room = sp.symbols("beyond twist room", positive=True)  # past the gap's end, in the gap, left in it
printed_3_5 = {
    (theta / 2, theta / 2 + beyond): d_s * (w1 - w2) + c_s * ((theta / 2 + beyond) - theta / 2),
    (twist + room, twist): sp.Integer(0),
    (twist + room, -twist): sp.Integer(0),
    (theta / 2, -theta / 2 - beyond): d_s * (w1 - w2) + c_s * ((-theta / 2 - beyond) + theta / 2),
}
variables = {symbol.name: symbol for symbol in emitted.free_symbols}
for (half_gap, at), printed in printed_3_5.items():
    found = emitted.subs(rate, w1 - w2).subs({variables["shaft1_twist"]: at, variables["half_gap[0]"]: half_gap})
    check("3.5", printed, rename(found, names))
check("3.5 without gap", linear_torque.subs(e, beyond), printed_3_5[theta / 2, theta / 2 + beyond].subs(theta, 0))

# %% [markdown]
# Over a step the torque is held, and it is the mean of (3.5) along a straight line from the twist e to e + Delta: with
# V the stored energy and p the twist beyond the gap, that mean is (V(e+) - V(e))/Delta + d (p+ - p)/h. So what the
# shaft gives is what its spring has stored, however coarse the step; (3.5) held at its value at the start of the step
# would make energy with every contact.

# %%
h, Delta, s, a, b = sp.symbols("h Delta s a b", positive=True)


def mean_of_3_5(pieces):
    """Return the mean of (3.5) over s from 0 to 1, given as (from, to, twist beyond the gap) of each piece."""
    return sum(sp.integrate(c_s * p + d_s * sp.diff(p, s) / h, (s, start, end)) for start, end, p in pieces)


def secant(p_start, p_end, change):
    """Return the torque of `ptgen.friction.backlash` for a step."""
    return c_s * (p_end**2 - p_start**2) / (2 * change) + d_s * (p_end - p_start) / h


stays = [(0, 1, a + Delta * s)]  # beyond the gap from a to a + Delta
enters = [(b / (a + b), 1, (a + b) * s - b)]  # from b inside the end of the gap to a beyond it
through = [(0, a / (a + theta + b), (a + theta + b) * s - a), ((a + theta) / (a + theta + b), 1, 0)]
through[1] = (*through[1][:2], (a + theta + b) * s - a - theta)  # from a beyond one end to b beyond the other
check("3.5 mean", secant(a, a + Delta, Delta), mean_of_3_5(stays))
check("3.5 mean", secant(0, a, a + b), mean_of_3_5(enters))
check("3.5 mean", secant(-a, b, a + theta + b), mean_of_3_5(through))

rng = np.random.default_rng(3)
count = 20_000
kappa, half, c, d = (10 ** rng.uniform(-1, 1, count) for _ in range(4))
start, free = rng.uniform(-3, 3, (2, count)) * half
T = backlash_step(kappa[:, None, None], *(v[:, None] for v in (start, free, half, c, d)))[:, 0]
end = free - kappa * T
p_start, p_end = start - np.clip(start, -half, half), end - np.clip(end, -half, half)
change = end - start
law = c * (p_end**2 - p_start**2) / 2 / change + d * (p_end - p_start)
check("3.5 step", int(np.sum(abs(law - T) > 1e-9 * (abs(T) + c * half))), 0)
made = 0.5 * c * (p_end**2 - p_start**2) - T * change  # stored minus received
check("3.5 energy", int(np.sum(made > 1e-9 * c * (half + abs(start) + abs(free)) ** 2)), 0)
print(f"{count} random steps of a shaft with backlash: the mean of (3.5) each time, no energy made")

# %% [markdown]
# ## Clutch, (3.11) to (3.13) and (4.1)
# The machines stand for the shafts at both sides: their own inertia is set to zero, so that their air-gap torques are
# the torques at the flanges. What drives the output disk is -T_co.

# %%
I_ci, I_co, T_ci, T_co, T_c, mu = (sp.Symbol(name, real=True) for name in "I_ci I_co T_ci T_co T_c mu_c".split())
T_cc, T_cs, w_cs, k_cv, speed = sp.symbols("T_cc T_cs omega_cs k_cv speed", positive=True)
wet = {"static": "5 N m", "stribeck_speed": "1 rad/s", "viscous": "0.1 N m s/rad"}
disks = {"capacity": "4 N m", "inertia_input": "1 kg m^2", "inertia_output": "2 kg m^2"}
clutch_beds = {
    law: bed(
        ["M1 - clutch - M2"],
        machine("M1"),
        machine("M2"),
        table("clutch", "clutch", **disks, **more),
        torque={},
        speed=["M1", "M2"],
    )
    for law, more in {"wet": wet, "dry": {}}.items()
}
names = {
    "clutch_inertia_input": I_ci,
    "clutch_inertia_output": I_co,
    "clutch_capacity": T_cc,
    "clutch_static": T_cs,
    "clutch_stribeck_speed": w_cs,
    "clutch_viscous": k_cv,
    "clutch_actuation": mu,
    "clutch_mid_speed": speed,
    "M1_inertia": 0,
    "M2_inertia": 0,
}
model = clutch_beds["dry"].model
w_ci, w_co = sp.symbols("omega_ci omega_co", real=True)
S = sp.Matrix.vstack(model.velocity_rows["clutch.input"], model.velocity_rows["clutch.output"])
to_z = S.inv()
z_rates = sp.Matrix(rates(model, names, [T_ci, -T_co], [T_c], list(to_z * sp.Matrix([w_ci, w_co]))))
disk_rates = (S * z_rates).applyfunc(sp.cancel)
check("3.11", [(T_ci - T_c) / I_ci, (T_c - T_co) / I_co], disk_rates)

stribeck = mu * (T_cc + (T_cs - T_cc) * sp.exp(-speed / w_cs) + k_cv * speed)
emitted = rename(expression(clutch_beds["wet"].plant, "slide[0]"), names)
check("3.12", stribeck, emitted)
check("4.1", stribeck, emitted)
dry = {**names, "clutch_viscous": 0}  # its default
check("3.13", mu * T_cc, rename(expression(clutch_beds["dry"].plant, "slide[0]"), dry))
holds = rename(expression(clutch_beds["wet"].plant, "rest[0]"), names)
check("4.2 corrected", mu * T_cs, holds)
check("4.2 corrected", sp.limit(stribeck, speed, 0, "+"), holds)

# %% [markdown]
# The sticking torque of (4.2) is no sum of external torques, but what (4.16b) needs for d(slip)/dt = 0.

# %%
sticking = sp.solve(z_rates[0], T_c)[0]
check("4.2 sticking", (I_co * T_ci + I_ci * T_co) / (I_ci + I_co), sticking)

# %% [markdown]
# ## State transformation of the clutch, (4.15) to (4.17)
# ptgen's first coordinate is the slip speed, the second row of (4.15). Its other coordinate is omega_ci; the source
# takes the mean velocity of both disks, and allows any other choice in a footnote. In that state (4.16) comes out,
# with the first row of (4.15) as in docs/errata.md.

# %%
check("4.15 second row", sp.Matrix([[1, -1]]), to_z[0, :])
check("4.16", T_ci / I_ci + T_co / I_co - (1 / I_ci + 1 / I_co) * T_c, z_rates[0])
mean_row = sp.Matrix([[I_ci, I_co]]) / (I_ci + I_co)
check("4.16", (T_ci - T_co) / (I_ci + I_co), (mean_row * disk_rates)[0])
check("4.15 corrected", 0, sp.diff((mean_row * disk_rates)[0], T_c))
if sp.diff((sp.Matrix([[1, -I_co / (I_ci + I_co)]]) * disk_rates)[0], T_c) == 0:
    raise AssertionError("the printed first row of (4.15) should leave the clutch torque in")
wet_plant = clutch_beds["wet"].plant
check("4.17", sp.Symbol("x[0]", real=True), expression(wet_plant, "w_start[0]"))
check("4.17", unit(0, 2), clutch_beds["wet"].model.friction_rows)

# %% [markdown]
# ## Losses of a differential, (4.3), (4.4), and its form (4.72), (4.73)
# The bevel differential alone, between machines whose inertia is set to zero. Coulomb part and load are the capacity
# of the element; the viscous part belongs to the linear part of the bed. The load T_di is taken at mid-step, as the
# mean of its value at the start and the one predicted for the end.

# %%
differential = bed(
    ["M1 - diff.input", "diff.output1 - M2", "diff.output2 - M3"],
    machine("M1"),
    machine("M2"),
    machine("M3"),
    table(
        "diff",
        "bevel_differential",
        ratio=3,
        radius_output1="40 mm",
        radius_output2="50 mm",
        radius_pinion="20 mm",
        inertia_drive="1 kg m^2",
        inertia_cage="2 kg m^2",
        inertia_output1="3 kg m^2",
        inertia_output2="4 kg m^2",
        inertia_pinion="0.1 kg m^2",
        loss={"coulomb": "5 N m", "load": 0.02, "viscous": "0.1 N m s/rad"},
        limited_slip={"coulomb": "50 N m", "load": 0.2, "viscous": "0.3 N m s/rad"},
    ),
    torque={},
    speed=["M1", "M2", "M3"],
)
model = differential.model
load = sp.Symbol("T_di", real=True)


def loss_law(position):
    """Return the printed and the emitted capacity of an element, and the printed and the assembled viscous friction."""
    friction = model.frictions[position]
    T_0, k_T, k_w = sp.symbols("T_0 k_T k_omega", positive=True)
    symbols = {friction.coulomb: T_0, friction.load.coefficient: k_T, friction.viscous: k_w}
    names = {symbol.name: value for symbol, value in symbols.items()}
    names |= {"diff_input_torque_start": load, "diff_input_torque_end": load}
    if friction.load.place != "diff.input":
        raise AssertionError("the load is the torque at the input")
    emitted = rename(expression(differential.plant, f"slide[{position}]"), names)
    assembled = rename(model.viscous, names)[position, position]
    return [T_0 + k_T * sp.Abs(load), k_w], [emitted, assembled]


check("3.34", *loss_law(0))
check("4.3", *loss_law(0))
check("3.35", *loss_law(1))
check("4.4", *loss_law(1))
check("4.73", sp.eye(2), model.friction_rows)  # the torque of row i depends on state i

# %% [markdown]
# Both friction velocities, the input's and the pinion's, are the whole state: nothing is to be transformed. With the
# two inertias of the reduced model from the kinetic energy, (4.72) is x' = B u - K T with K = M^-1.

# %%
T_do1, T_do2, T_di, T_dl, T_dsl = sp.symbols("T_do1 T_do2 T_di T_dl T_dsl", real=True)
r1, r2, r3, i_d = sp.symbols("r1 r2 r3 i_d", positive=True)
I_0, I_c, I_1, I_2, I_3 = sp.symbols("I_0 I_c I_1 I_2 I_3", positive=True)
names = {
    **{f"M{k}_inertia": 0 for k in (1, 2, 3)},
    **{f"diff_{element}_viscous": 0 for element in ("loss", "limited_slip")},
    "diff_radius_output1": r1,
    "diff_radius_output2": r2,
    "diff_radius_pinion": r3,
    "diff_ratio": i_d,
    "diff_inertia_drive": I_0,
    "diff_inertia_cage": I_c,
    "diff_inertia_pinion": I_3,
    "diff_inertia_output1": I_1,
    "diff_inertia_output2": I_2,
}
C = sp.Matrix([[1 / i_d, r3 / r1], [1 / i_d, -r3 / r2]])  # outputs over (omega_di, omega_3b), (3.33)
M = sp.diag(I_0 + I_c / i_d**2, I_3) + C.T * sp.diag(I_1, I_2) * C
K_diff, b = M.inv(), sp.Matrix([[1, 0, 0], [0, 0, 0]]) - sp.Matrix.hstack(sp.zeros(2, 1), C.T)
printed = K_diff * b * sp.Matrix([T_di, T_do1, T_do2]) - K_diff * sp.Matrix([T_dl, T_dsl])
found = rates(model, names, [T_di, -T_do1, -T_do2], [T_dl, T_dsl], [0, 0])
check("4.72", printed, found)
check("4.72 coordinates", sp.eye(2), model.friction_rows)

# %% [markdown]
# ## One friction torque, (4.5), and several that do not couple, (4.13)
# In every bed of ptgen the first coordinates are the friction velocities, as far as these are independent: row i of G
# is the unit row i. Then torque i depends on state i only, and the accelerations are linear in state, inputs and
# friction torques. For (4.5) k_11 > 0 is demanded; it is the diagonal of K = G M^-1 G'.

# %%
braked = bed(
    ["M1 - shaft1 - bearing1 - shaft2 - M2"],
    machine("M1"),
    machine("M2"),
    table("shaft1", "shaft", **shaft),
    table("shaft2", "shaft", **shaft),
    table("bearing1", "bearing", coulomb="1 N m", inertia="0.1 kg m^2"),
    torque={},
    speed=["M1", "M2"],
)
model = braked.model
check("4.5", unit(0, 3), model.friction_rows)
I_b = sp.Symbol("I_b", positive=True)
check("4.5", 1 / I_b, rename(friction_matrix(model), {"bearing1_inertia": I_b})[0])
scalar = bed(["M1 - bearing1"], machine("M1"), table("bearing1", "bearing", coulomb="1 N m"), torque={}, speed=["M1"])
u, T_fr, x = sp.symbols("u T_fr x", real=True)
check("4.14", u - T_fr, rates(scalar.model, {"M1_inertia": 1, "bearing1_viscous": 0}, [u], [T_fr], [x])[0])

# %% [markdown]
# Three elements with inertia of their own, joined by shafts: the first three rows of K are diagonal, (4.13), and the
# problem falls apart into three clamps.

# %%
apart = bed(
    ["M1 - bearing1 - shaft1 - bearing2 - shaft2 - bearing3 - M2"],
    machine("M1"),
    machine("M2"),
    table("shaft1", "shaft", **shaft),
    table("shaft2", "shaft", **shaft),
    *(table(f"bearing{k}", "bearing", coulomb="1 N m", inertia="0.1 kg m^2") for k in (1, 2, 3)),
    torque={},
    speed=["M1", "M2"],
)
K_apart = friction_matrix(apart.model)
check("4.13", sp.diag(*K_apart.diagonal()), K_apart)
K = np.array(K_apart.subs(apart.model.values), dtype=float)
limits = np.array([1.0, 2.0, 3.0])
for w in rng.uniform(-2, 2, (200, 3)) @ np.diag(np.diag(K) * limits):
    clamps = np.clip(w / np.diag(K), -limits, limits)
    check_value = np.max(abs(solve_box(K, w, -limits, limits).T - clamps))
    if check_value > 1e-12:
        raise AssertionError("uncoupled elements are clamps")
print("(4.13): 200 problems of three uncoupled elements are three clamps each")

# %% [markdown]
# ## Two clutches, (4.69) to (4.71)
# The chain of Figure 4.10. The machines are the first and the last body, the disks in the middle are one body.

# %%
I_c1i, I_c1o, I_c2i, I_c2o = sp.symbols("I_c1i I_c1o I_c2i I_c2o", positive=True)
T1, T2, Tc1, Tc2 = sp.symbols("T1 T2 Tc1 Tc2", real=True)
w3 = sp.Symbol("omega3", real=True)
chain = bed(
    ["M1 - clutch1 - clutch2 - M2"],
    machine("M1", 1.0),
    machine("M2", 1.0),
    table("clutch1", "clutch", capacity="4 N m", inertia_output="1 kg m^2"),
    table("clutch2", "clutch", capacity="8 N m", inertia_input="1 kg m^2"),
    torque={},
    speed=["M1", "M2"],
)
names = {
    "M1_inertia": I_c1i,
    "clutch1_inertia_output": I_c1o,
    "clutch2_inertia_input": I_c2i,
    "M2_inertia": I_c2o,
}
model = chain.model
S = sp.Matrix.vstack(*[model.velocity_rows[v] for v in ("M1.shaft", "clutch1.output", "M2.shaft")])
check("4.70", sp.Matrix([[1, -1, 0], [0, 1, -1], [1, 0, 0]]), S.inv())
x_rates = sp.Matrix(rates(model, names, [T1, T2], [Tc1, Tc2], [0, 0, 0]))
I_middle = I_c1o + I_c2i
check("4.69 corrected", [(T1 - Tc1) / I_c1i, (Tc1 - Tc2) / I_middle, (T2 + Tc2) / I_c2o], S * x_rates)
printed_4_71 = [
    T1 / I_c1i - (1 / I_c1i + 1 / I_middle) * Tc1 + Tc2 / I_middle,
    -T2 / I_c2o + Tc1 / I_middle - (1 / (I_c1i + I_c2o) + 1 / I_c2o) * Tc2,
    T1 / I_c1i - Tc1 / I_c1i,
]
corrected = -T2 / I_c2o + Tc1 / I_middle - (1 / I_middle + 1 / I_c2o) * Tc2
check("4.71a", printed_4_71[0], x_rates[0])
erratum("4.71b", printed_4_71[1], x_rates[1], "1/(I_c1i + I_c2o) must be 1/(I_c1o + I_c2i), the middle body")
check("4.71b corrected", corrected, x_rates[1])
check("4.71c", printed_4_71[2], x_rates[2])
for row, (derived, formula) in enumerate(zip(x_rates, (printed_4_71[0], corrected, printed_4_71[2]), strict=True)):
    for variable in (T1, T2, Tc1, Tc2):
        check(f"4.71 row {row + 1}", sp.diff(formula, variable), sp.diff(derived, variable))
equal = dict.fromkeys((I_c1i, I_c1o, I_c2i, I_c2o), 1)
check("4.71b at the example's inertias", printed_4_71[1].subs(equal), x_rates[1].subs(equal))

# %% [markdown]
# ## Friction is dissipative, (4.18) to (4.25)
# In the form (4.18), K22 = G M^-1 G' because the torques act through the transpose of the rows that give their
# velocities. It is symmetric and, for independent rows, positive definite. With the kinetic energy the friction power
# is -sum w_i T_i, never positive since (4.20) gives every torque the sign of its velocity; with the energy function
# x'x/2 of the source it is not (`errata.py`).

# %%


def positive(value):
    """Tell whether a rational expression of positive symbols is a quotient of sums of positive terms."""
    parts = sp.fraction(sp.factor(value))
    return all(all(c > 0 for c in sp.Poly(sp.expand(part)).coeffs()) for part in parts)


K_chain = rename(friction_matrix(model), names)
check("4.18", -sp.Matrix([[sp.diff(r, t) for t in (Tc1, Tc2)] for r in x_rates[:2]]), K_chain)
check("4.18", unit(0, 3).col_join(unit(1, 3)), model.friction_rows)
G = model.friction_rows
check("4.18 K22", (G * rename(model.mass, names).inv() * G.T).applyfunc(sp.cancel), K_chain)
check("4.18 K22", K_chain.T, K_chain)
everything = -sp.Matrix([[sp.diff(r, t) for t in (Tc1, Tc2)] for r in x_rates])
K_r = (rename(model.mass, names).inv() * G.T)[2:, :]
check("4.23", K_chain.col_join(K_r.applyfunc(sp.cancel)), everything)
if not (positive(K_chain[0, 0]) and positive(K_chain[1, 1]) and positive(K_chain.det())):
    raise AssertionError("K22 of the chain is positive definite")
if not (positive(K_diff[0, 0]) and positive(K_diff[1, 1]) and positive(K_diff.det())):
    raise AssertionError("K22 of the differential is positive definite")
x_sym = sp.Matrix(sp.symbols("x1:4", real=True))
mass = rename(model.mass, names)
kinetic_power = (x_sym.T * mass * x_rates.subs({T1: 0, T2: 0}))[0]
check("4.25 kinetic energy", -(x_sym[0] * Tc1 + x_sym[1] * Tc2), kinetic_power)
t1, t2 = sp.symbols("t1 t2", positive=True)  # (4.24): T = diag(t) x
check(
    "4.25 gains",
    -(t1 * x_sym[0] ** 2 + t2 * x_sym[1] ** 2),
    kinetic_power.subs({Tc1: t1 * x_sym[0], Tc2: t2 * x_sym[1]}),
)
print("K22 of chain and differential: symmetric, leading minors quotients of sums of positive terms")

# %% [markdown]
# ## Two pairs, (4.68), and three elements
# Two chains joined by a shaft: K consists of two blocks, and the problem of four elements falls into two of two. Three
# elements that do couple have 2^3 = 8 cases of sticking and sliding, not nine; seven of them, not eight, have at most
# two at rest. The last one has 3^3 = 27 sectors, as printed.

# %%
pairs = bed(
    ["M1 - clutch1 - clutch2 - shaft1 - clutch3 - clutch4 - M2"],
    machine("M1"),
    machine("M2"),
    table("shaft1", "shaft", **shaft),
    *(
        table(f"clutch{k}", "clutch", capacity="5 N m", inertia_output=f"{k} kg m^2", inertia_input="0.5 kg m^2")
        for k in (1, 2, 3, 4)
    ),
    torque={},
    speed=["M1", "M2"],
)
K_pairs = friction_matrix(pairs.model)
check("4.68", sp.zeros(2, 2), K_pairs[:2, 2:])
check("4.68", sp.zeros(2, 2), K_pairs[2:, :2])
if 0 in (K_pairs[0, 1], K_pairs[2, 3]):
    raise AssertionError("within each pair the clutches are coupled")
K = np.array(K_pairs.subs(pairs.model.values), dtype=float)
for w in rng.uniform(-2, 2, (200, 4)) @ K * 5.0:
    one, two = slice(0, 2), slice(2, 4)
    bound = np.full(4, 5.0)
    whole = solve_box(K, w, -bound, bound).T
    halves = [solve_box(K[p, p], w[p], -bound[p], bound[p]).T for p in (one, two)]
    if np.max(abs(whole - np.concatenate(halves))) > 1e-10:
        raise AssertionError("two pairs are two problems")
print("(4.68): 200 problems of two pairs are two problems each")
cases = list(itertools.product(("stick", "slide"), repeat=3))
erratum("after 4.68", 9, len(cases), "three elements: 2^3 = 8 cases, not nine")
erratum("after 4.68", 8, sum(case.count("stick") <= 2 for case in cases), "seven of them have at most two at rest")
check("after 4.68", 27, len(list(itertools.product((-1, 0, 1), repeat=3))))

# %% [markdown]
# ## Two clutches with ratios, (4.74) to (4.76)
# The simplified transmission of Section 3.7.2: clutch j drives the output through the ratio igb_j. As elements of
# ptgen that is one row (1, -igb_j) each. The transformation (4.74) is regular if the ratios differ, and K22 with it.

# %%
I_gbi, I_gbo, igb1, igb2, T_gbi, T_gbo = sp.symbols("I_gbi I_gbo igb1 igb2 T_gbi T_gbo", positive=True)
wide = Drive(*(sp.Integer(1000),) * 3)
gears = assemble(
    Mechanism(
        name="gears",
        velocities=("input", "output"),
        bodies=(Body("input", I_gbi), Body("output", I_gbo)),
        constraints=(),
        springs=(),
        frictions=tuple(
            Friction(name, {"input": sp.Integer(1), "output": -ratio}, T_cc, sp.Integer(0), FrictionRole.COUPLING)
            for name, ratio in (("clutch1", igb1), ("clutch2", igb2))
        ),
        torques=tuple(Torque(name, {name: sp.Integer(1)}, wide) for name in ("input", "output")),
        sensors=(),
        places=(),
        parameters=(),
        connections={},
        orientation={},
        observed=(),
    )
)
S = sp.Matrix.vstack(*[gears.velocity_rows[v] for v in ("input", "output")])
check("4.74", sp.Matrix([[1, -igb1], [1, -igb2]]), S.inv())
check("4.74 determinant", igb1 - igb2, sp.cancel(S.inv().det()))
slip_rates = rates(gears, {}, [T_gbi, -T_gbo], [Tc1, Tc2], [0, 0])
printed_4_75 = [
    T_gbi / I_gbi + r * T_gbo / I_gbo - Tc1 * (1 / I_gbi + r * igb1 / I_gbo) - Tc2 * (1 / I_gbi + r * igb2 / I_gbo)
    for r in (igb1, igb2)
]
check("4.75", printed_4_75, slip_rates)
check("4.76", sp.eye(2), gears.friction_rows)
check("4.75 determinant", (igb1 - igb2) ** 2 / (I_gbi * I_gbo), friction_matrix(gears).det())

# %%
summary()

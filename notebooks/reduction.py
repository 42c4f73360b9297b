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
# # Model reduction: Section 5.3, Appendix B, (3.6) and (3.7)
#
# A velocity without inertia follows from the balance of torques at its place. Static condensation
# does this for springs: with the massless angles q_m and the others q_k, q_m = -K_mm^-1 K_mk q_k.

# %%
import numpy as np
import scipy.integrate
import sympy as sp
from checking import check, erratum, show, summary

half = sp.Rational(1, 2)
i_d, T_dsl, r1, r3, I1, I2, I3 = sp.symbols("i_d T_dsl r1 r3 I1 I2 I3", positive=True)
cs1, cs2, cs3, igb, igb1, igb2 = sp.symbols("cs1 cs2 cs3 igb igb1 igb2", positive=True)
Im1, Im2, Im3, Igb1, Igb2, Igb3 = sp.symbols("Im1 Im2 Im3 Igb1 Igb2 Igb3", positive=True)
Tag1, Tag2, Tag3 = sp.symbols("Tag1 Tag2 Tag3", real=True)
phi1, phi2, phi3, phi_di, chi = sp.symbols("phi1 phi2 phi3 phi_di chi", real=True)
c_eq, dphi = sp.symbols("c_eq Delta_phi", positive=True)


def balance(potential, massless, torques):
    """Solve the torque balances of the massless angles; torques holds the applied ones."""
    return sp.solve([sp.diff(potential, x) - torques.get(x, 0) for x in massless], massless, dict=True)[0]


# %% [markdown]
# ## The inertia-free differential, (5.1)
# Virtual power of the bevel differential (3.14) with r1 = r2 and no inertia, no loss.

# %%
T_di, T_do1, T_do2, w_di, w_do1, w_do2, w_3b = sp.symbols("T_di T_do1 T_do2 w_di w_do1 w_do2 w_3b", real=True)
power = T_di * w_di - T_do1 * (w_di / i_d + r3 / r1 * w_3b) - T_do2 * (w_di / i_d - r3 / r1 * w_3b) - T_dsl * w_3b
split = sp.solve([sp.diff(power, w_di), sp.diff(power, w_3b)], [T_do1, T_do2], dict=True)[0]
T_5 = r1 / r3 * T_dsl
check("5.1", [i_d / 2 * T_di - T_5 / 2, i_d / 2 * T_di + T_5 / 2], [split[T_do1], split[T_do2]])
erratum(
    "5.1",
    [i_d / 2 * T_di - T_dsl / 2, i_d / 2 * T_di + T_dsl / 2],
    [split[T_do1], split[T_do2]],
    "T_dsl of (5.1) is r1/r3 times T_dsl of (3.15), (C.11), (C.14); the change of meaning is not stated",
)
kinematics = sp.solve(
    [w_do1 - w_di / i_d - r3 / r1 * w_3b, w_do2 - w_di / i_d + r3 / r1 * w_3b], [w_di, w_3b], dict=True
)[0]
check("5.1", i_d * (w_do1 + w_do2) / 2, kinematics[w_di])

# %% [markdown]
# ## Bed without gearboxes, (5.2) to (5.7)
# Machines on springs around the massless differential; phi_do = phi_di/i_d +- chi, and T_dsl as in
# (5.1) works on the half difference chi of the output velocities.

# %%
symmetric = {cs3: cs2}
potential = half * (
    cs1 * (phi1 - phi_di) ** 2 + cs2 * (phi_di / i_d + chi - phi2) ** 2 + cs2 * (phi_di / i_d - chi - phi3) ** 2
)
place = balance(potential, [phi_di, chi], {chi: -T_dsl})
shaft1 = sp.cancel((cs1 * (phi1 - phi_di)).subs(place))
shaft2 = sp.cancel((cs2 * (phi_di / i_d + chi - phi2)).subs(place))
shaft3 = sp.cancel((cs2 * (phi_di / i_d - chi - phi3)).subs(place))
twist = phi1 - i_d * (phi2 + phi3) / 2
stiffness_diff = sp.cancel(sp.diff(shaft1, phi1))
check("5.2", 2 * cs1 * cs2 / (i_d**2 * cs1 + 2 * cs2), stiffness_diff)
acceleration = [(Tag1 - shaft1) / Im1, (Tag2 + shaft2) / Im2, (Tag3 + shaft3) / Im3]
ce = stiffness_diff
check(
    "5.3",
    [
        -ce * phi1 / Im1 + i_d * ce * phi2 / (2 * Im1) + i_d * ce * phi3 / (2 * Im1) + Tag1 / Im1,
        i_d * ce * phi1 / (2 * Im2)
        - i_d**2 * ce * phi2 / (4 * Im2)
        - i_d**2 * ce * phi3 / (4 * Im2)
        - T_dsl / (2 * Im2)
        + Tag2 / Im2,
        i_d * ce * phi1 / (2 * Im3)
        - i_d**2 * ce * phi2 / (4 * Im3)
        - i_d**2 * ce * phi3 / (4 * Im3)
        + T_dsl / (2 * Im3)
        + Tag3 / Im3,
    ],
    acceleration,
)
bracket = ce * phi1 - i_d * ce / 2 * phi2 - i_d * ce / 2 * phi3
check("5.4", [bracket, i_d / 2 * bracket - T_dsl / 2, i_d / 2 * bracket + T_dsl / 2], [shaft1, shaft2, shaft3])
w1, w2, w3 = sp.symbols("w1 w2 w3", real=True)
check(
    "5.6",
    [
        -ce * twist / Im1 + Tag1 / Im1,
        i_d * ce * twist / (2 * Im2) - T_dsl / (2 * Im2) + Tag2 / Im2,
        i_d * ce * twist / (2 * Im3) + T_dsl / (2 * Im3) + Tag3 / Im3,
    ],
    acceleration,
)
check(
    "5.6", w1 - i_d * w2 / 2 - i_d * w3 / 2, sum(sp.diff(twist, x) * v for x, v in ((phi1, w1), (phi2, w2), (phi3, w3)))
)
check("5.7", [ce * twist, i_d / 2 * ce * twist - T_dsl / 2, i_d / 2 * ce * twist + T_dsl / 2], [shaft1, shaft2, shaft3])

# %% [markdown]
# ## Bed with adapter gearboxes, (5.8) to (5.13)
# The low-speed side as it stands: shaft 1 between phi1/igb1 and the differential, shafts 2 and 3
# between the differential and phi2/igb2, phi3/igb2. Scaling to the high-speed side must come out.

# %%
potential_gb = half * (
    cs1 * (phi1 / igb1 - phi_di) ** 2
    + cs2 * (phi_di / i_d + chi - phi2 / igb2) ** 2
    + cs2 * (phi_di / i_d - chi - phi3 / igb2) ** 2
)
place_gb = balance(potential_gb, [phi_di, chi], {chi: -T_dsl})
low1 = sp.cancel((cs1 * (phi1 / igb1 - phi_di)).subs(place_gb))
low2 = sp.cancel((cs2 * (phi_di / i_d + chi - phi2 / igb2)).subs(place_gb))
low3 = sp.cancel((cs2 * (phi_di / i_d - chi - phi3 / igb2)).subs(place_gb))
gb_acceleration = [(Tag1 - low1 / igb1) / I1, (Tag2 + low2 / igb2) / I2, (Tag3 + low3 / igb2) / I3]

id_p, T_p = sp.symbols("id_p T_p", positive=True)
scaled = {id_p: i_d * igb1 / igb2, T_p: T_dsl / igb2}
single = half * cs1 * ((phi1 - igb1 * phi_di) / igb1) ** 2
check("5.8", cs1 / igb1**2, sp.diff(single, phi1, 2))
check("5.8", [cs2 / igb2**2] * 2, [sp.diff(potential_gb, phi2, 2), sp.diff(potential_gb, phi3, 2)])
check("5.9", T_dsl / igb2, sp.cancel(low3 / igb2 - low2 / igb2).subs({phi2: 0, phi3: 0}))
check("5.9", i_d * igb1 / igb2, -2 * sp.cancel(sp.diff(low1, phi2) / sp.diff(low1, phi1)))
c1p, c2p = cs1 / igb1**2, cs2 / igb2**2
printed_c_gb = (2 * c1p * c2p / (id_p**2 * c1p + 2 * c2p)).subs(scaled)
check("5.10", printed_c_gb, sp.cancel(sp.diff(low1 / igb1, phi1)))
twist_gb = (phi1 - id_p * (phi2 + phi3) / 2).subs(scaled)
check("5.11", twist_gb, sp.cancel((low1 / igb1) / printed_c_gb))
printed_5_12 = [
    -c_eq * dphi / I1 + Tag1 / I1,
    id_p * c_eq * dphi / (2 * I2) - T_p / (2 * I2) + Tag2 / I2,
    id_p * c_eq * dphi / (2 * I3) + T_p / (2 * I3) + Tag3 / I3,
]
insert_gb = {c_eq: printed_c_gb, dphi: twist_gb}
check("5.12", [e.subs(insert_gb).subs(scaled) for e in printed_5_12], gb_acceleration)
check(
    "5.12",
    (w1 - id_p * w2 / 2 - id_p * w3 / 2).subs(scaled),
    sum(sp.diff(twist_gb, x) * v for x, v in ((phi1, w1), (phi2, w2), (phi3, w3))),
)

# %% [markdown]
# The flange sits between the rotor and the rigid rest of its machine's inertia: its torque is the
# reaction across that cut, by d'Alembert on the machine's side.

# %%
total = {I1: Im1 + Igb1, I2: Im2 + Igb2, I3: Im3 + Igb3}
flange = [Tag1 - Im1 * printed_5_12[0], Im2 * printed_5_12[1] - Tag2, Im3 * printed_5_12[2] - Tag3]
printed_5_13 = [
    Im1 / I1 * c_eq * dphi + Igb1 / I1 * Tag1,
    Im2 / I2 * id_p / 2 * c_eq * dphi - Im2 / I2 * T_p / 2 - Igb2 / I2 * Tag2,
    Im3 / I3 * id_p / 2 * c_eq * dphi + Im3 / I3 * T_p / 2 - Igb3 / I3 * Tag3,
]
check("5.13", [e.subs(total) for e in printed_5_13], [e.subs(total) for e in flange])
without = {Igb1: 0, Igb2: 0, Igb3: 0}
check(
    "5.13 limit",
    [e.subs(total).subs(without) for e in printed_5_13],
    [c_eq * dphi, id_p / 2 * c_eq * dphi - T_p / 2, id_p / 2 * c_eq * dphi + T_p / 2],
)

# %% [markdown]
# ## Bed for transmissions, (5.14) to (5.22)

# %%
T_gbi, T_gbo, w_gbi, w_gbo, phi_gbo = sp.symbols("T_gbi T_gbo w_gbi w_gbo phi_gbo", real=True)
gear_power = (T_gbi * w_gbi - T_gbo * w_gbo).subs(w_gbi, igb * w_gbo)
check("5.14", igb * T_gbi, sp.solve(sp.diff(gear_power, w_gbo), T_gbo)[0])
potential_t = half * (cs1 * (phi1 - igb * phi_gbo) ** 2 + cs2 * (phi_gbo - phi2) ** 2)
place_t = balance(potential_t, [phi_gbo], {})
flange1_t = sp.cancel((cs1 * (phi1 - igb * phi_gbo)).subs(place_t))
flange2_t = sp.cancel((cs2 * (phi_gbo - phi2)).subs(place_t))
stiffness_t = cs1 * cs2 / (igb**2 * cs1 + cs2)
check("5.15", stiffness_t, sp.diff(flange1_t, phi1))
twist_t = phi1 - igb * phi2
check(
    "5.16",
    [-stiffness_t * twist_t / Im1 + Tag1 / Im1, igb * stiffness_t * twist_t / Im2 + Tag2 / Im2],
    [(Tag1 - flange1_t) / Im1, (Tag2 + flange2_t) / Im2],
)
check("5.16", w1 - igb * w2, sp.diff(twist_t, phi1) * w1 + sp.diff(twist_t, phi2) * w2)
check("5.17", twist_t, sp.cancel(flange1_t / stiffness_t))
check("5.18", [stiffness_t * twist_t, igb * stiffness_t * twist_t], [flange1_t, flange2_t])

# %% [markdown]
# Transfer functions by C (sI - A)^-1 B from the state equations (5.16) and outputs (5.19).

# %%
s = sp.symbols("s")
A_t = sp.Matrix([[0, 0, -c_eq / Im1], [0, 0, igb * c_eq / Im2], [1, -igb, 0]])
B_t = sp.Matrix([[1 / Im1, 0], [0, 1 / Im2], [0, 0]])
C_t = sp.Matrix([[0, 0, c_eq], [0, 1, 0]])
G_t = (C_t * (s * sp.eye(3) - A_t).LUsolve(B_t)).applyfunc(sp.cancel)
quadratic = s**2 + c_eq / Im1 + c_eq * igb**2 / Im2
check("5.20", [c_eq / (Im1 * quadratic), -c_eq * igb / (Im2 * quadratic)], G_t[0, :])
check("5.21", [c_eq * igb / (Im1 * Im2 * s * quadratic), (s**2 + c_eq / Im1) / (Im2 * s * quadratic)], G_t[1, :])
root = sp.I * sp.sqrt(c_eq * (1 / Im1 + igb**2 / Im2))
check("5.22", [sp.denom(G_t[0, 0]).subs(s, root), sp.denom(G_t[0, 0]).subs(s, -root)], [0, 0])

# %% [markdown]
# ### A ratio that changes in time
# Section 5.4.1 keeps a term with d(igb)/dt. Two things that (5.15), (5.17) bring in are left out
# there: the derivative of (5.17) has a term in phi2, and the stiffness (5.15) changes as well.

# %%
t = sp.symbols("t")
ratio_t, angle1, angle2 = sp.Function("i")(t), sp.Function("p1")(t), sp.Function("p2")(t)
rate_of_twist = sp.diff(angle1 - ratio_t * angle2, t)
erratum(
    "5.44",
    sp.diff(angle1, t) - ratio_t * sp.diff(angle2, t),
    rate_of_twist,
    "(5.44c) is not the derivative of (5.17) while the ratio changes: - phi2 d(igb)/dt is missing",
)
torque_t = stiffness_t.subs(igb, ratio_t) * dphi
erratum(
    "5.45",
    0,
    sp.diff(torque_t, t),
    "with (5.15) the stiffness depends on igb, its rate is missing for a changing ratio",
)

# %% [markdown]
# # Appendix B
# ## Three-mass oscillator, (B.1) to (B.6)

# %%
ds1, ds2, T1, T2 = sp.symbols("ds1 ds2 T1 T2", positive=True)
q1, q2, q3, v1, v2, v3, a3 = sp.symbols("q1 q2 q3 v1 v2 v3 a3", real=True)
V = half * (cs1 * (q1 - q3) ** 2 + cs2 * (q3 - q2) ** 2)
D = half * (ds1 * (v1 - v3) ** 2 + ds2 * (v3 - v2) ** 2)
Ts1 = ds1 * (v1 - v3) + cs1 * (q1 - q3)
Ts2 = ds2 * (v3 - v2) + cs2 * (q3 - q2)
lagrange = [T - sp.diff(V, x) - sp.diff(D, y) for T, x, y in ((T1, q1, v1), (T2, q2, v2), (0, q3, v3))]
check("B.1", [T1 - Ts1, T2 + Ts2, Ts1 - Ts2], lagrange)
check("B.2", [Ts1, Ts2], [-lagrange[0] + T1, lagrange[1] - T2])
check("B.3", Ts1 - Ts2, lagrange[2])

a1, a2 = (T1 - Ts1) / I1, (T2 + Ts2) / I2
rates = {q1: v1, q2: v2, q3: v3, v1: a1, v2: a2, v3: a3}
rate_of_balance = sum(sp.diff(Ts1 - Ts2, x) * y for x, y in rates.items())
b1, b2 = sp.symbols("b1 b2", real=True)
check(
    "B.5",
    (ds1 * (b1 - a3) + cs1 * (v1 - v3) - ds2 * (a3 - b2) - cs2 * (v3 - v2)).subs({b1: a1, b2: a2}),
    rate_of_balance,
)
angle = [sp.Function(f"q{k}")(t) for k in (1, 2, 3)]
in_time = dict(zip((q1, q2, q3), angle, strict=True)) | dict(
    zip((v1, v2, v3), [sp.diff(x, t) for x in angle], strict=True)
)
check(
    "B.4",
    sp.diff(Ts1.subs(in_time), t) - sp.diff(Ts2.subs(in_time), t),
    ds1 * sp.diff(angle[0] - angle[2], t, 2)
    + cs1 * sp.diff(angle[0] - angle[2], t)
    - ds2 * sp.diff(angle[2] - angle[1], t, 2)
    - cs2 * sp.diff(angle[2] - angle[1], t),
)
printed_B6 = (
    (cs1 - ds1**2 / I1) * v1
    + (cs2 - ds2**2 / I2) * v2
    + (ds1**2 / I1 + ds2**2 / I2 - cs1 - cs2) * v3
    - cs1 * ds1 / I1 * q1
    - cs2 * ds2 / I2 * q2
    + (cs1 * ds1 / I1 + cs2 * ds2 / I2) * q3
    + ds1 / I1 * T1
    + ds2 / I2 * T2
)
acceleration3 = sp.solve(rate_of_balance, a3)[0]
check("B.6", printed_B6 / (ds1 + ds2), acceleration3)

# %% [markdown]
# ## Two exact cases, (B.7) to (B.15)

# %%
undamped = {ds1: 0, ds2: 0}
check("B.7", cs1 * (q1 - q3) - cs2 * (q3 - q2), lagrange[2].subs(undamped))
check("B.8", cs1 * (v1 - v3) - cs2 * (v3 - v2), rate_of_balance.subs(undamped))
q3_static = sp.solve(lagrange[2].subs(undamped), q3)[0]
v3_static = sp.solve(rate_of_balance.subs(undamped), v3)[0]
check("B.9", [(cs1 * q1 + cs2 * q2) / (cs1 + cs2), (cs1 * v1 + cs2 * v2) / (cs1 + cs2)], [q3_static, v3_static])
shaft_static = sp.cancel(Ts1.subs(undamped).subs(q3, q3_static))
check("B.10", cs1 * (q1 - (cs1 * q1 + cs2 * q2) / (cs1 + cs2)), shaft_static)
check("B.10", cs1 * cs2 / (cs1 + cs2) * (q1 - q2), sp.cancel(Ts2.subs(undamped).subs(q3, q3_static)))
check("B.11", [cs1 * cs2 / (cs1 + cs2), 0], [sp.diff(shaft_static, q1), sp.diff(shaft_static, v1)])

# %% [markdown]
# (B.12): let phi3 = alpha phi1 + beta phi2 and the same for the velocities. The balance must hold
# for all motions, which fixes alpha twice, once from the springs and once from the dampers.

# %%
alpha, beta = sp.symbols("alpha beta")
combined = sp.expand(lagrange[2].subs({q3: alpha * q1 + beta * q2, v3: alpha * v1 + beta * v2}))
conditions = [combined.coeff(x) for x in (q1, v1)]
resultant = sp.resultant(conditions[0], conditions[1], alpha)
check("B.12", (cs1 * ds2 - cs2 * ds1) ** 2, sp.expand(resultant) ** 2)
proportional = {ds2: cs2 * ds1 / cs1}
q3_prop = (cs1 * q1 + cs2 * q2) / (cs1 + cs2)
v3_prop = ((ds1 * v1 + ds2 * v2) / (ds1 + ds2)).subs(proportional)
alpha_prop = sp.solve(conditions[0], alpha)[0]
check("B.13", [sp.diff(q3_prop, q1), sp.diff(v3_prop, v1)], [alpha_prop, alpha_prop])
check("B.13", [lagrange[2].subs({q3: q3_prop, v3: v3_prop}).subs(proportional)], [0])
shaft_prop = Ts1.subs({q3: q3_prop, v3: v3_prop}).subs(proportional)
check(
    "B.14", (ds1 * ds2 / (ds1 + ds2) * (v1 - v2) + cs1 * cs2 / (cs1 + cs2) * (q1 - q2)).subs(proportional), shaft_prop
)
check(
    "B.15",
    [(ds1 * ds2 / (ds1 + ds2)).subs(proportional), cs1 * cs2 / (cs1 + cs2)],
    [sp.diff(shaft_prop, v1), sp.diff(shaft_prop, q1)],
)

# %% [markdown]
# After (B.15) the text says that in these two cases (B.6) does not depend on omega_3 and phi_3.
# Its coefficient of omega_3 is not zero there; what holds is that (B.13) solves it.

# %%
coefficient = sp.diff(acceleration3, v3).subs(proportional)
erratum("B.6", coefficient, 0, "(B.6) keeps its omega_3 terms when (B.12) holds")
check(
    "B.6 solved by B.13",
    acceleration3.subs({q3: q3_prop, v3: v3_prop}).subs(proportional),
    (alpha_prop * a1 + (1 - alpha_prop) * a2).subs({q3: q3_prop, v3: v3_prop}).subs(proportional),
)

# %% [markdown]
# ## State-space forms and characteristic polynomials, (B.17) to (B.23)

# %%
states = sp.Matrix([v1, v2, v3, q1, q2, q3])
right_side = sp.Matrix([a1, a2, acceleration3, v1, v2, v3])
A = right_side.jacobian(states).applyfunc(sp.cancel)
B = right_side.jacobian([T1, T2])
dd = ds1 + ds2
printed_A = sp.Matrix(
    [
        [-ds1 / I1, 0, ds1 / I1, -cs1 / I1, 0, cs1 / I1],
        [0, -ds2 / I2, ds2 / I2, 0, -cs2 / I2, cs2 / I2],
        [
            (cs1 - ds1**2 / I1) / dd,
            (cs2 - ds2**2 / I2) / dd,
            (ds1**2 / I1 + ds2**2 / I2 - cs1 - cs2) / dd,
            -cs1 * ds1 / I1 / dd,
            -cs2 * ds2 / I2 / dd,
            (cs1 * ds1 / I1 + cs2 * ds2 / I2) / dd,
        ],
        [1, 0, 0, 0, 0, 0],
        [0, 1, 0, 0, 0, 0],
        [0, 0, 1, 0, 0, 0],
    ]
)
printed_B = sp.Matrix([[1 / I1, 0], [0, 1 / I2], [ds1 / (I1 * dd), ds2 / (I2 * dd)], [0, 0], [0, 0], [0, 0]])
check("B.17", printed_A, A)
check("B.17", printed_B, B)

d_eq = sp.symbols("d_eq", positive=True)
one_shaft = d_eq * (v1 - v2) + c_eq * (q1 - q2)
A_two = sp.Matrix([(T1 - one_shaft) / I1, (T2 + one_shaft) / I2, v1, v2]).jacobian([v1, v2, q1, q2])
check(
    "B.19",
    sp.Matrix(
        [
            [-d_eq / I1, d_eq / I1, -c_eq / I1, c_eq / I1],
            [d_eq / I2, -d_eq / I2, c_eq / I2, -c_eq / I2],
            [1, 0, 0, 0],
            [0, 1, 0, 0],
        ]
    ),
    A_two,
)

mu = 1 / I1 + 1 / I2
polynomial = A.charpoly(s).as_expr()
printed_B20 = (
    s**6
    + ((cs1 + cs2) / dd + ds1 * ds2 / dd * mu) * s**5
    + (cs1 * ds2 + cs2 * ds1) / dd * mu * s**4
    + cs1 * cs2 / dd * mu * s**3
)
check("B.20", printed_B20, polynomial)
zeta, omega0, gamma = sp.symbols("zeta omega0 gamma", positive=True)
product = sp.expand((s - (-zeta + sp.I * omega0)) * (s - (-zeta - sp.I * omega0)) * (s + gamma))
check(
    "B.21",
    s**3
    + (2 * zeta + gamma) * s**2
    + (omega0**2 + zeta**2 + 2 * zeta * gamma) * s
    + gamma * omega0**2
    + gamma * zeta**2,
    product,
)
cubic = sp.Poly(sp.cancel(polynomial / s**3), s).all_coeffs()
printed_B22 = [
    (2 * zeta + gamma) - ((cs1 + cs2) / dd + ds1 * ds2 / dd * mu),
    (omega0**2 + zeta**2 + 2 * zeta * gamma) - (cs1 * ds2 + cs2 * ds1) / dd * mu,
    (omega0**2 * gamma + zeta**2 * gamma) - cs1 * cs2 / dd * mu,
]
check("B.22", printed_B22, [x - y for x, y in zip(sp.Poly(product, s).all_coeffs()[1:], cubic[1:], strict=True)])
polynomial_two = sp.cancel(A_two.charpoly(s).as_expr() / s**2)
zeta_two = d_eq / (2 * I1) + d_eq / (2 * I2)
omega_two = sp.sqrt((c_eq / I1 + c_eq / I2) - zeta_two**2)
check("B.23", sp.expand((s + zeta_two) ** 2 + omega_two**2), polynomial_two)

# %% [markdown]
# ## Equivalent shaft, (B.24) to (B.28)
# Equal decay rates and damped frequencies; then the stiffness is fixed by the static twist, gamma
# follows from the last and the damping from the middle coefficient.

# %%
equal = {zeta: zeta_two, omega0: omega_two}
matched = [sp.expand(e.subs(equal)) for e in printed_B22]
printed_B24 = [
    gamma + d_eq * mu - ((cs1 + cs2) / dd + ds1 * ds2 / dd * mu),
    c_eq + gamma * d_eq - (cs1 * ds2 + cs2 * ds1) / dd,
    gamma * c_eq - cs1 * cs2 / dd,
]
check("B.24", [printed_B24[0], printed_B24[1] * mu, printed_B24[2] * mu], matched)
twist_of_two = T1 / cs1 + T1 / cs2
check("B.25", cs1 * cs2 / (cs1 + cs2), T1 / twist_of_two)
c_series = cs1 * cs2 / (cs1 + cs2)
gamma_series = sp.solve(matched[2].subs(c_eq, c_series), gamma)[0]
check("B.26", (cs1 + cs2) / (ds1 + ds2), gamma_series)
d_series = sp.solve(matched[1].subs({c_eq: c_series, gamma: gamma_series}), d_eq)[0]
printed_B27 = (cs1**2 * ds2 + cs2**2 * ds1) / (cs1 + cs2) ** 2
check("B.27", printed_B27, d_series)
residual = matched[0].subs({gamma: gamma_series, d_eq: d_series})
check("B.28", (cs1 + cs2) / dd + printed_B27 * mu - ((cs1 + cs2) / dd + ds1 * ds2 / dd * mu), residual)
check("B.28", (cs1 * ds2 - cs2 * ds1) ** 2 / ((cs1 + cs2) ** 2 * dd) * mu, residual)

# %% [markdown]
# The last line is the exact error of (B.28): a square that vanishes for (B.12) only. Static
# condensation gives the same damping: with the shape phi3 of (B.9) the dampers' matrix becomes
# Psi' D Psi.

# %%
Psi = sp.Matrix([[1, 0], [0, 1], [cs1 / (cs1 + cs2), cs2 / (cs1 + cs2)]])
damping_matrix, stiffness_matrix = sp.hessian(D, [v1, v2, v3]), sp.hessian(V, [q1, q2, q3])
check("B.27", printed_B27, sp.cancel((Psi.T * damping_matrix * Psi)[0, 0]))
check("B.25", c_series, sp.cancel((Psi.T * stiffness_matrix * Psi)[0, 0]))

# %% [markdown]
# ## Chains, (B.29) to (B.33), (3.6), (3.7)
# Condensation of a whole chain of k shafts at once, for k = 2 to 4, and the step from k to k + 1
# for any k.

# %%
ds3 = sp.symbols("ds3", positive=True)


def condensed_chain(c, d):
    """Equivalent stiffness and damping of shafts in series by condensing all inner angles at once."""
    n = len(c)
    rows = sp.zeros(n, n + 1)
    for k in range(n):
        rows[k, k], rows[k, k + 1] = 1, -1
    K, R = rows.T * sp.diag(*c) * rows, rows.T * sp.diag(*d) * rows
    inner = list(range(1, n))
    shape = sp.zeros(n + 1, 2)
    shape[0, 0], shape[n, 1] = 1, 1
    shape[1:n, :] = -K.extract(inner, inner).LUsolve(K.extract(inner, [0, n])).applyfunc(sp.cancel)
    return sp.cancel((shape.T * K * shape)[0, 0]), sp.cancel((shape.T * R * shape)[0, 0])


c12, d12 = condensed_chain([cs1, cs2], [ds1, ds2])
check("B.29", [cs1 * cs2 / (cs1 + cs2), c12**2 / cs1**2 * ds1 + c12**2 / cs2**2 * ds2], [c12, d12])
check("B.29", printed_B27, d12)
c123, d123 = condensed_chain([cs1, cs2, cs3], [ds1, ds2, ds3])
check(
    "B.30",
    [
        c12 * cs3 / (c12 + cs3),
        1 / (1 / c12 + 1 / cs3),
        1 / (1 / cs1 + 1 / cs2 + 1 / cs3),
        cs1 * cs2 * cs3 / (cs1 * cs2 + cs1 * cs3 + cs2 * cs3),
    ],
    [c123] * 4,
)
check(
    "B.31",
    [
        (c12**2 * ds3 + cs3**2 * d12) / (c12 + cs3) ** 2,
        c123**2 / c12**2 * d12 + c123**2 / cs3**2 * ds3,
        c123**2 / cs1**2 * ds1 + c123**2 / cs2**2 * ds2 + c123**2 / cs3**2 * ds3,
    ],
    [d123] * 3,
)
for k in (2, 3, 4):
    c, d = sp.symbols(f"c1:{k + 1}", positive=True), sp.symbols(f"d1:{k + 1}", positive=True)
    c_chain, d_chain = condensed_chain(list(c), list(d))
    printed_c = 1 / sum(1 / x for x in c)
    printed_d = sum(printed_c**2 / x**2 * y for x, y in zip(c, d, strict=True))
    check("B.32", printed_c, c_chain)
    check("B.33", printed_d, d_chain)
    check("3.6", printed_c, c_chain)
    check("3.7", printed_d, d_chain)

compliance, weighted, c_next, d_next = sp.symbols("compliance weighted c_next d_next", positive=True)
c_k, d_k = 1 / compliance, weighted / compliance**2
c_step, d_step = condensed_chain([c_k, c_next], [d_k, d_next])
check("B.32", 1 / (compliance + 1 / c_next), c_step)
check("B.33", (weighted + d_next / c_next**2) * c_step**2, d_step)

# %% [markdown]
# ## Table B.1: roots, as in Figure B.4
# One of the complex roots of the exact polynomial (B.20), of the equivalent shaft (B.25), (B.27)
# and of the conventional one (B.15), for ds2 from 0 to 20 N m s/rad.

# %%
import matplotlib.pyplot as plt


def exact_root(j1, j2, c1, c2, d1, d2):
    """Complex root (rad/s) of the cubic factor of (B.20) with positive imaginary part."""
    m = 1 / j1 + 1 / j2
    roots = np.roots(
        [
            1,
            (c1 + c2) / (d1 + d2) + d1 * d2 / (d1 + d2) * m,
            (c1 * d2 + c2 * d1) / (d1 + d2) * m,
            c1 * c2 / (d1 + d2) * m,
        ]
    )
    return roots[np.argmax(roots.imag)]


def shaft_root(j1, j2, c, d):
    """Complex root (rad/s) of the two-mass oscillator, (B.23)."""
    decay = d / 2 * (1 / j1 + 1 / j2)
    return complex(-decay, np.sqrt(c * (1 / j1 + 1 / j2) - decay**2))


settings = {"setting 1": (5.0, 10.0, 3e3, 6e3, 5.0), "setting 2": (5.0, 10.0, 3e3, 12e3, 5.0)}
figure, axis = plt.subplots(figsize=(7, 5))
root_error, conventional_error = {}, {}
for name, (j1, j2, c1, c2, d1) in settings.items():
    grid = np.linspace(0, 20, 81)
    exact = np.array([exact_root(j1, j2, c1, c2, d1, d2) for d2 in grid])
    proposed = np.array(
        [shaft_root(j1, j2, c1 * c2 / (c1 + c2), (c1**2 * d2 + c2**2 * d1) / (c1 + c2) ** 2) for d2 in grid]
    )
    conventional = np.array([shaft_root(j1, j2, c1 * c2 / (c1 + c2), d1 * d2 / (d1 + d2)) for d2 in grid])
    root_error[name] = float(max(abs(proposed - exact)))
    conventional_error[name] = float(max(abs(conventional - exact)))
    print(
        f"{name}: distance to the exact root, equivalent {root_error[name]:.4f} rad/s, conventional {conventional_error[name]:.4f} rad/s"
    )
    for data, style, label in (
        (exact, "-", "exact"),
        (proposed, "--", "equivalent"),
        (conventional, ":", "conventional"),
    ):
        axis.plot(data.real, data.imag, style, label=f"{label}, {name}")
axis.set_xlabel("real part (rad/s)")
axis.set_ylabel("imaginary part (rad/s)")
axis.legend()
show(figure)
for name in settings:
    if not root_error[name] < 0.02 * conventional_error[name]:
        raise AssertionError(f"{name}: the equivalent shaft should be much closer to the exact root")

# %% [markdown]
# ## Table B.1: time domain, as in Figures B.5 and B.6
# A pulse of T1 of one second. The source does not state its height; 100 N m is used here, and the
# system is linear, so relative deviations do not depend on it.

# %%
j1, j2, c1, c2, d1, d2 = 5.0, 10.0, 3e3, 6e3, 5.0, 1.0
numbers = {I1: j1, I2: j2, cs1: c1, cs2: c2, ds1: d1, ds2: d2}
A_exact = np.array(printed_A.subs(numbers), dtype=float)
B_exact = np.array(printed_B.subs(numbers), dtype=float)


def speeds(a, b, times):
    """Rotational speeds n1, n2 (rpm) for the pulse of T1."""

    def rate(time, x):
        return a @ x + b[:, 0] * (100.0 if time < 1.0 else 0.0)

    first = scipy.integrate.solve_ivp(rate, (0, 1), np.zeros(len(a)), t_eval=times[times <= 1], rtol=1e-9, atol=1e-12)
    start = first.y[:, -1]
    second = scipy.integrate.solve_ivp(
        lambda _, x: a @ x, (1, times[-1]), start, t_eval=times[times > 1], rtol=1e-9, atol=1e-12
    )
    return np.hstack([first.y, second.y])[:2] * 30 / np.pi


times = np.linspace(0, 3, 1501)
reference = speeds(A_exact, B_exact, times)
curves = {}
for name, c, d in (
    ("equivalent", c1 * c2 / (c1 + c2), (c1**2 * d2 + c2**2 * d1) / (c1 + c2) ** 2),
    ("conventional", c1 * c2 / (c1 + c2), d1 * d2 / (d1 + d2)),
):
    values = {I1: j1, I2: j2, c_eq: c, d_eq: d}
    curves[name] = speeds(
        np.array(A_two.subs(values), dtype=float), np.array([[1 / j1, 0], [0, 1 / j2], [0, 0], [0, 0]]), times
    )
deviation = {name: np.max(abs(y - reference), axis=1) / np.max(abs(reference), axis=1) for name, y in curves.items()}
print("largest relative deviation of n1, n2:", {k: np.round(x, 5) for k, x in deviation.items()})
if not np.all(deviation["equivalent"] < 0.05 * deviation["conventional"]):
    raise AssertionError("the equivalent shaft should be much closer in the time domain")
figure, axes = plt.subplots(2, 1, sharex=True, layout="constrained")
for k, axis in enumerate(axes):
    axis.plot(times, reference[k], label="two shafts")
    for name, y in curves.items():
        axis.plot(times, y[k], "--", label=name)
    axis.set_ylabel(f"n{k + 1} (rpm)")
axes[0].legend()
axes[1].set_xlabel("time (s)")
show(figure)

# %% [markdown]
# # The same from ptgen's general procedures
# ptgen reduces a bed by rules of its own (shares of energy, static condensation). What comes out is
# compared with the formulas of the source.

# %%
from beds import bed, machine, rates, rename, shipped, signal, table

# %% [markdown]
# ## Shafts in series, (3.6), (3.7), (B.25), (B.27), (B.30), (B.31)
# Each equivalent shaft has its own symbols; `definitions` says what they stand for.


# %%
def chain_bed(count):
    """Two machines with `count` shafts in series between them."""
    shafts = [table(f"s{k}", "shaft", stiffness="3 kN m/rad", damping="5 N m s/rad") for k in range(1, count + 1)]
    chain = " - ".join(["M1", *(f"s{k}" for k in range(1, count + 1)), "M2"])
    return bed([chain], machine("M1"), machine("M2"), *shafts, torque={"M1": "s1"}, speed=["M2"])


def equivalent(project):
    """Stiffness and damping of the one shaft that is left, in the parameters of the file."""
    reduced = project.reduced
    found = {}
    for quantity in ("stiffness", "damping"):
        symbol = next(s for s in reduced.definitions if s.name == f"{reduced.model.twists[0]}_{quantity}")
        expression = reduced.definitions[symbol]
        while expression.free_symbols & set(reduced.definitions):
            expression = expression.subs(dict(reduced.definitions))
        found[quantity] = expression
    return found["stiffness"], found["damping"]


for count in (2, 3, 4):
    c, d = sp.symbols(f"c1:{count + 1}", positive=True), sp.symbols(f"d1:{count + 1}", positive=True)
    shaft_names = {f"s{k + 1}_stiffness": c[k] for k in range(count)} | {
        f"s{k + 1}_damping": d[k] for k in range(count)
    }
    c_found, d_found = (rename(e, shaft_names) for e in equivalent(chain_bed(count)))
    c_printed = 1 / sum(1 / k for k in c)
    d_printed = sum(c_printed**2 / k**2 * y for k, y in zip(c, d, strict=True))
    for number in ("3.6", "B.32") + {2: ("B.25",), 3: ("B.30",)}.get(count, ()):
        check(number, c_printed, c_found)
    for number in ("3.7", "B.33") + {2: ("B.27",), 3: ("B.31",)}.get(count, ()):
        check(number, d_printed, d_found)

# %% [markdown]
# ## Bed without gearboxes, (5.2) to (5.7)
# The source takes the torque flanges as rigid, so the file says the same. T_dsl of Section 5.3 is the
# one of the differential times r1/r3, i.e. over `pinion_ratio`.

# %%
direct = shipped("differential", '\n[reduction]\nrigid = ["flange1", "flange2", "flange3"]\n')
direct_model = direct.reduced.model
rho = sp.symbols("rho", positive=True)
direct_names = {
    "M1_inertia": Im1,
    "M2_inertia": Im2,
    "M3_inertia": Im3,
    "cardan1_stiffness": cs1,
    "cardan2_stiffness": cs2,
    "cardan3_stiffness": cs2,
    "diff_ratio": i_d,
    "diff_pinion_ratio": rho,
}
print(direct_model.coordinates, direct_model.twists, [round(m.frequency_hz, 2) for m in direct.reduced.modes_after])
check("5.2", 2 * cs1 * cs2 / (i_d**2 * cs1 + 2 * cs2), rename(direct_model.stiffness[0, 0], direct_names))
check("5.5", [1, -i_d / 2, -i_d / 2], list(rename(direct_model.twist_rows, direct_names)))
variables = ([Tag1, Tag2, Tag3], [rho * T_dsl], [w1, w2, w3, dphi])
printed_5_6 = [
    -ce * dphi / Im1 + Tag1 / Im1,
    i_d * ce * dphi / (2 * Im2) - T_dsl / (2 * Im2) + Tag2 / Im2,
    i_d * ce * dphi / (2 * Im3) + T_dsl / (2 * Im3) + Tag3 / Im3,
]
check("5.6", printed_5_6, rates(direct_model, direct_names, *variables))
check(
    "5.7",
    [ce * dphi, i_d / 2 * ce * dphi - T_dsl / 2, i_d / 2 * ce * dphi + T_dsl / 2],
    [signal(direct_model, f"flange{k}_torque", direct_names, *variables) for k in (1, 2, 3)],
)
check("5.7 place", ce * dphi, signal(direct_model, "diff.input", direct_names, *variables))

# %% [markdown]
# With unequal shafts (5.2) has a form that the source does not print: twice the shaft of the outputs
# becomes the shaft of half the sum of the compliances, and the slip-limiting torque is felt at the input.

# %%
unequal = direct_names | {"cardan3_stiffness": cs3}
check(
    "5.2 unequal shafts",
    1 / (1 / cs1 + i_d**2 / 4 * (1 / cs2 + 1 / cs3)),
    rename(direct_model.stiffness[0, 0], unequal),
)
print("M1's share of T_dsl:", sp.factor(rename(direct_model.friction_rows[0, 0], unequal)))

# %% [markdown]
# ## Bed with adapter gearboxes, (5.8) to (5.13)

# %%
geared = shipped("differential-gearboxes")
geared_model = geared.reduced.model
geared_names = direct_names | {
    "gearbox1_ratio": igb1,
    "gearbox2_ratio": igb2,
    "gearbox3_ratio": igb2,
    "gearbox1_inertia": Igb1,
    "gearbox2_inertia": Igb2,
    "gearbox3_inertia": Igb3,
}
print(geared_model.coordinates, geared_model.twists, [round(m.frequency_hz, 3) for m in geared.reduced.modes_after])
check("5.10", printed_c_gb, rename(geared_model.stiffness[0, 0], geared_names))
check("5.11", [1, -id_p.subs(scaled) / 2, -id_p.subs(scaled) / 2], list(rename(geared_model.twist_rows, geared_names)))
at_flange = ([Tag1, Tag2, Tag3], [rho * T_dsl], [w1, w2, w3, dphi])
stiff = {c_eq: printed_c_gb}
check(
    "5.12",
    [e.subs(stiff).subs(scaled).subs(total) for e in printed_5_12],
    rates(geared_model, geared_names, *at_flange),
)
check(
    "5.13",
    [e.subs(stiff).subs(scaled).subs(total) for e in printed_5_13],
    [signal(geared_model, f"flange{k}_torque", geared_names, *at_flange) for k in (1, 2, 3)],
)

# %% [markdown]
# ## Bed for transmissions, (5.15) to (5.18)

# %%
transmission = bed(
    ["M1 - flange1 - shaft1 - gearbox1 - shaft2 - flange2 - M2"],
    machine("M1"),
    machine("M2"),
    *(table(f"flange{k}", "torque_flange", inertia="0.01 kg m^2", stiffness="400 kN m/rad") for k in (1, 2)),
    *(table(f"shaft{k}", "shaft", stiffness="30 kN m/rad") for k in (1, 2)),
    table("gearbox1", "gearbox", ratio=2, inertia="0.02 kg m^2"),
    torque={"M1": "flange1"},
    speed=["M2"],
    reduction='rigid = ["flange1", "flange2"]',
)
transmission_names = {
    "M1_inertia": Im1,
    "M2_inertia": Im2,
    "shaft1_stiffness": cs1,
    "shaft2_stiffness": cs2,
    "gearbox1_ratio": igb,
}
transmission_model = transmission.reduced.model
print(transmission_model.coordinates, [rule.rule + " " + rule.element for rule in transmission.reduced.rules])
check("5.15", stiffness_t, rename(transmission_model.stiffness[0, 0], transmission_names))
check("5.17", [1, -igb], list(rename(transmission_model.twist_rows, transmission_names)))
t_variables = ([Tag1, Tag2], [], [w1, w2, dphi])
check(
    "5.16",
    [-stiffness_t * dphi / Im1 + Tag1 / Im1, igb * stiffness_t * dphi / Im2 + Tag2 / Im2],
    rates(transmission_model, transmission_names, *t_variables),
)
check(
    "5.19",
    [stiffness_t * dphi, w2],
    [
        signal(transmission_model, name, transmission_names, *t_variables)
        for name in transmission.design.decoupling.outputs
    ],
)
check(
    "5.18",
    [stiffness_t * dphi, igb * stiffness_t * dphi],
    [signal(transmission_model, f"flange{k}_torque", transmission_names, *t_variables) for k in (1, 2)],
)

# %%
summary()

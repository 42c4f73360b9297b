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
# # Further errata: Chapter 4 and Section 5.7
#
# Evidence for the entries of docs/errata.md that the other notebooks do not hold.

# %%
import itertools

import sympy as sp
from checking import check, erratum, summary

# %% [markdown]
# ## Clutch, (4.2), (4.15), (4.16)

# %%
Ici, Ico, mu, T_cs, T_cc, k_cv, w_cs = sp.symbols("Ici Ico mu T_cs T_cc k_cv w_cs", positive=True)
w_ci, w_co, T_ci, T_co, T_c, speed = sp.symbols("w_ci w_co T_ci T_co T_c speed", real=True)
breakaway = sp.limit(mu * (T_cc + (T_cs - T_cc) * sp.exp(-speed / w_cs) + k_cv * speed), speed, 0, "+")
erratum("4.2", T_cs, breakaway, "the limit of (4.1) at zero speed is mu_c T_cs, not T_cs")
rates = {w_ci: (T_ci - T_c) / Ici, w_co: (T_c - T_co) / Ico}


def rate(expression):
    """Time derivative along (3.11)."""
    return sp.expand(sum(sp.diff(expression, k) * r for k, r in rates.items()))


difference = w_ci - w_co
sticking = sp.solve(rate(difference), T_c)[0]
erratum(
    "4.2",
    T_ci - T_co,
    sticking,
    "the sticking clutch carries (Ico Tci + Ici Tco)/(Ici + Ico), no sum of external torques",
)
printed_w0 = w_ci - Ico / (Ici + Ico) * w_co
printed_4_16a = T_ci / (Ici + Ico) - T_co / (Ici + Ico)
erratum("4.15", rate(printed_w0), printed_4_16a, "first row must be Ici/(Ici+Ico), Ico/(Ici+Ico) to give (4.16a)")
check("4.16", printed_4_16a, rate((Ici * w_ci + Ico * w_co) / (Ici + Ico)))
check("4.16", T_ci / Ici + T_co / Ico - (1 / Ici + 1 / Ico) * T_c, rate(difference))

# %% [markdown]
# ## Energy argument, (4.21) to (4.25)
# With H = x'x/2 the friction power is -x'K22 T. Two equal clutches as in (4.71) have a positive
# definite K22, yet the claimed sign fails; with the kinetic energy as H it never does.

# %%
order_three = sp.symbols("x1:4", real=True)
x_general, T_general = sp.Matrix(order_three), sp.Matrix(sp.symbols("Tfr1:3", real=True))
A_general = sp.Matrix(3, 3, sp.symbols("a:3:3"))
K_general = sp.Matrix(3, 2, sp.symbols("k1:4(1:3)"))
energy = (x_general.T * x_general)[0] / 2
motion = A_general * x_general - K_general * T_general  # without input
check(
    "4.21",
    (x_general.T * A_general * x_general - x_general.T * K_general * T_general)[0],
    (sp.Matrix([energy]).jacobian(x_general) * motion)[0],
)
check(
    "4.22",
    -(x_general[0:2, 0].T * K_general[0:2, :] * T_general)[0] - (x_general[2:, 0].T * K_general[2:, :] * T_general)[0],
    -(x_general.T * K_general * T_general)[0],
)
K22 = sp.Matrix([[sp.Rational(3, 2), -sp.Rational(1, 2)], [-sp.Rational(1, 2), sp.Rational(3, 2)]])
x_example, T_example = sp.Matrix([sp.Rational(1, 10), 1]), sp.Matrix([10, 1])
power_printed = -(x_example.T * K22 * T_example)[0]
if not (K22.is_positive_definite and power_printed > 0):
    raise AssertionError("counterexample lost")
print("(4.25): K22 positive definite, friction opposes motion, dH/dt =", power_printed)
erratum("4.25", sp.sign(power_printed), -1, "K22 > 0 does not make x'K22 diag(t) x positive")
check("4.25 kinetic energy", -(x_example.T * T_example)[0], (x_example.T * K22.inv() * (-K22 * T_example))[0])

# %% [markdown]
# ## Sector borders, (4.36) to (4.61)
# X, Y are the abscissa a1'x + b1'u and the ordinate a2'x + b2'u.

# %%
k11, k12, k21, k22, m1, m2 = sp.symbols("k11 k12 k21 k22 m1 m2", positive=True)
X, Y, t1, t2 = sp.symbols("X Y t1 t2", real=True)
det = k11 * k22 - k12 * k21
dx1, dx2 = X - k11 * t1 - k12 * t2, Y - k21 * t1 - k22 * t2
both = sp.solve([dx1, dx2], [t1, t2], dict=True)[0]


def border(condition, unknown):
    """Solve a border for X or Y."""
    return sp.solve(condition, unknown)[0]


for sign in (1, -1):
    check("4.36", k22 / k12 * X - sign * det * m1 / k12, border(both[t1] - sign * m1, Y))
    check("4.37", k21 / k11 * X + sign * det * m2 / k11, border(both[t2] - sign * m2, Y))
t1_free = {sign: sp.solve(dx1.subs(t2, sign * m2), t1)[0] for sign in (1, -1)}
t2_free = {sign: sp.solve(dx2.subs(t1, sign * m1), t2)[0] for sign in (1, -1)}
check("4.40", (X - k12 * m2) / k11, t1_free[1])
check("4.46", (X + k12 * m2) / k11, t1_free[-1])
check("4.52", (Y - k21 * m1) / k22, t2_free[1])
check("4.58", (Y + k21 * m1) / k22, t2_free[-1])
for sign in (1, -1):
    check("4.42", sign * k11 * m1 + k12 * m2, border(t1_free[1] - sign * m1, X))
    check("4.48", sign * k11 * m1 - k12 * m2, border(t1_free[-1] - sign * m1, X))
    check("4.54", sign * k22 * m2 + k21 * m1, border(t2_free[1] - sign * m2, Y))
    check("4.60", sign * k22 * m2 - k21 * m1, border(t2_free[-1] - sign * m2, Y))
check("4.43", k21 / k11 * X + det * m2 / k11, border(dx2.subs({t2: m2, t1: t1_free[1]}), Y))
check("4.49", k21 / k11 * X - det * m2 / k11, border(dx2.subs({t2: -m2, t1: t1_free[-1]}), Y))
derived_4_55 = border(dx1.subs({t1: m1, t2: t2_free[1]}), Y)
derived_4_61 = border(dx1.subs({t1: -m1, t2: t2_free[-1]}), Y)
erratum("4.55", k22 / k12 * X + det * m1 / k12, derived_4_55, "sign of the last term; it is minus")
erratum("4.61", k22 / k12 * X - det * m1 / k12, derived_4_61, "sign of the last term; it is plus")
check("4.55 corrected", k22 / k12 * X - det * m1 / k12, derived_4_55)
check("4.61 corrected", k22 / k12 * X + det * m1 / k12, derived_4_61)
check("4.66", k11 * m1 + k12 * m2, border(dx1.subs({t1: m1, t2: m2}), X))
check("4.67", k22 * m2 + k21 * m1, border(dx2.subs({t1: m1, t2: m2}), Y))
check("4.32", [(k22 * X - k12 * Y) / det, (k11 * Y - k21 * X) / det], [both[t1], both[t2]])

# %% [markdown]
# Corner test without any algebra: at the corner K22 (m1, m2) of Figure 4.4 the border of sector 4
# meets the parallelogram. The printed (4.55) passes the opposite side.

# %%
corner = K22 * sp.Matrix([1, 1])
at_corner = {k11: K22[0, 0], k12: K22[0, 1], k21: K22[1, 0], k22: K22[1, 1], m1: 1, m2: 1, X: corner[0]}
print(
    "(4.55) at the corner: printed",
    (k22 / k12 * X + det * m1 / k12).subs(at_corner),
    "corrected",
    derived_4_55.subs(at_corner),
    "corner",
    corner[1],
)

# %% [markdown]
# Number of cases with three friction elements: each sticks or slides.

# %%
cases = list(itertools.product((False, True), repeat=3))
at_most_two = [k for k in cases if sum(k) <= 2]
erratum("4.68", sp.Integer(9), sp.Integer(len(cases)), "text: nine cases, there are 2^3 = 8")
erratum("4.68", sp.Integer(8), sp.Integer(len(at_most_two)), "text: eight with at most two at rest, there are 7")

# %% [markdown]
# ## Two clutches, (4.69), (4.71), and the transmission (4.75)

# %%
Ic1i, Ic1o, Ic2i, Ic2o = sp.symbols("Ic1i Ic1o Ic2i Ic2o", positive=True)
T1, T2, Tc1, Tc2 = sp.symbols("T1 T2 Tc1 Tc2", real=True)
d1, d2, d3 = (T1 - Tc1) / Ic1i, (Tc1 - Tc2) / (Ic1o + Ic2i), (T2 + Tc2) / Ic2o
check("4.71a", T1 / Ic1i - (1 / Ic1i + 1 / (Ic1o + Ic2i)) * Tc1 + Tc2 / (Ic1o + Ic2i), d1 - d2)
erratum(
    "4.71",
    -T2 / Ic2o + Tc1 / (Ic1o + Ic2i) - (1 / (Ic1i + Ic2o) + 1 / Ic2o) * Tc2,
    d2 - d3,
    "(4.71b): 1/(Ic1i + Ic2o) must be 1/(Ic1o + Ic2i)",
)
check("4.71b corrected", -T2 / Ic2o + Tc1 / (Ic1o + Ic2i) - (1 / (Ic1o + Ic2i) + 1 / Ic2o) * Tc2, d2 - d3)
Igbi, Igbo, igb1, igb2 = sp.symbols("Igbi Igbo igb1 igb2", positive=True)
T_in, T_out = sp.symbols("T_in T_out", real=True)
d_in, d_out = (T_in - Tc1 - Tc2) / Igbi, (igb1 * Tc1 + igb2 * Tc2 - T_out) / Igbo
printed_4_75 = [
    T_in / Igbi + r * T_out / Igbo - Tc1 * (1 / Igbi + r * igb1 / Igbo) - Tc2 * (1 / Igbi + r * igb2 / Igbo)
    for r in (igb1, igb2)
]
check("4.75", printed_4_75, [d_in - igb1 * d_out, d_in - igb2 * d_out])

# %% [markdown]
# ## Closed loop of Section 5.7, (5.101) to (5.115)

# %%
s = sp.symbols("s")
Im1, Im2, c, igb, kp1, ki1, kp2, ki2, d_des, g_w, g_T, kff = sp.symbols(
    "Im1 Im2 c igb kp1 ki1 kp2 ki2 d_des gamma_w gamma_T kff", positive=True
)
w1, w2, dphi, lam_w, lam_T, r_w, r_T, v1 = sp.symbols("w1 w2 dphi lam_w lam_T r_w r_T v1", real=True)
Ta1, Ta2 = sp.symbols("Ta1 Ta2", real=True)
plant = sp.Matrix([-c * dphi / Im1 + Ta1 / Im1, igb * c * dphi / Im2 + Ta2 / Im2, w1 - igb * w2])
check("5.101", sp.Matrix([[0, 0, -c / Im1], [0, 0, igb * c / Im2], [1, -igb, 0]]), plant.jacobian([w1, w2, dphi]))
v2 = kp2 * (r_w - w2) + lam_w
speed_law = v2 - g_w * igb * c * dphi
x1 = [w1, w2, dphi, lam_w]
loop1 = sp.Matrix([*plant.subs(Ta2, speed_law), ki2 * (r_w - w2)])
A1 = loop1.jacobian(x1)
check(
    "5.104",
    sp.Matrix(
        [[0, 0, -c / Im1, 0], [0, -kp2 / Im2, (1 - g_w) * igb * c / Im2, 1 / Im2], [1, -igb, 0, 0], [0, -ki2, 0, 0]]
    ),
    A1,
)
check("5.104", sp.Matrix([[1 / Im1, 0], [0, kp2 / Im2], [0, 0], [0, ki2]]), loop1.jacobian([Ta1, r_w]))
printed_5_105 = (
    s**4
    + kp2 / Im2 * s**3
    + (ki2 / Im2 + c / Im1 + (1 - g_w) * igb**2 * c / Im2) * s**2
    + c * kp2 / (Im1 * Im2) * s
    + c * ki2 / (Im1 * Im2)
)
check("5.105", printed_5_105, A1.charpoly(s).as_expr())
check("5.106", (s**2 + c / Im1) * (s**2 + kp2 / Im2 * s + ki2 / Im2), printed_5_105.subs(g_w, 1))
_, b3, b2, b1, b0 = sp.Poly(printed_5_105.subs(g_w, 0), s).all_coeffs()
check("5.105 Hurwitz", c**2 * igb**2 * kp2**2 / (Im1 * Im2**3), sp.expand(b3 * b2 * b1 - b1**2 - b3**2 * b0))

# %% [markdown]
# (5.107) uses v2/Im2, (5.108) has the entry that results from d(omega_2)/dt as in (5.62).

# %%
printed_A_tilde = sp.Matrix(
    [
        [
            -d_des / Im1,
            igb * d_des / Im1 - g_T * igb * kp2 / Im2,
            g_T * (1 - g_w) * igb**2 * c / Im2 - c / Im1,
            g_T * igb / Im2,
        ],
        [0, -kp2 / Im2, (1 - g_w) * igb * c / Im2, 1 / Im2],
        [1, -igb, 0, 0],
        [0, -ki2, 0, 0],
    ]
)
law_printed = v1 - d_des * (w1 - igb * w2) + g_T * igb * Im1 * v2 / Im2
law_acceleration = v1 - d_des * (w1 - igb * w2) + g_T * igb * Im1 * loop1[1]
from_printed = loop1.subs(Ta1, law_printed).jacobian(x1)
from_acceleration = loop1.subs(Ta1, law_acceleration).jacobian(x1)
erratum(
    "5.107", from_printed, printed_A_tilde, "with v2/Im2 the matrix (5.108) does not result; it needs d(omega_2)/dt"
)
check("5.108", printed_A_tilde, from_acceleration)
factored = (s**2 + d_des / Im1 * s + c / Im1) * (s**2 + kp2 / Im2 * s + ki2 / Im2)
check("5.109", factored, printed_A_tilde.subs(g_w, 1).charpoly(s).as_expr())
check("5.109", factored, printed_A_tilde.subs(g_T, 1).charpoly(s).as_expr())
erratum(
    "5.109",
    factored,
    from_printed.subs({g_T: 1, g_w: 0}).charpoly(s).as_expr(),
    "with the law (5.107) as printed, gamma_T = 1 alone does not factorise",
)
check("5.110", kp2**2 / (4 * Im2), sp.solve(sp.discriminant(s**2 + kp2 / Im2 * s + ki2 / Im2, s), ki2)[0])

# %%
x2 = [*x1, lam_T]
torque_law = kff * r_T + kp1 * (r_T - c * dphi) + lam_T
loop2 = sp.Matrix([*loop1.subs(Ta1, law_acceleration).subs(v1, torque_law), ki1 * (r_T - c * dphi)])
A2 = loop2.jacobian(x2)
printed_A2 = sp.Matrix(
    [
        [
            -d_des / Im1,
            igb * d_des / Im1 - g_T * igb * kp2 / Im2,
            g_T * (1 - g_w) * igb**2 * c / Im2 - c / Im1 - kp1 * c / Im1,
            g_T * igb / Im2,
            1 / Im1,
        ],
        [0, -kp2 / Im2, (1 - g_w) * igb * c / Im2, 1 / Im2, 0],
        [1, -igb, 0, 0, 0],
        [0, -ki2, 0, 0, 0],
        [0, 0, -ki1 * c, 0, 0],
    ]
)
check("5.113", printed_A2, A2)
check(
    "5.113",
    sp.Matrix([[(kff + kp1) / Im1, g_T * igb * kp2 / Im2], [0, kp2 / Im2], [0, 0], [0, ki2], [ki1, 0]]),
    loop2.jacobian([r_T, r_w]),
)
cubic = s**3 + d_des / Im1 * s**2 + (c / Im1 + kp1 * c / Im1) * s + ki1 * c / Im1
for active in ({g_w: 1}, {g_T: 1}):
    check("5.114", cubic * (s**2 + kp2 / Im2 * s + ki2 / Im2), printed_A2.subs(active).charpoly(s).as_expr())
p2, p1, p0 = sp.Poly(cubic, s).all_coeffs()[1:]
check("5.115", d_des / Im1 * (1 + kp1), sp.solve(p2 * p1 - p0, ki1)[0])

# %%
summary()

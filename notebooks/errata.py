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
# # Further errata: Chapter 4
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

# %%
summary()

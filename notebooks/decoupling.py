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
# # Input-output decoupling: Section 5.4
#
# Lie derivatives, relative degrees and decoupling matrices are computed by general functions; the
# printed laws are compared with what these functions give. The closed loops are then formed from
# the plant and the *printed* laws, and their transfer functions compared with the chosen ones.

# %%
import sympy as sp
from checking import check, summary

s, t = sp.symbols("s t")

# %% [markdown]
# ## The general procedure


# %%
def lie(field, function, x):
    """Lie derivative (5.25) of a scalar function along a vector field."""
    return sp.expand((sp.Matrix([function]).jacobian(x) * field)[0])


def decouple(a, b, outputs, x):
    """Relative degrees, chains of Lie derivatives, c~ of (5.28) and D of (5.29)."""
    degrees, chains, top, rows = [], [], [], []
    for c in outputs:
        chain = [c]
        while all(lie(b[:, k], chain[-1], x) == 0 for k in range(b.cols)):
            if len(chain) > len(x):
                raise ValueError(f"output {c} is not affected by any input")
            chain.append(lie(a, chain[-1], x))
        degrees.append(len(chain))
        chains.append(chain)
        rows.append([lie(b[:, k], chain[-1], x) for k in range(b.cols)])
        top.append(lie(a, chain[-1], x))
    return degrees, chains, sp.Matrix(top), sp.Matrix(rows)


def law(a, b, outputs, x, coefficients, gains, v):
    """Control law (5.34); coefficients[i] lists a_i0, a_i1, ..."""
    _, chains, top, D = decouple(a, b, outputs, x)
    bracket = sp.Matrix(
        [
            top[i] + sum(k * y for k, y in zip(coefficients[i], chains[i], strict=True)) - gains[i] * v[i]
            for i in range(len(outputs))
        ]
    )
    return (-D.LUsolve(bracket)).applyfunc(sp.cancel)


def transfer(a, b, outputs, x):
    """Transfer matrix of a linear system dx/dt = a(x) + b u, y = outputs(x)."""
    A, C = a.jacobian(x), sp.Matrix(outputs).jacobian(x)
    return (C * (s * sp.eye(len(x)) - A).LUsolve(b)).applyfunc(sp.cancel)


# %% [markdown]
# ## (5.24) to (5.41) on a non-linear example
# Order 4, two inputs, relative degrees 2 and 1, so one internal state. The derivatives are taken in
# time, with the chain rule of undefined functions, and only then compared with Lie derivatives.

# %%
x = sp.Matrix(sp.symbols("x1:5", real=True))
x1, x2, x3, x4 = x
u = sp.Matrix(sp.symbols("u1:3", real=True))
v = sp.Matrix(sp.symbols("v1:3", real=True))
a = sp.Matrix([x2, -(x1**3) + x3 * x4, -x3 + x1**2, -x4 + x2 * x3])
b = sp.Matrix([[0, 0], [1 + x3**2, x1], [0, 1 + x4**2], [x2, 0]])
outputs = [x1, x3]
trajectory = [sp.Function(f"x{k}")(t) for k in range(1, 5)]
motion = a + b * u


def time_derivative(expression):
    """Derivative along the solutions, through explicit functions of time."""
    to_time = dict(zip(x, trajectory, strict=True))
    slope = sp.diff(expression.subs(to_time), t)
    slope = slope.subs({sp.diff(f, t): m.subs(to_time) for f, m in zip(trajectory, motion, strict=True)})
    return sp.expand(slope.subs({f: symbol for f, symbol in zip(trajectory, x, strict=True)}))


degrees, chains, c_top, D = decouple(a, b, outputs, x)
y1_1 = time_derivative(x1)
y1_2 = time_derivative(y1_1)
y2_1 = time_derivative(x3)
check("5.24", [lie(a, x1, x), lie(b[:, 0], x1, x), lie(b[:, 1], x1, x)], [y1_1, 0, 0])
check("5.24", lie(a, lie(a, x1, x), x) + sum(lie(b[:, k], lie(a, x1, x), x) * u[k] for k in range(2)), y1_2)
check("5.26", [c_top[0] + (D * u)[0], c_top[1] + (D * u)[1]], [y1_2, y2_1])
check("5.27", c_top + D * u, sp.Matrix([y1_2, y2_1]))
check("5.28", c_top, sp.Matrix([y1_2, y2_1]).subs({u[0]: 0, u[1]: 0}))
check("5.29", D, sp.Matrix([y1_2, y2_1]).jacobian(u))
w = sp.Matrix(sp.symbols("w1:3"))
u_of_w = -D.inv() * (c_top - w)
insert = dict(zip(u, u_of_w, strict=True))
check("5.30", w, sp.Matrix([y1_2, y2_1]).subs(insert))
check("5.31", u_of_w, D.LUsolve(w - c_top))

a10, a11, a20, V1, V2 = sp.symbols("a10 a11 a20 V1 V2", positive=True)
u_law = law(a, b, outputs, x, [[a10, a11], [a20]], [V1, V2], v)
closed = dict(zip(u, u_law, strict=True))
check("5.32", [-a11 * y1_1 - a10 * x1 + V1 * v[0], -a20 * x3 + V2 * v[1]], (c_top + D * u_law).applyfunc(sp.cancel))
check("5.33", [y1_2.subs(closed) + a11 * y1_1 + a10 * x1, y2_1.subs(closed) + a20 * x3], [V1 * v[0], V2 * v[1]])
printed_5_34 = -D.inv() * sp.Matrix(
    [lie(a, lie(a, x1, x), x) + a11 * lie(a, x1, x) + a10 * x1 - V1 * v[0], lie(a, x3, x) + a20 * x3 - V2 * v[1]]
)
check("5.34", printed_5_34, D.LUsolve(sp.Matrix([-a11 * y1_1 - a10 * x1 + V1 * v[0], -a20 * x3 + V2 * v[1]]) - c_top))
check("5.35", sp.Matrix(degrees), sp.Matrix([2, 1]))
check("5.36", sum(degrees), 3)

# %% [markdown]
# Byrnes-Isidori form with eta = x4: the inverse exists, and in z the plant and the closed loop have
# the stated structure.

# %%
z = sp.Matrix(sp.symbols("xi1 xi2 xi3 eta"))
transformation = sp.Matrix([chains[0][0], chains[0][1], chains[1][0], x4])
check("5.37", transformation.jacobian(x).det() ** 2, 1)
inverse = sp.solve(list(transformation - z), list(x), dict=True)[0]
check("5.38", transformation.subs(inverse), z)
plant_z = sp.Matrix([time_derivative(e) for e in transformation]).subs(inverse)
phi_functions = (c_top + D * u).subs(inverse)
q_function = (a[3] + (b[3, :] * u)[0]).subs(inverse)
check("5.39", sp.Matrix([z[1], phi_functions[0], phi_functions[1], q_function]), plant_z)
closed_z = plant_z.subs({k: e.subs(inverse) for k, e in closed.items()}).applyfunc(sp.cancel)
check("5.40", closed_z[0:3, 0], sp.Matrix([z[1], -a10 * z[0] - a11 * z[1] + V1 * v[0], -a20 * z[2] + V2 * v[1]]))
q_closed = q_function.subs({k: e.subs(inverse) for k, e in closed.items()})
check("5.41", q_closed, closed_z[3])

# %% [markdown]
# ## Two machines, (5.42) to (5.62)
# The ratio may change in time, so its rate enters as a known signal. The stiffness is kept constant,
# as the source does (see docs/errata.md).

# %%
Im1, Im2, c, igb = sp.symbols("Im1 Im2 c igb", positive=True)
igb_rate = sp.symbols("igb_rate", real=True)
w1, w2, dphi, phi1, phi2 = sp.symbols("w1 w2 Delta_phi phi1 phi2", real=True)
T1, T2, u1, u2 = sp.symbols("T1 T2 v1 v2", real=True)
potential = c * (phi1 - igb * phi2) ** 2 / 2
newton = [(T1 - sp.diff(potential, phi1)) / Im1, (T2 - sp.diff(potential, phi2)) / Im2]
x_two = sp.Matrix([w1, w2, dphi])
dw1 = -c * dphi / Im1 + T1 / Im1
dw2 = igb * c * dphi / Im2 + T2 / Im2
ddphi = w1 - igb * w2
check("5.44", [e.subs(dphi, phi1 - igb * phi2) for e in (dw1, dw2)], newton)
check("5.44", ddphi, sp.diff(phi1 - igb * phi2, phi1) * w1 + sp.diff(phi1 - igb * phi2, phi2) * w2)

rate = {w1: dw1, w2: dw2, dphi: ddphi, igb: igb_rate}


def along(expression):
    """Time derivative along (5.44) with a ratio that changes in time."""
    return sp.expand(sum(sp.diff(expression, symbol) * slope for symbol, slope in rate.items()))


y1, y2 = c * dphi, w2
check("5.45", c * w1 - c * igb * w2, along(y1))
printed_5_46 = -(c**2) * (1 / Im1 + igb**2 / Im2) * dphi + c * T1 / Im1 - igb * c * T2 / Im2 - c * w2 * igb_rate
check("5.46", printed_5_46, along(along(y1)))
check("5.47", igb * c * dphi / Im2 + T2 / Im2, along(y2))

a_two = sp.Matrix([dw1, dw2, ddphi]).subs({T1: 0, T2: 0})
b_two = sp.Matrix([dw1, dw2, ddphi]).jacobian([T1, T2])
degrees_two, _, top_two, D_two = decouple(a_two, b_two, [y1, y2], x_two)
printed_D = sp.Matrix([[c / Im1, -igb * c / Im2], [0, 1 / Im2]])
check("5.48", printed_D, D_two)
check("5.48 relative degrees", sp.Matrix(degrees_two), sp.Matrix([2, 1]))
check("5.48 regular", D_two.det(), c / (Im1 * Im2))

# %% [markdown]
# Laws. The first one makes the speed an integrator, the second follows from (5.54) with the second
# derivative of y1 from above.

# %%
law2 = sp.solve(sp.Eq(along(y2), u2 / Im2), T2)[0]
check("5.50", u2 / Im2, along(y2).subs(T2, law2))
check("5.51", u2 - igb * c * dphi, law2)
Tf2 = Im2 * dw2 - T2
check("5.52", u2, sp.solve(sp.Eq(T2, u2 - sp.Symbol("Tf2")), u2)[0].subs(sp.Symbol("Tf2"), Tf2).subs(T2, law2))

A0, A1, V = sp.symbols("a0 a1 V", positive=True)
printed_G1 = V / (s**2 + A1 * s + A0)
time_signal, input_signal = sp.symbols("Y1 V1")
check(
    "5.54",
    s**2 * time_signal + A1 * s * time_signal + A0 * time_signal - V * input_signal,
    (time_signal / printed_G1 - input_signal) * V,
)
law1 = sp.solve(sp.Eq(along(along(y1)).subs(T2, law2) + A1 * along(y1) + A0 * y1, V * u1), T1)[0]
printed_5_55 = (
    (c - A0 * Im1) * dphi - A1 * Im1 * (w1 - igb * w2) + Im1 * igb * u2 / Im2 + Im1 * w2 * igb_rate + V * Im1 / c * u1
)
check("5.55", printed_5_55, law1)
natural = {A0: c / Im1, V: c / Im1}
printed_5_56 = u1 + Im1 * (igb * u2 / Im2 + w2 * igb_rate) - A1 * Im1 * (w1 - igb * w2)
check("5.56", printed_5_56, law1.subs(natural))
check("5.56 no twist", sp.diff(law1.subs(natural), dphi), 0)
check("5.57", c / (Im1 * s**2 + A1 * Im1 * s + c), printed_G1.subs(natural))
d_des = sp.symbols("d_des", positive=True)
printed_5_58 = c / (Im1 * s**2 + d_des * s + c)
check("5.58", printed_5_58, printed_G1.subs(natural).subs(A1, d_des / Im1))
check("5.59", -c * dphi / Im1 + T1 / Im1 - igb * u2 / Im2 - w2 * igb_rate, along(along(dphi)).subs(T2, law2))
T1_virtual = sp.symbols("T1_virtual")
printed_5_60 = T1_virtual + Im1 * igb * u2 / Im2 + Im1 * w2 * igb_rate
twist_decoupled = along(along(dphi)).subs(T2, law2).subs(T1, printed_5_60)
check("5.60", [sp.diff(twist_decoupled, k) for k in (u2, w2, igb_rate)], [0, 0, 0])
check("5.61", -c * dphi / Im1 + T1_virtual / Im1, twist_decoupled)
rate_of_input = igb_rate * w2 + igb * dw2
printed_5_62 = (u1 + Im1 * rate_of_input - d_des * (w1 - igb * w2)).subs(T2, law2)
check("5.62", printed_5_62, law1.subs(natural).subs(A1, d_des / Im1))

# %% [markdown]
# The general law (5.34) gives the same two laws, and the closed loop is diagonal.

# %%
general_two = law(a_two, b_two, [y1, y2], x_two, [[c / Im1, d_des / Im1], [0]], [c / Im1, 1 / Im2], [u1, u2])
check("5.62", printed_5_62.subs(igb_rate, 0), general_two[0])
check("5.51", u2 - igb * c * dphi, general_two[1])
closed_two = (a_two + b_two * sp.Matrix([printed_5_62.subs(igb_rate, 0), u2 - igb * c * dphi])).applyfunc(sp.expand)
G_two = transfer(closed_two.subs({u1: 0, u2: 0}), closed_two.jacobian([u1, u2]), [y1, y2], x_two)
check("5.58", G_two[0, :], sp.Matrix([[printed_5_58, 0]]))
check("5.49", G_two[1, :], sp.Matrix([[0, 1 / (Im2 * s)]]))
check("5.53", G_two[0, 0], (printed_G1.subs(natural)).subs(A1, d_des / Im1))

# %% [markdown]
# ## Three machines with adapter gearboxes, (5.63) to (5.78)

# %%
I1, I2, I3, Im3, id_p, igb2 = sp.symbols("I1 I2 I3 Im3 id_p igb2", positive=True)
Igb2, Igb3 = sp.symbols("Igb2 Igb3", positive=True)
w3, T3, u3, T_dsl, phi3 = sp.symbols("w3 T3 v3 T_dsl phi3", real=True)
x_three = sp.Matrix([w1, w2, w3, dphi])
printed_5_63 = sp.Matrix(
    [
        -c * dphi / I1 + T1 / I1,
        id_p * c * dphi / (2 * I2) - T_dsl / (2 * I2) + T2 / I2,
        id_p * c * dphi / (2 * I3) + T_dsl / (2 * I3) + T3 / I3,
        w1 - id_p * w2 / 2 - id_p * w3 / 2,
    ]
)
twist_three = phi1 - id_p * (phi2 + phi3) / 2
energy_three = c * twist_three**2 / 2
friction_power = T_dsl * (w2 - w3) / 2
newton_three = [
    (T1 - sp.diff(energy_three, phi1)) / I1,
    (T2 - sp.diff(energy_three, phi2) - sp.diff(friction_power, w2)) / I2,
    (T3 - sp.diff(energy_three, phi3) - sp.diff(friction_power, w3)) / I3,
]
check("5.63", printed_5_63[0:3, 0].subs(dphi, twist_three), newton_three)
check("5.63", printed_5_63[3], sum(sp.diff(twist_three, p) * k for p, k in ((phi1, w1), (phi2, w2), (phi3, w3))))

# %% [markdown]
# Total output torque: what shafts 2 and 3 carry on the high-speed side, times the gearbox ratio.

# %%
T_do1p, T_do2p = I2 * printed_5_63[1] - T2, I3 * printed_5_63[2] - T3
T_sum = igb2 * id_p * c * dphi
check("5.64", T_sum, igb2 * (T_do1p + T_do2p))
rate3 = dict(zip(x_three, printed_5_63, strict=True))


def along3(expression):
    """Time derivative along (5.63)."""
    return sp.expand(sum(sp.diff(expression, symbol) * slope for symbol, slope in rate3.items()))


check("5.66", igb2 * id_p * c * (w1 - id_p * (w2 + w3) / 2), along3(T_sum))
check(
    "5.67", igb2 * id_p * c * (printed_5_63[0] - id_p * (printed_5_63[1] + printed_5_63[2]) / 2), along3(along3(T_sum))
)
check("5.68", (T2 + id_p / 2 * c * dphi - T_dsl / 2) / I2, along3(w2))
inputs3 = [T1, T2, T3]
a_three = printed_5_63.subs({k: 0 for k in inputs3})
b_three = printed_5_63.jacobian(inputs3)
outputs3 = [T_sum, w2, w3]
degrees_three, chains_three, top_three, D_three = decouple(a_three, b_three, outputs3, x_three)
k = igb2 * id_p * c
check(
    "5.69", sp.Matrix([[k / I1, -k * id_p / (2 * I2), -k * id_p / (2 * I3)], [0, 1 / I2, 0], [0, 0, 1 / I3]]), D_three
)
check("5.69 relative degrees", sp.Matrix(degrees_three), sp.Matrix([2, 1, 1]))
check("5.69 regular", D_three.det(), k / (I1 * I2 * I3))

# %%
law_2 = sp.solve(sp.Eq(along3(w2), u2 / Im2), T2)[0]
law_3 = sp.solve(sp.Eq(along3(w3), u3 / Im3), T3)[0]
total = {I2: Im2 + Igb2, I3: Im3 + Igb3}
check("5.72", u2 + Igb2 / Im2 * u2 - (id_p / 2 * c * dphi - T_dsl / 2), law_2.subs(total))
check("5.73", u3 + Igb3 / Im3 * u3 - (id_p / 2 * c * dphi + T_dsl / 2), law_3.subs(total))

# %% [markdown]
# (5.74), (5.75): insert the measured torque (5.13) and solve for the machine torque. The law that
# results is the one above, so friction and twist have dropped out.

# %%
Tf2_measured = Im2 / I2 * id_p / 2 * c * dphi - Im2 / I2 * T_dsl / 2 - Igb2 / I2 * T2
Tf3_measured = Im3 / I3 * id_p / 2 * c * dphi + Im3 / I3 * T_dsl / 2 - Igb3 / I3 * T3
check("5.74", sp.solve(sp.Eq(T2, u2 - Tf2_measured.subs(total)), T2)[0], law_2.subs(total))
check("5.75", sp.solve(sp.Eq(T3, u3 - Tf3_measured.subs(total)), T3)[0], law_3.subs(total))

# %%
printed_5_76 = c / (I1 * s**2 + d_des * s + c)
dw2_s, dw3_s = sp.symbols("dw2 dw3")
second = igb2 * id_p * c * (printed_5_63[0] - id_p * (dw2_s + dw3_s) / 2)
demanded = sp.Eq(I1 * second + d_des * along3(T_sum) + c * T_sum, c * u1)
law_1 = sp.solve(demanded, T1)[0]
printed_5_77 = u1 / (igb2 * id_p) - d_des * (w1 - id_p * (w2 + w3) / 2) + I1 * id_p / 2 * (dw2_s + dw3_s)
check("5.77", printed_5_77, law_1)
printed_5_78 = u1 / (igb2 * id_p) - d_des * (w1 - id_p * (w2 + w3) / 2) + I1 * id_p / 2 * (u2 / Im2 + u3 / Im3)
check("5.78", printed_5_78, law_1.subs({dw2_s: u2 / Im2, dw3_s: u3 / Im3}))
general_three = law(
    a_three, b_three, outputs3, x_three, [[c / I1, d_des / I1], [0], [0]], [c / I1, 1 / Im2, 1 / Im3], [u1, u2, u3]
)
check("5.78", printed_5_78, general_three[0])
check("5.72", (u2 + Igb2 / Im2 * u2 - (id_p / 2 * c * dphi - T_dsl / 2)), general_three[1].subs(total))
check("5.73", (u3 + Igb3 / Im3 * u3 - (id_p / 2 * c * dphi + T_dsl / 2)), general_three[2].subs(total))

# %% [markdown]
# Closed loop with the printed laws (5.74), (5.75), (5.78). The friction torque is a disturbance:
# neither the total torque nor a speed depends on it.

# %%
printed_laws = sp.Matrix([printed_5_78, law_2, law_3])
closed_three = (a_three + b_three * printed_laws).applyfunc(sp.expand)
check("5.74", closed_three.jacobian([T_dsl]), sp.zeros(4, 1))
G_three = transfer(closed_three.subs({u1: 0, u2: 0, u3: 0}), closed_three.jacobian([u1, u2, u3]), outputs3, x_three)
check("5.76", G_three[0, :], sp.Matrix([[printed_5_76, 0, 0]]))
check("5.70", G_three[1, :], sp.Matrix([[0, 1 / (Im2 * s), 0]]))
check("5.71", G_three[2, :], sp.Matrix([[0, 0, 1 / (Im3 * s)]]))

# %% [markdown]
# ## The damping parameter, (5.79) to (5.81)

# %%
root = sp.sqrt(c / I1 - (d_des / (2 * I1)) ** 2)
denominator = sp.denom(sp.cancel(printed_5_76))
poles = [-d_des / (2 * I1) + sp.I * root, -d_des / (2 * I1) - sp.I * root]
check("5.79", [sp.expand(denominator.subs(s, p)) for p in poles], [0, 0])
check("5.79", sum(poles), -sp.Poly(denominator, s).all_coeffs()[1] / sp.Poly(denominator, s).all_coeffs()[0])
zeta, omega0 = sp.symbols("zeta omega0", positive=True)
standard = sp.Poly(s**2 + 2 * zeta * omega0 * s + omega0**2, s).all_coeffs()
monic = sp.Poly(denominator / I1, s).all_coeffs()
solution = sp.solve([p - q for p, q in zip(standard[1:], monic[1:], strict=True)], [zeta, omega0], dict=True)[0]
check("5.81", d_des / (2 * sp.sqrt(c * I1)), solution[zeta])
check("5.81 critical", root.subs(d_des, 2 * sp.sqrt(c * I1)), 0)

# %% [markdown]
# # The same from ptgen's general procedures
# `decouple` gets a reduced model and the roles of the machines, nothing else. Its law is a share of each
# virtual input and of each sensor.

# %%
from beds import bed, machine, rates, rename, shipped, table, with_definitions
from ptgen.control.lie import affine_system, derivatives


def law_of(design, names, machine_name):
    """A machine's law with ptgen's symbols replaced."""
    return rename(design.law_expressions()[machine_name], names)


# %% [markdown]
# ## Two machines, (5.48) to (5.62)
# The shaft is on the side of M1, so its stiffness does not depend on the ratio, as the source assumes.

# %%
two = bed(
    ["M1 - shaft1 - gearbox1 - flange2 - M2"],
    machine("M1"),
    machine("M2"),
    table("shaft1", "shaft", stiffness="30 kN m/rad"),
    table("gearbox1", "gearbox", ratio=2, inertia="0.02 kg m^2"),
    table("flange2", "torque_flange", inertia="0.01 kg m^2", stiffness="400 kN m/rad"),
    torque={"M1": "shaft1"},
    speed=["M2"],
    reduction='rigid = ["flange2"]\ndrop = ["gearbox1", "flange2"]',
)
design_two = two.design.decoupling
Tf2_sensor = sp.symbols("Tf2")
two_names = {
    "M1_inertia_estimate": Im1,
    "M1_inertia": Im1,
    "M2_inertia": Im2,
    "shaft1_stiffness": c,
    "gearbox1_ratio": igb,
    "M1_damping": d_des,
    "v_M1": u1,
    "v_M2": u2,
    "M1_speed": w1,
    "M2_speed": w2,
    "flange2_torque": Tf2_sensor,
}
two_names = with_definitions(two_names, design_two.definitions)
check("5.48", printed_D, rename(design_two.matrix, two_names))
check("5.48 relative degrees", sp.Matrix([2, 1]), sp.Matrix(design_two.relative_degrees))
if design_two.internal_order != 0:
    raise AssertionError("the bed with two machines has no internal dynamics")
check("5.52", u2 - Tf2_sensor, law_of(design_two, two_names, "M2"))
printed_natural = u1 + Im1 * igb * u2 / Im2 - d_des * (w1 - igb * w2)
check("5.62 constant ratio", printed_natural, law_of(design_two, two_names, "M1"))

# %% [markdown]
# With a ratio that changes in time, the derivatives (5.46) get the rate of the parameter, and the law
# follows from them by the same division by the decoupling matrix. The term with d(igb)/dt of (5.62) comes
# out. The general `decouple` holds ratios constant; a gear shift needs this additional term.

# %%
ratio_symbol = next(p.symbol for p in two.reduced.model.parameters if p.symbol.name == "gearbox1_ratio")
forms_two = [
    design_two.model.without_acceleration(design_two.model.signals["shaft1"]),
    design_two.model.signals["M2_speed"],
]
chains_two = [
    derivatives(design_two.system, name, form, {ratio_symbol: igb_rate})
    for name, form in zip(design_two.outputs, forms_two, strict=True)
]
state_two, input_two = sp.Matrix([w1, w2, dphi]), sp.Matrix([T1, T2])


def derivative_of(chain):
    """The delta-th derivative of an output over states and inputs."""
    return ((rename(chain.rows[-1], two_names) * state_two) + rename(chain.input_row, two_names) * input_two)[0]


check("5.42", c * dphi, (rename(chains_two[0].rows[0], two_names) * state_two)[0])
check("5.43", w2, (rename(chains_two[1].rows[0], two_names) * state_two)[0])
check("5.45", c * w1 - c * igb * w2, (rename(chains_two[0].rows[1], two_names) * state_two)[0])
check("5.46", printed_5_46, derivative_of(chains_two[0]))
check("5.47", igb * c * dphi / Im2 + T2 / Im2, derivative_of(chains_two[1]))
wanted_two = [-c / Im1 * c * dphi - d_des / Im1 * (c * w1 - c * igb * w2) + c / Im1 * u1, u2 / Im2]
laws_two = sp.solve([derivative_of(chain) - want for chain, want in zip(chains_two, wanted_two, strict=True)], [T1, T2])
check("5.62", printed_5_62, laws_two[T1])
check("5.51", u2 - igb * c * dphi, laws_two[T2])

# %% [markdown]
# ## Three machines with adapter gearboxes, (5.69) to (5.78), (5.98)
# The shipped bed; the stiffness (5.10) is ptgen's own. The inertia of M1 includes its gearbox (I1).

# %%
geared = shipped("differential-gearboxes")
design = geared.design.decoupling
i_d, igb1, rho = sp.symbols("i_d igb1 rho", positive=True)
Tf2_s, Tf3_s = sp.symbols("Tf2 Tf3")
three_names = {
    "M1_inertia_estimate": I1,
    "M2_inertia": Im2,
    "M3_inertia": Im3,
    "gearbox2_inertia": Igb2,
    "gearbox3_inertia": Igb3,
    "gearbox1_ratio": igb1,
    "gearbox2_ratio": igb2,
    "gearbox3_ratio": igb2,
    "diff_ratio": i_d,
    "diff_pinion_ratio": rho,
    "M1_damping": d_des,
    "v_M1": u1,
    "v_M2": u2,
    "v_M3": u3,
    "M1_speed": w1,
    "M2_speed": w2,
    "M3_speed": w3,
    "flange2_torque": Tf2_s,
    "flange3_torque": Tf3_s,
}
shaft_symbols = sp.symbols("cs1 cs2", positive=True)
three_names |= {
    "cardan1_stiffness": shaft_symbols[0],
    "cardan2_stiffness": shaft_symbols[1],
    "cardan3_stiffness": shaft_symbols[1],
}
three_names = with_definitions(three_names, design.definitions)
prime = {id_p: i_d * igb1 / igb2}
c_geared = rename(geared.reduced.model.stiffness[0, 0], three_names)
to_geared = total | prime | {c: c_geared}
printed_5_69 = sp.Matrix([[k / I1, -k * id_p / (2 * I2), -k * id_p / (2 * I3)], [0, 1 / I2, 0], [0, 0, 1 / I3]])
check("5.69", printed_5_69.subs(to_geared), rename(design.matrix, three_names))
check("5.69 relative degrees", sp.Matrix([2, 1, 1]), sp.Matrix(design.relative_degrees))
if design.internal_order != 0:
    raise AssertionError("the bed with three machines has no internal dynamics")
check("5.74", u2 - Tf2_s, law_of(design, three_names, "M2"))
check("5.75", u3 - Tf3_s, law_of(design, three_names, "M3"))
check("5.78", printed_5_78.subs(prime), law_of(design, three_names, "M1"))
measured = sp.Matrix([sp.Symbol(name) for name in design.sensors])
virtual = sp.Matrix([u1, u2, u3])
estimate = (
    rename(design.law.estimate_sensors * measured, three_names)
    + rename(design.law.estimate_virtual, three_names) * virtual
)[0]
check("5.98 without losses", igb2 * (Tf2_s + Igb2 / Im2 * u2 + Tf3_s + Igb3 / Im3 * u3), estimate)
check("5.95", igb2 * (Tf2_s + Tf3_s), rename(design.law.estimate_sensors * measured, three_names)[0])
check("5.76 natural stiffness", c_geared, rename(design.stiffness[0], three_names))

# %% [markdown]
# The closed loop of the reduced model with the law in states, (5.70), (5.71), (5.76): no cross terms, and
# nothing of the slip-limiting torque.

# %%
U_v, U_x, U_T = design.state_law.v, design.state_law.x, design.state_law.T
closed = rename(design.system.A + design.system.B * U_x, three_names).applyfunc(sp.cancel)
driven = rename(design.system.B * U_v, three_names).applyfunc(sp.cancel)
seen = [design.model.without_acceleration(design.model.signals[name]) for name in design.outputs]
output_rows = rename(sp.Matrix.vstack(*[sp.Matrix.hstack(form.z, form.e) for form in seen]), three_names)
G_ptgen = (output_rows * (s * sp.eye(4) - closed).LUsolve(driven)).applyfunc(sp.cancel)
check("5.76", G_ptgen[0, :], sp.Matrix([[printed_5_76.subs(c, c_geared), 0, 0]]))
check("5.70", G_ptgen[1, :], sp.Matrix([[0, 1 / (Im2 * s), 0]]))
check("5.71", G_ptgen[2, :], sp.Matrix([[0, 0, 1 / (Im3 * s)]]))
check("5.74", rename(design.system.F + design.system.B * U_T, three_names).applyfunc(sp.cancel), sp.zeros(4, 1))

# %% [markdown]
# The damping (5.81) for a damping ratio of one, as a number: 2 sqrt(c I) with the tuned inertia.

# %%
gains = geared.design.gains
by_hand = 2 * float(sp.sqrt(gains.stiffness["M1"] * gains.inertia_estimate["M1"]))
print("d =", gains.damping["M1"], "N m s/rad, 2 sqrt(c I) =", by_hand)
if abs(gains.damping["M1"] / by_hand - 1) > 1e-5:
    raise AssertionError("(5.81)")

# %% [markdown]
# The direct bed, (7.16), (7.17), (7.20): the same without gearboxes, the torque reference at the input of the
# differential, the torque flanges rigid as in the source. The law in states first, then from sensors.

# %%
direct_bed = shipped("differential", '\n[reduction]\nrigid = ["flange1", "flange2", "flange3"]\n')
direct = direct_bed.design.decoupling
bed_names = {name: value for name, value in three_names.items() if "equivalent" not in name}
direct_names = with_definitions(bed_names | {"M1_inertia_estimate": Im1, "M1_inertia": Im1}, direct.definitions)
c_direct = rename(direct_bed.reduced.model.stiffness[0, 0], direct_names)
T_dsl_sensor = sp.symbols("T_dsl", real=True)
direct_states = [w1, w2, w3, dphi]
at_outputs = [i_d / 2 * c_direct * dphi - T_dsl_sensor / 2, i_d / 2 * c_direct * dphi + T_dsl_sensor / 2]
spread = w1 - i_d * (w2 + w3) / 2
printed_7_16 = [(T1 - c_direct * dphi) / Im1, (at_outputs[0] + T2) / Im2, (at_outputs[1] + T3) / Im3]
check("7.16", printed_7_16, rates(direct.model, direct_names, [T1, T2, T3], [rho * T_dsl_sensor], direct_states))
check("7.16", spread, (rename(direct.model.twist_rows, direct_names) * sp.Matrix([w1, w2, w3]))[0])
printed_7_17 = [u1 - d_des * spread + Im1 * i_d / 2 * (u2 / Im2 + u3 / Im3), u2 - at_outputs[0], u3 - at_outputs[1]]
U_v, U_x, U_T = (rename(part, direct_names) for part in (direct.state_law.v, direct.state_law.x, direct.state_law.T))
from_states = U_v * sp.Matrix([u1, u2, u3]) + U_x * sp.Matrix(direct_states) + U_T * sp.Matrix([rho * T_dsl_sensor])
check("7.17", printed_7_17, list(from_states))
check(
    "7.17 from sensors",
    [printed_7_17[0], u2 - Tf2_s, u3 - Tf3_s],
    [law_of(direct, direct_names, name) for name in ("M1", "M2", "M3")],
)
printed_7_20 = [
    u1 / Im1 - c_direct * dphi / Im1 - d_des / Im1 * spread + i_d / 2 * (u2 / Im2 + u3 / Im3),
    u2 / Im2,
    u3 / Im3,
    spread,
]
moving = dict(zip([T1, T2, T3], from_states, strict=True))
check(
    "7.20",
    printed_7_20,
    [
        e.subs(moving)
        for e in [*rates(direct.model, direct_names, [T1, T2, T3], [rho * T_dsl_sensor], direct_states), spread]
    ],
)

# %%
summary()

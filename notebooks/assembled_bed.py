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
# # The assembled test bed for differentials: Appendix C and its modes
#
# The bed of Section 3.8: three machines, three torque flanges, three cardan shafts and a bevel
# gear differential. The equations of motion are derived from the kinetic energy, the potential
# energy of the springs, the dissipation of the dampers and the work of the applied torques.

# %%
import numpy as np
import sympy as sp
from checking import check, erratum, show, summary

# %% [markdown]
# ## Coordinates and energies
# The differential enters with its five bodies and the velocities (3.14), (3.19); nothing is taken
# over from the printed equations of Appendix C.

# %%
names = ["m1", "m2", "m3", "f1", "f2", "f3", "di", "3b"]
w = dict(zip(names, sp.symbols("w1 w2 w3 wf1 wf2 wf3 wdi w3b", real=True), strict=True))
q = dict(zip(names, sp.symbols("q1 q2 q3 qf1 qf2 qf3 qdi q3b", real=True), strict=True))
Im1, Im2, Im3, If1, If2, If3 = sp.symbols("Im1 Im2 Im3 If1 If2 If3", positive=True)
I0, I1, I2, I3, Ic = sp.symbols("I0 I1 I2 I3 Ic", positive=True)
r1, r2, r3, i_d, I_d = sp.symbols("r1 r2 r3 i_d I_d", positive=True)
cf1, cf2, cf3, cs1, cs2, cs3 = sp.symbols("cf1 cf2 cf3 cs1 cs2 cs3", positive=True)
df1, df2, df3, ds1, ds2, ds3 = sp.symbols("df1 df2 df3 ds1 ds2 ds3", positive=True)
Tag1, Tag2, Tag3, T_dl, T_dsl = sp.symbols("Tag1 Tag2 Tag3 T_dl T_dsl", real=True)
half = sp.Rational(1, 2)


def output1(x):
    """Motion of the first output shaft."""
    return x["di"] / i_d + r3 / r1 * x["3b"]


def output2(x):
    """Motion of the second output shaft."""
    return x["di"] / i_d - r3 / r2 * x["3b"]


def twists(x):
    """Elongations of the three flanges and the three shafts."""
    return [
        x["m1"] - x["f1"],
        x["f2"] - x["m2"],
        x["f3"] - x["m3"],
        x["f1"] - x["di"],
        output1(x) - x["f2"],
        output2(x) - x["f3"],
    ]


stiffness, damping = [cf1, cf2, cf3, cs1, cs2, cs3], [df1, df2, df3, ds1, ds2, ds3]
potential = half * sum(c * e**2 for c, e in zip(stiffness, twists(q), strict=True))
dissipation = half * sum(d * e**2 for d, e in zip(damping, twists(w), strict=True))
kinetic = half * (
    Im1 * w["m1"] ** 2
    + Im2 * w["m2"] ** 2
    + Im3 * w["m3"] ** 2
    + If1 * w["f1"] ** 2
    + If2 * w["f2"] ** 2
    + If3 * w["f3"] ** 2
    + I0 * w["di"] ** 2
    + I1 * output1(w) ** 2
    + I2 * output2(w) ** 2
    + I3 * w["3b"] ** 2
    + Ic * (w["di"] / i_d) ** 2
)
work_rate = Tag1 * w["m1"] + Tag2 * w["m2"] + Tag3 * w["m3"] - T_dl * w["di"] - T_dsl * w["3b"]

velocities, angles = sp.Matrix([w[n] for n in names]), sp.Matrix([q[n] for n in names])
inertia = sp.hessian(kinetic, list(velocities))
torque = sp.Matrix([sp.diff(work_rate, w[n]) - sp.diff(potential, q[n]) - sp.diff(dissipation, w[n]) for n in names])
total_Id = {Ic: I_d - i_d**2 * I0}

# %% [markdown]
# ## (C.1) to (C.4): machines, flanges, shafts
# The printed torques (C.2), (C.4) are inserted into the printed balances (C.1), (C.3) and these
# are compared with the Lagrange equations. Each torque is also compared alone.

# %%
Tf1 = df1 * (w["m1"] - w["f1"]) + cf1 * (q["m1"] - q["f1"])
Tf2 = df2 * (w["f2"] - w["m2"]) + cf2 * (q["f2"] - q["m2"])
Tf3 = df3 * (w["f3"] - w["m3"]) + cf3 * (q["f3"] - q["m3"])
Ts1 = ds1 * (w["f1"] - w["di"]) + cs1 * (q["f1"] - q["di"])
Ts2 = ds2 * ((w["di"] / i_d + r3 / r1 * w["3b"]) - w["f2"]) + cs2 * ((q["di"] / i_d + r3 / r1 * q["3b"]) - q["f2"])
Ts3 = ds3 * ((w["di"] / i_d - r3 / r2 * w["3b"]) - w["f3"]) + cs3 * ((q["di"] / i_d - r3 / r2 * q["3b"]) - q["f3"])

element_torques = [c * e + d * v for c, d, e, v in zip(stiffness, damping, twists(q), twists(w), strict=True)]
check("C.1", [Tag1 - Tf1, Tag2 + Tf2, Tag3 + Tf3], torque[0:3, 0])
check("C.1", sp.diag(Im1, Im2, Im3), inertia[0:3, 0:3])
check("C.2", [Tf1, Tf2, Tf3], element_torques[:3])
check("C.3", [Tf1 - Ts1, Ts2 - Tf2, Ts3 - Tf3], torque[3:6, 0])
check("C.3", sp.diag(If1, If2, If3), inertia[3:6, 3:6])
check("C.4", [Ts1, Ts2, Ts3], element_torques[3:])

# %% [markdown]
# ## (C.5), (C.6), (C.9): the differential inside the bed

# %%
S1, S2, S3 = sp.symbols("S1 S2 S3", real=True)
differential_inertia = inertia[6:8, 6:8].subs(total_Id).applyfunc(sp.cancel)
generalised = sp.Matrix([S1 - T_dl - S2 / i_d - S3 / i_d, -T_dsl - r3 / r1 * S2 + r3 / r2 * S3])
check("C.5", generalised.subs({S1: Ts1, S2: Ts2, S3: Ts3}), torque[6:8, 0])
differential_acceleration = differential_inertia.LUsolve(generalised)
printed_Dc = (
    I_d * (I1 * r3**2 / r1**2 + I2 * r3**2 / r2**2 + I3) + I1 * I2 * (r3 / r1 + r3 / r2) ** 2 + I1 * I3 + I2 * I3
)
printed_C5 = (
    i_d**2 * (S1 - T_dl) * (I1 * r3**2 / r1**2 + I2 * r3**2 / r2**2 + I3)
    - i_d * T_dsl * (I2 * r3 / r2 - I1 * r3 / r1)
    - i_d * S2 * (I2 * r3**2 / r2**2 + I2 * r3**2 / (r1 * r2) + I3)
    - i_d * S3 * (I1 * r3**2 / r1**2 + I1 * r3**2 / (r1 * r2) + I3)
)
printed_C6 = (
    i_d * (S1 - T_dl) * (I2 * r3 / r2 - I1 * r3 / r1)
    - T_dsl * (I_d + I1 + I2)
    - S2 * (I_d * r3 / r1 + I2 * r3 / r1 + I2 * r3 / r2)
    + S3 * (I_d * r3 / r2 + I1 * r3 / r1 + I1 * r3 / r2)
)
check("C.5", printed_C5 / printed_Dc, differential_acceleration[0])
check("C.6", printed_C6 / printed_Dc, differential_acceleration[1])
check("C.9", printed_Dc, differential_inertia.det() * i_d**2)

# %% [markdown]
# ## (C.10) to (C.14): the symmetric differential

# %%
symmetric = {I2: I1, r2: r1}
sym_acceleration = differential_acceleration.subs(symmetric).applyfunc(sp.cancel)
sym_Dc = printed_Dc.subs(symmetric)
check("C.10", i_d**2 * (2 * I1 * r3**2 / r1**2 + I3) * (S1 - T_dl - S2 / i_d - S3 / i_d) / sym_Dc, sym_acceleration[0])
check("C.11", r3 / r1 * (I_d + 2 * I1) * (-S2 + S3 - r1 / r3 * T_dsl) / sym_Dc, sym_acceleration[1])
numerator_C12 = I_d * (2 * I1 * r3**2 / r1**2 + I3) + 4 * I1**2 * r3**2 / r1**2 + 2 * I1 * I3
printed_Idi = numerator_C12 / (i_d**2 * (2 * I1 * r3**2 / r1**2 + I3))
printed_I3b = numerator_C12 / (I_d * r3 / r1 + 2 * I1 * r3 / r1)
Idi_closed, I3b_closed = (I_d + 2 * I1) / i_d**2, 2 * I1 * r3 / r1 + I3 * r1 / r3
check("C.12", [printed_Idi, printed_I3b], [Idi_closed, I3b_closed])
check("C.12", [printed_Idi, printed_I3b], [1 / sp.diff(sym_acceleration[0], S1), 1 / sp.diff(sym_acceleration[1], S3)])
check("C.13", (S1 - T_dl - S2 / i_d - S3 / i_d) / printed_Idi, sym_acceleration[0])
check("C.14", (-S2 + S3 - r1 / r3 * T_dsl) / printed_I3b, sym_acceleration[1])

# %% [markdown]
# The closed forms say what the two constants are: I_di is the inertia of everything that turns
# with the locked differential, seen from its input. I_3b is not an inertia on omega_3b, which
# would be 2 I1 (r3/r1)^2 + I3, but that inertia times r1/r3.

# %% [markdown]
# ## (C.15) to (C.18): no losses; open and locked differential

# %%
lossless = {T_dl: 0, T_dsl: 0}
check("C.15", (S1 - S2 / i_d - S3 / i_d) / printed_Idi, sym_acceleration[0].subs(lossless))
check("C.16", (-S2 + S3) / printed_I3b, sym_acceleration[1].subs(lossless))

locked = {w["3b"]: 0, q["3b"]: 0}
locked_inertia = sp.cancel(inertia[6, 6].subs(total_Id).subs(symmetric))
check("C.17", (S1 - S2 / i_d - S3 / i_d) / printed_Idi, generalised[0].subs(lossless) / locked_inertia)
check(
    "C.18",
    [
        ds2 * (w["di"] / i_d - w["f2"]) + cs2 * (q["di"] / i_d - q["f2"]),
        ds3 * (w["di"] / i_d - w["f3"]) + cs3 * (q["di"] / i_d - q["f3"]),
    ],
    [element_torques[4].subs(locked), element_torques[5].subs(locked)],
)

# %% [markdown]
# ## The ratio r3/r1 and the constant I_3b
# With chi = (r3/r1) omega_3b the output shafts are omega_di/i_d +- chi and nothing else contains
# the ratio, so the bed is described by I_di and the inertia I_3b r1/r3 of chi. If I_3b is kept,
# as a table entry would be, the dynamics still depend on r3/r1.

# %%
ratio = sp.symbols("rho", positive=True)
I_3b = sp.symbols("I_3b", positive=True)
chi_acceleration = sp.solve(sp.Eq(I_3b * sp.Symbol("a") / ratio, -S2 + S3 - T_dsl / ratio), sp.Symbol("a"))[0]
erratum(
    "C.14",
    sp.diff(chi_acceleration, ratio).subs(T_dsl, 0),
    0,
    "with I_3b given, r3/r1 does act on the dynamics, not only on T_dsl",
)
check(
    "C.14 chi",
    (chi_acceleration.subs(ratio, r3 / r1).subs(I_3b, I3b_closed)).subs(T_dsl, 0),
    (-S2 + S3) / (2 * I1 + I3 * r1**2 / r3**2),
)

# %% [markdown]
# ## Modes with Table C.1
# Undamped, as in Section 3.12. The columns are the eigenfrequencies; chi is used for the open
# differential with I_3b = 0.04 kg m^2 as its inertia (r3/r1 = 1), the only reading that needs no
# further number.

# %%
table_C1 = {
    "Im1": 1.0,
    "Im2": 10.3,
    "Im3": 10.3,
    "If1": 0.032,
    "If2": 0.032,
    "If3": 0.029,
    "Idi": 0.022,
    "I3b": 0.04,
    "id": 1.91,
    "cf1": 380e3,
    "cf2": 220e3,
    "cf3": 220e3,
    "cs1": 57e3,
    "cs2": 57e3,
    "cs3": 57e3,
}


def bed_matrices(values, open_differential, rho=1.0):
    """Inertia and stiffness matrix of the linear bed (N m, rad); the last column is omega_3b."""
    v = values
    rows = np.array(
        [
            [1, 0, 0, -1, 0, 0, 0, 0],
            [0, -1, 0, 0, 1, 0, 0, 0],
            [0, 0, -1, 0, 0, 1, 0, 0],
            [0, 0, 0, 1, 0, 0, -1, 0],
            [0, 0, 0, 0, -1, 0, 1 / v["id"], rho],
            [0, 0, 0, 0, 0, -1, 1 / v["id"], -rho],
        ],
        float,
    )
    c = np.diag([v["cf1"], v["cf2"], v["cf3"], v["cs1"], v["cs2"], v["cs3"]])
    m = np.diag([v["Im1"], v["Im2"], v["Im3"], v["If1"], v["If2"], v["If3"], v["Idi"], v["I3b"] * rho])
    n = 8 if open_differential else 7
    return m[:n, :n], (rows.T @ c @ rows)[:n, :n]


def modes(m, k):
    """Eigenfrequencies (Hz) in ascending order and mode shapes, largest entry 1."""
    root = 1 / np.sqrt(np.diag(m))
    values, vectors = np.linalg.eigh(root[:, None] * k * root[None, :])
    shapes = root[:, None] * vectors
    shapes = shapes / np.array([s[np.argmax(abs(s))] for s in shapes.T])
    return np.sqrt(np.clip(values, 0, None)) / (2 * np.pi), shapes


frequencies_locked, shapes_locked = modes(*bed_matrices(table_C1, open_differential=False))
frequencies_open, shapes_open = modes(*bed_matrices(table_C1, open_differential=True))
labels = ["M1", "M2", "M3", "f1", "f2", "f3", "di", "3b"]
for title, f, shape in (("locked", frequencies_locked, shapes_locked), ("open", frequencies_open, shapes_open)):
    print(f"{title} differential")
    for k, frequency in enumerate(f):
        print(f"  {frequency:8.2f} Hz  " + " ".join(f"{n}={x:+.2f}" for n, x in zip(labels, shape[:, k], strict=False)))

# %% [markdown]
# ### Statements of Section 3.12

# %%


def require(statement, holds):
    """Stop when a statement does not hold, otherwise print it."""
    if not holds:
        raise AssertionError(statement)
    print("holds:", statement)


require(
    "locked: one rigid-body mode, outputs slower by the ratio 1.91",
    frequencies_locked[0] < 1e-3 < frequencies_locked[1]
    and np.allclose(shapes_locked[1, 0] * 1.91, shapes_locked[0, 0]),
)
require(
    "locked: in the first elastic mode M2 and M3 oscillate against each other",
    shapes_locked[1, 1] * shapes_locked[2, 1] < 0 and abs(shapes_locked[0, 1]) < 0.05,
)
require("locked: mode at 21.9 Hz", round(frequencies_locked[2], 1) == 21.9)
require(
    "locked: at 21.9 Hz M1 oscillates against M2 and M3",
    shapes_locked[0, 2] * shapes_locked[1, 2] < 0 and shapes_locked[0, 2] * shapes_locked[2, 2] < 0,
)
require(
    "locked: in the next mode the differential oscillates against the three machines",
    all(shapes_locked[6, 3] * shapes_locked[k, 3] < 0 for k in range(3)),
)
require("open: two rigid-body modes", frequencies_open[1] < 1e-3 < frequencies_open[2])
require(
    "open: the mode of M1 against M2 and M3 is hardly changed",
    abs(frequencies_open[2] / frequencies_locked[2] - 1) < 0.01,
)
new_mode = 3
require(
    "open: a new mode with the two outputs against each other",
    abs(shapes_open[7, new_mode]) == 1.0 and abs(shapes_open[6, new_mode]) < 0.05,
)

# %% [markdown]
# The new mode of the open differential is the one that depends on I_3b r1/r3.

# %%
for rho in (0.5, 1.0, 2.0):
    print(f"r3/r1 = {rho}:", np.round(modes(*bed_matrices(table_C1, True, rho))[0], 2))

# %% [markdown]
# ### Mode shapes

# %%
import matplotlib.pyplot as plt

figure, axes = plt.subplots(7, 2, figsize=(9, 14), sharex=True, layout="constrained")
for column, (title, f, shape) in enumerate(
    (("locked", frequencies_locked, shapes_locked), ("open", frequencies_open, shapes_open))
):
    for row, k in enumerate(range(len(f) - 7, len(f))):
        axes[row, column].bar(labels[: shape.shape[0]], shape[:, k])
        axes[row, column].set_title(f"{title}: {f[k]:.1f} Hz", fontsize=9)
show(figure)

# %% [markdown]
# ## The same from ptgen's general procedures
# The bed of Table C.1 with the differential described by its five bodies. ptgen's coordinates begin with
# the friction velocities; its equations of motion are compared with those from the energies, entry by
# entry: inertia, stiffness and damping matrix, air-gap and friction torques.

# %%
from beds import ROOT, bed, machine, rates, read, rename, shipped, table

bevel_text = (ROOT / "testbeds" / "differential.toml").read_text(encoding="utf-8")
start, end = bevel_text.index("[components.diff]"), bevel_text.index("[components.diff.loss]")
bevel_table = table(
    "diff",
    "bevel_differential",
    ratio=1.91,
    radius_output1="40 mm",
    radius_output2="50 mm",
    radius_pinion="30 mm",
    inertia_drive="0.01 kg m^2",
    inertia_cage="0.02 kg m^2",
    inertia_output1="0.01 kg m^2",
    inertia_output2="0.02 kg m^2",
    inertia_pinion="0.01 kg m^2",
)
bevel_model = read(bevel_text[:start] + bevel_table + bevel_text[end:]).model
coordinate = {
    "m1": "M1.shaft",
    "m2": "M2.shaft",
    "m3": "M3.shaft",
    "f1": "flange1.uut",
    "f2": "flange2.uut",
    "f3": "flange3.uut",
    "di": "diff.input",
    "3b": "diff.pinion",
}
order = [bevel_model.coordinates.index(coordinate[n]) for n in names]
print(bevel_model.coordinates)
bed_names = {
    "M1_inertia": Im1,
    "M2_inertia": Im2,
    "M3_inertia": Im3,
    "flange1_inertia": If1,
    "flange2_inertia": If2,
    "flange3_inertia": If3,
    "flange1_stiffness": cf1,
    "flange2_stiffness": cf2,
    "flange3_stiffness": cf3,
    "cardan1_stiffness": cs1,
    "cardan2_stiffness": cs2,
    "cardan3_stiffness": cs3,
    "flange1_damping": df1,
    "flange2_damping": df2,
    "flange3_damping": df3,
    "cardan1_damping": ds1,
    "cardan2_damping": ds2,
    "cardan3_damping": ds3,
    "diff_loss_viscous": 0,
    "diff_limited_slip_viscous": 0,
}
bevel_names = {
    "diff_ratio": i_d,
    "diff_radius_output1": r1,
    "diff_radius_output2": r2,
    "diff_radius_pinion": r3,
    "diff_inertia_drive": I0,
    "diff_inertia_cage": Ic,
    "diff_inertia_output1": I1,
    "diff_inertia_output2": I2,
    "diff_inertia_pinion": I3,
}


def in_order(matrix, table_of_names):
    """Rows and columns of a matrix over ptgen's coordinates in the order of this notebook."""
    return rename(matrix, table_of_names).extract(order, order)


def compare_bed(numbers, model, table_of_names, kinetic_energy, power, elastic, dissipated):
    """Compare all matrices of a model with those that follow from the energies."""
    E = model.twist_rows
    check(numbers, in_order(model.mass, table_of_names), sp.hessian(kinetic_energy, list(velocities)))
    check(numbers, in_order(E.T * model.stiffness * E, table_of_names), sp.hessian(elastic, list(angles)))
    check(numbers, in_order(E.T * model.damping * E, table_of_names), sp.hessian(dissipated, list(velocities)))
    applied = model.input_rows.T * sp.Matrix([Tag1, Tag2, Tag3]) - model.friction_rows.T * sp.Matrix([T_dl, T_dsl])
    check(numbers, [rename(applied, table_of_names)[k] for k in order], [sp.diff(power, w[n]) for n in names])


compare_bed("C.1-C.9", bevel_model, bed_names | bevel_names, kinetic, work_rate, potential, dissipation)

# %% [markdown]
# The shipped bed has the reduced symmetric differential, (C.10) to (C.14). Its equation of the pinion is
# (C.14) when the inertia on omega_3b is I_3b r3/r1. The component alone gives (C.13), (C.14).

# %%
Idi, I3b, rho = sp.symbols("I_di I_3b rho", positive=True)
symmetric_names = {"diff_ratio": i_d, "diff_inertia": Idi, "diff_inertia_pinion": I3b, "diff_pinion_ratio": rho}
alone = bed(
    ["M1 - diff.input", "diff.output1 - M2", "diff.output2 - M3"],
    machine("M1"),
    machine("M2"),
    machine("M3"),
    table(
        "diff",
        "differential",
        ratio=1.91,
        inertia="0.022 kg m^2",
        inertia_pinion="0.04 kg m^2",
        loss={"coulomb": "1 N m"},
        limited_slip={"coulomb": "1 N m"},
    ),
    torque={"M1": "diff.input"},
    speed=["M2", "M3"],
).model
no_machines = {"M1_inertia": 0, "M2_inertia": 0, "M3_inertia": 0}
of_differential = rates(
    alone, bed_names | symmetric_names | no_machines, [S1, -S2, -S3], [T_dl, T_dsl], [w["di"], w["3b"]]
)
check("C.13", (S1 - T_dl - S2 / i_d - S3 / i_d) / Idi, of_differential[0])
check("C.14", (-S2 + S3 - T_dsl / rho) / I3b, of_differential[1])

differential = shipped("differential")
to_rho = {r3: rho * r1, r2: r1}
shipped_energy = (
    kinetic.subs({I0: 0, I1: 0, I2: 0, I3: 0, Ic: 0}) + half * Idi * w["di"] ** 2 + half * rho * I3b * w["3b"] ** 2
)
compare_bed(
    "C.10-C.14",
    differential.model,
    bed_names | symmetric_names,
    shipped_energy,
    work_rate,
    potential.subs(to_rho),
    dissipation.subs(to_rho),
)

# %% [markdown]
# Modes with Table C.1 from `ptgen.mechanism.modes`, friction elements locked or free.

# %%
from ptgen.mechanism.modes import modes as ptgen_modes

for locked, expected in ((("diff.limited_slip",), frequencies_locked), ((), frequencies_open)):
    found = np.array([mode.frequency_hz for mode in ptgen_modes(differential.model, locked)])
    print("locked" if locked else "open", np.round(found, 2))
    require(
        "ptgen's modes agree to 1e-9",
        np.allclose(found[found > 0], expected[-np.count_nonzero(found) :], rtol=1e-9) and len(found) == len(expected),
    )

# %%
summary()

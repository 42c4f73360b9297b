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
# # Components: machine torque, gearbox and differentials
#
# Every printed formula of Sections 3.2 to 3.6 that follows from something simpler is derived here
# and compared exactly. The tools are the same throughout: velocities that satisfy linear
# constraints, a basis of the null space of these constraints, and the principle of virtual power.

# %%
import sympy as sp
from checking import check, erratum, summary

# %% [markdown]
# ## Air-gap torque under field orientation, (3.1)
# Start from the flux linkages (A.12), (A.13) and the torque (A.17); the rotor flux has only a
# direct component.

# %%
p, L_m, L_S, L_R = sp.symbols("p L_m L_S L_R", positive=True)
Psi_Rd, i_Sd, i_Sq = sp.symbols("Psi_Rd i_Sd i_Sq", real=True)
i_S = i_Sd + sp.I * i_Sq
i_R = (Psi_Rd - L_m * i_S) / L_R
Psi_S = L_S * i_S + L_m * i_R
airgap_torque = sp.Rational(3, 2) * p * sp.im(sp.expand(sp.conjugate(Psi_S) * i_S))
check("3.1", sp.Rational(3, 2) * p * L_m / L_R * Psi_Rd * i_Sq, sp.expand(airgap_torque))

# %% [markdown]
# ## Adapter gearbox, (3.9), (3.10)
# Input and output gear are tied by (3.8). With S the null-space basis of that constraint, the
# reduced inertia is S'MS and the reduced torque S'Q.

# %%
I1, I2, i_gb, T_gbi, T_gbo = sp.symbols("I1 I2 i_gb T_gbi T_gbo", nonzero=True)
gear_inertia, gear_torque = sp.diag(I1, I2), sp.Matrix([T_gbi, -T_gbo])
S_gear = sp.Matrix([[1, -i_gb]]).nullspace()[0]
acceleration_out = (S_gear.T * gear_torque)[0] / (S_gear.T * gear_inertia * S_gear)[0]
S_in = S_gear / S_gear[0]
acceleration_in = (S_in.T * gear_torque)[0] / (S_in.T * gear_inertia * S_in)[0]
check("3.9", (T_gbi - T_gbo / i_gb) / (I1 + I2 / i_gb**2), acceleration_in)
check("3.9", i_gb * acceleration_out, acceleration_in)
check("3.10", (T_gbi * i_gb - T_gbo) / (I1 * i_gb**2 + I2), acceleration_out)

# %% [markdown]
# ## Bevel gear differential
# ### Constraints (3.14) from the velocities of the contact points
# Axis A-B is z, the pinion's axis is x. A tooth contact is the point where both bodies have the
# same velocity; the pinion's angular velocity is the cage's plus its own spin about x.

# %%
r0, r1, r2, r3, r_c = sp.symbols("r0 r1 r2 r3 r_c", positive=True)
w_di, w_do1, w_do2, w_3b, w_c = sp.symbols("omega_di omega_do1 omega_do2 omega_3b omega_c", real=True)
pinion = sp.Matrix([w_3b, 0, w_c])
contact1, contact2 = sp.Matrix([r1, 0, -r3]), sp.Matrix([r2, 0, r3])
check("3.14", [r1 * w_c + r3 * w_3b, r2 * w_c - r3 * w_3b], [pinion.cross(contact1)[1], pinion.cross(contact2)[1]])
check(
    "3.14",
    [r1 * w_do1, r2 * w_do2],
    [sp.Matrix([0, 0, w_do1]).cross(contact1)[1], sp.Matrix([0, 0, w_do2]).cross(contact2)[1]],
)

# %% [markdown]
# ### Free-body equations (3.15)
# Lagrange multipliers: each constraint row is multiplied by its tooth force.

# %%
I0, I3, I_c = sp.symbols("I0 I3 I_c", positive=True)
T_di, T_do1, T_do2, T_dl, T_dsl, F0, F1, F2 = sp.symbols("T_di T_do1 T_do2 T_dl T_dsl F0 F1 F2", real=True)
velocities = sp.Matrix([w_di, w_do1, w_do2, w_3b, w_c])
constraints = sp.Matrix([r0 * w_di - r_c * w_c, r1 * w_do1 - r1 * w_c - r3 * w_3b, r2 * w_do2 - r2 * w_c + r3 * w_3b])
J = constraints.jacobian(velocities)
applied = sp.Matrix([T_di - T_dl, -T_do1, -T_do2, -T_dsl, 0])
free_body = applied + J.T * sp.Matrix([-F0, F1, F2])
printed_3_15 = [
    T_di - T_dl - r0 * F0,
    r1 * F1 - T_do1,
    r2 * F2 - T_do2,
    r3 * F2 - r3 * F1 - T_dsl,
    r_c * F0 - r1 * F1 - r2 * F2,
]
check("3.15", printed_3_15, free_body)

# %% [markdown]
# ### Two degrees of freedom, (3.16) to (3.19)
# The independent velocities are omega_di and omega_3b. The tooth forces do no work and vanish.

# %%
i_d, I_d, D_c = sp.symbols("i_d I_d D_c", positive=True)
S = velocities.subs(sp.solve(list(constraints), [w_do1, w_do2, w_c])).jacobian([w_di, w_3b])
bodies = sp.diag(I0, I1, I2, I3, I_c)
bevel_inertia = (S.T * bodies * S).applyfunc(sp.cancel)
bevel_torque = (S.T * applied).applyfunc(sp.cancel)
bevel_acceleration = bevel_inertia.LUsolve(bevel_torque)
definitions = {i_d: r_c / r0, I_d: I_c + (r_c / r0) ** 2 * I0}

# as printed
printed_D_c = (
    I_d * (I1 * r3**2 / r1**2 + I2 * r3**2 / r2**2 + I3) + I1 * I2 * (r3 / r1 + r3 / r2) ** 2 + I1 * I3 + I2 * I3
)
printed_w_di = (
    i_d**2 * (T_di - T_dl) * (I1 * r3**2 / r1**2 + I2 * r3**2 / r2**2 + I3)
    - i_d * T_dsl * (I2 * r3 / r2 - I1 * r3 / r1)
    - i_d * T_do1 * (I2 * r3**2 / r2**2 + I2 * r3**2 / (r1 * r2) + I3)
    - i_d * T_do2 * (I1 * r3**2 / r1**2 + I1 * r3**2 / (r1 * r2) + I3)
)
printed_w_3b = (
    i_d * (T_di - T_dl) * (I2 * r3 / r2 - I1 * r3 / r1)
    - T_dsl * (I_d + I1 + I2)
    - T_do1 * (I_d * r3 / r1 + I2 * r3 / r1 + I2 * r3 / r2)
    + T_do2 * (I_d * r3 / r2 + I1 * r3 / r1 + I1 * r3 / r2)
)
check("3.16", (printed_w_di / printed_D_c).subs(definitions), bevel_acceleration[0])
check("3.17", (printed_w_3b / printed_D_c).subs(definitions), bevel_acceleration[1])
check("3.18", printed_D_c.subs(definitions), bevel_inertia.det() * (r_c / r0) ** 2)
check(
    "3.19",
    [w_di / i_d + r3 / r1 * w_3b, w_di / i_d - r3 / r2 * w_3b],
    [(S * sp.Matrix([w_di, w_3b]))[k].subs(r0, r_c / i_d) for k in (1, 2)],
)

# %% [markdown]
# Power balance: the rate of the kinetic energy is the power of the torques, with the printed
# accelerations and the inertias of the five bodies.

# %%
state = sp.Matrix([w_di, w_3b])
printed_acceleration = (sp.Matrix([printed_w_di, printed_w_3b]) / printed_D_c).subs(definitions)
outputs = S * state
power = T_di * w_di - T_do1 * outputs[1] - T_do2 * outputs[2] - T_dl * w_di - T_dsl * w_3b
check("3.16", (state.T * bevel_inertia * printed_acceleration)[0], power)

# %% [markdown]
# ### Steady state, (3.20), (3.21), and the speed relation (3.22)

# %%
static = sp.solve(list(bevel_torque.subs(r0, r_c / i_d)), [T_do1, T_do2], dict=True)[0]
gamma1, gamma2, gamma0 = r1 / (r1 + r2), r2 / (r1 + r2), r1 * r2 / (r3 * (r1 + r2))
check(
    "3.20",
    [gamma1 * i_d * (T_di - T_dl) - gamma0 * T_dsl, gamma2 * i_d * (T_di - T_dl) + gamma0 * T_dsl],
    [static[T_do1], static[T_do2]],
)
check("3.21", gamma0, -sp.diff(static[T_do1], T_dsl))
speed = sp.solve(list(constraints.subs(r_c, i_d * r0)), [w_di, w_c, w_3b], dict=True)[0][w_di]
check("3.22", i_d * (gamma1 * w_do1 + gamma2 * w_do2), speed)

# %% [markdown]
# ## Epicyclic differential
# ### Constraints (3.23)
# The axes of sun, ring, carrier and planets are parallel, so the velocity of a tooth contact is
# the carrier's at the planet's centre plus the planet's own. With omega_3p the planet's speed
# *relative to the carrier*, the planet's absolute speed is omega_di + omega_3p.

# %%
r_r, r_s, r_p = sp.symbols("r_r r_s r_p", positive=True)
w_3p = sp.symbols("omega_3p", real=True)
centre = r_s + r_p
tooth_ring = centre * w_di + r_p * (w_di + w_3p)
tooth_sun = centre * w_di - r_p * (w_di + w_3p)
geometry = {r_r: r_s + 2 * r_p}
check("3.23", [(r_r * w_di + r_p * w_3p).subs(geometry), r_s * w_di - r_p * w_3p], [tooth_ring, tooth_sun])

# %% [markdown]
# ### Free-body equations (3.24) and reduction, (3.25) to (3.28)
# The kinetic energy that (3.24) belongs to contains the planets' spin as (1/2) n_p I_p omega_3p^2.

# %%
I_r, I_s, I_p, n_p, F_r, F_s = sp.symbols("I_r I_s I_p n_p F_r F_s", positive=True)
epi_velocities = sp.Matrix([w_di, w_do1, w_do2, w_3p])
epi_constraints = sp.Matrix([r_r * w_do1 - r_r * w_di - r_p * w_3p, r_s * w_do2 - r_s * w_di + r_p * w_3p])
epi_applied = sp.Matrix([T_di - T_dl, -T_do1, -T_do2, -T_dsl])
epi_free_body = epi_applied + epi_constraints.jacobian(epi_velocities).T * n_p * sp.Matrix([F_r, F_s])
printed_3_24 = [
    T_di - T_dl - n_p * r_r * F_r - n_p * r_s * F_s,
    n_p * r_r * F_r - T_do1,
    n_p * r_s * F_s - T_do2,
    n_p * (r_p * F_s - r_p * F_r - T_dsl / n_p),
]
check("3.24", printed_3_24, epi_free_body)

I_pt = n_p * I_p
S_epi = epi_velocities.subs(sp.solve(list(epi_constraints), [w_do1, w_do2])).jacobian([w_di, w_3p])
epi_inertia = (S_epi.T * sp.diag(I_c, I_r, I_s, I_pt) * S_epi).applyfunc(sp.cancel)
epi_torque = (S_epi.T * epi_applied).applyfunc(sp.cancel)
epi_acceleration = epi_inertia.LUsolve(epi_torque)

printed_D_epi = (
    I_c * (I_r * r_p**2 / r_r**2 + I_s * r_p**2 / r_s**2 + I_pt)
    + I_r * I_s * (r_p / r_r + r_p / r_s) ** 2
    + I_r * I_pt
    + I_s * I_pt
)
printed_epi_di = (
    (T_di - T_dl) * (I_r * r_p**2 / r_r**2 + I_s * r_p**2 / r_s**2 + I_pt)
    - T_dsl * (I_r * r_p / r_r + I_s * r_p / r_s)
    - T_do1 * (I_s * r_p**2 / r_s**2 + I_s * r_p**2 / (r_r * r_s) + I_pt)
    - T_do2 * (I_r * r_p**2 / r_r**2 + I_r * r_p**2 / (r_r * r_s) + I_pt)
)
printed_epi_3p = (
    (T_di - T_dl) * (I_s * r_p / r_s - I_r * r_p / r_r)
    - T_dsl * (I_c + I_r + I_s)
    - T_do1 * (I_c * r_p / r_r + I_s * r_p / r_s + I_s * r_p / r_r)
    + T_do2 * (I_c * r_p / r_s + I_r * r_p / r_r + I_r * r_p / r_s)
)
erratum("3.25", printed_epi_di / printed_D_epi, epi_acceleration[0], "sign of I_r r_p/r_r in the factor of T_dsl")
corrected_epi_di = printed_epi_di + T_dsl * 2 * I_r * r_p / r_r
check("3.25 corrected", corrected_epi_di / printed_D_epi, epi_acceleration[0])
check("3.26", printed_epi_3p / printed_D_epi, epi_acceleration[1])
check("3.27", printed_D_epi, epi_inertia.det())
check(
    "3.28", [w_di + r_p / r_r * w_3p, w_di - r_p / r_s * w_3p], [(S_epi * sp.Matrix([w_di, w_3p]))[k] for k in (1, 2)]
)

# %% [markdown]
# The same two findings from another side: the friction matrix is the inverse of the reduced
# inertia, hence symmetric, and the power balance closes only with the corrected sign.

# %%
printed_friction = -sp.Matrix([printed_epi_di, printed_epi_3p]).jacobian([T_dl, T_dsl])
erratum("3.25", printed_friction[0, 1], printed_friction[1, 0], "printed friction matrix is not symmetric")
epi_state = sp.Matrix([w_di, w_3p])
epi_outputs = S_epi * epi_state
epi_power = T_di * w_di - T_do1 * epi_outputs[1] - T_do2 * epi_outputs[2] - T_dl * w_di - T_dsl * w_3p
printed_epi = sp.Matrix([printed_epi_di, printed_epi_3p]) / printed_D_epi
corrected_epi = sp.Matrix([corrected_epi_di, printed_epi_3p]) / printed_D_epi
erratum("3.25", (epi_state.T * epi_inertia * printed_epi)[0], epi_power, "printed form creates power")
check("3.25 corrected", (epi_state.T * epi_inertia * corrected_epi)[0], epi_power)

# %% [markdown]
# With the planets' absolute spin omega_di + omega_3p the kinetic energy has a mixed term that
# (3.24) leaves out; in (3.24a) and (3.24d) the inertia of a planet then acts on both accelerations.

# %%
w = sp.Matrix([w_di, w_3p])
energy_printed = (w.T * epi_inertia * w)[0] / 2
energy_absolute = energy_printed - I_pt * w_3p**2 / 2 + I_pt * (w_di + w_3p) ** 2 / 2 - I_pt * w_di**2 / 2
inertia_absolute = sp.hessian(sp.expand(energy_absolute), list(w))
erratum("3.24", epi_inertia[0, 1], inertia_absolute[0, 1], "coupling inertia n_p I_p of parallel axes is left out")
check("3.24 corrected", epi_inertia + sp.Matrix([[0, I_pt], [I_pt, 0]]), inertia_absolute)

# %% [markdown]
# ### Steady state, (3.29), (3.30), and the speed relation (3.31)

# %%
epi_static = sp.solve(list(epi_torque), [T_do1, T_do2], dict=True)[0]
g1, g2, g0 = r_r / (r_s + r_r), r_s / (r_s + r_r), r_r * r_s / (r_p * (r_r + r_s))
check(
    "3.29", [g1 * (T_di - T_dl) - g0 * T_dsl, g2 * (T_di - T_dl) + g0 * T_dsl], [epi_static[T_do1], epi_static[T_do2]]
)
check("3.30", g0, -sp.diff(epi_static[T_do1], T_dsl))
check("3.31", g1 * w_do1 + g2 * w_do2, sp.solve(list(epi_constraints), [w_di, w_3p], dict=True)[0][w_di])

# %% [markdown]
# ## Common form, (3.32), (3.33)
# Both types: b and k follow from the reduced inertia, c from the null-space basis. The first
# column of b equals the first column of k, and k is the inverse inertia.

# %%
u, T_fr = sp.Matrix([T_di, T_do1, T_do2]), sp.Matrix([T_dl, T_dsl])


def common_form(inertia, torque):
    """Return b and k of (3.32) from the reduced inertia and the reduced torque."""
    inverse = inertia.inv().applyfunc(sp.cancel)
    return (inverse * torque.jacobian(u)).applyfunc(sp.cancel), -(inverse * torque.jacobian(T_fr)).applyfunc(sp.cancel)


bevel_b, bevel_k = common_form(bevel_inertia, bevel_torque)
epi_b, epi_k = common_form(epi_inertia, epi_torque)
check("3.32", printed_acceleration, bevel_b * u - bevel_k * T_fr)
check("3.32", corrected_epi, epi_b * u - epi_k * T_fr)
for b, k in ((bevel_b, bevel_k), (epi_b, epi_k)):
    check("3.32", [k[0, 1], b[0, 0], b[1, 0]], [k[1, 0], k[0, 0], k[1, 0]])
bevel_c, epi_c = S[1:3, :].subs(r0, r_c / i_d), S_epi[1:3, :]
check("3.33", [w_di / i_d + r3 / r1 * w_3b, w_di / i_d - r3 / r2 * w_3b], bevel_c * sp.Matrix([w_di, w_3b]))
check("3.33", [w_di + r_p / r_r * w_3p, w_di - r_p / r_s * w_3p], epi_c * sp.Matrix([w_di, w_3p]))

# %% [markdown]
# ## Planetary gear set of a transmission, (3.47) to (3.50)
# The epicyclic differential without friction and with all torques accelerating.

# %%
T_cp, T_rp, T_sp = sp.symbols("T_cp T_rp T_sp", real=True)
renaming = {T_di: T_cp, T_do1: -T_rp, T_do2: -T_sp, T_dl: 0, T_dsl: 0}
planetary_acceleration = epi_acceleration.subs(renaming)
printed_w_cp = (
    (T_cp + T_rp + T_sp) * I_pt
    + (T_cp + T_rp) * I_s * r_p**2 / r_s**2
    + (T_cp + T_sp) * I_r * r_p**2 / r_r**2
    + T_rp * I_s * r_p**2 / (r_r * r_s)
    + T_sp * I_r * r_p**2 / (r_r * r_s)
) / printed_D_epi
printed_w_pp = (
    T_cp * (I_s * r_p / r_s - I_r * r_p / r_r)
    + T_rp * (I_c * r_p / r_r + I_s * r_p / r_s + I_s * r_p / r_r)
    - T_sp * (I_c * r_p / r_s + I_r * r_p / r_s + I_r * r_p / r_r)
) / printed_D_epi
check("3.47", printed_w_cp, planetary_acceleration[0])
check("3.48", printed_w_pp, planetary_acceleration[1])
check("3.49", printed_D_epi, epi_inertia.det())
check("3.50", [w_di + r_p / r_r * w_3p, w_di - r_p / r_s * w_3p], (S_epi * epi_state)[1:3, :])

# %% [markdown]
# ## The same from ptgen's general procedures
# Each component stands alone between machines. ptgen knows none of the formulas above: a component
# contributes bodies and constraint rows, and the coordinates follow by exact elimination. The inertia
# of the machines is set to zero in the result, so that their air-gap torques are the torques at the
# flanges; at an output the machine drives against the positive direction.

# %%
from beds import bed, machine, rates, rename, table

gearbox_beds = {
    side: bed(
        ["M1 - gearbox1 - M2"],
        machine("M1"),
        machine("M2"),
        table("gearbox1", "gearbox", ratio=3, inertia="2 kg m^2", inertia_side=side),
        torque={"M1": "gearbox1.input"},
        speed=["M2"],
    )
    for side in ("input", "output")
}
I_gb = sp.symbols("I_gb", positive=True)
gear_names = {"M1_inertia": 0, "M2_inertia": 0, "gearbox1_ratio": i_gb, "gearbox1_inertia": I_gb}
for side, gearbox_bed in gearbox_beds.items():
    model = gearbox_bed.model
    print(side, model.coordinates)
    acceleration = rates(model, gear_names, [T_gbi, -T_gbo], [], [0])[0]
    acceleration_gbo = acceleration / i_gb  # the coordinate is the speed of M1, at the input
    check(
        "3.9" if side == "input" else "3.10",
        (T_gbi - T_gbo / i_gb) / I_gb if side == "input" else (i_gb * T_gbi - T_gbo) / I_gb,
        acceleration if side == "input" else acceleration_gbo,
    )

# %% [markdown]
# ## Simplified gearboxes, (3.51) to (3.54)
# A clutch with the velocities of both sides, a gear stage without inertia behind it: by virtual power the clutch torque
# acts on the output with the ratio of the row that gives its slip. The ratios change at run time, so the coordinates are
# the velocities of both sides.

# %%
T_c, T_c1, T_c2, w_gbi, w_gbo = sp.symbols("T_c T_c1 T_c2 omega_gbi omega_gbo", real=True)
i_gb1, i_gb2, I_gbi, I_gbo = sp.symbols("i_gb1 i_gb2 I_gbi I_gbo", positive=True)
inertias = {"inertia_input": "1 kg m^2", "inertia_output": "2 kg m^2", "ratio_range": [2, 6]}
one_clutch, two_clutches = (
    bed(
        ["M1 - gb - M2"],
        machine("M1"),
        machine("M2"),
        table("gb", kind, **inertias, **more),
        torque={},
        speed=["M1", "M2"],
    )
    for kind, more in (
        ("single_clutch_gearbox", {"ratio": 5, "clutch": {"capacity": "1 N m"}}),
        (
            "double_clutch_gearbox",
            {"ratio1": 5, "ratio2": 3, "clutch1": {"capacity": "1 N m"}, "clutch2": {"capacity": "1 N m"}},
        ),
    )
)
clutch_names = {"M1_inertia": 0, "M2_inertia": 0, "gb_inertia_input": I_gbi, "gb_inertia_output": I_gbo}
clutch_names |= {"gb_ratio": i_gb, "gb_ratio1": i_gb1, "gb_ratio2": i_gb2}
assert one_clutch.model.coordinates == two_clutches.model.coordinates == ("M1.shaft", "M2.shaft")
speeds = sp.Matrix([w_gbi, w_gbo])
check(
    "3.51",
    [(T_gbi - T_c) / I_gbi, (i_gb * T_c - T_gbo) / I_gbo],
    rates(one_clutch.model, clutch_names, [T_gbi, -T_gbo], [T_c], [0, 0]),
)
check("3.52", [w_gbi - i_gb * w_gbo], rename(one_clutch.model.friction_rows, clutch_names) * speeds)
check(
    "3.53",
    [(T_gbi - T_c1 - T_c2) / I_gbi, (i_gb1 * T_c1 + i_gb2 * T_c2 - T_gbo) / I_gbo],
    rates(two_clutches.model, clutch_names, [T_gbi, -T_gbo], [T_c1, T_c2], [0, 0]),
)
check(
    "3.54",
    [w_gbi - i_gb1 * w_gbo, w_gbi - i_gb2 * w_gbo],
    rename(two_clutches.model.friction_rows, clutch_names) * speeds,
)

# %% [markdown]
# Bevel differential: the coordinates are those of the friction elements, omega_di and omega_3b.

# %%
three = [machine("M1"), machine("M2"), machine("M3")]
chains_of_three = ["M1 - diff.input", "diff.output1 - M2", "diff.output2 - M3"]
friction = {"loss": {"coulomb": "1 N m"}, "limited_slip": {"coulomb": "1 N m"}}
bevel_bed = bed(
    chains_of_three,
    *three,
    table(
        "diff",
        "bevel_differential",
        ratio=3,
        radius_output1="40 mm",
        radius_output2="50 mm",
        radius_pinion="30 mm",
        inertia_drive="0.1 kg m^2",
        inertia_cage="0.2 kg m^2",
        inertia_output1="0.3 kg m^2",
        inertia_output2="0.4 kg m^2",
        inertia_pinion="0.5 kg m^2",
        **friction,
    ),
    torque={"M1": "diff.input"},
    speed=["M2", "M3"],
)
print(bevel_bed.model.coordinates)
no_machines = {
    "M1_inertia": 0,
    "M2_inertia": 0,
    "M3_inertia": 0,
    "diff_loss_viscous": 0,
    "diff_limited_slip_viscous": 0,
}
bevel_names = no_machines | {
    "diff_ratio": i_d,
    "diff_radius_output1": r1,
    "diff_radius_output2": r2,
    "diff_radius_pinion": r3,
    "diff_inertia_drive": I0,
    "diff_inertia_cage": I_c,
    "diff_inertia_output1": I1,
    "diff_inertia_output2": I2,
    "diff_inertia_pinion": I3,
}
of_bevel = rates(bevel_bed.model, bevel_names, [T_di, -T_do1, -T_do2], [T_dl, T_dsl], [w_di, w_3b])
whole = {I_d: I_c + i_d**2 * I0}
check("3.16", (printed_w_di / printed_D_c).subs(whole), of_bevel[0])
check("3.17", (printed_w_3b / printed_D_c).subs(whole), of_bevel[1])
check("3.18", printed_D_c.subs(whole), rename(bevel_bed.model.mass, bevel_names).det() * i_d**2)
check(
    "3.19",
    [w_di / i_d + r3 / r1 * w_3b, w_di / i_d - r3 / r2 * w_3b],
    [
        (rename(bevel_bed.model.velocity_rows[f"diff.output{k}"], bevel_names) * sp.Matrix([w_di, w_3b]))[0]
        for k in (1, 2)
    ],
)

# %% [markdown]
# Epicyclic differential. ptgen gives the corrected (3.25).

# %%
epicyclic_bed = bed(
    chains_of_three,
    *three,
    table(
        "diff",
        "epicyclic_differential",
        radius_ring="90 mm",
        radius_sun="40 mm",
        planets=3,
        inertia_carrier="0.1 kg m^2",
        inertia_ring="0.2 kg m^2",
        inertia_sun="0.3 kg m^2",
        inertia_planet="0.01 kg m^2",
        **friction,
    ),
    torque={"M1": "diff.input"},
    speed=["M2", "M3"],
)
epi_names = no_machines | {
    "diff_radius_ring": r_s + 2 * r_p,
    "diff_radius_sun": r_s,
    "diff_planets": n_p,
    "diff_inertia_carrier": I_c,
    "diff_inertia_ring": I_r,
    "diff_inertia_sun": I_s,
    "diff_inertia_planet": I_p,
}
of_epicyclic = rates(epicyclic_bed.model, epi_names, [T_di, -T_do1, -T_do2], [T_dl, T_dsl], [w_di, w_3p])
check("3.25 corrected", (corrected_epi_di / printed_D_epi).subs(geometry), of_epicyclic[0])
erratum("3.25", (printed_epi_di / printed_D_epi).subs(geometry), of_epicyclic[0], "ptgen gives the corrected form")
check("3.26", (printed_epi_3p / printed_D_epi).subs(geometry), of_epicyclic[1])
check("3.27", printed_D_epi.subs(geometry), rename(epicyclic_bed.model.mass, epi_names).det())

# %% [markdown]
# The friction rows and the mass matrix give the symmetric friction matrix of (3.32).

# %%
for system_bed, names, k in (
    (bevel_bed, bevel_names, bevel_k.subs({r0: r_c / i_d})),
    (epicyclic_bed, epi_names, epi_k),
):
    G, M = system_bed.model.friction_rows, rename(system_bed.model.mass, names)
    friction_matrix = (G * M.inv() * G.T).applyfunc(sp.cancel)
    check("3.32", k.subs(geometry) if system_bed is epicyclic_bed else k, friction_matrix)

# %% [markdown]
# ## Torque converter, (3.37) to (3.41)
# A fluid that turns twice as fast moves twice the mass per time with twice the velocity: its torques grow with the square
# of the speeds if these keep their ratio. From that law of similarity alone (3.39) follows, with T_pc the torque at the
# reference speed, and a torque ratio that depends on the ratio of the speeds only, (3.38).

# %%
w_p, w_t, w_pc, nu = sp.symbols("omega_p omega_t omega_pc nu", positive=True)
T_1, T_2, T_lc, I_p, I_t = sp.symbols("T_1 T_2 T_lc I_p I_t", positive=True)
pump_shape, turbine_shape = sp.Function("f"), sp.Function("g")


def pump_torque(pump, turbine):
    """Return a torque that is homogeneous of degree two in the speeds."""
    return pump**2 * pump_shape(turbine / pump)


def turbine_torque(pump, turbine):
    """Return another one."""
    return pump**2 * turbine_shape(turbine / pump)


at_reference = pump_torque(w_pc, nu * w_pc)  # T_pc(nu)
mu = turbine_torque(w_pc, nu * w_pc) / at_reference
speed_ratio = {nu: w_t / w_p}
check("3.39", ((w_p / w_pc) ** 2 * at_reference).subs(speed_ratio), pump_torque(w_p, w_t))
check("3.38", (mu * pump_torque(w_p, nu * w_p)).subs(speed_ratio), turbine_torque(w_p, w_t))

# %% [markdown]
# ptgen's converter: at the points of its map, forward with the pump faster, it has (3.37) to (3.39) to the last digit,
# because these points are the constant coefficients of its polynomials. Its two inertias follow (3.40) and (3.41), with
# the torques of the lock-up clutch and of the fluid as they act on the bodies.

# %%
points = {"speed_ratio": [0, 0.5, 0.75, 1], "torque_ratio": [2, 1.5, 1.25, 1], "pump_torque": [160, 144, 96, 0]}
converter_bed = bed(
    ["M1 - tc - M2"],
    machine("M1"),
    machine("M2"),
    table(
        "tc",
        "torque_converter",
        inertia_pump="0.1 kg m^2",
        inertia_turbine="0.2 kg m^2",
        reference_speed="200 rad/s",
        drive=points | {"pump_torque": [f"{torque} N m" for torque in points["pump_torque"]]},
        lockup={"capacity": "1 N m"},
    ),
    torque={"M1": "tc.pump"},
    speed=["M2"],
)
(fluid,) = converter_bed.mechanism.fluids
forward = fluid.sectors[0]
known = [forward.share.index(share) for share in points["speed_ratio"][:-1]]
exact_pump = [sp.Rational(forward.faster[k][0]) for k in known]
exact_turbine = [sp.Rational(forward.slower[k][0]) for k in known]
check(
    "3.37 points of the map", list(map(sp.Rational, points["speed_ratio"])), list(map(sp.Rational, forward.share[1:]))
)
check("3.39 points of the map", points["pump_torque"][:-1], exact_pump)
check(
    "3.38 points of the map",
    list(map(sp.Rational, points["torque_ratio"][:-1])),
    [turbine / pump for turbine, pump in zip(exact_turbine, exact_pump, strict=True)],
)

# %%
T_cp, T_ct = sp.symbols("T_p T_t", positive=True)
model = converter_bed.plant_model
converter_names = {
    "M1_inertia": 0,
    "M2_inertia": 0,
    "tc_lockup_viscous": 0,
    "tc_inertia_pump": I_p,
    "tc_inertia_turbine": I_t,
}
moving = rates(model, converter_names, [T_1, -T_2], [T_lc, T_cp, T_ct], [0] * len(model.coordinates))
of_pump, of_turbine = (
    (rename(model.velocity_rows[f"tc.{side}"], converter_names) * sp.Matrix(moving))[0] for side in ("pump", "turbine")
)
check("3.40", T_1 - T_lc - T_cp, sp.cancel(I_p * of_pump))
check("3.41", T_lc + T_ct - T_2, sp.cancel(I_t * of_turbine))

# %%
summary()

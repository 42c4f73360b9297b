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
# # Speed control, torque control and the closed loop: Sections 5.5 to 5.7
#
# The printed formulas are derived from the plant (5.44) and the controllers by hand, and then compared with what ptgen's
# general procedure gives for a bed of two machines with a transmission: matrices entry by entry, polynomials, conditions.

# %%
import sympy as sp
from beds import bed, machine, rename, shipped, table
from checking import check, erratum, is_zero, summary
from ptgen.analysis.characteristic import characteristic_factors
from ptgen.analysis.continuous_proof import continuous_proof
from ptgen.analysis.stability_conditions import (
    closed_form_ranges,
    hurwitz_determinant,
    real_pole_condition,
    stability_conditions,
)
from ptgen.analysis.symbolic_loop import ACCELERATION_TORQUE, LOAD_COMPENSATION, LoopKind, symbolic_loop
from ptgen.control.decoupling import decouple

s, t = sp.symbols("s t")
Im1, Im2, c, igb, d_des = sp.symbols("Im1 Im2 c igb d_des", positive=True)
kp1, ki1, kp2, ki2, g_w, g_t, kff, b_hat = sp.symbols("kp1 ki1 kp2 ki2 gamma_w gamma_T kff b_hat", real=True)

# %% [markdown]
# The bed of Section 5.7; the shaft is on the side of M1, so that its stiffness does not depend on the ratio.

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
design = two.design.decoupling
NAMES = {
    "M1_inertia_estimate": Im1,
    "M1_inertia": Im1,
    "M2_inertia": Im2,
    "shaft1_stiffness": c,
    "gearbox1_ratio": igb,
    "M1_damping": d_des,
    "M1_feedforward": kff,
    "M1_torque_gain": kp1,
    "M1_torque_integral_gain": ki1,
    "M2_speed_gain": kp2,
    "M2_speed_integral_gain": ki2,
    "M2_observer_bandwidth": b_hat,
    LOAD_COMPENSATION.name: g_w,
    ACCELERATION_TORQUE.name: g_t,
}
open_loop = symbolic_loop(design, torque_loops=False)
closed_loop = symbolic_loop(design)
damping = design.damping[0]


def matrix_of(loop):
    """State matrix in the symbols of this notebook."""
    return rename(loop.A, NAMES)


def polynomial(loop, **position):
    """Characteristic polynomial as the product of the factors that the procedure finds, and their loops."""
    at = {LOAD_COMPENSATION: position.pop("load"), ACCELERATION_TORQUE: position.pop("acceleration")}
    factors = characteristic_factors(loop.at({key: value for key, value in at.items() if value is not None} | position))
    return sp.Mul(*[rename(factor.polynomial(s), NAMES) for factor in factors]), [factor.loops for factor in factors]


# %% [markdown]
# ## Plants of the controllers, (5.82), (5.83), (5.94)
# The law of ptgen around the plant, from each virtual input to its own output; friction and what the law misses act on
# the rotor as one torque.

# %%
law = symbolic_loop(design, torque_loops=False).at({LOAD_COMPENSATION: 1, ACCELERATION_TORQUE: 1})
gains_off = {symbol: 0 for symbol in law.A.free_symbols if symbol.name.startswith("M2_speed_")}
bare = law.at(gains_off)
n = design.system.order
A, virtual = rename(bare.A[:n, :n], NAMES), rename(law.A[:n, n], NAMES)  # the integrator enters as v2 does
omega_2 = ((s * sp.eye(n) - A).LUsolve(virtual))[1]
check("5.82", 1 / (Im2 * s), omega_2)
v2, T_dist, w2 = sp.symbols("v2 T_dist omega2")
rotor = sp.Eq(Im2 * s * w2, v2 - T_dist)
check("5.83", (v2 - T_dist) / (Im2 * s), sp.solve(rotor, w2)[0])
v1_column = rename(law.B[:n, 0], NAMES)
torque = c * ((s * sp.eye(n) - A).LUsolve(v1_column))[2]
check("5.94", c / (Im1 * s**2 + d_des * s + c), torque)
check("5.94 gain one", 1, sp.cancel(torque).subs(s, 0))
d_any = sp.symbols("d_any", real=True)
check(
    "5.94 BIBO stable for positive damping",
    [d_any],
    [k.expression for k in stability_conditions((Im1, d_any, c), [d_any])],
)

# %% [markdown]
# ## PI control (5.84), (5.99), (5.111)
# Each loop of the procedure is ``v = a r - b y + lambda``, ``d lambda/dt = c (r - y)``.

# %%
T_ref, T_sum, w_ref = sp.symbols("T_ref T_sum omega_ref")
by_machine = {loop.machine: loop for loop in closed_loop.loops}


def virtual_input(loop, reference, output):
    """Transform v of a loop."""
    a, b, k = (rename(part, NAMES) for part in (loop.on_reference, loop.on_output, loop.integral))
    return a * reference - b * output + k * (reference - output) / s


pi_speed = kp2 * (w_ref - w2) + ki2 / s * (w_ref - w2)
check("5.84", pi_speed, virtual_input(by_machine["M2"], w_ref, w2))
pi_torque = kff * T_ref + kp1 * (T_ref - T_sum) + ki1 / s * (T_ref - T_sum)
check("5.99", pi_torque, virtual_input(by_machine["M1"], T_ref, T_sum))
check("5.111", kff * T_ref + (kp1 + ki1 / s) * (T_ref - T_sum), virtual_input(by_machine["M1"], T_ref, T_sum))

# %% [markdown]
# ## P control with disturbance observer, (5.85) to (5.93)
# (5.88) follows from the model (5.86a) in the chosen dynamics (5.87). With the plant (5.85) and a constant disturbance
# the error of the estimate decays with the rate b. The auxiliary variable (5.89) does not need the acceleration.

# %%
T_hat, z = sp.symbols("T_hat z", real=True)
omega, command, disturbance, estimate = (sp.Function(name)(t) for name in ("omega", "v", "T_d", "T_e"))
dw, dw_hat = sp.symbols("domega domega_hat", real=True)
derived_5_88 = (Im2 * b_hat * (dw_hat - dw)).subs(dw_hat, (v2 - T_hat) / Im2)
check("5.88", b_hat * (v2 - Im2 * dw - T_hat), derived_5_88)
error_rate = derived_5_88.subs(dw, (v2 - T_dist) / Im2)
check("5.88 error decays", -b_hat * (T_hat - T_dist), error_rate)
z_of_t = b_hat * Im2 * omega + estimate
rate_5_88 = b_hat * (command - Im2 * sp.diff(omega, t) - estimate)
check(
    "5.90",
    -b_hat * z_of_t + b_hat * (command + b_hat * Im2 * omega),
    sp.diff(z_of_t, t).subs(sp.diff(estimate, t), rate_5_88),
)
check("5.91", z - b_hat * Im2 * w2, sp.solve(sp.Eq(z, b_hat * Im2 * w2 + T_hat), T_hat)[0])
p_control = kp2 * (w_ref - w2) + T_hat
check("5.93", kp2 * (w_ref - w2), (v2 - T_dist).subs(v2, p_control).subs(T_hat, T_dist))

# %% [markdown]
# ptgen steps the observer with implicit Euler: exact for a held torque. For small steps it is (5.88).

# %%
h = sp.symbols("h", positive=True)
share = 1 / (1 + h * b_hat)
stepped = share * T_hat + (1 - share) * (v2 - Im2 * dw)
check("5.88 as the limit of small steps", b_hat * (v2 - Im2 * dw - T_hat), sp.limit((stepped - T_hat) / h, h, 0))

# %% [markdown]
# Eliminating the observer: the controller is a PI controller with ``k_p + b I`` and ``b k_p``, whose proportional part acts
# on the reference with ``k_p`` only. So the response to disturbances is *exactly* that of a PI controller with the real
# poles ``-b`` and ``-k_p/I``; a PI controller with real poles (5.110) always has such an observer as its twin. The
# statement of Figure 5.16 ("tuned for similar disturbance rejection, nearly identical") is therefore exact. Figure 5.17:
# the twin has no zero, so it does not overshoot, and stays behind a ramp of slope a by ``I a / k_p``.

# %%
observer_loop = symbolic_loop(design, speed_control=LoopKind.SPEED_OBSERVER)
observer = next(loop for loop in observer_loop.loops if loop.kind is LoopKind.SPEED_OBSERVER)
v_hat = sp.symbols("v_hat")
by_hand = sp.solve(
    [sp.Eq(v_hat, kp2 * (w_ref - w2) + T_hat), sp.Eq(s * T_hat, b_hat * (v_hat - Im2 * s * w2 - T_hat))],
    [v_hat, T_hat],
    dict=True,
)[0]
check("5.92 with (5.88) as a PI controller", by_hand[v_hat], virtual_input(observer, w_ref, w2))
driven = sp.solve(sp.Eq(Im2 * s * w2, by_hand[v_hat] - T_dist), w2)[0]
twin = {kp2: kp2 + b_hat * Im2, ki2: b_hat * kp2}
pi_response = sp.solve(sp.Eq(Im2 * s * w2, pi_speed.subs(twin, simultaneous=True) - T_dist), w2)[0]
check("5.92 same disturbance response", sp.diff(driven, T_dist), sp.diff(pi_response, T_dist))
check("5.93 reference response", kp2 / (Im2 * s + kp2), sp.diff(driven, w_ref))
slope = sp.symbols("slope", positive=True)
behind = sp.limit(sp.cancel(s * (slope / s**2) * (1 - sp.diff(driven, w_ref))), s, 0)
check("5.93 error on a ramp", Im2 * slope / kp2, behind)
check("5.84 no error on a ramp", 0, sp.limit(sp.cancel(s * (slope / s**2) * (1 - sp.diff(pi_response, w_ref))), s, 0))
observed, loops = polynomial(observer_loop, load=1, acceleration=1)
cubic = s**3 + d_des / Im1 * s**2 + (c / Im1 + kp1 * c / Im1) * s + ki1 * c / Im1
check("5.93 poles", cubic * (s + b_hat) * (s + kp2 / Im2), observed)
print("factors of the loop with observer:", loops)

# %% [markdown]
# ## The estimate of the testing torque, (5.96) to (5.98)
# The shipped bed with three machines, loss torques known on the sides of the machines. The acceleration torques of (5.97)
# are those of (5.72), (5.73); with virtual inputs they give (5.98).

# %%
geared = shipped("differential-gearboxes")
losses = decouple(geared.reduced, geared.testbed.roles, "decoupling", ["gearbox2.input", "gearbox3.input"])
igb2, Igb2, Igb3, Im3 = sp.symbols("igb2 Igb2 Igb3 Im3", positive=True)
Tf2, Tf3, Tl2, Tl3, w3, v3 = sp.symbols("Tf2 Tf3 Tl2 Tl3 omega3 v3")
THREE = {
    "M2_inertia": Im2,
    "M3_inertia": Im3,
    "gearbox2_inertia": Igb2,
    "gearbox3_inertia": Igb3,
    "gearbox2_ratio": igb2,
    "gearbox3_ratio": igb2,
}
SENSED = {"flange2_torque": Tf2, "flange3_torque": Tf3, "M2_speed": w2, "M3_speed": w3}
sensors = sp.Matrix([SENSED.get(name, sp.Symbol(name)) for name in losses.sensors])
read = (rename(losses.law.estimate_sensors, THREE) * sensors)[0]
lost = (rename(losses.law.estimate_losses, THREE) * sp.Matrix([Tl2, Tl3]))[0]
virtual = (rename(losses.law.estimate_virtual, THREE) * sp.Matrix([0, v2, v3]))[0]
check("5.96", igb2 * (Tf2 + Tl2 + Tf3 + Tl3), read + lost)
check("5.96 speeds", [w2, w3], [(rename(loss.speed, THREE) * sensors)[0] for loss in losses.law.known_losses])
T_accel2, T_accel3 = Igb2 / Im2 * v2, Igb3 / Im3 * v3  # (5.72), (5.73)
check("5.97", igb2 * (Tf2 + Tl2 + T_accel2 + Tf3 + Tl3 + T_accel3), read + lost + virtual)
check("5.98", igb2 * (Tf2 + Tl2 + Igb2 / Im2 * v2 + Tf3 + Tl3 + Igb3 / Im3 * v3), read + lost + virtual)

# %% [markdown]
# ## Closed loop by hand, (5.101) to (5.115)

# %%
w1, dphi, lam_w, lam_T, r_w, r_T, v1 = sp.symbols("w1 dphi lam_w lam_T r_w r_T v1", real=True)
Ta1, Ta2 = sp.symbols("Ta1 Ta2", real=True)
plant = sp.Matrix([-c * dphi / Im1 + Ta1 / Im1, igb * c * dphi / Im2 + Ta2 / Im2, w1 - igb * w2])
printed_A = sp.Matrix([[0, 0, -c / Im1], [0, 0, igb * c / Im2], [1, -igb, 0]])
check("5.101", printed_A, plant.jacobian([w1, w2, dphi]))
check("5.101", printed_A, rename(design.system.A, NAMES))
check("5.101", sp.Matrix([[1 / Im1, 0], [0, 1 / Im2], [0, 0]]), rename(design.system.B, NAMES))
v2_pi = kp2 * (r_w - w2) + lam_w
speed_law = v2_pi - g_w * igb * c * dphi
x1 = [w1, w2, dphi, lam_w]
loop1 = sp.Matrix([*plant.subs(Ta2, speed_law), ki2 * (r_w - w2)])
A1 = loop1.jacobian(x1)
printed_A1 = sp.Matrix(
    [[0, 0, -c / Im1, 0], [0, -kp2 / Im2, (1 - g_w) * igb * c / Im2, 1 / Im2], [1, -igb, 0, 0], [0, -ki2, 0, 0]]
)
printed_B1 = sp.Matrix([[1 / Im1, 0], [0, kp2 / Im2], [0, 0], [0, ki2]])
check("5.104", printed_A1, A1)
check("5.104", printed_B1, loop1.jacobian([Ta1, r_w]))
undamped = open_loop.at({ACCELERATION_TORQUE: 0, damping: 0})
check("5.104", printed_A1, matrix_of(undamped))
check("5.104", printed_B1, rename(undamped.B, NAMES))
printed_5_105 = (
    s**4
    + kp2 / Im2 * s**3
    + (ki2 / Im2 + c / Im1 + (1 - g_w) * igb**2 * c / Im2) * s**2
    + c * kp2 / (Im1 * Im2) * s
    + c * ki2 / (Im1 * Im2)
)
check("5.105", printed_5_105, A1.charpoly(s).as_expr())
check("5.105", printed_5_105, polynomial(undamped, load=None, acceleration=None)[0])
check("5.106", (s**2 + c / Im1) * (s**2 + kp2 / Im2 * s + ki2 / Im2), printed_5_105.subs(g_w, 1))
check("5.106", printed_5_105.subs(g_w, 1), polynomial(undamped, load=1, acceleration=None)[0])

# %% [markdown]
# Without load compensation (5.105) is a Hurwitz polynomial for positive gains: the general conditions shrink to these two.

# %%
conventional = sp.Poly(printed_5_105.subs(g_w, 0), s).all_coeffs()
check("5.105 Hurwitz", c**2 * igb**2 * kp2**2 / (Im1 * Im2**3), hurwitz_determinant(conventional, 3))
check("5.105 Hurwitz", [kp2, ki2], [k.expression for k in stability_conditions(conventional, (kp2, ki2))])

# %% [markdown]
# (5.107) uses v2/Im2, (5.108) has the entry that results from d(omega_2)/dt as in (5.62): with the torque that the flange
# reads, ``v2 + (1 - gamma_omega) T_f2`` is the whole net torque on the rotor. ptgen uses that net torque, so what the
# acceleration torque does is independent of the load compensation.

# %%
printed_A_tilde = sp.Matrix(
    [
        [
            -d_des / Im1,
            igb * d_des / Im1 - g_t * igb * kp2 / Im2,
            g_t * (1 - g_w) * igb**2 * c / Im2 - c / Im1,
            g_t * igb / Im2,
        ],
        [0, -kp2 / Im2, (1 - g_w) * igb * c / Im2, 1 / Im2],
        [1, -igb, 0, 0],
        [0, -ki2, 0, 0],
    ]
)
law_printed = v1 - d_des * (w1 - igb * w2) + g_t * igb * Im1 * v2_pi / Im2
law_acceleration = v1 - d_des * (w1 - igb * w2) + g_t * igb * Im1 * loop1[1]
net_torque = v2_pi + (1 - g_w) * igb * c * dphi
check("5.107 net torque on the rotor", net_torque / Im2, loop1[1])
from_printed = loop1.subs(Ta1, law_printed).jacobian(x1)
from_acceleration = loop1.subs(Ta1, law_acceleration).jacobian(x1)
erratum(
    "5.107", from_printed, printed_A_tilde, "with v2/Im2 the matrix (5.108) does not result; it needs d(omega_2)/dt"
)
check("5.108", printed_A_tilde, from_acceleration)
check("5.108", printed_A_tilde, matrix_of(open_loop))
check(
    "5.108",
    sp.Matrix([[1 / Im1, g_t * igb * kp2 / Im2], [0, kp2 / Im2], [0, 0], [0, ki2]]),
    rename(open_loop.B, NAMES),
)
factored = (s**2 + d_des / Im1 * s + c / Im1) * (s**2 + kp2 / Im2 * s + ki2 / Im2)
for active in ({g_w: 1}, {g_t: 1}):
    check("5.109", factored, printed_A_tilde.subs(active).charpoly(s).as_expr())
for load, acceleration in ((1, None), (None, 1), (1, 1)):
    found, loops = polynomial(open_loop, load=load, acceleration=acceleration)
    check("5.109", factored, found)
    print("factors:", loops)
check("5.109", factored, from_printed.subs(g_w, 1).charpoly(s).as_expr())
erratum(
    "5.109",
    factored,
    from_printed.subs({g_t: 1, g_w: 0}).charpoly(s).as_expr(),
    "with the law (5.107) as printed, gamma_T = 1 alone does not factorise",
)

# %% [markdown]
# Footnote 7: one measure factorises, both decouple. With load compensation alone the speed reference still moves the
# torque; with the acceleration torque alone the torque reference still moves the speed.

# %%
C_y = sp.Matrix([[0, 0, c, 0], [0, 1, 0, 0]])


def cross_terms(load, acceleration):
    """Transfer functions from the speed reference to the torque, and from v1 to the speed."""
    position = open_loop.at({LOAD_COMPENSATION: load, ACCELERATION_TORQUE: acceleration})
    G = C_y * (s * sp.eye(4) - matrix_of(position)).LUsolve(rename(position.B, NAMES))
    return [int(not is_zero(G[0, 1])), int(not is_zero(G[1, 0]))]


check(
    "5.109 footnote",
    sp.Matrix([[1, 0], [0, 1], [0, 0]]),
    sp.Matrix([cross_terms(*k) for k in ((1, 0), (0, 1), (1, 1))]),
)
quadratic = (sp.Integer(1), kp2 / Im2, ki2 / Im2)
speed_conditions = stability_conditions(quadratic, (kp2, ki2))
check("5.109 conditions", [kp2, ki2], [k.expression for k in speed_conditions])
(real,) = closed_form_ranges((real_pole_condition(quadratic, (kp2, ki2)),), (kp2, ki2), speed_conditions)
check("5.110", kp2**2 / (4 * Im2), real.upper)
check("5.110", kp2**2 / (4 * Im2), sp.solve(sp.discriminant(s**2 + kp2 / Im2 * s + ki2 / Im2, s), ki2)[0])

# %%
x2 = [*x1, lam_T]
torque_law = kff * r_T + kp1 * (r_T - c * dphi) + lam_T
loop2 = sp.Matrix([*loop1.subs(Ta1, law_acceleration).subs(v1, torque_law), ki1 * (r_T - c * dphi)])
printed_A2 = sp.Matrix(
    [
        [
            -d_des / Im1,
            igb * d_des / Im1 - g_t * igb * kp2 / Im2,
            g_t * (1 - g_w) * igb**2 * c / Im2 - c / Im1 - kp1 * c / Im1,
            g_t * igb / Im2,
            1 / Im1,
        ],
        [0, -kp2 / Im2, (1 - g_w) * igb * c / Im2, 1 / Im2, 0],
        [1, -igb, 0, 0, 0],
        [0, -ki2, 0, 0, 0],
        [0, 0, -ki1 * c, 0, 0],
    ]
)
printed_B2 = sp.Matrix([[(kff + kp1) / Im1, g_t * igb * kp2 / Im2], [0, kp2 / Im2], [0, 0], [0, ki2], [ki1, 0]])
check("5.113", printed_A2, loop2.jacobian(x2))
check("5.113", printed_A2, matrix_of(closed_loop))
check("5.113", printed_B2, loop2.jacobian([r_T, r_w]))
check("5.113", printed_B2, rename(closed_loop.B, NAMES))
for active in ({g_w: 1}, {g_t: 1}):
    check("5.114", cubic * (s**2 + kp2 / Im2 * s + ki2 / Im2), printed_A2.subs(active).charpoly(s).as_expr())
for load, acceleration in ((1, None), (None, 1), (1, 1)):
    found, _ = polynomial(closed_loop, load=load, acceleration=acceleration)
    check("5.114", cubic * (s**2 + kp2 / Im2 * s + ki2 / Im2), found)

# %% [markdown]
# (5.115): the conditions of Lienard and Chipart, solved for one gain after the other.

# %%
d_free = sp.symbols("d_free", nonnegative=True)
chosen = (d_free, kp1, ki1)
conditions = stability_conditions([k.subs(d_des, d_free) for k in sp.Poly(cubic, s).all_coeffs()], chosen)
ranges = {item.gain: item for item in closed_form_ranges(conditions, chosen)}
check("5.115", [0, -1, 0], [ranges[gain].lower for gain in chosen])
check("5.115", d_free / Im1 * (1 + kp1), ranges[ki1].upper)
p2, p1, p0 = sp.Poly(cubic, s).all_coeffs()[1:]
check("5.115", d_des / Im1 * (1 + kp1), sp.solve(p2 * p1 - p0, ki1)[0])

# %% [markdown]
# After (5.115) the source says that without damping no stabilising PI torque controller exists. That is so where the
# loops are decoupled: the range above is empty. It is not so for the conventional control, whose speed control damps the
# shaft: the shipped bed of two machines is stable there with an integral gain of its torque control.

# %%
empty = ranges[ki1].upper.subs(d_free, 0)
check("5.115 no damping", 0, empty)
back_to_back = shipped("back-to-back")
proof = continuous_proof(back_to_back.design, back_to_back.reduced)
for setting in proof.settings:
    print(setting.name, "-", setting.verdict.value)
    for proven in setting.factors:
        for gain in proven.gains:
            print("   ", gain.gain, gain.value, "stable in", gain.intervals)
(without,) = proof.setting("conventional").factors
stable_to = next(gain for gain in without.gains if gain.gain.name == "M1_torque_integral_gain").intervals
erratum(
    "5.115",
    sp.Integer(0),
    sp.Float(stable_to[0][1]),
    "text: without damping no integral torque gain is stable; the conventional control has some",
)

# %% [markdown]
# Active damping without decoupling (after (5.110)): "possible", not guaranteed. A bed that is stable with all measures on
# can be unstable with the damping alone.

# %%
swapped = shipped("differential-output-torque")
swapped_proof = continuous_proof(swapped.design, swapped.reduced)
verdicts = {setting.name: setting.verdict.name for setting in swapped_proof.settings}
print(verdicts)
if verdicts["decoupling"] != "STABLE" or verdicts["damping alone"] != "UNSTABLE":
    raise AssertionError("the example of damping alone")

# %%
summary()

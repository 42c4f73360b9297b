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
# # Modular modelling: a rigid shaft, or a very stiff one
#
# The example of Section 3.7.1 of the source, Figures 3.17 to 3.20 and Table 3.2: two bodies and a clutch in between.
# Shaft 2 is flexible. Shaft 1 is rigid in (3.43), (3.44), so that body 1 and the clutch's input disk are one; in
# (3.45), (3.46) it is a stiff spring, so that every component stands alone. For a modelling tool that connects
# signals, the second is the simpler one. ptgen connects flanges, so both are one word of the chain apart, and the rigid
# one has the smaller model.

# %%
import matplotlib.pyplot as plt
import numpy as np
import sympy as sp
from beds import bed, machine, rates, table
from checking import check, show, summary
from runs import run_by_events, run_emitted

from ptgen.block.numpy_evaluator import NumpyBlock
from ptgen.mechanism.modes import modes
from ptgen.report.figures import BLUE, GREEN, INK, LIGHT, ORANGE

# Table 3.2
parts = (
    machine("M1", 1.0),
    machine("M2", 2.0),
    table("clutch", "clutch", capacity="200 N m", inertia_input="0.1 kg m^2", inertia_output="0.1 kg m^2"),
    table("shaft2", "shaft", stiffness="5 kN m/rad", damping="3 N m s/rad"),
)
shaft1 = table("shaft1", "shaft", stiffness="500 kN m/rad", damping="10 N m s/rad")
roles = {"torque": {}, "speed": ["M1", "M2"]}
rigid = bed(["M1 - clutch - shaft2 - M2"], *parts, **roles)
modular = bed(["M1 - shaft1 - clutch - shaft2 - M2"], *parts, shaft1, **roles)

# %% [markdown]
# ## Equations of motion, (3.43) to (3.46)
# ptgen's first coordinate is the slip speed of the clutch. Its accelerations are brought back to those of the bodies
# and compared with the printed ones. Angles enter as twists only.

# %%
I_1, I_2, I_ci, I_co, c_s1, c_s2, d_s1, d_s2 = sp.symbols("I_1 I_2 I_ci I_co c_s1 c_s2 d_s1 d_s2", positive=True)
T_1, T_2, T_c, w_1, w_2, w_ci, w_co, e_1, e_2 = sp.symbols(
    "T_1 T_2 T_c omega_1 omega_2 omega_ci omega_co e_1 e_2", real=True
)
names = {
    "M1_inertia": I_1,
    "M2_inertia": I_2,
    "clutch_inertia_input": I_ci,
    "clutch_inertia_output": I_co,
    "shaft1_stiffness": c_s1,
    "shaft1_damping": d_s1,
    "shaft2_stiffness": c_s2,
    "shaft2_damping": d_s2,
}


def body_rates(model, velocities, twists):
    """Return the accelerations of the named velocities, and the rates of the twists, over the symbols given."""
    S = sp.Matrix.vstack(*[model.velocity_rows[name] for name in velocities])
    z = S.inv() * sp.Matrix(list(velocities.values()))
    found = S * sp.Matrix(rates(model, names, [T_1, T_2], [T_c], [*z, *(twists[name] for name in model.twists)]))
    return list(found), dict(zip(model.twists, model.twist_rows * z, strict=True))


found, turning = body_rates(rigid.model, {"M1.shaft": w_1, "clutch.output": w_co, "M2.shaft": w_2}, {"shaft2": e_2})
T_s2 = d_s2 * (w_co - w_2) + c_s2 * e_2  # (3.44) with e_2 = phi_co - phi_2
check("3.43", [(T_1 - T_c) / (I_1 + I_ci), (T_c - T_s2) / I_co, (T_2 + T_s2) / I_2], found)
check("3.43", w_co - w_2, turning["shaft2"])
check("3.44", T_s2, I_2 * found[2] - T_2)  # what acts on body 2 beside its machine

found, turning = body_rates(
    modular.model,
    {"M1.shaft": w_1, "clutch.input": w_ci, "clutch.output": w_co, "M2.shaft": w_2},
    {"shaft1": e_1, "shaft2": e_2},
)
T_s1 = d_s1 * (w_1 - w_ci) + c_s1 * e_1  # (3.46a)
check("3.45", [(T_1 - T_s1) / I_1, (T_s1 - T_c) / I_ci, (T_c - T_s2) / I_co, (T_2 + T_s2) / I_2], found)
check("3.45", [w_1 - w_ci, w_co - w_2], [turning["shaft1"], turning["shaft2"]])
check("3.46", [T_s1, T_s2], [T_1 - I_1 * found[0], I_2 * found[3] - T_2])

# %% [markdown]
# ## Modes
# While the clutch slips, shaft 1 brings a mode of its own: body 1 against the input disk. Once it is locked, both
# models have the mode of all of body 1's side against body 2, and the modular one has a second one besides. The first
# is hardly shifted.

# %%
print(f"{'':20}{'rigid shaft 1':>26}{'modular':>44}")
table_of_modes = {}
for state, locked in (("slipping", ()), ("locked", ("clutch",))):
    for name, project in (("rigid", rigid), ("modular", modular)):
        found = [mode for mode in modes(project.model, locked) if mode.frequency_hz > 0]
        table_of_modes[state, name] = found
    texts = [
        ", ".join(f"{mode.frequency_hz:.3f} Hz ({mode.damping_ratio:.2%})" for mode in table_of_modes[state, name])
        for name in ("rigid", "modular")
    ]
    print(f"clutch {state:13}{texts[0]:>26}{texts[1]:>44}")
for state in ("slipping", "locked"):
    first, (same, extra) = table_of_modes[state, "rigid"][0], table_of_modes[state, "modular"]
    shift = same.frequency_hz / first.frequency_hz - 1
    decay = 2 * np.pi * extra.frequency_hz * extra.damping_ratio
    print(f"{state}: first mode shifted by {shift:.2e}, the extra one decays with {decay:.0f} 1/s")
    if not (len(table_of_modes[state, "rigid"]) == 1 and abs(shift) < 1e-2 and extra.frequency_hz > 250):
        raise AssertionError("one extra mode, far above the first")

# the same in closed form
values = {I_1: 1.0, I_2: 2.0, I_ci: 0.1, I_co: 0.1, c_s1: 500e3, c_s2: 5e3}
closed = {
    ("slipping", 0): c_s2 * (1 / I_co + 1 / I_2),
    ("slipping", 1): c_s1 * (1 / I_1 + 1 / I_ci),
}
for (state, index), squared in closed.items():
    expected = float(sp.sqrt(squared.subs(values))) / (2 * np.pi)
    check("Figure 3.20 modes", int(abs(table_of_modes[state, "modular"][index].frequency_hz / expected - 1) > 1e-9), 0)

# %% [markdown]
# ## Figure 3.20
# T1 = T2 = 100 N m from 0.2 s to 0.75 s; the clutch gets 200 N m at 0.5 s. Both models by the emitted C with steps of
# 100 us, and by the event-driven reference. The two models differ by less than 1 rpm: in n1 by the mode of shaft 1,
# which every jump of a torque excites, and in both by the shift of the first mode, which adds up over time. In the
# modular model the clutch sticks for 0.3 ms some 20 ms before it locks for good, because the input disk vibrates; the
# rigid one knows nothing of that.

# %%
STEP, DURATION, EVERY = 1e-4, 1.0, 10
BREAKS = (0.2, 0.5, 0.75)


def drive(t):
    """Return T1 and T2 (N m)."""
    return 100.0 if 0.2 <= t < 0.75 else 0.0


def press(t):
    """Return the actuation of the clutch."""
    return 1.0 if t >= 0.5 else 0.0


torques, actuations = {"M1": drive, "M2": drive}, {"clutch": press}
emitted, reference = {}, {}
for name, project in (("rigid", rigid), ("modular", modular)):
    start = np.zeros(len(project.model.coordinates))
    emitted[name] = run_emitted(project, start, torques, actuations, DURATION, STEP)
    times = emitted[name].time[EVERY::EVERY]
    reference[name] = run_by_events(project, start, torques, actuations, BREAKS, times)
    changes = ", ".join(f"{t.before:+d} to {t.after:+d} at {t.time:.6f} s" for t in reference[name].transitions)
    print(f"{name}: clutch {changes}")

RPM = 30 / np.pi
errors = {}
for run, name in ((emitted, "emitted C"), (reference, "events")):
    for body in (1, 2):
        errors[name, body] = RPM * (run["modular"][f"M{body}_speed"] - run["rigid"][f"M{body}_speed"])
        largest = np.max(abs(errors[name, body]))
        print(f"modular minus rigid by {name}: n{body} at most {largest:.4f} rpm")
        if not largest < 1.0:
            raise AssertionError("both models give similar results")
for name in ("rigid", "modular"):
    for body in (1, 2):
        largest = RPM * np.max(abs(emitted[name][f"M{body}_speed"][EVERY::EVERY] - reference[name][f"M{body}_speed"]))
        print(f"emitted C at 100 us against events, {name}: n{body} at most {largest:.1e} rpm")
        if not largest < 0.1:
            raise AssertionError("the emitted plant is to follow the reference")

figure, axes = plt.subplots(3, 1, figsize=(8, 8), sharex=True, layout="constrained")
for body, one, other in ((1, BLUE, ORANGE), (2, INK, GREEN)):
    run = emitted["rigid"]
    axes[0].plot(run.time, RPM * run[f"M{body}_speed"], color=one, label=f"n{body}, shaft 1 rigid")
    run = emitted["modular"]
    axes[0].plot(run.time, RPM * run[f"M{body}_speed"], "--", color=other, label=f"n{body}, modular")
    axes[body].plot(run.time, errors["emitted C", body], color=one, label="emitted C")
    axes[body].plot(
        reference["rigid"].time[::4], errors["events", body][::4], ".", color=other, markersize=3, label="events"
    )
    axes[body].set_ylabel(f"error of n{body} (rpm)")
axes[0].set_ylabel("rotational speed (rpm)")
axes[1].set_ylim(-0.8, 1.0)
zoom = axes[1].inset_axes((0.03, 0.08, 0.4, 0.3))
zoom.plot(emitted["rigid"].time, errors["emitted C", 1], color=BLUE, linewidth=1)
zoom.set(xlim=(0.498, 0.56), ylim=(-0.8, 0.8), yticks=[])
zoom.tick_params(labelsize=7)
axes[1].indicate_inset_zoom(zoom)
for axis in axes:
    axis.legend(frameon=False, loc="upper left", ncols=2)
    for time in BREAKS:
        axis.axvline(time, color=LIGHT, zorder=0)
axes[2].set_xlabel("time (s)")
show(figure)

# %% [markdown]
# ## What the stiff shaft costs
# An explicit method has to follow the mode of the stiff shaft although nobody wants to see it. The emitted plant
# solves the linear part exactly, so that no step is unstable. Friction can be solved as long as torques held over a
# step take velocity away from every element; with one clutch among inertias as here that bounds nothing. What is left
# is accuracy: at 100 us the speeds follow the reference to 0.01 rpm, and they do so with order 2.

# %%
A = modular.model.numeric().state_matrices()[0]
fastest = max(np.linalg.eigvals(A), key=abs)


def stable(growth):
    """Return the longest step (s) for which all powers of the growth factor of the fastest mode stay bounded."""
    inside = [h for h in np.geomspace(1e-6, 1e-2, 4000) if abs(growth(h * fastest)) <= 1]
    return max(inside)


euler = stable(lambda x: 1 + x)
runge_kutta = stable(lambda x: 1 + x + x**2 / 2 + x**3 / 6 + x**4 / 24)
print(
    f"fastest pole {fastest:.0f} 1/s; longest step: Euler {1e6 * euler:.0f} us, Runge-Kutta 4 {1e6 * runge_kutta:.0f} us"
)
evaluator = NumpyBlock(modular.plant)


def definite(h):
    """Tell whether friction can be solved with steps of length h."""
    try:
        evaluator.prepare({**evaluator.defaults(), "sample_time": np.array(h)})
    except ValueError:
        return False
    return True


if not all(definite(h) for h in np.geomspace(1e-5, 1e-2, 60)):
    raise AssertionError("friction can be solved with every step up to 10 ms")
errors_of_steps = {}
for step in (5e-5, 1e-4, 2.5e-4, 5e-4):
    run = run_emitted(modular, np.zeros(4), torques, actuations, DURATION, step)
    every = round(EVERY * STEP / step)
    largest = max(
        np.max(abs(run[f"M{body}_speed"][every::every] - reference["modular"][f"M{body}_speed"])) for body in (1, 2)
    )
    errors_of_steps[step] = largest
    print(f"emitted C at {1e6 * step:4.0f} us: speeds differ from the reference by at most {RPM * largest:.1e} rpm")
if not errors_of_steps[5e-5] < 0.4 * errors_of_steps[1e-4] < 0.4 * 0.1 / RPM:
    raise AssertionError("accurate, and better with shorter steps")

# %%
summary()

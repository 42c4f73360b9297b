"""Hypothesis strategies for beds: chains of any parts, closed by machines, or spread around a differential."""

from __future__ import annotations

from hypothesis import strategies as st
from mechanism.bed_text import DIFFERENTIALS, Bed

_INERTIA = st.floats(0.01, 10).map(lambda value: float(f"{value:.6g}"))
_STIFFNESS = st.floats(1e3, 1e6).map(lambda value: float(f"{value:.6g}"))
_DAMPING = st.floats(0, 50).map(lambda value: float(f"{value:.6g}"))
_RATIO = st.floats(0.2, 8).map(lambda value: float(f"{value:.6g}"))
_SIDE = st.sampled_from(["input", "output"])


@st.composite
def _part(draw: st.DrawFn, bed: Bed, kind: str) -> str:
    name = f"{kind}{len(bed.components)}"
    if kind == "shaft":
        return bed.add(name, kind, stiffness=draw(_STIFFNESS), damping=draw(_DAMPING))
    if kind == "inertia":
        return bed.add(name, kind, inertia=draw(_INERTIA))
    if kind == "torque_flange":
        extra = {"inertia_machine": draw(_INERTIA)} if draw(st.booleans()) else {}
        return bed.add(name, kind, inertia=draw(_INERTIA), stiffness=draw(_STIFFNESS), damping=draw(_DAMPING), **extra)
    sign = draw(st.sampled_from([1, -1]))
    bed.add(name, "gearbox", ratio=sign * draw(_RATIO), inertia=draw(_INERTIA), inertia_side=draw(_SIDE))
    return f"{name}.output" if draw(st.booleans()) else name


_KINDS = st.sampled_from(["shaft", "inertia", "torque_flange", "gearbox"])


@st.composite
def _chain(draw: st.DrawFn, bed: Bed, least: int, most: int) -> list[str]:
    return [draw(_part(bed, kind)) for kind in draw(st.lists(_KINDS, min_size=least, max_size=most))]


@st.composite
def chains(draw: st.DrawFn) -> Bed:
    """Two machines with one to five parts between them; the torque is asked for at the first part."""
    bed = Bed()
    bed.machine("M1", draw(_INERTIA))
    bed.machine("M2", draw(_INERTIA))
    parts = draw(_chain(bed, 1, 5))
    bed.chains = [" - ".join(["M1", *parts, "M2"])]
    first = parts[0].partition(".")[0]
    place = {"gearbox": f"{first}.output", "inertia": f"{first}.left"}.get(str(bed.components[first]["type"]), first)
    bed.torque, bed.speed = {"M1": place}, ["M2"]
    return bed


@st.composite
def trees(draw: st.DrawFn, kinds: tuple[str, ...] = tuple(DIFFERENTIALS)) -> Bed:
    """Three machines around a differential of any kind, with up to two parts and a shaft in each arm."""
    bed = Bed()
    kind = draw(st.sampled_from(kinds))
    fields = dict(DIFFERENTIALS[kind])
    for key in fields:
        if key.startswith("inertia"):
            fields[key] = draw(_INERTIA)
    if "ratio" in fields:
        fields["ratio"] = draw(_RATIO)
    if draw(st.booleans()):
        fields["loss"] = {"coulomb": 2.0, "load": 0.01, "viscous": draw(_DAMPING)}
    fields["limited_slip"] = {"coulomb": 20.0, "load": 0.1, "viscous": draw(_DAMPING)}
    bed.add("diff", kind, **fields)
    for index, flange in enumerate(("input", "output1", "output2"), start=1):
        bed.machine(f"M{index}", draw(_INERTIA))
        arm = [f"M{index}", *draw(_chain(bed, 0, 2)), draw(_part(bed, "shaft")), f"diff.{flange}"]
        bed.chains.append(" - ".join(arm if index == 1 else arm[::-1]))
    bed.torque, bed.speed = {"M1": draw(st.sampled_from(["diff.input", "diff.outputs"]))}, ["M2", "M3"]
    return bed

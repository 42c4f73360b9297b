r"""Simplified gearboxes of Section 3.7.2 from a gear set: the inertias, ratios and clutches that it has in its gears.

A change releases one element and applies another. With the elements locked that both gears share, the gear set has two
degrees of freedom, the velocities of input and output, and the kinetic energy

.. math:: E = \tfrac12 m_{11} \omega_{in}^2 + m_{12}\,\omega_{in} \omega_{out} + \tfrac12 m_{22} \omega_{out}^2.

The element that holds gear :math:`k` slips with :math:`\Delta\omega_k = \alpha_k (\omega_{in} - i_k \omega_{out})`, so
in (3.51)-(3.54) it is a clutch at the input with the :math:`|\alpha_k|`-fold torque. The inertia of the gear set at the
output in gear :math:`k` is :math:`J_k = i_k^2 m_{11} + 2 i_k m_{12} + m_{22}`, that of the models is
:math:`i_k^2 I_{gbi} + I_{gbo}`. Both are equal in both gears with

.. math:: I_{gbi} = m_{11} + \frac{2 m_{12}}{i_1 + i_2}, \qquad I_{gbo} = m_{22} + \frac{2 m_{12} i_1 i_2}{i_1 + i_2}.

For all other velocities the energies of gear set and model differ by a product of both slips,

.. math:: E - E_{II} = -\frac{m_{12}}{i_1 + i_2} (\omega_{in} - i_1 \omega_{out}) (\omega_{in} - i_2 \omega_{out}),

so nothing is lost while either element sticks. For one gear the same holds with :math:`i_1 = i_2`.

Members that turn independently of input and output take part with the motion in which no torque acts on them, that of
least kinetic energy.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from ptgen.errors import ModelError, Problem, nearest
from ptgen.gears.analysis import GearAnalysis
from ptgen.gears.combinations import free_motions
from ptgen.gears.gear import Gear
from ptgen.gears.inertia import energy, torque_free
from ptgen.gears.layout import Layout, ShiftElement
from ptgen.gears.vectors import Span, Vector, combined, null_space

__all__ = ["SimplifiedClutch", "SimplifiedGearbox", "simplified_gearbox"]


@dataclass(frozen=True)
class SimplifiedClutch:
    r"""A shift element, seen as a clutch at the input.

    Attributes
    ----------
    gear : str
        The gear that it holds.
    element : str
    ratio : float
        Ratio :math:`i_k` of the gear.
    factor : float
        :math:`\alpha_k`, the slip of the element over :math:`\omega_{in} - i_k \omega_{out}`.
    capacity : float
        Torque while it slips, fully actuated (N m).
    static : float or None
        Torque that it holds while it sticks (N m); None if it is the capacity.
    stribeck_speed : float or None
        Velocity over which the torque falls from `static` to the capacity (rad/s).
    viscous : float
        Viscous friction (N m s/rad).
    inertia : float
        Inertia :math:`J_k` of the gear set at the output, in the gear (kg m^2).
    inertia_error : float
        Inertia of the model at the output, in the gear, over `inertia`, less 1; 0 if the model is exact.
    """

    gear: str
    element: str
    ratio: float
    factor: float
    capacity: float
    static: float | None
    stribeck_speed: float | None
    viscous: float
    inertia: float
    inertia_error: float


@dataclass(frozen=True)
class SimplifiedGearbox:
    """What models I and II of one gear, or of a pair of gears, need; and what they leave out.

    Attributes
    ----------
    title : str
        The gear set.
    clutches : tuple of SimplifiedClutch
        One for each gear.
    locked : tuple of str
        The elements that stick all the time.
    masses : tuple of (float, float, float)
        m11, m12 and m22 (kg m^2) of the gear set with the locked elements.
    inertia_input, inertia_output : float
        I_gbi and I_gbo (kg m^2).
    own_motions : int
        Degrees of freedom beside those of input and output, which follow without torque.
    losses : tuple of str
        Friction elements of the gear set that the models do not have.
    """

    title: str
    clutches: tuple[SimplifiedClutch, ...]
    locked: tuple[str, ...]
    masses: tuple[float, float, float]
    inertia_input: float
    inertia_output: float
    own_motions: int
    losses: tuple[str, ...]

    @property
    def is_exact(self) -> bool:
        """Whether the models have the inertia of the gear set in each gear."""
        return all(abs(clutch.inertia_error) < 1e-12 for clutch in self.clutches)

    @property
    def strongest(self) -> SimplifiedClutch:
        """The clutch with the largest capacity; model I has that one for all gears."""
        return max(self.clutches, key=lambda clutch: clutch.capacity)


def simplified_gearbox(found: GearAnalysis, gears: Sequence[str]) -> SimplifiedGearbox:
    """Return models I and II of one gear, or of two gears with a single change between them.

    Parameters
    ----------
    found : GearAnalysis
        The gear set.
    gears : sequence of str
        One or two of its gears.

    Raises
    ------
    ModelError
        If there is no such gear, the change takes more than one element on each side, an element of it depends on
        more than the velocities of input and output, or the gear set has no inertia there.
    """
    chosen = [_gear(found, name) for name in gears]
    if len(chosen) == 1:
        return _of_one_gear(found.layout, chosen[0])
    if len(chosen) != 2 or chosen[0].name == chosen[1].name:
        what = f"one gear or two different ones can be simplified at a time, got {', '.join(gears) or 'none'}"
        raise ModelError(Problem("gears", what, "write e.g. 1,2"), found.layout.title)
    first, second = chosen
    change = found.change(first.name, second.name)
    if change is None or not (change.is_single and change.release and change.apply):
        released, applied = (" and ".join(side) for side in (change.release, change.apply)) if change else ("", "")
        what = (
            f"from gear {first.name} to gear {second.name} {released or 'nothing'} must be released and "
            f"{applied or 'nothing'} applied, and a simplified gearbox has one clutch for each gear"
        )
        other = [c.end for c in found.changes if c.start == first.name and c.is_single and c.release and c.apply]
        remedy = f"take another gear beside {first.name}: {', '.join(other) or 'none has a single change'}"
        raise ModelError(Problem("gears", what, remedy), found.layout.title)
    engaged = (set(first.engaged) | set(change.before.apply)) - set(change.before.release) - set(change.release)
    pairs = [(first, change.release[0]), (second, change.apply[0])]
    return _Reduction(found.layout, engaged).gearbox(pairs)


def _gear(found: GearAnalysis, name: str) -> Gear:
    listed = {gear.name: gear for gear in found.listed}
    if name not in listed:
        what = f'"{name}" is no gear of the shift table'
        raise ModelError(Problem("gears", what, nearest(name, listed)), found.layout.title)
    return listed[name]


def _of_one_gear(layout: Layout, gear: Gear) -> SimplifiedGearbox:
    """Return the models of one gear; of its elements the one is the clutch that leaves least coupling when open."""
    made = []
    problem: ModelError | None = None
    for element in gear.needed:
        try:
            made.append(_Reduction(layout, set(gear.engaged) - {element}).gearbox([(gear, element)]))
        except ModelError as error:
            problem = error
    if not made and problem is not None:
        raise problem
    return min(made, key=lambda box: box.masses[1] ** 2 / (box.masses[0] * box.masses[2]))


class _Reduction:
    """A gear set with some elements locked, in the velocities of input and output."""

    def __init__(self, layout: Layout, locked: set[str]) -> None:
        self.layout = layout
        self.locked = tuple(name for name in layout.element_names if name in locked)
        own = [element for element in layout.elements if element.name in locked]
        free = free_motions(layout)
        rows = [combined(layout.element_vector(element), free) for element in own]
        self.basis = [_sum(weights, free) for weights in null_space(rows, len(free))]
        self.ends = [combined(layout.unit_vector(member), self.basis) for member in (layout.input, layout.output)]
        if _rank(self.ends) < 2:
            what = f"with {', '.join(self.locked)} engaged the input and the output do not turn independently"
            raise ModelError(Problem("gears", what, "take gears that one element each makes of that"), layout.title)
        self.masses = self._masses()

    def _masses(self) -> tuple[Fraction, Fraction, Fraction]:
        """Return m11, m12 and m22; motions that are neither the input's nor the output's follow without torque."""
        inner = [_sum(weights, self.basis) for weights in null_space(self.ends, len(self.basis))]
        first, second = torque_free(self.layout, [self._motion(0), self._motion(1)], inner)
        pairs = (first, first), (first, second), (second, second)
        m11, m12, m22 = (energy(self.layout, *pair) for pair in pairs)
        return m11, m12, m22

    def _motion(self, end: int) -> Vector:
        """Return a motion in which one end turns with the velocity 1 and the other one stands."""
        weights: Vector = null_space([self.ends[1 - end]], len(self.basis))[0]
        for weights in null_space([self.ends[1 - end]], len(self.basis)):
            speed = _product(self.ends[end], weights)
            if speed:
                return _sum([weight / speed for weight in weights], self.basis)
        raise ValueError("the ends are independent")

    def gearbox(self, pairs: Sequence[tuple[Gear, str]]) -> SimplifiedGearbox:
        m11, m12, m22 = self.masses
        if not (m11 and m22):
            what = f"the {'output' if m11 else 'input'} moves no inertia, and the simplified gearboxes need one there"
            raise ModelError(Problem("members", what, "give the member or its sets an inertia"), self.layout.title)
        ratios = [gear.ratio for gear, _ in pairs]
        inertias = [i * i * m11 + 2 * i * m12 + m22 for i in ratios]
        own = _fitted(self.masses, ratios, inertias)
        factors = [self._factor(gear, element) for gear, element in pairs]
        elements = {element.name: element for element in self.layout.elements}
        clutches = tuple(
            _clutch(gear, elements[name], factor, inertia, (gear.ratio**2 * own[0] + own[1]) / inertia - 1)
            for (gear, name), factor, inertia in zip(pairs, factors, inertias, strict=True)
        )
        return SimplifiedGearbox(
            self.layout.title,
            clutches,
            self.locked,
            (float(m11), float(m12), float(m22)),
            float(own[0]),
            float(own[1]),
            len(self.basis) - 2,
            self.layout.losses,
        )

    def _factor(self, gear: Gear, name: str) -> Fraction:
        """Return alpha of the row of an element, ``alpha * (input - ratio * output)``."""
        element = next(own for own in self.layout.elements if own.name == name)
        row = combined(self.layout.element_vector(element), self.basis)
        slip: Vector = [a - gear.ratio * b for a, b in zip(*self.ends, strict=True)]
        pivot = next(k for k, entry in enumerate(slip) if entry)
        factor = row[pivot] / slip[pivot]
        if not factor or any(a != factor * b for a, b in zip(row, slip, strict=True)):
            what = (
                f"with {', '.join(self.locked) or 'nothing'} engaged the slip of {name} does not follow from the "
                "velocities of input and output, so that it is no clutch between them"
            )
            remedy = "preselect what the shift needs in the shift table, or take other gears"
            raise ModelError(Problem(f"gears.{gear.name}", what, remedy), self.layout.title)
        return factor


def _clutch(
    gear: Gear, element: ShiftElement, factor: Fraction, inertia: Fraction, error: Fraction
) -> SimplifiedClutch:
    size = float(abs(factor))
    return SimplifiedClutch(
        gear.name,
        element.name,
        float(gear.ratio),
        float(factor),
        size * element.capacity,
        None if element.static is None else size * element.static,
        None if element.stribeck_speed is None else element.stribeck_speed / size,
        size * size * element.viscous,
        float(inertia),
        float(error),
    )


def _fitted(
    masses: tuple[Fraction, Fraction, Fraction], ratios: Sequence[Fraction], inertias: Sequence[Fraction]
) -> tuple[Fraction, Fraction]:
    """Return the inertias at input and output that give the inertia in each gear.

    Where one of them would be negative, those are taken that share it as without coupling, with the least squares of
    the relative errors; for one gear there is none.
    """
    m11, m12, m22 = masses
    i, j = ratios[0], ratios[-1]
    if i + j:
        exact = m11 + 2 * m12 / (i + j), m22 + 2 * m12 * i * j / (i + j)
        if min(exact) > 0:
            return exact
    shares = [(i * i * m11 + m22) / inertia for i, inertia in zip(ratios, inertias, strict=True)]
    scale = sum(shares, Fraction(0)) / sum((share * share for share in shares), Fraction(0))
    return scale * m11, scale * m22


def _sum(weights: Sequence[Fraction], vectors: Sequence[Vector]) -> Vector:
    return [_product(weights, column) for column in zip(*vectors, strict=True)]


def _product(first: Sequence[Fraction], second: Sequence[Fraction]) -> Fraction:
    terms = (a * b for a, b in zip(first, second, strict=True) if a and b)
    return sum(terms, Fraction(0))


def _rank(rows: Sequence[Vector]) -> int:
    span = Span()
    for row in rows:
        span = span.with_vector(row) or span
    return span.rank

r"""Part: a gear set or another assembly of components, described in a file of its own.

Flanges
    Those that the part's file exposes, each of which is one of its members or a flange of one of its components.
Equations
    A member is a rigid shaft that joins any number of flanges. With the velocity :math:`\omega_k` of the member and
    :math:`\omega_j` of a flange that it joins,

    .. math:: \omega_k = \omega_j \quad\text{(rigid)}, \qquad
              T_j = c\,(\varphi_k - \varphi_j) + d\,(\omega_k - \omega_j) \quad\text{(flexible)} \qquad (3.46)

    A member that is held belongs to the housing: :math:`\omega_k = 0`.

    The rigid model of a gear set with friction elements is (3.42); it comes out of the assembly, like that of any bed.
    In the flexible model the joints of members with a stiffness give way where the flange that they hold has an
    inertia, as in (3.45).
Assumptions
    A part holds no machines. What its components are called is prefixed with its name: ``gears.P1.sun`` is a velocity
    and ``gears.A`` a friction element of the part ``gears``.
Reference
    (3.42)-(3.46), Section 3.7.1.
"""

from __future__ import annotations

import builtins
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import Annotated, Any, ClassVar, Literal

import sympy as sp
from pydantic import Field, model_validator

from ptgen.components.component import Component, Flange, Quantity, Record, Switch, parameters_of
from ptgen.elements import Body, Constraint, Elements, Parameter, Place, Row, Spring

__all__ = ["Member", "Part", "PartDescription"]


class Member(Record):
    """A rigid shaft inside a part."""

    joins: tuple[str, ...]
    """The flanges that it joins, such as "P1.sun"; a component with one flange, or with a single free side, by name."""
    held: Switch = False
    """Whether it is a part of the housing, so that it stands still."""
    inertia: Annotated[float, Quantity("kg m^2", "moment of inertia of the member")] | None = None
    stiffness: Annotated[float, Quantity("N m/rad", "stiffness of each joint in the flexible model")] | None = None
    damping: Annotated[float, Quantity("N m s/rad", "damping of each joint in the flexible model")] | None = None

    @model_validator(mode="after")
    def _held_without_inertia(self) -> Member:
        if self.held and self.inertia is not None:
            raise ValueError("inertia has no effect on what is held; remove it, or held")
        return self


@dataclass(frozen=True)
class PartDescription:
    """What a part's file says.

    Attributes
    ----------
    title : str
        What the part is called in reports.
    file : str
        The file that it was read from.
    digest : str
        SHA-256 of everything that the part was read from.
    components : mapping of str to Component
        In the order of the file.
    members : mapping of str to Member
        With the flanges that they join in full, ``"P1.sun"``.
    connections : tuple of (str, str)
        Rigid connections of two flanges each, beside those of the members.
    exposed : mapping of str to str
        Flange of the part -> the member or the flange of a component that it is.
    gears : mapping of str to tuple of str
        The shift table: gear -> the elements that are engaged in it.
    assumed : tuple of str
        Keys of the file whose values are assumed rather than measured.
    """

    title: str
    file: str
    digest: str
    components: Mapping[str, Component]
    members: Mapping[str, Member]
    connections: tuple[tuple[str, str], ...]
    exposed: Mapping[str, str]
    gears: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    assumed: tuple[str, ...] = ()


class Part(Component):
    """An assembly of components from a file; each file has a subclass of its own, see `of`."""

    type_name: ClassVar[str] = "part"
    summary: ClassVar[str] = "gear set or other assembly from a part file"
    flanges: ClassVar[tuple[Flange, ...]] = ()
    description: ClassVar[PartDescription]

    type: Literal["part"]
    file: str
    """The part's file, looked for beside the bed file and then among the parts that come with ptgen."""
    model: Literal["rigid", "flexible"] = "rigid"
    """Whether the joints of its members are rigid, or shafts with the stiffness that the part's file gives."""
    values: dict[str, Any] = Field(default_factory=dict)
    """Other values than those of the part's file, such as { "P1.inertia_sun" = "0.004 kg m^2" }."""

    @classmethod
    def of(cls, description: PartDescription) -> builtins.type[Part]:
        """Return the type of the parts with this description; its flanges are those that the file exposes."""
        return builtins.type(
            "Part",
            (cls,),
            {
                "__module__": __name__,
                "__doc__": description.title,
                "__annotations__": {
                    "flanges": ClassVar[tuple[Flange, ...]],
                    "description": ClassVar[PartDescription],
                },
                "flanges": tuple(Flange(name) for name in description.exposed),
                "description": description,
            },
        )

    def gear_elements(self) -> Mapping[str, tuple[str, ...]]:
        return self.description.gears

    def parameters(self, name: str) -> tuple[Parameter, ...]:
        inner = [
            parameter
            for part, component in self.description.components.items()
            for parameter in component.parameters(f"{name}_{part}")
        ]
        for member, record in self.description.members.items():
            own = parameters_of(record, f"{name}_{member}")
            inner += own if self.model == "flexible" else [p for p in own if p.symbol.name.endswith("_inertia")]
        return tuple(replace(parameter, owner=name) for parameter in inner)

    def elements(self, name: str) -> Elements:
        inner = [
            _renamed(component.elements(f"{name}_{part}"), f"{name}_{part}", f"{name}.{part}")
            for part, component in self.description.components.items()
        ]
        connections = [
            *(connection for elements in inner for connection in elements.connections),
            *((f"{name}.{left}", f"{name}.{right}") for left, right in self.description.connections),
        ]
        velocities = [
            *(f"{name}.{part}.{f}" for part, c in self.description.components.items() for f in c.flange_names()),
            *(velocity for elements in inner for velocity in elements.internal),
        ]
        bodies = [body for elements in inner for body in elements.bodies]
        heavy = {body.velocity for body in bodies}
        springs = [spring for elements in inner for spring in elements.springs]
        symbols = {parameter.symbol.name: parameter.symbol for parameter in self.parameters(name)}
        for member, record in self.description.members.items():
            hub = f"{name}.{member}"
            velocities.append(hub)
            if record.inertia is not None:
                bodies.append(Body(hub, symbols[f"{name}_{member}_inertia"]))
            for joined in record.joins:
                flange = f"{name}.{joined}"
                if self.model == "flexible" and record.stiffness is not None and flange in heavy:
                    # The joint's far end is connected to the flange, so that the flange has a torque, of losses say.
                    joint = f"{hub}.{joined}"
                    row = {hub: sp.Integer(1), joint: sp.Integer(-1)}
                    damping = symbols.get(f"{name}_{member}_damping", sp.Integer(0))
                    springs.append(Spring(joint, row, symbols[f"{name}_{member}_stiffness"], damping))
                    velocities.append(joint)
                    connections.append((joint, flange))
                else:
                    connections.append((hub, flange))
        own = {f"{name}.{flange}": f"{name}.{inside}" for flange, inside in self.description.exposed.items()}
        links = [
            Constraint(name, {flange: sp.Integer(1), inside: sp.Integer(-1)})
            for flange, inside in own.items()
            if flange != inside
        ]
        links += [
            Constraint(f"{name}.{member}", {f"{name}.{member}": sp.Integer(1)})
            for member, record in self.description.members.items()
            if record.held
        ]
        return Elements(
            internal=tuple(velocity for velocity in velocities if velocity not in own),
            bodies=tuple(bodies),
            constraints=(*(constraint for elements in inner for constraint in elements.constraints), *links),
            springs=tuple(springs),
            frictions=tuple(friction for elements in inner for friction in elements.frictions),
            sensors=tuple(sensor for elements in inner for sensor in elements.sensors),
            places=tuple(place for elements in inner for place in elements.places),
            connections=tuple(connections),
            fluids=tuple(fluid for elements in inner for fluid in elements.fluids),
        )


def _renamed(elements: Elements, old: str, new: str) -> Elements:
    """Return the elements of a component called `old` as those of one called `new`."""

    def name(text: str) -> str:
        return new + text[len(old) :] if text == old or text.startswith(f"{old}.") else text

    return replace(
        elements,
        internal=tuple(map(name, elements.internal)),
        bodies=tuple(replace(body, velocity=name(body.velocity)) for body in elements.bodies),
        constraints=tuple(Constraint(name(c.owner), _row(c.row, name)) for c in elements.constraints),
        springs=tuple(replace(s, name=name(s.name), row=_row(s.row, name)) for s in elements.springs),
        frictions=tuple(
            replace(
                friction,
                name=name(friction.name),
                row=_row(friction.row, name),
                load=None if friction.load is None else replace(friction.load, place=name(friction.load.place)),
            )
            for friction in elements.frictions
        ),
        sensors=tuple(replace(sensor, of=name(sensor.of)) for sensor in elements.sensors),
        places=tuple(
            Place(name(place.name), {name(flange): factor for flange, factor in place.flanges.items()})
            for place in elements.places
        ),
        connections=tuple((name(left), name(right)) for left, right in elements.connections),
        fluids=tuple(
            replace(fluid, name=name(fluid.name), pump=name(fluid.pump), turbine=name(fluid.turbine))
            for fluid in elements.fluids
        ),
    )


def _row(row: Row, name: Callable[[str], str]) -> Row:
    return {name(velocity): value for velocity, value in row.items()}

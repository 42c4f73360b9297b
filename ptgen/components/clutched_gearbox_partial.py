"""What the simplified gearboxes with clutches share: two inertias, ratios that change, and the gears.

A ratio of these gearboxes stands in the row of a clutch alone. Nothing that has inertia is tied by it, so it may change
at any time and by any amount, even its sign: while the clutch is open nothing happens, while it sticks it has to slip
until both sides suit each other again.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, ClassVar

from pydantic import field_validator, model_validator

from ptgen.components.component import Component, Engagement, Flange, Quantity

__all__ = ["ClutchedGearboxPartial"]


class ClutchedGearboxPartial(Component):
    """Base of the gearboxes whose ratios act through clutches."""

    flanges: ClassVar[tuple[Flange, ...]] = (Flange("input"), Flange("output"))
    ratios: ClassVar[tuple[str, ...]]
    """The keys of the ratios at the start."""
    clutches: ClassVar[tuple[str, ...]]
    """The names of the clutches that act through them."""

    inertia_input: Annotated[float, Quantity("kg m^2", "moment of inertia I_gbi at the input")]
    inertia_output: Annotated[float, Quantity("kg m^2", "moment of inertia I_gbo at the output")]
    gears: dict[str, Annotated[float, Quantity("", "ratio of a gear", signed=True)]] | None = None
    """Name of each gear = its ratio, such as { 1 = 5.503, 2 = 3.333, R = -3.403 }."""
    ratio_range: (
        tuple[
            Annotated[float, Quantity("", "least ratio while the bed runs", positive=False, signed=True)],
            Annotated[float, Quantity("", "largest ratio while the bed runs", positive=False, signed=True)],
        ]
        | None
    ) = None
    """Least and largest ratio while the bed runs; by default those of the gears. Without either nothing changes."""

    @field_validator("gears")
    @classmethod
    def _names(cls, gears: dict[str, float] | None) -> dict[str, float] | None:
        for name in gears or ():
            if name == "N" or not name.isalnum():
                raise ValueError(
                    f'the gear "{name}" needs a name of letters and digits, and N is neutral; write e.g. 1 or R'
                )
        if gears is not None and not gears:
            raise ValueError("must hold gears; write e.g. { 1 = 5.503, 2 = 3.333 }, or leave it out")
        return gears

    @model_validator(mode="after")
    def _ratios_in_range(self) -> ClutchedGearboxPartial:
        if self.ratio_range is not None and self.ratio_range[0] >= self.ratio_range[1]:
            least, most = self.ratio_range
            raise ValueError(
                f"ratio_range must rise, got [{least:g}, {most:g}]; "
                "exchange the two, or remove it if the ratio is constant"
            )
        span = self._span()
        if span is None:
            return self
        what = "ratio_range" if self.ratio_range is not None else "the range of the gears"
        given = {f"gears.{name}": ratio for name, ratio in (self.gears or {}).items()}
        given |= {key: getattr(self, key) for key in self.ratios}
        beyond = [f"{key} = {value:g}" for key, value in given.items() if not span[0] <= value <= span[1]]
        if beyond:
            raise ValueError(
                f"every ratio must lie in {what}, from {span[0]:g} to {span[1]:g}, got {', '.join(beyond)}; "
                "change it, or widen ratio_range"
            )
        return self

    def _span(self) -> tuple[float, float] | None:
        if self.ratio_range is not None:
            return self.ratio_range
        ratios = set((self.gears or {}).values())
        return (min(ratios), max(ratios)) if len(ratios) > 1 else None

    def gear_ratios(self) -> Mapping[str, float]:
        """Return the ratio of each gear."""
        return self.gears or {}

    def gear_elements(self) -> Mapping[str, tuple[str, ...]]:
        """Return the clutch of each gear; with several it is the first one that is free."""
        return {gear: ways[0].elements for gear, ways in self.engagements().items()}

    def engagements(self) -> Mapping[str, tuple[Engagement, ...]]:
        """Return each gear by way of each clutch whose ratio it can be."""
        spans, several = self.spans(), len(self.ratios) > 1
        ways = {
            gear: tuple(
                Engagement((clutch,), {key: ratio} if key in spans else {}, preselected=several)
                for clutch, key in zip(self.clutches, self.ratios, strict=True)
                if key in spans or getattr(self, key) == ratio
            )
            for gear, ratio in (self.gears or {}).items()
        }
        return {gear: found for gear, found in ways.items() if found}

    def spans(self) -> Mapping[str, tuple[float, float]]:
        """Return the range of each ratio, if they change."""
        span = self._span()
        return {} if span is None else dict.fromkeys(self.ratios, span)

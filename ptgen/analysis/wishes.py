"""What the wishes of a bed file do to the parameters of its controller, without designing the law anew."""

from __future__ import annotations

from functools import cached_property

from ptgen.control.controller import controller_block, conventional_parameters
from ptgen.control.decoupling import Decoupling
from ptgen.control.tuning import Gains, gains
from ptgen.mechanism.model import Model
from ptgen.mechanism.modes import Mode
from ptgen.testbed.testbed import Tuning

__all__ = ["WISHES", "WishedParameters"]

WISHES = ("speed_bandwidth", "torque_bandwidth", "damping_ratio")
"""The wishes that trade speed for margins, as the file names them."""


class WishedParameters:
    """Parameters of the controller for other wishes than the file's.

    Parameters
    ----------
    decoupling : Decoupling
    full : Model
        The full model.
    modes : tuple of Mode
        Its modes.
    tuning : Tuning
        The wishes of the file.
    sample_time : float
        Step (s).
    conventional : bool
        Whether to return those of the conventional controller.
    """

    def __init__(
        self,
        decoupling: Decoupling,
        full: Model,
        modes: tuple[Mode, ...],
        tuning: Tuning,
        sample_time: float,
        conventional: bool = False,
    ) -> None:
        self._decoupling, self._full, self._modes = decoupling, full, modes
        self._sample_time, self._conventional = sample_time, conventional
        self.tuning = tuning

    def gains(self, **wishes: float) -> Gains:
        """Return the gains for `wishes`, keys of `WISHES`, in place of those of the file."""
        return gains(self._decoupling, self._full, self.tuning.model_copy(update=wishes), self._modes)

    def at(self, **wishes: float) -> dict[str, float]:
        """Return all parameters for `wishes`, keys of `WISHES`, in place of those of the file, by name."""
        found = self.gains(**wishes)
        changed = found.parameters()
        parameters = {name: changed.get(name, value) for name, value in self._of_file.items()}
        return parameters | (conventional_parameters(self._decoupling, found) if self._conventional else {})

    @cached_property
    def _of_file(self) -> dict[str, float]:
        """Parameters for the wishes of the file; the block is written once, other wishes change its gains alone."""
        made = controller_block(self._decoupling, self.gains(), self.tuning, self._full, self._sample_time)
        return {signal.name: signal.value for signal in made.block.parameters}

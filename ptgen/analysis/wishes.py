"""What the wishes of a bed file do to the parameters of its controller, without designing the law anew."""

from __future__ import annotations

from ptgen.control.controller import controller_block
from ptgen.control.decoupling import Decoupling
from ptgen.control.tuning import gains
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

    def at(self, **wishes: float) -> dict[str, float]:
        """Return all parameters for `wishes` in place of those of the file, by name."""
        tuning = self.tuning.model_copy(update=wishes)
        found = gains(self._decoupling, self._full, tuning, self._modes)
        made = controller_block(self._decoupling, found, tuning, self._full, self._sample_time)
        parameters = {signal.name: signal.value for signal in made.block.parameters}
        return {**parameters, **made.conventional} if self._conventional else parameters

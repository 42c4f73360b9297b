r"""Shared by all components with a sensor: the low pass of its electronics.

Source, Section 2.3: dead time and filtering of the sensors in the control loops should be as small as possible, but the
speed of an incremental encoder follows from differences of angles, and is filtered for that reason. The filter

.. math:: \tau\,\dot y + y = y_{true}

acts on what the controller measures; envelopes, friction and torque references depend on the true quantities.
"""

from __future__ import annotations

from typing import Annotated

from ptgen.components.component import Quantity, Record

__all__ = ["SensorPartial"]


class SensorPartial(Record):
    """The low pass of a sensor."""

    time_constant: Annotated[float, Quantity("s", "time constant of the sensor's low pass")]

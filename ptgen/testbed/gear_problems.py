"""What is wrong with the shift table of a part, once its file is readable."""

from __future__ import annotations

from ptgen.components.part import Part
from ptgen.errors import ModelError, Problem
from ptgen.gears import layout_of_part, shift_table_problems

__all__ = ["gear_problems"]


def gear_problems(part: type[Part]) -> list[Problem]:
    """Return what is wrong with the shift table of a part; nothing if it has none."""
    description = part.description
    if not description.gears:
        return []
    layout = layout_of_part(part(type="part", file=description.file))
    try:
        return shift_table_problems(layout, description.gears)
    except ModelError as error:  # too many elements to look at: the file is known here
        return list(error.problems)

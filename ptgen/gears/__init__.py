"""What a gear set can do, from its layout alone: gears, neutrals and tie-ups, their speeds, torques and losses."""

from ptgen.gears.analysis import GearAnalysis, analyse_gears
from ptgen.gears.combinations import Combination, State
from ptgen.gears.gear import Gear
from ptgen.gears.handover import Handover, handover, way_round
from ptgen.gears.inertia import input_inertia
from ptgen.gears.joined import layout_of, layout_of_part
from ptgen.gears.layout import Layout
from ptgen.gears.shift_table import gear_ratios, shift_table_problems
from ptgen.gears.simplified import SimplifiedClutch, SimplifiedGearbox, simplified_gearbox

__all__ = [
    "Combination",
    "Gear",
    "GearAnalysis",
    "Handover",
    "Layout",
    "SimplifiedClutch",
    "SimplifiedGearbox",
    "State",
    "analyse_gears",
    "gear_ratios",
    "handover",
    "input_inertia",
    "layout_of",
    "layout_of_part",
    "shift_table_problems",
    "simplified_gearbox",
    "way_round",
]

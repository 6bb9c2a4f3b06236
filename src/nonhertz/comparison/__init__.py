"""Strips and plane grid on one case: how far they differ, what each costs, and why they differ where they do.

The strips take the pressure across the contact for a semi-ellipse or a parabola; the plane grid takes it for nothing
at all. Where both agree, the shape was right; where they do not, the solutions themselves say what is behind it.
"""

from nonhertz.comparison.methods import compare as compare
from nonhertz.comparison.value import Comparison as Comparison
from nonhertz.comparison.value import Quantity as Quantity
from nonhertz.comparison.value import Reason as Reason
from nonhertz.comparison.value import Seconds as Seconds
from nonhertz.comparison.value import Station as Station
from nonhertz.comparison.value import Stretch as Stretch

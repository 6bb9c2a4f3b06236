"""Strips and plane grid on one case: their differences, the places of these, and their run times.

The strips assume a semi-ellipse or a parabola for the pressure across the contact; the plane grid assumes nothing.
Where both agree, the shape was right.
"""

from nonhertz.comparison.methods import compare as compare
from nonhertz.comparison.value import ComparedQuantity as ComparedQuantity
from nonhertz.comparison.value import Comparison as Comparison
from nonhertz.comparison.value import Seconds as Seconds
from nonhertz.comparison.value import Station as Station
from nonhertz.comparison.value import Stretch as Stretch

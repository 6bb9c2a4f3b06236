"""Bearing files of few rollers, of bodies without ends: as little as makes a bearing, solved by strips in a blink."""

SIX = """
title = "six"
[bearing]
kind = "cylindrical"
rollers = 6
clearance = "12 um"
[roller]
diameter = 9.0
length = 10.0
profile = { kind = "crown", radius = 1200 }
side_faces = "none"
depth = "none"
[inner]
diameter = 37.5
[outer]
diameter = -55.5
[load]
radial = "5 kN"
tilt = "0.2 mrad"
"""
PAIR = """
title = "pair"
[bearing]
kind = "tapered"
rollers = 6
contact_angle = "12 deg"
pair = { arrangement = "O", distance = 20, clearance = "-40 um" }
[roller]
diameter = { y = [-5.8, 5.8], diameter = [10.94, 10.12] }
length = 11.6
profile = { kind = "crown", radius = 4000 }
side_faces = "none"
depth = "none"
[inner]
diameter = 40.8
[outer]
diameter = -62.32
[load]
radial = "8 kN"
axial = "3 kN"
"""


def changed(text: str, *replaced: tuple[str, str]) -> str:
    """Return a bearing file with other words in place of some that it must have."""
    for old, new in replaced:
        assert old in text, old
        text = text.replace(old, new)
    return text

"""Bearing files: of few rollers without ends, solved by strips in a blink, of two rows of barrels, of washers."""

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
SPHERICAL = """
[bearing]
kind = "spherical"
rollers = 17
contact_angle = "10 deg"
profile_radius = 60
inner_groove = 61.5
outer_groove = 61.5
pair = { arrangement = "X", distance = 20 }
[roller]
diameter = 12
length = 14
[inner]
diameter = 60
[outer]
diameter = -84.35
[load]
radial = ["20 kN", "5 kN"]
"""
THRUST = """
[bearing]
kind = "thrust"
rollers = 20
pitch_diameter = 60
[roller]
diameter = 8
length = 8
[inner]
[outer]
[load]
axial = "20 kN"
"""


def changed(text: str, *replaced: tuple[str, str]) -> str:
    """Return a bearing file with other words in place of some that it must have."""
    for old, new in replaced:
        assert old in text, old
        text = text.replace(old, new)
    return text

"""Bearings of crowned rollers without ends, which cost little: a cylindrical row, and a pair of tapered ones."""

import nonhertz as nh

PLAIN = {"side_faces": "none", "depth": "none"}
RINGS = {"inner": nh.Ring(diameter=37.5), "outer": nh.Ring(diameter=-55.5)}


def row(clearance=0.0184, rollers=13):
    roller = nh.Roller(diameter=9.0, length=10.0, profile=nh.profile.crown(600.0), **PLAIN)
    return nh.bearing.CylindricalRollerBearing(roller=roller, **RINGS, rollers=rollers, clearance=clearance)


def pair():
    cone = nh.Roller(
        diameter=nh.TabulatedDiameter((-5.0, 5.0), (9.4, 8.6)), length=10.0, profile=nh.profile.crown(600.0), **PLAIN
    )
    single = nh.bearing.TaperedRollerBearing(roller=cone, **RINGS, rollers=12, contact_angle=0.2)
    return nh.bearing.paired(single, "O", 20.0, clearance=-0.005)

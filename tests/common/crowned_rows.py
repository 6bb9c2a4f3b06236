"""Rows of rollers: crowned ones without ends, which cost little, a tapered pair of them, and one of each kind."""

import math

import nonhertz as nh

B = nh.bearing
PLAIN = {"side_faces": "none", "depth": "none"}
RINGS = {"inner": nh.Ring(diameter=37.5), "outer": nh.Ring(diameter=-55.5)}
TAPER = B.TaperedRollerBearing(
    roller=nh.Roller(
        diameter=nh.TabulatedDiameter((-5.825, 5.825), (10.94, 10.12)), length=11.65, profile=nh.profile.crown(8000)
    ),
    inner=nh.Ring(diameter=40.8), outer=nh.Ring(diameter=-62.32), rollers=14, contact_angle=0.207,
)  # fmt: skip


def row(clearance=0.0184, rollers=13, radius=600.0, ends=PLAIN, **given):
    roller = nh.Roller(diameter=9.0, length=10.0, profile=nh.profile.crown(radius), **ends)
    return B.CylindricalRollerBearing(roller=roller, **RINGS, rollers=rollers, clearance=clearance, **given)


def pair():
    cone = nh.Roller(
        diameter=nh.TabulatedDiameter((-5.0, 5.0), (9.4, 8.6)), length=10.0, profile=nh.profile.crown(600.0), **PLAIN
    )
    single = B.TaperedRollerBearing(roller=cone, **RINGS, rollers=12, contact_angle=0.2)
    return B.paired(single, "O", 20.0, clearance=-0.005)


def nu206(*, outer=None, **roller):
    rings = {"inner": nh.Ring(diameter=37.5, depth=3.75), "outer": nh.Ring(diameter=-55.5, depth=3.25, **(outer or {}))}
    roller = nh.Roller(**({"diameter": 9.0, "length": 10.0} | roller))
    return B.CylindricalRollerBearing(roller=roller, **rings, rollers=13, clearance=0.0184)


def worked(clearance=0.0, rollers=14, pitch=65.0, **roller):
    """Return the row of rollers of 10 mm whose ratings are worked out in public."""
    roller = nh.Roller(**({"diameter": 10.0, "length": 9.6, "profile": nh.profile.crown(2000)} | roller))
    rings = {"inner": nh.Ring(diameter=pitch - 10.0), "outer": nh.Ring(diameter=-pitch - 10.0)}
    return B.CylindricalRollerBearing(roller=roller, **rings, rollers=rollers, clearance=clearance)


def washers(diameter=8.0, pitch=60.0, rollers=20, crown=2000.0, depth=None):
    roller = nh.Roller(diameter=diameter, length=diameter, profile=nh.profile.crown(crown))
    flat = {"inner": nh.Plate(depth=depth), "outer": nh.Plate(depth=depth), "pitch_diameter": pitch}
    return B.CylindricalThrustBearing(roller=roller, **flat, rollers=rollers)


def barrels(angle=0.2, diameter=14.0, length=13.0, pitch=90.0, rollers=17, clearance=0.0):
    across = diameter / math.cos(angle)
    sphere = 0.5 * (pitch / math.cos(angle) + diameter)
    rings = {"inner": nh.Ring(diameter=pitch - across), "outer": nh.Ring(diameter=-pitch - across)}
    along = {"profile_radius": 0.975 * sphere, "inner_groove": sphere, "outer_groove": sphere}
    roller = nh.Roller(diameter=diameter, length=length)
    return B.SphericalRollerBearing(
        roller=roller, **rings, **along, rollers=rollers, contact_angle=angle, clearance=clearance
    )

"""Rows of rollers: crowned ones without ends, which cost little, a tapered pair of them, an NU 206, a tapered row."""

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

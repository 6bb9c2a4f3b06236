"""Solves with the package that is installed, in numbers that are known: what every wheel is tried with."""

import nonhertz as nh
from nonhertz.native import core

contact = nh.Contact(nh.Roller(diameter=20, length=20, profile=nh.profile.crown(radius=1000)), nh.Ring(diameter=80))
solution = nh.solve(contact, load=5e3, strips=41)
print(f"{core.__name__}: {solution.max_pressure!r} MPa, {solution.approach!r} mm")

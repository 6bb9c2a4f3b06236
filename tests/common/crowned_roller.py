"""A case file that is solved in a moment: a crowned roller without ends on a plate."""

CASE = """
title = "A roller on a plate"
[body.a]
diameter = 20.0
length = 20.0
profile = [{ kind = "crown", radius = "4 m" }]
side_faces = "none"
depth = "none"
[body.b]
side_faces = "none"
depth = "none"
[load]
load = "20 kN"
[solver]
strips = 31
"""

"""A case file with every key at least once, some of which name files beside it."""

TEXT = """\
title = "all keys"
[body.a]
kind = "roller"
diameter = 20.0
length = "2 cm"
effective_length = 19
position = "10 um"
material = { modulus = "207 GPa", poisson = 0.3 }
profile = [
  { kind = "crown", radius = 4000.0, centre = 0.1, shift = "1 mm", scale = 0.5 },
  { kind = "logarithmic", amplitude = 0.002, straight = 5 },
  { kind = "lundberg", load = "20 kN", radius = 10 },
  { kind = "tabulated", y = [-10, 0, 10], relief = ["10 um", 0, 0.01], interpolation = "linear" },
  { kind = "tabulated", file = "points.csv", interpolation = "cubic" },
  { kind = "partial-crown", radius = 1000, straight = 5, blended = true },
]
side_faces = ["calibrated", 1.2]
images = "series"
depth = "plane-strain"
[body.b]
kind = "ring"
diameter = { y = [-10, 10], diameter = [-80, -81.5] }
side_faces = "none"
[[body.b.profile]]
kind = "measured"
file = "trace.txt"
height_unit = "um"
sense = "height"
level = true
align = "symmetry"
trim = false
outliers = 5
smooth = "gaussian"
cutoff = 4
points = 20
[load]
load = "20 kN"
tilt = "0.5 mrad"
[solver]
element = "parabolic"
strips = 41
[life]
rollers = 14
contact_angle = "12 deg"
models = ["zaretsky", "iso-16281"]
slope = 1.5
fatigue_limit = "0.3 GPa"
laminae = 40
edge_stress = "none"
line_loads = "standard"
[[life.spectrum]]
load = 1e4
share = 0.25
tilt = -1e-3
[[life.spectrum]]
load = 5000
share = 0.75
"""

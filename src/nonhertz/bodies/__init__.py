"""What lies behind the surface of a body: its side faces and its depth, and their effect on how loads act.

`sides` and `depths` hold one file for each way to treat a side face and to choose a depth: its keyword, its meaning,
what it adds. `images` makes chains of mirror images, `ends` finds what governs a sharp end, `influence` sums up both
bodies.
"""

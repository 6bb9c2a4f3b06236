"""What lies behind the surface of a body: its side faces and its depth, and how loads on it act because of them.

`sides` and `depths` hold one file for each way to treat a side face and to choose a depth: its word, its meaning, what
it adds. `images` makes chains of mirror images, `ends` finds what governs a sharp end, `influence` sums up both bodies.
"""

"""What lies behind the surface of a body: its side faces and its depth, and their effect on how loads act.

What a body may say of either is in `nonhertz.model`. `images` makes chains of mirror images, `ends` finds what governs
a sharp end, `depths` what displacement is measured against, `influence` sums up both bodies.
"""

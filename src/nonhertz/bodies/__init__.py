"""Effect of a body's side faces and depth on the influence of loads on its surface.

The options of a body are in `nonhertz.model`. `images` makes chains of mirror images, `ends` computes the number that
governs a sharp end, `depths` the displacement of the reference points, and `influence` combines both bodies.
"""

"""What a solve found: the solution, its ends, how much it may err, and what strains the model.

Strips and the plane grid return different values with the same names: both are a `nonhertz.result.protocol.Solved`, and
who reads a result asks for no more than that.
"""

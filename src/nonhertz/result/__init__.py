"""The result of a solve: the solution, its ends, its error estimate, and strains of the model.

Strips and the plane grid return different types with the same attributes: both are a `nonhertz.result.solved.Solved`,
and code that reads a result relies on nothing else.
"""

"""The page of ``nonhertz serve``: a case to change by hand, solved again at every change, on this machine alone.

The server keeps nothing between requests. A request brings the whole case, the *document*, which is exactly what a case
file holds; the answer is what the command line would have said. What is computed is computed in processes of their own,
which are ended when they take too long.
"""

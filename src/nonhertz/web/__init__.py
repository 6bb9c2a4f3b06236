"""The page of ``nonhertz serve``: a case to edit, solved again at every change, on the local machine only.

The server is stateless. A request carries the whole case, the *document*, which is exactly what a case file holds; the
answer is what the command line would have said. All computing is done in worker processes, which are killed when they
take too long.
"""

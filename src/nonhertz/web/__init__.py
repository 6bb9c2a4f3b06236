"""The page of ``nonhertz serve``: a case to edit, solved again at every change, on the local machine only.

The server is stateless. A request contains the whole case, the *document*, which has exactly the contents of a case
file; the answer is the same as on the command line. All computing is done in worker processes, which are killed when
they take too long.
"""

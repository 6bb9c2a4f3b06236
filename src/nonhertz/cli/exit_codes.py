"""How commands end."""

FINE, NOT_CONVERGED, BAD_INPUT, INTERNAL, NOT_MET, NOT_JUDGED, STRAINED = range(7)
NOT_VERIFIED = NOT_CONVERGED
# As a shell reports a program ended by a signal.
INTERRUPTED, BROKEN_PIPE = 130, 141

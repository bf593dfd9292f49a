"""The same sweeps by other programs, for the bench: each module builds its peer's model from a graphkin method.

Lengths are read from the mechanism, so that a peer solves what the library file says; what it finds is compared
with graphkin's numbers before any clock is started.
"""

"""Value classes, caches, work lists, complex numbers as vectors, tolerances, plain data: all else stands on these."""

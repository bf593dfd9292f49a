"""Value classes, caches, work lists, complex numbers as vectors, rooms, tolerances, plain data: all else needs them."""

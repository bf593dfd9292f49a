"""What everything stands on: value classes, caches, work lists, complex numbers as vectors, tolerances, checksums."""

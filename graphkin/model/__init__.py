"""The mechanism as data: links, pairs, drivers, names, kinematic states, quantities and how they are read."""

"""The subjects, data only: instant centres, linkages, design, sweeps, finding, the structure of a mechanism."""

"""Both roads side by side: `roads` holds a replay against the analysis, `readings` reads both alike."""

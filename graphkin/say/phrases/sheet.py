"""What is written on a sheet beside drawings and results."""

from graphkin.say.catalogue import Phrases

PHRASES: Phrases = {
    "given": ("given", "已知"),
    "find": ("find", "求"),
    "step": ("Step {number} of {count}", "第 {number} 步，共 {count} 步"),
}
"""`given` heads what is known of the mechanism, `find` what is asked; `step` heads the sentence of a step's sheet."""

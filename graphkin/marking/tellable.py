"""Whether paper can tell a mistake at all.

An observer knows one mistake, what it gives and how a pencil scatters that. Values of students who make it he judges
by the rules of marking (`Explainer`), and has nothing to choose from but this mistake, right work, and other numbers.
He says nothing where every value is within its tolerance, for right work is never diagnosed; nor where the mistake does
not outweigh right work; nor where other numbers are as likely. What he misses no judge finds who has more mistakes to
choose from: one that moves a single value is missed by more than one in 20 where it moves it by less than 3 + 1.64
standard deviations.

The students' values are normal, with the variances and correlations of the mistake's drawings; and as they are drawn:
near a dead point these are not normal. Paper can tell the mistake where either way he finds it.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from graphkin.base.value import frozen
from graphkin.marking.explaining import Explainer

WELL = 0.95
"""What part of the students who make a mistake should be told of it."""
_TRIALS = 400


@frozen
class Observed:
    """What an observer sees of a mistake.

    beyond  part of the students who have a value beyond its tolerance, where values are normal
    found   part of them in whom he finds the mistake; drawn: the same, where values are as they are drawn
    """

    beyond: float
    found: float
    drawn: float

    @property
    def tellable(self) -> bool:
        return max(self.found, self.drawn) >= WELL


Wrong = Callable[[np.ndarray], np.ndarray]
"""Which values (students, quantities) are beyond their tolerance."""


def observed(explainer: Explainer, k: int, drawn: np.ndarray, wrong: Wrong) -> Observed:
    """Of explanation k; drawn: values of students who make this mistake (students, quantities)."""
    count = int(explainer.there.sum())
    normal = explainer.drawn(k, np.random.default_rng(count).standard_normal((_TRIALS, count)))
    given = np.concatenate([normal, drawn])
    beyond = wrong(given)
    found = np.concatenate([best.given for best in explainer.only(k).best(given, beyond)])
    return Observed(
        float(beyond[:_TRIALS].any(axis=1).mean()), float(found[:_TRIALS].mean()), float(found[_TRIALS:].mean())
    )

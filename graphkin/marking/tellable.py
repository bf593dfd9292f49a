"""Whether paper can tell a mistake at all, before any student is drawn up.

An observer knows one mistake, what it gives and how a pencil scatters that: normal, with the variances and correlations
of its drawings. Values like these he judges by the rules of marking (`Explainer`), and has nothing to choose from but
this mistake, right work, and other numbers. He says nothing where every value is within its tolerance, for right work
is never diagnosed; nor where the mistake does not outweigh right work; nor where other numbers are as likely. What he
misses no judge finds who has more mistakes to choose from: one that moves a single value is missed by more than one in
20 where it moves it by less than 3 + 1.64 standard deviations.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from graphkin.marking.explaining import Explainer
from graphkin.value import frozen

WELL = 0.95
"""What part of the students who make a mistake should be told of it."""
_TRIALS = 500


@frozen
class Observed:
    """What an observer sees of a mistake: the part of students who have a value beyond its tolerance, and the part of
    all in whom he finds the mistake."""

    beyond: float
    found: float

    @property
    def tellable(self) -> bool:
        return self.found >= WELL


def observed(explainer: Explainer, k: int, wrong: Callable[[np.ndarray], np.ndarray]) -> Observed:
    """Of explanation k; wrong: which values (students, quantities) are beyond their tolerance."""
    errors = np.random.default_rng(int(explainer.there.sum())).standard_normal((_TRIALS, int(explainer.there.sum())))
    given = explainer.drawn(k, errors)
    beyond = wrong(given)
    found = [best.given for best in explainer.only(k).best(given, beyond)]
    return Observed(float(beyond.any(axis=1).mean()), float(np.concatenate(found).mean()))

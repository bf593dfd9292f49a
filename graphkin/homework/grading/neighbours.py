"""Another student's numbers: what was handed in, beside the right values of all problems of a set."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path

import numpy as np

from graphkin.errors import AnotherStudent
from graphkin.marking.key import KeyEntry, columns, columns_of, differences
from graphkin.marking.records import Marked
from graphkin.model.quantities import at_position

_FEWEST, _PART = 3, 0.8  # so many numbers, and this part of them, agree with one other problem
_CHANCE = 0.01  # a hit that random numbers make more often, on some problem of the set, is no hint
_READ = ("unit", "sort", "right", "scatter", "tolerance")  # of a key's quantities
_NEAREST = 0.1  # closer than this, in standard deviations, is no better


class Neighbours:
    """The right values of a set's keys (students, quantities); one that cannot be read is no neighbour."""

    def __init__(self, files: Mapping[str, Path]) -> None:
        keys: dict[str, dict[str, KeyEntry]] = {}
        for student, path in files.items():
            with suppress(OSError, ValueError, KeyError, TypeError, AttributeError, RecursionError):
                data = json.loads(path.read_text("utf-8-sig"))
                parts = enumerate((data, *data.get("positions", ())), 1)
                each = [(at_position(one["text"], at), one) for at, part in parts for one in part["quantities"]]
                keys[student] = {text: KeyEntry(text, *(one[key] for key in _READ)) for text, one in each}
        every = {text: entry for entries in keys.values() for text, entry in entries.items()}
        self.students, self._columns = (*keys,), {text: k for k, text in enumerate(every)}
        self._table, shape = columns([*every.values()]), (len(keys), len(every))
        self._right, self._scatter, self._tolerance = (
            np.array([getattr(some.get(text), name, np.nan) for some in keys.values() for text in every]).reshape(shape)
            for name in ("right", "scatter", "tolerance")
        )

    def agreeing(self, marked: Marked) -> AnotherStudent | None:
        """The other student whose right values most of these numbers are, where those are not the own right ones.

        Numbers that are right by both problems say nothing. Of a large class one problem is always near: what random
        numbers, between the least and the largest of the class, meet as nearly is no hint.
        """
        some = [one for one in marked.judged if one.given is not None and one.unit_right and one.text in self._columns]
        which = np.array([self._columns[one.text] for one in some], dtype=int)
        given = np.array([[one.given for one in some]], dtype=float)
        off = np.abs(differences(columns_of(self._table, which), given, self._right[:, which]))
        agrees = off <= self._tolerance[:, which]
        own = np.array([one.verdict == "right" for one in some], dtype=bool)
        new = agrees & ~own
        enough = new.sum(axis=1) >= np.maximum(_FEWEST, _PART * (~(agrees & own)).sum(axis=1))
        others = [k for k in np.flatnonzero(enough) if self.students[k] != marked.student]
        if not others:
            return None
        z = np.where(new, np.maximum(off / self._scatter[:, which], _NEAREST), 0.0)
        best = min(others, key=lambda k: (-new[k].sum(), np.sum(z[k] ** 2)))
        every, n = np.concatenate([self._right[:, which], given])[:, new[best]], int(new[best].sum())
        cells = self._scatter[best, which][new[best]] / (np.nanmax(every, axis=0) - np.nanmin(every, axis=0))
        ball = (np.pi * np.sum(z[best] ** 2)) ** (n / 2) / math.gamma(n / 2 + 1)
        if len(self.students) * ball * np.prod(cells) > _CHANCE:
            return None
        return AnotherStudent(self.students[best], int(agrees[best].sum()), len(some))

"""What waits is looked at in order, and again only when it is called; rules come round as passes over all would have them."""

from __future__ import annotations

import random

from graphkin.base.worklist import Rounds, Waiting


def test_the_first_that_gives_anything_stays_first():
    waiting, given = Waiting(6), {4, 5}
    look = lambda number: number if number in given else None  # noqa: E731
    assert waiting.first(look) == waiting.first(look) == 4
    given |= {1, 2}
    assert waiting.first(look) == 4  # nobody called the others
    waiting.call([2, 5])
    assert waiting.first(look) == 2


def rules(seed: int) -> list[tuple[list[int], int, int]]:
    """Each wants some facts, and gives another with a number of its own."""
    rng = random.Random(seed)
    return [(rng.sample(range(12), rng.randint(0, 2)), rng.randrange(12), k) for k in range(20)]


def passes(every: list[tuple[list[int], int, int]]) -> dict[int, int]:
    """All rules again and again until nothing is new."""
    known: dict[int, int] = {}
    while True:
        before = len(known)
        for wants, gives, number in every:
            if all(want in known for want in wants):
                known.setdefault(gives, number)
        if len(known) == before:
            return known


def test_rounds_find_what_passes_over_all_rules_find():
    for seed in range(200):
        every, known = rules(seed), dict[int, int]()
        rounds = Rounds((wants, rule) for rule in every for wants in [rule[0]])
        for wants, gives, number in rounds:
            if gives not in known and all(want in known for want in wants):
                known[gives] = number
                rounds.call(gives)
        assert known == passes(every), seed

"""A design in words: numbered sentences with their numbers, its solutions, its linkage as a file."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from math import degrees

from graphkin.construction.drafting import Board, Drafting, Stage
from graphkin.errors import GraphkinError, Lang, NoDesign
from graphkin.model.mechanism import Mechanism
from graphkin.say.catalogue import LANGUAGES, in_both, say
from graphkin.say.figures import enough, figures, written
from graphkin.say.linkages import kind_name
from graphkin.say.numbers import SentenceNumber, sense
from graphkin.studies.design import Design, Reason, Solution, linkage_of
from graphkin.studies.linkages import filed, report

_DIGITS = 5  # as `Figure` has them


def sentences(construction: Drafting, board: Board, lang: Lang) -> list[str]:
    """One sentence a stage, with the numbers of the board."""
    numbers = {name: float(value.real) for name, value in board.numbers.items()}
    words: dict[str, object] = {name: SentenceNumber(value) for name, value in numbers.items()}
    for name, place in board.places.items():
        words |= {f"{name}_x": SentenceNumber(place.real * 1e3), f"{name}_y": SentenceNumber(place.imag * 1e3)}
    # the formulas of the sentences with their figures put in, of what there is on the board
    if "K" in numbers and "theta" in numbers:
        less, more, half_turn = figures(numbers["K"] - 1, numbers["K"] + 1, 180)
        ratio = written(half_turn * less / more, degrees(numbers["theta"]), _DIGITS)
        words["of_K"] = ratio.replace("180", "180°", 1)
    if {"AC1", "AC2", "a", "b"} <= numbers.keys():
        short, long = sorted(("AC1", "AC2"), key=numbers.__getitem__)
        one, other, two = figures(numbers[short] * 1e3, numbers[long] * 1e3, 2)
        halves = {"a": (other - one) / two, "b": (one + other) / two}
        count = max(enough(half, numbers[name] * 1e3, _DIGITS) for name, half in halves.items())
        words |= {short: one.text(count), long: other.text(count)}  # one length, one figure, wherever it stands
        words |= {"half_less": halves["a"].text(count), "half_more": halves["b"].text(count)}
    for link, divisor in (("a", "R1"), ("c", "R2")):
        if {link, divisor, "d"} <= numbers.keys():
            frame, by = figures(numbers["d"] * 1e3, numbers[divisor])
            words[f"of_{divisor}"] = written(frame / by, numbers[link] * 1e3, _DIGITS)
    stages = ((stage.say, _at_rocker(stage, board)) for stage in construction.stages)
    return [say(f"design.stage {key}", lang, which=at_rocker, **words) for key, at_rocker in stages]


def _at_rocker(stage: Stage, board: Board) -> bool:
    """True where a stage makes D, or makes no pivot and leans on D."""
    made = {step.name for step in stage.steps}
    return "D" in made or ("A" not in made and "D" in board.places)


def phrased(reason: Reason, lang: Lang) -> str:
    """A reason as a sentence."""
    words: dict[str, object] = {k: v if isinstance(v, str) else SentenceNumber(v) for k, v in reason.data}
    if "name" in words:
        words["name"] = say(f"design.name {words['name']}" if words["name"] else "design.name", lang)
    return say(f"design.reason {reason.key}", lang, **words)


def error(design: Design) -> NoDesign | None:
    """The error to raise where nothing was found; None where something was."""
    if design.solutions:
        return None
    reasons = [*(reason for one in design.rejected for reason in one.why), *design.why]
    in_english, in_chinese = ([phrased(reason, lang) for reason in reasons] for lang in LANGUAGES)
    return NoDesign((" ".join(in_english), " ".join(in_chinese)))


def lines(design: Design, lang: Lang = "en") -> list[str]:
    """The solution as a book writes it, then all solutions, what is none, and the family."""
    shown, best = [say(f"design.heading {design.kind}", lang)], design.best
    if best is not None:
        stages = enumerate(sentences(best.construction, best.board(), lang), start=1)
        shown += (f"({number}) {text}" for number, text in stages)
    for number, one in enumerate(design.solutions, start=1):
        key = "design.solution" if one.valid else "design.useless"
        shown += [say(key, lang, number=number) + _lengths(one, lang), *_judged(one, lang)]
    for one in design.rejected:
        shown.append(say("design.refused", lang) + _lengths(one, lang))
        shown += (f"  {phrased(reason, lang)}" for reason in one.why)
    if not design.solutions:
        shown.append(say("design.none", lang))
    shown += (phrased(reason, lang) for reason in design.why)
    for family in (family for family in design.families if len(family.angle)):
        open_arcs = [arc for arc in family.arcs if arc.name == "admissible"]
        ends = (map(SentenceNumber, (arc.start % math.tau, arc.end % math.tau)) for arc in open_arcs)
        arcs = say("common.list", lang).join(say("design.arcs", lang, start=start, end=end) for start, end in ends)
        sizes = (family.centre.real * 1e3, family.centre.imag * 1e3, family.radius, family.best[1])
        words = dict(zip(("x", "y", "radius", "best"), map(SentenceNumber, sizes), strict=True))
        axes = say(f"design.axes {design.kind}", lang)
        shown.append(say("design.family", lang, arcs=arcs, axes=axes, **words))
    return shown


def swing_letter(one: Solution) -> str:
    """The letter for all that the output turns through; ψ itself may be its direction."""
    return "Δψ" if "psi1" in one.construction.given else "ψ"


def _lengths(one: Solution, lang: Lang) -> str:
    """l_AB = 20.773 mm, l_BC = .. of those it has; a guide bar turns about C."""
    frame = "l_AC" if one.b is None and one.c is None else "l_AD"
    sizes = {"l_AB": one.a, "l_BC": one.b, "l_CD": one.c, frame: one.d, "e": one.e}
    lengths = (f"{name} = {SentenceNumber(size):mm}" for name, size in sizes.items() if size is not None)
    return say("common.and", lang).join(lengths)


def _faults(one: Solution, lang: Lang) -> list[str]:
    """Why it does not do."""
    return [say("design.invalid", lang) + phrased(reason, lang) for reason in one.why]


def _notes(one: Solution, lang: Lang) -> list[str]:
    return [phrased(reason, lang) for reason in one.notes if reason.key != "kind"]


def _slow(one: Solution, lang: Lang, key: str = "design.slow") -> list[str]:
    """The sense of the crank in the slow stroke of a quick-return design."""
    moving = "C" if one.shape != "guide-bar" else "B"
    return [] if one.pace is None else [say(key, lang, sense=sense(one.pace, lang), moving=moving)]


def judgement(one: Solution, lang: Lang) -> list[str]:
    """All that a drawing does not show: why it does not do, how the crank is to be turned, remarks."""
    return [*_faults(one, lang), *_slow(one, lang, "design.sheet slow"), *_notes(one, lang)]


def _judged(one: Solution, lang: Lang) -> Iterator[str]:
    yield from (f"  {fault}" for fault in _faults(one, lang))
    try:
        proof = report(linkage_of(one))  # by its lengths alone, without the drawing
    except GraphkinError as wrong:
        yield f"  {wrong.message(lang)}"
        return
    angles = {swing_letter(one): proof.swing, "θ": proof.theta, "γ_min": proof.gamma_min}
    facts = [kind_name(proof, lang)]
    facts += [f"{name} = {SentenceNumber(value):deg}" for name, value in angles.items() if value is not None]
    facts += [f"H = {SentenceNumber(proof.stroke):mm}"] if proof.stroke is not None else []
    facts += [f"K = {SentenceNumber(proof.k):n}"] if proof.k is not None else []
    facts += _slow(one, lang)
    yield f"  {say('design.proof', lang)}{say('common.and', lang).join(facts)}"
    yield from (f"  {note}" for note in _notes(one, lang))


def mechanism_of(solution: Solution, kind: str) -> Mechanism:
    """The linkage driven at AB with 1 rad/s as its positions follow each other, its file as its text. kind: of the
    design (`Design.kind`)."""
    machine = linkage_of(solution).mechanism(omega=solution.way)
    return filed(replace(machine, name="design", file="design.toml", title=in_both(f"design.title {kind}")))

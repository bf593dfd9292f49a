"""A problem in words: its data and its question, as the head of a solution has them; where its mechanism is drawn."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import islice

from graphkin.errors import Lang
from graphkin.model.mechanism import Mechanism
from graphkin.model.quantities.kinds import Rotation
from graphkin.running.drawn_sides import DrawnSides
from graphkin.say import names
from graphkin.say.catalogue import say
from graphkin.say.dimensions import drawn_value
from graphkin.say.entry import Entry, Sentence
from graphkin.say.numbers import side
from graphkin.say.problem_data import problem_data
from graphkin.say.reading import Reading
from graphkin.say.solution_goal import SolutionGoal

MADE = "-- graphkin problems"  # the last line of a text that this program wrote


def posed_entries(goal: SolutionGoal, drawn: DrawnSides | None = None) -> Iterator[Entry]:
    """A problem without its title: its story, the data, with the assembly it is `drawn` in and further positions, and
    the question."""
    reading = goal.reading
    yield from islice(problem_data(reading), 1, None)
    assembly = "" if drawn is None else assembly_sentence(drawn, reading.lang)
    yield from map(Sentence, filter(None, [assembly, *position_lines(reading)]))
    yield from goal.question()
    halves = (half for one in goal.wanted if one is not None for half in one.halves)
    thetas = {half.link: half for half in halves if isinstance(half, Rotation) and half.word == "theta"}
    lines = [_angle_line(goal, theta) for theta in thetas.values()]
    yield from map(Sentence, filter(None, lines))


def position_lines(reading: Reading) -> Iterator[str]:
    """All positions that are asked for, where there are further ones."""
    further, say = positions(reading.mechanism), reading.say
    yield from (say("problems.positions"),) if further else ()
    for at in range(further + 1) if further else ():
        shown = []  # `φ1 = 120°`, `s_ram = 25 mm`
        for k, driver in enumerate(reading.mechanism.drivers):
            also = 0 < at <= len(driver.also)
            value = driver.also[at - 1] if also else driver.value
            if value is not None:
                shown.append(drawn_value(reading, driver, value, () if also else ("driver", k)).text)
        yield f"#{at + 1}{say('common.colon')}{say('common.list').join(shown or [say('problems.as given')])}"


def positions(mechanism: Mechanism) -> int:
    """The number of further positions that are asked for."""
    return max((len(driver.also) for driver in mechanism.drivers), default=0)


def remarks(shared: Sequence[str], carried: Sequence[str], every: int, lang: Lang) -> Iterator[str]:
    """That of `every` student some have problems much alike, or in another assembly than the sketch means at their
    numbers."""
    for phrase, students in (("problems.shared", shared), ("problems.carried", carried)):
        if students:
            few = say("common.and", lang).join(students[:10]) + (" .." if len(students) > 10 else "")
            different = every - len(shared)
            yield say(phrase, lang, count=len(students), students=few, every=every, different=different)


def _angle_line(goal: SolutionGoal, angle: Rotation) -> str:
    """The line along which a link's angle is measured: from its first point to the next; of one point, its guide."""
    mechanism, symbol = goal.reading.mechanism, goal.symbol(angle)
    if (axis := mechanism.links[angle.link].axis) is not None:
        tail, head = map(names.point, axis)
        return goal.reading.say("problems.angle", angle=symbol, tail=tail, head=head)
    slide = next((slide for slide in mechanism.slides if angle.link in (slide.block, slide.guide)), None)
    if slide is None:
        return ""
    return goal.reading.say("problems.angle of guide", angle=symbol, guide=mechanism.called(slide.guide))


def assembly_sentence(sides: DrawnSides, lang: Lang) -> str:
    """`Assembly: C above BD.`, one side after another; nothing where there is no choice."""
    choices = []
    for lies in sides.lies:
        words = {"point": names.point(lies.point), "line": "".join(map(names.point, lies.line))}
        if lies.by_distance:
            choices.append(say("assembly.distance", lang, which=lies.to.real <= 0, **words))
        else:
            choices.append(say("derivation.side", lang, which=side(lies.to), **words))
    for point, place in sides.near:
        x, y = (f"{1000 * part + 0.0:.4g}" for part in (place.real, place.imag))
        choices.append(say("assembly.near", lang, point=names.point(point), x=x, y=y))
    joined = say("common.and", lang).join(dict.fromkeys(choices))
    return joined and say("assembly.drawn", lang, told=joined)

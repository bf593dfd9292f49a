"""The instant centres that are asked for, as a part of the solution: how each is found, with those it hangs on."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from graphkin.base.value import frozen
from graphkin.construction.drafting import Stage
from graphkin.model.quantities import Centre
from graphkin.say.centre_steps import CentreReader
from graphkin.say.entry import Entry
from graphkin.say.reading import Reading
from graphkin.studies.centres import centres
from graphkin.studies.centres.instant_centres import shortest


@frozen
class AskedCentres:
    """stages: those that lead to the centres asked for; together: the pairs of links asked for that have none."""

    reader: CentreReader
    stages: tuple[Stage, ...]
    together: tuple[tuple[str, str], ...]

    @property
    def from_velocities(self) -> bool:
        """Whether the velocities have to be there before."""
        return any(stage.say == "velocities" for stage in self.stages)

    def place(self, centre: Centre) -> str:
        """Where one of them lies."""
        found = self.reader.found
        if found.together(*centre.links):
            return self.reader.say("centres.by together")
        return self.reader.place(found.name(*centre.links))

    def entries(self, number: int) -> Iterator[Entry]:
        """The part of the solution with this number."""
        yield from self.reader.entries(self.stages, self.together, number)


def asked_centres(reading: Reading, wanted: Sequence[Centre]) -> AskedCentres:
    """How they are found at the position of a reading; read off the drawing where a ruler reads."""
    found = centres(reading.method, reading.ruler.right if reading.ruler else reading.plot)
    names = {found.name(*one.links) for one in wanted}
    together = tuple(pair for pair in found.centring.together if found.name(*pair) in names)
    found = replace(found, centring=shortest(found, names))
    return AskedCentres(CentreReader(found, reading.lang, reading.measured), found.centring.stages, together)

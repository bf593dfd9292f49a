"""Letters with what stands below and above them: how a label is cut before a medium sets it."""

from __future__ import annotations

from collections.abc import Iterator

from graphkin.base.value import frozen
from graphkin.sheet.lettering import Label, Run


@frozen
class Sign:
    """A run of letters, and the runs of its subscript and of what is raised."""

    base: Run | None
    low: tuple[Run, ...] = ()
    high: tuple[Run, ...] = ()

    @property
    def plain(self) -> str:
        """To be read aloud, or where nothing can be lowered: `a^k_B3B2`."""
        low, high = ("".join(run.text for run in runs) for runs in (self.low, self.high))
        base = self.base.text if self.base is not None else ""
        return base + (f"^{high}" if high else "") + (f"_{low}" if low else "")


def signs(label: Label) -> Iterator[Sign]:
    """Each letter with its scripts, and the text between."""
    base: Run | None = None
    low: tuple[Run, ...] = ()
    high: tuple[Run, ...] = ()
    for run in label:
        if run.place == "base":
            if base is not None and not low and not high and base.italic == run.italic:
                base = base._replace(text=base.text + run.text)
                continue
            if base is not None or low or high:
                yield Sign(base, low, high)
            base, low, high = run, (), ()
        elif run.place == "sub":
            low += (run,)
        else:
            high += (run,)
    if base is not None or low or high:
        yield Sign(base, low, high)

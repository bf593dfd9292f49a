"""The pages of a handout: what holds together, and where the pages turn so that least of them is left empty."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from graphkin.base.value import frozen
from graphkin.handouts import document
from graphkin.handouts.document import Block

_PAGE, _EARLY, _LATE, _BEYOND, _LONE, _OVER = 0.2, 0.01, 0.05, 0.2, 0.05, 3.0
# costs of a page, of a drawing before the end of its text or on the page after it, there with text of the next section
# before it, of a line alone, of no room
_LEAST = 0.18  # a last page has that much of its height, or more

_FOLLOWING = (document.FormulaLine, document.TermRows, document.HandoutTable, document.GridRoom, document.BlankLine)
"""They stay with what leads to them."""


@frozen
class PagePart:
    """Blocks that stay together; for a drawing, `of` is the first of the parts it belongs to, the last is before it."""

    blocks: tuple[Block, ...]
    of: int | None = None

    @property
    def heads(self) -> bool:
        """True where it begins with a heading."""
        return isinstance(self.blocks[0], document.HandoutHeading)


def page_parts(blocks: Sequence[Block]) -> list[PagePart]:
    """A heading stays with what it heads, a sentence with formulas, rows, boxes and blanks that it leads to, gridded
    paper with the equations before it; and all of a problem is together, from its title to the room for answers behind
    its figure."""
    parts: list[PagePart] = []
    first, leads = 0, False  # the first part of what the next drawing belongs to
    for k, block in enumerate(blocks):
        drawn_in = isinstance(blocks[min(k + 1, len(blocks) - 1)], document.GridRoom)
        follows = isinstance(block, _FOLLOWING) or (drawn_in and isinstance(blocks[k - 1], _FOLLOWING))
        if isinstance(block, document.HandoutPicture) and block.of_all:
            first = max(n for n, part in enumerate(parts) if getattr(part.blocks[0], "level", 2) == 1)
            parts[first:] = [PagePart((*(one for part in parts[first:] for one in part.blocks), block))]
        elif isinstance(block, document.HandoutPicture) and first < len(parts):
            parts.append(PagePart((block,), first))
            first = len(parts)
        elif first < len(parts) and (leads or follows):
            parts[-1] = PagePart((*parts[-1].blocks, block))
        else:
            first = len(parts) if isinstance(block, document.HandoutHeading) else first
            parts.append(PagePart((block,)))
        leads = _leads(block)
    return parts


def _leads(block: Block) -> bool:
    match block:
        case document.HandoutHeading() | document.NameLine() | document.HandoutPicture(of_all=True):
            return True
        case document.Paragraph(words):
            return "".join(run.text for run in words).endswith((":", "："))
        case _:
            return False


def pages(parts: Sequence[PagePart], heights: Sequence[float], room: float) -> list[list[int]]:
    """The parts of each page, by their numbers: those of least cost. A drawing stands on a page with some of what it
    belongs to, behind the last of that there; or it is the first on the page after.

    heights  of the parts, and `room` of a page, in one unit
    """
    belonging = {n: range(part.of, n) for n, part in enumerate(parts) if part.of is not None}
    # one that has no room beside any of what it belongs to has a page of its own
    belonging = {n: of for n, of in belonging.items() if min(heights[k] for k in of) + heights[n] <= room}
    drawings = {k: n for n, of in belonging.items() for k in of}
    texts = [k for k in range(len(parts)) if k not in belonging]
    if not texts:
        return []
    # by the text that a page begins with, the drawing of what goes on there if that is placed, and the one before it
    best: dict[tuple[int, int | None, int | None], tuple[float, list[list[int]]]] = {(0, None, None): (0.0, [])}
    for first in range(len(texts)):
        for start, (cost, before) in [each for each in best.items() if each[0][0] == first]:
            for page, key in _choices(texts, drawings, *start):
                end, placed, owed = key
                used = sum(heights[k] for k in page)
                if used > room and end > first + 1:
                    continue
                total = cost + _cost(used / room, end == len(texts))
                early = placed is not None and placed in page
                total += _EARLY * early + _LATE * (owed is not None)
                total += _BEYOND * (owed is not None and drawings.get(texts[end - 1]) != owed)
                total += _LONE * _lone([parts[k] for k in page], parts[texts[end]] if end < len(texts) else None)
                if key not in best or total < best[key][0]:
                    best[key] = total, [*before, page]
    return best[len(texts), None, None][1]


def _choices(
    texts: list[int], drawings: dict[int, int], first: int, placed: int | None, owed: int | None
) -> Iterator[tuple[list[int], tuple[int, int | None, int | None]]]:
    """The texts that a page may hold from one on, behind a drawing that is owed; and the drawing that is owed then."""
    begun: list[tuple[list[int], int, int | None]] = [([] if owed is None else [owed], first, None)]
    while begun:
        page, number, late = begun.pop()
        page, end, own = [*page, texts[number]], number + 1, drawings.get(texts[number])
        over = own is not None and end < len(texts) and drawings.get(texts[end]) == own
        if own is None or own == placed or over:
            going: list[tuple[list[int], int | None]] = [(page, late)]
            if over and own != placed and late is None:
                yield [*page, drawings[texts[number]]], (end, own, None)
        else:
            going = [([*page, drawings[texts[number]]], None), (page, own)] if late is None else []
        for each, waits in going:
            if end < len(texts):
                begun.append((each, end, waits))
            if waits is None or end < len(texts):
                yield each, (end, own if over and own == placed else None, waits)


def _lone(page: list[PagePart], after: PagePart | None) -> bool:
    """True of a page that begins with the last line of a section, or has but the first line of what goes on `after`."""
    texts = [part for part in page if part.of is None] or page
    first, last = texts[0], texts[-1]
    begins = not first.heads and len(first.blocks) == 1 and (texts[1].heads if len(texts) > 1 else False)
    return begins or (last.heads and len(last.blocks) == 2 and after is not None and not after.heads)


def _cost(used: float, last: bool) -> float:
    """The cost of a page that is filled so far; a last one may be empty, but for a few lines."""
    empty = max(0.0, 1 - used / _LEAST) if last else max(0.0, 1 - used) ** 2
    return _PAGE + empty + (_OVER if used > 1 else 0.0)

"""Labels as a page's scripts letter them."""

from __future__ import annotations

from graphkin.base.plain import Plain
from graphkin.outputs.typesetting import signs
from graphkin.sheet.lettering import Label


def signs_of(label: Label) -> list[list[Plain]]:
    """Each sign of a label: letters, whether they lean, what stands below and above."""
    every: list[list[Plain]] = []
    for sign in signs(label):
        base, low, high = ("".join(run.text for run in each) for each in sign.runs)
        leans = int(sign.base is not None and sign.base.italic)
        every.append([base, leans, low, high] if low or high else [base, leans] if leans else [base])
    return every

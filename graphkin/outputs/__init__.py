"""Sheets, sweeps, keys and marks as files: one module a format.

`svg` is the drawing file itself; a program can measure it (`graphkin.check`). `animation` uses it. Tables and
diagrams of quantities over the motion (`tables`, `diagram`) are written here, too.

How to add a format:
 1. a file with one function from a `Sheet` to its text or bytes: `sheet.paper` is the page, `sheet.marks` are painted
    on it in their order [mm, y down];
 2. a `match` over the kinds of marks that ends in `assert_never`, so that the type checker misses none;
 3. pens are in `sheet.paper.PENS`; `sheet.lettering.scripts` puts the runs of a label in their places, `typesetting`
    sets them in letters of other programs;
 4. its ending in `drawings.DRAWN` and a case of `drawings.content`: the commands offer what stands there;
 5. files are written through `files.beside`, with bytes by which graphkin knows its own.
"""

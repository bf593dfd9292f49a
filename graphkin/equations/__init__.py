"""The analytic methods written out for a mechanism as a textbook writes them: `document`, then a writer.

```
Method -> bodies, polygons, rolling   θ of every link, the closed vector polygons, what rolls (`model`)
       -> expressions                 sums of products of symbols with cos, sin, e^i: added, derived, evaluated
       -> dyads, positions, rates     closed forms: two rules, crosswise and squared, for every dyad
       -> matrices                    A ω = ω1 B, A α = −Ȧ ω + ω1 Ḃ
       -> complex_method, matrix_method -> Document -> text, html, tex
```

Source: Sun Huan, Theory of Machines, section 3-3, examples 3-5, 3-6 and 3-7.
"""

from __future__ import annotations

from graphkin.equations.document import By, Document
from graphkin.equations.text import write_text
from graphkin.equations.written import document

__all__ = ["By", "Document", "document", "write_text"]

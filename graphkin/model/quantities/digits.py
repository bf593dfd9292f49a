"""How many digits a figure has, wherever one is written: zeros at its end are kept, so that fewer digits are exact.

9.1 is 9.1; 9.1002 to four digits is 9.100.
"""

from __future__ import annotations

import math

_EXACT = 1e-9
"""A figure that is off by no more than this part is exact."""


def significant(value: float, digits: int) -> str:
    """So many digits as Python writes them, `1.200e-05`; fewer only of what is exact with fewer."""
    text = f"{value:.{digits}g}"
    if math.isfinite(value) and not math.isclose(float(text), value, rel_tol=_EXACT):
        text = f"{value:#.{digits}g}"
    mantissa, mark, exponent = text.partition("e")
    return mantissa.removesuffix(".") + mark + exponent

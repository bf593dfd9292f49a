"""What a user can get wrong, as data; the sentences stand here once, in both languages.

Every error says three things: where (file, line, key), what is wrong, what to do. Code raises
the data; only the edge (the command line, a notebook) asks for the words.

`base` has the classes all others come from; `files` is about the file as a whole, `keys` about keys and values, `shapes`
about a link's measures, `pairs` about sliding pairs, gears, rolling and cams, `drivers` about drivers and poses, `motion`
about assembly and movement, `singular` about the analysis, `marking`, `submissions` and `platforms` about homework, `asking` about what
is asked for, `finding` about conditions. A new error is a class in one of them, and a name in its `__all__`: this module
passes on all that those hold.
"""

from graphkin.errors import (
    asking,
    base,
    centring,
    design,
    drivers,
    files,
    finding,
    keys,
    linkages,
    marking,
    motion,
    pairs,
    platforms,
    shapes,
    singular,
    submissions,
)
from graphkin.errors.asking import *  # noqa: F403
from graphkin.errors.base import *  # noqa: F403
from graphkin.errors.centring import *  # noqa: F403
from graphkin.errors.design import *  # noqa: F403
from graphkin.errors.drivers import *  # noqa: F403
from graphkin.errors.files import *  # noqa: F403
from graphkin.errors.finding import *  # noqa: F403
from graphkin.errors.keys import *  # noqa: F403
from graphkin.errors.linkages import *  # noqa: F403
from graphkin.errors.marking import *  # noqa: F403
from graphkin.errors.motion import *  # noqa: F403
from graphkin.errors.pairs import *  # noqa: F403
from graphkin.errors.platforms import *  # noqa: F403
from graphkin.errors.shapes import *  # noqa: F403
from graphkin.errors.singular import *  # noqa: F403
from graphkin.errors.submissions import *  # noqa: F403

__all__: list[str] = []
__all__ += asking.__all__
__all__ += base.__all__
__all__ += centring.__all__
__all__ += design.__all__
__all__ += drivers.__all__
__all__ += files.__all__
__all__ += finding.__all__
__all__ += keys.__all__
__all__ += linkages.__all__
__all__ += marking.__all__
__all__ += motion.__all__
__all__ += pairs.__all__
__all__ += platforms.__all__
__all__ += shapes.__all__
__all__ += singular.__all__
__all__ += submissions.__all__

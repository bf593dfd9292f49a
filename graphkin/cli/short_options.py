"""Short options by their long names.

Before click takes `-o` for what it is, it looks for long options that are spelled nearly like it, which is slow.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import islice

import click


def spelled_out(command: click.Command, args: Sequence[str]) -> list[str]:
    """The words of a command line, short options by their long names; what is an option's value stays as it is."""
    options = {name: each for each in command.params if isinstance(each, click.Option) for name in each.opts}
    found: list[str] = []
    words = iter(args)
    for word in words:
        option = options.get(word)
        if option is None:
            found.append(word)
            if word == "--":
                break
            continue
        found.append(max(option.opts, key=len))
        found.extend(islice(words, 0 if option.is_flag or option.count else option.nargs))
    return [*found, *words]

"""NumPy calls, `multiply(r3, k7, r0)`, one an operation, as a Python function."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from typing import Any

import numpy as np

from graphkin.value import frozen

Watch = Callable[[np.ndarray], None]
"""Is shown what each risky operation gives."""


@frozen
class Instruction:
    """One call, and the register, row or part that it writes into."""

    call: str
    into: str
    risky: bool = False


@frozen
class Calls:
    """What is left of a tape.

    lines      calls in their order
    constants  numbers by their names in the calls
    rows, parts, given, registers  how many there are; the first `sines` rows are sines
    """

    lines: tuple[Instruction, ...]
    constants: Mapping[str, np.ndarray]
    rows: int
    sines: int
    parts: int
    given: int
    registers: int

    @cached_property
    def run(self) -> Callable[..., None]:
        """`run(given, rows, parts, registers)`: each as many arrays of one length, of the parts all x, all y, and
        the vectors; what is given may be scalars."""
        return self._made("", "")

    @cached_property
    def run_watched(self) -> Callable[..., None]:
        """`run_watched(given, rows, parts, registers, watch)`: the same; `Watch` sees what risky operations give."""
        return self._made(", watch", "; watch({})")

    def _made(self, watch: str, after: str) -> Callable[..., None]:
        body = [_unpacked("x", range(self.given), "given"), _unpacked("y", range(self.rows), "rows")]
        body += [_vectors(self.parts)]
        body += [_unpacked("r", range(self.registers), "registers")]
        body += [line.call + (after.format(line.into) if line.risky else "") for line in self.lines]
        functions = {line.call.partition("(")[0] for line in self.lines}
        names: dict[str, Any] = {name: getattr(np, name) for name in functions} | dict(self.constants)
        exec(f"def run(given, rows, parts, registers{watch}):\n " + "\n ".join(body), names)
        made: Callable[..., None] = names["run"]
        return made


def _unpacked(letter: str, numbers: Sequence[int], name: str) -> str:
    return "".join(f"{letter}{k}," for k in numbers) + f" = {name}" if numbers else "pass"


def _vectors(parts: int) -> str:
    names = [f"v{k}" for k in (*range(0, parts, 2), *range(1, parts, 2))] + [f"w{k}" for k in range(parts // 2)]
    return ", ".join(names) + " = parts" if names else "pass"

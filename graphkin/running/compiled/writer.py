"""A tape written out as calls: registers dealt out, and signs carried along, so that hardly a call only turns one."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np

from graphkin.running.compiled.calls import Calls, Instruction
from graphkin.running.compiled.needed import DIVIDE, WHOLE, Whole, needed
from graphkin.running.compiled.operations import GIVEN, NUMBER, RISKY, SIDE, Operation
from graphkin.running.compiled.signs import AS_THEY_ARE, wished
from graphkin.running.compiled.tape import Signed, Tape
from graphkin.running.compiled.vectors import made_of_others

Operand = tuple[str, int, float | None]
"""A name, the sign with which what is meant lies there, and the number that it is."""
ODD, EVEN = ("rint", "sign", "sin", "tan"), ("absolute", "cos")
"""What turns its sign with that of its operand, and what does not."""
SLOW_APART = ("arctan2",)
"""What is much slower with numbers that do not lie side by side."""


def written_out(tape: Tape, given: int, sines: int, shown: Sequence[Signed], parts: Sequence[Signed] = ()) -> Calls:
    """Of the operations those that are shown, or parts of vectors, those they are made of, and those that may fail; the
    rest is left out. The first `sines` of those that are shown are sines."""
    writer = _Writer(tape, shown, parts)
    return Calls(tuple(writer.lines), writer.constants, len(shown), sines, len(parts), given, writer.registers)


class _Writer:
    """Writes calls, and deals out registers: one is free again after the last call that needs what is in it.

    asked  into which rows and parts a place goes, with their signs
    held   where it lies that was worked out, and with which sign
    """

    def __init__(self, tape: Tape, shown: Sequence[Signed], parts: Sequence[Signed]) -> None:
        self.tape = tape
        # NumPy takes an array of no dimensions quicker than a float
        self.constants: dict[str, np.ndarray] = {}
        self.named: dict[str, str] = {}
        self.lines: list[Instruction] = []
        self.free: list[str] = []
        self.registers = 0
        self.held: dict[int, tuple[str, int]] = {}
        self.asked: dict[int, list[tuple[str, int]]] = {}
        for letter, results in (("y", shown), ("v", parts)):
            for number, (place, sign) in enumerate(results):
                self.asked.setdefault(place, []).append((f"{letter}{number}", sign))
        pairs = [*zip(parts[::2], parts[1::2])]
        self.made = {each.number: each for each in made_of_others(tape, pairs)}
        self.operations = self._ordered()
        slow = [each for each in self.operations.values() if each.does in SLOW_APART]
        of_slow = {tape.unsigned(of)[0] for each in slow for of in each.of}
        self.at_once = {place: asked[0] for place, asked in self.asked.items() if place not in of_slow}
        self.signs = wished(tape, self.operations, {place: sign for place, (_, sign) in self.at_once.items()})
        self.last = {tape.unsigned(of)[0]: place for place, each in self.operations.items() for of in each.of}
        for place, operation in self.operations.items():
            self._write(place, operation)
        for place in self.asked.keys() - self.held.keys():
            self._lay(place, self.asked[place])

    def _ordered(self) -> dict[int, Operation]:
        """What is to be done; a vector of which a part is needed before its other part is known is not made whole."""
        wholes: dict[int, Whole] = {}
        for each in self.made.values():
            if wholes.keys().isdisjoint(each.twins):
                wholes |= dict.fromkeys(each.twins, Whole(each.twins[1], Operation(WHOLE, each.of, each.number)))
        while True:
            found = needed(self.tape, self.asked, wholes)
            used = [(self.tape.unsigned(of)[0], place) for place, each in found.items() for of in each.of]
            early = {wholes[of].at for of, place in used if of in wholes and place < wholes[of].at}
            if not early:
                return found
            wholes = {place: whole for place, whole in wholes.items() if whole.at not in early}

    def _write_whole(self, number: int) -> None:
        """Into its own room, and where else its parts are shown."""
        made, into = self.made[number], f"w{number}"
        ratio, first = self._constant(made.ratio), f"w{made.first}"
        if made.second is None:
            self._call("multiply", [ratio, first], into)
        else:
            self._call("subtract", [f"w{made.second}", first], into)
            self._call("multiply", [ratio, into], into)
            self._call("add", [first, into], into)
        for name, place in zip((f"v{2 * number}", f"v{2 * number + 1}"), made.places):
            sign = next(sign for asked, sign in self.asked[place] if asked == name)
            self.held[place] = name, sign
            self._lay(place, [other for other in self.asked[place] if other[0] != name])

    def _write(self, place: int, operation: Operation) -> None:
        does, of, number = operation
        if does == WHOLE:
            self._write_whole(int(number))
            self.free += {self.held[each][0] for each in of if self.held[each][0][0] == "r" and self._ends(each, place)}
            return
        operands = [self._operand(each) for each in of]
        ending = {name for each, (name, *_) in zip(of, operands) if name[0] == "r" and self._ends(each, place)}
        if does in AS_THEY_ARE:
            unlike = operands[does == "arctan2" :]
            turned = {name: self._turned(name) for name, sign, _ in unlike if sign < 0}
            operands[does == "arctan2" :] = [(turned.get(name, name), 1, number) for name, _, number in unlike]
            ending |= {*turned.values()}
        self.free += ending
        others = self.asked.get(place, [])
        if place in self.at_once:
            (into, sign), *others = others
        else:
            into, sign = self._register(), self.signs[place]
        found = self._called(does, operands, into, sign)
        if found != sign and into[0] != "r":
            self._call("negative", [into], into)
            found = sign
        self.held[place] = into, found
        self._lay(place, others)
        if place not in self.last and into[0] == "r":
            self.free.append(into)

    def _ends(self, of: int, place: int) -> bool:
        return self.last[self.tape.unsigned(of)[0]] == place

    def _lay(self, place: int, others: Iterable[tuple[str, int]]) -> None:
        """Where else it is shown, while it is still in the cache."""
        name, found, _ = self._operand(place)
        for into, sign in others:
            self._call("positive" if sign == found else "negative", [name], into)

    def _call(self, does: str, operands: Sequence[str], into: str, risky: bool = False) -> None:
        self.lines.append(Instruction(f"{does}({', '.join(operands)}, {into})", into, risky))

    # --- one operation ------------------------------------------------------------------------

    def _called(self, does: str, operands: Sequence[Operand], into: str, wanted: int) -> int:
        """Write it; the sign with which it lies there: the one that is wanted, where that takes no call more."""
        match does:
            case "add" | "subtract":
                (one, sign, number), (other, second, more) = operands
                return self._sum((one, sign, number), (other, second if does == "add" else -second, more), into, wanted)
            case "multiply":
                return self._product(operands[0], operands[1], into, wanted)
            case "reciprocal":  # NumPy's own is not vectorised
                return self._quotient((self._constant(1.0), 1, 1.0), operands[0], into, wanted)
            case _ if does == DIVIDE:
                return self._quotient(operands[0], operands[1], into, wanted)
            case "arctan2":
                self._call(does, [name for name, *_ in operands], into)
                return operands[0][1]
            case _ if does in ODD or does in EVEN:
                self._call(does, [operands[0][0]], into)
                return operands[0][1] if does in ODD else 1
            case _:
                into = f"out={into}" if does == "maximum" else into  # the others take it quicker by place
                self._call(does, [name for name, *_ in operands], into, does in RISKY)
                return 1

    def _sum(self, a: Operand, b: Operand, into: str, wanted: int) -> int:
        (one, sign, number), (other, second, more) = a, b
        if sign == second != wanted and number is not None:
            one, sign = self._constant(-number), -sign
        elif sign == second != wanted and more is not None:
            other, second = self._constant(-more), -second
        if sign == second:
            self._call("add", [one, other], into)
            return sign
        self._call("subtract", [one, other] if sign == wanted else [other, one], into)
        return wanted

    def _product(self, a: Operand, b: Operand, into: str, wanted: int) -> int:
        for (_, sign, number), (other, second, _) in ((a, b), (b, a)):
            if number is not None:
                self._call("multiply", [self._constant(number * sign * second * wanted), other], into)
                return wanted
        if a[0] == b[0]:
            self._call("square", [a[0]], into)
        else:
            self._call("multiply", [a[0], b[0]], into)
        return a[1] * b[1]

    def _quotient(self, a: Operand, by: Operand, into: str, wanted: int) -> int:
        (name, sign, number), (other, second, _) = a, by
        if number is not None:
            name, sign = self._constant(number * sign * second * wanted), second * wanted
        self._call("divide", [name, other], into, True)
        return sign * second

    # --- operands -----------------------------------------------------------------------------

    def _operand(self, place: int) -> Operand:
        place, sign = self.tape.unsigned(place)
        does, _, number = self.tape.operations[place]
        if does == NUMBER:
            return self._constant(number), sign, number
        if does in (GIVEN, SIDE):
            return f"x{int(number)}", sign, None
        name, found = self.held[place]
        return name, sign * found, None

    def _turned(self, name: str) -> str:
        """The negative in another register."""
        into = self._register()
        self._call("negative", [name], into)
        return into

    def _constant(self, number: complex) -> str:
        name = self.named.setdefault(repr(number), f"k{len(self.named)}")
        self.constants[name] = np.array(number)
        return name

    def _register(self) -> str:
        if self.free:
            return self.free.pop()
        self.registers += 1
        return f"r{self.registers - 1}"

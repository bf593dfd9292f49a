"""From sums to formulas: what is put first, how angles are called, what is taken out of brackets."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from heapq import heapify, heappop, heappush

from graphkin.base.value import frozen
from graphkin.equations.expressions import Sum, SymbolProduct, Wave
from graphkin.equations.layout import Call, Exp, Frac, Letter, Minus, Node, Num, Op, Paren, Pow, Row, Word
from graphkin.equations.symbols import AngleSum, Symbol

ZERO = Num("0")


@frozen
class Pretty:
    """Writes sums; `alias` names angles fixed to one another (θ2 for θ3 + γ)."""

    alias: Mapping[Symbol, AngleSum]

    def sum(self, of: Sum, ordered: bool = False) -> Node:
        """Terms with their signs, a positive one first where there is one (not where they stand `ordered`)."""
        if not of.terms:
            return ZERO
        first = 0 if ordered else next((k for k, term in enumerate(of.terms) if term.factor > 0), 0)
        terms = (of.terms[first], *of.terms[:first], *of.terms[first + 1 :])
        return added([(term.factor < 0, self._product(term)) for term in terms])

    def factored(self, of: Sum) -> Node:
        """What all terms share, before a bracket."""
        common = _common(of.terms)
        if len(of.terms) < 2 or common is None:
            return self.sum(of)
        inner = Sum(tuple(_without(term, common) for term in of.terms))
        if all(term.factor < 0 for term in inner.terms):
            return Minus(Row((self._product(common), Paren(self.sum(-inner)))))
        return Row((self._product(common), Paren(self.sum(inner))))

    def grouped(self, of: Sum) -> Node:
        """Terms of one rate together, as in (3-19): ω2 (a sin θ2 + b cos θ2)."""
        groups: dict[tuple[tuple[Symbol, int], ...], list[SymbolProduct]] = {}
        for term in of.terms:
            rates = tuple(part for part in term.symbols if part[0].kind in ("rate", "push"))
            groups.setdefault(rates, []).append(term)
        found: list[tuple[bool, Node]] = []
        for rates, terms in groups.items():
            if not rates or len(terms) == 1:
                found += [(term.factor < 0, self._product(term)) for term in terms]
                continue
            minus = all(term.factor < 0 for term in terms)
            inner = Sum(tuple(_without(term, SymbolProduct(-1.0 if minus else 1.0, rates)) for term in terms))
            found.append((minus, Row((self._product(SymbolProduct(1.0, rates)), Paren(self.sum(inner))))))
        return added(sorted(found, key=lambda part: part[0])) if found else ZERO

    def quotient(self, top: Sum, bottom: Sum) -> Node:
        """top / bottom; signs above, nothing below where it is 1."""
        if bottom.terms and bottom.terms[0].factor < 0:
            top, bottom = -top, -bottom
        if bottom == Sum((SymbolProduct(1.0),)):
            return self.sum(top)
        if top.terms and all(term.factor < 0 for term in top.terms):
            return Minus(Frac(self.factored(-top), self.factored(bottom)))
        if not top.terms:
            return ZERO
        return Frac(self.factored(top), self.factored(bottom))

    def angle(self, of: AngleSum) -> Node:
        parts = sorted(self._called(of), key=lambda part: part[1] < 0)
        quarters = of.quarters - sum(n * self.alias[s].quarters for s, n in parts if s in self.alias)
        found = [(count < 0, _times(abs(count), Letter(symbol))) for symbol, count in parts]
        if quarters % 4:
            found.append((False, Num(f"{quarters % 4 * 90}°")))
        return added(found) if found else ZERO

    def _called(self, of: AngleSum) -> list[tuple[Symbol, int]]:
        counts, last = dict(of.parts), -1
        waiting = [k for symbol in counts for k in self._naming.get(symbol, ())]
        heapify(waiting)
        while waiting:
            if (at := heappop(waiting)) == last:
                continue
            (name, meaning), last = self._longest_first[at], at
            times = {counts.get(symbol, 0) * sign for symbol, sign in meaning.parts if abs(sign) == 1}
            if len(times) == 1 and times != {0} and len(meaning.parts) > 1:
                count = times.pop()
                for symbol, sign in meaning.parts:
                    counts[symbol] -= count * sign
                counts[name] = count
                for later in self._naming.get(name, ()):
                    heappush(waiting, max(later, last))
        return [(symbol, count) for symbol, count in counts.items() if count]

    @cached_property
    def _naming(self) -> dict[Symbol, list[int]]:
        """By symbol, which of the names below stand for a sum with it."""
        naming: dict[Symbol, list[int]] = {}
        for k, (_, meaning) in enumerate(self._longest_first):
            for symbol, _ in meaning.parts:
                naming.setdefault(symbol, []).append(k)
        return naming

    @cached_property
    def _longest_first(self) -> list[tuple[Symbol, AngleSum]]:
        """What a long sum is called, before what a part of it is."""
        return sorted(self.alias.items(), key=lambda each: -len(each[1].parts))

    def _product(self, term: SymbolProduct) -> Node:
        """A term without its sign."""
        size, items = abs(term.factor), list[Node]()
        items += [Word("i")] if term.turns else []
        items += [_powered(Letter(symbol), power) for symbol, power in term.symbols]
        for wave in dict.fromkeys(term.waves):
            items.append(self._wave(wave, term.waves.count(wave)))
        if size != 1 or not items:
            items.insert(0, Num(f"{size:.12g}"))
        return items[0] if len(items) == 1 else Row(tuple(items))

    def _wave(self, wave: Wave, power: int) -> Node:
        angle = self.angle(wave.angle)
        if wave.kind == "exp":
            return Exp(Row((Word("i"), angle if isinstance(angle, Letter) else Paren(angle))))
        return _powered(Call(wave.kind, (angle,)), power)


def _powered(node: Node, power: int) -> Node:
    return node if power == 1 else Pow(node, power)


def _times(count: int, node: Node) -> Node:
    return node if count == 1 else Row((Num(str(count)), node))


def added(terms: Sequence[tuple[bool, Node]]) -> Node:
    """Nodes with their signs (True: minus)."""
    items: list[Node] = []
    for minus, node in terms:
        if items:
            items.append(Op("−" if minus else "+"))
            items.append(node)
        else:
            items.append(Minus(node) if minus else node)
    return items[0] if len(items) == 1 else Row(tuple(items))


def bracketed(node: Node) -> Node:
    """In brackets where it is a sum."""
    summed = isinstance(node, Minus) or (isinstance(node, Row) and any(isinstance(item, Op) for item in node.items))
    return Paren(node) if summed else node


def _common(terms: Sequence[SymbolProduct]) -> SymbolProduct | None:
    """The number and the symbols that stand in all terms."""
    if not terms:
        return None
    sizes = {abs(term.factor) for term in terms}
    powers = {s: min(dict(term.symbols).get(s, 0) for term in terms) for s, _ in terms[0].symbols}
    shared = tuple((symbol, power) for symbol, power in powers.items() if power)
    size = sizes.pop() if len(sizes) == 1 else 1.0
    return SymbolProduct(size, shared) if shared or size != 1.0 else None


def _without(term: SymbolProduct, common: SymbolProduct) -> SymbolProduct:
    taken = dict(common.symbols)
    left = ((symbol, power - taken.get(symbol, 0)) for symbol, power in term.symbols)
    return replace(term, factor=term.factor / common.factor, symbols=tuple((s, p) for s, p in left if p))

"""From sums to formulas: the order of terms, the names of angles, the factors before brackets."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from heapq import heapify, heappop, heappush

from graphkin.base.value import frozen
from graphkin.equations.expressions import ONE, AngleSum, Sum, Symbol, SymbolProduct
from graphkin.equations.formulas import ZERO, Call, Exp, Frac, Letter, Minus, Node, Num, Op, Paren, Pow, Row, Word


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
        """All that the terms share, number and symbols, before a bracket."""
        if len(of.terms) < 2:
            return self.sum(of)
        sizes = {abs(term.factor) for term in of.terms}
        shared = _shared(of.terms)
        common = SymbolProduct(sizes.pop() if len(sizes) == 1 else 1.0, shared)
        if not shared and common.factor == 1.0:
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
        nodes: list[tuple[bool, Node]] = []
        for rates, terms in groups.items():
            if not rates or len(terms) == 1:
                nodes += [(term.factor < 0, self._product(term)) for term in terms]
                continue
            minus = all(term.factor < 0 for term in terms)
            inner = Sum(tuple(_without(term, SymbolProduct(-1.0 if minus else 1.0, rates)) for term in terms))
            nodes.append((minus, Row((self._product(SymbolProduct(1.0, rates)), Paren(self.sum(inner))))))
        return added(sorted(nodes, key=lambda part: part[0])) if nodes else ZERO

    def quotient(self, top: Sum, bottom: Sum) -> Node:
        """top / bottom; signs above, nothing below where it is 1."""
        if bottom.terms and bottom.terms[0].factor < 0:
            top, bottom = -top, -bottom
        if bottom == ONE:
            return self.sum(top)
        if not top.terms:
            return ZERO
        if common := _shared((*top.terms, *bottom.terms)):
            divisor = SymbolProduct(1.0, common)
            return self.quotient(*(Sum(tuple(_without(term, divisor) for term in of.terms)) for of in (top, bottom)))
        if all(term.factor < 0 for term in top.terms):
            return Minus(Frac(self.factored(-top), self.factored(bottom)))
        return Frac(self.factored(top), self.factored(bottom))

    def angle(self, of: AngleSum) -> Node:
        """A sum of angles by their names, positive ones first."""
        parts = sorted(self._renamed(of), key=lambda part: part[1] < 0)
        quarters = of.quarters - sum(n * self.alias[s].quarters for s, n in parts if s in self.alias)
        nodes: list[tuple[bool, Node]] = []
        for symbol, count in parts:
            letter = Letter(symbol)
            nodes.append((count < 0, letter if abs(count) == 1 else Row((Num(str(abs(count))), letter))))
        if quarters % 4:
            nodes.append((False, Num(f"{quarters % 4 * 90}°")))
        return added(nodes) if nodes else ZERO

    def _renamed(self, of: AngleSum) -> list[tuple[Symbol, int]]:
        """Its symbols, sums that have a name of their own replaced by it, the longest first."""
        counts, last, (longest_first, naming) = dict(of.parts), -1, self._names
        queue = [k for symbol in counts for k in naming.get(symbol, ())]
        heapify(queue)
        while queue:
            if (at := heappop(queue)) == last:
                continue
            (name, meaning), last = longest_first[at], at
            times = {counts.get(symbol, 0) * sign for symbol, sign in meaning.parts if abs(sign) == 1}
            if len(times) == 1 and times != {0} and len(meaning.parts) > 1:
                count = times.pop()
                for symbol, sign in meaning.parts:
                    counts[symbol] -= count * sign
                counts[name] = count
                for later in naming.get(name, ()):
                    heappush(queue, max(later, last))
        return [(symbol, count) for symbol, count in counts.items() if count]

    @cached_property
    def _names(self) -> tuple[list[tuple[Symbol, AngleSum]], dict[Symbol, list[int]]]:
        """The names of sums, long ones first; and by symbol the numbers of those in which it stands."""
        longest_first = sorted(self.alias.items(), key=lambda each: -len(each[1].parts))
        naming: dict[Symbol, list[int]] = {}
        for k, (_, meaning) in enumerate(longest_first):
            for symbol, _ in meaning.parts:
                naming.setdefault(symbol, []).append(k)
        return longest_first, naming

    def _product(self, term: SymbolProduct) -> Node:
        """A term without its sign."""
        size, items = abs(term.factor), list[Node]()
        items += [Word("i")] if term.turns else []
        items += [Letter(symbol) if power == 1 else Pow(Letter(symbol), power) for symbol, power in term.symbols]
        for wave in dict.fromkeys(term.waves):
            power = term.waves.count(wave)
            angle = self.angle(wave.angle)
            if wave.kind == "exp":
                items.append(Exp(Row((Word("i"), angle if isinstance(angle, Letter) else Paren(angle)))))
            else:
                call = Call(wave.kind, (angle,))
                items.append(call if power == 1 else Pow(call, power))
        if size != 1 or not items:
            items.insert(0, Num(f"{size:.12g}"))
        return items[0] if len(items) == 1 else Row(tuple(items))


def _shared(terms: Sequence[SymbolProduct]) -> tuple[tuple[Symbol, int], ...]:
    """The symbols that all of these have, with their powers."""
    powers = {symbol: min(dict(term.symbols).get(symbol, 0) for term in terms) for symbol, _ in terms[0].symbols}
    return tuple((symbol, power) for symbol, power in powers.items() if power)


def added(terms: Sequence[tuple[bool, Node]]) -> Node:
    """Nodes with their signs (True: minus)."""
    (minus, first), *rest = terms
    items: list[Node] = [Minus(first) if minus else first]
    for minus, node in rest:
        items += [Op("−" if minus else "+"), node]
    return items[0] if len(items) == 1 else Row(tuple(items))


def bracketed(node: Node) -> Node:
    """In brackets where it is a sum."""
    summed = isinstance(node, Minus) or (isinstance(node, Row) and any(isinstance(item, Op) for item in node.items))
    return Paren(node) if summed else node


def _without(term: SymbolProduct, common: SymbolProduct) -> SymbolProduct:
    powers = dict(common.symbols)
    left = ((symbol, power - powers.get(symbol, 0)) for symbol, power in term.symbols)
    return replace(term, factor=term.factor / common.factor, symbols=tuple((s, p) for s, p in left if p))

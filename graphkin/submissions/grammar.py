"""Answers as students write them, taken apart by a small grammar: nothing is guessed.

A text becomes tokens, each with a code of one letter; the forms of an answer are patterns over these codes:

    n number   u unit    s sign   g sign in brackets   p ±   t ~: about, or to   a ∠, `angle`   e =, :   l `is`
    c sense    d direction in a word or an arrow       i j unit vectors   k name of a quantity   ( ) brackets
    ; between clauses   z what makes an answer doubtful
    x not known: where it may stand, in a remark in brackets or before an e, it says nothing

Words that say nothing have no token. All others must be understood: one number, and a second only where it says the
same, is a direction, or is by what the first may err.
"""

from __future__ import annotations

import cmath
import math
import re
from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import NamedTuple

from graphkin.errors import NOWHERE, GraphkinError, NotAnAnswer, OtherDimension, SenseDisputed
from graphkin.files.values import DIMENSIONS, read_quantity
from graphkin.model.mechanism import Dimension
from graphkin.submissions import numbers
from graphkin.submissions.numbers import LONGEST, Number, in_si, plain, unit_named
from graphkin.submissions.submission import HandedValue, Sense

_SENSES: Mapping[float, Sense | None] = {1: "ccw", 0: None, -1: "cw"}
WORDS = math.radians(60)
"""A direction in words holds within this angle on either side."""


class Token(NamedTuple):
    """number: of a sign or a sense 1 or -1"""

    code: str
    text: str = ""
    number: float = 1.0
    way: complex = 0j


class Amount(NamedTuple):
    """A number, its unit as it is typed, its sign: 0 where none is written."""

    size: float
    unit: str
    sign: float = 0.0

    @property
    def number(self) -> Number:
        return (self.sign or 1) * self.size, self.unit


# --- tokens ------------------------------------------------------------------------------------

_ATOM = (
    rf"(?:{'|'.join(numbers.ATOMS.values())}|r|%)"
    r"(?: ?(?:\^|\*\*) ?(?:\([+-]?[1-3]\)|[+-]?[1-3])|[+-]?[1-3](?![0-9.,]*[0-9])| ?squared|的?平方|²)?"
)
_PER = "每(?:二次方|平方)?"
_FACTOR = rf"(?:{_ATOM}|\({_ATOM}(?: ?[*/] ?{_ATOM})*\))"
_UNIT = rf"(?:/ ?|per |{_PER})?{_ATOM}(?:(?: ?[*/.] ?| ?per ?|{_PER}| ?(?=s\^?\(?-)){_FACTOR})*(?![a-z_'])"
_ANGLES = re.compile(f"{numbers.ATOMS['deg']}|{numbers.ATOMS['rad']}")
_UP, _SIDE = r"(?:up(?:per)?|top|down|low(?:er)?|bottom)(?:wards?)?", r"(?:left|right)(?:wards?)?"
_AND = r"(?: ?[-/& ] ?|,? ?and (?:to the )?)?"
_WAYS: dict[str, complex] = {
    "左": -1, "右": 1, "上": 1j, "下": -1j, "left": -1, "right": 1, "up": 1j, "top": 1j, "down": -1j, "low": -1j,
    "bottom": -1j, "←": -1, "<-": -1, "→": 1, "->": 1, "↑": 1j, "↓": -1j, "↖": 1j - 1, "↗": 1j + 1, "↘": 1 - 1j,
    "↙": -1 - 1j, "+x": 1, "-x": -1, "+y": 1j, "-y": -1j, "positivex": 1, "negativex": -1, "positivey": 1j,
    "negativey": -1j, "x正": 1, "x负": -1, "y正": 1j, "y负": -1j,
}  # fmt: skip
_WAY = re.compile("|".join(map(re.escape, _WAYS)))

_LEXICON = (  # a code, its sign after it; of two that begin alike the longer one first
    ("u", rf"1 ?/ ?{_FACTOR}(?![a-z])"), ("n", numbers.NUMBER),
    ("", rf" +|or so|左右|上下|in(?={numbers.WHERE})"
         r"|(?:from|to|wrt|with respect to|relative to|与|从|自|相对于?) ?(?:the )?(?:x ?轴的?正方?向"
         r"|(?:\+ ?|positive )?x(?:[- ]?axis)?(?: direction)?(?![a-z轴]))"),
    ("d", r"(?:along |in )?(?:the )?(?:[+-]|negative|positive) ?[xy](?:[- ]?axis|轴)?(?: direction|方向)?"
          r"(?![a-z0-9_]| *[=:])|沿?[xy] ?轴?的?[正负]方?向"),
    ("z", r"from [a-z][0-9']* to|towards? [a-z](?![a-z])|along|perpendicular|parallel|[⊥∥]|//|平行|垂直(?![向朝纸])"
          r"|[沿指由从][向着]? ?[a-z]|[a-z][0-9']* ?(?:->|→) ?[a-z]|(?:->|→) ?(?=[-+.0-9])|same|同[向样]|一致"),
    ("g+", r"\( ?\+ ?\)"), ("g-", r"\( ?- ?\)"), ("p", r"±|\+ ?/ ?-|\+-|plus or minus"),
    ("c+", r"(?:counter|anti)[- ]?clock[- ]?wise|(?:ccw|acw)(?![a-z])|(?:c\.c\.|a\.c\.)w\.?|[逆反][时時][针針钟鐘]|逆"
           r"|[↺⟲🔄⊙]|out of (?:the )?(?:page|paper)|(?:垂直)?纸面向外"),
    ("c-", r"clock[- ]?wise|cw(?![a-z])|c\.w\.?|[顺順][时時][针針钟鐘]|[顺順]|[↻⟳🔃⊗]|into (?:the )?(?:page|paper)"
           r"|(?:垂直)?纸面向[里内]"),
    ("z", r"quadrant|象限|偏|below|above|以[上下内外]|大于|小于|超过|相反|反[向转]|正转|opposite|wrong|错|作废"
          r"|[或非不未?]|(?:not?|or)(?![a-z])"),
    ("x", r"[下上左右如见][图面表]"),
    ("", r"about|approx(?:imately|\.)?|ca\.|(?:ca|mag|ans|so|it|the|of|dir|to)(?![a-z])|circa|roughly|around|nearly"
         r"|almost|est\.|magnitude|size|value|speed|answer|final|result|hence|therefore|(?:an?|and|with)(?= )|towards?"
         r"|pointing|directed|direction|signs?|sense|rotat(?:ion|ing|es)|turn(?:ing|s)|units?|side|measured|velocity"
         r"|(?:horizontal|vertical)(?:ly)?|acceleration|角?加?速度|大?约(?:为|等于)?|大概|近似|大小|数值|值|结果|答案?"
         r"|[解求测量]?得到?|估[计读算]|计算|读数|测量|由图|[故即且沿取以设的号其]|i\.e\.|所以|因此|规定|单位|方向(?!角)"
         r"|转向|旋向|指向|[朝往向方边侧斜](?!向角)|水平|竖直|铅[垂直]|垂直(?=向|朝)|转动|旋转|∴|[.!](?= |$)"
         r"|(?<=[针鐘钟向顺逆])转(?!角)"),
    ("a", r"∠|∡|@|/_|(?:at|arg)(?![a-z])|方向角|夹角|角度|angle|[θφϑϕ][0-9a-z_']*|<(?= ?[+-]?[0-9.]+ ?(?:°|deg))"),
    ("l", r"[为是记]|(?:is|are|as|means?)(?![a-z])|等于|equals?|表示|代表|taken|because|since"),
    ("u", f"{_UNIT}|°"), ("s-", r"负[号数向]?|minus|negative|neg(?![a-z])|-ve|-(?!>)"),
    ("s+", r"正[号数]?|plus|positive|pos(?![a-z])|\+ve|\+"),
    ("d", rf"(?:{_UP}{_AND}{_SIDE}|{_SIDE}{_AND}{_UP}|{_UP}|{_SIDE})(?![a-z])|[左右上下←→↑↓↖↗↘↙]|->|<-$"),
    (";", "=>|[,;、⇒\n]"), ("e", "[=:]"), ("(", r"[(\[]"), (")", r"[)\]]"), ("t", "~"), ("i", "i(?![a-z0-9])"),
    ("j", "j(?![a-z0-9])"), ("k", r"[α-ω][0-9a-z_.'^]*|[a-z]+[_^'0-9][0-9a-z_.'^]*"),
    ("x", r"[0-9a-z][0-9a-z.]*|[\s\S]"),
)  # fmt: skip
_TOKEN = re.compile("|".join(f"(?P<t{k}>{pattern})" for k, (_, pattern) in enumerate(_LEXICON)))


def _tokens(text: str) -> Iterator[Token]:
    """The tokens of a plain text in small letters."""
    for match in _TOKEN.finditer(text):
        code, piece = _LEXICON[int((match.lastgroup or "")[1:])][0], match.group()
        if code == "n":
            number = numbers.number_of(match)
            yield Token("n" if math.isfinite(number) else "z", piece, number)
        elif code == "d":
            way = sum((_WAYS[one] for one in _WAY.findall(re.sub("[ 轴的]", "", piece))), 0j)
            yield Token(code, piece, way=way / abs(way))
        elif code:
            yield Token(code[0], piece, -1 if code[1:] == "-" else 1)


# --- forms -------------------------------------------------------------------------------------

_INNER = re.compile(r"\(([^()]*)\)")
_PAIR = re.compile("([sg]?nu?);([sg]?nu?)(?:;n)?")
_SUM = re.compile("(s?nu?)(?:i(snu?)j|(sn)[ij])")
_APART = re.compile("(?<=u)(?=u|[sg]?nu)|(?<=[^;a])(?=a)|(?:(?<=en)|(?<=e[sn][nu])|(?<=esnu))(?=[kx]e)")
_CONVENTION = re.compile("c[le]*s(?![sgn])|s[le]*c")
_VALUE = re.compile("[sg]?nu?(?:pnu?)?g?")
_END = Token(";")


def _codes(tokens: list[Token]) -> str:
    return "".join(token.code for token in tokens)


def _components(first: list[Token], second: list[Token]) -> list[Token]:
    """As `x = .., y = ..`."""
    return [_END, Token("x", "x"), Token("e"), *first, _END, Token("x", "y"), Token("e"), *second, _END]


def _without_brackets(tokens: list[Token], vector: bool) -> list[Token]:
    """Brackets resolved: pairs, what the number may err by, remarks; the rest stands as if there were none."""
    while (match := _INNER.search(codes := _codes(tokens))) is not None:
        inside, its, before = tokens[match.start() + 1 : match.end() - 1], match[1], codes[: match.start()]
        pair = _PAIR.fullmatch(its) if vector else None  # `(-0.08, -0.26)`, `(0.271 m/s, 252.5°)`, `(1, 2, 0)`
        if pair is not None and (not inside[-1].number or pair.end(2) == len(its)):
            polar = _ANGLES.fullmatch(inside[-1].text) is not None
            first, second = inside[: pair.end(1)], inside[pair.start(2) : pair.end(2)]
            inside = [_END, *inside, _END] if polar else _components(first, second)
        elif vector and re.fullmatch("[sg]?nu?", its) and any("," in one.text for one in inside if one.code == "n"):
            inside = [Token("z")]  # `(3,4)`: one number or two
        elif its in ("pn", "pnu") or ("x" in its and set(its) <= set("xkleij;")):
            inside = []
        elif its == "s":  # `(负)`
            inside = [Token("g", number=inside[0].number)]
        elif its != "u" and not before.endswith("a") and ("n" in before or "n" not in its):
            inside = [_END, *inside, _END]
        tokens[match.start() : match.end()] = inside
    return tokens


@dataclass
class _Reading:
    """The parts of an answer, clause by clause.

    turning, vector   whether the quantity has a sense, or a direction; axis: of one component alone
    column   the unit of the column that it stands in
    upward   1 where it is said that counter-clockwise is positive, -1
    """

    whole: str
    dimension: Dimension | None
    turning: bool
    vector: bool
    axis: str
    column: str
    values: list[Amount] = field(default_factory=list)
    angles: list[Amount] = field(default_factory=list)
    parts: dict[str, Number] = field(default_factory=dict)
    units: list[str] = field(default_factory=list)
    senses: set[float] = field(default_factory=set)
    ways: list[complex] = field(default_factory=list)
    upward: set[int] = field(default_factory=set)
    wants_sign: bool = False

    @property
    def sense(self) -> float:
        """Of a turning quantity: the one in words, 0 where only a sign says it."""
        return min(self.senses, default=0) if self.turning else 0

    def doubt(self, senses: bool = False) -> NotAnAnswer | SenseDisputed:
        return (SenseDisputed if senses else NotAnAnswer)(NOWHERE, self.whole[:LONGEST])

    def read(self, text: str) -> None:
        """A plain text in small letters, clause by clause."""
        tokens = [one for one in _tokens(text) if one.code != "a" or not self.turning]
        tokens = _without_brackets(tokens, self.vector)
        while self.vector and (match := _SUM.search(_codes(tokens))) is not None:
            first, second = match.span(1), match.span(2) if match[2] else match.span(3)
            tokens[match.start() : match.end()] = _components(tokens[slice(*first)], tokens[slice(*second)])
        # `counter-clockwise is positive`; `clockwise -` by itself may be sense and sign
        while self.turning and (match := _CONVENTION.search(_codes(tokens))) is not None:
            ends = tokens[match.start()], tokens[match.end() - 1]
            self.upward.add(1 if ends[0].number == ends[1].number else -1)
            self.wants_sign |= len(match[0]) == 2 and -1 in (one.number for one in ends if one.code == "s")
            tokens[match.start() : match.end()] = [_END]
        for match in reversed([*_APART.finditer(_codes(tokens))]):
            tokens.insert(match.start(), _END)
        ends_of = [-1, *(k for k, token in enumerate(tokens) if token.code == ";"), len(tokens)]
        for start, end in pairwise(ends_of):
            self._clause(tokens[start + 1 : end])

    def _clause(self, clause: list[Token]) -> None:
        """One clause: labels, each before an e, and what they say."""
        if re.match("k+l", _codes(clause)) is not None and "e" not in _codes(clause):
            clause = [Token("e") if token.code == "l" else token for token in clause]
        ends = [-1, *(k for k, token in enumerate(clause) if token.code == "e"), len(clause)]
        *labels, body = ([one for one in clause[a + 1 : b] if one.code != "l"] for a, b in pairwise(ends))
        if labels and not set(_codes(body)) & set("ncd") and "n" in _codes(labels[-1]):
            body, labels[-1] = labels[-1], body  # `3.92 = omega`
        axis = ""
        for label in labels:
            codes, text = _codes(label), "".join(token.text for token in label)
            if "z" in codes:
                raise self.doubt()
            body = [*(token for token in label if token.code in ("cda" if set(codes) <= set("cda") else "cd")), *body]
            if "n" not in codes and codes.count("u") == 1 and "u" not in _codes(body):
                units = (token.text for token in label if token.code == "u")
                self.units += [unit for unit in units if unit[1:] and unit[0] != "/"]  # in `v/r` none stands
            match = re.search("(?:^|[_a-z0-9])([xy])(?:分量)?$", text)
            axis = match[1] if match is not None and self.vector else ""
        self._body(body, axis)
        for label in labels:  # of `3.9193 = 3.92` the last one counts
            if _VALUE.fullmatch(_codes(label)):
                self.values.append(self._amount(label))

    def _body(self, body: list[Token], axis: str) -> None:
        senses = {token.number for token in body if token.code == "c"}
        self.senses |= senses
        self.ways += [token.way for token in body if token.code == "d"]
        body = [token for token in body if token.code not in "cd"]
        codes = re.sub("^k+(?=n|$)|(?<![nu])t", lambda run: "_" * len(run[0]), _codes(body))
        body, codes = [token for token, code in zip(body, codes) if code != "_"], codes.replace("_", "")
        value = codes.lstrip("a")
        if codes == "u":
            self.units.append(body[0].text)
        elif codes in ("", "pn", "pnu") or (codes == "g" and senses == {body[0].number}):
            return  # `3.92 cw (-)`, `3.92 cw ± 0.1`
        elif _VALUE.fullmatch(value) is None:
            raise self.doubt()
        elif value != codes:
            angle = self._amount(body)
            in_pi = not angle.unit and any("π" in token.text for token in body)
            self.angles.append(angle._replace(unit="rad") if in_pi else angle)
        elif axis:
            if self.parts.setdefault(axis, part := self._amount(body).number) != part:
                raise self.doubt()
        else:
            self.values.append(self._amount(body))

    def _amount(self, tokens: list[Token]) -> Amount:
        """The number of a value; what it may err by is passed over."""
        number = next(token.number for token in tokens if token.code == "n")
        signs = {token.number for token in tokens if token.code in "sg"}
        off = next((k for k, token in enumerate(tokens) if token.code == "p"), len(tokens))
        units = [token.text for token in tokens[:off] if token.code == "u"]
        units += [token.text for token in tokens[off:] if token.code == "u" and token.text != "%"]
        if len(signs) > 1:
            raise self.doubt(senses=True)
        return Amount(number, next(iter(units), ""), min(signs, default=0.0))

    # --- all clauses together ------------------------------------------------------------------

    def answer(self) -> HandedValue:
        """Two numbers must agree within 2 %, or the unit of one alone is right; components give the size, or the
        direction of one."""
        if self.vector and len(self.values) > 1:  # `0.271 m/s, 252.5°`
            self.angles += [value for value in self.values if _ANGLES.fullmatch(value.unit)]
            self.values = [value for value in self.values if not _ANGLES.fullmatch(value.unit)]
        if [*self.parts] == [self.axis]:
            self.values.append(Amount(*self.parts.pop(self.axis)))
        toward = sum(self.ways, 0j)
        if not (self.values or self.parts) or len(self.parts) == 1 or max(len(self.angles), len({*self.units})) > 1:
            raise self.doubt()
        apart = any((way * toward.conjugate()).real < 0.1 for way in self.ways)
        if len(self.senses) > 1 or len(self.upward) > 1 or apart:
            raise self.doubt(senses=True)
        toward = toward / abs(toward) if toward else 0j
        own = next(iter(self.units), "")
        amounts = [self.in_si((number, its or own)) for number, its in self._signed(toward)]
        of_unit = [one for one in amounts if one.fault is None] or amounts
        if len(of_unit) < len(amounts) and not all(one.unit for one in of_unit):
            raise self.doubt()
        own = next((its for _, its in self.parts.values() if its), own)
        halves = [self.in_si((number, its or own)) for _, (number, its) in sorted(self.parts.items())]
        pair = complex(*(half.value or 0.0 for half in halves)) if halves else 0j
        value = replace(of_unit[0], sense=_SENSES[self.sense]) if amounts else replace(halves[0], value=abs(pair))
        size = value.value or 0.0
        if not all(math.isclose(abs(size), abs(other.value or 0.0), rel_tol=0.02) for other in of_unit):
            raise self.doubt()
        return self._directed(value, toward, pair)

    def _signed(self, toward: complex) -> Iterator[Number]:
        """The values with the signs that senses and conventions give them."""
        for value in self.values:
            signed = (value.sign or 1) * min(self.upward, default=1)
            if (self.wants_sign and not value.sign) or (self.ways and not self.vector):
                raise self.doubt()
            against = max(toward.real, toward.imag) > 0.1 or (self.sense and signed != self.sense)
            if value.sign < 0 and value.size and against:
                raise self.doubt(senses=True)
            yield (self.sense or signed) * value.size, value.unit

    def _directed(self, value: HandedValue, toward: complex, pair: complex) -> HandedValue:
        """With its direction, which is in words, in components, or an angle."""
        size = value.value or 0.0
        vector, within = (abs(size) * toward, WORDS) if toward else (None, 0.0)
        if pair:
            if not any(math.isclose(abs(pair), length, rel_tol=0.05) for length in (abs(size), 1.0)):
                raise self.doubt()
            vector, within = size * pair / abs(pair), 0.0
        for angle, unit in (one.number for one in self.angles):
            in_words = vector
            vector, within = cmath.rect(size, in_si(angle * min(self.senses, default=1), unit, "angle")), 0.0
            if in_words and vector and abs(cmath.phase(vector / in_words)) > WORDS:
                raise self.doubt(senses=True)
        return replace(value, vector=vector or None, within=within)

    def in_si(self, one: Number) -> HandedValue:
        number, own = one
        name = unit_named(own or self.column)
        if self.dimension is None:
            if name not in ("", "%"):
                raise self.doubt()
            return HandedValue(self.whole, read_quantity(number / 100 if name else number, "velocity"))
        shown = name.replace("²", "^2")
        try:
            return HandedValue(self.whole, in_si(number, name, self.dimension), None, shown)
        except OtherDimension as fault:
            return HandedValue(self.whole, read_quantity(number, self.dimension), None, shown, fault)


# --- a text ------------------------------------------------------------------------------------

_SIMPLE = re.compile(
    r"([+-]?(?:[0-9]{1,20}(?:\.[0-9]{0,20})?|\.[0-9]{1,20})(?:[eE][+-]?[0-9]{1,3})?) ?([A-Za-z°][A-Za-z/^²]{0,9}2?)?"
)
_NO_SENSE = re.compile(r"\s+[—–―]+\s*$")
_TURNING = ("rad", "rad/s", "rad/s^2")
_EVERY = (*DIMENSIONS, "1")
_STRAIGHT = tuple(si for si in _EVERY if si not in _TURNING)
_REWRITTEN: tuple[tuple[str, str | Callable[[re.Match[str]], str], Collection[str]], ...] = (
    ("<([^<>]*)>", r"(\1)", _EVERY), (r" \| |(?<=[^\s(:=,;]) - (?=[^0-9]*$)", ", ", _EVERY),
    ("(π(?: ?/ ?[0-9]+)?)(?![ 0-9/]*[a-z°度弧*])", r"\1 rad", ("rad",)), ("(?<=[0-9]) ?: ?(?=[0-9])", "/", ("1",)),
    (r"(?<=\S) +-+$", "", _STRAIGHT),  # in the last column of a table; of what turns a minus may be a sign
    (r"([0-9][.,][0-9]+)\([0-9]{1,2}\)", r"\1", _EVERY),
    (rf"(?<=[0-9]) +(?=[-+]?[0-9.,]+ ?(?:{numbers.ATOMS['deg']}))", ", ", numbers.PLANES),  # `0.967 80.9°`
    (r"([0-9]+)° ?([0-9]+(?:\.[0-9]+)?)'(?: ?([0-9]+(?:\.[0-9]+)?)'')?",
     lambda at: f"{int(at[1]) + float(at[2]) / 60 + float(at[3] or 0) / 3600!r}°", _EVERY),
    ("[\"\u201c\u201d\u300c\u300d]|^[*_=' ]+|[*_ ]+$", "", _EVERY),
)  # fmt: skip
"""Rewritings before a text is read: a pattern, the text in its place, and the SI units it holds for."""


def simple(text: str) -> Number | None:
    """A number alone or with a unit of the house's, as tables have it."""
    match = _SIMPLE.fullmatch(text)
    return None if match is None or (match[2] and not numbers.is_unit(match[2])) else (float(match[1]), match[2] or "")


def parsed_value(text: str, si: str, unit: str = "", vector: bool = True, axis: str = "") -> HandedValue:
    """The value that a text gives for a quantity of this SI unit; faults come with `NOWHERE`.

    unit   of its column; vector: whether such a quantity has a direction; axis: of one component alone
    """
    reading = _Reading(text, DIMENSIONS.get(si), si in _TURNING, vector and si in numbers.PLANES, axis, unit)
    try:
        if (number := simple(text)) is not None:
            return reading.in_si(number)
        if len(text) > LONGEST:
            raise NotAnAnswer(NOWHERE, text[:40] + "..")
        bare = numbers.unaccented(plain(numbers.unlatexed(_NO_SENSE.sub("", text)))).lower()
        for pattern, better, units in _REWRITTEN:
            bare = re.sub(pattern, better, bare) if si in units else bare
        reading.read(bare)
        return reading.answer()
    except GraphkinError as fault:
        return HandedValue(text, None, fault=fault)

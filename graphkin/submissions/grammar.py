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

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import pairwise

from graphkin.base.value import frozen
from graphkin.errors import NOWHERE, NotAnAnswer, SenseDisputed

Number = tuple[float, str]  # with its unit as it is typed
LONGEST = 200  # no value is written with more letters
ANGLES = re.compile(r"°|度|deg(?:ree)?s?|rad(?:ian)?s?|弧度")


@frozen
class WrittenAnswer:
    """An answer taken apart.

    number   with its sign; of one that is given by its components alone None
    sense    1 for counter-clockwise, -1, and 0 where only a sign says it
    also     what is said to be the same number
    angle    of its direction; toward: a direction in words, of length 1, or 0; parts: components
    """

    number: Number | None
    sense: int = 0
    also: tuple[Number, ...] = ()
    angle: Number | None = None
    toward: complex = 0j
    parts: tuple[Number, ...] = ()


@frozen
class Token:
    """number: of a sign or a sense 1 or -1"""

    code: str
    text: str = ""
    number: float = 1.0
    way: complex = 0j


# --- LaTeX -------------------------------------------------------------------------------------

_FONTS = re.compile(r"\\(?:(?:math|text)(?:rm|bf|it)?|boldsymbol|mbox|unit|si|num|hat|vec)\s*\{([^{}]*)\}")
_COMMANDS = {
    "times": "*", "cdot": "*", "pm": "±", "approx": "=", "simeq": "=", "sim": "~", "angle": "∠", "degree": "°",
    "pi": "π", "omega": "ω", "alpha": "α", "theta": "θ", "varphi": "φ", "phi": "φ", "circlearrowleft": "↺",
    "circlearrowright": "↻", "leftarrow": "←", "rightarrow": "→", "uparrow": "↑", "downarrow": "↓", "searrow": "↘",
    "swarrow": "↙", "nearrow": "↗", "nwarrow": "↖", "per": "/", "meter": "m", "metre": "m", "milli": "m",
    "second": "s", "radian": "rad", "squared": "^2", "quad": " ", "qquad": " ",
    **dict.fromkeys(("left", "right", "rm", "mathrm", "text"), ""),
}  # fmt: skip


def unlatexed(text: str) -> str:
    """Without the marks of LaTeX; a text that has none as it is."""
    if not any(mark in text for mark in "\\${"):
        return text
    text = re.sub(r"\\(?:SI|qty)\s*\{([^{}]*)\}\s*\{", r"\1 {", text.replace("~", " "))
    text = re.sub(r"\^\s*\{?\s*\\circ\s*\}?", "°", text)
    text = _FONTS.sub(r" \1 ", _FONTS.sub(r" \1 ", text))
    text = re.sub(r"\\[dt]?frac\s*\{([^{}]*)\}\s*\{([^{}]*)\}", r"\1/\2", text)
    text = re.sub(r"\\[,;:! ()\[\]]", " ", text)
    text = re.sub(r"\\([A-Za-z]+)", lambda run: _COMMANDS.get(run[1], run[0]), text)
    return re.sub(r"[${}]", "", text)


# --- tokens ------------------------------------------------------------------------------------

_NO_MORE = "(?![0-9]|[.,][0-9])"
_BODY = (
    rf"(?:[1-9][0-9]{{0,2}}(?P<of>[ ',.])[0-9]{{3}}(?:(?P=of)[0-9]{{3}})*(?!(?P=of))[.,](?:[0-9]{{1,2}}|[0-9]{{4,}})"
    rf"{_NO_MORE}|[1-9][0-9]{{0,2}}(?:(?P<by>[ '])[0-9]{{3}}(?:(?P=by)[0-9]{{3}})*|(?P<at>[.,])[0-9]{{3}}"
    rf"(?:(?P=at)[0-9]{{3}})+){_NO_MORE}"
    r"|[0-9]+(?:[.,][0-9]+|\.(?![0-9]))?|\.[0-9]+)"
)
_POWER = r"(?:e|[*x] ?10 ?(?:\^|\*\*) ?\(?|[*x] ?10(?=[+-]))(?P<power>[+-]?[0-9]+)\)?"
_DECIMAL = rf"(?P<body>{_BODY})(?: ?{_POWER}{_NO_MORE})?"
_FRACTION = r"(?:(?P<whole>[0-9]{1,9}) )?(?P<top>[0-9]{1,9}) ?/ ?(?P<bottom>[0-9]{1,9})" + _NO_MORE
_PI = r"(?P<times>[0-9]+(?:[.,][0-9]+)? ?\*? ?)?(?:π|pi(?![a-z]))(?: ?/ ?(?P<over>[0-9]{1,9})" + _NO_MORE + ")?"
_NUMBER = re.compile(rf"(?:{_FRACTION}|{_PI}|{_DECIMAL})(?![0-9a-z]*[0-9])")

_WHERE = " (?:the|an?|c?cw|clock|counter|anti|drawing|fig)"  # `in the ..`, not inches
_ATOM = (
    r"(?:rad(?:ian)?s?|deg(?:ree)?s?|°|度|弧度|毫米|厘米|米|millimet(?:er|re)s?|met(?:er|re)s?|mm|cm|km|m"
    rf"|inch(?:es)?|in(?!{_WHERE})|ft|feet|foot|rev(?:olution)?s?|rpm|r|转|圈|s(?:ec(?:ond)?s?)?|秒"
    r"|min(?:ute)?s?|分钟?|h(?:ours?)?|小时|%)"
    r"(?: ?(?:\^|\*\*) ?(?:\([+-]?[1-3]\)|[+-]?[1-3])|[+-]?[1-3](?![0-9.,]*[0-9])| ?squared|的?平方|²)?"
)
_PER = "每(?:二次方|平方)?"
_FACTOR = rf"(?:{_ATOM}|\({_ATOM}(?: ?[*/] ?{_ATOM})*\))"
_UNIT = rf"(?:/ ?|per |{_PER})?{_ATOM}(?:(?: ?[*/.] ?| ?per ?|{_PER}| ?(?=s\^?\(?-)){_FACTOR})*(?![a-z_'])"
_UP, _SIDE = r"(?:up(?:per)?|top|down|low(?:er)?|bottom)(?:wards?)?", r"(?:left|right)(?:wards?)?"
_AND = r"(?: ?[-/& ] ?|,? ?and (?:to the )?)?"
_WAYS: dict[str, complex] = {
    "左": -1, "右": 1, "上": 1j, "下": -1j, "left": -1, "right": 1, "up": 1j, "top": 1j, "down": -1j, "low": -1j,
    "bottom": -1j, "←": -1, "<-": -1, "→": 1, "->": 1, "↑": 1j, "↓": -1j, "↖": 1j - 1, "↗": 1j + 1, "↘": 1 - 1j,
    "↙": -1 - 1j, "+x": 1, "-x": -1, "+y": 1j, "-y": -1j, "positivex": 1, "negativex": -1, "positivey": 1j,
    "negativey": -1j, "x正": 1, "x负": -1, "y正": 1j, "y负": -1j,
}  # fmt: skip
_WAY = re.compile("|".join(map(re.escape, _WAYS)))

_LEXICON = (  # of two that begin alike the longer one first
    ("", " +"),
    ("", r"(?:from|to|wrt|with respect to|relative to|与|从|自|相对于?) ?(?:the )?(?:x ?轴的?正方?向"
         r"|(?:\+ ?|positive )?x(?:[- ]?axis)?(?: direction)?(?![a-z轴]))"),
    ("d", r"(?:along |in )?(?:the )?(?:[+-]|negative|positive) ?[xy](?:[- ]?axis|轴)?(?: direction|方向)?"
          r"(?![a-z0-9_]| *[=:])|沿?[xy] ?轴?的?[正负]方?向"),
    ("z", r"from [a-z][0-9']* to|towards? [a-z](?![a-z])|along|perpendicular|parallel|[⊥∥]|//|平行|垂直(?![向朝纸])"
          r"|[沿指由从][向着]? ?[a-z]|[a-z][0-9']* ?(?:->|→) ?[a-z]|(?:->|→) ?(?=[-+.0-9])|same|同[向样]|一致"),
    ("g", r"\( ?[+-] ?\)"), ("p", r"±|\+ ?/ ?-|\+-|plus or minus"),
    ("ccw", r"(?:counter|anti)[- ]?clock[- ]?wise|(?:ccw|acw)(?![a-z])|(?:c\.c\.|a\.c\.)w\.?|[逆反][时時][针針钟鐘]|逆"
            r"|[↺⟲🔄⊙]|out of (?:the )?(?:page|paper)|(?:垂直)?纸面向外"),
    ("cw", r"clock[- ]?wise|cw(?![a-z])|c\.w\.?|[顺順][时時][针針钟鐘]|[顺順]|[↻⟳🔃⊗]|into (?:the )?(?:page|paper)"
           r"|(?:垂直)?纸面向[里内]"),
    ("", rf"or so|左右|上下|in(?={_WHERE})"),
    ("z", r"quadrant|象限|偏|below|above|以[上下内外]|大于|小于|超过|相反|反[向转]|正转|opposite|wrong|错|作废"
          r"|[或非不未?]|(?:not?|or)(?![a-z])"),
    ("x", r"[下上左右如见][图面表]"),
    ("", r"about|approx(?:imately|\.)?|ca\.|(?:ca|mag|ans|so|it|the|of|dir|to)(?![a-z])|circa|roughly|around|nearly"
         r"|almost|est\."
         r"|magnitude|size|value|speed|answer|final|result|hence|therefore|(?:an?|and|with)(?= )|towards?|pointing"
         r"|directed|direction|signs?|sense|rotat(?:ion|ing|es)|turn(?:ing|s)|units?|side|horizontal(?:ly)?|vertical(?:ly)?"
         r"|measured|velocity|acceleration|角?加?速度|大?约(?:为|等于)?|大概|近似|大小|数值|值"
         r"|结果|答案?|[解求测量]?得到?|估[计读算]|计算|读数|测量|由图|[故即且沿取以设的号其]|i\.e\.|所以|因此|规定|单位|方向(?!角)|转向|旋向|指向|[朝往向方边侧斜](?!向角)"
         r"|水平|竖直|铅[垂直]|垂直(?=向|朝)|转动|旋转|∴|[.!](?= |$)"),
    ("a", r"∠|∡|@|/_|(?:at|arg)(?![a-z])|方向角|夹角|角度|angle|[θφϑϕ][0-9a-z_']*|<(?= ?[+-]?[0-9.]+ ?(?:°|deg))"),
    ("l", r"[为是记]|(?:is|are|as|means?)(?![a-z])|等于|equals?|表示|代表|taken|because|since"),
    ("u", f"{_UNIT}|°"), ("-", r"负[号数向]?|minus|negative|neg(?![a-z])|-ve|-(?!>)"),
    ("+", r"正[号数]?|plus|positive|pos(?![a-z])|\+ve|\+"),
    ("d", rf"(?:{_UP}{_AND}{_SIDE}|{_SIDE}{_AND}{_UP}|{_UP}|{_SIDE})(?![a-z])|[左右上下←→↑↓↖↗↘↙]|->|<-$"),
    (";", "=>|[,;、⇒\n]"), ("e", "[=:]"), ("(", r"[(\[]"), (")", r"[)\]]"), ("t", "~"), ("i", "i(?![a-z0-9])"),
    ("j", "j(?![a-z0-9])"), ("k", r"[α-ω][0-9a-z_.'^]*|[a-z]+[_^'0-9][0-9a-z_.'^]*"),
    ("x", r"[0-9a-z][0-9a-z.]*|[\s\S]"),
)  # fmt: skip
_TOKEN = re.compile("|".join(f"(?P<t{k}>{pattern})" for k, (_, pattern) in enumerate(_LEXICON)))
_ONE_PER = re.compile(rf"1 ?/ ?{_FACTOR}(?![a-z])")
_SIGNS = {"ccw": 1, "cw": -1, "+": 1, "-": -1}


def _tokens(text: str) -> Iterator[Token]:
    """The tokens of a plain text in small letters."""
    at = 0
    while at < len(text):
        code, match = "u", _ONE_PER.match(text, at)
        if match is None:
            code, match = "n", _NUMBER.match(text, at)
        if match is None and (match := _TOKEN.match(text, at)) is not None:
            code = _LEXICON[int((match.lastgroup or "")[1:])][0]
        assert match is not None, "the last row of the lexicon takes any letter"
        at, piece = match.end(), match.group()
        if code == "n":
            number = _number(match)
            yield Token("n" if math.isfinite(number) else "z", piece, number)
        elif code == "d":
            way = sum((_WAYS[one] for one in _WAY.findall(re.sub("[ 轴的]", "", piece))), 0j)
            yield Token(code, piece, way=way / abs(way))
        elif code == "g":
            yield Token(code, piece, -1 if "-" in piece else 1)
        elif code:
            yield Token({"ccw": "c", "cw": "c", "+": "s", "-": "s"}.get(code, code), piece, _SIGNS.get(code, 1))


def _number(match: re.Match[str]) -> float:
    """The value of a number: `462/1000`, `1 1/2`, `2π/3`, `3,92*10^-1`, `1.234,5`; NaN of none."""
    if match["top"] is not None:
        top, bottom = int(match["top"]), int(match["bottom"])
        improper = match["whole"] is not None and top >= bottom
        return math.nan if not bottom or improper else int(match["whole"] or 0) + top / bottom
    body, power = match["body"], match["power"] or "0"
    if body is None:
        times = (match["times"] or "1").strip(" *").replace(",", ".")
        return float(times) * math.pi / (int(match["over"] or 1) or math.nan)
    groups = match["of"] or match["by"] or match["at"]
    body = body.replace(groups, "") if groups else body
    return float(f"{body.replace(',', '.').rstrip('.')}e{power}") if len(power) <= 5 else math.nan


# --- forms -------------------------------------------------------------------------------------

_INNER = re.compile(r"\(([^()]*)\)")
_PAIR = re.compile("([sg]?nu?);([sg]?nu?)(?:;n)?")
_SUM = re.compile("(s?nu?)(?:i(snu?)j|(sn)[ij])")
_APART = re.compile("(?<=u)(?=u|[sg]?nu)|(?<=[^;a])(?=a)|(?:(?<=en)|(?<=e[sn][nu])|(?<=esnu))(?=[kx]e)")
_CONVENTION = re.compile("c[le]*s(?![sgn])|s[le]*c")
_VALUE = re.compile("[sg]?nu?(?:pnu?)?g?")
_END = Token(";")


def taken_apart(text: str, whole: str, vector: bool, turning: bool, axis: str = "") -> WrittenAnswer:
    """A plain text in small letters. Raises NotAnAnswer with `whole`, SenseDisputed.

    vector, turning   whether the quantity has a direction, or a sense; axis: of one component alone
    """
    reading = _Reading(whole, vector, turning, axis)
    tokens = _without_brackets([one for one in _tokens(text) if one.code != "a" or not turning], vector)
    while vector and (match := _SUM.search(_codes(tokens))) is not None:
        first, second = match.span(1), match.span(2) if match[2] else match.span(3)
        tokens[match.start() : match.end()] = _components(tokens[slice(*first)], tokens[slice(*second)])
    tokens = reading.without_conventions(tokens)
    for match in reversed([*_APART.finditer(_codes(tokens))]):
        tokens.insert(match.start(), _END)
    clause: list[Token] = []
    for token in (*tokens, _END):
        if token.code != ";":
            clause.append(token)
            continue
        reading.read(clause)
        clause = []
    return reading.answer()


def leading_number(text: str, whole: str) -> tuple[float, str]:
    """The number that a plain text begins with, and the rest. Raises NotAnAnswer with `whole`."""
    bare = text.rpartition("=")[2].strip().lower()
    sign, bare = (-1, bare[1:]) if bare.startswith("-") else (1, bare.removeprefix("+"))
    if (match := _NUMBER.match(bare.lstrip())) is None or not math.isfinite(number := _number(match)):
        raise NotAnAnswer(NOWHERE, whole[:LONGEST])
    return sign * number, bare.lstrip()[match.end() :].strip(" ,;")


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
            polar = ANGLES.fullmatch(inside[-1].text) is not None
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
    """The parts of an answer, clause by clause; signs of values are 0 where none is written.

    upward   1 where it is said that counter-clockwise is positive, -1
    """

    whole: str
    vector: bool
    turning: bool
    axis: str
    values: list[tuple[float, Number]] = field(default_factory=list)
    angles: list[Number] = field(default_factory=list)
    parts: dict[str, Number] = field(default_factory=dict)
    units: list[str] = field(default_factory=list)
    senses: set[float] = field(default_factory=set)
    ways: list[complex] = field(default_factory=list)
    upward: set[int] = field(default_factory=set)
    wants_sign: bool = False

    def doubt(self, senses: bool = False) -> NotAnAnswer | SenseDisputed:
        return (SenseDisputed if senses else NotAnAnswer)(NOWHERE, self.whole[:LONGEST])

    def without_conventions(self, tokens: list[Token]) -> list[Token]:
        """`counter-clockwise is positive` and the like taken out. `clockwise -` by itself may be sense and sign."""
        while self.turning and (match := _CONVENTION.search(_codes(tokens))) is not None:
            ends = tokens[match.start()], tokens[match.end() - 1]
            self.upward.add(1 if ends[0].number == ends[1].number else -1)
            self.wants_sign |= len(match[0]) == 2 and -1 in (one.number for one in ends if one.code == "s")
            tokens[match.start() : match.end()] = [_END]
        return tokens

    def read(self, clause: list[Token]) -> None:
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
                self.values.append(self._number(label))

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
            sign, (angle, unit) = self._number(body)
            in_pi = not unit and any("π" in token.text for token in body)
            self.angles.append(((sign or 1) * angle, "rad" if in_pi else unit))
        elif axis:
            sign, (number, unit) = self._number(body)
            if self.parts.setdefault(axis, part := ((sign or 1) * number, unit)) != part:
                raise self.doubt()
        else:
            self.values.append(self._number(body))

    def _number(self, tokens: list[Token]) -> tuple[float, Number]:
        """A sign, 0 where none is written, and the number with its unit; what it may err by is passed over."""
        number = next(token.number for token in tokens if token.code == "n")
        signs = {token.number for token in tokens if token.code in "sg"}
        off = next((k for k, token in enumerate(tokens) if token.code == "p"), len(tokens))
        units = [token.text for token in tokens[:off] if token.code == "u"]
        units += [token.text for token in tokens[off:] if token.code == "u" and token.text != "%"]
        if len(signs) > 1:
            raise self.doubt(senses=True)
        return min(signs, default=0.0), (number, next(iter(units), ""))

    def answer(self) -> WrittenAnswer:
        """All clauses together."""
        if self.vector and len(self.values) > 1:  # `0.271 m/s, 252.5°`
            angles = [value for value in self.values if ANGLES.fullmatch(value[1][1])]
            self.angles += [((sign or 1) * number, unit) for sign, (number, unit) in angles]
            self.values = [value for value in self.values if value not in angles]
        if [*self.parts] == [self.axis]:
            self.values += [(1.0, self.parts.pop(self.axis))]
        toward = sum(self.ways, 0j)
        if not (self.values or self.parts) or len(self.parts) == 1 or max(len(self.angles), len({*self.units})) > 1:
            raise self.doubt()
        apart = any((way * toward.conjugate()).real < 0.1 for way in self.ways)
        if len(self.senses) > 1 or len(self.upward) > 1 or apart:
            raise self.doubt(senses=True)
        sense = int(min(self.senses, default=0))
        unit, toward = next(iter(self.units), ""), toward / abs(toward) if toward else 0j
        angle = (self.angles[0][0] * (sense or 1), self.angles[0][1]) if self.angles else None
        sense = sense if self.turning else 0
        numbers = []
        for sign, (number, own) in self.values:
            signed = (sign or 1) * min(self.upward, default=1)
            if (self.wants_sign and not sign) or (self.ways and not self.vector):
                raise self.doubt()
            against = max(toward.real, toward.imag) > 0.1 or (sense and signed != sense)
            if sign < 0 and number and against:
                raise self.doubt(senses=True)
            numbers.append(((sense or signed) * number, own or unit))
        units = [own for _, own in self.parts.values() if own]
        parts = tuple((number, own or next(iter(units), unit)) for _, (number, own) in sorted(self.parts.items()))
        return WrittenAnswer(next(iter(numbers), None), sense, tuple(numbers[1:]), angle, toward, parts)

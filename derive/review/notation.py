r"""Formulas as the ledger of claims keeps them, in plain text, read for typesetting.

The notation is what colleagues write in a letter: ``dp_r = H_r^+ drho``, ``[AB^T, AB^T hat(BC)] [dx; dalpha]``,
``A_ee^-1``, ``lambda^_k``. `read` parts a text into words and formulas; a formula keeps every sign of the text, in its
order, and adds none. Nothing is interpreted: ``d`` before a symbol stays an upright d, a name stays a name. What does
not parse stays text.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

from derive.review import typeset as ts
from derive.review.typeset import Math

_TOKEN = re.compile(
    r"""(?P<space>\s*)(?:
    (?P<other>i\.e\.|eqs?\.|Figs?\.)
  | (?P<number>\d+(?:\.\d+)?(?:e-?\d+(?![A-Za-z0-9]))?)
  | (?P<dots>\.\.\.?)
  | (?P<point>O_[bp](?=[A-Z]))                    # the origin of a frame, before another point
  | (?P<name>[A-Za-z]+(?:\d+[A-Za-z]*)*)
  | (?P<sub>_(?:\{[^{}]*\}|\([^()]*\)|[A-Za-z0-9]+(?:[,+][A-Za-z0-9]+)*))
  | (?P<hat>\^(?=_))
  | (?P<sup>\^(?:\([^()]*\)|-?[A-Za-z]+\+(?=[\s,;)\]]|$)|-?\d+|-?[A-Za-z][A-Za-z0-9]*|\+))
  | (?P<prime>')
  | (?P<op>\+-|>=|<=|[-+=<>.,;:/|])
  | (?P<open>[(\[{])
  | (?P<close>[)\]}])
  | (?P<sign>\S)
    )""",
    re.VERBOSE,
)


def _set(words: str) -> frozenset[str]:
    return frozenset(words.split(" "))


LONG = 45  # characters of a formula that a page may break
_SIGNS = {"-": "−", "+-": "±", ">=": "≥", "<=": "≤", "...": "…", "..": "…", ".": "·"}
_SHORT = {"eps": "epsilon", "th": "theta"}
_GREEK = _set("alpha beta gamma delta theta eta kappa lambda mu xi pi rho sigma phi omega epsilon")
_CAPITALS = {"Phi": "Φ", "Pi": "Π", "Theta": "Θ", "Delta": "Δ"}
_FUNCTIONS = _set("cos sin tan sqrt arctan arcsin acos atan2 hat FPR IPR")
_OF_SOMETHING = _set("rank diag det pinv min max sum Delta")  # words as well
_LOOSE = {",", ";", ":", ".", "=", "-", "+", "/", "..."}  # signs that end no formula
_UNITS = {"mm", "deg"}
_ACCENTS = {"hat": ("^", r"\hat"), "bar": ("¯", r"\bar"), "tilde": ("~", r"\tilde")}
_WORDS = _set("is of in at by to as no or if it on an be so do we up go co vs that what dot due")  # no symbols


@dataclass(frozen=True)
class _Token:
    kind: str
    text: str
    space: bool
    start: int
    end: int


def _tokens(text: str) -> list[_Token]:
    found = []
    for match in _TOKEN.finditer(text):
        kind = match.lastgroup or "other"
        found.append(_Token(kind, match[kind], bool(match["space"]), match.start(kind), match.end()))
    return found


def read(text: str) -> list[str | Math]:
    """Return a text as words and formulas in turn; a long formula as pieces, so that a page may break it before a sign.

    Parameters
    ----------
    text : str
        One line of the ledger.
    """
    tokens = _tokens(text)
    words = [_is_word(tokens, n) for n in range(len(tokens))]
    parts: list[str | Math] = []
    done = n = 0
    while n < len(tokens):
        if words[n]:
            n += 1
            continue
        last = next((m for m in range(n, len(tokens)) if words[m]), len(tokens))
        for sentence in _sentences(tokens[n:last]):
            stretch = _trimmed(sentence)
            if _says_something(stretch) and (formula := _formula(stretch)):
                start, end = stretch[0].start, stretch[-1].end
                if text[done:start]:
                    parts.append(text[done:start])
                parts += formula
                done = end
        n = last
    return [*parts, text[done:]] if text[done:] else parts


# --------------------------------------------------------------------------------------------- words and formulas


def _is_symbol(name: str) -> bool:
    """Tell a symbol from a word by its letters alone."""
    if name in _WORDS:
        return False
    if name in _GREEK | _FUNCTIONS | set(_SHORT) | (set(_CAPITALS) - _OF_SOMETHING):
        return True
    if name[-1:].isdigit() or re.fullmatch(r"[A-Za-z]{1,2}\d+[A-Za-z]*", name):
        return len(re.split(r"\d", name)[0]) <= 2 or _is_symbol(re.split(r"\d", name)[0])
    accent = re.fullmatch(r"(.+?)(hat|bar|tilde)", name)
    if accent is not None:
        return _is_symbol(accent[1])
    return len(name) <= 2 or (name[0] == "d" and (_is_symbol(name[1:]) and name[1:] not in _FUNCTIONS))


def _is_word(tokens: Sequence[_Token], n: int) -> bool:
    token, before = tokens[n], tokens[n - 1] if n else None
    after = tokens[n + 1] if n + 1 < len(tokens) else None
    if token.kind in ("other", "sign"):
        return True
    if token.kind == "prime":  # an apostrophe, or a quotation mark
        return before is None or token.space or (before.kind == "name" and _is_word(tokens, n - 1))
    if token.text in ("-", ".") and after is not None and before is not None and not token.space:
        return not after.space and "name" in (before.kind, after.kind) and _is_plain(tokens, n)
    if token.kind != "name":
        return False
    if before is not None and before.kind == "prime" and not token.space:
        return _is_word(tokens, n - 1)  # the s of a genitive
    if after is not None and after.kind in ("sub", "sup", "hat") and not after.space:
        return False
    if token.text in _UNITS:
        return before is None or before.kind not in ("number", "close", "sup")
    if token.text in _OF_SOMETHING:
        return after is None or not (after.text == "(" or (after.kind == "name" and not _is_word(tokens, n + 1)))
    if token.text == "x" and before is not None and before.kind == "name":
        return not _is_symbol(before.text) and before.text not in _OF_SOMETHING | _UNITS
    if token.text in ("a", "A", "I"):
        return after is not None and after.space and after.kind == "name" and _is_word(tokens, n + 1)
    return not _is_symbol(token.text)


def _is_plain(tokens: Sequence[_Token], n: int) -> bool:
    """Return whether a sign stands between two letters of a word, as in co-linear."""
    return all(
        t.kind == "name" and not _is_symbol(t.text) and t.text not in _UNITS for t in (tokens[n - 1], tokens[n + 1])
    )


def _sentences(tokens: Sequence[_Token]) -> list[list[_Token]]:
    """Part at the commas and semicolons that no bracket encloses."""
    parts: list[list[_Token]] = [[]]
    depth = 0
    for token in tokens:
        depth += (token.kind == "open") - (token.kind == "close")
        if token.text in (",", ";") and depth <= 0:
            parts.append([])
        else:
            parts[-1].append(token)
    return parts


def _pieces(tokens: Sequence[_Token]) -> list[list[_Token]]:
    """Part a long formula before the signs between its terms."""
    parts: list[list[_Token]] = [[]]
    depth = bars = 0
    long = tokens[-1].end - tokens[0].start > LONG
    for n, token in enumerate(tokens):
        depth += (token.kind == "open") - (token.kind == "close")
        bars += token.text == "|"
        between = token.space and n + 1 < len(tokens) and tokens[n + 1].space
        begun = bool(parts[-1]) and parts[-1][-1].kind != "dots"
        if long and begun and depth == 0 and bars % 2 == 0 and between and token.text in ("=", "+", "-"):
            parts.append([])
        parts[-1].append(token)
    return parts


def _trimmed(tokens: Sequence[_Token]) -> list[_Token]:
    """Return tokens without separators at their ends and without brackets that they do not close."""
    found = list(tokens)
    pairs = {")": "(", "]": "[", "}": "{"}
    while found:
        opened: list[int] = []
        lone = None
        for n, token in enumerate(found):
            if token.kind == "open":
                opened.append(n)
            elif token.kind == "close":
                if not opened or found[opened[-1]].text != pairs[token.text]:
                    lone = n
                    break
                opened.pop()
        if lone is None and opened:
            lone = opened[0]
        if lone is not None:  # the longer side is the formula
            found = max(found[:lone], found[lone + 1 :], key=len)
        elif found[-1].text in _LOOSE or (found[-1].text == "|" and sum(t.text == "|" for t in found) % 2):
            found = found[:-1]
        elif len(found) > 3 and [t.kind for t in found[:3]] == ["open", "number", "close"] and found[3].space:
            found = found[3:]  # the number of an equation
        elif found[0].kind == "number" and len(found) > 1 and found[1].text == ":":
            found = found[2:]
        elif found[0].text in (",", ";", ":", ".", "=", "/") or found[0].kind in ("sub", "sup", "prime"):
            found = found[1:]
        else:
            break
    return found


def _says_something(tokens: Sequence[_Token]) -> bool:
    symbols = [t for t in tokens if t.kind in ("name", "point") and t.text not in _UNITS]
    return bool(symbols) or any(t.text in ("=", ">=", "<=") for t in tokens)


def _formula(tokens: Sequence[_Token]) -> list[Math]:
    """Return a formula in pieces; nothing where it is none."""
    try:
        first, *others = (_Parser(piece).whole() for piece in _pieces(tokens))
    except _UnreadableError:
        return []
    return [first, *(Math(m.mathml.replace("<mo>", '<mo form="infix">', 1), m.latex) for m in others)]


# --------------------------------------------------------------------------------------------------------- parsing


class _UnreadableError(Exception):
    """A text that is no formula."""


class _Parser:
    """Recursive descent: sequences of signs and factors, factors with scripts, brackets."""

    def __init__(self, tokens: Sequence[_Token]) -> None:
        self._tokens = list(tokens)
        self._n = 0

    def whole(self) -> Math:
        rows = self._rows(None)
        return ts.row(ts.separated(ts.separated(cells) for cells in rows))

    def _peek(self, ahead: int = 0) -> _Token | None:
        n = self._n + ahead
        return self._tokens[n] if n < len(self._tokens) else None

    def _next(self) -> _Token:
        token = self._peek()
        if token is None:
            raise _UnreadableError
        self._n += 1
        return token

    def _is_spaced(self) -> bool:
        """Return whether a matrix begins here whose cells stand apart by spaces alone: one of them is a bare number."""
        depth, inside = 0, []
        for token in self._tokens[self._n :]:
            depth += (token.kind == "open") - (token.kind == "close")
            if depth < 0:
                break
            if depth == 0:
                inside.append(token)
        signs = {t.text for t in inside}
        bare = any(t.kind == "number" and t.space for t in inside)
        return ";" in signs and "," not in signs and bare

    def _rows(self, closing: str | None) -> list[list[Math]]:
        """Return what stands up to a closing bracket: rows by semicolons, cells by commas or spaces."""
        rows: list[list[Math]] = [[]]
        spaced = closing == "]" and self._is_spaced()
        cell, operand, filled = ts.EMPTY, False, False
        while True:
            token = self._peek()
            if token is None or token.text == closing:
                if token is None and closing is not None:
                    raise _UnreadableError
                if filled:
                    rows[-1].append(cell)
                return rows
            if token.text in (",", ";"):
                self._n += 1
                rows[-1].append(cell)
                if token.text == ";":
                    rows.append([])
                cell, operand, filled = ts.EMPTY, False, False
                continue
            if spaced and operand and token.space and (token.kind != "op" or token.text in ("|", "-")):
                rows[-1].append(cell)
                cell, operand = ts.EMPTY, False
            filled = True
            if spaced and token.text == "|":
                self._n += 1
                cell, operand = cell + ts.op("|"), True
            elif self._is_cross(token, operand):
                self._n += 1
                cell, operand = cell + ts.op("×"), False
            elif token.kind == "op" and not self._opens_bar(token, operand):
                cell, operand = cell + self._sign(operand, closing), False
            else:
                space = ts.thin() if operand and token.space else ts.EMPTY
                cell, operand = cell + space + self._factor(), True

    def _is_cross(self, token: _Token, operand: bool) -> bool:
        after = self._peek(1)
        if token.text != "x" or not operand or not token.space or after is None or not after.space:
            return False
        return after.kind in ("name", "number", "open", "point")

    def _opens_bar(self, token: _Token, operand: bool) -> bool:
        after = self._peek(1)
        return token.text == "|" and after is not None and not after.space and not (operand and not token.space)

    def _sign(self, operand: bool, closing: str | None) -> Math:
        token, after = self._next(), self._peek()
        if token.text == "/":
            raise _UnreadableError
        shown = ts.op(_SIGNS.get(token.text, token.text))
        if token.text in ("=", "<=", ">=", "<", ">"):
            return Math(shown.mathml, {"<=": r"\le ", ">=": r"\ge "}.get(token.text, token.text))
        alone = operand and token.space and after is not None and not after.space
        if token.text in ("-", "+") and closing == "]" and alone:  # the sign of the next entry of a row
            return ts.gap() + shown
        if token.text == "|":
            return ts.thin() + shown + ts.thin()
        return Math(shown.mathml, r"\pm ") if token.text == "+-" else shown

    def _factor(self) -> Math:
        left = self._scripted()
        while (token := self._peek()) is not None and token.text == "/":
            self._n += 1
            left = (ts.frac(_unbracketed(left), _unbracketed(self._scripted())), None)
        return left[0]

    def _scripted(self) -> tuple[Math, Math | None]:
        """Return an operand with its scripts, and what is in its bracket where it is nothing but that."""
        first = self._peek()
        differential = first is not None and first.kind == "name" and _is_differential(first.text)
        base, inside = self._atom()
        below = above = None
        while (token := self._peek()) is not None and token.kind in ("sub", "sup", "hat", "prime") and not token.space:
            self._n += 1
            inside = None
            if token.kind == "hat" or token.text == "_hat":
                base = _accent(base, "hat")
            elif token.kind == "sub" and below is None:
                below = _script(token.text[1:])
            elif token.kind in ("sup", "prime"):
                shown = _script(token.text[1:]) if token.kind == "sup" else Math("<mo>′</mo>", r"\prime ")
                above = shown if above is None else ts.row(above, shown)
            else:
                raise _UnreadableError
        base = _with_scripts(base, below, above)
        following = self._peek()
        if inside is None and following is not None and following.text == "(" and not following.space:
            base = ts.row(base, self._group()[0])  # of what is in the bracket
        return (ts.row(ts.words("d"), base) if differential else base), inside

    def _atom(self) -> tuple[Math, Math | None]:
        token = self._peek()
        if token is None:
            raise _UnreadableError
        if token.kind == "open" or token.text == "|":
            return self._group()
        self._n += 1
        if token.kind == "number":
            return _number(token.text), None
        if token.kind == "dots":
            return ts.op("…"), None
        if token.kind == "point":
            return ts.sub(ts.letter("O"), ts.letter(token.text[-1])), None
        if token.kind != "name":
            raise _UnreadableError
        after = self._peek()
        applied = after is not None and after.text == "(" and not after.space
        if applied and token.text in ("sqrt", "hat"):
            group, inside = self._group()
            body = inside if inside is not None else group
            return (ts.root(body) if token.text == "sqrt" else _accent(body, "hat")), None
        return _name(token.text[1:] if _is_differential(token.text) else token.text), None

    def _group(self) -> tuple[Math, Math | None]:
        opening = self._next()
        closing = {"(": ")", "[": "]", "{": "}", "|": "|"}[opening.text]
        nested = (first := self._peek()) is not None and opening.text == first.text == "["
        rows = self._bar() if opening.text == "|" else self._rows(closing)
        self._next()
        pair = opening.text + closing
        if nested and len(rows) == 1 and len(rows[0]) > 1:  # a matrix row by row
            return _brackets(ts.separated(rows[0]), pair), None
        if len(rows) > 1 and opening.text != "|":
            return _brackets(_table(rows), pair), None
        body = ts.separated(rows[0])
        return _brackets(body, pair), body if pair == "()" else None

    def _bar(self) -> list[list[Math]]:
        cell, operand = ts.EMPTY, False
        while (token := self._peek()) is not None and not (token.text == "|" and operand):
            if token.kind == "op" and token.text not in ",;|":
                cell, operand = cell + self._sign(operand, "|"), False
            elif token.kind in ("close", "op"):
                raise _UnreadableError
            else:
                cell, operand = cell + (ts.thin() if operand and token.space else ts.EMPTY) + self._factor(), True
        return [[cell]]


def _unbracketed(part: tuple[Math, Math | None]) -> Math:
    return part[0] if part[1] is None else part[1]


def _brackets(body: Math, pair: str) -> Math:
    if pair != "{}":
        return ts.brackets(body, pair)
    return Math(f"<mrow><mo>{{</mo>{body.mathml}<mo>}}</mo></mrow>", rf"\left\{{{body.latex}\right\}}")


def _table(rows: Sequence[Sequence[Math]]) -> Math:
    """Return the rows of a matrix, without its brackets."""
    whole = ts.matrix(rows)
    cells = whole.mathml.removeprefix("<mrow><mo>(</mo>").removesuffix("<mo>)</mo></mrow>")
    return Math(cells, whole.latex.replace("pmatrix", "matrix"))


def _number(text: str) -> Math:
    mantissa, _, exponent = text.partition("e")
    if not exponent:
        return ts.number(text)
    power = ts.sup(ts.number(10), ts.number(exponent.replace("-", "−")))
    power = Math(power.mathml, f"10^{{{exponent}}}")
    return power if mantissa == "1" else ts.row(ts.number(mantissa), ts.op("·"), power)


def _is_differential(name: str) -> bool:
    known = _GREEK | _UNITS | _OF_SOMETHING
    return name[0] == "d" and len(name) > 1 and name not in known and not name[1].isdigit() and _is_symbol(name[1:])


def _with_scripts(base: Math, below: Math | None, above: Math | None) -> Math:
    if below is None or above is None:
        return (
            base if below is None and above is None else ts.sub(base, below) if below else ts.sup(base, above or base)
        )
    inside = "".join(f"<mrow>{m.mathml}</mrow>" for m in (base, below, above))
    return Math(f"<msubsup>{inside}</msubsup>", f"{{{base.latex}}}_{{{below.latex}}}^{{{above.latex}}}")


def _name(text: str) -> Math:
    """Return a symbol; accents behind it are kept apart from it."""
    if text in _UNITS or text in _FUNCTIONS:
        return ts.words(text) if text in _UNITS else ts.letter(text)
    if text == "sum":
        return ts.op("∑")
    if text in _CAPITALS:
        return Math(f"<mi>{_CAPITALS[text]}</mi>", rf"\{text}")
    if text in _OF_SOMETHING:
        return ts.letter(text)
    accent = re.fullmatch(r"(.+?)(hat|bar|tilde)(\d*)", text)
    if accent is not None and _is_symbol(accent[1]):
        shown = _accent(_name(accent[1]), accent[2])
        return ts.sub(shown, ts.number(accent[3])) if accent[3] else shown
    pieces = re.findall(r"([A-Za-z]+?)(\d+)((?<=\d)[xyz](?![A-Za-z0-9]))?|([A-Za-z]+)", text)
    shown = ts.EMPTY
    for head, digits, axis, rest in pieces:
        base = ts.letter(_SHORT.get(head or rest, head or rest))
        index = ts.number(digits) + (ts.letter(axis) if axis else ts.EMPTY)
        shown = shown + (ts.sub(base, index) if digits else base)
    return ts.row(shown)


def _accent(base: Math, which: str) -> Math:
    sign, command = _ACCENTS[which]
    return Math(
        f'<mover accent="true"><mrow>{base.mathml}</mrow><mo stretchy="false">{sign}</mo></mover>',
        f"{command}{{{base.latex}}}",
    )


def _script(text: str) -> Math:
    """Return an index or an exponent."""
    if text[0] in "({":
        inside = _Parser(_tokens(text[1:-1])).whole()
        return ts.brackets(inside) if text[0] == "(" else inside
    if text == "T" or text == "-T":
        return ts.row(ts.op("−"), ts.op("⊤")) if text[0] == "-" else ts.op("⊤")
    shown = ts.EMPTY
    for n, part in enumerate(text.split(",")):
        shown = shown + (ts.op(",") if n else ts.EMPTY)
        for piece in re.findall(r"[A-Za-z]+|\d+|[-+]", part):
            if piece.isdigit():
                shown = shown + ts.number(piece)
            elif piece in "+-":
                shown = shown + ts.op(_SIGNS.get(piece, piece))
            elif piece in _GREEK or len(piece) == 1 or len(piece) > 3:
                shown = shown + ts.letter(piece)
            else:
                for sign in piece:
                    shown = shown + ts.letter(sign)
    return ts.row(shown)

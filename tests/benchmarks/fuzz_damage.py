"""Damage to files, drawn by dice: bytes, lines, cells, words, values of JSON."""

from __future__ import annotations

import json
import random
import re
from collections.abc import Callable, Iterator, Sequence

NUMBERS = ("nan", "inf", "-1", "0", "1e400", "1e300", "-0.0", "", "x", "1,5", "1_000", "٣", "0x10", "9" * 400, "true")
JSONS = (None, True, -1, 0, 1e300, "", "x", [], {}, [[]], [None], [1, "a"], "9" * 400)


def damaged(content: bytes, name: str, dice: random.Random) -> bytes:
    """Return the content of a file with one to three damages."""
    for _ in range(dice.choice((1, 1, 1, 2, 3))):
        ways: Sequence[Callable[[bytes, random.Random], bytes]] = (
            *_TEXT,
            *(_JSON * 3 if name.endswith(".json") else _CELLS),
        )
        content = dice.choice(ways)(content, dice)
    return content


def _lines(change: Callable[[list[bytes], random.Random], None]) -> Callable[[bytes, random.Random], bytes]:
    def damage(content: bytes, dice: random.Random) -> bytes:
        lines = content.split(b"\n")
        change(lines, dice)
        return b"\n".join(lines)

    return damage


def _swap(lines: list[bytes], dice: random.Random) -> None:
    i, j = dice.randrange(len(lines)), dice.randrange(len(lines))
    lines[i], lines[j] = lines[j], lines[i]


def _number(content: bytes, dice: random.Random) -> bytes:
    """Put something else in the place of a number."""
    found = list(re.finditer(rb"-?\d+(\.\d+)?(e-?\d+)?", content))
    if not found:
        return content
    at = dice.choice(found)
    return content[: at.start()] + dice.choice(NUMBERS).encode() + content[at.end() :]


def _word(content: bytes, dice: random.Random) -> bytes:
    """Misspell a word, or leave it out."""
    found = list(re.finditer(rb"[A-Za-z_][\w.]*", content))
    if not found:
        return content
    at = dice.choice(found)
    word = at[0].decode()
    other = dice.choice(
        ("", word[::-1], word + "_", word.upper(), word * 40, dice.choice(found)[0].decode(), "[" + word, '"')
    )
    return content[: at.start()] + other.encode() + content[at.end() :]


def _byte(content: bytes, dice: random.Random) -> bytes:
    at = dice.randrange(len(content) + 1)
    return content[:at] + bytes([dice.randrange(256)]) + content[at + 1 :]


def _column(content: bytes, dice: random.Random) -> bytes:
    """Leave out a column of a table."""
    rows = [line.split(b",") for line in content.split(b"\n")]
    at = dice.randrange(max(len(rows[0]), 1))
    return b"\n".join(b",".join(c for k, c in enumerate(row) if k != at) for row in rows)


_TEXT: tuple[Callable[[bytes, random.Random], bytes], ...] = (
    lambda c, d: b"",
    lambda c, d: c[: d.randrange(len(c) + 1)],
    lambda c, d: b"\xef\xbb\xbf" + c,
    lambda c, d: c.decode(errors="replace").encode("utf-16"),
    lambda c, d: c.replace(b"\n", b"\r\n"),
    lambda c, d: c.replace(b"\n", b"\r"),
    lambda c, d: c.replace(b".", b","),
    lambda c, d: c.replace(b",", b";"),
    lambda c, d: c + b"\0" * 9,
    lambda c, d: b"\x89PNG\r\n" + bytes(d.randrange(256) for _ in range(200)),
    lambda c, d: c.replace(b'"', b"'"),
    _byte,
    _byte,
    _lines(lambda lines, d: lines.__delitem__(d.randrange(len(lines)))),
    _lines(lambda lines, d: lines.insert(d.randrange(len(lines)), d.choice(lines))),
    _lines(_swap),
)
_CELLS: tuple[Callable[[bytes, random.Random], bytes], ...] = (_number, _number, _number, _word, _word, _word, _column)


def _places(data: object, at: tuple[object, ...] = ()) -> Iterator[tuple[object, ...]]:
    inside = data.items() if isinstance(data, dict) else enumerate(data) if isinstance(data, list) else ()
    for key, value in inside:
        yield (*at, key)
        yield from _places(value, (*at, key))


def _json(content: bytes, dice: random.Random) -> bytes:
    """Put something else in the place of a value of JSON, or leave it out."""
    try:
        data = json.loads(content)
    except (ValueError, RecursionError):
        return content
    shallow = [p for p in _places(data) if len(p) <= dice.choice((1, 2, 3, 9))]
    if not shallow:
        return content
    *path, last = dice.choice(shallow)
    inside = data
    for key in path:
        inside = inside[key]
    way = dice.randrange(4)
    if way == 0:
        del inside[last]
    elif way == 1 and isinstance(inside[last], list) and inside[last]:
        inside[last] = inside[last][:-1]
    elif way == 2 and isinstance(inside[last], (int, float)):
        inside[last] = dice.choice((-1, 0, 1e300, -inside[last], inside[last] * 1e6, int(inside[last])))
    else:
        inside[last] = dice.choice(JSONS)
    return json.dumps(data, indent=1).encode()


def _nested(content: bytes, dice: random.Random) -> bytes:
    deep = 10 ** dice.randrange(2, 6)
    return content.replace(b":", b": " + b"[" * deep, 1)


_JSON: tuple[Callable[[bytes, random.Random], bytes], ...] = (*(_json,) * 12, _nested, _number)

"""The manual's page of the ladder says what the effects' files say: every term, its formula, its units."""

from __future__ import annotations

import re

import numpy as np
import pytest

from deltacal_gen.motion.lag import LATENCY
from deltacal_gen.motion.payload import NAMES, PAYLOAD
from deltacal_gen.pages import manual
from deltacal_gen.physics.terms import drive_effect_names, load_effect

PAGE = manual.source("ladder")
EQUATION = re.search(r"```text\n(.*?)```", PAGE, re.DOTALL)
FUNCTIONS = {"sign": np.sign, "abs": np.abs, "exp": np.exp, "cos": np.cos, "sin": np.sin}
CALLED = {"turn": "q", "warming": "T"}  # states, as the page calls them


def terms() -> dict[str, str]:
    """Return the terms of the equation by the names of their effects."""
    assert EQUATION is not None
    lines = [re.split(r" {2,}", line.strip()) for line in EQUATION[1].splitlines()]
    return {name: re.sub(r"^(tau =|\+) ", "", term) for term, name in lines}


def value(formula: str, numbers: dict[str, object]) -> object:
    """Return what a formula says: products are written as names beside one another, powers with ^."""
    text = re.sub(r"[A-Za-z]\w*(?!\w*\()", lambda found: f"v_{found[0]}", formula)
    text = re.sub(r"(?<=[\w)]) (?=[\w(])", "*", text).replace("^", "**")
    return eval(text, {"__builtins__": {}}, FUNCTIONS | {f"v_{name}": v for name, v in numbers.items()})


def test_every_effect_is_a_term_and_every_term_an_effect() -> None:
    assert next(iter(terms())) == "rigid"
    assert set(terms()) == {"rigid", *drive_effect_names()}


@pytest.mark.parametrize("name", drive_effect_names())
def test_a_term_of_the_page_is_that_of_the_effects_file(name: str) -> None:
    kernels, rng = load_effect(name), np.random.default_rng(4)
    memory = [own for own, _ in getattr(kernels, "MEMORY", ())]
    inputs = [*kernels.STATE, *memory]
    s, c = rng.standard_normal((50, len(inputs))), rng.uniform(0.5, 2.0, (1, len(kernels.COEFFICIENTS)))
    constants = rng.uniform(0.5, 2.0, len(kernels.CONSTANTS)).tolist()
    numbers: dict[str, object] = {CALLED.get(n, n): s[:, k] for k, n in enumerate(inputs)}
    if "T" in numbers:
        numbers["T"] = s[:, inputs.index("warming")] + 20.0
    numbers |= {n: c[0, k] for k, (n, *_) in enumerate(kernels.COEFFICIENTS)}
    numbers |= {n: v for (n, *_), v in zip(kernels.CONSTANTS, constants, strict=True)}
    told = np.broadcast_to(np.asarray(value(terms()[name], numbers)), 50)
    assert told == pytest.approx(kernels.value(s, c, constants)[:, 0], rel=1e-12)


@pytest.mark.parametrize("name", drive_effect_names())
def test_a_rung_has_its_section_with_formula_and_units(name: str) -> None:
    section = re.search(rf"^## `{name}`\n(.*?)(?=^## )", PAGE, re.DOTALL | re.MULTILINE)
    assert section is not None
    assert f"`{terms()[name]}`" in section[1]
    for part in ("- Expect it: ", "- Without it: ", "- The page: "):
        assert part in section[1]
    words = section[1].replace("\n", " ")
    for own, unit, *_ in (*load_effect(name).COEFFICIENTS, *load_effect(name).CONSTANTS):
        assert re.search(rf"\b{own}\b", words)
        assert ({"1": "without a unit"}.get(unit, f"in {unit}") in words) or own == "order", unit


def test_what_is_no_term_is_told_beside_them() -> None:
    rest = PAGE.partition("## What is no term of it")[2]
    for name in (LATENCY, PAYLOAD, "delay", *(own for own, _ in NAMES)):
        assert f"`{name}`" in rest

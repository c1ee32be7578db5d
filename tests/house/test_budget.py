"""How large each wing of the program may be: the table of its lines only ever falls."""

from __future__ import annotations

import pytest

from tests.benchmarks.lines import Size, code_size, read_budget, wing_sizes


@pytest.fixture(scope="module")
def sizes() -> dict[str, Size]:
    return wing_sizes()


def test_no_wing_is_larger_than_its_budget(sizes: dict[str, Size]) -> None:
    budget = read_budget()
    assert set(sizes) <= set(budget), "a new wing needs a budget, and the commit the reason"
    over = {
        wing: (size, budget[wing])
        for wing, size in sizes.items()
        if size.lines > budget[wing].lines or size.tokens > budget[wing].tokens or size.data > budget[wing].data
    }
    assert over == {}, "say it once; a budget is raised only in the commit that says why"


def test_a_budget_is_lowered_where_a_wing_has_shrunk(sizes: dict[str, Size]) -> None:
    """A wing that fell by more than a page leaves its old budget to nobody."""
    budget = read_budget()
    loose = {wing: b.lines - sizes.get(wing, Size()).lines for wing, b in budget.items()}
    assert {wing: n for wing, n in loose.items() if n > 60} == {}, "python -m tests.benchmarks.lines --lower"


def test_docstrings_comments_and_blanks_are_no_code() -> None:
    function = 'def f():\n    """Say it."""\n    return x\n'
    text = f'"""What it is\n\nat length.\n"""\n\n# why\nx = (\n    1,\n    2,\n)\n\n\n{function}'
    assert code_size(text) == Size(lines=6, tokens=15)

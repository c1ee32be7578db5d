"""Rules are watched without a change, and switched off wherever the program calls them."""

from __future__ import annotations

from collections import Counter

from deltacal_gen.diagnosis import diagnosis, evidence, strategy
from tests.benchmarks.rules import RULES, Rule, original, replaced, switched_off, table, watched


def test_every_rule_is_there_once() -> None:
    assert len({rule.name for rule in RULES}) == len(RULES)
    assert all(callable(original(rule)) or isinstance(original(rule), property) for rule in RULES)


def test_a_rule_is_replaced_wherever_it_was_imported() -> None:
    before = strategy.borne_out
    assert diagnosis.borne_out is before
    with switched_off(Rule("diagnosis.strategy:borne_out", True)):
        assert diagnosis.borne_out(None, None) is True  # type: ignore[arg-type]
        assert strategy.borne_out is diagnosis.borne_out
    assert strategy.borne_out is before
    assert diagnosis.borne_out is before


def test_a_property_is_replaced() -> None:
    found = evidence.Evidence(ratio=-100.0, size=100.0, expected=100.0)
    assert found.denies
    with switched_off(Rule("diagnosis.evidence:Evidence.denies", False)):
        assert not found.denies
    assert found.denies


def test_a_rule_fires_where_it_changes_something() -> None:
    fired: Counter[str] = Counter()
    with watched(fired):
        assert evidence.Evidence(ratio=-100.0, size=100.0, expected=100.0).denies
        assert not evidence.Evidence(ratio=100.0, size=100.0, expected=100.0).denies
    assert fired["evidence.Evidence.denies"] == 1
    given = Rule("diagnosis.strategy:_proven", given=1)
    with replaced(given, lambda real: lambda *given: given[1]):
        assert strategy._proven(None, "as it was") == "as it was"  # type: ignore[arg-type,comparison-overlap]
    assert not given.fired("same", (None, "same"))
    assert given.fired(None, (None, "same"))


def test_what_changes_an_answer_is_counted() -> None:
    right, wrong = ({"said": [k], "right": not k, "error": 1.0 + k, "wrong": []} for k in (0, 1))
    name = RULES[0].name
    shown = table([{"with": right, "without": {name: wrong}}, {"with": wrong, "without": {name: wrong}}])
    first = [next(iter(column.cells)) for column in shown.columns]
    assert first == [name, "2", "1", "1", "0", "1", "0"]

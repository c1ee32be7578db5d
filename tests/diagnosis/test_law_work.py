"""How much is computed for a law, where none is to be had: a bound in solved machines, not in seconds."""

from __future__ import annotations

import dataclasses
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from deltacal_gen.diagnosis.laws import laws as of
from deltacal_gen.diagnosis.laws.ground import Tried
from deltacal_gen.diagnosis.laws.search import FormulaFit
from deltacal_gen.diagnosis.refits import refitted, terms_of
from deltacal_gen.estimation.fit import rough
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import pose_problem
from deltacal_gen.machine.backend import Backend, using
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.physics import grammar
from deltacal_gen.physics.body import Body
from tests.support.concealed import SIGMA, Case, record
from tests.support.every_effect import ARM, chain

pytestmark = pytest.mark.usefixtures("compiled")

SOFT = (
    Case("arm", "joint_compliance", (2, 3), {"compliance": 0.004}),
    Case("arm", "joint_tilt_compliance", (4,), {"compliance_x": 4e-3, "compliance_y": 5e-3}),
)
WANDERS = 3.0  # times the noise: a walk of the instrument from row to row, in no channel
READ = ("payload_kg", "level_mrad")  # channels
MOST = 380  # machines solved for all rows


@pytest.fixture(scope="module")
def known() -> Fit:
    """Return a fit that knows what makes an arm soft, of readings that wander besides."""
    arm, m = chain(ARM), mechanism_of(chain(ARM))
    terms = [case.term(arm) for case in SOFT]
    rec = record(arm, terms[0], kind="position", beside=tuple(terms[1:]))
    walk = np.cumsum(np.random.default_rng(2).standard_normal(rec.measured.shape), axis=0)
    rec = dataclasses.replace(
        rec,
        measured=rec.measured + WANDERS * SIGMA * walk / walk.std(axis=0),
        channels={name: rec.channels[name] for name in READ},
    )
    problem = pose_problem(arm, rec, m.model(m.full_model))
    at = refitted(problem, rough(problem, must_converge=False), terms)
    assert at is not None
    return at


def outcome(at: Fit) -> Any:
    """Return what a search has found, as far as laws ask."""
    return SimpleNamespace(
        problem=at.problem.with_names(at.problem.names),
        search=SimpleNamespace(
            fit=at,
            price=lambda term: 5.0 * term.n_coefficients,
            grouped=lambda terms: [(i,) for i in range(len(terms))],
        ),
        unexplained=True,
    )


@pytest.mark.walk
@using(Backend.COMPILED)
def test_where_names_explain_more_than_any_law_none_is_grown_in_their_place(
    known: Fit, monkeypatch: pytest.MonkeyPatch
) -> None:
    solved, solve = [0], Body.solve

    def counted(*given: Any) -> Any:
        solved[0] += 1
        assert solved[0] <= MOST
        return solve(*given)

    monkeypatch.setattr(Body, "solve", counted)
    assert not of.laws(outcome(known), lambda _: None).laws


@using(Backend.COMPILED)
def test_the_fit_itself_tells_which_term_may_be_needless(known: Fit, monkeypatch: pytest.MonkeyPatch) -> None:
    problem, terms = known.problem.with_names(known.problem.names), terms_of(known)
    springs, tilts, nothing = *terms, Case("arm", "joint_compliance", (5,), {"compliance": 0.0}).term(chain(ARM))
    whole = refitted(problem, known, [nothing, tilts, springs])
    assert whole is not None
    asked = list[list[str]]()

    def counted(problem: Any, at: Fit, terms: Any, **how: Any) -> Fit | None:
        asked.append([t.effect for t in terms])
        return refitted(problem, at, terms, **how)

    monkeypatch.setattr(of, "refitted", counted)
    law = Tried("joint", grammar.single("payload", grammar.Atom("payload")), (2, 3), 0.0, 20.0)
    left = of._needed(problem, FormulaFit(whole, (law,), of._prices(outcome(whole))))
    assert [t.limbs for t in terms_of(left.fit)] == [(4,), (2, 3)]
    assert len(asked) == 1 + of.DOUBTED

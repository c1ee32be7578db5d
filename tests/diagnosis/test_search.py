"""The search for what was left out, where the way to it misleads: strained geometry, events taken for each other."""

from __future__ import annotations

import itertools
from collections.abc import Sequence

import numpy as np
import pytest

from deltacal_gen.diagnosis.beside import Beside
from deltacal_gen.diagnosis.charges import SMALLEST, UNSEEN, best_set, gains
from deltacal_gen.diagnosis.diagnosis import _first, _geometry
from deltacal_gen.diagnosis.library import library
from deltacal_gen.diagnosis.refits import refitted
from deltacal_gen.diagnosis.search import Search
from deltacal_gen.estimation.fit import fit
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import pose_problem
from deltacal_gen.estimation.solvers import Prior
from deltacal_gen.identification.drawing import strained
from deltacal_gen.identification.together import deviance_of
from deltacal_gen.inference.likelihood import unit_variance
from deltacal_gen.inference.sizes import fit_sizes
from deltacal_gen.machine.backend import Backend, using
from deltacal_gen.machine.registry import Array, load_mechanism
from deltacal_gen.physics.terms import Term, blank
from tests.benchmarks.concealed_cases import generate
from tests.benchmarks.concealed_machines import EVERY, kinds
from tests.support.left_out import DELTA, SIGMA, channels, diagnosis, effect, machine, named, record
from tests.support.prototype import plausible

pytestmark = pytest.mark.usefixtures("compiled")

ROBOT = machine()
N = 120
READ = [(m, k) for m in EVERY for k in ("position", "pose") if k in kinds(load_mechanism(m))]
EARLY, LATE = 40, 80  # rows after which something happens


def geometry(*terms: Term, kind: str = "position", n: int = N) -> Fit:
    recording = record(ROBOT, *terms, kind=kind, n=n, of=channels(n, "time"))
    problem = pose_problem(ROBOT, recording, DELTA.model(DELTA.full_model))
    return fit(problem, Prior(), drop_gross=False, must_converge=False)


@pytest.mark.walk
@pytest.mark.parametrize("kind", ["position", "distance"])
def test_geometry_that_physics_strains_is_no_doubt_of_the_drawing(kind: str) -> None:
    truth = effect("joint_scale", (1, 2, 3), 0.01)
    recording = record(ROBOT, truth, kind=kind, n=N, seed=3, of=channels(N, "time"))
    assert strained(_first(_geometry(ROBOT, recording, None)[0]))
    found = diagnosis(ROBOT, recording)
    assert named(found.to_dict()) == [("joint_scale", [1, 2, 3])]
    assert "Compare the file's dimensions" not in found.summary
    assert found.final.heldout_rms_mm is not None
    assert found.final.heldout_rms_mm < 1.3 * SIGMA


def test_a_drawing_of_another_machine_is_none_of_this_one() -> None:
    far = {name: 200 * value for name, value in plausible(DELTA, 6, size=0.3).items()}
    found = diagnosis(ROBOT, record(ROBOT, n=N, seed=6, errors=far))
    assert (found.verdict, found.effects) == ("adequate", ())
    assert "Compare the file's dimensions" in found.summary


@pytest.mark.parametrize(("name", "kind"), READ)
@using(Backend.NUMPY)  # one search of a machine, as of one that was just added, does not pay for compiling it
def test_every_machine_with_all_it_may_have_is_searched(name: str, kind: str) -> None:
    """Effects of two targets of which a machine has one; turns of an instrument of which nothing is read."""
    cases = (generate("null", (), (7, 0, k), name) for k in itertools.count())
    case = next(c for c in cases if c.recording.kind == kind)
    problem, *_ = _geometry(case.robot, case.recording, None)
    first = _first(problem)
    search = Search(first, library(problem)[0])
    best = search.ranked()[0].term
    beside = refitted(problem, first, [search.estimated(best)])
    assert beside is not None
    again = Search(beside, search.terms)
    assert np.isfinite(again.freed(0).gain(again.freed(0).where(best)))
    assert np.isfinite(deviance_of(beside))


def test_gains_are_those_of_the_directions_that_are_seen() -> None:
    """Whether all are, and one solve is enough, some are not, or none."""
    rng = np.random.default_rng(3)
    for k in (1, 2, 3, 6):
        A = rng.standard_normal((300, 9, k)) * 10.0 ** -rng.integers(0, 6, (300, 1, k))
        A[::7, :, 0] = 0.0
        A[1::7, :, -1] = A[1::7, :, 0] * (1 + 1e-6 * rng.standard_normal((len(A[1::7]), 9)))
        A /= np.maximum(np.linalg.norm(A, axis=1, keepdims=True).max(axis=2, keepdims=True), 1e-12)
        G, b = A.transpose(0, 2, 1) @ A, np.einsum("mij,mi->mj", A, rng.standard_normal((300, 9)))
        for one, own, gain in zip(G, b, gains(G, b), strict=True):
            seen = np.flatnonzero(np.diagonal(one) > UNSEEN)
            inverse = np.linalg.pinv(one[np.ix_(seen, seen)], rcond=SMALLEST, hermitian=True)
            assert gain == pytest.approx(own[seen] @ inverse @ own[seen], rel=1e-5, abs=1e-12)


def test_no_columns_explain_more_than_there_is() -> None:
    """Priors hold a part of what is left: without it, as many columns as readings would leave less than nothing."""
    beside = Beside(geometry(effect("joint_scale", (1,), 0.01)))
    found = beside.model(np.eye(beside.readings))
    columns, squares = np.eye(beside.readings), beside.squares
    G, b = columns - beside.Q @ beside.Q.T, beside.residual[:, None]
    assert np.linalg.eigvalsh(np.block([[G, b], [b.T, np.array([[squares]])]]))[0] > -1e-9 * squares
    assert 0 < found.rest < squares


def test_what_is_drawn_by_chance_is_found_where_it_is() -> None:
    beside = Beside(geometry(effect("joint_scale", (1,), 0.003)))
    rng = np.random.default_rng(5)
    aligned = beside.residual[:, None] + 1e-3 * rng.standard_normal((beside.readings, 3))
    groups, owner = (
        [aligned * unit_variance(aligned), rng.standard_normal((beside.readings, 24))],
        np.repeat([0, 1], [3, 24]),
    )
    model = beside.model(np.hstack(groups))
    found = fit_sizes(model, owner, prices=2.0)
    assert np.flatnonzero(found.variances).tolist() == [0]
    assert found.deviance < model.deviance(np.zeros(27)) - 100
    # once it is fitted nothing of it is left to be drawn
    assert not fit_sizes(beside.joined(aligned).model(groups[0]), owner[:3], prices=2.0).variances.any()


def test_a_coefficient_that_no_reading_sees_is_not_beyond_what_can_be() -> None:
    """Rounding gives it a size of either sign: of a compliance half of them would be none."""
    search, form = Search(geometry(), ()), blank("joint_tilt_compliance", (1, 2))
    G, b = np.diag([1.0, 1e-17, 1.0, 1.0]), np.array([0.01, -1e-17, 0.01, -50.0])
    assert [(c.row, c.name) for c in search._beyond(form, G, b, np.ones(4))] == [(1, "compliance_y")]


def test_no_set_of_one_item_more_fewer_or_exchanged_is_worth_more() -> None:
    """Of limbs that stand for one another, 8 columns of 5 directions, either way may pass by the best set."""
    items = range(8)
    for k in range(40):
        rng = np.random.default_rng(k)
        A = rng.standard_normal((40, 5)) @ rng.standard_normal((5, 8)) + 0.05 * rng.standard_normal((40, 8))
        y = A @ (rng.standard_normal(8) * (rng.random(8) < 0.5)) + 2.0 * rng.standard_normal(40)
        A /= np.linalg.norm(A, axis=0)

        def worth(sets: Sequence[tuple[int, ...]], A: Array = A, y: Array = y) -> list[float]:
            at = np.array(sets)
            G, b = (A.T @ A)[at[:, :, None], at[:, None, :]], (A.T @ y)[at]
            return [float(gain) - 6.0 * len(s) for gain, s in zip(gains(G, b), sets, strict=True)]

        own, score = best_set(items, worth)
        beside = [s for n in (1, 2, 3, 4, 5, 6, 7, 8) for s in itertools.combinations(items, n)]
        beside = [s for s in beside if len(s) - len(own) in (-1, 0, 1) and len({*s} ^ {*own}) <= 2]
        assert max(worth([s])[0] for s in beside) < score + 1e-6

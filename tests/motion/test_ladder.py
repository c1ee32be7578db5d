"""The ladder of one joint: what is taken, what is looked at once more, and what counts as motion at all."""

from __future__ import annotations

import dataclasses
import re
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from scipy import signal

import deltacal_gen as dc
from deltacal_gen.motion import fit as fits_of_joints
from deltacal_gen.motion import identification, joint, regression, unexplained
from deltacal_gen.motion.diagnosis import _for_all_that
from deltacal_gen.motion.fit import Fit, climbed, fitted
from deltacal_gen.motion.ladder import Ladder, LookedAt
from deltacal_gen.motion.lag import with_lag
from deltacal_gen.motion.library import Rung
from deltacal_gen.motion.rigid import Rigid
from deltacal_gen.motion.session import Session
from deltacal_gen.motion.trajectories import Motion
from tests.support import motion_recordings
from tests.support.motion_recordings import session_of, usual, written

SAMPLES, FOLDS = 4000, 4


def ladder(sizes: tuple[float, ...], correlated: Callable[[np.ndarray], float]) -> Ladder:
    """Return a ladder of coulomb_friction, viscous_friction and others, each of a size beside noise of 1."""
    rng = np.random.default_rng(3)
    X, fold = rng.standard_normal((SAMPLES, len(sizes))), np.arange(SAMPLES) * FOLDS // SAMPLES
    y = X @ np.array(sizes) + rng.standard_normal(SAMPLES)
    names = ("coulomb_friction", "viscous_friction", "presliding_friction", "quadratic_friction")
    rungs = tuple(Rung(name, (0.1,) if name == "presliding_friction" else ()) for name in names[: len(sizes)])
    bench = regression.Bench.of(X, y, fold, np.empty(0))
    return Ladder(bench, rungs, tuple((c,) for c in range(len(sizes))), X, y, correlated, fold)


def test_what_drives_usually_have_must_earn_its_place_too() -> None:
    sizes = (0.4, 0.4)
    assert ladder(sizes, lambda _: 1.0).climb(range(FOLDS)) == [0, 1]
    assert (
        ladder(sizes, lambda _: 100.0).climb(range(FOLDS)) == []
    )  # samples that hang together for so long tell little


def test_a_size_that_nearly_buys_enough_is_looked_at_between_those_that_are_searched() -> None:
    near = ladder((1.0, 0.5, 0.18, 0.05), lambda _: 1.0)
    chosen = near.climb(range(FOLDS))
    assert chosen == [0, 1]
    assert near.nearly(chosen, range(FOLDS)) == [2]  # 1.6 % of the rms: a better size may buy the rest


def test_no_friction_is_below_zero() -> None:
    """Less friction while it builds up is none of that name; what grows with the square of the speed may be less."""
    assert ladder((1.0, 0.5, -0.3, -0.3), lambda _: 1.0).climb(range(FOLDS)) == [0, 1, 3]
    assert ladder((-1.0, 0.5, 0.3), lambda _: 1.0).climb(range(FOLDS)) == [1, 2]


def test_what_bodies_take_up_in_a_fit_and_do_not_foretell_is_of_the_drive() -> None:
    one = ladder((1.0, 0.5), lambda _: 1.0)
    fold = np.arange(SAMPLES) * FOLDS // SAMPLES
    alike = one.X[:, [1]] * (fold[:, None] == np.arange(FOLDS))  # in every run another column does the same
    X = np.hstack([alike, one.X])
    at = tuple((FOLDS + c,) for c in range(2))
    bench = regression.Bench.of(X, one.y, fold, np.ones(FOLDS))
    known = dataclasses.replace(one, bench=bench, X=X, at=at, correlated=lambda _: 20.0, counted={})
    assert known.gain([0, 1], 1, range(FOLDS)) < known.charge(1)
    assert known.foretells([0, 1], 1, range(FOLDS)) > 3 * known.charge(1)
    assert known.climb(range(FOLDS)) == [0, 1]
    assert known.earned([0, 1], 1, range(FOLDS)) == known.foretells([0, 1], 1, range(FOLDS))  # what answers tell


def test_what_a_ridge_presumes_is_no_knowledge() -> None:
    rng = np.random.default_rng(5)
    one = rng.standard_normal(SAMPLES)
    X = np.column_stack([one, one + 1e-3 * rng.standard_normal(SAMPLES)])
    bench = regression.Bench.of(X, one, np.arange(SAMPLES) % FOLDS, np.ones(2))
    variance = np.diag(np.linalg.inv((X / bench.scale).T @ (X / bench.scale)))
    for ridge in regression.RIDGES:
        known = dataclasses.replace(bench, ridge=ridge).covariance(range(2))
        np.testing.assert_allclose(np.diag(known), variance, rtol=0.01)


def test_a_clock_that_jumps_leaves_stretches_to_hold_out() -> None:
    time = np.arange(3000) * 0.01 + 3600.0 * (np.arange(3000) >= 1500)
    fold, held = regression.folds_of(time, np.zeros(3000, dtype=int), np.ones(3000, dtype=bool))
    assert set(held) == set(range(regression.FOLDS))
    assert min((fold == k).sum() for k in range(regression.FOLDS)) > 100


@pytest.mark.parametrize(("seconds", "folds"), [(2.5, 1), (2.7, 2), (4.2, 2), (4.3, 3), (7.5, 5), (12.0, 5)])
def test_a_short_movement_is_held_out_by_as_many_seconds_as_it_has(seconds: float, folds: int) -> None:
    """Of samples between two stretches no fit takes any; at the ends there is nothing to keep away from."""
    time = np.arange(0, seconds, 0.01)
    fold, held = regression.folds_of(time, np.zeros(len(time), dtype=int), np.ones(len(time), dtype=bool))
    assert set(held) == set(range(folds))
    assert fold[0] == 0
    assert fold[-2] >= 0
    for k in np.flatnonzero(np.diff(held)):
        assert (fold[k - 28 : k + 29] == regression.BETWEEN).all()
    stretches = np.flatnonzero(np.diff((fold == regression.BETWEEN).astype(int), prepend=1, append=1))
    assert np.diff(stretches)[::2].min() >= 99


@pytest.mark.parametrize(
    ("seconds", "seed", "whole"),
    [(4.0, 1, False), (4.0, 7, False), (5.0, 3, True), (6.0, 8, True), (8.0, 3, True)],
)
def test_one_short_movement_tells_usual_friction_and_nothing_that_is_not_there(
    seconds: float, seed: int, whole: bool, tmp_path: Path
) -> None:
    """Stretches choose for one another what does not hold there; a delay does what a term that lacks would."""
    true = {("coulomb_friction", 1), ("viscous_friction", 1), ("coulomb_friction", 2), ("viscous_friction", 3)}
    found = set()
    for each in session_of(written(tmp_path, usual, runs=1, seed=seed, seconds=seconds)).moving:
        fit = with_lag(climbed(each))
        found |= {(rung.effect, each.number) for rung in fit.rungs}
        assert fit.lag is None
    assert found == true if whole else found < true


@pytest.mark.walk
@pytest.mark.parametrize("delay", [0.06, -0.12])
def test_a_long_delay_is_found_in_quick_samples_too(
    delay: float, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Thirty samples of 2 ms, and sixty."""
    monkeypatch.setattr(motion_recordings, "STEP", 0.002)
    recording = written(tmp_path, usual, runs=3, seed=2, seconds=4.0, delay=(0.0, 0.0, delay))
    fit = with_lag(climbed(session_of(recording).joints[2]))
    assert fit.lag is not None
    assert abs(fit.lag.delay - delay) < 4 * fit.lag.std < 0.01
    assert [rung.effect for rung in fit.rungs] == ["viscous_friction"]


def test_what_is_held_out_is_that_of_fits_to_the_other_folds() -> None:
    one = ladder((1.0, 0.5, 0.2), lambda _: 1.0)
    left = np.empty(SAMPLES)
    fold = np.arange(SAMPLES) * FOLDS // SAMPLES
    for k in range(FOLDS):
        own = fold == k
        left[own] = one.y[own] - one.X[own] @ np.linalg.lstsq(one.X[~own], one.y[~own], rcond=None)[0]
    assert one.bench.held_out([0, 1, 2], range(FOLDS)) == pytest.approx(float(np.mean(left**2)), rel=1e-6)
    values = np.sin(np.arange(SAMPLES))
    other = one.X.copy()
    other[:, 1] = values * one.bench.scale[1]
    moved = one.bench.with_columns([1], other, one.y, fold)
    same = regression.Bench.of(other, one.y, fold, np.empty(0))
    by = np.array([1.0, one.bench.scale[1] / same.scale[1], 1.0])
    np.testing.assert_allclose(moved.G * by * by[:, None], same.G, atol=1e-8)
    np.testing.assert_allclose(moved.g * by, same.g, atol=1e-8)


def test_samples_that_hang_together_are_counted_within_movements() -> None:
    rng = np.random.default_rng(1)
    piece, used = np.repeat([0, 1, 2], [500, 300, 700]), rng.random(1500) > 0.2
    residual = np.convolve(rng.standard_normal(1510), np.ones(11) / 11, "valid")
    r, total = np.where(used, residual, 0.0), 1.0
    power = r @ r / used.sum()
    for lag in range(1, 200):
        both = used[lag:] & used[:-lag] & (piece[lag:] == piece[:-lag])
        rho = (r[lag:] * r[:-lag])[both].mean() / power
        if rho < 2.0 / np.sqrt(both.sum()):
            break
        total += 2 * rho
    assert total > 5
    assert regression.together(residual, piece, used, 0.01) == pytest.approx(total, rel=1e-9)
    assert regression.together(np.zeros(1500), piece, used, 0.01) == 1.0


def test_noise_that_hangs_together_for_milliseconds_is_noise_at_any_rate() -> None:
    rng, rough = np.random.default_rng(2), {}
    noise = signal.lfilter([1.0], [1.0, -np.exp(-1 / 12)], rng.standard_normal(40000))  # over 12 ms, at 1 kHz
    for every in (1, 2, 5, 10):
        left, there = noise[::every], rng.random(40000 // every) > 0.2
        own = SimpleNamespace(rows=np.flatnonzero(there), piece=np.arange(len(left)) // 900, step=0.001 * every)
        fit: Any = SimpleNamespace(joint=own, left=left[there])
        rough[every] = unexplained._rough(fit) / np.std(left)
    assert list(rough.values()) == pytest.approx([rough[10]] * 4, rel=0.06)
    assert 1 / rough[1] < unexplained.SMOOTH / 2


def test_a_joint_that_others_shake_stands() -> None:
    time = np.arange(0, 20, 0.01)
    speeds = np.column_stack([np.sin(time), 0.02 * np.sin(time), 0.002 * np.sin(time)])
    states = np.stack([np.zeros_like(speeds), speeds, np.zeros_like(speeds)])
    known = Motion(states, np.zeros((2, 3)), np.zeros(len(time), dtype=bool), 5.0, 0.0, "")
    below = [joint.resting_below(known, j, ["rad"] * 3) for j in range(3)]
    assert below[:2] == pytest.approx([0.01, 0.0002], rel=0.01)
    assert below[2] == np.abs(speeds[:, 2]).max()  # none of its samples is in motion
    alone = joint.resting_below(known, 2, ["rad", "rad", "mm"])
    assert alone == pytest.approx(0.00002, rel=0.01)  # of its unit nothing moves more


@pytest.fixture(scope="module")
def session(tmp_path_factory: pytest.TempPathFactory) -> Session:
    return session_of(written(tmp_path_factory.mktemp("arm"), usual, runs=3))


def test_what_foretells_worse_than_nothing_is_said_to(session: Session) -> None:
    fit = fit_of(session)
    assert unexplained.rest(fit, None) is None
    poor = dataclasses.replace(fit, held_out=2.0 * fit.joint.y)
    found = unexplained.rest(poor, None)
    assert found is not None
    assert "of joint 1 is off by 2 times what its drive gives on samples that took no part" in found.text


def test_what_folds_choose_and_do_not_foretell_is_not_told(session: Session, monkeypatch: pytest.MonkeyPatch) -> None:
    """Effects may buy something on every fold beside each other, and what the others choose nothing on any of them."""
    one = session.joints[0]
    assert climbed(one).rungs
    plain = fitted(one, [])
    monkeypatch.setattr(fits_of_joints, "_apart", lambda joint, _ladder, _others, own: 0.99 * plain.held_out[own])
    found = climbed(one)
    assert found.rungs == ()
    np.testing.assert_array_equal(found.held_out, plain.held_out)
    assert {each.effect for each in found.passed_over} >= {"coulomb_friction", "viscous_friction"}


def test_what_buys_by_a_wrong_sign_is_said_to(session: Session) -> None:
    """It takes away what a rung must, earns its price, and is not named: without a reason that reads as a mistake."""
    turned = dataclasses.replace(session.joints[0])
    vars(turned)["sense"] = -1.0  # friction that brakes is what no drive has then
    found = climbed(turned)
    dry = next(each for each in found.passed_over if each.effect == "coulomb_friction")
    assert dry.impossible
    much = dataclasses.replace(dry, buys=0.03, gain=75.0)
    assert _for_all_that(much) == ", but by a coefficient of the wrong sign, which no drive has"


@pytest.mark.parametrize(("effect", "words"), [("presliding_friction", "but what"), ("torque_ripple", "but a smooth")])
def test_what_earns_its_price_and_is_not_named_has_a_reason_beside_other_rungs(effect: str, words: str) -> None:
    """Drives of a short recording keep usual friction where folds choose more that does not hold."""
    said = _for_all_that(LookedAt(effect, gain=72.0, width=1, tried=20, buys=0.37))
    assert words in said
    assert "does not foretell the others" in said


def fit_of(session: Session) -> Fit:
    return fitted(session.joints[0], [Rung("coulomb_friction"), Rung("viscous_friction")])


def test_noise_of_velocities_and_accelerations_is_a_part_of_the_noise(session: Session) -> None:
    noise = np.array([[0.02, 0.01, 0.03], [0.4, 0.3, 0.9]])
    session = dataclasses.replace(session, motion=dataclasses.replace(session.motion, noise=noise))
    fit, rng = fit_of(session), np.random.default_rng(0)
    states = session.motion.states[:, fit.joint.rows]
    blurred = states.copy()
    blurred[1:] += noise[:, None] * rng.standard_normal(states[1:].shape)
    rigid = [session.rigid.columns(s)[0] @ fit.coefficients[: fit.joint.X.shape[1]] for s in (states, blurred)]
    viscous = fit.coefficients[-1] * (blurred - states)[1, :, 0]
    by_chance = np.sqrt(np.mean((rigid[1] - rigid[0] + viscous) ** 2))
    assert session.of_joints(fit) == pytest.approx(by_chance, rel=0.05)


def test_what_tolerances_leave_is_what_a_fit_to_another_machine_leaves(session: Session) -> None:
    """Torques of a machine with an error, fitted with the regressor of one without: they leave that error's part."""
    assert session.of_geometry(fit_of(session)) is None
    name, size = "alpha_2", 0.004
    known = dataclasses.replace(session, robot=dataclasses.replace(session.robot, tolerance={name: size}))
    fit = fit_of(known)
    X = fit.joint.columns(fit.rungs, fit.load)
    X = X / np.linalg.norm(X, axis=0)
    inertia = np.zeros(len(session.rigid.names))
    inertia[session.rigid.own[0].chosen] = fit.coefficients[: session.rigid.own[0].rank]
    other = Rigid(dataclasses.replace(session.robot, errors={name: size}))
    states = session.motion.states[:, fit.joint.rows]
    change = (other.torque(states, inertia) - session.rigid.torque(states, inertia))[:, 0]
    left = change - X @ np.linalg.lstsq(X, change, rcond=1e-12)[0]
    found = known.of_geometry(fit)
    assert found == pytest.approx(np.sqrt(np.mean(left**2)), rel=0.1)
    assert found < 0.9 * np.sqrt(np.mean(change**2))  # bodies take up the rest


def test_bodies_that_could_be_built_have_drives_that_could(session: Session) -> None:
    links = tuple(link._replace(rotor_inertia=1e5) for link in session.robot.links)
    rigid = Session.of(dataclasses.replace(session.robot, links=links), session.given)
    fits = [fitted(each, [Rung("coulomb_friction"), Rung("viscous_friction")]) for each in rigid.moving]
    found = {each.name: each.value for each in identification.bodies_told(rigid.rigid, fits)["consistent"]}
    assert list(found) == list(rigid.rigid.names)
    assert all(found[f"rotor_{i}"] >= 0 for i in (1, 2, 3))
    made = rigid.rigid.common.made_up @ np.array(list(found.values()))
    told = {p.name: p for p in identification.base_parameters(rigid.rigid, fits)}
    values = np.array([told[name].value for name, _ in rigid.rigid.words(rigid.rigid.common)])
    values = values + rigid.rigid.stated_base(rigid.rigid.common)
    std = np.array([told[name].std for name, _ in rigid.rigid.words(rigid.rigid.common)])
    assert np.sqrt(np.mean(((made - values) / std) ** 2)) < 3


def test_what_takes_much_away_and_is_not_named_says_why(tmp_path: Path) -> None:
    """Of a short recording friction takes much of what is left away, and does not earn what its search costs."""
    told = dc.diagnose(tmp_path / "robot.toml", written(tmp_path, usual, runs=1, seconds=5.0))["rejected"]
    most = [r["why"] for r in told if float(r["why"].split()[2]) >= 10]
    assert most
    for why in most:
        assert re.search(r"its search costs \d|does not foretell the others", why), why


def test_two_effects_of_which_neither_pays_alone_are_found_together() -> None:
    """What the other explains hangs together while it is not taken, and counts as few samples: slow waves here."""
    rng, at, step = np.random.default_rng(4), np.arange(600), 0.01
    X = np.column_stack([np.cos(2 * np.pi * at / 300), np.sin(2 * np.pi * at / 300)])
    y, fold = X @ [1.0, 1.1] + 0.01 * rng.standard_normal(600), at // 300
    rungs = Rung("torque_offset"), Rung("quadratic_friction")

    def correlated(left: np.ndarray) -> float:
        return regression.together(left, fold, np.ones(600, dtype=bool), step)

    bench = regression.Bench.of(X, y, fold, np.empty(0))
    ladder = Ladder(bench, rungs, ((0,), (1,)), X, y, correlated, fold)
    assert all(ladder.gain([k], k, bench.folds) < ladder.charge(k) for k in (0, 1))
    assert sorted(ladder.climb(bench.folds)) == [0, 1]
    alone = dataclasses.replace(ladder, y=X[:, 0], bench=regression.Bench.of(X, X[:, 0], fold, np.empty(0)), counted={})
    assert alone.climb(bench.folds) == [0]


@pytest.mark.parametrize(
    ("gains", "foretold", "pays"),
    [((5.0, 50.0), (30.0, 0.0), True), ((5.0, 50.0), (9.0, 0.0), False), ((5.0, 9.0), (30.0, 30.0), False)],
)
def test_of_two_effects_one_may_earn_its_charge_where_it_took_no_part(
    gains: tuple[float, float], foretold: tuple[float, float], pays: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The other must in the fit: of short stretches two waves foretell each other. One alone must, too."""
    for name, values in {"gain": gains, "foretells": foretold, "charge": (10.0, 10.0)}.items():
        monkeypatch.setattr(Ladder, name, lambda self, *of, values=values: values[of[1] if len(of) > 1 else of[0]])
    monkeypatch.setattr(Ladder, "impossible", lambda self, *_: [])
    of_two = ladder((0.0, 0.0), lambda _: 1.0)
    assert of_two._pays([0, 1], [0, 1], (0, 1)) is pays
    assert of_two._pays([0, 1], [0], (0, 1)) is False

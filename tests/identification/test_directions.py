"""Noise that is not alike in all directions: found whatever its tails, weighed, said; physics along an axis is none."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

from deltacal_gen.diagnosis.diagnosis import diagnose
from deltacal_gen.estimation.directions import levelling, shape_of
from deltacal_gen.estimation.residuals import Repeats
from deltacal_gen.identification.identification import identify
from deltacal_gen.machine.values import Recording
from deltacal_gen.physics.terms import Term
from tests.benchmarks.honesty_nulls import ROBOT, SIGMA, drawn, null
from tests.support.left_out import effect, record

pytestmark = pytest.mark.usefixtures("compiled")

AXES = np.array([0.6, 0.8, 1.4])  # about of unit mean square


@pytest.mark.parametrize("sort", ["white", "laplace", "t3"])
def test_a_shape_is_found_whatever_the_tails(sort: str) -> None:
    found = shape_of(drawn(sort, (400, 3), np.random.default_rng(2)) * AXES)
    assert found is not None
    assert np.trace(found) == pytest.approx(3.0)
    assert np.sqrt(np.diag(found)) == pytest.approx(AXES / np.sqrt(np.mean(AXES**2)), rel=0.15)


@pytest.mark.parametrize("sort", ["white", "uniform", "t3"])
def test_noise_alike_in_all_directions_has_no_shape(sort: str) -> None:
    rng = np.random.default_rng(4)
    radius = np.abs(drawn(sort, (100, 1), rng))  # of tails that a whole reading has
    alike = [rng.standard_normal((100, 3)) * (radius if sort == "t3" else 1.0) for _ in range(300)]
    assert sum(shape_of(z) is not None for z in alike) <= 3


def test_few_readings_have_no_shape() -> None:
    assert shape_of(np.random.default_rng(1).standard_normal((24, 3)) * AXES) is None
    assert shape_of(np.ones((100, 1))) is None
    exact = np.random.default_rng(1).standard_normal((100, 3)) * [1.0, 1.0, 0.0]
    assert shape_of(exact) is None
    assert shape_of(exact + np.where(np.arange(100)[:, None] < 5, 1.0, 1e-9)) is None  # but for a few


def test_what_is_levelled_is_alike_in_all_directions() -> None:
    half = np.random.default_rng(3).standard_normal((3, 3))
    shape = half @ half.T
    level = levelling(shape)
    assert level @ shape @ level.T == pytest.approx(np.eye(3), abs=1e-9)
    values = np.random.default_rng(1).standard_normal((7, 3, 2))
    own = Repeats(np.arange(7), shape=shape).whiten(values)
    assert own[4, :, 1] == pytest.approx(level @ values[4, :, 1])


@pytest.mark.walk
@pytest.mark.parametrize("k", [4])
def test_noise_with_directions_beside_tails_and_time_is_noise(k: int) -> None:
    found = diagnose(ROBOT, null("AR mixed", k)).answer()
    assert (found.verdict, found.effects) == ("adequate", ())
    model = found.noise.model
    assert model is not None
    assert model.columns is not None
    assert model.columns[2] > 1.5 * model.columns[0]
    assert model.rows > 3
    assert "times that along" in model.text


@pytest.mark.walk
@pytest.mark.parametrize("k", [25, 37])
def test_directions_that_rows_show_once_freed_are_no_slip(k: int) -> None:
    """Before they are, noise that is larger along one axis is one that wanders beside an instrument that slips."""
    found = diagnose(ROBOT, null("AR mixed", k)).answer()
    assert (found.verdict, found.effects) == ("adequate", ())


def _read(*effects: Term, seed: int = 11) -> Recording:
    exact = record(ROBOT, *effects, n=100, sigma=0.0, declared=False)
    e = np.random.default_rng(seed).standard_normal((100, 3)) * AXES / np.sqrt(np.mean(AXES**2))
    return dataclasses.replace(exact, measured=exact.measured + SIGMA * e)


def test_identify_weighs_directions() -> None:
    fitted = identify(ROBOT, _read()).fit
    assert fitted.repeats.shape is not None
    assert fitted.sigma[0] == pytest.approx(SIGMA, rel=0.15)


@pytest.mark.walk
def test_physics_along_one_axis_is_no_noise() -> None:
    found = diagnose(ROBOT, _read(effect("distal_compliance", (1, 2, 3), *[1e-2] * 3))).answer()
    assert [e.name for e in found.effects] == ["distal_compliance"]
    assert found.noise.model is not None
    assert found.noise.model.columns is not None

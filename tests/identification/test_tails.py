"""Tails of noise: told where they are heavy, and its size is then that of noise with such tails."""

from __future__ import annotations

import numpy as np
import pytest

from deltacal_gen.diagnosis.diagnosis import diagnose
from deltacal_gen.estimation.residuals import CLIPPED, HUBER
from deltacal_gen.identification.identification import identify
from deltacal_gen.identification.tails import NO_TAILS, tails
from tests.benchmarks.honesty_nulls import ROBOT, SIGMA, null

DRAWN = {
    "normal": lambda n, rng: rng.standard_normal(n),
    "uniform": lambda n, rng: rng.uniform(-(3**0.5), 3**0.5, n),
    "Laplace": lambda n, rng: rng.laplace(0, 0.5**0.5, n),
    "Student": lambda n, rng: rng.standard_t(3, n) / 3**0.5,
}
ERRORS = {"Laplace": 0.06, "Student": 0.1}  # of 600: who knows the shape errs by 0.04 in either


def robust(e: np.ndarray) -> float:
    """Return the size that a fit counts with (Huber's proposal 2)."""
    size = 1.4826 * float(np.median(np.abs(e)))
    for _ in range(20):
        size *= float(np.sqrt(np.mean(np.clip(e / size, -HUBER, HUBER) ** 2) / CLIPPED))
    return size


@pytest.mark.parametrize("shape", ["normal", "uniform"])
def test_light_tails_are_not_spoken_of(shape: str) -> None:
    rng = np.random.default_rng(1)
    assert all(tails(DRAWN[shape](300, rng)) == NO_TAILS for _ in range(200))


@pytest.mark.parametrize("shape", ERRORS)
def test_of_heavy_tails_the_shape_is_told_and_the_size_is_their_standard_deviation(shape: str) -> None:
    rng, found, off = np.random.default_rng(2), [], []
    for _ in range(200):
        e = DRAWN[shape](600, rng)
        size = robust(e)
        found.append(tails(e / size))
        off.append(size * found[-1].spread - 1)
    assert np.mean([f.shape == shape for f in found]) > 0.75
    assert np.mean([f.shape is not None for f in found]) > 0.9
    assert np.sqrt(np.mean(np.square(off))) < ERRORS[shape]


def test_what_fits_exactly_has_no_tails() -> None:
    assert tails(np.zeros(10)) == NO_TAILS


@pytest.mark.walk
def test_answers_tell_tails_in_words_and_count_with_them() -> None:
    recording = null("t3", 8)  # declares nothing
    found = diagnose(ROBOT, recording).answer()
    model = found.noise.model
    assert model.tails == "Student"
    assert model.degrees in (3, 4, 5)
    assert f"as frequent as in Student's distribution with {model.degrees:g} degrees of freedom" in model.text
    assert found.noise.sigma_mm == pytest.approx(SIGMA, rel=0.25)
    told = identify(ROBOT, recording).answer()
    assert told.sigma_mm > 1.05 * told.residual_sigma_mm

"""Sizes by evidence, against a textbook's and another library's, and by simulation."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.stats import chi2, kstest

from deltacal_gen.inference.likelihood import MixedModel
from deltacal_gen.inference.projection import basis
from deltacal_gen.inference.sizes import fit_sizes

# yield of dyestuff [g], five samples of each of six batches (Davies and Goldsmith 1972, Statistical Methods in Research
# and Production, table 6.3); standard deviations by REML: Bates et al. 2015, lme4
DYESTUFF = np.array(
    [
        [1545, 1440, 1440, 1520, 1580],
        [1540, 1555, 1490, 1560, 1495],
        [1595, 1550, 1605, 1510, 1560],
        [1445, 1440, 1595, 1465, 1545],
        [1595, 1630, 1515, 1635, 1625],
        [1520, 1455, 1450, 1480, 1445],
    ],
    dtype=float,
)
WITHIN = (1e-3, 1e6)


def test_dyestuff_is_as_the_textbook_has_it() -> None:
    Z = np.kron(np.eye(6), np.ones((5, 1)))
    model = MixedModel.of(Z, DYESTUFF.ravel(), basis(np.ones((30, 1))))
    found = fit_sizes(model, np.zeros(6, dtype=int), WITHIN)
    assert found.noise**0.5 == pytest.approx(49.51, abs=0.01)
    assert (found.variances[0] * found.noise) ** 0.5 == pytest.approx(42.00, abs=0.01)
    # of a balanced design the estimates are those of the analysis of variance
    within = DYESTUFF.var(axis=1, ddof=1).mean()
    between = DYESTUFF.mean(axis=1).var(ddof=1) - within / 5
    assert found.noise == pytest.approx(within, rel=1e-6)
    assert found.variances[0] * found.noise == pytest.approx(between, rel=1e-6)
    # the noise sought beside the variance, not profiled
    both = fit_sizes(model, np.zeros(6, dtype=int), WITHIN, noise=(1.0, 1e6))
    assert both.noise == pytest.approx(found.noise, rel=1e-5)
    assert both.variances[0] == pytest.approx(between, rel=1e-4)


def test_crossed_effects_are_as_another_library_has_them() -> None:
    import pandas
    import statsmodels.api as sm  # takes seconds

    rng = np.random.default_rng(7)
    a, b = rng.integers(0, 12, 300), rng.integers(0, 9, 300)
    x = rng.standard_normal(300)
    y = 1 + 2 * x + 1.5 * rng.standard_normal(12)[a] + 0.6 * rng.standard_normal(9)[b] + rng.standard_normal(300)
    frame = pandas.DataFrame({"y": y, "x": x, "a": a, "b": b, "whole": 1})
    known = sm.MixedLM.from_formula(
        "y ~ x", frame, groups="whole", re_formula="0", vc_formula={"a": "0 + C(a)", "b": "0 + C(b)"}
    ).fit(reml=True)
    Z = np.column_stack([np.eye(12)[a], np.eye(9)[b]])
    model = MixedModel.of(Z, y, basis(np.column_stack([np.ones(300), x])))
    found = fit_sizes(model, np.repeat([0, 1], [12, 9]), WITHIN)
    assert found.noise == pytest.approx(known.scale, rel=1e-3)
    assert found.variances * found.noise == pytest.approx(np.asarray(known.vcomp), rel=1e-2)


def test_sizes_are_where_the_slope_is_none() -> None:
    rng = np.random.default_rng(3)
    Z, owner = rng.standard_normal((60, 12)), np.repeat([0, 1, 2], 4)
    y = Z @ (np.array([2.0, 0.5, 1.0])[owner] * rng.standard_normal(12)) + rng.standard_normal(60)
    model = MixedModel.of(Z, y, np.zeros((60, 0)))
    found = fit_sizes(model, owner, WITHIN)
    by, _ = model.slopes(found.variances[owner])
    assert np.bincount(owner, by) == pytest.approx(np.zeros(3), abs=1e-4)
    around = [model.deviance((found.variances * f)[owner]) for f in rng.uniform(0.5, 2.0, (50, 3))]
    assert min(around) > found.deviance


def test_a_prior_of_the_size_draws_to_it() -> None:
    model = MixedModel.of(np.eye(3), np.full(3, 20.0), np.zeros((3, 0)))
    free = fit_sizes(model, np.zeros(3, dtype=int), WITHIN, noise=1.0)
    held = fit_sizes(model, np.zeros(3, dtype=int), WITHIN, noise=1.0, spread=0.1)
    assert free.variances[0] == pytest.approx(399.0, rel=1e-5)  # y^2 = variance + noise
    assert 1.0 < held.variances[0] < 10.0
    assert held.deviance == pytest.approx(
        model.deviance(np.repeat(held.variances, 3), 1.0) + (0.5 * np.log(held.variances[0]) / 0.1) ** 2
    )


def test_effects_of_no_block_have_the_variance_one() -> None:
    rng = np.random.default_rng(4)
    y = np.append(3.0 * rng.standard_normal(40), rng.standard_normal(5))
    model = MixedModel.of(np.eye(45), y, np.zeros((45, 0)))
    owner = np.repeat([0, -1], [40, 5])
    found = fit_sizes(model, owner, WITHIN, noise=0.5)
    assert found.variances[0] == pytest.approx(np.mean(y[:40] ** 2) - 0.5, rel=1e-5)


def test_a_block_that_is_not_there_has_the_null_of_a_boundary() -> None:
    """What it gains is 0 half of the time, else chi-square of one degree of freedom."""
    rng = np.random.default_rng(5)
    Z, Q = rng.standard_normal((200, 40)) / 200**0.5, basis(np.ones((200, 1)))
    gains = []
    for _ in range(300):
        model = MixedModel.of(Z, rng.standard_normal(200), Q).diagonal()
        gains.append(model.deviance(np.zeros(40)) - fit_sizes(model, np.zeros(40, dtype=int), WITHIN).deviance)
    there = np.array(gains)[np.array(gains) > 1e-3]
    assert len(there) / 300 == pytest.approx(0.5, abs=0.12)
    assert kstest(there, chi2(1).cdf).pvalue > 1e-3


def test_a_price_keeps_out_what_chance_brings() -> None:
    rng = np.random.default_rng(6)
    Z, owner = rng.standard_normal((80, 30)), np.repeat(np.arange(10), 3)
    y = Z[:, :3] @ np.array([3.0, -2.0, 2.5]) + rng.standard_normal(80)
    found = fit_sizes(MixedModel.of(Z, y, np.zeros((80, 0))), owner, WITHIN, prices=10.0)
    assert np.flatnonzero(found.variances).tolist() == [0]


def test_simulated_effects_lie_within_their_posterior() -> None:
    """Simulation-based calibration in small: ranks of true effects among the posterior's are uniform."""
    rng = np.random.default_rng(8)
    Z, Q, size, noise = rng.standard_normal((50, 6)), basis(rng.standard_normal((50, 3))), 1.3, 0.8
    ranks = []
    for _ in range(200):
        c = size**0.5 * rng.standard_normal(6)
        y = Z @ c + noise**0.5 * rng.standard_normal(50)
        mean, C = MixedModel.of(Z, y, Q).posterior(np.full(6, size), noise)
        ranks.append((c[0] - mean[0]) / C[0, 0] ** 0.5)
    assert kstest(ranks, "norm").pvalue > 1e-3

"""The comparison of methods in Savoure et al. 2006, section III.B: every equation and stated figure, decided."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from tests.claims.independent_savoure import (
    BASE,
    CHECK,
    CONFIGURATIONS,
    DEG,
    ERRORS,
    LENGTHS,
    NOMINAL,
    PLANAR,
    SIGMA,
    Study,
    planar_closed_form,
    planar_pose,
    planar_sensitivity,
    rank,
    study,
)

# ------------------------------------------------------------------------------------------------ III.B: the comparison


PLANAR_SCALE = np.array([1 / 950.0, *np.ones(8)])


def stacked(printed: bool = False, tool: float = 100.0) -> np.ndarray:
    return np.concatenate([planar_sensitivity(at, tool, printed=printed) for at in CONFIGURATIONS])


def test_configurations() -> None:
    assert len(CONFIGURATIONS) == 19
    assert len(CHECK) == 91


def test_table_2() -> None:
    """Nine errors of nine parameters; the nominal machine is a parallelogram; only five errors, and q0's, are not 0."""
    assert len(ERRORS) == len(NOMINAL) == 9
    assert NOMINAL[1] + NOMINAL[2] == NOMINAL[4] + NOMINAL[5]
    assert np.count_nonzero(ERRORS) == 6
    for at in CHECK[::15]:
        assert np.isfinite(planar_closed_form(at, NOMINAL + ERRORS, 100.0)).all()  # it can be assembled everywhere


def test_six_of_nine_errors_are_identifiable() -> None:
    for tool in LENGTHS:
        found, gap = rank(stacked(tool=tool), PLANAR_SCALE)
        assert found == 6
        assert gap > 1e6
    assert rank(stacked(printed=True), PLANAR_SCALE)[0] == 7  # eq. (65) as printed contradicts the count


def test_eq_70_to_72() -> None:
    """A null direction for each: the pair moved so that the combination stays, nothing is seen."""
    for base, other, sign in (("a2x", "b2x", 1), ("a2y", "b2y", 1), ("b1x", "a1x", 1)):
        e = np.zeros(9)
        e[PLANAR.index(base)], e[PLANAR.index(other)] = 1.0, float(sign)  # base - other = 0
        assert np.abs(stacked() @ e).max() < 1e-9
        if base == "b1x":
            assert np.abs(stacked(printed=True) @ e).max() > 0.1


def test_base_parameters_hold_to_first_order() -> None:
    """Both of a pair moved alike: nothing at the nominal machine, more than the noise at that of Table 2."""
    found = []
    for pair in (("a2x", "b2x"), ("a2y", "b2y"), ("b1x", "a1x")):
        both = np.isin(PLANAR, pair).astype(float)

        def moved(k: np.ndarray, both: np.ndarray = both) -> np.ndarray:
            change = [planar_pose(q, k + both, 100.0) - planar_pose(q, k, 100.0) for q in CONFIGURATIONS]
            return np.abs(change).max(axis=0)

        assert moved(NOMINAL).max() < 1e-12
        whole, half = moved(NOMINAL + ERRORS), moved(NOMINAL + ERRORS / 2)
        found.append(whole[:2].max())
        assert np.degrees(whole[2]) > 0.008
        assert half[2] / whole[2] == pytest.approx(0.5, abs=0.03)
    assert found == pytest.approx([0.019, 0.020, 0.017], abs=0.0005)


def test_eq_73() -> None:
    columns = [PLANAR.index(name) for name in BASE]
    assert len(columns) == 6
    assert rank(stacked()[:, columns], PLANAR_SCALE[columns])[0] == 6


def test_eq_74() -> None:
    """Two columns, independent over the configurations; the machine has one rod, `l` of eq. (38)."""
    H = np.column_stack([950 * np.cos(CONFIGURATIONS), np.sin(CONFIGURATIONS)])
    assert np.linalg.matrix_rank(H / [950.0, 1.0]) == 2


@cache
def run(tool: float, seed: int | None = 0, noise: float = 1.0, step: float = 5.0) -> Study:
    configurations = np.arange(-45.0, 45.0 + step / 2, step) * DEG
    rng = None if seed is None else np.random.default_rng(seed)
    return study(tool, rng, configurations=configurations, noise=noise)


def worst(values: np.ndarray) -> float:
    return float(np.abs(values).max())


@pytest.mark.parametrize("tool", LENGTHS)
def test_three_curves(tool: float) -> None:
    """The largest error at every tool length: none > classical > 15 times improved."""
    for seed in range(3):
        found = run(tool, seed)
        assert worst(found.none) > 3 * worst(found.classical) > 45 * worst(found.improved)


def test_the_curves_in_numbers() -> None:
    """What the ledger quotes, without noise [mm]."""
    quoted = {0.0: (1.672, 0.239, 0.0063), 100.0: (1.966, 0.632, 0.0084), 200.0: (5.604, 1.543, 0.0820)}
    for tool, values in quoted.items():
        found = run(tool, seed=None)
        measured = (worst(found.none), worst(found.classical), worst(found.improved))
        assert measured == pytest.approx(values, rel=0.01)


def test_the_difference_grows_with_the_tool() -> None:
    gap = [worst(run(tool).classical) - worst(run(tool).improved) for tool in LENGTHS]
    assert gap[0] < gap[1] < gap[2]
    turned = [np.abs(planar_closed_form(CHECK, NOMINAL + ERRORS, tool)[:, 2]).max() for tool in LENGTHS]
    assert turned[0] == pytest.approx(turned[2])  # the platform's turn does not depend on h: its lever does


def test_noise_is_not_what_remains() -> None:
    """Without any noise, or with 19 times the configurations and a tenth of the noise, as much remains."""
    for tool in LENGTHS:
        base, silent, many = run(tool), run(tool, seed=None), run(tool, noise=0.1, step=0.25)
        assert len(np.arange(-45.0, 45.1, 0.25)) == 361
        assert worst(silent.improved) > 0.8 * worst(base.improved)
        assert worst(many.improved) > 0.8 * worst(base.improved)
    # identified biases, not noise: the standard deviation of b1x is some 0.011 mm, its error 0.33 mm at h = 200
    assert abs(run(200.0, seed=None).base[3] - (-1.0)) > 0.3


def test_what_remains_is_of_second_order() -> None:
    """Half the machine's errors leave a quarter: the linearisation is what remains."""
    left = [worst(study(200.0, None, errors=t * ERRORS).improved) for t in (0.5, 0.25)]
    assert left[0] / left[1] == pytest.approx(4, rel=0.15)


def test_the_exact_method_leaves_noise() -> None:
    """Closed form identified and inverted: the largest error is below the noise of one reading."""
    for tool in LENGTHS:
        for seed in range(3):
            assert worst(run(tool, seed).exact) < SIGMA[0]
        assert worst(run(tool, seed=None).exact) < 1e-3


def test_signs_of_eq_65_cancel_in_the_study() -> None:
    """With (65) as printed the same positions come out and delta q0 with the wrong sign: the curves cannot tell."""
    right, printed = (study(100.0, None, printed=p) for p in (False, True))
    assert worst(right.improved) == pytest.approx(worst(printed.improved), rel=1e-6)
    assert printed.base[0] == pytest.approx(-right.base[0], rel=1e-6)


CAPTIONS = {
    2: "Computation scheme of the complete inverse position relationship's approximation",
    3: "Scheme of the simple mechanism",
    6: "TCP positioning before and after classical and improved calibration",
}


@pytest.mark.parametrize(
    ("cited", "meant", "subject"),
    [(6, 3, "mechanism"), (3, 2, "inverse position relationship")],
    ids=["closure relations", "compensation"],
)
def test_cited_figures(cited: int, meant: int, subject: str) -> None:
    assert subject not in CAPTIONS[cited]
    assert subject in CAPTIONS[meant]


def test_references() -> None:
    """Every number that the text cites is listed but the last."""
    cited, listed = set(range(1, 20)), set(range(1, 19))
    assert cited - listed == {19}


def test_table_2_has_errors_on_six_parameters() -> None:
    assert [name for name, value in zip(PLANAR, ERRORS, strict=True) if value == 0] == ["a2x", "b1x", "b2y"]
    base = {"a2x": ERRORS[2] - ERRORS[5], "a2y": ERRORS[3] - ERRORS[6], "b1x": ERRORS[4] - ERRORS[1]}
    assert all(base.values())

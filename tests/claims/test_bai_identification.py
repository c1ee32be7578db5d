"""What Bai 2015 claims of distances, identifiability and poses, section 3, decided."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from deltacal_gen.estimation.problem import pose_problem
from deltacal_gen.files.robot import Robot
from deltacal_gen.identification.identifiability import identification_matrix
from deltacal_gen.machine.registry import Machine
from deltacal_gen.physics.simulation import simulate
from tests.claims import independent_bai as bai
from tests.claims.symbolic_bai import L, a, e, is_zero, l, lhat, phi, rows, symbols, t, u0, u1, v0, w0
from tests.support.prototype import wanted

sp = pytest.importorskip("sympy", reason="the proofs need the dependency group 'derive'")

STARTS = np.radians(np.arange(0.0, 120.0, 7.5))  # start angles of a ring; the machine has the symmetry of 120 deg


# --------------------------------------------------------------------------------------- section 3.1: distances


def rigid_motion(turn: sp.Matrix, shift: sp.Matrix) -> sp.Matrix:
    """Return a limb's Delta p_r that makes model 24 move by turn x r + shift as a body."""
    de = shift + turn.cross(e * u0)
    return sp.Matrix([L * w0.dot(turn), *de, 0, L * u0.dot(turn), L * v0.dot(turn), 0])


def test_eq_11() -> None:
    """Six conditions for six rigid motions: each motion is within model 24, and eq. (11) leaves none of them."""
    turn, shift = symbols("turn"), symbols("shift")
    r = e * u0 + L * u1 + l * lhat  # the loop closure, with e = b - a
    B_r, _ = rows()
    assert is_zero(lhat.dot(turn.cross(r) + shift) - (B_r * rigid_motion(turn, shift))[0])

    directions = [sp.Rational(-1, 2) * sp.pi + 2 * sp.pi * i / 3 for i in range(3)]
    moved = [rigid_motion(turn, shift).subs(phi, d) for d in directions]  # e_x, e_y, e_z are entries 1, 2, 3
    removed = sp.Matrix([moved[0][1], moved[1][2], moved[2][2], moved[0][3], moved[1][3], moved[2][3]])
    determinant = sp.simplify(removed.jacobian([*turn, *shift]).det())
    assert determinant.subs(e, 0) == 0
    assert sp.simplify(determinant / e**3).is_number
    assert sp.simplify(determinant / e**3) != 0
    assert (len(bai.MODEL_18), len(bai.MODEL_36)) == (24 - 6, 42 - 6)
    r = bai.scattered(24, np.random.default_rng(5))
    assert bai.rank(bai.H(r, bai.MODEL_24)) == bai.rank(bai.H(r, bai.MODEL_18))
    assert bai.rank(bai.H(r, bai.MODEL_42)) == bai.rank(bai.H(r, bai.MODEL_36))


def test_eqs_12_to_14() -> None:
    """rho n = r_j - r_i, differentiated; n stays a unit vector, so its change drops out of n . d(rho n)."""
    r = {k: symbols(k) for k in ("ri", "rj")}
    d = {k: symbols(f"d{k}") for k in r}
    line = (r["rj"] + t * d["rj"]) - (r["ri"] + t * d["ri"])
    rho = sp.sqrt(line.dot(line))
    n = line / rho
    at = {t: 0}
    change = (rho.diff(t) * n + rho * n.diff(t)).subs(at)
    assert (change - (d["rj"] - d["ri"])).applyfunc(sp.factor) == sp.zeros(3, 1)
    assert sp.factor(n.dot(n.diff(t)).subs(at)) == 0
    assert sp.factor(rho.diff(t).subs(at) - n.subs(at).dot(d["rj"] - d["ri"])) == 0


@pytest.mark.parametrize("names", [bai.MODEL_18, bai.MODEL_36], ids=["eq. (15)", "eq. (16)"])
def test_eqs_15_and_16(robot: Robot, mechanism: Machine, names: tuple[str, ...]) -> None:
    """The matrix written from the text is the derivative of the exact machine's distances."""
    r = bai.fine_poses(7, 0.2)
    problem = pose_problem(robot, simulate(robot, wanted(r, frame="robot")), names, as_distance=True)
    found, expected = identification_matrix(problem, "paper").H, bai.H(r, names)
    assert found.shape == (105, len(names))
    assert found == pytest.approx(expected, abs=1e-11 * np.abs(expected).max())


# ------------------------------------------------------------------------------------ section 3.2: identifiability


@pytest.mark.parametrize("names", [bai.MODEL_18, bai.MODEL_32], ids=["eq. (17)", "eq. (20)"])
def test_eqs_17_and_20(names: tuple[str, ...]) -> None:
    H = bai.H(bai.fine_poses(9, 0.2), names, bai.POINTS[:2])
    p = bai.vector(bai.entries(bai.TABLE_4))[[bai.MODEL_42.index(n) for n in names]]
    assert np.linalg.pinv(H, rcond=1e-12) @ (H @ p) == pytest.approx(p, abs=1e-9)


def test_model_18_has_rank_18_and_model_36_rank_32() -> None:
    r = bai.scattered(24, np.random.default_rng(7))
    for points in (1, 2, 3):
        assert bai.rank(bai.H(r, bai.MODEL_18, bai.POINTS[:points])) == 18
        for names in (bai.MODEL_42, bai.MODEL_36, bai.MODEL_32):
            assert bai.rank(bai.H(r, names, bai.POINTS[:points])) == 32


def test_one_point_gives_rank_32() -> None:
    r = bai.scattered(24, np.random.default_rng(7))
    for point in (None, *bai.POINTS):
        assert bai.rank(bai.H(r, bai.MODEL_32, (point,))) == 32
    # on the paper's own poses, n = 9, too: what the second point buys is conditioning
    poses = bai.fine_poses(9, 0.3)
    one, two = bai.H(poses, bai.MODEL_32, bai.POINTS[:1]), bai.H(poses, bai.MODEL_32, bai.POINTS[:2])
    assert len(one) == 171
    assert bai.rank(one) == 32
    assert bai.condition(one) > 2 * bai.condition(two)


def test_three_points_are_always_coplanar(rng: np.random.Generator) -> None:
    triples = rng.normal(size=(100, 3, 3))
    assert max(np.linalg.matrix_rank(p[1:] - p[0]) for p in triples) == 2  # three points span a plane, never more
    assert np.linalg.matrix_rank(np.array(bai.POINTS)[1:] - bai.POINTS[0]) == 2  # not on one line: what the ranks need


def test_eighteen_distances_suffice_only_between_separate_poses() -> None:
    rng = np.random.default_rng(7)
    pairs = [(2 * k, 2 * k + 1) for k in range(18)]
    assert bai.rank(bai.H(bai.scattered(36, rng), bai.MODEL_18, pairs=pairs)) == 18
    # distances of all pairs of N poses know 3 N - 6 numbers: 21 distances of 7 poses have rank 15
    for n, rank in ((6, 12), (7, 15), (8, 18)):
        H = bai.H(bai.scattered(n, rng), bai.MODEL_18)
        assert bai.rank(H) == rank
    assert len(bai.every_pair(7)) == 21


def test_thirty_two_distances_of_two_points_do_not_suffice() -> None:
    rng = np.random.default_rng(7)
    for n, count, rank in ((7, 42, 26), (8, 56, 31), (9, 72, 32)):
        H = bai.H(bai.scattered(n, rng), bai.MODEL_32, bai.POINTS[:2])
        assert len(H) == count
        assert bai.rank(H) == rank


def test_three_poses_off_a_line_do_not_suffice() -> None:
    """Poses in the vertical plane of limb 1: opposite offsets of limbs 2 and 3 move all of them across the plane."""
    rng = np.random.default_rng(7)
    for _ in range(10):
        r = bai.scattered(3, rng)
        assert np.linalg.matrix_rank(r[1:] - r[0], tol=1.0) == 2  # not on one line
        assert bai.rank(bai.H(r, bai.OFFSETS)) == 3
        r[:, 0] = 0.0
        assert np.linalg.matrix_rank(r[1:] - r[0], tol=1.0) == 2
        H = bai.H(r, bai.OFFSETS)
        assert bai.rank(H) == 2
        assert np.abs(H @ [0.0, 1.0, -1.0]).max() < 1e-13
    # and off such planes: the determinant changes its sign between poses that are on no line either
    signs = {np.sign(np.linalg.det(bai.H(bai.scattered(3, rng), bai.OFFSETS))) for _ in range(50)}
    assert signs == {-1.0, 1.0}


def test_three_distances_find_the_offsets_and_no_more() -> None:
    """Three poses off a line identify Delta p_theta, of three entries; of the 18 of Delta p_r they see three."""
    r = bai.scattered(3, np.random.default_rng(3))
    assert bai.rank(bai.H(r, bai.OFFSETS)) == 3
    assert bai.rank(bai.H(r, bai.MODEL_18)) == 3 < len(bai.MODEL_18)


def test_eq_18() -> None:
    """Twelve entries per limb: one or the other of e_x and e_y, five more of Delta p_r, six of Delta p_e."""
    for i, free in ((1, "ey"), (2, "ex"), (3, "ex")):
        of_limb = [n for n in bai.MODEL_36 if n.endswith(f"_{i}")]
        kept = ["theta", "L", "alpha0", "beta0", "l", *bai.ORIENTATION]
        assert sorted(of_limb) == sorted(f"{n}_{i}" for n in (free, *kept))
    assert len(bai.MODEL_36) == 3 * 12


# eq. (19), each relation as left minus right = 0: coefficients of the entries h_r,i,k and h_e,i,k by parameter
root3 = sp.sqrt(3)
La_e = L * a / e
RELATIONS = {
    1: {
        "alpha03": (-1, 1, 0),
        "theta": tuple(-La_e / root3 * k for k in (-1, -1, 2)),
        "alpha0": tuple(-La_e * k for k in (-1, 1, 0)),
    },
    2: {
        "alpha03": (-1, 0, 1),
        "theta": tuple(La_e / root3 * k for k in (-1, 2, -1)),
        "alpha0": tuple(-La_e * k for k in (-1, 0, 1)),
    },
    3: {
        "alpha03": (3, 0, 0),
        "alpha2": (L / e,) * 3,
        "alpha0": (-La_e * 3, 0, 0),
        "theta": tuple(-La_e * root3 * k for k in (0, 1, -1)),
    },
    4: {"beta03": (1, 1, 1), "beta0": (-La_e,) * 3},
}


@pytest.mark.parametrize("relation", RELATIONS)
def test_eq_19(relation: int) -> None:
    """Each relation is a set of errors that turns the workspace as a body, so that no distance changes.

    The plate turns by delta + kappa r / e and P moves by -(a / e) delta x r, for the delta and kappa found here.
    """
    coefficients = RELATIONS[relation]
    delta, kappa = symbols("delta"), sp.Symbol("kappa")
    directions = [-sp.pi / 2 + 2 * sp.pi * i / 3 for i in range(3)]
    of_limb = [{n: values[i] for n, values in coefficients.items()} for i in range(3)]
    r = e * u0 + L * u1 + l * lhat
    turn, shift = delta + kappa * r / e, (-a / e * delta).cross(r)
    found: dict[sp.Symbol, sp.Expr] = sp.solve(
        [delta.dot(u0.subs(phi, d)) + kappa - x.get("alpha03", 0) for d, x in zip(directions, of_limb, strict=True)]
        + [delta[2] - of_limb[0].get("beta03", 0)],
        [*delta, kappa],
        dict=True,
    )[0]
    B_r, B_e = rows()
    for d, x in zip(directions, of_limb, strict=True):
        at = {phi: d}
        position, orientation = (sp.Matrix([x.get(n, 0) for n in names]) for names in (bai.POSITION, bai.ORIENTATION))
        first = lhat.dot(shift) + (a * u0).cross(lhat).dot(turn) - (B_r * position)[0]
        second = w0.cross(lhat).dot(turn) - (B_e * orientation)[0]
        assert is_zero(first.subs(found).subs(at))
        assert is_zero(second.subs(found).subs(at))


def test_no_entry_depends_on_those_of_h_r_alone() -> None:
    """Each of the nine entries adds a rank to the 24 of h_r: the relations (19) need others of h_e on their left."""
    r = bai.scattered(24, np.random.default_rng(7))
    for name in (f"{n}_{i}" for n in ("alpha03", "beta03", "alpha2") for i in (1, 2, 3)):
        assert bai.rank(bai.H(r, (*bai.MODEL_24, name))) == 19 == bai.rank(bai.H(r, bai.MODEL_24)) + 1
    nine = tuple(f"{n}_{i}" for n in ("alpha03", "beta03", "alpha2") for i in (1, 2, 3))
    assert bai.rank(bai.H(r, (*bai.MODEL_24, *nine))) == 18 + 9 - 4


def test_eq_19_in_numbers() -> None:
    """The printed relations among entries of H, for a reference point off the centre; the other sign fails."""
    numbers = {L: bai.L, a: bai.a, e: bai.b - bai.a}
    H = bai.H(bai.scattered(10, np.random.default_rng(9)), bai.MODEL_42, bai.POINTS[1:2])
    for relation in RELATIONS.values():
        terms = {
            f"{name}_{i}": float(sp.N(sp.sympify(k).subs(numbers)))
            for name, ks in relation.items()
            for i, k in enumerate(ks, start=1)
        }
        column = {n: H[:, bai.MODEL_42.index(n)] * k for n, k in terms.items()}
        left = sum(v for n, v in column.items() if n.split("_")[0] in bai.ORIENTATION)
        right = -sum(v for n, v in column.items() if n.split("_")[0] in bai.POSITION)
        assert left == pytest.approx(right, abs=1e-11)
        assert np.abs(left + right).max() > 1.0


def test_the_four_errors_to_remove() -> None:
    H = bai.H(bai.scattered(24, np.random.default_rng(7)), bai.MODEL_32, bai.POINTS[:2])
    assert H.shape[1] == 32 == bai.rank(H)
    missing = {n for n in bai.MODEL_36 if n not in bai.entries(bai.TABLE_4)}
    assert missing == set(bai.DEPENDENT)  # Table 4 leaves out the same ones


def test_what_the_unidentifiable_errors_leave() -> None:
    """Errors of 1 mrad in the four that model 32 leaves out, shared out by least squares over those it keeps."""
    r = bai.check_poses()
    C = bai.sensitivity(r)[0]
    kept = [bai.MODEL_42.index(n) for n in bai.MODEL_32]
    true = np.zeros(42)
    true[[bai.MODEL_42.index(n) for n in bai.DEPENDENT]] = 1e-3
    H = bai.H(r, bai.MODEL_42)
    found = np.zeros(42)
    found[kept] = np.linalg.lstsq(H[:, kept], H @ true, rcond=1e-14)[0]
    left = C @ (true - found)
    assert np.abs(H @ true).max() > 0.05  # mm: what distances show of them
    assert np.abs(H @ (true - found)).max() < 1e-9  # and nothing of it is left in any distance
    # in {O} of eq. (11) a rotation is left that no distance shows
    moved, stays = (np.linalg.norm(x, axis=1).max() for x in (C @ true, left))
    assert stays > 0.5 * moved
    arm = r - r.mean(axis=0)
    cross = np.concatenate([np.stack([np.cross(axis, x) for axis in np.eye(3)], axis=1) for x in arm])
    body = np.hstack([cross, np.tile(np.eye(3), (len(r), 1))])
    fit = np.linalg.lstsq(body, left.ravel(), rcond=None)[0]
    assert body @ fit == pytest.approx(left.ravel(), abs=1e-9)


# -------------------------------------------------------------------------------------- section 3.3: pose selection


def test_number_of_distances() -> None:
    n = sp.Symbol("n", integer=True, positive=True)
    assert sp.simplify(sp.binomial(2 * n + 1, 2).expand(func=True) - n * (2 * n + 1)) == 0
    for count in (3, 7, 9):
        assert len(bai.every_pair(len(bai.fine_poses(count)))) == count * (2 * count + 1)


@pytest.mark.parametrize("model", ["3", "18", "32"])
@pytest.mark.parametrize("norm", ["spectral", "frobenius"])
def test_the_condition_number_is_not_monotone(model: str, norm: str) -> None:
    for start in STARTS[1:16:5]:
        finite = [k for k in bai.kappas(model, norm, start).values() if np.isfinite(k)]
        rises = sum(later > earlier * (1 + 1e-6) for earlier, later in pairwise(finite))
        assert rises >= (1 if model == "3" else 4)


def test_eq_21() -> None:
    """What the rule picks depends on the norm and on the start angle of the rings."""
    found = {norm: {bai.rule(bai.kappas("18", norm, s)) for s in STARTS} for norm in ("spectral", "frobenius")}
    assert all(len(chosen) >= 4 for chosen in found.values())
    differs = [bai.rule(bai.kappas("3", "spectral", s)) != bai.rule(bai.kappas("3", "frobenius", s)) for s in STARTS]
    assert sum(differs) > len(STARTS) / 2


def test_n_equal_to_3_and_4_on_two_layers() -> None:
    for start in (0.0, 0.2, 0.5):
        assert bai.rank(bai.H(bai.fine_poses(3, start), bai.MODEL_18)) == 15
        assert bai.rank(bai.H(bai.fine_poses(3, start), bai.MODEL_32, bai.POINTS[:2])) < 32
    for start, full in ((0.0, False), (15.0, True), (30.0, False), (75.0, True)):
        poses = bai.fine_poses(4, np.radians(start))
        assert (bai.rank(bai.H(poses, bai.MODEL_18)) == 18) is full
        assert (bai.rank(bai.H(poses, bai.MODEL_32, bai.POINTS[:2])) == 32) is full


def test_model_18_is_not_that_of_the_orientation() -> None:
    """The name stands for two sets of 18 errors without a common one."""
    turning = {f"{e}_{i}" for e in bai.ORIENTATION for i in (1, 2, 3)}
    assert len(turning) == len(bai.MODEL_18) == 18
    assert turning.isdisjoint(bai.MODEL_18)
    assert set(bai.MODEL_18) == set(bai.entries(bai.TABLE_3))


def test_two_translations_give_the_full_rank(rng: np.random.Generator) -> None:
    """Poses in one plane, horizontal or vertical, pin all 18 and all 32; they do it worse."""
    spread = bai.condition(bai.H(bai.fine_poses(9, 1.3), bai.MODEL_18))
    for axis, at in ((2, bai.HOME[2]), (1, 37.0)):
        poses = bai.scattered(30, rng)
        poses[:, axis] = at
        H = bai.H(poses, bai.MODEL_18)
        assert bai.rank(H) == 18
        assert bai.condition(H) > 3 * spread
        assert bai.rank(bai.H(poses, bai.MODEL_32)) == 32


def test_poses_on_the_boundary_inform_most() -> None:
    for names, points in ((bai.MODEL_18, (None,)), (bai.MODEL_32, bai.POINTS[:2])):
        found = []
        for radius in (500.0, 400.0, 300.0, 200.0, 100.0):
            r = np.vstack([bai.HOME, bai.ring(9, 0.0, 1.3, radius), bai.ring(9, 1.0, 1.3, radius)])
            H = bai.H(r, names, points)
            found.append((bai.condition(H), np.linalg.svd(H, compute_uv=False)[len(names) - 1]))
        assert all(inner[0] > outer[0] and inner[1] < outer[1] for outer, inner in pairwise(found))
        if names == bai.MODEL_18:
            assert np.allclose([k for k, _ in found], [83.3, 122.0, 181.8, 299.0, 760.0], rtol=1e-3)

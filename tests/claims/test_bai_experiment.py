"""The compensation and the experiment of Bai 2015, sections 4 and 5, decided."""

from __future__ import annotations

import numpy as np
import pytest

from tests.claims import independent_bai as bai
from tests.claims.symbolic_bai import L, closure, dtheta, is_zero, lhat, rows, symbols, t, v1

sp = pytest.importorskip("sympy", reason="the proofs need the dependency group 'derive'")

# ------------------------------------------------------------------------------------------ section 4: compensation


def test_eqs_22_and_23() -> None:
    """An offset of the arms enters as L Delta theta does: B_m holds the first column of each B_r,i on its diagonal."""
    B_r, _ = rows()
    assert is_zero(B_r[0] - lhat.dot(v1))
    assert is_zero(lhat.dot(closure(1).diff(dtheta).diff(t).subs(t, 0)) + L * lhat.dot(v1))
    k = sp.symbols("k_1:4", nonzero=True)
    x = sp.Matrix(sp.symbols("x_1:4"))  # B_r Delta p_r - A_re A_ee^-1 B_e Delta p_e
    B_m = sp.diag(*k)
    assert sp.simplify(x + B_m * (-B_m.inv() * x)) == sp.zeros(3, 1)
    column = sp.Matrix(k)  # as printed
    with pytest.raises(sp.matrices.exceptions.ShapeError):
        _ = column * sp.Matrix(sp.symbols("q_1:4"))
    with pytest.raises(sp.matrices.exceptions.NonSquareMatrixError):
        column.inv()


def test_the_indices_of_eq_22() -> None:
    """With v_2,1 and v_3,1 (frames of limb 1) even on a diagonal, the compensator leaves most of an offset."""
    r = bai.check_poses()
    A_rr, _, _, B_r, _, B_m = bai.matrices(r)
    *_, v1, l_hat = bai.frames(r)
    offset = bai.vector(dict.fromkeys(bai.OFFSETS, 1.0))[:24]
    effect = B_r @ offset
    q = np.linalg.solve(B_m, -effect[..., None])[..., 0]
    assert q == pytest.approx(-1.0)
    # v_2,1 = v_1,1 (frame 2C of limb 1 is nominally parallel to frame 1B), v_3,1 = v_0
    wrong = np.stack([v1[:, 0], v1[:, 0], np.tile([0.0, 0.0, 1.0], (len(r), 1))], axis=1)
    q = -effect / (l_hat * wrong).sum(axis=-1)
    left = np.linalg.solve(A_rr, (effect + np.einsum("nij,nj->ni", B_m, q))[..., None])[..., 0]
    assert np.linalg.norm(left, axis=1).max() > 1.0  # of 1 mm


def test_eq_24() -> None:
    n1, n2, n3 = (symbols(f"n{k}") for k in (1, 2, 3))
    A = sp.Matrix.hstack(n1, n2, n3).T
    columns, volume = sp.Matrix.hstack(n2.cross(n3), n3.cross(n1), n1.cross(n2)), n1.dot(n2.cross(n3))
    assert (A * columns - volume * sp.eye(3)).expand() == sp.zeros(3)
    assert (A * columns.T - volume * sp.eye(3)).expand() != sp.zeros(3)  # the printed transpose
    A_ee = bai.matrices(np.array([100.0, 50.0, bai.HOME[2]]))[2]
    printed = np.array([np.cross(A_ee[1], A_ee[2]), np.cross(A_ee[2], A_ee[0]), np.cross(A_ee[0], A_ee[1])])
    printed = printed / np.linalg.det(A_ee)
    assert A_ee @ printed.T == pytest.approx(np.eye(3), abs=1e-12)
    assert np.abs(A_ee @ printed - np.eye(3)).max() > 0.5


def test_eqs_25_and_26() -> None:
    """Offsets alone: Delta r = A_rr^-1 B_m Delta p_theta on the exact machine, and Delta q_m = -Delta p_theta."""
    r = bai.scattered(30, np.random.default_rng(2))
    A_rr, _, _, B_r, _, B_m = bai.matrices(r)
    size = 1e-5 * np.array([1.0, -2.0, 3.0])
    exact = (bai.forward(bai.joints(r) + size) - bai.forward(bai.joints(r) - size)) / 2
    assert exact == pytest.approx(np.linalg.solve(A_rr, B_m @ (bai.L * size)[:, None])[..., 0], abs=1e-8)
    p_r = bai.vector(dict(zip(bai.OFFSETS, bai.L * size, strict=True)))[:24]
    q = -np.linalg.solve(B_m, (B_r @ p_r)[..., None])[..., 0]
    assert q == pytest.approx(np.tile(-bai.L * size, (30, 1)))
    # all of model 18: the commanded change cancels the displacement
    p_r = bai.vector(bai.entries(bai.TABLE_3))[:24]
    q = -np.linalg.solve(B_m, (B_r @ p_r)[..., None])[..., 0]
    assert B_r @ p_r + np.einsum("nij,nj->ni", B_m, q) == pytest.approx(0.0, abs=1e-12)


def test_only_eq_23_brings_the_point_back() -> None:
    """Eq. (22) takes any Delta q_m and answers with a displacement; none is left for that of eq. (23) alone."""
    rng = np.random.default_rng(4)
    A_rr, _, _, B_r, _, B_m = bai.matrices(bai.scattered(20, rng))
    effect = B_r @ bai.vector(bai.entries(bai.TABLE_3))[:24]
    assert np.linalg.svd(A_rr, compute_uv=False).min() > 0.1  # so the right side vanishes where Delta r does
    answer = -np.linalg.solve(B_m, effect[..., None])[..., 0]
    for q, least, most in ((answer, 0.0, 1e-12), (answer + rng.choice([-0.1, 0.1], (20, 3)), 0.02, 1.0)):
        moved = np.linalg.solve(A_rr, (effect + np.einsum("nij,nj->ni", B_m, q))[..., None])
        size = np.linalg.norm(moved, axis=1)
        assert least <= size.min()
        assert size.max() < most


def test_sizes_of_section_4_2() -> None:
    """What the offsets and what the other errors of Table 3 move the point by."""
    r = bai.check_poses()
    C = bai.sensitivity(r)[0]
    offsets = bai.vector(dict(zip(bai.OFFSETS, bai.L * bai.OFFSETS_FOUND, strict=True)))
    others = bai.vector({n: v for n, v in bai.entries(bai.TABLE_3).items() if not n.startswith("theta")})
    assert np.linalg.norm(C @ offsets, axis=1).max() > 9.0
    assert np.linalg.norm(C @ others, axis=1).max() > 1.0
    distance, volumetric = bai.relative(r, C @ others)
    assert np.abs(distance).max() > 0.7
    assert volumetric.max() > 1.1
    assert max(bai.TABLE_5["A"]) > 5.0  # the paper's own tables: offsets in, and offsets out
    assert min(bai.TABLE_5["B"]) > 3 * 0.2


# ----------------------------------------------------------------------------------------- section 5: the experiment


def test_table_1() -> None:
    """The cylinder is within reach of the nominal machine, with margin."""
    r = np.vstack([bai.ring(72, d, radius=s) for d in np.linspace(0, 1, 6) for s in np.linspace(0, 500, 11)])
    q = np.degrees(bai.joints(r))
    assert np.isfinite(q).all()
    assert (q.min(), q.max()) == pytest.approx((-78.0, 36.1), abs=0.5)
    assert bai.forward(np.radians(q)) == pytest.approx(r, abs=1e-9)


def test_where_the_workspace_is_drawn() -> None:
    """The captions: that of the figure cited for H, R and h tells of a limb, that of Fig. 4 of poses."""
    captions = {2: "Schematic diagram of a limb in the Delta robot", 4: "Measurement pose selection"}
    assert not {"workspace", "pose"} & set(captions[2].lower().split())
    assert "pose" in captions[4]


def test_counts_of_section_5() -> None:
    assert len(bai.every_pair(5 + 1)) == 15
    assert (len(bai.fine_poses(7)), len(bai.every_pair(15))) == (15, 105)
    assert (len(bai.fine_poses(9)), 2 * len(bai.every_pair(19))) == (19, 342)
    assert len(bai.check_poses()) - 1 == 96 == 3 * 2 * 16


def test_three_poses_of_a_ring_suffice_for_the_offsets() -> None:
    for start in np.radians(range(0, 120, 3)):
        H = bai.H(bai.rough_poses(3, start), bai.OFFSETS)
        assert bai.rank(H) == 3
        assert bai.condition(H) < 6.0


def test_figure_6() -> None:
    """n = 5: at nearly all start angles with the Frobenius condition number, at none with the spectral one."""
    fine = np.radians(np.arange(0.0, 120.0, 2.5))
    chosen = {norm: [bai.rule(bai.kappas("3", norm, s)) for s in fine] for norm in ("spectral", "frobenius")}
    assert 5 not in chosen["spectral"]
    assert chosen["frobenius"].count(5) > 0.9 * len(fine)


def test_figure_7() -> None:
    """n = 7 for model 18 and n = 9 for model 32: together at a start angle of 75 deg, not at 0 or 30 deg."""

    def chosen(norm: str, start: float) -> list[int | None]:
        return [bai.rule(bai.kappas(model, norm, np.radians(start))) for model in ("3", "18", "32")]

    assert chosen("frobenius", 75.0) == [5, 7, 9]
    for norm in ("spectral", "frobenius"):
        for start in (0.0, 30.0):
            assert chosen(norm, start)[1:] != [7, 9]


def test_two_runs_find_the_offsets() -> None:
    """Offsets as found, five poses of the middle layer, commands corrected after each run."""
    targets = bai.rough_poses(5, 0.3)
    H = bai.H(targets, bai.OFFSETS)
    left = [bai.OFFSETS_FOUND]
    for _ in range(3):
        reached = bai.forward(bai.joints(targets) + left[-1])
        step = np.linalg.pinv(H) @ (bai.distances(reached) - bai.distances(targets)) / bai.L
        left.append(left[-1] - step)
    once, twice = (np.abs(np.degrees(x)).max() for x in left[1:3])
    assert bai.L * np.radians(once) > 0.05 > 100 * bai.L * np.radians(twice)  # mm, beside the repeatability of 0.05 mm


def test_table_2_and_the_text() -> None:
    largest = {name: max(map(abs, row)) for name, row in bai.TABLE_2.items()}
    assert list(largest.values()) == [4.181, 4.962, 0.187, 1.047]
    for when in ("before", "after"):  # a distance error never exceeds the volumetric error
        pairs = zip(bai.TABLE_2[f"{when} distance"], bai.TABLE_2[f"{when} volumetric"], strict=True)
        assert all(abs(distance) <= volumetric for distance, volumetric in pairs)


def test_table_2_does_not_follow_from_the_offsets() -> None:
    """Before minus after is what the offsets do; the mean over an even ring hardly depends on its start angle."""
    printed = np.mean(np.subtract(bai.TABLE_2["before distance"], bai.TABLE_2["after distance"]))
    assert printed == pytest.approx(-3.424, abs=1e-3)
    worst, means = [], []
    for start in np.radians(range(0, 360, 4)):
        for ring in (bai.rough_poses(5, start), bai.rough_poses(5, start)[[0, 5, 4, 3, 2, 1]]):
            reached = bai.forward(bai.joints(ring) + bai.OFFSETS_FOUND)
            error = (bai.distances(reached) - bai.distances(ring))[:5]  # the pairs with home
            means.append(error.mean())
            change = np.subtract(bai.TABLE_2["before distance"], bai.TABLE_2["after distance"])
            worst.append(np.abs(error - change).max())
    assert max(means) < -4.0
    assert min(worst) > 0.75  # mm, at repeatability 0.05 mm


def test_table_3() -> None:
    found = bai.entries(bai.TABLE_3)
    assert set(found) == set(bai.MODEL_18)
    assert len(found) == 18


def test_table_3_explains_table_5_b() -> None:
    """Compensation by Table 3 turns column B into column C18: the table's own errors lie within C18 of B."""
    r = bai.check_poses()
    distance, volumetric = bai.relative(r, bai.sensitivity(r)[0] @ bai.vector(bai.entries(bai.TABLE_3)))
    assert np.abs(distance).max() == pytest.approx(bai.TABLE_5["B"][0], abs=bai.TABLE_5["C18"][0])
    assert volumetric.max() == pytest.approx(bai.TABLE_5["B"][1], abs=bai.TABLE_5["C18"][1])


def test_table_4() -> None:
    found = bai.entries(bai.TABLE_4)
    assert set(found) == set(bai.MODEL_32)
    assert len(found) == 18 + 14


def apart(point: np.ndarray | None, first: dict[str, float], second: dict[str, float]) -> float:
    """Return the largest difference at the 96 poses between the distance errors that two sets of errors predict."""
    r = bai.check_poses()
    return float(
        np.abs(bai.relative(r, bai.sensitivity(r, point)[0] @ (bai.vector(first) - bai.vector(second)))[0]).max()
    )


def test_table_4_does_not_go_with_table_5() -> None:
    """Both compensators left at most 0.167 and 0.134 mm, so their corrections differ by at most the sum."""
    allowed = bai.TABLE_5["C18"][0] + bai.TABLE_5["C32"][0]
    three, four = bai.entries(bai.TABLE_3), bai.entries(bai.TABLE_4)
    sockets = [np.array(p, dtype=float) for p in np.ndindex(3, 3, 3)]
    for p in sockets:  # wherever the reflector sat, within 150 mm sideways and 200 mm below the plate
        assert apart((p - [1, 1, 2]) * [150, 150, 100], three, four) > 2 * allowed
    assert apart(None, three, four) > 1.0
    assert apart(None, three, four | {"L_1": 0.119}) < allowed
    # no other single number of Table 4, dropped, would mend it
    mends = [n for n in four if apart(None, three, four | {n: three.get(n, 0.0)}) < allowed]
    assert mends == ["L_1"]
    r = bai.check_poses()
    printed, mended = (bai.relative(r, bai.sensitivity(r)[0] @ bai.vector(x))[0] for x in (four, four | {"L_1": 0.119}))
    assert np.abs(printed).max() > bai.TABLE_5["B"][0] + 4 * bai.TABLE_5["C32"][0]  # 1.55 mm, where B is 0.682
    assert np.abs(mended).max() == pytest.approx(bai.TABLE_5["B"][0], abs=bai.TABLE_5["C32"][0])


def test_tables_3_and_4_differ() -> None:
    three, four = bai.entries(bai.TABLE_3), bai.entries(bai.TABLE_4)
    differences = {n: abs(three[n] - four[n]) for n in three}
    assert all(d > 0 for d in differences.values())
    assert max(d for n, d in differences.items() if n != "L_1") == pytest.approx(0.363, abs=5e-4)  # theta_3
    # a machine with the orientation errors of Table 4 makes model 18 find other values than model 32 does
    H = bai.H(bai.fine_poses(7, 0.2), bai.MODEL_42)
    columns = [bai.MODEL_42.index(n) for n in bai.MODEL_18]
    true = bai.vector(four)
    found = np.linalg.lstsq(H[:, columns], H @ true, rcond=None)[0]
    assert np.abs(found - true[columns]).max() > 0.1


def test_table_5_and_the_text() -> None:
    assert bai.TABLE_5["B"] == (0.682, 1.303)
    assert min(map(min, bai.TABLE_5.values())) > 0.05 > 0.005  # no better than the machine repeats
    for distance, volumetric in bai.TABLE_5.values():
        assert distance < volumetric
    better = [1 - c32 / c18 for c18, c32 in zip(bai.TABLE_5["C18"], bai.TABLE_5["C32"], strict=True)]
    assert better == pytest.approx([0.198, 0.039], abs=1e-3)  # "slightly"
    total = [before / after for before, after in zip(bai.TABLE_5["A"], bai.TABLE_5["C18"], strict=True)]
    assert total == pytest.approx([34.2, 16.5], abs=0.1)


def test_table_5_a_does_not_follow_from_the_offsets() -> None:
    """Column A is the offsets' effect plus column B; the offsets alone give 6.45 mm or more, wherever circles start."""
    alone = []
    for start in np.radians(np.arange(0.0, 22.5, 2.5)):
        r = bai.check_poses(start)
        reached = bai.forward(bai.joints(r) + bai.OFFSETS_FOUND)
        error = np.linalg.norm(reached[1:] - reached[0], axis=1) - np.linalg.norm(r[1:] - r[0], axis=1)
        alone.append(np.abs(error).max())
    assert min(alone) > 6.4
    assert min(alone) - bai.TABLE_5["B"][0] > bai.TABLE_5["A"][0]
    r = bai.check_poses()
    sums = bai.vector(bai.entries(bai.TABLE_3))
    sums = sums + bai.vector(dict(zip(bai.OFFSETS, bai.L * bai.OFFSETS_FOUND, strict=True)))
    distance, volumetric = bai.relative(r, bai.sensitivity(r)[0] @ sums)
    assert np.abs(distance).max() > bai.TABLE_5["A"][0] + 4 * bai.TABLE_5["C18"][0]
    assert volumetric.max() > bai.TABLE_5["A"][1] + bai.TABLE_5["C18"][1]


def test_distances_cannot_show_that_the_plate_is_parallel() -> None:
    """Any constant turn of the plate is within what distances do not see, and Table 4 leaves 0.26 deg as it stands."""
    r = bai.check_poses()
    turn = bai.sensitivity(r)[1] @ bai.vector(bai.entries(bai.TABLE_4))[24:]
    assert np.degrees(np.linalg.norm(turn, axis=1).max()) == pytest.approx(0.26, abs=0.01)
    names = [f"{n}_{i}" for n in ("alpha03", "beta03") for i in (1, 2, 3)]
    columns = [bai.MODEL_42.index(n) for n in names]
    H = bai.H(r, bai.MODEL_42, bai.POINTS[:2])
    others = list(range(24))
    for axis in np.eye(3):
        constant = np.concatenate([bai.U0 @ axis, bai.V0 @ axis])
        turned = bai.sensitivity(r)[1][:, :, [k - 24 for k in columns]] @ constant
        assert turned == pytest.approx(np.tile(axis, (len(r), 1)), abs=1e-12)
        seen = H[:, columns] @ constant  # explained by errors of Delta p_r to the last digit
        fit = np.linalg.lstsq(H[:, others], seen, rcond=1e-12)[0]
        assert H[:, others] @ fit == pytest.approx(seen, abs=1e-9)


def test_figure_8_has_no_numbers() -> None:
    """What can be checked of it: on the rim of the middle layer the two corrections differ, and are alike in size."""
    r = np.vstack([bai.HOME, bai.ring(72, 0.5)])
    mended = bai.entries(bai.TABLE_4) | {"L_1": 0.119}
    three, four = (bai.relative(r, bai.sensitivity(r)[0] @ bai.vector(x)) for x in (bai.entries(bai.TABLE_3), mended))
    assert np.abs(three[0] - four[0]).max() > 0.05
    assert np.abs(three[0]).max() == pytest.approx(np.abs(four[0]).max(), rel=0.5)

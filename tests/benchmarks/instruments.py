"""Boards and cameras against what is true: ``python -m tests.benchmarks.instruments PART --count N -o FILE``.

``camera``: an arm with errors in ten of its dimensions, a camera on its last link or beside it, 0.2 px of noise, one
in twenty points found wrongly; all of it from `tests.support.exact_camera`. Counted: parameters within three standard
deviations of the truth; how far hand and eye are off, where the machine is told and where it is not, beside a bundle
adjustment that is told the machine and which points are wrong, and beside the bound of Cramer and Rao, of which the
squared error by the bound's covariance is 1 in the mean; images of new poses, beside OpenCV's hand-eye methods on the
same files where a version has them (``calibrateHandEye``: 4.x), with the arm as drawn and with the true one.

``confounds``: what readings cannot tell apart, said in words with both members; and not said where they can. Planes are
those in which a Delta of our own moves, leaning, and in which a print lies that its tip touches.

Seeds are 0, 1, ...; those that the file has are not tried again.
"""

from __future__ import annotations

import argparse
import csv
import sys
import tempfile
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from scipy.optimize import least_squares, root
from scipy.spatial.transform import Rotation

import deltacal_gen as dc
from tests.support.exact_camera import (
    DH,
    GRID,
    LENS,
    NOISE_PX,
    Scene,
    arm_poses,
    arm_robot,
    around,
    camera,
    joints_around,
    rows_seen,
    turn,
    write,
)
from tests.support.independent_delta import closure, numbers

Array = np.ndarray
VIEWS, NEW = 30, 12
ERRORS = {"theta": 0.2, "alpha": 0.1, "a": 0.3, "d": 0.3}  # deg, mm: standard deviations of what is wrong with an arm
AT_FAULT = ("theta_2", "theta_3", "theta_4", "theta_5", "alpha_2", "alpha_4", "a_2", "a_3", "d_4", "a_1")
METHODS = ("TSAI", "PARK", "HORAUD", "ANDREFF", "DANIILIDIS")


# ------------------------------------------------------------------------------------------------------------- cameras


def camera_row(seed: int, folder: Path) -> dict[str, float]:
    """Return what became of a camera and its arm."""
    rng = np.random.default_rng(seed)
    place = ("platform", "fixed")[seed % 2]
    wrong = {name: ERRORS[name[:-2]] * rng.standard_normal() for name in AT_FAULT}
    joints = joints_around(rng, VIEWS)
    poses = arm_poses(joints, wrong)
    scene = around(poses, place)
    pixels, shown = scene.pixels(poses, LENS)
    columns = rows_seen(joints, pixels, shown, rng)
    robot, seen = arm_robot(folder), write(folder / "seen.csv", columns, camera(place, **LENS))
    result = dc.identify(robot, seen)
    identified = [p for p in result.parameters if p.status == "identified"]
    within = sum(abs(p.value - wrong.get(p.name, 0.0)) <= 3 * p.std for p in identified if p.std is not None)
    measured = np.column_stack([columns["u_px"], columns["v_px"]]).astype(float)
    right = np.linalg.norm(measured - pixels[shown], axis=1) < 6 * NOISE_PX  # as only who made them knows
    adjusted = bundle(scene, poses, shown, measured, right)
    known = robot.with_name("true.toml")
    known.write_text(arm_robot(folder, wrong).read_text() + told_exactly())
    arm_robot(folder)
    ours, settled = (hand_and_eye(found) for found in (result, dc.identify(known, seen)))
    new = joints_around(rng, NEW)
    truly = arm_poses(new, wrong)
    wanted, visible = scene.pixels(truly, LENS)
    told = {
        "deltacal": predicted(result, new, folder, place),
        "adjusted": adjusted.pixels(truly, LENS)[0],
        **{
            f"{method}_{arm}": found.pixels(arm_poses(new, errors), LENS)[0]
            for arm, errors in (("drawn", {}), ("true", wrong))
            for method, found in opencv(columns, place, errors).items()
        },
    }
    row = {"within": within, "identified": len(identified), "sigma_px": float(result["sigma_px"])}
    row |= (
        apart("ours", *ours, scene) | apart("told", *settled, scene) | apart("adjusted", adjusted.C, adjusted.h, scene)
    )
    at = scene, joints, wrong, (shown, right)
    row |= bound(at_best(*at, []), at_best(*at, [b.name for b in result.base]), scene, *ours)
    off = {f"px_{name}": rms(uv[visible] - wanted[visible]) for name, uv in told.items()}
    return row | {f"px_{method}_{arm}": np.nan for arm in ("drawn", "true") for method in METHODS} | off


def told_exactly() -> str:
    """Return tolerances that leave nothing of an arm unknown."""
    names = [f"{k}_{i} = 1e-6\n" for i in range(1, 7) for k in DH] + [f"{k} = 1e-6\n" for k in ("tx", "ty", "tz")]
    return f"[tolerance]\n{''.join(names)}beta_2 = 1e-6\n"


def hand_and_eye(result: Any) -> tuple[Array, Array]:
    """Return how the camera of a result is turned and shifted."""
    state = np.array(result["instrument"]["state"][0])
    return state[:9].reshape(3, 3), state[9:12]


def rms(off: Array) -> float:
    return float(np.sqrt(np.mean(off**2)))


def apart(who: str, C: Array, h: Array, scene: Scene) -> dict[str, float]:
    """Return how far a camera is off [deg, mm]: where it stands in the frame that carries it."""
    angle = np.degrees(np.linalg.norm(Rotation.from_matrix(C @ scene.C.T).as_rotvec()))
    return {f"deg_{who}": float(angle), f"mm_{who}": float(np.linalg.norm(C.T @ h - scene.C.T @ scene.h))}


def moved(scene: Scene, by: Array) -> Scene:
    """Return a scene whose camera and board are turned and shifted by twelve numbers."""
    C, B = scene.C @ turn(*by[:3]), scene.B @ turn(*by[6:9])
    return Scene(scene.place, C, C @ (scene.C.T @ scene.h + by[3:6]), B, scene.g + by[9:12])


def bundle(scene: Scene, poses: tuple[Array, Array], shown: Array, measured: Array, right: Array) -> Scene:
    """Return camera and board by a bundle adjustment that knows the machine and which points are right."""

    def off(by: Array) -> Array:
        return ((moved(scene, by).pixels(poses, LENS)[0][shown] - measured)[right] / NOISE_PX).ravel()

    return moved(scene, least_squares(off, np.zeros(12), x_scale=np.tile([1e-4] * 3 + [0.1] * 3, 2), method="lm").x)


def at_best(
    scene: Scene, joints: Array, wrong: Mapping[str, float], points: tuple[Array, Array], names: Sequence[str]
) -> Array:
    """Return the covariance of an arm's errors `names` [deg, mm], of camera and board (12), at best (Cramer, Rao).

    Points (shown, and which of these are right) that were found wrongly tell nothing.
    """
    shown, right = points
    steps = [(name, 1e-4) for name in names] + [("", 1e-6)] * 12
    columns = []
    for k, (name, step) in enumerate(steps):
        ends = []
        for way in (step, -step):
            errors = {**wrong, name: wrong.get(name, 0.0) + way} if name else dict(wrong)
            by = np.zeros(12) if name else way * np.eye(12)[k - len(steps) + 12]
            ends.append(moved(scene, by).pixels(arm_poses(joints, errors), LENS)[0][shown][right].ravel())
        columns.append((ends[0] - ends[1]) / (2 * step * NOISE_PX))
    J = np.column_stack(columns)
    return np.asarray(np.linalg.inv(J.T @ J))


def bound(known: Array, free: Array, scene: Scene, C: Array, h: Array) -> dict[str, float]:
    """Return how well hand and eye can be known, the arm `known` and not, and how far C and h are off, squared."""
    known, free = known[-12:-6, -12:-6], free[-12:-6, -12:-6]
    off = np.concatenate([Rotation.from_matrix(scene.C.T @ C).as_rotvec(), C.T @ h - scene.C.T @ scene.h])
    out = {"squared": float(off @ np.linalg.solve(free, off))}
    for unit, own, size in (("mm", slice(3, 6), 1.0), ("deg", slice(0, 3), np.degrees(1.0))):
        for what, covariance in (("knowing", known), ("least", free)):
            out[f"{unit}_{what}"] = float(size * np.sqrt(np.trace(covariance[own, own])))
    return out


def predicted(result: Any, joints: Array, folder: Path, place: str) -> Array:
    """Return the images (N, n, 2) of all points at new joints, as the result tells them."""
    cells = {f"q{i + 1}_deg": np.repeat(joints[:, i], len(GRID)) for i in range(6)}
    points = dict(zip(("board_x_mm", "board_y_mm"), np.tile(GRID, (len(joints), 1)).T, strict=True))
    blank = write(
        folder / "new.csv", {"pose": np.repeat(np.arange(len(joints)), len(GRID)), **cells, **points}, camera(place)
    )
    told = dc.predict(result, blank)
    return np.asarray(told.measured).reshape(len(joints), len(GRID), 2)


def opencv(columns: Mapping[str, Sequence[Any]], place: str, errors: Mapping[str, float]) -> dict[str, Scene]:
    """Return camera and board by OpenCV's methods; nothing where its version has none of them."""
    try:
        import cv2
    except ImportError:
        return {}
    if not hasattr(cv2, "calibrateHandEye"):
        return {}
    K = np.array([[LENS["fx_px"], 0, LENS["cx_px"]], [0, LENS["fy_px"], LENS["cy_px"]], [0, 0, 1]])
    view = np.array(columns["pose"], dtype=int)
    points = np.column_stack([columns["board_x_mm"], columns["board_y_mm"], np.zeros(len(view))]).astype(float)
    uv = np.column_stack([columns["u_px"], columns["v_px"]]).astype(float)
    joints = np.column_stack([columns[f"q{i}_deg"] for i in range(1, 7)]).astype(float)
    R, t, kept = [], [], []
    for k in np.unique(view):
        own = view == k
        if own.sum() < 6:
            continue
        _, agree = cv2.findHomography(points[own][:, :2], uv[own], cv2.RANSAC, 10 * NOISE_PX)
        right = np.zeros(own.sum(), dtype=bool) if agree is None else agree.ravel() > 0
        if right.sum() < 6:
            continue
        done, r, at = cv2.solvePnP(points[own][right], uv[own][right], K, None, flags=cv2.SOLVEPNP_IPPE)
        if done:
            r, at = cv2.solvePnPRefineLM(points[own][right], uv[own][right], K, None, r, at)
            R.append(cv2.Rodrigues(r)[0])
            t.append(at.ravel())
            kept.append(joints[np.flatnonzero(own)[0]])
    if len(R) < 3:  # too few images that show enough of the board
        return {}
    hand = arm_poses(np.array(kept), errors)
    if place == "fixed":  # the base as the camera's hand sees it
        hand = np.swapaxes(hand[0], 1, 2), -np.einsum("nji,nj->ni", *hand)
    out = {}
    for name in METHODS:
        X, x = cv2.calibrateHandEye(*map(list, hand), R, t, method=getattr(cv2, f"CALIB_HAND_EYE_{name}"))
        if not np.isfinite(X).all() or np.linalg.det(X) <= 0:
            continue  # it gave none
        turns = Rotation.from_matrix([A @ X @ B for A, B in zip(hand[0], R, strict=True)])
        at = [A @ (X @ b + x.ravel()) + a for A, a, b in zip(*hand, t, strict=True)]
        out[name] = Scene(place, X.T, -X.T @ x.ravel(), turns.mean().as_matrix(), np.median(at, axis=0))
    return out


# ----------------------------------------------------------------------------------------------------------- confounds

SCALE, DISTANCE, BOARD = "the machine's own scale", "the distance of the board", "where the board lies"
DELTA = Path(dc.__file__).parent / "examples/delta/robot.toml"
SHOULDERS = ("ez_1", "ez_2", "ez_3")  # heights, by which the plane leans and lies in which a Delta moves
PRINT = np.array([[x, y, 0.0] for x in np.linspace(-250, 250, 6) for y in np.linspace(-200, 200, 5)])
BELOW = 860.0  # mm


def confounds_row(seed: int, folder: Path) -> dict[str, float]:
    """Return of each thing that readings cannot tell whether it is said, and whether it is where they can: 1 or 0."""
    rng = np.random.default_rng(seed)
    place = ("platform", "fixed")[seed % 2]
    wrong = {name: ERRORS[name[:-2]] * rng.standard_normal() for name in AT_FAULT}
    joints = joints_around(rng, VIEWS)
    poses = arm_poses(joints, wrong)
    scale = 1 + 0.002 * rng.standard_normal()
    images = rows_seen(joints, *around(poses, place).pixels(poses, LENS, scale), rng)
    at = poses[1] - poses[1].mean(axis=0)
    on_board = at @ turn(*rng.uniform(-0.3, 0.3, 3)) / scale + 0.02 * rng.standard_normal(at.shape)
    touched = {f"q{i + 1}_deg": joints[:, i] for i in range(6)}
    touched |= {f"board_{axis}_mm": values for axis, values in zip("xyz", on_board.T, strict=True)}
    arm, touch, print_of = arm_robot(folder), 'kind = "position"\nsigma_mm = 0.02\n', 'board_scale = "unknown"\n'
    looked = camera(place, **LENS)

    def told(robot: Path, values: Mapping[str, Sequence[Any]], said: str) -> Any:
        return dc.identify(robot, write(folder / "read.csv", values, said))

    seen = told(arm, images, looked.replace("[measurement.camera]", f"{print_of}[measurement.camera]"))
    known, free, felt = told(arm, images, looked), told(arm, images, camera(place)), told(arm, touched, touch)
    axes, flat = table(folder), level(rng)
    behind = {f"q{i + 1}_mm": flat["q"][:, i] for i in range(3)}
    behind |= {f"enc{i + 1}_mm": flat["q"][:, i] + 0.5 + 0.01 * rng.standard_normal(VIEWS) for i in range(3)}
    encoder = told(axes, behind, 'kind = "encoder"\n')
    on_print, at_robot = touches(rng)
    delta, there = told(DELTA, on_print, touch), told(DELTA, at_robot, f'{touch}frame = "robot"\n')
    centre = {name: LENS[name] for name in ("cx_px", "cy_px")}
    still = told(axes, flat["images"], camera("platform", **centre))
    return {
        "print, seen": rival(seen, "board_scale", SCALE),
        "print, touched": rival(told(arm, touched, touch + print_of), "board_scale", SCALE),
        "focal length": rival(still, "fx_px", DISTANCE),
        "zero and frame": spoken(felt, "theta_1 and where the board lies"),
        "zero and camera": spoken(known, "theta_1 and where camera and board stand"),
        "plane and plane": leaning(delta),
        "zero and encoder": rival(encoder, "enc_zero_2", "the zero of joint 2"),
        "not there: print, seen": spoken(known, SCALE),
        "not there: print, touched": spoken(felt, SCALE),
        "not there: focal length": spoken(free, DISTANCE),
        "not there: plane and plane": spoken(there, BOARD),
        "not there: zero of joint 2": spoken(known, "theta_2 and where") or spoken(felt, "theta_2 and where"),
    }


def rival(result: Any, name: str, words: str) -> float:
    """Return 1 where an unknown names what stands for it, in a sentence with both, and a reading is proposed."""
    (own,) = (p for p in result.parameters if p.name == name)
    whole = words in (own.indistinguishable_from or ()) and spoken(result, name) and result.next_measurements
    return float(bool(whole) and (own.status == "not pinned" or name.startswith("enc")))


def spoken(result: Any, words: str) -> float:
    """Return 1 where a sentence on what is one number has these words."""
    return float(any(words in c.text for c in result.unidentifiable if "one number" in c.text))


def leaning(result: Any) -> float:
    """Return 1 where each height of a shoulder is told with where the board lies, and that this would settle it."""
    told = [c.text for c in result.unidentifiable if f"and {BOARD} are one number" in c.text]
    both = all(any(f"{name} by" in text for text in told) for name in SHOULDERS)
    return float(both and any(BOARD in remedy.measurement for remedy in result.next_measurements))


def touches(rng: np.random.Generator) -> tuple[dict[str, Any], dict[str, Any]]:
    """Return what a Delta with errors reads that touches a leaning print all over; the same in the robot's frame."""
    sizes = {"ez": 0.5, "theta": np.radians(0.2), "L": 0.3}  # mm, rad
    wrong = {f"{name}_{i}": size * rng.standard_normal() for name, size in sizes.items() for i in (1, 2, 3)}
    drawn, joints = numbers(dc.read_robot(DELTA).geometry), np.zeros((len(PRINT), 3))
    points = PRINT @ turn(*rng.uniform(-0.02, 0.02, 2), 0.0).T - [0.0, 0.0, BELOW]
    for k, at in enumerate(points):

        def off(u: Array, at: Array = at) -> Array:  # the platform's turns, and the joints
            return closure(drawn, wrong, np.concatenate([at, u[:3]]), u[3:], np.zeros(3)) / BELOW

        def slope(u: Array, off: Any = off) -> Array:
            return np.column_stack([off(u + 1e-20j * e).imag / 1e-20 for e in np.eye(6)])

        found = root(off, np.concatenate([np.zeros(3), joints[k - 1]]), jac=slope, tol=1e-12)
        assert np.abs(found.fun).max() < 1e-9, f"the Delta does not reach {at}"
        assert np.abs(found.x[:3]).max() < 0.1, f"the platform is turned over at {at}"
        joints[k] = found.x[3:]
    joints = np.degrees(joints)
    columns = {f"q{i + 1}_deg": q for i, q in enumerate(joints.T)}
    noise = 0.02 * rng.standard_normal(PRINT.shape)
    read = (PRINT + noise * [1, 1, 0], points + noise)
    on_print, at_robot = (columns | {f"board_{a}_mm": v for a, v in zip("xyz", r.T, strict=True)} for r in read)
    return on_print, at_robot


def table(folder: Path) -> Path:
    """Write a machine of three axes at right angles, which slide."""
    axes = ((-90.0, -90.0), (-90.0, -90.0), (0.0, 0.0))
    links = (
        f'[[joint]]\nkind = "prismatic"\nconvention = "standard"\na = 0.0\nd = 0.0\nalpha = {alpha}\ntheta = {theta}\n'
        for alpha, theta in axes
    )
    path = folder / "table.toml"
    path.write_text(f'[robot]\nname = "table"\nmechanism = "serial"\n{"".join(links)}')
    return path


def level(rng: np.random.Generator) -> dict[str, Any]:
    """Return joints of that table, and what a camera on it sees that looks straight down from one height."""
    q = np.column_stack([np.full(VIEWS, 100.0), rng.uniform(-60, 60, (VIEWS, 2))])
    hand, at, T = [], [], np.eye(4)
    for row in q:
        T = np.eye(4)
        for way, (alpha, theta) in zip(row, ((-90.0, -90.0), (-90.0, -90.0), (0.0, 0.0)), strict=True):
            c, s, ca, sa = (f(np.radians(v)) for v in (theta, alpha) for f in (np.cos, np.sin))
            T = T @ np.array([[c, -s * ca, s * sa, 0], [s, c * ca, -c * sa, 0], [0, sa, ca, way], [0, 0, 0, 1]])
        hand.append(T[:3, :3])
        at.append(T[:3, 3])
    down = np.diag([1.0, -1.0, -1.0])  # the camera's axis, along which the first joint stays where it is
    upright = T[:3, :3].T @ np.column_stack([[1.0, 0, 0], [0, 1.0, 0], [0, 0, 1.0]])
    middle = np.mean(at, axis=0)
    scene = Scene("platform", down @ upright.T, np.zeros(3), np.eye(3), middle - [75.0, 60.0, 500.0])
    pixels, shown = scene.pixels((np.array(hand), np.array(at)), LENS)
    seen = rows_seen(np.column_stack([q, np.zeros((VIEWS, 3))]), pixels, shown, rng)
    images = {name.replace("_deg", "_mm"): v for name, v in seen.items() if name not in ("q4_deg", "q5_deg", "q6_deg")}
    return {"q": q, "images": images}


# ------------------------------------------------------------------------------------------------------------ the table

PARTS: dict[str, Callable[[int, Path], dict[str, float]]] = {"camera": camera_row, "confounds": confounds_row}


def summary(part: str, rows: Sequence[Mapping[str, str]]) -> list[str]:
    """Return what the rows of a part say together."""
    column = {name: np.array([float(row[name]) for row in rows]) for name in rows[0] if name != "seed"}
    if part == "confounds":
        return [f"{name}: {int(values.sum())} of {len(rows)}" for name, values in column.items()]
    within, all_ = column["within"].sum(), column["identified"].sum()
    lines = [f"within three standard deviations: {within:.0f} of {all_:.0f} ({100 * within / all_:.1f} %)"]
    for unit in ("mm", "deg"):
        of = ("ours", "told", "adjusted", "knowing", "least")
        ours, told, adjusted, knowing, least = (np.sqrt(np.mean(column[f"{unit}_{who}"] ** 2)) for who in of)
        lines.append(
            f"hand and eye, {unit}: told the machine {told:.4f}, {told / adjusted:.2f} of a bundle adjustment that "
            f"knows it, {told / knowing:.2f} of the bound; not told it {ours:.4f}, {ours / least:.2f} of the bound"
        )
    squared = column["squared"].mean() / 6
    lines.append(f"hand and eye, not told the machine: squared error by the bound's covariance {squared:.2f} of 1")
    for name, off in ((name[3:], off) for name, off in column.items() if name.startswith("px_")):
        if (gave := np.isfinite(off)).any():
            worse = int((off[gave] < column["px_deltacal"][gave]).sum())
            middle = f"median {np.median(off[gave]):.3f}, worst {off[gave].max():.3f}"
            lines.append(f"new images, {name}: {middle} px; better than deltacal in {worse} of {gave.sum()}")
    return lines


def main(arguments: Sequence[str]) -> int:
    """Try the seeds of a part; print what they say together."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("part", choices=PARTS)
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("-o", "--output", type=Path, required=True, help="the rows, a CSV file")
    asked = parser.parse_args(arguments)
    rows: list[dict[str, Any]] = []
    if asked.output.exists():
        with asked.output.open(encoding="utf-8") as kept:
            rows = list(csv.DictReader(kept))
    had = {int(row["seed"]) for row in rows}
    for seed in (s for s in range(asked.count) if s not in had):
        with tempfile.TemporaryDirectory() as folder:
            rows.append({"seed": seed, **PARTS[asked.part](seed, Path(folder))})
        with asked.output.open("w", newline="", encoding="utf-8") as file:
            table_ = csv.DictWriter(file, list(rows[0]), lineterminator="\n")
            table_.writeheader()
            table_.writerows(rows)
    print(*summary(asked.part, [{k: str(v) for k, v in row.items()} for row in rows]), sep="\n")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

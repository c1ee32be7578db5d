"""The ladder of an arm's drives by hand: what someone with NumPy, SciPy and a day would write.

``python tests/benchmarks/by_hand_motion.py RECORDING.csv ROBOT.toml``

Newton and Euler in the frames of Denavit and Hartenberg, derivatives by a Butterworth filter run both ways and central
differences, least squares per joint, whole runs held out (stretches where a joint moves in fewer than three runs),
rungs taken while each buys 2 % of the held-out rms; figures are of folds that took no part in choice nor fit, on
readings as recorded and at 5, 10 and 20 Hz. It imports nothing of the project; `motion_by_hand` sets the tool beside.
"""

from __future__ import annotations

import argparse
import csv
import tomllib
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from scipy.signal import butter, filtfilt

Array = np.ndarray
CUTOFF = 10.0  # Hz, of the joints
AT_REST = 0.01  # of the highest speed
BUYS = 0.02
PARTS = 5  # of a recording of few runs
GAP = 0.3  # s
LOW = (5.0, 10.0, 20.0)  # Hz


def regressor(links: Sequence[dict], q: Array, qd: Array, qdd: Array, gravity: Array) -> Array:
    """Return (n, N, 10 n): the torque of each joint by mass, first moments and inertia of each link."""
    n, N = q.shape[1], len(q)
    R, o = np.tile(np.eye(3), (N, 1, 1)), np.zeros((N, 3))
    w, dw, a = np.zeros((N, 3)), np.zeros((N, 3)), np.tile(-gravity, (N, 1))
    axes, out = [], np.zeros((n, N, 10 * n))
    for j, link in enumerate(links):
        z, at = R[:, :, 2].copy(), o.copy()
        axes.append((z, at))
        dw = dw + np.cross(w, z * qd[:, j, None]) + z * qdd[:, j, None]
        w = w + z * qd[:, j, None]
        t, al = q[:, j] + np.radians(link.get("theta", 0.0)), np.radians(link.get("alpha", 0.0))
        c, s = np.cos(t), np.sin(t)
        A = np.zeros((N, 3, 3))
        A[:, 0, 0], A[:, 0, 1], A[:, 0, 2] = c, -s * np.cos(al), s * np.sin(al)
        A[:, 1, 0], A[:, 1, 1], A[:, 1, 2] = s, c * np.cos(al), -c * np.sin(al)
        A[:, 2, 1], A[:, 2, 2] = np.sin(al), np.cos(al)
        step = np.column_stack([link.get("a", 0.0) * c, link.get("a", 0.0) * s, np.full(N, link.get("d", 0.0))]) / 1000
        r = np.einsum("nij,nj->ni", R, step)
        a = a + np.cross(dw, r) + np.cross(w, np.cross(w, r))
        R, o = R @ A, o + r
        force, moment = np.zeros((N, 3, 10)), np.zeros((N, 3, 10))
        force[:, :, 0] = a
        for k in range(3):
            e = R[:, :, k]
            force[:, :, 1 + k] = np.cross(dw, e) + np.cross(w, np.cross(w, e))
            moment[:, :, 1 + k] = np.cross(e, a)
        for k, (x, y) in enumerate(((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))):
            E = np.zeros((3, 3))
            E[x, y] = E[y, x] = 1.0
            T = R @ E @ np.swapaxes(R, 1, 2)
            L = np.einsum("nij,nj->ni", T, w)
            moment[:, :, 4 + k] = np.einsum("nij,nj->ni", T, dw) + np.cross(w, L)
        about = moment + np.cross(o[:, :, None], force, axisa=1, axisb=1, axisc=1)
        for i, (z, at) in enumerate(axes):
            own = about - np.cross(at[:, :, None], force, axisa=1, axisb=1, axisc=1)
            out[i, :, 10 * j : 10 * j + 10] = np.einsum("ni,nik->nk", z, own)
    return out


def read(path: Path, joints: int) -> tuple[list[str], Array, Array, Array, list[str]]:
    with path.open() as file:
        rows = list(csv.DictReader(file))
    word = next(name for name in rows[0] if name.startswith(("tau1", "current1", "drive1")))
    columns = [word.replace("1", str(i + 1), 1) for i in range(joints)]
    run = [row.get("run", "1") for row in rows]
    q = np.array([[float(row[f"q{i + 1}_deg"]) for i in range(joints)] for row in rows])
    tau = np.array([[float(row[c]) if row[c] else np.nan for c in columns] for row in rows])
    return run, np.array([float(row["time_s"]) for row in rows]), np.radians(q), tau, columns


def low(values: Array, cutoff: float, step: float) -> Array:
    b, a = butter(4, min(2 * cutoff * step, 0.95))
    return filtfilt(b, a, values, axis=0)


def derivatives(q: Array, time: Array, run: Array) -> tuple[Array, Array, Array]:
    out = np.zeros((3, *q.shape))
    for code in np.unique(run):
        own = run == code
        step = float(np.median(np.diff(time[own])))
        even = np.arange(time[own][0], time[own][-1] + step / 2, step)
        smooth = low(np.column_stack([np.interp(even, time[own], x) for x in q[own].T]), CUTOFF, step)
        qd = np.gradient(smooth, step, axis=0)
        for n, values in enumerate((smooth, qd, np.gradient(qd, step, axis=0))):
            out[n, own] = np.column_stack([np.interp(time[own], even, x) for x in values.T])
    return out[0], out[1], out[2]


def folds(time: Array, run: Array, used: Array) -> tuple[Array, Array]:
    """Return the fold that each sample is fitted in, -1 in gaps between stretches, and the one it is held out with."""
    counts = {code: int((used & (run == code)).sum()) for code in np.unique(run)}
    whole = [code for code, n in counts.items() if n > 0.25 * used.sum() / max(1, sum(v > 0 for v in counts.values()))]
    out = np.full(len(time), -1)
    if len(whole) >= 3:
        for k, code in enumerate(whole):
            out[used & (run == code)] = k
        return out, out
    held = out.copy()
    for code in whole:
        own = np.flatnonzero(used & (run == code))
        length = max(1.6, float(time[own][-1] - time[own][0]) / 20)
        block = np.floor((time[own] - time[own][0]) / length).astype(int)
        inside = (time[own] - time[own][0]) - block * length
        held[own] = block % PARTS
        out[own] = np.where((inside > GAP) & (inside < length - GAP), held[own], -1)
    return out, held


def held_out(X: Array, y: Array, fold: Array) -> Array:
    left = np.full(len(y), np.nan)
    scale = np.sqrt(np.mean(X**2, axis=0)) + 1e-300
    for k in np.unique(fold[fold >= 0]):
        train, test = (fold >= 0) & (fold != k), fold == k
        found = np.linalg.lstsq(X[train] / scale, y[train], rcond=1e-6)[0]
        left[test] = y[test] - (X[test] / scale) @ found
    return left


def rms(values: Array) -> float:
    return float(np.sqrt(np.nanmean(values**2))) if np.isfinite(values).any() else float("nan")


def base(Y: Array) -> Array:
    """Return an orthonormal basis of what the rigid machine can ask of a joint."""
    scale = np.linalg.norm(Y, axis=0)
    Y = Y[:, scale > 1e-9 * scale.max()]
    U, s, _ = np.linalg.svd(Y / np.linalg.norm(Y, axis=0), full_matrices=False)
    return np.asarray(U[:, s > 1e-7 * s[0]]) * np.sqrt(len(Y))


def offered(qd: Array, qdd: Array, load: Array) -> dict[str, Array]:
    sign, top = np.sign(qd), np.quantile(np.abs(qd), 0.95)
    return {
        "coulomb": sign,
        "viscous": qd,
        "offset": np.ones_like(qd),
        "rotor": qdd,
        "quadratic": qd * np.abs(qd),
        "load": np.abs(load) * sign,
        **{f"stribeck {v:.3g}": sign * np.exp(-((qd / (v * top)) ** 2)) for v in (0.03, 0.06, 0.12, 0.25, 0.5)},
    }


def chosen(rigid: Array, y: Array, qd: Array, qdd: Array, fold: Array) -> list[str]:
    """Return the rungs that are taken while each buys something on the folds."""
    taken: list[str] = []
    while True:
        load = np.zeros(len(y))
        for _ in range(2):
            rungs = offered(qd, qdd, load)
            X = np.column_stack([rigid, *(rungs[name] for name in taken)])
            load = rigid @ np.linalg.lstsq(X[fold >= 0], y[fold >= 0], rcond=1e-6)[0][: rigid.shape[1]]
        now, word = rms(held_out(X, y, fold)), "stribeck" if any(t.startswith("stribeck") for t in taken) else "-"
        rest = {name: x for name, x in rungs.items() if name not in taken and not name.startswith(word)}
        after = {name: rms(held_out(np.column_stack([X, x]), y, fold)) for name, x in rest.items()}
        best = min(after, key=lambda name: after[name])
        if after[best] > (1 - BUYS) * now:
            return taken
        taken.append(best)


def ladder(Y: Array, y: Array, qd: Array, qdd: Array, fold: Array, held: Array) -> tuple[list[str], Array]:
    """Return the rungs that are taken, and residuals of folds that took no part in choice nor fit."""
    rigid, left = base(Y), np.full(len(y), np.nan)
    for k in np.unique(fold[fold >= 0]):
        others = np.where(fold == k, -1, fold)
        names, train, test = chosen(rigid, y, qd, qdd, others), others >= 0, held == k
        load = np.zeros(len(y))
        for _ in range(3):
            X = np.column_stack([rigid, *(offered(qd, qdd, load)[name] for name in names)])
            found = np.linalg.lstsq(X[train], y[train], rcond=1e-6)[0]
            load = rigid @ found[: rigid.shape[1]]
        left[test] = y[test] - X[test] @ found
    return chosen(rigid, y, qd, qdd, fold), left


def low_passed(left: Array, step: float) -> list[float]:
    """Return the rms of residuals (N,), nan where there are none, as recorded and through each of `LOW`."""
    there, whole = np.isfinite(left), np.nan_to_num(left)
    return [rms(left), *(rms(low(whole, f, step)[there]) for f in LOW)]


def residuals(
    recording: Path, robot: Path, split: Array | None = None
) -> tuple[list[str], Array, float, list[list[str] | None], Array]:
    """Return runs, times (N,), their ordinary step, the rungs of each joint and what they leave held out (N, n).

    `split` (2, N, n) says in which fold each sample is fitted and held out, -1 in none; by default its own.
    """
    said = tomllib.loads(robot.read_text())
    links, gravity = said["joint"], np.array(said.get("masses", {}).get("gravity", [0.0, 0.0, -9.81]))
    run, time, q, tau, _ = read(recording, len(links))
    code = np.unique(run, return_inverse=True)[1]
    q, qd, qdd = derivatives(q, time, code)
    Y = regressor(links, q, qd, qdd, gravity)
    names: list[list[str] | None] = []
    left = np.full(tau.shape, np.nan)
    for j in range(len(links)):
        speed = max(AT_REST * np.quantile(np.abs(qd[:, j]), 0.99), np.radians(0.5))
        used = (np.abs(qd[:, j]) > speed) & np.isfinite(tau[:, j])
        fold, held = folds(time, code, used) if split is None else np.where(used, split[:, :, j], -1)
        if used.sum() < 100 or len(np.unique(fold[fold >= 0])) < 2:
            names.append(None)
            continue
        own, left[used, j] = ladder(Y[j][used], tau[used, j], qd[used, j], qdd[used, j], fold[used], held[used])
        names.append(own)
    return run, time, float(np.median(np.diff(time)[np.diff(code) == 0])), names, left


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("recording", type=Path)
    parser.add_argument("robot", type=Path)
    options = parser.parse_args()
    _, _, step, names, left = residuals(options.recording, options.robot)
    for j, own in enumerate(names):
        if own is None:
            print(f"joint {j + 1}: does not move")
            continue
        listed = ", ".join(f"{v:.4g}" for v in low_passed(left[:, j], step))
        print(f"joint {j + 1}: {listed} (recorded, 5, 10, 20 Hz): {', '.join(own)}")


if __name__ == "__main__":
    main()

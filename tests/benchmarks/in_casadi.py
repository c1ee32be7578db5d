"""The works in CasADi: formulas of one pose made into C, ``gcc -O3 -march=native``, in a loop over the poses.

Where there is no C compiler CasADi interprets them, and `NAME` says so. Every public function gets a work ready and
returns what computes it: a function without arguments that returns an array. Names, order and units as in `by_hand`.
"""

from __future__ import annotations

import ctypes
import hashlib
import shutil
import subprocess
import tempfile
from collections.abc import Callable
from pathlib import Path

import casadi
import numpy as np
from casadi import SX, cross, dot, horzcat, vertcat

from tests.benchmarks import by_hand
from tests.benchmarks.by_hand import ARM, DONE, FRAMES, PLATFORM, ROD, E

CC = shutil.which("gcc") or shutil.which("cc")
NAME = "CasADi C" if CC else "CasADi VM"
FLAGS = ("-O3", "-march=native", "-shared", "-fPIC")
BUILT = Path(tempfile.gettempdir()) / "deltacal-casadi"  # compiled code by the hash of its text
LOOP = """
void loop(long long n, const double *const *given, double *out) {{
  const double *arg[{arg}]; double *res[{res}], w[{w}]; casadi_int iw[{iw}];
  for (long long k = 0; k < n; ++k) {{
    {arguments}
    {body}
  }}
}}
"""
ONCE = "res[0] = out + {size} * k; each(arg, res, iw, w, 0);"
NEWTON = """double *x = out + 6 * k, next[6], left;
    res[0] = x; start(arg, res, iw, w, 0);
    arg[{last}] = x; res[0] = next; res[1] = &left;
    do {{ each(arg, res, iw, w, 0); for (int i = 0; i < 6; ++i) x[i] = next[i]; }} while (left > {done});"""


def _inverse(a, b, c):
    """Return the columns of the inverse of a matrix by its rows."""
    columns = cross(b, c), cross(c, a), cross(a, b)
    by = 1 / dot(a, columns[0])
    return [column * by for column in columns]


def _joint(r, u):
    d = r - E * u
    x, z = dot(d, u), r[2]
    k = (dot(d, d) + (ARM**2 - ROD**2)) / (2 * ARM)
    root = casadi.sqrt(x * x + z * z - k * k)
    return casadi.atan2(z * k + x * root, x * k - z * root)


def _position(theta):
    elbows = [
        (E + ARM * casadi.cos(t)) * u + ARM * casadi.sin(t) * v
        for t, (u, v, _) in zip(theta, FRAMES.transpose(0, 2, 1), strict=True)
    ]
    a, b = elbows[1] - elbows[0], elbows[2] - elbows[0]
    n, aa, bb, ab = cross(a, b), dot(a, a), dot(b, b), dot(a, b)
    half = 0.5 / dot(n, n)
    u, v = bb * (aa - ab) * half, aa * (bb - ab) * half
    t = casadi.sqrt((ROD**2 - u * u * aa - v * v * bb - 2 * u * v * ab) * 2 * half)
    return elbows[0] + u * a + v * b - casadi.copysign(t, n[2]) * n


def _factors(theta, r):
    """Return A_rr^-1, A_ee^-1 and A_re, three vectors each, and B_r (3 x 8) and B_e (3 x 6) of eqs. (6) and (7)."""
    rods, arms, normals, B_r, B_e = [], [], [], [], []
    for t, (u, v, w) in zip(theta.elements(), FRAMES.transpose(0, 2, 1), strict=True):
        c, s = casadi.cos(t), casadi.sin(t)
        rod = (r - (E + ARM * c) * u - ARM * s * v) / ROD
        along_u, along_w = dot(rod, u), dot(rod, w)
        along_u1, along_v1 = c * along_u + s * rod[2], c * rod[2] - s * along_u
        rods.append(rod)
        arms.append(PLATFORM * cross(u, rod))
        normals.append(cross(w, rod))
        B_r.append([along_v1, rod[0], rod[1], rod[2], along_u1, s * along_w, -c * along_w, 1.0])
        B_e.append([1.0, along_w, -rod[2], along_u, -along_v1, along_u1])
    return _inverse(*rods), _inverse(*normals), arms, B_r, B_e


def sensitivity(theta, r, offset=(0.0, 0.0, 0.0)):
    """C of eq. (8), (N, 3, 42)."""
    t, at, out = SX.sym("theta", 3), SX.sym("r", 3), []
    G, M, arms, B_r, B_e = _factors(t, at)
    H = [cross(turn, offset) - sum(g * dot(arm, turn) for g, arm in zip(G, arms, strict=True)) for turn in M]
    for x in range(3):
        out += [g[x] * b for g, row in zip(G, B_r, strict=True) for b in row]
        out += [h[x] * b for h, row in zip(H, B_e, strict=True) for b in row]
    run = _over_poses([t, at], out, [theta, r])
    return lambda: run().reshape(-1, 3, 42)


def identification_matrix(theta, r, offset, columns):
    """H of eq. (14); NumPy takes the differences."""
    C = sensitivity(theta, r, offset)
    return lambda: by_hand.differences(np.take(C(), columns, axis=2), r)


def ideal_inverse(r):
    """Joints (N, 3)."""
    at = SX.sym("r", 3)
    return _over_poses([at], [_joint(at, u) for u in FRAMES[:, :, 0]], [r])


def ideal_forward(theta):
    """Positions (N, 3)."""
    t = SX.sym("theta", 3)
    return _over_poses([t], [_position(t.elements())], [theta])


def change(theta, r, p):
    """What eq. (23) adds to the joints (N, 3)."""
    t, at, errors = SX.sym("theta", 3), SX.sym("r", 3), SX.sym("p", 42)
    _, M, arms, B_r, B_e = _factors(t, at)
    f, g = errors[:24].reshape((8, 3)), errors[24:].reshape((6, 3))
    turn = sum(dot(vertcat(*B_e[i]), g[:, i]) * M[i] for i in range(3))
    out = [(dot(arms[i], turn) - dot(vertcat(*B_r[i]), f[:, i])) / (ARM * B_r[i][0]) for i in range(3)]
    return _over_poses([t, at, errors], out, [theta, r, p])


def forward(theta, rods):
    """Exact poses (N, 6) by Newton on the six rods."""
    t, machine, x = SX.sym("theta", 3), SX.sym("rods", 14, 6), SX.sym("x", 6)
    shrink, F, J = 1 / (1 + dot(x[3:], x[3:]) / 4), [], []
    for j, row in enumerate(casadi.horzsplit(machine)):
        angle = t[j // 2] + row[13]
        first = cross(x[3:], row[9:12])
        hand = row[9:12] + shrink * (first + cross(x[3:], first) / 2)
        d = x[:3] + hand - row[:3] * casadi.cos(angle) - row[3:6] * casadi.sin(angle) - row[6:9]
        moment = cross(hand, d)
        F.append((dot(d, d) - row[12] ** 2) / 2)
        J.append(horzcat(d.T, (shrink * (moment + cross(moment, x[3:]) / 2)).T))
    step = casadi.solve(vertcat(*J), vertcat(*F))
    ideal = _position([t[i] + machine[13, 2 * i] for i in range(3)])
    start = casadi.Function("start", [t, machine], [vertcat(ideal, 0, 0, 0)])
    each = casadi.Function("each", [t, machine, x], [x - step, casadi.mmax(casadi.fabs(step))])
    if CC:
        return _loop([start, each], NEWTON.format(last=2, done=DONE), [theta, rods.ravel()], 6)
    n, every = len(theta), (theta.T, np.tile(rods.T, len(theta)))

    def newton():
        x, left = start.map(n)(*every), np.inf
        while left > DONE:
            x, steps = each.map(n)(*every, x)
            left = float(casadi.mmax(steps))
        return np.array(x).T

    return newton


def torque(links, inertia, gravity, motion):
    """Torques (N, n) of a chain of turning joints [N mm], by Newton and Euler from link to link (Luh et al. 1980).

    `links` are tables of standard Denavit-Hartenberg numbers [mm, deg], `inertia` (n, 10) as the tool has it [kg, mm];
    all of them, and gravity (3,) [m/s^2], are numbers in the code. `motion` (3, N, n).
    """
    n = len(links)
    q, qd, qdd = (SX.sym(name, n) for name in ("q", "qd", "qdd"))
    z, w, dw, a = vertcat(0, 0, 1), SX.zeros(3), SX.zeros(3), SX(-np.asarray(gravity, dtype=float))
    frames, asked = [], []
    for i, (link, body) in enumerate(zip(links, np.asarray(inertia), strict=True)):
        turn, tilt = q[i] + np.radians(link.get("theta", 0.0)), np.radians(link.get("alpha", 0.0))
        c, s, ca, sa = casadi.cos(turn), casadi.sin(turn), round(np.cos(tilt), 15), round(np.sin(tilt), 15)
        R = vertcat(horzcat(c, -s * ca, s * sa), horzcat(s, c * ca, -c * sa), horzcat(0, sa, ca))
        way = casadi.DM([link.get("a", 0.0), link.get("d", 0.0) * sa, link.get("d", 0.0) * ca]) / 1000
        dw = R.T @ (dw + z * qdd[i] + cross(w, z * qd[i]))
        w = R.T @ (w + z * qd[i])
        a = R.T @ a + cross(dw, way) + cross(w, cross(w, way))
        m, h, (xx, yy, zz, xy, xz, yz) = body[0], casadi.DM(body[1:4]) / 1000, body[4:] / 1e6
        tensor = casadi.DM([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
        force = m * a + cross(dw, h) + cross(w, cross(w, h))
        asked.append((force, tensor @ dw + cross(w, tensor @ w) + cross(h, a)))
        frames.append((R, way))
    f, moment, out = SX.zeros(3), SX.zeros(3), []
    for (R, way), (force, own) in zip(frames[::-1], asked[::-1], strict=True):
        f, moment = f + force, moment + own
        f, moment = R @ f, R @ (moment + cross(way, f))
        out.append(1000 * moment[2])
    return _over_poses([q, qd, qdd], out[::-1], list(motion))


def _over_poses(symbols, out, given):
    """Return what computes `out`, numbers of one pose, at all poses: (N, numbers)."""
    each, n = casadi.Function("each", symbols, [vertcat(*out)]), len(given[0])
    if CC:
        return _loop([each], ONCE.format(size=each.numel_out(0)), given, each.numel_out(0))
    every, rows = each.map(n), [g.T if g.ndim == 2 else np.tile(g[:, None], n) for g in given]
    return lambda: np.array(every(*rows)).T


def _loop(functions: list[casadi.Function], body: str, given, size: int) -> Callable[[], np.ndarray]:
    """Return what runs compiled functions over the poses; of `given`, tables go row by row."""
    text, n = casadi.CodeGenerator("poses.c"), len(given[0])
    for function in functions:
        text.add(function)
    steps = [f" + {g.shape[1]} * k" if g.ndim == 2 else "" for g in given]
    arguments = " ".join(f"arg[{i}] = given[{i}]{step};" for i, step in enumerate(steps))
    room = {what: max(getattr(f, f"sz_{what}")() for f in functions) + 1 for what in ("arg", "res", "w", "iw")}
    run = _built(text.dump() + LOOP.format(**room, arguments=arguments, body=body)).loop
    kept, out = [np.ascontiguousarray(g, dtype=float) for g in given], np.empty((n, size))
    pointers = (ctypes.c_void_p * len(kept))(*(g.ctypes.data for g in kept))
    call = ctypes.c_longlong(n), pointers, ctypes.c_void_p(out.ctypes.data)

    def fill():
        run(*call)
        return out

    fill.given = kept  # what the pointers point at
    return fill


def _built(source: str) -> ctypes.CDLL:
    """Return the library of a C text, compiled unless it was before."""
    BUILT.mkdir(exist_ok=True)
    library = BUILT / f"{hashlib.sha256(' '.join((*FLAGS, source)).encode()).hexdigest()[:16]}.so"
    if not library.exists():
        with tempfile.TemporaryDirectory(dir=BUILT) as place:
            text, made = Path(place) / "poses.c", Path(place) / "poses.so"
            text.write_text(source)
            subprocess.run([CC, *FLAGS, text, "-o", made, "-lm"], check=True)
            made.rename(library)
    return ctypes.CDLL(str(library))


if __name__ == "__main__":
    by_hand.main(lambda theta, rods, _: forward(theta, rods)(), lambda *given: identification_matrix(*given)())

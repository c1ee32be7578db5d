"""The cases whose answers are frozen: files and commands, nothing of the package itself.

A case is a folder of input files and the commands that are run on them. Simulated ones are written here, one for each
mechanism, kind of measurement and effect, of drives too; those of a folder ``shared`` beside the checkout are taken as
they are.
"""

from __future__ import annotations

import csv
import io
import shutil
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "src" / "deltacal_gen" / "examples"
SHARED = ROOT.parent / "shared"
QUICK = ("machine-diamond", "machine-planar_parallelogram", "kind-height_distance", "effect-backlash")  # of make test
FROM_SHARED = {"klipper": 26, "duet-heightmaps": 3}  # recordings taken of a collection, evenly
SERIES = ("ipa-robot-accuracy-ur10/contract/series_d",)

Command = tuple[str, ...]


@dataclass(frozen=True)
class Case:
    """Input files and what is run on them.

    Attributes
    ----------
    name : str
        Of its folder: ``machine-``, ``kind-``, ``effect-`` (simulated), ``concealed-`` or ``real-``.
    write : callable
        Puts the input files into a folder.
    commands : tuple of tuple of str
        Arguments of ``deltacal``, run in that folder one after another.
    """

    name: str
    write: Callable[[Path], None]
    commands: tuple[Command, ...]


def cases() -> Iterator[Case]:
    """Yield every case; those of ``shared`` only where it is."""
    yield from _machines()
    yield from _kinds()
    yield from _effects()
    yield from _concealed()
    yield from _real()


def _after(model: str | None = None, *, export: bool = True, diagnose: bool = True) -> tuple[Command, ...]:
    """Return what is asked of a recording, and of what was found: predictions and corrected commands."""
    of_model: Command = () if model is None else ("--model", model)
    asked: list[Command] = [("identify", "robot.toml", "recording.csv", *of_model, "-o", "result.json")]
    answers = ["result"]
    if diagnose:
        asked.append(("diagnose", "robot.toml", "recording.csv", *of_model, "-o", "diagnosis.json"))
        answers.append("diagnosis")
    for answer in answers:
        asked.append(("predict", f"{answer}.json", "fresh.csv", "-o", f"predicted_by_{answer}.csv"))
        if export:
            asked.append(("compensate", f"{answer}.json", "targets.csv", "-o", f"joints_by_{answer}.csv"))
            asked.append(("compensate", f"{answer}.json", "--export", "c", "-o", f"command_by_{answer}.c"))
    return tuple(asked)


def _simulated(model: str | None = None, noise: float = 0.01, *, export: bool = True) -> tuple[Command, ...]:
    simulate = ("simulate", "robot.toml", "poses.csv", "--truth", "truth.toml", "--noise", str(noise), "--seed", "7")
    return ((*simulate, "-o", "recording.csv"), *_after(model, export=export))


def _write(folder: Path, files: Mapping[str, str]) -> None:
    for name, text in files.items():
        (folder / name).write_text(text, encoding="utf-8", newline="\n")


def _table(columns: Mapping[str, Sequence[object] | np.ndarray]) -> str:
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(columns)
    writer.writerows(zip(*columns.values(), strict=True))
    return out.getvalue()


def _read(path: Path) -> dict[str, list[str]]:
    with path.open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    return {name: [row[name] for row in rows] for name in rows[0]}


def _example(name: str) -> dict[str, str]:
    files = ("robot.toml", "poses.csv", "poses.toml", "truth.toml")
    return {file: (EXAMPLES / name / file).read_text(encoding="utf-8") for file in files}


# ------------------------------------------------------------------------------------------------- one per mechanism

FEW = 10  # poses of an example
MACHINES = {  # example, noise [mm], targets [mm]
    "delta": ("delta", 0.01, ((0, 0, -853), (120.5, -200, -900), (-300, 100.25, -780))),
    "complete_delta": ("delta", 0.01, ((0, 0, -853), (120.5, -200, -900), (-300, 100.25, -780))),
    "diamond": ("diamond", 0.002, ((0, -581), (-200, -600))),
    "linear_delta": ("linear_delta", 0.01, ((0, 0, 5), (40, -60, 80))),
    "planar_parallelogram": ("planar_parallelogram", 0.003, ()),
    "simplified_parallelogram": ("planar_parallelogram", 0.003, ()),
    "robotennis": ("robotennis", 0.005, ((0, 0, 800), (120, -80, 900))),
    "serial": ("serial", 0.02, ()),
    "hexapod": ("hexapod", 0.003, ()),
}


def _targets(points: Sequence[Sequence[float]]) -> dict[str, str]:
    columns = dict(zip(("x_mm", "y_mm", "z_mm"), np.transpose(points).tolist(), strict=False))
    return {"targets.csv": _table(columns)} if points else {}


def _grid(rows: Sequence[str]) -> list[str]:
    """Return targets in the plane on a grid over the range of a few (label, x, y)."""
    at = np.array([[float(cell) for cell in row.split(",")[1:]] for row in rows])
    x, y = (np.linspace(at[:, j].min(), at[:, j].max(), n) for j, n in ((0, 9), (1, 5)))
    return [f"{k},{a:g},{b:g}" for k, (a, b) in enumerate(((a, b) for b in y for a in x), 1)]


def _machines() -> Iterator[Case]:
    for name, (example, noise, points) in MACHINES.items():

        def write(
            folder: Path, name: str = name, example: str = example, points: Sequence[Sequence[float]] = points
        ) -> None:
            files = _example(example)
            header, *rows = files["poses.csv"].splitlines()
            kept = dict.fromkeys(rows) if len(rows) > FEW else _grid(rows)  # repeats take time, and tell of noise
            files["poses.csv"] = "\n".join([header, *kept]) + "\n"
            files["robot.toml"] = files["robot.toml"].replace(f'mechanism = "{example}"', f'mechanism = "{name}"')
            _write(folder, {**files, **_targets(points)})

        yield Case(f"machine-{name}", write, _predicting(_simulated(None, noise, export=bool(points))))


def _predicting(commands: tuple[Command, ...]) -> tuple[Command, ...]:
    """Return commands that predict the recording itself: its joints are what a controller reports."""
    return tuple(tuple("recording.csv" if part == "fresh.csv" else part for part in c) for c in commands)


# ----------------------------------------------------------------------------------------------------- one per kind


def _delta_kind(kind: str, extra: str = "") -> Callable[[Path], None]:
    def write(folder: Path) -> None:
        files = _example("gearbox")
        files["poses.toml"] = f'[measurement]\nkind = "{kind}"\nframe = "unknown"\n{extra}'
        if kind == "distance":
            a = np.tile(np.arange(1, 151), 2)
            b = (a + np.repeat((37, 61), 150) - 1) % 150 + 1
            files["poses.distances.csv"] = _table({"pose_a": a, "pose_b": b})
        _write(folder, {**files, **_targets(MACHINES["delta"][2])})

    return write


def _bed(distances: bool) -> Callable[[Path], None]:
    def write(folder: Path) -> None:
        files = _example("linear_delta")
        radius, angle = np.repeat((15.0, 40.0, 65.0, 85.0), 12), np.tile(np.arange(12) * 30.0, 4)
        x, y = radius * np.cos(np.radians(angle)), radius * np.sin(np.radians(angle))
        columns = {"pose": np.arange(1, 49), "x_mm": x.round(3), "y_mm": y.round(3), "z_mm": np.zeros(48)}
        if distances:
            files["poses.distances.csv"] = _table({"pose_a": [37, 39, 41, 38], "pose_b": [43, 45, 47, 44]})
        files["poses.csv"], files["poses.toml"] = _table(columns), '[measurement]\nkind = "height"\n'
        _write(folder, {**files, **_targets(MACHINES["linear_delta"][2])})

    return write


def _ball(folder: Path) -> None:
    files = _example("robotennis")
    camera = "fx_px = 1200.0\nfy_px = 1190.0\ncx_px = 640.0\ncy_px = 480.0\nk1 = -0.05\nball_radius_mm = 20.0\n"
    files["poses.toml"] = f'[measurement]\nkind = "sphere image"\nframe = "unknown"\n[camera]\n{camera}'
    rng = np.random.default_rng(5)
    at = np.column_stack([rng.uniform(-150, 150, (60, 2)), rng.uniform(790, 950, 60)]).round(3)
    files["poses.csv"] = _table(dict(zip(("x_mm", "y_mm", "z_mm"), at.T, strict=True)))
    _write(folder, {**files, **_targets(MACHINES["robotennis"][2])})


ARM = ((180.0, -90.0, 400.0, 0.0), (600.0, 0.0, 0.0, -90.0), (120.0, -90.0, 0.0, 0.0))  # a, alpha, d, theta: mm, deg
OFF = (0.0, 0.4, 0.0), (0.05, -0.08, 0.1)  # errors of a [mm] and theta [deg]
SOCKETS = {"front0": (700.0, 60.0, 500.0), "front1": (700.0, 110.0, 500.0), "left0": (-60.0, 720.0, 650.0)}
SOCKETS |= {"left1": (-60.0, 720.0, 700.0), "high0": (500.0, -450.0, 900.0), "high1": (535.355339, -414.644661, 900.0)}


def _tip(q: np.ndarray) -> np.ndarray:
    """Return the tip (N, 3) of a six-axis arm with errors in its first three links, by Denavit and Hartenberg."""
    rows = [*ARM, (0.0, 90.0, 650.0, 0.0), (0.0, -90.0, 0.0, 0.0), (0.0, 0.0, 115.0, 0.0)]
    T = np.tile(np.eye(4), (len(q), 1, 1))
    for j, (a, alpha, d, theta) in enumerate(rows):
        error_a, error_theta = (OFF[0][j], OFF[1][j]) if j < 3 else (0.0, 0.0)
        t, c, s = q[:, j] + np.radians(theta + error_theta), *(f(np.radians(alpha)) for f in (np.cos, np.sin))
        one, none = np.ones_like(t), np.zeros_like(t)
        ct, st, a = np.cos(t), np.sin(t), a + error_a
        rows_of = [[ct, -st * c, st * s, a * ct], [st, ct * c, -ct * s, a * st], [none, s * one, c * one, d * one]]
        T = T @ np.moveaxis(np.array([*rows_of, [none, none, none, one]]), 2, 0)
    return (T @ np.array([30.0, 0.0, 80.0, 1.0]))[:, :3]


def _sockets(folder: Path) -> None:
    """Write joints at which the tip sits in sockets, found by Newton's method from all sides."""
    rng, parts = np.random.default_rng(3), []
    for name, at in SOCKETS.items():
        q = rng.uniform(-1.5, 1.5, (150, 6))
        for _ in range(60):
            x = _tip(q)
            J = np.stack([(_tip(q + 1e-6 * e) - x) / 1e-6 for e in np.eye(6)], axis=2)
            step = (np.linalg.pinv(J) @ (np.array(at) - x)[:, :, None])[:, :, 0]
            q = q + np.clip(step, -0.2, 0.2)
        there = q[np.abs(_tip(q) - at).max(axis=1) < 1e-9][:20] + 2e-6 * rng.standard_normal((20, 6))
        parts += [[name, *np.degrees(row).round(7)] for row in there]
    robot = '[robot]\nname = "arm"\nmechanism = "serial"\n[geometry]\ntool = [30.0, 0.0, 80.0]\n'
    for a, alpha, d, theta in [*ARM, (0.0, 90.0, 650.0, 0.0), (0.0, -90.0, 0.0, 0.0), (0.0, 0.0, 115.0, 0.0)]:
        robot += f'[[joint]]\nkind = "revolute"\nconvention = "standard"\na = {a}\nalpha = {alpha}\nd = {d}\n'
        robot += f"theta = {theta}\n"
    pairs = ", ".join(f'["{n}", "{n[:-1]}1", 50.0]' for n in SOCKETS if n.endswith("0"))
    columns = zip(*parts, strict=True)
    names = ("contact", *(f"q{i}_deg" for i in range(1, 7)))
    sidecar = f'[measurement]\nkind = "contact"\n[contacts]\ndistance_mm = [{pairs}]\n'
    table = _table(dict(zip(names, columns, strict=True)))
    _write(folder, {"robot.toml": robot, "recording.csv": table, "recording.toml": sidecar})


def _drawn(folder: Path) -> None:
    files = _example("delta")
    _write(folder, {name: files[name] for name in ("robot.toml", "truth.toml")})


def _kinds() -> Iterator[Case]:
    base = "base_point_mm = [0.0, 0.0, 0.0]\n"
    for kind, extra in (("position", ""), ("pose", "sigma_deg = 0.003\n"), ("distance", ""), ("gauge", base)):
        model = "delta/18" if kind in ("distance", "gauge") else "delta/42"
        yield Case(f"kind-{kind}", _delta_kind(kind, extra), _predicting(_simulated(model)))
    yield Case("kind-height", _bed(distances=False), _predicting(_simulated(noise=0.005)))
    yield Case("kind-height_distance", _bed(distances=True), _predicting(_simulated(noise=0.005)))
    yield Case("kind-encoder", _delta_kind("encoder"), _predicting(_simulated()))
    for name, noise in (("touched_board", 0.02), ("board_image", 0.1)):  # mm, px
        plan = ("plan", "robot.toml", "--model", "delta/18", "--kind", name.replace("_", " "), "--optimal", "24")
        asked = _predicting(_simulated("delta/18", noise, export=False))
        yield Case(f"kind-{name}", _drawn, ((*plan, "-o", "poses.csv"), *asked))
    yield Case("kind-sphere", _ball, _predicting(_simulated(noise=0.1)))  # px
    asked = ("identify", "robot.toml", "recording.csv", "-o", "result.json")
    yield Case("kind-contact", _sockets, (asked, ("diagnose", *asked[1:-1], "diagnosis.json")))


# --------------------------------------------------------------------------------------------------- one per effect

GEARED = {  # amplitudes on the demonstration's machine that stand well above 0.01 mm; deg, mm, N, s, K as in files
    "backlash": "limb = 2\nwidth = 0.05",
    "base_compliance": "compliance_x = 0.004\ncompliance_y = 0.003",
    "distal_compliance": "limbs = [1, 2, 3]\ncompliance = 0.004",
    "friction_windup": "limb = 1\ncompliance = 0.004",
    "inertial_deflection": "limb = 3\ncompliance = 0.01",
    "instrument_drift": "rate_x = 0.2\nrate_y = -0.1\nrate_z = 0.15",
    "instrument_offset": "offset_x = 0.0\noffset_y = 0.08\noffset_z = 0.05",
    "instrument_scale": "scale = 250.0",
    "instrument_slip": "offset_x = 0.1\noffset_y = -0.15\noffset_z = 0.2\nwhen = 1500.0",
    "joint_axis_runout": "limb = 2\ncos = 0.05\nsin = 0.08",
    "joint_compliance": "limb = 1\ncompliance = 0.006",
    "joint_coupling": "limb = 3\ncoupling = 0.0015\nof = 1",
    "joint_scale": "limb = 3\nscale = 0.002",
    "joint_latency": "limb = 2\ndelay = 0.002",
    "latency": "delay = 0.002",
    "part_tilt": 'limb = 2\ntilt_x = 0.03\ntilt_y = -0.02\nof = "level_mrad"',
    "payload_deflection": "limb = 2\ncompliance = 0.008",
    "proximal_bending": "limbs = [1, 2, 3]\ncompliance = 0.01",
    "saturating_compliance": "limb = 2\ncompliance = 0.02\nlimit = 4.0",
    "thermal_growth": "expansion_proximal = 3e-5\nexpansion_distal = 2e-5\nexpansion_base = 1e-5",
    "thermal_zero": "limb = 1\ndrift = 0.01",
    "tool_slip": "offset_x = 0.1\noffset_y = -0.15\noffset_z = 0.2\nwhen = 1500.0",
    "transmission_eccentricity": "limb = 2\norder = 33\ncos = 0.02\nsin = 0.01",
    "warm_up": "limb = 1\nsize = 0.06\ntime_constant = 900.0",
    "zero_drift": "limb = 3\nrate = 0.08",
    "zero_jump": "limb = 1\nsize = 0.06\nwhen = 1500.0",
}
PRINTED = {  # on the printer's example
    "effector_tilt": "limb = 1\ndl = 0.3",
    "tower_lean": "limb = 2\nradial = 0.1\ntangential = 0.1",
    "bed_shape": "x = 0.0\ny = 0.0\nxx = 0.2\nxy = 0.1\nyy = -0.1",
}
DRIVEN = {  # a sliding joint: mm for deg
    "latency": "delay = 0.004",
    "transmission_eccentricity": "limb = 2\norder = 1\ncos = 0.03\nsin = 0.02",
}
CARRIED = {  # by an arm, and by one that a column lifts
    "link_bending": ("arm", "limb = 2\ncompliance = 0.002"),
    "link_torsion": ("arm", "limb = 3\ncompliance = 0.005"),
    "joint_tilt_compliance": ("arm", "limb = 4\ncompliance_x = 0.004\ncompliance_y = 0.005"),
    "column_lean": ("lift", "limb = 1\ncompliance = 3e-6"),
}
LIFT = """[robot]
name = "lift"
mechanism = "serial"
[geometry]
tool = [40.0, -15.0, 90.0]
"""
for sort, numbers, mass, com in (
    ("prismatic", "d = 400.0", 12.0, (60.0, 0.0, -30.0)),
    ("revolute", "a = 450.0\nd = 80.0", 6.0, (-200.0, 0.0, 0.0)),
    ("revolute", "a = 380.0\nalpha = 90.0", 4.0, (-170.0, 0.0, 20.0)),
    ("revolute", "d = 120.0", 1.0, (0.0, 0.0, -30.0)),
):
    LIFT += f'[[joint]]\nkind = "{sort}"\n{numbers}\nmass = {mass}\ncom = {list(com)}\n'
OF_DRIVES = {  # on the second of three joints; Nm, deg, kg, K, s
    "coulomb_friction": "coulomb = 4.0",
    "load_friction": "load = 0.15",
    "presliding_friction": "stiffness = 8.0\ncoulomb = 6.0",
    "quadratic_friction": "quadratic = 0.003",
    "rotor_inertia": "inertia = 2e6",
    "stribeck_friction": "stribeck = 4.0\nvelocity = 6.0",
    "torque_offset": "offset = 2.0",
    "torque_ripple": "order = 12\ncos = 0.8\nsin = -0.5",
    "viscous_friction": "viscous = 0.2",
    "warm_friction": "warm = -0.004",
}
FED_FORWARD = ("compensate", "diagnosis.json", "poses.csv", "--trajectory", "-o", "torques.csv")
LINKS = ((0.0, 90.0, 320.0, 9.0), (600.0, 0.0, 0.0, 8.0), (500.0, 0.0, 0.0, 5.0))  # a, alpha, d: mm, deg; kg


def _geared(name: str) -> Callable[[Path], None]:
    def write(folder: Path) -> None:
        files = _example("gearbox")
        poses: dict[str, Sequence[object] | np.ndarray] = dict(_read(EXAMPLES / "gearbox" / "poses.csv"))
        rng, n = np.random.default_rng(11), len(poses["pose"])
        if name in ("latency", "joint_latency", "inertial_deflection"):
            poses |= {f"qd{i}_deg_s": (60 * rng.standard_normal(n)).round(2) for i in (1, 2, 3)}
            poses |= {f"qdd{i}_deg_s2": (800 * rng.standard_normal(n)).round(1) for i in (1, 2, 3)}
        if name == "part_tilt":
            poses["level_mrad"] = rng.standard_normal(n).round(3)
        if name == "instrument_offset":
            points = np.array([(0.0, 0.0, -45.0), (40.0, 0.0, -45.0), (-20.0, 35.0, -10.0)])[rng.integers(3, size=n)]
            poses |= dict(zip(("tool_x_mm", "tool_y_mm", "tool_z_mm"), points.T, strict=True))
        files["poses.csv"] = _table(poses)
        parameters = files["truth.toml"].partition("[[effects]]")[0]
        files["truth.toml"] = f'{parameters}[[effects]]\nname = "{name}"\n{GEARED[name]}\n'
        fresh = _table({k: v[1::7] for k, v in poses.items()})
        targets = {"x_mm": [0.0, 110.0], "y_mm": [0.0, -170.0], "z_mm": [-735.0, -860.0], "payload_kg": [1.0, 0.0]}
        targets |= {"temp_C": [24.0, 21.0], "time_s": [6000.0, 6100.0]} | {f"approach{i}": [1, -1] for i in (1, 2, 3)}
        if name == "part_tilt":
            targets["level_mrad"] = [0.5, -1.0]
        _write(folder, {**files, "fresh.csv": fresh, "fresh.toml": files["poses.toml"], "targets.csv": _table(targets)})

    return write


def _printed(name: str, amplitudes: str) -> Callable[[Path], None]:
    def write(folder: Path) -> None:
        files = _example("linear_delta")
        if name == "bed_shape":
            _bed(distances=False)(folder)
            files = {}
        elif name == "latency":
            poses: dict[str, Sequence[object] | np.ndarray] = dict(_read(EXAMPLES / "linear_delta" / "poses.csv"))
            rng = np.random.default_rng(12)
            n = len(poses["x_mm"])
            poses |= {f"qd{i}_mm_s": (60 * rng.standard_normal(n)).round(2) for i in (1, 2, 3)}
            poses |= {f"qdd{i}_mm_s2": (800 * rng.standard_normal(n)).round(1) for i in (1, 2, 3)}
            files["poses.csv"] = _table(poses)
        truth = f'[parameters]\nradius = 0.6\nendstop_1 = 0.8\n[[effects]]\nname = "{name}"\n{amplitudes}\n'
        _write(folder, {**files, "truth.toml": truth, **_targets(MACHINES["linear_delta"][2])})

    return write


def _carried(name: str) -> Callable[[Path], None]:
    def write(folder: Path) -> None:
        machine, amplitudes = CARRIED[name]
        rng, n = np.random.default_rng(13), 150
        files = _example("serial") if machine == "arm" else {"robot.toml": LIFT}
        most = {"arm": [("deg", 70.0)] * 6, "lift": [("mm", 150.0), *[("deg", 80.0)] * 3]}[machine]
        poses = {f"q{i}_{unit}": rng.uniform(-size, size, n).round(3) for i, (unit, size) in enumerate(most, 1)}
        poses["payload_kg"] = rng.choice([0.0, 2.0, 4.0], n)
        files["poses.csv"], files["poses.toml"] = _table(poses), '[measurement]\nkind = "pose"\nframe = "unknown"\n'
        _write(folder, {**files, "truth.toml": f'[[effects]]\nname = "{name}"\n{amplitudes}\n'})

    return write


def _moved(name: str) -> Callable[[Path], None]:
    """Write a trajectory of an arm whose bodies are known, sums of waves, in a hall that warms."""

    def write(folder: Path) -> None:
        rng, time = np.random.default_rng(17), np.arange(0.0, 10.0, 0.01)
        rows = []
        for run in range(4):
            size, phase = rng.uniform(8.0, 20.0, (2, 4, 3)) * [[[1.0]], [[0.3]]]
            waves = 2 * np.pi * np.array([0.1, 0.23, 0.41, 0.6])
            q = (size * np.sin(waves[:, None] * time[:, None, None] + phase)).sum(axis=1)
            rows += [[run, t, *at, 20 + 5 * run] for t, at in zip(time.round(2), q.round(6), strict=True)]
        names = ("run", "time_s", "q1_deg", "q2_deg", "q3_deg", "temp_C")
        robot = '[robot]\nname = "arm"\nmechanism = "serial"\n'
        for a, alpha, d, mass in LINKS:
            robot += f'[[joint]]\nkind = "revolute"\na = {a}\nalpha = {alpha}\nd = {d}\nmass = {mass}\n'
            robot += "com = [-100.0, 20.0, 30.0]\ninertia = [2e4, 3e4, 4e4, 1e3, 2e3, 3e3]\n"
        files = {"robot.toml": robot, "poses.csv": _table(dict(zip(names, zip(*rows, strict=True), strict=True)))}
        files["poses.toml"] = '[measurement]\nkind = "torque"\n'
        _write(folder, {**files, "truth.toml": f'[[effects]]\nname = "{name}"\nlimb = 2\n{OF_DRIVES[name]}\n'})

    return write


def _effects() -> Iterator[Case]:
    for name in GEARED:
        yield Case(f"effect-{name}", _geared(name), _simulated())
    for name, amplitudes in PRINTED.items():
        model = None if name == "bed_shape" else "linear_delta/9"
        yield Case(f"effect-{name}", _printed(name, amplitudes), _predicting(_simulated(model, 0.005)))
    for name, amplitudes in DRIVEN.items():
        yield Case(f"effect-{name}-sliding", _printed(name, amplitudes), _predicting(_simulated(None, 0.005)))
    for name in CARRIED:
        yield Case(f"effect-{name}", _carried(name), _predicting(_simulated(None, export=False)))
    for name in OF_DRIVES:
        asked = [c for c in _predicting(_simulated(None, 0.05)) if "targets.csv" not in c]
        yield Case(f"effect-{name}", _moved(name), (*asked, FED_FORWARD))
    yield Case("effect-parallelogram_error", _delta_kind("position"), _predicting(_simulated("delta/18")))


# ------------------------------------------------------------------------------------------ beside the checkout


def _copied(source: Path) -> Callable[[Path], None]:
    def write(folder: Path) -> None:
        for file in source.iterdir():
            if file.suffix in (".csv", ".toml") and "truth" not in file.name:
                shutil.copyfile(file, folder / file.name)
        if (source / "fresh.csv").is_file():
            points = ((0.0, 0.0, -800.0), (60.5, -80.0, -830.0))
            _write(folder, _targets(points))

    return write


def _concealed() -> Iterator[Case]:
    for source in sorted((SHARED / "concealed").glob("dev_*")):
        yield Case(f"concealed-{source.name}", _copied(source), _after())


def _real() -> Iterator[Case]:
    chosen = [SHARED / "recordings" / series for series in SERIES if (SHARED / "recordings" / series).is_dir()]
    for collection, count in FROM_SHARED.items():
        every = sorted((SHARED / "recordings" / collection / "contract").glob("*/recording.csv"))
        chosen += [every[i].parent for i in np.linspace(0, len(every) - 1, count).astype(int)] if every else []
    for source in chosen:
        commands = tuple(c for c in _predicting(_after(export=False)) if "targets.csv" not in c)
        yield Case(
            f"real-{source.relative_to(SHARED / 'recordings').parts[0]}-{source.name}", _copied(source), commands
        )

"""Good inputs of each sort for every command that reads files: what `fuzz` damages."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

import deltacal_gen as dc
from deltacal_gen.app.demonstration import example
from tests.support import bags, mocap

TARGETS = {
    "delta": "x_mm,y_mm,z_mm\n0,0,-853\n99,0,-900\n",
    "diamond": "x_mm,y_mm\n0,-900\n50,-950\n",
    "planar_parallelogram": "x_mm,y_mm\n-660,-770\n",
    "linear_delta": "x_mm,y_mm,z_mm\n0,0,0\n50,20,5\n",
    "hexapod": "x_mm,y_mm,z_mm,rx_deg,ry_deg,rz_deg\n0,0,310,0,0,0\n10,5,300,3,-2,5\n",
    "serial": "q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg\n1,2,3,4,25,6\n",
}
MACHINES = ("delta", "diamond", "planar_parallelogram", "linear_delta", "serial", "hexapod")


@dataclass(frozen=True)
class Job:
    """A command with good inputs: arguments, in which ``{name}`` is a file of the folder, and the files damaged."""

    arguments: tuple[str, ...]
    damaged: tuple[str, ...]

    @property
    def name(self) -> str:
        """The command."""
        return self.arguments[0]


def shelf(folder: Path) -> None:
    """Fill a folder with a good input of each sort for each machine."""
    for machine in MACHINES:
        source = example().parent / machine
        for name in ("robot.toml", "poses.csv", "poses.toml", "truth.toml", "printer.cfg", "arm.urdf"):
            if (source / name).exists():
                (folder / f"{machine}.{name}").write_bytes((source / name).read_bytes())
        robot, recording = folder / f"{machine}.robot.toml", folder / f"{machine}.recording.csv"
        truth = (
            folder / f"{machine}.truth.toml" if machine == "linear_delta" else None
        )  # else firmware cannot be bettered
        dc.simulate(robot, folder / f"{machine}.poses.csv", output=recording, truth=truth, noise=0.02, seed=3)
        dc.identify(robot, recording, output=folder / f"{machine}.result.json")
    for name in ("robot.toml", "recording.csv", "recording.toml"):
        (folder / f"gearbox.{name}").write_bytes((example().parent / "gearbox" / name).read_bytes())
    dc.diagnose(
        folder / "gearbox.robot.toml", folder / "gearbox.recording.csv", output=folder / "gearbox.diagnosis.json"
    )
    for machine, rows in TARGETS.items():
        (folder / f"{machine}.targets.csv").write_text(rows)
    (folder / "targets.csv").write_text("x_mm,y_mm,z_mm,payload_kg,temp_C,approach1\n0,0,-853,1,21,1\n99,0,-900,,,-1\n")
    (folder / "config.g").write_text(
        "; delta\nM665 R160 L345:345:345 H380 X0.1 Y0 Z0\nM666 X0.1 Y-0.1 Z0\nG31 Z0.5 X0 Y0\n"
    )
    (folder / "marlin.txt").write_text(
        "M665 L345 R160 H380 X0.1 Y0 Z0\nM666 X-0.1 Y-0.2 Z0\nM851 Z-0.5\nBed X: 0 Y: 0 Z: 0.1\nBed X: 9 Y: 9 Z: 0.2\n"
    )
    (folder / "heightmap.csv").write_text(
        "RepRapFirmware height map file v2 generated\n"
        "xmin,xmax,ymin,ymax,radius,xspacing,yspacing,xnum,ynum\n-80,80,-80,80,90,80,80,3,3\n"
        "0,0.1,0\n0.12,-0.01,0.05\n0,0.02,0\n"
    )
    rows = (folder / "delta.recording.csv").read_text().splitlines()
    head = rows[0].split(",")
    joints, xyz = (
        [head.index(n) for n in names] for names in (("q1_deg", "q2_deg", "q3_deg"), ("x_mm", "y_mm", "z_mm"))
    )
    cells = [row.split(",") for row in rows[1:]]
    (folder / "joints.csv").write_text(
        "point,J1 [deg],J2 [deg],J3 [deg]\n"
        + "".join(f"p{k},{','.join(c[j] for j in joints)}\n" for k, c in enumerate(cells))
    )
    (folder / "points.txt").write_text("".join(f"A;p{k};{';'.join(c[j] for j in xyz)}\n" for k, c in enumerate(cells)))
    _kinds(folder)
    _once(folder)


# --------------------------------------------------------------------------------------- kinds of readings of their own

ARMS = '[robot]\nname = "arms"\nmechanism = "delta"\n'
CHAIN = """[robot]
name = "two links"
mechanism = "serial"
"""
LINK = """
[[joint]]
kind = "revolute"
a = 300.0
alpha = 0.0
d = 0.0
theta = 0.0
mass = 3.0
com = [-150.0, 0.0, 0.0]
inertia = [100.0, 22500.0, 22500.0, 0.0, 0.0, 0.0]
"""
SLIDE = """[robot]
name = "axis"
mechanism = "serial"
[[joint]]
kind = "prismatic"
a = 0.0
alpha = 0.0
d = 0.0
theta = 0.0
"""
LENS = "fx_px = 1500.0\nfy_px = 1480.0\ncx_px = 640.0\ncy_px = 512.0\nk1 = -0.1\n"
FRICTION = """[[effects]]
name = "coulomb_friction"
limb = 1
coulomb = 2.0
[[effects]]
name = "viscous_friction"
limb = 2
viscous = 0.02
"""
KINDS = ("encoder", "touched", "images", "torque", "axis")


def _table(head: str, rows: Iterable[Sequence[object]]) -> str:
    return "\n".join([head, *(",".join(map(str, row)) for row in rows)]) + "\n"


def _kinds(folder: Path) -> None:
    """Write robot, poses and sidecar of each of `KINDS`, simulate its readings, and identify by them."""
    dice = np.random.default_rng(5)
    delta = (folder / "delta.robot.toml").read_text()
    joints = [(k, *dice.uniform(0, 40, 3).round(3)) for k in range(30)]
    grid = [(x, y) for x in (0, 40, 80) for y in (0, 40, 80)]
    swings = [
        (run, round(0.01 * n, 2), *(40 * np.sin(0.06 * n * (run + w) + w) for w in (1, 2)))
        for run in (1, 2, 3)
        for n in range(150)
    ]
    (folder / "torque.truth.toml").write_text(FRICTION)
    given = {
        "encoder": (ARMS, _table("pose,q1_deg,q2_deg,q3_deg", joints), 'kind = "encoder"\nsigma_deg = 0.01\n'),
        "touched": (delta, _table("pose,q1_deg,q2_deg,q3_deg", joints), 'kind = "touched board"\nsigma_mm = 0.05\n'),
        "images": (
            delta,
            _table("pose,q1_deg,q2_deg,q3_deg,board_x_mm,board_y_mm", [(*j, *g) for j in joints[:12] for g in grid]),
            f'kind = "board image"\nsigma_px = 0.1\n[measurement.camera]\n{LENS}',
        ),
        "torque": (CHAIN + 2 * LINK, _table("run,time_s,q1_deg,q2_deg", swings), 'kind = "torque"\n'),
    }
    for name, (robot, poses, sidecar) in given.items():
        (folder / f"{name}.robot.toml").write_text(robot)
        (folder / f"{name}.poses.csv").write_text(poses)
        (folder / f"{name}.poses.toml").write_text(f"[measurement]\n{sidecar}")
        truth = folder / f"{name}.truth.toml"
        dc.simulate(
            folder / f"{name}.robot.toml",
            folder / f"{name}.poses.csv",
            output=folder / f"{name}.recording.csv",
            truth=truth if truth.exists() else None,
            noise=0.01,
            seed=3,
        )
    ways = [
        (c, 20 * (42 * c + k), q, q - way * 0.006) for c in range(3) for k, (q, way) in enumerate(_forth_and_back())
    ]
    (folder / "axis.robot.toml").write_text(SLIDE)
    noisy = [(c, t, q, x + 0.001 * dice.standard_normal()) for c, t, q, x in ways]
    (folder / "axis.recording.csv").write_text(_table("cycle,time_s,q1_mm,x_mm", noisy))
    (folder / "axis.recording.toml").write_text('[measurement]\nkind = "position"\nsigma_mm = 0.001\n')
    for name in KINDS:
        robot, recording = folder / f"{name}.robot.toml", folder / f"{name}.recording.csv"
        dc.identify(robot, recording, output=folder / f"{name}.result.json")
    dc.diagnose(folder / "torque.robot.toml", folder / "torque.recording.csv", output=folder / "torque.diagnosis.json")


def _forth_and_back() -> list[tuple[float, int]]:
    stops = [25.0 * k for k in range(21)]
    return [(q, 1) for q in stops] + [(q, -1) for q in stops[::-1]]


def _jobs_of_kinds() -> Iterator[Job]:
    for name in KINDS:
        robot, recording, result = (f"{name}.{end}" for end in ("robot.toml", "recording.csv", "result.json"))
        read = (robot, recording, f"{name}.recording.toml")
        yield Job(("identify", f"{{{robot}}}", f"{{{recording}}}", "-o", "{out.json}"), read)
        yield Job(("validate", f"{{{result}}}", f"{{{recording}}}"), (result, *read[1:]))
        yield Job(("predict", f"{{{result}}}", f"{{{recording}}}", "-o", "{out.csv}"), (result, *read[1:]))
        yield Job(("compare", f"{{{result}}}", f"{{{result}}}"), (result,))
        if name != "torque":
            bands = ("predict", f"{{{result}}}", f"{{{recording}}}", "--bands", "-o", "{out.csv}")
            yield Job(bands, (result, *read[1:]))
        if name != "axis":
            poses = f"{name}.poses.csv"
            yield Job(
                ("simulate", f"{{{robot}}}", f"{{{poses}}}", "-o", "{out.csv}"), (robot, poses, f"{name}.poses.toml")
            )
    for name in ("axis", "torque"):
        robot, recording = f"{name}.robot.toml", f"{name}.recording.csv"
        yield Job(
            ("diagnose", f"{{{robot}}}", f"{{{recording}}}", "-o", "{out.json}"),
            (robot, recording, f"{name}.recording.toml"),
        )
    torque = ("simulate", "{torque.robot.toml}", "{torque.poses.csv}", "--truth", "{torque.truth.toml}")
    yield Job((*torque, "-o", "{out.csv}"), ("torque.truth.toml", "torque.truth.toml", "torque.poses.csv"))
    study = ("study", "{torque.robot.toml}", "--plan", "{torque.poses.csv}", "--suspect", "{torque.truth.toml}")
    few = ("--noise", "0.01", "--trials", "2", "--diagnoses", "1", "--workers", "1")
    yield Job(
        (*study, *few, "-o", "{out.json}", "--report", "{out.html}"),
        ("torque.robot.toml", "torque.poses.csv", "torque.poses.toml", "torque.truth.toml"),
    )
    for command in ("predict", "validate"):
        arguments = (command, "{torque.diagnosis.json}", "{torque.recording.csv}")
        written = ("-o", "{out.csv}") if command == "predict" else ()
        yield Job((*arguments, *written), ("torque.diagnosis.json",))


# -------------------------------------------------------------------------------------------------------- every command


def _jobs_of_commands() -> Iterator[Job]:
    """Yield what is used once: next, bands, places, certificates, studies, batches."""
    robot, recording, result = "{delta.robot.toml}", "{delta.recording.csv}", "{delta.result.json}"
    other, about = "{other.csv}", "{about.toml}"
    beside = ("delta.result.json", "other.csv", "other.toml")
    yield Job(("next", "{open.diagnosis.json}", "--budget", "4", "-o", "{out.csv}"), ("open.diagnosis.json",))
    yield Job(("predict", result, other, "--place", recording, "--bands", "-o", "{out.csv}"), beside)
    yield Job(
        ("compensate", result, "{targets.csv}", "--bands", "-o", "{out.csv}"), ("delta.result.json", "targets.csv")
    )
    yield Job(
        ("certificate", result, other, "--about", about, "-o", "{out.html}"), (*beside, "about.toml", "about.toml")
    )
    yield Job(
        ("certificate", "{axis.result.json}", "{other.axis.csv}", "-o", "{out.html}"),
        ("axis.result.json", "other.axis.csv"),
    )
    study = ("study", robot, "--plan", "{delta.poses.csv}", "--model", "18", "--noise", "0.01", "--trials", "3")
    yield Job(
        (*study, "--workers", "1", "-o", "{out.json}", "--report", "{out.html}"),
        ("delta.robot.toml", "delta.poses.csv", "delta.poses.toml"),
    )
    yield Job(
        ("batch", "{shop}", "-o", "{out}", "--do", "identify", "--workers", "1"),
        ("shop/recording.csv", "shop/robot.toml"),
    )
    yield Job(("identify", robot, recording, "--as", "distance", "-o", "{out.json}"), ("delta.recording.csv",))
    yield Job(("import", "bag", "{run.mcap}", "-o", "{out}"), ("run.mcap",))
    yield Job(("import", "bag", "{run.mcap}", "--mapping", "{map.toml}", "-o", "{out}"), ("map.toml",))
    yield Job(
        ("import", "c3d", "{take.c3d}", "{capture.joints.csv}", "-o", "{out}"), ("take.c3d", "capture.joints.csv")
    )
    motive = ("import", "c3d", "{take.csv}", "{capture.joints.csv}", "--readings", "Tool", "-o", "{out}")
    yield Job(motive, ("take.csv", "take.csv", "capture.joints.csv"))


def _open(folder: Path) -> None:
    """Diagnose a soft machine on poses that do not tell its joints from its arms: poses to measure next are left."""
    dice = np.random.default_rng(4)
    rows = [(k, *dice.uniform(-150, 150, 2).round(1), round(dice.uniform(-950, -800), 1), 20 * k) for k in range(40)]
    (folder / "open.poses.csv").write_text(_table("pose,x_mm,y_mm,z_mm,time_s", rows))
    (folder / "open.truth.toml").write_text(
        '[[effects]]\nname = "joint_compliance"\nlimbs = [1, 2, 3]\ncompliance = 0.011\n'
    )
    robot, recording = folder / "delta.robot.toml", folder / "open.recording.csv"
    truth = folder / "open.truth.toml"
    dc.simulate(robot, folder / "open.poses.csv", output=recording, truth=truth, noise=0.005, seed=6)
    found = dc.diagnose(robot, recording, output=folder / "open.diagnosis.json")
    assert found.next_measurements, "nothing is open: `next` would not be tried"


def _once(folder: Path) -> None:
    """Write the files of `_jobs_of_commands`."""
    _open(folder)
    (folder / "other.csv").write_bytes((folder / "delta.recording.csv").read_bytes() + b"\n")
    (folder / "other.toml").write_bytes((folder / "delta.recording.toml").read_bytes())
    (folder / "other.axis.csv").write_bytes((folder / "axis.recording.csv").read_bytes() + b"\n")
    (folder / "about.toml").write_text(
        '[laboratory]\nname = "L"\ncountry = "DE"\n[machine]\nserial = "7"\n[calibration]\nbegin = 2026-01-16\n'
    )
    bags.mcap(folder, bags.way)
    (folder / "map.toml").write_text(
        '[joints]\nnames = ["wrist", "elbow", "shoulder"]\n'
        '[readings]\ntopic = "/tracker"\nfields = ["point.y", "point.x", "point.z"]\nunit = "mm"\n'
    )
    mocap.c3d(folder)
    mocap.motive(folder)
    rows = [(f"{t:.3f}", *q) for t, q in zip(mocap.TIMES, mocap.stairs(mocap.TIMES), strict=True)]
    (folder / "capture.joints.csv").write_text(_table("time_s,q1_deg,q2_deg,q3_deg", rows))
    (folder / "shop").mkdir()
    for name in ("robot.toml", "recording.csv"):
        (folder / "shop" / name).write_bytes((folder / f"diamond.{name}").read_bytes())


# ------------------------------------------------------------------------------------------------------------------ all


def jobs() -> Iterator[Job]:
    """Yield every command with good inputs."""
    for machine in MACHINES:
        robot, recording, poses, truth, result = (
            f"{machine}.{name}" for name in ("robot.toml", "recording.csv", "poses.csv", "truth.toml", "result.json")
        )
        beside, targets = f"{machine}.recording.toml", f"{machine}.targets.csv"
        read = (robot, recording, beside)
        yield Job(("identify", f"{{{robot}}}", f"{{{recording}}}", "-o", "{out.json}", "--report", "{out.html}"), read)
        yield Job(("validate", f"{{{result}}}", f"{{{recording}}}"), (result, recording, beside))
        yield Job(("predict", f"{{{result}}}", f"{{{recording}}}", "-o", "{out.csv}"), (result, recording, beside))
        yield Job(
            ("simulate", f"{{{robot}}}", f"{{{poses}}}", "--truth", f"{{{truth}}}", "-o", "{out.csv}"),
            (robot, poses, truth, truth, f"{machine}.poses.toml"),
        )
        yield Job(("compare", f"{{{result}}}", f"{{{result}}}", "-o", "{out.json}"), (result,))
        yield Job(("compensate", f"{{{result}}}", f"{{{targets}}}", "-o", "{out.csv}"), (result, targets))
        yield Job(("compensate", f"{{{result}}}", "--export", "c", "-o", "{out.c}"), (result,))
    yield Job(
        ("diagnose", "{gearbox.robot.toml}", "{gearbox.recording.csv}", "-o", "{out.json}", "--report", "{out.html}"),
        ("gearbox.robot.toml", "gearbox.recording.csv", "gearbox.recording.toml"),
    )
    diagnosis = "gearbox.diagnosis.json"
    for arguments in (
        ("predict", "{gearbox.diagnosis.json}", "{gearbox.recording.csv}", "-o", "{out.csv}"),
        ("compensate", "{gearbox.diagnosis.json}", "{targets.csv}", "-o", "{out.csv}"),
        ("identify", "{gearbox.robot.toml}", "{gearbox.recording.csv}", "--physics", "{gearbox.diagnosis.json}"),
    ):
        yield Job(arguments, (diagnosis, diagnosis, "gearbox.recording.csv", "targets.csv"))
    printer, robot = "linear_delta.result.json", "{delta.robot.toml}"
    for kind in ("klipper", "rrf", "marlin"):
        yield Job(("compensate", f"{{{printer}}}", "--export", kind, "-o", "{out.txt}"), (printer,))
    yield Job(
        ("matrix", robot, "{delta.recording.csv}", "--model", "18", "-o", "{out.npz}"),
        ("delta.robot.toml", "delta.recording.csv"),
    )
    yield Job(("plan", robot, "--model", "18", "-o", "{out.csv}"), ("delta.robot.toml",))
    yield Job(("import", "klipper", "{linear_delta.printer.cfg}", "-o", "{out}"), ("linear_delta.printer.cfg",))
    yield Job(("import", "rrf", "{config.g}", "{heightmap.csv}", "-o", "{out}"), ("config.g", "heightmap.csv"))
    yield Job(("import", "marlin", "{marlin.txt}", "-o", "{out}"), ("marlin.txt",))
    yield Job(("import", "urdf", "{serial.arm.urdf}", "-o", "{out}"), ("serial.arm.urdf",))
    yield from _jobs_of_kinds()
    yield from _jobs_of_commands()
    yield Job(("import", "points", "{points.txt}", "{joints.csv}", robot, "-o", "{out}"), ("points.txt", "joints.csv"))

"""Tables 2 to 5 and figure 8 of Bai 2015 on a simulated prototype.

The machine has the errors of Table 4 and the encoder offsets of section 5.1; the tracker has 0.005 mm of noise. Rough
calibration uses home and five poses of the middle layer; fine calibration home and n poses on the top and bottom
layers: n = 7 and one reference point for model 18, n = 9 and two points for model 32; all from distances of all pairs.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Iterator, Mapping
from functools import partial
from typing import Any

import numpy as np

from deltacal_gen.estimation.fit import fit
from deltacal_gen.estimation.problem import pose_problem
from deltacal_gen.estimation.solvers import LeastSquares
from deltacal_gen.files.robot import Robot, read_robot
from deltacal_gen.identification.accuracy import (
    check_poses,
    circle,
    distance_error,
    largest,
    volumetric_error,
    workspace_of,
)
from deltacal_gen.identification.identifiability import identification_matrix
from deltacal_gen.machine.registry import Array, load_mechanism
from deltacal_gen.machine.values import POSITION, Measurement, Recording
from deltacal_gen.physics.simulation import read_truth, simulate
from deltacal_gen.planning.rows import blank_recording
from deltacal_gen.use.compensation import Compensator
from derive.review.reproduction.sheet import Part, Picture, Sheet
from derive.review.sources import EXAMPLES

SIGMA = 0.005  # mm, per coordinate; each pose is read three times and averaged
DELTA = load_mechanism("delta")
TABLE_2 = {  # mm
    "before, distance": (-3.405, -3.859, -2.863, -4.181, -2.663),
    "before, volumetric": (3.769, 3.888, 3.163, 4.962, 2.975),
    "after, distance": (0.025, -0.061, 0.008, 0.187, -0.011),
    "after, volumetric": (0.309, 1.015, 0.961, 0.859, 1.047),
}
OFFSETS = (0.911, 1.098, 1.441)  # deg, section 5.1
TABLE_3 = {  # model 18, mm
    "ex": (None, -0.201, 0.146),
    "ey": (0.114, None, None),
    "theta": (0.965, -0.034, -0.578),
    "L": (0.112, 0.101, 0.098),
    "alpha0": (-0.841, -0.546, 0.759),
    "beta0": (0.421, -0.764, 0.432),
    "l": (0.107, 0.157, 0.302),
}
TABLE_4 = {  # model 32, mm
    "ex": (None, -0.187, 0.174),
    "ey": (0.160, None, None),
    "theta": (1.107, -0.112, -0.941),
    "L": (0.919, 0.110, 0.122),
    "alpha0": (-0.707, -0.901, 0.872),
    "beta0": (0.636, -0.524, 0.497),
    "l": (0.114, 0.125, 0.193),
    "dl": (0.048, 0.052, 0.039),
    "dc": (-0.021, 0.014, -0.009),
    "alpha03": (-0.175, None, None),
    "beta03": (0.267, -0.242, None),
    "alpha2": (0.057, -0.017, None),
    "beta2": (-0.032, -0.047, 0.061),
}
TABLE_5 = {"A": (5.704, 6.361), "B": (0.682, 1.303), "C18": (0.167, 0.386), "C32": (0.134, 0.371)}  # mm


def measured(
    robot: Robot, truth: dict[str, float], targets: Array, tools: Array, rng: np.random.Generator
) -> Recording:
    """Return what the tracker reads of every target with every reference point."""
    at, tool = np.tile(targets, (len(tools), 1)), np.repeat(tools, len(targets), axis=0)
    joints, _, _ = DELTA.inverse(at, robot.tool, DELTA.rows(robot))
    said = Measurement(frame="unknown")
    poses = blank_recording(robot, "position", joints, POSITION, said, "bai2015.csv", tool=tool)
    return simulate(robot, poses, truth, noise_mm=SIGMA / np.sqrt(3), rng=rng)


def identified(robot: Robot, recording: Recording, model: str) -> Robot:
    """Return the robot with a model's parameters identified from the distances of all pairs."""
    problem = pose_problem(robot, recording, DELTA.model(model), as_distance=True)
    errors = fit(problem, LeastSquares(), weigh_repeats=False, robust=False).errors
    return dataclasses.replace(robot, errors=dict(zip(DELTA.index, errors.tolist(), strict=True)))


def errors_of(command: Robot, kind: str, truth: dict[str, float], targets: Array) -> tuple[Array, Array]:
    """Return distance and volumetric error relative to the first target; the frame is the robot's own, known here."""
    true = dataclasses.replace(command, errors=truth)
    joints = Compensator(command, kind).joints(targets)
    reached = DELTA.forward(joints, command.tool, DELTA.rows(true))[0][:, :3]
    return distance_error(reached, targets), volumetric_error(reached, targets, turn=np.eye(3))


@dataclasses.dataclass(frozen=True)
class Calibrated:
    """The nominal machine, the true errors, and the machine after rough and fine calibration; home and check poses."""

    nominal: Robot
    truth: dict[str, float]
    rough: Robot
    fine: dict[str, Robot]
    home: Array

    @staticmethod
    def simulated(rng: np.random.Generator) -> Calibrated:
        """Measure and identify as sections 5.1 and 5.2 do."""
        nominal = read_robot(EXAMPLES / "delta" / "robot.toml")
        truth = read_truth(EXAMPLES / "delta" / "truth.toml", nominal).errors
        space = workspace_of(nominal)
        home, points = check_poses(space)[:1], np.array([[0.0, 0.0, 0.0], [0.0, 0.0, -100.0]])

        def rings(n: int) -> Array:
            return np.vstack([home, circle(space, 0.0, 1.0, n), circle(space, 1.0, 1.0, n)])

        middle = np.vstack([home, circle(space, 0.5, 1.0, 5)])
        rough = identified(nominal, measured(nominal, truth, middle, points[:1], rng), "3")
        fine = {
            "18": identified(rough, measured(nominal, truth, rings(7), points[:1], rng), "18"),
            "32": identified(rough, measured(nominal, truth, rings(9), points, rng), "32"),
        }
        return Calibrated(nominal, truth, rough, fine, home)

    def middle(self, n: int) -> Array:
        """Return home and `n` poses on the rim of the middle layer."""
        return np.vstack([self.home, circle(workspace_of(self.nominal), 0.5, 1.0, n)])


def study(tell: Callable[[str], None]) -> Iterator[Part]:
    """Yield the paper's tables and figure 8, remade."""
    tell("rough and fine calibration of a simulated prototype")
    made = Calibrated.simulated(np.random.default_rng(2015))
    yield table_1(made.nominal)
    yield table_2(made)
    for number, model, printed in (("Table 3", "18", TABLE_3), ("Table 4", "32", TABLE_4)):
        yield source_errors(made, number, model, printed)
    tell("errors over the workspace")
    yield table_5(made)
    tell("condition numbers against the number of poses")
    for number, cases in (("Fig. 6", ROUGH), ("Fig. 7", FINE)):
        yield Picture(number, CONDITIONS, partial(_conditions, made, cases), (1, len(cases)))
    yield Picture("Fig. 8", "Errors on the rim of the middle layer", partial(_figure_8, made), (1, 2))


def table_1(robot: Robot) -> Sheet:
    """Return the nominal parameters, which are all that is taken over."""
    sheet = Sheet("Table 1", "Taken over as printed", ("parameter", "nominal"))
    for key in ("base_radius", "platform_radius", "proximal_length", "distal_length", "joint_spacing"):
        sheet.add(f"{key.replace('_', ' ')}, mm", f"{robot.geometry[key][0]:g}")
    return sheet


CONDITIONS = "Condition number against n, start angle 75 deg, in both norms: the paper names neither"
Case = tuple[str, str, tuple[float, ...], int]  # words, model, layers of the workspace, reference points
ROUGH: tuple[Case, ...] = (("encoder offsets", "3", (0.5,), 1),)
FINE: tuple[Case, ...] = (("model 18", "18", (0.0, 1.0), 1), ("model 32", "32", (0.0, 1.0), 2))
START = np.radians(75.0)


def condition(made: Calibrated, case: Case, n: int) -> tuple[float, float]:
    """Return the spectral and the Frobenius condition number of H with n poses on each layer, and home."""
    _, model, layers, points = case
    turn = np.array([[np.cos(START), -np.sin(START), 0], [np.sin(START), np.cos(START), 0], [0, 0, 1.0]])
    rings = [circle(workspace_of(made.nominal), layer, 1.0, n) @ turn.T for layer in layers]
    tools = np.array([[0.0, 0.0, 0.0], [0.0, 0.0, -100.0]])[:points]
    exact = measured(made.nominal, {}, np.vstack([made.home, *rings]), tools, np.random.default_rng(0))
    problem = pose_problem(made.nominal, exact, DELTA.model(model), as_distance=True)
    s = np.linalg.svd(identification_matrix(problem, "paper").H, compute_uv=False)
    return float(s[0] / s[-1]), float(np.sqrt(np.sum(s**2) * np.sum(s**-2.0)))


def _conditions(made: Calibrated, cases: tuple[Case, ...], axes: Any) -> None:
    """Draw condition numbers; numbers of poses that do not see all are left out."""
    for a, case in zip(np.atleast_1d(axes), cases, strict=True):
        least = 3 if case[1] == "3" else 4  # of two layers 7 poses see 15 of 18
        counts = list(range(least, 15))
        both = np.array([condition(made, case, n) for n in counts])
        for values, norm in zip(both.T, ("spectral", "Frobenius"), strict=True):
            a.plot(counts, values, "o-", ms=3, label=norm)
        a.set(xlabel="n", ylabel="condition number", title=case[0])
        a.legend(frameon=False)


def table_2(made: Calibrated) -> Sheet:
    """Return the errors relative to home before and after the offsets are taken off, and the offsets."""
    points = [f"P{k}" for k in range(1, 6)]
    heads = ("errors relative to home, mm", *points, *(f"paper: {p}" for p in points))
    sheet = Sheet("Table 2", "Simulated with the errors of Table 4 and the offsets of section 5.1", heads)
    for name, machine in (("before", made.nominal), ("after", made.rough)):
        found = errors_of(machine, "exact", made.truth, made.middle(5))
        for kind, errors in zip(("distance", "volumetric"), found, strict=True):
            what = f"{name}, {kind}"
            sheet.add(what, *(f"{e:.3f}" for e in errors[1:]), *(f"{e:.3f}" for e in TABLE_2[what]))
    offsets = np.degrees([made.rough.errors[f"theta_{i}"] for i in (1, 2, 3)])
    sheet.add("encoder offsets, deg", *(f"{v:.3f}" for v in offsets), "", "", *OFFSETS, "", "")
    return sheet


def source_errors(made: Calibrated, number: str, model: str, printed: Mapping[str, tuple[float | None, ...]]) -> Sheet:
    """Return the errors that a model identifies beyond the offsets of section 5.1, in mm."""
    limbs = (1, 2, 3)
    heads = ("error, mm", *(f"limb {i}" for i in limbs), *(f"paper: limb {i}" for i in limbs))
    title = f"Model {model}, identified from the simulated prototype, whose errors are those of Table 4"
    sheet = Sheet(number, title, heads)
    names = [f"{error}_{i}" for error in printed for i in limbs]
    scale = dict(zip(names, DELTA.scaling("table", made.nominal, names), strict=True))
    for error, values in printed.items():
        cells = []
        for i, value in zip(limbs, values, strict=True):
            name = f"{error}_{i}"
            offset = np.radians(OFFSETS[i - 1]) if error == "theta" else 0.0
            size = (made.fine[model].errors.get(name, 0.0) - offset) * scale[name]
            cells.append("" if value is None else f"{size:.3f}")
        sheet.add(error, *cells, *("" if v is None else f"{v:.3f}" for v in values))
    return sheet


def table_5(made: Calibrated) -> Sheet:
    """Return the largest errors over the workspace, machines commanded by each calibration."""
    heads = (
        "machine commanded by",
        "compensator",
        "distance, mm",
        "volumetric, mm",
        "paper: distance",
        "paper: volumetric",
    )
    sheet = Sheet("Table 5", "Largest errors over the 96 check poses", heads)
    cases = [("A", "nominal", made.nominal, "exact"), ("B", "encoder offsets", made.rough, "exact")]
    cases += [(f"C{m}", f"model {m}", made.fine[m], kind) for m in ("18", "32") for kind in ("linear", "exact")]
    check = check_poses(workspace_of(made.nominal))
    for column, name, machine, kind in cases:
        rho, v = errors_of(machine, kind, made.truth, check)
        sheet.add(f"{column}: {name}", kind, f"{largest(rho):.3f}", f"{largest(v):.3f}", *TABLE_5[column])
    return sheet


def _figure_8(made: Calibrated, axes: Any) -> None:
    """Draw errors on the rim of the middle layer against the swing angle."""
    machines = (("before fine calibration", made.rough, "exact"), ("model 18", made.fine["18"], "linear"))
    for name, machine, kind in (*machines, ("model 32", made.fine["32"], "linear")):
        found = errors_of(machine, kind, made.truth, made.middle(72))
        for a, errors in zip(axes, found, strict=True):
            a.plot(np.arange(0, 360, 5), errors[1:], label=name)
    for a, what in zip(axes, ("distance", "volumetric"), strict=True):
        a.set(xlabel="swing angle, deg", ylabel=f"{what} error, mm")
    axes[0].legend(frameon=False)

"""Confined first sessions, whose misfit several effects explain: of a Delta, a linear delta, an arm of six joints.

Poses are in a part of the workspace, or a temperature rises with time; the machine is the same wherever it stands.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np

from deltacal_gen.files.robot import Robot, robot_from_dict
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.machine.values import Measurement, Recording
from deltacal_gen.physics.simulation import simulate
from deltacal_gen.physics.terms import Term, blank, row_coefficients
from deltacal_gen.units import joint_factors, joint_names
from tests.benchmarks.concealed_machines import ordinary_errors
from tests.support.every_effect import ARM, PRINTER, chain
from tests.support.left_out import FRAME, channels, machine
from tests.support.prototype import scattered

Array = np.ndarray
POSES, LIMB = 60, (2,)
SIGMA = 0.01  # mm
SMALL = 1e-5  # of a coefficient's unit in files: by which it is seen how far an effect moves what is read
NARROW = 0.35  # rad: how far an arm's joints move either way of where they are, in its first session
STANDS = np.array([0.3, -0.7, 0.9, 0.2, 0.8, -0.4])  # rad: and where that is
MACHINES: dict[str, Robot] = {
    "delta": machine(),
    "linear_delta": robot_from_dict(PRINTER),
    "serial": chain(ARM),
}
CONFINED = {  # where the first session is: where rods hang straight, and near the middle of the bed
    "delta": machine(workspace={"radius": 250.0, "height": 400.0}),
    "linear_delta": robot_from_dict(PRINTER | {"workspace": {"top": 150.0, "radius": 35.0, "height": 50.0}}),
}
SORTS: dict[str, tuple[str, str, float, tuple[str, ...]]] = {  # machine, effect, up to how far it moves [mm], channels
    "joint_compliance": ("delta", "joint_compliance", 0.8, ("payload",)),
    "proximal_bending": ("delta", "proximal_bending", 0.8, ("payload",)),
    "payload_deflection": ("delta", "payload_deflection", 0.2, ("payload",)),
    "distal_compliance": ("delta", "distal_compliance", 0.22, ()),
    "thermal_zero": ("delta", "thermal_zero", 0.1, ("time", "temp")),
    "zero_drift": ("delta", "zero_drift", 0.3, ("time", "temp")),
    "zero_jump": ("delta", "zero_jump", 0.1, ("time", "temp")),
    "tool_slip": ("delta", "tool_slip", 0.04, ("time",)),
    "friction_windup": ("delta", "friction_windup", 0.02, ("approach",)),
    "backlash": ("delta", "backlash", 0.012, ("approach", "payload")),
    "a printer's thermal_zero": ("linear_delta", "thermal_zero", 0.1, ("time", "temp")),
    "a printer's zero_drift": ("linear_delta", "zero_drift", 0.15, ("time", "temp")),
    "a printer's zero_jump": ("linear_delta", "zero_jump", 0.06, ("time", "temp")),
    "an arm's thermal_zero": ("serial", "thermal_zero", 0.1, ("time", "temp")),
    "an arm's joint_compliance": ("serial", "joint_compliance", 0.15, ("payload",)),
    "an arm's backlash": ("serial", "backlash", 0.025, ("approach", "payload")),
    "an arm's friction_windup": ("serial", "friction_windup", 0.06, ("approach",)),
}


@dataclasses.dataclass(frozen=True)
class Start:
    """A first session of a machine, what is truly there, and how the same machine is read elsewhere."""

    robot: Robot
    term: Term
    errors: dict[str, float]
    first: Recording
    k: int

    def extended(self, rows: Sequence[Mapping[str, float | str]]) -> Recording:
        """Return the first session and further rows, as a user appends them."""
        names = joint_names(self.first.joint_unit, self.first.joints.shape[1])
        factors = np.array(joint_factors(self.first.joint_unit, len(names)))
        more = np.array([[float(row[name]) for name in names] for row in rows]) * factors
        of = {
            name: np.concatenate([values, [float(row.get(name, values[-1])) for row in rows]])
            for name, values in self.first.channels.items()
        }
        joints = np.vstack([self.first.joints, more])
        return _read(self.robot, joints, of, self.errors, [self.term], self.k)


def start(sort: str, k: int) -> Start:
    """Return the k-th first session of a sort; every other one says how large noise is."""
    name, effect, much, recorded = SORTS[sort]
    robot = MACHINES[name]
    rng = np.random.default_rng([k, len(name), 31])
    errors, joints = ordinary_errors(robot, rng), _joints(name, k, rng)
    of = channels(POSES, *recorded, seed=k)
    if "approach" in recorded:
        of |= {f"approach{i}": rng.choice([-1.0, 1.0], POSES) for i in range(1, joints.shape[1] + 1)}
    term = _sized(robot, joints, of, errors, effect, much, k)
    return Start(robot, term, errors, _read(robot, joints, of, errors, [term], k), k)


def _joints(name: str, k: int, rng: np.random.Generator) -> Array:
    if name == "serial":
        return STANDS + NARROW * rng.uniform(-1, 1, (POSES, len(STANDS)))
    confined = CONFINED[name]
    mechanism = mechanism_of(confined)
    points = scattered(confined, POSES, k)
    if name == "linear_delta":  # z upwards, from the bed
        assert confined.workspace is not None
        space = confined.workspace
        points = space.place(points[:, :2], rng.random(POSES))
    theta, _, status = mechanism.inverse(points, np.zeros((POSES, 3)), mechanism.rows(confined))
    assert not status.any()
    return confined.joint_sign * theta


def _read(
    robot: Robot,
    joints: Array,
    of: Mapping[str, Array],
    errors: dict[str, float],
    terms: Sequence[Term],
    k: int,
    sigma: float = SIGMA,
) -> Recording:
    mechanism, n = mechanism_of(robot), len(joints)
    axes = tuple(f"{axis}_mm" for axis in mechanism.axes)
    asked = Recording(
        path=Path("recording.csv"),
        kind="position",
        measurement=Measurement(kind="position", frame="unknown", sigma_mm=SIGMA if k % 2 else None),
        joint_unit=mechanism.joint_unit,
        joints=joints,
        columns=axes,
        measured=np.full((n, len(axes)), np.nan),
        pose=np.arange(1, n + 1).astype(str),
        line=np.arange(2, n + 2),
        channels=dict(of),
        setup=np.zeros(n, dtype=int),
        setup_names=("",),
    )
    rng = np.random.default_rng([k, 7])
    done = simulate(robot, asked, errors, noise_mm=sigma, rng=rng, terms=terms, frame=FRAME)
    kept = {name: v for name, v in done.channels.items() if not name.startswith("true_")}
    return dataclasses.replace(done, channels=kept, measurement=asked.measurement)


def _sized(
    robot: Robot, joints: Array, of: dict[str, Array], errors: dict[str, float], effect: str, much: float, k: int
) -> Term:
    """Return an effect that moves what is read by so much [mm] at most, each coefficient alike."""
    constants: tuple[float, ...] = ()
    one = blank(effect, () if effect == "tool_slip" else LIMB, (0.0,) if _at_a_moment(effect) else ())
    if _at_a_moment(effect):
        constants = (float(of["time_s"][20 + k % 20]) - 1.0,)
    one = dataclasses.replace(one, constants=constants)

    def read(values: Array) -> Array:
        return _read(robot, joints, of, errors, [one.with_values(values)], k, 0.0).measured

    names = row_coefficients(one, mechanism_of(robot).joint_unit)
    small = SMALL * np.array([factor for row in names for *_, factor in row])
    nothing = read(np.zeros(len(small)))
    moved = [np.abs(read(unit) - nothing).max() for unit in np.diag(small)]
    return one.with_values(much * small / moved)


def _at_a_moment(effect: str) -> bool:
    return effect in ("zero_jump", "tool_slip")

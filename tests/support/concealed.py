"""Recordings of machines with an effect that is concealed in them."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from deltacal_gen.files.robot import Robot
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.machine.values import Measurement, Recording
from deltacal_gen.physics import terms as of
from deltacal_gen.physics.parts import lacks
from deltacal_gen.physics.simulation import simulate
from deltacal_gen.physics.terms import Term, row_factors
from tests.support.every_effect import joints as stand
from tests.support.left_out import FRAME

N, SIGMA = 150, 0.01  # poses, mm


def channels(robot: Robot, n: int, seed: int) -> dict[str, np.ndarray]:
    """Return what a shop records beside readings: time, a hall that warms, payloads, directions."""
    rng, joints = np.random.default_rng([seed, 3]), mechanism_of(robot).limbs
    t = np.round(np.cumsum(rng.uniform(15, 40, n)), 2)
    most = 8.0 if robot.links else 30.0  # a hall; what is enclosed
    warm = np.round(20 + most * (1 - np.exp(-2 * t / t[-1])) + 0.1 * most * rng.standard_normal(n), 2)
    out = {"time_s": t, "temp_C": warm, "payload_kg": rng.choice([0.0, 2.0, 4.0], n)}
    out |= {"level_mrad": np.round(rng.standard_normal(n), 3), "humidity_pct": np.round(45 + rng.normal(0, 3, n), 1)}
    return out | {f"approach{i}": rng.choice([-1.0, 1.0], n) for i in range(1, joints + 1)}


def record(
    robot: Robot,
    term: Term | None,
    seed: int = 1,
    kind: str = "pose",
    beside: tuple[Term, ...] = (),
    **more: np.ndarray,
) -> Recording:
    """Return readings of a machine with plausible errors and effects, in an instrument's unknown frame."""
    rng, m = np.random.default_rng([seed, 9]), mechanism_of(robot)
    joints, targets = np.full((N, m.limbs), np.nan), None
    if robot.links:
        joints = stand(robot, N, seed)
    else:
        space = robot.workspace
        assert space is not None
        assert space.radius is not None
        turn, r = 2 * np.pi * rng.random(N), space.radius * np.sqrt(rng.random(N))
        targets = space.place(np.column_stack([r * np.cos(turn), r * np.sin(turn)]), rng.random(N))
    poses = Recording(
        path=Path("recording.csv"),
        kind=kind,
        measurement=Measurement(kind=kind, frame="unknown"),
        joint_unit=m.joint_unit,
        joints=joints,
        columns=("x_mm", "y_mm", "z_mm") + (("rx_deg", "ry_deg", "rz_deg") if kind == "pose" else ()),
        measured=np.zeros((N, 0)),
        pose=np.arange(1, N + 1).astype(str),
        line=np.arange(N) + 2,
        channels=channels(robot, N, seed) | more,
        setup=np.zeros(N, dtype=int),
        setup_names=("1",),
        targets=targets,
    )
    known = m.model(m.full_model)
    errors = {p.name: 0.3 * p.typical * float(rng.standard_normal()) for p in m.parameters if p.name in known}
    how: dict[str, Any] = {"noise_rad": 2e-5} if kind == "pose" else {}
    done = simulate(
        robot, poses, errors, noise_mm=SIGMA, rng=rng, terms=[*([term] if term else []), *beside], frame=FRAME, **how
    )
    measurement = dataclasses.replace(done.measurement, sigma_mm=SIGMA, sigma_deg=float(np.degrees(2e-5)))
    kept = {name: v for name, v in done.channels.items() if not name.startswith("true_")}
    return dataclasses.replace(done, measurement=measurement, channels=kept)


@dataclass(frozen=True)
class Case:
    """An effect on a machine; `values` in the units of files, one for all limbs, and what searched constants are."""

    machine: str
    effect: str
    limbs: tuple[int, ...]
    values: Mapping[str, float]
    constants: Mapping[str, float | str] = field(default_factory=dict)
    alike: tuple[str, ...] = ()  # what these readings may not tell from it

    def term(self, robot: Robot) -> Term:
        m = mechanism_of(robot)
        blank = of.blank(self.effect, self.limbs, (), (), lacks(self.effect, m, m.moves(robot), m.roles(robot)))
        given = [self.values[name] for name, *_ in blank.kernels.COEFFICIENTS]
        factors = of.constants_of(blank, m.joint_unit)
        constants = tuple(of.scaled(self.constants[name], factor) for name, _, factor in factors)
        values = np.array(given) * row_factors(blank, m.joint_unit)
        return dataclasses.replace(blank, values=values, constants=constants)

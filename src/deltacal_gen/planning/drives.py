"""What a trajectory will tell of the drives, before anything moves: Monte Carlo over bodies, noise and suspicions.

A machine of a study has bodies that differ from those of the robot file by a part of their mass, somewhere about them:
a cover, a cable, what a drawing leaves out. What its drives give
along the trajectory is read with noise, its bodies are identified as `diagnose` does, beside the dry and the viscous
friction that every drive may have, and what that predicts is judged on other movements within the same limits. The
estimate is linear in what is found: how large friction is changes nothing of its errors. Suspected effects are
concealed in recordings of such machines, which the diagnosis then sees as any other recording.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any, ClassVar

import numpy as np

from deltacal_gen.errors import InputError
from deltacal_gen.execution import Told, content_key
from deltacal_gen.files.robot import kept_robot, robot_to_dict
from deltacal_gen.machine.backend import Backend, using
from deltacal_gen.machine.registry import Array
from deltacal_gen.machine.values import Robot
from deltacal_gen.motion.fit import fitted
from deltacal_gen.motion.identification import RIGID, base_parameters
from deltacal_gen.motion.joint import Joint
from deltacal_gen.motion.ladder import BEGUN_WITH
from deltacal_gen.motion.lag import LATENCY
from deltacal_gen.motion.library import Rung, of_joint
from deltacal_gen.motion.payload import PAYLOAD
from deltacal_gen.motion.session import Session
from deltacal_gen.motion.simulation import Truth, lacking, simulated
from deltacal_gen.motion.trajectories import Trajectories
from deltacal_gen.planning.advice import told_of
from deltacal_gen.planning.exciting import Excitation
from deltacal_gen.planning.machines import Trial
from deltacal_gen.planning.monte_carlo import drawn
from deltacal_gen.results.base import Value
from deltacal_gen.results.parts import EffectName, Missing
from deltacal_gen.results.reader import TORQUE
from deltacal_gen.results.trajectories import MotionStudy, ToldParameter, TorqueAddition, TorqueSpread
from deltacal_gen.states import named

BODIES, ABOUT = 0.1, 100.0  # by so much of its mass a body differs, so far from its frame [mm]: standard deviations
DRAWN = 2000  # machines by which the spread of base parameters is told
FRICTION = tuple(Rung(name) for name in BEGUN_WITH)  # what is found beside the bodies
OTHERS = 3  # movements at random on which predictions are judged
PERIOD, HARMONICS = 10.0, 5  # of these, and of the run that is advised [s, 1]: what `plan` takes
UNSEEN = 1e-10  # of the largest eigenvalue of the information, columns of one size: what readings do not see
SURE = 1e-6  # of a unit: so much of it may lie where readings do not see


@dataclass(frozen=True)
class DriveStudy:
    """A robot, a trajectory, and what is unknown of bodies and drives.

    Attributes
    ----------
    robot : Robot
        The machine as drawn, with its bodies.
    given : Trajectories
        Its readings are not looked at.
    sigma : tuple of float
        Noise of a reading of each joint, in the unit of the recording.
    suspects : tuple of Truth
        Each what the drives of one machine have beside.
    seed : int
    """

    robot: Robot
    given: Trajectories
    sigma: tuple[float, ...]
    suspects: tuple[Truth, ...] = ()
    seed: int = 0
    chunk: ClassVar[int] = 50

    def __getstate__(self) -> dict[str, Any]:
        """Return the fields alone: a worker works out the rest itself."""
        return {f.name: getattr(self, f.name) for f in dataclasses.fields(self)}

    def __setstate__(self, state: Mapping[str, Any]) -> None:
        self.__dict__.update(state)

    @cached_property
    def session(self) -> Session:
        """The recording of the machine as drawn, without noise."""
        if not all(read.forces for read in self.given.readouts):
            raise InputError(
                "what a drive gives per ampere is not said: torques of a study are in Nm or N.",
                "Give torque_constant_Nm_A in [transmission] of the robot file, or columns tau1_Nm ...",
                file=self.given.path,
            )
        return Session.of(self.robot, simulated(self.robot, self.given, Truth(), 0.0, np.random.default_rng(0)))

    @cached_property
    def joints(self) -> list[Joint]:
        """The joints of which there are samples enough."""
        return self.session.moving

    @cached_property
    def excitation(self) -> Excitation:
        """Movements of the robot within its limits."""
        return Excitation(self.robot, PERIOD, HARMONICS, self.seed)

    @cached_property
    def check(self) -> list[Array]:
        """What own base parameters and friction ask of each moving joint (C, r + 2), on movements at random."""
        states = np.concatenate([self.excitation.at_random() for _ in range(OTHERS)], axis=1)
        return self.asked(states)

    @cached_property
    def noise(self) -> list[float]:
        """Noise of a reading of each moving joint, in units inside."""
        return [self.sigma[j.number - 1] * j.readout.inside for j in self.joints]

    def prepare(self) -> None:
        """Work out what all machines share."""
        self.check, self.noise  # noqa: B018  # each is worked out where it is first asked for

    def fingerprint(self) -> str:
        """Return a hash of all that the study's results depend on."""
        given, plain = self.given, [dataclasses.asdict(truth) for truth in self.suspects]
        arrays = (given.joints, given.time, given.run, given.recorded, *given.channels.values())
        return content_key(
            MotionStudy.schema,
            given.kind,
            robot_to_dict(self.robot),
            given.said.model_dump(),
            [list(given.units), list(given.channels), list(given.setups), given.constants],
            [np.asarray(a).tolist() for a in arrays],
            [self.sigma, self.seed],
            [{k: _plain(v) for k, v in truth.items()} for truth in plain],
        )

    def asked(self, states: Array) -> list[Array]:
        """Return what own base parameters and friction ask of each moving joint (N, r + 2) at states (3, N, n_q)."""
        columns = self.session.rigid.columns(states)
        found = []
        for joint in self.joints:
            qd = states[1, :, joint.number - 1]
            found.append(np.hstack([columns[joint.number - 1], *(r.columns({"qd": qd}) for r in FRICTION)]))
        return found

    def bodies(self, rng: np.random.Generator) -> Array:
        """Return by how much the inertial parameters (n,) of a machine differ from the robot file's."""
        dynamics = self.session.rigid.dynamics
        stated = np.nan_to_num(dynamics.stated(points=True))
        if not dynamics.bodies:
            return np.asarray(BODIES * rng.standard_normal(len(stated)) * stated)
        of_bodies, rotors = np.split(stated, [len(stated) - len(dynamics.rotors)])
        masses = of_bodies.reshape(dynamics.bodies, -1)[:, 0]
        points = dynamics.of_points(ABOUT * rng.standard_normal((dynamics.bodies, 3)))
        off = (BODIES * masses * rng.standard_normal(dynamics.bodies))[:, None] * points
        return np.append(off, BODIES * rng.standard_normal(len(rotors)) * rotors)

    def machines(self, index: int, count: int) -> Drives:
        """Draw, read and identify machines."""
        rng, rigid, inside = np.random.default_rng([self.seed, 0, index]), self.session.rigid, self._inside
        off, stated, before, after = list[Array](), list[list[float]](), list[list[float]](), list[list[float]]()
        for _ in range(count):
            inertia = self.bodies(rng)
            fits, errors = [], []
            for joint, noise, check, unit in zip(self.joints, self.noise, self.check, inside, strict=True):
                own = rigid.own[joint.number - 1].made_up @ inertia
                series = joint.series
                y = series.y + series.X @ own + noise * rng.standard_normal(len(series.y))
                fits.append(fitted(dataclasses.replace(series, y=y, memories={}).at(), FRICTION))
                wrong = fits[-1].coefficients - np.append(self._stated[joint.number] + own, np.zeros(len(FRICTION)))
                errors.append((_rms(check[:, : len(own)] @ own) / unit, _rms(check @ wrong) / unit))
            found = base_parameters(rigid, fits)
            off.append(np.array([p.value for p in found]) - rigid.common.made_up @ inertia)
            stated.append([p.std or 0.0 for p in found])
            before.append([b for b, _ in errors])
            after.append([a for _, a in errors])
        return Drives(
            count=count,
            sum=np.sum(off, axis=0).tolist(),
            squares=np.sum(np.square(off), axis=0).tolist(),
            stated=np.sum(np.square(stated), axis=0).tolist(),
            before=before,
            after=after,
        )

    def concealed(self, suspect: int, trial: int) -> Trial:
        """Conceal a suspect in a recording of a machine and diagnose it; suspect -1 conceals nothing."""
        from deltacal_gen.motion.diagnosis import diagnose

        rng = np.random.default_rng([self.seed, 1 + suspect + 1, trial])
        truth = Truth() if suspect < 0 else self.suspects[suspect]
        own = dict(zip(self.session.rigid.names, self.bodies(rng).tolist(), strict=True))
        together = {name: own[name] + truth.parameters.get(name, 0.0) for name in own}
        told = dataclasses.replace(truth, parameters=together)
        found = diagnose(self.robot, simulated(self.robot, self.given, told, np.array(self.sigma), rng), _silent)
        named = _merged((e.name, e.limbs) for e in found.effects)
        wanted = _merged((e.name, e.limbs) for e in effects_of(truth))
        return Trial.of(found, named, wanted)

    @cached_property
    def _stated(self) -> dict[int, Array]:
        """Own base parameters of the machine as drawn, by the number of the joint."""
        rigid = self.session.rigid
        return {joint.number: rigid.stated_base(rigid.own[joint.number - 1]) for joint in self.joints}

    @property
    def _inside(self) -> list[float]:
        return [joint.readout.inside for joint in self.joints]


class Drives(Value):
    """Machines that were drawn, read and identified.

    `sum` and `squares` are of estimate minus truth by base parameter, `stated` the sum of the variances that
    identifications state; `before` and `after` hold of each machine the rms of what is predicted wrong, joint by joint.
    """

    count: int
    sum: list[float]
    squares: list[float]
    stated: list[float]
    before: list[list[float]]
    after: list[list[float]]


def effects_of(truth: Truth) -> tuple[EffectName, ...]:
    """Return the names under which a diagnosis would tell what a truth has."""
    found: list[tuple[str, tuple[int, ...]]] = [(rung.effect, (joint,)) for joint, rung, _ in truth.effects]
    found += [(LATENCY, (joint,)) for joint, delay in truth.delays.items() if delay]
    found += [(PAYLOAD, ()) for _ in truth.payloads]
    return tuple(EffectName(name=name, limbs=limbs) for name, limbs in _merged(found))


def conduct(
    study: DriveStudy,
    trials: int = 1000,
    diagnoses: int = 10,
    *,
    workers: int | None = None,
    cluster: str | None = None,
    directory: str | Path | None = None,
    told: Told = lambda done, total, label: None,
) -> MotionStudy:
    """Conduct a study of a trajectory; see `execution.run` for workers, cluster and directory.

    Raises
    ------
    InputError
        A body has no mass, no joint moves for long enough, a drive's torque per ampere is not known.
    NoSolutionError
        No other movement stays in the workspace.
    """
    with using(Backend.COMPILED):
        study.prepare()
        done, hidden, add = drawn(
            study,
            trials,
            diagnoses,
            lambda: _additions(study),
            workers=workers,
            cluster=cluster,
            directory=directory,
            told=told,
        )
    parts = [Drives(**d) for d in done]
    session, given = study.session, study.given
    names = [effects_of(truth) for truth in study.suspects]
    return MotionStudy(
        model=f"{study.robot.mechanism}/{RIGID}",
        robot=kept_robot(study.robot),
        kind=TORQUE,
        readings=sum(len(joint.y) for joint in study.joints),
        runs=len(given.run_names),
        sigma_by_joint=study.sigma,
        unit_by_joint=given.units,
        machines=sum(part.count for part in parts),
        seed=study.seed,
        parameters=_parameters(study, parts),
        torque=_torque(study, parts),
        unidentifiable=tuple(session.rigid.unseen(session.rigid.common)),
        suspects=told_of(names, hidden, diagnoses),
        channels_wanted=_wanted(study),
        add=add,
        notes=tuple(study.excitation.notes),
    )


def _parameters(study: DriveStudy, parts: list[Drives]) -> tuple[ToldParameter, ...]:
    """Return how well each base parameter is found."""
    rigid, count = study.session.rigid, sum(part.count for part in parts)
    mean, square, stated = (
        np.sum([getattr(part, key) for part in parts], axis=0) / count for key in ("sum", "squares", "stated")
    )
    rng = np.random.default_rng([study.seed, 0])
    drawn_std = np.std([rigid.common.made_up @ study.bodies(rng) for _ in range(DRAWN)], axis=0)
    covariance, hidden = _covariance(_common(study))
    found = []
    for k, (name, text) in enumerate(rigid.words(rigid.common)):
        predicted = None if hidden[k] > SURE else float(np.sqrt(covariance[k, k]))
        found.append(
            ToldParameter(
                name=name,
                combination=text,
                unit=rigid.dynamics.units[rigid.common.chosen[k]],
                drawn_std=float(drawn_std[k]),
                std=float(np.sqrt(square[k])),
                bias=float(mean[k]),
                predicted_std=predicted,
                stated_std=float(np.sqrt(stated[k])),
            )
        )
    return tuple(found)


def _common(study: DriveStudy) -> Array:
    """Return what common base parameters and the friction of every moving joint ask, all joints together, by noise."""
    rigid, rows = study.session.rigid, []
    for k, (joint, noise) in enumerate(zip(study.joints, study.noise, strict=True)):
        X = joint.X @ rigid.own[joint.number - 1].made_up[:, rigid.common.chosen]
        friction = np.zeros((len(X), len(FRICTION) * len(study.joints)))
        friction[:, len(FRICTION) * k : len(FRICTION) * (k + 1)] = _friction(joint)
        rows.append(np.hstack([X, friction]) / noise)
    return np.concatenate(rows)


def _friction(joint: Joint) -> Array:
    return np.hstack([rung.columns({"qd": joint.states["qd"]}) for rung in FRICTION])


def _covariance(A: Array) -> tuple[Array, Array]:
    """Return the covariance (n, n) of the unknowns of rows (M, n) by their noise, and how much of each is not seen."""
    size = np.linalg.norm(A, axis=0)
    scale = np.where(size > 0, size, 1.0)
    values, vectors = np.linalg.eigh((A / scale).T @ (A / scale))
    seen = values > UNSEEN * values[-1]
    inverse = (vectors[:, seen] / values[seen]) @ vectors[:, seen].T
    return inverse / np.outer(scale, scale), np.linalg.norm(vectors[:, ~seen], axis=1)


def _predicted(A: Array, noise: float, check: Array) -> float | None:
    """Return the rms of what is predicted wrong by an estimate from rows (M, n); None where they leave some open."""
    covariance, hidden = _covariance(A / noise)
    if (hidden > SURE).any():
        return None
    return float(np.sqrt(np.mean(np.sum((check @ covariance) * check, axis=1))))


def _torque(study: DriveStudy, parts: list[Drives]) -> tuple[TorqueSpread, ...]:
    """Return what is predicted wrong of each joint's torque, before and after."""
    before, after = (np.concatenate([getattr(part, key) for part in parts]) for key in ("before", "after"))
    found = []
    for k, (joint, noise, check) in enumerate(zip(study.joints, study.noise, study.check, strict=True)):
        predicted = _predicted(np.hstack([joint.X, _friction(joint)]), noise, check)
        found.append(
            TorqueSpread(
                limb=joint.number,
                unit=joint.readout.told,
                before_rms=_rms(before[:, k]),
                after_rms=_rms(after[:, k]),
                p95=float(np.quantile(after[:, k], 0.95)),
                predicted_rms=None if predicted is None else predicted / joint.readout.inside,
                readings=len(joint.y),
            )
        )
    return tuple(found)


def _additions(study: DriveStudy) -> tuple[TorqueAddition, ...]:
    """Return what a further run would leave: the one that adds most, and the trajectory itself once more."""
    motion = study.session.motion.states
    known = motion[:, np.isfinite(motion).all(axis=(0, 2))]
    best = study.asked(study.excitation.further(known).states(study.excitation.time(study.given.step)))
    ideas = {
        "the same trajectory once more": None,
        f"a run of {PERIOD:g} s that excites what is known least (deltacal plan --kind torque)": best,
    }
    found = []
    for words, more in ideas.items():
        each = []
        for k, (joint, noise, check) in enumerate(zip(study.joints, study.noise, study.check, strict=True)):
            own = np.hstack([joint.X, _friction(joint)])
            left = _predicted(np.vstack([own, own if more is None else more[k]]), noise, check)
            each.append(None if left is None else left / joint.readout.inside)
        found.append(TorqueAddition(add=words, rms_by_joint=tuple(each)))
    return tuple(found)


def _lacking(states: Sequence[str]) -> str:
    """Return what is missing for states: the column of a channel of the machine, else the first of them."""
    return next((f"the column {s.column}" for s in map(named, states) if s.per == "machine" and s.column), states[0])


def _wanted(study: DriveStudy) -> tuple[Missing, ...]:
    """Return the suspects that no recording of this trajectory could show, and what they need."""
    known = of_joint(study.given, study.session.motion.states, 0, np.zeros(study.given.n_rows))
    found = {
        rung.effect: Missing(name=rung.effect, missing=_lacking(missing))
        for truth in study.suspects
        for _, rung, _ in truth.effects
        if (missing := lacking(rung, known))
    }
    return tuple(found.values())


def _merged(found: Any) -> list[tuple[str, tuple[int, ...]]]:
    """Return effects by name with all their joints, in order."""
    limbs: dict[str, set[int]] = {}
    for name, own in found:
        limbs.setdefault(name, set()).update(own)
    return sorted((name, tuple(sorted(own))) for name, own in limbs.items())


def _plain(value: Any) -> Any:
    """Return a truth's values as JSON says them."""
    if isinstance(value, np.ndarray):
        return value.tolist()
    if isinstance(value, tuple | list):
        return [_plain(v) for v in value]
    if isinstance(value, dict):
        return {str(k): _plain(v) for k, v in value.items()}
    return value


def _rms(values: Array) -> float:
    return float(np.sqrt(np.mean(np.square(values))))


def _silent(text: str) -> None:
    return None

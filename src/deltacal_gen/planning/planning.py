"""Where to measure: poses on the rim of the workspace, the papers' rules, D-optimal sets, identifiability.

A plan is judged by the identification matrix that its recording will have: exact poses of the machine as the robot
file knows it, commanded through the nominal inverse, and derivatives by the generated kernels. For several reference
points the machine runs through the same joints once for each. Distances are those of all pairs of one reference
point, positions and poses are in one unknown frame, which is projected out.

An open chain has no rim to run along: its poses are joints, drawn evenly from their ranges and taken one by one, each
the one that adds most to the information.

Condition numbers depend on three conventions, each of which can be chosen and is said in the result: the scaling of
the columns, the norm (``spectral``: largest by smallest singular value; ``frobenius``: the norm of the matrix times
that of its pseudo-inverse), and the angle at which a ring starts. So does the number of poses that the rule picks.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np

from deltacal_gen.errors import ValueOutOfRange
from deltacal_gen.files.robot import Robot
from deltacal_gen.files.writing import write_recording
from deltacal_gen.identification.accuracy import workspace_of
from deltacal_gen.instrument.kinds import kind_of
from deltacal_gen.machine.registry import Array, mechanism_of
from deltacal_gen.machine.values import Measurement, Recording
from deltacal_gen.planning import singularities
from deltacal_gen.planning.matrix import FEWEST, Plan, Step, Task, at_poses, rule
from deltacal_gen.planning.optimal import bases, exchange, fewest_of, log_det_with, predict, reachable, task_of
from deltacal_gen.planning.reach import Poses, fitting, reached_of, readable_targets
from deltacal_gen.planning.rows import blank_recording
from deltacal_gen.planning.targets import FINE, ROUGH, candidates_of, edges, parts_of, rings
from deltacal_gen.results.plan import Method

Sets = Callable[[int], tuple[Poses, tuple[str, ...]]]  # from n to its poses, and what became of those out of reach


def plan_poses(
    robot: Robot,
    model: str,
    *,
    kind: str | None = None,
    tools: int | Array | Sequence[Sequence[float]] | None = None,
    layers: Sequence[str | float] | None = None,
    start_angle: float = 0.0,
    scaling: str | None = None,
    norm: str = "spectral",
    threshold: float = 0.01,
    n_max: int = 30,
    sigma_mm: float | None = None,
    said: Measurement | None = None,
    singular: tuple[float, float] | None = None,
) -> Plan:
    """Return the papers' poses on the rim of the workspace for n = 3 .. n_max, and the n that the rule chooses.

    Rings in a cylinder (Bai 2015); for a planar machine, rows along the edges of its rectangle (Mei 2018); for an open
    chain joints out of `joint_spread`, from as many as the model needs.

    Where a model has parameters that no poses can tell apart, the largest model within it that has none stands for it,
    or else the parameters that a pivoted QR keeps.

    Parameters
    ----------
    model : str
        ``delta/18`` or ``18``.
    kind : str, optional
        ``distance``, ``position`` or ``pose``; by default distances, and positions of an open chain.
    tools : (T, 3) array or int, optional
        Reference points in {O'} [mm], or how many of `reference_points`. By default one, or two where the model's
        parameters turn the platform and no pose is read; one of an open chain.
    layers : sequence, optional
        See `rings`. By default the middle one for a model with no more parameters than joints, else top and bottom.
    start_angle : float
        [rad]
    scaling : str
        ``paper``, ``table``, ``file`` or ``typical``: see `identifiability.IdentificationMatrix`. By default the
        paper's, or ``typical`` where no paper has one.
    norm : str
        Of the condition number: ``spectral`` or ``frobenius``.
    threshold : float
        Relative change of the condition number that the rule tolerates.
    sigma_mm : float, optional
        Noise per coordinate of a position, for the prediction.
    said : Measurement, optional
        What the sidecar of the readings will say: of a camera whether it is fixed, what of its lens is known; of a
        gauge where its ends are mounted.
    singular : (float, float), optional
        Instead of rings positions drawn at random whose nearest singularity is so far away, from .. to [mm]
        (Traslosheros 2013, section 4: 50 to 100 mm).

    Raises
    ------
    UsageError
        An unknown model, kind, scaling, norm or layer; a gauge that is mounted nowhere.
    InputError
        The robot file has no workspace.
    NoSolutionError
        Most poses of a ring cannot be reached, or lie beyond the joints' limits; single ones move inwards.

    References
    ----------
    Bai 2015, section 3.3, rule (21): min n subject to |k_n - k_(n-1)| / k_n <= threshold, n >= 3.
    Mei 2018, section 5, rule (31): min n subject to |k_1 - k_m| / k_1 <= threshold, n >= 3, k_m of the corrected gauge.
    """
    task = task_of(robot, model, kind, tools, scaling, norm, said)
    if n_max < FEWEST:
        raise ValueOutOfRange(f"n_max is {n_max}, but a ring has at least {FEWEST} poses.")
    drawn = None if singular is None else singularities.near(robot, singular, n_max, np.random.default_rng(0))
    method: Method
    sets: Sets
    mechanism, first = mechanism_of(robot), FEWEST
    parts: tuple[float, ...] = ()
    if mechanism.many_ways or kind_of(task.kind).aims == "touch":
        method, start_angle = "joints", 0.0
        first, sets = _joints(task, n_max)
    elif drawn is not None:
        method = "singular"
        sets = lambda n: (reached_of(robot, drawn[:n], task.tools), ())  # noqa: E731
    else:
        method = "edges" if len(mechanism.axes) == 2 else "rings"
        rough = method == "rings" and len(mechanism.model(model)) <= mechanism.limbs
        parts = parts_of((ROUGH if rough else FINE) if layers is None else layers)
        sets = _rings(task, method, parts, start_angle)
    before = math.inf if method == "joints" else task.step(FEWEST - 1, sets(FEWEST - 1)[0]).condition
    steps: list[Step] = []
    for n in range(first, n_max + 1):
        steps.append(task.step(n, sets(n)[0], before))
        before = steps[-1].condition
    chosen, settled = rule([step.n for step in steps], [step.change for step in steps], threshold)
    poses, notes = sets(chosen or n_max)
    return Plan(
        **vars(task),
        method=method,
        layers=parts,
        start_angle=start_angle,
        threshold=threshold,
        steps=tuple(steps),
        chosen=chosen,
        settled=settled,
        poses=poses,
        prediction=predict(task, poses, sigma_mm),
        notes=notes,
    )


def _rings(task: Task, method: Method, parts: Sequence[float], start_angle: float) -> Sets:
    """Return what gives n poses on the rim of each layer, or along each edge."""
    robot, space = task.robot, workspace_of(task.robot)
    shift = task.tools[0] - robot.tool if method == "edges" else 0.0  # the robot's own point runs along the edges

    def sets(n: int) -> tuple[Poses, tuple[str, ...]]:
        targets = edges(space, n, parts) if method == "edges" else rings(space, n, parts, start_angle)
        return fitting(robot, readable_targets(robot, targets + shift), task.tools, space.home + shift)

    return sets


def _joints(task: Task, n_max: int) -> tuple[int, Sets]:
    """Return how many joints of a chain the model needs, and what gives n: by exchange, then what adds most."""
    wanted = reachable(task, readable_targets(task.robot, candidates_of(task.robot, kind_of(task.kind))))
    whole, frame = bases(task, reached_of(task.robot, wanted, task.tools))
    fewest = max(FEWEST, fewest_of(task, whole))
    if fewest >= n_max:
        raise ValueOutOfRange(
            f"{task.model} needs {fewest} poses at the least, more than {n_max}: ask for fewer parameters."
        )
    picked = exchange(whole, frame, fewest, np.random.default_rng(0)).tolist()
    for _ in range(fewest, n_max):
        gain = log_det_with(whole, np.array(picked)) - log_det_with(frame, np.array(picked))
        gain[picked] = -math.inf
        picked.append(int(np.argmax(gain)))
    return fewest, lambda n: (reached_of(task.robot, wanted[picked[:n]], task.tools), ())


def target_recording(found: Plan, path: str | Path = "poses.csv") -> Recording:
    """Return a plan's poses as a recording of targets, or of a chain's joints, with nothing measured yet."""
    poses, mechanism = found.poses, mechanism_of(found.robot)
    kind = at_poses(found)
    recording = blank_recording(
        found.robot,
        kind.name,
        poses.joints,
        kind.columns(mechanism),
        dataclasses.replace(found.said, kind=kind.name),
        path,
        tool=None if kind.mount else poses.tool,
        targets=None if mechanism.many_ways else _with_turns(found),
    )
    return kind.laid_out(recording, poses.x, mechanism)


def _with_turns(found: Plan) -> Array:
    """Return the targets (N, 3) of a plan; of a platform that turns on command the poses (N, 12) that were planned."""
    poses, mechanism = found.poses, mechanism_of(found.robot)
    if not mechanism.turning:
        return poses.targets
    q = found.robot.joint_sign * poses.joints
    nominal, _ = mechanism.forward(q, poses.tool, mechanism.rows(dataclasses.replace(found.robot, errors={})))
    return np.hstack([poses.targets, nominal[:, 3:]])


def write_targets(found: Plan, path: str | Path) -> None:
    """Write a plan's targets and tool points as a CSV, with a sidecar, to be measured or simulated.

    Raises
    ------
    InputError
        A file cannot be written.
    """
    write_recording(target_recording(found, path), path)

"""From arrays to parameters: the same fit as in ``identify``, without files, reports and what only those need.

A process that begins here has imported NumPy alone. A first small job is done by the plain kernels before Numba would
be loaded (see `deltacal_gen.machine.registry`)::

    from deltacal_gen import estimate, nominal

    robot = nominal("delta", {"base_radius": 200.0, "platform_radius": 51.0, ...})
    found = estimate(robot, "18", joints, positions, as_distance=True)
    found.parameters                                  # {"L_1": 0.012, ...} mm and rad, actual minus nominal
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from deltacal_gen.errors import (
    NoReadings,
    NotForThisMachine,
    OptionNotApplicable,
    OutOfReach,
    UnknownModel,
    UnknownName,
    ValueOutOfRange,
    WrongArray,
)
from deltacal_gen.estimation.fit import fit, rough
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import Problem, pose_problem
from deltacal_gen.estimation.solvers import Factored, LeastSquares, Solver
from deltacal_gen.instrument.kinds import PAIRS, POINTS
from deltacal_gen.machine.answers import result
from deltacal_gen.machine.backend import working
from deltacal_gen.machine.registry import SOLVED, STATUS, Array, load_mechanism, mechanism_of
from deltacal_gen.machine.values import POSITION, Measurement, Recording, Robot
from deltacal_gen.units import file_unit, to_internal

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

GIVEN = "arrays"  # stands in messages where a file's name would
FRAMES = ("unknown", "robot")
MACHINES = 256  # at once: what belongs to them stays in the cache


def nominal(mechanism: str, geometry: Mapping[str, ArrayLike], tool: ArrayLike = (0.0, 0.0, 0.0)) -> Robot:
    """Return a machine as its drawings have it.

    Parameters
    ----------
    mechanism : str
        One of ``models()``.
    geometry : mapping
        Values by the keys of a robot file and in its units, one number for all limbs or one per limb [mm, deg].
    tool : (3,) array
        Reference point in {O'} [mm].

    Raises
    ------
    UsageError
        An unknown mechanism or key, a missing key, or values of a wrong shape.
    """
    known = load_mechanism(mechanism)
    if known.linked:
        raise NotForThisMachine(f"{mechanism} is made of links; write a robot file and read it with read_robot.")
    keys = {entry.key: entry for entry in known.geometry}
    if wrong := sorted(geometry.keys() - keys.keys()):
        raise UnknownModel(f"{mechanism} has no dimension '{wrong[0]}'; it has {', '.join(keys)}.")
    values = {}
    for name, entry in keys.items():
        if name not in geometry and entry.default is None:
            unit = file_unit(entry.unit)
            raise WrongArray(f"the dimension '{name}' of {mechanism} is missing: {entry.meaning} [{unit}].")
        value = np.multiply(geometry[name], to_internal(entry.unit)) if name in geometry else entry.default
        length = sum(other.key == name for other in known.geometry) if entry.entry is not None else known.limbs
        values[name] = np.atleast_1d(np.asarray(value, dtype=float))
        if values[name].shape not in ((1,), (length,)) or not np.isfinite(values[name]).all():
            raise WrongArray(f"the dimension '{name}' of {mechanism} must be one finite number or {length} of them.")
    return Robot(
        name=mechanism,
        mechanism=mechanism,
        geometry=values,
        tool=_points(tool, 1, "the reference point")[0],
        errors={},
        tolerance={},
        workspace=None,
        masses=None,
        transmission=None,
        joint_sign=np.ones(known.limbs),
        joint_limits=None,
    )


def recorded(
    robot: Robot,
    joints: ArrayLike,
    measured: ArrayLike,
    *,
    pairs: ArrayLike | None = None,
    tool: ArrayLike | None = None,
    frame: str = "unknown",
    sigma: float | None = None,
) -> Recording:
    """Return arrays as a recording; see `estimate` for the parameters.

    Raises
    ------
    UsageError
        Arrays whose shapes do not go together, a pair of one pose with itself, a negative distance, or a frame or a
        standard deviation that cannot be.
    InputError
        No reading.
    """
    mechanism = mechanism_of(robot)
    if frame not in FRAMES:
        raise UnknownName(f"there is no frame '{frame}'; known: {', '.join(FRAMES)}.")
    if sigma is not None and not (sigma > 0 and np.isfinite(sigma)):
        raise ValueOutOfRange(f"sigma = {sigma}: a standard deviation above 0 mm was expected, or None.")
    q, values = np.asarray(joints, dtype=float), np.asarray(measured, dtype=float)
    if q.ndim != 2 or q.shape[1] != mechanism.limbs or not np.isfinite(q).all():
        raise WrongArray(f"joints have the shape {q.shape}; (N, {mechanism.limbs}) finite numbers were expected.")
    ends = None if pairs is None else np.asarray(pairs)
    wanted = (len(q), len(mechanism.axes)) if ends is None else (len(ends),)
    if values.shape != wanted:
        what = f"positions along {' '.join(mechanism.axes)}" if ends is None else "one distance per pair"
        raise WrongArray(f"measured has the shape {values.shape}; {wanted} was expected: {what}.")
    if ends is not None and (
        ends.ndim != 2 or ends.shape[1] != 2 or ends.dtype.kind not in "iu" or not np.isin(ends, range(len(q))).all()
    ):
        raise WrongArray(f"pairs must be (K, 2) whole numbers below {len(q)}: rows of joints.")
    if not np.isfinite(np.atleast_2d(values.T)).all(axis=0).any():
        raise NoReadings("measured holds no reading, so there is nothing to fit.", "Give at least one.", file=GIVEN)
    points = None if tool is None else _points(tool, len(q), "tool")
    if ends is not None:
        at = q if points is None else np.hstack([q, np.where(np.isfinite(points), points, robot.tool)])
        if (same := (at[ends[:, 0]] == at[ends[:, 1]]).all(axis=1)).any():
            k = int(np.argmax(same))
            raise WrongArray(
                f"pairs[{k}] = {ends[k].tolist()} has the same joints and tool at both ends; "
                "a pair needs two different poses."
            )
        if (values < 0).any():
            k = int(np.argmax(values < 0))
            raise WrongArray(f"measured[{k}] = {values[k]:.6g}: a distance cannot be negative.")
    return Recording(
        path=GIVEN,
        kind=POINTS if ends is None else PAIRS,
        measurement=Measurement(frame=frame, sigma_mm=sigma),
        joint_unit=mechanism.joint_unit,
        joints=robot.joint_sign * q,
        columns=tuple(name for name in POSITION if name[0] in mechanism.axes) if ends is None else (),
        measured=values if ends is None else np.empty((len(q), 0)),
        pose=np.arange(len(q)),
        line=np.arange(len(q)),
        channels={},
        setup=np.zeros(len(q), dtype=int),
        setup_names=("1",),
        tool=points,
        pairs=ends,
        pair_measured=None if ends is None else values,
        pair_line=None if ends is None else np.arange(len(ends)),
    )


def estimate(
    robot: Robot,
    model: str,
    joints: ArrayLike,
    measured: ArrayLike,
    *,
    pairs: ArrayLike | None = None,
    tool: ArrayLike | None = None,
    as_distance: bool = False,
    frame: str = "unknown",
    sigma: float | None = None,
    solver: Solver | None = None,
    robust: bool = True,
) -> Fit:
    """Estimate a machine's source errors from arrays: the encoder offsets first, then all parameters of a model.

    Parameters
    ----------
    robot : Robot
        As drawn, by `nominal` or `read_robot`.
    model : str
        ``delta/32`` or ``32``.
    joints : (N, n_q) array
        In the mechanism's positive direction [rad or mm].
    measured : (N, axes) or (K,) array
        Positions of the reference point [mm], NaN where none was read; with `pairs` distances [mm].
    pairs : (K, 2) int array, optional
        Rows of `joints` between which distances were measured.
    tool : (3,) or (N, 3) array, optional
        Measured points in {O'} [mm]; default the robot's own.
    as_distance : bool
        Use the distances of all pairs of positions that share a measured point: no frame is needed (Bai 2015, 3.1).
    frame : {"unknown", "robot"}
        Of measured positions; one that is unknown is estimated along.
    sigma : float, optional
        Standard deviation per coordinate [mm], where it is known and readings are few.
    solver : Solver, optional
        Rule for directions that the data hardly see; default `LeastSquares`.
    robust : bool
        Let a few per cent of gross errors not move the result.

    Returns
    -------
    Fit
        ``parameters`` by name; ``errors`` (n_p,), ``covariance``, ``residual`` and the rest as arrays.

    Raises
    ------
    UsageError
        As `recorded`; an unknown model.
    InputError
        Joints at which the machine cannot stand; no reading.
    NoSolutionError
        No convergence.
    """
    recording = recorded(robot, joints, measured, pairs=pairs, tool=tool, frame=frame, sigma=sigma)
    everything = pose_problem(robot, recording, (), as_distance=as_distance)
    with working("identify", len(recording.joints)):
        first = rough(everything, robust)
        names = everything.mechanism.model(model)
        return fit(
            everything.with_names(names),
            LeastSquares() if solver is None else solver,
            errors=first.errors,
            machine=first.machine,
            instrument=first.instrument,
            robust=robust,
        )


class PoseSet:
    """Poses at which many machines of one drawing are measured, corrected or judged.

    What depends on the poses alone is computed once: derivatives of the machine as drawn, and the factor of a linear
    identification. Another machine costs its exact positions and a product of matrices::

        poses = PoseSet(robot, joints)
        linear = poses.linear("18", as_distance=True)
        found = linear.estimate(poses.positions(errors) + noise)    # (T, n) of T machines

    Parameters
    ----------
    robot : Robot
        As drawn.
    joints : (N, n_q) array
        In the mechanism's positive direction [rad or mm].
    tool : (3,) or (N, 3) array, optional
        Measured points in {O'} [mm]; default the robot's own.

    Raises
    ------
    UsageError
        Arrays whose shapes do not go together.
    NoSolutionError
        Joints at which the machine cannot stand.
    """

    def __init__(self, robot: Robot, joints: ArrayLike, *, tool: ArrayLike | None = None) -> None:
        self.robot, self.mechanism = robot, mechanism_of(robot)
        self.joints = np.asarray(joints, dtype=float)
        if self.joints.ndim != 2 or self.joints.shape[1] != self.mechanism.limbs:
            raise WrongArray(f"joints have the shape {self.joints.shape}; (N, {self.mechanism.limbs}) was expected.")
        self.tool = _points(robot.tool if tool is None else tool, len(self.joints), "tool")
        self._x, status = self.mechanism.forward(self.joints, self.tool, self.mechanism.rows(robot))
        if (status != SOLVED).any():
            row = int(np.argmax(status != SOLVED))
            raise OutOfReach(f"at the joints of row {row} the machine is {STATUS[int(status[row])]}.")

    def positions(self, errors: ArrayLike, joints: Array | None = None, *, out: Array | None = None) -> Array:
        """Return exact positions (T, N, 3) [mm] of machines with source errors (T, n_p); NaN where there is none.

        `joints` (T, N, n_q) are each machine's own; default those of the set. The result is written into `out` where
        it is given.
        """
        errors = self.mechanism.every(errors)
        every = np.broadcast_to(self.joints if joints is None else joints, (len(errors), *self.joints.shape))
        out, same = result(out, (*every.shape[:2], 3)), bool((self.tool == self.tool[0]).all())
        for first in range(0, len(errors), MACHINES):
            some = slice(first, first + MACHINES)
            rows = self.mechanism.rows(self.robot, errors[some])
            q = np.array(every[some])  # no view that cannot be written: for those kernels would be compiled once more
            tool = self.tool[0] if same else np.tile(self.tool, (len(rows), 1))
            with working("call", len(errors) * every.shape[1]):  # whatever is left for the last machines
                self.mechanism.positions(q.reshape(-1, q.shape[2]), tool, rows, out=out[some].reshape(-1, 3))
        return out

    @cached_property
    def corrections(self) -> Array:
        """Change of the joints by each error (N, n_q, n_p) that leaves the point in place: Bai 2015, eq. (23)."""
        found = self.mechanism.sensitivity(self._x, self.joints, self.tool, self.mechanism.rows(self.robot))
        axes = ["xyz".index(axis) for axis in self.mechanism.axes]
        kept: Array = -np.linalg.pinv(found.joints[:, axes]) @ found.parameters[:, axes]
        return kept

    def commands(self, errors: ArrayLike, *, out: Array | None = None) -> Array:
        """Return the joints (T, N, n_q) that bring machines with source errors (T, n_p) here, to first order."""
        errors = self.mechanism.every(errors) - self.mechanism.vector(self.robot.errors)
        flat = self.corrections.reshape(-1, self.corrections.shape[2])
        joints = result(out, (len(errors), *self.joints.shape))
        np.matmul(errors, flat.T, out=joints.reshape(len(errors), -1))
        joints += self.joints
        return joints

    def linear(
        self,
        model: str,
        *,
        pairs: ArrayLike | None = None,
        as_distance: bool = False,
        frame: str = "unknown",
    ) -> LinearFit:
        """Return the linear identification of machines measured at these poses; see `estimate` for the parameters.

        Raises
        ------
        UsageError
            An unknown model; positions in an unknown frame, which no linear step can find.
        """
        positions = self._x[:, ["xyz".index(axis) for axis in self.mechanism.axes]]
        measured = positions if pairs is None else np.ones(len(np.asarray(pairs)))
        recording = recorded(self.robot, self.joints, measured, pairs=pairs, tool=self.tool, frame=frame)
        problem = pose_problem(self.robot, recording, self.mechanism.model(model), as_distance=as_distance)
        return LinearFit(problem, made=as_distance and pairs is None)


class LinearFit:
    """Identification in one linear step from the machine as drawn, its factor kept for any number of machines.

    Attributes
    ----------
    names : tuple of str
        The source errors found.
    matrix : (M, n) array
        Readings by source errors, the identification matrix [mm / mm or rad].
    gain : (n, M) array
        Its inverse in the least squares sense; directions that no reading sees stay at the drawing's values.
    """

    def __init__(self, problem: Problem, made: bool) -> None:
        instrument = problem.begin(problem.reference)
        if instrument.free:
            raise OptionNotApplicable(
                'positions in an unknown frame are not linear: give as_distance=True or frame="robot".'
            )
        state, x = problem.linearise(problem.reference, instrument), problem.poses(problem.reference)
        self.names, self.columns = problem.names, problem.columns
        self._from, self._parameters = problem.reference[self.columns], len(problem.reference)
        read = np.isfinite(problem.readings.values)
        self.matrix = state.J_p[read]
        self.gain = problem.scale[:, None] * Factored(self.matrix * problem.scale, np.zeros(len(self.names))).gain
        self._nominal = instrument.predict(problem.readings, x)[0][read]
        self._ends = problem.readings.rows.T if made else None
        self._poses = len(problem.recording.joints)

    def estimate(self, measured: ArrayLike, *, out: Array | None = None) -> Array:
        """Return the source errors (T, n) [mm, rad] of machines, in the order of `names`.

        Parameters
        ----------
        measured : (T, N, axes or 3) or (T, K) array
            What was measured of each machine: positions, or the distances of the pairs [mm].

        Raises
        ------
        UsageError
            They are not as many as the poses ask for.
        """
        measured = np.asarray(measured, dtype=float)
        if self._ends is not None:
            fits = measured.ndim == 3 and measured.shape[1] == self._poses
        else:
            fits = measured.ndim > 1 and measured.size == len(measured) * len(self._nominal)
        if not fits:
            wanted = (
                f"positions (T, {self._poses}, axes)" if self._ends is not None else f"{len(self._nominal)} numbers"
            )
            raise WrongArray(f"measured has the shape {measured.shape}; {wanted} of each machine were expected.")
        out = result(out, (len(measured), len(self.names)))
        for first in range(0, len(measured), MACHINES):
            some = slice(first, first + MACHINES)
            values = (
                self._lengths(measured[some])
                if self._ends is not None
                else measured[some].reshape(-1, len(self._nominal)).T
            )
            out[some] = (self.gain @ (values - self._nominal[:, None])).T
        out += self._from
        return out

    def whole(self, found: Array, *, out: Array | None = None) -> Array:
        """Return estimates (T, n) as all source errors of the mechanism (T, n_p)."""
        out = result(out, (len(found), self._parameters))
        out[:] = 0.0
        out[:, self.columns] = found
        return out

    def _lengths(self, positions: Array) -> Array:
        """Return the distances (M, T) of positions (T, N, k): the machines last, so that rows are copied whole."""
        assert self._ends is not None
        a, b = self._ends
        square = np.zeros((len(a), len(positions)))
        for along in np.ascontiguousarray(positions.transpose(2, 1, 0)):
            gap = along[b]
            gap -= along[a]
            gap *= gap
            square += gap
        return np.sqrt(square, out=square)


def _points(values: ArrayLike, rows: int, what: str) -> Array:
    points = np.asarray(values, dtype=float)
    if points.shape not in ((3,), (rows, 3)):
        raise WrongArray(f"{what} has the shape {points.shape}; (3,) or ({rows}, 3) was expected.")
    return np.array(np.broadcast_to(points, (rows, 3)))

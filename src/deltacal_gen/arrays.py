"""From arrays to parameters: the same fit as in ``identify``, without files, reports and what only those need.

A process that begins here has imported NumPy alone. A first small job is done by the plain kernels before Numba would
be loaded (see `deltacal_gen.mechanism`)::

    from deltacal_gen import estimate, nominal

    robot = nominal("delta", {"base_radius": 200.0, "platform_radius": 51.0, ...})
    found = estimate(robot, "18", joints, positions, as_distance=True)
    found.parameters                                  # {"L_1": 0.012, ...} mm and rad, actual minus nominal
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike

from deltacal_gen.errors import UsageError
from deltacal_gen.estimation import Fit, fit, pose_problem, rough
from deltacal_gen.inputs import POSITION, Measurement, Recording, Robot
from deltacal_gen.mechanism import Array, load_mechanism, mechanism_of
from deltacal_gen.solvers import LeastSquares, Solver
from deltacal_gen.units import file_unit, to_internal

GIVEN = Path("arrays")  # stands in messages where a file's name would


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
    if known.links is not None:
        raise UsageError(f"{mechanism} is made of links; write a robot file and read it with read_robot.")
    keys = {entry.key: entry for entry in known.geometry}
    if wrong := sorted(geometry.keys() - keys.keys()):
        raise UsageError(f"{mechanism} has no dimension '{wrong[0]}'; it has {', '.join(keys)}.")
    values = {}
    for name, entry in keys.items():
        if name not in geometry and entry.default is None:
            unit = file_unit(entry.unit)
            raise UsageError(f"the dimension '{name}' of {mechanism} is missing: {entry.meaning} [{unit}].")
        value = np.multiply(geometry[name], to_internal(entry.unit)) if name in geometry else entry.default
        length = sum(other.key == name for other in known.geometry) if entry.entry is not None else known.limbs
        values[name] = np.atleast_1d(np.asarray(value, dtype=float))
        if values[name].shape not in ((1,), (length,)) or not np.isfinite(values[name]).all():
            raise UsageError(f"the dimension '{name}' of {mechanism} must be one finite number or {length} of them.")
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
        Arrays whose shapes do not go together.
    """
    mechanism = mechanism_of(robot)
    q, values = np.asarray(joints, dtype=float), np.asarray(measured, dtype=float)
    if q.ndim != 2 or q.shape[1] != mechanism.limbs or not np.isfinite(q).all():
        raise UsageError(f"joints have the shape {q.shape}; (N, {mechanism.limbs}) finite numbers were expected.")
    ends = None if pairs is None else np.asarray(pairs)
    wanted = (len(q), len(mechanism.axes)) if ends is None else (len(ends),)
    if values.shape != wanted:
        what = f"positions along {' '.join(mechanism.axes)}" if ends is None else "one distance per pair"
        raise UsageError(f"measured has the shape {values.shape}; {wanted} was expected: {what}.")
    if ends is not None and (
        ends.ndim != 2 or ends.shape[1] != 2 or ends.dtype.kind not in "iu" or not np.isin(ends, range(len(q))).all()
    ):
        raise UsageError(f"pairs must be (K, 2) whole numbers below {len(q)}: rows of joints.")
    return Recording(
        path=GIVEN,
        kind="position" if ends is None else "distance",
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
        tool=None if tool is None else _points(tool, len(q), "tool"),
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
        Arrays whose shapes do not go together; an unknown model.
    InputError
        Joints at which the machine cannot stand; no reading.
    NoSolutionError
        No convergence.
    """
    recording = recorded(robot, joints, measured, pairs=pairs, tool=tool, frame=frame, sigma=sigma)
    everything = pose_problem(robot, recording, (), as_distance=as_distance)
    first = rough(everything, robust)
    names = everything.mechanism.model(model)
    rule = LeastSquares() if solver is None else solver
    return fit(everything.with_names(names), rule, errors=first.errors, instrument=first.instrument, robust=robust)


def _points(values: ArrayLike, rows: int, what: str) -> Array:
    points = np.asarray(values, dtype=float)
    if points.shape not in ((3,), (rows, 3)):
        raise UsageError(f"{what} has the shape {points.shape}; (3,) or ({rows}, 3) was expected.")
    return np.array(np.broadcast_to(points, (rows, 3)))

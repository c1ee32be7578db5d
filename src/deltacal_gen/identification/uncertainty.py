"""The uncertainty of the tool over the workspace, as far as the readings leave it open."""

from __future__ import annotations

import numpy as np

from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.files.robot import Robot
from deltacal_gen.identification.accuracy import check_joints, without_motion
from deltacal_gen.identification.knowledge import factor
from deltacal_gen.results.parts import Uncertainty
from deltacal_gen.results.result import MapPoint, UncertaintyMap

# ------------------------------------------------------------------------------------------ over the workspace


def uncertainty_map(final: Fit, robot: Robot, known: Uncertainty) -> UncertaintyMap | None:
    """Return the standard deviation of the tool position over the workspace, or None where the robot has none.

    Positions and poses: of the position in the instrument's frame, its frame's uncertainty included. Distances and
    gauge lengths know no frame: of the position after the best alignment of the map as a whole. What the data do not
    pin enters with its prior, what the model leaves out with its size. The point of the platform is that of the first
    reading.
    """
    if robot.workspace is None:
        return None
    problem = final.problem
    mechanism, n, L = problem.mechanism, len(known.parameters), factor(known)
    tool = problem.body.tool[problem.readings.rows[0, 0]]
    q, x, targets, ok = check_joints(robot, tool)
    if not ok.any():
        return None
    dx = mechanism.sensitivity(x, q, tool, mechanism.rows(robot)).parameters
    dx = dx[:, :, [mechanism.index[name] for name in known.parameters]]
    if (frame := final.instrument.of_points()) is not None:
        J_p, J_m = frame.linearise(frame.kind.taken(np.arange(ok.sum())[:, None]), x, dx)
        whole, part = len(final.instrument.free), len(frame.free)
        keep = [n + s * whole + j for s in range(len(frame.state)) for j in range(part)]
        J = np.concatenate([J_p, J_m], axis=2)
        L = L[[*range(n), *keep]]
    else:
        J = without_motion(dx[:, :3].reshape(-1, n), x[:, :3]).reshape(-1, 3, n)
        L = L[:n]
    scatter = known.scatter[:3] if final.problem.readings.kind.positions else np.zeros(3)
    std = np.hypot(np.linalg.norm(J @ L, axis=2), scatter)
    norm = np.linalg.norm(std, axis=1)
    return UncertaintyMap(
        frame="best alignment of the map" if frame is None else "instrument",
        tool_mm=tuple(tool.tolist()),
        worst_mm=float(norm.max()),
        median_mm=float(np.median(norm)),
        points=tuple(
            MapPoint(target_mm=tuple(t), std_mm=tuple(s))
            for t, s in zip(targets[ok].tolist(), std.tolist(), strict=True)
        ),
        unreachable=int((~ok).sum()),
    )

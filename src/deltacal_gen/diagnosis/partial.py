"""Partial residuals: one number per reading, where the cause is seen best, and what each effect moves.

Geometry that is fitted without an effect follows part of it. What the effect does shows undistorted as a partial
residual: the residual of the whole fit, and what the effect adds there.
"""

from __future__ import annotations

from functools import cached_property

import numpy as np

from deltacal_gen.files.robot import robot_of
from deltacal_gen.instrument.kinds import POINTS, kind_of
from deltacal_gen.machine.registry import Array, mechanism_of
from deltacal_gen.physics.body import Body
from deltacal_gen.physics.channels import Channels
from deltacal_gen.physics.reading import reading_shift
from deltacal_gen.physics.terms import load_effect, term_of
from deltacal_gen.results.base import shown_in
from deltacal_gen.results.diagnosis import Diagnosis, Effect, PartialResiduals
from deltacal_gen.units import file_unit, joint_factors, joint_names, to_internal


def with_partial_residuals(found: Diagnosis) -> Diagnosis:
    """Return a diagnosis with its partial residuals, and for each effect how far it moves a reading and what to do."""
    made = _Contributions(found)
    effects = tuple(
        e.replace(moves_mm=made.size(i), advice=load_effect(e.name).ADVICE) for i, e in enumerate(found.effects)
    )
    return found.replace(effects=effects, residuals=found.residuals.replace(partial=_partial(found, made)))


class _Contributions:
    """What each effect adds to the readings (R, 3) [mm]; None where they are no positions in one frame."""

    def __init__(self, found: Diagnosis) -> None:
        self.found, self.robot = found, robot_of(found.robot)
        self.mechanism = mechanism_of(self.robot)
        self.terms = [term_of(t) for t in found.physics]

    @property
    def in_one_frame(self) -> bool:
        return kind_of(self.found.instrument.kind).positions and len(self.found.instrument.setups) == 1

    @cached_property
    def body(self) -> Body:
        """The calibrated machine at the readings."""
        unit, n = self.mechanism.joint_unit, self.mechanism.limbs
        columns = self.found.residuals.channels
        q = np.column_stack([columns[name] for name in joint_names(unit, n)]) * joint_factors(unit, n)
        tool = np.ascontiguousarray(np.broadcast_to(self.robot.tool, (len(q), 3)))
        channels = Channels.from_columns(columns, q.shape, self.robot, unit)
        return Body(self.robot, self.mechanism, q, tool, channels)

    @cached_property
    def errors(self) -> Array:
        return self.mechanism.vector(self.robot.errors)

    def of(self, effect: int) -> Array | None:
        """Return what an effect adds."""
        if not self.in_one_frame or any(self.body.missing(t) for t in self.terms):
            return None
        others = [t for i, t in enumerate(self.terms) if i != effect]
        with_it, without = (self.body.solve(self.errors, terms)[0].x[:, :3] for terms in (self.terms, others))
        turn, origin = np.split(self.found.instrument.state[0, :12], [9])
        positions = kind_of(POINTS).taken(np.arange(len(with_it))[:, None], values=with_it)
        shifted = []
        for x, terms in ((with_it, self.terms), (without, others)):
            read = x @ turn.reshape(3, 3).T + origin
            shifted.append(read + reading_shift(terms, self.body, positions, read, with_it)[0])
        out: Array = shifted[0] - shifted[1]
        return out

    def size(self, effect: int) -> float | None:
        """Return by how much an effect moves a reading at most [mm]."""
        added = self.of(effect)
        return None if added is None else float(np.nanmax(np.linalg.norm(added, axis=1)))

    def of_finding(self, strongest: Effect) -> Array | None:
        """Return what an effect adds, a periodic error with its harmonics."""
        found = self.found
        first = next(e for e in found.findings if strongest in (e, *found.harmonics(e)))
        own = (first, *found.harmonics(first))
        parts = [self.of(i) for i, e in enumerate(found.effects) if e in own]
        return None if any(p is None for p in parts) else np.sum([p for p in parts if p is not None], axis=0)

    def at_joint(self, limb: int) -> tuple[Array, str]:
        """Return what turns a position's residual into the error of a joint (R, 3), and its unit in files."""
        machine, _ = self.body.solve(self.errors, ())
        turn = self.found.instrument.state[0, :9].reshape(3, 3)  # of {O} in the instrument's frame
        slopes = np.linalg.pinv(self.body.sensitivity(machine).joints[:, :3]) @ turn.T
        unit = self.mechanism.joint_units[limb - 1]
        return slopes[:, limb - 1] / to_internal(unit), file_unit(unit)


def _partial(found: Diagnosis, made: _Contributions) -> PartialResiduals:
    """Return residuals as the error of the joint that is at fault, else along the direction in which most is left."""
    before, after = found.residuals.before_mm, found.residuals.after_mm
    (unit, size), without = shown_in(found), None
    strongest = max(found.effects, key=lambda e: e.share_of_excess, default=None)
    limbs = found.location.limbs if strongest is None else strongest.limbs
    if strongest is not None and (added := made.of_finding(strongest)) is not None:
        before, without = after + added, strongest.name
    if before.shape[1] == 1:
        along, of = np.ones(1) / size, "residual"
    elif len(limbs) == 1 and made.in_one_frame:
        along, unit = made.at_joint(limbs[0])
        of = f"error of joint {limbs[0]}"
    else:
        centred = np.nan_to_num(before - np.nanmedian(before, axis=0))
        along, of = np.linalg.svd(centred, full_matrices=False)[2][0] / size, "residual where most is left"
    return PartialResiduals(
        of=of, unit=unit, without=without, before=(along * before).sum(axis=1), after=(along * after).sum(axis=1)
    )

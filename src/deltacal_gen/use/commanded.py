"""Commands for targets: where a machine is wanted, and the joints that bring it there with all that is known of it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from deltacal_gen.errors import UnknownName, WrongArray, WrongFile
from deltacal_gen.files.checks import impossible
from deltacal_gen.files.columns import Columns, is_channel
from deltacal_gen.files.toml import nearest
from deltacal_gen.instrument.kinds import kind_of
from deltacal_gen.machine.registry import Array
from deltacal_gen.machine.rotation import from_vector
from deltacal_gen.machine.values import Recording
from deltacal_gen.physics.channels import Channels
from deltacal_gen.physics.ranges import in_words
from deltacal_gen.results.diagnosis import Diagnosis
from deltacal_gen.results.result import Result
from deltacal_gen.states import RECORDED
from deltacal_gen.units import DEG, joint_factors, joint_names
from deltacal_gen.use import prediction
from deltacal_gen.use.compensation import TURNED_DEG, Compensator

Progress = Callable[[str], None]
USUAL = (  # columns of channels: of the machine, and of the first joint
    *sorted(s.column for s in RECORDED if s.per == "machine"),
    *sorted(s.columns("rad", 1)[0] for s in RECORDED if s.per == "joint"),
)


@dataclass(frozen=True, eq=False)
class Wanted:
    """Where a machine shall stand, target by target.

    Attributes
    ----------
    positions : (N, 3) or (N, 12) array
        Positions [mm], or whole poses of a machine whose last frame turns.
    tool : (N, 3) array or None
        Measured points of the platform [mm]; None for the robot's own.
    near : (N, n_q) array or None
        Joints of a program as it is: a chain goes on standing as it stands there.
    columns : mapping
        What the effects depend on, by the names of a recording's columns.
    pose : list of str or None
        Labels of the targets.
    """

    positions: Array
    tool: Array | None
    near: Array | None
    columns: Mapping[str, Array | float]
    pose: list[str] | None

    @staticmethod
    def of_array(targets: Array, compensator: Compensator, columns: Mapping[str, Array | float]) -> Wanted:
        """Return positions (N, 3) [mm], of machines that turn with rotation vectors in deg beside (N, 6).

        Raises
        ------
        UsageError
            They are no finite numbers, or have another shape.
        """
        positions = _finite(targets)
        if compensator.mechanism.turning and positions.ndim == 2 and positions.shape[1] == 6:
            positions = np.hstack([positions[:, :3], from_vector(positions[:, 3:] * DEG).reshape(-1, 9)])
        if positions.size and (positions.ndim != 2 or positions.shape[1] not in {3, *compensator.mechanism.widths}):
            turned = " or, with rx_deg, ry_deg, rz_deg, (N, 6)" if compensator.mechanism.turning else ""
            raise WrongArray(f"targets have the shape {np.shape(targets)}; (N, 3) mm{turned} is expected.")
        return Wanted(positions, None, None, columns, None)

    @staticmethod
    def of_file(
        recording: Recording, compensator: Compensator, columns: Mapping[str, Array | float], tell: Progress
    ) -> Wanted:
        """Return the targets of a file; of a chain's program where the chain as drawn stands at its joints.

        Raises
        ------
        InputError
            Joints alone, of a machine that stands one way only: its targets are what is asked for.
        """
        tool = recording.tool
        if tool is not None:
            tool = np.where(np.isfinite(tool), tool, compensator.robot.tool)
        near, positions = None, recording.targets
        if positions is None:
            if not compensator.mechanism.many_ways:
                raise WrongFile(
                    "the file gives joints, not targets.",
                    "Give the columns x_mm, y_mm, z_mm and no joints.",
                    file=recording.path,
                )
            near = recording.joints
            positions, _ = Compensator(compensator.nominal).pose(near, tool)
            if np.isfinite(recording.measured).any():
                tell("readings of the file are not read: wanted is where the chain as drawn stands at its joints")
        return Wanted(positions, tool, near, {**columns, **recording.channels}, recording.pose.tolist())


def _finite(targets: object) -> Array:
    """Return targets as numbers; raise a UsageError where some are none, as a masked one is."""
    try:
        given: Any = np.ma.asarray(targets)
        if given.dtype.kind == "c":
            raise TypeError
        out: Array = given.astype(float).filled(np.nan)
    except (TypeError, ValueError):
        raise WrongArray(
            f"a {type(targets).__name__} of no real numbers holds no targets: give an array (N, 3) [mm]."
        ) from None
    if not np.isfinite(out).all():
        row = int(np.argwhere(~np.isfinite(out))[0, 0]) if out.ndim else 0
        raise WrongArray(f"target {row + 1} is not a finite number in every coordinate. Leave it out.")
    return out


@dataclass(frozen=True, eq=False)
class Commands:
    """Joints that bring a calibrated machine to where it is wanted.

    Attributes
    ----------
    joints : (N, n_q) array
        As the controller counts [rad or mm].
    at : Channels
        Of each command, completed by what is assumed.
    share : (N,) array or None
        Which part of a smooth correction they undo; None where there is none.
    """

    known: Result | Diagnosis
    compensator: Compensator
    wanted: Wanted
    joints: Array
    at: Channels
    share: Array | None

    @cached_property
    def in_files(self) -> Array:
        """The joints (N, n_q) in the units of files [deg or mm]."""
        mechanism = self.compensator.mechanism
        return np.asarray(self.joints / joint_factors(mechanism.joint_unit, mechanism.limbs))

    def table(self) -> Columns:
        """Return the columns of a file: it can be simulated, or measured, as it stands."""
        mechanism, wanted = self.compensator.mechanism, self.wanted
        table: Columns = {} if wanted.pose is None else {"pose": wanted.pose}
        table |= zip(joint_names(mechanism.joint_unit, mechanism.limbs), self.in_files.T, strict=True)
        if wanted.tool is not None:
            table |= {f"tool_{axis}_mm": values for axis, values in zip("xyz", wanted.tool.T, strict=True)}
        return table

    def bands(self) -> tuple[dict[str, Array], str]:
        """Return columns of the ends between which the machine will stand, and what they rest on in words."""
        from deltacal_gen.use.bands import commanded_bands, known_of

        wanted, known = self.wanted, self.known
        reached = wanted.positions
        if known.correction is None:
            reached = self.compensator.pose(self.joints, wanted.tool, self.at)[0]
        columns = commanded_bands(known, self.joints, reached[:, :3], wanted.tool, self.at, self.share)
        return columns, known_of(known).text


def commanded(known: Result | Diagnosis, compensator: Compensator, wanted: Wanted, tell: Progress) -> Commands:
    """Return the commands that bring a machine to its targets; `tell` is told what was assumed, and what is left."""
    at, assumed = compensator.channels(wanted.columns, len(wanted.positions))
    for words in assumed:
        tell(words)
    joints = compensator.joints(wanted.positions, wanted.tool, at, wanted.near)
    if (beyond := in_words(compensator.beyond_laws(joints, wanted.tool, at), "targets")) is not None:
        tell(beyond)
    if (left := _left_turned(compensator, wanted, joints, at)) is not None:
        tell(left)
    if wanted.near is None and wanted.tool is None and compensator.found_point is not None:
        tell(compensator.found_point)
    share: Array | None = None
    if (correction := known.correction) is not None:
        if kind_of(known.instrument.kind).positions:
            joints, share = prediction.corrected_joints(known, correction, joints, wanted.tool, wanted.columns)
            if (outside := share < 0.5).any():
                tell(f"{outside.sum()} of {len(share)} targets lie outside what the smooth correction was made of")
        else:
            tell("the smooth correction is not part of these commands: it was made of readings that know no position")
    return Commands(known, compensator, wanted, joints, at, share)


def _left_turned(compensator: Compensator, wanted: Wanted, joints: Array, at: Channels) -> str | None:
    """Return in words how many commands leave the last frame of a chain turned; None where none does."""
    mechanism, positions = compensator.mechanism, wanted.positions
    if not mechanism.many_ways or positions.shape[1] <= 3:
        return None
    turned = np.linalg.norm(compensator.missed(joints, positions, wanted.tool, at)[:, 3:], axis=1) / DEG
    off = turned > TURNED_DEG
    if not off.any():
        return None
    why = "it has fewer than six joints" if mechanism.limbs < 6 else "it is near singular there"
    return f"{off.sum()} of {len(off)} commands leave the last frame turned by up to {turned.max():.2g} deg: {why}"


def check_channels(channels: Mapping[str, Any], compensator: Compensator, known: Result | Diagnosis, n: int) -> None:
    """Raise a UsageError for the first channel that nothing could be, with the one that may be meant.

    Of n targets its values are what a file of targets may hold: numbers that can be, or blank.
    """
    covariates = {channel.column for t in compensator.terms for s in t.states for channel in s.channels}
    if known.correction is not None:
        covariates |= {*known.correction.depends_on}
    if isinstance(known, Diagnosis):  # what was recorded beside the readings is no mistake
        covariates |= known.residuals.channels.keys()
    for name, given in channels.items():
        if is_channel(name) or name in covariates:
            _check_values(name, given, n)
            continue
        near = nearest(name, USUAL)
        raise UnknownName(
            f"there is no channel '{name}'. " + (f"Did you mean '{near}'?" if near else f"Known: {', '.join(USUAL)}.")
        )


def _check_values(name: str, given: Any, n: int) -> None:
    """Raise a UsageError where a channel of n targets holds what no file of targets may."""
    try:
        values = np.broadcast_to(np.asarray(given, dtype=float), n)
    except (TypeError, ValueError):
        raise WrongArray(f"channel '{name}': a number, or {n} of them, one for each target, were expected.") from None
    if np.isinf(values).any():
        raise WrongArray(f"channel '{name}': a finite number was expected.")
    wrong, expected = impossible(name, values)
    if wrong.any():
        raise WrongArray(f"channel '{name}' holds {values[np.argmax(wrong)]:g}: {expected}.")

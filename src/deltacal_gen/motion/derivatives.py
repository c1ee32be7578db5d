"""Velocities and accelerations of recorded joints, without delay, and how much of the signal that takes away."""

from __future__ import annotations

import numpy as np

from deltacal_gen.errors import TooFewReadings
from deltacal_gen.motion.trajectories import Motion, Trajectories
from deltacal_gen.physics import splines
from deltacal_gen.physics.splines import Samples
from deltacal_gen.states import TIME
from deltacal_gen.units import of_joints

SLOWEST = 1.0  # s between samples of which derivatives are made: it is mostly a time in milliseconds


def motion(given: Trajectories, cutoff: float | None = None) -> Motion:
    """Return joints with their derivatives, where these are not known yet; `cutoff` [Hz] where it is.

    Raises
    ------
    InputError
        Samples lie so far apart that no motion is seen between them, or no movement has enough of them.
    """
    if given.moved is not None:
        return given.moved
    said = given.said.motion.derivatives
    if said == "recorded":
        states = np.stack([given.joints, *given.recorded])
        loose = np.zeros(len(given.time), dtype=bool)
        return Motion(
            states, np.zeros((2, states.shape[2])), loose, None, 0.0, "velocities and accelerations as recorded"
        )
    if given.step >= SLOWEST:
        raise TooFewReadings(
            f"samples lie {given.step:g} s apart: what joints do in between is not seen.",
            "Give time_s in seconds; or record speeds and accelerations and say so under [motion].",
            file=given.path,
            column=TIME,
        )
    base, order = (given.joints, 0) if said is None else (given.recorded[0], 1)
    samples, units = Samples(base, given.time, given.piece), of_joints(given.joint_unit, base.shape[1])
    if (longest := max(map(len, samples.pieces))) < splines.LEAST:
        raise TooFewReadings(
            f"no movement has more than {longest} samples without a gap: no derivative is made of so few.",
            "Give all samples of one uninterrupted movement the same run.",
            file=given.path,
            column=TIME,
        )
    spacing = splines.chosen_spacing(samples, 2 - order, units) if cutoff is None else 0.5 / cutoff
    fitted = splines.smooth(samples, spacing, 2 - order)
    states = fitted if order == 0 else np.stack([given.joints, *fitted])
    sigma = splines.noise(base, fitted[0], given.step, spacing)
    per = [splines.unit_noise(given.step, spacing, d) for d in ((1, 2) if order == 0 else (0, 1))]
    what = "joints" if order == 0 else "recorded velocities"
    loose, text = ~splines.inside(samples, splines.LOOSE * spacing), splines.what_was_done(what, spacing)
    cut = np.zeros_like(loose) if order else splines.cut(samples, fitted, spacing, units) & ~loose
    if 0 < cut.sum() <= (1.0 - splines.KEPT) * (~loose).sum():  # where most turns are cut, what is left is no recording
        loose |= cut
        text += f"; {cut.sum()} samples near turns that it cuts take no part"
    return Motion(
        states,
        np.outer(per, sigma),
        loose,
        0.5 / spacing,
        splines.removed(samples, fitted[0], units),
        text,
    )

"""What no effect explains, corrected without physics: a smooth displacement of joints or of the reading.

The displacement is a function of one variable that was recorded, a Gaussian process on few knots (subset of
regressors; Rasmussen and Williams 2006, section 8.3.1), fitted together with geometry, instrument and effects. The
variable, the length over which the function varies and its size are those of the largest evidence; held-out poses say
whether there is a correction at all. It holds where there were readings; beyond them the machine is as it is without.
"""

from __future__ import annotations

import dataclasses
import itertools
from collections.abc import Sequence, Set
from dataclasses import dataclass

import numpy as np

from deltacal_gen.diagnosis.structure import Structure, structures
from deltacal_gen.errors import InputError, NoSolutionError
from deltacal_gen.estimation.fit import fit
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.estimation.residuals import lengths, rms, robust_sigma, robust_weights
from deltacal_gen.estimation.solvers import Prior
from deltacal_gen.identification.folds import folds
from deltacal_gen.identification.functions import Function, Functions, Linear, Sized, confirmed
from deltacal_gen.identification.together import rows_alone
from deltacal_gen.inference.functions import bumps, farthest, gaps
from deltacal_gen.machine.registry import Array
from deltacal_gen.machine.values import Recording
from deltacal_gen.physics.body import Body
from deltacal_gen.results.diagnosis import SmoothState
from deltacal_gen.units import joint_factors, joint_names

CANDIDATES = 3  # structures that are tried, the strongest first
LENGTHS = (0.025, 0.05, 0.1, 0.2, 0.4)  # over which a function varies, parts of the diagonal of what was measured
KNOTS = 40  # so many as the shortest of them has in a row
STEPS = 1024  # over a function's range, at which its waves are looked at
JITTER = 1e-8  # of a knot's variance: knots that say nearly the same
POSITION = "position"


class Smooth(SmoothState):
    """A smooth function of a variable that displaces joints, or the platform along the axes of {O}.

    Attributes
    ----------
    variable : str
        A channel, a joint (`q1_deg`) or the `position` in {O}.
    limbs : tuple of int
        Limbs (from 1) whose joints it displaces; empty for the platform.
    knots : (K, d) array
        Values of the variable, in its own unit.
    length : float
        Over which the function varies, in the same unit.
    reach : float
        Within which of a knot everything lies that was measured.
    coefficients : (K, limbs or 3) array
        [rad, mm]
    """

    def displacement(self, values: Array) -> Array:
        """Return the displacement (N, limbs or 3) at values (N, d) of the variable [rad, mm]."""
        out: Array = np.nan_to_num(bumps(values, self.knots, self.length)) @ self.coefficients
        return out

    def share(self, values: Array) -> Array:
        """Return which part (N,) of the correction holds: 1 where there were readings, 0 far off or where blank."""
        gap = np.maximum(gaps(values, self.knots).min(axis=1) - self.reach * (1 + JITTER), 0.0)
        out: Array = np.where(np.isfinite(gap), np.exp(-0.5 * np.nan_to_num(gap / self.length) ** 2), 0.0)
        return np.where(out < 0.01, 0.0, out)

    def waves(self) -> tuple[float, tuple[float, ...]]:
        """Return the RMS [rad, mm] of a joint's function of one variable, and the lengths of the waves that carry most.

        Over the range of the knots, what goes straight through it taken off; lengths in the variable's unit, the
        strongest first, together half of the square.
        """
        v = np.linspace(self.knots.min(), self.knots.max(), STEPS)
        moved = self.displacement(v[:, None])[:, 0]
        moved = moved - np.polynomial.Polynomial.fit(v, moved, 1)(v)
        power = np.abs(np.fft.rfft(moved)[1:]) ** 2
        order = np.argsort(-power)
        most = 1 + int(np.searchsorted(np.cumsum(power[order]), 0.5 * power.sum()))
        return float(np.std(moved)), tuple(float(np.ptp(v) / (k + 1)) for k in order[:most])


@dataclass(frozen=True)
class Correction:
    """A smooth function, and geometry, effects and instrument as they are beside it.

    Attributes
    ----------
    fitted : Fit
        Geometry, effects and instrument.
    heldout : (float, float)
        RMS [mm] of readings that took part neither in the fit nor in its choices, without and with the correction.
    row_by_row : bool
        Whether these were held out without the rows around them, whose noise may hang together with theirs.
    size : float
        RMS [mm] by which it moves the readings beyond what geometry would make up for.
    each : tuple of float
        RMS [mm] by which each of the functions moves them alone.
    """

    smooth: tuple[Smooth, ...]
    fitted: Fit
    heldout: tuple[float, float]
    row_by_row: bool
    size: float
    each: tuple[float, ...]

    @property
    def moving(self) -> tuple[Smooth, ...]:
        """Functions that move something; the others only say where these hold."""
        return self.smooth[: len(self.each)]


def variable(name: str, recording: Recording, q: Array, x: Array) -> Array | None:
    """Return the values (N, d) of a variable of a recording, None if it has none.

    Parameters
    ----------
    q : (N, n_q) array
        Joints as the geometry counts them.
    x : (N, 12) array
        Poses.
    """
    if name == POSITION:
        return x[:, :3]
    if name in recording.channels:
        return recording.channels[name][:, None]
    names, unit = joint_names(recording.joint_unit, q.shape[1]), joint_factors(recording.joint_unit, q.shape[1])
    return dict(zip(names, (q / unit).T[:, :, None], strict=True)).get(name)


def displacement(functions: Sequence[Smooth], recording: Recording, q: Array, x: Array) -> tuple[Array, Array]:
    """Return by how much smooth functions move the joints (N, n_q) [rad, mm] and the platform (N, 3) [mm] of each row.

    `q` and `x` as in `variable`; what goes with a variable that a recording lacks is zero.
    """
    joints, shift = np.zeros_like(q), np.zeros((len(x), 3))
    for smooth in functions:
        if (values := variable(smooth.variable, recording, q, x)) is None:
            continue
        moved = smooth.displacement(values)
        if smooth.limbs:
            joints[:, [i - 1 for i in smooth.limbs]] += moved
        else:
            shift += moved
    return joints, shift


def holding(functions: Sequence[Smooth], recording: Recording, q: Array, x: Array) -> Array:
    """Return which part (N,) of smooth functions holds in each row: together they do where each of them does."""
    out = np.ones(len(x))
    for smooth in functions:
        values = variable(smooth.variable, recording, q, x)
        out = np.minimum(out, 0.0 if values is None else smooth.share(values))
    return out


@dataclass(frozen=True)
class BorneOut:
    """Smooth functions that held-out poses confirm.

    Attributes
    ----------
    at : Fit
        That they were chosen beside.
    without, corrected : (R, k) array
        Errors [mm, rad] of held-out readings; nan of gross errors.
    row_by_row : bool
        Whether neighbours, whose noise may be correlated with theirs, were not held out with them.
    """

    at: Fit
    linear: Linear
    option: _Option
    sized: Sized
    without: Array
    corrected: Array
    row_by_row: bool

    @property
    def heldout(self) -> tuple[float, float]:
        """RMS [mm] of held-out readings without the functions and with them."""
        kind = self.at.problem.readings.kind
        return rms(lengths(self.without, kind)), rms(lengths(self.corrected, kind))

    def of_all(self, whole: Fit) -> Correction | None:
        """Return the correction with geometry, effects and instrument fitted to all readings beside it."""
        linear, alone = self.linear, self.linear.alone
        step, every = linear.step(self.sized), np.ones(len(linear.residual), dtype=bool)
        functions = tuple(_moved(smooth, self.at, whole) for smooth in self.option.smooth(step[linear.n :]))
        try:
            fitted = fit(
                displaced(whole, functions, whole.problem),
                Prior(),
                errors=whole.errors,
                instrument=whole.instrument,
                must_converge=False,
                tolerance=0.1,
            )
        except (NoSolutionError, InputError):
            return None
        kind = whole.problem.readings.kind
        by_functions = linear.errors(alone, linear.step(alone), every) - linear.errors(self.sized, step, every)
        return Correction(
            smooth=functions,
            fitted=fitted,
            heldout=self.heldout,
            row_by_row=self.row_by_row,
            size=rms(lengths(by_functions, kind)),
            each=tuple(rms(lengths(moved, kind)) for moved in linear.moves(self.sized.functions, step, every)),
        )


def borne_out_beside(at: Fit, left: Sequence[Structure]) -> BorneOut | None:
    """Return the smooth functions of the largest evidence, None where held-out poses do not confirm them.

    Every part of the readings is predicted by what the others choose and fit, fading where they were not. Of readings
    that are correlated no more count than tell something of their own.

    Parameters
    ----------
    left : sequence of Structure
        What is left of the fit, the strongest first.
    """
    # along a path functions of the joints are correlated as noise is, which then stands for them
    if alike := at.repeats.rows > 1:
        at = rows_alone(at)
        left = structures(at)
    problem, found = at.problem, at.problem.readings
    parts, variables = folds(found, problem.recording), [s for s in left if s.earned > 0][:CANDIDATES]
    linear = Linear(at, parts)
    option, sized = _best(linear, _options(at, linear, variables))
    if option is None:
        return None
    # what is left out looked like gross errors where it is strongest
    r = linear.errors(sized, linear.step(sized), np.ones(len(found), dtype=bool))
    sigma = robust_sigma(r, np.zeros(found.kind.noises), True, found)
    linear = Linear(dataclasses.replace(at, weights=robust_weights(r, sigma, found.kind)), parts)
    option, sized = _best(linear, options := _options(at, linear, variables))
    if option is None:
        return None
    without = linear.held_out(linear.alone)
    corrected = without.copy()
    for k, (_, test) in enumerate(parts):
        own, chosen = _best(linear, options, {k})
        if own is not None:
            holds = holding((*own.blank, *own.there), problem.recording, problem.body.q, at.machine.x)
            moved = linear.errors(chosen, linear.step(chosen, {k}), test) - without[test]
            corrected[test] += holds[found.rows[test]].min(axis=1)[:, None] * moved
    made = BorneOut(at, linear, option, sized, without, corrected, alike)
    return made if confirmed(problem, without, corrected) else None


def _moved(smooth: Smooth, at: Fit, whole: Fit) -> Smooth:
    """Return a function of the position whose knots lie where another fit has their poses, others as they are.

    Where {O} stands few readings tell, and what fits leave open of it is not the same in all of them.
    """
    if smooth.variable != POSITION:
        return smooth
    rows = gaps(smooth.knots, at.machine.x[:, :3]).argmin(axis=1)
    lines = at.problem.recording.line[rows]
    there = np.argsort(whole.problem.recording.line, kind="stable")
    found = there[np.searchsorted(whole.problem.recording.line, lines, sorter=there)]
    return smooth.replace(knots=whole.machine.x[found, :3])


def displaced(at: Fit, functions: Sequence[Smooth], problem: Problem) -> Problem:
    """Return a problem whose joints and readings are moved by smooth functions as predictions move them."""
    body, x = problem.body, at.machine.x
    joints, shift = displacement(functions, problem.recording, body.q, x)
    share = holding(functions, problem.recording, body.q, x)[:, None]
    if joints.any():
        moved = Body(body.robot, body.mechanism, body.q + share * joints, body.tool, body.channels)
        problem = dataclasses.replace(problem, body=moved)
    if shift.any():
        instrument = at.instrument.mounted(problem.mechanism, at.errors)
        there, _ = instrument.predict(problem.readings, np.hstack([x[:, :3] + share * shift, x[:, 3:]]))
        here, _ = instrument.predict(problem.readings, x)
        readings = dataclasses.replace(problem.readings, values=problem.readings.values - (there - here))
        problem = dataclasses.replace(problem, readings=readings)
    return problem


@dataclass(frozen=True)
class _Option:
    """Smooth functions that act together, to choose from.

    Attributes
    ----------
    blank : tuple of Smooth
        The functions, zero.
    to_knots : tuple of (K, m) array
        Of each, by which its m coefficients at a place become those of its knots.
    there : tuple of Smooth
        That move nothing, and say where the others hold.
    """

    blank: tuple[Smooth, ...]
    to_knots: tuple[Array, ...]
    there: tuple[Smooth, ...]
    functions: Functions
    D: Array

    def smooth(self, c: Array) -> tuple[Smooth, ...]:
        """Return the functions with coefficients [rad, mm]."""
        each = zip(self.blank, self.to_knots, self.functions.parted(c), strict=True)
        made = [f.replace(coefficients=to @ own.reshape(to.shape[1], -1)) for f, to, own in each]
        return (*made, *self.there)


def _best(linear: Linear, options: Sequence[_Option], without: Set[int] = frozenset()) -> tuple[_Option | None, Sized]:
    """Return the option of the largest evidence in all parts but some, with its size; None where none has more."""
    tried: list[tuple[_Option | None, Sized]] = [(o, linear.sized(o.functions, o.D, without)) for o in options]
    alone = linear.sized(linear.alone.functions, linear.alone.D, without)
    return max([(None, alone), *tried], key=lambda found: found[1].evidence)


def _options(at: Fit, linear: Linear, found: Sequence[Structure]) -> list[_Option]:
    """Return what there is to choose from: a function of a structure's variable, or one of every joint."""
    limbs, sees_joints = at.problem.mechanism.limbs, at.problem.readings.kind.sees_joints
    names = joint_names(at.problem.recording.joint_unit, limbs)
    own: list[tuple[str, tuple[int, ...]]] = [(name, (j + 1,)) for j, name in enumerate(names)]
    sets = [own, *([(s.channel, s.limbs)] for s in found if s.limbs or not sees_joints)]
    out = []
    for wanted, length in itertools.product(sets, LENGTHS):
        blank = tuple(like for name, on in wanted if (like := _like(at, name, on, length)) is not None)
        if not blank:
            continue
        to_knots, each = zip(*(_function(at, like, limbs) for like in blank), strict=True)
        # along one path a function of any joint is one of all others: it holds where the path was
        there = _like(at, POSITION, (), length) if wanted is own and not sees_joints else None
        functions = linear.functions(each)
        out.append(_Option(blank, to_knots, () if there is None else (there,), functions, linear.units(functions)))
    return out


def _like(at: Fit, name: str, limbs: tuple[int, ...], length: float) -> Smooth | None:
    """Return a function of a variable at joints or in the reading, that is zero; None where nothing varies."""
    used = np.unique(at.problem.readings.rows)
    values = variable(name, at.problem.recording, at.problem.body.q, at.machine.x)
    if values is None or not (known := values[used][np.isfinite(values[used]).all(axis=1)]).size:
        return None
    span = float(np.linalg.norm(np.ptp(known, axis=0)))
    if span == 0:
        return None
    knots = known[farthest(known, KNOTS)]
    return Smooth(
        variable=name,
        limbs=limbs,
        knots=knots,
        length=length * span,
        reach=float(gaps(known, knots).min(axis=1).max()),
        coefficients=np.zeros((len(knots), len(limbs) or 3)),
    )


def _function(at: Fit, like: Smooth, limbs: int) -> tuple[Array, Function]:
    """Return a smooth function as combinations of functions of variance 1, and how these become its knots'."""
    values = variable(like.variable, at.problem.recording, at.problem.body.q, at.machine.x)
    assert values is not None  # the function has knots of them
    U, s, _ = np.linalg.svd(bumps(like.knots, like.knots, like.length), hermitian=True)
    keep = s > JITTER * s[0]
    to_knots = U[:, keep] / np.sqrt(s[keep])
    places = tuple(i - 1 for i in like.limbs) or tuple(range(limbs, limbs + 3))
    return to_knots, Function(np.nan_to_num(bumps(values, like.knots, like.length)) @ to_knots, places)

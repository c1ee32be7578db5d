"""The noise of readings, where it is known from, and whether a fit leaves more than it."""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass

import numpy as np

from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.residuals import lengths
from deltacal_gen.identification.repeats import ENOUGH, of_one_point, repeats, within_poses
from deltacal_gen.identification.rounding import rounding_of
from deltacal_gen.identification.tails import NO_TAILS, Tails, tails_of
from deltacal_gen.machine.registry import Array
from deltacal_gen.machine.values import Recording
from deltacal_gen.results.parts import NoiseModel, Source

PROVEN = 4.0  # standard deviations by which one noise must exceed another to be called larger
CHANCE = 3e-5  # of a noise that is exceeded so, likewise
MISTAKEN = 3.0  # times by which a declared noise, from a data sheet or another day, may well be wrong
LEAST_EXCESS = 1.15  # of chi2 per degree of freedom: a sidecar's sigma has a digit or two


# ----------------------------------------------------------------------------------------------- what is pinned


def coordinate_sigma(found: Fit) -> float:
    """Return the noise that a fit leaves per measured scalar [mm]; a distance made of positions holds that of two.

    Where it hangs together over more rows than a set-up has, it is what of it these rows show.
    """
    series = found.repeats.series
    shown = 1.0 if series is None else float(np.sqrt(series.within))
    return shown * float(found.sigma[0]) / (np.sqrt(2.0) if found.problem.readings.made else 1.0)


@dataclass(frozen=True)
class Noise:
    """Noise per measured scalar [mm], where it is known from, and the degrees of freedom of that knowledge.

    `repeated` says that repeats bear it out, `refuted` is a declared noise that they contradict, or what a fit leaves
    [mm]; `rounded` says that joints or readings were rounded, where the noise holds that. `sigma` is what fits count
    with; where it is what one leaves, `told` is the standard deviation of noise with such tails.
    """

    sigma: float
    source: Source
    degrees: float
    repeated: bool = False
    refuted: float | None = None
    rounded: str = ""
    tails: Tails = NO_TAILS

    @property
    def told(self) -> float:
        """Standard deviation of a reading [mm]."""
        return self.sigma * self.tails.spread if self.source is Source.RESIDUAL else self.sigma

    @property
    def contradiction(self) -> str:
        """What is wrong with a declared noise, in a sentence; empty where nothing is."""
        if self.refuted is None:
            return ""
        times, word = self.sigma / self.refuted, "small"
        if times < 1:
            times, word = 1 / times, "large"
        shows = (
            "repeats of a pose differ by"
            if self.source is Source.REPEATS
            else "what is left depends on nothing that was recorded, and scatters by"
        )
        return (
            f"The declared sigma_mm of {self.refuted:.3g} is {times:.1f} times too {word}: {shows} {self.sigma:.3g} mm."
        )


def noise(final: Fit, recording: Recording) -> Noise:
    """Return the noise, from the sidecar, from repeats, or from what the fit leaves.

    A declared sigma holds unless repeats
    contradict it: clearly smaller ones do; clearly larger ones do unless the closest of them agree with it, since what
    happens between two readings of a pose adds to the spread of some and not of others. Rounding is added where a fit
    leaves as much more as it comes to.
    """
    known = _known(final, recording)
    if known.source is Source.RESIDUAL or not _more(final, known):
        return known
    wider = _with_rounding(known, final)
    excess, doubt = _excess(final, wider)
    return wider if wider.rounded and abs(excess) < doubt else known


def _with_rounding(known: Noise, final: Fit) -> Noise:
    """Return a noise with what rounding comes to; of readings repeats show it, but where steps are coarser than noise.

    Repeats that are rounded to the same value show none of it.
    """
    steps = rounding_of(final)
    shown = 0.0 if known.source is Source.DECLARED else known.sigma
    unseen = float(np.sqrt(max(steps.of_readings**2 - shown**2, 0.0)))
    sigma = float(np.hypot(known.sigma, np.hypot(steps.of_joints, unseen)))
    return dataclasses.replace(known, sigma=sigma, rounded=steps.text)


def doubted(known: Noise, final: Fit) -> Noise:
    """Return noise as a fit shows it, where that is noise, but more than was declared, or less."""
    if known.source is not Source.DECLARED or known.repeated:
        return known
    excess, doubt = _excess(final, known)
    if abs(excess) <= max(doubt, np.log(LEAST_EXCESS)):
        return known
    return Noise(coordinate_sigma(final), Source.RESIDUAL, np.inf, refuted=known.sigma)


def with_tails(known: Noise, final: Fit) -> Noise:
    """Return noise with the tails that a fit leaves, which then is nothing but noise."""
    return dataclasses.replace(known, tails=tails_of(final))


def stated(final: Fit, recording: Recording, *, explained: bool) -> Noise:
    """Return the noise as a diagnosis states it: where all is explained, what is left may refute what was declared."""
    known = noise(final, recording)
    return with_tails(doubted(known, final), final) if explained else known


def _known(final: Fit, recording: Recording) -> Noise:
    """Return what `noise` does, rounding left out."""
    found, residual = final.problem.readings, coordinate_sigma(final)
    declared = found.kind.sigma(recording.measurement, final.instrument.scale)
    if found.made:
        return (
            Noise(residual, Source.RESIDUAL, np.inf) if declared is None else Noise(declared, Source.DECLARED, np.inf)
        )
    shown = repeats(final, recording)
    within, degrees = shown.variance, shown.degrees
    repeated = degrees >= ENOUGH and within > 0
    if declared is not None:
        doubt = PROVEN * np.sqrt(_spread(shown.rows) / max(degrees, 1))
        gap = np.log(within / declared**2) if repeated else 0.0
        between = np.sqrt(declared * np.sqrt(within))  # nearer to what was declared than to what repeats say
        if abs(gap) <= doubt or (gap > 0 and shown.closest < between):
            return Noise(declared, Source.DECLARED, np.inf, repeated=repeated)
    if repeated:
        return Noise(float(np.sqrt(within)), Source.REPEATS, float(degrees), repeated=True, refuted=declared)
    return Noise(residual, Source.RESIDUAL, np.inf)


def noise_model(final: Fit, known: Noise) -> NoiseModel:
    """Return how the noise of rows hangs together that a fit counts with, and whether rounding is in it."""
    series, shape = final.repeats.series, final.repeats.shape
    words, rho, rows, own = "each row has noise of its own", 0.0, 1.0, 1.0
    if series is not None:
        words, rho, rows, own = series.text, series.rho, series.rows, series.own
    following = final.problem.readings.following
    words += f"; {following} distances more follow from those that count and tell nothing new" if following else ""
    columns = None if shape is None else tuple(np.sqrt(np.diag(shape)).tolist())
    words += "" if shape is None else f"; {_directed(shape)}"
    words += "".join(f"; {said}" for said in (str(known.tails), known.rounded) if said)
    return NoiseModel(
        rho=rho,
        rows=rows,
        own=own,
        columns=columns,
        tails=known.tails.shape,
        degrees=known.tails.degrees,
        text=words,
    )


def _directed(shape: Array) -> str:
    """Return along which axis of its frame an instrument is least sure, and how much surer along another."""
    variances, axes = np.linalg.eigh(shape)
    least, most = axes[:, 0], axes[:, -1]
    along, across = ("({})".format(", ".join(f"{v:.1f}" for v in _upright(axis))) for axis in (most, least))
    return f"along {along} of what is read it is {np.sqrt(variances[-1] / variances[0]):.1f} times that along {across}"


def _upright(axis: Array) -> Array:
    """Return an axis with its largest component positive, none of them -0."""
    turned: Array = axis * np.sign(axis[np.argmax(np.abs(axis))])
    return np.round(turned, 1) + 0.0


def _spread(r: Array) -> float:
    """Return the variance of squares in units of the variance's square: 2 where noise is normal, more in its tails."""
    squares = r[np.isfinite(r)] ** 2
    mean = float(np.mean(squares)) + 1e-300
    return max(float(np.mean(squares**2)) / mean**2, 3.0) - 1


def lack_of_fit(final: Fit, recording: Recording) -> bool:
    """Tell whether what a fit leaves is more than a noise known beforehand, or shown within poses."""
    known = noise(final, recording)
    more = known.source is not Source.RESIDUAL and _more(final, known)
    return more or alike_at_a_pose(final, recording)


def merely_more(final: Fit, recording: Recording) -> bool:
    """Tell whether what a fit leaves is more than was declared, but not so much that the declaration cannot be wrong.

    Repeats do not err so: what they do not show is no noise.
    """
    known = noise(final, recording)
    declared = known.source is Source.DECLARED and not known.repeated
    return declared and coordinate_sigma(final) < MISTAKEN * known.sigma


def _more(final: Fit, known: Noise) -> bool:
    excess, doubt = _excess(final, known)
    return excess > max(doubt, np.log(LEAST_EXCESS))


def alike_at_a_pose(final: Fit, recording: Recording) -> bool:
    """Tell whether what readings of one pose share is proven, and more than the noise that they show.

    Among many readings of few poses it hardly adds to what all of them leave: means of poses tell (lack of fit against
    pure error). As much again as the noise is demanded, since what happens between two visits of a pose is in neither;
    what rounding of joints or readings comes to is shared by repeats as well, and no lack. Where repeats are too few to
    tell the noise, or channels differed among them, it is no more than all that differs within a pose.
    """
    known, shown = _known(final, recording), repeats(final, recording)
    if known.source is Source.RESIDUAL:
        shown = within_poses(final)
        known = Noise(float(np.sqrt(shown.variance)), Source.REPEATS, float(shown.degrees), repeated=True)
    if known.source is not Source.REPEATS or final.repeats.series is not None or not shown.variance:
        return False
    from scipy.special import fdtrc

    found = final.problem.readings
    r = np.delete(lengths(final.residual, found.kind), final.gross, axis=0)
    group = np.unique(np.delete(of_one_point(found), final.gross), return_inverse=True)[1]
    count = np.bincount(group)
    sums = np.zeros((len(count), r.shape[1]))
    np.add.at(sums, group, np.nan_to_num(r))
    free = sums.size - final.solution.degrees - final.instrument.n_unknown
    if free < 1:
        return False
    ratio = float((sums**2 / count[:, None]).sum()) / free / shown.variance
    each = float(np.mean(count))
    if ratio - 1 <= each or fdtrc(free, shown.degrees, ratio) >= CHANCE:
        return False
    wider = _with_rounding(known, final)
    ratio /= 1 + each * (wider.sigma**2 / shown.variance - 1)
    chance = float(fdtrc(free, shown.degrees, ratio))
    return not (wider.rounded and CHANCE < chance < 1 - CHANCE)


def _excess(final: Fit, known: Noise) -> tuple[float, float]:
    """Return by which logarithm the variance that a fit leaves exceeds a known one, and how far it may by chance.

    Where noise hangs together the fit has taken much of it: the rows are looked at freed of what others tell.
    """
    problem, series = final.problem, final.repeats.series
    z = np.delete(final.repeats.freed(final.residual / final.sigma), final.gross, axis=1)
    ways, r = len(z), lengths(z.reshape(-1, z.shape[2]), problem.readings.kind) * final.sigma[0]
    r = r[np.isfinite(r)] / (np.sqrt(2.0) if problem.readings.made else 1.0)
    free = max(len(r) / ways - final.solution.degrees - final.instrument.n_unknown, 1.0)
    seen = free / (1.0 if series is None else series.rows_of_size)
    excess = float(np.log(float(r @ r) / ways / free / known.sigma**2))
    return excess, float(PROVEN * np.sqrt(_spread(r) * (1 / seen + 1 / known.degrees)))


def freedom(final: Fit) -> float:
    """Return how many scalar readings a fit leaves to judge it by: all, less what the data determine."""
    return float(final.problem.readings.n_scalars - final.solution.degrees - final.instrument.n_unknown)

"""Whether fits arrive: ``python -m tests.benchmarks.arrival [--problems N] [--seed S] [--starts K]``.

Each of the random problems of `arrival_problems` is fitted and compared with the lowest that SciPy's trust region
reaches from several starts, of the same rows weighed alike: what the fit leaves must not be more than 0.1 of chi2 above
it. Problems are done as `sitting` says; a seed that is not given is that of the file of ``--kept``, or drawn. With
``--recordings FOLDER ...`` the fits of real recordings are compared instead.
"""

from __future__ import annotations

import argparse
import json
import secrets
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np
from scipy.optimize import least_squares

import deltacal_gen as dc
from deltacal_gen.errors import DeltacalError
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.system import whitened
from deltacal_gen.identification.identification import identify
from deltacal_gen.instrument.kind import Instrument
from deltacal_gen.machine.registry import Array, mechanism_of
from deltacal_gen.physics.deformed import Deformed
from tests.benchmarks.arrival_problems import drawn
from tests.benchmarks.sitting import add_options, kept, sit, wilson

ABOVE = 0.1  # of chi2: what a fit may leave above the lowest that was found
EVALUATIONS = 100  # of a start
SMALL = 1e-6  # increment of the instrument's unknowns for a derivative [mm, rad]
ENOUGH_S = 15.0  # of CPU for the starts of one problem, beyond which no further one is begun: soft arms are slow
FAR = 1e3  # standard deviations by which every row is off where no machine stands


class Objective:
    """The sum of squares that a fit has minimised, its noise and weights as they ended, for another optimiser."""

    def __init__(self, found: Fit) -> None:
        self._fit, self._problem = found, found.problem
        self.n, self._m = len(found.problem.scale), int(np.isfinite(found.residual).sum())
        self._base: Instrument = found.instrument
        self._last: tuple[Array, Deformed | None] = (np.zeros(0), None)

    def white(self, values: Array) -> Array:
        """Return rows (R, k, ...) as the fit weighed them, those read of them."""
        at = self._fit
        return whitened(values, np.isfinite(at.residual), at.sigma, at.weights, at.repeats)

    def begin(self, errors: Array, instrument: Instrument | None) -> Array:
        """Return the unknowns where a start stands; raise an InputError where no machine does."""
        self._base = self._problem.begin(errors) if instrument is None else instrument
        self._last = (np.zeros(0), None)
        u = (errors[self._problem.columns] - self._problem.reference[self._problem.columns]) / self._problem.scale
        return np.concatenate([u, np.zeros(self._base.n_unknown)])

    def _at(self, z: Array) -> tuple[Array, Instrument, Deformed]:
        errors = self._problem.reference.copy()
        errors[self._problem.columns] += self._problem.scale * z[: self.n]
        if self._last[1] is None or not np.array_equal(self._last[0], z):
            self._last = (z.copy(), self._problem.solve(errors))
        machine = self._last[1]
        assert machine is not None
        return errors, self._base.stepped(z[self.n :]), machine

    def rows(self, z: Array) -> Array:
        """Return the rows and the priors' (m + n,)."""
        try:
            errors, instrument, machine = self._at(z)
        except DeltacalError:
            return np.full(self._m + self.n, FAR)
        r = self._problem.residual(errors, instrument, self._problem.seen(machine))
        return np.concatenate([self.white(r), z[: self.n]])

    def jacobian(self, z: Array) -> Array:
        """Return the derivatives (m + n, unknowns): by parameters exact, by the instrument's unknowns differences."""
        errors, instrument, machine = self._at(z)
        J_p = self._problem.linearise(errors, instrument, machine).J_p
        if self._problem.gives_way:
            J_p = J_p + self._problem.followed(errors, instrument, machine)
        J_p = J_p * self._problem.scale
        out = np.zeros((self._m + self.n, len(z)))
        out[: self._m, : self.n], out[self._m :, : self.n] = -self.white(J_p), np.eye(self.n)
        x = self._problem.seen(machine)
        for k, unit in enumerate(SMALL * np.eye(len(z))[self.n :, self.n :], start=self.n):
            ends = (self._base.stepped(z[self.n :] + side) for side in (unit, -unit))
            high, low = (self.white(self._problem.residual(errors, own, x)) for own in ends)
            out[: self._m, k] = (high - low) / (2 * SMALL)
        return out


def chi2(found: Fit) -> float:
    """Return the objective where a fit ended."""
    objective = Objective(found)
    return float((objective.rows(objective.begin(found.errors, found.instrument)) ** 2).sum())


def lowest(found: Fit, starts: int, rng: np.random.Generator) -> float:
    """Return the lowest objective that another optimiser finds, from the fit's end and from starts at random."""
    problem, objective, best = found.problem, Objective(found), np.inf
    until = time.process_time() + ENOUGH_S
    for k in range(starts):
        if k > 1 and time.process_time() > until:
            break
        errors = problem.reference.copy()
        off = problem.scale * rng.standard_normal(len(problem.scale)) * rng.choice([0.01, 0.1])
        errors[problem.columns] += 0.0 if k == 1 else off
        try:
            first = objective.begin(*((found.errors, found.instrument) if k == 0 else (errors, None)))
            ended = least_squares(
                objective.rows, first, objective.jacobian, x_scale="jac", method="trf", max_nfev=EVALUATIONS
            )
        except (DeltacalError, ValueError):
            continue  # no machine stands at the start
        best = min(best, 2 * float(ended.cost))
    return best


def examine(job: tuple[int, int, int]) -> dict[str, Any]:
    """Return what came of a problem; see `compared`."""
    return compared(*job)


def compared(seed: int, number: int, starts: int) -> dict[str, Any]:
    """Fit a random problem and return what it and the other optimiser leave, and the time of the fit."""
    word, fitted = drawn(seed, number)
    line: dict[str, Any] = {"number": number, "word": word}
    began = time.process_time()
    try:
        found = fitted()
    except DeltacalError as error:
        return line | {"error": str(error)}
    line["ms"] = round(1e3 * (time.process_time() - began), 1)
    line["iterations"], line["promised"] = len(found.history), found.history[-1]
    rng = np.random.default_rng([seed, number, 1])
    return line | {"own": chi2(found), "other": lowest(found, starts, rng)}


def missed(line: dict[str, Any]) -> bool:
    """Tell whether a fit did not arrive."""
    return "error" in line or not line["own"] <= line["other"] + ABOVE


def real(folders: list[Path], starts: int) -> int:
    """Print what the fit of each recording leaves, and how much lower another optimiser gets."""
    worst = 0.0
    for folder in folders:
        robot = dc.read_robot(folder / "robot.toml")
        try:
            found = identify(robot, dc.read_recording(folder / "recording.csv", mechanism_of(robot))).fit
        except DeltacalError as error:
            print(f"{folder.name}: {error}", flush=True)
            continue
        own, other = chi2(found), lowest(found, starts, np.random.default_rng(0))
        worst = max(worst, own - other)
        print(f"{folder.name}: {own:.3f}, lower by {own - other:.4f}; promised {found.history[-1]:.1e}", flush=True)
    return int(worst > 1.0)


def main(arguments: list[str] | None = None) -> int:
    """Fit problems and compare; return 1 where too many fits do not arrive."""
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.arrival", description=__doc__.split("\n")[0])
    parser.add_argument("--problems", type=int, default=2000)
    parser.add_argument("--seed", type=int)
    parser.add_argument("--starts", type=int, default=20)
    parser.add_argument("--recordings", nargs="+", type=Path)
    add_options(parser)
    given = parser.parse_args(arguments)
    if given.recordings:
        return real(given.recordings, given.starts)
    seed = given.seed
    if seed is None:
        seed = next((job[0] for job in kept(given.kept)[0]), secrets.randbelow(2**32))
    jobs = [(seed, number, given.starts) for number in range(given.problems)]
    found = sit(examine, jobs, given, lambda line: json.dumps(line) if missed(line) else "")
    lines = list(found.done.values())
    away = list(filter(missed, lines))
    for line in away:
        print(json.dumps(line))
    spent = np.median([line["ms"] for line in lines if "ms" in line] or [np.nan])
    low, high = wilson(len(away), len(lines))
    print(
        f"seed {seed}: {len(away)} of {len(lines)} did not arrive ({low:.2%} to {high:.2%}); "
        f"half of the fits below {spent:.0f} ms"
    )
    return found.code or int(len(away) > len(lines) // 1000)


if __name__ == "__main__":
    sys.exit(main())

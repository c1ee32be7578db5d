"""What a diagnosis of a real machine is worth: on the other half of a recording, and on another series.

    python -m tests.benchmarks.real halves FOLDER [FOLDER ...] [--halves 10] [--seed 7]
    python -m tests.benchmarks.real carry FOLDER FOLDER [FOLDER ...]
    python -m tests.benchmarks.real blocks FOLDER [FOLDER ...] [--rows 200]

A folder holds ``robot.toml`` and ``recording.csv``. `halves`: one half of the poses, drawn at random, is calibrated and
diagnosed, the other predicted by both. `carry`: every folder is diagnosed; the even rows of every other one are
identified with that physics held and without, its odd rows predicted by both, and the other way round. Errors are mean
lengths in the unit of the readings; both know of the predicted rows nothing but joints and channels. Of three folders
and more all others together, each a set-up of its own in one recording, are carried to each one, too. `blocks`: what
all rows name is fitted again to each block of rows: how far sizes scatter, by what standard deviations say of it. What
there is to do is done as `sitting` says.
"""

from __future__ import annotations

import argparse
import itertools
import sys
import tempfile
import time
from collections.abc import Iterable, Sequence
from pathlib import Path

import numpy as np

import deltacal_gen as dc
from deltacal_gen.diagnosis.answer import Diagnosed
from deltacal_gen.diagnosis.diagnosis import MACHINED, diagnose
from deltacal_gen.diagnosis.refits import form, refitted, std_of, terms_of
from deltacal_gen.estimation.fit import CONVERGED
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.prior import with_prior
from deltacal_gen.estimation.problem import pose_problem
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.machine.values import Recording, Robot
from deltacal_gen.physics.terms import Term, row_coefficients
from tests.benchmarks.arm import together
from tests.benchmarks.sitting import Entry, add_options, sit

Job = tuple[str, tuple[str, ...], tuple[str, ...], tuple[int, ...]]  # what, folders, folders carried to, numbers


def given(folder: Path) -> tuple[Robot, Recording]:
    robot = dc.read_robot(folder / "robot.toml")
    return robot, dc.read_recording(folder / "recording.csv", mechanism_of(robot))


def error(known: dc.Result | dc.Diagnosis, asked: Recording) -> float:
    """Return the mean length of the errors of predicted readings, of lengths alone where there are rotations."""
    off = (dc.predict(known, asked).measured - asked.measured)[:, :3]
    read = np.isfinite(off).any(axis=1)
    return float(np.mean(np.linalg.norm(np.nan_to_num(off[read]), axis=1)))


def examine(job: Job) -> Entry:
    """Return what came of a job."""
    what, sources, targets, numbers = job
    if what == "halves":
        return half(Path(sources[0]), *numbers)
    if what == "blocks":
        return blocks(Path(sources[0]), *numbers)
    return {"carried": carried(list(map(Path, sources)), list(map(Path, targets)))}


def half(folder: Path, k: int, seed: int) -> Entry:
    """Return what geometry and a diagnosis of one half predict of the other."""
    robot, recording = given(folder)
    poses = np.unique(recording.pose)
    np.random.default_rng([seed, k]).shuffle(poses)
    first = np.isin(recording.pose, poses[: len(poses) // 2])
    train, test = (recording.subset(np.flatnonzero(part)) for part in (first, ~first))
    began = time.process_time()
    found = dc.diagnose(robot, train)
    spent = time.process_time() - began
    errors = [error(dc.identify(robot, train), test), error(found, test)]
    named = ", ".join(f"{e.name} {list(e.limbs)}" for e in found.effects) or "nothing"
    smooth = " and a smooth correction" if found.correction is not None else ""
    text = (
        f"{folder.name} half {k}: geometry {errors[0]:.4f}, diagnosed {errors[1]:.4f}; {found.verdict.value}: "
        f"{named}{smooth}; {spent:.0f} s of CPU"
    )
    return {"errors": errors, "text": text}


def carried(sources: Sequence[Path], targets: Sequence[Path]) -> list[list[float | str]]:
    """Return what a diagnosis of one series, or of several together, is worth on either half of the rows of others."""
    with tempfile.TemporaryDirectory() as place:
        found = dc.diagnose(*given(sources[0] if len(sources) == 1 else together(list(sources), Path(place))))
    name, out = " and ".join(folder.name for folder in sources), list[list[float | str]]()
    for target in targets:
        robot, recording = given(target)
        parts = [recording.subset(np.arange(k, recording.n_rows, 2)) for k in (0, 1)]
        for train, test in (parts, parts[::-1]):
            held = error(dc.identify(robot, train, physics=found), test)
            out.append([f"{name} to {target.name}", error(dc.identify(robot, train), test), held])
    return out


# --------------------------------------------------------------------------------------------------------------- blocks


def blocks(folder: Path, rows: int) -> Entry:
    """Return the sizes of all that is named, and their standard deviations, of all rows and of each block of them."""
    robot, recording = given(folder)
    found = diagnose(robot, recording)
    starts = range(0, recording.n_rows - rows + 1, rows)
    fits = [again(found, recording.subset(np.arange(start, start + rows))) for start in starts]
    sizes = []
    for i, term in enumerate(terms_of(found.final)):
        own = [(at, j) for at in fits if at for j, t in enumerate(terms_of(at)) if form(t) == form(term)]
        for n, (words, factor) in enumerate(told_as(term, recording.joint_unit)):
            every = [(terms_of(at)[j].values.ravel()[n] / factor, std_of(at, j)[n] / factor) for at, j in own]
            whole = term.values.ravel()[n] / factor, std_of(found.final, i)[n] / factor
            sizes.append({"name": words, "whole": whole, "blocks": every})
    return {"blocks": len(fits), "sizes": sizes}


def told_as(term: Term, joint_unit: str) -> list[tuple[str, float]]:
    """Return of each coefficient of an effect what it is called, and the factor of its unit."""
    out = []
    for row, names in enumerate(row_coefficients(term, joint_unit)):
        limb = f" {term.limbs[row]}" if term.limbs else ""
        named = [(f"{term.effect}{limb}, {key} [{unit}]", factor) for key, unit, factor in names]
        beyond = term.values.shape[1] - len(named)  # warming of sessions whose temperature nobody recorded
        out += named + [(f"{term.effect}{limb}, of a session", 1.0)] * beyond
    return out


def again(found: Diagnosed, part: Recording) -> Fit | None:
    """Return the fit of geometry, instrument and all that was named to other readings; None where there is none."""
    problem = with_prior(pose_problem(found.robot, part, found.final.problem.names), found.robot, MACHINED)[0]
    return refitted(problem, found.final, terms_of(found.final), tolerance=CONVERGED)


def scatter(folder: str, entry: Entry) -> Iterable[str]:
    """Return in words how far sizes scatter from block to block, by what is said of it."""
    from scipy.stats import chi2

    yield f"{folder}: {entry['blocks']} blocks"
    for size in entry["sizes"]:
        value, std = size["whole"]
        text = f"  {size['name']}: {value:.4g} +- {std:.2g} of all rows"
        if (n := len(size["blocks"])) > 1:
            values, stds = np.array(size["blocks"]).T
            said = float(np.sqrt(np.mean(stds**2)))
            times = float(np.std(values, ddof=1)) / said
            low, high = (times * np.sqrt((n - 1) / chi2.isf(p, n - 1)) for p in (0.025, 0.975))
            text += f"; {n} blocks scatter by {times:.2f} times ({low:.2f} to {high:.2f}) the {said:.2g} that is told"
        yield text


# ----------------------------------------------------------------------------------------------------------------- runs


def jobs(said: argparse.Namespace) -> list[Job]:
    """Return what there is to do."""
    names = tuple(map(str, said.folders))
    if said.what == "halves":
        return [("halves", (name,), (), (k, said.seed)) for name in names for k in range(said.halves)]
    if said.what == "blocks":
        return [("blocks", (name,), (), (said.rows,)) for name in names]
    one = [((source,), tuple(n for n in names if n != source)) for source in names]
    several = [(tuple(n for n in names if n != target), (target,)) for target in names if len(names) > 2]
    return [("carry", sources, targets, ()) for sources, targets in one + several]


def told(what: str, done: dict[Job, Entry]) -> Iterable[str]:
    """Return what all jobs together say."""
    for folder, own in itertools.groupby(done.items(), key=lambda pair: pair[0][1]):
        entries = [entry for _, entry in own]
        if what == "blocks":
            yield from scatter(Path(folder[0]).name, entries[0])
        for words, alone, held in (line for entry in entries for line in entry.get("carried", ())):
            yield f"{words}: {alone:.4f} to {held:.4f}, ratio {held / alone:.3f}"
        if what == "halves":
            before, after = np.mean([entry["errors"] for entry in entries], axis=0)
            name = Path(folder[0]).name
            yield f"{name}, mean of {len(entries)} halves: geometry {before:.4f}, diagnosed {after:.4f}"


def main(arguments: list[str] | None = None) -> int:
    """Do what is asked, and print what it says."""
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.real", description=__doc__.partition("\n")[0])
    parser.add_argument("what", choices=("halves", "carry", "blocks"))
    parser.add_argument("folders", nargs="+", type=Path)
    parser.add_argument("--halves", type=int, default=10)
    parser.add_argument("--seed", type=int, default=7)
    parser.add_argument("--rows", type=int, default=200, help="of a block (default 200)")
    add_options(parser)
    said = parser.parse_args(arguments)
    found = sit(examine, jobs(said), said, lambda entry: entry.get("text", ""))
    for line in told(said.what, found.done):
        print(line, flush=True)
    return found.code


if __name__ == "__main__":
    sys.exit(main())

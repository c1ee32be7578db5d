"""How cost grows: ``python -m tests.benchmarks.scaling [-o scaling.png] [--most 1000000]``.

Time per pose against the number of poses, time of a linearisation against the number of effects, and the gain of a
second thread: compiled kernels hold no lock of the interpreter, so that threads share the poses among them.
"""

from __future__ import annotations

import argparse
import os
import sys
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path

import numpy as np

from deltacal_gen import PoseSet
from deltacal_gen.estimation.problem import pose_problem
from deltacal_gen.identification.accuracy import check_poses
from deltacal_gen.machine.backend import Backend, using
from deltacal_gen.pages import manual
from deltacal_gen.physics.terms import blank
from tests.benchmarks import by_hand
from tests.benchmarks.contenders import DELTA, POSES, ROBOT, SIGMA, errors, measured, positions, recorded, rings
from tests.benchmarks.works import identified

EFFECT = "joint_scale"  # one coefficient for each joint


def kernels(n: int) -> dict[str, Callable[[slice], None]]:
    """Return W3 and W5 of n poses: what computes a part of them into arrays of its own."""
    theta = np.ascontiguousarray(by_hand.ideal_inverse(positions(n)))
    exact, ideal = (DELTA.compiled.constants(DELTA.rows(ROBOT, p)) for p in (errors(), np.zeros(42)))
    tool, x, status = np.zeros((1, 3)), np.empty((n, 6)), np.empty(n, dtype=np.int64)
    r = np.empty((n, DELTA.compiled.SIMPLIFIED))

    def forward(part: slice) -> None:
        DELTA.compiled.forward(theta[part], tool, exact, x[part], status[part], False)

    def simplified(part: slice) -> None:
        DELTA.compiled.simplified_forward(theta[part], tool, ideal, r[part], status[part])

    return {"W5: exact positions": forward, "W3: ideal positions": simplified}


def trials(count: int) -> Callable[[slice], None]:
    """Return W6 of so many machines, model 18: what identifies and judges a part of them."""
    rng, theta = np.random.default_rng(6), by_hand.ideal_inverse(rings(POSES))
    assert ROBOT.workspace is not None
    target = check_poses(ROBOT.workspace)
    poses, check = PoseSet(ROBOT, theta), PoseSet(ROBOT, by_hand.ideal_inverse(target))
    linear = poses.linear("18", as_distance=True)
    true = np.stack([errors("18", seed) for seed in range(count)])
    noise = SIGMA * rng.standard_normal((count, POSES, 3))
    identified(poses, linear, check, target, true[:1], noise[:1])  # what they share is computed

    def part(some: slice) -> None:
        with using(Backend.COMPILED):  # a thread begins without what was chosen outside
            identified(poses, linear, check, target, true[some], noise[some])

    return part


def best(run: Callable[[], object], repetitions: int = 7, clock: Callable[[], float] = time.process_time) -> float:
    """Return the least time of some runs [s]: of the processor, which a busy machine leaves nearly as it is."""
    run()
    times = []
    for _ in range(repetitions):
        begin = clock()
        run()
        times.append(clock() - begin)
    return min(times)


def threads(work: Callable[[slice], None], count: int, pool: ThreadPoolExecutor) -> float:
    """Return how many times faster two threads do a work: wall time, both ways in turn, the least time of each."""
    wall = time.perf_counter
    halves = [slice(0, count // 2), slice(count // 2, count)]
    one, two = np.inf, np.inf
    for _ in range(5):
        one = min(one, best(lambda: work(slice(0, count)), 2, wall))
        two = min(two, best(lambda: list(pool.map(work, halves)), 2, wall))
    return one / two


def two_cores() -> ThreadPoolExecutor:
    """Return two threads that stay on a core each where they can: it is not the system's scheduler that is measured."""
    cores = sorted(os.sched_getaffinity(0))[:2] if hasattr(os, "sched_setaffinity") else []

    def stay() -> None:
        if cores:
            os.sched_setaffinity(0, {cores.pop()})

    return ThreadPoolExecutor(2, initializer=stay)


def by_effects(most: int) -> tuple[list[int], list[float]]:
    """Return numbers of effects, and the time [ms] of linearising a recording with them free."""
    theta, points = measured("18", 200)
    problem = pose_problem(ROBOT, recorded(theta, points), DELTA.model("18"))
    terms = [blank(EFFECT, (limb,)) for _ in range(most) for limb in (1, 2, 3)]
    runs = {}
    for k in range(0, len(terms) + 1, 3):
        some = problem.with_terms(terms[:k], np.ones(sum(t.n_coefficients for t in terms[:k])))
        runs[k] = partial(some.linearise, some.reference, some.begin(some.reference))
    times = dict.fromkeys(runs, np.inf)
    for _ in range(5):  # in turn, so that a busy machine slows them alike
        for k, run in runs.items():
            times[k] = min(times[k], 1e3 * best(run, 5))
    return list(times), list(times.values())


@using(Backend.COMPILED)
def main(arguments: list[str] | None = None) -> int:
    """Print the figures and draw them."""
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.scaling", description=__doc__.split("\n")[0])
    parser.add_argument("-o", "--output", type=Path, default=Path("scaling.png"))
    parser.add_argument("--most", type=int, default=1_000_000, metavar="POSES")
    parser.add_argument("--measured", action="store_true", help="draw the manual's picture")
    given = parser.parse_args(arguments)
    if given.measured:
        given.output = manual.folder() / "measured" / "scaling.png"
    sizes = [n for n in (100, 1_000, 10_000, 100_000, 1_000_000) if n <= given.most]
    cost: dict[str, list[float]] = {}
    for n in sizes:
        for name, work in kernels(n).items():
            cost.setdefault(name, []).append(best(lambda: work(slice(0, n))) / n * 1e9)  # noqa: B023
    for name, spent in cost.items():
        print(f"{name}: " + ", ".join(f"{n} poses {t:.0f} ns" for n, t in zip(sizes, spent, strict=True)))
    counts, times = by_effects(4)
    print("linearise 200 poses: " + ", ".join(f"{k} effects {t:.2f} ms" for k, t in zip(counts, times, strict=True)))
    with two_cores() as pool:
        n, machines = given.most, max(2, given.most // 250)
        works = {name: (work, n) for name, work in kernels(n).items()}
        works["W6: identifications"] = (trials(machines), machines)
        gain = {name: threads(work, count, pool) for name, (work, count) in works.items()}
    print("two threads: " + ", ".join(f"{name} x {g:.2f}" for name, g in gain.items()))
    draw(given.output, sizes, cost, counts, times, gain)
    return 0


def draw(
    path: Path,
    sizes: list[int],
    cost: dict[str, list[float]],
    counts: list[int],
    times: list[float],
    gain: dict[str, float],
) -> None:
    """Draw cost against poses, against effects, and the gain of a second thread."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(11, 3.6), layout="constrained")
    poses, effects, second = figure.subplots(1, 3)
    for name, spent in cost.items():
        poses.loglog(sizes, np.array(spent) * sizes / 1e6, "o-", label=name)
    poses.loglog(sizes, [0.01 * n / 100 for n in sizes], "k:", label="linear")
    poses.set(xlabel="poses", ylabel="time [ms]", title="Cost against poses")
    poses.legend()
    effects.plot(counts, times, "o-")
    effects.set(xlabel="effects", ylabel="time [ms]", title="Linearising 200 poses", ylim=(0, None))
    second.bar(range(len(gain)), list(gain.values()), color="0.6")
    second.set_xticks(range(len(gain)), [name.partition(":")[0] for name in gain])
    second.axhline(1.8, color="k", linestyle=":")
    second.set(ylabel="times faster", title="Two threads for one", ylim=(0, 2.1))
    figure.savefig(path, dpi=120)


if __name__ == "__main__":
    sys.exit(main())

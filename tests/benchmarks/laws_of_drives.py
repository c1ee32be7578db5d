"""Laws of drives, drawn blind: ``python -m tests.benchmarks.laws_of_drives [--laws N] [--seed S]``.

An arm of three joints with usual friction, of which one has what nobody registered besides: a curve of its position,
its speed or its load, or friction that its position or load changes. A third of the curves are formulas, the others
come of a generator that knows no forms: sums of bumps of random places, widths and sizes. Right is a law at that joint
alone, made of the true states, without a needless name; what is left of fresh runs is told over the noise.
"""

from __future__ import annotations

import argparse
import tempfile
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

import deltacal_gen as dc
from deltacal_gen.errors import DeltacalError
from tests.support.motion_recordings import NOISE, named, usual, written

Curve = Callable[[np.ndarray], np.ndarray]
STATES = {"q": ("q",), "qd": ("qd",), "torque": ("torque",), "qd q": ("q", "qd"), "qd torque": ("qd", "torque")}
LARGE = (0.5, 2.0)  # Nm: rms of what is concealed
BUMPS = 6


def formula(rng: np.random.Generator, low: float, high: float) -> tuple[str, Curve]:
    """Return a curve that is a formula of few parts between two ends."""
    k, w = rng.uniform(low + 0.25 * (high - low), high - 0.25 * (high - low)), 0.15 * (high - low)
    curves: dict[str, Curve] = {
        "stop": lambda x: np.maximum(x - k, 0),
        "hard stop": lambda x: np.maximum(k - x, 0) ** 2,
        "step": lambda x: np.tanh((x - k) / w),
        "bump": lambda x: np.exp(-(((x - k) / w) ** 2)),
    }
    name = str(rng.choice(sorted(curves)))
    return name, curves[name]


def drawn(rng: np.random.Generator, low: float, high: float) -> tuple[str, Curve]:
    """Return a curve of bumps."""
    at, size = rng.uniform(low, high, BUMPS), rng.standard_normal(BUMPS)
    wide = rng.uniform(0.15, 0.5, BUMPS) * (high - low)
    return "drawn", lambda x: (size * np.exp(-(((x[..., None] - at) / wide) ** 2))).sum(axis=-1)


def case(seed: int) -> tuple[dict[str, Any], Callable[[np.ndarray, np.ndarray], np.ndarray]]:
    """Return what is concealed, in words, and as a friction of `motion_recordings`."""
    rng = np.random.default_rng(seed)
    joint, states = int(rng.integers(3)), str(rng.choice(sorted(STATES)))
    of = states.split()[-1]
    low, high = {"q": (-0.4, 0.4), "qd": (-0.6, 0.6), "torque": (0.0, 1.0)}[of]
    form, curve = (formula if rng.uniform() < 1 / 3 else drawn)(rng, low, high)
    size = float(np.exp(rng.uniform(*np.log(LARGE))))
    sample = curve(np.linspace(low, high, 200))
    size /= float(np.std(sample) if len(states.split()) == 1 else np.sqrt(np.mean(sample**2)))

    def friction(s: np.ndarray, load: np.ndarray) -> np.ndarray:
        known = {"q": s[0, :, joint], "qd": s[1, :, joint], "torque": load[:, joint]}
        x = known[of]
        if of == "torque":  # over the loads that the joint has
            least, wide = loads()
            x = (x - least[joint]) / wide[joint]
        value = size * curve(x) * (np.sign(known["qd"]) if states.startswith("qd ") else 1.0)
        out = usual(s, load)
        out[:, joint] += value
        return out

    return {"seed": seed, "joint": joint + 1, "states": STATES[states], "form": form}, friction


@cache
def loads() -> tuple[np.ndarray, np.ndarray]:
    """Return least and range of each joint's load [Nm], as a recording has them."""
    seen: list[np.ndarray] = []
    with tempfile.TemporaryDirectory() as folder:
        written(Path(folder), lambda s, load: (seen.append(load), usual(s, load))[1], seed=1)
    every = np.vstack(seen)
    return every.min(axis=0), np.ptp(every, axis=0)


def examine(seed: int) -> dict[str, Any]:
    """Return how a case ends."""
    true, friction = case(seed)
    with tempfile.TemporaryDirectory() as one, tempfile.TemporaryDirectory() as other:
        recording = written(Path(one), friction, runs=6, seed=seed)
        found: Any = dc.diagnose(Path(one) / "robot.toml", recording)
        fresh = written(Path(other), friction, runs=3, seed=seed + 500)
        left = dc.validate(found.to_dict(), fresh)["rms_by_joint"][true["joint"] - 1]
    terms = [t for law in found["laws"] for t in law["terms"]]
    states = sorted({s for law in found["laws"] for s in law["states"]})
    strange = sorted({*named(found)} - {"coulomb_friction", "viscous_friction"})
    return true | {
        "told": [t["expression"] for t in terms],
        "place": {j for t in terms for j in t["limbs"]} == {true["joint"]},
        "same": states == sorted(true["states"]),
        "elsewhere": any(j != true["joint"] for t in terms for j in t["limbs"]),
        "open": [u["limb"] for u in found["unexplained"]],
        "needless": strange,
        "fresh": left / NOISE,
    }


def main(arguments: list[str] | None = None) -> int:
    """Draw laws, and print what came of them."""
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.laws_of_drives")
    parser.add_argument("--laws", type=int, default=60)
    parser.add_argument("--seed", type=int, default=0)
    given = parser.parse_args(arguments)
    rows = []
    for seed in range(given.seed, given.seed + given.laws):
        try:
            rows.append(examine(seed))
        except DeltacalError as error:
            print(seed, "refused:", error, flush=True)
            continue
        print({k: v for k, v in rows[-1].items() if v or k == "place"}, flush=True)
    for name, own in (
        ("formulas", [r for r in rows if r["form"] != "drawn"]),
        ("drawn", [r for r in rows if r["form"] == "drawn"]),
    ):
        told = [r for r in own if r["place"]]
        print(
            f"{name}: of {len(own)} told as a law {len(told)}, of the true states {sum(r['same'] for r in told)}, "
            f"unexplained at the joint {sum(r['joint'] in r['open'] for r in own)}, at another joint "
            f"{sum(r['elsewhere'] for r in own)}, a name besides {sum(bool(r['needless']) for r in told)}; fresh runs "
            f"over noise, median where told {np.median([r['fresh'] for r in told] or [np.nan]):.3f}, "
            f"within 1.2 {sum(r['fresh'] < 1.2 for r in told)}"
        )
    return 0


if __name__ == "__main__":
    raise SystemExit(main())

"""An arm under a tracker, two series: what geometry leaves, what physics takes off, whether it carries to the other.

    python -m tests.benchmarks.arm SERIES_A SERIES_D [--measured]

Each series is a folder with ``robot.toml`` and ``recording.csv``. Everything is diagnosed on one series, or on both as
two set-ups of one recording, then held while geometry and frame are refitted to the other.
"""

from __future__ import annotations

import argparse
import csv
import tempfile
from pathlib import Path
from typing import Any

import numpy as np

import deltacal_gen as dc
from deltacal_gen import read_recording, read_robot
from deltacal_gen.machine.registry import mechanism_of
from tests.support.measured import write

COMMAND = "python -m tests.benchmarks.arm SERIES_A SERIES_D --measured"
NAMES = ("A", "D")


def mean_error(result: dict[str, Any], folder: Path) -> float:
    """Return the mean distance [mm] of predicted from measured positions."""
    robot = read_robot(folder / "robot.toml")
    measured = read_recording(folder / "recording.csv", mechanism_of(robot))
    off = dc.predict(result, measured).measured - measured.measured
    return float(np.nanmean(np.linalg.norm(off, axis=1)))


def together(series: list[Path], folder: Path) -> Path:
    """Write all series as one recording, each a set-up of its own, in `folder`; return the folder."""
    rows = []
    for k, place in enumerate(series, 1):
        name = f"series{k}_"
        with (place / "recording.csv").open() as file:
            rows += [
                row | {"setup": name, "pose": f"{name}{row.get('pose', n)}"}
                for n, row in enumerate(csv.DictReader(file))
            ]
    columns = [c for c in rows[0] if all(c in row for row in rows)]
    with (folder / "recording.csv").open("w", newline="") as file:
        writer = csv.DictWriter(file, columns, extrasaction="ignore")
        writer.writeheader()
        writer.writerows(rows)
    for name in ("robot.toml", "recording.toml"):
        (folder / name).write_bytes((series[0] / name).read_bytes())
    return folder


def main() -> None:
    """Print both tables."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("series", type=Path, nargs=2)
    parser.add_argument("--measured", action="store_true", help="write the manual's tables too")
    given = parser.parse_args()
    folders = dict(zip(NAMES, given.series, strict=True))
    diagnoses, left, carried = {}, [], []
    for name, folder in folders.items():
        found = diagnoses[name] = dc.diagnose(folder / "robot.toml", folder / "recording.csv")
        poses = len(found["residuals"]["line"])
        rms = [found[stage][key] for key in ("train_rms_mm", "heldout_rms_mm") for stage in ("baseline", "final")]
        left.append([f"series {name}", str(poses), *(f"{value:.3f}" for value in rms)])
        print(" | ".join(left[-1]), *[f"{e['name']} {e['limbs']}" for e in found["effects"]], flush=True)
    with tempfile.TemporaryDirectory() as place:
        both = together(given.series, Path(place))
        diagnoses["A and D together"] = dc.diagnose(both / "robot.toml", both / "recording.csv")
    for of, to in (("A", "D"), ("D", "A"), ("A and D together", "D")):
        files = folders[to] / "robot.toml", folders[to] / "recording.csv"
        geometry = mean_error(dc.identify(*files), folders[to])
        held = mean_error(dc.identify(*files, physics=diagnoses[of]), folders[to])
        carried.append([of, to, f"{geometry:.3f}", f"{held:.3f}", f"{held / geometry:.2f}"])
        print(" | ".join(carried[-1]), flush=True)
    if given.measured:
        heads = ("geometry", "with physics", "held out, geometry", "held out, with physics")
        write("arm", ["series", "poses", *(f"{head}, mm" for head in heads)], left, COMMAND)
        heads = ("diagnosed on", "applied to", "geometry, mm", "physics held, mm", "ratio")
        write("arm_carried", heads, carried, COMMAND)


if __name__ == "__main__":
    main()

"""From an empty process: how long the first identification and the first command take, compiled before or not."""

from __future__ import annotations

import itertools
import json
import os
import shutil
import subprocess
import sys
import tempfile
from functools import cache, partial
from pathlib import Path

import deltacal_kernels
import numpy as np

import deltacal_gen
from deltacal_gen.files.robot import robot_to_toml
from tests.benchmarks.contenders import (
    DELTA,
    NUMBA,
    NUMPY,
    OURS,
    ROBOT,
    SIGMA,
    TOOLS,
    Array,
    Contender,
    Work,
    calibrated,
    errors,
    measured,
    paper,
    positions,
    reach,
)


@cache
def _place() -> tempfile.TemporaryDirectory[str]:
    """Return a folder with the files to identify from, and with kernels and programs by hand that are not compiled."""
    place = tempfile.TemporaryDirectory(prefix="deltacal-bench-")
    folder = Path(place.name)
    theta, [(_, at)] = measured("18")
    (folder / "robot.toml").write_text(robot_to_toml(ROBOT), encoding="utf-8")
    head = "q1_deg,q2_deg,q3_deg,x_mm,y_mm,z_mm"
    table = np.hstack([np.degrees(theta), at])
    np.savetxt(folder / "recording.csv", table, "%.12g", ",", header=head, comments="")
    package = Path(deltacal_kernels.__file__).parent
    for source, name in ((package, package.name), (Path(__file__).parent, "by_hand")):
        shutil.copytree(source, folder / name, ignore=shutil.ignore_patterns("__pycache__"))
    return place


def _empty_cache() -> None:
    """Remove what Numba, CasADi and JAX have compiled."""
    for path in Path(_place().name).rglob("*.nbc"):
        path.unlink()
    for folder in ("deltacal-casadi", "jax"):
        shutil.rmtree(Path(_place().name) / folder, ignore_errors=True)


def _process(*command: str) -> str:
    """Run Python on the copies; return what it prints."""
    place, package = Path(_place().name), Path(deltacal_gen.__file__).parents[1]
    environment = os.environ | {
        "PYTHONPATH": os.pathsep.join(map(str, (place, package))),
        "OPENBLAS_NUM_THREADS": "1",
        "TMPDIR": str(place),
        "JAX_COMPILATION_CACHE_DIR": str(place / "jax"),
        "JAX_PERSISTENT_CACHE_MIN_COMPILE_TIME_SECS": "0",
    }
    for inherited in ("NUMBA_CACHE_DIR", "PYTHONDONTWRITEBYTECODE"):  # byte code is kept, as of what is installed
        environment.pop(inherited, None)
    done = subprocess.run([sys.executable, *command], cwd=place, env=environment, capture_output=True, text=True)
    if done.returncode:
        raise RuntimeError(f"{' '.join(command)}\n{done.stderr}")
    return done.stdout


_API = """
import sys
import numpy as np
from deltacal_gen import estimate, nominal
with open("recording.csv") as file:  # by its name NumPy would first load what reads compressed files and addresses
    table = np.loadtxt(file, delimiter=",", skiprows=1)
robot = nominal("delta", {key: float(value) for key, value in zip(sys.argv[1::2], sys.argv[2::2])})
found = estimate(robot, "18", np.radians(table[:, :3]), table[:, 3:6], as_distance=True)
print(*found.errors)
"""
_COMMAND = """
import json, sys
import numpy as np
from deltacal_gen.use.compensation import Compensator
from deltacal_gen.files.robot import read_robot
import dataclasses
target, errors = json.loads(sys.argv[1]), json.loads(sys.argv[2])
robot = dataclasses.replace(read_robot("robot.toml"), errors=errors)
print(*Compensator(robot).command(np.array([target]))[0][0])
"""


def start(n: int, *, what: str, cold: bool) -> Work:
    """From the start of the process to the first result, with the compiled code on the disk or without."""
    before = _empty_cache if cold else None
    if what == "command":
        target = positions(1)[0].tolist()
        programs = {
            OURS: ("-c", _COMMAND, json.dumps(target), json.dumps(calibrated().errors)),
            NUMPY: ("-m", "by_hand.by_hand", "command", *map(repr, (*target, *paper(errors()).tolist()))),
        }
        view, tolerance = {OURS: _numbers, NUMPY: _numbers}, 1e-4  # rad; by hand it is eq. (23)
    else:
        geometry = [(key, str(float(value[0]))) for key, value in ROBOT.geometry.items() if len(value) == 1]
        mine: tuple[str, ...] = ("-c", _API, *itertools.chain.from_iterable(geometry))
        if what == "deltacal identify":
            given = ("robot.toml", "recording.csv", "--model", "18", "--as", "distance", "--json")
            mine = ("-m", "deltacal_gen.app.cli", "identify", *given)
        modules = {NUMPY: "by_hand", NUMBA: "by_hand_numba"}
        modules |= {name: tool.__name__.rpartition(".")[2] for name, tool in TOOLS.items()}
        programs = {OURS: mine} | {
            name: ("-m", f"by_hand.{module}", "identify", "recording.csv") for name, module in modules.items()
        }
        view = {name: lambda text: reach(_numbers(text)) for name in programs}
        told = _told if what == "deltacal identify" else _numbers
        view[OURS] = lambda text: reach(paper(told(text)))
        tolerance = 10 * SIGMA  # the package's default is robust and has priors
    contenders = {
        name: Contender(partial(_process, *program), view[name], before) for name, program in programs.items()
    }
    return Work(f"process start to {what}, cache {'empty' if cold else 'full'}", "s", 1, contenders, tolerance)


def _numbers(text: str) -> Array:
    return np.array(text.split(), dtype=float)


def _told(text: str) -> Array:
    """Return the source errors (42,) of a RESULT.json."""
    found = json.loads(text)["parameters"]
    return DELTA.vector({p["name"]: p["value"] * (np.pi / 180 if p["unit"] == "deg" else 1.0) for p in found})

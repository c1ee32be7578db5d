"""A machine of every mechanism, with poses and a truth: files of its example, or made from its own drawing."""

from __future__ import annotations

import tempfile
from functools import cache
from pathlib import Path

import numpy as np

from deltacal_gen.app.demonstration import example
from deltacal_gen.files.robot import robot_to_toml
from deltacal_gen.files.toml import toml_text
from deltacal_gen.machine.registry import load_mechanism, mechanism_of
from deltacal_gen.units import joint_factors, joint_names, to_file

POSES = 60
_made = tempfile.TemporaryDirectory(prefix="drawn-")


@cache
def example_of(name: str) -> Path:
    """Return a folder with robot.toml, poses.csv and truth.toml of the machine that a mechanism describes.

    Those of its example; where there is none, those of the drawing that the mechanism's own file gives, at poses
    anywhere in its workspace, with errors of twice the ordinary size.
    """
    machine = load_mechanism(name).machine
    return example(machine) if (example(machine) / "robot.toml").exists() else _written(machine)


@cache
def _written(name: str) -> Path:
    from derive.review import subjects  # SymPy takes a second, which only a drawing costs
    from derive.review.checks import spread

    robot, folder = subjects.example(name), Path(_made.name) / name
    assert robot is not None, f"{name} has no example: give its file in derive/mechanisms a drawing"
    folder.mkdir()
    mechanism, rng = mechanism_of(robot), np.random.default_rng(13)
    kept = set(mechanism.models[mechanism.full_model])
    errors = {p.name: to_file(2 * p.typical * rng.standard_normal(), p.unit) for p in mechanism.parameters}
    joints = robot.joint_sign * spread(robot, POSES).q / joint_factors(mechanism.joint_unit, mechanism.limbs)
    header = ",".join(joint_names(mechanism.joint_unit, mechanism.limbs))
    np.savetxt(folder / "poses.csv", joints, "%.5f", ",", header=header, comments="")
    for file, text in {
        "robot.toml": robot_to_toml(robot),
        "poses.toml": toml_text({"measurement": {"kind": "position", "frame": "robot"}}),
        "truth.toml": toml_text({"parameters": {n: e for n, e in errors.items() if n in kept}}),
    }.items():
        (folder / file).write_text(text, encoding="utf-8")
    return folder

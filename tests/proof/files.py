"""The files of a case: what a tool may see, and apart from it what is the case.

::

    cases/c001/robot.toml  recording.csv  recording.toml  [recording.distances.csv]  fresh.csv  fresh.toml  [...]
    truth/c001/case.json   truth.toml     exact.csv ...   fresh.csv ...

The names say nothing. ``fresh`` of a case has no readings; that of the truth has them, without noise. ``exact`` is the
recording without noise, ``truth.toml`` the machine as ``deltacal simulate --truth`` reads it, ``case.json`` the rest.
"""

from __future__ import annotations

import dataclasses
import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from deltacal_gen.files.recording import read_recording
from deltacal_gen.files.robot import read_robot, robot_to_toml
from deltacal_gen.files.toml import toml_text
from deltacal_gen.files.writing import write_recording
from deltacal_gen.machine.values import Recording
from deltacal_gen.physics.simulation import read_truth
from deltacal_gen.units import DEG
from tests.benchmarks.concealed_cases import MECHANISM, Case
from tests.benchmarks.concealed_grading import Oracle
from tests.proof.engines import truth_of


@dataclass(frozen=True)
class Concealed:
    """A case as its files hold it, who simulated it, and what an ideal fit reaches (None where it did not converge)."""

    name: str
    engine: str
    case: Case
    ideal: Oracle | None


def unread(recording: Recording) -> Recording:
    """Return a recording whose readings are still to be taken: blank cells in the files."""
    if recording.pair_measured is not None:
        return dataclasses.replace(recording, pair_measured=np.full_like(recording.pair_measured, np.nan))
    return dataclasses.replace(recording, measured=np.full_like(recording.measured, np.nan))


def write(concealed: Concealed, folder: Path) -> None:
    """Write a case into `folder`; its ``case.json`` comes last, so that a truth with it is complete."""
    case = concealed.case
    seen, hidden = folder / "cases" / concealed.name, folder / "truth" / concealed.name
    seen.mkdir(parents=True, exist_ok=True)
    hidden.mkdir(parents=True, exist_ok=True)
    (seen / "robot.toml").write_text(robot_to_toml(case.robot), encoding="utf-8")
    write_recording(case.recording, seen / "recording.csv")
    write_recording(unread(case.fresh), seen / "fresh.csv")
    write_recording(case.fresh, hidden / "fresh.csv")
    write_recording(case.exact, hidden / "exact.csv")
    truth = truth_of(case.robot, case.errors, case.terms)
    tables = [toml_text({"parameters": truth["parameters"]}), *(toml_text({"[effects]": e}) for e in truth["effects"])]
    (hidden / "truth.toml").write_text("\n".join(tables), encoding="utf-8")
    ideal = concealed.ideal
    about: dict[str, Any] = {
        "engine": concealed.engine,
        "kind": case.kind,
        "names": list(case.names),
        "sigma_mm": case.sigma,
        "turn_sigma_deg": case.turn_sigma / DEG,
        "excess": case.excess,  # standard deviations of noise that geometry alone leaves
        "channels": list(case.channels),
        "limbs": list(case.limbs),
        "traits": list(case.traits),
        "ideal": ideal
        and {
            "prediction_mm": ideal.prediction,
            "geometry_mm": ideal.geometry,
            "std": [s.tolist() for s in ideal.std],  # mm, rad, N, s, K; by effect of truth.toml, limb, coefficient
        },
    }
    (hidden / "case.json").write_text(json.dumps(about, indent=1) + "\n", encoding="utf-8")


def read(folder: Path, name: str) -> Concealed:
    """Return a case from its files."""
    seen, hidden = folder / "cases" / name, folder / "truth" / name
    about = json.loads((hidden / "case.json").read_text(encoding="utf-8"))
    robot = read_robot(seen / "robot.toml")
    truth = read_truth(hidden / "truth.toml", robot)
    case = Case(
        kind=about["kind"],
        names=tuple(about["names"]),
        robot=robot,
        recording=read_recording(seen / "recording.csv", MECHANISM),
        exact=read_recording(hidden / "exact.csv", MECHANISM),
        fresh=read_recording(hidden / "fresh.csv", MECHANISM),
        errors=truth.errors,
        terms=truth.terms,
        sigma=about["sigma_mm"],
        turn_sigma=about["turn_sigma_deg"] * DEG,
        excess=about["excess"],
        channels=tuple(about["channels"]),
        limbs=tuple(about["limbs"]),
        traits=tuple(about["traits"]),
    )
    said = about["ideal"]
    ideal = said and Oracle(said["prediction_mm"], said["geometry_mm"], tuple(np.array(s) for s in said["std"]))
    return Concealed(name, about["engine"], case, ideal)


def names(folder: Path) -> list[str]:
    """Return the names of all complete cases."""
    return sorted(p.parent.name for p in (folder / "truth").glob("*/case.json"))

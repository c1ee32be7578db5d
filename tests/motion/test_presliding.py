"""Friction that builds up over a way (Dahl): told with its stiffness, beside the dry friction that it is part of."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.errors import InputError
from tests.support.motion_recordings import DEG, NOISE, carried, named, trajectory, written

COULOMB, STIFFNESS, VISCOUS = 6.0, 8.0, 0.1  # Nm, Nm/deg, Nm s/deg
WAY = COULOMB / STIFFNESS  # deg


def bristles(q: np.ndarray) -> np.ndarray:
    """Return Dahl's state (N,) at joints (N,) [deg], solved along the way: the time does not stand in it."""
    z = np.zeros(len(q))
    for n, (before, now) in enumerate(pairwise(q), start=1):
        way = np.sign(now - before)
        z[n] = way + (z[n - 1] - way) * np.exp(-abs(now - before) / WAY)
    return z


def dahl(states: np.ndarray, load: np.ndarray) -> np.ndarray:
    """Return friction (N, 3) [Nm] whose second joint gives before it slides."""
    found = VISCOUS * states[1] / DEG + 4.0 * np.sign(states[1]) * [1.0, 0.0, 1.0]
    found[:, 1] += COULOMB * bristles(states[0, :, 1] / DEG)
    return found


@pytest.fixture(scope="module")
def recording(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return written(tmp_path_factory.mktemp("dahl"), dahl)


@pytest.fixture(scope="module")
def found(recording: Path) -> Any:
    return dc.diagnose(recording.with_name("robot.toml"), recording)


@pytest.mark.walk
def test_it_is_named_where_it_is_with_its_stiffness(found: Any) -> None:
    assert named(found) == {"coulomb_friction": [1, 2, 3], "viscous_friction": [1, 2, 3], "presliding_friction": [2]}
    told = {p["name"]: p for e in found["effects"] if e["name"] == "presliding_friction" for p in e["parameters"]}
    assert (told["stiffness"]["unit"], told["travel"]["unit"]) == ("Nm/deg", "deg")
    for name, true in (("stiffness", STIFFNESS), ("travel", WAY)):
        assert abs(told[name]["value"] - true) < 4 * told[name]["std"] < 0.2 * true, told[name]
    dry = next(
        p for e in found["effects"] if e["name"] == "coulomb_friction" for p in e["parameters"] if p["limb"] == 2
    )
    assert abs(dry["value"] - COULOMB) < 4 * dry["std"]
    assert found["verdict"] == "missing_physics"
    assert found["final"]["heldout_rms_by_joint"][1] < 1.1 * NOISE


@pytest.mark.walk
def test_what_it_remembers_is_predicted(found: Any, tmp_path: Path) -> None:
    path = written(tmp_path, dahl, runs=1, seed=7)
    assert max(dc.validate(found.to_dict(), path)["rms_by_joint"]) < 1.15 * NOISE


STATED = (
    """
[[effects]]
name = "presliding_friction"
limb = 2
stiffness = 8.0
""",
    """
[[effects]]
name = "coulomb_friction"
coulomb = 6.0
limb = 2
""",
)


@pytest.mark.parametrize("truth", ["".join(STATED), STATED[0] + "coulomb = 6.0\n"])
def test_a_truth_says_it_beside_the_joint_s_dry_friction_or_with_it(truth: str, tmp_path: Path) -> None:
    readings = []
    for name, text in (("with", truth), ("without", "")):
        (tmp_path / name).mkdir()
        table = np.genfromtxt(carried(tmp_path / name, text), delimiter=",", names=True)
        readings.append(table["tau2_Nm"])
    q = [trajectory(10.0, 60 + run)[0, :, 1] / DEG for run in range(4)]
    inner = np.concatenate([(np.arange(len(own)) > 50) & (np.arange(len(own)) < len(own) - 50) for own in q])
    wanted = COULOMB * np.concatenate([bristles(own) for own in q])
    assert readings[0] - readings[1] == pytest.approx(wanted, abs=0.05 * COULOMB, nan_ok=True)
    assert np.std((readings[0] - readings[1] - wanted)[inner]) < 0.01 * COULOMB


def test_a_stiffness_without_a_force_says_what_is_missing(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="presliding_friction needs a number for 'travel'"):
        carried(tmp_path, STATED[0])


def yielding(q: np.ndarray) -> np.ndarray:
    """Return Bouc's and Wen's hysteresis (N,) along joints (N,) [deg]: it yields over 3 deg, and keeps a stiffness."""
    z = np.zeros(len(q))
    for n, way in enumerate(np.diff(q), start=1):
        z[n] = z[n - 1] + (way - 0.7 * abs(way) * z[n - 1] - 0.3 * way * abs(z[n - 1])) / 3.0
    return 0.7 * z + 0.3 * (q - q.mean()) / np.std(q)


@pytest.mark.walk
def test_hysteresis_of_another_shape_is_not_explained(tmp_path: Path) -> None:
    def friction(states: np.ndarray, load: np.ndarray) -> np.ndarray:
        return np.outer(1.5 * yielding(states[0, :, 1] / DEG), [0.0, 1.0, 0.0])

    path = written(tmp_path, friction, seed=2)
    found = dc.diagnose(tmp_path / "robot.toml", path)
    assert found["verdict"] == "unexplained"
    assert [u["limb"] for u in found["unexplained"]] == [2]
    assert {j for e in found["effects"] for j in e["limbs"]} <= {2}

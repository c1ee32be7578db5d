"""Open chains: against homogeneous transforms written out here, and against numerical derivatives."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.errors import InputError, UsageError
from deltacal_gen.files.robot import Robot, read_robot, robot_to_dict, robot_to_toml
from deltacal_gen.machine.backend import Backend, using
from deltacal_gen.machine.registry import Machine, mechanism_of
from deltacal_gen.units import DEG
from tests.support.open_chains import ARM, SCARA, by_hand, robot
from tests.support.prototype import displaced, displacement

MODIFIED = [link | {"convention": "modified"} for link in ARM]
MIXED = [*ARM[:2], {"kind": "fixed", "a": 30.0, "alpha": 20.0}, {"kind": "coupled", "coupling": {"1": 0.5, "2": -1.0}}]
SLIDES = [{"kind": "prismatic", "alpha": 90.0, "theta": 90.0}, {"kind": "prismatic", "alpha": -90.0}]


BOTH = [ARM[0], *MODIFIED[1:4], *MIXED[2:]]
EVERY = pytest.mark.parametrize(
    "links",
    [ARM, MODIFIED, BOTH, MIXED, SLIDES, SCARA],
    ids=["standard", "modified", "both", "coupled", "prismatic", "scara"],
)


@EVERY
@pytest.mark.parametrize("backend", list(Backend), ids=lambda backend: backend.value)
def test_the_pose_and_its_derivatives_are_those_of_matrices_by_hand(
    links: list[dict[str, Any]], backend: Backend
) -> None:
    with using(backend):
        _check_by_hand(robot(links))


def _check_by_hand(r: Robot) -> None:
    m, rng = mechanism_of(r), np.random.default_rng(3)
    q = rng.uniform(-2, 2, (4, m.limbs)) * [100.0 if unit == "mm" else 1.0 for unit in m.joint_units]
    errors = {p.name: 3 * p.typical * rng.standard_normal() for p in m.parameters}
    rows = m.rows(r, m.vector(errors))
    x, status = m.forward(q, r.tool, rows)
    assert (status == 0).all()
    for n in range(len(q)):
        assert x[n] == pytest.approx(by_hand(r, q[n], errors), abs=1e-10)
    S = m.sensitivity(x, q, r.tool, rows)
    for j, p in enumerate(m.parameters):
        h = 1e-3 * (1.0 if p.unit == "mm" else 0.1)
        plus, minus = (
            np.array([by_hand(r, one, errors | {p.name: errors[p.name] + s * h}) for one in q]) for s in (1, -1)
        )
        slope = (displacement(x, plus) - displacement(x, minus)) / (2 * h)
        assert S.parameters[:, :, j] == pytest.approx(slope, abs=2e-4 if p.unit == "rad" else 1e-8)
    for j in range(m.limbs):
        h = 1e-4
        plus, minus = (m.forward(q + s * h * np.eye(m.limbs)[j], r.tool, rows)[0] for s in (1, -1))
        slope = (displacement(x, plus) - displacement(x, minus)) / (2 * h)
        assert S.joints[:, :, j] == pytest.approx(slope, abs=1e-4)


@EVERY
@pytest.mark.parametrize("machines", [1, 3, 37])
def test_compiled_kernels_and_numpy_agree_for_many_machines_and_tools(
    links: list[dict[str, Any]], machines: int
) -> None:
    """Poses that fill no block of lanes, shared out among machines, each pose with a tool of its own."""
    r, n = robot(links), 111
    m, rng = mechanism_of(r), np.random.default_rng(4)
    q, tool = rng.uniform(-2, 2, (n, m.limbs)), 50 * rng.standard_normal((n, 3))
    rows = m.rows(r, m.typical * rng.standard_normal((machines, len(m.parameters))))
    found = {}
    for backend in Backend:
        with using(backend):
            x, _ = m.forward(q, tool, rows)
            S = m.sensitivity(x, q, tool, rows)
            found[backend] = (
                x,
                S.parameters,
                S.joints,
                m.weights_at(x, q, tool, rows, {}),
                *_exerted(m, x, q, tool, rows),
            )
    for plain, compiled in zip(found[Backend.NUMPY], found[Backend.COMPILED], strict=True):
        assert np.abs(compiled - plain).max() < 1e-10
    alone = np.vstack([m.forward(q[[j]], tool[[j]], rows[[j * machines // n]])[0] for j in range(n)])
    assert np.abs(alone - found[Backend.COMPILED][0]).max() < 1e-11
    with pytest.raises(ValueError, match="rows have the shape"):
        m.forward(q[:-1], tool[:-1], np.resize(rows, (4, *rows.shape[1:])))


@pytest.mark.parametrize(
    "links",
    [ARM, MODIFIED, MIXED, SLIDES, SCARA],
    ids=["standard", "modified", "coupled", "prismatic", "scara"],
)
def test_a_chain_that_gives_way_has_the_derivatives_of_differences(links: list[dict[str, Any]]) -> None:
    r = robot(links)
    m, rng = mechanism_of(r), np.random.default_rng(4)
    q = rng.uniform(-2, 2, (4, m.limbs)) * [100.0 if unit == "mm" else 1.0 for unit in m.joint_units]
    errors = m.vector({p.name: 3 * p.typical * rng.standard_normal() for p in m.parameters})
    sizes = np.array([0.3, 0.3, 2e-3, 2e-3, 0.3, 0.3, 2e-3])  # mm, rad
    bent = sizes * rng.standard_normal((1, m.limbs, len(sizes)))
    rigid, rows = (m.rows(r, errors, much * bent) for much in (1e-14, 1.0))
    x, _ = m.forward(q, r.tool, rows)
    assert m.forward(q, r.tool, rigid)[0] == pytest.approx(m.forward(q, r.tool, m.rows(r, errors))[0], abs=1e-10)
    S = m.sensitivity(x, q, r.tool, rows)
    assert m.sensitivity(x, q, r.tool, rigid).parameters == pytest.approx(
        m.sensitivity(x, q, r.tool, m.rows(r, errors)).parameters, abs=1e-8
    )
    for j in range(m.limbs):
        for d in range(len(sizes)):
            h = np.zeros_like(bent)
            h[0, j, d] = 1e-3 * sizes[d]
            plus, minus = (m.forward(q, r.tool, m.rows(r, errors, bent + s * h))[0] for s in (1, -1))
            slope = displacement(minus, plus) / (2 * h[0, j, d])
            assert S.deflections[:, :, m._moving[j], d] == pytest.approx(slope, rel=1e-4, abs=1e-4)
    for j, p in enumerate(m.parameters):
        h = np.zeros(len(errors))
        h[j] = 1e-3 * p.typical
        plus, minus = (m.forward(q, r.tool, m.rows(r, errors + s * h, bent))[0] for s in (1, -1))
        assert S.parameters[:, :, j] == pytest.approx(displacement(minus, plus) / (2 * h[j]), rel=1e-4, abs=1e-4)


def test_weights_work_along_deflections_as_energy_falls() -> None:
    r = robot([*ARM[:3], {"kind": "fixed", "a": 30.0, "alpha": 20.0, "mass": 0.7}, *ARM[3:]])
    m, rng = mechanism_of(r), np.random.default_rng(5)
    q, gravity, payload = rng.uniform(-2, 2, (5, 6)), np.array([0.0, 0.0, -9.81]), 2.0
    x, _ = m.forward(q, r.tool, m.rows(r))
    pulls = m.loads(x, q, r.tool, m.rows(r), {"proximal": 0.0}, gravity, payload, range(1, 7)).pull
    for j, k in enumerate(m._moving):
        for d, name in enumerate(m.deflections):
            # a link bears no weight of its own, nor that of the fixed part of it
            behind = k if name.startswith(("side", "tilt")) else k + (2 if k == 2 else 1)
            masses = np.array([*(link.mass * (n >= behind) for n, link in enumerate(r.links)), payload])
            at = []
            for h in (1e-4, -1e-4):
                bent = np.zeros((1, m.limbs, len(m.deflections)))
                bent[0, j, d] = h
                rows = m.rows(r, None, bent)
                moved, _ = m.forward(q, r.tool, rows)
                at.append(m.weights_at(moved, q, r.tool, rows, {"proximal": 0.0}))
            work = ((at[0] - at[1]) @ gravity @ masses) / 2e-4
            assert pulls[:, j, d] == pytest.approx(work, rel=1e-5, abs=1e-3), (j, name)


def test_a_link_bends_across_its_line_and_twists_about_it() -> None:
    r = robot(
        [{"kind": "revolute", "a": 300.0, "d": 40.0}, {"kind": "fixed", "a": 100.0}, {"kind": "revolute", "a": 200.0}]
    )
    m = mechanism_of(r)
    tool, q = np.array([0.0, 50.0, 0.0]), np.zeros((1, 2))
    before, _ = m.forward(q, tool, m.rows(r))

    def moved(**given: float) -> np.ndarray:
        bent = np.zeros((1, 2, len(m.deflections)))
        for name, much in given.items():
            bent[0, 0, m.deflections.index(name)] = much
        return displacement(before, m.forward(q, tool, m.rows(r, None, bent))[0])[0]

    line = np.array([400.0, 0.0, 40.0]) / np.hypot(400.0, 40.0)
    for name in ("bend_v", "bend_w"):
        shift = moved(**{name: 0.1})
        assert shift[:3] @ line == pytest.approx(0.0, abs=1e-12)
        assert np.linalg.norm(shift[:3]) == pytest.approx(0.1)
        assert shift[3:] == pytest.approx(np.zeros(3), abs=1e-12)
    assert moved(bend_w=0.1)[2] > 0.09  # along the joint's axis, as far as that lies across
    assert moved(bend_v=0.1)[1] == pytest.approx(0.1)
    turned = moved(twist=1e-3)
    assert turned[3:] == pytest.approx(1e-3 * line, abs=1e-9)
    assert turned[:3] == pytest.approx(np.cross(1e-3 * line, before[0, :3]), abs=1e-4)  # the line passes through {O}
    assert moved(tilt_x=1e-3)[3:] == pytest.approx([1e-3, 0.0, 0.0], abs=1e-12)
    assert moved(tilt_y=1e-3)[3:] == pytest.approx([0.0, 1e-3, 0.0], abs=1e-12)
    assert moved(side_x=0.1)[:3] == pytest.approx([0.1, 0.0, 0.0])
    assert moved(side_y=0.1)[:3] == pytest.approx([0.0, 0.1, 0.0])


def _exerted(m: Machine, x: np.ndarray, q: np.ndarray, tool: np.ndarray, rows: np.ndarray) -> list[np.ndarray]:
    """Return what weights and a payload exert: torque, moment, and along the deflections of joints that give way."""
    given = {"proximal": 0.0}, np.array([0.5, -0.3, -9.81]), 2.0
    total = m.loads(x, q, tool, rows, *given)
    bent = rows.copy()
    bent[:, :, rows.shape[2] - len(m.deflections) :] = 1e-3
    return [total.torque, total.moment, m.loads(x, q, tool, bent, *given).pull]


def test_torques_are_minus_the_slope_of_potential_energy() -> None:
    r = robot()
    m, rng = mechanism_of(r), np.random.default_rng(5)
    q, rows, gravity, payload = rng.uniform(-2, 2, (5, 6)), m.rows(r), np.array([0.0, 0.0, -9.81]), 2.0
    masses = np.array([*(link.mass for link in r.links), payload])

    def energy(q: np.ndarray) -> np.ndarray:
        x, _ = m.forward(q, r.tool, rows)
        at = m.weights_at(x, q, r.tool, rows, {"proximal": 0.0})
        return np.asarray(-(at @ gravity) @ masses)

    x, _ = m.forward(q, r.tool, rows)
    torque = m.torques(x, q, r.tool, rows, {"proximal": 0.0}, gravity, payload)
    assert torque[:, 0] == pytest.approx(0, abs=1e-9)  # its axis is vertical
    for j in range(6):
        step = 1e-3 * np.eye(6)[j]
        slope = (8 * (energy(q + step) - energy(q - step)) - (energy(q + 2 * step) - energy(q - 2 * step))) / 12e-3
        assert torque[:, j] == pytest.approx(-slope, abs=1e-4)


def test_parallel_axes_have_a_beta_and_others_none() -> None:
    names = mechanism_of(robot()).model("serial/dh")
    assert [n for n in names if n.startswith("beta")] == ["beta_2", "beta_3"]
    assert {"a_1", "alpha_4", "d_6", "theta_3", "tx", "tz"} <= set(names)


def test_a_chain_survives_its_file(tmp_path: Path) -> None:
    r = robot(MIXED, errors={"a_2": 0.25, "theta_1": 0.1, "tx": -0.5})
    path = tmp_path / "robot.toml"
    path.write_text(robot_to_toml(r))
    again = read_robot(path)
    assert again.links == r.links
    assert again.errors == pytest.approx({"a_2": 0.25, "theta_1": 0.1 * DEG, "tx": -0.5})
    assert robot_to_dict(again) == robot_to_dict(r)


@pytest.mark.parametrize(
    ("links", "message"),
    [
        ([], "no links"),
        ([{"kind": "fixed"}], "no joint that moves"),
        ([*ARM[:1], {"kind": "coupled", "coupling": {"7": 1.0}}], "coupled to '7'"),
        ([*ARM[:1], {"kind": "coupled"}], "has no coupling"),
        ([{"kind": "turning"}], "'kind'"),
        ([ARM[0] | {"len": 3.0}], "'len'"),
    ],
)
def test_a_flawed_chain_is_refused(links: list[dict[str, Any]], message: str) -> None:
    with pytest.raises(InputError, match=message):
        robot(links)


def test_a_position_alone_does_not_command_a_chain() -> None:
    r = robot()
    with pytest.raises(UsageError, match="Give joints"):
        mechanism_of(r).inverse(np.zeros((1, 3)), r.tool, mechanism_of(r).rows(r))


def test_a_chain_is_simulated_and_identified(tmp_path: Path) -> None:
    """Full poses up to half a turn in an unknown frame; what comes out predicts the true machine elsewhere."""
    truth = {"a_2": 0.4, "alpha_1": 0.05, "theta_2": 0.08, "d_4": -0.3, "beta_3": 0.03, "theta_5": -0.1}
    (tmp_path / "robot.toml").write_text(robot_to_toml(robot()))
    lines = "\n".join(f"{k} = {v}" for k, v in truth.items())
    (tmp_path / "truth.toml").write_text(f"[parameters]\n{lines}\n")
    q = np.random.default_rng(7).uniform(-150, 150, (160, 6))
    for name, part in (("poses", q[:120]), ("fresh", q[120:])):
        header = ",".join(f"q{i}_deg" for i in range(1, 7))
        np.savetxt(tmp_path / f"{name}.csv", part, delimiter=",", header=header, comments="")
        (tmp_path / f"{name}.toml").write_text('[measurement]\nkind = "pose"\nframe = "unknown"\n')
        how = {"truth": tmp_path / "truth.toml", "seed": 1, "noise": 0.01 if name == "poses" else 0.0}
        dc.simulate(tmp_path / "robot.toml", tmp_path / f"{name}.csv", output=tmp_path / f"{name}_read.csv", **how)
    found = dc.identify(tmp_path / "robot.toml", tmp_path / "poses_read.csv", output=tmp_path / "result.json")
    assert found["train_rms_mm"] == pytest.approx(0.01, rel=0.15)
    check = dc.validate(tmp_path / "result.json", tmp_path / "fresh_read.csv")
    assert check["rms_mm"] < 0.01


def test_displacements_lead_from_pose_to_pose() -> None:
    x = np.hstack([np.zeros((1, 3)), np.eye(3).ravel()[None]])
    step = np.array([1.0, 2.0, 3.0, 0.1, -0.2, 0.3])
    assert displacement(x, displaced(x, step))[0] == pytest.approx(step)


@pytest.mark.parametrize(
    ("key", "scale", "said"),
    [
        ("alpha", DEG, r"look like radians \(1.5708 is among them\)"),
        ("a", 1e-3, r"the lengths in \[\[joint\]\] look like metres \(the largest is 0.4\)"),
        ("a", 1e3, "look like micrometres"),
    ],
)
def test_tables_in_other_units_are_refused(key: str, scale: float, said: str) -> None:
    """As they stand in URDF and in papers: a chain of radians was one whose readings were 350 mm off."""
    other = {"alpha": "theta", "a": "d"}[key]
    links = [link | {k: round(link.get(k, 0.0) * scale, 4) for k in (key, other)} for link in ARM]
    with pytest.raises(InputError, match=said):
        robot(links)


def test_small_twists_and_short_slides_are_drawings() -> None:
    robot([link | {"alpha": link.get("alpha", 0.0) + 1.57} for link in ARM])
    robot([{"kind": "prismatic", "d": 2.0}, {"kind": "prismatic", "alpha": 90.0}, {"kind": "revolute", "a": 1.5}])

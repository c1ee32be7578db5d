"""Recordings read in blocks: the same numbers as read whole, in a memory that does not grow with the rows."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pyarrow as pa
import pyarrow.csv
import pyarrow.parquet as pq
import pytest

from deltacal_gen.app import commands
from deltacal_gen.errors import InputError, UsageError
from deltacal_gen.files.recording import read_blocks, read_recording
from deltacal_gen.files.robot import Robot, robot_to_toml
from deltacal_gen.identification.identification import identify
from deltacal_gen.machine.registry import load_mechanism
from deltacal_gen.physics.simulation import simulate
from deltacal_gen.physics.terms import blank, kept_term
from deltacal_gen.use import prediction, streams, validation
from tests.conftest import plausible, scattered

NOISE = 0.02  # mm
DELTA = load_mechanism("delta")


def targets(robot: Robot, path: Path, n: int, frame: str = "unknown") -> Path:
    np.savetxt(path, scattered(robot, n, 5), "%.9g", ",", header="x_mm,y_mm,z_mm", comments="")
    path.with_suffix(".toml").write_text(f'[measurement]\nkind = "position"\nframe = "{frame}"\n')
    return path


def as_parquet(path: Path) -> Path:
    pq.write_table(pa.csv.read_csv(path), path.with_suffix(".parquet"))
    return path.with_suffix(".parquet")


@pytest.fixture(scope="module")
def errors() -> dict[str, float]:
    return plausible(DELTA, 4, DELTA.model("18"))


@pytest.mark.parametrize("kind", ["csv", "parquet"])
def test_blocks_are_the_recording(robot: Robot, errors: dict[str, float], tmp_path: Path, kind: str) -> None:
    """137 rows in blocks of 50: simulated, identified and predicted as when they are read whole."""
    poses = targets(robot, tmp_path / "poses.csv", 137)
    poses = as_parquet(poses) if kind == "parquet" else poses
    out = tmp_path / "recording.csv"
    done = streams.simulate(robot, poses, out, errors, noise=NOISE, rng=np.random.default_rng(3), rows=50)
    assert done == 137
    given = read_recording(poses, DELTA, need_measured=False, allow_targets=True)
    whole = simulate(robot, given, errors, noise=NOISE, rng=np.random.default_rng(3))
    found = read_recording(out, DELTA)
    np.testing.assert_allclose(found.measured, whole.measured, rtol=0, atol=1e-9)
    np.testing.assert_allclose(found.joints, whole.joints, rtol=0, atol=1e-12)
    assert found.pose.tolist() == whole.pose.tolist()

    fitted = streams.identify(robot, as_parquet(out) if kind == "parquet" else out, "18", rows=50)
    thorough = identify(robot, found, "18", solver="least-squares", robust=False)
    deviation = np.sqrt(np.diag(fitted.covariance)[:18])
    values = np.array(list(fitted.parameters.values()))
    assert fitted.rows == 137
    assert (np.abs(values - thorough.fit.errors[thorough.fit.problem.columns]) < 0.02 * deviation).all()
    assert fitted.sigma == pytest.approx(NOISE, rel=0.2)
    np.testing.assert_allclose(deviation, np.sqrt(np.diag(thorough.fit.covariance)[:18]), rtol=0.2)

    assert streams.predict(fitted.answer(), out, tmp_path / "predicted.csv", rows=50) == 137
    predicted = read_recording(tmp_path / "predicted.csv", DELTA).measured
    np.testing.assert_allclose(predicted, prediction.predict(fitted.answer(), found).measured, rtol=0, atol=1e-9)
    assert np.std(predicted - found.measured) < 1.2 * NOISE

    whole = validation.validate(fitted.answer(), found).to_dict()
    parts = streams.validate(fitted.answer(), out, rows=50).to_dict()
    assert parts.pop("rows") == [{**row, "error_mm": pytest.approx(row["error_mm"])} for row in whole.pop("rows")]
    assert parts == {key: value if isinstance(value, str) else pytest.approx(value) for key, value in whole.items()}


def test_one_pass_is_the_linear_identification(robot: Robot, tmp_path: Path) -> None:
    poses = targets(robot, tmp_path / "poses.csv", 60, frame="robot")
    small = {name: 0.01 * value for name, value in plausible(DELTA, 4, DELTA.model("18")).items()}
    streams.simulate(robot, poses, tmp_path / "recording.csv", small)
    found = streams.identify(robot, tmp_path / "recording.csv", "18", rows=25, passes=1)
    assert found.passes == 1
    left = np.subtract(list(found.parameters.values()), [small[name] for name in found.names])
    assert np.abs(left).max() < 1e-2 * np.abs(list(small.values())).max()


def test_what_needs_the_whole_recording_is_refused(robot: Robot, tmp_path: Path) -> None:
    path = tmp_path / "recording.csv"
    path.write_text("q1_deg,q2_deg,q3_deg,x_mm,y_mm,z_mm,setup\n1,2,3,4,5,-900,a\n2,3,4,5,6,-900,b\n")
    with pytest.raises(InputError, match="several set-ups"):
        list(read_blocks(path, DELTA, 10))
    path.write_text("q1_deg,q2_deg,q3_deg,gauge_mm\n1,2,3,4\n")
    path.with_suffix(".toml").write_text("[measurement]\nbase_point_mm = [0, 0, 0]\n")
    with pytest.raises(InputError, match="of the kind gauge"):
        streams.identify(robot, path, "18")
    for text, says in (("", "empty"), ("q1_deg,q2_deg\n", "no row"), ("q1_deg\n1,2\n", "2 cells")):
        path.write_text(text)
        with pytest.raises(InputError, match=says):
            list(read_blocks(path, DELTA, 10))
    with pytest.raises(InputError, match="cannot be read"):
        list(read_blocks(tmp_path / "none.csv", DELTA, 10))


HEADER = "q1_deg,q2_deg,q3_deg,x_mm,y_mm,z_mm"


@pytest.mark.parametrize("rows", [1, 2, 10])
def test_several_set_ups_are_refused_wherever_a_block_ends(tmp_path: Path, rows: int) -> None:
    path = tmp_path / "recording.csv"
    path.write_text(f"{HEADER},setup\n1,2,3,4,5,-900,A\n2,3,4,5,6,-900,A\n3,3,4,,,,B\n4,3,4,5,6,-900,B\n")
    with pytest.raises(InputError, match=r"several set-ups \(A, B\)"):
        list(read_blocks(path, DELTA, rows))


@pytest.mark.parametrize("kind", ["csv", "parquet"])
def test_a_block_without_readings_is_passed_over(robot: Robot, tmp_path: Path, kind: str) -> None:
    """Rows 20 to 39 of 60 were not read: whatever the blocks, 40 rows are fitted and judged."""
    poses, path = targets(robot, tmp_path / "poses.csv", 60), tmp_path / "recording.csv"
    streams.simulate(robot, poses, path, noise=NOISE, rng=np.random.default_rng(3))
    lines = path.read_text().splitlines()
    cells = [line.split(",") for line in lines[21:41]]
    at = [lines[0].split(",").index(name) for name in ("x_mm", "y_mm", "z_mm")]
    blanked = [",".join("" if k in at else cell for k, cell in enumerate(row)) for row in cells]
    path.write_text("\n".join(lines[:21] + blanked + lines[41:]) + "\n")
    path = as_parquet(path) if kind == "parquet" else path
    found = [streams.identify(robot, path, "18", rows=rows) for rows in (10, 20, 60)]
    assert {one.rows for one in found} == {40}
    for one in found[:2]:
        np.testing.assert_allclose(one.errors, found[2].errors, rtol=0, atol=1e-3)
    whole = validation.validate(found[2].answer(), read_recording(path, DELTA))
    parts = streams.validate(found[2].answer(), path, rows=10)
    assert parts["readings"] == whole["readings"] == 40
    assert parts["rms_mm"] == pytest.approx(whole["rms_mm"])
    blocks = list(read_blocks(path, DELTA, 20))
    assert [part.pose[0] for part in blocks] == ["1", "41"]


def test_columns_stay_where_they_are(robot: Robot, tmp_path: Path) -> None:
    """A column of a block may be blank, or hold text where another block holds numbers."""
    poses, out = tmp_path / "poses.csv", tmp_path / "recording.csv"
    poses.write_text("q1_deg,q2_deg,q3_deg,note,humidity,draught\n1,2,3,calm,,\n2,3,4,1,40,\n3,3,4,,,2\n")
    streams.simulate(robot, poses, out, rows=1)
    found = read_recording(out, DELTA).channels
    np.testing.assert_array_equal(found["humidity"], [np.nan, 40.0, np.nan])
    np.testing.assert_array_equal(found["draught"], [np.nan, np.nan, 2.0])
    assert "note" not in found


def test_a_recording_without_any_reading_is_said(tmp_path: Path) -> None:
    path = tmp_path / "recording.csv"
    path.write_text(f"{HEADER}\n1,2,3,,,\n2,3,4,,,\n")
    for rows in (1, 10):
        with pytest.raises(InputError, match=r"no row holds a reading\. Fill in x_mm, y_mm, z_mm"):
            list(read_blocks(path, DELTA, rows))


@pytest.mark.parametrize("given", [{"rows": 0}, {"rows": -1}, {"rows": 2.5}, {"passes": 0}, {"passes": -1}])
def test_blocks_and_passes_are_counted_from_one(robot: Robot, tmp_path: Path, given: dict[str, float]) -> None:
    path = tmp_path / "recording.csv"
    path.write_text(f"{HEADER}\n1,2,3,4,5,-900\n")
    (name, value), *_ = given.items()
    with pytest.raises(UsageError, match=rf"{name} = {value}: .* at least 1"):
        streams.identify(robot, path, "18", **given)


def test_contacts_are_refused(robot: Robot, tmp_path: Path) -> None:
    """Block by block every point would be placed anew, and the error come out too small."""
    poses, path = targets(robot, tmp_path / "poses.csv", 20, frame="robot"), tmp_path / "recording.csv"
    streams.simulate(robot, poses, path)
    result = streams.identify(robot, path, "18", passes=1).answer()
    path.with_suffix(".toml").unlink()
    path.write_text("q1_deg,q2_deg,q3_deg,contact\n1,2,3,a\n2,3,4,a\n")
    for rows in (1, 10):
        with pytest.raises(InputError, match="contacts are not validated in blocks"):
            streams.validate(result, path, rows=rows)


def test_a_cell_may_go_on_where_a_block_ends(tmp_path: Path) -> None:
    path = tmp_path / "recording.csv"
    path.write_text('pose,q1_deg,q2_deg,q3_deg,x_mm,y_mm,z_mm\n"a\nb",1,2,3,4,5,-900\nc,2,3,4,5,6,-900\n')
    blocks = list(read_blocks(path, DELTA, 1))
    assert [part.pose.tolist() for part in blocks] == [["ab"], ["c"]]
    assert [part.line.tolist() for part in blocks] == [[3], [4]]


def test_blocks_from_the_command_line(robot: Robot, errors: dict[str, float], tmp_path: Path) -> None:
    """simulate, identify, predict and validate of files: numbers as without --blocks."""
    poses, out = targets(robot, tmp_path / "poses.csv", 60), tmp_path / "recording.csv"
    given = {"truth": errors, "noise": NOISE, "seed": 3}
    assert commands.simulate_blocks(robot, poses, out, **given) == 60
    whole = commands.simulate(robot, poses, **given)
    np.testing.assert_allclose(read_recording(out, DELTA).measured, whole.measured, rtol=0, atol=1e-9)

    (tmp_path / "robot.toml").write_text(robot_to_toml(robot))
    command = [sys.executable, "-m", "deltacal_gen.app.cli", "identify", "robot.toml", out.name, "--model", "18"]
    said = subprocess.run([*command, "--blocks", "-o", "result.json"], cwd=tmp_path, capture_output=True, text=True)
    assert said.returncode == 0, said.stderr
    found = json.loads((tmp_path / "result.json").read_text())
    beside = commands.identify(robot, out, "18", solver="least-squares", robust=False)
    alike = ("model", "rank", "unidentifiable", "readings", "schema")
    assert {key: found[key] for key in alike} == {key: beside[key] for key in alike}
    for key, within in (("condition", 0.02), ("singular_values", 0.02), ("before_rms_mm", 0.2), ("train_rms_mm", 0.01)):
        assert found[key] == pytest.approx(beside[key], rel=within, abs=1e-6)
    for mine, theirs in zip(found["parameters"], beside["parameters"], strict=True):
        assert (mine["name"], mine["unit"], mine["status"]) == (theirs["name"], theirs["unit"], theirs["status"])
        if mine["status"] == "identified":
            assert mine["value"] == pytest.approx(theirs["value"], abs=0.05 * theirs["std"])

    more = commands.identify_blocks(robot, out, "24")  # a frame nobody knows hides the base frame
    assert (more["rank"], len(more["unidentifiable"])) == (18, 6)
    assert "not pinned" in {p["status"] for p in more["parameters"]}

    assert commands.predict_blocks(found, out, tmp_path / "predicted.csv") == 60
    assert "held-out" not in said.stdout
    whole = commands.validate(found, out)
    assert whole["rms_mm"] == pytest.approx(found["train_rms_mm"], rel=0.1)
    assert commands.validate_blocks(found, out) == whole  # of one block
    with pytest.raises(UsageError, match="not used in blocks"):
        commands.validate_blocks(found | {"physics": [kept_term(blank("backlash", (1,)))]}, out)
    (tmp_path / "truth.toml").write_text('[[effects]]\nname = "joint_scale"\nlimb = 1\nscale = 1e-4\n')
    with pytest.raises(UsageError, match="effects are not simulated in blocks"):
        commands.simulate_blocks(robot, poses, out, truth=tmp_path / "truth.toml")


PROGRAM = """
import json, resource, sys
import numpy as np
from pathlib import Path
from deltacal_gen.use import streams
from deltacal_gen.files.robot import read_robot
folder, rows = Path(sys.argv[1]), int(sys.argv[2])
robot = read_robot(folder / "robot.toml")
peak = []
for name in sys.argv[3:]:
    streams.simulate(robot, folder / name, folder / "recording.csv", {"L_1": 0.1}, rows=rows)
    found = streams.identify(robot, folder / "recording.csv", "18", rows=rows, passes=1)
    streams.predict(found.answer(), folder / "recording.csv", folder / "predicted.csv", rows=rows)
    streams.validate(found.answer(), folder / "recording.csv", rows=rows)
    peak.append(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)
print(json.dumps(peak))
"""


def test_memory_does_not_grow_with_the_rows(robot: Robot, tmp_path: Path) -> None:
    """Resident memory after two blocks, and after eight [KiB]."""
    (tmp_path / "robot.toml").write_text(robot_to_toml(robot))
    for name, n in (("few", 1000), ("many", 4000)):
        as_parquet(targets(robot, tmp_path / f"{name}.csv", n))
    files = ["few.parquet", "many.csv", "many.parquet"]
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM, str(tmp_path), "500", *files], capture_output=True, text=True, check=True
    )
    peak = json.loads(done.stdout)
    whole = 4000 * 6 * 48 * 8 / 1024  # the derivatives of all poses at once
    assert peak[2] - peak[0] < whole / 4

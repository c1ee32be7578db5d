"""The command line as a user meets it: outputs, exit codes, and messages that name file, line, column and remedy."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from jsonschema import Draft202012Validator

from deltacal_gen.app import checkout
from deltacal_gen.app.demonstration import example
from deltacal_gen.results.published import FOLDER, file_of
from deltacal_gen.results.reader import read_answer
from tests.support.commands import Run


@pytest.fixture
def shop(tmp_path: Path) -> Path:
    """A folder with the embedded example's robot and recording."""
    for name in ("robot.toml", "recording.csv", "recording.toml"):
        (tmp_path / name).write_text((example() / name).read_text())
    return tmp_path


def edited(path: Path, line: int, column: str, value: str) -> None:
    """Write `value` into a cell of a CSV; lines count from 1, the header is line 1."""
    rows = [row.split(",") for row in path.read_text().splitlines()]
    rows[line - 1][rows[0].index(column)] = value
    path.write_text("\n".join(",".join(row) for row in rows) + "\n")


def without_labels(path: Path) -> None:
    """Remove the column of pose labels, the first, so that a changed joint contradicts no repeat."""
    path.write_text("\n".join(row.split(",", 1)[1] for row in path.read_text().splitlines()) + "\n")


def test_identify_predict_compensate_hang_together(run: Run, shop: Path) -> None:
    result = shop / "result.json"
    code, out, _ = run("identify", shop / "robot.toml", shop / "recording.csv", "-o", result, "--json")
    assert code == 0
    found = json.loads(out)
    assert found == json.loads(result.read_text())
    assert found["schema"] == "deltacal.result/1"
    assert found["heldout_rms_mm"] < 0.006  # the instrument's noise is 0.005
    assert {p["status"] for p in found["parameters"]} <= {"identified", "pinned by prior", "not pinned", "fixed"}
    assert all(p["std"] is None for p in found["parameters"] if p["status"] == "not pinned")

    assert run("predict", result, shop / "recording.csv", "-o", shop / "predicted.csv")[0] == 0
    measured, predicted = (
        np.genfromtxt(shop / name, delimiter=",", names=True)["x_mm"] for name in ("recording.csv", "predicted.csv")
    )
    assert np.std(measured - predicted) < 0.006

    (shop / "targets.csv").write_text("x_mm,y_mm,z_mm\n0,0,-853\n300,-200,-900\n")
    assert run("compensate", result, shop / "targets.csv", "-o", shop / "joints.csv")[0] == 0
    joints = np.genfromtxt(shop / "joints.csv", delimiter=",", names=True)
    assert len(joints) == 2
    assert run("compensate", result, "--export", "c", "-o", shop / "compensator.c")[0] == 0
    assert "deltacal_compensate" in (shop / "compensator.c").read_text()

    code, out, _ = run("validate", result, shop / "recording.csv", "--json")
    assert code == 0
    assert json.loads(out)["iso9283"]["RP_mean_mm"] < 0.03


def test_simulate_then_identify_recovers_what_was_put_in(run: Run, tmp_path: Path) -> None:
    robot = example() / "robot.toml"
    (tmp_path / "truth.toml").write_text("[parameters]\ntheta_2 = 0.4\nL_3 = -0.7\n")
    recording = tmp_path / "recording.csv"
    assert run("simulate", robot, example() / "poses.csv", "--truth", tmp_path / "truth.toml", "-o", recording)[0] == 0
    code, out, _ = run("identify", robot, recording, "--model", "delta/18", "--json")
    assert code == 0
    values = {p["name"]: p["value"] for p in json.loads(out)["parameters"]}
    assert values["theta_2"] == pytest.approx(0.4, abs=1e-6)
    assert values["L_3"] == pytest.approx(-0.7, abs=1e-6)
    assert values["L_1"] == pytest.approx(0.0, abs=1e-6)


def test_poses_without_a_sidecar_are_read_in_the_robots_frame(run: Run, tmp_path: Path) -> None:
    (tmp_path / "poses.csv").write_text("x_mm,y_mm,z_mm\n0,0,-853\n100,0,-800\n0,200,-900\n")
    code, _, _ = run("simulate", example() / "robot.toml", tmp_path / "poses.csv", "-o", tmp_path / "out.csv")
    assert code == 0
    read = np.genfromtxt(tmp_path / "out.csv", delimiter=",", names=True)
    assert read["z_mm"] == pytest.approx([-853, -800, -900], abs=1e-9)
    assert 'frame = "robot"' in (tmp_path / "out.toml").read_text()


def test_matrix_of_the_paper_has_its_shape_and_rank(run: Run, shop: Path) -> None:
    what = ("--model", "delta/36", "--as", "distance", "--scaling", "paper")
    code, out, _ = run("matrix", shop / "robot.toml", shop / "recording.csv", *what, "-o", shop / "H.npz", "--json")
    assert code == 0
    assert json.loads(out)["figures"]["rank"] == 32
    with np.load(shop / "H.npz") as saved:
        assert saved["H"].shape == (len(saved["r"]), 36)
        assert saved["names"][0] == "theta_1"


@pytest.mark.parametrize(
    ("line", "column", "value", "words"),
    [
        (7, "q2_deg", "abc", ("line 7", "q2_deg", "number")),
        (7, "q2_deg", "", ("line 7", "q2_deg")),
        (7, "q2_deg", "nan", ("line 7", "q2_deg")),
        (9, "x_mm", "oops", ("line 9", "x_mm")),
        (2, "q1_deg", "-700", ("q1_deg",)),
    ],
)
def test_bad_cells_are_named_and_nothing_is_written(
    run: Run, shop: Path, line: int, column: str, value: str, words: tuple[str, ...]
) -> None:
    without_labels(shop / "recording.csv")
    edited(shop / "recording.csv", line, column, value)
    code, out, err = run("identify", shop / "robot.toml", shop / "recording.csv", "-o", shop / "result.json")
    assert code == 3
    assert out == ""
    assert "recording.csv" in err
    for word in words:
        assert word in err
    assert not (shop / "result.json").exists()


def test_one_wild_row_is_listed_and_moves_nothing(run: Run, shop: Path) -> None:
    without_labels(shop / "recording.csv")
    edited(shop / "recording.csv", 6, "q1_deg", "60")
    code, out, _ = run("identify", shop / "robot.toml", shop / "recording.csv", "--json")
    assert code == 0
    found = json.loads(out)
    assert 6 in found["gross_errors"]
    assert found["heldout_rms_mm"] < 0.006


def test_a_pose_label_with_two_sets_of_joints_names_both_lines(run: Run, shop: Path) -> None:
    edited(shop / "recording.csv", 3, "q1_deg", "5.0")
    code, _, err = run("identify", shop / "robot.toml", shop / "recording.csv")
    assert code == 3
    assert "2" in err
    assert "line 3" in err


def test_swapped_readings_are_caught_before_they_are_believed(run: Run, shop: Path) -> None:
    path = shop / "recording.csv"
    rows = [row.split(",") for row in path.read_text().splitlines()]
    for column in ("x_mm", "y_mm", "z_mm"):
        c = rows[0].index(column)
        rows[10][c], rows[40][c] = rows[40][c], rows[10][c]
    path.write_text("\n".join(",".join(row) for row in rows) + "\n")
    code, _, err = run("identify", shop / "robot.toml", path)
    assert code == 3
    assert "lines 11 and 41 are swapped" in err


def test_metres_in_a_millimetre_column_are_recognised(run: Run, shop: Path) -> None:
    path = shop / "recording.csv"
    rows = [row.split(",") for row in path.read_text().splitlines()]
    columns = [rows[0].index(c) for c in ("x_mm", "y_mm", "z_mm")]
    for row in rows[1:]:
        for c in columns:
            row[c] = repr(float(row[c]) / 1000)
    path.write_text("\n".join(",".join(row) for row in rows) + "\n")
    code, _, err = run("identify", shop / "robot.toml", path)
    assert code == 3
    assert "metres" in err


def test_an_empty_recording_and_a_missing_file_are_said_plainly(run: Run, shop: Path) -> None:
    (shop / "recording.csv").write_text("")
    code, _, err = run("identify", shop / "robot.toml", shop / "recording.csv")
    assert code == 3
    assert "empty" in err
    code, _, err = run("identify", shop / "robot.toml", shop / "absent.csv")
    assert code == 3
    assert "absent.csv" in err


def test_a_misspelt_robot_key_is_answered_with_the_right_one(run: Run, shop: Path) -> None:
    path = shop / "robot.toml"
    path.write_text(path.read_text().replace("proximal_length", "proximal_lenght"))
    code, _, err = run("identify", path, shop / "recording.csv")
    assert code == 3
    assert "proximal_length" in err
    assert "robot.toml, line" in err


def test_too_few_readings_say_how_many_are_needed(run: Run, shop: Path) -> None:
    lines = (shop / "recording.csv").read_text().splitlines()
    (shop / "few.csv").write_text("\n".join(lines[:8]) + "\n")
    (shop / "few.toml").write_text((shop / "recording.toml").read_text())
    code, _, err = run("identify", shop / "robot.toml", shop / "few.csv", "--model", "delta/42")
    assert code == 3
    assert "48 are needed" in err  # 42 parameters, 6 of the frame; the sidecar declares the noise


def test_an_unreachable_target_is_no_solution(run: Run, shop: Path) -> None:
    (shop / "far.csv").write_text("x_mm,y_mm,z_mm\n0,0,-853\n0,0,-5000\n")
    code, _, err = run("simulate", shop / "robot.toml", shop / "far.csv", "-o", shop / "out.csv")
    assert code == 4
    assert "line 3" in err
    assert not (shop / "out.csv").exists()


def test_usage_errors_have_their_own_code(run: Run, shop: Path) -> None:
    assert run("identify", shop / "robot.toml", shop / "recording.csv", "--model", "delta/99")[0] == 2
    assert run("identify", shop / "robot.toml", shop / "recording.csv", "--method", "magic")[0] == 2
    assert run("identify")[0] == 2
    assert run("nonsense")[0] == 2


def test_a_result_that_is_no_result_is_refused(run: Run, shop: Path) -> None:
    (shop / "result.json").write_text("{}")
    code, _, err = run("predict", shop / "result.json", shop / "recording.csv", "-o", shop / "out.csv")
    assert code == 3
    assert "result.json" in err


def test_models_lists_every_parameter_with_unit_and_meaning(run: Run) -> None:
    code, out, _ = run("models", "--json")
    assert code == 0
    delta = next(m for m in json.loads(out) if m["mechanism"] == "delta")
    assert len(delta["parameters"]) == 42
    assert all(p["meaning"] and p["unit"] for p in delta["parameters"])
    assert len(delta["models"]["delta/32"]) == 32


def test_kernels_outside_a_checkout_say_so(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(checkout, "find_checkout", lambda: None)
    code, _, err = run("kernels")
    assert code == 2
    assert "source checkout" in err


def test_nothing_at_run_time_imports_sympy() -> None:
    rooms = ("app.cli", "diagnosis.diagnosis", "planning.planning")
    code = f"import sys, {', '.join(f'deltacal_gen.{room}' for room in rooms)}; sys.exit('sympy' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code]).returncode == 0


def test_an_error_has_a_code_that_is_explained(run: Run, shop: Path) -> None:
    code, out, err = run("identify", shop / "robot.toml", shop / "absent.csv", "--json")
    found = json.loads(out)
    assert (code, found["code"], found["exit_code"]) == (3, "file-not-readable", 3)
    assert found["file"].endswith("absent.csv")
    assert err.startswith("error[file-not-readable]: ")
    code, out, _ = run("explain", found["code"])
    assert code == 0
    assert out.startswith("# file-not-readable\n")
    assert "permissions" in out
    code, _, err = run("explain", "nothing-of-that")
    assert code == 2
    assert "missing-column" in err
    assert run("identify", "--nonsense")[2].startswith("error[command-line]: ")


def test_what_is_no_answer_itself_leaves_a_receipt_as_published(run: Run, shop: Path) -> None:
    (shop / "targets.csv").write_text("x_mm,y_mm,z_mm\n0,0,-853\n300,-200,-900\n")
    robot, recording, result = shop / "robot.toml", shop / "recording.csv", shop / "result.json"
    assert run("identify", robot, recording, "--model", "18", "-o", result)[0] == 0
    figures = {}
    for code, command, written in (
        (0, ("simulate", robot, shop / "targets.csv", "--noise", 0.01, "-o", shop / "s.csv"), ["s.csv", "s.toml"]),
        (0, ("matrix", robot, recording, "--model", "delta/18", "-o", shop / "H.npz"), ["H.npz"]),
        (0, ("predict", result, recording, "-o", shop / "p.csv"), ["p.csv"]),
        (0, ("compensate", result, shop / "targets.csv", "-o", shop / "j.csv"), ["j.csv"]),
        (0, ("compensate", result, shop / "targets.csv"), []),
        (0, ("compensate", result, "--export", "c", "-o", shop / "c.c"), ["c.c"]),
        (0, ("manual", "exit-codes"), []),
        (3, ("predict", result, shop / "absent.csv", "-o", shop / "q.csv"), None),
    ):
        ended, out, _ = run(*command, "--json")
        found = json.loads(out)
        assert ended == code, command
        published = json.loads((FOLDER / file_of(found["schema"])).read_text())
        Draft202012Validator(published).validate(found)
        assert read_answer(found).to_dict() == found
        if written is not None:
            assert found["command"] == command[0]
            assert [Path(name).name for name in found["files"]] == written
            assert all(Path(name).exists() for name in found["files"])
            figures[command[0]] = found["figures"]
    assert figures["simulate"] == {"readings": 2, "kind": "position", "noise_mm": 0.01}
    assert figures["matrix"]["columns"] == figures["matrix"]["rank"] == 18
    assert figures["predict"]["readings"] == len(recording.read_text().splitlines()) - 1


def test_an_old_option_names_the_new_one(run: Run, shop: Path) -> None:
    for command, old, new in (("identify", "--solver", "--method"), ("batch", "--machine", "--group-by")):
        code, _, err = run(command, shop, shop, old, "x")
        assert code == 2
        assert f"{old} of {command} is now called {new}" in err


def test_an_option_of_another_use_is_refused(run: Run, shop: Path) -> None:
    code, _, err = run("plan", shop / "robot.toml", "--model", "18", "--runs", 3)
    assert code == 2
    assert "--runs means nothing here" in err


def test_help_is_found_in_every_way(run: Run) -> None:
    shown = run("identify", "--help")[1]
    assert shown == run("help", "identify")[1]
    assert "Example: deltacal identify" in shown
    code, out, _ = run()
    assert code == 2
    for group in ("Start", "Calibrate", "Diagnose", "Use", "Import", "Review"):
        assert f" {group} " in out
    assert run("-V") == run("--version")


def test_quiet_prints_nothing_and_verbose_what_is_done(run: Run, shop: Path) -> None:
    command = ("identify", shop / "robot.toml", shop / "recording.csv", "--model", "18", "-o", shop / "r.json")
    assert run(*command, "--quiet") == (0, "", "")
    assert "fine stage" in run(*command, "--verbose")[2]


def test_help_imports_nothing_that_computes() -> None:
    code = (
        "import sys; from deltacal_gen.app.cli.application import application;"
        "[application(words).help_print([]) for words in ([], ['identify'])];"
        "sys.exit(bool({'numpy', 'pydantic', 'scipy'} & sys.modules.keys()))"
    )
    assert subprocess.run([sys.executable, "-c", code], stdout=subprocess.DEVNULL).returncode == 0

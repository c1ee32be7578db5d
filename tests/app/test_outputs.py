"""Where outputs go, and how commands end: whatever is asked for, nothing is lost, half or left behind."""

from __future__ import annotations

import hashlib
import json
import os
import platform
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen import __version__
from deltacal_gen.app import cli
from deltacal_gen.app.demonstration import example
from deltacal_gen.files.writing import write_files
from tests.support.commands import Run

ROBOT, RECORDING = example() / "robot.toml", example() / "recording.csv"
linux = pytest.mark.skipif(sys.platform != "linux", reason="devices and links of Linux")


@pytest.fixture(scope="module")
def result(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("known") / "result.json"
    dc.identify(ROBOT, RECORDING, model="delta/18", output=path)
    return path


def test_a_fault_of_ours_is_told_in_one_line_with_its_own_exit_code(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    def broken(*_: object, **__: object) -> None:
        raise KeyError("18")

    monkeypatch.setattr(dc, "models", broken)
    code, out, said = run("models")
    assert (code, out) == (cli.FAULT, "")
    assert "KeyError: '18'" in said
    assert "deltacal_gen/app/cli/application.py:" in said.replace(" ", "")
    assert "Traceback" not in said
    monkeypatch.setenv(cli.TRACEBACK, "1")
    assert "Traceback" in run("models")[2]


def test_stopped_from_the_keyboard_is_130(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    def stopped(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(dc, "models", stopped)
    assert run("models")[0] == 130


def test_the_version_is_told(run: Run) -> None:
    assert run("--version")[:2] == (0, f"deltacal {__version__}\n")


@pytest.mark.walk
def test_a_model_may_be_named_without_its_mechanism(run: Run, tmp_path: Path) -> None:
    page, found = tmp_path / "page.html", tmp_path / "diagnosis.json"
    assert run("diagnose", ROBOT, RECORDING, "--model", "18", "-o", found, "--report", page)[0] == 0
    assert json.loads(found.read_text())["baseline"]["model"] == "delta/18"
    assert page.stat().st_size > 10_000


@linux
@pytest.mark.parametrize("name", ["-", "/dev/stdout"])
def test_the_standard_output_is_written_through(name: str) -> None:
    command = [sys.executable, "-m", "deltacal_gen.app.cli", "identify", ROBOT, RECORDING, "--model", "18", "-o", name]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    assert json.loads(done.stdout)["schema"] == "deltacal.result/1"
    assert "parameters identified" in done.stderr


@pytest.mark.parametrize("command", ["identify", "diagnose"])
def test_two_outputs_are_two_files(run: Run, tmp_path: Path, command: str) -> None:
    both = tmp_path / "both.html"
    code, _, told = run(command, ROBOT, RECORDING, "-o", both, "--report", tmp_path / "." / "both.html")
    assert code == 3
    assert "would overwrite an input or another output" in told
    assert not both.exists()


def test_two_outputs_do_not_go_to_the_standard_output(run: Run) -> None:
    for command in (("identify", ROBOT, RECORDING), ("plan", ROBOT, "--model", "18")):
        code, out, told = run(*command, "--json", "-o", "-")
        assert code == 2
        assert "leave one of them out" in json.loads(out)["error"]
        assert "leave one of them out" in told


@linux
def test_devices_stay_devices(tmp_path: Path) -> None:
    write_files({Path(os.devnull): "text"})
    assert Path(os.devnull).is_char_device()
    with pytest.raises(Exception, match="No space left"):
        write_files({Path("/dev/full"): "text"})


@linux
def test_a_link_stays_a_link(tmp_path: Path) -> None:
    (tmp_path / "far").mkdir()
    link, real = tmp_path / "link.json", tmp_path / "far" / "real.json"
    link.symlink_to(real)
    for text in ("first", "second"):
        write_files({link: text})
        assert link.is_symlink()
        assert real.read_text() == text
    assert [p.name for p in (tmp_path / "far").iterdir()] == ["real.json"]


@linux
def test_what_a_dead_process_left_is_cleared_and_what_a_live_one_makes_is_not(tmp_path: Path) -> None:
    dead = subprocess.Popen([sys.executable, "-c", ""])
    dead.wait()
    left, made = (tmp_path / f".x.json.{n}@{platform.node()}.part" for n in (dead.pid, os.getppid()))
    left.write_text("half")
    made.write_text("half")
    write_files({tmp_path / "x.json": "whole"})
    assert sorted(p.name for p in tmp_path.iterdir()) == sorted([made.name, "x.json"])


def test_a_failure_leaves_what_was_there(tmp_path: Path) -> None:
    path = tmp_path / "x.json"
    path.write_text("old")
    with pytest.raises(UnicodeEncodeError):
        write_files({path: "new", tmp_path / "y.json": "\ud800"})
    assert path.read_text() == "old"
    assert [p.name for p in tmp_path.iterdir()] == ["x.json"]


@linux
def test_killed_at_any_moment_a_file_is_old_or_new(tmp_path: Path) -> None:
    path = tmp_path / "x.txt"
    script = (
        "import sys; from pathlib import Path; from deltacal_gen.files.writing import write_files\n"
        "print('go', flush=True)\n"
        "while True:\n    for c in 'ab': write_files({Path(sys.argv[1]): c * 300_000})\n"
    )
    for k in range(4):
        with subprocess.Popen([sys.executable, "-c", script, str(path)], stdout=subprocess.PIPE) as process:
            assert process.stdout is not None
            process.stdout.readline()
            time.sleep(0.02 + 0.003 * k)
            process.send_signal(signal.SIGKILL)
        assert path.read_text() in ("a" * 300_000, "b" * 300_000)
    write_files({path: "whole"})
    assert [p.name for p in tmp_path.iterdir()] == ["x.txt"]


PHYSICS = '"physics": [{"effect": "%s", "limbs": [1], "values": [[0.1]], "constants": [], "tools": []}]'
OTHERS = {
    "kind": ('"kind": "position", "state"', '"kind": "velocity", "state"', "no kind of measurement"),
    "mechanism": ('"mechanism": "delta"', '"mechanism": "gamma"', "gamma"),
    "effect": ('"physics": []', PHYSICS % "slackness", "there is no effect"),
    "formula": ('"physics": []', PHYSICS % "law joint = c1*", "c1*"),
}


@pytest.mark.parametrize(("before", "after", "expected"), OTHERS.values(), ids=OTHERS.keys())
def test_a_result_of_another_installation_says_what_is_not_here(
    run: Run, result: Path, tmp_path: Path, before: str, after: str, expected: str
) -> None:
    text = result.read_text()
    assert before in text
    other = tmp_path / "other.json"
    other.write_text(text.replace(before, after))
    code, _, said = run("validate", other, RECORDING)
    assert code == 3
    assert expected in said
    assert other.name in said


@pytest.mark.parametrize("turn", [np.diag([1, 1, -1]), -np.eye(3), 2 * np.eye(3)], ids=["mirrored", "point", "long"])
def test_a_frame_that_is_no_rotation_is_bad_input(run: Run, result: Path, tmp_path: Path, turn: np.ndarray) -> None:
    edited = json.loads(result.read_text())
    edited["instrument"]["state"][0][:9] = (
        (turn @ np.reshape(edited["instrument"]["state"][0][:9], (3, 3))).ravel().tolist()
    )
    other = tmp_path / "other.json"
    other.write_text(json.dumps(edited))
    for command in ("validate", "predict"):
        code, _, said = run(command, other, RECORDING, *(["-o", tmp_path / "p.csv"] if command == "predict" else []))
        assert code == 3
        for words in ("other.json", "'instrument.state'", "mirrored or no rotation", "identify again"):
            assert words in " ".join(said.split())


def test_an_answer_says_what_made_it_of_which_files(run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "86400")
    for name in ("robot.toml", "recording.csv"):
        (tmp_path / name).write_bytes((example() / name).read_bytes())
    (tmp_path / "recording.toml").write_text('[measurement]\ninstrument = "tracker <7>"\noperator = "A. B."\n')
    files = [tmp_path / name for name in ("robot.toml", "recording.csv", "recording.toml")]
    result, page = tmp_path / "result.json", tmp_path / "page.html"
    assert run("identify", files[0], files[1], "--model", "18", "-o", result, "--report", page)[0] == 0
    made = json.loads(result.read_text())["made"]
    assert made["version"] == __version__
    assert made["date"] == "1970-01-02"
    assert (made["instrument"], made["operator"]) == ("tracker <7>", "A. B.")
    hashes = {path.name: hashlib.sha256(path.read_bytes()).hexdigest() for path in files}
    assert {entry["name"]: entry["sha256"] for entry in made["inputs"]} == hashes
    text = page.read_text()
    assert "instrument tracker &lt;7&gt;; operator A. B." in text
    assert all(h in text for h in hashes.values())
    code, out, _ = run("validate", result, files[1], "--json")
    assert code == 0
    assert [entry["name"] for entry in json.loads(out)["made"]["inputs"]] == [
        "result.json",
        "recording.csv",
        "recording.toml",
    ]


def test_json_nested_without_end_is_bad_input(run: Run, tmp_path: Path) -> None:
    deep = tmp_path / "deep.json"
    deep.write_text('{"a": ' + "[" * 100_000)
    assert run("validate", deep, RECORDING)[0] == 3

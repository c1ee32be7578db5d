"""`loop`: propose, measure, append, diagnose, until nothing is open or the budget is spent; whole or not at all."""

from __future__ import annotations

import json
import os
import shlex
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

from deltacal_gen.app.loop import first_rows, measured
from deltacal_gen.errors import InputError, UsageError
from deltacal_gen.files.recording import read_recording
from deltacal_gen.files.robot import robot_to_toml
from deltacal_gen.files.writing import write_recording
from deltacal_gen.machine.registry import SOLVED
from tests.conftest import Run
from tests.left_out import DELTA, effect, record
from tests.test_discrimination import LIGHT, NEAR

SOFT = effect("joint_compliance", (1, 2, 3), 0.011)
ROOT = Path(__file__).parents[1]
MEASURING = """
import sys
import numpy as np
from deltacal_gen.files.recording import read_recording
from deltacal_gen.files.writing import csv_text, file_columns
from tests.left_out import DELTA, record
from tests.test_loop import LIGHT, SOFT
asked = read_recording(sys.argv[1], DELTA, need_measured=False)
done = record(LIGHT, SOFT, n=asked.n_rows, seed=asked.n_rows, joints=np.degrees(asked.joints), of=asked.channels)
with open(sys.argv[2], "w") as file:
    file.write(csv_text(file_columns(done)[0] | {"pose": asked.pose.tolist()}))
print("measured", asked.n_rows)
"""


@pytest.fixture
def started(tmp_path: Path) -> Path:
    """A folder with a robot, and a recording that does not tell a soft joint from a soft arm."""
    (tmp_path / "robot.toml").write_text(robot_to_toml(LIGHT), encoding="utf-8")
    write_recording(record(NEAR, SOFT, n=50), tmp_path / "recording.csv")
    (tmp_path / "measure.py").write_text(MEASURING, encoding="utf-8")
    return tmp_path


def python(*words: str) -> str:
    return shlex.join([sys.executable, *words])


def test_a_question_is_settled_by_what_a_command_measures(
    started: Path, run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join([str(ROOT), *sys.path]))
    recording, found = started / "recording.csv", started / "found.json"
    before = recording.read_text(encoding="utf-8").splitlines()
    command = python(str(started / "measure.py"))
    code, said, _ = run("loop", started / "robot.toml", recording, "--measure", command, "-o", found, "--json")
    assert code == 0
    answer = json.loads(said)
    first, *_, last = answer["rounds"]
    assert any("joint_compliance" in why and "proximal_bending" in why for why in first["open"])
    assert (last["effects"], last["open"], last["rows"]) == (["joint_compliance"], [], 0)
    others = json.loads(found.read_text(encoding="utf-8"))["effects"][0]["indistinguishable_from"]
    assert "proximal_bending" not in others
    after = recording.read_text(encoding="utf-8").splitlines()
    assert [line.rstrip(",") for line in after[1 : len(before)]] == before[1:]  # older rows lack the payload
    assert len(after) - len(before) == answer["rows"] == sum(r["rows"] for r in answer["rounds"])


def test_the_budget_is_kept(started: Path, run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join([str(ROOT), *sys.path]))
    recording = started / "recording.csv"
    command = python(str(started / "measure.py"), "{poses}", "{readings}")
    code, said, _ = run("loop", started / "robot.toml", recording, "--measure", command, "--budget", 1)
    assert code == 1
    assert "the budget is spent; 1 rows were measured" in said
    assert read_recording(recording, DELTA).n_rows == 51


@pytest.mark.parametrize(
    ("script", "problem"),
    [
        ("raise SystemExit(7)", "exit code 7"),
        ("", "wrote no readings"),
        ("import sys; open(sys.argv[2], 'w').write('pose,x_mm,y_mm,z_mm\\nnext1,1,2,3\\n')", "measured 1 rows"),
        (
            "import sys; rows = open(sys.argv[1]).read().split()\n"
            "open(sys.argv[2], 'w').write('\\n'.join(['x_mm,y_mm,z_mm', '1,2,oops', '1,2,3']))",
            "oops",
        ),
    ],
)
def test_a_command_that_fails_leaves_the_recording_as_it_was(started: Path, script: str, problem: str) -> None:
    recording = started / "recording.csv"
    before = recording.read_bytes()
    rows = first_rows(LIGHT, 2)
    (started / "measure.py").write_text(script, encoding="utf-8")
    with pytest.raises(InputError, match=problem):
        measured(LIGHT, recording, [sys.executable, str(started / "measure.py")], rows)
    assert recording.read_bytes() == before
    with pytest.raises(UsageError, match="cannot be run"):
        measured(LIGHT, recording, ["no-such-command"], rows)


def test_what_the_command_does_not_repeat_stands_as_it_was_asked_for(tmp_path: Path) -> None:
    recording = tmp_path / "new.csv"
    script = "import sys; open(sys.argv[2], 'w').write('x_mm,y_mm,z_mm,oil_C\\n1,2,-800,40\\n1,5,-800,\\n')"
    rows = [row | {"payload_kg": 1.5} for row in first_rows(LIGHT, 2)]
    for _ in range(2):
        measured(LIGHT, recording, [sys.executable, "-c", script], rows)
    read = read_recording(recording, DELTA)
    assert read.n_rows == 4
    assert read.channels["payload_kg"].tolist() == [1.5] * 4
    assert np.isnan(read.channels["oil_C"]).tolist() == [False, True, False, True]


def test_it_begins_with_poses_all_over_the_workspace() -> None:
    rows = first_rows(LIGHT, 500)
    assert len(rows) == len(DELTA.model(DELTA.full_model))
    q = np.radians([[row[f"q{i}_deg"] for i in (1, 2, 3)] for row in rows])
    x, status = DELTA.forward(q, LIGHT.tool, DELTA.rows(LIGHT))
    assert (status == SOLVED).all()
    assert (np.ptp(x[:, :3], axis=0) > 150).all()
    assert len(first_rows(LIGHT, 10)) == 10


@pytest.mark.skipif(os.name == "nt", reason="no signals")
def test_stopped_from_the_keyboard_while_the_command_measures(started: Path) -> None:
    recording, sign = started / "recording.csv", started / "begun"
    (started / "measure.py").write_text(
        f"import time; open({str(sign)!r}, 'w').close(); time.sleep(60)", encoding="utf-8"
    )
    before = recording.read_bytes()
    words = ["loop", "robot.toml", "recording.csv", "--measure"]
    # a job that a shell starts in the background ignores Ctrl-C, and so would what it starts
    heard = "import signal; signal.signal(signal.SIGINT, signal.default_int_handler)"
    program = f"{heard}; import runpy; runpy.run_module('deltacal_gen.app.cli', run_name='__main__', alter_sys=True)"
    process = subprocess.Popen(
        [sys.executable, "-c", program, *words, python(str(started / "measure.py"))],
        cwd=started,
        env=os.environ | {"PYTHONPATH": os.pathsep.join([str(ROOT), *sys.path])},
        start_new_session=True,
    )
    deadline = time.monotonic() + 100
    while not sign.exists() and time.monotonic() < deadline:
        time.sleep(0.1)
    os.killpg(process.pid, signal.SIGINT)
    assert process.wait(30) == 130
    assert recording.read_bytes() == before
    assert not list(started.glob("*.tmp*"))

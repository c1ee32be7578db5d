"""Windows, as far as it can be had elsewhere: code pages on the screen, line ends, names, no default encoding."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from deltacal_gen.app.demonstration import example

SOURCE = example("delta")
WARNED = ("-X", "warn_default_encoding", "-W", "error::EncodingWarning:deltacal_gen")  # by what a computer is set to
COMMANDS = (
    "identify {}/robot.toml {}/recording.csv --model delta/3 -o {}/é.json --report {}/r.html --picture {}/p.svg",
    "compensate {}/é.json {}/targets.csv -o {}/joints.csv",
    "predict {}/é.json {}/recording.csv -o {}/predicted.csv",
    "models",
    "manual compensate",
)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with blanks and letters beyond ASCII in its name, its files with the line ends of Windows."""
    folder = tmp_path_factory.mktemp("Prüfstand µ 1")
    for name in ("robot.toml", "recording.csv", "recording.toml"):
        (folder / name).write_bytes((SOURCE / name).read_bytes().replace(b"\n", b"\r\n"))
    (folder / "targets.csv").write_bytes(b"x_mm;y_mm;z_mm\r\n0,5;0,25;-853,125\r\n")
    return folder


@pytest.mark.walk
@pytest.mark.parametrize(
    "code_page",
    [pytest.param("cp1252", marks=pytest.mark.thorough), pytest.param("cp437", marks=pytest.mark.thorough), "ascii"],
)
def test_commands_end_well_on_a_screen_with_few_letters(folder: Path, code_page: str) -> None:
    screen = os.environ | {"PYTHONIOENCODING": code_page, "PYTHONUTF8": "0"}
    script = (
        "import sys\n"
        "from deltacal_gen.app import cli\n"
        f"for line in {COMMANDS!r}:\n"
        f"    sys.argv = ['deltacal', *(word.replace('{{}}', {str(folder)!r}) for word in line.split())]\n"
        "    try:\n"
        "        cli.main()\n"
        "    except SystemExit as end:\n"
        "        assert not end.code, (line, end.code)\n"
    )
    done = subprocess.run([sys.executable, *WARNED, "-c", script], capture_output=True, env=screen, check=False)
    assert done.returncode == 0, done.stderr.decode(code_page, errors="replace")
    assert b"identified" in done.stdout
    for name in ("é.json", "r.html", "joints.csv", "predicted.csv"):
        assert "\r" not in (folder / name).read_bytes().decode("utf-8"), name


def test_what_is_told_of_a_line_is_right_with_the_ends_of_windows(folder: Path, tmp_path: Path) -> None:
    rows = (folder / "recording.csv").read_bytes().split(b"\r\n")
    cells = rows[4].split(b",")
    cells[1] = b"x"
    (tmp_path / "bad.csv").write_bytes(b"\r\n".join([*rows[:4], b",".join(cells), *rows[5:]]))
    words = ["identify", str(folder / "robot.toml"), str(tmp_path / "bad.csv")]
    done = subprocess.run(
        [sys.executable, "-m", "deltacal_gen.app.cli", *words], capture_output=True, text=True, check=False
    )
    assert done.returncode == 3
    assert "bad.csv, line 5, column 'q1_deg': the cell holds 'x'" in done.stderr

"""Copies of the checkout to which somebody adds a file, and commands that are run on them."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
UNFINISHED = ("*.pyc.*", "*.part")  # what another process is writing
COMMANDS = """
import json, sys
from deltacal_gen.app import cli
for line in json.loads(sys.argv[1]):
    sys.argv[1:] = line
    try:
        cli.main()
    except SystemExit as end:
        if end.code:
            raise
    print(end="\\0", flush=True)
"""


def copied(folder: Path, *parts: str, without: Sequence[str] = ()) -> None:
    """Copy folders of the checkout, with what was compiled of them: modules would otherwise be compiled again."""
    for part in parts:
        shutil.copytree(ROOT / part, folder / part, ignore=shutil.ignore_patterns(*UNFINISHED, *without))


def called(folder: Path, *arguments: object, paths: Sequence[Path], where: str = ".") -> str:
    """Run Python on a copy; return what it printed."""
    done = subprocess.run(
        [sys.executable, *map(str, arguments)],
        cwd=folder / where,
        env=os.environ | {"PYTHONPATH": os.pathsep.join(map(str, paths)), "PYTHONHASHSEED": "0"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def commanded(folder: Path, *lines: Sequence[object], paths: Sequence[Path], where: str = ".") -> list[str]:
    """Run command lines of ``deltacal`` on a copy, in one process, which imports once; return what each printed."""
    given = json.dumps([[str(word) for word in line] for line in lines])
    *said, rest = called(folder, "-c", COMMANDS, given, paths=paths, where=where).split("\0")
    assert not rest
    return said

"""Copies of the checkout to which somebody adds a file, and commands and tests that are run on them."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from deltacal_gen.app.cli.table import COMMANDS
from deltacal_gen.pages import manual
from tests.support import shared

ROOT = Path(__file__).resolve().parents[2]
APART = ("tests/benchmarks/", "tests/proof/")
UNFINISHED = ("*.pyc.*", "*.part")  # what another process is writing
OTHERS = {  # commands that no file of a registry changes
    "kernels": "derived what was added before anything else",
    "demo": "one recording, of a machine of the package's own",
    "claims": "of papers",
    "reproduce": "of papers",
    "manual": "pages",
    "import": "what other programs keep, of machines that they know",
    "explain": "of errors",
}
LINES = """
import json, sys
from deltacal_gen.app import cli
for line in json.loads(sys.argv[1]):
    sys.argv[1:] = line
    try:
        cli.main()
    except SystemExit as end:
        if end.code and (line[0], end.code) != ("next", 1):  # nothing is open: an answer
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
    *said, rest = called(folder, "-c", LINES, given, paths=paths, where=where).split("\0")
    assert not rest
    return said


def printed(topic: str, name: str) -> str:
    """Return the file that a page of the manual prints of what is called `name`."""
    page = (manual.folder() / f"{topic}.md").read_text(encoding="utf-8")
    (text,) = (block for block in re.findall(r"```python.*?\n(.*?)```", page, re.S) if f'name="{name}"' in block)
    return str(text)


@dataclass(frozen=True)
class Checkout:
    """A copy of the checkout to which one file was added, or a few: `names` of a registry (``mechanisms``)."""

    folder: Path
    registry: str
    names: tuple[str, ...]

    @classmethod
    def with_files(cls, folder: Path, registry: str, texts: Mapping[str, str]) -> Checkout:
        """Copy the checkout, write the files, and derive what they add."""
        copied(folder, "derive", "templates", "generated", "src", "tests")
        shutil.copy(ROOT / "pyproject.toml", folder)
        for name, text in texts.items():
            (folder / "derive" / registry / f"{name}.py").write_text(text, encoding="utf-8")
        made = cls(folder, registry, tuple(texts))
        made.python("-m", "derive", *texts)  # what `deltacal kernels NAME` starts
        return made

    @property
    def name(self) -> str:
        """The first of what was added."""
        return self.names[0]

    @property
    def paths(self) -> list[Path]:
        return [self.folder, self.folder / "generated", self.folder / "src"]

    def python(self, *arguments: object, where: str = ".") -> str:
        """Run Python; return what it printed."""
        return called(self.folder, *arguments, paths=self.paths, where=where)

    def deltacal(self, *lines: Sequence[object], where: str = ".") -> list[str]:
        """Run command lines of ``deltacal``; return what each printed."""
        return commanded(self.folder, *lines, paths=self.paths, where=where)

    def passed(self) -> set[str]:
        """Run what its registry gives to tests one by one, for what was added; return the tests that passed.

        Those of benchmarks and proofs are in `all_passed`.
        """
        files = [file for file in shared.parametrised(self.registry) if not file.startswith(APART)]
        return self._tested("-k", " or ".join(self.names), *files)

    def all_passed(self) -> set[str]:
        """Run this with what takes minutes, and the tests that run over all that the registry has at once."""
        looping, by_name = shared.looping(self.registry), shared.parametrised(self.registry)
        every = " or ".join(self.names)
        said = self.python("-m", "pytest", "-q", "-n0", "-m", "", "-k", every, "--collect-only", "tests")
        own = re.compile(rf"\[.*({'|'.join(self.names)})(?!\w)")  # "forward_rrr" is of rrr, "probe_eddy" of no probe
        of_them = (line for line in said.splitlines() if own.search(line))
        collected = {line.partition("::")[0] for line in of_them}
        unseen = {file for file in collected - {*by_name} if not file.startswith("tests/whole/test_add")}
        assert not unseen, f"their tests ask the registry in a way that `shared` does not follow: {unseen}"
        asked = " or ".join([every, *(test.partition("::")[2] for test in looping)])
        return self._tested("-m", "", "-k", asked, *{*by_name, *(test.partition("::")[0] for test in looping)})

    def _tested(self, *arguments: str) -> set[str]:
        said = self.python("-m", "pytest", "-q", "-rp", "-n0", *arguments)
        return set(re.findall(r"^PASSED (\S+)", said, re.M))


def untried(*lines: Sequence[object]) -> set[str]:
    """Return the commands that stand in no line and concern what was added."""
    names = {name for group in COMMANDS.values() for name in group}
    return names - {str(line[0]) for line in lines} - OTHERS.keys()

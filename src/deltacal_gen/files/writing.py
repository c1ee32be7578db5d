"""Recordings and other tables as files, written all or nothing."""

from __future__ import annotations

import csv
import glob
import io
import os
import platform
import stat
import sys
import tempfile
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import SupportsFloat

import numpy as np

from deltacal_gen.errors import FileNotWritable, OutputName
from deltacal_gen.files.columns import ONE_SETUP, TOOL, Column, Columns, distances_path
from deltacal_gen.files.rows import PARQUET
from deltacal_gen.files.sidecar import sidecar_text
from deltacal_gen.machine.rotation import to_vector
from deltacal_gen.machine.values import POSITION, ROTATION, Recording
from deltacal_gen.units import DEG, joint_names, of_joints, to_file

TURN_DIGITS = 9  # of deg: what a rotation matrix and the solution of a pose keep of a turn, and no rounding


def write_recording(recording: Recording, path: str | Path) -> None:
    """Write a recording as CSV with its sidecar and, where there are pairs, its distances file: all or nothing.

    Raises
    ------
    InputError
        A file cannot be written, or the distances file of another recording is in the way.
    """
    path = Path(path)
    if path.suffix.lower() == PARQUET:
        raise OutputName("recordings are written as CSV.", "Choose a name that ends with .csv.", file=path)
    distances = distances_path(path)
    columns, pair_columns = file_columns(recording)
    files = {path.with_suffix(".toml"): sidecar_text(recording)}
    if pair_columns:
        files[distances] = csv_text(pair_columns)
    elif distances.exists():
        raise OutputName(
            f"the file is in the way: it would be read as the distances of {path.name}.",
            "Remove it, or choose another name for the recording.",
            file=distances,
        )
    write_files(files | {path: csv_text(columns)})


def file_columns(recording: Recording) -> tuple[Columns, Columns]:
    """Columns of the recording and of its distances, in the units of the files."""
    poses = recording.pose.tolist()
    if recording.pairs is not None and len(set(poses)) < len(poses):
        poses = [str(n + 1) for n in range(len(poses))]  # distances name rows by their pose
    columns: Columns = {"pose": poses}
    if recording.targets is not None:
        axes = 3 if "z_mm" in recording.columns or recording.targets[:, 2].any() else 2  # in the plane there is no z
        columns |= zip(POSITION[:axes], recording.targets.T[:axes], strict=True)
        if recording.targets.shape[1] > 3:
            turned = np.round(to_vector(recording.targets[:, 3:].reshape(-1, 3, 3)) / DEG, TURN_DIGITS) + 0.0
            columns |= list(zip(ROTATION, turned.T, strict=True))[0 if axes == 3 else 2 :]
        if np.isfinite(recording.measured).all() and not set(recording.columns) & set(columns):  # what shall be touched
            columns |= zip(recording.columns, recording.measured.T, strict=True)
    else:
        unit, count = recording.joint_unit, recording.joints.shape[1]
        each = zip(joint_names(unit, count), of_joints(unit, count), recording.joints.T, strict=True)
        columns |= {name: [to_file(value, u) for value in q] for name, u, q in each}
        for name, values in zip(recording.columns, recording.measured.T, strict=False):
            columns[name] = [to_file(value, "rad" if name.endswith("_deg") else "mm") for value in values]
    if recording.contact is not None:
        columns["contact"] = recording.contact.tolist()
    if recording.setup_names != ONE_SETUP:
        columns["setup"] = [recording.setup_names[code] for code in recording.setup]
    if recording.tool is not None:
        columns |= zip(TOOL, recording.tool.T, strict=True)
    columns |= recording.channels
    if recording.pairs is None or recording.pair_measured is None:
        return columns, {}
    a, b = ([poses[row] for row in rows] for rows in recording.pairs.T)
    return columns, {"pose_a": a, "pose_b": b, "distance_mm": recording.pair_measured}


def csv_text(columns: Mapping[str, Column]) -> str:
    """CSV text of columns of one length: texts as they are, numbers with all their digits, nan as a blank cell."""
    text = io.StringIO()
    plain, quoted = csv.writer(text, lineterminator="\n"), csv.writer(text, lineterminator="\n", quoting=csv.QUOTE_ALL)
    plain.writerow(columns)
    for row in zip(*columns.values(), strict=True):
        cells = [_cell(value) for value in row]
        # Unquoted, a row that begins with # would read as a comment.
        (quoted if cells[0].startswith("#") else plain).writerow(cells)
    return text.getvalue()


def _cell(value: str | SupportsFloat) -> str:
    if isinstance(value, str):
        return value
    number = float(value)
    return "" if np.isnan(number) else repr(number).removesuffix(".0")


def write_files(files: Mapping[Path, str | bytes]) -> None:
    """Write files, texts in UTF-8, replacing old ones only when all are on the disk; raises InputError."""
    with staging(files) as parts:
        for path, content in files.items():
            parts[path].write_bytes(content if isinstance(content, bytes) else content.encode())


def make_folder(path: Path) -> None:
    """Make a folder, and those that it is in; raises InputError where it cannot be made."""
    try:
        path.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise FileNotWritable(f"the folder cannot be made: {error.strerror}.", "Choose another.", file=path) from None


@contextmanager
def staging(paths: Iterable[Path]) -> Iterator[dict[Path, Path]]:
    """Yield where to write each of the files; they appear, all of them, when the block has ended well.

    A link stays a link: the file that it leads to is replaced. What is no file on a disk (``-`` for the standard
    output, a terminal, a pipe, /dev/null) is written through.

    Raises
    ------
    InputError
        A file cannot be written; what was there before is untouched, and nothing is left beside it.
    """
    parts: dict[Path, Path] = {}
    path = Path()
    try:
        for path in paths:
            parts[path] = _part(path)
        yield parts
        for path, part in parts.items():
            if is_stream(path):
                _write_through(part, path)
            else:
                os.replace(part, path.resolve())
    except OSError as error:
        at = next((path for path, part in parts.items() if str(part) == error.filename), path)
        raise FileNotWritable(
            f"the file cannot be written: {error.strerror or error}.",
            "Check the folder and the space on the disk.",
            file=at,
        ) from None
    finally:
        for part in parts.values():
            with suppress(OSError):  # of a folder that has gone
                part.unlink(missing_ok=True)


def is_stream(path: Path) -> bool:
    """Tell whether an output is no file on a disk, to be written through instead of replaced."""
    if is_standard_output(path) or path.absolute().parts[1:2] in (("dev",), ("proc",)):
        return True
    try:
        return not stat.S_ISREG(path.stat().st_mode)
    except OSError:  # not there yet
        return False


def is_standard_output(path: Path) -> bool:
    """Tell whether an output is the standard output."""
    return str(path) in ("-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1")


def _write_through(part: Path, path: Path) -> None:
    content = part.read_bytes()
    if not is_standard_output(path):
        with path.open("wb") as stream:
            stream.write(content)
        return
    sys.stdout.flush()
    if (raw := getattr(sys.stdout, "buffer", None)) is not None:
        raw.write(content)
        raw.flush()
    else:  # of a notebook
        sys.stdout.write(content.decode())


def _part(path: Path) -> Path:
    """Return where a file is made before it takes its name, in the same folder; clear what dead processes left."""
    if is_stream(path):
        return Path(tempfile.gettempdir(), f"deltacal.{os.getpid()}.{path.name}.part")
    target = path.resolve()
    for left in target.parent.glob(f".{glob.escape(target.name)}.*@{platform.node()}.part"):
        if not _alive(left.name.removesuffix(".part").rpartition("@")[0].rpartition(".")[2]):
            left.unlink(missing_ok=True)
    return target.with_name(f".{target.name}.{os.getpid()}@{platform.node()}.part")


def _alive(process: str) -> bool:
    """Tell whether a process of this machine, by its number, may still be at work."""
    if os.name == "nt" or not process.isdecimal():  # there os.kill ends a process, whatever the signal
        return True
    try:
        os.kill(int(process), 0)
    except ProcessLookupError:
        return False
    except OSError:  # another user's
        return True
    return True

"""Answers that stand for what functions return as arrays and recordings: what was written, in numbers and words."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

Given = Mapping[str, Any]  # what the command line gave
Told = tuple[str, ...]


def simulated(found: Any, given: Given, told: Told) -> Any:
    """Return what stands for a simulated recording."""
    from deltacal_gen.results.written import Simulated

    rows = found.n_rows if found.pairs is None else len(found.pairs)
    noise = _noise_in_words(found, given.get("noise", 0.0))
    return Simulated(recording=str(given["output"]), readings=rows, kind=found.kind, noise=noise)


def _noise_in_words(found: Any, noise: float) -> str | None:
    """Return the unit in which noise was taken, in words, where that is not mm alone."""
    from deltacal_gen.instrument.kinds import kind_of
    from deltacal_gen.results.reader import KINDS_IN_MOTION

    if not noise or found.kind in KINDS_IN_MOTION:
        return None
    kind, rotations = kind_of(found.kind), found.measurement.sigma_deg
    if kind.rotations:
        return f"noise: {noise:g} mm of positions, {rotations:.3g} deg of rotations"
    unit = kind.unit_in(found.columns)
    return None if unit == "mm" else f"noise: {noise:g} {unit} of each reading"


def matrix(found: Any, given: Given, told: Told) -> Any:
    """Return what stands for an identification matrix."""
    from deltacal_gen.identification.identifiability import observability
    from deltacal_gen.results.written import Matrix

    rows, columns = found["H"].shape
    words = {key: tuple(map(str, found[key])) for key in ("combinations", "unidentifiable") if key in found}
    seen = None if words else observability(found["H"], rows)
    return Matrix(
        file=str(given["output"]),
        rows=rows,
        columns=columns,
        rank=len(words["combinations"]) if seen is None else seen.rank,
        condition=seen.condition if seen is not None and seen.rank == columns else None,
        scaling=str(found["scaling"]),
        combinations=words.get("combinations"),
        unidentifiable=words.get("unidentifiable"),
    )


def commanded(found: Any, given: Given, told: Told) -> Any:
    """Return what stands for commands, an export, or commands along a trajectory."""
    import numpy as np

    from deltacal_gen.results.written import FedForward, Joints

    file = str(given["output"]) if "output" in given else None
    if given.get("trajectory"):
        columns = tuple(found.columns_of_file())
        how = {"joints": found.joints_in_files, "torques": found.torque, "units": found.units}
        return FedForward(columns=columns, **how, told=told, file=file)
    export, kind = given.get("export"), given.get("method", "exact")
    joints, firmware = (np.zeros((0, 3)), found) if export else (found, None)
    return Joints(kind=kind, export=export, joints=joints, assumed=told, firmware=firmware, file=file)


def predicted(found: Any, given: Given, told: Told) -> Any:
    """Return what stands for predicted readings."""
    from deltacal_gen.machine.values import Recording
    from deltacal_gen.results.written import Predicted
    from deltacal_gen.use.prediction import CORRECTED

    if not isinstance(found, Recording):
        kind, rows = found.said.measurement.kind, found.n_rows
        told = (*told, "At rest, where friction is not known, samples are blank.")
    else:
        kind, rows = found.kind, found.n_rows if found.pairs is None else len(found.pairs)
        share = found.channels.get(CORRECTED)
        if share is not None and (share < 1).any():
            told = (
                *told,
                f"{(share < 1).sum()} of {len(share)} rows lie outside what was measured for the smooth correction; it "
                f"fades there and at {(share == 0).sum()} of them nothing is corrected (column {CORRECTED})",
            )
    return Predicted(file=str(given["output"]), kind=kind, readings=rows, told=told)


def imported(found: Any, given: Given, told: Told) -> Any:
    """Return what stands for an import."""
    from deltacal_gen.results.written import Imported

    return Imported(
        folder=str(given["output"]),
        robot=None if found.robot is None else "robot.toml",
        recordings=tuple(f"{name}.csv" for name in found.recordings),
        warnings=tuple(found.warnings),
    )


def claims(found: Any, given: Given, told: Told) -> Any:
    """Return claims; those that stand on a page without their texts."""
    from deltacal_gen.results.registered import WrittenClaims

    return WrittenClaims(found) if "output" in given else found


def page(found: str, given: Given, told: Told) -> Any:
    """Return what stands for a page of the manual."""
    from deltacal_gen.pages.manual import CONTENTS
    from deltacal_gen.results.written import Manual

    topic = given.get("topic") or given.get("code")
    files = tuple(found.splitlines()) if topic is None and "examples" in given else ()
    return Manual(topic=topic or CONTENTS, text=None if files else found, files=files)

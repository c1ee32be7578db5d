"""Receipts for what functions return as arrays and recordings: what was written, in numbers and words."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

Given = Mapping[str, Any]  # what the command line gave
Told = tuple[str, ...]


def receipt(command: str, given: Given, summary: str, **what: Any) -> Any:
    """Return the receipt of a command; its file is the output, where there is one and nothing else is said."""
    from deltacal_gen.results.written import Receipt

    files = (str(given["output"]),) if "output" in given else ()
    return Receipt(command=command, summary=summary, **{"files": files, **what})


def simulated(found: Any, given: Given, told: Told) -> Any:
    """Return the receipt of a simulated recording."""
    from deltacal_gen.instrument.kinds import kind_of
    from deltacal_gen.results.reader import KINDS_IN_MOTION

    figures, files = _read(found), (str(given["output"]), str(Path(given["output"]).with_suffix(".toml")))
    if (sigma := given.get("noise")) and found.kind not in KINDS_IN_MOTION:
        kind = kind_of(found.kind)
        figures[f"noise_{kind.unit_in(found.columns)}"] = sigma
        figures |= {"noise_deg": found.measurement.sigma_deg} if kind.rotations else {}
    noise = ", ".join(f"{value:.3g} {name[6:]}" for name, value in figures.items() if name.startswith("noise_"))
    notes = (f"noise of a reading: {noise}",) if noise else ()
    summary = f"{figures['readings']} readings of the kind {found.kind}"
    return receipt("simulate", given, summary, files=files, figures=figures, notes=notes)


def _read(found: Any) -> dict[str, Any]:
    """Return how many readings a recording holds, and of which kind."""
    rows = found.n_rows if found.pairs is None else len(found.pairs)
    return {"readings": rows, "kind": found.kind}


def matrix(found: Any, given: Given, told: Told) -> Any:
    """Return the receipt of an identification matrix; in motion with the combinations that the samples determine."""
    from deltacal_gen.identification.identifiability import observability
    from deltacal_gen.results.document import number

    rows, columns = found["H"].shape
    words = {key: tuple(map(str, found[key])) for key in ("combinations", "unidentifiable") if key in found}
    seen = None if words else observability(found["H"], rows)
    rank = len(words["combinations"]) if seen is None else seen.rank
    condition = seen.condition if seen is not None and seen.rank == columns else None
    size = f"H {rows} x {columns}, rank {rank}, condition {number(condition)} (scaling {found['scaling']})"
    sizes = {"rows": rows, "columns": columns, "rank": rank, "condition": condition, "scaling": str(found["scaling"])}
    notes = tuple(f"{name}: {'; '.join(each)}" for name, each in words.items())
    return receipt("matrix", given, size, figures=sizes | words, notes=notes)


def commanded(found: Any, given: Given, told: Told) -> Any:
    """Return the receipt of commands, of an export, or of commands along a trajectory."""
    import numpy as np

    if given.get("trajectory"):
        table = {name: column for name, column in found.columns_of_file().items() if name != "run"}
        what = {"columns": tuple(table), "rows": np.column_stack(list(table.values()))}
        summary = f"{len(found.torque)} samples with joints and torques"
    elif export := given.get("export"):
        kind = given.get("method", "exact")
        what = {"figures": {"export": export, "method": kind}, "firmware": found}
        summary = f"{kind} compensator; its error is stated in the file"
    else:
        what, summary = {"rows": found}, f"{len(found)} commands"
    return receipt("compensate", given, summary, notes=told, **what)


def predicted(found: Any, given: Given, told: Told) -> Any:
    """Return the receipt of predicted readings."""
    from deltacal_gen.machine.values import Recording
    from deltacal_gen.use.prediction import CORRECTED

    if not isinstance(found, Recording):
        told = (*told, "At rest, where friction is not known, samples are blank.")
    elif (share := found.channels.get(CORRECTED)) is not None and (share < 1).any():
        told = (
            *told,
            f"{(share < 1).sum()} of {len(share)} rows lie outside what was measured for the smooth correction; it "
            f"fades there and at {(share == 0).sum()} of them nothing is corrected (column {CORRECTED})",
        )
    figures = _read(found)
    summary = f"{figures['readings']} readings of the kind {found.kind} predicted"
    return receipt("predict", given, summary, figures=figures, notes=told)


def imported(found: Any, given: Given, told: Told) -> Any:
    """Return the receipt of an import."""
    names = [*([] if found.robot is None else ["robot.toml"]), *(f"{name}.csv" for name in found.recordings)]
    files = tuple(str(Path(given["output"]) / name) for name in names)
    notes = tuple(f"warning: {words}" for words in found.warnings)
    return receipt("import", given, ", ".join(names), files=files, notes=notes)


def claims(found: Any, given: Given, told: Told) -> Any:
    """Return claims; those that stand on a page without their texts."""
    from deltacal_gen.results.registered import WrittenClaims

    return WrittenClaims(found) if "output" in given else found


def page(found: str, given: Given, told: Told) -> Any:
    """Return the receipt of a page of the manual, or of the examples that it copied."""
    from deltacal_gen.pages.manual import CONTENTS

    topic = given.get("topic") or given.get("code")
    files = tuple(found.splitlines()) if topic is None and "examples" in given else ()
    figures = {"topic": topic or CONTENTS}
    return receipt("manual", given, ", ".join(files), files=files, figures=figures, text=None if files else found)

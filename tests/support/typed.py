"""A script as a user would write it: mypy holds it to the strictest rules, `test_typed` runs it.

What stands in `assert_type` is what an editor completes.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any, assert_type

import numpy as np
import pandas as pd

import deltacal_gen as dc
from deltacal_gen.app.demonstration import example
from deltacal_gen.pages.figures import Sheet


def calibrated(folder: Path, frame: pd.DataFrame) -> dc.Result:
    """Identify from a data frame, by solvers given by name and as objects; a robot goes from answer to command."""
    result = dc.identify(folder / "robot.toml", frame, model="delta/18")
    assert_type(result, dc.Result)
    assert_type(result.heldout_rms_mm, float | None)
    assert_type(result.parameters[0].status, dc.Status)
    assert_type(dc.plot(result), Sheet)
    cut = dc.identify(result.robot, frame, model=18, method=dc.TSVD(12))
    assert cut.heldout_rms_mm is not None
    return cut


def used(result: dc.Result, folder: Path, frame: pd.DataFrame) -> dc.Comparison:
    """Ask a result for commands, predictions, a check and a plan."""
    targets = np.array([[0.0, 0.0, -853.0]])
    joints = dc.compensate(result, targets)
    assert_type(joints, np.ndarray[Any, np.dtype[np.float64]])
    assert np.allclose(dc.Compensator(result).joints(targets), np.radians(joints))
    predicted = dc.predict(result, frame)
    assert_type(predicted, dc.Recording)
    assert len(dc.to_dataframe(predicted)) == predicted.n_rows
    assert_type(dc.validate(result, frame).rms_mm, float)
    planned = dc.plan(result.robot, model="delta/18")
    assert_type(planned.chosen, int | None)
    again = dc.simulate(result.robot, folder / "poses.csv", noise=0.01)
    return dc.compare(result, dc.identify(result.robot, again, model="delta/18"))


def main() -> dc.Comparison:
    """Return what changed between a recording and a simulation of the machine that it showed."""
    folder = example("delta")
    frame = pd.read_csv(folder / "recording.csv")
    frame.attrs["measurement"] = {"sigma_mm": 0.005}
    return used(calibrated(folder, frame), folder, frame)

"""Where the clocks of a recording stand, as a result knows them or its sidecar says."""

from __future__ import annotations

import numpy as np

from deltacal_gen.errors import InputError
from deltacal_gen.motion.clocks import Clock, TwoClocks
from deltacal_gen.results.diagnosis import Diagnosis
from deltacal_gen.results.result import Result


def known_clock(known: Result | Diagnosis, given: TwoClocks) -> Clock:
    """Return where the clocks of a recording stand that is not to be aligned by its own readings.

    Raises
    ------
    InputError
        Neither the result nor the sidecar says it of a run.
    """
    told = known.parameters or ()
    rate = next((p.value for p in told if p.name == "clock_rate"), 0.0)
    offsets = {p.run: p.value for p in told if p.name == "clock_offset"}
    found = np.empty(len(given.run_names))
    for k, run in enumerate(given.run_names):
        value = offsets.get(None, offsets.get(run, given.offset))
        if value is None:
            raise InputError(
                f"where the instrument's clock stands in run '{run}' is not known: the result does not know that run.",
                "Say clock_offset_s under [measurement]: t_joints = t_instrument + clock_offset_s + clock_rate "
                "t_instrument.",
                file=given.recording.path,
            )
        found[k] = value
    return Clock(found, rate)

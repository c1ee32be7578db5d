"""Calibration of parallel robots with models that are derived, not typed.

Every command of ``deltacal`` is a function of the same name here; each takes paths, or objects already read::

    import deltacal_gen as dc

    result = dc.identify("robot.toml", "recording.csv", model="delta/32")
    print(result.heldout_rms_mm, [c.text for c in result.unidentifiable])
    joints = dc.compensate(result, targets)          # (N, 3) mm -> (N, 3) deg

What they answer is a frozen value; ``result["heldout_rms_mm"]`` is what its JSON says under that key, and
``read_result`` reads its file. Inside: mm, rad, s, kg, N; files and results speak deg (see ``units``).
"""

from __future__ import annotations

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)  # so that a command starts at once

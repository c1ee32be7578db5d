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

import importlib
from typing import Any

__version__ = "0.1.0"

_HOME = {
    "estimation.arrays": ("PoseSet", "estimate", "nominal"),
    "app.commands": (
        "batch",
        "claims",
        "compare",
        "compensate",
        "demo",
        "diagnose",
        "effects",
        "identify",
        "identify_blocks",
        "import_klipper",
        "import_points",
        "import_rrf",
        "derivation",
        "kernels",
        "matrix",
        "models",
        "plan",
        "predict",
        "predict_blocks",
        "simulate",
        "simulate_blocks",
        "study",
        "validate",
        "validate_blocks",
    ),
    "use.compensation": ("Compensator",),
    "errors": ("DeltacalError", "InputError", "NoSolutionError", "UsageError"),
    "use.exports": ("export_c", "export_table", "read_table"),
    "machine.registry": ("Machine", "load_mechanism"),
    "machine.values": ("Recording", "Robot"),
    "machine.backend": ("Backend", "using"),
    "files.recording": ("read_recording", "write_recording"),
    "results.batch": ("Batch",),
    "results.comparison": ("Comparison",),
    "results.diagnosis": ("Diagnosis", "Verdict"),
    "results.plan": ("Plan",),
    "results.reader": ("read_answer", "read_result"),
    "results.result": ("Result", "Status"),
    "results.study": ("Study",),
    "results.validation": ("Validation",),
    "files.robot": ("read_robot", "robot_to_toml"),
    "estimation.solvers": ("LeastSquares", "Prior", "Ridge", "TSVD"),
}
_WHERE = {name: module for module, names in _HOME.items() for name in names}
__all__ = sorted(_WHERE)  # names are looked up on first use, so that a command starts at once


def __getattr__(name: str) -> Any:
    if name not in _WHERE:
        raise AttributeError(f"module 'deltacal_gen' has no attribute '{name}'")
    return getattr(importlib.import_module(f"deltacal_gen.{_WHERE[name]}"), name)


def __dir__() -> list[str]:
    return [*__all__, "__version__"]

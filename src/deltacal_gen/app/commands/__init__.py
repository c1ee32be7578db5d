"""The commands as functions: paths or objects in, answers out (see `results`): attributes, and by key the JSON.

A function writes only where it is given an output path, and then all or nothing. The modules are those of `cli`.
"""

from __future__ import annotations

from deltacal_gen.app.commands.calibration import diagnose, identify, matrix
from deltacal_gen.app.commands.common import PICTURES, check_output
from deltacal_gen.app.commands.experiments import next_poses, plan, simulate
from deltacal_gen.app.commands.guide import demo, manual, manual_examples
from deltacal_gen.app.commands.many import batch, study
from deltacal_gen.app.commands.model_side import claims, derivation, effects, kernels, models, reproduce, trial, warm
from deltacal_gen.app.commands.use import (
    certificate,
    compare,
    compensate,
    export_compensator,
    feed_forward,
    firmware_lines,
    predict,
    validate,
)

__all__ = [
    "PICTURES",
    "batch",
    "certificate",
    "check_output",
    "claims",
    "compare",
    "compensate",
    "demo",
    "derivation",
    "diagnose",
    "effects",
    "export_compensator",
    "feed_forward",
    "firmware_lines",
    "identify",
    "kernels",
    "manual",
    "manual_examples",
    "matrix",
    "models",
    "next_poses",
    "plan",
    "predict",
    "reproduce",
    "simulate",
    "study",
    "trial",
    "validate",
    "warm",
]

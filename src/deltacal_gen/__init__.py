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
from typing import TYPE_CHECKING, Any

from deltacal_gen.results import shown as _shown

if TYPE_CHECKING:  # what mypy and editors see; at run time names are looked up on first use
    from deltacal_gen.app.commands import (
        batch as batch,
        certificate as certificate,
        claims as claims,
        compare as compare,
        compensate as compensate,
        demo as demo,
        derivation as derivation,
        diagnose as diagnose,
        effects as effects,
        feed_forward as feed_forward,
        firmware_lines as firmware_lines,
        identify as identify,
        import_bag as import_bag,
        import_c3d as import_c3d,
        import_klipper as import_klipper,
        import_marlin as import_marlin,
        import_points as import_points,
        import_rrf as import_rrf,
        import_urdf as import_urdf,
        kernels as kernels,
        manual as manual,
        manual_examples as manual_examples,
        manual_site as manual_site,
        matrix as matrix,
        models as models,
        next_poses as next_poses,
        plan as plan,
        predict as predict,
        reproduce as reproduce,
        simulate as simulate,
        study as study,
        validate as validate,
    )
    from deltacal_gen.errors import (
        DeltacalError as DeltacalError,
        InputError as InputError,
        NoSolutionError as NoSolutionError,
        UsageError as UsageError,
    )
    from deltacal_gen.estimation.arrays import PoseSet as PoseSet, estimate as estimate, nominal as nominal
    from deltacal_gen.estimation.solvers import (
        LeastSquares as LeastSquares,
        Prior as Prior,
        Ridge as Ridge,
        TSVD as TSVD,
    )
    from deltacal_gen.files.dialect import decimal_mark as decimal_mark
    from deltacal_gen.files.recording import read_recording as read_recording
    from deltacal_gen.files.writing import write_recording as write_recording
    from deltacal_gen.files.robot import read_robot as read_robot, robot_to_toml as robot_to_toml
    from deltacal_gen.machine.backend import Backend as Backend, using as using
    from deltacal_gen.machine.registry import Machine as Machine, load_mechanism as load_mechanism
    from deltacal_gen.machine.values import Recording as Recording, Robot as Robot
    from deltacal_gen.results.batch import Batch as Batch
    from deltacal_gen.results.certificate import Certificate as Certificate
    from deltacal_gen.results.comparison import Comparison as Comparison
    from deltacal_gen.results.diagnosis import Diagnosis as Diagnosis, Verdict as Verdict
    from deltacal_gen.results.plan import Plan as Plan
    from deltacal_gen.results.reader import read_answer as read_answer, read_result as read_result
    from deltacal_gen.results.result import Result as Result, Status as Status
    from deltacal_gen.results.study import Study as Study
    from deltacal_gen.results.validation import Validation as Validation
    from deltacal_gen.use.compensation import Compensator as Compensator
    from deltacal_gen.use.exports import export_c as export_c
    from deltacal_gen.use.tables import export_table as export_table, read_table as read_table
    from deltacal_gen.version import __version__ as __version__

_HOME = {
    "estimation.arrays": ("PoseSet", "estimate", "nominal"),
    "app.commands": (
        "batch",
        "certificate",
        "claims",
        "compare",
        "compensate",
        "demo",
        "diagnose",
        "effects",
        "feed_forward",
        "firmware_lines",
        "identify",
        "import_bag",
        "import_c3d",
        "import_klipper",
        "import_marlin",
        "import_points",
        "import_rrf",
        "import_urdf",
        "derivation",
        "kernels",
        "manual",
        "manual_examples",
        "manual_site",
        "matrix",
        "models",
        "next_poses",
        "plan",
        "predict",
        "reproduce",
        "simulate",
        "study",
        "validate",
    ),
    "use.compensation": ("Compensator",),
    "errors": ("DeltacalError", "InputError", "NoSolutionError", "UsageError"),
    "use.exports": ("export_c",),
    "use.tables": ("export_table", "read_table"),
    "machine.registry": ("Machine", "load_mechanism"),
    "machine.values": ("Recording", "Robot"),
    "machine.backend": ("Backend", "using"),
    "files.dialect": ("decimal_mark",),
    "files.recording": ("read_recording",),
    "files.writing": ("write_recording",),
    "results.batch": ("Batch",),
    "results.certificate": ("Certificate",),
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
_WHERE["__version__"] = "version"


def _plotted(answer: Any) -> Any:
    from deltacal_gen.pages.plots import plot

    return plot(answer)


def _named(recording: Any) -> Any:
    from deltacal_gen.files.writing import file_columns

    return file_columns(recording)


_shown.lend(plot=_plotted, columns=_named)  # what stands above answers; both take long to import


def __getattr__(name: str) -> Any:
    if name not in _WHERE:
        raise AttributeError(f"module 'deltacal_gen' has no attribute '{name}'")
    return getattr(importlib.import_module(f"deltacal_gen.{_WHERE[name]}"), name)


def __dir__() -> list[str]:
    return [*__all__, "__version__"]

"""What ``deltacal_gen`` exports, and where it lives; ``__init__`` looks names up here, on first use."""

from .app.commands.assess import certificate as certificate, compare as compare, validate as validate
from .app.commands.calibration import diagnose as diagnose, identify as identify, matrix as matrix
from .app.commands.experiments import next_poses as next_poses, simulate as simulate
from .app.commands.guide import (
    demo as demo,
    explain as explain,
    manual as manual,
    manual_examples as manual_examples,
)
from .app.commands.many import batch as batch, study as study
from .app.commands.model_side import (
    claims as claims,
    derivation as derivation,
    effects as effects,
    kernels as kernels,
    models as models,
    reproduce as reproduce,
)
from .app.commands.plans import plan as plan, plan_cycles as plan_cycles, plan_trajectory as plan_trajectory
from .app.commands.use import (
    compensate as compensate,
    export_compensator as export_compensator,
    feed_forward as feed_forward,
    predict as predict,
)
from .errors import (
    DeltacalError as DeltacalError,
    InputError as InputError,
    NoSolutionError as NoSolutionError,
    UsageError as UsageError,
)
from .estimation.arrays import PoseSet as PoseSet, estimate as estimate, nominal as nominal
from .estimation.solvers import LeastSquares as LeastSquares, Prior as Prior, Ridge as Ridge, TSVD as TSVD
from .files.dialect import decimal_mark as decimal_mark
from .files.frames import to_dataframe as to_dataframe
from .files.importers.bag import import_bag as import_bag
from .files.importers.c3d import import_c3d as import_c3d
from .files.importers.klipper import import_klipper as import_klipper
from .files.importers.marlin import import_marlin as import_marlin
from .files.importers.points import import_points as import_points
from .files.importers.rrf import import_rrf as import_rrf
from .files.importers.urdf import import_urdf as import_urdf
from .files.recording import read_recording as read_recording
from .files.writing import write_recording as write_recording
from .files.robot import read_robot as read_robot, robot_to_toml as robot_to_toml
from .machine.backend import Backend as Backend, using as using
from .machine.registry import Machine as Machine, load_mechanism as load_mechanism
from .machine.values import Recording as Recording, Robot as Robot
from .pages.plots import plot as plot
from .results.batch import Batch as Batch
from .results.certificate import Certificate as Certificate
from .results.comparison import Comparison as Comparison
from .results.diagnosis import Diagnosis as Diagnosis, Verdict as Verdict
from .results.plan import Plan as Plan
from .results.reader import read_answer as read_answer, read_result as read_result
from .results.result import Result as Result, Status as Status
from .results.study import Study as Study
from .results.validation import Validation as Validation
from .use.compensation import Compensator as Compensator
from .use.exporters.c import export_c as export_c
from .use.exporters.table import export_table as export_table, read_table as read_table
from .version import __version__ as __version__

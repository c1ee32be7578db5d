"""Answers as values: their JSON, their published schemas, and what the reader of files refuses."""

from __future__ import annotations

import copy
import json
import pickle
import shutil
from collections.abc import Mapping
from pathlib import Path
from typing import Any, get_args

import numpy as np
import pytest
from jsonschema import Draft202012Validator
from pydantic import ValidationError

import deltacal_gen as dc
from deltacal_gen.app.demonstration import example
from deltacal_gen.errors import InputError
from deltacal_gen.results import published
from deltacal_gen.results.base import Value, keys_of
from deltacal_gen.results.document import Text, as_html, as_text, rounded, table_of
from deltacal_gen.results.reader import ANSWERS, read_answer, read_result, types_of
from deltacal_gen.results.result import Remedy, Result

pytestmark = pytest.mark.usefixtures("compiled")

DELTA, GEARBOX = example("delta"), example("gearbox")
UNITS = ("_mm", "_deg", "_Nm", "_N", "_A", "_1", "_Hz", "_s", "_kg")
BARE = {  # numbers without a unit: counts, parts of a whole, figures of statistics, what `unit` beside them tells
    *(
        "cost_chi2",
        "harmonic_of",
        "rho",
        "rows",
        "own",
        "rank",
        "rank_tolerance",
        "singular_values",
        "condition",
        "pins",
        "of",
        "determined",
        "scalars",
        "poses",
        "run",
        "runs",
        "torques",
        "joint",
        "centre",
        "cosine",
        "sine",
        "harmonics",
        "log_determinant",
    ),
    *("parameters", "iterations", "degrees_of_freedom", "chi2_per_dof", "gross_errors", "home_line", "unreachable"),
    *(
        "readings",
        "unknowns",
        "limb",
        "limbs",
        "orders",
        "order",
        "term",
        "forms_tried",
        "recordings",
        "low",
        "high",
        "mean",
        "between",
        "p_value",
        "share",
        "share_of_excess",
        "gain_chi2",
        "gain_by_limb",
        "instead_of_limb",
    ),
    *(
        "expected_chi2",
        "line",
        "lines",
        "n",
        "pose_count",
        "corrected",
        "change",
        "threshold",
        "layers",
        "chosen",
        "settled",
    ),
    *("O1", "O2", "O3", "O4", "O5", "machines", "lost", "seed", "points", "count", "recordings", "named_right"),
    *("before_rms", "after_rms", "predicted_rms", "p95"),
    *("named_among_equals", "chance", "interval", "instead", "times", "gain", "doubling", "rows", "columns"),
    *(
        "value",
        "std",
        "share",
        "probability",
        "within",
        "low",
        "high",
        "bias",
        "drawn_std",
        "predicted_std",
        "stated_std",
        "before",
        "after",
        "limit_std",
        "terms",
        "factor",
        "degrees",
        "scatter",
        "shown",
        "unshown_by_joint",
        "left_out",
        "chi2_by_pose",
        "further",
        "limits",
        "joints",
    ),
    # inside: mm, rad, s, kg, N, as their types say
    *(
        "state",
        "free",
        "scale",
        "home",
        "ties",
        "values",
        "constants",
        "tools",
        "gaps",
        "knots",
        "coefficients",
        "length",
    ),
    *("reach", "channels", "errors", "tolerance"),
    # of machines in motion: in `unit_by_joint`, parts of a whole, counts, and as their types say
    *("train_rms_by_joint", "heldout_rms_by_joint", "heldout_rms_by_joint_filtered", "sigma_by_joint"),
    *(
        "rms_by_joint",
        "rms_by_joint_filtered",
        "together_by_joint",
        "of_joints_by_joint",
        "of_geometry_by_joint",
        "removed",
        "consistent_off",
        "at_rest",
        "at_rest_below",
    ),
    *(
        "joint",
        "payload",
        "buys",
        "heldout_gain",
        "error",
        "delay",
        "delay_std",
        "inertial",
        "mass",
        "centre",
        "time",
        "measured",
        "speed",
    ),
    *("position", "load", "error_before", "error_after"),
    *("before_by_joint", "after_by_joint", "noise_by_joint", "fitted_by_joint"),
    *("positions", "cycles", "cycle", "approach"),
    *("exit_code", "figures"),  # names of figures end in their unit
    *("range", "at", "seen", "partial", "charge", "outside_law"),  # of laws, as their states and targets count
}


@pytest.fixture(scope="module")
def answers(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Mapping[str, Any]]:
    folder = tmp_path_factory.mktemp("answers")
    fleet = folder / "fleet"
    shutil.copytree(DELTA, fleet / "good")
    shutil.copytree(DELTA, fleet / "wrong")
    (fleet / "wrong" / "recording.csv").write_text("pose,q1_deg,q2_deg,q3_deg,x_mm,y_mm,z_mm\n1,0,0,0,1,2,x\n")
    result = dc.identify(DELTA / "robot.toml", DELTA / "recording.csv")
    diagnosis = dc.diagnose(GEARBOX / "robot.toml", GEARBOX / "recording.csv")
    return {
        "result": result,
        "held": dc.identify(GEARBOX / "robot.toml", GEARBOX / "recording.csv", physics=diagnosis),
        "diagnosis": diagnosis,
        "validation": dc.validate(diagnosis, GEARBOX / "recording.csv"),
        "certificate": dc.certificate(result, dc.read_recording(DELTA / "recording.csv", dc.load_mechanism("delta"))),
        "comparison": dc.compare(result, result),
        "plan": dc.plan(DELTA / "robot.toml", model="delta/18", noise=0.01),
        "cycles": dc.plan_cycles(DELTA / "robot.toml", kind="encoder", positions=3),
        "study": dc.study(DELTA / "robot.toml", plan=DELTA / "poses.csv", trials=20, noise=0.01, workers=1),
        "batch": dc.batch(fleet, output=folder / "run", do="identify", workers=1),
    }


KINDS = (
    "result",
    "held",
    "diagnosis",
    "validation",
    "certificate",
    "comparison",
    "plan",
    "cycles",
    "study",
    "batch",
)


def test_the_published_schemas_are_those_of_the_types() -> None:
    files = {p.name: p.read_text(encoding="utf-8") for p in published.FOLDER.glob("*.json")}
    assert files == published.published(), "run python -m deltacal_gen.results.published"
    for text in files.values():
        Draft202012Validator.check_schema(json.loads(text))


@pytest.mark.walk
@pytest.mark.parametrize("kind", KINDS)
def test_what_commands_answer_is_as_the_published_schema_says(answers: dict[str, Any], kind: str) -> None:
    data = json.loads(json.dumps(answers[kind] | {}, allow_nan=False))
    as_published = Draft202012Validator(json.loads((published.FOLDER / published.file_of(data["schema"])).read_text()))
    as_published.validate(data)
    key = next(k for kind_of in (list, dict) for k, v in data.items() if isinstance(v, kind_of) and v)
    for broken in ({k: v for k, v in data.items() if k != key}, data | {key: "words"}, data | {"schema": "other/1"}):
        assert not as_published.is_valid(broken)


@pytest.mark.walk
@pytest.mark.parametrize("kind", KINDS)
def test_an_answer_read_back_is_the_same(answers: dict[str, Any], kind: str) -> None:
    data = answers[kind] | {}
    read = read_answer(json.loads(json.dumps(data)))
    assert type(read) is types_of(data["schema"])[0]
    assert json.dumps(read.to_dict()) == json.dumps(data)  # and the keys are in the same order
    assert json.loads(read.to_json()) == data
    assert read == data
    assert dict(read) == data
    assert {**pickle.loads(pickle.dumps(read))} == data
    assert read_answer(read) is read


def kinds_in(top: Any) -> dict[str, type]:
    """Return all types that a type is made of, by their names."""
    if not isinstance(top, type):
        return {name: kind for part in get_args(top) for name, kind in kinds_in(part).items()}
    found: dict[str, type] = {top.__name__: top}
    for field in top.model_fields.values() if issubclass(top, Value) else ():
        found |= kinds_in(field.annotation)
    return found


def _types() -> dict[str, type[Value]]:
    found = {name: kind for s in ANSWERS for of in types_of(s) for name, kind in kinds_in(of).items()}
    return {name: kind for name, kind in found.items() if issubclass(kind, Value)}


def numeric(hint: Any) -> bool:
    """Tell whether a field holds numbers, in whatever it holds them."""
    return hint in (float, int, np.ndarray) or any(map(numeric, get_args(hint)))


@pytest.mark.parametrize("name", sorted(_types()))
def test_every_type_is_described_and_every_number_has_its_unit(name: str) -> None:
    kind = _types()[name]
    assert (kind.__doc__ or "").strip()
    for field, info in kind.model_fields.items():
        assert not numeric(info.annotation) or all(key in BARE or key.endswith(UNITS) for key in keys_of(field)), field


def test_a_value_is_frozen_and_knows_its_fields() -> None:
    remedy = Remedy(measurement="another point", pins=2, of=4)
    assert remedy.to_dict() == {"measurement": "another point", "pins": 2, "of": 4}
    assert remedy.replace(open_mm=0.1).to_dict() == {"measurement": "another point", "pins": 2, "of": 4, "open_mm": 0.1}
    with pytest.raises(ValidationError, match="frozen"):
        remedy.pins = 3  # type: ignore[misc]
    with pytest.raises(ValidationError, match="frozen"):
        del remedy.pins
    with pytest.raises(ValidationError, match="of\n  Field required"):
        Remedy(measurement="", pins=1)  # type: ignore[call-arg]
    with pytest.raises(TypeError, match="no field 'off'"):
        remedy.replace(off=1)
    assert remedy == copy.deepcopy(remedy) != remedy.replace(pins=1)


@pytest.mark.walk
def test_a_blank_cell_is_null(answers: dict[str, Any]) -> None:
    found = read_result(answers["diagnosis"] | {})
    residuals = found.residuals  # type: ignore[union-attr]
    name, values = next(iter(residuals.channels.items()))
    blank = residuals.replace(channels={name: np.where(np.arange(len(values)) == 1, np.nan, values)})
    assert blank.to_dict()["channels"][name][:2] == [values[0], None]


# ------------------------------------------------------------------------------------------------ what is refused


def changed(data: Any, path: tuple[Any, ...], value: Any) -> Any:
    """Return data with another value at a place; without a value the key is gone."""
    data = copy.deepcopy(data)
    part = data
    for step in path[:-1]:
        part = part[step]
    if value is None:
        del part[path[-1]]
    else:
        part[path[-1]] = value
    return data


@pytest.mark.walk
@pytest.mark.parametrize(
    ("path", "value", "words"),
    [
        (("schema",), None, "this is no result of identify or diagnose"),
        (("schema",), "deltacal.plan/1", "this is no result of identify or diagnose"),
        (("schema",), "deltacal.result/2", "its schema is deltacal.result/2, and this version reads deltacal.result/1"),
        (("schema",), "deltacal.result/2", "Run identify again with this version"),
        (("robot",), None, "'robot' is missing"),
        (("parameters", 3, "value"), None, r"'parameters\[3\].value' is missing"),
        (("parameters", 3, "value"), "0.1", r"'parameters\[3\].value' is \"0.1\": input should be a valid number"),
        (("parameters", 3, "status"), "guessed", r"'parameters\[3\].status' is \"guessed\": input should be 'identif"),
        (("sigma_mm",), float("nan"), "'sigma_mm' is NaN: input should be a finite number"),
        (("instrument", "state", 0), [1.0, 2.0], "the rows are not equally long"),
        (("instrument", "home"), [1.0, 2.0], r"'instrument.home\[2\]' is missing"),
        (("robot", "masess"), {}, "'robot.masess' is .*not permitted"),
    ],
)
def test_what_is_damaged_is_said_with_file_line_and_key(
    answers: dict[str, Any], tmp_path: Path, path: tuple[Any, ...], value: Any, words: str
) -> None:
    data = answers["result"] | {}
    data["instrument"]["state"] *= 2
    broken = changed(data, path, value)
    lines = (f" {json.dumps(k)}: {json.dumps(v)}" for k, v in broken.items())
    (tmp_path / "result.json").write_text("{\n" + ",\n".join(lines) + "\n}\n")
    for given in (broken, tmp_path / "result.json"):
        with pytest.raises(InputError, match=words) as refused:
            read_result(given)
    assert refused.value.file == tmp_path / "result.json"
    if path[0] not in ("schema", "robot") or len(path) > 1:
        assert refused.value.line == list(broken).index(path[0]) + 2
    assert "identify" in refused.value.remedy


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b'{\n"schema": "deltacal.result/1",\n', "result.json, line 3: this is not JSON"),
        (b"[1, 2]", "no result of identify or diagnose"),
        (b"\xff\xfe\x00", "this is not text"),
        (None, "there is no such file"),
    ],
)
def test_what_is_no_json_is_said(tmp_path: Path, content: bytes | None, words: str) -> None:
    if content is not None:
        (tmp_path / "result.json").write_bytes(content)
    with pytest.raises(InputError, match=words):
        read_result(tmp_path / "result.json")


@pytest.mark.walk
def test_a_key_of_a_later_version_is_no_error(answers: dict[str, Any]) -> None:
    found = read_result(answers["result"] | {"gravity": {"sagging_mm": 20.0}})
    assert isinstance(found, Result)
    assert found == answers["result"]


def test_people_read_a_value_as_far_as_it_is_known() -> None:
    assert rounded(0.0957, 0.21) == ("0.10", "0.21")
    assert rounded(-0.001, 0.5) == ("0.00", "0.50")
    assert rounded(12345.6, 320.0) == ("12346", "320")
    assert rounded(1.23456e-5, 3.3e-8) == ("1.2346e-05", "3.3e-08")
    assert rounded(1.23456, None) == ("1.235", "-")
    rows = [{"name": "L_1", "value": -0.0538492, "std": 0.0473807}, {"name": "ex_1", "value": -0.194392, "std": None}]
    found = [Text("found"), *table_of(rows)]
    assert as_text(found) == "found\nname  value    std\nL_1   -0.054   0.047\nex_1  -0.1944  -"
    assert "<td>-0.054</td><td>0.047</td>" in as_html(found)


@pytest.mark.walk
def test_a_robot_in_an_answer_says_what_it_is(answers: dict[str, Any]) -> None:
    robot = answers["result"].robot
    assert repr(robot) == f"<RobotTables '{robot.robot.name}': {robot.robot.mechanism}>"

"""Tables as people and programs write them down: what is certain is read, what is not is asked for."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pandas as pd
import pytest

import deltacal_gen as dc
from deltacal_gen.app.demonstration import example
from deltacal_gen.errors import InputError
from deltacal_gen.files.dialect import converted, decimal_mark
from deltacal_gen.files.recording import read_recording
from deltacal_gen.files.rows import read_csv
from deltacal_gen.machine.registry import load_mechanism
from deltacal_gen.machine.values import Recording
from deltacal_gen.units import DEG
from tests.support.commands import Run

DELTA = load_mechanism("delta")
HEADER = ["pose", "q1_deg", "q2_deg", "q3_deg", "x_mm", "y_mm", "z_mm", "payload_kg"]
TABLE = [["a", 10.5, -20.25, 30, 1234.5, 2, -800.125, 0.5], ["b", 11, 21, 31, 0.25, -3, -801, 1.5]]


def rows(mark: str = ".", separator: str = ",", header: list[str] | None = None) -> str:
    table = [[str(c).replace(".", mark) for c in row] for row in TABLE]
    return "".join(separator.join(row) + "\n" for row in [header or HEADER, *table])


def read(folder: Path, content: str | bytes) -> Recording:
    path = folder / "recording.csv"
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    return read_recording(path, DELTA)


FORMS: dict[str, str | bytes] = {
    "plain": rows(),
    "semicolons": rows(separator=";"),
    "tabs": rows(separator="\t"),
    "decimal commas": rows(",", ";"),
    "commas after tabs": rows(",", "\t"),
    "marks between thousands": rows(",", ";").replace("1234,5", "1.234,5"),
    "blanks between thousands": rows(separator=";").replace("1234.5", "1 234.5"),
    "commas between thousands": rows(separator=";").replace("1234.5", "1,234.5"),
    "utf-16": rows(",", ";").encode("utf-16"),
    "utf-16 without a mark": rows().encode("utf-16-le"),
    "byte order mark": b"\xef\xbb\xbf" + rows().encode(),
    "latin-1": "# gemessen auf Tisch \xfc\n".encode("latin-1") + rows(separator=";").encode(),
    "windows lines": rows().replace("\n", "\r\n"),
    "units in brackets": rows(
        header=["pose", "q1 [deg]", "Q2 (deg)", "q3[°]", "X [mm]", "y (mm)", "Z[mm]", "payload [kg]"]
    ),
    "a row of units": rows(header=["pose", "q1", "q2", "q3", "X", "Y", "Z", "payload"]).replace(
        "payload\n", "payload\n,deg,deg,deg,mm,mm,mm,kg\n"
    ),
    "a header that is a remark": "# made on Monday\n# " + rows(),  # as numpy.savetxt writes it
    "the same twice, in two units": "".join(
        f"{line},{more}\n"
        for line, more in zip(
            rows(header=[*HEADER[:-1], "payload_g"]).replace(",0.5", ",500").replace(",1.5", ",1500").splitlines(),
            ("X [m]", "1.2345", "0.00025"),
            strict=True,
        )
    ),
    "a preamble": "Tracker AT960; serial 123\nDate:;22.11.2026\nOperator;A. B.\n\n" + rows(",", ";"),
    "other units": (
        "pose,q1_rad,q2 [rad],q3_rad,x_m,Y [in],z_cm,payload_g\n"
        f"a,{10.5 * DEG!r},{-20.25 * DEG!r},{30 * DEG!r},1.2345,{2 / 25.4!r},-80.0125,500\n"
        f"b,{11 * DEG!r},{21 * DEG!r},{31 * DEG!r},0.00025,{-3 / 25.4!r},-80.1,1500\n"
    ),
}


@pytest.mark.parametrize("form", FORMS)
def test_every_form_gives_the_same_recording(tmp_path: Path, form: str) -> None:
    recording = read(tmp_path, FORMS[form])
    table = np.array([row[1:] for row in TABLE], dtype=float)
    assert recording.pose.tolist() == ["a", "b"]
    assert recording.joints / DEG == pytest.approx(table[:, :3])
    assert recording.measured == pytest.approx(table[:, 3:6])
    assert recording.payload_kg == pytest.approx(table[:, 6])


@pytest.mark.parametrize("form", FORMS)
def test_the_first_rows_are_read_as_the_whole(tmp_path: Path, form: str) -> None:
    read(tmp_path, FORMS[form])
    whole, first = (read_csv(tmp_path / "recording.csv", rows) for rows in (None, 1))
    assert first.columns == {name: cells[:1] for name, cells in whole.columns.items()}
    assert first.line.tolist() == whole.line[:1].tolist()


def test_a_cell_may_go_on_where_the_first_rows_end(tmp_path: Path) -> None:
    path = tmp_path / "recording.csv"
    path.write_text('pose,q1_deg,q2_deg,q3_deg,x_mm,y_mm,z_mm\n"a\nb",1,2,3,4,5,-900\nc,2,3,4,5,6,-900\n')
    first = read_csv(path, 1)
    assert first.columns["pose"] == ["ab"]
    assert first.line.tolist() == [3]


def test_a_workbook_is_a_table(tmp_path: Path) -> None:
    openpyxl = pytest.importorskip("openpyxl")
    book = openpyxl.Workbook()
    book.create_sheet("notes", 0)
    for row in (["Tracker AT960"], HEADER, *TABLE):
        book["Sheet"].append(row)
    book.save(tmp_path / "recording.xlsx")
    recording = read_recording(tmp_path / "recording.xlsx", DELTA)
    assert recording.measured[0].tolist() == [1234.5, 2.0, -800.125]
    assert recording.line.tolist() == [3, 4]
    (tmp_path / "recording.xlsx").write_bytes(b"PK but no archive")
    with pytest.raises(InputError, match="this is no workbook"):
        read_recording(tmp_path / "recording.xlsx", DELTA)


def test_all_sheets_of_a_workbook_are_tried_and_errors_name_the_one_that_is_read(tmp_path: Path) -> None:
    openpyxl = pytest.importorskip("openpyxl")
    book = openpyxl.Workbook()
    book["Sheet"].append(["made by", "A. B."])
    data = book.create_sheet("Data")
    for row in (HEADER, *TABLE):
        data.append(row)
    book.save(tmp_path / "recording.xlsx")
    assert read_recording(tmp_path / "recording.xlsx", DELTA).line.tolist() == [2, 3]
    data["B3"] = "x"
    book.save(tmp_path / "recording.xlsx")
    with pytest.raises(InputError, match=r"line 3, column 'q1_deg': in the sheet 'Data': the cell holds 'x'"):
        read_recording(tmp_path / "recording.xlsx", DELTA)


AMBIGUOUS = "pose;q1_deg;q2_deg;q3_deg;x_mm;y_mm;z_mm\na;10;20;30;1,234;2;-800\nb;11;21;31;5;6;-801\n"


def test_what_is_not_certain_is_asked_for(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="line 2: whether the comma in '1,234' is a decimal mark or parts thousands"):
        read(tmp_path, AMBIGUOUS)
    for mark, x in ((",", 1.234), (".", 1234.0)):
        with decimal_mark(mark):
            assert read(tmp_path, AMBIGUOUS).measured[0, 0] == pytest.approx(x)


def test_the_answer_is_an_option_of_the_command(tmp_path: Path, run: Run) -> None:
    (tmp_path / "poses.csv").write_text(AMBIGUOUS.replace("10;20;30", "1,234;2;3").replace("11;21;31", "5;6;7"))
    command = ("simulate", example() / "robot.toml", tmp_path / "poses.csv", "-o", tmp_path / "out.csv")
    code, _, said = run(*command)
    assert code == 3
    assert "--decimal" in said
    assert run(*command, "--decimal", ",")[0] == 0
    assert (tmp_path / "out.csv").read_text().splitlines()[1].split(",")[1] == "1.234"
    assert run(*command)[0] == 3  # the answer is of that command alone
    assert run(*command, "--decimal", "x")[0] == 2


INCHES = [repr(v / 25.4) for v in (1.5, 2, -800, 2.5, 3, -801)]
EXPORTS = {
    "SpatialAnalyzer": "// Collection::Group::Point, X, Y, Z\nJob::A::P1, 1.5, 2, -800\nJob::A::P2, 2.5, 3, -801\n",
    "PolyWorks": "PolyWorks|Inspector report\nUnits: Inches\n\nName X Y Z\n"
    f"P1 {' '.join(INCHES[:3])}\nP2 {' '.join(INCHES[3:])}\n",
    "Leica": "Job: cell 7\nDate: 22.11.2026 10:31\nUnit: Meters\n\nPointID\tX\tY\tZ\n"
    "P1\t0.0015\t0.002\t-0.8\nP2\t0.0025\t0.003\t-0.801\n",
    "FARO": "CAM2 Measure 10\nOperator;A. B.\nUnits=mm\nName;X;Y;Z\nP1;1,5;2,0;-800,0\nP2;2,5;3,0;-801,0\n",
}


@pytest.mark.parametrize("software", EXPORTS)
def test_exports_of_instrument_software(tmp_path: Path, software: str) -> None:
    (tmp_path / "points.txt").write_text(EXPORTS[software])
    (tmp_path / "joints.csv").write_text("point,J1 [deg],J2 [deg],J3 [deg]\nP1,10,20,30\nP2,11,21,31\n")
    found = dc.import_points(tmp_path / "points.txt", tmp_path / "joints.csv").recordings["recording"]
    assert found.measured == pytest.approx(np.array([[1.5, 2, -800], [2.5, 3, -801]]))
    assert found.pose.tolist() == ["P1", "P2"]


@pytest.mark.parametrize(
    ("name", "known"),
    [
        ("x_inch", ("x_mm", 25.4, 0.0)),
        ("Y_metres", ("y_mm", 1000.0, 0.0)),
        ("q1_degrees", ("q1_deg", 1.0, 0.0)),
        ("temp_kelvin", ("temp_C", 1.0, -273.15)),
        ("temp_arm [°F]", ("temp_arm_C", 5 / 9, -160 / 9)),
        ("tau1 [Nm]", ("tau1_Nm", 1.0, 0.0)),
        ("Tau2_mNm", ("tau2_Nm", 1e-3, 0.0)),
        ("tau2 (N·m)", ("tau2_Nm", 1.0, 0.0)),
        ("tau3 [kN]", ("tau3_N", 1e3, 0.0)),
        ("current6_mA", ("current6_A", 1e-3, 0.0)),
        ("Drive1", ("drive1", 1.0, 0.0)),
        ("Run", ("run", 1.0, 0.0)),
        ("load_inch", None),
    ],
)
def test_units_may_be_written_out_in_a_name(name: str, known: tuple[str, float, float] | None) -> None:
    assert converted(name) == (known or (name, 1.0, 0.0))


def test_temperatures_are_in_degrees_of_celsius(tmp_path: Path) -> None:
    head = "pose,q1_deg,q2_deg,q3_deg,x_mm,y_mm,z_mm"
    text = f"{head},temp_K,temp_arm_F\na,1,2,3,4,5,-800,293.15,68\nb,2,3,4,5,6,-801,,212\n"
    found = read(tmp_path, text).channels
    assert found["temp_C"] == pytest.approx([20.0, np.nan], nan_ok=True)
    assert found["temp_arm_C"] == pytest.approx([20.0, 100.0])


def test_a_table_in_the_place_of_the_robot_is_told(tmp_path: Path, run: Run) -> None:
    code, _, err = run("identify", example() / "recording.csv", example() / "robot.toml")
    assert code == 3
    assert "Give the robot first" in err


@pytest.mark.parametrize(
    ("name", "cells", "seconds"),
    [
        ("timestamp", ("2026-11-26T10:22:11.5", "2026-11-26 10:22:12.5+00:00"), (1795688531.5, 1795688532.5)),
        ("Timestamp", ("26.11.2026 10:22:11.5", "26.11.2026 10:22:12.5"), (1795688531.5, 1795688532.5)),
        ("time stamp", ("2026/11/26 10:22:11.5", "2026/11/26 10:22:12.5"), (1795688531.5, 1795688532.5)),
        ("Date Time", ("2026-11-26T10:22:11+01:00", ""), (1795684931.0, np.nan)),
        ("time", ("10:22:11.25", "10:22:12"), (37331.25, 37332.0)),
        ("time", ("10:22:11", "noon"), None),
        ("date", ("20261126", "20261127"), None),
        ("remark", ("10:22:11", "10:22:12"), None),
    ],
)
def test_moments_are_seconds(
    tmp_path: Path, name: str, cells: tuple[str, str], seconds: tuple[float, float] | None
) -> None:
    rows = "".join(f"{k},{k},2,3,4,5,-800,{cell}\n" for k, cell in enumerate(cells))
    found = read(tmp_path, f"pose,q1_deg,q2_deg,q3_deg,x_mm,y_mm,z_mm,{name}\n{rows}").time_s
    assert (found is None) == (seconds is None)
    assert seconds is None or found == pytest.approx(np.array(seconds), abs=1e-6, nan_ok=True)


QUATERNION = "pose,q1_deg,q2_deg,q3_deg,x_mm,y_mm,z_mm,{}\na,1,2,3,4,5,-800,{}\nb,1,2,3,4,5,-801,,,,\n"


@pytest.mark.parametrize(
    ("names", "cells"),
    [
        ("qx,qy,qz,qw", "0,0.6,0,0.8"),
        ("qw,qx,qy,qz", "-0.8,0,-0.6,0"),
        ("Quat_X,Quat_Y,Quat_Z,Quat_W", "0,0.6,0,0.8"),
        ("orientation.x,orientation.y,orientation.z,orientation.w", "0,0.6,0,0.8"),
        ("tool_q_w,tool_q_x,tool_q_y,tool_q_z", "0.798,0,0.602,0"),
    ],
)
def test_a_quaternion_is_a_rotation(tmp_path: Path, names: str, cells: str) -> None:
    recording = read(tmp_path, QUATERNION.format(names, cells))
    assert (recording.kind, recording.channels) == ("pose", {})
    assert recording.measured[0, 3:] / DEG == pytest.approx([0, 2 * np.degrees(np.arcsin(0.6)), 0], abs=0.5)
    assert np.isnan(recording.measured[1, 3:]).all()


@pytest.mark.parametrize("names", ["qx,qy,qz,remark", "a_qx,a_qy,b_qz,b_qw", "ax,ay,az,aw"])
def test_what_may_be_a_quaternion_is_none(tmp_path: Path, names: str) -> None:
    recording = read(tmp_path, QUATERNION.format(names, "0,0.6,0,0.8"))
    assert (recording.kind, list(recording.channels)) == ("position", names.split(","))


def test_numbers_that_are_no_quaternion_are_named(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"line 2, column 'qx': .* the length 1, this one 1\.9"):
        read(tmp_path, QUATERNION.format("qx,qy,qz,qw", "1,1,1,0.8"))
    (tmp_path / "recording.toml").write_text('[measurement]\nrotation = "xyz"\n')
    with pytest.raises(InputError, match="is an order of turns, but the rotation here is a quaternion"):
        read(tmp_path, QUATERNION.format("qx,qy,qz,qw", "0,0.6,0,0.8"))


def test_a_quaternion_says_how_a_platform_shall_stand(tmp_path: Path) -> None:
    path = tmp_path / "targets.csv"
    path.write_text("x_mm,y_mm,z_mm,qx,qy,qz,qw\n400,0,500,0,1,0,0\n")
    asked = read_recording(path, load_mechanism("hexapod"), need_measured=False, allow_targets=True).targets
    assert asked is not None
    assert asked[0, 3:].reshape(3, 3) == pytest.approx(np.diag([-1.0, 1, -1]), abs=1e-9)


@pytest.mark.parametrize(
    ("begin", "told"),
    [
        (b"PK\x03\x04", "no text, but a workbook or an archive. Save the sheet as .xlsx"),
        (b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", "a workbook of an old kind"),
        (b"\x1f\x8b", "compressed"),
        (b"PAR1", "Give it the ending .parquet"),
    ],
)
def test_what_is_no_text_is_named(tmp_path: Path, begin: bytes, told: str) -> None:
    with pytest.raises(InputError, match=told):
        read(tmp_path, begin + bytes(200))


def test_a_column_that_is_missing_is_looked_for_among_the_others(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"Other columns are Joint 1 \(deg\), J2, A3"):
        read(tmp_path, rows(header=["pose", "Joint 1 (deg)", "J2", "A3", "x_mm", "y_mm", "z_mm", "payload_kg"]))


@pytest.mark.parametrize("ending", [".parquet", ".PARQUET"])
def test_numbers_in_parquet_have_the_units_that_their_columns_say(tmp_path: Path, ending: str) -> None:
    frame = pd.DataFrame(TABLE, columns=HEADER)
    other = frame.drop(columns=["payload_kg", "x_mm"]).assign(
        payload_g=1000 * frame["payload_kg"],
        **{"X [m]": frame["x_mm"] / 1000},
        timestamp=pd.to_datetime(["2026-11-22T08:00:00.5Z", "2026-11-22T08:00:02.0Z"]),
    )
    other.to_parquet(tmp_path / f"recording{ending}")
    recording, same = read_recording(tmp_path / f"recording{ending}", DELTA), read(tmp_path, rows())
    assert recording.measured == pytest.approx(same.measured)
    assert recording.payload_kg == pytest.approx(same.payload_kg)
    assert np.diff(recording.channels["time_s"]) == pytest.approx(1.5)
    assert set(recording.channels) == {"payload_kg", "time_s"}


@pytest.mark.parametrize("name", ["recording.csv.toml", "recording.TOML"])
def test_a_sidecar_by_another_name_is_not_passed_over(tmp_path: Path, name: str) -> None:
    (tmp_path / name).write_text("[measurement]\nframe = 'robot'\n")
    if (tmp_path / "recording.toml").exists():
        pytest.skip("a disk on which both are one name")
    with pytest.raises(InputError, match=r"the sidecar of recording.csv, which is recording.toml. Rename it"):
        read(tmp_path, rows())
    (tmp_path / "recording.toml").write_text("[measurement]\nframe = 'robot'\n")
    assert read(tmp_path, rows()).measurement.frame == "robot"


@pytest.mark.parametrize("folder", [".", "/"])
def test_a_folder_is_no_recording(run: Run, folder: str) -> None:
    code, _, told = run("identify", example().parent / "delta" / "robot.toml", folder)
    assert code == 3
    assert "Is a directory" in told

"""The sidecar of a recording, NAME.toml: what was measured and how."""

from __future__ import annotations

import dataclasses
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, Field, ValidatorFunctionWrapHandler, WrapValidator

from deltacal_gen.files.columns import sidecar_path
from deltacal_gen.files.toml import Number, Positive, Table, TomlFile, Vector, table_of, toml_text
from deltacal_gen.instrument import kinds
from deltacal_gen.instrument.kinds import kind_of
from deltacal_gen.machine.values import UNKNOWN, Camera, Measurement, Recording


def _lens(value: object, check: ValidatorFunctionWrapHandler) -> Any:
    return UNKNOWN if value == "unknown" else check(value)


Lens = Annotated[Number, WrapValidator(_lens)]
Clocks = Literal["own", "own, same rate", "own, same for all runs"]  # and what of it is alike in all runs
LENS = ("fx_px", "fy_px", "cx_px", "cy_px", "k1", "k2", "p1", "p2", "k3")


LEAST, MOST = 1e-12, 1e9  # noise in any unit: its square has to be a number
Noise = Annotated[Positive, Field(ge=LEAST, le=MOST)]


_Focal = Annotated[Positive, WrapValidator(_lens)]
_Camera = table_of(
    Camera,
    Lens,
    fx_px=_Focal,
    fy_px=_Focal,
    rotation_deg=Vector,
    ball_radius_mm=Positive,
    place=Literal["platform", "fixed"],
)


def said_of(camera: Camera) -> dict[str, Any]:
    """Return a camera as a sidecar says it."""
    given = {f.name: value for f in dataclasses.fields(camera) if (value := getattr(camera, f.name)) != f.default}
    return {
        key: "unknown" if value != value else value
        for key, value in given.items()
        if value == value or key in LENS[4:]  # the others are left out
    }


_ALIASES = {alias: name for name in kinds.names() for alias in kind_of(name).aliases}
_Kind: Any = Annotated[Literal[kinds.names()], BeforeValidator(lambda said: _ALIASES.get(str(said), said))]
_Measurement = table_of(
    Measurement,
    Noise,
    kind=_Kind,
    frame=Literal["unknown", "robot"],
    instrument=str,
    operator=str,
    zero=Literal["absolute", "incremental"],
    base_point_mm=Vector,
    platform_point_mm=Vector,
    camera=_Camera,
    board_scale=Literal["known", "unknown"],
    clock=Clocks,
    clock_offset_s=Number,
    rotation=Literal["vector", "xyz", "xzy", "yxz", "yzx", "zxy", "zyx"],
)


class _Contacts(Table):
    distance_mm: tuple[tuple[str, str, Positive], ...] = ()


class Sidecar(Table):
    """The tables of a sidecar."""

    measurement: _Measurement = _Measurement()  # type: ignore[valid-type]
    camera: _Camera | None = None  # type: ignore[valid-type]
    contacts: _Contacts = _Contacts()


def read_measurement(sidecar: str | Path) -> Measurement:
    """Return what a sidecar, NAME.toml, says of the measurement.

    Raises
    ------
    InputError
        The file is missing, or a key in it is wrong.
    """
    return measurement_of(TomlFile.read(sidecar).check(Sidecar))


def read_sidecar(path: Path) -> Sidecar:
    """Read the sidecar of a recording; one that is not there says nothing."""
    path = sidecar_path(path)
    if not path.exists():
        return Sidecar()
    return TomlFile.read(path).check(Sidecar)


def measurement_of(sidecar: Sidecar) -> Measurement:
    """Return what a sidecar says of the measurement."""
    said: Any = sidecar
    camera = said.camera or said.measurement.camera
    return Measurement(**dict(said.measurement) | {"camera": None if camera is None else Camera(**dict(camera))})


def sidecar_text(recording: Recording) -> str:
    """Return the sidecar of a recording, as text."""
    fields = dataclasses.fields(Measurement)
    said = {f.name: value for f in fields if (value := getattr(recording.measurement, f.name)) != f.default}
    said.pop("camera", None)
    tables = {"measurement": {"kind": recording.kind, "frame": "unknown"} | said | {"kind": recording.kind}}
    if recording.measurement.camera is not None:
        tables["measurement.camera"] = said_of(recording.measurement.camera)
    if recording.contact_distances:
        tables["contacts"] = {"distance_mm": recording.contact_distances}
    return toml_text(tables)

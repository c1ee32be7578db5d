"""What a certificate says that no recording knows: who measured whose machine, where and when (TOML)."""

from __future__ import annotations

import datetime
from typing import Annotated, Literal

from pydantic import Field

from deltacal_gen.files.toml import Table, TomlFile

Text = Annotated[str, Field(min_length=1, pattern=r"^\S+(\s+\S+)*$")]
Country = Annotated[str, Field(pattern="^[A-Z]{2}$")]
Place = Literal["laboratory", "customer", "laboratoryBranch", "customerBranch", "other"]


class PartyTable(Table):
    """[laboratory], [customer]."""

    name: Text | None = None
    street: Text | None = None
    city: Text | None = None
    country: Country | None = None


class MachineTable(Table):
    """[machine]."""

    manufacturer: Text | None = None
    serial: Text | None = None


class CalibrationTable(Table):
    """[calibration]: its number, who answers for it, when and where it was made."""

    number: Text | None = None
    person: Text | None = None
    begin: datetime.date | None = None
    end: datetime.date | None = None
    place: Place | None = None


class About(Table):
    """The tables of the file, each of which may be absent."""

    laboratory: PartyTable = PartyTable()
    customer: PartyTable = PartyTable()
    machine: MachineTable = MachineTable()
    calibration: CalibrationTable = CalibrationTable()


def read_about(path: str) -> About:
    """Return what a file says; raises InputError for what cannot be."""
    file = TomlFile.read(path)
    about = file.check(About)
    begin, end = about.calibration.begin, about.calibration.end
    if begin is not None and end is not None and end < begin:
        raise file.error("the calibration ends before it begins.", "Correct the day.", "calibration", "end")
    return about

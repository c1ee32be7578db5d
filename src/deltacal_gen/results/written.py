"""What commands say of the files that they wrote, with ``--json``."""

from __future__ import annotations

from typing import Literal

from deltacal_gen.results.base import Answer, Rows


class Simulated(Answer):
    """A recording of `simulate`."""

    schema: Literal["deltacal.simulation/1"] = "deltacal.simulation/1"
    recording: str
    readings: int
    kind: str | None = None


class Matrix(Answer):
    """An identification matrix of `matrix`."""

    schema: Literal["deltacal.matrix/1"] = "deltacal.matrix/1"
    file: str
    rows: int
    columns: int
    rank: int
    condition: float | None
    """Null where the rank is not full."""
    scaling: str


class Joints(Answer):
    """Commands of `compensate`, in deg or mm."""

    schema: Literal["deltacal.joints/1"] = "deltacal.joints/1"
    kind: str
    export: str | None
    joints: Rows
    assumed: tuple[str, ...]
    """What was assumed where a channel was not given."""


class Predicted(Answer):
    """Readings of `predict`."""

    schema: Literal["deltacal.prediction/1"] = "deltacal.prediction/1"
    file: str
    kind: str | None = None
    readings: int
    told: tuple[str, ...]


class Imported(Answer):
    """What `import` made."""

    schema: Literal["deltacal.import/1"] = "deltacal.import/1"
    folder: str
    robot: str | None
    recordings: tuple[str, ...]
    warnings: tuple[str, ...]


class Derivation(Answer):
    """Pages of `derivation`."""

    schema: Literal["deltacal.derivation/1"] = "deltacal.derivation/1"
    files: tuple[str, ...]


class Manual(Answer):
    """A page of `manual`, or the files that it wrote."""

    schema: Literal["deltacal.manual/1"] = "deltacal.manual/1"
    topic: str
    text: str | None
    """Markdown; null where files were written and no topic was asked for."""
    files: tuple[str, ...]

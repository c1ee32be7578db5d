"""Recordings of what firmware and trackers keep."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from deltacal_gen.app.commands.common import Source

if TYPE_CHECKING:
    from deltacal_gen.files.imports import Imported


def import_klipper(path: Source, output: Source | None = None) -> Imported:
    """Return a robot and recordings of a Klipper printer.cfg; see `imports.import_klipper`."""
    from deltacal_gen.files import imports

    return imports.import_klipper(path, output)


def import_rrf(config: Source, height_map: Source, output: Source | None = None) -> Imported:
    """Return a robot and a recording of RepRapFirmware's config.g and height map; see `rrf.import_rrf`."""
    from deltacal_gen.files import rrf

    return rrf.import_rrf(config, height_map, output)


def import_marlin(path: Source, output: Source | None = None) -> Imported:
    """Return a robot and a recording of a log of Marlin: M503, G33, G29; see `marlin.import_marlin`."""
    from deltacal_gen.files import marlin

    return marlin.import_marlin(path, output)


def import_urdf(
    path: Source, output: Source | None = None, *, base: str | None = None, tip: str | None = None
) -> Imported:
    """Return a robot of the chain between two links of a URDF, and no recording; see `urdf.import_urdf`."""
    from deltacal_gen.files import urdf

    return urdf.import_urdf(path, output, base=base, tip=tip)


def import_points(
    points: Source, joints: Source, robot: Source | None = None, output: Source | None = None
) -> Imported:
    """Return a recording of a tracker's list of points and a table of joints; see `points.import_points`."""
    from deltacal_gen.files import points as lists

    return lists.import_points(points, joints, robot, output)


def import_bag(
    path: Source,
    robot: Source | None = None,
    output: Source | None = None,
    *,
    joints: str | None = None,
    readings: str | None = None,
    mapping: Source | None = None,
    moving: bool = False,
    offset_s: float = 0.0,
) -> Imported:
    """Return a recording of a bag of ROS or a file of MCAP; see `bags.import_bag`."""
    from deltacal_gen.files import bags

    how: dict[str, Any] = {"joints": joints, "readings": readings, "mapping": mapping}
    return bags.import_bag(path, robot, output, **how, moving=moving, offset_s=offset_s)


def import_c3d(
    path: Source,
    joints: Source,
    robot: Source | None = None,
    output: Source | None = None,
    *,
    readings: str | None = None,
    moving: bool = False,
    offset_s: float = 0.0,
) -> Imported:
    """Return a recording of a motion capture (C3D, CSV of Motive or Nexus) and joints; see `mocap.import_c3d`."""
    from deltacal_gen.files import mocap

    return mocap.import_c3d(path, joints, robot, output, readings=readings, moving=moving, offset_s=offset_s)

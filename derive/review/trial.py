"""A first look at a machine whose kernels were just derived: whether it closes, what is seen of it, how it looks."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from rich.console import Console
from rich.table import Table

from deltacal_gen.files.robot import Robot
from deltacal_gen.machine.registry import SOLVED, mechanism_of
from deltacal_gen.pages.report import asset
from derive.review import account as accounts
from derive.review import checks, reports

POSES = 100
WIDTH = 79  # of a terminal that nobody has widened


@dataclass(frozen=True)
class Trial:
    """What a machine does at poses without any symmetry.

    Attributes
    ----------
    poses, solved : int
        Poses tried, and those from which the joints that lead there lead back.
    worst_mm, worst_rad : float
        By which a pose, its joints and the pose at these joints miss at most, of those solved.
    order : float
        Least order at which derivatives by errors, joints and deflections leave a remainder: 2 where they are right.
    ranks : list of Rank
        What each kind of measurement sees of the machine's largest model.
    """

    model: str
    poses: int
    solved: int
    worst_mm: float
    worst_rad: float
    order: float
    ranks: list[checks.Rank]


def trial(robot: Robot, poses: int = POSES) -> Trial:
    """Return how a machine does in round trips, its derivatives' order, and ranks of its largest model."""
    mechanism = mechanism_of(robot)
    tried = checks.spread(robot, poses)
    rows = mechanism.rows(robot)
    target = tried.x if mechanism.turning else tried.x[:, :3]
    q, _, status = mechanism.inverse(target, robot.tool, rows, robot.geometric_limits)
    back, again = mechanism.forward(np.nan_to_num(q), robot.tool, rows, near=tried.x)
    gap, good = np.abs(checks.moved(tried.x, back)), (status == SOLVED) & (again == SOLVED)
    at = checks.trials(robot, poses)
    return Trial(
        model=mechanism.full_model,
        poses=poses,
        solved=int(good.sum()),
        worst_mm=float(gap[good, :3].max(initial=0.0)),
        worst_rad=float(gap[good, 3:].max(initial=0.0)),
        order=min(o.order for o in checks.orders(robot, tried)),
        ranks=checks.ranks(robot, at, list(mechanism.models[mechanism.full_model])),
    )


def drawn(robot: Robot) -> str:
    """Return a drawing (SVG) of the machine in the middle of its workspace, made of its own equations."""
    head, rest = reports.drawn(robot, accounts.mechanism(robot.mechanism, robot)).split(">", 1)
    style = asset("style.css")
    colours = style[style.index(":root") : style.index("}", style.index(":root")) + 1]  # the page's own, by their names
    ground = '<rect width="100%" height="100%" fill="var(--paper)"/>'
    return f"{head}><style>{colours} text {{ font-family: sans-serif }}</style>{ground}{rest}"


def told(robot: Robot, found: Trial) -> str:
    """Return a trial as text: a sentence, and a table of what is seen."""
    table = Table("seen by", "points", "rank", f"of {found.model}", "least / most")  # singular values
    for rank in found.ranks:
        table.add_row(rank.kind, str(rank.points), str(rank.rank), str(rank.columns), f"{rank.smallest:.1e}")
    screen = Console(width=WIDTH)
    with screen.capture() as seen:
        screen.print(table)
    there_and_back = (
        f"{robot.mechanism}: {found.solved} of {found.poses} poses there and back, within {found.worst_mm:.1e} mm and "
        f"{found.worst_rad:.1e} rad; derivatives leave a remainder of order {found.order:.2f} (2 is right)"
    )
    return f"{there_and_back}\n{seen.get()}"

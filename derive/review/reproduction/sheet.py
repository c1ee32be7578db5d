"""What a paper's tables and figures are remade as: sheets and pictures, each by the number it has in the paper."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import Any


@dataclass
class Sheet:
    """A table, with the paper's figures in columns of their own.

    Attributes
    ----------
    of : str
        Its number in the paper, as the ledger of claims has it (``Table 5``).
    title : str
        What it shows, and what was chosen where the paper is silent.
    columns : tuple of str
        Heads; those that hold the paper's figures begin with "paper".
    rows : list of tuple of str
        Cells.
    """

    of: str
    title: str
    columns: tuple[str, ...]
    rows: list[tuple[str, ...]] = field(default_factory=list)

    def add(self, *cells: object) -> None:
        """Add a row.

        Raises
        ------
        ValueError
            It has more or fewer cells than there are columns.
        """
        if len(cells) != len(self.columns):
            raise ValueError(f"{self.of}: {len(cells)} cells for {len(self.columns)} columns.")
        self.rows.append(tuple(map(str, cells)))


@dataclass(frozen=True)
class Picture:
    """A figure: its number, what it shows, and how it is drawn on axes of a grid (rows, columns) and a size [inch]."""

    of: str
    title: str
    draw: Callable[[Any], None]
    grid: tuple[int, int] = (1, 1)
    size: tuple[float, float] = (7.4, 3.0)


Part = Sheet | Picture
Study = Callable[[Callable[[str], None]], Iterator[Part]]  # from what tells of progress to its parts, one by one

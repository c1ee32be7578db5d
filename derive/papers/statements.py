"""Statements of a paper, each with what decides it: rows, equalities, formulas at rational machines, ranks."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from typing import Any

import sympy as sp

from derive.papers.exact import PRIMES, Field
from derive.papers.letters import Dictionary, Term, vanishes


@dataclass(frozen=True)
class Verdict:
    """What became of a statement.

    Attributes
    ----------
    where : str
        Its number in the paper.
    name : str
        By which the ledger refers to it.
    printed, correct : str
        The printed form, and what is derived, in the paper's letters.
    status : str
        As in the ledger: *proved* by SymPy, *verified* by exact evaluation, or *contradicted*.
    decided : str
        How.
    """

    where: str
    name: str
    printed: str
    correct: str
    status: str
    decided: str

    def entry(self) -> dict[str, str]:
        """Return it as it is written to the ledger's file."""
        return asdict(self)


@dataclass(frozen=True)
class Statement(ABC):
    """A printed form, where it stands, and how the ledger refers to it."""

    where: str
    name: str

    @abstractmethod
    def verdict(self) -> Verdict:
        """Return the printed form beside what is derived."""

    def _verdict(self, printed: str, correct: str, decided: str, held: str) -> Verdict:
        status = held if printed == correct else "contradicted"
        return Verdict(self.where, self.name, printed, correct, status, decided)


@dataclass(frozen=True)
class Rows(Statement):
    """A row, or one of each limb, printed as named blocks; `derived` holds the same blocks as they come out.

    Attributes
    ----------
    left : str
        What the paper calls it.
    letters : Dictionary
        Of the paper.
    printed : sequence of Term
        Block by block.
    derived : sequence of Matrix
        Block by block, in the paper's symbols.
    """

    left: str
    letters: Dictionary
    printed: Sequence[Term]
    derived: Sequence[sp.Matrix]

    def verdict(self) -> Verdict:
        """Compare block by block by SymPy; what is derived is read back in the paper's names."""
        found = []
        for term, block in zip(self.printed, self.derived, strict=True):
            same = self.letters.value(term).shape == block.shape and vanishes(self.letters.value(term) - block)
            found.append(str(term) if same else self.letters.read(block))
        count = sum(b.cols * b.rows for b in self.derived)
        decided = f"{count} entr{'y' if count == 1 else 'ies'} compared by SymPy"
        return self._verdict(self._shown(map(str, self.printed)), self._shown(found), decided, "proved")

    def _shown(self, blocks: Any) -> str:
        return f"{self.left} = [{', '.join(blocks)}]"


@dataclass(frozen=True)
class Equal(Statement):
    """An expression or a matrix that is printed whole.

    Attributes
    ----------
    left : str
        What the paper calls it.
    printed, derived : Expr or Matrix
        Both in the same symbols.
    text : str, optional
        The printed form, where it is better written by hand.
    """

    left: str
    printed: sp.Expr | sp.Matrix
    derived: sp.Expr | sp.Matrix
    text: str | None = None

    def verdict(self) -> Verdict:
        """Compare by SymPy."""
        printed = self.text or f"{self.left} = {shown(self.printed)}"
        if vanishes(sp.Matrix([self.printed]) - sp.Matrix([self.derived])):
            return self._verdict(printed, printed, "the difference is identically zero, by SymPy", "proved")
        return self._verdict(printed, f"{self.left} = {shown(self.derived)}", "derived by SymPy", "proved")


def shown(value: sp.Expr | sp.Matrix) -> str:
    """Return an expression or a matrix as text."""
    if not isinstance(value, sp.MatrixBase):
        return str(sp.sstr(value)).replace("**", "^").replace("*", " ")
    rows = (", ".join(shown(sp.sympify(e)) for e in value.row(r)) for r in range(value.rows))
    return f"[{'; '.join(rows)}]"


@dataclass(frozen=True)
class Formula(Statement):
    """A formula of matrices, evaluated exactly at rational machines.

    Attributes
    ----------
    text : str
        As printed.
    printed, derived : callable
        From a machine to the matrix as lists of rational numbers; None of a printed form that cannot be evaluated.
    machines : sequence
        What they are evaluated at.
    corrected : (str, callable), optional
        The form that takes the place of a printed one that does not hold: it is held against the derivation, too.
    proof : callable, optional
        Whether SymPy derives the formula, too, from rows that it compared entry by entry.
    """

    text: str
    printed: Callable[[Any], Any] | None
    derived: Callable[[Any], Any]
    machines: Sequence[Any]
    corrected: tuple[str, Callable[[Any], Any]] | None = None
    proof: Callable[[], bool] | None = None

    def verdict(self) -> Verdict:
        """Compare at every machine.

        Raises
        ------
        ValueError
            Neither the printed form nor the corrected one is what is derived.
        """
        derived = [self.derived(m) for m in self.machines]
        for text, form in ((self.text, self.printed), self.corrected or (self.text, None)):
            if form is not None and [form(m) for m in self.machines] == derived:
                size, many = f"{len(derived[0])} x {len(derived[0][0])} entries", len(self.machines)
                decided = f"{size} equal at {many} rational machine{'s' if many > 1 else ''}, exactly"
                if self.proof is None or not self.proof():
                    return self._verdict(self.text, text, decided, "verified")
                return self._verdict(self.text, text, f"by SymPy from its rows; {decided}", "proved")
        raise ValueError(f"{self.name}: neither '{self.text}' nor its correction is what is derived.")


@dataclass(frozen=True)
class Rank(Statement):
    """A rank that is printed, as text with the number in it, and the rows that decide it over prime fields.

    Attributes
    ----------
    text : str
        With ``{rank}`` where the number stands.
    printed : int
        The number in the paper.
    rows : callable
        From a `Field` to the matrix.
    """

    text: str
    printed: int
    rows: Callable[[Field], list[list[Any]]]

    def verdict(self) -> Verdict:
        """Count the rank over each of the primes; a generic pose of the real machine sees no less.

        Raises
        ------
        ValueError
            The primes do not agree.
        """
        matrices = [(field, self.rows(field)) for field in map(Field, PRIMES)]
        ranks = {field.rank(rows) for field, rows in matrices}
        if len(ranks) != 1:
            raise ValueError(f"{self.name}: ranks {sorted(ranks)} over the primes {PRIMES}.")
        (rank,) = ranks
        size = f"{len(matrices[0][1])} x {len(matrices[0][1][0])}"
        decided = f"{size} entries at poses that close exactly, over {len(PRIMES)} prime fields"
        return self._verdict(self.text.format(rank=self.printed), self.text.format(rank=rank), decided, "verified")


@dataclass(frozen=True)
class Least(Statement):
    """A number of poses or points from which on nothing more is seen, as text with ``{count}`` where it stands.

    Attributes
    ----------
    text : str
        With the number.
    printed : int
        The number in the paper.
    rows : callable
        From a `Field` and the number to the matrix.
    counts : sequence of int
        Those that are tried; the last is taken for plenty.
    """

    text: str
    printed: int
    rows: Callable[[Field, int], list[list[Any]]]
    counts: Sequence[int]

    def verdict(self) -> Verdict:
        """Return the least number whose rank is that of plenty."""
        field = Field(PRIMES[0])
        ranks = [field.rank(self.rows(field, count)) for count in self.counts]
        count = next(n for n, rank in zip(self.counts, ranks, strict=True) if rank == ranks[-1])
        told = ", ".join(f"{rank} with {n}" for n, rank in zip(self.counts, ranks, strict=True))
        decided = f"ranks {told}, at poses that close exactly, over a prime field"
        return self._verdict(self.text.format(count=self.printed), self.text.format(count=count), decided, "verified")

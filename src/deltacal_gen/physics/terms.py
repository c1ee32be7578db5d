"""Terms: effects with their coefficients on a machine, by limb or by tool point, and as files and answers keep them."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, Any

import deltacal_kernels.effects
import numpy as np

from deltacal_gen import states
from deltacal_gen.machine.backend import RowFunctions, row_functions
from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.law import Law, is_law, load_law
from deltacal_gen.states import State
from deltacal_gen.units import of_joints, of_sliding

if TYPE_CHECKING:
    from deltacal_gen.results.parts import TermState

DOUBTED = 2.0  # standard deviations by which a coefficient may lie outside its believable range
UNKNOWN = "of a session without the channel"
LOGGED = states.TIME  # the column in which time constants count where nothing else is said
Point = tuple[float, float, float]
Constant = float | str


def effect_names() -> tuple[str, ...]:
    """Return the names of all registered effects."""
    return tuple(deltacal_kernels.effects.EFFECTS)


def drive_effect_names() -> tuple[str, ...]:
    """Return the names of all registered effects on what drives give, which no pose shows."""
    return tuple(deltacal_kernels.effects.OF_DRIVES)


@cache
def load_effect(name: str) -> RowFunctions | Law:
    """Return the generated module of an effect: its tables, `value` and `jacobian`; of a law, the same made of it."""
    if is_law(name):
        return load_law(name)
    return row_functions(f"effects.{name}")


class Partial:
    """An effect on a machine that has not all parts it moves: its generated module without some coefficients.

    What no coefficient moves is not moved, and what is read for that alone is not read.
    """

    def __init__(self, whole: RowFunctions | Law, lacks: tuple[str, ...]) -> None:
        self._whole = whole
        self._own = [c for c, (name, *_) in enumerate(whole.COEFFICIENTS) if name not in lacks]
        self.COEFFICIENTS = tuple(whole.COEFFICIENTS[c] for c in self._own)
        self.BELIEVABLE = tuple(whole.BELIEVABLE[c] for c in self._own)
        names = {name for name, *_ in self.COEFFICIENTS}
        each = enumerate(zip(whole.PARTS, whole.TARGETS, strict=True))
        self._targets = [t for t, ((own, _), target) in each if names & set(own) and target not in lacks]
        self.TARGETS = tuple(whole.TARGETS[t] for t in self._targets)
        read = {state for t in self._targets for state in whole.PARTS[t][1]}
        self._read = [s for s, name in enumerate(whole.STATE) if name in read]
        self.STATE = tuple(whole.STATE[s] for s in self._read)

    def __getattr__(self, name: str) -> Any:
        return getattr(self._whole, name)

    def value(self, s: Array, c: Array, constants: Sequence[Constant] = ()) -> Array:
        """Return by how much each target is moved, (M, n_t)."""
        return np.asarray(self._whole.value(*self._filled(s, c), constants)[:, self._targets])

    def jacobian(self, s: Array, c: Array, constants: Sequence[Constant] = ()) -> Array:
        """Return the derivatives of `value` by the coefficients, (M, n_t, n_c)."""
        return np.asarray(self._whole.jacobian(*self._filled(s, c), constants)[:, self._targets][:, :, self._own])

    def _filled(self, s: Array, c: Array) -> tuple[Array, Array]:
        every_s, every_c = np.zeros((len(s), len(self._whole.STATE))), np.zeros((len(c), len(self._whole.COEFFICIENTS)))
        every_s[:, self._read], every_c[:, self._own] = s, c
        return every_s, every_c


class Interrupted:
    """An effect that reads a channel which some sessions lack: there it moves by as much as nobody knows.

    What the channel was in such a session is one value: its product with every coefficient is a coefficient of its own,
    limb by limb, which counts in rows whose cells are blank. The session of a row comes last in the kernels' input.
    """

    def __init__(self, whole: RowFunctions | Law | Partial, gaps: tuple[int, ...]) -> None:
        self._whole, self._gaps = whole, gaps
        own = whole.COEFFICIENTS
        unknown = ((f"{name}_in_{k}", unit, factor, UNKNOWN) for k in gaps for name, unit, factor, _ in own)
        self.COEFFICIENTS = (*own, *unknown)
        self.BELIEVABLE = (*whole.BELIEVABLE, *[(-np.inf, np.inf)] * (len(own) * len(gaps)))

    def __getattr__(self, name: str) -> Any:
        return getattr(self._whole, name)

    def value(self, s: Array, c: Array, constants: Sequence[Constant] = ()) -> Array:
        """Return by how much each target is moved, (M, n_t)."""
        known, place = self._known(s)
        return np.asarray(self._whole.value(known, self._own(c, place), constants))

    def jacobian(self, s: Array, c: Array, constants: Sequence[Constant] = ()) -> Array:
        """Return the derivatives of `value` by the coefficients, (M, n_t, n_c)."""
        known, place = self._known(s)
        D = np.asarray(self._whole.jacobian(known, self._own(c, place), constants))
        out = np.zeros((*D.shape[:2], 1 + len(self._gaps), D.shape[2]))
        out[np.arange(len(D)), :, place] = D
        return out.reshape(*D.shape[:2], -1)

    def _known(self, s: Array) -> tuple[Array, np.ndarray]:
        """Return states with 1 for what is blank, and which coefficients (M,) count: 0 the effect's own."""
        blank = np.isnan(s[:, :-1]).any(axis=1)
        place = np.zeros(len(s), dtype=np.int64)
        for k, session in enumerate(self._gaps, 1):
            place[blank & (s[:, -1] == session)] = k
        return np.where(np.isnan(s[:, :-1]), 1.0, s[:, :-1]), place

    def _own(self, c: Array, place: np.ndarray) -> Array:
        each = np.broadcast_to(c, (len(place), c.shape[1])).reshape(len(place), 1 + len(self._gaps), -1)
        own: Array = each[np.arange(len(place)), place]
        return own


Kernels = RowFunctions | Law | Partial | Interrupted


@cache
def partial(effect: str, lacks: tuple[str, ...], gaps: tuple[int, ...] = ()) -> Kernels:
    """Return the module of an effect without some coefficients, with those of sessions that lack its channel."""
    found = Partial(load_effect(effect), lacks) if lacks else load_effect(effect)
    return Interrupted(found, gaps) if gaps else found


@dataclass(frozen=True)
class Term:
    """An effect with its coefficients on a machine.

    Attributes
    ----------
    effect : str
    limbs : tuple of int
        Limbs (from 1) that have it; empty for an effect of the whole machine.
    constants : tuple of float or str
        Found by search: the order of a harmonic, the time of a jump, the name of a column.
    values : (limbs, tools or 1, n_c) array
        Coefficients [mm, rad, N, s, K].
    tools : tuple of (x, y, z)
        Tool points [mm] that have it, of an effect that displaces measured points.
    lacks : tuple of str
        Coefficients, and targets of others, that it does not have, as the machine lacks them.
    gaps : tuple of int
        Sessions in which cells of a channel that it reads are blank; see `Interrupted`.
    """

    effect: str
    limbs: tuple[int, ...]
    values: Array
    constants: tuple[Constant, ...] = ()
    tools: tuple[Point, ...] = ()
    lacks: tuple[str, ...] = ()
    gaps: tuple[int, ...] = ()

    @property
    def kernels(self) -> Kernels:
        """The effect's generated module."""
        return partial(self.effect, self.lacks, self.gaps)

    @property
    def own(self) -> int:
        """How many coefficients a limb has that say something of the effect: those of gaps do not."""
        return self.values.shape[1] // (1 + len(self.gaps))

    @property
    def plain(self) -> Term:
        """The term without what sessions that lack its channel have."""
        return dataclasses.replace(self, values=self.values[:, : self.own], gaps=()) if self.gaps else self

    @property
    def states(self) -> tuple[State, ...]:
        """What the effect reads, in the order of its kernels' input; what constants choose, as they do."""
        known = dict(zip((name for name, *_ in self.kernels.CONSTANTS), self.constants, strict=False))
        return tuple(s.chosen(known[s.by]) if s.by in known else s for s in states.read_by(self.kernels))

    @property
    def n_coefficients(self) -> int:
        """Number of coefficients, all limbs together."""
        return int(self.values.size)

    def with_values(self, flat: Array) -> Term:
        """Return the term with other coefficients (n_coefficients,)."""
        return dataclasses.replace(self, values=np.asarray(flat, dtype=float).reshape(self.values.shape))

    def constant(self, name: str) -> Constant:
        """Return a constant by name."""
        return self.constants[[key for key, *_ in self.kernels.CONSTANTS].index(name)]

    def afterwards(self) -> Term:
        """Return the effect as it acts after the recording in which it was found: a jump is past."""
        past, names = self.kernels.AFTERWARDS, [key for key, *_ in self.kernels.CONSTANTS]
        constants = tuple(past.get(key, value) for key, value in zip(names, self.constants, strict=True))
        return dataclasses.replace(self, constants=constants)

    @property
    def happens(self) -> bool:
        """Whether it happens at a moment that readings may stand before; what is past does not."""
        return self.constants != self.afterwards().constants

    def counted(self, anew: Callable[[float], float]) -> Term:
        """Return the effect with the moments at which it happens once counted anew, as on another clock."""
        once, names = self.kernels.AFTERWARDS, [key for key, *_ in self.kernels.CONSTANTS]
        constants = tuple(anew(float(c)) if key in once else c for key, c in zip(names, self.constants, strict=True))
        return dataclasses.replace(self, constants=constants)


def blank(
    effect: str,
    limbs: Sequence[int],
    constants: Sequence[Constant] = (),
    tools: Sequence[Sequence[float]] = (),
    lacks: tuple[str, ...] = (),
    gaps: tuple[int, ...] = (),
) -> Term:
    """Return a term with all coefficients zero."""
    kernels = partial(effect, lacks, gaps)
    own = tuple(limbs) if kernels.PER_LIMB else ()
    points = tuple((float(x), float(y), float(z)) for x, y, z in tools) if displaces_points(kernels) else ()
    values = np.zeros((max(len(own), len(points), 1), len(kernels.COEFFICIENTS)))
    return Term(effect, own, values, tuple(constants), points, lacks, gaps)


def remembers(kernels: Kernels) -> bool:
    """Tell whether an effect has memories along a run."""
    return bool(getattr(kernels, "MEMORY", ()))


def displaces_points(kernels: Kernels) -> bool:
    """Tell whether an effect acts tool point by tool point."""
    return "points" in kernels.SEARCHED


def of_reading(terms: Sequence[Term]) -> tuple[Term, ...]:
    """Return the effects that act on the reading itself."""
    return tuple(t for t in terms if t.kernels.ACTS_ON == "reading")


def of_the_instrument(effect: str) -> bool:
    """Tell whether what an effect moves is only read, or where: no command undoes it."""
    return load_effect(effect).ACTS_ON in ("point", "reading")


def coefficients(kernels: Kernels, joint_unit: str) -> tuple[tuple[str, str, float], ...]:
    """Return name, unit in files and factor to the unit inside of an effect's coefficients.

    Those of a joint depend on whether it turns or slides (`joint_unit` rad or mm).
    """
    return tuple(
        (name, *(of_sliding(unit) if joint_unit == "mm" and name in kernels.OF_JOINT else (unit, factor)))
        for name, unit, factor, _ in kernels.COEFFICIENTS
    )


def row_coefficients(term: Term, joint_unit: str) -> list[tuple[tuple[str, str, float], ...]]:
    """Return `coefficients` for each row of a term's values: a limb's, where its joint says in what they count."""
    units = of_joints(joint_unit, max(term.limbs, default=1))
    of_rows = [units[i - 1] for i in term.limbs] or [units[0]] * len(term.values)
    return [coefficients(term.kernels, unit) for unit in of_rows]


def constants_of(term: Term, joint_unit: str) -> tuple[tuple[str, str, float], ...]:
    """Return name, unit in files and factor to the unit inside of a term's constants, as its first joint counts."""
    unit = of_joints(joint_unit, max(term.limbs, default=1))[min(term.limbs, default=1) - 1]
    return tuple(
        (name, *(of_sliding(of) if unit == "mm" and name in term.kernels.OF_JOINT else (of, factor)))
        for name, of, factor, _ in term.kernels.CONSTANTS
    )


def scaled(value: Constant, factor: float) -> Constant:
    """Return a constant in other units; a name has none."""
    return value if isinstance(value, str) else value * factor


def row_factors(term: Term, joint_unit: str) -> Array:
    """Return the factors (rows, n_c) from files' units to those inside of a term's values."""
    return np.array([[factor for _, _, factor in row] for row in row_coefficients(term, joint_unit)])


TURNED = "approach counts the other way here, or a controller takes out more than there is"


@dataclass(frozen=True)
class Beyond:
    """A coefficient that no machine worth measuring has: of which row of a term, how large, in files' units."""

    row: int
    name: str
    value: float
    unit: str
    believable: tuple[float, float]
    turned: bool = False
    """Whether it could be, if the direction of approach counted the other way."""

    def __str__(self) -> str:
        low, high = self.believable
        unless = f", unless {TURNED}" if self.turned else ""
        return f"a {self.name} of {self.value:.3g} {self.unit}, where {low:g} to {high:g} can be{unless}"


def beyond(term: Term, std: Array, joint_unit: str) -> list[Beyond]:
    """Return the coefficients that leave their believable range by more than their own uncertainty allows.

    Parameters
    ----------
    std : (n_c,) or (limbs, n_c) array
        Standard deviations of the coefficients, in the units of `term.values`.
    """
    out = []
    allowed = DOUBTED * np.reshape(std, term.values.shape)
    directed = any(channel.column == states.APPROACH for state in term.states for channel in state.channels)
    for r, row in enumerate(row_coefficients(term, joint_unit)):
        for c, ((name, unit, factor), (low, high)) in enumerate(zip(row, term.kernels.BELIEVABLE, strict=True)):
            value, doubt = term.values[r, c] / factor, allowed[r, c] / abs(factor)
            if not low - doubt <= value <= high + doubt:
                turned = directed and low <= -value <= high
                out.append(Beyond(r, name, float(value), unit, (low, high), turned))
    return out


def largest(term: Term, joint_unit: str) -> Array:
    """Return the largest believable size (rows, n_c) of each coefficient, in the units of `term.values`."""
    out: Array = np.abs(row_factors(term, joint_unit)) * np.abs(term.kernels.BELIEVABLE).max(axis=1)
    return out


def without_rows(term: Term, rows: Sequence[int]) -> Term | None:
    """Return a term on its other limbs, or tool points; None where there are none."""
    kept = [r for r in range(len(term.values)) if r not in set(rows)]
    if not kept:
        return None
    limbs = tuple(term.limbs[r] for r in kept) if term.limbs else ()
    tools = tuple(term.tools[r] for r in kept) if term.tools else ()
    return dataclasses.replace(term, limbs=limbs, tools=tools, values=term.values[kept])


def on_limbs(term: Term, limbs: Sequence[int]) -> Term:
    """Return a term on some of its limbs; as it is where it has none of them."""
    return without_rows(term, [r for r, limb in enumerate(term.limbs) if limb not in limbs]) or term


def kept_term(term: Term) -> TermState:
    """Return what an answer keeps of a term, in its own units inside."""
    from deltacal_gen.results.parts import TermState

    return TermState(
        effect=term.effect,
        limbs=term.limbs,
        constants=term.constants,
        values=term.values,
        tools=term.tools,
        lacks=term.lacks or None,
        gaps=term.gaps or None,
    )


def term_of(kept: TermState) -> Term:
    """Return the term that an answer kept."""
    return Term(kept.effect, kept.limbs, kept.values, kept.constants, kept.tools, kept.lacks or (), kept.gaps or ())

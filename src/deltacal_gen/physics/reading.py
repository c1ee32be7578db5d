"""Effects on the reading: what they add to what an instrument would read of the deformed machine."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from deltacal_gen.instrument.kind import Readings
from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.body import Body, states_read
from deltacal_gen.physics.terms import Term
from deltacal_gen.states import STATES

STEP = 1e-4  # mm or rad: by which readings and the point differ to see how what is added follows them
READ = tuple(s.name for s in STATES.values() if s.kind == "reading")


def reading_shift(terms: Sequence[Term], body: Body, found: Readings, values: Array, x: Array) -> tuple[Array, Array]:
    """Return what effects on the reading add to predicted readings (R, k), and the derivatives (R, k, n_c).

    Parameters
    ----------
    found : Readings
        Which rows of the recording, and what of them.
    values : (R, k) array
        Readings as predicted without these effects.
    x : (N, 12) array
        Poses of the machine.
    """
    R, k = values.shape
    added, parts = np.zeros((R, k)), []
    columns, rows = found.kind.targets, found.rows[:, 0]
    for term in terms:
        kernels = term.kernels
        own = np.zeros((R, k, term.n_coefficients))
        on = [(j, columns[t]) for j, t in enumerate(kernels.TARGETS) if t in columns]
        if on and kernels.ACTS_ON == "reading":
            # a column that this kind of reading does not have is read by no target that acts here
            state = dict.fromkeys(READ, np.zeros(R))
            state |= {f"y_{t.rpartition('.')[2]}": values[:, c] for t, c in columns.items()}
            machine = body.state(states_read([term]), x, body.q, np.zeros((0, 0, 0)))  # no parameter is read
            state |= {name: (v if v.ndim == 1 else v.mean(axis=1))[rows] for name, v in machine.items()}
            state |= {s.name: body.since(term, s)[rows] for s in term.states if s.by}
            if set(kernels.STATE) <= state.keys():
                s = np.column_stack([state[n] for n in kernels.STATE]) if kernels.STATE else np.zeros((R, 0))
                s = np.column_stack([s, body.session[rows]]) if term.gaps else s
                value, D = (
                    kernels.value(s, term.values, term.constants),
                    kernels.jacobian(s, term.values, term.constants),
                )
                for j, column in on:
                    added[:, column] += value[:, j]
                    own[:, column] += D[:, j]
        parts.append(own)
    return added, np.concatenate(parts, axis=2) if parts else np.zeros((R, k, 0))


def shift_follows(term: Term) -> bool:
    """Tell whether what an effect adds to readings changes with them, or with where the machine stands."""
    return term.kernels.ACTS_ON == "reading" and any(s.kind == "reading" or s.follows for s in term.states)


def following_shift(terms: Sequence[Term], body: Body, found: Readings, values: Array, x: Array) -> tuple[Array, Array]:
    """Return the derivatives of what `reading_shift` adds, by the readings (R, k, k) and by the point (R, k, 3)."""
    still, _ = reading_shift(terms, body, found, values, x)

    def by(at: Callable[[Array], tuple[Array, Array]], axes: Array) -> Array:
        ends = [reading_shift(terms, body, found, *at(STEP * axis))[0] for axis in axes]
        return (np.stack(ends, axis=2) - still[:, :, None]) / STEP

    place = np.eye(x.shape[1])[:3]
    return by(lambda step: (values + step, x), np.eye(values.shape[1])), by(lambda step: (values, x + step), place)

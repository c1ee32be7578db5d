"""How a machine that gives way moves where the loads on it follow: what its derivatives at fixed loads leave out.

Displacements D of limbs come of the machine that they move, D = L(D, p), so that by parameters p
dD = (1 - dL/dD)^-1 (dL/dD dD_fixed + dL/dp dp), in every pose by itself. Derivatives of L are differences: of a machine
displaced, which costs one pose and its loads, not of one solved to its equilibrium.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.body import Body, by_limb, follows, states_read
from deltacal_gen.physics.deformed import Deformed, carried
from deltacal_gen.physics.targets import target_of
from deltacal_gen.physics.terms import Term

STEP = 1e-4  # mm or rad: by which a machine is displaced to see how its loads follow

Place = tuple[str, int]  # what an effect moves: target, and limb from 0; of base and point 0


def following(
    body: Body, errors: Array, terms: Sequence[Term], held: Sequence[Term], machine: Deformed, names: Sequence[str]
) -> Array:
    """Return what the derivatives of platform coordinates gain where loads follow the machine, (N, n_x, n).

    By source errors of these `names`, then by the coefficients of `terms`; beside the mechanism's sensitivity and
    `Body.columns`, which are at fixed loads.

    Parameters
    ----------
    errors : (n_p,) array
        Source errors of the machine [mm, rad].
    held : sequence of Term
        Effects beside `terms` that stay as they are.
    machine : Deformed
        In equilibrium under all of them.
    """
    pulled = [t for t in (*terms, *held) if t.kernels.ACTS_ON != "reading" and follows(t)]
    x = machine.upright
    ends = list(dict.fromkeys(place for t in pulled for place in _places(body, t)))
    moved_freely = [place for t in terms for place in _places(body, t)]
    at = {place: k for k, place in enumerate(dict.fromkeys((*ends, *moved_freely)))}
    if not ends:
        return np.zeros((len(x), body.mechanism.n_x, len(names) + sum(t.n_coefficients for t in terms)))
    reads, limbs = states_read(pulled), body.pulled(pulled)

    def loaded(q: Array, tool: Array, rows: Array) -> Array:
        there, _ = body.mechanism.forward(q, tool, rows, near=x)
        moved = body.moved(pulled, body.state(reads, np.nan_to_num(there), q, rows, limbs))
        return np.stack([v if (v := moved[target]).ndim == 1 else v[:, j] for target, j in ends], axis=1)

    still, plain = loaded(machine.q, machine.tool, machine.rows), body.mechanism.rows(body.robot, errors)
    by_place, by_name = np.empty((len(x), len(ends), len(at))), np.empty((len(x), len(ends), len(names)))
    for place, k in at.items():
        by_place[:, :, k] = (loaded(*_displaced(body, machine, place)) - still) / STEP
    for k, name in enumerate(names):
        moved = errors.copy()
        moved[body.mechanism.index[name]] += STEP
        rows = machine.rows + (body.mechanism.rows(body.robot, moved) - plain)
        by_name[:, :, k] = (loaded(machine.q, machine.tool, rows) - still) / STEP
    own = np.concatenate([by_name, by_place @ _direct(body, terms, at, machine)], axis=2)
    return _moving(body, machine, ends) @ np.linalg.solve(np.eye(len(ends)) - by_place[:, :, : len(ends)], own)


def _places(body: Body, term: Term) -> list[Place]:
    if term.kernels.ACTS_ON == "reading":
        return []
    limbs = range(body.mechanism.limbs) if by_limb(term) else (0,)
    own = [i - 1 for i in term.limbs] or limbs
    return [(target, j) for target in term.kernels.TARGETS for j in own]


def _displaced(body: Body, machine: Deformed, place: Place) -> tuple[Array, Array, Array]:
    """Return joints, points and rows of parameters of a machine of which one thing has moved by a step.

    A turn of the base turns what is read, and no load: it comes last; see `Body.solve`.
    """
    name, j = place
    target, q, tool, rows = target_of(name), machine.q, machine.tool, machine.rows
    if target.sort == "joint":
        q = q + STEP * np.eye(body.mechanism.limbs)[j]
    elif target.sort == "tool":
        tool = tool + STEP * np.eye(3)[target.axis]
    elif target.sort == "limb":
        rows = rows.copy()
        for name, much in body.moves[target.part].items():
            rows[:, :, body.mechanism.column(name)] += STEP * much[:, j]
    return q, tool, rows


def _moving(body: Body, machine: Deformed, places: Sequence[Place]) -> Array:
    """Return the derivatives of the platform's coordinates by what effects move, (N, n_x, k)."""
    S = body.sensitivity(machine)
    limbs = sorted({j + 1 for target, j in places if target_of(target).sort == "limb"})

    def moved(name: str) -> Array:
        target = target_of(name)
        if target.sort == "joint":
            return S.joints
        return body.along(S, target.part, limbs) if target.sort == "limb" else carried(target, machine)[:, :, None]

    by_target = {target: moved(target) for target, _ in places}
    return np.stack([by_target[target][:, :, j] for target, j in places], axis=2)


def _direct(body: Body, terms: Sequence[Term], at: Mapping[Place, int], machine: Deformed) -> Array:
    """Return the derivatives of what effects move, `at` its places, by their coefficients, (N, k, n_c)."""
    N, limbs = body.q.shape
    out, start = np.zeros((N, len(at), sum(t.n_coefficients for t in terms))), 0
    state = body.state(states_read(terms), machine.upright, machine.q, machine.rows, body.pulled(terms))
    for term in terms:
        targets = term.kernels.TARGETS
        if by_limb(term):
            D = body.derivatives(term, body.read(term, state), body.coefficients(term))
            D = D.reshape(N, limbs, len(targets), -1)
            for i, (target, j) in enumerate(_places(body, term)):
                own = start + (i % len(term.limbs) * D.shape[3] if term.limbs else 0)
                out[:, at[target, j], own : own + D.shape[3]] = D[:, j, targets.index(target)]
        elif places := _places(body, term):
            D = body.by_coefficients(term, state)
            out[:, [at[place] for place in places], start : start + D.shape[2]] = D
        start += term.n_coefficients
    return out

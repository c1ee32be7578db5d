"""Laws of drives as DIAGNOSIS.json holds them: one answer, of every joint that has a law its terms."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from deltacal_gen.motion.joint import Joint
from deltacal_gen.motion.laws import Lawful
from deltacal_gen.motion.library import LOAD
from deltacal_gen.motion.session import Session
from deltacal_gen.physics.formula import unit, written
from deltacal_gen.physics.law import Law, inside, load_law
from deltacal_gen.results.diagnosis import LawCoefficient, LawCurve, LawTerm
from deltacal_gen.results.motion import TorqueLaw
from deltacal_gen.states import named

if TYPE_CHECKING:
    from deltacal_gen.machine.registry import Array

POINTS, DOTS = 121, 800  # of a curve, and of the samples beside it


def told(session: Session, found: Mapping[int, Lawful]) -> tuple[TorqueLaw, ...]:
    """Return the laws of some joints (from 1) as one answer; nothing where there are none."""
    if not found:
        return ()
    each = [found[j] for j in sorted(found)]
    limits: dict[str, tuple[float, float]] = {}
    for law in each:
        for state, (low, high) in law.limits.items():
            before = limits.get(state, (np.inf, -np.inf))
            limits[state] = (min(before[0], low), max(before[1], high))
    units = tuple(joint.unit for joint in session.joints)
    heldout = tuple(found[j.number].heldout / j.readout.inside if j.number in found else None for j in session.joints)
    known = [h for h in heldout if h is not None]
    together = float(np.sqrt(np.mean(np.square(known)))) if len(set(units)) == 1 else None
    return (
        TorqueLaw(
            terms=tuple(term for law in each for term in _terms(session, law)),
            states=tuple(limits),
            range=limits,
            heldout_rms=together,
            heldout_rms_by_joint=heldout,
            unit_by_joint=units,
            share_of_excess=float(np.mean([law.share for law in each])),
            gain=float(sum(law.gain for law in each)),
            charge=float(sum(law.charge for law in each)),
            alike=tuple(dict.fromkeys(text for law in each for text in law.alike)),
            borne_out=True,
            curve=_curve(session, each[0]),
        ),
    )


def _terms(session: Session, law: Lawful) -> list[LawTerm]:
    """Return the terms of a joint's law."""
    joint, terms = law.fit.joint, []
    at = len(law.fit.coefficients) - sum(rung.width for rung in law.rungs)
    for rung, form, std in zip(law.rungs, law.forms, law.std, strict=True):
        module = load_law(rung.effect)
        linear = module.formula.linear
        units = module.units(_joint_unit(session, joint.number), _inside(joint))
        first = len(form.functions) + 1
        names = [*linear, *(f"c{first + k}" for k in range(len(form.constants)))]
        values = [*law.fit.coefficients[at : at + rung.width], *form.constants]
        terms.append(
            LawTerm(
                target="torque",
                limbs=(joint.number,),
                expression=module.formula.text,
                coefficients=tuple(
                    LawCoefficient(
                        name=name,
                        limb=joint.number if name in linear else None,
                        value=float(value),
                        std=float(s),
                        unit=written(units[name]),
                    )
                    for name, value, s in zip(names, values, std, strict=True)
                ),
            )
        )
        at += rung.width
    return terms


def _joint_unit(session: Session, joint: int) -> str:
    return session.rigid.dynamics.joint_units[joint - 1]


def _inside(joint: Joint) -> str:
    """Return the unit in which a joint's law is: that of its readings, or of what they are known to be."""
    return {"Nm": "N mm"}.get(joint.readout.told, joint.readout.told)


def _curve(session: Session, law: Lawful) -> LawCurve:
    """Return the law of a joint along its first state, others at their median, and what samples say of it there."""
    fit, joint = law.fit, law.fit.joint
    states = joint.states | {LOAD: fit.load}
    module = load_law(law.rungs[0].effect)
    assert isinstance(module, Law)
    first, *others = sorted(module.STATE, key=lambda s: s == "qd")  # friction is drawn along what changes it
    rungs = [rung for rung in law.rungs if {*load_law(rung.effect).STATE} <= {*module.STATE}]
    width = sum(rung.width for rung in law.rungs)
    own = dict(zip(law.rungs, np.split(np.arange(len(fit.coefficients))[-width:], _ends(law)), strict=True))
    at = [int(k) for rung in rungs for k in own[rung]]

    def along(values: Mapping[str, Array]) -> Array:
        return np.hstack([rung.columns(dict(values)) for rung in rungs])

    low, high = law.limits[first]
    middle = {s: float(np.quantile(states[s], 0.75)) if s == "qd" else float(np.median(states[s])) for s in others}
    grid = {first: np.linspace(low, high, POINTS)} | {s: np.full(POINTS, v) for s, v in middle.items()}
    some = np.linspace(0, len(joint.y) - 1, min(DOTS, len(joint.y))).astype(int)
    seen = {s: states[s][some] for s in module.STATE}
    now = along(seen) @ fit.coefficients[at]
    shown = along({first: seen[first]} | {s: np.full(len(some), v) for s, v in middle.items()}) @ fit.coefficients[at]
    ratio = np.divide(shown, now, out=np.ones_like(now), where=np.abs(now) > 1e-3 * np.abs(now).max())
    by = along(grid)
    return LawCurve(
        state=first,
        unit=written(unit(inside(named(first), _joint_unit(session, joint.number), _inside(joint)))),
        target_unit=_inside(joint),
        at=grid[first],
        value=by @ fit.coefficients[at],
        std=np.sqrt((by**2) @ np.square(fit.std[at])),
        seen=seen[first],
        partial=shown + ratio * fit.left[some],
    )


def _ends(law: Lawful) -> Sequence[int]:
    """Return where the coefficients of each further term begin."""
    return [int(n) for n in np.cumsum([rung.width for rung in law.rungs])[:-1]]

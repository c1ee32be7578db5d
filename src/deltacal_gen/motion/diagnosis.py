"""From what drives gave to the friction behind it: the ladder of every joint, told together."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from scipy.stats import chi2

from deltacal_gen.machine.values import Robot
from deltacal_gen.motion.identification import RIGID
from deltacal_gen.motion.joint import Fit, climbed, fitted
from deltacal_gen.motion.ladder import BUYS
from deltacal_gen.motion.session import Session, sigma_said
from deltacal_gen.motion.trajectories import INSIDE, Trajectories
from deltacal_gen.motion.unexplained import Rest, rest
from deltacal_gen.physics.terms import drive_effect_names, load_effect
from deltacal_gen.results.diagnosis import EffectParameter, Verdict
from deltacal_gen.results.motion import (
    LadderOf,
    MotionDiagnosis,
    MotionLocation,
    RungOf,
    TorqueEffect,
    Unexplained,
)
from deltacal_gen.results.parts import Missing
from deltacal_gen.units import of_sliding

if TYPE_CHECKING:
    from deltacal_gen.physics.terms import Kernels

Progress = Callable[[str], None]
NEEDS = {"warming": "temperatures that differ in a column temp_C", "turn": "joints that pass two periods"}


def diagnose(robot: Robot, given: Trajectories, progress: Progress) -> MotionDiagnosis:
    """Find what each drive has beside the rigid machine.

    Raises
    ------
    InputError
        No joint moves for long enough.
    """
    progress("derivatives")
    session = Session.of(robot, given)
    plain: list[Fit] = []
    found: list[Fit] = []
    for joint in session.moving:
        progress(f"joint {joint.number}")
        plain.append(fitted(joint, []))
        found.append(climbed(joint))
    rests = [rest(fit, _sigma(session, fit)) for fit in found]
    effects = _effects(session, found)
    baseline, final = session.left(plain, f"{robot.mechanism}/{RIGID}"), session.left(found)
    open_ = [r for r in rests if r is not None]
    verdict = Verdict.UNEXPLAINED if open_ else Verdict.MISSING_PHYSICS if effects else Verdict.ADEQUATE
    return MotionDiagnosis(
        **session.answered(found),
        verdict=verdict,
        summary=_summary(effects, open_, session, found),
        noise=session.noise(found),
        baseline=baseline,
        location=_location(effects, open_),
        effects=effects,
        final=final,
        ladder=tuple(_ladder(fit, r) for fit, r in zip(found, rests, strict=True)),
        unexplained=tuple(Unexplained(limb=r.joint, channel=r.channel, share=r.share, text=r.text) for r in open_),
        rejected=(),
        not_tested=_not_tested(found),
    )


def _sigma(session: Session, fit: Fit) -> float | None:
    said = sigma_said(session.given, fit.joint.unit)
    return None if said is None else said * INSIDE[fit.joint.unit]


def _effects(session: Session, fits: Sequence[Fit]) -> tuple[TorqueEffect, ...]:
    """Return the effects by name; those of several orders one for each."""
    of_name: dict[tuple[str, tuple[float, ...]], list[tuple[Fit, int]]] = {}
    for fit in fits:
        for n, rung in enumerate(fit.rungs):
            key = rung.effect, rung.constants if "orders" in rung.kernels.SEARCHED else ()
            of_name.setdefault(key, []).append((fit, n))
    return tuple(_effect(session, where) for where in of_name.values())


def _effect(session: Session, where: Sequence[tuple[Fit, int]]) -> TorqueEffect:
    fit, n = where[0]
    kernels = fit.rungs[n].kernels
    gains = [fit.gains[n] for fit, n in where]
    width = fit.rungs[n].width * len(where)
    return TorqueEffect(
        name=fit.rungs[n].effect,
        title=kernels.TITLE,
        limbs=tuple(fit.joint.number for fit, _ in where),
        parameters=tuple(p for fit, n in where for p in _parameters(session, fit, n)),
        p_value=float(chi2.sf(sum(gains), width)),
        gain_chi2=float(sum(gains)),
        gain_by_limb={str(fit.joint.number): float(fit.gains[n]) for fit, n in where},
        share_of_excess=float(max(1.0 - (1.0 - fit.bought[n]) ** 2 for fit, n in where)),
        indistinguishable_from=tuple(sorted({name for fit, n in where for name in fit.alike[n]})),
        heldout_gain=tuple(float(fit.bought[n]) for fit, n in where),
    )


def _parameters(session: Session, fit: Fit, n: int) -> list[EffectParameter]:
    """Return an effect's coefficients and constants on a joint, in the units of files."""
    rung, joint = fit.rungs[n], fit.joint
    at = joint.X.shape[1] + sum(other.width for other in fit.rungs[:n])
    slides = session.rigid.dynamics.joint_units[joint.number - 1] == "mm"
    found = []
    for c, (name, unit, factor, _) in enumerate(rung.kernels.COEFFICIENTS):
        unit, factor = in_files(rung.kernels, name, unit, factor, joint.unit, slides)
        value, std = fit.coefficients[at + c] / factor, fit.std[at + c] / factor
        found.append(EffectParameter(name=name, limb=joint.number, value=float(value), std=float(std), unit=unit))
    for (name, unit, factor, _), constant in zip(rung.kernels.CONSTANTS, rung.constants, strict=True):
        if slides and name in rung.kernels.OF_JOINT:
            unit, factor = of_sliding(unit)
        value = float(constant / factor)
        found.append(EffectParameter(name=name, limb=joint.number, value=value, std=None, unit=unit))
    return found


def in_files(kernels: Kernels, name: str, unit: str, factor: float, read: str, slides: bool) -> tuple[str, float]:
    """Return unit in files and factor to the unit inside of a coefficient, of a joint whose readings are in a unit.

    Where what a drive gives per torque is unknown, its readings' unit stands for Nm.
    """
    if slides and name in kernels.OF_JOINT:
        unit, factor = of_sliding(unit)
    if read in ("Nm", "N"):
        return unit, factor
    if name in kernels.OF_JOINT:
        force = "N" if slides else "Nm"
        return unit.replace(force, read, 1), factor / (1.0 if slides else INSIDE["Nm"])
    return (f"{unit} {read}/Nm", factor / INSIDE["Nm"]) if unit != "1" else (unit, factor)


def _ladder(fit: Fit, left: Rest | None) -> LadderOf:
    rungs = [
        RungOf(limb=fit.joint.number, name=rung.effect, buys=float(b), gain_chi2=float(g))
        for rung, b, g in zip(fit.rungs, fit.bought, fit.gains, strict=True)
    ]
    stops = f"no further effect buys {100 * BUYS:g} % of the held-out rms"
    return LadderOf(
        limb=fit.joint.number,
        unit=fit.joint.unit,
        rungs=tuple(sorted(rungs, key=lambda r: -r.buys)),
        stops=stops if left is None else f"{stops}; {left.text}",
    )


def _location(effects: Sequence[TorqueEffect], rests: Sequence[Rest]) -> MotionLocation:
    limbs = sorted({r.joint for r in rests} or {i for e in effects for i in e.limbs})
    texts = [r.text for r in rests] or [f"{e.title}: joint {', '.join(map(str, e.limbs))}" for e in effects]
    channels = dict.fromkeys(r.channel for r in sorted(rests, key=lambda r: -r.share) if r.channel)
    return MotionLocation(channels=tuple(channels), limbs=tuple(limbs), region=None, text="; ".join(texts) or "nowhere")


def _summary(effects: Sequence[TorqueEffect], rests: Sequence[Rest], session: Session, fits: Sequence[Fit]) -> str:
    still = [j.number for j in session.joints if j.number not in {fit.joint.number for fit in fits}]
    named = [f"{e.title} (joint {', '.join(map(str, e.limbs))})" for e in effects]
    parts = [f"Beside the rigid machine the drives overcome {'; '.join(named)}." if named else ""]
    if rests:
        parts.append(f"Not explained: {'; '.join(r.text for r in rests)}.")
    if not named and not rests:
        parts.append("The rigid machine explains what the drives give.")
    if still:
        parts.append(f"Joint {', '.join(map(str, still))} moves too little to say anything.")
    return " ".join(p for p in parts if p)


def _not_tested(fits: Sequence[Fit]) -> tuple[Missing, ...]:
    """Return the effects that no joint's samples can tell, and what they would need."""
    tested = {rung.effect for fit in fits for rung in fit.joint.candidates}
    found = []
    for name in drive_effect_names():
        if name not in tested:
            needs = [words for state, words in NEEDS.items() if state in load_effect(name).STATE]
            found.append(Missing(name=name, missing="; ".join(needs) or "longer motion"))
    return tuple(found)

"""Judgement of diagnoses of concealed cases, and the table of it.

Public: `examine` (draw a case, diagnose it, grade it: one entry of the report), `grade` (a DIAGNOSIS.json against the
truth of a case), `oracle` (what an ideal fit that knows the effects reaches), `table` and `failures` (the report).
"""

from __future__ import annotations

import collections
import dataclasses
import time
import traceback
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from rich.table import Table

from deltacal_gen.diagnosis.diagnosis import diagnose
from deltacal_gen.errors import DeltacalError
from deltacal_gen.estimation.fit import fit, rough
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.prior import BROAD
from deltacal_gen.estimation.problem import pose_problem
from deltacal_gen.estimation.residuals import rms
from deltacal_gen.estimation.solvers import Prior
from deltacal_gen.files.robot import kept_robot
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.machine.values import Recording
from deltacal_gen.physics.terms import Term, coefficients, kept_term
from deltacal_gen.results.parts import MachineState
from deltacal_gen.use.prediction import predict
from tests.benchmarks.concealed_cases import ORDINARY, Array, Case, Judge, generate, readings, source_errors

CONVENTION = {"joint_axis_runout", "instrument_offset"}  # parameters that are equal up to the geometry
WIDE = 3.0  # times the ideal fit's: a standard deviation may not hide an error behind more
RULED_OUT = 150.0  # of chi2 without noise: what the data rule out is no rival that they cannot tell apart
VERDICT = {"null": "adequate", "outside": "unexplained"}


# ---------------------------------------------------------------------------------------------------- what is ideal


@dataclass(frozen=True)
class Oracle:
    """An ideal fit: error of its prediction [mm] with the true effects and without, and its standard deviations."""

    prediction: float
    geometry: float
    std: tuple[Array, ...]


def oracle(case: Case) -> Oracle:
    """Return what geometry and the true effects, fitted to the noisy recording, reach on the fresh readings."""
    names = source_errors(case.robot, case.recording)
    n = len(names)
    problem = pose_problem(case.robot, case.recording, names)
    problem = dataclasses.replace(problem, scale=BROAD * problem.scale)
    first = rough(problem, must_converge=False)
    plain = fit(problem, Prior(), errors=first.errors, instrument=first.instrument)
    geometry = prediction_error(case, predict(_as_result(case, plain), case.fresh))
    if not case.terms:
        return Oracle(geometry, geometry, ())
    values = np.concatenate([t.values.ravel() for t in case.terms])
    joint = problem.with_terms(case.terms, 10 * np.abs(values))
    true = fit(joint, Prior(), errors=np.concatenate([plain.errors, values]), instrument=plain.instrument)
    std = np.sqrt(np.diag(true.covariance))[n : n + len(values)]
    ends = np.cumsum([t.n_coefficients for t in case.terms])[:-1]
    parts = tuple(s.reshape(t.values.shape) for s, t in zip(np.split(std, ends), case.terms, strict=True))
    return Oracle(prediction_error(case, predict(_as_result(case, true), case.fresh)), geometry, parts)


def prediction_error(case: Case, predicted: Recording) -> float:
    """Return the RMS error [mm] of a prediction of the fresh readings, rotations left out."""
    k = len(mechanism_of(case.robot).axes)
    return rms(readings(predicted)[:, :k] - readings(case.fresh)[:, :k])


def _as_result(case: Case, found: Fit) -> MachineState:
    errors, terms = found.problem.split(found.errors)
    names = [p.name for p in mechanism_of(case.robot).parameters]
    robot = dataclasses.replace(case.robot, errors=dict(zip(names, map(float, errors), strict=True)))
    recording = case.recording
    instrument = found.instrument.kept(recording.setup_names, recording.measurement.zero)
    return MachineState(robot=kept_robot(robot), physics=tuple(map(kept_term, terms)), instrument=instrument)


# -------------------------------------------------------------------------------------------------------- judgement


def _lawful(case: Case, result: Mapping[str, Any]) -> bool:
    """Tell whether foreign physics is told as a law that is borne out, at its limbs, and nothing named beside it."""
    law = next(iter(result.get("laws") or []), None)
    if case.kind != "outside" or law is None or result["effects"] or not law["borne_out"]:
        return False
    return {i for t in law["terms"] for i in t["limbs"]} == set(case.limbs)


def grade(case: Case, result: Mapping[str, Any], ideal: Oracle | None = None) -> dict[str, Any]:
    """Return how a DIAGNOSIS.json does on a case; `wrong` says in words what is wrong with it.

    Parameters
    ----------
    result : mapping
        DIAGNOSIS.json.
    ideal : Oracle, optional
        Whose standard deviations are the measure of those of the diagnosis.
    """
    named = {str(e["name"]): e for e in result["effects"]}
    location = result.get("location") or {}
    first = next(iter(location.get("channels") or []), {}).get("name")
    limbs = tuple(sorted(location.get("limbs") or ()))
    wrong: list[str] = []
    noise = result["noise"]
    out: dict[str, Any] = {
        "verdict": result["verdict"],
        "verdict_ok": result["verdict"] == VERDICT.get(case.kind, "missing_physics") or _lawful(case, result),
        "found": [_said(e) for e in result["effects"]],
        "chi2": result["final"]["chi2_per_dof"],
        "noise": [noise["sigma_mm"] / case.sigma, noise["source"]],
        "location": [first, list(limbs)],
        "rejected": [[r["name"], r.get("gain_chi2")] for r in result["rejected"][:4]],
        "wrong": wrong,
    }
    if not out["verdict_ok"]:
        wrong.append(f"verdict {out['verdict']}, chi2 {out['chi2']:.2f} ({noise['source']})")
    if case.kind == "outside":
        out["channel_ok"] = first in case.channels
        out["limbs_ok"] = limbs == case.limbs
        out["located"] = out["channel_ok"] or (bool(case.limbs) and out["limbs_ok"]) or _lawful(case, result)
        if not out["located"]:
            wrong.append(f"placed at {first} {limbs}, not {case.channels[0]} {case.limbs}")
        return out
    out["exact"] = set(named) == {t.effect for t in case.terms} and len(named) == len(result["effects"])
    if case.kind == "null":
        out["alarm"] = bool(named)
    if not out["exact"]:
        wrong.append(f"named {' + '.join(map(str, out['found'])) or 'nothing'}")
        return out
    if not case.terms:
        return out
    out["limbs_ok"] = all(tuple(named[t.effect]["limbs"]) == t.limbs for t in case.terms)
    if not out["limbs_ok"]:
        wrong.append(f"limbs {[named[t.effect]['limbs'] for t in case.terms]}")
    out["z"], out["wide"] = [], []
    for i, term in enumerate(case.terms):
        entry = named[term.effect]
        order = [p["value"] for p in entry["parameters"] if p["name"] == "order"]
        if term.effect == "transmission_eccentricity" and order != [term.constants[0]]:
            wrong.append(f"order {order}")
        elif term.effect not in CONVENTION:
            z, wide = _departures(term, entry, None if ideal is None else ideal.std[i], case.recording.joint_unit)
            out["z"] += z
            out["wide"] += wide
    out["ruled_out"] = _ruled_out(case, named)
    if any(abs(z) > 3 for z in out["z"]):
        wrong.append(f"z {[round(z, 1) for z in out['z']]}")
    if any(w > WIDE for w in out["wide"]):
        wrong.append(f"std {[round(w, 1) for w in out['wide']]} times the ideal")
    if out["ruled_out"]:
        wrong.append(f"ruled out {out['ruled_out']}")
    return out


def _said(entry: Mapping[str, Any]) -> list[Any]:
    constants = [p["value"] for p in entry["parameters"] if p.get("std") is None]
    gain = entry.get("gain_chi2")
    return [entry["name"], entry["limbs"], constants, gain and round(gain, 1), entry["indistinguishable_from"]]


def _departures(
    true: Term, entry: Mapping[str, Any], ideal: Array | None, joint_unit: str
) -> tuple[list[float], list[float]]:
    """Return (value - truth) / std, and std / the ideal fit's, of every coefficient that both have."""
    found = {(p["name"], p["limb"]): p for p in entry["parameters"]}
    z, wide = [], []
    for r, row in enumerate(true.values):
        for c, (name, _, factor) in enumerate(coefficients(true.kernels, joint_unit)):
            p = found.get((name, true.limbs[r] if true.limbs else None))
            if p is None or not p["std"]:
                continue
            z.append(float((p["value"] - row[c] / factor) / p["std"]))
            if ideal is not None:
                wide.append(float(p["std"] * factor / max(ideal[r, c], 1e-300)))
    return z, wide


def _ruled_out(case: Case, named: Mapping[str, Any]) -> list[Any]:
    """Return the members of `indistinguishable_from` that the data do tell apart, with the loss in chi2."""
    judge: Judge | None = None
    out: list[Any] = []
    for i, term in enumerate(case.terms):
        for rival in named[term.effect]["indistinguishable_from"]:
            judge = judge or Judge(case.robot, case.exact, case.errors, case.sigma, case.turn_sigma)
            if judge.problem.body.missing(rival):
                continue  # what was not recorded is ruled out by nothing
            if (loss := judge.loss(case.exact, case.terms, i, rival)) > RULED_OUT:
                out.append([rival, round(loss)])
    return out


Job = tuple[str, tuple[str, ...], tuple[int, ...], str]  # kind, names, seed, machine: see `concealed_cases.plan`


def examine(
    job: Job, draw: Callable[..., Case] = generate, also: Mapping[str, Callable[[Case, Any], Any]] | None = None
) -> dict[str, Any]:
    """Return how the diagnosis does on the case of a job; `also` are further figures of a case and its answer."""
    kind, names, seed, machine = job
    out: dict[str, Any] = {"kind": kind, "names": list(names), "seed": list(seed), "machine": machine, "wrong": []}
    try:
        case = draw(*job)
    except RuntimeError as e:
        return out | {"skipped": str(e)}
    truth = [[t.effect, list(t.limbs), list(t.constants)] for t in case.terms]
    out |= {"names": list(case.names), "truth": truth, "excess": case.excess, "traits": case.traits}
    begin, processor = time.perf_counter(), time.process_time()
    try:
        result = diagnose(case.robot, case.recording).answer()
        out |= {"seconds": time.perf_counter() - begin, "processor": time.process_time() - processor}
        error = prediction_error(case, predict(result, case.fresh))
        out |= {name: measure(case, result) for name, measure in (also or {}).items()}
        try:
            ideal = oracle(case)
        except DeltacalError as e:
            out["no_oracle"], ideal = str(e), None
        out |= grade(case, result, ideal)
        if ideal is not None:
            out["to_geometry"] = error / ideal.geometry
            out["to_oracle"] = None if case.kind == "outside" else error / ideal.prediction
    except Exception:
        out["wrong"] = [*out["wrong"], f"exception: {' '.join(traceback.format_exc().splitlines()[-3:])}"]
        out.setdefault("seconds", time.perf_counter() - begin)
    return out


# ------------------------------------------------------------------------------------------------------------ report


def _part(found: Sequence[dict[str, Any]], key: str) -> str:
    values = [f[key] for f in found if f.get(key) is not None]
    return f"{sum(map(bool, values))}/{len(values)}" if values else ""


def _line(label: str, found: Sequence[dict[str, Any]]) -> list[str]:
    z = np.array([v for f in found for v in f.get("z", ())])
    wide = np.array([v for f in found for v in f.get("wide", ())])
    ratio = [f["to_oracle"] for f in found if f.get("to_oracle")]
    spread = float(np.diff(np.quantile(z, [0.1587, 0.8413]))[0] / 2) if len(z) > 4 else None
    return [
        label,
        str(len(found)),
        _part(found, "exact"),
        _part(found, "limbs_ok"),
        _part(found, "alarm"),
        _part(found, "verdict_ok"),
        f"{int((np.abs(z) < 3).sum())}/{len(z)}" if len(z) else "",
        "" if spread is None else f"{spread:.2f}",
        f"{wide.max():.1f}" if len(wide) else "",
        str(sum(len(f.get("ruled_out") or ()) for f in found)) if len(z) else "",
        f"{np.median(ratio):.2f}" if ratio else "",
        _part(found, "located"),
        f"{np.median([f['seconds'] for f in found]):.1f}",
    ]


def table(found: Sequence[dict[str, Any]]) -> Table:
    """Return the table of graded cases, by kind and by effect."""
    out = Table("", title="what was concealed, and what was found")
    heads = "n,exact,limbs,alarms,verdict,< 3 std,spread,widest,ruled out,/oracle,located,s"
    for head in heads.split(","):
        out.add_column(head, justify="right")
    for kind in ORDINARY:
        if of_kind := [f for f in found if f["kind"] == kind]:
            out.add_row(*_line(kind, of_kind), style="bold")
            by_name: dict[str, list[dict[str, Any]]] = collections.defaultdict(list)
            for f in of_kind:
                for name in f["names"]:
                    by_name[name].append(f)
            for name in sorted(by_name):
                out.add_row(*_line(f"  {name}", by_name[name]))
    return out


def failures(found: Sequence[dict[str, Any]]) -> Iterator[str]:
    """Yield a line for each case that went wrong: what was true, what was found, and by what gains."""
    for f in sorted(found, key=lambda f: (f["kind"], f["names"])):
        if f["wrong"]:
            yield (
                f"{f['kind']} {f['seed']} true {f.get('truth') or f['names']} excess {f.get('excess', 0):.1f} "
                f"{' '.join(f.get('traits', ()))}: {'; '.join(f['wrong'])}; found {f.get('found')} chi2 "
                f"{f.get('chi2', 0):.2f} noise {f.get('noise')} at {f.get('location')}; next {f.get('rejected')}"
            )

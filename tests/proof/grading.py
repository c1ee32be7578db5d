"""Runs a tool on the files of a case, out of reach of the truth, and judges its answer.

``TOOL diagnose robot.toml recording.csv -o diagnosis.json`` and ``TOOL predict diagnosis.json fresh.csv -o
predicted.csv`` run in a scratch folder that holds the files of the case and nothing else.
"""

from __future__ import annotations

import csv
import json
import os
import shlex
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from deltacal_gen.estimation.residuals import rms
from tests.benchmarks.concealed_cases import readings
from tests.benchmarks.concealed_grading import CONVENTION, grade
from tests.proof.files import Concealed

Array = np.ndarray
TOOL = f"{shlex.quote(sys.executable)} -m deltacal_gen.app.cli"
COLUMNS = {
    "position": ("x_mm", "y_mm", "z_mm"),
    "pose": ("x_mm", "y_mm", "z_mm"),
    "distance": ("distance_mm",),
    "gauge": ("gauge_mm",),
}


def answer(case: Path, output: Path, tool: str = TOOL, limit_s: float = 300.0) -> dict[str, Any]:
    """Run a tool on a case's folder; return how long it took and, where it failed, what it said.

    `output` receives ``diagnosis.json`` and ``predicted.csv``. Words of `tool` that name a file are made absolute.
    """
    command = [os.path.abspath(w) if os.path.exists(w) else w for w in shlex.split(tool)]
    output.mkdir(parents=True, exist_ok=True)
    out: dict[str, Any] = {}
    with tempfile.TemporaryDirectory(prefix="proof_") as scratch:
        for file in case.iterdir():
            shutil.copy(file, scratch)
        steps = (
            ("diagnose", ["robot.toml", "recording.csv", "-o", "diagnosis.json"], "diagnosis.json"),
            ("predict", ["diagnosis.json", "fresh.csv", "-o", "predicted.csv"], "predicted.csv"),
        )
        for step, arguments, wanted in steps:
            (output / wanted).unlink(missing_ok=True)
            begin = time.perf_counter()
            try:
                done = subprocess.run(
                    [*command, step, *arguments], cwd=scratch, capture_output=True, text=True, timeout=limit_s
                )
            except subprocess.TimeoutExpired:
                return out | {"failed": f"{step}: not done in {limit_s:.0f} s"}
            out[f"{step}_s"] = time.perf_counter() - begin
            if done.returncode != 0 or not (Path(scratch) / wanted).exists():
                last = (done.stderr or done.stdout).strip().splitlines()[-1:] or ["no word"]
                return out | {"failed": f"{step}: exit {done.returncode}: {last[0][:200]}"}
            shutil.copy(Path(scratch) / wanted, output / wanted)
    return out


def judge(concealed: Concealed, output: Path, ran: Mapping[str, Any]) -> dict[str, Any]:
    """Return one entry of the table: how the answer in `output` compares with the truth.

    Beside what `concealed_grading.grade` says: `right` (verdict, names, orders and limbs; of physics outside the
    vocabulary, unexplained and in the right place), `relative` (errors of parameters over the largest true one of their
    effect), `to_oracle` and `gain` (prediction error of fresh readings over an ideal fit's, and geometry's over it).
    """
    case, ideal = concealed.case, concealed.ideal
    out: dict[str, Any] = {
        "name": concealed.name,
        "engine": concealed.engine,
        "kind": case.kind,
        "names": list(case.names),
        "excess": case.excess,
        "right": False,
        "wrong": [],
        "seconds": ran.get("diagnose_s"),
    }
    if "failed" in ran:
        return out | {"wrong": [ran["failed"]], "verdict_ok": False, "exact": False, "alarm": case.kind == "null"}
    try:
        found = json.loads((output / "diagnosis.json").read_text(encoding="utf-8"))
        out |= grade(case, found, ideal)
        if case.terms and out["exact"]:
            out |= _values(case, found)
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        said = f"not a diagnosis in its form: {type(error).__name__} {error}"
        return out | {"wrong": [said], "verdict_ok": False, "exact": False, "alarm": case.kind == "null"}
    if out.get("missing"):
        out["wrong"].append(f"no value of {', '.join(out['missing'])}")
    placed = out["located"] if case.kind == "outside" else out["exact"] and out.get("limbs_ok", True)
    out["right"] = bool(out["verdict_ok"] and placed and out.get("order_ok", True))
    try:
        predicted = _predicted(output / "predicted.csv", case.fresh.kind)
        error = rms(predicted - readings(case.fresh)[:, :3])
    except (KeyError, ValueError) as fault:
        out["wrong"].append(f"no prediction of the fresh readings: {fault}")
        return out
    if not np.isfinite(error):
        out["wrong"].append("blank predictions")
    elif ideal is not None and error > 0:
        out["gain"] = ideal.geometry / error
        if case.kind != "outside":
            out["to_oracle"] = error / ideal.prediction
    return out


def _values(case: Any, found: Mapping[str, Any]) -> dict[str, Any]:
    """Return relative errors of the parameters, those that the answer lacks, and whether orders are right."""
    relative: list[float] = []
    missing: list[str] = []
    order_ok = True
    for term in case.terms:
        entry = next(e for e in found["effects"] if e["name"] == term.effect)
        said = {(p["name"], p["limb"]): p for p in entry["parameters"]}
        if term.effect == "transmission_eccentricity":
            order_ok = [p["value"] for p in entry["parameters"] if p["name"] == "order"] == [term.constants[0]]
        factors = np.array([f for _, _, f, _ in term.kernels.COEFFICIENTS])
        largest = np.abs(term.values / factors).max()
        for r, row in enumerate(term.values):
            limb = term.limbs[r] if term.limbs else None
            for (name, _, factor, _), value in zip(term.kernels.COEFFICIENTS, row, strict=True):
                p = said.get((name, limb))
                if p is None or p["value"] is None or not p.get("std"):
                    if limb is None or limb in entry["limbs"]:
                        missing.append(f"{term.effect}.{name}" + (f" of limb {limb}" if limb else ""))
                elif term.effect not in CONVENTION:
                    relative.append(float(abs(p["value"] - value / factor) / largest))
    return {"relative": relative, "missing": missing, "order_ok": order_ok}


def _predicted(path: Path, kind: str) -> Array:
    with path.open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    return np.array([[float(row[name] or "nan") for name in COLUMNS[kind]] for row in rows])

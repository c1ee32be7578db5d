"""What the papers print, decided by the derivation: the committed verdicts, and that a wrong print is found."""

from __future__ import annotations

import json
import random
from pathlib import Path

import numpy as np
import pytest

from deltacal_gen.errors import InputError
from deltacal_gen.machine.registry import mechanism_of
from derive.review import ledger
from tests.claims import independent_mei as own
from tests.support.ledger import ENTRY, write

sp = pytest.importorskip("sympy", reason="the derivation needs the dependency group 'derive'")

from derive.mechanisms import delta  # noqa: E402
from derive.papers import bai, deltas, exact, letters, mei, savoure, statements, verdicts  # noqa: E402
from derive.review import checks, geometry  # noqa: E402
from derive.review.subjects import example, subject  # noqa: E402


def test_every_paper_of_the_ledger_has_statements() -> None:
    assert ledger.paper_names() == verdicts.STATED


@pytest.mark.parametrize("paper", verdicts.STATED)
def test_committed_verdicts_are_those_of_the_derivation(paper: str) -> None:
    found = {name: verdict.entry() for name, verdict in verdicts.decided(paper).items()}
    assert found == ledger.derived()[paper], f"Run '{verdicts.COMMAND}' and commit."


@pytest.mark.parametrize("paper", verdicts.STATED)
def test_every_verdict_decides_a_claim_of_its_number(paper: str) -> None:
    for verdict in ledger.derived()[paper].values():
        claims = [c for c in ledger.load_paper(paper).claims if c.decided and verdict["printed"] in c.printed]
        assert [c.where for c in claims] == [verdict["where"]], verdict


# ------------------------------------------------------------------------------------------- what is wrong is found


def test_a_wrong_sign_is_read_back_in_the_papers_letters() -> None:
    """The corrected form is the derivation's, found block by block; no typed text stands in for it."""
    mean, _ = bai.rods()
    printed = bai.LETTERS.terms({"lhat.w0": sp.cos(deltas.theta), "lhat.u1": 1})
    found = statements.Rows(
        "eq. (6)", "x", "x", bai.LETTERS, printed, [bai.row(mean.unknowns, "beta0"), bai.row(mean.unknowns, "L")]
    )
    assert found.verdict().correct == "x = [-lhat.w0 cos(theta), lhat.u1]"
    assert found.verdict().status == "contradicted"


def test_what_no_letter_names_is_written_out() -> None:
    assert bai.LETTERS.read(sp.Matrix([[deltas.lhat[0] + 2 * deltas.lhat[1]]])) == "[lhat_x + 2*lhat_y]"


def test_a_formula_without_a_form_that_holds_is_refused() -> None:
    machine = deltas.rational_machine(1)
    wrong = statements.Formula("eq. (9)", "C_e", "C_e = A_ee^-1", bai.derived_inverse, bai.C_e, [machine])
    with pytest.raises(ValueError, match="neither 'C_e = A_ee\\^-1' nor its correction"):
        wrong.verdict()


def test_a_machine_of_a_prime_field_closes() -> None:
    field = exact.Field(exact.PRIMES[0])
    rng = random.Random(3)
    lengths = deltas.lengths_of(field, rng)
    (place,) = deltas.places(field, rng, lengths, 1)
    machine = deltas.closed_machine(field, lengths, place)
    assert machine is not None
    for limb in machine.limbs:  # P = (b - a) u0 + L u1 + l lhat, and both directions are of length one
        cos, sin, C, S = (limb[exact.turned(f(s))] for s in (deltas.theta, deltas.phi) for f in (sp.cos, sp.sin))
        reach = [cos * C, cos * S, sin]
        for k, (direction, at) in enumerate(zip((C, S, field(0)), place, strict=True)):
            e = lengths[deltas.b] - lengths[deltas.a]
            assert e * direction + lengths[deltas.L] * reach[k] + lengths[deltas.l] * limb[deltas.lhat[k]] == at
        assert exact.dot([limb[s] for s in deltas.lhat], [limb[s] for s in deltas.lhat]) == field(1)


def test_a_field_needs_its_roots() -> None:
    with pytest.raises(ValueError, match="has no square root"):
        exact.Field(2**61 - 1)


def test_ranks_over_both_primes_are_those_of_floating_point() -> None:
    """Against an independent implementation: twelve columns of lengths have rank 9 there, too."""
    field = exact.Field(exact.PRIMES[1])
    assert field.rank(mei.length_rows(field, 14)) == 9
    rng = np.random.default_rng(1)
    poses = np.column_stack([rng.uniform(-200, 200, 40), rng.uniform(-760, -640, 40)])
    assert np.linalg.matrix_rank(own.identification_matrix(poses, complete=True)) == 9


def test_one_limb_of_the_planar_machine_is_its_closure() -> None:
    """The third line of (65) is what is printed only up to two entries."""
    J_kC = savoure.in_the_plane()[1]
    assert list(J_kC.row(2))[:2] == [deltas.l, savoure.v]


# ------------------------------------------------------------------------------------- two descriptions of one machine


@pytest.mark.parametrize("move", sorted(delta.MACHINE.keywords["moves"].keys() - {"tip_v", "tip_w"}))
def test_both_descriptions_of_the_delta_move_alike(move: str) -> None:
    """Parts that effects move change the closures of 42 and of 51 errors alike, whatever way a limb points."""
    found = []
    for name, rods in (("delta", ("d", "d")), ("complete_delta", ("d1", "d2"))):
        mechanism = exact.limbs(name)
        symbols = {e.name: e.symbol for e in mechanism.errors}
        rates = letters.differentials(mechanism, tuple(dict.fromkeys(rods)))
        moved = [sum(much * rod[symbols[e]] for e, much in mechanism.moves[move].items()) for rod in rates]
        along = [dict(zip(letters.vector(rod), letters.vector("d"), strict=True)) for rod in rods]
        found.append([sp.sympify(e).xreplace(known) for e, known in zip(moved, along, strict=True)])
    rng = random.Random(5)
    for _ in range(2):
        at = {s: rng.uniform(0.3, 2.0) for e in (*found[0], *found[1]) for s in sorted(e.free_symbols, key=str)}
        one, other = ([float(e.subs(at)) for e in side] for side in found)
        assert one == pytest.approx(other, abs=1e-12)
        assert np.abs(one).max() > 1e-3


@pytest.mark.parametrize("name", ["planar_parallelogram", "simplified_parallelogram"])
def test_what_newton_starts_from_closes(name: str) -> None:
    """Where a file gives the forward position in closed form, the closures vanish there."""
    mechanism = exact.limbs(name)
    assert mechanism.seeds is not None
    rng = random.Random(7)
    lengths = {str(k.quantity.symbol): k.quantity.symbol for k in mechanism.geometry}
    known = {s: 900.0 if n[0] == "l" else 0.0 if n.endswith("y") else 120.0 for n, s in lengths.items()}
    known |= {e.symbol: rng.uniform(-1.0, 1.0) * e.typical for e in mechanism.common}
    known |= {t.symbol: 5.0 for t in mechanism.tool} | {mechanism.joint.symbol: 0.3}

    def go_on() -> None:
        """Evaluate the steps that can be."""
        known.update({s: float(e.subs(known)) for s, e in mechanism.steps if e.free_symbols <= known.keys()})

    go_on(), go_on()  # twice: steps of steps
    platform = {s: seed for s, seed in mechanism.seeds.items() if s != mechanism.joint.symbol}
    known |= {s: float(sp.sympify(seed).subs(known)) for s, seed in platform.items()}
    go_on(), go_on(), go_on()
    for closure in mechanism.loop_closure:
        assert float(closure.subs(known)) == pytest.approx(0.0, abs=1e-6)


# ---------------------------------------------------------------------------------------------------- the rank tables


@pytest.mark.parametrize(
    ("model", "rank"),
    [("delta/36", 32), ("delta/51", 42), ("planar_parallelogram/9", 6), ("diamond/12", 9), ("robotennis/15", 15)],
)
def test_the_rank_tables_hold_the_papers_own_case(model: str, rank: int) -> None:
    """What the papers read stands in the tables by name, with the rank that the prime fields give."""
    one = subject(model)
    robot = example(one.mechanism)
    assert robot is not None
    at = checks.trials(robot, 24)
    case = verdicts.case_of(one.mechanism)
    found = [r for r in checks.ranks(robot, at, mechanism_of(robot).models[model]) if r.kind == case]
    assert found[0].rank == rank


def test_what_is_unseen_is_said_in_geometry() -> None:
    assert geometry.sentence("complete_delta", ["bx_21", "by_21", "ax_21"]).startswith("Both ends of a rod")
    assert geometry.sentence("complete_delta", ["az_31", "az_32", "betax_3", "betay_3"]).startswith("The arm turned")
    assert geometry.sentence("complete_delta", ["bx_11", "ax_21"]) == ""  # of two limbs: no such sentence
    assert geometry.sentence("planar_parallelogram", ["a2y", "b2y"], limbs=False).endswith("parallel to itself.")


# ----------------------------------------------------------------------------------------------- the ledger reads them

VERDICT = {
    "where": "eq. (3)",
    "name": "sum",
    "printed": "2 + 2 = 5",
    "correct": "2 + 2 = 4",
    "status": "contradicted",
    "decided": "counted by SymPy",
}
BY_DERIVATION = {key: value for key, value in ENTRY.items() if key not in ("printed", "correct", "status")}


def shelf(folder: Path, **changes: str) -> Path:
    (folder / "derived.json").write_text(json.dumps({"euclid": {"sum": VERDICT}}))
    return write(folder, {**BY_DERIVATION, "derived": "sum", **changes})


def test_a_claim_takes_its_verdict_from_the_derivation(tmp_path: Path) -> None:
    (claim,) = ledger.read_paper(shelf(tmp_path)).claims
    assert (claim.printed, claim.correct, claim.status) == ("2 + 2 = 5", "2 + 2 = 4", "contradicted")
    assert claim.decided == "counted by SymPy"


def test_nothing_is_typed_beside_the_derivation(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="'status' is typed beside 'derived'"):
        ledger.read_paper(shelf(tmp_path, status="proved"))
    with pytest.raises(InputError, match="no verdict \\['product'\\] of the derivation; known: sum") as caught:
        ledger.read_paper(shelf(tmp_path, derived="product"))
    assert caught.value.line == 3

"""Reports of a derivation: complete, equal to what is lowered, the same bytes every time, and readable in a browser."""

from __future__ import annotations

import json
import math
import os
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest
import sympy as sp
from sympy.core.function import AppliedUndef

import deltacal_gen as dc
from deltacal_gen.app.commands.model_side import trial
from deltacal_gen.errors import InputError, UsageError
from deltacal_gen.instrument.kinds import kind_of
from deltacal_gen.machine.registry import load_mechanism, mechanism_names, mechanism_of
from deltacal_gen.physics.terms import drive_effect_names, effect_names
from derive import registry
from derive.effects import state
from derive.language import vocabulary
from derive.language.effects import Effect, EffectQuantity, Reference
from derive.language.memory import Lag
from derive.review import account, checks, ledger, method, notation, reports, typeset, unseen
from derive.review.directions import links_of, null_spaces_of_chain
from derive.review.machine import Written
from derive.review.sources import Sources, kernels
from derive.review.subjects import applies, example, subject, subjects
from derive.review.written import exactly
from derive.spec import ChainMechanism, LimbMechanism
from derive.steps import Derivation
from tests.support.expressions import numbers, value

ROOT = Path(__file__).resolve().parents[2]
MACHINES = [m.name for m in registry.mechanisms() if isinstance(m, LimbMechanism)]


@pytest.fixture(scope="module")
def written() -> dict[str, Written]:
    return {name: Written(name) for name in MACHINES}


def limbs(name: str) -> LimbMechanism:
    found = registry.mechanism(name)
    assert isinstance(found, LimbMechanism)
    return found


def chain() -> ChainMechanism:
    found = registry.mechanism("serial")
    assert isinstance(found, ChainMechanism)
    return found


# ---------------------------------------------------------------------------------------------- what is shown is so


@pytest.mark.parametrize("name", MACHINES)
def test_every_step_is_shown_as_it_is_lowered(name: str, written: dict[str, Written]) -> None:
    machine, exact = written[name], limbs(name)
    assert isinstance(exact.steps, Derivation) or not exact.steps, "steps without lines cannot be led to"
    lowered, names = dict(exact.steps), list(machine.steps.written)
    for n, step in enumerate(names):
        symbols = machine.steps.written[step]
        if not isinstance(symbols, sp.MatrixBase):
            continue
        form = machine.reader(names[:n]).read(machine.value(step))
        at = numbers(set().union(*(e.free_symbols for e in form.explicit())) | set(symbols))
        at |= dict.fromkeys((s for s in at if s in machine.defined and s not in lowered), 0.0)  # zero in the plane
        for s, shown in zip(symbols, form.explicit(), strict=True):
            own = lowered.get(s, sp.Integer(0))
            assert value(shown, at) == pytest.approx(value(own, at), abs=1e-12), (step, s)


@pytest.mark.parametrize("name", ["delta", "diamond", "planar_parallelogram", "robotennis"])
def test_differentials_are_those_of_the_steps(name: str, written: dict[str, Written]) -> None:
    machine = written[name]
    for n, step in enumerate(names := list(machine.steps.written)):
        definition = machine.value(step)
        machine.step(step, names[:n])  # finds out what nothing changes
        if not isinstance(definition, sp.MatrixBase):
            continue
        form = machine.reader(names[:n]).read(definition)
        change = machine.change(form, names[:n])
        shown = sp.zeros(*definition.shape) if change is None else change.explicit()
        at = numbers(set().union(*(e.free_symbols for e in (*shown, *definition))) | set(machine.varied.values()))
        moving = {s: d for s, d in machine.varied.items() if str(s).rpartition("_")[0] not in machine.fixed}
        rotations = {sp.Symbol(f"d {f}", real=True): f for f in definition.atoms(AppliedUndef)}
        for d, f in rotations.items():
            turned = exactly(f)
            at[d] = sum(
                value(sp.diff(turned, s), at) * at.get(moving[s], 0.3) for s in turned.free_symbols & set(moving)
            )
        for e, formula in list(zip(definition, shown, strict=True))[::4]:  # of a matrix the diagonal
            whole = exactly(e)
            known = {s: at.setdefault(s, 0.3) for s in whole.free_symbols}
            slope = sum(value(sp.diff(whole, s), known) * at.setdefault(moving[s], 0.3) for s in known if s in moving)
            assert value(formula, at) == pytest.approx(slope, abs=1e-9), (step, formula)


@pytest.mark.parametrize("name", ["diamond", "robotennis", "planar_parallelogram", "simplified_parallelogram"])
def test_null_spaces_in_closed_form_are_unseen_by_readings(name: str) -> None:
    exact = limbs(name)
    robot = example(name)
    assert robot is not None
    mechanism, poses = mechanism_of(robot), checks.spread(robot, 40)
    found = unseen.equations(exact, {key: v.tolist() for key, v in robot.geometry.items()})
    assert found is not None
    errors, motions, rows = found
    basis = unseen.NullSpace(errors, motions, rows).of(errors, motions, {})
    every = [p.name for p in mechanism.parameters]
    H = checks.identification(robot, [poses], every, kind_of("position"))
    s = np.linalg.svd(H * mechanism.typical, compute_uv=False)
    assert len(basis) == len(every) - int((s > 1e-9 * s[0]).sum())
    geometry = {
        sp.Symbol(str(g.quantity.symbol), positive=True): float(robot.geometry[g.key][0]) for g in exact.geometry
    }
    for vector in basis:
        v = np.array([float(sp.N(vector.get(n, sp.Integer(0)).xreplace(geometry))) for n in every])
        assert np.abs(H @ v).max() < 1e-9 * np.abs(H).max() * np.abs(v).max()


@pytest.mark.parametrize(
    ("motions", "kind", "points", "frame"),
    [
        ("frame of the robot", "position", 1, "robot"),
        ("unknown frame, one point", "position", 1, "unknown"),
        ("unknown frame, several points", "position", 3, "unknown"),
        ("unknown frame and body", "pose", 1, "unknown"),
    ],
)
def test_twists_that_links_hand_on_are_all_that_readings_of_a_chain_miss(
    motions: str, kind: str, points: int, frame: str
) -> None:
    robot = example("serial")
    assert robot is not None
    mechanism, at = mechanism_of(robot), checks.trials(robot, 60)
    ((model, names),) = mechanism.models.items()
    found = null_spaces_of_chain(chain(), links_of(robot), list(robot.tool), mechanism.models)
    assert found is not None
    basis = found[model][motions]
    H = checks.identification(robot, at.sets[:points], list(names), kind_of(kind), frame)
    typical = mechanism.typical[[mechanism.index[n] for n in names]]
    s = np.linalg.svd(H * typical, compute_uv=False)
    assert len(basis) == len(names) - int((s > 1e-9 * s[0]).sum())
    numbers = {f"{key}_{k + 1}": value for key in ("a", "d") for k, value in enumerate(robot.geometry[key])}
    numbers |= {f"tool_{axis}": value for axis, value in zip("xyz", robot.tool, strict=True)}
    for vector in basis:
        put = {n: e.subs({s: numbers[s.name] for s in e.free_symbols}) for n, e in vector.items()}
        v = np.array([float(put.get(n, 0)) for n in names])
        assert np.abs(H @ v).max() < 1e-9 * np.abs(H).max() * np.abs(v).max(), vector


def test_the_account_of_a_chain_names_every_parameter() -> None:
    robot = example("serial")
    assert robot is not None
    found = account.mechanism("serial", robot)
    named = {row["name"] for table in ("errors", "common") for row in found["tables"][table]}
    assert named == {p.error for p in mechanism_of(robot).parameters}
    assert {link["convention"] for link in found["links"]} == {"standard", "modified"}
    assert found["statics"]


def test_a_coupled_chain_has_no_null_space_in_closed_form() -> None:
    robot = example("serial")
    assert robot is not None
    links = links_of(robot)
    links[2] |= {"kind": "coupled"}
    assert null_spaces_of_chain(chain(), links, list(robot.tool), mechanism_of(robot).models) is None


def test_effects_that_read_loads_need_weights(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("joint_compliance", "payload_deflection"):
        assert applies(name, "planar_parallelogram") == applies(name, "serial") == []
    monkeypatch.setitem(vars(load_mechanism("planar_parallelogram")), "weighs", False)
    for name in ("joint_compliance", "payload_deflection"):
        assert applies(name, "planar_parallelogram") == ["weights"]


def test_a_root_of_another_kind_leaves_the_null_space_to_numbers() -> None:
    x, y = sp.symbols("x y")
    with pytest.raises(ValueError, match="square root"):
        unseen.NullSpace([x, y], [], [sp.sqrt(2) * x + sp.sqrt(3) * y])
    (vector,) = unseen.NullSpace([x, y], [], [sp.sqrt(3) * x - 3 * y]).of([x, y], [], {})
    assert sp.simplify(vector["x"] * sp.sqrt(3) - 3 * vector["y"]) == 0


def test_kernels_are_counted_as_they_stand_and_written_out(tmp_path: Path) -> None:
    text = "def constants(p):\n    a = p[0]\n    k[..., 0] = a * a\n\n\ndef _f(x, k, out):\n    b = k[0]\n"
    text += "    c = b + x\n    out[0] = c * c\n    out[1] = -c\n"
    (tmp_path / "k.py").write_text(text)
    first, second = kernels(Sources(tmp_path), "k.py")
    assert (first.outputs, first.operations, first.written_out) == (1, 1, 1)
    assert (second.outputs, second.operations, second.written_out) == (2, 3, 5 + 3)


# ------------------------------------------------------------------------------------------------------- typesetting


@pytest.mark.parametrize(
    ("text", "latex"),
    [
        ("alpha03", r"{\alpha}_{03}"),
        ("px", "{p}_{x}"),
        ("R1_11", r"{R}_{1,\,11}"),
        ("dl", r"\Delta l"),
        ("base_x", r"{\mathrm{base}}_{x}"),
    ],
)
def test_names_are_typeset(text: str, latex: str) -> None:
    assert typeset.name(text).latex == latex


def test_expressions_are_typeset_in_both_languages() -> None:
    x, y = sp.symbols("x y", real=True)
    shown = typeset.expression(-x / 2 + sp.sqrt(x**2 + 1) / (y - 1) ** 2 - 3 * sp.cos(x + y) ** 2)
    assert shown.latex.startswith(r"\frac{\sqrt{{x}^{2}+1}}{{\left(y-1\right)}^{2}}")
    tree = ElementTree.fromstring(shown.mathml)
    assert [e.tag for e in tree.iter()].count("mfrac") == 2
    assert "".join(tree.itertext()).replace("\u2062", "").endswith("−3cos2(x+y)")


SHOWN = {
    "Φ": "Phi",
    "Π": "Pi",
    "Θ": "Theta",
    "−": "-",
    "≤": "<=",
    "≥": ">=",
    "±": "+-",
    "×": "x",
    "⊤": "T",
    "′": "'",
    "·": ".",
    "∑": "sum",
    "Δ": "Delta",
}
SPELT = {"\N{GREEK SMALL LETTER FINAL SIGMA}": "sigma", "ε": "eps", "θ": "th"}


def letters(text: str) -> str:
    """Return a formula's signs as the ledger spells them, without what says where they stand."""
    # an index comes before an exponent
    text = re.sub(r"('|\^[A-Za-z0-9]+)(_[A-Za-z0-9]+(?:[,+][A-Za-z0-9]+)*)", r"\2\1", text)
    for shown, spelt in (SHOWN | SPELT | {s: n for n, s in typeset._GREEK.items() if s not in SPELT}).items():
        text = text.replace(shown, spelt)
    for spelt, short in (("epsilon", "eps"), ("theta", "th"), ("sqrt", ""), ("hat", ""), ("bar", ""), ("tilde", "")):
        text = text.replace(spelt, short)
    return re.sub(r"[\s_^/(){}.…~¯;,]", "", text)


@pytest.mark.parametrize("paper", ledger.paper_names())
def test_the_ledgers_formulas_keep_every_sign(paper: str) -> None:
    formulas = 0
    for claim in ledger.load_paper(paper).claims:
        for text in (claim.printed, claim.correct):
            parts = notation.read(text)
            for m in (p for p in parts if isinstance(p, typeset.Math)):
                formulas += 1
                ElementTree.fromstring(f"<math>{m.mathml}</math>")
                assert m.latex.count("{") - m.latex.count(r"\{") == m.latex.count("}") - m.latex.count(r"\}")
            shown = "".join(
                p if isinstance(p, str) else "".join(ElementTree.fromstring(p.mathml).itertext()) for p in parts
            )
            assert letters(shown) == letters(text.replace("1e-3", "10-3").replace("1e4", "104")), text
        if claim.where.startswith("eq."):
            assert "=" not in "".join(p for p in notation.read(claim.printed) if isinstance(p, str)), claim.printed
    assert formulas > 50


@pytest.mark.parametrize(
    ("text", "latex"),
    [
        ("dp_r = H_r^+ drho", [r"\text{d}{p}_{r}={H}_{r}^{+}\,\text{d}\rho"]),
        ("the same with de_i for deps_i", ["the same with ", r"\text{d}{e}_{i}", " for ", r"\text{d}{\epsilon}_{i}"]),
        ("identifiable if K >= 3, that is (8)", ["identifiable if ", r"K\ge 3", ", that is (8)"]),
        ("a / (2 b)", [r"\frac{a}{2\,b}"]),
        ("BC x delta x", [r"\mathrm{BC}\times \delta\,x"]),
        ("Q = [0 -1; 1 0]", None),
        ("no formula here", ["no formula here"]),
        ("x = )(", ["x", " = )("]),
    ],
)
def test_the_ledgers_notation_is_read(text: str, latex: list[str] | None) -> None:
    parts = [p if isinstance(p, str) else p.latex for p in notation.read(text)]
    if latex is None:
        assert r"\begin{matrix}" in parts[0]
        assert parts[0].count("&") == 2
    else:
        assert parts == latex


def formulas(data: Any) -> Iterator[typeset.Math]:
    if isinstance(data, typeset.Math):
        yield data
    elif isinstance(data, dict | list):
        for part in data.values() if isinstance(data, dict) else data:
            yield from formulas(part)


@pytest.mark.parametrize("name", [*registry.measurement_names(), *MACHINES, "serial"])
def test_formulas_are_well_formed(name: str) -> None:
    instrument = name in registry.measurement_names()
    found = list(formulas(account.measurement(name) if instrument else account.mechanism(name)))
    assert found
    for f in found:
        ElementTree.fromstring(f"<math>{f.mathml}</math>")
        assert f.latex.count("{") == f.latex.count("}")


@pytest.mark.parametrize("spec", registry.effects(), ids=lambda spec: spec.name)
def test_accounts_of_effects_are_complete(spec: Any) -> None:
    found = account.effect(spec.name)
    assert [t["target"] for t in found["targets"]] == list(spec.targets)
    assert all(len(t["columns"]) == len(spec.coefficients) for t in found["targets"])
    assert {r["name"] for r in (*found["coefficients"], *found["constants"])} == {
        c.name for c in (*spec.coefficients, *spec.constants)
    }


def test_all_that_an_effect_may_say_is_typeset() -> None:
    """Every function of the language, a memory, and derivatives that are one-sided at a kink."""
    x, c = state("torque")[0], sp.Symbol("k", real=True)
    said = sp.Piecewise((sp.Mod(x, 3), (x > 1) & (x <= 2) | sp.Ne(x, 5)), (sp.floor(x), True))
    said += sum((f(x) for f in (sp.Abs, sp.sign, sp.exp, sp.log, sp.sin, sp.cos, sp.asin, sp.tanh, sp.Heaviside)), said)
    said += sp.Max(x, 2) + sp.Min(x, 2) + Lag(x, sp.Integer(60))
    assert {f.func for f in said.atoms(sp.Function, sp.Max, sp.Min)} >= set(vocabulary.FUNCTIONS)
    spec = Effect(
        name="everything",
        title="all functions at once",
        source="derive/effects/everything.py",
        advice="None.",
        per_limb=True,
        coefficients=(EffectQuantity(c, "1", 1.0, "a coefficient", believable=(-1.0, 1.0)),),
        targets={"joint": c * said},
        tests=(Reference({"torque": 1.0, "lag_1": 0.0}, {"k": 0.0}, {"joint": 0.0}),),
    )
    (target,), (memory,) = account.targets(spec), account.memories(spec)
    assert memory["rate"].latex.startswith(r"\frac{\text{d}")
    shown = [target["formula"], *target["columns"], memory["rate"], memory["start"]]
    for f in shown:
        tree = ElementTree.fromstring(f"<math>{f.mathml}</math>")
        words = {e.text for e in tree.iter("mtext")}
        assert words <= {"joint", "otherwise", " mod ", "d"}, "a construct was left to SymPy's own text"
        assert f.latex.count("{") == f.latex.count("}")
    for sign in ("sgn", "max", "min", "⌊", "≤", "≠", "∧", "∨", "mod", "otherwise"):
        assert sign in target["formula"].mathml


# -------------------------------------------------------------------------------------------------------- whole pages


@pytest.fixture(scope="module")
def pages(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with reports of a machine, of two effects and of a kind of measurement, in both formats."""
    folder = tmp_path_factory.mktemp("reports")
    chosen = [subject(name) for name in ("diamond/12", "backlash", "presliding_friction", "board_image")]
    for one, template, found in reports.made(chosen, lambda text: None):
        for ending in (".html", ".md"):
            for path, text in reports.files(folder / f"{one.stem}{ending}", template, found).items():
                path.write_text(text, encoding="utf-8")
    return folder


@pytest.mark.walk
def test_a_report_is_complete(pages: Path) -> None:
    exact = limbs("diamond")
    html, md = ((pages / f"diamond-12.{ending}").read_text(encoding="utf-8") for ending in ("html", "md"))
    html = html.replace("<wbr>", "")
    told = account.mechanism("diamond")
    for part in (*told["steps"], *told["where"]):
        assert part["formula"].mathml in html
        assert part["formula"].latex in md
        assert f"{part['place'].file}:{part['place'].line}" in md
    for closure in told["closures"]:
        assert closure["equation"].mathml in html
        assert closure["differential_equation"].latex in md
    tables = (exact.platform, exact.tool, exact.errors, exact.common, exact.deflections, exact.masses)
    for quantity in (q for rows in tables for q in rows):
        assert f"<code>{quantity.name}</code>" in html
        assert f"`{quantity.name}`" in md
        assert quantity.meaning in md
    for entry in exact.geometry:
        assert f"`{entry.key}`" in md
    for claim in ledger.load_paper("mei").claims:
        assert claim.test in html
        assert claim.test in md
    applying = [name for name in effect_names() if not applies(name, "diamond")]
    assert len(applying) > 5
    for name in applying:
        for target in account.effect(name)["targets"]:
            assert target["formula"].mathml in html
            assert target["formula"].latex in md
    for part in (*told["implicit"], *told["statics"]):
        assert part["formula"].mathml in html
        assert part["formula"].latex in md
        for end in part["ends"]:
            assert f"<code>{end if isinstance(end, str) else end.__qualname__}</code>" in html
    for kind in registry.measurements():
        found = account.measurement(kind.name)
        for formula in (*found["steps"], *found["readings"], *(q["symbol"] for q in found["unknown"])):
            assert formula.mathml in html
            assert formula.latex in md
    for name in ("machine", "orders", "map", "condition"):
        svg = (pages / f"diamond-12-{name}.svg").read_text(encoding="utf-8")
        ElementTree.fromstring(svg)
        assert "var(" not in svg


@pytest.mark.walk
def test_markdown_renders_on_a_code_host(pages: Path) -> None:
    for page in pages.glob("*.md"):
        text = page.read_text(encoding="utf-8")
        for table in re.findall(r"(?:^\|.*\n)+", text, re.M):
            widths = {len(re.findall(r"(?<!\\)\|", row)) for row in table.splitlines()}
            assert len(widths) == 1, table[:300]
        inline = re.findall(r"\$`([^`]+)`\$", text)
        assert inline
        assert text.count("$") == 2 * len(inline)  # between $` and `$ no sign is Markdown's
        assert not any("|" in formula for formula in inline)


@pytest.mark.walk
def test_every_link_of_a_page_leads_somewhere(pages: Path) -> None:
    for page in pages.glob("*.html"):
        text = page.read_text(encoding="utf-8")
        anchors = set(re.findall(r'id="([^"]+)"', text))
        links = re.findall(r'href="([^"]+)"', text)
        assert links
        assert {link for link in links if link.lstrip("#") not in anchors} == set()


@pytest.mark.walk
def test_lines_that_steps_lead_to_make_them(pages: Path) -> None:
    text = (pages / "diamond-12.md").read_text(encoding="utf-8")
    text = text[text.index("### Steps") : text.index("### Closure")]
    places = re.findall(r"`(derive/mechanisms/diamond\.py):(\d+)` → `\w+` `(generated/[\w/.]+):(\d+)`", text)
    assert len(places) >= 3
    for source, line, kernel, assigned in places:
        made = (ROOT / source).read_text().splitlines()[int(line) - 1]
        name = re.search(r'step\("(\w+)"', made)
        assert name is not None
        assert (ROOT / kernel).read_text().splitlines()[int(assigned) - 1].strip().startswith(f"{name[1]}_")


@pytest.mark.walk
def test_a_report_is_the_same_bytes_anywhere(pages: Path, tmp_path: Path) -> None:
    command = f"import deltacal_gen as dc; dc.derivation('diamond/12', output=r'{tmp_path / 'other.html'}')"
    elsewhere = {"PYTHONPATH": os.pathsep.join(sys.path), "PYTHONHASHSEED": "11", "TZ": "Asia/Tokyo"}
    subprocess.run([sys.executable, "-c", command], check=True, cwd=tmp_path, env={**os.environ, **elsewhere})
    text = (pages / "diamond-12.html").read_bytes()
    assert (tmp_path / "other.html").read_bytes() == text
    assert str(ROOT).encode() not in text
    assert re.search(rb"https?://(?!www\.w3\.org/)", text) is None
    assert b"<script" not in text


def test_the_index_names_every_model_and_effect() -> None:
    names = {s.name for s in subjects()}
    assert names >= {*effect_names(), *drive_effect_names(), *registry.measurement_names()}
    for name in mechanism_names():
        assert any(s.mechanism == name for s in subjects()), name
    assert {"delta/42", "delta/51", "diamond/12", "planar_parallelogram/9", "robotennis/15", "serial/dh"} <= names
    assert len({s.stem for s in subjects()}) == len(subjects())


def test_the_method_is_what_the_runtime_computes() -> None:
    """Each rule that SymPy made agrees with the function in which it ends, and names a test that is there."""
    found = method.steps()
    assert len({step.title for step in found}) == len(found) >= 10
    for step in found:
        assert step.gap < 1e-12, step.title
        assert method.ends(step), step.title
        file, name = step.test.split("::")
        assert f"def {name}(" in (ROOT / file).read_text(), step.test
    with pytest.raises(ValueError, match="not convex"):
        method.least(-((method.a - 1) ** 2))


@pytest.mark.parametrize("name", mechanism_names())
def test_derivatives_converge_on_every_example(name: str) -> None:
    robot = example(name)
    assert robot is not None, f"{name} has no example, so that its report has no numbers"
    for order in checks.orders(robot, checks.spread(robot, 20)):
        assert order.order == pytest.approx(2.0, abs=0.06), order.by


@pytest.mark.walk
@pytest.mark.parametrize(
    ("arguments", "error", "words"),
    [
        (("nothing/3", "a.html"), UsageError, "there is no model, mechanism, effect or measurement 'nothing/3'"),
        ((None, "a.html"), UsageError, "give a model"),
        (("diamond", "a.pdf"), InputError, "ends with none of .html, .md"),
    ],
)
def test_what_cannot_be_made_is_said(
    arguments: tuple[Any, ...], error: type[Exception], words: str, tmp_path: Path
) -> None:
    with pytest.raises(error, match=re.escape(words)):
        dc.derivation(arguments[0], output=tmp_path / arguments[1])
    assert list(tmp_path.iterdir()) == []


@pytest.mark.walk
def test_a_file_that_cannot_be_written_is_named(tmp_path: Path) -> None:
    picture = tmp_path / "report-machine.svg"
    picture.mkdir()
    with pytest.raises(InputError, match=r"report-machine\.svg: the file cannot be written") as error:
        dc.derivation("planar_parallelogram/2", output=tmp_path / "report.md")
    assert error.value.file == str(picture)
    assert error.value.remedy.startswith("Check the folder")


@pytest.mark.walk
def test_a_machine_that_is_tried_out_is_drawn_and_its_file_explained(tmp_path: Path) -> None:
    text = (ROOT / "src/deltacal_gen/examples/diamond/robot.toml").read_text(encoding="utf-8")
    (tmp_path / "robot.toml").write_text(text, encoding="utf-8")
    said = trial(tmp_path / "robot.toml", tmp_path / "machine.svg")
    assert said.startswith("diamond: 100 of 100 poses there and back")
    ElementTree.fromstring((tmp_path / "machine.svg").read_text(encoding="utf-8"))
    (tmp_path / "robot.toml").write_text(text.replace("proximal_length", "proximal_lenght"), encoding="utf-8")
    with pytest.raises(InputError, match="proximal_lenght") as error:
        trial(tmp_path / "robot.toml", tmp_path / "machine.svg")
    assert error.value.line is not None
    assert error.value.remedy


@pytest.mark.walk
def test_the_command_says_what_it_wrote(run: Any, tmp_path: Path) -> None:
    code, out, _ = run("derivation", "zero_jump", "-o", tmp_path / "effect.md", "--json")
    assert code == 0
    assert json.loads(out)["files"] == [str(tmp_path / "effect.md")]
    assert math.isclose((tmp_path / "effect.md").read_text().count("```math"), 4, abs_tol=3)


@pytest.mark.parametrize("name", ["complete_delta", "delta", "diamond", "robotennis", "linear_delta"])
def test_weights_at_rest_and_bodies_in_motion_have_the_same_masses_at_the_same_places(name: str) -> None:
    """Written down twice, for statics and for dynamics: mass and first moment of a limb agree without errors."""
    machine = limbs(name)
    at_rest = sum((w.mass * sp.Matrix([1, *w.point]) for w in machine.limb_weights), sp.zeros(4, 1))
    moments = [part for part in machine.limb_inertials if part.unit != "kg mm^2"]
    moving = sum((part.stated * m * sp.Matrix([1, *p]) for part in moments for m, p in part.points), sp.zeros(4, 1))
    assert at_rest != sp.zeros(4, 1)
    errors = {e.symbol: 0 for e in machine.errors}
    assert (at_rest - moving).subs(errors).applyfunc(sp.simplify) == sp.zeros(4, 1)

"""No mathematics of a machine stands in the runtime or in a template: all of it is derived.

Told by its words: trigonometry and vector products anywhere in ``src`` and ``templates``, products of matrices in the
wings that compute with machines. What may stand there is listed with its reason; what is listed and gone is an error.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SRC, TEMPLATES = ROOT / "src" / "deltacal_gen", ROOT / "templates"
ROUND = {
    "sin",
    "cos",
    "tan",
    "asin",
    "acos",
    "atan",
    "atan2",
    "arcsin",
    "arccos",
    "arctan",
    "arctan2",
    "hypot",
    "cross",
}
PRODUCTS = {"einsum", "matmul", "dot", "tensordot", "vdot", "inner"}
MACHINES = ("machine", "physics", "instrument")  # wings in which a product of matrices may be one of a machine

WORKSPACE = "a place in the cylinder of the workspace, by its radius and its angle"
CHAIN_RULE = "derivatives of the kernels, multiplied"
BEGUN = "a first estimate by linear algebra (Zhang 2000; Shah 2013), which the derived images then correct"
TURNED = "a pose in a base that has turned"
ROWS = "a drawing's lines as rows of a table, which the derived kernels prove wherever they are made"
FUNCTIONS = {
    "diagnosis/spectrum.py:_standing": "the amplitude of a wave of cosine and sine, and how well it is known",
    "machine/values.py:Workspace.holds": WORKSPACE,
    "identification/noise.py:_with_rounding": "variances that add up",
    "identification/uncertainty.py:uncertainty_map": "two standard deviations together",
    "inference/functions.py:walk": "functions of a random walk in time, of no machine",
    "instrument/board.py:_apart": BEGUN,
    "instrument/board.py:_mapped": BEGUN,
    "instrument/board.py:_places": BEGUN,
    "instrument/board.py:at_origin": "a camera moved to its part's origin, the board along with it: no image changes",
    "instrument/board.py:first": BEGUN,
    "instrument/board.py:fitted": "normal equations",
    "instrument/board.py:hand_eye": BEGUN,
    "instrument/board.py:homography": BEGUN,
    "instrument/board.py:looked_at": "the point that lines pass closest, by least squares",
    "instrument/board.py:mounted": "a camera of a simulation is hung up before the machine",
    "instrument/board.py:nearest": "the rotation nearest to a matrix",
    "instrument/board.py:shown": "which points a straight lens shows, asked before there are images",
    "instrument/board.py:stand": BEGUN,
    "instrument/board.py:unseen": "columns made orthogonal to one another",
    "instrument/kind.py:Instrument.check_state": "whether a matrix that was read is a rotation",
    "instrument/kind.py:Instrument.linearise": CHAIN_RULE,
    "instrument/kind.py:Instrument.residual": "one measured rotation by another",
    "instrument/kind.py:Instrument.stepped": "directions that keep ties, by their shares",
    "machine/rotation.py:align": "the rotation that fits two clouds of points (Kabsch 1976)",
    "instrument/kind.py:Kind.by_platform": CHAIN_RULE,
    "instrument/kind.py:Kind.start": "the square of a step",
    "instrument/kinds/board_image.py:BoardImage._scale": "of each image the derivatives along and across, picked out",
    "instrument/kinds/board_image.py:BoardImage.imagined": "how far along the optical axis a board stands",
    "instrument/kinds/contact.py:Contact.tied": "a least correction, by the pseudo-inverse",
    "instrument/kinds/pose.py:Pose.start": "one measured rotation by another",
    "instrument/kinds/position.py:Position._aligned": "a cloud of points, turned and shifted",
    "instrument/kinds/position.py:Position._along_a_line": "points along the line that fits one coordinate best",
    "instrument/kinds/position.py:read_along": "least squares on the unit sphere (Gander, Golub, von Matt 1989)",
    "instrument/kinds/sphere.py:Sphere.drawn": "a camera of a simulation is hung up before the machine",
    "instrument/kinds/sphere.py:Sphere.imagined": "how far along the optical axis a ball stands",
    "instrument/kinds/sphere.py:Sphere.start": "points in the camera's frame, by the rotation that was found",
    "instrument/kinds/touched_board.py:TouchedBoard.laid_out": "a flat print is laid on the workspace",
    "instrument/kinds/touched_board.py:_plane": "axes of a flat print from its points, by singular values",
    "instrument/sphere.py:centres": "normal equations",
    "machine/answers.py:Sensitivity.turned": TURNED,
    "machine/chain.py:Chain._length": "how far a table of a link leads",
    "machine/chain.py:Chain._parallel": "whether an angle is a multiple of half a turn",
    "machine/chain.py:Chain.follow": "joints in the directions that a chain commands: linear algebra of its Jacobian",
    "machine/chain.py:Chain.moves": "shares of tables in a joint's link",
    "machine/chain.py:Chain.roles": "sums over the tables of a joint's link",
    "machine/chain.py:_prioritised": "two levels of priority by projections (Siciliano, Slotine 1991)",
    "machine/denavit.py:_across": ROWS,
    "machine/denavit.py:_least": ROWS,
    "machine/denavit.py:_seen": ROWS,
    "machine/denavit.py:_tilted": ROWS,
    "machine/denavit.py:_to_end": ROWS,
    "machine/denavit.py:rows_of": ROWS,
    "machine/dynamics.py:ChainDynamics.torque": "what derived columns give for their parameters, summed up",
    "machine/limbs.py:Limbs._body": "a sum of every row, NaN where a number is",
    "machine/machine.py:Machine.missed": "one rotation by another",
    "machine/rotation.py:about_z": WORKSPACE,
    "machine/rotation.py:to_vector": "SciPy's, for rotations by less than half a turn, without importing it",
    "motion/session.py:Session.declared": "two standard deviations together",
    "physics/body.py:Body.along": CHAIN_RULE,
    "physics/body.py:Body.derivatives": CHAIN_RULE,
    "physics/body.py:Body._rows": "parts that effects move, by what they are made of",
    "physics/body.py:Body.state": WORKSPACE,
    "physics/body.py:Body.theta": "joints by the errors of their zeros, as the mechanism declares them",
    "physics/deformed.py:carried": CHAIN_RULE,
    "physics/deformed.py:turned": TURNED,
    "physics/following.py:following": "chain rule and implicit functions: of any machine that gives way",
    "physics/formula.py:": "the functions that a law's text may name",
    "physics/simulation.py:simulate": "noise of a measured rotation",
    "physics/splines.py:unit_noise": "the noise of a spline's derivative, by least squares",
    "planning/boards.py:looking": "from where a plan looks at a board: a tilt and a turn around it",
    "planning/exciting.py:Excitation.__init__": "by how much a series may pass its samples (Ehlich and Zeller 1964)",
    "planning/exciting.py:Series.states": "a Fourier series in time, as a plan commands it (Swevers et al. 1997)",
    "use/comparison.py:_both": "two standard deviations together",
    "use/command_source.py:_places": WORKSPACE,
    "use/exporters/table.py:_table_errors": WORKSPACE,
    "use/exporters/table.py:_used": WORKSPACE,
    "use/unseen.py:_on_the_bed": "along which way of the bed a print is stretched",
}
LINES = {
    "mechanism/vectorised.py.jinja: by_limb @ J_p": "the closure's inverse, by limb, times its derivatives",
    "mechanism/vectorised.py.jinja: W @ S_p": "a derived matrix times derivatives",
}
TYPED = re.compile(
    rf"\b(?:math|np|cmath)\.(?:sqrt|{'|'.join(sorted(ROUND | PRODUCTS))})\b|\w \(?@ \w|\b(?:sin|cos|sqrt)\("
)


def _told(node: ast.AST, machines: bool) -> bool:
    """Tell whether a node is trigonometry, a vector product or, in wings of machines, a product of matrices."""
    if isinstance(node, ast.Attribute):
        named = isinstance(node.value, ast.Name) and node.value.id in ("np", "math")
        return named and (node.attr in ROUND or (machines and node.attr in PRODUCTS))
    return machines and isinstance(node, ast.BinOp | ast.AugAssign) and isinstance(node.op, ast.MatMult)


def _functions(tree: ast.Module) -> Iterator[tuple[str, ast.AST]]:
    """Yield functions and methods, by name, and what stands outside of them."""
    for node in tree.body:
        if isinstance(node, ast.ClassDef):
            for inner in node.body:
                yield f"{node.name}.{getattr(inner, 'name', '')}", inner
        else:
            yield getattr(node, "name", ""), node


def test_the_runtime_holds_no_formula_of_a_machine() -> None:
    found = set()
    for path in sorted(SRC.rglob("*.py")):
        where = path.relative_to(SRC).as_posix()
        for name, function in _functions(ast.parse(path.read_text(encoding="utf-8"))):
            if any(_told(node, where.startswith(MACHINES)) for node in ast.walk(function)):
                found.add(f"{where}:{name}")
    assert found - set(FUNCTIONS) == set(), "derive it (derive/), or list it with the reason why it is of no machine"
    assert set(FUNCTIONS) - found == set(), "what is listed stands there no more"


def test_templates_lay_out_and_do_not_compute() -> None:
    allowed, found = dict.fromkeys(LINES, 0), []
    for path in sorted(TEMPLATES.rglob("*.jinja")):
        where = path.relative_to(TEMPLATES).as_posix()
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
            if TYPED.search(line):
                known = [key for key in LINES if key.startswith(f"{where}: ") and key.partition(": ")[2] in line]
                allowed.update({key: allowed[key] + 1 for key in known})
                found += [] if known else [f"{where}:{number}: {line.strip()}"]
    assert found == []
    assert all(allowed.values()), "what is listed stands there no more"


def test_what_is_listed_says_why() -> None:
    assert all(len(why) > 10 for why in (*FUNCTIONS.values(), *LINES.values()))

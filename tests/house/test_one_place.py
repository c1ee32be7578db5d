"""One place for what a state is, one for a kind of measurement, one for a sort of machine: read from syntax trees.

A state's name or column that is compared, or stands in a table beside others, says that somebody else knows what states
are; so does a kind's name outside its object, and the class of a machine outside its wing. So does an effect's name
anywhere, that of a target in full or in a table, and of a constant that is compared. Everybody else asks a field of the
state (``derive/language/states.py``), a method of the kind (``instrument/kind.py``), what the machine says it can do
(``machine/machine.py``), a table of the effect or that of targets (``derive/language/targets.py``). Where a name may
stand all the same is told below, with the reason.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from deltacal_kernels.effects.targets import LAWFUL, TARGETS

from deltacal_gen import states
from deltacal_gen.instrument import kinds
from deltacal_gen.machine.values import TRUTH
from deltacal_gen.physics.terms import drive_effect_names, effect_names, load_effect
from deltacal_gen.results.reader import KINDS_IN_MOTION

SOURCE = Path(__file__).resolve().parents[2] / "src" / "deltacal_gen"
EXAMPLES = "manual/"  # notebooks that are read

STATES = {s.name for s in states.STATES.values() if s.kind in ("joint", "channel", "load") or s.of_geometry}
COLUMNS = {
    pattern for s in states.STATES.values() for pattern in (s.column, s.column.format(i=1, unit="deg")) if pattern
}
KINDS = {*kinds.names(), *KINDS_IN_MOTION}
EFFECTS = {*effect_names(), *drive_effect_names()}
CONSTANTS = {key for name in EFFECTS for key, *_ in load_effect(name).CONSTANTS}
ON = {target.partition(".")[0] for target in TARGETS}
ASKS = ("startswith", "endswith", "removeprefix", "removesuffix", "get_close_matches")

OF_STATES = {
    "physics/body.py:state": "computes the states of a machine, each by its name",
    "physics/body.py:_loads": "computes what weights exert, each load by its name",
    "motion/library.py:of_joint": "computes the states of a joint in motion, each by its name",
    "motion/session.py:of_joints": "the noise of a joint's derivatives, in their order",
    "motion/identification.py:still_to_show": "what joints that moved one by one have not told of",
    "motion/session.py:to_move": "what a joint that stood still, or moved for too short a time, has not told of",
    "planning/runs.py:asked": "what runs can be made to vary: how fast they are, and what they carry",
    "motion/told.py:_curve": "friction is drawn along what else changes it, at a speed",
    "motion/unexplained.py:the module": "what answers call that on which a rest depends; the words are the table's",
    "diagnosis/library.py:_constant": "an offset of clocks does to readings what an effect of the speed does",
    "pages/laws.py:_part": "the target of a law, not a state",
    "physics/law.py:__init__": "the target of a law, not a state",
    "physics/law.py:unit_moved": "the target of a law, not a state",
    "app/demonstration.py:_check": "a recording that is made up for the demonstration",
    "app/commands/clocks.py:instrument_columns": "columns of a file: those of joints begin so",
}
OF_KINDS = {
    "files/printers.py:height_recording": "reads the files of firmware that probes heights",
    "files/samples.py:imported": "reads the files of motion capture, with rotations or without",
    "files/recording.py:_pairs_and_rows": "a column, which holds the labels of poses",
    "use/experiments.py:_asks": "a column, which holds the labels of poses",
    "planning/runs.py:asked": "a state, which has the same name",
    "pages/motion.py:against": "a word for how far a joint slides",
    "pages/laws.py:_part": "the target of a law of drives",
    "physics/law.py:__init__": "the target of a law of drives",
    "physics/parts.py:lacking": "the target of an effect on probed heights",
}
OF_MACHINES = {
    "files/robot.py": "reads and writes robot files, of which some list links one by one",
    "files/checks.py:check_units": "asks the robot file whether it lists links: a chain reaches as far as they slide",
    "estimation/arrays.py:nominal": "makes a robot of dimensions alone, which one that lists links has not",
}
OF_EFFECTS = {
    "motion/joint.py:the module": "what every drive has, to begin with",
    "motion/lag.py:the module": "the delay of a drive's readings, which is no term beside others: all terms come late",
    "machine/dynamics.py:stated": "a field of a joint of the robot file, which has the same name",
}
OF_TARGETS = {
    "physics/law.py:unit_moved": "the units of targets: mm but of these",
}


Nodes = list[tuple[str, str, ast.AST]]


@pytest.fixture(scope="module")
def nodes() -> Nodes:
    """Return all nodes of the source, each with its path and the function or class around it."""
    found: Nodes = []

    def walk(where: str, owner: str, node: ast.AST) -> None:
        owner = node.name if isinstance(node, ast.FunctionDef | ast.ClassDef) else owner
        found.append((where, owner, node))
        for child in ast.iter_child_nodes(node):
            walk(where, owner, child)

    for path in sorted(SOURCE.rglob("*.py")):
        walk(path.relative_to(SOURCE).as_posix(), "the module", ast.parse(path.read_text(encoding="utf-8")))
    return found


def places(nodes: Nodes, rule: Callable[[ast.AST], bool], *home: str) -> Iterator[str]:
    """Yield ``path:function`` of all that a rule finds outside its home."""
    for where, owner, node in nodes:
        if not where.startswith((*home, EXAMPLES)) and rule(node):
            yield f"{where}:{owner}: {ast.unparse(node)}"


def words(*nodes: ast.AST | None) -> set[str]:
    """Return the texts that stand in nodes as they are, or in their displays."""
    found: set[str] = set()
    for node in nodes:
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            found.add(node.value)
        elif isinstance(node, ast.Tuple | ast.List | ast.Set):
            found |= words(*node.elts)
    return found


def of_states(node: ast.AST) -> bool:
    """Tell whether a node compares or tabulates states."""
    known = STATES | COLUMNS
    if isinstance(node, ast.Compare):
        return bool(words(node.left, *node.comparators) & known)
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr in ASKS:
        return bool(words(*node.args) & known)
    if isinstance(node, ast.Dict):
        return len(words(*node.keys) & known) > 1
    return isinstance(node, ast.Tuple | ast.List | ast.Set) and len(words(node) & known) > 1


def of_kinds(node: ast.AST) -> bool:
    """Tell whether a node compares, chooses, defaults to or looks up a kind by its name."""
    if isinstance(node, ast.Compare):
        return bool(words(node.left, *node.comparators) & KINDS)
    if isinstance(node, ast.IfExp):
        return bool(words(node.body, node.orelse) & KINDS)
    if isinstance(node, ast.match_case):
        return bool({n.value for n in ast.walk(node.pattern) if isinstance(n, ast.Constant)} & KINDS)
    if isinstance(node, ast.arguments):
        return bool(words(*node.defaults, *node.kw_defaults) & KINDS)
    if isinstance(node, ast.Call):
        named = node.func.id if isinstance(node.func, ast.Name) else getattr(node.func, "attr", "")
        said = [k.value for k in node.keywords if k.arg == "kind"]
        return bool(words(*said, *(node.args if named == "kind_of" else ())) & KINDS)
    if isinstance(node, ast.Dict):
        said = [v for k, v in zip(node.keys, node.values, strict=True) if words(k) == {"kind"}]
        return bool(words(*said) & KINDS)
    return False


def of_effects(node: ast.AST) -> bool:
    """Tell whether a node names an effect, or compares the name of a constant of effects."""
    if isinstance(node, ast.Compare):
        return bool(words(node.left, *node.comparators) & CONSTANTS)
    return isinstance(node, ast.Constant) and node.value in EFFECTS


def of_targets(node: ast.AST) -> bool:
    """Tell whether a node names a target in full, or tabulates what stands before the dot."""
    if isinstance(node, ast.Dict):
        return len(words(*node.keys) & ON) > 1
    return isinstance(node, ast.Constant) and node.value in TARGETS.keys() - ON


def of_machines(node: ast.AST) -> bool:
    """Tell whether a node asks what sort a machine is instead of what it can do."""
    sorts = {"Chain", "Limbs", "ChainDynamics", "LimbDynamics"}
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "isinstance":
        return any(isinstance(n, ast.Name) and n.id in sorts for n in ast.walk(node))
    if isinstance(node, ast.ImportFrom):
        return any(name.name in sorts for name in node.names)
    return isinstance(node, ast.Attribute) and node.attr in ("links", "linked")


def of_truths(node: ast.AST) -> bool:
    """Tell whether a node knows how columns of what only a simulation knows begin: others ask `Recording.told`."""
    return isinstance(node, ast.Constant) and isinstance(node.value, str) and node.value.startswith(TRUTH)


@pytest.mark.parametrize(
    ("rule", "home", "allowed"),
    [
        (of_states, ("states.py",), OF_STATES),
        (of_kinds, ("instrument/kinds/",), OF_KINDS),
        (of_effects, (), OF_EFFECTS),
        (of_targets, (), OF_TARGETS),
        (of_machines, ("machine/",), OF_MACHINES),
        (of_truths, ("machine/values.py",), {}),
    ],
    ids=["states", "kinds", "effects", "targets", "machines", "truths"],
)
def test_what_is_known_is_known_in_one_place(
    nodes: Nodes, rule: Callable[[ast.AST], bool], home: tuple[str, ...], allowed: dict[str, str]
) -> None:
    found = list(places(nodes, rule, *home))
    assert [line for line in found if not line.startswith(tuple(allowed))] == [], (
        "ask its home, or say why it may stand"
    )
    assert {where for where in allowed if not any(line.startswith(where) for line in found)} == set(), "no longer there"
    assert all(allowed.values())


def test_a_law_is_looked_for_on_targets_that_there_are() -> None:
    assert set(LAWFUL) <= TARGETS.keys()

"""The laws that reports show: their SymPy expressions at numbers are what kernels and runtime compute."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
import pytest
import sympy as sp

from deltacal_gen.instrument.kind import Readings
from deltacal_gen.instrument.kinds import kind_of
from deltacal_gen.machine.chain import Chain
from deltacal_gen.machine.limbs import Limbs
from deltacal_gen.machine.registry import COORDINATES, Array, mechanism_of
from deltacal_gen.machine.rotation import cayley_matrix, cayley_vector
from deltacal_gen.physics.body import Body
from deltacal_gen.physics.deformed import Deformed
from deltacal_gen.physics.reading import reading_shift
from deltacal_gen.physics.terms import Term, blank, effect_names
from deltacal_gen.states import read_by
from derive import closed_form, registry, vectors
from derive.review import checks, laws, reports
from derive.review.laws import Law
from derive.review.sources import Place, Sources
from derive.review.subjects import example
from derive.spec import LimbMechanism
from tests.support.every_effect import body_of, constants, limbs_with, machine_with

SPECS = {m.name: m for m in registry.mechanisms() if isinstance(m, LimbMechanism)}
MACHINES = list(SPECS)
WEIGHING = [name for name, m in SPECS.items() if m.masses]
GRAVITY = np.array([1.0, -2.0, -9.81])  # askew, so that no component of a moment vanishes
POSES = 5
rng = np.random.default_rng(16)


def value(e: sp.Basic, **at: Any) -> Array:
    """Return an expression at numbers, given by the names of its symbols."""
    symbols = [s for s in e.atoms(sp.MatrixSymbol, sp.Symbol) if str(s) in at]
    plain = {
        s: sp.MatrixSymbol(f"m{k}", *s.shape) if isinstance(s, sp.MatrixSymbol) else sp.Symbol(f"s{k}")
        for k, s in enumerate(symbols)
    }
    numbers = (np.asarray(at[str(s)], dtype=float) for s in symbols)
    return np.asarray(sp.lambdify(list(plain.values()), e.xreplace(plain), "numpy")(*numbers))


def sides(found: Iterable[Law]) -> dict[str, sp.Basic]:
    """Return the right sides of laws by their left ones."""
    return {str(left): right for law in found for left, right in law.equations}


def skew(v: Array) -> Array:
    return np.cross(np.eye(3), v)


class Machine:
    """A machine at a few poses, with the Jacobians of its closures as full matrices."""

    def __init__(self, name: str) -> None:
        robot = example(name)
        assert robot is not None
        mechanism = mechanism_of(robot)
        assert isinstance(mechanism, Limbs)
        self.robot, self.mechanism, self.spec = robot, mechanism, SPECS[name]
        poses = checks.spread(robot, POSES)
        self.x, self.q, self.tool = poses.x, poses.q, poses.tool
        self.rows = self.mechanism.rows(robot)
        F, self.J_x, J_q, J_p = self.mechanism.jacobians(self.x, self.q, self.tool, self.rows)
        assert np.abs(F).max() < 1e-6
        limbs, (N, f, n_v) = self.mechanism.limbs, J_p.shape
        self.J_q, self.J_p = np.zeros((N, f, limbs)), np.zeros((N, f, limbs, n_v))
        for row in range(f):
            limb = row // (f // limbs)
            self.J_q[:, row, limb], self.J_p[:, row, limb] = J_q[:, row], J_p[:, row]
        self.J_p = self.J_p.reshape(N, f, limbs * n_v)
        self.own = np.hstack([self.x[:, :3], cayley_vector(self.x[:, 3:].reshape(-1, 3, 3))])
        self.at = [COORDINATES.index(n) for n in self.mechanism.platform]

    def jacobians(self, n: int) -> dict[str, Array]:
        return {"J_x": self.J_x[n], "J_q": self.J_q[n], "J_p": self.J_p[n]}


@pytest.fixture(scope="module")
def machines() -> dict[str, Machine]:
    return {name: Machine(name) for name in MACHINES}


# ------------------------------------------------------------------------------------------------------- limbs


@pytest.mark.parametrize("name", MACHINES)
def test_sensitivities_are_those_of_the_implicit_function_theorem(name: str, machines: dict[str, Machine]) -> None:
    machine, shown = machines[name], laws.implicit(True, Place("", 1))
    right = sides(shown)
    found = machine.mechanism.sensitivity(machine.x, machine.q, machine.tool, machine.rows)
    every = np.concatenate([found.own, found.common, found.deflections], axis=3)
    for n in range(len(machine.x)):
        S, V = (value(right[side], **machine.jacobians(n)) for side in "SV")
        c = machine.own[n, 3:]
        to_turn = np.eye(6)  # of shift and Cayley vector to shift and turn
        to_turn[3:, 3:] = value(right["d phi"], **{"[c]": skew(c), "c.c": c @ c, "d c": np.eye(3)})
        in_space = to_turn[np.ix_(machine.at, machine.at)]
        assert found.joints[n, machine.at] == pytest.approx(in_space @ V, rel=1e-9, abs=1e-9)
        whole = every[n, machine.at].reshape(len(machine.at), -1)
        assert whole == pytest.approx(in_space @ S, rel=1e-9, abs=1e-9)
        # on the machine the closures stay zero, along what the theorem says
        d = {"d p": rng.standard_normal((S.shape[1], 1)), "d q": rng.standard_normal((V.shape[1], 1))}
        moved = value(right["d x"], S=S, V=V, **d)
        total = next(left for law in shown for left, _ in law.equations if str(left).count("d ") == 3)
        assert value(total, **machine.jacobians(n), **d, **{"d x": moved}) == pytest.approx(0, abs=1e-9)


@pytest.mark.parametrize("name", WEIGHING)
def test_loads_are_those_of_virtual_work(name: str, machines: dict[str, Machine]) -> None:
    machine, right = machines[name], sides(laws.virtual_work(True))
    mechanism, spec = machine.mechanism, machine.spec
    masses = {q.name: float(rng.uniform(0.2, 2.0)) for q in spec.masses}
    payload, weighed = 1.7, mechanism._masses(masses)
    put = {q.symbol: masses[q.name] for q in spec.masses} | {sp.Symbol("payload", real=True): payload}
    every = [*spec.limb_weights * spec.limbs, *spec.platform_weights]
    G = np.concatenate([float(sp.sympify(w.mass).xreplace(put)) * GRAVITY for w in every])[:, None]
    loads = mechanism.loads(machine.x, machine.q, machine.tool, machine.rows, masses, GRAVITY, payload)
    tool = np.tile(machine.tool, (len(machine.x), 1))

    def points(own: Array, q: Array) -> Array:
        kernels, limbs = mechanism._statics, range(mechanism.limbs)
        parts = [kernels.limb_points(own, q[:, i], tool, machine.rows[:, i], weighed) for i in limbs]
        return np.hstack([*parts, kernels.platform_points(own, tool, weighed, np.full(len(own), payload))])

    own = np.ascontiguousarray(machine.own[:, machine.at])

    def slopes(of: str, h: float = 1e-4) -> Array:
        columns = []
        for step in h * np.eye(own.shape[1] if of == "x" else machine.q.shape[1]):
            ends = [(own + s * step, machine.q) if of == "x" else (own, machine.q + s * step) for s in (1, -1)]
            columns.append((points(*ends[0]) - points(*ends[1])) / (2 * h))
        return np.stack(columns, axis=2)

    r_q, r_x = slopes("q"), slopes("x")
    rods = [mechanism.column(rod) - len(mechanism.geometry) for rod in mechanism._tables.RODS]
    for n in range(len(machine.x)):
        W = {f"W_{v}": value(right[f"W_{v}"], **{f"∂r/∂{v}": r[n], "G": G}) for v, r in (("q", r_q), ("x", r_x))}
        mu = value(right["mu"], **W, **machine.jacobians(n))
        tau = value(right["tau"], **W, **machine.jacobians(n), mu=mu)
        assert loads.torque[n] == pytest.approx(tau[:, 0], rel=1e-6, abs=1e-3)
        f_p = value(right["f_p"], **machine.jacobians(n), mu=mu).reshape(mechanism.limbs, -1)
        bent = len(mechanism.deflections)
        assert loads.pull[n] == pytest.approx(f_p[:, f_p.shape[1] - bent :], rel=1e-6, abs=1e-5)
        tensions = loads.tension[n].sum(axis=1) * mechanism._tables.RODS_PER_CLOSURE
        assert tensions == pytest.approx(f_p[:, rods].sum(axis=1), rel=1e-6, abs=1e-5)


@pytest.mark.parametrize("name", [name for name, m in SPECS.items() if m.seeds is None is m.home])
def test_the_simplified_closure_is_the_sphere_that_is_shown(name: str) -> None:
    spec = SPECS[name]
    ((left, _),) = laws.sphere().equations
    centre, constant = closed_form.sphere(spec)
    position = [q.symbol for q in spec.platform[: spec.commanded]] + [sp.Integer(0)] * (3 - spec.commanded)
    entries = {
        "P": sp.Matrix(position),
        "c": sp.Matrix([*centre, *[0] * (3 - len(centre))]),
        "d": sp.Matrix([constant]),
    }
    put = {s: sp.ImmutableMatrix(entries[s.name]) for s in left.atoms(sp.MatrixSymbol)}
    (explicit,) = left.xreplace(put).doit()
    assert sp.expand(explicit - closed_form.simplified_closure(spec)) == 0


# --------------------------------------------------------------------------------------------------- rotations


def test_rotations_are_those_of_the_runtime() -> None:
    v = np.array([0.3, -0.2, 0.4])
    right = sides(whole for whole, _ in laws.rotations_used(["exp", "cay"]))
    exp, cay = right["exp"], right["cay"]
    turned = value(exp, **{"[v]": skew(v), "t": np.linalg.norm(v)})
    written = np.array(vectors.rotation_vector(sp.Matrix(v))).astype(float)
    assert turned == pytest.approx(written, abs=1e-15)
    assert turned @ v == pytest.approx(v)
    assert np.trace(turned) == pytest.approx(1 + 2 * np.cos(np.linalg.norm(v)))
    assert value(cay, **{"[c]": skew(v), "c.c": v @ v}) == pytest.approx(cayley_matrix(v[None])[0], abs=1e-15)


# ------------------------------------------------------------------------------------------------------ chains


def test_loads_of_a_chain_are_those_of_virtual_work() -> None:
    robot = example("serial")
    assert robot is not None
    mechanism, right = mechanism_of(robot), sides(laws.weights_of_links())
    assert isinstance(mechanism, Chain)
    masses, payload = [link.mass for link in mechanism.links], 1.7
    assert all(masses)
    rows, poses = mechanism.rows(robot), checks.spread(robot, POSES)
    given = {"any": 1.0}  # an empty mapping asks for the payload alone
    loads = mechanism.loads(poses.x, poses.q, poses.tool, rows, given, GRAVITY, payload)
    n_q, h = mechanism.limbs, 1e-5

    def at(q: Array) -> tuple[Array, Array, Array]:
        x, _ = mechanism.forward(q, poses.tool, rows)
        return mechanism.weights_at(x, q, poses.tool, rows, given), *mechanism.frames(q, rows)

    r, p, R = at(poses.q)
    moved = [[at(poses.q + s * h * e) for s in (1, -1)] for e in np.eye(n_q)]
    G = np.concatenate([m * GRAVITY for m in (*masses, payload)])[:, None]
    g = GRAVITY[:, None]
    for n in range(len(poses.q)):
        by_links = np.stack([(a[0][n] - b[0][n]).ravel() / (2 * h) for a, b in moved], axis=1)
        tau = value(right["tau"], **{"∂r/∂theta": by_links, "∂theta/∂q": np.eye(n_q), "G": G})
        assert loads.torque[n] == pytest.approx(tau[:, 0], rel=1e-6, abs=1e-3)
        tip = poses.x[n, :3]
        F, M = (value(right[f"{v}_t"], m_payload=payload, g=g, **{"P ×": skew(tip)}) for v in "FM")
        for j in reversed(range(len(masses))):
            origin, turn = p[n, j + 1], R[n, j + 1]
            names = {"p_j": origin[:, None], "R_j": turn, "c_j": np.array(mechanism.links[j].com)[:, None]}
            centre = value(right["r_j"], **names)
            assert centre[:, 0] == pytest.approx(r[n, j], abs=1e-9)
            step = {"m_j": masses[j], "g": g, "r_j ×": skew(centre[:, 0])}
            F, M = value(right["F_j"], F_k=F, **step), value(right["M_j"], M_k=M, **step)
            a, b = moved[j]
            s = (a[1][n, j + 1] - b[1][n, j + 1])[:, None] / (2 * h)
            spin = (a[2][n, j + 1] - b[2][n, j + 1]) @ turn.T / (2 * h)
            w = np.array([[spin[2, 1]], [spin[0, 2]], [spin[1, 0]]])
            felt = value(right["∂W/∂theta_j"], s=s, w=w, F=F, M=M, **{"p ×": skew(origin)})
            assert loads.torque[n, j] == pytest.approx(felt[0, 0], rel=1e-6, abs=1e-2)


# ----------------------------------------------------------------------------------------------------- effects


READ = {"position": {"reading.x": 0, "reading.y": 1, "reading.z": 2}, "height": {"height": 2}}


def slopes_of(term: Term, body: Body, machine: Deformed, readings: Array) -> dict[str, list[Array]]:
    """Return the columns of an effect as a report shows them: by target one (N, limbs) for each coefficient."""
    spec = registry.effect(term.effect)
    put: dict[str, Any] = dict.fromkeys((str(c.symbol) for c in spec.coefficients), 0.0)
    put |= {str(c.symbol): v for c, v in zip(spec.constants, term.constants, strict=True)}
    names = [s.name for s in term.states if s.kind != "reading" and not s.by]
    put |= body.state(names, machine.x, machine.q, machine.rows)
    put |= {s.name: body.since(term, s) for s in term.states if s.by}
    for raw, s in zip(read_by(term.kernels), term.states, strict=True):
        if raw.kind == "chosen":
            put[raw.name] = put[s.name][:, None] * body._of_other(s.joint) if s.joint else put[s.name]
    by_memory: dict[str, Array] = {}
    if spec.memory:
        state = body.state(names, machine.x, machine.q, machine.rows)
        found = body._remembered(term, body.read(term, state))
        limbs = found.value.shape[0] // len(body.q)
        for m, z in enumerate(spec.memory):
            put[z.name] = found.value[:, m].reshape(-1, limbs)
            by_memory[z.name] = found.by_coefficients[:, m].reshape(len(body.q), limbs, -1)
    put |= {"y_length": readings[:, 0], **dict(zip(("y_x", "y_y", "y_z"), readings.T, strict=False))}
    shaped = {name: v[:, None] if np.ndim(v) == 1 else v for name, v in put.items()}

    def of(e: sp.Expr) -> Array:
        return np.broadcast_to(value(e, **{str(s): shaped[str(s)] for s in e.free_symbols}), body.q.shape)

    return {
        target: [
            of(sp.diff(e, c.symbol))
            + sum(of(sp.diff(e, z.symbol)) * by_memory[z.name][:, :, k] for z in spec.memory)  # and through memories
            for k, c in enumerate(spec.coefficients)
        ]
        for target, e in spec.targets.items()
    }


@pytest.mark.parametrize("effect", effect_names())
def test_effects_reach_pose_and_reading_as_the_chain_rule_says(effect: str) -> None:
    robot = machine_with(effect)
    body, limbs = body_of(robot, POSES), limbs_with(effect)[-1:]
    mechanism, every = body.mechanism, np.arange(POSES)
    term = blank(effect, limbs, constants(effect), [tuple(robot.tool)])
    machine, status = body.solve(mechanism.vector(robot.errors), [term])
    assert not status.any()
    S = mechanism.sensitivity(machine.x, machine.q, machine.tool, machine.rows)
    common = np.zeros((*S.own.shape[:3], len(mechanism.common)))  # a chain's links share none
    common[..., : S.common.shape[3]] = S.common
    by_limb = np.concatenate([S.own, common, S.deflections], axis=3)
    kind = "height" if "height" in registry.effect(effect).targets else "position"
    at = list(READ[kind].values())
    readings = machine.x[:, at] + 1000.0
    found = Readings(kind_of(kind), every[:, None], readings, None, 0 * every, every, every)
    columns = body.columns([term], machine, S, every)[:, at]
    columns = columns + reading_shift([term], body, found, readings, machine.x)[1]
    own = limbs if term.limbs else range(1, mechanism.limbs + 1)

    def reached(target: str, slope: Array, n: int) -> Array:
        """Return what a column of a target does to the position, at pose n."""
        word, _, part = target.partition(".")
        ((_, right),) = laws.reaches([target], loaded=False)[0].equations
        along = np.eye(3)[:, ["xyz".index(part)]] if part in ("x", "y", "z") else np.eye(3)[:, [2]]
        if word == "joint":
            moved = [value(right, V=S.joints[n][:, [i - 1]], **{"∂Δjoint/∂c": [[slope[n, i - 1]]]}) for i in own]
            return np.asarray(np.sum(moved, axis=0)[:3, 0])
        if word == "limb":
            p = np.zeros((mechanism.limbs, by_limb.shape[3], 1))
            for name, much in mechanism.moves(robot)[part].items():
                p[:, mechanism.column(name) - len(mechanism.geometry), 0] = np.diagonal(much)
            moved = [
                value(right, S=by_limb[n, :, i - 1], **{"∂p/∂part": p[i - 1], "∂Δlimb.part/∂c": [[slope[n, i - 1]]]})
                for i in own
            ]
            return np.asarray(np.sum(moved, axis=0)[:3, 0])
        given = {"∂Δturn/∂c": along, "∂Δtool/∂c": along, "∂Δreading/∂c": along}
        given = {name: v * slope[n, 0] for name, v in given.items()}
        seen = {"P ×": skew(machine.x[n, :3]), "R": machine.x[n, 3:].reshape(3, 3)}
        return np.asarray(value(right, **given, **seen)[:, 0])

    shown = slopes_of(term, body, machine, readings)
    assert np.abs(columns).max() > 0
    for k in range(columns.shape[2]):
        for n in every:
            total = sum(reached(target, slopes[k], n) for target, slopes in shown.items() if target != "length")
            assert columns[n, :, k] == pytest.approx(total[at], rel=1e-9, abs=1e-12 * np.abs(columns).max())


def test_a_name_that_the_runtime_does_not_have_breaks_a_report() -> None:
    sources = Sources()
    part = {"ends": ["no_such_kernel"], "place": None}
    with pytest.raises(KeyError, match="no_such_kernel"):
        reports.led(part, [], sources, "generated/deltacal_kernels/delta")

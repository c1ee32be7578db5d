"""Memories along a run: the derived steps against a solver of differential equations that knows nothing of them."""

from __future__ import annotations

import dataclasses
import warnings
from collections.abc import Callable
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

sp = pytest.importorskip("sympy", reason="deriving needs the dependency group 'derive'")
pytest.importorskip("jinja2", reason="deriving needs the dependency group 'derive'")

from deltacal_gen.app.demonstration import example  # noqa: E402
from deltacal_gen.errors import InputError  # noqa: E402
from deltacal_gen.files.robot import read_robot  # noqa: E402
from deltacal_gen.machine.registry import SOLVED, UNBALANCED, UNDEFINED, load_mechanism  # noqa: E402
from deltacal_gen.physics import memory, terms  # noqa: E402
from deltacal_gen.physics.body import Body  # noqa: E402
from deltacal_gen.physics.channels import Channels  # noqa: E402
from deltacal_gen.physics.terms import Term, blank, load_effect  # noqa: E402
from deltacal_gen.physics.undefined import lacking, undefined  # noqa: E402
from derive import compiler  # noqa: E402
from derive.effects import coefficient, state  # noqa: E402
from derive.language.effects import Effect, Orders, Reference  # noqa: E402
from derive.language.memory import Lag, Memory, with_lags  # noqa: E402

(load,) = state("torque")
z = sp.Symbol("z", real=True)
ANY = (-10.0, 10.0)
SIZE, RATE = coefficient("size", "mm", 1.0, "size", ANY), coefficient("rate", "1", 1.0, "rate", ANY)
TAU = coefficient("tau", "s", 1.0, "time constant", ANY)


def effect(
    target: Any, *memories: Memory, searched: tuple[Any, ...] = (), varied: tuple[Any, ...] = (), reads: str = "torque"
) -> Effect:
    return Effect(
        name="remembering",
        title="an effect with a memory",
        source="tests/physics/test_memory.py",
        advice="None.",
        tests=(
            Reference(
                {reads: 0.0, **{m.name: 0.0 for m in with_lags({"joint": target}, memories)[1]}},
                {c.name: 0.0 for c in (SIZE, *varied)},
                {"joint": 0.0},
                {s.constant.name: 1.0 for s in searched},
            ),
        ),
        per_limb=True,
        coefficients=(SIZE, *varied),
        searched=searched,
        targets={"joint": SIZE.symbol * target},
        memory=memories,
    )


def derived(spec: Effect) -> ModuleType:
    """Return an effect's module as it would be generated."""
    module = ModuleType(spec.name)
    text = compiler.write_one(compiler.lower_one(compiler.derive_one(spec)))[Path("effects/remembering.py")]
    exec(compile(text, spec.name, "exec"), module.__dict__)
    return module


DAHL = Memory(z, "bristles", RATE.symbol * load * (1 - z * sp.sign(load)), sp.Integer(0))
CUBIC = Memory(z, "spring", RATE.symbol * load - z**3 - z / 10, load / 5)
FOLLOWING = Memory(z, "load, delayed", RATE.symbol * (load - z), load)


def recording(rows: int, limbs: int, seed: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return time, run and one state (N, limbs, 1) of two runs, rows of both mixed."""
    rng = np.random.default_rng(seed)
    time, run = np.cumsum(rng.uniform(0.01, 0.4, rows)), rng.integers(0, 2, rows)
    values = np.sin(time[:, None] * rng.uniform(0.5, 2.0, limbs)) + 0.3 * rng.standard_normal((rows, limbs))
    mixed = rng.permutation(rows)
    return time[mixed], run[mixed], values[mixed][:, :, None]


def solved(rate: Any, start: Any, time: np.ndarray, values: np.ndarray) -> np.ndarray:
    """Return z (N,) at the rows of one run in the order of time, from row to row by Dormand and Prince's method."""
    found = [start(values[0])]
    for a, b, first, last in zip(time, time[1:], values, values[1:], strict=False):

        def of(t: float, y: np.ndarray, a: float = a, b: float = b, f: float = first, g: float = last) -> Any:
            return rate(y, f + (g - f) * (t - a) / (b - a))

        found.append(
            solve_ivp(of, (a, b), [found[-1]], "DOP853", rtol=1e-11, atol=1e-12, max_step=(b - a) / 8).y[0, -1]
        )
    return np.array(found)


CASES = {
    "lag": (
        effect(z, FOLLOWING, varied=(RATE,)),
        (0.0, 2.8),
        lambda y, s: 2.8 * (s - y),
        lambda s: s,
    ),
    "dahl": (
        effect(z, DAHL, varied=(RATE,)),
        (0.0, 4.0),
        lambda y, s: 4.0 * s * (1 - y * np.sign(s)),
        lambda s: 0.0,
    ),
    "cubic": (
        effect(z, CUBIC, varied=(RATE,)),
        (0.0, 3.0),
        lambda y, s: 3.0 * s - y**3 - y / 10,
        lambda s: s / 5,
    ),
}


@pytest.mark.parametrize("case", CASES)
def test_a_memory_is_what_a_solver_of_differential_equations_gives(case: str) -> None:
    spec, coefficients, rate, start = CASES[case]
    time, run, states = recording(60, 2, seed=5)
    c = np.tile(coefficients, (len(time), 2, 1))
    found = memory.along(derived(spec), states, c, (), time, run)
    assert found.settled.all()
    for which in (0, 1):
        rows = np.flatnonzero(run == which)
        rows = rows[np.argsort(time[rows])]
        for limb in range(2):
            expected = solved(rate, start, time[rows], states[rows, limb, 0])
            error = np.abs(found.value[rows, limb, 0] - expected)
            assert error.max() < 1e-6
            assert (error <= found.bound[rows, limb, 0] + 1e-9).all()


def test_a_lag_of_states_that_go_straight_is_exact_however_far_apart_the_rows_are() -> None:
    module = derived(effect(Lag(load, TAU.symbol), searched=(Orders(TAU),)))
    time, tau = np.array([0.0, 3.0, 3.001, 50.0]), 0.8
    u = np.array([1.0, -2.0, 4.0, 5.0])
    found = memory.along(module, u[:, None, None], np.zeros((4, 1, 1)), (tau,), time, np.zeros(4, dtype=int))
    expected = [u[0]]
    for k in range(3):
        h, slope = time[k + 1] - time[k], (u[k + 1] - u[k]) / (time[k + 1] - time[k])
        rest = expected[-1] - (u[k] - tau * slope)
        expected.append(u[k + 1] - tau * slope + rest * np.exp(-h / tau))
    np.testing.assert_allclose(found.value[:, 0, 0], expected, rtol=1e-13, atol=1e-13)


@pytest.mark.parametrize("case", CASES)
def test_derivatives_by_the_coefficients_are_slopes(case: str) -> None:
    spec, coefficients, _, _ = CASES[case]
    module = derived(spec)
    time, run, states = recording(40, 2, seed=8)
    c = np.tile(coefficients, (len(time), 2, 1))
    at = memory.along(module, states, c, (), time, run)
    assert at.by_coefficients.shape == (40, 2, 1, 2)
    np.testing.assert_array_equal(at.by_coefficients[..., 0], 0.0)  # the size is no part of the memory
    step = np.array([0.0, 1e-5])
    up, down = (memory.along(module, states, c + sign * step, (), time, run).value for sign in (1, -1))
    np.testing.assert_allclose(at.by_coefficients[..., 1], (up - down) / 2e-5, rtol=2e-4, atol=2e-5)


def test_a_constant_may_be_searched_and_a_memory_led_into_the_target() -> None:
    spec = effect(sp.tanh(Lag(load, TAU.symbol)) * load, searched=(Orders(TAU),))
    module = derived(spec)
    assert [name for name, _ in module.MEMORY] == ["lag_1"]
    assert module.STATE == ("torque",)
    s, c = np.array([[0.4, -0.2], [1.5, 0.8]]), np.array([[2.0]])
    np.testing.assert_allclose(module.value(s, c, (0.5,))[:, 0], 2.0 * np.tanh(s[:, 1]) * s[:, 0], rtol=1e-15)
    np.testing.assert_allclose(module.jacobian(s, c, (0.5,))[:, 0, 0], np.tanh(s[:, 1]) * s[:, 0], rtol=1e-15)
    slope = 2.0 * s[:, 0] / np.cosh(s[:, 1]) ** 2
    np.testing.assert_allclose(module.by_memory(s, c, (0.5,))[:, 0, 0], slope, rtol=1e-14)


def test_where_halving_does_not_settle_it_is_said_and_bounded() -> None:
    """A rate so fast, and so bent, that no interval between two rows is short enough."""
    jumping = Memory(z, "ratchet", 1e9 * RATE.symbol * sp.cos(1e3 * z + load), sp.Integer(0))
    module = derived(effect(z, jumping, varied=(RATE,)))
    time, states = np.array([0.0, 1.0, 2.0, 3.0]), np.array([1.0, 2.0, -1.0, -2.0])[:, None, None]
    found = memory.along(module, states, np.ones((4, 1, 2)), (), time, np.zeros(4, dtype=int))
    assert not found.settled[1:].any()
    np.testing.assert_array_equal(
        found.settled[:, 0], np.nan_to_num(found.bound[:, 0, 0], nan=np.inf) <= memory.TOLERANCE
    )


def test_a_recording_of_one_row_has_the_memory_it_starts_with() -> None:
    module = derived(effect(Lag(load, TAU.symbol), searched=(Orders(TAU),)))
    found = memory.along(
        module, np.full((1, 1, 1), 3.0), np.ones((1, 1, 1)), (0.5,), np.zeros(1), np.zeros(1, dtype=int)
    )
    assert found.value.ravel().tolist() == [3.0]
    np.testing.assert_array_equal(found.by_coefficients, 0.0)


def test_memories_that_cannot_be_meant_are_refused_by_name() -> None:
    other = Memory(sp.Symbol("w", real=True), "other", -z, sp.Integer(0))
    with pytest.raises(ValueError, match="effect remembering: the rate of w reads another memory"):
        effect(z, DAHL, other, varied=(RATE,))
    with pytest.raises(ValueError, match="remembering: z starts from states and constants only"):
        effect(z, Memory(z, "z", -z, RATE.symbol), varied=(RATE,))
    with pytest.raises(ValueError, match="rate of lag_1 has no value where all coefficients are zero"):
        effect(Lag(load, TAU.symbol), varied=(TAU,))
    with pytest.raises(ValueError, match="a reading has no memory"):
        dataclasses.replace(effect(z, DAHL, varied=(RATE,)), targets={"reading.x": SIZE.symbol * z}, per_limb=False)
    with pytest.raises(ValueError, match="memory z: tan cannot be written in every target"):
        effect(z, Memory(z, "z", -sp.tan(z), sp.Integer(0)))
    with pytest.raises(ValueError, match="the memory z has no meaning"):
        Memory(z, "", -z, sp.Integer(0))


# ------------------------------------------------------------------------------------------------- on a machine


@pytest.fixture
def on_delta(monkeypatch: pytest.MonkeyPatch) -> Callable[[Effect], tuple[Body, Term]]:
    """Return what puts a machine at rows of a recording, and an effect on its joints 1 and 2."""

    def made(spec: Effect) -> tuple[Body, Term]:
        module = derived(spec)
        terms.partial.cache_clear()
        for room in ("terms", "parts"):
            monkeypatch.setattr(
                f"deltacal_gen.physics.{room}.load_effect",
                lambda name: module if name == spec.name else load_effect(name),
            )
        robot = dataclasses.replace(read_robot(example() / "robot.toml"), errors={})
        mechanism, rng, n = load_mechanism("delta"), np.random.default_rng(4), 10
        targets = np.column_stack([rng.uniform(-200, 200, (n, 2)), rng.uniform(-950, -750, n)])
        q, _, status = mechanism.inverse(targets, np.zeros((n, 3)), mechanism.rows(robot))
        assert (status == 0).all()
        values = {"time": np.cumsum(rng.uniform(0.1, 1.0, n)), "qd": rng.uniform(-0.5, 0.5, (n, 3))}
        channels = Channels(values, np.arange(n, dtype=float), np.repeat([0, 1], n // 2))
        return Body(robot, mechanism, q, np.zeros((n, 3)), channels), blank(spec.name, (1, 2), (0.05,))

    return made


(speed,) = state("qd")


def test_a_machine_follows_its_memory_and_columns_are_its_derivatives(on_delta: Any) -> None:
    memory_of_speed = Memory(z, "speed, delayed", RATE.symbol * (speed - z), speed)
    body, term = on_delta(effect(sp.tanh(z), memory_of_speed, varied=(RATE,), reads="qd"))
    values = np.array([[0.01, 0.8], [-0.02, 0.3]])
    term, errors = term.with_values(values), np.zeros(len(body.mechanism.parameters))
    machine, status = body.solve(errors, (term,))
    assert (status == 0).all()
    lag = memory.along(
        term.kernels,
        body.channels.values["qd"][:, :2, None],
        np.tile(values, (10, 1, 1)),
        (),
        body.channels.clock,
        body.channels.run,
    )
    np.testing.assert_allclose(machine.q[:, :2] - body.q[:, :2], values[:, 0] * np.tanh(lag.value[..., 0]), atol=1e-15)
    np.testing.assert_array_equal(machine.q[:, 2], body.q[:, 2])
    chosen = np.arange(10)
    sensitivity = body.mechanism.sensitivity(machine.x, machine.q, body.tool, machine.rows)
    columns = body.columns((term,), machine, sensitivity, chosen)
    for j in range(4):
        h = np.zeros(4)
        h[j] = 1e-5
        up, down = (body.solve(errors, (term.with_values(values.ravel() + s * h),))[0].x[:, :3] for s in (1, -1))
        np.testing.assert_allclose(columns[:, :3, j], (up - down) / 2e-5, rtol=1e-5, atol=1e-4)


def test_a_memory_without_time_says_what_is_missing(on_delta: Any) -> None:
    body, term = on_delta(effect(Lag(speed, TAU.symbol), searched=(Orders(TAU),), reads="qd"))
    assert body.missing(term.effect) is None
    body.channels = Channels({"qd": body.channels.values["qd"]}, body.channels.order)
    assert body.missing(term.effect) == "the column time_s"


def test_a_jump_that_leaves_no_equilibrium_is_stated_with_row_and_joint(on_delta: Any) -> None:
    """``theta = q - size sign(theta - at)``: from either side the joint is thrown to the other, in row 4 of joint 2."""
    (theta,) = state("theta")
    at = coefficient("at", "1", 1.0, "where it jumps", ANY)
    body, term = on_delta(effect(-sp.sign(theta - at.symbol), searched=(Orders(at),), reads="theta"))
    term = dataclasses.replace(term, limbs=(2,), values=np.array([[0.01]]), constants=(body.q[4, 1] + 0.004,))
    machine, status = body.solve(np.zeros(len(body.mechanism.parameters)), (term,))
    assert status.tolist() == [UNBALANCED if row == 4 else SOLVED for row in range(10)]
    assert machine.restless is not None
    assert machine.restless.tolist() == [2 if row == 4 else 0 for row in range(10)]
    assert np.isnan(machine.x[4]).all()
    recording = SimpleNamespace(path=Path("r.csv"), line=np.arange(2, 12))
    with pytest.raises(InputError, match=r"without static equilibrium.*joint 2 first") as refused:
        body.check(machine, status, np.arange(10), recording)  # type: ignore[arg-type]
    assert refused.value.line == 6


def test_rows_at_which_a_formula_divides_by_zero_are_told_and_the_others_solved(on_delta: Any) -> None:
    spec = dataclasses.replace(
        effect(speed, reads="qd"),
        targets={"joint": SIZE.symbol / speed},
        tests=(Reference({"qd": 1.0}, {"size": 0.0}, {"joint": 0.0}),),
    )
    body, term = on_delta(spec)
    still = np.where(np.arange(len(body.q))[:, None] == 4, 0.0, 1.0) * np.maximum(np.abs(body.channels.values["qd"]), 1)
    body.channels = Channels({**body.channels.values, "qd": still}, body.channels.order)
    term = dataclasses.replace(term, values=np.full_like(term.values, 1e-3))
    errors = np.zeros(len(body.mechanism.parameters))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        machine, status = body.solve(errors, (term,))
        bare, _ = body.solve(errors, ())
        lost = undefined(body, term, bare.x, bare.q, bare.rows)
    assert status.tolist() == [UNDEFINED if row == 4 else SOLVED for row in range(10)]
    assert np.isnan(machine.x[4]).all()
    assert np.isfinite(machine.x[np.arange(10) != 4]).all()
    assert np.flatnonzero(lost).tolist() == [4]
    assert lacking(term, [6]) == "a value at line 6: its formula divides by zero there, or grows beyond all bounds"


def test_rows_too_far_apart_for_a_memory_are_told(on_delta: Any) -> None:
    bristles = Memory(z, "bristles", 50.0 * speed * (1 - z * sp.sign(speed)), sp.Integer(0))
    body, term = on_delta(effect(z, bristles, reads="qd"))
    turning = np.where(np.arange(len(body.q))[:, None] % 2, 1.0, -1.0) * np.ones_like(body.q)
    channels = {**body.channels.values, "qd": turning, "time": 1e4 * np.arange(len(body.q), dtype=float)}
    body.channels = Channels(channels, body.channels.order)
    errors = np.zeros(len(body.mechanism.parameters))
    bare, _ = body.solve(errors, ())
    lost = undefined(body, term, bare.x, bare.q, bare.rows)
    assert lost.any()
    assert not lost[0]
    _, status = body.solve(errors, (dataclasses.replace(term, values=np.full_like(term.values, 1e-3)),))
    assert (status == np.where(lost, UNDEFINED, SOLVED)).all()
    assert "rows closer in time: what it remembers cannot be followed to line 3 and 1 more" in lacking(term, [3, 4])

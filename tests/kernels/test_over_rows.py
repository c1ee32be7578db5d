"""Functions over rows are one mathematics in two texts: NumPy's, and loops that Numba compiles."""

import importlib
import inspect
import pkgutil

import deltacal_kernels
import numpy as np
import pytest

from deltacal_gen.machine.backend import PAYS_FROM, RowFunctions

FOUND = [m.name for m in pkgutil.walk_packages(deltacal_kernels.__path__, "deltacal_kernels.")]
COMPILED = [name for name in FOUND if ".compiled." in name]
EVERY = 6  # of them is tried where each costs its compiler's time
MANY = PAYS_FROM["call"]
WIDTH = 40  # columns of what is drawn: no function reads as many


def _drawn(function, rows, rng):
    """Return arguments of a function over rows; lengths and masses are positive."""
    given = []
    for name in inspect.signature(function).parameters:
        if name == "constants":
            given.append(tuple(rng.uniform(0.5, 2.0, size=6)))
        elif name == "masses":
            given.append(rng.uniform(0.5, 2.0, size=WIDTH))
        elif name in ("q", "payload", "h"):
            given.append(rng.uniform(0.1, 1.0, size=rows))
        else:
            given.append(rng.uniform(-1.0, 1.0, size=(rows, WIDTH)))
    return given


@pytest.mark.parametrize(
    "name",
    [pytest.param(name, marks=[pytest.mark.thorough] if n % EVERY else []) for n, name in enumerate(COMPILED)],
)
def test_numba_computes_what_numpy_does(name):
    plain, compiled = importlib.import_module(name.replace(".compiled", "")), importlib.import_module(name)
    for function in plain.OVER_ROWS:
        given = _drawn(getattr(plain, function), 30, np.random.default_rng(3))
        with np.errstate(all="ignore"):  # of numbers drawn without a sense
            expected = getattr(plain, function)(*given)
        found = getattr(compiled, function)(*(np.ascontiguousarray(values) for values in given))
        np.testing.assert_allclose(found, expected, rtol=1e-9, atol=1e-12, err_msg=function)


def test_every_effect_every_measurement_and_all_statics_are_compiled():
    families = [name for name in FOUND if name.rpartition(".")[0].endswith((".effects", ".measurements"))]
    rows = [name for name in families if hasattr(importlib.import_module(name), "OVER_ROWS")]
    rows += [name for name in FOUND if name.endswith(".statics") and ".compiled." not in name]
    assert {name.replace(".compiled", "") for name in COMPILED} == set(rows)
    assert len(rows) > 50


def test_many_rows_are_done_by_numba_and_few_by_numpy(monkeypatch):
    kernels = RowFunctions("effects.backlash")
    asked = []
    monkeypatch.setitem(
        vars(kernels), "_compiled", _Noted(importlib.import_module("deltacal_kernels.effects.compiled.backlash"), asked)
    )
    c, rng = np.full((1, 1), 0.2), np.random.default_rng(1)
    few, many = rng.uniform(-1, 1, (MANY - 1, 1)), rng.uniform(-1, 1, (2 * MANY, 2))[:, :1]
    np.testing.assert_allclose(kernels.value(few, c), -0.1 * few)
    assert not asked
    np.testing.assert_allclose(kernels.value(many, c, ("temp_motor_C",)), -0.1 * many)
    assert asked == ["value"]


class _Noted:
    """A module that notes what it is asked for."""

    def __init__(self, module, asked):
        self._module, self._asked = module, asked

    def __getattr__(self, name):
        self._asked.append(name)
        return getattr(self._module, name)

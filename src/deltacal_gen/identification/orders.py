"""All orders of the periodic errors of joints at once: random functions beside geometry and instrument.

The error of a joint is a function of its angle with a Gaussian prior. Before any readings its orders are independent,
with Matérn's spectrum (Rasmussen and Williams 2006, section 4.2.1): even up to a corner, and falling with the fourth
power beyond. What another session knew of it is a prior, too, which holds the function where that session read it.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import NamedTuple

import numpy as np

from deltacal_gen.identification.functions import Function, Linear, Sized
from deltacal_gen.inference.functions import waves
from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.terms import Term, effect_names, load_effect

ORDERS = 100  # integer orders of a periodic error that are searched


@cache
def wave() -> str:
    """Return the name of the effect that is a wave of the joint's turn; "" where none is registered."""
    return next((name for name in effect_names() if load_effect(name).PERIODIC), "")


def as_terms(errors: Mapping[int, Array]) -> tuple[Term, ...]:
    """Return the errors of joints, coefficients (2 orders,) [rad] of each, as effects: one per order, from 1."""
    each = np.stack([values.reshape(ORDERS, 2) for values in errors.values()], axis=1)
    return tuple(Term(wave(), tuple(errors), each[k - 1], (float(k),)) for k in range(1, ORDERS + 1))


class Coefficients(NamedTuple):
    """The error of a joint: cosine and sine of each order (2 orders,) [rad], and their covariance [rad2].

    `rms` and `std` are those of the error and of its standard deviation over the readings [rad], but for a constant.
    """

    values: Array
    covariance: Array
    rms: float
    std: float


def all_orders(q: Array, joint: int, root: Array | None = None) -> Function:
    """Return all orders of the error of a joint (from 1), of joints (N, n_q) [rad].

    `root` (2 orders, 2 orders) is L where coefficients are L c; without it they are c.
    """
    each = waves(q[:, joint - 1], ORDERS)
    return Function(each if root is None else each @ root, (joint - 1,))


def solved(linear: Linear, found: Sized, rows: np.ndarray) -> tuple[list[Coefficients], Array]:
    """Return the coefficients of each joint, and the covariance of what is fitted beside them [mm, rad].

    Parameters
    ----------
    rows : (R,) int array
        That were read.
    """
    n, step, covariance = linear.n, linear.step(found), linear.covariance(found)
    out, places = [], found.functions.parted(np.arange(n, len(step)))
    for function, own in zip(found.functions.each, places, strict=True):
        F, c, C = function.values[rows], step[own], covariance[np.ix_(own, own)]
        some = F - F.mean(axis=0)  # a constant is the joint's zero
        std = float(np.sqrt(np.mean(((some @ C) * some).sum(axis=1))))
        out.append(Coefficients(c, C, float(np.std(F @ c)), std))
    return out, covariance[:n, :n]

"""Generalised loads of `simplified_parallelogram`: Planar parallelogram, simplified: one virtual rod.

Generated from derive/mechanisms/simplified_parallelogram.py by "deltacal kernels". Do not edit.
Template templates/mechanism/statics.py.jinja; sha256 of both c59e3e405ee39126; SymPy 1.14.0.

Plain NumPy over all poses at once. masses: ; payload (N,) in kg at the
reference point. Every weight has its own acceleration field [m/s^2]: gravity for all, or minus its own acceleration.
Loads in N (along lengths) and N mm (along angles).
"""

import numpy as np

LIMB_WEIGHTS = 0
PLATFORM_WEIGHTS = 0


def _limb(x, q, tool, p, masses, fields):
    """Generalised loads of the weights of one limb and their moment: (N, 7)."""
    out = np.zeros((len(x), 7))
    return out


def _limb_points(x, q, tool, p, masses):
    """Where the weights of one limb are: (N, 0)."""
    out = np.zeros((len(x), 0))
    return out


def _platform(x, tool, masses, payload, fields):
    """Generalised loads of the weights of one platform and their moment: (N, 6)."""
    out = np.zeros((len(x), 6))
    return out


def _platform_points(x, tool, masses, payload):
    """Where the weights of one platform are: (N, 0)."""
    out = np.zeros((len(x), 0))
    return out


def points(x, q, tool, p, masses, payload):
    """Return where the weights are, (N, 0, 3): limb by limb, then the platform's."""
    parts = [_limb_points(x, q[:, i], tool, p[:, i], masses) for i in range(1)]
    return np.hstack([*parts, _platform_points(x, tool, masses, payload)]).reshape(len(x), -1, 3)


def loads(x, q, tool, p, masses, payload, fields):
    """Return generalised loads W_q (N, 1) on the joints, W_x (N, 3) on the platform, and the moment about {O} (N, 3).

    fields (N, weights, 3): in the order of `points`.
    """
    flat = fields.reshape(len(x), -1)
    W_q = np.zeros((len(x), 1))
    rest = _platform(x, tool, masses, payload, flat[:, 0:])
    for i in range(1):
        own = _limb(x, q[:, i], tool, p[:, i], masses, flat[:, 0 * i :])
        W_q[:, i] = own[:, 0]
        rest += own[:, 1:]
    return W_q, rest[:, :3], rest[:, 3:]

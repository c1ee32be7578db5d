"""Poses side by side: `diamond`, Diamond, two arms in a plane.

Generated from derive/mechanisms/diamond.py by "deltacal kernels". Do not edit.
Template templates/mechanism/blocks.py.jinja; sha256 of both f8f5106fbf27c9ae; SymPy 1.14.0.

The other modules of many poses take them in blocks, and compute with lane arrays, one number a pose, which all lie in
one array w: first a region for every limb, then what the limbs share. Here a block of what is given is put there.
"""

from deltacal_kernels.straight import straight

LANES = 32  # poses of a block
WORK = 2208  # numbers that a block computes with
SPARE = 256  # and that the last of its poses are written to


@straight
def load(q, w, first, last, n):
    """Put joints of poses side by side, the last one again for the rest of `n`."""
    for lane in range(n):
        m = min(first + lane, last)
        w[0 + lane] = q[2 * m + 0]
        w[896 + lane] = q[2 * m + 1]


@straight
def hold(tool, w, first, last, n):
    """Put tools of poses side by side, like `load`."""
    for lane in range(n):
        m = min(first + lane, last)
        at = tool[3 * m + 0]
        w[32 + lane] = at
        w[928 + lane] = at
        at = tool[3 * m + 1]
        w[64 + lane] = at
        w[960 + lane] = at
        at = tool[3 * m + 2]
        w[96 + lane] = at
        w[992 + lane] = at


@straight
def aim(w, n):
    """Put targets, which were loaded as joints, where the limbs read the platform."""
    for lane in range(n):
        at = w[0 + lane]
        w[128 + lane] = at
        w[1024 + lane] = at
        at = w[896 + lane]
        w[160 + lane] = at
        w[1056 + lane] = at

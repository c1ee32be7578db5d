"""Poses side by side: `linear_delta`, Linear delta, three towers and six rods.

Generated from derive/mechanisms/linear_delta.py by "deltacal kernels". Do not edit.
Template templates/mechanism/blocks.py.jinja; sha256 of both c6c40488ceda5e33; SymPy 1.14.0.

The other modules of many poses take them in blocks, and compute with lane arrays, one number a pose, which all lie in
one array w: first a region for every limb, then what the limbs share. Here a block of what is given is put there.
"""

from deltacal_kernels.straight import straight

LANES = 32  # poses of a block
WORK = 8160  # numbers that a block computes with
SPARE = 1440  # and that the last of its poses are written to


@straight
def load(q, w, first, last, n):
    """Put joints of poses side by side, the last one again for the rest of `n`."""
    for lane in range(n):
        m = min(first + lane, last)
        w[0 + lane] = q[3 * m + 0]
        w[2112 + lane] = q[3 * m + 1]
        w[4224 + lane] = q[3 * m + 2]


@straight
def hold(tool, w, first, last, n):
    """Put tools of poses side by side, like `load`."""
    for lane in range(n):
        m = min(first + lane, last)
        at = tool[3 * m + 0]
        w[32 + lane] = at
        w[2144 + lane] = at
        w[4256 + lane] = at
        at = tool[3 * m + 1]
        w[64 + lane] = at
        w[2176 + lane] = at
        w[4288 + lane] = at
        at = tool[3 * m + 2]
        w[96 + lane] = at
        w[2208 + lane] = at
        w[4320 + lane] = at


@straight
def aim(w, n):
    """Put targets, which were loaded as joints, where the limbs read the platform."""
    for lane in range(n):
        at = w[0 + lane]
        w[128 + lane] = at
        w[2240 + lane] = at
        w[4352 + lane] = at
        at = w[2112 + lane]
        w[160 + lane] = at
        w[2272 + lane] = at
        w[4384 + lane] = at
        at = w[4224 + lane]
        w[192 + lane] = at
        w[2304 + lane] = at
        w[4416 + lane] = at

"""Poses side by side: `delta`, Delta, three arms and six rods.

Generated from derive/mechanisms/delta.py by "deltacal kernels". Do not edit.
Template templates/mechanism/blocks.py.jinja; sha256 of both 753f05cf317e5b1b; SymPy 1.14.0.

The other modules of many poses take them in blocks, and compute with lane arrays, one number a pose, which all lie in
one array w: first a region for every limb, then what the limbs share. Here a block of what is given is put there.
"""

from deltacal_kernels.straight import straight

LANES = 32  # poses of a block
WORK = 10848  # numbers that a block computes with
SPARE = 2304  # and that the last of its poses are written to


@straight
def load(q, w, first, last, n):
    """Put joints of poses side by side, the last one again for the rest of `n`."""
    for lane in range(n):
        m = min(first + lane, last)
        w[0 + lane] = q[3 * m + 0]
        w[3008 + lane] = q[3 * m + 1]
        w[6016 + lane] = q[3 * m + 2]


@straight
def hold(tool, w, first, last, n):
    """Put tools of poses side by side, like `load`."""
    for lane in range(n):
        m = min(first + lane, last)
        at = tool[3 * m + 0]
        w[32 + lane] = at
        w[3040 + lane] = at
        w[6048 + lane] = at
        at = tool[3 * m + 1]
        w[64 + lane] = at
        w[3072 + lane] = at
        w[6080 + lane] = at
        at = tool[3 * m + 2]
        w[96 + lane] = at
        w[3104 + lane] = at
        w[6112 + lane] = at


@straight
def aim(w, n):
    """Put targets, which were loaded as joints, where the limbs read the platform."""
    for lane in range(n):
        at = w[0 + lane]
        w[128 + lane] = at
        w[3136 + lane] = at
        w[6144 + lane] = at
        at = w[3008 + lane]
        w[160 + lane] = at
        w[3168 + lane] = at
        w[6176 + lane] = at
        at = w[6016 + lane]
        w[192 + lane] = at
        w[3200 + lane] = at
        w[6208 + lane] = at

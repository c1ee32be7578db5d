"""Poses side by side: `complete_delta`, Delta, complete geometry of the six rods.

Generated from derive/mechanisms/complete_delta.py by "deltacal kernels". Do not edit.
Template templates/mechanism/blocks.py.jinja; sha256 of both 0cdfbe293666cb26; SymPy 1.14.0.

The other modules of many poses take them in blocks, and compute with lane arrays, one number a pose, which all lie in
one array w: first a region for every limb, then what the limbs share. Here a block of what is given is put there.
"""

from deltacal_kernels.straight import straight

LANES = 32  # poses of a block
WORK = 11808  # numbers that a block computes with
SPARE = 2736  # and that the last of its poses are written to


@straight
def load(q, w, first, last, n):
    """Put joints of poses side by side, the last one again for the rest of `n`."""
    for lane in range(n):
        m = min(first + lane, last)
        w[0 + lane] = q[3 * m + 0]
        w[3328 + lane] = q[3 * m + 1]
        w[6656 + lane] = q[3 * m + 2]


@straight
def hold(tool, w, first, last, n):
    """Put tools of poses side by side, like `load`."""
    for lane in range(n):
        m = min(first + lane, last)
        at = tool[3 * m + 0]
        w[32 + lane] = at
        w[3360 + lane] = at
        w[6688 + lane] = at
        at = tool[3 * m + 1]
        w[64 + lane] = at
        w[3392 + lane] = at
        w[6720 + lane] = at
        at = tool[3 * m + 2]
        w[96 + lane] = at
        w[3424 + lane] = at
        w[6752 + lane] = at


@straight
def aim(w, n):
    """Put targets, which were loaded as joints, where the limbs read the platform."""
    for lane in range(n):
        at = w[0 + lane]
        w[128 + lane] = at
        w[3456 + lane] = at
        w[6784 + lane] = at
        at = w[3328 + lane]
        w[160 + lane] = at
        w[3488 + lane] = at
        w[6816 + lane] = at
        at = w[6656 + lane]
        w[192 + lane] = at
        w[3520 + lane] = at
        w[6848 + lane] = at

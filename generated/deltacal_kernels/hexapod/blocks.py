"""Poses side by side: `hexapod`, Hexapod of Gough and Stewart, six legs.

Generated from derive/mechanisms/hexapod.py by "deltacal kernels". Do not edit.
Template templates/mechanism/blocks.py.jinja; sha256 of both d96b8a8038a84c08; SymPy 1.14.0.

The other modules of many poses take them in blocks, and compute with lane arrays, one number a pose, which all lie in
one array w: first a region for every limb, then what the limbs share. Here a block of what is given is put there.
"""

from deltacal_kernels.straight import straight

LANES = 32  # poses of a block
WORK = 11872  # numbers that a block computes with
SPARE = 3168  # and that the last of its poses are written to


@straight
def load(q, w, first, last, n):
    """Put joints of poses side by side, the last one again for the rest of `n`."""
    for lane in range(n):
        m = min(first + lane, last)
        w[0 + lane] = q[6 * m + 0]
        w[1664 + lane] = q[6 * m + 1]
        w[3328 + lane] = q[6 * m + 2]
        w[4992 + lane] = q[6 * m + 3]
        w[6656 + lane] = q[6 * m + 4]
        w[8320 + lane] = q[6 * m + 5]


@straight
def hold(tool, w, first, last, n):
    """Put tools of poses side by side, like `load`."""
    for lane in range(n):
        m = min(first + lane, last)
        at = tool[3 * m + 0]
        w[32 + lane] = at
        w[1696 + lane] = at
        w[3360 + lane] = at
        w[5024 + lane] = at
        w[6688 + lane] = at
        w[8352 + lane] = at
        at = tool[3 * m + 1]
        w[64 + lane] = at
        w[1728 + lane] = at
        w[3392 + lane] = at
        w[5056 + lane] = at
        w[6720 + lane] = at
        w[8384 + lane] = at
        at = tool[3 * m + 2]
        w[96 + lane] = at
        w[1760 + lane] = at
        w[3424 + lane] = at
        w[5088 + lane] = at
        w[6752 + lane] = at
        w[8416 + lane] = at


@straight
def aim(w, n):
    """Put targets, which were loaded as joints, where the limbs read the platform."""
    for lane in range(n):
        at = w[0 + lane]
        w[128 + lane] = at
        w[1792 + lane] = at
        w[3456 + lane] = at
        w[5120 + lane] = at
        w[6784 + lane] = at
        w[8448 + lane] = at
        at = w[1664 + lane]
        w[160 + lane] = at
        w[1824 + lane] = at
        w[3488 + lane] = at
        w[5152 + lane] = at
        w[6816 + lane] = at
        w[8480 + lane] = at
        at = w[3328 + lane]
        w[192 + lane] = at
        w[1856 + lane] = at
        w[3520 + lane] = at
        w[5184 + lane] = at
        w[6848 + lane] = at
        w[8512 + lane] = at
        at = w[4992 + lane]
        w[224 + lane] = at
        w[1888 + lane] = at
        w[3552 + lane] = at
        w[5216 + lane] = at
        w[6880 + lane] = at
        w[8544 + lane] = at
        at = w[6656 + lane]
        w[256 + lane] = at
        w[1920 + lane] = at
        w[3584 + lane] = at
        w[5248 + lane] = at
        w[6912 + lane] = at
        w[8576 + lane] = at
        at = w[8320 + lane]
        w[288 + lane] = at
        w[1952 + lane] = at
        w[3616 + lane] = at
        w[5280 + lane] = at
        w[6944 + lane] = at
        w[8608 + lane] = at

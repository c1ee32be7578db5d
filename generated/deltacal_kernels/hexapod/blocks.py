"""Poses side by side: `hexapod`, Hexapod of Gough and Stewart, six legs.

Generated from derive/mechanisms/hexapod.py by "deltacal kernels". Do not edit.
Template templates/mechanism/blocks.py.jinja; sha256 of both ba6845f42f6f6176; SymPy 1.14.0.

The other modules of many poses take them in blocks, and compute with lane arrays, one number a pose, which all lie in
one array w: first a region for every limb, then what the limbs share. Here a block of what is given is put there.
"""

from deltacal_kernels.straight import straight

LANES = 32  # poses of a block
WORK = 11296  # numbers that a block computes with
SPARE = 2304  # and that the last of its poses are written to


@straight
def load(q, w, first, last, n):
    """Put joints of poses side by side, the last one again for the rest of `n`."""
    for lane in range(n):
        m = min(first + lane, last)
        w[0 + lane] = q[6 * m + 0]
        w[1568 + lane] = q[6 * m + 1]
        w[3136 + lane] = q[6 * m + 2]
        w[4704 + lane] = q[6 * m + 3]
        w[6272 + lane] = q[6 * m + 4]
        w[7840 + lane] = q[6 * m + 5]


@straight
def hold(tool, w, first, last, n):
    """Put tools of poses side by side, like `load`."""
    for lane in range(n):
        m = min(first + lane, last)
        at = tool[3 * m + 0]
        w[32 + lane] = at
        w[1600 + lane] = at
        w[3168 + lane] = at
        w[4736 + lane] = at
        w[6304 + lane] = at
        w[7872 + lane] = at
        at = tool[3 * m + 1]
        w[64 + lane] = at
        w[1632 + lane] = at
        w[3200 + lane] = at
        w[4768 + lane] = at
        w[6336 + lane] = at
        w[7904 + lane] = at
        at = tool[3 * m + 2]
        w[96 + lane] = at
        w[1664 + lane] = at
        w[3232 + lane] = at
        w[4800 + lane] = at
        w[6368 + lane] = at
        w[7936 + lane] = at


@straight
def aim(w, n):
    """Put targets, which were loaded as joints, where the limbs read the platform."""
    for lane in range(n):
        at = w[0 + lane]
        w[128 + lane] = at
        w[1696 + lane] = at
        w[3264 + lane] = at
        w[4832 + lane] = at
        w[6400 + lane] = at
        w[7968 + lane] = at
        at = w[1568 + lane]
        w[160 + lane] = at
        w[1728 + lane] = at
        w[3296 + lane] = at
        w[4864 + lane] = at
        w[6432 + lane] = at
        w[8000 + lane] = at
        at = w[3136 + lane]
        w[192 + lane] = at
        w[1760 + lane] = at
        w[3328 + lane] = at
        w[4896 + lane] = at
        w[6464 + lane] = at
        w[8032 + lane] = at
        at = w[4704 + lane]
        w[224 + lane] = at
        w[1792 + lane] = at
        w[3360 + lane] = at
        w[4928 + lane] = at
        w[6496 + lane] = at
        w[8064 + lane] = at
        at = w[6272 + lane]
        w[256 + lane] = at
        w[1824 + lane] = at
        w[3392 + lane] = at
        w[4960 + lane] = at
        w[6528 + lane] = at
        w[8096 + lane] = at
        at = w[7840 + lane]
        w[288 + lane] = at
        w[1856 + lane] = at
        w[3424 + lane] = at
        w[4992 + lane] = at
        w[6560 + lane] = at
        w[8128 + lane] = at

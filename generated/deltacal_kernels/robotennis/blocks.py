"""Poses side by side: `robotennis`, RoboTennis, three arms with rods as single links, incremental home.

Generated from derive/mechanisms/robotennis.py by "deltacal kernels". Do not edit.
Template templates/mechanism/blocks.py.jinja; sha256 of both e2c18b3be720666b; SymPy 1.14.0.

The other modules of many poses take them in blocks, and compute with lane arrays, one number a pose, which all lie in
one array w: first a region for every limb, then what the limbs share. Here a block of what is given is put there.
"""

from deltacal_kernels.straight import straight

LANES = 32  # poses of a block
WORK = 4320  # numbers that a block computes with
SPARE = 792  # and that the last of its poses are written to


@straight
def load(q, w, first, last, n):
    """Put joints of poses side by side, the last one again for the rest of `n`."""
    for lane in range(n):
        m = min(first + lane, last)
        w[0 + lane] = q[3 * m + 0]
        w[1216 + lane] = q[3 * m + 1]
        w[2432 + lane] = q[3 * m + 2]


@straight
def hold(tool, w, first, last, n):
    """Put tools of poses side by side, like `load`."""
    for lane in range(n):
        m = min(first + lane, last)
        at = tool[3 * m + 0]
        w[32 + lane] = at
        w[1248 + lane] = at
        w[2464 + lane] = at
        at = tool[3 * m + 1]
        w[64 + lane] = at
        w[1280 + lane] = at
        w[2496 + lane] = at
        at = tool[3 * m + 2]
        w[96 + lane] = at
        w[1312 + lane] = at
        w[2528 + lane] = at


@straight
def aim(w, n):
    """Put targets, which were loaded as joints, where the limbs read the platform."""
    for lane in range(n):
        at = w[0 + lane]
        w[128 + lane] = at
        w[1344 + lane] = at
        w[2560 + lane] = at
        at = w[1216 + lane]
        w[160 + lane] = at
        w[1376 + lane] = at
        w[2592 + lane] = at
        at = w[2432 + lane]
        w[192 + lane] = at
        w[1408 + lane] = at
        w[2624 + lane] = at

"""Kinematics of `simplified_parallelogram`, many poses at once: Planar parallelogram, simplified: one virtual rod.

Generated from derive/mechanisms/simplified_parallelogram.py by "deltacal kernels". Do not edit.
Template templates/mechanism/kinematics.py.jinja; sha256 of both 15abcabf08d1e5e2; SymPy 1.14.0.

Arrays are C-contiguous float64, the pose first, lengths in mm, angles in rad:

x (N, 3)  platform: px py cz
q (N, 1)  joints        tool (N or 1, 3)  reference point in {O'}
p (M, 1, 11)  one row of parameters per limb: a1x a2x a2y b1x b2x b2y l1 l2 h q0 l1
k (M, 1, 6)  what `constants` makes of p; each of the M machines has N / M of the poses, one after the other

Poses are taken in blocks of up to 32, side by side: a loop over `lane` runs over the poses of a block. What is
poorly conditioned or converges slowly is left to the plain kernels of ``vectorised.py``. `status` says what became of
each pose.
"""

import math

import numpy as np

from deltacal_kernels.cache import kernel
from deltacal_kernels.elementary import arcsine, arctangent, cosine, outer, scratch, sine, tangent, wide
from deltacal_kernels.poses import as_coordinates, as_poses
from deltacal_kernels.straight import straight

from . import vectorised
from .blocks import LANES, SPARE, WORK, aim, hold, load
from .constants import constants
from .vectorised import SINGULAR, SOLVED, UNREACHABLE, jacobians

OPEN = -1  # a pose that is left to the plain kernels
MAX_STEPS = 8
STEP_DONE = 1e-6  # mm; Newton is quadratic: after such a step a length of 1000 mm is exact to 1e-15 mm
TURN_DONE = 3e-8  # rad
CLEAR = 10.0  # mm off the plane of the limbs' centres: nearer, the closed form loses digits
APART = 1e-3  # squared sine between the centres' directions
SIMPLIFIED = 3  # coordinates that `simplified_forward` gives: the others are zero
fast = kernel(nogil=True, error_model="numpy", fastmath={"contract"})


@straight
def _early(w, k, n):
    """What moves with a joint only; then platform of the simplified machine at a given joint (11 operations)."""
    q0 = k[0]
    s1 = k[1]
    A_x = k[2]
    h = k[3]
    for lane in range(n):
        q = w[0 + lane]
        tx = w[32 + lane]
        ty = w[64 + lane]
        s2 = q + q0
        r_x = s1*sine(s2)
        r_y = -s1*cosine(s2)
        B_x = A_x + r_x
        s24 = A_x + r_x + tx
        s25 = -h + r_y + ty
        w[704 + lane] = B_x
        w[736 + lane] = r_y
        w[768 + lane] = s24
        w[800 + lane] = s25
        w[832 + lane] = 0


@straight
def _rows(w, k, n):
    """Equations of a limb, their derivatives by shift and turn of the platform (8 operations)."""
    h = k[3]
    for lane in range(n):
        tx = w[32 + lane]
        ty = w[64 + lane]
        px = w[128 + lane]
        py = w[160 + lane]
        cz = w[192 + lane]
        B_x = w[704 + lane]
        r_y = w[736 + lane]
        C_x = px - tx
        C_y = h + py - ty
        s10 = -B_x + C_x
        s11 = C_y - r_y
        s28 = 0.25*(cz * cz) + 1
        w[224 + lane] = s10
        w[256 + lane] = 1
        w[288 + lane] = 0
        w[320 + lane] = 0
        w[384 + lane] = s11
        w[416 + lane] = 0
        w[448 + lane] = 1
        w[480 + lane] = 0
        w[544 + lane] = cz
        w[576 + lane] = 0
        w[608 + lane] = 0
        w[640 + lane] = s28


@straight
def _step(w, n):
    """Newton's step of the platform; how far the equations are from dependent (77 operations)."""
    for lane in range(n):
        F00 = w[224 + lane]
        J00_0 = w[256 + lane]
        J00_1 = w[288 + lane]
        J00_2 = w[320 + lane]
        F01 = w[384 + lane]
        J01_0 = w[416 + lane]
        J01_1 = w[448 + lane]
        J01_2 = w[480 + lane]
        F02 = w[544 + lane]
        J02_0 = w[576 + lane]
        J02_1 = w[608 + lane]
        J02_2 = w[640 + lane]
        G_cof_00 = J01_1*J02_2 - J01_2*J02_1
        G_cof_01 = -J01_0*J02_2 + J01_2*J02_0
        G_cof_02 = J01_0*J02_1 - J01_1*J02_0
        G_cof_10 = -J00_1*J02_2 + J00_2*J02_1
        G_cof_11 = J00_0*J02_2 - J00_2*J02_0
        G_cof_12 = -J00_0*J02_1 + J00_1*J02_0
        G_cof_20 = J00_1*J01_2 - J00_2*J01_1
        G_cof_21 = -J00_0*J01_2 + J00_2*J01_0
        G_cof_22 = J00_0*J01_1 - J00_1*J01_0
        G_det_00 = G_cof_00*J00_0 + G_cof_01*J00_1 + G_cof_02*J00_2
        G_by_00 = (1.0 / G_det_00)
        G_inv_00 = G_by_00*G_cof_00
        G_inv_01 = G_by_00*G_cof_10
        G_inv_02 = G_by_00*G_cof_20
        G_inv_10 = G_by_00*G_cof_01
        G_inv_11 = G_by_00*G_cof_11
        G_inv_12 = G_by_00*G_cof_21
        G_inv_20 = G_by_00*G_cof_02
        G_inv_21 = G_by_00*G_cof_12
        G_inv_22 = G_by_00*G_cof_22
        u_00 = F00*G_inv_00 + F01*G_inv_01 + F02*G_inv_02
        u_10 = F00*G_inv_10 + F01*G_inv_11 + F02*G_inv_12
        u_20 = F00*G_inv_20 + F01*G_inv_21 + F02*G_inv_22
        s61 = (J01_0 * J01_0) + (J01_1 * J01_1) + (J01_2 * J01_2)
        s65 = (J02_0 * J02_0) + (J02_1 * J02_1) + (J02_2 * J02_2)
        s67 = (G_det_00 * G_det_00) - 1.0e-12*s61*s65*((J00_0 * J00_0) + (J00_1 * J00_1) + (J00_2 * J00_2))
        w[1248 + lane] = u_00
        w[1280 + lane] = u_10
        w[1312 + lane] = u_20
        w[1344 + lane] = s67


@straight
def _start(w, k, n):
    """Joint of the simplified limb at a given position (13 operations)."""
    q0 = k[0]
    s1 = k[1]
    A_x = k[2]
    h = k[3]
    s12 = k[4]
    s17 = k[5]
    for lane in range(n):
        tx = w[32 + lane]
        ty = w[64 + lane]
        px = w[128 + lane]
        s13 = -A_x + px - tx
        s16 = -q0 + arcsine(s12*s13)
        s23 = -h - s1*math.sqrt(-(s13 * s13)*s17 + 1) + ty
        w[864 + lane] = s16
        w[896 + lane] = s23
        w[928 + lane] = 0


@straight
def _more(w, k, n):
    """What else derivatives by joint and errors read of it (4 operations)."""
    q0 = k[0]
    s1 = k[1]
    for lane in range(n):
        q = w[0 + lane]
        s2 = q + q0
        s3 = sine(s2)
        r_x = s1*s3
        s5 = cosine(s2)
        w[960 + lane] = r_x
        w[992 + lane] = s3
        w[1024 + lane] = s5


@straight
def _joints(w, k, n):
    """Derivatives of a limb's equations by its joint (1 operations)."""
    for lane in range(n):
        r_y = w[736 + lane]
        r_x = w[960 + lane]
        w[352 + lane] = r_y
        w[512 + lane] = -r_x
        w[672 + lane] = 0


@straight
def _command(w, n):
    """Newton's step of joints and rotation; how far the equations are from dependent (71 operations)."""
    for lane in range(n):
        F00 = w[224 + lane]
        J00_1 = w[288 + lane]
        J00_2 = w[320 + lane]
        Q00 = w[352 + lane]
        F01 = w[384 + lane]
        J01_1 = w[448 + lane]
        J01_2 = w[480 + lane]
        Q01 = w[512 + lane]
        F02 = w[544 + lane]
        J02_1 = w[608 + lane]
        J02_2 = w[640 + lane]
        Q02 = w[672 + lane]
        A_cof_00 = J01_1*J02_2 - J01_2*J02_1
        A_cof_01 = J01_2*Q02 - J02_2*Q01
        A_cof_02 = -J01_1*Q02 + J02_1*Q01
        A_cof_10 = -J00_1*J02_2 + J00_2*J02_1
        A_cof_11 = -J00_2*Q02 + J02_2*Q00
        A_cof_12 = J00_1*Q02 - J02_1*Q00
        A_cof_20 = J00_1*J01_2 - J00_2*J01_1
        A_cof_21 = J00_2*Q01 - J01_2*Q00
        A_cof_22 = -J00_1*Q01 + J01_1*Q00
        A_det_00 = A_cof_00*Q00 + A_cof_01*J00_1 + A_cof_02*J00_2
        A_by_00 = (1.0 / A_det_00)
        s36 = A_by_00*(A_cof_00*F00 + A_cof_10*F01 + A_cof_20*F02)
        s41 = A_by_00*(A_cof_01*F00 + A_cof_11*F01 + A_cof_21*F02)
        s46 = A_by_00*(A_cof_02*F00 + A_cof_12*F01 + A_cof_22*F02)
        s55 = (J01_1 * J01_1) + (J01_2 * J01_2) + (Q01 * Q01)
        s59 = (J02_1 * J02_1) + (J02_2 * J02_2) + (Q02 * Q02)
        s61 = (A_det_00 * A_det_00) - 1.0e-12*s55*s59*((J00_1 * J00_1) + (J00_2 * J00_2) + (Q00 * Q00))
        w[1728 + lane] = s36
        w[1760 + lane] = s41
        w[1792 + lane] = s46
        w[1824 + lane] = s61


@straight
def _errors(w, k, n):
    """Derivatives of a limb's equations by errors, by deflections (2 operations)."""
    for lane in range(n):
        r_y = w[736 + lane]
        r_x = w[960 + lane]
        s3 = w[992 + lane]
        s5 = w[1024 + lane]
        w[1056 + lane] = r_y
        w[1088 + lane] = -s3
        w[1120 + lane] = -r_x
        w[1152 + lane] = s5
        w[1184 + lane] = 0
        w[1216 + lane] = 0


@straight
def _inverse_of_rows(w, n):
    """Minus the inverse of the derivatives, row by row; how far the equations are from dependent (71 operations)."""
    for lane in range(n):
        J00_0 = w[256 + lane]
        J00_1 = w[288 + lane]
        J00_2 = w[320 + lane]
        J01_0 = w[416 + lane]
        J01_1 = w[448 + lane]
        J01_2 = w[480 + lane]
        J02_0 = w[576 + lane]
        J02_1 = w[608 + lane]
        J02_2 = w[640 + lane]
        G_cof_00 = J01_1*J02_2 - J01_2*J02_1
        G_cof_01 = -J01_0*J02_2 + J01_2*J02_0
        G_cof_02 = J01_0*J02_1 - J01_1*J02_0
        G_cof_10 = -J00_1*J02_2 + J00_2*J02_1
        G_cof_11 = J00_0*J02_2 - J00_2*J02_0
        G_cof_12 = -J00_0*J02_1 + J00_1*J02_0
        G_cof_20 = J00_1*J01_2 - J00_2*J01_1
        G_cof_21 = -J00_0*J01_2 + J00_2*J01_0
        G_cof_22 = J00_0*J01_1 - J00_1*J01_0
        G_det_00 = G_cof_00*J00_0 + G_cof_01*J00_1 + G_cof_02*J00_2
        G_by_00 = (1.0 / G_det_00)
        G_inv_00 = G_by_00*G_cof_00
        G_inv_01 = G_by_00*G_cof_10
        G_inv_02 = G_by_00*G_cof_20
        G_inv_10 = G_by_00*G_cof_01
        G_inv_11 = G_by_00*G_cof_11
        G_inv_12 = G_by_00*G_cof_21
        G_inv_20 = G_by_00*G_cof_02
        G_inv_21 = G_by_00*G_cof_12
        G_inv_22 = G_by_00*G_cof_22
        s61 = (J01_0 * J01_0) + (J01_1 * J01_1) + (J01_2 * J01_2)
        s65 = (J02_0 * J02_0) + (J02_1 * J02_1) + (J02_2 * J02_2)
        s67 = (G_det_00 * G_det_00) - 1.0e-12*s61*s65*((J00_0 * J00_0) + (J00_1 * J00_1) + (J00_2 * J00_2))
        w[1408 + lane] = -G_inv_00
        w[1440 + lane] = -G_inv_01
        w[1472 + lane] = -G_inv_02
        w[1504 + lane] = -G_inv_10
        w[1536 + lane] = -G_inv_11
        w[1568 + lane] = -G_inv_12
        w[1600 + lane] = -G_inv_20
        w[1632 + lane] = -G_inv_21
        w[1664 + lane] = -G_inv_22
        w[1696 + lane] = s67


@straight
def _move(w, n):
    """The platform after a step, and its rotation matrix (10 operations)."""
    for lane in range(n):
        px = w[128 + lane]
        py = w[160 + lane]
        cz = w[192 + lane]
        y0 = w[1248 + lane]
        y1 = w[1280 + lane]
        y2 = w[1312 + lane]
        going = w[1376 + lane]
        new_00 = -going*y0 + px
        new_10 = -going*y1 + py
        new_20 = cz - going*y2*(0.25*(cz * cz) + 1)
        w[128 + lane] = new_00
        w[160 + lane] = new_10
        w[192 + lane] = new_20


@straight
def _meet(w, n):
    """Put the platform where the simplified machine has it."""
    for lane in range(n):
        p_0 = w[768 + lane]
        p_1 = w[800 + lane]
        p_2 = w[832 + lane]
        good = (abs(p_0) < math.inf) & (abs(p_1) < math.inf) & (abs(p_2) < math.inf)
        w[1376 + lane] = 0.0 if good else 1.0
        w[128 + lane] = p_0
        w[160 + lane] = p_1
        w[192 + lane] = p_2


@straight
def _settle(w, n):
    """Mark the poses for which this step was the last; return how many go on."""
    left = 0
    for lane in range(n):
        done = (w[1344 + lane] > 0.0)
        done = done & (abs(w[1248 + lane]) < STEP_DONE)
        done = done & (abs(w[1280 + lane]) < STEP_DONE)
        done = done & (abs(w[1312 + lane]) < TURN_DONE)
        going = 0.0 if done | (w[1376 + lane] == 0.0) else 1.0
        w[1376 + lane] = going
        left += 1 if going == 1.0 else 0
    return left


@straight
def _settle_joints(w, n):
    """Mark the poses for which this step was the last; return how many go on."""
    left = 0
    for lane in range(n):
        done = (w[1824 + lane] > 0.0)
        done = done & (abs(w[1728 + lane]) < TURN_DONE)
        done = done & (abs(w[1760 + lane]) < STEP_DONE)
        done = done & (abs(w[1792 + lane]) < TURN_DONE)
        going = 0.0 if done | (w[1376 + lane] == 0.0) else 1.0
        w[1376 + lane] = going
        left += 1 if going == 1.0 else 0
    return left


@straight
def _begin(w, n):
    """Let all poses go."""
    for lane in range(n):
        w[1376 + lane] = 1.0
        w[1248 + lane] = 0.0
        w[1280 + lane] = 0.0
        w[1312 + lane] = 0.0


@straight
def _started(w, n):
    """Take joints, and coordinates that no command asks for, from the simplified machine."""
    for lane in range(n):
        w[1376 + lane] = 0.0 if (abs(w[864 + lane]) < math.inf) else 1.0
        w[0 + lane] = w[864 + lane]
        w[160 + lane] = w[896 + lane]
        w[192 + lane] = w[928 + lane]


@straight
def _turn_joints(w, n):
    """Move the joints by a step; what it does to the platform is left to `_move`."""
    for lane in range(n):
        going = w[1376 + lane]
        w[0 + lane] -= going * w[1728 + lane]
        w[1280 + lane] = w[1760 + lane]
        w[1312 + lane] = w[1792 + lane]

@straight
def _place(x, w, first, last, n):
    """Put platform poses side by side, like `load`."""
    for lane in range(n):
        m = min(first + lane, last)
        w[128 + lane] = x[3 * m + 0]
        w[160 + lane] = x[3 * m + 1]
        w[192 + lane] = x[3 * m + 2]


@straight
def _unload(w, x, status, first, last):
    """Write the platform's poses, and what became of them; return how many are left open."""
    left = 0
    for lane in range(last - first + 1):
        x[3 * (first + lane) + 0] = w[128 + lane]
        x[3 * (first + lane) + 1] = w[160 + lane]
        x[3 * (first + lane) + 2] = w[192 + lane]
        is_open = w[1376 + lane] != 0.0
        status[first + lane] = OPEN if is_open else SOLVED
        left += 1 if is_open else 0
    return left


@straight
def _unload_joints(w, q, first, last):
    for lane in range(last - first + 1):
        q[1 * (first + lane) + 0] = w[0 + lane]


@fast
def _forward(q, tool, k, x, status, warm):
    w = scratch(WORK + SPARE)
    w_1 = w[0:1248]
    if len(tool) == 1:
        hold(tool, w, 0, 0, LANES)
    left, machines = 0, k.shape[0]
    each = status.size // machines
    for m in range(machines):
        k_1 = k[m, 0]
        for first in range(m * each, (m + 1) * each, LANES):
            last = min(first + LANES, (m + 1) * each) - 1
            n = (last - first + 8) // 8 * 8
            load(q, w, first, last, n)
            if len(tool) > 1:
                hold(tool, w, first, last, n)
            _early(w_1, k_1, n)
            if warm:
                _place(x, w, first, last, n)
            else:
                _meet(w, n)
            _begin(w, n)
            _move(w, n)
            for _ in range(MAX_STEPS):
                _rows(w_1, k_1, n)
                _step(w, n)
                _move(w, n)
                if _settle(w, n) == 0:
                    break
            left += _unload(w, x, status, first, last)
    return left


def _of(values, chosen, poses):
    """Return what belongs to the chosen poses of constants or tools, of which there may be fewer than poses."""
    return values[chosen // (poses // len(values))]


def forward(q, tool, k, x, status, warm):
    """Fill x (N, 3) with the exact platform pose at the joints q, by Newton from the simplified machine, or from x where warm.

    status (N,): SOLVED, UNREACHABLE (no platform pose closes all loops) or SINGULAR; x is NaN unless SOLVED.
    """
    given = x.copy() if warm else x
    if _forward(q, tool, k, x, status, warm):
        left = np.flatnonzero(status == OPEN)
        of, found = np.zeros(len(left), dtype=np.int64), given[left]
        vectorised.forward(q[left], _of(tool, left, len(status)), _of(k, left, len(status)), found, of, warm)
        x[left], status[left] = found, of


@fast
def _inverse(target, tool, k, x, q, status):
    w = scratch(WORK + SPARE)
    w_1 = w[0:1248]
    if len(tool) == 1:
        hold(tool, w, 0, 0, LANES)
    left, machines = 0, k.shape[0]
    each = status.size // machines
    for m in range(machines):
        k_1 = k[m, 0]
        for first in range(m * each, (m + 1) * each, LANES):
            last = min(first + LANES, (m + 1) * each) - 1
            n = (last - first + 8) // 8 * 8
            load(target, w, first, last, n)
            if len(tool) > 1:
                hold(tool, w, first, last, n)
            aim(w, n)
            _start(w_1, k_1, n)
            _started(w, n)
            _begin(w, n)
            _move(w, n)
            for _ in range(MAX_STEPS):
                _early(w_1, k_1, n)
                _more(w_1, k_1, n)
                _rows(w_1, k_1, n)
                _joints(w_1, k_1, n)
                _command(w, n)
                _turn_joints(w, n)
                _move(w, n)
                if _settle_joints(w, n) == 0:
                    break
            left += _unload(w, x, status, first, last)
            _unload_joints(w, q, first, last)
    return left


def inverse(target, tool, k, x, q, status):
    """Fill the joints q (N, 1) that bring the reference point to target (N, 1), and the pose x (N, 3) it then has.

    Newton on the joints and the platform's rotation from the simplified machine. status as in `forward`; UNREACHABLE
    where the target lies beyond the reach of a limb.
    """
    if _inverse(target, tool, k, x, q, status):
        left = np.flatnonzero(status == OPEN)
        found, joints, of = (
            np.empty((len(left), 3)), np.empty((len(left), 1)), np.zeros(len(left), dtype=np.int64)
        )
        vectorised.inverse(target[left], _of(tool, left, len(status)), _of(k, left, len(status)), found, joints, of)
        x[left], q[left], status[left] = found, joints, of


@fast
def _simplified_forward(q, tool, k, x, status):
    given, found = q.reshape(q.size), x.reshape(x.size)
    machines, tools = k.reshape(k.size), tool.reshape(tool.size)
    left, runs = 0, max(k.shape[0], tool.shape[0])
    each = status.size // runs
    for m in range(runs):
        own = machines[6 * (m // (runs // k.shape[0])) :]
        held = tools[3 * (m // (runs // tool.shape[0])) :]
        left += _simplified_forward_of(given[1 * each * m :], held, own, found[3 * each * m :], status[each * m :], each)
    return left


@straight
def _simplified_forward_of(q, tool, own, x, status, poses):
    """Solve the poses of one machine with one tool; return how many are left open."""
    left = 0
    tx = tool[0]
    ty = tool[1]
    q0_0 = own[0 + 0]
    s1_0 = own[0 + 1]
    A_x_0 = own[0 + 2]
    h_0 = own[0 + 3]
    for n in range(poses):
        q_0 = q[1 * n + 0]
        s2_0 = q_0 + q0_0
        r_x_0 = s1_0*sine(s2_0)
        r_y_0 = -s1_0*cosine(s2_0)
        s24_0 = A_x_0 + r_x_0 + tx
        s25_0 = -h_0 + r_y_0 + ty
        p_0 = s24_0
        p_1 = s25_0
        p_2 = 0
        good = (abs(p_0) < math.inf) & (abs(p_1) < math.inf) & (abs(p_2) < math.inf)
        x[3 * n + 0] = p_0
        x[3 * n + 1] = p_1
        x[3 * n + 2] = p_2
        status[n] = SOLVED if good else OPEN
        left += 0 if good else 1
    return left


def simplified_forward(q, tool, k, x, status):
    """Fill x (N, 3) with the platform of the simplified machine, in closed form: exact where (nothing) are zero.

    status as in `forward`.
    """
    if _simplified_forward(q, tool, k, x, status):
        left = np.flatnonzero(status == OPEN)
        found, of = np.empty((len(left), 3)), np.empty(len(left), dtype=status.dtype)
        forward(q[left], _of(tool, left, len(status)), _of(k, left, len(status)), found, of, False)
        x[left], status[left] = found[:, :3], of


@fast
def _sensitivity(x, q, tool, k, S_p, S_q, status):
    w, by_errors, by_joints = scratch(WORK + SPARE), S_p.reshape(S_p.size), S_q.reshape(S_q.size)
    w_1 = w[0:1248]
    if len(tool) == 1:
        hold(tool, w, 0, 0, LANES)
    left, machines = 0, k.shape[0]
    each = status.size // machines
    for m in range(machines):
        k_1 = k[m, 0]
        for first in range(m * each, (m + 1) * each, LANES):
            last = min(first + LANES, (m + 1) * each) - 1
            n = (last - first + 8) // 8 * 8
            load(q, w, first, last, n)
            if len(tool) > 1:
                hold(tool, w, first, last, n)
            _place(x, w, first, last, n)
            _begin(w, n)
            _move(w, n)
            _early(w_1, k_1, n)
            _more(w_1, k_1, n)
            _rows(w_1, k_1, n)
            _joints(w_1, k_1, n)
            _errors(w_1, k_1, n)
            _inverse_of_rows(w, n)
            left += _products(w, by_errors, by_joints, status, first, last)
    return left


@fast
def _products(w, S_p, S_q, status, first, last):
    """Multiply the inverse and the derivatives by errors and joints; return how many poses are left open."""
    wide()
    for lane in range(0, last - first + 1, 8):
        whole = 6 * (first + lane + 8) <= S_p.size  # else the last poses are written through scratch
        to, at = (S_p, 6 * (first + lane)) if whole else (w[WORK:], 0)
        for i in range(1):
            outer(to, at + 2 * i + 0, 6, 2, 3, w, (1408 + 0 * i + lane, 1440 + 0 * i + lane, 1472 + 0 * i + lane, ), 96, (1056 + 1248 * i + lane, 1120 + 1248 * i + lane, 1184 + 1248 * i + lane, ), 32, 2)
        if not whole:
            for c in range(6 * (last + 1 - first - lane)):
                S_p[6 * (first + lane) + c] = to[c]
        whole = 3 * (first + lane + 8) <= S_q.size  # else the last poses are written through scratch
        to, at = (S_q, 3 * (first + lane)) if whole else (w[WORK:], 0)
        for i in range(1):
            outer(to, at + 1 * i + 0, 3, 1, 3, w, (1408 + 0 * i + lane, 1440 + 0 * i + lane, 1472 + 0 * i + lane, ), 96, (352 + 1248 * i + lane, 512 + 1248 * i + lane, 672 + 1248 * i + lane, ), 32, 1)
        if not whole:
            for c in range(3 * (last + 1 - first - lane)):
                S_q[3 * (first + lane) + c] = to[c]
    left = 0
    for lane in range(last - first + 1):
        regular = (w[1696 + lane] > 0.0)
        status[first + lane] = SOLVED if regular else OPEN
        left += 0 if regular else 1
    return left


def sensitivity(x, q, tool, k, S_p, S_q, status):
    """Fill the derivatives of the exact pose: S_p (N, 3, 2) by errors and deflections, S_q (N, 3, 1) by joints.

    Rows are px, py, then turns of the platform about
    the axes of {O}. Columns of S_p run limb by limb. S_q is the velocity Jacobian.
    """
    if _sensitivity(x, q, tool, k, S_p, S_q, status):
        left = np.flatnonzero(status == OPEN)
        by_errors, by_joints, of = (
            np.empty((len(left), 3, 2)), np.empty((len(left), 3, 1)),
            np.zeros(len(left), dtype=np.int64),
        )
        vectorised.sensitivity(
            x[left], q[left], _of(tool, left, len(status)), _of(k, left, len(status)), by_errors, by_joints, of
        )
        S_p[left], S_q[left], status[left] = by_errors, by_joints, of

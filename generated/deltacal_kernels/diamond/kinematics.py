"""Kinematics of `diamond`, many poses at once: Diamond, two arms in a plane.

Generated from derive/mechanisms/diamond.py by "deltacal kernels". Do not edit.
Template templates/mechanism/kinematics.py.jinja; sha256 of both 3b3fd3818aa3fd27; SymPy 1.14.0.

Arrays are C-contiguous float64, the pose first, lengths in mm, angles in rad:

x (N, 2)  platform: px py
q (N, 2)  joints        tool (N or 1, 3)  reference point in {O'}
p (M, 2, 13)  one row of parameters per limb: base_x base_y L l side theta ex ey L l mx my tip_v
k (M, 2, 12)  what `constants` makes of p; each of the M machines has N / M of the poses, one after the other

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
from .constants import constants, nominal_constants
from .nominal import distance_rows, nominal_sensitivity
from .vectorised import SINGULAR, SOLVED, UNREACHABLE, jacobians

OPEN = -1  # a pose that is left to the plain kernels
MAX_STEPS = 8
STEP_DONE = 1e-6  # mm; Newton is quadratic: after such a step a length of 1000 mm is exact to 1e-15 mm
TURN_DONE = 3e-8  # rad
CLEAR = 10.0  # mm off the plane of the limbs' centres: nearer, the closed form loses digits
SPHERES = 128  # poses at once whose spheres are kept until all of them meet
APART = 1e-3  # squared sine between the centres' directions
SIMPLIFIED = 2  # coordinates that `simplified_forward` gives: the others are zero
fast = kernel(nogil=True, error_model="numpy", fastmath={"contract"})


@straight
def _early(w, k, n):
    """What moves with a joint only; then the simplified limb as a sphere |P|^2 - 2 c.P + d = 0: c, d (19 operations)."""
    s6 = k[0]
    s9 = k[1]
    s12 = k[2]
    B_x = k[3]
    B_y = k[4]
    s27 = k[11]
    for lane in range(n):
        q = w[0 + lane]
        tx = w[32 + lane]
        ty = w[64 + lane]
        s7 = q + s6
        s8 = cosine(s7)
        s10 = s8*s9
        s11 = sine(s7)
        C_x = B_x + s10 + s11*s12
        s16 = s11*s9
        C_y = B_y - s12*s8 + s16
        s79 = B_x + s10 + tx
        s80 = B_y + s16 + ty
        s83 = -s27 + (s79 * s79) + (s80 * s80)
        w[320 + lane] = C_x
        w[352 + lane] = C_y
        w[384 + lane] = s79
        w[416 + lane] = s80
        w[448 + lane] = s83


@straight
def _rows(w, k, n):
    """Equations of a limb, their derivatives by shift and turn of the platform (10 operations)."""
    s28 = k[5]
    for lane in range(n):
        tx = w[32 + lane]
        ty = w[64 + lane]
        px = w[128 + lane]
        py = w[160 + lane]
        C_x = w[320 + lane]
        C_y = w[352 + lane]
        A_x = px - tx
        A_y = py - ty
        d_x = A_x - C_x
        d_y = A_y - C_y
        s29 = 0.5*(d_x * d_x) + 0.5*(d_y * d_y) + s28
        w[192 + lane] = s29
        w[224 + lane] = d_x
        w[256 + lane] = d_y


@straight
def _step(w, n):
    """Newton's step of the platform; how far the equations are from dependent (26 operations)."""
    for lane in range(n):
        F00 = w[192 + lane]
        J00_0 = w[224 + lane]
        J00_1 = w[256 + lane]
        F10 = w[1088 + lane]
        J10_0 = w[1120 + lane]
        J10_1 = w[1152 + lane]
        G_det_00 = J00_0*J10_1 - J00_1*J10_0
        G_by_00 = (1.0 / G_det_00)
        G_inv_00 = G_by_00*J10_1
        G_inv_01 = -G_by_00*J00_1
        G_inv_10 = -G_by_00*J10_0
        G_inv_11 = G_by_00*J00_0
        u_00 = F00*G_inv_00 + F10*G_inv_01
        u_10 = F00*G_inv_10 + F10*G_inv_11
        s22 = (G_det_00 * G_det_00) - 1.0e-12*((J00_0 * J00_0) + (J00_1 * J00_1))*((J10_0 * J10_0) + (J10_1 * J10_1))
        w[1792 + lane] = u_00
        w[1824 + lane] = u_10
        w[1856 + lane] = s22


@straight
def _start(w, k, n):
    """Joint of the simplified limb at a given position (29 operations)."""
    s6 = k[0]
    s9 = k[1]
    B_x = k[3]
    B_y = k[4]
    s62 = k[6]
    s66 = k[7]
    s71 = k[8]
    for lane in range(n):
        tx = w[32 + lane]
        ty = w[64 + lane]
        px = w[128 + lane]
        py = w[160 + lane]
        s53 = -B_y + py - ty
        s54 = -B_x + px - tx
        s55 = (s54 * s54)
        s57 = (s53 * s53)
        s63 = 0.5*s55 + 0.5*s57 + s62
        s70 = math.sqrt(s55*s66 + s57*s66 - (s63 * s63))
        s78 = -s6 + arctangent(s53*s63*s9 + s54*s70*s71, -s53*s70*s71 + s54*s63*s9)
        w[480 + lane] = s78


@straight
def _more(w, k, n):
    """What else derivatives by joint and errors read of it (10 operations)."""
    s6 = k[0]
    s9 = k[1]
    s12 = k[2]
    for lane in range(n):
        q = w[0 + lane]
        s7 = q + s6
        s8 = cosine(s7)
        s11 = sine(s7)
        s84 = s11*s9 - s12*s8
        s86 = -s11*s12 - s8*s9
        w[512 + lane] = s11
        w[544 + lane] = s8
        w[576 + lane] = s84
        w[608 + lane] = s86


@straight
def _joints(w, k, n):
    """Derivatives of a limb's equations by its joint (7 operations)."""
    for lane in range(n):
        tx = w[32 + lane]
        ty = w[64 + lane]
        px = w[128 + lane]
        py = w[160 + lane]
        C_x = w[320 + lane]
        C_y = w[352 + lane]
        s84 = w[576 + lane]
        s86 = w[608 + lane]
        A_x = px - tx
        A_y = py - ty
        d_x = A_x - C_x
        d_y = A_y - C_y
        s88 = d_x*s84 + d_y*s86
        w[288 + lane] = s88


@straight
def _command(w, n):
    """Newton's step of joints and rotation; how far the equations are from dependent (16 operations)."""
    for lane in range(n):
        F00 = w[192 + lane]
        J00_0 = w[224 + lane]
        J00_1 = w[256 + lane]
        Q00 = w[288 + lane]
        F10 = w[1088 + lane]
        J10_0 = w[1120 + lane]
        J10_1 = w[1152 + lane]
        Q10 = w[1184 + lane]
        s1 = F00/Q00
        s3 = F10/Q10
        s9 = -1.0e-12*(J00_0 * J00_0) - 1.0e-12*(J00_1 * J00_1) + (Q00 * Q00)
        s15 = -1.0e-12*(J10_0 * J10_0) - 1.0e-12*(J10_1 * J10_1) + (Q10 * Q10)
        w[2080 + lane] = s1
        w[2112 + lane] = s3
        w[2144 + lane] = s9
        w[2176 + lane] = s15


@straight
def _errors(w, k, n):
    """Derivatives of a limb's equations by errors, by deflections (30 operations)."""
    s9 = k[1]
    s12 = k[2]
    side = k[9]
    s51 = k[10]
    for lane in range(n):
        tx = w[32 + lane]
        ty = w[64 + lane]
        px = w[128 + lane]
        py = w[160 + lane]
        C_x = w[320 + lane]
        C_y = w[352 + lane]
        s11 = w[512 + lane]
        s8 = w[544 + lane]
        A_x = px - tx
        A_y = py - ty
        d_x = A_x - C_x
        d_y = A_y - C_y
        s30 = 2*d_y
        s31 = 0.5*s30
        s32 = 2*d_x
        s33 = 0.5*s32
        s46 = -s11*(s12*s31 - s33*s9) + s8*(-s12*s33 - s31*s9)
        s50 = side*(-s11*s31 - s33*s8)
        s52 = -side*(-s11*s33 + s31*s8)
        w[640 + lane] = s46
        w[672 + lane] = -s33
        w[704 + lane] = -s31
        w[736 + lane] = s50
        w[768 + lane] = s51
        w[800 + lane] = 0
        w[832 + lane] = 0
        w[864 + lane] = s52


@straight
def _inverse_of_rows(w, n):
    """Minus the inverse of the derivatives, row by row; how far the equations are from dependent (24 operations)."""
    for lane in range(n):
        J00_0 = w[224 + lane]
        J00_1 = w[256 + lane]
        J10_0 = w[1120 + lane]
        J10_1 = w[1152 + lane]
        G_det_00 = J00_0*J10_1 - J00_1*J10_0
        G_by_00 = (1.0 / G_det_00)
        G_inv_00 = G_by_00*J10_1
        G_inv_01 = -G_by_00*J00_1
        G_inv_10 = -G_by_00*J10_0
        G_inv_11 = G_by_00*J00_0
        s22 = (G_det_00 * G_det_00) - 1.0e-12*((J00_0 * J00_0) + (J00_1 * J00_1))*((J10_0 * J10_0) + (J10_1 * J10_1))
        w[1920 + lane] = -G_inv_00
        w[1952 + lane] = -G_inv_01
        w[1984 + lane] = -G_inv_10
        w[2016 + lane] = -G_inv_11
        w[2048 + lane] = s22


@straight
def _move(w, n):
    """The platform after a step, and its rotation matrix (4 operations)."""
    for lane in range(n):
        px = w[128 + lane]
        py = w[160 + lane]
        y0 = w[1792 + lane]
        y1 = w[1824 + lane]
        going = w[1888 + lane]
        new_00 = -going*y0 + px
        new_10 = -going*y1 + py
        w[128 + lane] = new_00
        w[1024 + lane] = new_00
        w[160 + lane] = new_10
        w[1056 + lane] = new_10


@straight
def _meet(w, n):
    """Put the platform where the simplified machine has it."""
    for lane in range(n):
        c_00 = w[384 + lane]
        c_01 = w[416 + lane]
        c_02 = w[448 + lane]
        c_10 = w[1280 + lane]
        c_11 = w[1312 + lane]
        c_12 = w[1344 + lane]
        a_x = -c_00 + c_10
        a_y = -c_01 + c_11
        to_a = -0.5*c_02 + 0.5*c_12
        aa = (a_x * a_x) + (a_y * a_y)
        inverse = (1.0 / aa)
        by_a = inverse*to_a
        p_x = a_x*by_a
        p_y = a_y*by_a
        half = inverse*(a_x*(-c_01 + p_y) - a_y*(-c_00 + p_x))
        rest = -2*c_00*p_x - 2*c_01*p_y + c_02 + (p_x * p_x) + (p_y * p_y)
        under = (half * half) - inverse*rest
        kept = (under if (under > 0) else 0)
        s27 = math.sqrt(kept)
        along = -half - (s27 if (a_x > 0) else -s27)
        s31 = -a_y*along + p_x
        s33 = a_x*along + p_y
        s34 = aa*under
        s39 = (c_00 * c_00) + (c_01 * c_01) + (c_10 * c_10) + (c_11 * c_11)
        p_0 = s31
        p_1 = s33
        clear = s34
        square = aa
        wide = s39
        good = (clear > CLEAR * CLEAR) & (square > APART * wide)
        w[1888 + lane] = 0.0 if good else 1.0
        w[128 + lane] = p_0
        w[160 + lane] = p_1


@straight
def _settle(w, n):
    """Mark the poses for which this step was the last; return how many go on."""
    left = 0
    for lane in range(n):
        done = (w[1856 + lane] > 0.0)
        done = done & (abs(w[1792 + lane]) < STEP_DONE)
        done = done & (abs(w[1824 + lane]) < STEP_DONE)

        going = 0.0 if done | (w[1888 + lane] == 0.0) else 1.0
        w[1888 + lane] = going
        left += 1 if going == 1.0 else 0
    return left


@straight
def _settle_joints(w, n):
    """Mark the poses for which this step was the last; return how many go on."""
    left = 0
    for lane in range(n):
        done = (w[2144 + lane] > 0.0)
        done = done & (w[2176 + lane] > 0.0)
        done = done & (abs(w[2080 + lane]) < TURN_DONE)
        done = done & (abs(w[2112 + lane]) < TURN_DONE)


        going = 0.0 if done | (w[1888 + lane] == 0.0) else 1.0
        w[1888 + lane] = going
        left += 1 if going == 1.0 else 0
    return left


@straight
def _begin(w, n):
    """Let all poses go."""
    for lane in range(n):
        w[1888 + lane] = 1.0
        w[1792 + lane] = 0.0
        w[1824 + lane] = 0.0


@straight
def _started(w, n):
    """Take joints, and coordinates that no command asks for, from the simplified machine."""
    for lane in range(n):
        w[1888 + lane] = 0.0 if (abs(w[480 + lane]) < math.inf) & (abs(w[1376 + lane]) < math.inf) else 1.0
        w[0 + lane] = w[480 + lane]
        w[896 + lane] = w[1376 + lane]


@straight
def _turn_joints(w, n):
    """Move the joints by a step; what it does to the platform is left to `_move`."""
    for lane in range(n):
        going = w[1888 + lane]
        w[0 + lane] -= going * w[2080 + lane]
        w[896 + lane] -= going * w[2112 + lane]

@straight
def _place(x, w, first, last, n):
    """Put platform poses side by side, like `load`."""
    for lane in range(n):
        m = min(first + lane, last)
        w[128 + lane] = x[2 * m + 0]
        w[160 + lane] = x[2 * m + 1]


@straight
def _unload(w, x, status, first, last):
    """Write the platform's poses, and what became of them; return how many are left open."""
    left = 0
    for lane in range(last - first + 1):
        x[2 * (first + lane) + 0] = w[128 + lane]
        x[2 * (first + lane) + 1] = w[160 + lane]
        is_open = w[1888 + lane] != 0.0
        status[first + lane] = OPEN if is_open else SOLVED
        left += 1 if is_open else 0
    return left


@straight
def _unload_joints(w, q, first, last):
    for lane in range(last - first + 1):
        q[2 * (first + lane) + 0] = w[0 + lane]
        q[2 * (first + lane) + 1] = w[896 + lane]


@fast
def _forward(q, tool, k, x, status, warm):
    w = scratch(WORK + SPARE)
    w_1 = w[0:896]
    w_2 = w[896:1792]
    if len(tool) == 1:
        hold(tool, w, 0, 0, LANES)
    left, machines = 0, k.shape[0]
    each = status.size // machines
    for m in range(machines):
        k_1 = k[m, 0]
        k_2 = k[m, 1]
        for first in range(m * each, (m + 1) * each, LANES):
            last = min(first + LANES, (m + 1) * each) - 1
            n = (last - first + 8) // 8 * 8
            load(q, w, first, last, n)
            if len(tool) > 1:
                hold(tool, w, first, last, n)
            _early(w_1, k_1, n)
            _early(w_2, k_2, n)
            if warm:
                _place(x, w, first, last, n)
            else:
                _meet(w, n)
            _begin(w, n)
            _move(w, n)
            for _ in range(MAX_STEPS):
                _rows(w_1, k_1, n)
                _rows(w_2, k_2, n)
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
    """Fill x (N, 2) with the exact platform pose at the joints q, by Newton from the simplified machine, or from x where warm.

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
    w_1 = w[0:896]
    w_2 = w[896:1792]
    if len(tool) == 1:
        hold(tool, w, 0, 0, LANES)
    left, machines = 0, k.shape[0]
    each = status.size // machines
    for m in range(machines):
        k_1 = k[m, 0]
        k_2 = k[m, 1]
        for first in range(m * each, (m + 1) * each, LANES):
            last = min(first + LANES, (m + 1) * each) - 1
            n = (last - first + 8) // 8 * 8
            load(target, w, first, last, n)
            if len(tool) > 1:
                hold(tool, w, first, last, n)
            aim(w, n)
            _start(w_1, k_1, n)
            _start(w_2, k_2, n)
            _started(w, n)
            _begin(w, n)
            _move(w, n)
            for _ in range(MAX_STEPS):
                _early(w_1, k_1, n)
                _more(w_1, k_1, n)
                _rows(w_1, k_1, n)
                _joints(w_1, k_1, n)
                _early(w_2, k_2, n)
                _more(w_2, k_2, n)
                _rows(w_2, k_2, n)
                _joints(w_2, k_2, n)
                _command(w, n)
                _turn_joints(w, n)
                _move(w, n)
                if _settle_joints(w, n) == 0:
                    break
            left += _unload(w, x, status, first, last)
            _unload_joints(w, q, first, last)
    return left


def inverse(target, tool, k, x, q, status):
    """Fill the joints q (N, 2) that bring the reference point to target (N, 2), and the pose x (N, 2) it then has.

    Newton on the joints and the platform's rotation from the simplified machine. status as in `forward`; UNREACHABLE
    where the target lies beyond the reach of a limb.
    """
    if _inverse(target, tool, k, x, q, status):
        left = np.flatnonzero(status == OPEN)
        found, joints, of = (
            np.empty((len(left), 2)), np.empty((len(left), 2)), np.zeros(len(left), dtype=np.int64)
        )
        vectorised.inverse(target[left], _of(tool, left, len(status)), _of(k, left, len(status)), found, joints, of)
        x[left], q[left], status[left] = found, joints, of


@fast
def _simplified_forward(q, tool, k, x, status):
    given, found = q.reshape(q.size), x.reshape(x.size)
    machines, tools = k.reshape(k.size), tool.reshape(tool.size)
    left, runs = 0, max(k.shape[0], tool.shape[0])
    w = scratch(6 * SPHERES)
    each = status.size // runs
    for m in range(runs):
        own = machines[24 * (m // (runs // k.shape[0])) :]
        held = tools[3 * (m // (runs // tool.shape[0])) :]
        left += _simplified_forward_of(given[2 * each * m :], held, own, found[2 * each * m :], status[each * m :], each, w)
    return left


@straight
def _simplified_forward_of(q, tool, own, x, status, poses, w):
    """Solve the poses of one machine with one tool; return how many are left open."""
    left = 0
    tx = tool[0]
    ty = tool[1]
    s6_0 = own[0 + 0]
    s9_0 = own[0 + 1]
    B_x_0 = own[0 + 3]
    B_y_0 = own[0 + 4]
    s27_0 = own[0 + 11]
    s6_1 = own[12 + 0]
    s9_1 = own[12 + 1]
    B_x_1 = own[12 + 3]
    B_y_1 = own[12 + 4]
    s27_1 = own[12 + 11]
    for first in range(0, poses, SPHERES):  # in two short loops, of which a processor has several rounds at work
        count = min(SPHERES, poses - first)
        for lane in range(count):
            n = first + lane
            q_0 = q[2 * n + 0]
            s7_0 = q_0 + s6_0
            s79_0 = B_x_0 + s9_0*cosine(s7_0) + tx
            s80_0 = B_y_0 + s9_0*sine(s7_0) + ty
            s83_0 = -s27_0 + (s79_0 * s79_0) + (s80_0 * s80_0)
            c_00 = s79_0
            c_01 = s80_0
            c_02 = s83_0
            q_1 = q[2 * n + 1]
            s7_1 = q_1 + s6_1
            s79_1 = B_x_1 + s9_1*cosine(s7_1) + tx
            s80_1 = B_y_1 + s9_1*sine(s7_1) + ty
            s83_1 = -s27_1 + (s79_1 * s79_1) + (s80_1 * s80_1)
            c_10 = s79_1
            c_11 = s80_1
            c_12 = s83_1
            w[0 * SPHERES + lane], w[1 * SPHERES + lane], w[2 * SPHERES + lane] = c_00, c_01, c_02
            w[3 * SPHERES + lane], w[4 * SPHERES + lane], w[5 * SPHERES + lane] = c_10, c_11, c_12
        for lane in range(count):
            n = first + lane
            c_00 = w[0 + lane]
            c_01 = w[128 + lane]
            c_02 = w[256 + lane]
            c_10 = w[384 + lane]
            c_11 = w[512 + lane]
            c_12 = w[640 + lane]
            a_x = -c_00 + c_10
            a_y = -c_01 + c_11
            to_a = -0.5*c_02 + 0.5*c_12
            aa = (a_x * a_x) + (a_y * a_y)
            inverse = (1.0 / aa)
            by_a = inverse*to_a
            p_x = a_x*by_a
            p_y = a_y*by_a
            half = inverse*(a_x*(-c_01 + p_y) - a_y*(-c_00 + p_x))
            rest = -2*c_00*p_x - 2*c_01*p_y + c_02 + (p_x * p_x) + (p_y * p_y)
            under = (half * half) - inverse*rest
            kept = (under if (under > 0) else 0)
            s27 = math.sqrt(kept)
            along = -half - (s27 if (a_x > 0) else -s27)
            s31 = -a_y*along + p_x
            s33 = a_x*along + p_y
            s34 = aa*under
            s39 = (c_00 * c_00) + (c_01 * c_01) + (c_10 * c_10) + (c_11 * c_11)
            p_0 = s31
            p_1 = s33
            clear = s34
            square = aa
            wide = s39
            good = (clear > CLEAR * CLEAR) & (square > APART * wide)
            x[2 * n + 0] = p_0
            x[2 * n + 1] = p_1
            status[n] = SOLVED if good else OPEN
            left += 0 if good else 1
    return left


def simplified_forward(q, tool, k, x, status):
    """Fill x (N, 2) with the platform of the simplified machine, in closed form: exact where tip_v are zero.

    It does not turn, so that x is the position of the reference point.
    status as in `forward`.
    """
    if _simplified_forward(q, tool, k, x, status):
        left = np.flatnonzero(status == OPEN)
        found, of = np.empty((len(left), 2)), np.empty(len(left), dtype=status.dtype)
        forward(q[left], _of(tool, left, len(status)), _of(k, left, len(status)), found, of, False)
        x[left], status[left] = found[:, :2], of


@fast
def _simplified_inverse(target, tool, k, q, status):
    given, found = target.reshape(target.size), q.reshape(q.size)
    machines, tools = k.reshape(k.size), tool.reshape(tool.size)
    left, runs = 0, max(k.shape[0], tool.shape[0])
    each = status.size // runs
    for m in range(runs):
        own = machines[24 * (m // (runs // k.shape[0])) :]
        held = tools[3 * (m // (runs // tool.shape[0])) :]
        left += _simplified_inverse_of(given[2 * each * m :], held, own, found[2 * each * m :], status[each * m :], each)
    return left


@straight
def _simplified_inverse_of(target, tool, own, q, status, poses):
    """Solve the poses of one machine with one tool; return how many are left open."""
    left = 0
    tx = tool[0]
    ty = tool[1]
    s6_0 = own[0 + 0]
    s9_0 = own[0 + 1]
    B_x_0 = own[0 + 3]
    B_y_0 = own[0 + 4]
    s62_0 = own[0 + 6]
    s66_0 = own[0 + 7]
    s71_0 = own[0 + 8]
    s6_1 = own[12 + 0]
    s9_1 = own[12 + 1]
    B_x_1 = own[12 + 3]
    B_y_1 = own[12 + 4]
    s62_1 = own[12 + 6]
    s66_1 = own[12 + 7]
    s71_1 = own[12 + 8]
    for n in range(poses):
        px = target[2 * n + 0]
        py = target[2 * n + 1]
        s53_0 = -B_y_0 + py - ty
        s54_0 = -B_x_0 + px - tx
        s55_0 = (s54_0 * s54_0)
        s57_0 = (s53_0 * s53_0)
        s63_0 = 0.5*s55_0 + 0.5*s57_0 + s62_0
        s70_0 = math.sqrt(s55_0*s66_0 + s57_0*s66_0 - (s63_0 * s63_0))
        s78_0 = -s6_0 + arctangent(s53_0*s63_0*s9_0 + s54_0*s70_0*s71_0, -s53_0*s70_0*s71_0 + s54_0*s63_0*s9_0)
        q_00 = s78_0
        s53_1 = -B_y_1 + py - ty
        s54_1 = -B_x_1 + px - tx
        s55_1 = (s54_1 * s54_1)
        s57_1 = (s53_1 * s53_1)
        s63_1 = 0.5*s55_1 + 0.5*s57_1 + s62_1
        s70_1 = math.sqrt(s55_1*s66_1 + s57_1*s66_1 - (s63_1 * s63_1))
        s78_1 = -s6_1 + arctangent(s53_1*s63_1*s9_1 + s54_1*s70_1*s71_1, -s53_1*s70_1*s71_1 + s54_1*s63_1*s9_1)
        q_10 = s78_1
        good = (abs(q_00) < math.inf) & (abs(q_10) < math.inf)
        q[2 * n + 0] = q_00
        q[2 * n + 1] = q_10
        status[n] = SOLVED if good else OPEN
        left += 0 if good else 1
    return left


def simplified_inverse(target, tool, k, q, status):
    """Fill the joints q (N, 2) of the simplified machine, in closed form; see `simplified_forward` and `inverse`."""
    if _simplified_inverse(target, tool, k, q, status):
        left = np.flatnonzero(status == OPEN)
        found, joints, of = (
            np.empty((len(left), 2)), np.empty((len(left), 2)),
            np.empty(len(left), dtype=status.dtype),
        )
        inverse(target[left], _of(tool, left, len(status)), _of(k, left, len(status)), found, joints, of)
        q[left], status[left] = joints, of


@fast
def _sensitivity(x, q, tool, k, S_p, S_q, status):
    w, by_errors, by_joints = scratch(WORK + SPARE), S_p.reshape(S_p.size), S_q.reshape(S_q.size)
    w_1 = w[0:896]
    w_2 = w[896:1792]
    if len(tool) == 1:
        hold(tool, w, 0, 0, LANES)
    left, machines = 0, k.shape[0]
    each = status.size // machines
    for m in range(machines):
        k_1 = k[m, 0]
        k_2 = k[m, 1]
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
            _early(w_2, k_2, n)
            _more(w_2, k_2, n)
            _rows(w_2, k_2, n)
            _joints(w_2, k_2, n)
            _errors(w_2, k_2, n)
            _inverse_of_rows(w, n)
            left += _products(w, by_errors, by_joints, status, first, last)
    return left


@fast
def _products(w, S_p, S_q, status, first, last):
    """Multiply the inverse and the derivatives by errors and joints; return how many poses are left open."""
    wide()
    for lane in range(0, last - first + 1, 8):
        whole = 32 * (first + lane + 8) <= S_p.size  # else the last poses are written through scratch
        to, at = (S_p, 32 * (first + lane)) if whole else (w[WORK:], 0)
        for i in range(2):
            outer(to, at + 8 * i + 0, 32, 16, 2, w, (1920 + 32 * i + lane, ), 64, (640 + 896 * i + lane, ), 32, 8)
        if not whole:
            for c in range(32 * (last + 1 - first - lane)):
                S_p[32 * (first + lane) + c] = to[c]
        whole = 4 * (first + lane + 8) <= S_q.size  # else the last poses are written through scratch
        to, at = (S_q, 4 * (first + lane)) if whole else (w[WORK:], 0)
        for i in range(2):
            outer(to, at + 1 * i + 0, 4, 2, 2, w, (1920 + 32 * i + lane, ), 64, (288 + 896 * i + lane, ), 32, 1)
        if not whole:
            for c in range(4 * (last + 1 - first - lane)):
                S_q[4 * (first + lane) + c] = to[c]
    left = 0
    for lane in range(last - first + 1):
        regular = (w[2048 + lane] > 0.0)
        status[first + lane] = SOLVED if regular else OPEN
        left += 0 if regular else 1
    return left


def sensitivity(x, q, tool, k, S_p, S_q, status):
    """Fill the derivatives of the exact pose: S_p (N, 2, 16) by errors and deflections, S_q (N, 2, 2) by joints.

    Rows are px, py, then turns of the platform about
    the axes of {O}. Columns of S_p run limb by limb. S_q is the velocity Jacobian.
    """
    if _sensitivity(x, q, tool, k, S_p, S_q, status):
        left = np.flatnonzero(status == OPEN)
        by_errors, by_joints, of = (
            np.empty((len(left), 2, 16)), np.empty((len(left), 2, 2)),
            np.zeros(len(left), dtype=np.int64),
        )
        vectorised.sensitivity(
            x[left], q[left], _of(tool, left, len(status)), _of(k, left, len(status)), by_errors, by_joints, of
        )
        S_p[left], S_q[left], status[left] = by_errors, by_joints, of

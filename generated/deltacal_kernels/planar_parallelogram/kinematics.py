"""Kinematics of `planar_parallelogram`, many poses at once: Planar parallelogram, one joint.

Generated from derive/mechanisms/planar_parallelogram.py by "deltacal kernels". Do not edit.
Template templates/mechanism/kinematics.py.jinja; sha256 of both 129b4092c00fdc0d; SymPy 1.14.0.

Arrays are C-contiguous float64, the pose first, lengths in mm, angles in rad:

x (N, 3)  platform: px py cz
q (N, 1)  joints        tool (N or 1, 3)  reference point in {O'}
p (M, 1, 18)  one row of parameters per limb: a1x a2x a2y b1x b2x b2y l1 l2 h q0 a1x a2x a2y b1x b2x b2y l1 l2
k (M, 1, 28)  what `constants` makes of p; each of the M machines has N / M of the poses, one after the other

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
    """What moves with a joint only; then platform of the simplified machine at a given joint (69 operations)."""
    h = k[0]
    q0 = k[1]
    s7 = k[2]
    b1_x = k[3]
    b2_x = k[4]
    b2_y = k[5]
    A1_x = k[8]
    s116 = k[13]
    s124 = k[16]
    s130 = k[17]
    s134 = k[18]
    s138 = k[20]
    s153 = k[22]
    s156 = k[23]
    s160 = k[25]
    s195 = k[27]
    for lane in range(n):
        q = w[0 + lane]
        tx = w[32 + lane]
        ty = w[64 + lane]
        C_y = -h + ty
        s8 = q + q0
        r1_x = s7*sine(s8)
        r1_y = -s7*cosine(s8)
        s22 = b1_x - tx
        s29 = b2_x - tx
        s31 = -C_y + b2_y
        s185 = r1_x*s116 + r1_y*s130 + r1_y*s134 + s124
        s190 = r1_x*s130 + r1_x*s134 - r1_y*s116 + s138
        s198 = (r1_x * r1_x) + r1_x*s153 + r1_x*s156 + (r1_y * r1_y) + r1_y*s195 + s160
        s201 = math.sqrt((s185 * s185) + (s190 * s190) - (s198 * s198))
        s204 = -s185*s198 + s190*s201
        s208 = -s185*s201 - s190*s198
        s211 = 1/math.sqrt((s204 * s204) + (s208 * s208))
        s214 = A1_x - C_y*s204*s211 + r1_x - s208*s211*s22
        s217 = C_y*s208*s211 + r1_y - s204*s211*s22
        s221 = 2*tangent(0.5*arctangent(s204, s208))
        w[832 + lane] = s22
        w[864 + lane] = C_y
        w[896 + lane] = s29
        w[928 + lane] = s31
        w[960 + lane] = r1_x
        w[992 + lane] = r1_y
        w[1024 + lane] = s214
        w[1056 + lane] = s217
        w[1088 + lane] = s221


@straight
def _rows(w, k, n):
    """Equations of a limb, their derivatives by shift and turn of the platform (38 operations)."""
    A2_x = k[6]
    A2_y = k[7]
    A1_x = k[8]
    s71 = k[9]
    for lane in range(n):
        px = w[128 + lane]
        py = w[160 + lane]
        R_11 = w[224 + lane]
        R_12 = w[256 + lane]
        R_21 = w[288 + lane]
        R_22 = w[320 + lane]
        s22 = w[832 + lane]
        C_y = w[864 + lane]
        s29 = w[896 + lane]
        s31 = w[928 + lane]
        r1_x = w[960 + lane]
        r1_y = w[992 + lane]
        s23 = R_11*s22
        s24 = -C_y*R_12
        B1_x = px + s23 + s24
        s26 = R_21*s22
        s27 = -C_y*R_22
        B1_y = py + s26 + s27
        s30 = R_11*s29
        s32 = R_12*s31
        B2_x = px + s30 + s32
        s34 = R_21*s29
        s35 = R_22*s31
        B2_y = py + s34 + s35
        r2_x = -A2_x + B2_x
        r2_y = -A2_y + B2_y
        s39 = -A1_x + B1_x - r1_x
        s54 = B1_y - r1_y
        s72 = 0.5*(r2_x * r2_x) + 0.5*(r2_y * r2_y) + s71
        s222 = -s26 - s27
        s223 = s23 + s24
        s228 = r2_x*(-s34 - s35) + r2_y*(s30 + s32)
        w[352 + lane] = s39
        w[384 + lane] = 1
        w[416 + lane] = 0
        w[448 + lane] = s222
        w[512 + lane] = s54
        w[544 + lane] = 0
        w[576 + lane] = 1
        w[608 + lane] = s223
        w[672 + lane] = s72
        w[704 + lane] = r2_x
        w[736 + lane] = r2_y
        w[768 + lane] = s228


@straight
def _step(w, n):
    """Newton's step of the platform; how far the equations are from dependent (77 operations)."""
    for lane in range(n):
        F00 = w[352 + lane]
        J00_0 = w[384 + lane]
        J00_1 = w[416 + lane]
        J00_2 = w[448 + lane]
        F01 = w[512 + lane]
        J01_0 = w[544 + lane]
        J01_1 = w[576 + lane]
        J01_2 = w[608 + lane]
        F02 = w[672 + lane]
        J02_0 = w[704 + lane]
        J02_1 = w[736 + lane]
        J02_2 = w[768 + lane]
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
        w[2144 + lane] = u_00
        w[2176 + lane] = u_10
        w[2208 + lane] = u_20
        w[2240 + lane] = s67


@straight
def _start(w, k, n):
    """Joint of the simplified limb at a given position (64 operations)."""
    h = k[0]
    q0 = k[1]
    s7 = k[2]
    b1_x = k[3]
    s103 = k[10]
    s102 = k[11]
    s108 = k[12]
    s116 = k[13]
    s120 = k[14]
    s122 = k[15]
    s124 = k[16]
    s130 = k[17]
    s134 = k[18]
    s136 = k[19]
    s138 = k[20]
    s149 = k[21]
    s153 = k[22]
    s156 = k[23]
    s158 = k[24]
    s160 = k[25]
    for lane in range(n):
        tx = w[32 + lane]
        ty = w[64 + lane]
        px = w[128 + lane]
        C_y = -h + ty
        s104 = px + s103 - tx
        s107 = -q0 + arcsine(s102*s104)
        s109 = (s104 * s104)
        s111 = -s108*s109 + 1
        s112 = math.sqrt(s111)
        s125 = s104*s116 + s112*s120 + s112*s122 + s124
        s139 = s104*s130 + s104*s134 + s112*s136 + s138
        s161 = s104*s153 + s104*s156 + s109 + s111*s149 + s112*s158 + s160
        s164 = math.sqrt((s125 * s125) + (s139 * s139) - (s161 * s161))
        s167 = -s125*s161 + s139*s164
        s171 = -s125*s164 - s139*s161
        s174 = 1/math.sqrt((s167 * s167) + (s171 * s171))
        s177 = C_y*s171*s174 - s112*s7 - s167*s174*(b1_x - tx)
        s181 = 2*tangent(0.5*arctangent(s167, s171))
        w[1120 + lane] = s107
        w[1152 + lane] = s177
        w[1184 + lane] = s181


@straight
def _more(w, k, n):
    """What else derivatives by joint and errors read of it (3 operations)."""
    q0 = k[1]
    for lane in range(n):
        q = w[0 + lane]
        s8 = q + q0
        s9 = sine(s8)
        s11 = cosine(s8)
        w[1216 + lane] = s9
        w[1248 + lane] = s11


@straight
def _joints(w, k, n):
    """Derivatives of a limb's equations by its joint (1 operations)."""
    for lane in range(n):
        r1_x = w[960 + lane]
        r1_y = w[992 + lane]
        w[480 + lane] = r1_y
        w[640 + lane] = -r1_x
        w[800 + lane] = 0


@straight
def _command(w, n):
    """Newton's step of joints and rotation; how far the equations are from dependent (71 operations)."""
    for lane in range(n):
        F00 = w[352 + lane]
        J00_1 = w[416 + lane]
        J00_2 = w[448 + lane]
        Q00 = w[480 + lane]
        F01 = w[512 + lane]
        J01_1 = w[576 + lane]
        J01_2 = w[608 + lane]
        Q01 = w[640 + lane]
        F02 = w[672 + lane]
        J02_1 = w[736 + lane]
        J02_2 = w[768 + lane]
        Q02 = w[800 + lane]
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
        w[2624 + lane] = s36
        w[2656 + lane] = s41
        w[2688 + lane] = s46
        w[2720 + lane] = s61


@straight
def _errors(w, k, n):
    """Derivatives of a limb's equations by errors, by deflections (26 operations)."""
    A2_x = k[6]
    A2_y = k[7]
    s101 = k[26]
    for lane in range(n):
        px = w[128 + lane]
        py = w[160 + lane]
        R_11 = w[224 + lane]
        R_12 = w[256 + lane]
        R_21 = w[288 + lane]
        R_22 = w[320 + lane]
        s29 = w[896 + lane]
        s31 = w[928 + lane]
        r1_x = w[960 + lane]
        r1_y = w[992 + lane]
        s9 = w[1216 + lane]
        s11 = w[1248 + lane]
        B2_x = R_11*s29 + R_12*s31 + px
        B2_y = R_21*s29 + R_22*s31 + py
        r2_x = -A2_x + B2_x
        r2_y = -A2_y + B2_y
        s73 = 2*r2_y
        s74 = 0.5*s73
        s75 = 2*r2_x
        s76 = 0.5*s75
        s83 = R_12*s76 + R_22*s74
        s86 = R_11*s76 + R_21*s74
        w[1280 + lane] = r1_y
        w[1312 + lane] = 1
        w[1344 + lane] = 0
        w[1376 + lane] = 0
        w[1408 + lane] = -R_11
        w[1440 + lane] = 0
        w[1472 + lane] = 0
        w[1504 + lane] = -s9
        w[1536 + lane] = 0
        w[1568 + lane] = -r1_x
        w[1600 + lane] = 0
        w[1632 + lane] = 0
        w[1664 + lane] = 0
        w[1696 + lane] = -R_21
        w[1728 + lane] = 0
        w[1760 + lane] = 0
        w[1792 + lane] = s11
        w[1824 + lane] = 0
        w[1856 + lane] = 0
        w[1888 + lane] = 0
        w[1920 + lane] = -s76
        w[1952 + lane] = -s74
        w[1984 + lane] = 0
        w[2016 + lane] = s86
        w[2048 + lane] = s83
        w[2080 + lane] = 0
        w[2112 + lane] = s101


@straight
def _inverse_of_rows(w, n):
    """Minus the inverse of the derivatives, row by row; how far the equations are from dependent (71 operations)."""
    for lane in range(n):
        J00_0 = w[384 + lane]
        J00_1 = w[416 + lane]
        J00_2 = w[448 + lane]
        J01_0 = w[544 + lane]
        J01_1 = w[576 + lane]
        J01_2 = w[608 + lane]
        J02_0 = w[704 + lane]
        J02_1 = w[736 + lane]
        J02_2 = w[768 + lane]
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
        w[2304 + lane] = -G_inv_00
        w[2336 + lane] = -G_inv_01
        w[2368 + lane] = -G_inv_02
        w[2400 + lane] = -G_inv_10
        w[2432 + lane] = -G_inv_11
        w[2464 + lane] = -G_inv_12
        w[2496 + lane] = -G_inv_20
        w[2528 + lane] = -G_inv_21
        w[2560 + lane] = -G_inv_22
        w[2592 + lane] = s67


@straight
def _move(w, n):
    """The platform after a step, and its rotation matrix (20 operations)."""
    for lane in range(n):
        px = w[128 + lane]
        py = w[160 + lane]
        cz = w[192 + lane]
        y0 = w[2144 + lane]
        y1 = w[2176 + lane]
        y2 = w[2208 + lane]
        going = w[2272 + lane]
        new_00 = -going*y0 + px
        new_10 = -going*y1 + py
        new_20 = cz - going*y2*(0.25*(cz * cz) + 1)
        s9 = (new_20 * new_20)
        s12 = (1.0 / (0.25*s9 + 1))
        s14 = -0.5*s12*s9 + 1
        s15 = -new_20*s12
        w[128 + lane] = new_00
        w[160 + lane] = new_10
        w[192 + lane] = new_20
        w[224 + lane] = s14
        w[256 + lane] = s15
        w[288 + lane] = -s15
        w[320 + lane] = s14


@straight
def _meet(w, n):
    """Put the platform where the simplified machine has it."""
    for lane in range(n):
        p_0 = w[1024 + lane]
        p_1 = w[1056 + lane]
        p_2 = w[1088 + lane]
        good = (abs(p_0) < math.inf) & (abs(p_1) < math.inf) & (abs(p_2) < math.inf)
        w[2272 + lane] = 0.0 if good else 1.0
        w[128 + lane] = p_0
        w[160 + lane] = p_1
        w[192 + lane] = p_2


@straight
def _settle(w, n):
    """Mark the poses for which this step was the last; return how many go on."""
    left = 0
    for lane in range(n):
        done = (w[2240 + lane] > 0.0)
        done = done & (abs(w[2144 + lane]) < STEP_DONE)
        done = done & (abs(w[2176 + lane]) < STEP_DONE)
        done = done & (abs(w[2208 + lane]) < TURN_DONE)
        going = 0.0 if done | (w[2272 + lane] == 0.0) else 1.0
        w[2272 + lane] = going
        left += 1 if going == 1.0 else 0
    return left


@straight
def _settle_joints(w, n):
    """Mark the poses for which this step was the last; return how many go on."""
    left = 0
    for lane in range(n):
        done = (w[2720 + lane] > 0.0)
        done = done & (abs(w[2624 + lane]) < TURN_DONE)
        done = done & (abs(w[2656 + lane]) < STEP_DONE)
        done = done & (abs(w[2688 + lane]) < TURN_DONE)
        going = 0.0 if done | (w[2272 + lane] == 0.0) else 1.0
        w[2272 + lane] = going
        left += 1 if going == 1.0 else 0
    return left


@straight
def _begin(w, n):
    """Let all poses go."""
    for lane in range(n):
        w[2272 + lane] = 1.0
        w[2144 + lane] = 0.0
        w[2176 + lane] = 0.0
        w[2208 + lane] = 0.0


@straight
def _started(w, n):
    """Take joints, and coordinates that no command asks for, from the simplified machine."""
    for lane in range(n):
        w[2272 + lane] = 0.0 if (abs(w[1120 + lane]) < math.inf) else 1.0
        w[0 + lane] = w[1120 + lane]
        w[160 + lane] = w[1152 + lane]
        w[192 + lane] = w[1184 + lane]


@straight
def _turn_joints(w, n):
    """Move the joints by a step; what it does to the platform is left to `_move`."""
    for lane in range(n):
        going = w[2272 + lane]
        w[0 + lane] -= going * w[2624 + lane]
        w[2176 + lane] = w[2656 + lane]
        w[2208 + lane] = w[2688 + lane]

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
        is_open = w[2272 + lane] != 0.0
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
    w_1 = w[0:2144]
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
    w_1 = w[0:2144]
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
        own = machines[28 * (m // (runs // k.shape[0])) :]
        held = tools[3 * (m // (runs // tool.shape[0])) :]
        left += _simplified_forward_of(given[1 * each * m :], held, own, found[3 * each * m :], status[each * m :], each)
    return left


@straight
def _simplified_forward_of(q, tool, own, x, status, poses):
    """Solve the poses of one machine with one tool; return how many are left open."""
    left = 0
    tx = tool[0]
    ty = tool[1]
    h_0 = own[0 + 0]
    q0_0 = own[0 + 1]
    s7_0 = own[0 + 2]
    b1_x_0 = own[0 + 3]
    A1_x_0 = own[0 + 8]
    s116_0 = own[0 + 13]
    s124_0 = own[0 + 16]
    s130_0 = own[0 + 17]
    s134_0 = own[0 + 18]
    s138_0 = own[0 + 20]
    s153_0 = own[0 + 22]
    s156_0 = own[0 + 23]
    s160_0 = own[0 + 25]
    s195_0 = own[0 + 27]
    for n in range(poses):
        q_0 = q[1 * n + 0]
        C_y_0 = -h_0 + ty
        s8_0 = q_0 + q0_0
        r1_x_0 = s7_0*sine(s8_0)
        r1_y_0 = -s7_0*cosine(s8_0)
        s22_0 = b1_x_0 - tx
        s185_0 = r1_x_0*s116_0 + r1_y_0*s130_0 + r1_y_0*s134_0 + s124_0
        s190_0 = r1_x_0*s130_0 + r1_x_0*s134_0 - r1_y_0*s116_0 + s138_0
        s198_0 = (r1_x_0 * r1_x_0) + r1_x_0*s153_0 + r1_x_0*s156_0 + (r1_y_0 * r1_y_0) + r1_y_0*s195_0 + s160_0
        s201_0 = math.sqrt((s185_0 * s185_0) + (s190_0 * s190_0) - (s198_0 * s198_0))
        s204_0 = -s185_0*s198_0 + s190_0*s201_0
        s208_0 = -s185_0*s201_0 - s190_0*s198_0
        s211_0 = 1/math.sqrt((s204_0 * s204_0) + (s208_0 * s208_0))
        s214_0 = A1_x_0 - C_y_0*s204_0*s211_0 + r1_x_0 - s208_0*s211_0*s22_0
        s217_0 = C_y_0*s208_0*s211_0 + r1_y_0 - s204_0*s211_0*s22_0
        s221_0 = 2*tangent(0.5*arctangent(s204_0, s208_0))
        p_0 = s214_0
        p_1 = s217_0
        p_2 = s221_0
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
    w_1 = w[0:2144]
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
        whole = 27 * (first + lane + 8) <= S_p.size  # else the last poses are written through scratch
        to, at = (S_p, 27 * (first + lane)) if whole else (w[WORK:], 0)
        for i in range(1):
            outer(to, at + 9 * i + 0, 27, 9, 3, w, (2304 + 0 * i + lane, 2336 + 0 * i + lane, 2368 + 0 * i + lane, ), 96, (1280 + 2144 * i + lane, 1568 + 2144 * i + lane, 1856 + 2144 * i + lane, ), 32, 8)
            outer(to, at + 9 * i + 8, 27, 9, 3, w, (2304 + 0 * i + lane, 2336 + 0 * i + lane, 2368 + 0 * i + lane, ), 96, (1536 + 2144 * i + lane, 1824 + 2144 * i + lane, 2112 + 2144 * i + lane, ), 32, 1)
        if not whole:
            for c in range(27 * (last + 1 - first - lane)):
                S_p[27 * (first + lane) + c] = to[c]
        whole = 3 * (first + lane + 8) <= S_q.size  # else the last poses are written through scratch
        to, at = (S_q, 3 * (first + lane)) if whole else (w[WORK:], 0)
        for i in range(1):
            outer(to, at + 1 * i + 0, 3, 1, 3, w, (2304 + 0 * i + lane, 2336 + 0 * i + lane, 2368 + 0 * i + lane, ), 96, (480 + 2144 * i + lane, 640 + 2144 * i + lane, 800 + 2144 * i + lane, ), 32, 1)
        if not whole:
            for c in range(3 * (last + 1 - first - lane)):
                S_q[3 * (first + lane) + c] = to[c]
    left = 0
    for lane in range(last - first + 1):
        regular = (w[2592 + lane] > 0.0)
        status[first + lane] = SOLVED if regular else OPEN
        left += 0 if regular else 1
    return left


def sensitivity(x, q, tool, k, S_p, S_q, status):
    """Fill the derivatives of the exact pose: S_p (N, 3, 9) by errors and deflections, S_q (N, 3, 1) by joints.

    Rows are px, py, then turns of the platform about
    the axes of {O}. Columns of S_p run limb by limb. S_q is the velocity Jacobian.
    """
    if _sensitivity(x, q, tool, k, S_p, S_q, status):
        left = np.flatnonzero(status == OPEN)
        by_errors, by_joints, of = (
            np.empty((len(left), 3, 9)), np.empty((len(left), 3, 1)),
            np.zeros(len(left), dtype=np.int64),
        )
        vectorised.sensitivity(
            x[left], q[left], _of(tool, left, len(status)), _of(k, left, len(status)), by_errors, by_joints, of
        )
        S_p[left], S_q[left], status[left] = by_errors, by_joints, of

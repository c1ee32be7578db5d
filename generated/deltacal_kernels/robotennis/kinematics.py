"""Kinematics of `robotennis`, many poses at once: RoboTennis, three arms with rods as single links, incremental home.

Generated from derive/mechanisms/robotennis.py by "deltacal kernels". Do not edit.
Template templates/mechanism/kinematics.py.jinja; sha256 of both 3faa7b1c8cab7651; SymPy 1.14.0.

Arrays are C-contiguous float64, the pose first, lengths in mm, angles in rad:

x (N, 3)  platform: px py pz
q (N, 3)  joints        tool (N or 1, 3)  reference point in {O'}
p (M, 3, 19)  one row of parameters per limb: a b h H phi hx hy hz a b h theta0 phi H px0 py0 pz0 tip_v tip_w
k (M, 3, 24)  what `constants` makes of p; each of the M machines has N / M of the poses, one after the other

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
SIMPLIFIED = 3  # coordinates that `simplified_forward` gives: the others are zero
fast = kernel(nogil=True, error_model="numpy", fastmath={"contract"})


@straight
def _early(w, k, n):
    """What moves with a joint only; then the simplified limb as a sphere |P|^2 - 2 c.P + d = 0: c, d (30 operations)."""
    theta0 = k[0]
    u_x = k[1]
    u_y = k[2]
    s11 = k[3]
    s14 = k[4]
    s16 = k[5]
    s20 = k[6]
    s22 = k[7]
    tip_v = k[8]
    pz0 = k[11]
    s96 = k[15]
    s98 = k[16]
    s100 = k[17]
    s102 = k[18]
    s45 = k[23]
    for lane in range(n):
        q = w[0 + lane]
        tx = w[32 + lane]
        ty = w[64 + lane]
        tz = w[96 + lane]
        s6 = q + theta0
        s7 = cosine(s6)
        arm_x = s7*u_x
        arm_y = s7*u_y
        arm_z = sine(s6)
        B_x = arm_x*s11 + arm_z*s14 + s16
        B_y = arm_y*s11 + arm_z*s20 + s22
        s24 = arm_z*s11
        B_z = s24 + s7*tip_v
        s138 = -s7*s98 - s96 + tx
        s140 = -s100 - s102*s7 + ty
        s141 = -pz0 + s24 + tz
        s145 = (s138 * s138) + (s140 * s140) + (s141 * s141) - s45
        w[384 + lane] = B_x
        w[416 + lane] = B_y
        w[448 + lane] = B_z
        w[480 + lane] = s138
        w[512 + lane] = s140
        w[544 + lane] = s141
        w[576 + lane] = s145


@straight
def _rows(w, k, n):
    """Equations of a limb, their derivatives by shift and turn of the platform (20 operations)."""
    px0 = k[9]
    py0 = k[10]
    pz0 = k[11]
    s31 = k[12]
    s33 = k[13]
    s46 = k[14]
    for lane in range(n):
        tx = w[32 + lane]
        ty = w[64 + lane]
        tz = w[96 + lane]
        px = w[128 + lane]
        py = w[160 + lane]
        pz = w[192 + lane]
        B_x = w[384 + lane]
        B_y = w[416 + lane]
        B_z = w[448 + lane]
        centre_x = px + px0 - tx
        centre_y = py + py0 - ty
        centre_z = pz + pz0 - tz
        C_x = centre_x + s31
        C_y = centre_y + s33
        rod_x = -B_x + C_x
        rod_y = -B_y + C_y
        rod_z = -B_z + centre_z
        s47 = 0.5*(rod_x * rod_x) + 0.5*(rod_y * rod_y) + 0.5*(rod_z * rod_z) + s46
        w[224 + lane] = s47
        w[256 + lane] = rod_x
        w[288 + lane] = rod_y
        w[320 + lane] = rod_z


@straight
def _step(w, n):
    """Newton's step of the platform; how far the equations are from dependent (77 operations)."""
    for lane in range(n):
        F00 = w[224 + lane]
        J00_0 = w[256 + lane]
        J00_1 = w[288 + lane]
        J00_2 = w[320 + lane]
        F10 = w[1440 + lane]
        J10_0 = w[1472 + lane]
        J10_1 = w[1504 + lane]
        J10_2 = w[1536 + lane]
        F20 = w[2656 + lane]
        J20_0 = w[2688 + lane]
        J20_1 = w[2720 + lane]
        J20_2 = w[2752 + lane]
        G_cof_00 = J10_1*J20_2 - J10_2*J20_1
        G_cof_01 = -J10_0*J20_2 + J10_2*J20_0
        G_cof_02 = J10_0*J20_1 - J10_1*J20_0
        G_cof_10 = -J00_1*J20_2 + J00_2*J20_1
        G_cof_11 = J00_0*J20_2 - J00_2*J20_0
        G_cof_12 = -J00_0*J20_1 + J00_1*J20_0
        G_cof_20 = J00_1*J10_2 - J00_2*J10_1
        G_cof_21 = -J00_0*J10_2 + J00_2*J10_0
        G_cof_22 = J00_0*J10_1 - J00_1*J10_0
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
        u_00 = F00*G_inv_00 + F10*G_inv_01 + F20*G_inv_02
        u_10 = F00*G_inv_10 + F10*G_inv_11 + F20*G_inv_12
        u_20 = F00*G_inv_20 + F10*G_inv_21 + F20*G_inv_22
        s61 = (J10_0 * J10_0) + (J10_1 * J10_1) + (J10_2 * J10_2)
        s65 = (J20_0 * J20_0) + (J20_1 * J20_1) + (J20_2 * J20_2)
        s67 = (G_det_00 * G_det_00) - 1.0e-12*s61*s65*((J00_0 * J00_0) + (J00_1 * J00_1) + (J00_2 * J00_2))
        w[3648 + lane] = u_00
        w[3680 + lane] = u_10
        w[3712 + lane] = u_20
        w[3744 + lane] = s67


@straight
def _start(w, k, n):
    """Joint of the simplified limb at a given position (35 operations)."""
    theta0 = k[0]
    pz0 = k[11]
    s96 = k[15]
    s98 = k[16]
    s100 = k[17]
    s102 = k[18]
    s117 = k[19]
    s124 = k[20]
    s129 = k[21]
    for lane in range(n):
        tx = w[32 + lane]
        ty = w[64 + lane]
        tz = w[96 + lane]
        px = w[128 + lane]
        py = w[160 + lane]
        pz = w[192 + lane]
        centre_z = pz + pz0 - tz
        s97 = px + s96 - tx
        s101 = py + s100 - ty
        s104 = s101*s102 + s97*s98
        s106 = (centre_z * centre_z)
        s118 = 0.5*(s101 * s101) + 0.5*s106 + s117 + 0.5*(s97 * s97)
        s127 = math.sqrt((s104 * s104) + s106*s124 - (s118 * s118))
        s136 = -theta0 + arctangent(centre_z*s118*s129 + s104*s127, centre_z*s127*s129 - s104*s118)
        w[608 + lane] = s136


@straight
def _more(w, k, n):
    """What else derivatives by joint and errors read of it (16 operations)."""
    theta0 = k[0]
    u_x = k[1]
    u_y = k[2]
    s11 = k[3]
    s14 = k[4]
    s20 = k[6]
    tip_v = k[8]
    s98 = k[16]
    s102 = k[18]
    for lane in range(n):
        q = w[0 + lane]
        s6 = q + theta0
        s7 = cosine(s6)
        arm_x = s7*u_x
        arm_y = s7*u_y
        arm_z = sine(s6)
        s148 = -arm_z*s98 - s14*s7
        s152 = -arm_z*s102 - s20*s7
        s156 = arm_z*tip_v - s11*s7
        w[640 + lane] = s7
        w[672 + lane] = arm_z
        w[704 + lane] = arm_y
        w[736 + lane] = arm_x
        w[768 + lane] = s148
        w[800 + lane] = s152
        w[832 + lane] = s156


@straight
def _joints(w, k, n):
    """Derivatives of a limb's equations by its joint (16 operations)."""
    px0 = k[9]
    py0 = k[10]
    pz0 = k[11]
    s31 = k[12]
    s33 = k[13]
    for lane in range(n):
        tx = w[32 + lane]
        ty = w[64 + lane]
        tz = w[96 + lane]
        px = w[128 + lane]
        py = w[160 + lane]
        pz = w[192 + lane]
        B_x = w[384 + lane]
        B_y = w[416 + lane]
        B_z = w[448 + lane]
        s148 = w[768 + lane]
        s152 = w[800 + lane]
        s156 = w[832 + lane]
        centre_x = px + px0 - tx
        centre_y = py + py0 - ty
        centre_z = pz + pz0 - tz
        C_x = centre_x + s31
        C_y = centre_y + s33
        rod_x = -B_x + C_x
        rod_y = -B_y + C_y
        rod_z = -B_z + centre_z
        s158 = rod_x*s148 + rod_y*s152 + rod_z*s156
        w[352 + lane] = s158


@straight
def _command(w, n):
    """Newton's step of joints and rotation; how far the equations are from dependent (33 operations)."""
    for lane in range(n):
        F00 = w[224 + lane]
        J00_0 = w[256 + lane]
        J00_1 = w[288 + lane]
        J00_2 = w[320 + lane]
        Q00 = w[352 + lane]
        F10 = w[1440 + lane]
        J10_0 = w[1472 + lane]
        J10_1 = w[1504 + lane]
        J10_2 = w[1536 + lane]
        Q10 = w[1568 + lane]
        F20 = w[2656 + lane]
        J20_0 = w[2688 + lane]
        J20_1 = w[2720 + lane]
        J20_2 = w[2752 + lane]
        Q20 = w[2784 + lane]
        s1 = F00/Q00
        s3 = F10/Q10
        s5 = F20/Q20
        s13 = -1.0e-12*(J00_0 * J00_0) - 1.0e-12*(J00_1 * J00_1) - 1.0e-12*(J00_2 * J00_2) + (Q00 * Q00)
        s21 = -1.0e-12*(J10_0 * J10_0) - 1.0e-12*(J10_1 * J10_1) - 1.0e-12*(J10_2 * J10_2) + (Q10 * Q10)
        s29 = -1.0e-12*(J20_0 * J20_0) - 1.0e-12*(J20_1 * J20_1) - 1.0e-12*(J20_2 * J20_2) + (Q20 * Q20)
        w[4128 + lane] = s1
        w[4160 + lane] = s3
        w[4192 + lane] = s5
        w[4224 + lane] = s13
        w[4256 + lane] = s21
        w[4288 + lane] = s29


@straight
def _errors(w, k, n):
    """Derivatives of a limb's equations by errors, by deflections (78 operations)."""
    u_x = k[1]
    u_y = k[2]
    s11 = k[3]
    s14 = k[4]
    s16 = k[5]
    s20 = k[6]
    s22 = k[7]
    tip_v = k[8]
    px0 = k[9]
    py0 = k[10]
    pz0 = k[11]
    s31 = k[12]
    s33 = k[13]
    s77 = k[22]
    for lane in range(n):
        tx = w[32 + lane]
        ty = w[64 + lane]
        tz = w[96 + lane]
        px = w[128 + lane]
        py = w[160 + lane]
        pz = w[192 + lane]
        B_x = w[384 + lane]
        B_y = w[416 + lane]
        B_z = w[448 + lane]
        s7 = w[640 + lane]
        arm_z = w[672 + lane]
        arm_y = w[704 + lane]
        arm_x = w[736 + lane]
        centre_x = px + px0 - tx
        centre_y = py + py0 - ty
        centre_z = pz + pz0 - tz
        C_x = centre_x + s31
        C_y = centre_y + s33
        rod_x = -B_x + C_x
        rod_y = -B_y + C_y
        rod_z = -B_z + centre_z
        s48 = 2*rod_z
        s49 = 0.5*s48
        s50 = 2*rod_y
        s51 = 0.5*s50
        s52 = 2*rod_x
        s53 = 0.5*s52
        s59 = -arm_z*s51
        s60 = -s11*s51
        s63 = -arm_z*s53
        s64 = -s11*s53
        s73 = -arm_z*(-s49*tip_v + s60*u_y + s64*u_x)
        s74 = s7*(-s11*s49 - s14*s53 - s20*s51) + s73
        s75 = -arm_x*s53 - arm_y*s51 - arm_z*s49
        s80 = s51*u_y + s53*u_x
        s86 = -s20*s63
        s87 = s60*s7*u_x
        s88 = -s64*s7*u_y
        s89 = s14*s59 - s16*s51 + s22*s53 + s31*s51 - s33*s53 + s86 + s87 + s88
        s92 = -s49*s7 - s59*u_y - s63*u_x
        s95 = s51*u_x - s53*u_y
        w[864 + lane] = s75
        w[896 + lane] = s77
        w[928 + lane] = s80
        w[960 + lane] = s74
        w[992 + lane] = s89
        w[1024 + lane] = -s80
        w[1056 + lane] = s53
        w[1088 + lane] = s51
        w[1120 + lane] = s49
        w[1152 + lane] = s92
        w[1184 + lane] = s95


@straight
def _inverse_of_rows(w, n):
    """Minus the inverse of the derivatives, row by row; how far the equations are from dependent (71 operations)."""
    for lane in range(n):
        J00_0 = w[256 + lane]
        J00_1 = w[288 + lane]
        J00_2 = w[320 + lane]
        J10_0 = w[1472 + lane]
        J10_1 = w[1504 + lane]
        J10_2 = w[1536 + lane]
        J20_0 = w[2688 + lane]
        J20_1 = w[2720 + lane]
        J20_2 = w[2752 + lane]
        G_cof_00 = J10_1*J20_2 - J10_2*J20_1
        G_cof_01 = -J10_0*J20_2 + J10_2*J20_0
        G_cof_02 = J10_0*J20_1 - J10_1*J20_0
        G_cof_10 = -J00_1*J20_2 + J00_2*J20_1
        G_cof_11 = J00_0*J20_2 - J00_2*J20_0
        G_cof_12 = -J00_0*J20_1 + J00_1*J20_0
        G_cof_20 = J00_1*J10_2 - J00_2*J10_1
        G_cof_21 = -J00_0*J10_2 + J00_2*J10_0
        G_cof_22 = J00_0*J10_1 - J00_1*J10_0
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
        s61 = (J10_0 * J10_0) + (J10_1 * J10_1) + (J10_2 * J10_2)
        s65 = (J20_0 * J20_0) + (J20_1 * J20_1) + (J20_2 * J20_2)
        s67 = (G_det_00 * G_det_00) - 1.0e-12*s61*s65*((J00_0 * J00_0) + (J00_1 * J00_1) + (J00_2 * J00_2))
        w[3808 + lane] = -G_inv_00
        w[3840 + lane] = -G_inv_01
        w[3872 + lane] = -G_inv_02
        w[3904 + lane] = -G_inv_10
        w[3936 + lane] = -G_inv_11
        w[3968 + lane] = -G_inv_12
        w[4000 + lane] = -G_inv_20
        w[4032 + lane] = -G_inv_21
        w[4064 + lane] = -G_inv_22
        w[4096 + lane] = s67


@straight
def _move(w, n):
    """The platform after a step, and its rotation matrix (6 operations)."""
    for lane in range(n):
        px = w[128 + lane]
        py = w[160 + lane]
        pz = w[192 + lane]
        y0 = w[3648 + lane]
        y1 = w[3680 + lane]
        y2 = w[3712 + lane]
        going = w[3776 + lane]
        new_00 = -going*y0 + px
        new_10 = -going*y1 + py
        new_20 = -going*y2 + pz
        w[128 + lane] = new_00
        w[1344 + lane] = new_00
        w[2560 + lane] = new_00
        w[160 + lane] = new_10
        w[1376 + lane] = new_10
        w[2592 + lane] = new_10
        w[192 + lane] = new_20
        w[1408 + lane] = new_20
        w[2624 + lane] = new_20


@straight
def _meet(w, n):
    """Put the platform where the simplified machine has it."""
    for lane in range(n):
        c_00 = w[480 + lane]
        c_01 = w[512 + lane]
        c_02 = w[544 + lane]
        c_03 = w[576 + lane]
        c_10 = w[1696 + lane]
        c_11 = w[1728 + lane]
        c_12 = w[1760 + lane]
        c_13 = w[1792 + lane]
        c_20 = w[2912 + lane]
        c_21 = w[2944 + lane]
        c_22 = w[2976 + lane]
        c_23 = w[3008 + lane]
        a_x = -c_00 + c_10
        a_y = -c_01 + c_11
        a_z = -c_02 + c_12
        b_x = -c_00 + c_20
        b_y = -c_01 + c_21
        b_z = -c_02 + c_22
        s7 = -0.5*c_03
        to_a = 0.5*c_13 + s7
        to_b = 0.5*c_23 + s7
        aa = (a_x * a_x) + (a_y * a_y) + (a_z * a_z)
        n_x = a_y*b_z - a_z*b_y
        n_y = -a_x*b_z + a_z*b_x
        n_z = a_x*b_y - a_y*b_x
        nn = (n_x * n_x) + (n_y * n_y) + (n_z * n_z)
        bb = (b_x * b_x) + (b_y * b_y) + (b_z * b_z)
        ab = a_x*b_x + a_y*b_y + a_z*b_z
        inverse = (1.0 / nn)
        by_a = inverse*(-ab*to_b + bb*to_a)
        by_b = inverse*(aa*to_b - ab*to_a)
        p_x = a_x*by_a + b_x*by_b
        p_y = a_y*by_a + b_y*by_b
        p_z = a_z*by_a + b_z*by_b
        half = inverse*(n_x*(-c_00 + p_x) + n_y*(-c_01 + p_y) + n_z*(-c_02 + p_z))
        s66 = -2*c_01*p_y
        s67 = -2*c_02*p_z
        rest = -2*c_00*p_x + c_03 + (p_x * p_x) + (p_y * p_y) + (p_z * p_z) + s66 + s67
        under = (half * half) - inverse*rest
        kept = (under if (under > 0) else 0)
        s73 = math.sqrt(kept)
        along = -half + (s73 if (n_z > 0) else -s73)
        s77 = along*n_x + p_x
        s79 = along*n_y + p_y
        s81 = along*n_z + p_z
        s82 = nn*under
        s83 = aa*bb
        p_0 = s77
        p_1 = s79
        p_2 = s81
        clear = s82
        square = nn
        wide = s83
        good = (clear > CLEAR * CLEAR) & (square > APART * wide)
        w[3776 + lane] = 0.0 if good else 1.0
        w[128 + lane] = p_0
        w[160 + lane] = p_1
        w[192 + lane] = p_2


@straight
def _settle(w, n):
    """Mark the poses for which this step was the last; return how many go on."""
    left = 0
    for lane in range(n):
        done = (w[3744 + lane] > 0.0)
        done = done & (abs(w[3648 + lane]) < STEP_DONE)
        done = done & (abs(w[3680 + lane]) < STEP_DONE)
        done = done & (abs(w[3712 + lane]) < STEP_DONE)

        going = 0.0 if done | (w[3776 + lane] == 0.0) else 1.0
        w[3776 + lane] = going
        left += 1 if going == 1.0 else 0
    return left


@straight
def _settle_joints(w, n):
    """Mark the poses for which this step was the last; return how many go on."""
    left = 0
    for lane in range(n):
        done = (w[4224 + lane] > 0.0)
        done = done & (w[4256 + lane] > 0.0)
        done = done & (w[4288 + lane] > 0.0)
        done = done & (abs(w[4128 + lane]) < TURN_DONE)
        done = done & (abs(w[4160 + lane]) < TURN_DONE)
        done = done & (abs(w[4192 + lane]) < TURN_DONE)


        going = 0.0 if done | (w[3776 + lane] == 0.0) else 1.0
        w[3776 + lane] = going
        left += 1 if going == 1.0 else 0
    return left


@straight
def _begin(w, n):
    """Let all poses go."""
    for lane in range(n):
        w[3776 + lane] = 1.0
        w[3648 + lane] = 0.0
        w[3680 + lane] = 0.0
        w[3712 + lane] = 0.0


@straight
def _started(w, n):
    """Take joints, and coordinates that no command asks for, from the simplified machine."""
    for lane in range(n):
        w[3776 + lane] = 0.0 if (abs(w[608 + lane]) < math.inf) & (abs(w[1824 + lane]) < math.inf) & (abs(w[3040 + lane]) < math.inf) else 1.0
        w[0 + lane] = w[608 + lane]
        w[1216 + lane] = w[1824 + lane]
        w[2432 + lane] = w[3040 + lane]


@straight
def _turn_joints(w, n):
    """Move the joints by a step; what it does to the platform is left to `_move`."""
    for lane in range(n):
        going = w[3776 + lane]
        w[0 + lane] -= going * w[4128 + lane]
        w[1216 + lane] -= going * w[4160 + lane]
        w[2432 + lane] -= going * w[4192 + lane]

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
        is_open = w[3776 + lane] != 0.0
        status[first + lane] = OPEN if is_open else SOLVED
        left += 1 if is_open else 0
    return left


@straight
def _unload_joints(w, q, first, last):
    for lane in range(last - first + 1):
        q[3 * (first + lane) + 0] = w[0 + lane]
        q[3 * (first + lane) + 1] = w[1216 + lane]
        q[3 * (first + lane) + 2] = w[2432 + lane]


@fast
def _forward(q, tool, k, x, status, warm):
    w = scratch(WORK + SPARE)
    w_1 = w[0:1216]
    w_2 = w[1216:2432]
    w_3 = w[2432:3648]
    if len(tool) == 1:
        hold(tool, w, 0, 0, LANES)
    left, machines = 0, k.shape[0]
    each = status.size // machines
    for m in range(machines):
        k_1 = k[m, 0]
        k_2 = k[m, 1]
        k_3 = k[m, 2]
        for first in range(m * each, (m + 1) * each, LANES):
            last = min(first + LANES, (m + 1) * each) - 1
            n = (last - first + 8) // 8 * 8
            load(q, w, first, last, n)
            if len(tool) > 1:
                hold(tool, w, first, last, n)
            _early(w_1, k_1, n)
            _early(w_2, k_2, n)
            _early(w_3, k_3, n)
            if warm:
                _place(x, w, first, last, n)
            else:
                _meet(w, n)
            _begin(w, n)
            _move(w, n)
            for _ in range(MAX_STEPS):
                _rows(w_1, k_1, n)
                _rows(w_2, k_2, n)
                _rows(w_3, k_3, n)
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
    w_1 = w[0:1216]
    w_2 = w[1216:2432]
    w_3 = w[2432:3648]
    if len(tool) == 1:
        hold(tool, w, 0, 0, LANES)
    left, machines = 0, k.shape[0]
    each = status.size // machines
    for m in range(machines):
        k_1 = k[m, 0]
        k_2 = k[m, 1]
        k_3 = k[m, 2]
        for first in range(m * each, (m + 1) * each, LANES):
            last = min(first + LANES, (m + 1) * each) - 1
            n = (last - first + 8) // 8 * 8
            load(target, w, first, last, n)
            if len(tool) > 1:
                hold(tool, w, first, last, n)
            aim(w, n)
            _start(w_1, k_1, n)
            _start(w_2, k_2, n)
            _start(w_3, k_3, n)
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
                _early(w_3, k_3, n)
                _more(w_3, k_3, n)
                _rows(w_3, k_3, n)
                _joints(w_3, k_3, n)
                _command(w, n)
                _turn_joints(w, n)
                _move(w, n)
                if _settle_joints(w, n) == 0:
                    break
            left += _unload(w, x, status, first, last)
            _unload_joints(w, q, first, last)
    return left


def inverse(target, tool, k, x, q, status):
    """Fill the joints q (N, 3) that bring the reference point to target (N, 3), and the pose x (N, 3) it then has.

    Newton on the joints and the platform's rotation from the simplified machine. status as in `forward`; UNREACHABLE
    where the target lies beyond the reach of a limb.
    """
    if _inverse(target, tool, k, x, q, status):
        left = np.flatnonzero(status == OPEN)
        found, joints, of = (
            np.empty((len(left), 3)), np.empty((len(left), 3)), np.zeros(len(left), dtype=np.int64)
        )
        vectorised.inverse(target[left], _of(tool, left, len(status)), _of(k, left, len(status)), found, joints, of)
        x[left], q[left], status[left] = found, joints, of


@fast
def _simplified_forward(q, tool, k, x, status):
    given, found = q.reshape(q.size), x.reshape(x.size)
    machines, tools = k.reshape(k.size), tool.reshape(tool.size)
    left, runs = 0, max(k.shape[0], tool.shape[0])
    w = scratch(12 * SPHERES)
    each = status.size // runs
    for m in range(runs):
        own = machines[72 * (m // (runs // k.shape[0])) :]
        held = tools[3 * (m // (runs // tool.shape[0])) :]
        left += _simplified_forward_of(given[3 * each * m :], held, own, found[3 * each * m :], status[each * m :], each, w)
    return left


@straight
def _simplified_forward_of(q, tool, own, x, status, poses, w):
    """Solve the poses of one machine with one tool; return how many are left open."""
    left = 0
    tx = tool[0]
    ty = tool[1]
    tz = tool[2]
    theta0_0 = own[0 + 0]
    s11_0 = own[0 + 3]
    pz0_0 = own[0 + 11]
    s96_0 = own[0 + 15]
    s98_0 = own[0 + 16]
    s100_0 = own[0 + 17]
    s102_0 = own[0 + 18]
    s45_0 = own[0 + 23]
    theta0_1 = own[24 + 0]
    s11_1 = own[24 + 3]
    pz0_1 = own[24 + 11]
    s96_1 = own[24 + 15]
    s98_1 = own[24 + 16]
    s100_1 = own[24 + 17]
    s102_1 = own[24 + 18]
    s45_1 = own[24 + 23]
    theta0_2 = own[48 + 0]
    s11_2 = own[48 + 3]
    pz0_2 = own[48 + 11]
    s96_2 = own[48 + 15]
    s98_2 = own[48 + 16]
    s100_2 = own[48 + 17]
    s102_2 = own[48 + 18]
    s45_2 = own[48 + 23]
    for first in range(0, poses, SPHERES):  # in two short loops, of which a processor has several rounds at work
        count = min(SPHERES, poses - first)
        for lane in range(count):
            n = first + lane
            q_0 = q[3 * n + 0]
            s6_0 = q_0 + theta0_0
            s7_0 = cosine(s6_0)
            arm_z_0 = sine(s6_0)
            s138_0 = -s7_0*s98_0 - s96_0 + tx
            s140_0 = -s100_0 - s102_0*s7_0 + ty
            s141_0 = arm_z_0*s11_0 - pz0_0 + tz
            s145_0 = (s138_0 * s138_0) + (s140_0 * s140_0) + (s141_0 * s141_0) - s45_0
            c_00 = s138_0
            c_01 = s140_0
            c_02 = s141_0
            c_03 = s145_0
            q_1 = q[3 * n + 1]
            s6_1 = q_1 + theta0_1
            s7_1 = cosine(s6_1)
            arm_z_1 = sine(s6_1)
            s138_1 = -s7_1*s98_1 - s96_1 + tx
            s140_1 = -s100_1 - s102_1*s7_1 + ty
            s141_1 = arm_z_1*s11_1 - pz0_1 + tz
            s145_1 = (s138_1 * s138_1) + (s140_1 * s140_1) + (s141_1 * s141_1) - s45_1
            c_10 = s138_1
            c_11 = s140_1
            c_12 = s141_1
            c_13 = s145_1
            q_2 = q[3 * n + 2]
            s6_2 = q_2 + theta0_2
            s7_2 = cosine(s6_2)
            arm_z_2 = sine(s6_2)
            s138_2 = -s7_2*s98_2 - s96_2 + tx
            s140_2 = -s100_2 - s102_2*s7_2 + ty
            s141_2 = arm_z_2*s11_2 - pz0_2 + tz
            s145_2 = (s138_2 * s138_2) + (s140_2 * s140_2) + (s141_2 * s141_2) - s45_2
            c_20 = s138_2
            c_21 = s140_2
            c_22 = s141_2
            c_23 = s145_2
            w[0 * SPHERES + lane], w[1 * SPHERES + lane], w[2 * SPHERES + lane], w[3 * SPHERES + lane] = c_00, c_01, c_02, c_03
            w[4 * SPHERES + lane], w[5 * SPHERES + lane], w[6 * SPHERES + lane], w[7 * SPHERES + lane] = c_10, c_11, c_12, c_13
            w[8 * SPHERES + lane], w[9 * SPHERES + lane], w[10 * SPHERES + lane], w[11 * SPHERES + lane] = c_20, c_21, c_22, c_23
        for lane in range(count):
            n = first + lane
            c_00 = w[0 + lane]
            c_01 = w[128 + lane]
            c_02 = w[256 + lane]
            c_03 = w[384 + lane]
            c_10 = w[512 + lane]
            c_11 = w[640 + lane]
            c_12 = w[768 + lane]
            c_13 = w[896 + lane]
            c_20 = w[1024 + lane]
            c_21 = w[1152 + lane]
            c_22 = w[1280 + lane]
            c_23 = w[1408 + lane]
            a_x = -c_00 + c_10
            a_y = -c_01 + c_11
            a_z = -c_02 + c_12
            b_x = -c_00 + c_20
            b_y = -c_01 + c_21
            b_z = -c_02 + c_22
            s7 = -0.5*c_03
            to_a = 0.5*c_13 + s7
            to_b = 0.5*c_23 + s7
            aa = (a_x * a_x) + (a_y * a_y) + (a_z * a_z)
            n_x = a_y*b_z - a_z*b_y
            n_y = -a_x*b_z + a_z*b_x
            n_z = a_x*b_y - a_y*b_x
            nn = (n_x * n_x) + (n_y * n_y) + (n_z * n_z)
            bb = (b_x * b_x) + (b_y * b_y) + (b_z * b_z)
            ab = a_x*b_x + a_y*b_y + a_z*b_z
            inverse = (1.0 / nn)
            by_a = inverse*(-ab*to_b + bb*to_a)
            by_b = inverse*(aa*to_b - ab*to_a)
            p_x = a_x*by_a + b_x*by_b
            p_y = a_y*by_a + b_y*by_b
            p_z = a_z*by_a + b_z*by_b
            half = inverse*(n_x*(-c_00 + p_x) + n_y*(-c_01 + p_y) + n_z*(-c_02 + p_z))
            s66 = -2*c_01*p_y
            s67 = -2*c_02*p_z
            rest = -2*c_00*p_x + c_03 + (p_x * p_x) + (p_y * p_y) + (p_z * p_z) + s66 + s67
            under = (half * half) - inverse*rest
            kept = (under if (under > 0) else 0)
            s73 = math.sqrt(kept)
            along = -half + (s73 if (n_z > 0) else -s73)
            s77 = along*n_x + p_x
            s79 = along*n_y + p_y
            s81 = along*n_z + p_z
            s82 = nn*under
            s83 = aa*bb
            p_0 = s77
            p_1 = s79
            p_2 = s81
            clear = s82
            square = nn
            wide = s83
            good = (clear > CLEAR * CLEAR) & (square > APART * wide)
            x[3 * n + 0] = p_0
            x[3 * n + 1] = p_1
            x[3 * n + 2] = p_2
            status[n] = SOLVED if good else OPEN
            left += 0 if good else 1
    return left


def simplified_forward(q, tool, k, x, status):
    """Fill x (N, 3) with the platform of the simplified machine, in closed form: exact where tip_v, tip_w are zero.

    It does not turn, so that x is the position of the reference point.
    status as in `forward`.
    """
    if _simplified_forward(q, tool, k, x, status):
        left = np.flatnonzero(status == OPEN)
        found, of = np.empty((len(left), 3)), np.empty(len(left), dtype=status.dtype)
        forward(q[left], _of(tool, left, len(status)), _of(k, left, len(status)), found, of, False)
        x[left], status[left] = found[:, :3], of


@fast
def _simplified_inverse(target, tool, k, q, status):
    given, found = target.reshape(target.size), q.reshape(q.size)
    machines, tools = k.reshape(k.size), tool.reshape(tool.size)
    left, runs = 0, max(k.shape[0], tool.shape[0])
    each = status.size // runs
    for m in range(runs):
        own = machines[72 * (m // (runs // k.shape[0])) :]
        held = tools[3 * (m // (runs // tool.shape[0])) :]
        left += _simplified_inverse_of(given[3 * each * m :], held, own, found[3 * each * m :], status[each * m :], each)
    return left


@straight
def _simplified_inverse_of(target, tool, own, q, status, poses):
    """Solve the poses of one machine with one tool; return how many are left open."""
    left = 0
    tx = tool[0]
    ty = tool[1]
    tz = tool[2]
    theta0_0 = own[0 + 0]
    pz0_0 = own[0 + 11]
    s96_0 = own[0 + 15]
    s98_0 = own[0 + 16]
    s100_0 = own[0 + 17]
    s102_0 = own[0 + 18]
    s117_0 = own[0 + 19]
    s124_0 = own[0 + 20]
    s129_0 = own[0 + 21]
    theta0_1 = own[24 + 0]
    pz0_1 = own[24 + 11]
    s96_1 = own[24 + 15]
    s98_1 = own[24 + 16]
    s100_1 = own[24 + 17]
    s102_1 = own[24 + 18]
    s117_1 = own[24 + 19]
    s124_1 = own[24 + 20]
    s129_1 = own[24 + 21]
    theta0_2 = own[48 + 0]
    pz0_2 = own[48 + 11]
    s96_2 = own[48 + 15]
    s98_2 = own[48 + 16]
    s100_2 = own[48 + 17]
    s102_2 = own[48 + 18]
    s117_2 = own[48 + 19]
    s124_2 = own[48 + 20]
    s129_2 = own[48 + 21]
    for n in range(poses):
        px = target[3 * n + 0]
        py = target[3 * n + 1]
        pz = target[3 * n + 2]
        centre_z_0 = pz + pz0_0 - tz
        s97_0 = px + s96_0 - tx
        s101_0 = py + s100_0 - ty
        s104_0 = s101_0*s102_0 + s97_0*s98_0
        s106_0 = (centre_z_0 * centre_z_0)
        s118_0 = 0.5*(s101_0 * s101_0) + 0.5*s106_0 + s117_0 + 0.5*(s97_0 * s97_0)
        s127_0 = math.sqrt((s104_0 * s104_0) + s106_0*s124_0 - (s118_0 * s118_0))
        s136_0 = -theta0_0 + arctangent(centre_z_0*s118_0*s129_0 + s104_0*s127_0, centre_z_0*s127_0*s129_0 - s104_0*s118_0)
        q_00 = s136_0
        centre_z_1 = pz + pz0_1 - tz
        s97_1 = px + s96_1 - tx
        s101_1 = py + s100_1 - ty
        s104_1 = s101_1*s102_1 + s97_1*s98_1
        s106_1 = (centre_z_1 * centre_z_1)
        s118_1 = 0.5*(s101_1 * s101_1) + 0.5*s106_1 + s117_1 + 0.5*(s97_1 * s97_1)
        s127_1 = math.sqrt((s104_1 * s104_1) + s106_1*s124_1 - (s118_1 * s118_1))
        s136_1 = -theta0_1 + arctangent(centre_z_1*s118_1*s129_1 + s104_1*s127_1, centre_z_1*s127_1*s129_1 - s104_1*s118_1)
        q_10 = s136_1
        centre_z_2 = pz + pz0_2 - tz
        s97_2 = px + s96_2 - tx
        s101_2 = py + s100_2 - ty
        s104_2 = s101_2*s102_2 + s97_2*s98_2
        s106_2 = (centre_z_2 * centre_z_2)
        s118_2 = 0.5*(s101_2 * s101_2) + 0.5*s106_2 + s117_2 + 0.5*(s97_2 * s97_2)
        s127_2 = math.sqrt((s104_2 * s104_2) + s106_2*s124_2 - (s118_2 * s118_2))
        s136_2 = -theta0_2 + arctangent(centre_z_2*s118_2*s129_2 + s104_2*s127_2, centre_z_2*s127_2*s129_2 - s104_2*s118_2)
        q_20 = s136_2
        good = (abs(q_00) < math.inf) & (abs(q_10) < math.inf) & (abs(q_20) < math.inf)
        q[3 * n + 0] = q_00
        q[3 * n + 1] = q_10
        q[3 * n + 2] = q_20
        status[n] = SOLVED if good else OPEN
        left += 0 if good else 1
    return left


def simplified_inverse(target, tool, k, q, status):
    """Fill the joints q (N, 3) of the simplified machine, in closed form; see `simplified_forward` and `inverse`."""
    if _simplified_inverse(target, tool, k, q, status):
        left = np.flatnonzero(status == OPEN)
        found, joints, of = (
            np.empty((len(left), 3)), np.empty((len(left), 3)),
            np.empty(len(left), dtype=status.dtype),
        )
        inverse(target[left], _of(tool, left, len(status)), _of(k, left, len(status)), found, joints, of)
        q[left], status[left] = joints, of


@fast
def _sensitivity(x, q, tool, k, S_p, S_q, status):
    w, by_errors, by_joints = scratch(WORK + SPARE), S_p.reshape(S_p.size), S_q.reshape(S_q.size)
    w_1 = w[0:1216]
    w_2 = w[1216:2432]
    w_3 = w[2432:3648]
    if len(tool) == 1:
        hold(tool, w, 0, 0, LANES)
    left, machines = 0, k.shape[0]
    each = status.size // machines
    for m in range(machines):
        k_1 = k[m, 0]
        k_2 = k[m, 1]
        k_3 = k[m, 2]
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
            _early(w_3, k_3, n)
            _more(w_3, k_3, n)
            _rows(w_3, k_3, n)
            _joints(w_3, k_3, n)
            _errors(w_3, k_3, n)
            _inverse_of_rows(w, n)
            left += _products(w, by_errors, by_joints, status, first, last)
    return left


@fast
def _products(w, S_p, S_q, status, first, last):
    """Multiply the inverse and the derivatives by errors and joints; return how many poses are left open."""
    wide()
    for lane in range(0, last - first + 1, 8):
        whole = 99 * (first + lane + 8) <= S_p.size  # else the last poses are written through scratch
        to, at = (S_p, 99 * (first + lane)) if whole else (w[WORK:], 0)
        for i in range(3):
            outer(to, at + 11 * i + 0, 99, 33, 3, w, (3808 + 32 * i + lane, ), 96, (864 + 1216 * i + lane, ), 32, 8)
            outer(to, at + 11 * i + 8, 99, 33, 3, w, (3808 + 32 * i + lane, ), 96, (1120 + 1216 * i + lane, ), 32, 3)
        if not whole:
            for c in range(99 * (last + 1 - first - lane)):
                S_p[99 * (first + lane) + c] = to[c]
        whole = 9 * (first + lane + 8) <= S_q.size  # else the last poses are written through scratch
        to, at = (S_q, 9 * (first + lane)) if whole else (w[WORK:], 0)
        for i in range(3):
            outer(to, at + 1 * i + 0, 9, 3, 3, w, (3808 + 32 * i + lane, ), 96, (352 + 1216 * i + lane, ), 32, 1)
        if not whole:
            for c in range(9 * (last + 1 - first - lane)):
                S_q[9 * (first + lane) + c] = to[c]
    left = 0
    for lane in range(last - first + 1):
        regular = (w[4096 + lane] > 0.0)
        status[first + lane] = SOLVED if regular else OPEN
        left += 0 if regular else 1
    return left


def sensitivity(x, q, tool, k, S_p, S_q, status):
    """Fill the derivatives of the exact pose: S_p (N, 3, 33) by errors and deflections, S_q (N, 3, 3) by joints.

    Rows are px, py, pz, then turns of the platform about
    the axes of {O}. Columns of S_p run limb by limb. S_q is the velocity Jacobian.
    """
    if _sensitivity(x, q, tool, k, S_p, S_q, status):
        left = np.flatnonzero(status == OPEN)
        by_errors, by_joints, of = (
            np.empty((len(left), 3, 33)), np.empty((len(left), 3, 3)),
            np.zeros(len(left), dtype=np.int64),
        )
        vectorised.sensitivity(
            x[left], q[left], _of(tool, left, len(status)), _of(k, left, len(status)), by_errors, by_joints, of
        )
        S_p[left], S_q[left], status[left] = by_errors, by_joints, of

"""Kinematics of `hexapod`, many poses at once: Hexapod of Gough and Stewart, six legs.

Generated from derive/mechanisms/hexapod.py by "deltacal kernels". Do not edit.
Template templates/mechanism/kinematics.py.jinja; sha256 of both 02aa05c418480ee2; SymPy 1.14.0.

Arrays are C-contiguous float64, the pose first, lengths in mm, angles in rad:

x (N, 6)  platform: px py pz cx cy cz
q (N, 6)  joints        tool (N or 1, 3)  reference point in {O'}
p (M, 6, 18)  one row of parameters per limb: base alpha up plate beta down leg ax ay az bx by bz l scale tx ty tz
k (M, 6, 13)  what `constants` makes of p; each of the M machines has N / M of the poses, one after the other

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
SIMPLIFIED = 6  # coordinates that `simplified_forward` gives: the others are zero
fast = kernel(nogil=True, error_model="numpy", fastmath={"contract"})


@straight
def _early(w, k, n):
    """What moves with a joint only; then platform at home, whatever the joint (9 operations)."""
    s44 = k[0]
    s48 = k[1]
    s50 = k[2]
    s67 = k[6]
    s69 = k[7]
    s205 = k[12]
    for lane in range(n):
        q = w[0 + lane]
        tx = w[32 + lane]
        ty = w[64 + lane]
        tz = w[96 + lane]
        b_x = s44 - tx
        b_y = s48 - ty
        b_z = s50 - tz
        s = q*s67 + s69
        s82 = -0.5*(s * s)
        s206 = s205 + tz
        w[864 + lane] = b_x
        w[896 + lane] = b_y
        w[928 + lane] = b_z
        w[960 + lane] = s82
        w[992 + lane] = tx
        w[1024 + lane] = ty
        w[1056 + lane] = s206
        w[1088 + lane] = 0
        w[1120 + lane] = 0
        w[1152 + lane] = 0


@straight
def _rows(w, k, n):
    """Equations of a limb, their derivatives by shift and turn of the platform (48 operations)."""
    A_x = k[3]
    A_y = k[4]
    A_z = k[5]
    for lane in range(n):
        px = w[128 + lane]
        py = w[160 + lane]
        pz = w[192 + lane]
        R_11 = w[320 + lane]
        R_12 = w[352 + lane]
        R_13 = w[384 + lane]
        R_21 = w[416 + lane]
        R_22 = w[448 + lane]
        R_23 = w[480 + lane]
        R_31 = w[512 + lane]
        R_32 = w[544 + lane]
        R_33 = w[576 + lane]
        b_x = w[864 + lane]
        b_y = w[896 + lane]
        b_z = w[928 + lane]
        s82 = w[960 + lane]
        s52 = R_11*b_x
        s53 = R_12*b_y
        s54 = R_13*b_z
        B_x = px + s52 + s53 + s54
        s56 = R_21*b_x
        s57 = R_22*b_y
        s58 = R_23*b_z
        B_y = py + s56 + s57 + s58
        s60 = R_31*b_x
        s61 = R_32*b_y
        s62 = R_33*b_z
        B_z = pz + s60 + s61 + s62
        d_x = -A_x + B_x
        d_y = -A_y + B_y
        d_z = -A_z + B_z
        s83 = 0.5*(d_x * d_x) + 0.5*(d_y * d_y) + 0.5*(d_z * d_z) + s82
        s210 = -s60 - s61 - s62
        s212 = s56 + s57 + s58
        s214 = d_y*s210 + d_z*s212
        s216 = -s52 - s53 - s54
        s218 = -d_x*s210 + d_z*s216
        s221 = -d_x*s212 - d_y*s216
        w[608 + lane] = s83
        w[640 + lane] = d_x
        w[672 + lane] = d_y
        w[704 + lane] = d_z
        w[736 + lane] = s214
        w[768 + lane] = s218
        w[800 + lane] = s221


@straight
def _step(w, n):
    """Newton's step of the platform; how far the equations are from dependent (289 operations)."""
    for lane in range(n):
        F00 = w[608 + lane]
        J00_0 = w[640 + lane]
        J00_1 = w[672 + lane]
        J00_2 = w[704 + lane]
        J00_3 = w[736 + lane]
        J00_4 = w[768 + lane]
        J00_5 = w[800 + lane]
        F10 = w[2272 + lane]
        J10_0 = w[2304 + lane]
        J10_1 = w[2336 + lane]
        J10_2 = w[2368 + lane]
        J10_3 = w[2400 + lane]
        J10_4 = w[2432 + lane]
        J10_5 = w[2464 + lane]
        F20 = w[3936 + lane]
        J20_0 = w[3968 + lane]
        J20_1 = w[4000 + lane]
        J20_2 = w[4032 + lane]
        J20_3 = w[4064 + lane]
        J20_4 = w[4096 + lane]
        J20_5 = w[4128 + lane]
        F30 = w[5600 + lane]
        J30_0 = w[5632 + lane]
        J30_1 = w[5664 + lane]
        J30_2 = w[5696 + lane]
        J30_3 = w[5728 + lane]
        J30_4 = w[5760 + lane]
        J30_5 = w[5792 + lane]
        F40 = w[7264 + lane]
        J40_0 = w[7296 + lane]
        J40_1 = w[7328 + lane]
        J40_2 = w[7360 + lane]
        J40_3 = w[7392 + lane]
        J40_4 = w[7424 + lane]
        J40_5 = w[7456 + lane]
        F50 = w[8928 + lane]
        J50_0 = w[8960 + lane]
        J50_1 = w[8992 + lane]
        J50_2 = w[9024 + lane]
        J50_3 = w[9056 + lane]
        J50_4 = w[9088 + lane]
        J50_5 = w[9120 + lane]
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
        U_00 = G_inv_00*J00_3 + G_inv_01*J10_3 + G_inv_02*J20_3
        U_01 = G_inv_00*J00_4 + G_inv_01*J10_4 + G_inv_02*J20_4
        U_02 = G_inv_00*J00_5 + G_inv_01*J10_5 + G_inv_02*J20_5
        U_10 = G_inv_10*J00_3 + G_inv_11*J10_3 + G_inv_12*J20_3
        U_11 = G_inv_10*J00_4 + G_inv_11*J10_4 + G_inv_12*J20_4
        U_12 = G_inv_10*J00_5 + G_inv_11*J10_5 + G_inv_12*J20_5
        U_20 = G_inv_20*J00_3 + G_inv_21*J10_3 + G_inv_22*J20_3
        U_21 = G_inv_20*J00_4 + G_inv_21*J10_4 + G_inv_22*J20_4
        U_22 = G_inv_20*J00_5 + G_inv_21*J10_5 + G_inv_22*J20_5
        S_00 = -J30_0*U_00 - J30_1*U_10 - J30_2*U_20 + J30_3
        S_01 = -J30_0*U_01 - J30_1*U_11 - J30_2*U_21 + J30_4
        S_02 = -J30_0*U_02 - J30_1*U_12 - J30_2*U_22 + J30_5
        S_10 = -J40_0*U_00 - J40_1*U_10 - J40_2*U_20 + J40_3
        S_11 = -J40_0*U_01 - J40_1*U_11 - J40_2*U_21 + J40_4
        S_12 = -J40_0*U_02 - J40_1*U_12 - J40_2*U_22 + J40_5
        S_20 = -J50_0*U_00 - J50_1*U_10 - J50_2*U_20 + J50_3
        S_21 = -J50_0*U_01 - J50_1*U_11 - J50_2*U_21 + J50_4
        S_22 = -J50_0*U_02 - J50_1*U_12 - J50_2*U_22 + J50_5
        Si_cof_00 = S_11*S_22 - S_12*S_21
        Si_cof_01 = -S_10*S_22 + S_12*S_20
        Si_cof_02 = S_10*S_21 - S_11*S_20
        Si_cof_10 = -S_01*S_22 + S_02*S_21
        Si_cof_11 = S_00*S_22 - S_02*S_20
        Si_cof_12 = -S_00*S_21 + S_01*S_20
        Si_cof_20 = S_01*S_12 - S_02*S_11
        Si_cof_21 = -S_00*S_12 + S_02*S_10
        Si_cof_22 = S_00*S_11 - S_01*S_10
        Si_det_00 = S_00*Si_cof_00 + S_01*Si_cof_01 + S_02*Si_cof_02
        Si_by_00 = (1.0 / Si_det_00)
        Si_inv_00 = Si_by_00*Si_cof_00
        Si_inv_01 = Si_by_00*Si_cof_10
        Si_inv_02 = Si_by_00*Si_cof_20
        Si_inv_10 = Si_by_00*Si_cof_01
        Si_inv_11 = Si_by_00*Si_cof_11
        Si_inv_12 = Si_by_00*Si_cof_21
        Si_inv_20 = Si_by_00*Si_cof_02
        Si_inv_21 = Si_by_00*Si_cof_12
        Si_inv_22 = Si_by_00*Si_cof_22
        s169 = F30 - J30_0*u_00 - J30_1*u_10 - J30_2*u_20
        s174 = F40 - J40_0*u_00 - J40_1*u_10 - J40_2*u_20
        s179 = F50 - J50_0*u_00 - J50_1*u_10 - J50_2*u_20
        w_00 = Si_inv_00*s169 + Si_inv_01*s174 + Si_inv_02*s179
        w_10 = Si_inv_10*s169 + Si_inv_11*s174 + Si_inv_12*s179
        w_20 = Si_inv_20*s169 + Si_inv_21*s174 + Si_inv_22*s179
        s193 = -U_00*w_00 - U_01*w_10 - U_02*w_20 + u_00
        s197 = -U_10*w_00 - U_11*w_10 - U_12*w_20 + u_10
        s201 = -U_20*w_00 - U_21*w_10 - U_22*w_20 + u_20
        s210 = (J10_0 * J10_0) + (J10_1 * J10_1) + (J10_2 * J10_2)
        s214 = (J20_0 * J20_0) + (J20_1 * J20_1) + (J20_2 * J20_2)
        s216 = (G_det_00 * G_det_00) - 1.0e-12*s210*s214*((J00_0 * J00_0) + (J00_1 * J00_1) + (J00_2 * J00_2))
        s225 = (J40_3 * J40_3) + (J40_4 * J40_4) + (J40_5 * J40_5)
        s229 = (J50_3 * J50_3) + (J50_4 * J50_4) + (J50_5 * J50_5)
        s231 = (Si_det_00 * Si_det_00) - 1.0e-12*s225*s229*((J30_3 * J30_3) + (J30_4 * J30_4) + (J30_5 * J30_5))
        w[9984 + lane] = s193
        w[10016 + lane] = s197
        w[10048 + lane] = s201
        w[10080 + lane] = w_00
        w[10112 + lane] = w_10
        w[10144 + lane] = w_20
        w[10176 + lane] = s216
        w[10208 + lane] = s231


@straight
def _start(w, k, n):
    """Joint of the simplified limb at a given position (66 operations)."""
    s44 = k[0]
    s48 = k[1]
    s50 = k[2]
    A_x = k[3]
    A_y = k[4]
    A_z = k[5]
    s184 = k[8]
    s186 = k[9]
    s192 = k[10]
    s195 = k[11]
    for lane in range(n):
        tx = w[32 + lane]
        ty = w[64 + lane]
        tz = w[96 + lane]
        px = w[128 + lane]
        py = w[160 + lane]
        pz = w[192 + lane]
        cx = w[224 + lane]
        cy = w[256 + lane]
        cz = w[288 + lane]
        R_11 = w[320 + lane]
        R_22 = w[448 + lane]
        R_33 = w[576 + lane]
        s7 = (1.0 / (0.25*(cx * cx) + 0.25*(cy * cy) + 0.25*(cz * cz) + 1))
        s13 = 0.5*cx*cy
        s16 = 0.5*cx*cz
        s25 = 0.5*cy*cz
        b_x = s44 - tx
        b_y = s48 - ty
        b_z = s50 - tz
        s171 = ((-A_x + R_11*b_x + b_y*s7*(-cz + s13) + b_z*s7*(cy + s16) + px) * (-A_x + R_11*b_x + b_y*s7*(-cz + s13) + b_z*s7*(cy + s16) + px))
        s176 = ((-A_y + R_22*b_y + b_x*s7*(cz + s13) + b_z*s7*(-cx + s25) + py) * (-A_y + R_22*b_y + b_x*s7*(cz + s13) + b_z*s7*(-cx + s25) + py))
        s181 = ((-A_z + R_33*b_z + b_x*s7*(-cy + s16) + b_y*s7*(cx + s25) + pz) * (-A_z + R_33*b_z + b_x*s7*(-cy + s16) + b_y*s7*(cx + s25) + pz))
        s196 = s195 + math.sqrt(s186*(0.5*s171 + 0.5*s176 + 0.5*s181 + s184) + s192)
        w[1184 + lane] = s196


@straight
def _more(w, k, n):
    """What else derivatives by joint and errors read of it (6 operations)."""
    s67 = k[6]
    s69 = k[7]
    for lane in range(n):
        q = w[0 + lane]
        s = q*s67 + s69
        s85 = -s
        s93 = q*s85
        s222 = -s*s67
        w[1216 + lane] = s222
        w[1248 + lane] = s85
        w[1280 + lane] = s93


@straight
def _joints(w, k, n):
    """Derivatives of a limb's equations by its joint (0 operations)."""
    for lane in range(n):
        s222 = w[1216 + lane]
        w[832 + lane] = s222


@straight
def _command(w, n):
    """Newton's step of joints and rotation; how far the equations are from dependent (144 operations)."""
    for lane in range(n):
        F00 = w[608 + lane]
        J00_0 = w[640 + lane]
        J00_1 = w[672 + lane]
        J00_2 = w[704 + lane]
        J00_3 = w[736 + lane]
        J00_4 = w[768 + lane]
        J00_5 = w[800 + lane]
        Q00 = w[832 + lane]
        F10 = w[2272 + lane]
        J10_0 = w[2304 + lane]
        J10_1 = w[2336 + lane]
        J10_2 = w[2368 + lane]
        J10_3 = w[2400 + lane]
        J10_4 = w[2432 + lane]
        J10_5 = w[2464 + lane]
        Q10 = w[2496 + lane]
        F20 = w[3936 + lane]
        J20_0 = w[3968 + lane]
        J20_1 = w[4000 + lane]
        J20_2 = w[4032 + lane]
        J20_3 = w[4064 + lane]
        J20_4 = w[4096 + lane]
        J20_5 = w[4128 + lane]
        Q20 = w[4160 + lane]
        F30 = w[5600 + lane]
        J30_0 = w[5632 + lane]
        J30_1 = w[5664 + lane]
        J30_2 = w[5696 + lane]
        J30_3 = w[5728 + lane]
        J30_4 = w[5760 + lane]
        J30_5 = w[5792 + lane]
        Q30 = w[5824 + lane]
        F40 = w[7264 + lane]
        J40_0 = w[7296 + lane]
        J40_1 = w[7328 + lane]
        J40_2 = w[7360 + lane]
        J40_3 = w[7392 + lane]
        J40_4 = w[7424 + lane]
        J40_5 = w[7456 + lane]
        Q40 = w[7488 + lane]
        F50 = w[8928 + lane]
        J50_0 = w[8960 + lane]
        J50_1 = w[8992 + lane]
        J50_2 = w[9024 + lane]
        J50_3 = w[9056 + lane]
        J50_4 = w[9088 + lane]
        J50_5 = w[9120 + lane]
        Q50 = w[9152 + lane]
        s1 = F00/Q00
        s3 = F10/Q10
        s5 = F20/Q20
        s7 = F30/Q30
        s9 = F40/Q40
        s11 = F50/Q50
        s18 = -1.0e-12*(J00_2 * J00_2)
        s20 = -1.0e-12*(J00_3 * J00_3)
        s22 = -1.0e-12*(J00_4 * J00_4)
        s24 = -1.0e-12*(J00_5 * J00_5)
        s25 = -1.0e-12*(J00_0 * J00_0) - 1.0e-12*(J00_1 * J00_1) + (Q00 * Q00) + s18 + s20 + s22 + s24
        s32 = -1.0e-12*(J10_2 * J10_2)
        s34 = -1.0e-12*(J10_3 * J10_3)
        s36 = -1.0e-12*(J10_4 * J10_4)
        s38 = -1.0e-12*(J10_5 * J10_5)
        s39 = -1.0e-12*(J10_0 * J10_0) - 1.0e-12*(J10_1 * J10_1) + (Q10 * Q10) + s32 + s34 + s36 + s38
        s46 = -1.0e-12*(J20_2 * J20_2)
        s48 = -1.0e-12*(J20_3 * J20_3)
        s50 = -1.0e-12*(J20_4 * J20_4)
        s52 = -1.0e-12*(J20_5 * J20_5)
        s53 = -1.0e-12*(J20_0 * J20_0) - 1.0e-12*(J20_1 * J20_1) + (Q20 * Q20) + s46 + s48 + s50 + s52
        s60 = -1.0e-12*(J30_2 * J30_2)
        s62 = -1.0e-12*(J30_3 * J30_3)
        s64 = -1.0e-12*(J30_4 * J30_4)
        s66 = -1.0e-12*(J30_5 * J30_5)
        s67 = -1.0e-12*(J30_0 * J30_0) - 1.0e-12*(J30_1 * J30_1) + (Q30 * Q30) + s60 + s62 + s64 + s66
        s74 = -1.0e-12*(J40_2 * J40_2)
        s76 = -1.0e-12*(J40_3 * J40_3)
        s78 = -1.0e-12*(J40_4 * J40_4)
        s80 = -1.0e-12*(J40_5 * J40_5)
        s81 = -1.0e-12*(J40_0 * J40_0) - 1.0e-12*(J40_1 * J40_1) + (Q40 * Q40) + s74 + s76 + s78 + s80
        s88 = -1.0e-12*(J50_2 * J50_2)
        s90 = -1.0e-12*(J50_3 * J50_3)
        s92 = -1.0e-12*(J50_4 * J50_4)
        s94 = -1.0e-12*(J50_5 * J50_5)
        s95 = -1.0e-12*(J50_0 * J50_0) - 1.0e-12*(J50_1 * J50_1) + (Q50 * Q50) + s88 + s90 + s92 + s94
        w[11488 + lane] = s1
        w[11520 + lane] = s3
        w[11552 + lane] = s5
        w[11584 + lane] = s7
        w[11616 + lane] = s9
        w[11648 + lane] = s11
        w[11680 + lane] = s25
        w[11712 + lane] = s39
        w[11744 + lane] = s53
        w[11776 + lane] = s67
        w[11808 + lane] = s81
        w[11840 + lane] = s95


@straight
def _errors(w, k, n):
    """Derivatives of a limb's equations by errors, by deflections (48 operations)."""
    A_x = k[3]
    A_y = k[4]
    A_z = k[5]
    for lane in range(n):
        px = w[128 + lane]
        py = w[160 + lane]
        pz = w[192 + lane]
        R_11 = w[320 + lane]
        R_12 = w[352 + lane]
        R_13 = w[384 + lane]
        R_21 = w[416 + lane]
        R_22 = w[448 + lane]
        R_23 = w[480 + lane]
        R_31 = w[512 + lane]
        R_32 = w[544 + lane]
        R_33 = w[576 + lane]
        b_x = w[864 + lane]
        b_y = w[896 + lane]
        b_z = w[928 + lane]
        s85 = w[1248 + lane]
        s93 = w[1280 + lane]
        B_x = R_11*b_x + R_12*b_y + R_13*b_z + px
        B_y = R_21*b_x + R_22*b_y + R_23*b_z + py
        B_z = R_31*b_x + R_32*b_y + R_33*b_z + pz
        d_x = -A_x + B_x
        d_y = -A_y + B_y
        d_z = -A_z + B_z
        s86 = 2*d_z
        s87 = 0.5*s86
        s88 = 2*d_y
        s89 = 0.5*s88
        s90 = 2*d_x
        s91 = 0.5*s90
        s112 = R_13*s91 + R_23*s89 + R_33*s87
        s113 = R_12*s91 + R_22*s89 + R_32*s87
        s114 = R_11*s91 + R_21*s89 + R_31*s87
        w[1312 + lane] = -s91
        w[1344 + lane] = -s89
        w[1376 + lane] = -s87
        w[1408 + lane] = s114
        w[1440 + lane] = s113
        w[1472 + lane] = s112
        w[1504 + lane] = s85
        w[1536 + lane] = s93
        w[1568 + lane] = -s114
        w[1600 + lane] = -s113
        w[1632 + lane] = -s112


@straight
def _inverse_of_rows(w, n):
    """Minus the inverse of the derivatives, row by row; how far the equations are from dependent (439 operations)."""
    for lane in range(n):
        J00_0 = w[640 + lane]
        J00_1 = w[672 + lane]
        J00_2 = w[704 + lane]
        J00_3 = w[736 + lane]
        J00_4 = w[768 + lane]
        J00_5 = w[800 + lane]
        J10_0 = w[2304 + lane]
        J10_1 = w[2336 + lane]
        J10_2 = w[2368 + lane]
        J10_3 = w[2400 + lane]
        J10_4 = w[2432 + lane]
        J10_5 = w[2464 + lane]
        J20_0 = w[3968 + lane]
        J20_1 = w[4000 + lane]
        J20_2 = w[4032 + lane]
        J20_3 = w[4064 + lane]
        J20_4 = w[4096 + lane]
        J20_5 = w[4128 + lane]
        J30_0 = w[5632 + lane]
        J30_1 = w[5664 + lane]
        J30_2 = w[5696 + lane]
        J30_3 = w[5728 + lane]
        J30_4 = w[5760 + lane]
        J30_5 = w[5792 + lane]
        J40_0 = w[7296 + lane]
        J40_1 = w[7328 + lane]
        J40_2 = w[7360 + lane]
        J40_3 = w[7392 + lane]
        J40_4 = w[7424 + lane]
        J40_5 = w[7456 + lane]
        J50_0 = w[8960 + lane]
        J50_1 = w[8992 + lane]
        J50_2 = w[9024 + lane]
        J50_3 = w[9056 + lane]
        J50_4 = w[9088 + lane]
        J50_5 = w[9120 + lane]
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
        U_00 = G_inv_00*J00_3 + G_inv_01*J10_3 + G_inv_02*J20_3
        U_01 = G_inv_00*J00_4 + G_inv_01*J10_4 + G_inv_02*J20_4
        U_02 = G_inv_00*J00_5 + G_inv_01*J10_5 + G_inv_02*J20_5
        U_10 = G_inv_10*J00_3 + G_inv_11*J10_3 + G_inv_12*J20_3
        U_11 = G_inv_10*J00_4 + G_inv_11*J10_4 + G_inv_12*J20_4
        U_12 = G_inv_10*J00_5 + G_inv_11*J10_5 + G_inv_12*J20_5
        U_20 = G_inv_20*J00_3 + G_inv_21*J10_3 + G_inv_22*J20_3
        U_21 = G_inv_20*J00_4 + G_inv_21*J10_4 + G_inv_22*J20_4
        U_22 = G_inv_20*J00_5 + G_inv_21*J10_5 + G_inv_22*J20_5
        S_00 = -J30_0*U_00 - J30_1*U_10 - J30_2*U_20 + J30_3
        S_01 = -J30_0*U_01 - J30_1*U_11 - J30_2*U_21 + J30_4
        S_02 = -J30_0*U_02 - J30_1*U_12 - J30_2*U_22 + J30_5
        S_10 = -J40_0*U_00 - J40_1*U_10 - J40_2*U_20 + J40_3
        S_11 = -J40_0*U_01 - J40_1*U_11 - J40_2*U_21 + J40_4
        S_12 = -J40_0*U_02 - J40_1*U_12 - J40_2*U_22 + J40_5
        S_20 = -J50_0*U_00 - J50_1*U_10 - J50_2*U_20 + J50_3
        S_21 = -J50_0*U_01 - J50_1*U_11 - J50_2*U_21 + J50_4
        S_22 = -J50_0*U_02 - J50_1*U_12 - J50_2*U_22 + J50_5
        Si_cof_00 = S_11*S_22 - S_12*S_21
        Si_cof_01 = -S_10*S_22 + S_12*S_20
        Si_cof_02 = S_10*S_21 - S_11*S_20
        Si_cof_10 = -S_01*S_22 + S_02*S_21
        Si_cof_11 = S_00*S_22 - S_02*S_20
        Si_cof_12 = -S_00*S_21 + S_01*S_20
        Si_cof_20 = S_01*S_12 - S_02*S_11
        Si_cof_21 = -S_00*S_12 + S_02*S_10
        Si_cof_22 = S_00*S_11 - S_01*S_10
        Si_det_00 = S_00*Si_cof_00 + S_01*Si_cof_01 + S_02*Si_cof_02
        Si_by_00 = (1.0 / Si_det_00)
        Si_inv_00 = Si_by_00*Si_cof_00
        Si_inv_01 = Si_by_00*Si_cof_10
        Si_inv_02 = Si_by_00*Si_cof_20
        Si_inv_10 = Si_by_00*Si_cof_01
        Si_inv_11 = Si_by_00*Si_cof_11
        Si_inv_12 = Si_by_00*Si_cof_21
        Si_inv_20 = Si_by_00*Si_cof_02
        Si_inv_21 = Si_by_00*Si_cof_12
        Si_inv_22 = Si_by_00*Si_cof_22
        s193 = -J30_0*Si_inv_00 - J40_0*Si_inv_01 - J50_0*Si_inv_02
        s198 = -J30_1*Si_inv_00 - J40_1*Si_inv_01 - J50_1*Si_inv_02
        s203 = -J30_2*Si_inv_00 - J40_2*Si_inv_01 - J50_2*Si_inv_02
        V_00 = G_inv_00*s193 + G_inv_10*s198 + G_inv_20*s203
        V_01 = G_inv_01*s193 + G_inv_11*s198 + G_inv_21*s203
        V_02 = G_inv_02*s193 + G_inv_12*s198 + G_inv_22*s203
        s217 = -J30_0*Si_inv_10 - J40_0*Si_inv_11 - J50_0*Si_inv_12
        s222 = -J30_1*Si_inv_10 - J40_1*Si_inv_11 - J50_1*Si_inv_12
        s227 = -J30_2*Si_inv_10 - J40_2*Si_inv_11 - J50_2*Si_inv_12
        V_10 = G_inv_00*s217 + G_inv_10*s222 + G_inv_20*s227
        V_11 = G_inv_01*s217 + G_inv_11*s222 + G_inv_21*s227
        V_12 = G_inv_02*s217 + G_inv_12*s222 + G_inv_22*s227
        s241 = -J30_0*Si_inv_20 - J40_0*Si_inv_21 - J50_0*Si_inv_22
        s246 = -J30_1*Si_inv_20 - J40_1*Si_inv_21 - J50_1*Si_inv_22
        s251 = -J30_2*Si_inv_20 - J40_2*Si_inv_21 - J50_2*Si_inv_22
        V_20 = G_inv_00*s241 + G_inv_10*s246 + G_inv_20*s251
        V_21 = G_inv_01*s241 + G_inv_11*s246 + G_inv_21*s251
        V_22 = G_inv_02*s241 + G_inv_12*s246 + G_inv_22*s251
        s265 = -G_inv_00 + U_00*V_00 + U_01*V_10 + U_02*V_20
        s269 = -G_inv_01 + U_00*V_01 + U_01*V_11 + U_02*V_21
        s273 = -G_inv_02 + U_00*V_02 + U_01*V_12 + U_02*V_22
        s277 = Si_inv_00*U_00 + Si_inv_10*U_01 + Si_inv_20*U_02
        s281 = Si_inv_01*U_00 + Si_inv_11*U_01 + Si_inv_21*U_02
        s285 = Si_inv_02*U_00 + Si_inv_12*U_01 + Si_inv_22*U_02
        s289 = -G_inv_10 + U_10*V_00 + U_11*V_10 + U_12*V_20
        s293 = -G_inv_11 + U_10*V_01 + U_11*V_11 + U_12*V_21
        s297 = -G_inv_12 + U_10*V_02 + U_11*V_12 + U_12*V_22
        s301 = Si_inv_00*U_10 + Si_inv_10*U_11 + Si_inv_20*U_12
        s305 = Si_inv_01*U_10 + Si_inv_11*U_11 + Si_inv_21*U_12
        s309 = Si_inv_02*U_10 + Si_inv_12*U_11 + Si_inv_22*U_12
        s313 = -G_inv_20 + U_20*V_00 + U_21*V_10 + U_22*V_20
        s317 = -G_inv_21 + U_20*V_01 + U_21*V_11 + U_22*V_21
        s321 = -G_inv_22 + U_20*V_02 + U_21*V_12 + U_22*V_22
        s325 = Si_inv_00*U_20 + Si_inv_10*U_21 + Si_inv_20*U_22
        s329 = Si_inv_01*U_20 + Si_inv_11*U_21 + Si_inv_21*U_22
        s333 = Si_inv_02*U_20 + Si_inv_12*U_21 + Si_inv_22*U_22
        s342 = (J10_0 * J10_0) + (J10_1 * J10_1) + (J10_2 * J10_2)
        s346 = (J20_0 * J20_0) + (J20_1 * J20_1) + (J20_2 * J20_2)
        s348 = (G_det_00 * G_det_00) - 1.0e-12*s342*s346*((J00_0 * J00_0) + (J00_1 * J00_1) + (J00_2 * J00_2))
        s357 = (J40_3 * J40_3) + (J40_4 * J40_4) + (J40_5 * J40_5)
        s361 = (J50_3 * J50_3) + (J50_4 * J50_4) + (J50_5 * J50_5)
        s363 = (Si_det_00 * Si_det_00) - 1.0e-12*s357*s361*((J30_3 * J30_3) + (J30_4 * J30_4) + (J30_5 * J30_5))
        w[10272 + lane] = s265
        w[10304 + lane] = s269
        w[10336 + lane] = s273
        w[10368 + lane] = s277
        w[10400 + lane] = s281
        w[10432 + lane] = s285
        w[10464 + lane] = s289
        w[10496 + lane] = s293
        w[10528 + lane] = s297
        w[10560 + lane] = s301
        w[10592 + lane] = s305
        w[10624 + lane] = s309
        w[10656 + lane] = s313
        w[10688 + lane] = s317
        w[10720 + lane] = s321
        w[10752 + lane] = s325
        w[10784 + lane] = s329
        w[10816 + lane] = s333
        w[10848 + lane] = -V_00
        w[10880 + lane] = -V_01
        w[10912 + lane] = -V_02
        w[10944 + lane] = -Si_inv_00
        w[10976 + lane] = -Si_inv_01
        w[11008 + lane] = -Si_inv_02
        w[11040 + lane] = -V_10
        w[11072 + lane] = -V_11
        w[11104 + lane] = -V_12
        w[11136 + lane] = -Si_inv_10
        w[11168 + lane] = -Si_inv_11
        w[11200 + lane] = -Si_inv_12
        w[11232 + lane] = -V_20
        w[11264 + lane] = -V_21
        w[11296 + lane] = -V_22
        w[11328 + lane] = -Si_inv_20
        w[11360 + lane] = -Si_inv_21
        w[11392 + lane] = -Si_inv_22
        w[11424 + lane] = s348
        w[11456 + lane] = s363


@straight
def _move(w, n):
    """The platform after a step, and its rotation matrix (104 operations)."""
    for lane in range(n):
        px = w[128 + lane]
        py = w[160 + lane]
        pz = w[192 + lane]
        cx = w[224 + lane]
        cy = w[256 + lane]
        cz = w[288 + lane]
        y0 = w[9984 + lane]
        y1 = w[10016 + lane]
        y2 = w[10048 + lane]
        y3 = w[10080 + lane]
        y4 = w[10112 + lane]
        y5 = w[10144 + lane]
        going = w[10240 + lane]
        new_00 = -going*y0 + px
        new_10 = -going*y1 + py
        new_20 = -going*y2 + pz
        s10 = 0.5*cz
        s11 = 0.25*cx*cy
        s14 = -0.5*cy
        s15 = 0.25*cx*cz
        s17 = -going*y5*(s14 + s15)
        new_30 = cx - going*y3*(0.25*(cx * cx) + 1) - going*y4*(s10 + s11) + s17
        s25 = 0.5*cx
        s26 = 0.25*cy*cz
        s28 = -going*y5*(s25 + s26)
        new_40 = cy - going*y3*(-s10 + s11) - going*y4*(0.25*(cy * cy) + 1) + s28
        s37 = -going*y5*(0.25*(cz * cz) + 1)
        new_50 = cz - going*y3*(-s14 + s15) - going*y4*(-s25 + s26) + s37
        s39 = (new_30 * new_30)
        s41 = (new_40 * new_40)
        s43 = (new_50 * new_50)
        s46 = (1.0 / (0.25*s39 + 0.25*s41 + 0.25*s43 + 1))
        s47 = -0.5*s41
        s48 = -0.5*s43
        s51 = s46*(s47 + s48) + 1
        s52 = 0.5*new_30*new_40
        s54 = s46*(-new_50 + s52)
        s55 = 0.5*new_30*new_50
        s57 = s46*(new_40 + s55)
        s59 = s46*(new_50 + s52)
        s60 = -0.5*s39
        s63 = s46*(s48 + s60) + 1
        s64 = 0.5*new_40*new_50
        s66 = s46*(-new_30 + s64)
        s68 = s46*(-new_40 + s55)
        s70 = s46*(new_30 + s64)
        s73 = s46*(s47 + s60) + 1
        w[128 + lane] = new_00
        w[1792 + lane] = new_00
        w[3456 + lane] = new_00
        w[5120 + lane] = new_00
        w[6784 + lane] = new_00
        w[8448 + lane] = new_00
        w[160 + lane] = new_10
        w[1824 + lane] = new_10
        w[3488 + lane] = new_10
        w[5152 + lane] = new_10
        w[6816 + lane] = new_10
        w[8480 + lane] = new_10
        w[192 + lane] = new_20
        w[1856 + lane] = new_20
        w[3520 + lane] = new_20
        w[5184 + lane] = new_20
        w[6848 + lane] = new_20
        w[8512 + lane] = new_20
        w[224 + lane] = new_30
        w[256 + lane] = new_40
        w[288 + lane] = new_50
        w[320 + lane] = s51
        w[1984 + lane] = s51
        w[3648 + lane] = s51
        w[5312 + lane] = s51
        w[6976 + lane] = s51
        w[8640 + lane] = s51
        w[352 + lane] = s54
        w[2016 + lane] = s54
        w[3680 + lane] = s54
        w[5344 + lane] = s54
        w[7008 + lane] = s54
        w[8672 + lane] = s54
        w[384 + lane] = s57
        w[2048 + lane] = s57
        w[3712 + lane] = s57
        w[5376 + lane] = s57
        w[7040 + lane] = s57
        w[8704 + lane] = s57
        w[416 + lane] = s59
        w[2080 + lane] = s59
        w[3744 + lane] = s59
        w[5408 + lane] = s59
        w[7072 + lane] = s59
        w[8736 + lane] = s59
        w[448 + lane] = s63
        w[2112 + lane] = s63
        w[3776 + lane] = s63
        w[5440 + lane] = s63
        w[7104 + lane] = s63
        w[8768 + lane] = s63
        w[480 + lane] = s66
        w[2144 + lane] = s66
        w[3808 + lane] = s66
        w[5472 + lane] = s66
        w[7136 + lane] = s66
        w[8800 + lane] = s66
        w[512 + lane] = s68
        w[2176 + lane] = s68
        w[3840 + lane] = s68
        w[5504 + lane] = s68
        w[7168 + lane] = s68
        w[8832 + lane] = s68
        w[544 + lane] = s70
        w[2208 + lane] = s70
        w[3872 + lane] = s70
        w[5536 + lane] = s70
        w[7200 + lane] = s70
        w[8864 + lane] = s70
        w[576 + lane] = s73
        w[2240 + lane] = s73
        w[3904 + lane] = s73
        w[5568 + lane] = s73
        w[7232 + lane] = s73
        w[8896 + lane] = s73


@straight
def _meet(w, n):
    """Put the platform where the simplified machine has it."""
    for lane in range(n):
        p_0 = w[992 + lane]
        p_1 = w[1024 + lane]
        p_2 = w[1056 + lane]
        p_3 = w[1088 + lane]
        p_4 = w[1120 + lane]
        p_5 = w[1152 + lane]
        good = (abs(p_0) < math.inf) & (abs(p_1) < math.inf) & (abs(p_2) < math.inf) & (abs(p_3) < math.inf) & (abs(p_4) < math.inf) & (abs(p_5) < math.inf)
        w[10240 + lane] = 0.0 if good else 1.0
        w[128 + lane] = p_0
        w[160 + lane] = p_1
        w[192 + lane] = p_2
        w[224 + lane] = p_3
        w[256 + lane] = p_4
        w[288 + lane] = p_5


@straight
def _settle(w, n):
    """Mark the poses for which this step was the last; return how many go on."""
    left = 0
    for lane in range(n):
        done = (w[10176 + lane] > 0.0)
        done = done & (w[10208 + lane] > 0.0)
        done = done & (abs(w[9984 + lane]) < STEP_DONE)
        done = done & (abs(w[10016 + lane]) < STEP_DONE)
        done = done & (abs(w[10048 + lane]) < STEP_DONE)
        done = done & (abs(w[10080 + lane]) < TURN_DONE)
        done = done & (abs(w[10112 + lane]) < TURN_DONE)
        done = done & (abs(w[10144 + lane]) < TURN_DONE)
        going = 0.0 if done | (w[10240 + lane] == 0.0) else 1.0
        w[10240 + lane] = going
        left += 1 if going == 1.0 else 0
    return left


@straight
def _settle_joints(w, n):
    """Mark the poses for which this step was the last; return how many go on."""
    left = 0
    for lane in range(n):
        done = (w[11680 + lane] > 0.0)
        done = done & (w[11712 + lane] > 0.0)
        done = done & (w[11744 + lane] > 0.0)
        done = done & (w[11776 + lane] > 0.0)
        done = done & (w[11808 + lane] > 0.0)
        done = done & (w[11840 + lane] > 0.0)
        done = done & (abs(w[11488 + lane]) < STEP_DONE)
        done = done & (abs(w[11520 + lane]) < STEP_DONE)
        done = done & (abs(w[11552 + lane]) < STEP_DONE)
        done = done & (abs(w[11584 + lane]) < STEP_DONE)
        done = done & (abs(w[11616 + lane]) < STEP_DONE)
        done = done & (abs(w[11648 + lane]) < STEP_DONE)


        going = 0.0 if done | (w[10240 + lane] == 0.0) else 1.0
        w[10240 + lane] = going
        left += 1 if going == 1.0 else 0
    return left


@straight
def _begin(w, n):
    """Let all poses go."""
    for lane in range(n):
        w[10240 + lane] = 1.0
        w[9984 + lane] = 0.0
        w[10016 + lane] = 0.0
        w[10048 + lane] = 0.0
        w[10080 + lane] = 0.0
        w[10112 + lane] = 0.0
        w[10144 + lane] = 0.0


@straight
def _started(w, n):
    """Take joints, and coordinates that no command asks for, from the simplified machine."""
    for lane in range(n):
        w[10240 + lane] = 0.0 if (abs(w[1184 + lane]) < math.inf) & (abs(w[2848 + lane]) < math.inf) & (abs(w[4512 + lane]) < math.inf) & (abs(w[6176 + lane]) < math.inf) & (abs(w[7840 + lane]) < math.inf) & (abs(w[9504 + lane]) < math.inf) else 1.0
        w[0 + lane] = w[1184 + lane]
        w[1664 + lane] = w[2848 + lane]
        w[3328 + lane] = w[4512 + lane]
        w[4992 + lane] = w[6176 + lane]
        w[6656 + lane] = w[7840 + lane]
        w[8320 + lane] = w[9504 + lane]


@straight
def _turn_joints(w, n):
    """Move the joints by a step; what it does to the platform is left to `_move`."""
    for lane in range(n):
        going = w[10240 + lane]
        w[0 + lane] -= going * w[11488 + lane]
        w[1664 + lane] -= going * w[11520 + lane]
        w[3328 + lane] -= going * w[11552 + lane]
        w[4992 + lane] -= going * w[11584 + lane]
        w[6656 + lane] -= going * w[11616 + lane]
        w[8320 + lane] -= going * w[11648 + lane]

@straight
def _place(x, w, first, last, n):
    """Put platform poses side by side, like `load`."""
    for lane in range(n):
        m = min(first + lane, last)
        w[128 + lane] = x[6 * m + 0]
        w[160 + lane] = x[6 * m + 1]
        w[192 + lane] = x[6 * m + 2]
        w[224 + lane] = x[6 * m + 3]
        w[256 + lane] = x[6 * m + 4]
        w[288 + lane] = x[6 * m + 5]


@straight
def _unload(w, x, status, first, last):
    """Write the platform's poses, and what became of them; return how many are left open."""
    left = 0
    for lane in range(last - first + 1):
        x[6 * (first + lane) + 0] = w[128 + lane]
        x[6 * (first + lane) + 1] = w[160 + lane]
        x[6 * (first + lane) + 2] = w[192 + lane]
        x[6 * (first + lane) + 3] = w[224 + lane]
        x[6 * (first + lane) + 4] = w[256 + lane]
        x[6 * (first + lane) + 5] = w[288 + lane]
        is_open = w[10240 + lane] != 0.0
        status[first + lane] = OPEN if is_open else SOLVED
        left += 1 if is_open else 0
    return left


@straight
def _unload_joints(w, q, first, last):
    for lane in range(last - first + 1):
        q[6 * (first + lane) + 0] = w[0 + lane]
        q[6 * (first + lane) + 1] = w[1664 + lane]
        q[6 * (first + lane) + 2] = w[3328 + lane]
        q[6 * (first + lane) + 3] = w[4992 + lane]
        q[6 * (first + lane) + 4] = w[6656 + lane]
        q[6 * (first + lane) + 5] = w[8320 + lane]


@fast
def _forward(q, tool, k, x, status, warm):
    w = scratch(WORK + SPARE)
    w_1 = w[0:1664]
    w_2 = w[1664:3328]
    w_3 = w[3328:4992]
    w_4 = w[4992:6656]
    w_5 = w[6656:8320]
    w_6 = w[8320:9984]
    if len(tool) == 1:
        hold(tool, w, 0, 0, LANES)
    left, machines = 0, k.shape[0]
    each = status.size // machines
    for m in range(machines):
        k_1 = k[m, 0]
        k_2 = k[m, 1]
        k_3 = k[m, 2]
        k_4 = k[m, 3]
        k_5 = k[m, 4]
        k_6 = k[m, 5]
        for first in range(m * each, (m + 1) * each, LANES):
            last = min(first + LANES, (m + 1) * each) - 1
            n = (last - first + 8) // 8 * 8
            load(q, w, first, last, n)
            if len(tool) > 1:
                hold(tool, w, first, last, n)
            _early(w_1, k_1, n)
            _early(w_2, k_2, n)
            _early(w_3, k_3, n)
            _early(w_4, k_4, n)
            _early(w_5, k_5, n)
            _early(w_6, k_6, n)
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
                _rows(w_4, k_4, n)
                _rows(w_5, k_5, n)
                _rows(w_6, k_6, n)
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
    """Fill x (N, 6) with the exact platform pose at the joints q, by Newton from the simplified machine, or from x where warm.

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
    w_1 = w[0:1664]
    w_2 = w[1664:3328]
    w_3 = w[3328:4992]
    w_4 = w[4992:6656]
    w_5 = w[6656:8320]
    w_6 = w[8320:9984]
    if len(tool) == 1:
        hold(tool, w, 0, 0, LANES)
    left, machines = 0, k.shape[0]
    each = status.size // machines
    for m in range(machines):
        k_1 = k[m, 0]
        k_2 = k[m, 1]
        k_3 = k[m, 2]
        k_4 = k[m, 3]
        k_5 = k[m, 4]
        k_6 = k[m, 5]
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
            _start(w_4, k_4, n)
            _start(w_5, k_5, n)
            _start(w_6, k_6, n)
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
                _early(w_4, k_4, n)
                _more(w_4, k_4, n)
                _rows(w_4, k_4, n)
                _joints(w_4, k_4, n)
                _early(w_5, k_5, n)
                _more(w_5, k_5, n)
                _rows(w_5, k_5, n)
                _joints(w_5, k_5, n)
                _early(w_6, k_6, n)
                _more(w_6, k_6, n)
                _rows(w_6, k_6, n)
                _joints(w_6, k_6, n)
                _command(w, n)
                _turn_joints(w, n)
                _move(w, n)
                if _settle_joints(w, n) == 0:
                    break
            left += _unload(w, x, status, first, last)
            _unload_joints(w, q, first, last)
    return left


def inverse(target, tool, k, x, q, status):
    """Fill the joints q (N, 6) that bring the reference point to target (N, 6), and the pose x (N, 6) it then has.

    Newton on the joints and the platform's rotation from the simplified machine. status as in `forward`; UNREACHABLE
    where the target lies beyond the reach of a limb.
    """
    if _inverse(target, tool, k, x, q, status):
        left = np.flatnonzero(status == OPEN)
        found, joints, of = (
            np.empty((len(left), 6)), np.empty((len(left), 6)), np.zeros(len(left), dtype=np.int64)
        )
        vectorised.inverse(target[left], _of(tool, left, len(status)), _of(k, left, len(status)), found, joints, of)
        x[left], q[left], status[left] = found, joints, of




@fast
def _simplified_inverse(target, tool, k, q, status):
    given, found = target.reshape(target.size), q.reshape(q.size)
    machines, tools = k.reshape(k.size), tool.reshape(tool.size)
    left, runs = 0, max(k.shape[0], tool.shape[0])
    each = status.size // runs
    for m in range(runs):
        own = machines[78 * (m // (runs // k.shape[0])) :]
        held = tools[3 * (m // (runs // tool.shape[0])) :]
        left += _simplified_inverse_of(given[6 * each * m :], held, own, found[6 * each * m :], status[each * m :], each)
    return left


@straight
def _simplified_inverse_of(target, tool, own, q, status, poses):
    """Solve the poses of one machine with one tool; return how many are left open."""
    left = 0
    tx = tool[0]
    ty = tool[1]
    tz = tool[2]
    s44_0 = own[0 + 0]
    s48_0 = own[0 + 1]
    s50_0 = own[0 + 2]
    A_x_0 = own[0 + 3]
    A_y_0 = own[0 + 4]
    A_z_0 = own[0 + 5]
    s184_0 = own[0 + 8]
    s186_0 = own[0 + 9]
    s192_0 = own[0 + 10]
    s195_0 = own[0 + 11]
    s44_1 = own[13 + 0]
    s48_1 = own[13 + 1]
    s50_1 = own[13 + 2]
    A_x_1 = own[13 + 3]
    A_y_1 = own[13 + 4]
    A_z_1 = own[13 + 5]
    s184_1 = own[13 + 8]
    s186_1 = own[13 + 9]
    s192_1 = own[13 + 10]
    s195_1 = own[13 + 11]
    s44_2 = own[26 + 0]
    s48_2 = own[26 + 1]
    s50_2 = own[26 + 2]
    A_x_2 = own[26 + 3]
    A_y_2 = own[26 + 4]
    A_z_2 = own[26 + 5]
    s184_2 = own[26 + 8]
    s186_2 = own[26 + 9]
    s192_2 = own[26 + 10]
    s195_2 = own[26 + 11]
    s44_3 = own[39 + 0]
    s48_3 = own[39 + 1]
    s50_3 = own[39 + 2]
    A_x_3 = own[39 + 3]
    A_y_3 = own[39 + 4]
    A_z_3 = own[39 + 5]
    s184_3 = own[39 + 8]
    s186_3 = own[39 + 9]
    s192_3 = own[39 + 10]
    s195_3 = own[39 + 11]
    s44_4 = own[52 + 0]
    s48_4 = own[52 + 1]
    s50_4 = own[52 + 2]
    A_x_4 = own[52 + 3]
    A_y_4 = own[52 + 4]
    A_z_4 = own[52 + 5]
    s184_4 = own[52 + 8]
    s186_4 = own[52 + 9]
    s192_4 = own[52 + 10]
    s195_4 = own[52 + 11]
    s44_5 = own[65 + 0]
    s48_5 = own[65 + 1]
    s50_5 = own[65 + 2]
    A_x_5 = own[65 + 3]
    A_y_5 = own[65 + 4]
    A_z_5 = own[65 + 5]
    s184_5 = own[65 + 8]
    s186_5 = own[65 + 9]
    s192_5 = own[65 + 10]
    s195_5 = own[65 + 11]
    for n in range(poses):
        px = target[6 * n + 0]
        py = target[6 * n + 1]
        pz = target[6 * n + 2]
        cx = target[6 * n + 3]
        cy = target[6 * n + 4]
        cz = target[6 * n + 5]
        s0_0 = (cx * cx)
        s2_0 = (cy * cy)
        s4_0 = (cz * cz)
        s7_0 = (1.0 / (0.25*s0_0 + 0.25*s2_0 + 0.25*s4_0 + 1))
        s8_0 = -0.5*s2_0
        s9_0 = -0.5*s4_0
        R_11_0 = s7_0*(s8_0 + s9_0) + 1
        s13_0 = 0.5*cx*cy
        s16_0 = 0.5*cx*cz
        s21_0 = -0.5*s0_0
        R_22_0 = s7_0*(s21_0 + s9_0) + 1
        s25_0 = 0.5*cy*cz
        R_33_0 = s7_0*(s21_0 + s8_0) + 1
        b_x_0 = s44_0 - tx
        b_y_0 = s48_0 - ty
        b_z_0 = s50_0 - tz
        s171_0 = ((-A_x_0 + R_11_0*b_x_0 + b_y_0*s7_0*(-cz + s13_0) + b_z_0*s7_0*(cy + s16_0) + px) * (-A_x_0 + R_11_0*b_x_0 + b_y_0*s7_0*(-cz + s13_0) + b_z_0*s7_0*(cy + s16_0) + px))
        s176_0 = ((-A_y_0 + R_22_0*b_y_0 + b_x_0*s7_0*(cz + s13_0) + b_z_0*s7_0*(-cx + s25_0) + py) * (-A_y_0 + R_22_0*b_y_0 + b_x_0*s7_0*(cz + s13_0) + b_z_0*s7_0*(-cx + s25_0) + py))
        s181_0 = ((-A_z_0 + R_33_0*b_z_0 + b_x_0*s7_0*(-cy + s16_0) + b_y_0*s7_0*(cx + s25_0) + pz) * (-A_z_0 + R_33_0*b_z_0 + b_x_0*s7_0*(-cy + s16_0) + b_y_0*s7_0*(cx + s25_0) + pz))
        s196_0 = s195_0 + math.sqrt(s186_0*(0.5*s171_0 + 0.5*s176_0 + 0.5*s181_0 + s184_0) + s192_0)
        q_00 = s196_0
        s0_1 = (cx * cx)
        s2_1 = (cy * cy)
        s4_1 = (cz * cz)
        s7_1 = (1.0 / (0.25*s0_1 + 0.25*s2_1 + 0.25*s4_1 + 1))
        s8_1 = -0.5*s2_1
        s9_1 = -0.5*s4_1
        R_11_1 = s7_1*(s8_1 + s9_1) + 1
        s13_1 = 0.5*cx*cy
        s16_1 = 0.5*cx*cz
        s21_1 = -0.5*s0_1
        R_22_1 = s7_1*(s21_1 + s9_1) + 1
        s25_1 = 0.5*cy*cz
        R_33_1 = s7_1*(s21_1 + s8_1) + 1
        b_x_1 = s44_1 - tx
        b_y_1 = s48_1 - ty
        b_z_1 = s50_1 - tz
        s171_1 = ((-A_x_1 + R_11_1*b_x_1 + b_y_1*s7_1*(-cz + s13_1) + b_z_1*s7_1*(cy + s16_1) + px) * (-A_x_1 + R_11_1*b_x_1 + b_y_1*s7_1*(-cz + s13_1) + b_z_1*s7_1*(cy + s16_1) + px))
        s176_1 = ((-A_y_1 + R_22_1*b_y_1 + b_x_1*s7_1*(cz + s13_1) + b_z_1*s7_1*(-cx + s25_1) + py) * (-A_y_1 + R_22_1*b_y_1 + b_x_1*s7_1*(cz + s13_1) + b_z_1*s7_1*(-cx + s25_1) + py))
        s181_1 = ((-A_z_1 + R_33_1*b_z_1 + b_x_1*s7_1*(-cy + s16_1) + b_y_1*s7_1*(cx + s25_1) + pz) * (-A_z_1 + R_33_1*b_z_1 + b_x_1*s7_1*(-cy + s16_1) + b_y_1*s7_1*(cx + s25_1) + pz))
        s196_1 = s195_1 + math.sqrt(s186_1*(0.5*s171_1 + 0.5*s176_1 + 0.5*s181_1 + s184_1) + s192_1)
        q_10 = s196_1
        s0_2 = (cx * cx)
        s2_2 = (cy * cy)
        s4_2 = (cz * cz)
        s7_2 = (1.0 / (0.25*s0_2 + 0.25*s2_2 + 0.25*s4_2 + 1))
        s8_2 = -0.5*s2_2
        s9_2 = -0.5*s4_2
        R_11_2 = s7_2*(s8_2 + s9_2) + 1
        s13_2 = 0.5*cx*cy
        s16_2 = 0.5*cx*cz
        s21_2 = -0.5*s0_2
        R_22_2 = s7_2*(s21_2 + s9_2) + 1
        s25_2 = 0.5*cy*cz
        R_33_2 = s7_2*(s21_2 + s8_2) + 1
        b_x_2 = s44_2 - tx
        b_y_2 = s48_2 - ty
        b_z_2 = s50_2 - tz
        s171_2 = ((-A_x_2 + R_11_2*b_x_2 + b_y_2*s7_2*(-cz + s13_2) + b_z_2*s7_2*(cy + s16_2) + px) * (-A_x_2 + R_11_2*b_x_2 + b_y_2*s7_2*(-cz + s13_2) + b_z_2*s7_2*(cy + s16_2) + px))
        s176_2 = ((-A_y_2 + R_22_2*b_y_2 + b_x_2*s7_2*(cz + s13_2) + b_z_2*s7_2*(-cx + s25_2) + py) * (-A_y_2 + R_22_2*b_y_2 + b_x_2*s7_2*(cz + s13_2) + b_z_2*s7_2*(-cx + s25_2) + py))
        s181_2 = ((-A_z_2 + R_33_2*b_z_2 + b_x_2*s7_2*(-cy + s16_2) + b_y_2*s7_2*(cx + s25_2) + pz) * (-A_z_2 + R_33_2*b_z_2 + b_x_2*s7_2*(-cy + s16_2) + b_y_2*s7_2*(cx + s25_2) + pz))
        s196_2 = s195_2 + math.sqrt(s186_2*(0.5*s171_2 + 0.5*s176_2 + 0.5*s181_2 + s184_2) + s192_2)
        q_20 = s196_2
        s0_3 = (cx * cx)
        s2_3 = (cy * cy)
        s4_3 = (cz * cz)
        s7_3 = (1.0 / (0.25*s0_3 + 0.25*s2_3 + 0.25*s4_3 + 1))
        s8_3 = -0.5*s2_3
        s9_3 = -0.5*s4_3
        R_11_3 = s7_3*(s8_3 + s9_3) + 1
        s13_3 = 0.5*cx*cy
        s16_3 = 0.5*cx*cz
        s21_3 = -0.5*s0_3
        R_22_3 = s7_3*(s21_3 + s9_3) + 1
        s25_3 = 0.5*cy*cz
        R_33_3 = s7_3*(s21_3 + s8_3) + 1
        b_x_3 = s44_3 - tx
        b_y_3 = s48_3 - ty
        b_z_3 = s50_3 - tz
        s171_3 = ((-A_x_3 + R_11_3*b_x_3 + b_y_3*s7_3*(-cz + s13_3) + b_z_3*s7_3*(cy + s16_3) + px) * (-A_x_3 + R_11_3*b_x_3 + b_y_3*s7_3*(-cz + s13_3) + b_z_3*s7_3*(cy + s16_3) + px))
        s176_3 = ((-A_y_3 + R_22_3*b_y_3 + b_x_3*s7_3*(cz + s13_3) + b_z_3*s7_3*(-cx + s25_3) + py) * (-A_y_3 + R_22_3*b_y_3 + b_x_3*s7_3*(cz + s13_3) + b_z_3*s7_3*(-cx + s25_3) + py))
        s181_3 = ((-A_z_3 + R_33_3*b_z_3 + b_x_3*s7_3*(-cy + s16_3) + b_y_3*s7_3*(cx + s25_3) + pz) * (-A_z_3 + R_33_3*b_z_3 + b_x_3*s7_3*(-cy + s16_3) + b_y_3*s7_3*(cx + s25_3) + pz))
        s196_3 = s195_3 + math.sqrt(s186_3*(0.5*s171_3 + 0.5*s176_3 + 0.5*s181_3 + s184_3) + s192_3)
        q_30 = s196_3
        s0_4 = (cx * cx)
        s2_4 = (cy * cy)
        s4_4 = (cz * cz)
        s7_4 = (1.0 / (0.25*s0_4 + 0.25*s2_4 + 0.25*s4_4 + 1))
        s8_4 = -0.5*s2_4
        s9_4 = -0.5*s4_4
        R_11_4 = s7_4*(s8_4 + s9_4) + 1
        s13_4 = 0.5*cx*cy
        s16_4 = 0.5*cx*cz
        s21_4 = -0.5*s0_4
        R_22_4 = s7_4*(s21_4 + s9_4) + 1
        s25_4 = 0.5*cy*cz
        R_33_4 = s7_4*(s21_4 + s8_4) + 1
        b_x_4 = s44_4 - tx
        b_y_4 = s48_4 - ty
        b_z_4 = s50_4 - tz
        s171_4 = ((-A_x_4 + R_11_4*b_x_4 + b_y_4*s7_4*(-cz + s13_4) + b_z_4*s7_4*(cy + s16_4) + px) * (-A_x_4 + R_11_4*b_x_4 + b_y_4*s7_4*(-cz + s13_4) + b_z_4*s7_4*(cy + s16_4) + px))
        s176_4 = ((-A_y_4 + R_22_4*b_y_4 + b_x_4*s7_4*(cz + s13_4) + b_z_4*s7_4*(-cx + s25_4) + py) * (-A_y_4 + R_22_4*b_y_4 + b_x_4*s7_4*(cz + s13_4) + b_z_4*s7_4*(-cx + s25_4) + py))
        s181_4 = ((-A_z_4 + R_33_4*b_z_4 + b_x_4*s7_4*(-cy + s16_4) + b_y_4*s7_4*(cx + s25_4) + pz) * (-A_z_4 + R_33_4*b_z_4 + b_x_4*s7_4*(-cy + s16_4) + b_y_4*s7_4*(cx + s25_4) + pz))
        s196_4 = s195_4 + math.sqrt(s186_4*(0.5*s171_4 + 0.5*s176_4 + 0.5*s181_4 + s184_4) + s192_4)
        q_40 = s196_4
        s0_5 = (cx * cx)
        s2_5 = (cy * cy)
        s4_5 = (cz * cz)
        s7_5 = (1.0 / (0.25*s0_5 + 0.25*s2_5 + 0.25*s4_5 + 1))
        s8_5 = -0.5*s2_5
        s9_5 = -0.5*s4_5
        R_11_5 = s7_5*(s8_5 + s9_5) + 1
        s13_5 = 0.5*cx*cy
        s16_5 = 0.5*cx*cz
        s21_5 = -0.5*s0_5
        R_22_5 = s7_5*(s21_5 + s9_5) + 1
        s25_5 = 0.5*cy*cz
        R_33_5 = s7_5*(s21_5 + s8_5) + 1
        b_x_5 = s44_5 - tx
        b_y_5 = s48_5 - ty
        b_z_5 = s50_5 - tz
        s171_5 = ((-A_x_5 + R_11_5*b_x_5 + b_y_5*s7_5*(-cz + s13_5) + b_z_5*s7_5*(cy + s16_5) + px) * (-A_x_5 + R_11_5*b_x_5 + b_y_5*s7_5*(-cz + s13_5) + b_z_5*s7_5*(cy + s16_5) + px))
        s176_5 = ((-A_y_5 + R_22_5*b_y_5 + b_x_5*s7_5*(cz + s13_5) + b_z_5*s7_5*(-cx + s25_5) + py) * (-A_y_5 + R_22_5*b_y_5 + b_x_5*s7_5*(cz + s13_5) + b_z_5*s7_5*(-cx + s25_5) + py))
        s181_5 = ((-A_z_5 + R_33_5*b_z_5 + b_x_5*s7_5*(-cy + s16_5) + b_y_5*s7_5*(cx + s25_5) + pz) * (-A_z_5 + R_33_5*b_z_5 + b_x_5*s7_5*(-cy + s16_5) + b_y_5*s7_5*(cx + s25_5) + pz))
        s196_5 = s195_5 + math.sqrt(s186_5*(0.5*s171_5 + 0.5*s176_5 + 0.5*s181_5 + s184_5) + s192_5)
        q_50 = s196_5
        good = (abs(q_00) < math.inf) & (abs(q_10) < math.inf) & (abs(q_20) < math.inf) & (abs(q_30) < math.inf) & (abs(q_40) < math.inf) & (abs(q_50) < math.inf)
        q[6 * n + 0] = q_00
        q[6 * n + 1] = q_10
        q[6 * n + 2] = q_20
        q[6 * n + 3] = q_30
        q[6 * n + 4] = q_40
        q[6 * n + 5] = q_50
        status[n] = SOLVED if good else OPEN
        left += 0 if good else 1
    return left


def simplified_inverse(target, tool, k, q, status):
    """Fill the joints q (N, 6) of the simplified machine, in closed form; see `simplified_forward` and `inverse`."""
    if _simplified_inverse(target, tool, k, q, status):
        left = np.flatnonzero(status == OPEN)
        found, joints, of = (
            np.empty((len(left), 6)), np.empty((len(left), 6)),
            np.empty(len(left), dtype=status.dtype),
        )
        inverse(target[left], _of(tool, left, len(status)), _of(k, left, len(status)), found, joints, of)
        q[left], status[left] = joints, of


@fast
def _sensitivity(x, q, tool, k, S_p, S_q, status):
    w, by_errors, by_joints = scratch(WORK + SPARE), S_p.reshape(S_p.size), S_q.reshape(S_q.size)
    w_1 = w[0:1664]
    w_2 = w[1664:3328]
    w_3 = w[3328:4992]
    w_4 = w[4992:6656]
    w_5 = w[6656:8320]
    w_6 = w[8320:9984]
    if len(tool) == 1:
        hold(tool, w, 0, 0, LANES)
    left, machines = 0, k.shape[0]
    each = status.size // machines
    for m in range(machines):
        k_1 = k[m, 0]
        k_2 = k[m, 1]
        k_3 = k[m, 2]
        k_4 = k[m, 3]
        k_5 = k[m, 4]
        k_6 = k[m, 5]
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
            _early(w_4, k_4, n)
            _more(w_4, k_4, n)
            _rows(w_4, k_4, n)
            _joints(w_4, k_4, n)
            _errors(w_4, k_4, n)
            _early(w_5, k_5, n)
            _more(w_5, k_5, n)
            _rows(w_5, k_5, n)
            _joints(w_5, k_5, n)
            _errors(w_5, k_5, n)
            _early(w_6, k_6, n)
            _more(w_6, k_6, n)
            _rows(w_6, k_6, n)
            _joints(w_6, k_6, n)
            _errors(w_6, k_6, n)
            _inverse_of_rows(w, n)
            left += _products(w, by_errors, by_joints, status, first, last)
    return left


@fast
def _products(w, S_p, S_q, status, first, last):
    """Multiply the inverse and the derivatives by errors and joints; return how many poses are left open."""
    wide()
    for lane in range(0, last - first + 1, 8):
        whole = 396 * (first + lane + 8) <= S_p.size  # else the last poses are written through scratch
        to, at = (S_p, 396 * (first + lane)) if whole else (w[WORK:], 0)
        for i in range(6):
            outer(to, at + 11 * i + 0, 396, 66, 6, w, (10272 + 32 * i + lane, ), 192, (1312 + 1664 * i + lane, ), 32, 8)
            outer(to, at + 11 * i + 8, 396, 66, 6, w, (10272 + 32 * i + lane, ), 192, (1568 + 1664 * i + lane, ), 32, 3)
        if not whole:
            for c in range(396 * (last + 1 - first - lane)):
                S_p[396 * (first + lane) + c] = to[c]
        whole = 36 * (first + lane + 8) <= S_q.size  # else the last poses are written through scratch
        to, at = (S_q, 36 * (first + lane)) if whole else (w[WORK:], 0)
        for i in range(6):
            outer(to, at + 1 * i + 0, 36, 6, 6, w, (10272 + 32 * i + lane, ), 192, (832 + 1664 * i + lane, ), 32, 1)
        if not whole:
            for c in range(36 * (last + 1 - first - lane)):
                S_q[36 * (first + lane) + c] = to[c]
    left = 0
    for lane in range(last - first + 1):
        regular = (w[11424 + lane] > 0.0) & (w[11456 + lane] > 0.0)
        status[first + lane] = SOLVED if regular else OPEN
        left += 0 if regular else 1
    return left


def sensitivity(x, q, tool, k, S_p, S_q, status):
    """Fill the derivatives of the exact pose: S_p (N, 6, 66) by errors and deflections, S_q (N, 6, 6) by joints.

    Rows are px, py, pz, then turns of the platform about
    the axes of {O}. Columns of S_p run limb by limb. S_q is the velocity Jacobian.
    """
    if _sensitivity(x, q, tool, k, S_p, S_q, status):
        left = np.flatnonzero(status == OPEN)
        by_errors, by_joints, of = (
            np.empty((len(left), 6, 66)), np.empty((len(left), 6, 6)),
            np.zeros(len(left), dtype=np.int64),
        )
        vectorised.sensitivity(
            x[left], q[left], _of(tool, left, len(status)), _of(k, left, len(status)), by_errors, by_joints, of
        )
        S_p[left], S_q[left], status[left] = by_errors, by_joints, of

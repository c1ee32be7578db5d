"""Kinematics of `delta`, many poses at once: Delta, three arms and six rods.

Generated from derive/mechanisms/delta.py by "deltacal kernels". Do not edit.
Template templates/mechanism/kinematics.py.jinja; sha256 of both 02a986b4fb4e6a45; SymPy 1.14.0.

Arrays are C-contiguous float64, the pose first, lengths in mm, angles in rad:

x (N, 6)  platform: px py pz cx cy cz
q (N, 3)  joints        tool (N or 1, 3)  reference point in {O'}
p (M, 3, 22)  one row of parameters per limb: b a L l c phi theta ex ey ez L alpha0 beta0 l dl dc alpha03 beta03 alpha2 beta2 tip_v tip_w
k (M, 3, 91)  what `constants` makes of p; each of the M machines has N / M of the poses, one after the other

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
    """What moves with a joint only; then the simplified limb as a sphere |P|^2 - 2 c.P + d = 0: c, d (62 operations)."""
    theta = k[0]
    R0_11 = k[1]
    R0_12 = k[2]
    R0_21 = k[3]
    R0_22 = k[4]
    R0_31 = k[5]
    R0_32 = k[6]
    s219 = k[7]
    tip_v = k[8]
    s223 = k[9]
    s228 = k[10]
    s233 = k[11]
    s235 = k[12]
    s238 = k[13]
    g_x = k[14]
    g_y = k[15]
    s253 = k[16]
    s257 = k[17]
    s261 = k[18]
    s1166 = k[24]
    s1168 = k[25]
    s1170 = k[26]
    s1172 = k[27]
    ez = k[28]
    s1184 = k[84]
    for lane in range(n):
        q = w[0 + lane]
        tx = w[32 + lane]
        ty = w[64 + lane]
        tz = w[96 + lane]
        s163 = q + theta
        s164 = cosine(s163)
        s166 = sine(s163)
        R1_11 = R0_11*s164 + R0_12*s166
        R1_12 = -R0_11*s166 + R0_12*s164
        R1_21 = R0_21*s164 + R0_22*s166
        R1_22 = -R0_21*s166 + R0_22*s164
        R1_31 = R0_31*s164 + R0_32*s166
        R1_32 = -R0_31*s166 + R0_32*s164
        C_x = R1_11*s219 + R1_12*tip_v + s223
        C_y = R1_21*s219 + R1_22*tip_v + s228
        C_z = R1_31*s219 + R1_32*tip_v + s233
        s236 = s235 - tx
        s239 = s238 - ty
        c1_x = R1_11*g_x + R1_12*g_y + s253
        c1_y = R1_21*g_x + R1_22*g_y + s257
        c1_z = R1_31*g_x + R1_32*g_y + s261
        s1212 = -s1166 - s1168*s164 + tx
        s1214 = -s1170 - s1172*s164 + ty
        s1216 = ez + s166*s219 + tz
        s1220 = -s1184 + (s1212 * s1212) + (s1214 * s1214) + (s1216 * s1216)
        w[1120 + lane] = s236
        w[1152 + lane] = s239
        w[1184 + lane] = C_x
        w[1216 + lane] = C_y
        w[1248 + lane] = C_z
        w[1280 + lane] = c1_x
        w[1312 + lane] = c1_y
        w[1344 + lane] = c1_z
        w[1376 + lane] = s1212
        w[1408 + lane] = s1214
        w[1440 + lane] = s1216
        w[1472 + lane] = s1220


@straight
def _rows(w, k, n):
    """Equations of a limb, their derivatives by shift and turn of the platform (116 operations)."""
    h_x = k[19]
    h_y = k[20]
    h_z = k[21]
    s1243 = k[85]
    s1489 = k[86]
    for lane in range(n):
        tz = w[96 + lane]
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
        s236 = w[1120 + lane]
        s239 = w[1152 + lane]
        C_x = w[1184 + lane]
        C_y = w[1216 + lane]
        C_z = w[1248 + lane]
        c1_x = w[1280 + lane]
        c1_y = w[1312 + lane]
        c1_z = w[1344 + lane]
        s237 = R_11*s236
        s240 = R_12*s239
        s241 = -R_13*tz
        A_x = px + s237 + s240 + s241
        s243 = R_21*s236
        s244 = R_22*s239
        s245 = -R_23*tz
        A_y = py + s243 + s244 + s245
        s247 = R_31*s236
        s248 = R_32*s239
        s249 = -R_33*tz
        A_z = pz + s247 + s248 + s249
        a1_x = R_11*h_x + R_12*h_y + R_13*h_z
        a1_y = R_21*h_x + R_22*h_y + R_23*h_z
        a1_z = R_31*h_x + R_32*h_y + R_33*h_z
        d_x = A_x - C_x
        d_y = A_y - C_y
        d_z = A_z - C_z
        s_x = a1_x - c1_x
        s_y = a1_y - c1_y
        s_z = a1_z - c1_z
        s1231 = 0.5*(s_x * s_x)
        s1233 = 0.5*(s_y * s_y)
        s1235 = 0.5*(s_z * s_z)
        s1244 = 0.5*(d_x * d_x) + 0.5*(d_y * d_y) + 0.5*(d_z * d_z) + s1231 + s1233 + s1235 + s1243
        s1490 = d_x*s_x + d_y*s_y + d_z*s_z + s1489
        s1715 = -s247 - s248 - s249
        s1717 = s243 + s244 + s245
        s1721 = a1_y*s_z - a1_z*s_y + d_y*s1715 + d_z*s1717
        s1723 = -s237 - s240 - s241
        s1727 = -a1_x*s_z + a1_z*s_x - d_x*s1715 + d_z*s1723
        s1732 = a1_x*s_y - a1_y*s_x - d_x*s1717 - d_y*s1723
        s1737 = a1_y*d_z - a1_z*d_y + s1715*s_y + s1717*s_z
        s1742 = -a1_x*d_z + a1_z*d_x - s1715*s_x + s1723*s_z
        s1747 = a1_x*d_y - a1_y*d_x - s1717*s_x - s1723*s_y
        w[608 + lane] = s1244
        w[640 + lane] = d_x
        w[672 + lane] = d_y
        w[704 + lane] = d_z
        w[736 + lane] = s1721
        w[768 + lane] = s1727
        w[800 + lane] = s1732
        w[864 + lane] = s1490
        w[896 + lane] = s_x
        w[928 + lane] = s_y
        w[960 + lane] = s_z
        w[992 + lane] = s1737
        w[1024 + lane] = s1742
        w[1056 + lane] = s1747


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
        F01 = w[864 + lane]
        J01_0 = w[896 + lane]
        J01_1 = w[928 + lane]
        J01_2 = w[960 + lane]
        J01_3 = w[992 + lane]
        J01_4 = w[1024 + lane]
        J01_5 = w[1056 + lane]
        F10 = w[3616 + lane]
        J10_0 = w[3648 + lane]
        J10_1 = w[3680 + lane]
        J10_2 = w[3712 + lane]
        J10_3 = w[3744 + lane]
        J10_4 = w[3776 + lane]
        J10_5 = w[3808 + lane]
        F11 = w[3872 + lane]
        J11_0 = w[3904 + lane]
        J11_1 = w[3936 + lane]
        J11_2 = w[3968 + lane]
        J11_3 = w[4000 + lane]
        J11_4 = w[4032 + lane]
        J11_5 = w[4064 + lane]
        F20 = w[6624 + lane]
        J20_0 = w[6656 + lane]
        J20_1 = w[6688 + lane]
        J20_2 = w[6720 + lane]
        J20_3 = w[6752 + lane]
        J20_4 = w[6784 + lane]
        J20_5 = w[6816 + lane]
        F21 = w[6880 + lane]
        J21_0 = w[6912 + lane]
        J21_1 = w[6944 + lane]
        J21_2 = w[6976 + lane]
        J21_3 = w[7008 + lane]
        J21_4 = w[7040 + lane]
        J21_5 = w[7072 + lane]
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
        S_00 = -J01_0*U_00 - J01_1*U_10 - J01_2*U_20 + J01_3
        S_01 = -J01_0*U_01 - J01_1*U_11 - J01_2*U_21 + J01_4
        S_02 = -J01_0*U_02 - J01_1*U_12 - J01_2*U_22 + J01_5
        S_10 = -J11_0*U_00 - J11_1*U_10 - J11_2*U_20 + J11_3
        S_11 = -J11_0*U_01 - J11_1*U_11 - J11_2*U_21 + J11_4
        S_12 = -J11_0*U_02 - J11_1*U_12 - J11_2*U_22 + J11_5
        S_20 = -J21_0*U_00 - J21_1*U_10 - J21_2*U_20 + J21_3
        S_21 = -J21_0*U_01 - J21_1*U_11 - J21_2*U_21 + J21_4
        S_22 = -J21_0*U_02 - J21_1*U_12 - J21_2*U_22 + J21_5
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
        s169 = F01 - J01_0*u_00 - J01_1*u_10 - J01_2*u_20
        s174 = F11 - J11_0*u_00 - J11_1*u_10 - J11_2*u_20
        s179 = F21 - J21_0*u_00 - J21_1*u_10 - J21_2*u_20
        w_00 = Si_inv_00*s169 + Si_inv_01*s174 + Si_inv_02*s179
        w_10 = Si_inv_10*s169 + Si_inv_11*s174 + Si_inv_12*s179
        w_20 = Si_inv_20*s169 + Si_inv_21*s174 + Si_inv_22*s179
        s193 = -U_00*w_00 - U_01*w_10 - U_02*w_20 + u_00
        s197 = -U_10*w_00 - U_11*w_10 - U_12*w_20 + u_10
        s201 = -U_20*w_00 - U_21*w_10 - U_22*w_20 + u_20
        s210 = (J10_0 * J10_0) + (J10_1 * J10_1) + (J10_2 * J10_2)
        s214 = (J20_0 * J20_0) + (J20_1 * J20_1) + (J20_2 * J20_2)
        s216 = (G_det_00 * G_det_00) - 1.0e-12*s210*s214*((J00_0 * J00_0) + (J00_1 * J00_1) + (J00_2 * J00_2))
        s225 = (J11_3 * J11_3) + (J11_4 * J11_4) + (J11_5 * J11_5)
        s229 = (J21_3 * J21_3) + (J21_4 * J21_4) + (J21_5 * J21_5)
        s231 = (Si_det_00 * Si_det_00) - 1.0e-12*s225*s229*((J01_3 * J01_3) + (J01_4 * J01_4) + (J01_5 * J01_5))
        w[9024 + lane] = s193
        w[9056 + lane] = s197
        w[9088 + lane] = s201
        w[9120 + lane] = w_00
        w[9152 + lane] = w_10
        w[9184 + lane] = w_20
        w[9216 + lane] = s216
        w[9248 + lane] = s231


@straight
def _start(w, k, n):
    """Joint of the simplified limb at a given position (36 operations)."""
    theta = k[0]
    s1166 = k[24]
    s1168 = k[25]
    s1170 = k[26]
    s1172 = k[27]
    ez = k[28]
    s1191 = k[29]
    s1198 = k[30]
    s1203 = k[31]
    for lane in range(n):
        tx = w[32 + lane]
        ty = w[64 + lane]
        tz = w[96 + lane]
        px = w[128 + lane]
        py = w[160 + lane]
        pz = w[192 + lane]
        s1167 = px + s1166 - tx
        s1171 = py + s1170 - ty
        s1174 = s1167*s1168 + s1171*s1172
        s1176 = -ez + pz - tz
        s1177 = (s1176 * s1176)
        s1192 = 0.5*(s1167 * s1167) + 0.5*(s1171 * s1171) + 0.5*s1177 + s1191
        s1201 = math.sqrt((s1174 * s1174) + s1177*s1198 - (s1192 * s1192))
        s1210 = -theta + arctangent(-s1174*s1201 + s1176*s1192*s1203, -s1174*s1192 - s1176*s1201*s1203)
        w[1504 + lane] = s1210


@straight
def _more(w, k, n):
    """What else derivatives by joint and errors read of it (39 operations)."""
    theta = k[0]
    R0_11 = k[1]
    R0_12 = k[2]
    R0_21 = k[3]
    R0_22 = k[4]
    R0_31 = k[5]
    R0_32 = k[6]
    s219 = k[7]
    tip_v = k[8]
    g_x = k[14]
    g_y = k[15]
    for lane in range(n):
        q = w[0 + lane]
        s163 = q + theta
        s164 = cosine(s163)
        s166 = sine(s163)
        R1_11 = R0_11*s164 + R0_12*s166
        R1_12 = -R0_11*s166 + R0_12*s164
        R1_21 = R0_21*s164 + R0_22*s166
        R1_22 = -R0_21*s166 + R0_22*s164
        R1_31 = R0_31*s164 + R0_32*s166
        R1_32 = -R0_31*s166 + R0_32*s164
        s1750 = R1_11*tip_v - R1_12*s219
        s1754 = R1_21*tip_v - R1_22*s219
        s1758 = R1_31*tip_v - R1_32*s219
        s1762 = R1_11*g_y - R1_12*g_x
        s1766 = R1_21*g_y - R1_22*g_x
        s1770 = R1_31*g_y - R1_32*g_x
        w[1536 + lane] = R1_32
        w[1568 + lane] = R1_31
        w[1600 + lane] = R1_22
        w[1632 + lane] = R1_21
        w[1664 + lane] = R1_12
        w[1696 + lane] = R1_11
        w[1728 + lane] = s166
        w[1760 + lane] = s164
        w[1792 + lane] = s1750
        w[1824 + lane] = s1754
        w[1856 + lane] = s1758
        w[1888 + lane] = s1762
        w[1920 + lane] = s1766
        w[1952 + lane] = s1770


@straight
def _joints(w, k, n):
    """Derivatives of a limb's equations by its joint (61 operations)."""
    h_x = k[19]
    h_y = k[20]
    h_z = k[21]
    for lane in range(n):
        tz = w[96 + lane]
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
        s236 = w[1120 + lane]
        s239 = w[1152 + lane]
        C_x = w[1184 + lane]
        C_y = w[1216 + lane]
        C_z = w[1248 + lane]
        c1_x = w[1280 + lane]
        c1_y = w[1312 + lane]
        c1_z = w[1344 + lane]
        s1750 = w[1792 + lane]
        s1754 = w[1824 + lane]
        s1758 = w[1856 + lane]
        s1762 = w[1888 + lane]
        s1766 = w[1920 + lane]
        s1770 = w[1952 + lane]
        A_x = R_11*s236 + R_12*s239 - R_13*tz + px
        A_y = R_21*s236 + R_22*s239 - R_23*tz + py
        A_z = R_31*s236 + R_32*s239 - R_33*tz + pz
        a1_x = R_11*h_x + R_12*h_y + R_13*h_z
        a1_y = R_21*h_x + R_22*h_y + R_23*h_z
        a1_z = R_31*h_x + R_32*h_y + R_33*h_z
        d_x = A_x - C_x
        d_y = A_y - C_y
        d_z = A_z - C_z
        s_x = a1_x - c1_x
        s_y = a1_y - c1_y
        s_z = a1_z - c1_z
        s1772 = d_x*s1750 + d_y*s1754 + d_z*s1758 + s1762*s_x + s1766*s_y + s1770*s_z
        s1779 = d_x*s1762 + d_y*s1766 + d_z*s1770 + s1750*s_x + s1754*s_y + s1758*s_z
        w[832 + lane] = s1772
        w[1088 + lane] = s1779


@straight
def _command(w, n):
    """Newton's step of joints and rotation; how far the equations are from dependent (152 operations)."""
    for lane in range(n):
        F00 = w[608 + lane]
        J00_0 = w[640 + lane]
        J00_1 = w[672 + lane]
        J00_2 = w[704 + lane]
        J00_3 = w[736 + lane]
        J00_4 = w[768 + lane]
        J00_5 = w[800 + lane]
        Q00 = w[832 + lane]
        F01 = w[864 + lane]
        J01_3 = w[992 + lane]
        J01_4 = w[1024 + lane]
        J01_5 = w[1056 + lane]
        Q01 = w[1088 + lane]
        F10 = w[3616 + lane]
        J10_0 = w[3648 + lane]
        J10_1 = w[3680 + lane]
        J10_2 = w[3712 + lane]
        J10_3 = w[3744 + lane]
        J10_4 = w[3776 + lane]
        J10_5 = w[3808 + lane]
        Q10 = w[3840 + lane]
        F11 = w[3872 + lane]
        J11_3 = w[4000 + lane]
        J11_4 = w[4032 + lane]
        J11_5 = w[4064 + lane]
        Q11 = w[4096 + lane]
        F20 = w[6624 + lane]
        J20_0 = w[6656 + lane]
        J20_1 = w[6688 + lane]
        J20_2 = w[6720 + lane]
        J20_3 = w[6752 + lane]
        J20_4 = w[6784 + lane]
        J20_5 = w[6816 + lane]
        Q20 = w[6848 + lane]
        F21 = w[6880 + lane]
        J21_3 = w[7008 + lane]
        J21_4 = w[7040 + lane]
        J21_5 = w[7072 + lane]
        Q21 = w[7104 + lane]
        by_00 = (1.0 / Q00)
        by_10 = (1.0 / Q10)
        by_20 = (1.0 / Q20)
        ratio_00 = Q01*by_00
        ratio_10 = Q11*by_10
        ratio_20 = Q21*by_20
        E_00 = -J00_3*ratio_00 + J01_3
        E_01 = -J00_4*ratio_00 + J01_4
        E_02 = -J00_5*ratio_00 + J01_5
        E_10 = -J10_3*ratio_10 + J11_3
        E_11 = -J10_4*ratio_10 + J11_4
        E_12 = -J10_5*ratio_10 + J11_5
        E_20 = -J20_3*ratio_20 + J21_3
        E_21 = -J20_4*ratio_20 + J21_4
        E_22 = -J20_5*ratio_20 + J21_5
        E_cof_00 = E_11*E_22 - E_12*E_21
        E_cof_01 = -E_10*E_22 + E_12*E_20
        E_cof_02 = E_10*E_21 - E_11*E_20
        E_cof_10 = -E_01*E_22 + E_02*E_21
        E_cof_11 = E_00*E_22 - E_02*E_20
        E_cof_12 = -E_00*E_21 + E_01*E_20
        E_cof_20 = E_01*E_12 - E_02*E_11
        E_cof_21 = -E_00*E_12 + E_02*E_10
        E_cof_22 = E_00*E_11 - E_01*E_10
        E_det_00 = E_00*E_cof_00 + E_01*E_cof_01 + E_02*E_cof_02
        E_by_00 = (1.0 / E_det_00)
        s57 = -F00*ratio_00 + F01
        s60 = -F10*ratio_10 + F11
        s63 = -F20*ratio_20 + F21
        w_00 = E_by_00*(E_cof_00*s57 + E_cof_10*s60 + E_cof_20*s63)
        w_10 = E_by_00*(E_cof_01*s57 + E_cof_11*s60 + E_cof_21*s63)
        w_20 = E_by_00*(E_cof_02*s57 + E_cof_12*s60 + E_cof_22*s63)
        s81 = by_00*(F00 - J00_3*w_00 - J00_4*w_10 - J00_5*w_20)
        s86 = by_10*(F10 - J10_3*w_00 - J10_4*w_10 - J10_5*w_20)
        s91 = by_20*(F20 - J20_3*w_00 - J20_4*w_10 - J20_5*w_20)
        s100 = (E_10 * E_10) + (E_11 * E_11) + (E_12 * E_12)
        s104 = (E_20 * E_20) + (E_21 * E_21) + (E_22 * E_22)
        s106 = (E_det_00 * E_det_00) - 1.0e-12*s100*s104*((E_00 * E_00) + (E_01 * E_01) + (E_02 * E_02))
        s114 = -1.0e-12*(J00_0 * J00_0) - 1.0e-12*(J00_1 * J00_1) - 1.0e-12*(J00_2 * J00_2) + (Q00 * Q00)
        s122 = -1.0e-12*(J10_0 * J10_0) - 1.0e-12*(J10_1 * J10_1) - 1.0e-12*(J10_2 * J10_2) + (Q10 * Q10)
        s130 = -1.0e-12*(J20_0 * J20_0) - 1.0e-12*(J20_1 * J20_1) - 1.0e-12*(J20_2 * J20_2) + (Q20 * Q20)
        w[10528 + lane] = s81
        w[10560 + lane] = s86
        w[10592 + lane] = s91
        w[10624 + lane] = w_00
        w[10656 + lane] = w_10
        w[10688 + lane] = w_20
        w[10720 + lane] = s106
        w[10752 + lane] = s114
        w[10784 + lane] = s122
        w[10816 + lane] = s130


@straight
def _errors(w, k, n):
    """Derivatives of a limb's equations by errors, by deflections (488 operations)."""
    R0_11 = k[1]
    R0_12 = k[2]
    R0_21 = k[3]
    R0_22 = k[4]
    R0_31 = k[5]
    R0_32 = k[6]
    s219 = k[7]
    tip_v = k[8]
    g_x = k[14]
    g_y = k[15]
    h_x = k[19]
    h_y = k[20]
    h_z = k[21]
    s516 = k[32]
    s547 = k[33]
    s552 = k[34]
    s578 = k[35]
    s610 = k[36]
    s615 = k[37]
    s617 = k[38]
    s619 = k[39]
    s621 = k[40]
    s624 = k[41]
    s606 = k[42]
    s628 = k[43]
    s634 = k[44]
    s637 = k[45]
    s643 = k[46]
    s668 = k[47]
    s700 = k[48]
    s706 = k[49]
    s731 = k[50]
    s764 = k[51]
    s770 = k[52]
    s772 = k[53]
    s774 = k[54]
    s776 = k[55]
    s779 = k[56]
    s760 = k[57]
    s783 = k[58]
    s788 = k[59]
    s791 = k[60]
    s796 = k[61]
    s802 = k[62]
    s804 = k[63]
    s806 = k[64]
    s808 = k[65]
    s810 = k[66]
    s843 = k[67]
    s868 = k[68]
    s870 = k[69]
    s872 = k[70]
    s874 = k[71]
    s905 = k[72]
    s929 = k[73]
    s932 = k[74]
    s934 = k[75]
    s936 = k[76]
    R0_33 = k[77]
    R0_23 = k[78]
    R0_13 = k[79]
    s1458 = k[87]
    s1459 = k[88]
    s290 = k[89]
    s1690 = k[90]
    for lane in range(n):
        tz = w[96 + lane]
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
        s236 = w[1120 + lane]
        s239 = w[1152 + lane]
        C_x = w[1184 + lane]
        C_y = w[1216 + lane]
        C_z = w[1248 + lane]
        c1_x = w[1280 + lane]
        c1_y = w[1312 + lane]
        c1_z = w[1344 + lane]
        R1_32 = w[1536 + lane]
        R1_31 = w[1568 + lane]
        R1_22 = w[1600 + lane]
        R1_21 = w[1632 + lane]
        R1_12 = w[1664 + lane]
        R1_11 = w[1696 + lane]
        s166 = w[1728 + lane]
        s164 = w[1760 + lane]
        A_x = R_11*s236 + R_12*s239 - R_13*tz + px
        A_y = R_21*s236 + R_22*s239 - R_23*tz + py
        A_z = R_31*s236 + R_32*s239 - R_33*tz + pz
        a1_x = R_11*h_x + R_12*h_y + R_13*h_z
        a1_y = R_21*h_x + R_22*h_y + R_23*h_z
        a1_z = R_31*h_x + R_32*h_y + R_33*h_z
        d_x = A_x - C_x
        d_y = A_y - C_y
        d_z = A_z - C_z
        s_x = a1_x - c1_x
        s_y = a1_y - c1_y
        s_z = a1_z - c1_z
        s1245 = 2*s_z
        s1246 = 0.5*s1245
        s1247 = 2*s_y
        s1248 = 0.5*s1247
        s1249 = 2*s_x
        s1250 = 0.5*s1249
        s1251 = 2*d_z
        s1252 = 0.5*s1251
        s1253 = 2*d_y
        s1254 = 0.5*s1253
        s1255 = 2*d_x
        s1256 = 0.5*s1255
        s1370 = -g_y*s1246 - s1252*tip_v
        s1375 = -g_x*s1246 - s1252*s219
        s1380 = -g_y*s1248 - s1254*tip_v
        s1385 = -g_x*s1248 - s1254*s219
        s1390 = -g_y*s1250 - s1256*tip_v
        s1395 = -g_x*s1250 - s1256*s219
        s1399 = s164*(-R0_11*s1390 + R0_12*s1395 - R0_21*s1380 + R0_22*s1385 - R0_31*s1370 + R0_32*s1375)
        s1402 = R0_11*s1395 + R0_12*s1390 + R0_21*s1385 + R0_22*s1380 + R0_31*s1375 + R0_32*s1370
        s1404 = s1399 - s1402*s166
        s1405 = R_13*s1250 + R_23*s1248 + R_33*s1246
        s1406 = R_12*s1250 + R_22*s1248 + R_32*s1246
        s1407 = R_11*s1250 + R_21*s1248 + R_31*s1246
        s1408 = -R1_12*s1250 - R1_22*s1248 - R1_32*s1246
        s1409 = -R1_11*s1250 - R1_21*s1248 - R1_31*s1246
        s1411 = -R1_12*s1256 - R1_22*s1254 - R1_32*s1252
        s1412 = -R1_11*s1256 - R1_21*s1254 - R1_31*s1252
        s1416 = -s1370*s166 + s1375*s164
        s1417 = s1370*s164 + s1375*s166
        s1418 = -s1380*s166 + s1385*s164
        s1419 = s1380*s164 + s1385*s166
        s1420 = -s1390*s166 + s1395*s164
        s1421 = s1390*s164 + s1395*s166
        s1425 = s1405*s516
        s1426 = s1406*s547
        s1427 = s1407*s552
        s1428 = -s1246*s578
        s1429 = -s1248*s610
        s1430 = -s1250*s615
        s1431 = -s1252*s617
        s1432 = -s1254*s619
        s1433 = -s1256*s621
        s1434 = s1416*s624
        s1435 = s1417*s606
        s1436 = s1418*s628
        s1437 = s1419*s634
        s1438 = s1420*s637
        s1439 = s1421*s643
        s1440 = s1425 + s1426 + s1427 + s1428 + s1429 + s1430 + s1431 + s1432 + s1433 + s1434 + s1435 + s1436 + s1437 + s1438 + s1439
        s1441 = s1405*s668
        s1442 = s1406*s700
        s1443 = s1407*s706
        s1444 = -s1246*s731
        s1445 = -s1248*s764
        s1446 = -s1250*s770
        s1447 = -s1252*s772
        s1448 = -s1254*s774
        s1449 = -s1256*s776
        s1450 = s1416*s779
        s1451 = s1417*s760
        s1452 = s1418*s783
        s1453 = s1419*s788
        s1454 = s1420*s791
        s1455 = s1421*s796
        s1456 = s1441 + s1442 + s1443 + s1444 + s1445 + s1446 + s1447 + s1448 + s1449 + s1450 + s1451 + s1452 + s1453 + s1454 + s1455
        s1465 = -s1246*s802 - s1248*s808 - s1250*s810 + s1408*s804 + s1409*s806
        s1466 = -s1425 - s1426 - s1427
        s1467 = -s1441 - s1442 - s1443
        s1473 = -s1246*s843 - s1248*s872 - s1250*s874 + s1408*s868 + s1409*s870
        s1479 = -s1246*s905 - s1248*s934 - s1250*s936 + s1408*s929 + s1409*s932
        s1483 = -R0_13*s1256 - R0_23*s1254 - R0_33*s1252
        s1604 = -d_z*g_y - s_z*tip_v
        s1609 = -d_z*g_x - s219*s_z
        s1614 = -d_y*g_y - s_y*tip_v
        s1619 = -d_y*g_x - s219*s_y
        s1624 = -d_x*g_y - s_x*tip_v
        s1629 = -d_x*g_x - s219*s_x
        s1633 = s164*(-R0_11*s1624 + R0_12*s1629 - R0_21*s1614 + R0_22*s1619 - R0_31*s1604 + R0_32*s1609)
        s1636 = R0_11*s1629 + R0_12*s1624 + R0_21*s1619 + R0_22*s1614 + R0_31*s1609 + R0_32*s1604
        s1638 = s1633 - s1636*s166
        s1639 = R_13*d_x + R_23*d_y + R_33*d_z
        s1640 = R_12*d_x + R_22*d_y + R_32*d_z
        s1641 = R_11*d_x + R_21*d_y + R_31*d_z
        s1642 = -R1_12*d_x - R1_22*d_y - R1_32*d_z
        s1643 = -R1_11*d_x - R1_21*d_y - R1_31*d_z
        s1645 = -R1_12*s_x - R1_22*s_y - R1_32*s_z
        s1646 = -R1_11*s_x - R1_21*s_y - R1_31*s_z
        s1650 = -s1604*s166 + s1609*s164
        s1651 = s1604*s164 + s1609*s166
        s1652 = -s1614*s166 + s1619*s164
        s1653 = s1614*s164 + s1619*s166
        s1654 = -s1624*s166 + s1629*s164
        s1655 = s1624*s164 + s1629*s166
        s1658 = s1639*s516
        s1659 = s1640*s547
        s1660 = s1641*s552
        s1661 = -d_z*s578
        s1662 = -d_y*s610
        s1663 = -d_x*s615
        s1664 = -s617*s_z
        s1665 = -s619*s_y
        s1666 = -s621*s_x
        s1667 = s1650*s624
        s1668 = s1651*s606
        s1669 = s1652*s628
        s1670 = s1653*s634
        s1671 = s1654*s637
        s1672 = s1655*s643
        s1673 = s1658 + s1659 + s1660 + s1661 + s1662 + s1663 + s1664 + s1665 + s1666 + s1667 + s1668 + s1669 + s1670 + s1671 + s1672
        s1674 = s1639*s668
        s1675 = s1640*s700
        s1676 = s1641*s706
        s1677 = -d_z*s731
        s1678 = -d_y*s764
        s1679 = -d_x*s770
        s1680 = -s772*s_z
        s1681 = -s774*s_y
        s1682 = -s776*s_x
        s1683 = s1650*s779
        s1684 = s1651*s760
        s1685 = s1652*s783
        s1686 = s1653*s788
        s1687 = s1654*s791
        s1688 = s1655*s796
        s1689 = s1674 + s1675 + s1676 + s1677 + s1678 + s1679 + s1680 + s1681 + s1682 + s1683 + s1684 + s1685 + s1686 + s1687 + s1688
        s1696 = -d_x*s810 - d_y*s808 - d_z*s802 + s1642*s804 + s1643*s806
        s1697 = -s1658 - s1659 - s1660
        s1698 = -s1674 - s1675 - s1676
        s1704 = -d_x*s874 - d_y*s872 - d_z*s843 + s1642*s868 + s1643*s870
        s1710 = -d_x*s936 - d_y*s934 - d_z*s905 + s1642*s929 + s1643*s932
        s1714 = -R0_13*s_x - R0_23*s_y - R0_33*s_z
        w[1984 + lane] = s1404
        w[2016 + lane] = -s1256
        w[2048 + lane] = -s1254
        w[2080 + lane] = -s1252
        w[2112 + lane] = s1412
        w[2144 + lane] = s1440
        w[2176 + lane] = s1456
        w[2208 + lane] = s1458
        w[2240 + lane] = s1459
        w[2272 + lane] = s1465
        w[2304 + lane] = s1466
        w[2336 + lane] = s1467
        w[2368 + lane] = s1473
        w[2400 + lane] = s1479
        w[2432 + lane] = s1411
        w[2464 + lane] = s1483
        w[2496 + lane] = s1638
        w[2528 + lane] = -s_x
        w[2560 + lane] = -s_y
        w[2592 + lane] = -s_z
        w[2624 + lane] = s1646
        w[2656 + lane] = s1673
        w[2688 + lane] = s1689
        w[2720 + lane] = -s290
        w[2752 + lane] = s1690
        w[2784 + lane] = s1696
        w[2816 + lane] = s1697
        w[2848 + lane] = s1698
        w[2880 + lane] = s1704
        w[2912 + lane] = s1710
        w[2944 + lane] = s1645
        w[2976 + lane] = s1714


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
        J01_0 = w[896 + lane]
        J01_1 = w[928 + lane]
        J01_2 = w[960 + lane]
        J01_3 = w[992 + lane]
        J01_4 = w[1024 + lane]
        J01_5 = w[1056 + lane]
        J10_0 = w[3648 + lane]
        J10_1 = w[3680 + lane]
        J10_2 = w[3712 + lane]
        J10_3 = w[3744 + lane]
        J10_4 = w[3776 + lane]
        J10_5 = w[3808 + lane]
        J11_0 = w[3904 + lane]
        J11_1 = w[3936 + lane]
        J11_2 = w[3968 + lane]
        J11_3 = w[4000 + lane]
        J11_4 = w[4032 + lane]
        J11_5 = w[4064 + lane]
        J20_0 = w[6656 + lane]
        J20_1 = w[6688 + lane]
        J20_2 = w[6720 + lane]
        J20_3 = w[6752 + lane]
        J20_4 = w[6784 + lane]
        J20_5 = w[6816 + lane]
        J21_0 = w[6912 + lane]
        J21_1 = w[6944 + lane]
        J21_2 = w[6976 + lane]
        J21_3 = w[7008 + lane]
        J21_4 = w[7040 + lane]
        J21_5 = w[7072 + lane]
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
        S_00 = -J01_0*U_00 - J01_1*U_10 - J01_2*U_20 + J01_3
        S_01 = -J01_0*U_01 - J01_1*U_11 - J01_2*U_21 + J01_4
        S_02 = -J01_0*U_02 - J01_1*U_12 - J01_2*U_22 + J01_5
        S_10 = -J11_0*U_00 - J11_1*U_10 - J11_2*U_20 + J11_3
        S_11 = -J11_0*U_01 - J11_1*U_11 - J11_2*U_21 + J11_4
        S_12 = -J11_0*U_02 - J11_1*U_12 - J11_2*U_22 + J11_5
        S_20 = -J21_0*U_00 - J21_1*U_10 - J21_2*U_20 + J21_3
        S_21 = -J21_0*U_01 - J21_1*U_11 - J21_2*U_21 + J21_4
        S_22 = -J21_0*U_02 - J21_1*U_12 - J21_2*U_22 + J21_5
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
        s193 = -J01_0*Si_inv_00 - J11_0*Si_inv_01 - J21_0*Si_inv_02
        s198 = -J01_1*Si_inv_00 - J11_1*Si_inv_01 - J21_1*Si_inv_02
        s203 = -J01_2*Si_inv_00 - J11_2*Si_inv_01 - J21_2*Si_inv_02
        V_00 = G_inv_00*s193 + G_inv_10*s198 + G_inv_20*s203
        V_01 = G_inv_01*s193 + G_inv_11*s198 + G_inv_21*s203
        V_02 = G_inv_02*s193 + G_inv_12*s198 + G_inv_22*s203
        s217 = -J01_0*Si_inv_10 - J11_0*Si_inv_11 - J21_0*Si_inv_12
        s222 = -J01_1*Si_inv_10 - J11_1*Si_inv_11 - J21_1*Si_inv_12
        s227 = -J01_2*Si_inv_10 - J11_2*Si_inv_11 - J21_2*Si_inv_12
        V_10 = G_inv_00*s217 + G_inv_10*s222 + G_inv_20*s227
        V_11 = G_inv_01*s217 + G_inv_11*s222 + G_inv_21*s227
        V_12 = G_inv_02*s217 + G_inv_12*s222 + G_inv_22*s227
        s241 = -J01_0*Si_inv_20 - J11_0*Si_inv_21 - J21_0*Si_inv_22
        s246 = -J01_1*Si_inv_20 - J11_1*Si_inv_21 - J21_1*Si_inv_22
        s251 = -J01_2*Si_inv_20 - J11_2*Si_inv_21 - J21_2*Si_inv_22
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
        s357 = (J11_3 * J11_3) + (J11_4 * J11_4) + (J11_5 * J11_5)
        s361 = (J21_3 * J21_3) + (J21_4 * J21_4) + (J21_5 * J21_5)
        s363 = (Si_det_00 * Si_det_00) - 1.0e-12*s357*s361*((J01_3 * J01_3) + (J01_4 * J01_4) + (J01_5 * J01_5))
        w[9312 + lane] = s265
        w[9344 + lane] = s269
        w[9376 + lane] = s273
        w[9408 + lane] = s277
        w[9440 + lane] = s281
        w[9472 + lane] = s285
        w[9504 + lane] = s289
        w[9536 + lane] = s293
        w[9568 + lane] = s297
        w[9600 + lane] = s301
        w[9632 + lane] = s305
        w[9664 + lane] = s309
        w[9696 + lane] = s313
        w[9728 + lane] = s317
        w[9760 + lane] = s321
        w[9792 + lane] = s325
        w[9824 + lane] = s329
        w[9856 + lane] = s333
        w[9888 + lane] = -V_00
        w[9920 + lane] = -V_01
        w[9952 + lane] = -V_02
        w[9984 + lane] = -Si_inv_00
        w[10016 + lane] = -Si_inv_01
        w[10048 + lane] = -Si_inv_02
        w[10080 + lane] = -V_10
        w[10112 + lane] = -V_11
        w[10144 + lane] = -V_12
        w[10176 + lane] = -Si_inv_10
        w[10208 + lane] = -Si_inv_11
        w[10240 + lane] = -Si_inv_12
        w[10272 + lane] = -V_20
        w[10304 + lane] = -V_21
        w[10336 + lane] = -V_22
        w[10368 + lane] = -Si_inv_20
        w[10400 + lane] = -Si_inv_21
        w[10432 + lane] = -Si_inv_22
        w[10464 + lane] = s348
        w[10496 + lane] = s363


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
        y0 = w[9024 + lane]
        y1 = w[9056 + lane]
        y2 = w[9088 + lane]
        y3 = w[9120 + lane]
        y4 = w[9152 + lane]
        y5 = w[9184 + lane]
        going = w[9280 + lane]
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
        w[3136 + lane] = new_00
        w[6144 + lane] = new_00
        w[160 + lane] = new_10
        w[3168 + lane] = new_10
        w[6176 + lane] = new_10
        w[192 + lane] = new_20
        w[3200 + lane] = new_20
        w[6208 + lane] = new_20
        w[224 + lane] = new_30
        w[256 + lane] = new_40
        w[288 + lane] = new_50
        w[320 + lane] = s51
        w[3328 + lane] = s51
        w[6336 + lane] = s51
        w[352 + lane] = s54
        w[3360 + lane] = s54
        w[6368 + lane] = s54
        w[384 + lane] = s57
        w[3392 + lane] = s57
        w[6400 + lane] = s57
        w[416 + lane] = s59
        w[3424 + lane] = s59
        w[6432 + lane] = s59
        w[448 + lane] = s63
        w[3456 + lane] = s63
        w[6464 + lane] = s63
        w[480 + lane] = s66
        w[3488 + lane] = s66
        w[6496 + lane] = s66
        w[512 + lane] = s68
        w[3520 + lane] = s68
        w[6528 + lane] = s68
        w[544 + lane] = s70
        w[3552 + lane] = s70
        w[6560 + lane] = s70
        w[576 + lane] = s73
        w[3584 + lane] = s73
        w[6592 + lane] = s73


@straight
def _meet(w, n):
    """Put the platform where the simplified machine has it."""
    for lane in range(n):
        c_00 = w[1376 + lane]
        c_01 = w[1408 + lane]
        c_02 = w[1440 + lane]
        c_03 = w[1472 + lane]
        c_10 = w[4384 + lane]
        c_11 = w[4416 + lane]
        c_12 = w[4448 + lane]
        c_13 = w[4480 + lane]
        c_20 = w[7392 + lane]
        c_21 = w[7424 + lane]
        c_22 = w[7456 + lane]
        c_23 = w[7488 + lane]
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
        along = -half - (s73 if (n_z > 0) else -s73)
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
        w[9280 + lane] = 0.0 if good else 1.0
        w[128 + lane] = p_0
        w[160 + lane] = p_1
        w[192 + lane] = p_2
        w[224 + lane] = 0.0
        w[256 + lane] = 0.0
        w[288 + lane] = 0.0


@straight
def _settle(w, n):
    """Mark the poses for which this step was the last; return how many go on."""
    left = 0
    for lane in range(n):
        done = (w[9216 + lane] > 0.0)
        done = done & (w[9248 + lane] > 0.0)
        done = done & (abs(w[9024 + lane]) < STEP_DONE)
        done = done & (abs(w[9056 + lane]) < STEP_DONE)
        done = done & (abs(w[9088 + lane]) < STEP_DONE)
        done = done & (abs(w[9120 + lane]) < TURN_DONE)
        done = done & (abs(w[9152 + lane]) < TURN_DONE)
        done = done & (abs(w[9184 + lane]) < TURN_DONE)
        going = 0.0 if done | (w[9280 + lane] == 0.0) else 1.0
        w[9280 + lane] = going
        left += 1 if going == 1.0 else 0
    return left


@straight
def _settle_joints(w, n):
    """Mark the poses for which this step was the last; return how many go on."""
    left = 0
    for lane in range(n):
        done = (w[10720 + lane] > 0.0)
        done = done & (w[10752 + lane] > 0.0)
        done = done & (w[10784 + lane] > 0.0)
        done = done & (w[10816 + lane] > 0.0)
        done = done & (abs(w[10528 + lane]) < TURN_DONE)
        done = done & (abs(w[10560 + lane]) < TURN_DONE)
        done = done & (abs(w[10592 + lane]) < TURN_DONE)

        done = done & (abs(w[10624 + lane]) < TURN_DONE)
        done = done & (abs(w[10656 + lane]) < TURN_DONE)
        done = done & (abs(w[10688 + lane]) < TURN_DONE)
        going = 0.0 if done | (w[9280 + lane] == 0.0) else 1.0
        w[9280 + lane] = going
        left += 1 if going == 1.0 else 0
    return left


@straight
def _begin(w, n):
    """Let all poses go."""
    for lane in range(n):
        w[9280 + lane] = 1.0
        w[9024 + lane] = 0.0
        w[9056 + lane] = 0.0
        w[9088 + lane] = 0.0
        w[9120 + lane] = 0.0
        w[9152 + lane] = 0.0
        w[9184 + lane] = 0.0


@straight
def _started(w, n):
    """Take joints, and coordinates that no command asks for, from the simplified machine."""
    for lane in range(n):
        w[9280 + lane] = 0.0 if (abs(w[1504 + lane]) < math.inf) & (abs(w[4512 + lane]) < math.inf) & (abs(w[7520 + lane]) < math.inf) else 1.0
        w[0 + lane] = w[1504 + lane]
        w[3008 + lane] = w[4512 + lane]
        w[6016 + lane] = w[7520 + lane]
        w[224 + lane] = 0.0
        w[256 + lane] = 0.0
        w[288 + lane] = 0.0


@straight
def _turn_joints(w, n):
    """Move the joints by a step; what it does to the platform is left to `_move`."""
    for lane in range(n):
        going = w[9280 + lane]
        w[0 + lane] -= going * w[10528 + lane]
        w[3008 + lane] -= going * w[10560 + lane]
        w[6016 + lane] -= going * w[10592 + lane]
        w[9120 + lane] = w[10624 + lane]
        w[9152 + lane] = w[10656 + lane]
        w[9184 + lane] = w[10688 + lane]

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
        is_open = w[9280 + lane] != 0.0
        status[first + lane] = OPEN if is_open else SOLVED
        left += 1 if is_open else 0
    return left


@straight
def _unload_joints(w, q, first, last):
    for lane in range(last - first + 1):
        q[3 * (first + lane) + 0] = w[0 + lane]
        q[3 * (first + lane) + 1] = w[3008 + lane]
        q[3 * (first + lane) + 2] = w[6016 + lane]


@fast
def _forward(q, tool, k, x, status, warm):
    w = scratch(WORK + SPARE)
    w_1 = w[0:3008]
    w_2 = w[3008:6016]
    w_3 = w[6016:9024]
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
    w_1 = w[0:3008]
    w_2 = w[3008:6016]
    w_3 = w[6016:9024]
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
    """Fill the joints q (N, 3) that bring the reference point to target (N, 3), and the pose x (N, 6) it then has.

    Newton on the joints and the platform's rotation from the simplified machine. status as in `forward`; UNREACHABLE
    where the target lies beyond the reach of a limb.
    """
    if _inverse(target, tool, k, x, q, status):
        left = np.flatnonzero(status == OPEN)
        found, joints, of = (
            np.empty((len(left), 6)), np.empty((len(left), 3)), np.zeros(len(left), dtype=np.int64)
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
        own = machines[273 * (m // (runs // k.shape[0])) :]
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
    theta_0 = own[0 + 0]
    s219_0 = own[0 + 7]
    s1166_0 = own[0 + 24]
    s1168_0 = own[0 + 25]
    s1170_0 = own[0 + 26]
    s1172_0 = own[0 + 27]
    ez_0 = own[0 + 28]
    s1184_0 = own[0 + 84]
    theta_1 = own[91 + 0]
    s219_1 = own[91 + 7]
    s1166_1 = own[91 + 24]
    s1168_1 = own[91 + 25]
    s1170_1 = own[91 + 26]
    s1172_1 = own[91 + 27]
    ez_1 = own[91 + 28]
    s1184_1 = own[91 + 84]
    theta_2 = own[182 + 0]
    s219_2 = own[182 + 7]
    s1166_2 = own[182 + 24]
    s1168_2 = own[182 + 25]
    s1170_2 = own[182 + 26]
    s1172_2 = own[182 + 27]
    ez_2 = own[182 + 28]
    s1184_2 = own[182 + 84]
    for first in range(0, poses, SPHERES):  # in two short loops, of which a processor has several rounds at work
        count = min(SPHERES, poses - first)
        for lane in range(count):
            n = first + lane
            q_0 = q[3 * n + 0]
            s163_0 = q_0 + theta_0
            s164_0 = cosine(s163_0)
            s1212_0 = -s1166_0 - s1168_0*s164_0 + tx
            s1214_0 = -s1170_0 - s1172_0*s164_0 + ty
            s1216_0 = ez_0 + s219_0*sine(s163_0) + tz
            s1220_0 = -s1184_0 + (s1212_0 * s1212_0) + (s1214_0 * s1214_0) + (s1216_0 * s1216_0)
            c_00 = s1212_0
            c_01 = s1214_0
            c_02 = s1216_0
            c_03 = s1220_0
            q_1 = q[3 * n + 1]
            s163_1 = q_1 + theta_1
            s164_1 = cosine(s163_1)
            s1212_1 = -s1166_1 - s1168_1*s164_1 + tx
            s1214_1 = -s1170_1 - s1172_1*s164_1 + ty
            s1216_1 = ez_1 + s219_1*sine(s163_1) + tz
            s1220_1 = -s1184_1 + (s1212_1 * s1212_1) + (s1214_1 * s1214_1) + (s1216_1 * s1216_1)
            c_10 = s1212_1
            c_11 = s1214_1
            c_12 = s1216_1
            c_13 = s1220_1
            q_2 = q[3 * n + 2]
            s163_2 = q_2 + theta_2
            s164_2 = cosine(s163_2)
            s1212_2 = -s1166_2 - s1168_2*s164_2 + tx
            s1214_2 = -s1170_2 - s1172_2*s164_2 + ty
            s1216_2 = ez_2 + s219_2*sine(s163_2) + tz
            s1220_2 = -s1184_2 + (s1212_2 * s1212_2) + (s1214_2 * s1214_2) + (s1216_2 * s1216_2)
            c_20 = s1212_2
            c_21 = s1214_2
            c_22 = s1216_2
            c_23 = s1220_2
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
            along = -half - (s73 if (n_z > 0) else -s73)
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
    """Fill x (N, 3) with the platform of the simplified machine, in closed form: exact where alpha0, beta0, dl, dc, alpha03, beta03, alpha2, beta2, tip_v, tip_w are zero.

    It does not turn, so that x is the position of the reference point.
    status as in `forward`.
    """
    if _simplified_forward(q, tool, k, x, status):
        left = np.flatnonzero(status == OPEN)
        found, of = np.empty((len(left), 6)), np.empty(len(left), dtype=status.dtype)
        forward(q[left], _of(tool, left, len(status)), _of(k, left, len(status)), found, of, False)
        x[left], status[left] = found[:, :3], of


@fast
def _simplified_inverse(target, tool, k, q, status):
    given, found = target.reshape(target.size), q.reshape(q.size)
    machines, tools = k.reshape(k.size), tool.reshape(tool.size)
    left, runs = 0, max(k.shape[0], tool.shape[0])
    each = status.size // runs
    for m in range(runs):
        own = machines[273 * (m // (runs // k.shape[0])) :]
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
    theta_0 = own[0 + 0]
    s1166_0 = own[0 + 24]
    s1168_0 = own[0 + 25]
    s1170_0 = own[0 + 26]
    s1172_0 = own[0 + 27]
    ez_0 = own[0 + 28]
    s1191_0 = own[0 + 29]
    s1198_0 = own[0 + 30]
    s1203_0 = own[0 + 31]
    theta_1 = own[91 + 0]
    s1166_1 = own[91 + 24]
    s1168_1 = own[91 + 25]
    s1170_1 = own[91 + 26]
    s1172_1 = own[91 + 27]
    ez_1 = own[91 + 28]
    s1191_1 = own[91 + 29]
    s1198_1 = own[91 + 30]
    s1203_1 = own[91 + 31]
    theta_2 = own[182 + 0]
    s1166_2 = own[182 + 24]
    s1168_2 = own[182 + 25]
    s1170_2 = own[182 + 26]
    s1172_2 = own[182 + 27]
    ez_2 = own[182 + 28]
    s1191_2 = own[182 + 29]
    s1198_2 = own[182 + 30]
    s1203_2 = own[182 + 31]
    for n in range(poses):
        px = target[3 * n + 0]
        py = target[3 * n + 1]
        pz = target[3 * n + 2]
        s1167_0 = px + s1166_0 - tx
        s1171_0 = py + s1170_0 - ty
        s1174_0 = s1167_0*s1168_0 + s1171_0*s1172_0
        s1176_0 = -ez_0 + pz - tz
        s1177_0 = (s1176_0 * s1176_0)
        s1192_0 = 0.5*(s1167_0 * s1167_0) + 0.5*(s1171_0 * s1171_0) + 0.5*s1177_0 + s1191_0
        s1201_0 = math.sqrt((s1174_0 * s1174_0) + s1177_0*s1198_0 - (s1192_0 * s1192_0))
        s1210_0 = -theta_0 + arctangent(-s1174_0*s1201_0 + s1176_0*s1192_0*s1203_0, -s1174_0*s1192_0 - s1176_0*s1201_0*s1203_0)
        q_00 = s1210_0
        s1167_1 = px + s1166_1 - tx
        s1171_1 = py + s1170_1 - ty
        s1174_1 = s1167_1*s1168_1 + s1171_1*s1172_1
        s1176_1 = -ez_1 + pz - tz
        s1177_1 = (s1176_1 * s1176_1)
        s1192_1 = 0.5*(s1167_1 * s1167_1) + 0.5*(s1171_1 * s1171_1) + 0.5*s1177_1 + s1191_1
        s1201_1 = math.sqrt((s1174_1 * s1174_1) + s1177_1*s1198_1 - (s1192_1 * s1192_1))
        s1210_1 = -theta_1 + arctangent(-s1174_1*s1201_1 + s1176_1*s1192_1*s1203_1, -s1174_1*s1192_1 - s1176_1*s1201_1*s1203_1)
        q_10 = s1210_1
        s1167_2 = px + s1166_2 - tx
        s1171_2 = py + s1170_2 - ty
        s1174_2 = s1167_2*s1168_2 + s1171_2*s1172_2
        s1176_2 = -ez_2 + pz - tz
        s1177_2 = (s1176_2 * s1176_2)
        s1192_2 = 0.5*(s1167_2 * s1167_2) + 0.5*(s1171_2 * s1171_2) + 0.5*s1177_2 + s1191_2
        s1201_2 = math.sqrt((s1174_2 * s1174_2) + s1177_2*s1198_2 - (s1192_2 * s1192_2))
        s1210_2 = -theta_2 + arctangent(-s1174_2*s1201_2 + s1176_2*s1192_2*s1203_2, -s1174_2*s1192_2 - s1176_2*s1201_2*s1203_2)
        q_20 = s1210_2
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
            np.empty((len(left), 6)), np.empty((len(left), 3)),
            np.empty(len(left), dtype=status.dtype),
        )
        inverse(target[left], _of(tool, left, len(status)), _of(k, left, len(status)), found, joints, of)
        q[left], status[left] = joints, of


@fast
def _sensitivity(x, q, tool, k, S_p, S_q, status):
    w, by_errors, by_joints = scratch(WORK + SPARE), S_p.reshape(S_p.size), S_q.reshape(S_q.size)
    w_1 = w[0:3008]
    w_2 = w[3008:6016]
    w_3 = w[6016:9024]
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
        whole = 288 * (first + lane + 8) <= S_p.size  # else the last poses are written through scratch
        to, at = (S_p, 288 * (first + lane)) if whole else (w[WORK:], 0)
        for i in range(3):
            outer(to, at + 16 * i + 0, 288, 48, 6, w, (9312 + 32 * i + lane, 9408 + 32 * i + lane, ), 192, (1984 + 3008 * i + lane, 2496 + 3008 * i + lane, ), 32, 8)
            outer(to, at + 16 * i + 8, 288, 48, 6, w, (9312 + 32 * i + lane, 9408 + 32 * i + lane, ), 192, (2240 + 3008 * i + lane, 2752 + 3008 * i + lane, ), 32, 8)
        if not whole:
            for c in range(288 * (last + 1 - first - lane)):
                S_p[288 * (first + lane) + c] = to[c]
        whole = 18 * (first + lane + 8) <= S_q.size  # else the last poses are written through scratch
        to, at = (S_q, 18 * (first + lane)) if whole else (w[WORK:], 0)
        for i in range(3):
            outer(to, at + 1 * i + 0, 18, 3, 6, w, (9312 + 32 * i + lane, 9408 + 32 * i + lane, ), 192, (832 + 3008 * i + lane, 1088 + 3008 * i + lane, ), 32, 1)
        if not whole:
            for c in range(18 * (last + 1 - first - lane)):
                S_q[18 * (first + lane) + c] = to[c]
    left = 0
    for lane in range(last - first + 1):
        regular = (w[10464 + lane] > 0.0) & (w[10496 + lane] > 0.0)
        status[first + lane] = SOLVED if regular else OPEN
        left += 0 if regular else 1
    return left


def sensitivity(x, q, tool, k, S_p, S_q, status):
    """Fill the derivatives of the exact pose: S_p (N, 6, 48) by errors and deflections, S_q (N, 6, 3) by joints.

    Rows are px, py, pz, then turns of the platform about
    the axes of {O}. Columns of S_p run limb by limb. S_q is the velocity Jacobian.
    """
    if _sensitivity(x, q, tool, k, S_p, S_q, status):
        left = np.flatnonzero(status == OPEN)
        by_errors, by_joints, of = (
            np.empty((len(left), 6, 48)), np.empty((len(left), 6, 3)),
            np.zeros(len(left), dtype=np.int64),
        )
        vectorised.sensitivity(
            x[left], q[left], _of(tool, left, len(status)), _of(k, left, len(status)), by_errors, by_joints, of
        )
        S_p[left], S_q[left], status[left] = by_errors, by_joints, of

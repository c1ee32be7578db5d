"""Kinematics of `complete_delta`, many poses at once: Delta, complete geometry of the six rods.

Generated from derive/mechanisms/complete_delta.py by "deltacal kernels". Do not edit.
Template templates/mechanism/kinematics.py.jinja; sha256 of both 03810b4eb23746f1; SymPy 1.14.0.

Arrays are C-contiguous float64, the pose first, lengths in mm, angles in rad:

x (N, 6)  platform: px py pz cx cy cz
q (N, 3)  joints        tool (N or 1, 3)  reference point in {O'}
p (M, 3, 25)  one row of parameters per limb: b a L l c phi bx_{i}1 by_{i}1 bz_{i}1 ax_{i}1 ay_{i}1 az_{i}1 l_{i}1 bx_{i}2 by_{i}2 bz_{i}2 ax_{i}2 ay_{i}2 az_{i}2 l_{i}2 betax betay betaz tip_v tip_w
k (M, 3, 77)  what `constants` makes of p; each of the M machines has N / M of the poses, one after the other

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
    """What moves with a joint only; then the simplified limb as a sphere |P|^2 - 2 c.P + d = 0: c, d (64 operations)."""
    R0_12 = k[0]
    R0_13 = k[1]
    R0_22 = k[2]
    R0_23 = k[3]
    R0_32 = k[4]
    R0_33 = k[5]
    g1_y = k[6]
    g1_z = k[7]
    s147 = k[8]
    s153 = k[9]
    s155 = k[10]
    h1_x = k[11]
    h1_y = k[12]
    bz1 = k[13]
    g2_y = k[14]
    g2_z = k[15]
    s185 = k[16]
    s190 = k[17]
    s192 = k[18]
    h2_x = k[19]
    h2_y = k[20]
    bz2 = k[21]
    s839 = k[24]
    s841 = k[25]
    s843 = k[26]
    s845 = k[27]
    L = k[30]
    s856 = k[72]
    for lane in range(n):
        q = w[0 + lane]
        tx = w[32 + lane]
        ty = w[64 + lane]
        tz = w[96 + lane]
        s78 = cosine(q)
        s80 = sine(q)
        R1_12 = R0_12*s78 + R0_13*s80
        R1_13 = -R0_12*s80 + R0_13*s78
        R1_22 = R0_22*s78 + R0_23*s80
        R1_23 = -R0_22*s80 + R0_23*s78
        R1_32 = R0_32*s78 + R0_33*s80
        R1_33 = -R0_32*s80 + R0_33*s78
        A1_x = R1_12*g1_y + R1_13*g1_z + s147
        A1_y = R1_22*g1_y + R1_23*g1_z + s153
        A1_z = R1_32*g1_y + R1_33*g1_z + s155
        s159 = h1_x - tx
        s161 = h1_y - ty
        s163 = bz1 - tz
        A2_x = R1_12*g2_y + R1_13*g2_z + s185
        A2_y = R1_22*g2_y + R1_23*g2_z + s190
        A2_z = R1_32*g2_y + R1_33*g2_z + s192
        s196 = h2_x - tx
        s198 = h2_y - ty
        s200 = bz2 - tz
        s877 = -s78*s841 - s839 + tx
        s879 = -s78*s845 - s843 + ty
        s881 = L*s80 + tz
        s885 = -s856 + (s877 * s877) + (s879 * s879) + (s881 * s881)
        w[1120 + lane] = s159
        w[1152 + lane] = s161
        w[1184 + lane] = s163
        w[1216 + lane] = A1_x
        w[1248 + lane] = A1_y
        w[1280 + lane] = A1_z
        w[1312 + lane] = s196
        w[1344 + lane] = s198
        w[1376 + lane] = s200
        w[1408 + lane] = A2_x
        w[1440 + lane] = A2_y
        w[1472 + lane] = A2_z
        w[1504 + lane] = s877
        w[1536 + lane] = s879
        w[1568 + lane] = s881
        w[1600 + lane] = s885


@straight
def _rows(w, k, n):
    """Equations of a limb, their derivatives by shift and turn of the platform (142 operations)."""
    s901 = k[73]
    s1139 = k[74]
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
        s159 = w[1120 + lane]
        s161 = w[1152 + lane]
        s163 = w[1184 + lane]
        A1_x = w[1216 + lane]
        A1_y = w[1248 + lane]
        A1_z = w[1280 + lane]
        s196 = w[1312 + lane]
        s198 = w[1344 + lane]
        s200 = w[1376 + lane]
        A2_x = w[1408 + lane]
        A2_y = w[1440 + lane]
        A2_z = w[1472 + lane]
        s160 = R_11*s159
        s162 = R_12*s161
        s164 = R_13*s163
        B1_x = px + s160 + s162 + s164
        s166 = R_21*s159
        s167 = R_22*s161
        s168 = R_23*s163
        B1_y = py + s166 + s167 + s168
        s170 = R_31*s159
        s171 = R_32*s161
        s172 = R_33*s163
        B1_z = pz + s170 + s171 + s172
        d1_x = -A1_x + B1_x
        d1_y = -A1_y + B1_y
        d1_z = -A1_z + B1_z
        s197 = R_11*s196
        s199 = R_12*s198
        s201 = R_13*s200
        B2_x = px + s197 + s199 + s201
        s203 = R_21*s196
        s204 = R_22*s198
        s205 = R_23*s200
        B2_y = py + s203 + s204 + s205
        s207 = R_31*s196
        s208 = R_32*s198
        s209 = R_33*s200
        B2_z = pz + s207 + s208 + s209
        d2_x = -A2_x + B2_x
        d2_y = -A2_y + B2_y
        d2_z = -A2_z + B2_z
        s893 = 0.25*(d1_x * d1_x)
        s894 = 0.25*(d1_y * d1_y)
        s895 = 0.25*(d1_z * d1_z)
        s896 = 0.25*(d2_x * d2_x)
        s897 = 0.25*(d2_y * d2_y)
        s898 = 0.25*(d2_z * d2_z)
        s902 = s893 + s894 + s895 + s896 + s897 + s898 + s901
        s1140 = s1139 + s893 + s894 + s895 - s896 - s897 - s898
        s1265 = 0.5*d1_x
        s1266 = 0.5*d2_x
        s1267 = s1265 + s1266
        s1268 = 0.5*d1_y
        s1269 = 0.5*d2_y
        s1270 = s1268 + s1269
        s1271 = 0.5*d1_z
        s1272 = 0.5*d2_z
        s1273 = s1271 + s1272
        s1274 = -s170 - s171 - s172
        s1275 = 0.5*d1_y*s1274
        s1276 = s166 + s167 + s168
        s1277 = 0.5*d1_z*s1276
        s1278 = -s207 - s208 - s209
        s1279 = 0.5*d2_y*s1278
        s1280 = s203 + s204 + s205
        s1281 = 0.5*d2_z*s1280
        s1282 = s1275 + s1277 + s1279 + s1281
        s1283 = -0.5*d1_x*s1274
        s1284 = -s160 - s162 - s164
        s1285 = 0.5*d1_z*s1284
        s1286 = -0.5*d2_x*s1278
        s1287 = -s197 - s199 - s201
        s1288 = 0.5*d2_z*s1287
        s1289 = s1283 + s1285 + s1286 + s1288
        s1290 = -0.5*d1_x*s1276
        s1291 = -0.5*d1_y*s1284
        s1292 = -0.5*d2_x*s1280
        s1293 = -0.5*d2_y*s1287
        s1294 = s1290 + s1291 + s1292 + s1293
        s1295 = s1265 - s1266
        s1296 = s1268 - s1269
        s1297 = s1271 - s1272
        s1298 = s1275 + s1277 - s1279 - s1281
        s1299 = s1283 + s1285 - s1286 - s1288
        s1300 = s1290 + s1291 - s1292 - s1293
        w[608 + lane] = s902
        w[640 + lane] = s1267
        w[672 + lane] = s1270
        w[704 + lane] = s1273
        w[736 + lane] = s1282
        w[768 + lane] = s1289
        w[800 + lane] = s1294
        w[864 + lane] = s1140
        w[896 + lane] = s1295
        w[928 + lane] = s1296
        w[960 + lane] = s1297
        w[992 + lane] = s1298
        w[1024 + lane] = s1299
        w[1056 + lane] = s1300


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
        F10 = w[3936 + lane]
        J10_0 = w[3968 + lane]
        J10_1 = w[4000 + lane]
        J10_2 = w[4032 + lane]
        J10_3 = w[4064 + lane]
        J10_4 = w[4096 + lane]
        J10_5 = w[4128 + lane]
        F11 = w[4192 + lane]
        J11_0 = w[4224 + lane]
        J11_1 = w[4256 + lane]
        J11_2 = w[4288 + lane]
        J11_3 = w[4320 + lane]
        J11_4 = w[4352 + lane]
        J11_5 = w[4384 + lane]
        F20 = w[7264 + lane]
        J20_0 = w[7296 + lane]
        J20_1 = w[7328 + lane]
        J20_2 = w[7360 + lane]
        J20_3 = w[7392 + lane]
        J20_4 = w[7424 + lane]
        J20_5 = w[7456 + lane]
        F21 = w[7520 + lane]
        J21_0 = w[7552 + lane]
        J21_1 = w[7584 + lane]
        J21_2 = w[7616 + lane]
        J21_3 = w[7648 + lane]
        J21_4 = w[7680 + lane]
        J21_5 = w[7712 + lane]
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
    """Joint of the simplified limb at a given position (34 operations)."""
    s839 = k[24]
    s841 = k[25]
    s843 = k[26]
    s845 = k[27]
    s863 = k[28]
    s858 = k[29]
    L = k[30]
    for lane in range(n):
        tx = w[32 + lane]
        ty = w[64 + lane]
        tz = w[96 + lane]
        px = w[128 + lane]
        py = w[160 + lane]
        pz = w[192 + lane]
        s840 = px + s839 - tx
        s844 = py + s843 - ty
        s847 = s840*s841 + s844*s845
        s849 = pz - tz
        s850 = (s849 * s849)
        s864 = 0.5*(s840 * s840) + 0.5*(s844 * s844) + 0.5*s850 + s863
        s868 = math.sqrt((s847 * s847) + s850*s858 - (s864 * s864))
        s875 = arctangent(L*s849*s864 - s847*s868, -L*s849*s868 - s847*s864)
        w[1632 + lane] = s875


@straight
def _more(w, k, n):
    """What else derivatives by joint and errors read of it (38 operations)."""
    R0_12 = k[0]
    R0_13 = k[1]
    R0_22 = k[2]
    R0_23 = k[3]
    R0_32 = k[4]
    R0_33 = k[5]
    g1_y = k[6]
    g1_z = k[7]
    g2_y = k[14]
    g2_z = k[15]
    for lane in range(n):
        q = w[0 + lane]
        s78 = cosine(q)
        s80 = sine(q)
        R1_12 = R0_12*s78 + R0_13*s80
        R1_13 = -R0_12*s80 + R0_13*s78
        R1_22 = R0_22*s78 + R0_23*s80
        R1_23 = -R0_22*s80 + R0_23*s78
        R1_32 = R0_32*s78 + R0_33*s80
        R1_33 = -R0_32*s80 + R0_33*s78
        s1303 = R1_12*g1_z - R1_13*g1_y
        s1307 = R1_22*g1_z - R1_23*g1_y
        s1311 = R1_32*g1_z - R1_33*g1_y
        s1315 = R1_12*g2_z - R1_13*g2_y
        s1319 = R1_22*g2_z - R1_23*g2_y
        s1323 = R1_32*g2_z - R1_33*g2_y
        w[1664 + lane] = R1_33
        w[1696 + lane] = R1_32
        w[1728 + lane] = R1_23
        w[1760 + lane] = R1_22
        w[1792 + lane] = R1_13
        w[1824 + lane] = R1_12
        w[1856 + lane] = s80
        w[1888 + lane] = s78
        w[1920 + lane] = s1303
        w[1952 + lane] = s1307
        w[1984 + lane] = s1311
        w[2016 + lane] = s1315
        w[2048 + lane] = s1319
        w[2080 + lane] = s1323


@straight
def _joints(w, k, n):
    """Derivatives of a limb's equations by its joint (64 operations)."""
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
        s159 = w[1120 + lane]
        s161 = w[1152 + lane]
        s163 = w[1184 + lane]
        A1_x = w[1216 + lane]
        A1_y = w[1248 + lane]
        A1_z = w[1280 + lane]
        s196 = w[1312 + lane]
        s198 = w[1344 + lane]
        s200 = w[1376 + lane]
        A2_x = w[1408 + lane]
        A2_y = w[1440 + lane]
        A2_z = w[1472 + lane]
        s1303 = w[1920 + lane]
        s1307 = w[1952 + lane]
        s1311 = w[1984 + lane]
        s1315 = w[2016 + lane]
        s1319 = w[2048 + lane]
        s1323 = w[2080 + lane]
        B1_x = R_11*s159 + R_12*s161 + R_13*s163 + px
        B1_y = R_21*s159 + R_22*s161 + R_23*s163 + py
        B1_z = R_31*s159 + R_32*s161 + R_33*s163 + pz
        d1_x = -A1_x + B1_x
        d1_y = -A1_y + B1_y
        d1_z = -A1_z + B1_z
        B2_x = R_11*s196 + R_12*s198 + R_13*s200 + px
        B2_y = R_21*s196 + R_22*s198 + R_23*s200 + py
        B2_z = R_31*s196 + R_32*s198 + R_33*s200 + pz
        d2_x = -A2_x + B2_x
        d2_y = -A2_y + B2_y
        d2_z = -A2_z + B2_z
        s1304 = 0.5*d1_x*s1303
        s1308 = 0.5*d1_y*s1307
        s1312 = 0.5*d1_z*s1311
        s1316 = 0.5*d2_x*s1315
        s1320 = 0.5*d2_y*s1319
        s1324 = 0.5*d2_z*s1323
        s1325 = s1304 + s1308 + s1312 + s1316 + s1320 + s1324
        s1326 = s1304 + s1308 + s1312 - s1316 - s1320 - s1324
        w[832 + lane] = s1325
        w[1088 + lane] = s1326


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
        F10 = w[3936 + lane]
        J10_0 = w[3968 + lane]
        J10_1 = w[4000 + lane]
        J10_2 = w[4032 + lane]
        J10_3 = w[4064 + lane]
        J10_4 = w[4096 + lane]
        J10_5 = w[4128 + lane]
        Q10 = w[4160 + lane]
        F11 = w[4192 + lane]
        J11_3 = w[4320 + lane]
        J11_4 = w[4352 + lane]
        J11_5 = w[4384 + lane]
        Q11 = w[4416 + lane]
        F20 = w[7264 + lane]
        J20_0 = w[7296 + lane]
        J20_1 = w[7328 + lane]
        J20_2 = w[7360 + lane]
        J20_3 = w[7392 + lane]
        J20_4 = w[7424 + lane]
        J20_5 = w[7456 + lane]
        Q20 = w[7488 + lane]
        F21 = w[7520 + lane]
        J21_3 = w[7648 + lane]
        J21_4 = w[7680 + lane]
        J21_5 = w[7712 + lane]
        Q21 = w[7744 + lane]
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
        w[11488 + lane] = s81
        w[11520 + lane] = s86
        w[11552 + lane] = s91
        w[11584 + lane] = w_00
        w[11616 + lane] = w_10
        w[11648 + lane] = w_20
        w[11680 + lane] = s106
        w[11712 + lane] = s114
        w[11744 + lane] = s122
        w[11776 + lane] = s130


@straight
def _errors(w, k, n):
    """Derivatives of a limb's equations by errors, by deflections (347 operations)."""
    g1_y = k[6]
    g1_z = k[7]
    g2_y = k[14]
    g2_z = k[15]
    R0_31 = k[31]
    R0_21 = k[32]
    R0_11 = k[33]
    s424 = k[34]
    s438 = k[35]
    s446 = k[36]
    s450 = k[37]
    s452 = k[38]
    s456 = k[39]
    s458 = k[40]
    s462 = k[41]
    s464 = k[42]
    s522 = k[43]
    s534 = k[44]
    s544 = k[45]
    s548 = k[46]
    s550 = k[47]
    s554 = k[48]
    s556 = k[49]
    s560 = k[50]
    s562 = k[51]
    s620 = k[52]
    s634 = k[53]
    s642 = k[54]
    s646 = k[55]
    s648 = k[56]
    s652 = k[57]
    s654 = k[58]
    s658 = k[59]
    s660 = k[60]
    s800 = k[61]
    s802 = k[62]
    s804 = k[63]
    s813 = k[64]
    s815 = k[65]
    s817 = k[66]
    s826 = k[67]
    s828 = k[68]
    s830 = k[69]
    s1091 = k[75]
    s1097 = k[76]
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
        s159 = w[1120 + lane]
        s161 = w[1152 + lane]
        s163 = w[1184 + lane]
        A1_x = w[1216 + lane]
        A1_y = w[1248 + lane]
        A1_z = w[1280 + lane]
        s196 = w[1312 + lane]
        s198 = w[1344 + lane]
        s200 = w[1376 + lane]
        A2_x = w[1408 + lane]
        A2_y = w[1440 + lane]
        A2_z = w[1472 + lane]
        R1_33 = w[1664 + lane]
        R1_32 = w[1696 + lane]
        R1_23 = w[1728 + lane]
        R1_22 = w[1760 + lane]
        R1_13 = w[1792 + lane]
        R1_12 = w[1824 + lane]
        s80 = w[1856 + lane]
        s78 = w[1888 + lane]
        B1_x = R_11*s159 + R_12*s161 + R_13*s163 + px
        B1_y = R_21*s159 + R_22*s161 + R_23*s163 + py
        B1_z = R_31*s159 + R_32*s161 + R_33*s163 + pz
        d1_x = -A1_x + B1_x
        d1_y = -A1_y + B1_y
        d1_z = -A1_z + B1_z
        B2_x = R_11*s196 + R_12*s198 + R_13*s200 + px
        B2_y = R_21*s196 + R_22*s198 + R_23*s200 + py
        B2_z = R_31*s196 + R_32*s198 + R_33*s200 + pz
        d2_x = -A2_x + B2_x
        d2_y = -A2_y + B2_y
        d2_z = -A2_z + B2_z
        s903 = 0.5*d2_z
        s904 = 0.5*d2_y
        s905 = 0.5*d2_x
        s906 = 0.5*d1_z
        s907 = 0.5*d1_y
        s908 = 0.5*d1_x
        s923 = R_13*s905 + R_23*s904 + R_33*s903
        s926 = R_12*s905 + R_22*s904 + R_32*s903
        s929 = R_11*s905 + R_21*s904 + R_31*s903
        s930 = -g2_z*s903
        s932 = -g2_y*s903
        s934 = -g2_z*s904
        s936 = -g2_y*s904
        s938 = -g2_z*s905
        s940 = -g2_y*s905
        s956 = R_13*s908 + R_23*s907 + R_33*s906
        s959 = R_12*s908 + R_22*s907 + R_32*s906
        s962 = R_11*s908 + R_21*s907 + R_31*s906
        s963 = -g1_z*s906
        s965 = -g1_y*s906
        s967 = -g1_z*s907
        s969 = -g1_y*s907
        s971 = -g1_z*s908
        s973 = -g1_y*s908
        s1026 = s930 + s963
        s1031 = s932 + s965
        s1036 = s934 + s967
        s1041 = s936 + s969
        s1046 = s938 + s971
        s1051 = s940 + s973
        s1066 = -R1_13*s905 - R1_23*s904 - R1_33*s903
        s1067 = -R1_12*s905 - R1_22*s904 - R1_32*s903
        s1068 = -R1_13*s908 - R1_23*s907 - R1_33*s906
        s1069 = -R1_12*s908 - R1_22*s907 - R1_32*s906
        s1073 = -s1026*s80 + s1031*s78
        s1074 = s1026*s78 + s1031*s80
        s1075 = -s1036*s80 + s1041*s78
        s1076 = s1036*s78 + s1041*s80
        s1077 = -s1046*s80 + s1051*s78
        s1078 = s1046*s78 + s1051*s80
        s1086 = -R0_31*s906
        s1087 = -R0_21*s907
        s1088 = -R0_11*s908
        s1089 = s1086 + s1087 + s1088
        s1092 = -R0_31*s903
        s1093 = -R0_21*s904
        s1094 = -R0_11*s905
        s1095 = s1092 + s1093 + s1094
        s1098 = -s800*s903
        s1099 = -s802*s904
        s1100 = -s804*s905
        s1101 = -s424*s906
        s1102 = -s438*s907
        s1103 = -s446*s908
        s1105 = s1074*s452
        s1106 = s1075*s456
        s1107 = s1076*s458
        s1108 = s1077*s462
        s1109 = s1078*s464
        s1110 = s1073*s450 + s1098 + s1099 + s1100 + s1101 + s1102 + s1103 + s1105 + s1106 + s1107 + s1108 + s1109
        s1111 = -s813*s903
        s1112 = -s815*s904
        s1113 = -s817*s905
        s1114 = -s522*s906
        s1115 = -s534*s907
        s1116 = -s544*s908
        s1118 = s1074*s550
        s1119 = s1075*s554
        s1120 = s1076*s556
        s1121 = s1077*s560
        s1122 = s1078*s562
        s1123 = s1073*s548 + s1111 + s1112 + s1113 + s1114 + s1115 + s1116 + s1118 + s1119 + s1120 + s1121 + s1122
        s1124 = -s826*s903
        s1125 = -s828*s904
        s1126 = -s830*s905
        s1127 = -s620*s906
        s1128 = -s634*s907
        s1129 = -s642*s908
        s1131 = s1074*s648
        s1132 = s1075*s652
        s1133 = s1076*s654
        s1134 = s1077*s658
        s1135 = s1078*s660
        s1136 = s1073*s646 + s1124 + s1125 + s1126 + s1127 + s1128 + s1129 + s1131 + s1132 + s1133 + s1134 + s1135
        s1137 = s1066 + s1068
        s1138 = s1086 + s1087 + s1088 + s1092 + s1093 + s1094
        s1192 = -s930 + s963
        s1197 = -s932 + s965
        s1202 = -s934 + s967
        s1207 = -s936 + s969
        s1212 = -s938 + s971
        s1217 = -s940 + s973
        s1235 = -s1192*s80 + s1197*s78
        s1236 = s1192*s78 + s1197*s80
        s1237 = -s1202*s80 + s1207*s78
        s1238 = s1202*s78 + s1207*s80
        s1239 = -s1212*s80 + s1217*s78
        s1240 = s1212*s78 + s1217*s80
        s1243 = s1236*s452
        s1244 = s1237*s456
        s1245 = s1238*s458
        s1246 = s1239*s462
        s1247 = s1240*s464
        s1248 = -s1098 - s1099 - s1100 + s1101 + s1102 + s1103 + s1235*s450 + s1243 + s1244 + s1245 + s1246 + s1247
        s1250 = s1236*s550
        s1251 = s1237*s554
        s1252 = s1238*s556
        s1253 = s1239*s560
        s1254 = s1240*s562
        s1255 = -s1111 - s1112 - s1113 + s1114 + s1115 + s1116 + s1235*s548 + s1250 + s1251 + s1252 + s1253 + s1254
        s1257 = s1236*s648
        s1258 = s1237*s652
        s1259 = s1238*s654
        s1260 = s1239*s658
        s1261 = s1240*s660
        s1262 = -s1124 - s1125 - s1126 + s1127 + s1128 + s1129 + s1235*s646 + s1257 + s1258 + s1259 + s1260 + s1261
        s1263 = -s1066 + s1068
        s1264 = s1086 + s1087 + s1088 - s1092 - s1093 - s1094
        w[2112 + lane] = s962
        w[2144 + lane] = s959
        w[2176 + lane] = s956
        w[2208 + lane] = s1089
        w[2240 + lane] = s1069
        w[2272 + lane] = s1068
        w[2304 + lane] = s1091
        w[2336 + lane] = s929
        w[2368 + lane] = s926
        w[2400 + lane] = s923
        w[2432 + lane] = s1095
        w[2464 + lane] = s1067
        w[2496 + lane] = s1066
        w[2528 + lane] = s1097
        w[2560 + lane] = s1110
        w[2592 + lane] = s1123
        w[2624 + lane] = s1136
        w[2656 + lane] = s1137
        w[2688 + lane] = s1138
        w[2720 + lane] = s962
        w[2752 + lane] = s959
        w[2784 + lane] = s956
        w[2816 + lane] = s1089
        w[2848 + lane] = s1069
        w[2880 + lane] = s1068
        w[2912 + lane] = s1091
        w[2944 + lane] = -s929
        w[2976 + lane] = -s926
        w[3008 + lane] = -s923
        w[3040 + lane] = -s1095
        w[3072 + lane] = -s1067
        w[3104 + lane] = -s1066
        w[3136 + lane] = -s1097
        w[3168 + lane] = s1248
        w[3200 + lane] = s1255
        w[3232 + lane] = s1262
        w[3264 + lane] = s1263
        w[3296 + lane] = s1264


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
        J10_0 = w[3968 + lane]
        J10_1 = w[4000 + lane]
        J10_2 = w[4032 + lane]
        J10_3 = w[4064 + lane]
        J10_4 = w[4096 + lane]
        J10_5 = w[4128 + lane]
        J11_0 = w[4224 + lane]
        J11_1 = w[4256 + lane]
        J11_2 = w[4288 + lane]
        J11_3 = w[4320 + lane]
        J11_4 = w[4352 + lane]
        J11_5 = w[4384 + lane]
        J20_0 = w[7296 + lane]
        J20_1 = w[7328 + lane]
        J20_2 = w[7360 + lane]
        J20_3 = w[7392 + lane]
        J20_4 = w[7424 + lane]
        J20_5 = w[7456 + lane]
        J21_0 = w[7552 + lane]
        J21_1 = w[7584 + lane]
        J21_2 = w[7616 + lane]
        J21_3 = w[7648 + lane]
        J21_4 = w[7680 + lane]
        J21_5 = w[7712 + lane]
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
        w[3456 + lane] = new_00
        w[6784 + lane] = new_00
        w[160 + lane] = new_10
        w[3488 + lane] = new_10
        w[6816 + lane] = new_10
        w[192 + lane] = new_20
        w[3520 + lane] = new_20
        w[6848 + lane] = new_20
        w[224 + lane] = new_30
        w[256 + lane] = new_40
        w[288 + lane] = new_50
        w[320 + lane] = s51
        w[3648 + lane] = s51
        w[6976 + lane] = s51
        w[352 + lane] = s54
        w[3680 + lane] = s54
        w[7008 + lane] = s54
        w[384 + lane] = s57
        w[3712 + lane] = s57
        w[7040 + lane] = s57
        w[416 + lane] = s59
        w[3744 + lane] = s59
        w[7072 + lane] = s59
        w[448 + lane] = s63
        w[3776 + lane] = s63
        w[7104 + lane] = s63
        w[480 + lane] = s66
        w[3808 + lane] = s66
        w[7136 + lane] = s66
        w[512 + lane] = s68
        w[3840 + lane] = s68
        w[7168 + lane] = s68
        w[544 + lane] = s70
        w[3872 + lane] = s70
        w[7200 + lane] = s70
        w[576 + lane] = s73
        w[3904 + lane] = s73
        w[7232 + lane] = s73


@straight
def _meet(w, n):
    """Put the platform where the simplified machine has it."""
    for lane in range(n):
        c_00 = w[1504 + lane]
        c_01 = w[1536 + lane]
        c_02 = w[1568 + lane]
        c_03 = w[1600 + lane]
        c_10 = w[4832 + lane]
        c_11 = w[4864 + lane]
        c_12 = w[4896 + lane]
        c_13 = w[4928 + lane]
        c_20 = w[8160 + lane]
        c_21 = w[8192 + lane]
        c_22 = w[8224 + lane]
        c_23 = w[8256 + lane]
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
        w[10240 + lane] = 0.0 if good else 1.0
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
        done = done & (abs(w[11488 + lane]) < TURN_DONE)
        done = done & (abs(w[11520 + lane]) < TURN_DONE)
        done = done & (abs(w[11552 + lane]) < TURN_DONE)

        done = done & (abs(w[11584 + lane]) < TURN_DONE)
        done = done & (abs(w[11616 + lane]) < TURN_DONE)
        done = done & (abs(w[11648 + lane]) < TURN_DONE)
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
        w[10240 + lane] = 0.0 if (abs(w[1632 + lane]) < math.inf) & (abs(w[4960 + lane]) < math.inf) & (abs(w[8288 + lane]) < math.inf) else 1.0
        w[0 + lane] = w[1632 + lane]
        w[3328 + lane] = w[4960 + lane]
        w[6656 + lane] = w[8288 + lane]
        w[224 + lane] = 0.0
        w[256 + lane] = 0.0
        w[288 + lane] = 0.0


@straight
def _turn_joints(w, n):
    """Move the joints by a step; what it does to the platform is left to `_move`."""
    for lane in range(n):
        going = w[10240 + lane]
        w[0 + lane] -= going * w[11488 + lane]
        w[3328 + lane] -= going * w[11520 + lane]
        w[6656 + lane] -= going * w[11552 + lane]
        w[10080 + lane] = w[11584 + lane]
        w[10112 + lane] = w[11616 + lane]
        w[10144 + lane] = w[11648 + lane]

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
        q[3 * (first + lane) + 0] = w[0 + lane]
        q[3 * (first + lane) + 1] = w[3328 + lane]
        q[3 * (first + lane) + 2] = w[6656 + lane]


@fast
def _forward(q, tool, k, x, status, warm):
    w = scratch(WORK + SPARE)
    w_1 = w[0:3328]
    w_2 = w[3328:6656]
    w_3 = w[6656:9984]
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
    w_1 = w[0:3328]
    w_2 = w[3328:6656]
    w_3 = w[6656:9984]
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
        own = machines[231 * (m // (runs // k.shape[0])) :]
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
    s839_0 = own[0 + 24]
    s841_0 = own[0 + 25]
    s843_0 = own[0 + 26]
    s845_0 = own[0 + 27]
    L_0 = own[0 + 30]
    s856_0 = own[0 + 72]
    s839_1 = own[77 + 24]
    s841_1 = own[77 + 25]
    s843_1 = own[77 + 26]
    s845_1 = own[77 + 27]
    L_1 = own[77 + 30]
    s856_1 = own[77 + 72]
    s839_2 = own[154 + 24]
    s841_2 = own[154 + 25]
    s843_2 = own[154 + 26]
    s845_2 = own[154 + 27]
    L_2 = own[154 + 30]
    s856_2 = own[154 + 72]
    for first in range(0, poses, SPHERES):  # in two short loops, of which a processor has several rounds at work
        count = min(SPHERES, poses - first)
        for lane in range(count):
            n = first + lane
            q_0 = q[3 * n + 0]
            s78_0 = cosine(q_0)
            s877_0 = -s78_0*s841_0 - s839_0 + tx
            s879_0 = -s78_0*s845_0 - s843_0 + ty
            s881_0 = L_0*sine(q_0) + tz
            s885_0 = -s856_0 + (s877_0 * s877_0) + (s879_0 * s879_0) + (s881_0 * s881_0)
            c_00 = s877_0
            c_01 = s879_0
            c_02 = s881_0
            c_03 = s885_0
            q_1 = q[3 * n + 1]
            s78_1 = cosine(q_1)
            s877_1 = -s78_1*s841_1 - s839_1 + tx
            s879_1 = -s78_1*s845_1 - s843_1 + ty
            s881_1 = L_1*sine(q_1) + tz
            s885_1 = -s856_1 + (s877_1 * s877_1) + (s879_1 * s879_1) + (s881_1 * s881_1)
            c_10 = s877_1
            c_11 = s879_1
            c_12 = s881_1
            c_13 = s885_1
            q_2 = q[3 * n + 2]
            s78_2 = cosine(q_2)
            s877_2 = -s78_2*s841_2 - s839_2 + tx
            s879_2 = -s78_2*s845_2 - s843_2 + ty
            s881_2 = L_2*sine(q_2) + tz
            s885_2 = -s856_2 + (s877_2 * s877_2) + (s879_2 * s879_2) + (s881_2 * s881_2)
            c_20 = s877_2
            c_21 = s879_2
            c_22 = s881_2
            c_23 = s885_2
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
    """Fill x (N, 3) with the platform of the simplified machine, in closed form: exact where bx1, by1, bz1, ax1, ay1, az1, dl1, bx2, by2, bz2, ax2, ay2, az2, dl2, betax, betay, betaz, tip_v, tip_w are zero.

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
        own = machines[231 * (m // (runs // k.shape[0])) :]
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
    s839_0 = own[0 + 24]
    s841_0 = own[0 + 25]
    s843_0 = own[0 + 26]
    s845_0 = own[0 + 27]
    s863_0 = own[0 + 28]
    s858_0 = own[0 + 29]
    L_0 = own[0 + 30]
    s839_1 = own[77 + 24]
    s841_1 = own[77 + 25]
    s843_1 = own[77 + 26]
    s845_1 = own[77 + 27]
    s863_1 = own[77 + 28]
    s858_1 = own[77 + 29]
    L_1 = own[77 + 30]
    s839_2 = own[154 + 24]
    s841_2 = own[154 + 25]
    s843_2 = own[154 + 26]
    s845_2 = own[154 + 27]
    s863_2 = own[154 + 28]
    s858_2 = own[154 + 29]
    L_2 = own[154 + 30]
    for n in range(poses):
        px = target[3 * n + 0]
        py = target[3 * n + 1]
        pz = target[3 * n + 2]
        s840_0 = px + s839_0 - tx
        s844_0 = py + s843_0 - ty
        s847_0 = s840_0*s841_0 + s844_0*s845_0
        s849_0 = pz - tz
        s850_0 = (s849_0 * s849_0)
        s864_0 = 0.5*(s840_0 * s840_0) + 0.5*(s844_0 * s844_0) + 0.5*s850_0 + s863_0
        s868_0 = math.sqrt((s847_0 * s847_0) + s850_0*s858_0 - (s864_0 * s864_0))
        s875_0 = arctangent(L_0*s849_0*s864_0 - s847_0*s868_0, -L_0*s849_0*s868_0 - s847_0*s864_0)
        q_00 = s875_0
        s840_1 = px + s839_1 - tx
        s844_1 = py + s843_1 - ty
        s847_1 = s840_1*s841_1 + s844_1*s845_1
        s849_1 = pz - tz
        s850_1 = (s849_1 * s849_1)
        s864_1 = 0.5*(s840_1 * s840_1) + 0.5*(s844_1 * s844_1) + 0.5*s850_1 + s863_1
        s868_1 = math.sqrt((s847_1 * s847_1) + s850_1*s858_1 - (s864_1 * s864_1))
        s875_1 = arctangent(L_1*s849_1*s864_1 - s847_1*s868_1, -L_1*s849_1*s868_1 - s847_1*s864_1)
        q_10 = s875_1
        s840_2 = px + s839_2 - tx
        s844_2 = py + s843_2 - ty
        s847_2 = s840_2*s841_2 + s844_2*s845_2
        s849_2 = pz - tz
        s850_2 = (s849_2 * s849_2)
        s864_2 = 0.5*(s840_2 * s840_2) + 0.5*(s844_2 * s844_2) + 0.5*s850_2 + s863_2
        s868_2 = math.sqrt((s847_2 * s847_2) + s850_2*s858_2 - (s864_2 * s864_2))
        s875_2 = arctangent(L_2*s849_2*s864_2 - s847_2*s868_2, -L_2*s849_2*s868_2 - s847_2*s864_2)
        q_20 = s875_2
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
    w_1 = w[0:3328]
    w_2 = w[3328:6656]
    w_3 = w[6656:9984]
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
        whole = 342 * (first + lane + 8) <= S_p.size  # else the last poses are written through scratch
        to, at = (S_p, 342 * (first + lane)) if whole else (w[WORK:], 0)
        for i in range(3):
            outer(to, at + 19 * i + 0, 342, 57, 6, w, (10272 + 32 * i + lane, 10368 + 32 * i + lane, ), 192, (2112 + 3328 * i + lane, 2720 + 3328 * i + lane, ), 32, 8)
            outer(to, at + 19 * i + 8, 342, 57, 6, w, (10272 + 32 * i + lane, 10368 + 32 * i + lane, ), 192, (2368 + 3328 * i + lane, 2976 + 3328 * i + lane, ), 32, 8)
            outer(to, at + 19 * i + 16, 342, 57, 6, w, (10272 + 32 * i + lane, 10368 + 32 * i + lane, ), 192, (2624 + 3328 * i + lane, 3232 + 3328 * i + lane, ), 32, 3)
        if not whole:
            for c in range(342 * (last + 1 - first - lane)):
                S_p[342 * (first + lane) + c] = to[c]
        whole = 18 * (first + lane + 8) <= S_q.size  # else the last poses are written through scratch
        to, at = (S_q, 18 * (first + lane)) if whole else (w[WORK:], 0)
        for i in range(3):
            outer(to, at + 1 * i + 0, 18, 3, 6, w, (10272 + 32 * i + lane, 10368 + 32 * i + lane, ), 192, (832 + 3328 * i + lane, 1088 + 3328 * i + lane, ), 32, 1)
        if not whole:
            for c in range(18 * (last + 1 - first - lane)):
                S_q[18 * (first + lane) + c] = to[c]
    left = 0
    for lane in range(last - first + 1):
        regular = (w[11424 + lane] > 0.0) & (w[11456 + lane] > 0.0)
        status[first + lane] = SOLVED if regular else OPEN
        left += 0 if regular else 1
    return left


def sensitivity(x, q, tool, k, S_p, S_q, status):
    """Fill the derivatives of the exact pose: S_p (N, 6, 57) by errors and deflections, S_q (N, 6, 3) by joints.

    Rows are px, py, pz, then turns of the platform about
    the axes of {O}. Columns of S_p run limb by limb. S_q is the velocity Jacobian.
    """
    if _sensitivity(x, q, tool, k, S_p, S_q, status):
        left = np.flatnonzero(status == OPEN)
        by_errors, by_joints, of = (
            np.empty((len(left), 6, 57)), np.empty((len(left), 6, 3)),
            np.zeros(len(left), dtype=np.int64),
        )
        vectorised.sensitivity(
            x[left], q[left], _of(tool, left, len(status)), _of(k, left, len(status)), by_errors, by_joints, of
        )
        S_p[left], S_q[left], status[left] = by_errors, by_joints, of

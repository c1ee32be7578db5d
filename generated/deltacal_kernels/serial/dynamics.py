"""Dynamics of `serial`, many samples at once: Open chain of revolute and prismatic joints.

Generated from derive/mechanisms/serial.py by "deltacal kernels". Do not edit.
Template templates/chain/dynamics.py.jinja; sha256 of both 0108ce8d2f77ef6a; SymPy 1.14.0.

Arrays are C-contiguous float64, the sample first; mm, rad, s, kg, N:

motion (3, N, n_q)  joints, their velocities, their accelerations
inertia (links, 10)  of each link, in its frame: m m_x m_y m_z ixx iyy izz ixy ixz iyz
gravity (3,)  in {O} [m/s^2]
k (M, links, 7)  what `constants` makes of p; each of the M machines has N / M of the samples, one after the other
conventions, drives, much  what tells a chain from others, see ``kinematics.py``

What bodies ask for is linear in their inertial parameters: `torque` sums it up, `regressor` gives it one by one.
Samples are taken in blocks of up to 32, side by side.
"""

import numpy as np

from deltacal_kernels.cache import kernel
from deltacal_kernels.elementary import cosine, scratch, sine
from deltacal_kernels.straight import straight

INERTIA = ("m", "m_x", "m_y", "m_z", "ixx", "iyy", "izz", "ixy", "ixz", "iyz", )  # parameters of a body
LANES = 32  # samples of a block
WORK = 4992  # numbers that a block computes with
AXIS, ASKED = 192, 192  # those of a joint's axis, and of what a body asks for
fast = kernel(nogil=True, error_model="numpy", fastmath={"contract"})


@straight
def _fill(p, k, rows):
    """Fill what no sample changes of the links of all machines (8 operations a link)."""
    for lane in range(rows):
        a = p[12 * lane + 0]
        alpha = p[12 * lane + 1]
        d = p[12 * lane + 2]
        theta = p[12 * lane + 3]
        da = p[12 * lane + 4]
        dalpha = p[12 * lane + 5]
        dd = p[12 * lane + 6]
        dtheta = p[12 * lane + 7]
        dbeta = p[12 * lane + 8]
        s0 = dtheta + theta
        s2 = d + dd
        along_x = a + da
        about_x = alpha + dalpha
        s26 = cosine(dbeta)
        s28 = cosine(about_x)
        s33 = sine(about_x)
        s36 = sine(dbeta)
        k[7 * lane + 0] = s0
        k[7 * lane + 1] = s2
        k[7 * lane + 2] = along_x
        k[7 * lane + 3] = s26
        k[7 * lane + 4] = s28
        k[7 * lane + 5] = s33
        k[7 * lane + 6] = s36


@fast
def _constants(p, k):
    _fill(p, k, p.shape[0] * p.shape[1])


def constants(p):
    """Return k (M, links, 7), what no pose changes of a link, from p (M, links, 12)."""
    p = np.ascontiguousarray(p, dtype=float)
    k = np.empty((*p.shape[:2], 7))
    _constants(p, k)
    return k


def of_point(point):
    """Return the inertial parameters of a mass of 1 kg at a point of a link (3,) [mm], (10,)."""
    rx = point[0]
    ry = point[1]
    rz = point[2]
    s1566 = (ry * ry)
    s1567 = (rz * rz)
    s1568 = s1566 + s1567
    s1569 = (rx * rx)
    s1570 = s1567 + s1569
    s1571 = s1566 + s1569
    s1572 = -rx*ry
    s1573 = -rx*rz
    s1574 = -ry*rz
    out = np.zeros(10)
    out[0] = 1
    out[1] = rx
    out[2] = ry
    out[3] = rz
    out[4] = s1568
    out[5] = s1570
    out[6] = s1571
    out[7] = s1572
    out[8] = s1573
    out[9] = s1574
    return out


@straight
def _move_standard(w, n):
    """A link, standard convention: its frame, and how that moves, by the one before (320 operations)."""
    for lane in range(n):
        turn = w[0 + lane]
        slide = w[32 + lane]
        turn_t = w[64 + lane]
        slide_t = w[96 + lane]
        turn_tt = w[128 + lane]
        slide_tt = w[160 + lane]
        ox = w[192 + lane]
        oy = w[224 + lane]
        oz = w[256 + lane]
        R_00 = w[288 + lane]
        R_01 = w[320 + lane]
        R_02 = w[352 + lane]
        R_10 = w[384 + lane]
        R_11 = w[416 + lane]
        R_12 = w[448 + lane]
        R_20 = w[480 + lane]
        R_21 = w[512 + lane]
        R_22 = w[544 + lane]
        ox_t = w[576 + lane]
        oy_t = w[608 + lane]
        oz_t = w[640 + lane]
        R_00_t = w[672 + lane]
        R_01_t = w[704 + lane]
        R_02_t = w[736 + lane]
        R_10_t = w[768 + lane]
        R_11_t = w[800 + lane]
        R_12_t = w[832 + lane]
        R_20_t = w[864 + lane]
        R_21_t = w[896 + lane]
        R_22_t = w[928 + lane]
        ox_tt = w[960 + lane]
        oy_tt = w[992 + lane]
        oz_tt = w[1024 + lane]
        R_00_tt = w[1056 + lane]
        R_01_tt = w[1088 + lane]
        R_02_tt = w[1120 + lane]
        R_10_tt = w[1152 + lane]
        R_11_tt = w[1184 + lane]
        R_12_tt = w[1216 + lane]
        R_20_tt = w[1248 + lane]
        R_21_tt = w[1280 + lane]
        R_22_tt = w[1312 + lane]
        s0 = w[1344 + lane]
        s2 = w[1376 + lane]
        along_x = w[1408 + lane]
        s26 = w[1440 + lane]
        s28 = w[1472 + lane]
        s33 = w[1504 + lane]
        s36 = w[1536 + lane]
        about_z = s0 + turn
        along_z = s2 + slide
        s7 = cosine(about_z)
        s9 = sine(about_z)
        s11 = R_00*s7 + R_01*s9
        s13 = R_02*along_z + along_x*s11 + ox
        s17 = R_10*s7 + R_11*s9
        s19 = R_12*along_z + along_x*s17 + oy
        s23 = R_20*s7 + R_21*s9
        s25 = R_22*along_z + along_x*s23 + oz
        s32 = -R_00*s9 + R_01*s7
        s35 = R_02*s28 - s32*s33
        s38 = s11*s26 - s35*s36
        s41 = R_02*s33 + s28*s32
        s44 = s11*s36 + s26*s35
        s49 = -R_10*s9 + R_11*s7
        s51 = R_12*s28 - s33*s49
        s53 = s17*s26 - s36*s51
        s56 = R_12*s33 + s28*s49
        s59 = s17*s36 + s26*s51
        s64 = -R_20*s9 + R_21*s7
        s66 = R_22*s28 - s33*s64
        s68 = s23*s26 - s36*s66
        s71 = R_22*s33 + s28*s64
        s74 = s23*s36 + s26*s66
        s78 = -s9*turn_t
        s82 = s7*turn_t
        s86 = R_00*s78 + R_00_t*s7 + R_01*s82 + R_01_t*s9
        s88 = R_02*slide_t + R_02_t*along_z + along_x*s86 + ox_t
        s98 = R_10*s78 + R_10_t*s7 + R_11*s82 + R_11_t*s9
        s100 = R_12*slide_t + R_12_t*along_z + along_x*s98 + oy_t
        s110 = R_20*s78 + R_20_t*s7 + R_21*s82 + R_21_t*s9
        s112 = R_22*slide_t + R_22_t*along_z + along_x*s110 + oz_t
        s121 = -R_00*s82 - R_00_t*s9 + R_01*s78 + R_01_t*s7
        s123 = R_02_t*s28 - s121*s33
        s125 = -s123*s36 + s26*s86
        s128 = R_02_t*s33 + s121*s28
        s131 = s123*s26 + s36*s86
        s140 = -R_10*s82 - R_10_t*s9 + R_11*s78 + R_11_t*s7
        s142 = R_12_t*s28 - s140*s33
        s144 = -s142*s36 + s26*s98
        s147 = R_12_t*s33 + s140*s28
        s150 = s142*s26 + s36*s98
        s159 = -R_20*s82 - R_20_t*s9 + R_21*s78 + R_21_t*s7
        s161 = R_22_t*s28 - s159*s33
        s163 = s110*s26 - s161*s36
        s166 = R_22_t*s33 + s159*s28
        s169 = s110*s36 + s161*s26
        s171 = R_02_t*slide_t
        s178 = -s82*turn_t - s9*turn_tt
        s180 = R_00_t*s78
        s187 = s7*turn_tt + s78*turn_t
        s189 = R_01_t*s82
        s194 = R_00*s178 + R_00_tt*s7 + R_01*s187 + R_01_tt*s9 + 2*s180 + 2*s189
        s196 = R_02*slide_tt + R_02_tt*along_z + along_x*s194 + ox_tt + 2*s171
        s198 = R_12_t*slide_t
        s204 = R_10_t*s78
        s210 = R_11_t*s82
        s215 = R_10*s178 + R_10_tt*s7 + R_11*s187 + R_11_tt*s9 + 2*s204 + 2*s210
        s217 = R_12*slide_tt + R_12_tt*along_z + along_x*s215 + oy_tt + 2*s198
        s219 = R_22_t*slide_t
        s225 = R_20_t*s78
        s231 = R_21_t*s82
        s236 = R_20*s178 + R_20_tt*s7 + R_21*s187 + R_21_tt*s9 + 2*s225 + 2*s231
        s238 = R_22*slide_tt + R_22_tt*along_z + along_x*s236 + oz_tt + 2*s219
        s242 = R_01_t*s78
        s248 = -R_00_t*s82
        s253 = -R_00*s187 - R_00_tt*s9 + R_01*s178 + R_01_tt*s7 + 2*s242 + 2*s248
        s255 = R_02_tt*s28 - s253*s33
        s257 = s194*s26 - s255*s36
        s260 = R_02_tt*s33 + s253*s28
        s263 = s194*s36 + s255*s26
        s267 = R_11_t*s78
        s273 = -R_10_t*s82
        s278 = -R_10*s187 - R_10_tt*s9 + R_11*s178 + R_11_tt*s7 + 2*s267 + 2*s273
        s280 = R_12_tt*s28 - s278*s33
        s282 = s215*s26 - s280*s36
        s285 = R_12_tt*s33 + s278*s28
        s288 = s215*s36 + s26*s280
        s292 = R_21_t*s78
        s298 = -R_20_t*s82
        s303 = -R_20*s187 - R_20_tt*s9 + R_21*s178 + R_21_tt*s7 + 2*s292 + 2*s298
        s305 = R_22_tt*s28 - s303*s33
        s307 = s236*s26 - s305*s36
        s310 = R_22_tt*s33 + s28*s303
        s313 = s236*s36 + s26*s305
        w[192 + lane] = s13
        w[224 + lane] = s19
        w[256 + lane] = s25
        w[288 + lane] = s38
        w[320 + lane] = s41
        w[352 + lane] = s44
        w[384 + lane] = s53
        w[416 + lane] = s56
        w[448 + lane] = s59
        w[480 + lane] = s68
        w[512 + lane] = s71
        w[544 + lane] = s74
        w[576 + lane] = s88
        w[608 + lane] = s100
        w[640 + lane] = s112
        w[672 + lane] = s125
        w[704 + lane] = s128
        w[736 + lane] = s131
        w[768 + lane] = s144
        w[800 + lane] = s147
        w[832 + lane] = s150
        w[864 + lane] = s163
        w[896 + lane] = s166
        w[928 + lane] = s169
        w[960 + lane] = s196
        w[992 + lane] = s217
        w[1024 + lane] = s238
        w[1056 + lane] = s257
        w[1088 + lane] = s260
        w[1120 + lane] = s263
        w[1152 + lane] = s282
        w[1184 + lane] = s285
        w[1216 + lane] = s288
        w[1248 + lane] = s307
        w[1280 + lane] = s310
        w[1312 + lane] = s313


@straight
def _axes_standard(w, n):
    """A link, standard convention: twists of all behind it by turn and slide of its joint (9 operations)."""
    for lane in range(n):
        ox = w[192 + lane]
        oy = w[224 + lane]
        oz = w[256 + lane]
        R_02 = w[352 + lane]
        R_12 = w[448 + lane]
        R_22 = w[544 + lane]
        s316 = -R_12*oz + R_22*oy
        s319 = R_02*oz - R_22*ox
        s322 = -R_02*oy + R_12*ox
        w[1984 + lane] = s316
        w[2016 + lane] = s319
        w[2048 + lane] = s322
        w[2080 + lane] = R_02
        w[2112 + lane] = R_12
        w[2144 + lane] = R_22
        w[2176 + lane] = R_02
        w[2208 + lane] = R_12
        w[2240 + lane] = R_22
        w[2272 + lane] = 0
        w[2304 + lane] = 0
        w[2336 + lane] = 0


@straight
def _move_modified(w, n):
    """A link, modified convention: its frame, and how that moves, by the one before (320 operations)."""
    for lane in range(n):
        turn = w[0 + lane]
        slide = w[32 + lane]
        turn_t = w[64 + lane]
        slide_t = w[96 + lane]
        turn_tt = w[128 + lane]
        slide_tt = w[160 + lane]
        ox = w[192 + lane]
        oy = w[224 + lane]
        oz = w[256 + lane]
        R_00 = w[288 + lane]
        R_01 = w[320 + lane]
        R_02 = w[352 + lane]
        R_10 = w[384 + lane]
        R_11 = w[416 + lane]
        R_12 = w[448 + lane]
        R_20 = w[480 + lane]
        R_21 = w[512 + lane]
        R_22 = w[544 + lane]
        ox_t = w[576 + lane]
        oy_t = w[608 + lane]
        oz_t = w[640 + lane]
        R_00_t = w[672 + lane]
        R_01_t = w[704 + lane]
        R_02_t = w[736 + lane]
        R_10_t = w[768 + lane]
        R_11_t = w[800 + lane]
        R_12_t = w[832 + lane]
        R_20_t = w[864 + lane]
        R_21_t = w[896 + lane]
        R_22_t = w[928 + lane]
        ox_tt = w[960 + lane]
        oy_tt = w[992 + lane]
        oz_tt = w[1024 + lane]
        R_00_tt = w[1056 + lane]
        R_01_tt = w[1088 + lane]
        R_02_tt = w[1120 + lane]
        R_10_tt = w[1152 + lane]
        R_11_tt = w[1184 + lane]
        R_12_tt = w[1216 + lane]
        R_20_tt = w[1248 + lane]
        R_21_tt = w[1280 + lane]
        R_22_tt = w[1312 + lane]
        s0 = w[1344 + lane]
        s2 = w[1376 + lane]
        along_x = w[1408 + lane]
        s26 = w[1440 + lane]
        s28 = w[1472 + lane]
        s33 = w[1504 + lane]
        s36 = w[1536 + lane]
        about_z = s0 + turn
        along_z = s2 + slide
        s7 = cosine(about_z)
        s9 = sine(about_z)
        s78 = -s9*turn_t
        s82 = s7*turn_t
        s178 = -s82*turn_t - s9*turn_tt
        s187 = s7*turn_tt + s78*turn_t
        s325 = -R_01*s33 + R_02*s28
        s327 = R_00*s26 - s325*s36
        s331 = R_00*s36 + s26*s325
        s333 = along_x*s327 + along_z*s331 + ox
        s336 = -R_11*s33 + R_12*s28
        s338 = R_10*s26 - s336*s36
        s342 = R_10*s36 + s26*s336
        s344 = along_x*s338 + along_z*s342 + oy
        s347 = -R_21*s33 + R_22*s28
        s349 = R_20*s26 - s347*s36
        s353 = R_20*s36 + s26*s347
        s355 = along_x*s349 + along_z*s353 + oz
        s358 = R_01*s28 + R_02*s33
        s360 = s327*s7 + s358*s9
        s363 = -s327*s9 + s358*s7
        s366 = R_11*s28 + R_12*s33
        s368 = s338*s7 + s366*s9
        s371 = -s338*s9 + s366*s7
        s374 = R_21*s28 + R_22*s33
        s376 = s349*s7 + s374*s9
        s379 = -s349*s9 + s374*s7
        s625 = -R_01_t*s33 + R_02_t*s28
        s627 = R_00_t*s26 - s36*s625
        s631 = R_00_t*s36 + s26*s625
        s635 = along_x*s627 + along_z*s631 + ox_t + s331*slide_t
        s638 = -R_11_t*s33 + R_12_t*s28
        s640 = R_10_t*s26 - s36*s638
        s644 = R_10_t*s36 + s26*s638
        s648 = along_x*s640 + along_z*s644 + oy_t + s342*slide_t
        s651 = -R_21_t*s33 + R_22_t*s28
        s653 = R_20_t*s26 - s36*s651
        s657 = R_20_t*s36 + s26*s651
        s661 = along_x*s653 + along_z*s657 + oz_t + s353*slide_t
        s666 = R_01_t*s28 + R_02_t*s33
        s670 = s327*s78 + s358*s82 + s627*s7 + s666*s9
        s677 = -s327*s82 + s358*s78 - s627*s9 + s666*s7
        s682 = R_11_t*s28 + R_12_t*s33
        s686 = s338*s78 + s366*s82 + s640*s7 + s682*s9
        s693 = -s338*s82 + s366*s78 - s640*s9 + s682*s7
        s698 = R_21_t*s28 + R_22_t*s33
        s702 = s349*s78 + s374*s82 + s653*s7 + s698*s9
        s709 = -s349*s82 + s374*s78 - s653*s9 + s698*s7
        s1169 = -R_01_tt*s33 + R_02_tt*s28
        s1171 = R_00_tt*s26 - s1169*s36
        s1175 = R_00_tt*s36 + s1169*s26
        s1176 = s631*slide_t
        s1182 = along_x*s1171 + along_z*s1175 + ox_tt + 2*s1176 + s331*slide_tt
        s1185 = -R_11_tt*s33 + R_12_tt*s28
        s1187 = R_10_tt*s26 - s1185*s36
        s1191 = R_10_tt*s36 + s1185*s26
        s1192 = s644*slide_t
        s1198 = along_x*s1187 + along_z*s1191 + oy_tt + 2*s1192 + s342*slide_tt
        s1201 = -R_21_tt*s33 + R_22_tt*s28
        s1203 = R_20_tt*s26 - s1201*s36
        s1207 = R_20_tt*s36 + s1201*s26
        s1208 = s657*slide_t
        s1214 = along_x*s1203 + along_z*s1207 + oz_tt + 2*s1208 + s353*slide_tt
        s1216 = s627*s78
        s1222 = R_01_tt*s28 + R_02_tt*s33
        s1224 = s666*s82
        s1229 = s1171*s7 + 2*s1216 + s1222*s9 + 2*s1224 + s178*s327 + s187*s358
        s1231 = s666*s78
        s1237 = -s627*s82
        s1242 = -s1171*s9 + s1222*s7 + 2*s1231 + 2*s1237 + s178*s358 - s187*s327
        s1244 = s640*s78
        s1250 = R_11_tt*s28 + R_12_tt*s33
        s1252 = s682*s82
        s1257 = s1187*s7 + 2*s1244 + s1250*s9 + 2*s1252 + s178*s338 + s187*s366
        s1259 = s682*s78
        s1265 = -s640*s82
        s1270 = -s1187*s9 + s1250*s7 + 2*s1259 + 2*s1265 + s178*s366 - s187*s338
        s1272 = s653*s78
        s1278 = R_21_tt*s28 + R_22_tt*s33
        s1280 = s698*s82
        s1285 = s1203*s7 + 2*s1272 + s1278*s9 + 2*s1280 + s178*s349 + s187*s374
        s1287 = s698*s78
        s1293 = -s653*s82
        s1298 = -s1203*s9 + s1278*s7 + 2*s1287 + 2*s1293 + s178*s374 - s187*s349
        w[192 + lane] = s333
        w[224 + lane] = s344
        w[256 + lane] = s355
        w[288 + lane] = s360
        w[320 + lane] = s363
        w[352 + lane] = s331
        w[384 + lane] = s368
        w[416 + lane] = s371
        w[448 + lane] = s342
        w[480 + lane] = s376
        w[512 + lane] = s379
        w[544 + lane] = s353
        w[576 + lane] = s635
        w[608 + lane] = s648
        w[640 + lane] = s661
        w[672 + lane] = s670
        w[704 + lane] = s677
        w[736 + lane] = s631
        w[768 + lane] = s686
        w[800 + lane] = s693
        w[832 + lane] = s644
        w[864 + lane] = s702
        w[896 + lane] = s709
        w[928 + lane] = s657
        w[960 + lane] = s1182
        w[992 + lane] = s1198
        w[1024 + lane] = s1214
        w[1056 + lane] = s1229
        w[1088 + lane] = s1242
        w[1120 + lane] = s1175
        w[1152 + lane] = s1257
        w[1184 + lane] = s1270
        w[1216 + lane] = s1191
        w[1248 + lane] = s1285
        w[1280 + lane] = s1298
        w[1312 + lane] = s1207


@straight
def _axes_modified(w, n):
    """A link, modified convention: twists of all behind it by turn and slide of its joint (45 operations)."""
    for lane in range(n):
        ox = w[192 + lane]
        oy = w[224 + lane]
        oz = w[256 + lane]
        R_00 = w[288 + lane]
        R_01 = w[320 + lane]
        R_02 = w[352 + lane]
        R_10 = w[384 + lane]
        R_11 = w[416 + lane]
        R_12 = w[448 + lane]
        R_20 = w[480 + lane]
        R_21 = w[512 + lane]
        R_22 = w[544 + lane]
        along_x = w[1408 + lane]
        s26 = w[1440 + lane]
        s28 = w[1472 + lane]
        s33 = w[1504 + lane]
        s36 = w[1536 + lane]
        s325 = -R_01*s33 + R_02*s28
        s331 = R_00*s36 + s26*s325
        s336 = -R_11*s33 + R_12*s28
        s342 = R_10*s36 + s26*s336
        s347 = -R_21*s33 + R_22*s28
        s353 = R_20*s36 + s26*s347
        s1299 = -along_x*(R_20*s26 - s347*s36) - oz
        s1301 = -along_x*(R_10*s26 - s336*s36) - oy
        s1303 = s1299*s342 - s1301*s353
        s1304 = -along_x*(R_00*s26 - s325*s36) - ox
        s1307 = -s1299*s331 + s1304*s353
        s1310 = s1301*s331 - s1304*s342
        w[1984 + lane] = s1303
        w[2016 + lane] = s1307
        w[2048 + lane] = s1310
        w[2080 + lane] = s331
        w[2112 + lane] = s342
        w[2144 + lane] = s353
        w[2176 + lane] = s331
        w[2208 + lane] = s342
        w[2240 + lane] = s353
        w[2272 + lane] = 0
        w[2304 + lane] = 0
        w[2336 + lane] = 0


@straight
def _ask(w, n):
    """Force that a body asks for, and its moment about {O} (248 operations)."""
    for lane in range(n):
        ox = w[192 + lane]
        oy = w[224 + lane]
        oz = w[256 + lane]
        R_00 = w[288 + lane]
        R_01 = w[320 + lane]
        R_02 = w[352 + lane]
        R_10 = w[384 + lane]
        R_11 = w[416 + lane]
        R_12 = w[448 + lane]
        R_20 = w[480 + lane]
        R_21 = w[512 + lane]
        R_22 = w[544 + lane]
        ox_tt = w[960 + lane]
        oy_tt = w[992 + lane]
        oz_tt = w[1024 + lane]
        R_00_tt = w[1056 + lane]
        R_01_tt = w[1088 + lane]
        R_02_tt = w[1120 + lane]
        R_10_tt = w[1152 + lane]
        R_11_tt = w[1184 + lane]
        R_12_tt = w[1216 + lane]
        R_20_tt = w[1248 + lane]
        R_21_tt = w[1280 + lane]
        R_22_tt = w[1312 + lane]
        m = w[1568 + lane]
        m_x = w[1600 + lane]
        m_y = w[1632 + lane]
        m_z = w[1664 + lane]
        ixx = w[1696 + lane]
        iyy = w[1728 + lane]
        izz = w[1760 + lane]
        ixy = w[1792 + lane]
        ixz = w[1824 + lane]
        iyz = w[1856 + lane]
        gx = w[1888 + lane]
        gy = w[1920 + lane]
        gz = w[1952 + lane]
        s1312 = -gx + 0.001*ox_tt
        s1317 = 0.001*R_00_tt*m_x + 0.001*R_01_tt*m_y + 0.001*R_02_tt*m_z + m*s1312
        s1319 = -gy + 0.001*oy_tt
        s1324 = 0.001*R_10_tt*m_x + 0.001*R_11_tt*m_y + 0.001*R_12_tt*m_z + m*s1319
        s1326 = -gz + 0.001*oz_tt
        s1331 = 0.001*R_20_tt*m_x + 0.001*R_21_tt*m_y + 0.001*R_22_tt*m_z + m*s1326
        s1336 = -R_20*m_x - R_21*m_y - R_22*m_z
        s1341 = R_10*m_x + R_11*m_y + R_12*m_z
        s1343 = -oz*s1324
        s1349 = 0.5*R_20*ixx - 0.5*R_20*iyy - 0.5*R_20*izz + R_21*ixy + R_22*ixz
        s1350 = 0.001*R_10_tt*s1349
        s1356 = R_20*ixy - 0.5*R_21*ixx + 0.5*R_21*iyy - 0.5*R_21*izz + R_22*iyz
        s1357 = 0.001*R_11_tt*s1356
        s1363 = R_20*ixz + R_21*iyz - 0.5*R_22*ixx - 0.5*R_22*iyy + 0.5*R_22*izz
        s1364 = 0.001*R_12_tt*s1363
        s1370 = -0.5*R_10*ixx + 0.5*R_10*iyy + 0.5*R_10*izz - R_11*ixy - R_12*ixz
        s1371 = 0.001*R_20_tt*s1370
        s1377 = -R_10*ixy + 0.5*R_11*ixx - 0.5*R_11*iyy + 0.5*R_11*izz - R_12*iyz
        s1378 = 0.001*R_21_tt*s1377
        s1384 = -R_10*ixz - R_11*iyz + 0.5*R_12*ixx + 0.5*R_12*iyy - 0.5*R_12*izz
        s1385 = 0.001*R_22_tt*s1384
        s1386 = oy*s1331 + s1319*s1336 + s1326*s1341 + s1343 + s1350 + s1357 + s1364 + s1371 + s1378 + s1385
        s1392 = -R_00*m_x - R_01*m_y - R_02*m_z
        s1394 = -ox*s1331
        s1395 = -0.001*R_00_tt*s1349
        s1396 = -0.001*R_01_tt*s1356
        s1397 = -0.001*R_02_tt*s1363
        s1403 = 0.5*R_00*ixx - 0.5*R_00*iyy - 0.5*R_00*izz + R_01*ixy + R_02*ixz
        s1404 = 0.001*R_20_tt*s1403
        s1410 = R_00*ixy - 0.5*R_01*ixx + 0.5*R_01*iyy - 0.5*R_01*izz + R_02*iyz
        s1411 = 0.001*R_21_tt*s1410
        s1417 = R_00*ixz + R_01*iyz - 0.5*R_02*ixx - 0.5*R_02*iyy + 0.5*R_02*izz
        s1418 = 0.001*R_22_tt*s1417
        s1419 = oz*s1317 - s1312*s1336 + s1326*s1392 + s1394 + s1395 + s1396 + s1397 + s1404 + s1411 + s1418
        s1423 = -oy*s1317
        s1424 = -0.001*R_00_tt*s1370
        s1425 = -0.001*R_01_tt*s1377
        s1426 = -0.001*R_02_tt*s1384
        s1427 = -0.001*R_10_tt*s1403
        s1428 = -0.001*R_11_tt*s1410
        s1429 = -0.001*R_12_tt*s1417
        s1430 = ox*s1324 - s1312*s1341 - s1319*s1392 + s1423 + s1424 + s1425 + s1426 + s1427 + s1428 + s1429
        w[2560 + lane] = s1317
        w[2592 + lane] = s1324
        w[2624 + lane] = s1331
        w[2656 + lane] = s1386
        w[2688 + lane] = s1419
        w[2720 + lane] = s1430


@straight
def _ask_each(w, n):
    """The same for each inertial parameter by itself (294 operations)."""
    for lane in range(n):
        ox = w[192 + lane]
        oy = w[224 + lane]
        oz = w[256 + lane]
        R_00 = w[288 + lane]
        R_01 = w[320 + lane]
        R_02 = w[352 + lane]
        R_10 = w[384 + lane]
        R_11 = w[416 + lane]
        R_12 = w[448 + lane]
        R_20 = w[480 + lane]
        R_21 = w[512 + lane]
        R_22 = w[544 + lane]
        ox_tt = w[960 + lane]
        oy_tt = w[992 + lane]
        oz_tt = w[1024 + lane]
        R_00_tt = w[1056 + lane]
        R_01_tt = w[1088 + lane]
        R_02_tt = w[1120 + lane]
        R_10_tt = w[1152 + lane]
        R_11_tt = w[1184 + lane]
        R_12_tt = w[1216 + lane]
        R_20_tt = w[1248 + lane]
        R_21_tt = w[1280 + lane]
        R_22_tt = w[1312 + lane]
        gx = w[1888 + lane]
        gy = w[1920 + lane]
        gz = w[1952 + lane]
        s1312 = -gx + 0.001*ox_tt
        s1319 = -gy + 0.001*oy_tt
        s1326 = -gz + 0.001*oz_tt
        s1433 = oy*s1326 - oz*s1319
        s1436 = -ox*s1326 + oz*s1312
        s1439 = ox*s1319 - oy*s1312
        s1440 = 0.001*R_00_tt
        s1441 = 0.001*R_10_tt
        s1442 = 0.001*R_20_tt
        s1447 = R_10*s1326 - 0.001*R_10_tt*oz - R_20*s1319 + 0.001*R_20_tt*oy
        s1452 = -R_00*s1326 + 0.001*R_00_tt*oz + R_20*s1312 - 0.001*R_20_tt*ox
        s1457 = R_00*s1319 - 0.001*R_00_tt*oy - R_10*s1312 + 0.001*R_10_tt*ox
        s1458 = 0.001*R_01_tt
        s1459 = 0.001*R_11_tt
        s1460 = 0.001*R_21_tt
        s1465 = R_11*s1326 - 0.001*R_11_tt*oz - R_21*s1319 + 0.001*R_21_tt*oy
        s1470 = -R_01*s1326 + 0.001*R_01_tt*oz + R_21*s1312 - 0.001*R_21_tt*ox
        s1475 = R_01*s1319 - 0.001*R_01_tt*oy - R_11*s1312 + 0.001*R_11_tt*ox
        s1476 = 0.001*R_02_tt
        s1477 = 0.001*R_12_tt
        s1478 = 0.001*R_22_tt
        s1483 = R_12*s1326 - 0.001*R_12_tt*oz - R_22*s1319 + 0.001*R_22_tt*oy
        s1488 = -R_02*s1326 + 0.001*R_02_tt*oz + R_22*s1312 - 0.001*R_22_tt*ox
        s1493 = R_02*s1319 - 0.001*R_02_tt*oy - R_12*s1312 + 0.001*R_12_tt*ox
        s1494 = -0.0005*R_10*R_20_tt
        s1495 = -0.0005*R_11_tt*R_21
        s1496 = -0.0005*R_12_tt*R_22
        s1497 = 0.0005*R_10_tt*R_20
        s1498 = 0.0005*R_11*R_21_tt
        s1499 = 0.0005*R_12*R_22_tt
        s1500 = s1494 + s1495 + s1496 + s1497 + s1498 + s1499
        s1501 = -0.0005*R_00_tt*R_20
        s1502 = -0.0005*R_01*R_21_tt
        s1503 = -0.0005*R_02*R_22_tt
        s1504 = 0.0005*R_00*R_20_tt
        s1505 = 0.0005*R_01_tt*R_21
        s1506 = 0.0005*R_02_tt*R_22
        s1507 = s1501 + s1502 + s1503 + s1504 + s1505 + s1506
        s1508 = -0.0005*R_00*R_10_tt
        s1509 = -0.0005*R_01_tt*R_11
        s1510 = -0.0005*R_02_tt*R_12
        s1511 = 0.0005*R_00_tt*R_10
        s1512 = 0.0005*R_01*R_11_tt
        s1513 = 0.0005*R_02*R_12_tt
        s1514 = s1508 + s1509 + s1510 + s1511 + s1512 + s1513
        s1515 = -s1494 - s1495 + s1496 - s1497 - s1498 + s1499
        s1516 = -s1501 - s1502 + s1503 - s1504 - s1505 + s1506
        s1517 = -s1508 - s1509 + s1510 - s1511 - s1512 + s1513
        s1518 = -s1494 + s1495 - s1496 - s1497 + s1498 - s1499
        s1519 = -s1501 + s1502 - s1503 - s1504 + s1505 - s1506
        s1520 = -s1508 + s1509 - s1510 - s1511 + s1512 - s1513
        s1525 = -0.001*R_10*R_21_tt + 0.001*R_10_tt*R_21 - 0.001*R_11*R_20_tt + 0.001*R_11_tt*R_20
        s1530 = 0.001*R_00*R_21_tt - 0.001*R_00_tt*R_21 + 0.001*R_01*R_20_tt - 0.001*R_01_tt*R_20
        s1535 = -0.001*R_00*R_11_tt + 0.001*R_00_tt*R_11 - 0.001*R_01*R_10_tt + 0.001*R_01_tt*R_10
        s1540 = -0.001*R_10*R_22_tt + 0.001*R_10_tt*R_22 - 0.001*R_12*R_20_tt + 0.001*R_12_tt*R_20
        s1545 = 0.001*R_00*R_22_tt - 0.001*R_00_tt*R_22 + 0.001*R_02*R_20_tt - 0.001*R_02_tt*R_20
        s1550 = -0.001*R_00*R_12_tt + 0.001*R_00_tt*R_12 - 0.001*R_02*R_10_tt + 0.001*R_02_tt*R_10
        s1555 = -0.001*R_11*R_22_tt + 0.001*R_11_tt*R_22 - 0.001*R_12*R_21_tt + 0.001*R_12_tt*R_21
        s1560 = 0.001*R_01*R_22_tt - 0.001*R_01_tt*R_22 + 0.001*R_02*R_21_tt - 0.001*R_02_tt*R_21
        s1565 = -0.001*R_01*R_12_tt + 0.001*R_01_tt*R_12 - 0.001*R_02*R_11_tt + 0.001*R_02_tt*R_11
        w[2752 + lane] = s1312
        w[2784 + lane] = s1319
        w[2816 + lane] = s1326
        w[2848 + lane] = s1433
        w[2880 + lane] = s1436
        w[2912 + lane] = s1439
        w[2944 + lane] = s1440
        w[2976 + lane] = s1441
        w[3008 + lane] = s1442
        w[3040 + lane] = s1447
        w[3072 + lane] = s1452
        w[3104 + lane] = s1457
        w[3136 + lane] = s1458
        w[3168 + lane] = s1459
        w[3200 + lane] = s1460
        w[3232 + lane] = s1465
        w[3264 + lane] = s1470
        w[3296 + lane] = s1475
        w[3328 + lane] = s1476
        w[3360 + lane] = s1477
        w[3392 + lane] = s1478
        w[3424 + lane] = s1483
        w[3456 + lane] = s1488
        w[3488 + lane] = s1493
        w[3520 + lane] = 0
        w[3552 + lane] = 0
        w[3584 + lane] = 0
        w[3616 + lane] = s1500
        w[3648 + lane] = s1507
        w[3680 + lane] = s1514
        w[3712 + lane] = 0
        w[3744 + lane] = 0
        w[3776 + lane] = 0
        w[3808 + lane] = s1515
        w[3840 + lane] = s1516
        w[3872 + lane] = s1517
        w[3904 + lane] = 0
        w[3936 + lane] = 0
        w[3968 + lane] = 0
        w[4000 + lane] = s1518
        w[4032 + lane] = s1519
        w[4064 + lane] = s1520
        w[4096 + lane] = 0
        w[4128 + lane] = 0
        w[4160 + lane] = 0
        w[4192 + lane] = s1525
        w[4224 + lane] = s1530
        w[4256 + lane] = s1535
        w[4288 + lane] = 0
        w[4320 + lane] = 0
        w[4352 + lane] = 0
        w[4384 + lane] = s1540
        w[4416 + lane] = s1545
        w[4448 + lane] = s1550
        w[4480 + lane] = 0
        w[4512 + lane] = 0
        w[4544 + lane] = 0
        w[4576 + lane] = s1555
        w[4608 + lane] = s1560
        w[4640 + lane] = s1565


@straight
def _give(w, n):
    """What a joint gives to what is asked behind it (11 operations)."""
    for lane in range(n):
        fx = w[2560 + lane]
        fy = w[2592 + lane]
        fz = w[2624 + lane]
        mx = w[2656 + lane]
        my = w[2688 + lane]
        mz = w[2720 + lane]
        ux = w[2368 + lane]
        uy = w[2400 + lane]
        uz = w[2432 + lane]
        wx = w[2464 + lane]
        wy = w[2496 + lane]
        wz = w[2528 + lane]
        s1581 = fx*ux + fy*uy + fz*uz + mx*wx + my*wy + mz*wz
        w[4672 + lane] = s1581


@straight
def _give_each(w, n):
    """The same for each inertial parameter (110 operations)."""
    for lane in range(n):
        ux = w[2368 + lane]
        uy = w[2400 + lane]
        uz = w[2432 + lane]
        wx = w[2464 + lane]
        wy = w[2496 + lane]
        wz = w[2528 + lane]
        m_fx = w[2752 + lane]
        m_fy = w[2784 + lane]
        m_fz = w[2816 + lane]
        m_mx = w[2848 + lane]
        m_my = w[2880 + lane]
        m_mz = w[2912 + lane]
        m_x_fx = w[2944 + lane]
        m_x_fy = w[2976 + lane]
        m_x_fz = w[3008 + lane]
        m_x_mx = w[3040 + lane]
        m_x_my = w[3072 + lane]
        m_x_mz = w[3104 + lane]
        m_y_fx = w[3136 + lane]
        m_y_fy = w[3168 + lane]
        m_y_fz = w[3200 + lane]
        m_y_mx = w[3232 + lane]
        m_y_my = w[3264 + lane]
        m_y_mz = w[3296 + lane]
        m_z_fx = w[3328 + lane]
        m_z_fy = w[3360 + lane]
        m_z_fz = w[3392 + lane]
        m_z_mx = w[3424 + lane]
        m_z_my = w[3456 + lane]
        m_z_mz = w[3488 + lane]
        ixx_fx = w[3520 + lane]
        ixx_fy = w[3552 + lane]
        ixx_fz = w[3584 + lane]
        ixx_mx = w[3616 + lane]
        ixx_my = w[3648 + lane]
        ixx_mz = w[3680 + lane]
        iyy_fx = w[3712 + lane]
        iyy_fy = w[3744 + lane]
        iyy_fz = w[3776 + lane]
        iyy_mx = w[3808 + lane]
        iyy_my = w[3840 + lane]
        iyy_mz = w[3872 + lane]
        izz_fx = w[3904 + lane]
        izz_fy = w[3936 + lane]
        izz_fz = w[3968 + lane]
        izz_mx = w[4000 + lane]
        izz_my = w[4032 + lane]
        izz_mz = w[4064 + lane]
        ixy_fx = w[4096 + lane]
        ixy_fy = w[4128 + lane]
        ixy_fz = w[4160 + lane]
        ixy_mx = w[4192 + lane]
        ixy_my = w[4224 + lane]
        ixy_mz = w[4256 + lane]
        ixz_fx = w[4288 + lane]
        ixz_fy = w[4320 + lane]
        ixz_fz = w[4352 + lane]
        ixz_mx = w[4384 + lane]
        ixz_my = w[4416 + lane]
        ixz_mz = w[4448 + lane]
        iyz_fx = w[4480 + lane]
        iyz_fy = w[4512 + lane]
        iyz_fz = w[4544 + lane]
        iyz_mx = w[4576 + lane]
        iyz_my = w[4608 + lane]
        iyz_mz = w[4640 + lane]
        s1588 = m_fx*ux + m_fy*uy + m_fz*uz + m_mx*wx + m_my*wy + m_mz*wz
        s1595 = m_x_fx*ux + m_x_fy*uy + m_x_fz*uz + m_x_mx*wx + m_x_my*wy + m_x_mz*wz
        s1602 = m_y_fx*ux + m_y_fy*uy + m_y_fz*uz + m_y_mx*wx + m_y_my*wy + m_y_mz*wz
        s1609 = m_z_fx*ux + m_z_fy*uy + m_z_fz*uz + m_z_mx*wx + m_z_my*wy + m_z_mz*wz
        s1616 = ixx_fx*ux + ixx_fy*uy + ixx_fz*uz + ixx_mx*wx + ixx_my*wy + ixx_mz*wz
        s1623 = iyy_fx*ux + iyy_fy*uy + iyy_fz*uz + iyy_mx*wx + iyy_my*wy + iyy_mz*wz
        s1630 = izz_fx*ux + izz_fy*uy + izz_fz*uz + izz_mx*wx + izz_my*wy + izz_mz*wz
        s1637 = ixy_fx*ux + ixy_fy*uy + ixy_fz*uz + ixy_mx*wx + ixy_my*wy + ixy_mz*wz
        s1644 = ixz_fx*ux + ixz_fy*uy + ixz_fz*uz + ixz_mx*wx + ixz_my*wy + ixz_mz*wz
        s1651 = iyz_fx*ux + iyz_fy*uy + iyz_fz*uz + iyz_mx*wx + iyz_my*wy + iyz_mz*wz
        w[4672 + lane] = s1588
        w[4704 + lane] = s1595
        w[4736 + lane] = s1602
        w[4768 + lane] = s1609
        w[4800 + lane] = s1616
        w[4832 + lane] = s1623
        w[4864 + lane] = s1630
        w[4896 + lane] = s1637
        w[4928 + lane] = s1644
        w[4960 + lane] = s1651


@straight
def _begin(gravity, w, n):
    """Begin with the frame of the base, at rest."""
    for lane in range(n):
        w[192 + lane] = 0.0
        w[224 + lane] = 0.0
        w[256 + lane] = 0.0
        w[288 + lane] = 1.0
        w[320 + lane] = 0.0
        w[352 + lane] = 0.0
        w[384 + lane] = 0.0
        w[416 + lane] = 1.0
        w[448 + lane] = 0.0
        w[480 + lane] = 0.0
        w[512 + lane] = 0.0
        w[544 + lane] = 1.0
        w[576 + lane] = 0.0
        w[608 + lane] = 0.0
        w[640 + lane] = 0.0
        w[672 + lane] = 0.0
        w[704 + lane] = 0.0
        w[736 + lane] = 0.0
        w[768 + lane] = 0.0
        w[800 + lane] = 0.0
        w[832 + lane] = 0.0
        w[864 + lane] = 0.0
        w[896 + lane] = 0.0
        w[928 + lane] = 0.0
        w[960 + lane] = 0.0
        w[992 + lane] = 0.0
        w[1024 + lane] = 0.0
        w[1056 + lane] = 0.0
        w[1088 + lane] = 0.0
        w[1120 + lane] = 0.0
        w[1152 + lane] = 0.0
        w[1184 + lane] = 0.0
        w[1216 + lane] = 0.0
        w[1248 + lane] = 0.0
        w[1280 + lane] = 0.0
        w[1312 + lane] = 0.0
        w[1888 + lane] = gravity[0]
        w[1920 + lane] = gravity[1]
        w[1952 + lane] = gravity[2]


@straight
def _rest(w, n):
    """Leave a link's joint at zero, at rest."""
    for lane in range(n):
        w[0 + lane] = 0.0
        w[32 + lane] = 0.0
        w[64 + lane] = 0.0
        w[96 + lane] = 0.0
        w[128 + lane] = 0.0
        w[160 + lane] = 0.0


@straight
def _drive(states, much, w, variable, j, joints, first, last, n):
    """Move a link's joint by one of the chain's, the last sample again for the rest of `n`."""
    for lane in range(n):
        m = min(first + lane, last)
        w[32 * (0 + variable) + lane] += much[0] * states[joints * m + j]


@straight
def _own(k, of, w, link, links, first, last, n):
    """Put what no sample changes of a link side by side, of the machine that stands at each sample."""
    for lane in range(n):
        at = 7 * (links * of[min(first + lane, last)] + link)
        w[1344 + lane] = k[at + 0]
        w[1376 + lane] = k[at + 1]
        w[1408 + lane] = k[at + 2]
        w[1440 + lane] = k[at + 3]
        w[1472 + lane] = k[at + 4]
        w[1504 + lane] = k[at + 5]
        w[1536 + lane] = k[at + 6]


@straight
def _weigh(inertia, w, n):
    """Put the inertial parameters of a link side by side."""
    for lane in range(n):
        w[1568 + lane] = inertia[0]
        w[1600 + lane] = inertia[1]
        w[1632 + lane] = inertia[2]
        w[1664 + lane] = inertia[3]
        w[1696 + lane] = inertia[4]
        w[1728 + lane] = inertia[5]
        w[1760 + lane] = inertia[6]
        w[1792 + lane] = inertia[7]
        w[1824 + lane] = inertia[8]
        w[1856 + lane] = inertia[9]


@straight
def _keep_axis(w, axes, variable, n):
    """Keep the twist by a link's turn or slide."""
    for lane in range(n):
        axes[0 + lane] = w[32 * (6 * variable + 62) + lane]
        axes[32 + lane] = w[32 * (6 * variable + 63) + lane]
        axes[64 + lane] = w[32 * (6 * variable + 64) + lane]
        axes[96 + lane] = w[32 * (6 * variable + 65) + lane]
        axes[128 + lane] = w[32 * (6 * variable + 66) + lane]
        axes[160 + lane] = w[32 * (6 * variable + 67) + lane]


@straight
def _take_axis(w, axes, n):
    """Take a twist that was kept."""
    for lane in range(n):
        w[2368 + lane] = axes[0 + lane]
        w[2400 + lane] = axes[32 + lane]
        w[2432 + lane] = axes[64 + lane]
        w[2464 + lane] = axes[96 + lane]
        w[2496 + lane] = axes[128 + lane]
        w[2528 + lane] = axes[160 + lane]


@straight
def _keep_asked(w, bodies, n):
    """Keep what a link's body asks for."""
    for lane in range(n):
        bodies[0 + lane] = w[2560 + lane]
        bodies[32 + lane] = w[2592 + lane]
        bodies[64 + lane] = w[2624 + lane]
        bodies[96 + lane] = w[2656 + lane]
        bodies[128 + lane] = w[2688 + lane]
        bodies[160 + lane] = w[2720 + lane]


@straight
def _nothing(w, n):
    """Begin with nothing asked for."""
    for lane in range(n):
        w[2560 + lane] = 0.0
        w[2592 + lane] = 0.0
        w[2624 + lane] = 0.0
        w[2656 + lane] = 0.0
        w[2688 + lane] = 0.0
        w[2720 + lane] = 0.0


@straight
def _also(w, bodies, n):
    """Add what a body asks for."""
    for lane in range(n):
        w[2560 + lane] += bodies[0 + lane]
        w[2592 + lane] += bodies[32 + lane]
        w[2624 + lane] += bodies[64 + lane]
        w[2656 + lane] += bodies[96 + lane]
        w[2688 + lane] += bodies[128 + lane]
        w[2720 + lane] += bodies[160 + lane]


@straight
def _pay(w, much, tau, j, joints, first, last):
    """Add what a joint gives to its torque."""
    for lane in range(last - first + 1):
        tau[joints * (first + lane) + j] += much[0] * w[4672 + lane]


@straight
def _pay_each(w, much, Y, at, width, first, last):
    """Add what a joint gives for each inertial parameter of a link."""
    for lane in range(last - first + 1):
        Y[width * (first + lane) + at + 0] += much[0] * w[4672 + lane]
        Y[width * (first + lane) + at + 1] += much[0] * w[4704 + lane]
        Y[width * (first + lane) + at + 2] += much[0] * w[4736 + lane]
        Y[width * (first + lane) + at + 3] += much[0] * w[4768 + lane]
        Y[width * (first + lane) + at + 4] += much[0] * w[4800 + lane]
        Y[width * (first + lane) + at + 5] += much[0] * w[4832 + lane]
        Y[width * (first + lane) + at + 6] += much[0] * w[4864 + lane]
        Y[width * (first + lane) + at + 7] += much[0] * w[4896 + lane]
        Y[width * (first + lane) + at + 8] += much[0] * w[4928 + lane]
        Y[width * (first + lane) + at + 9] += much[0] * w[4960 + lane]


@fast
def _torque(motion, inertia, gravity, k, conventions, drives, much, tau):
    q = motion[0]
    links, joints = k.shape[1], q.shape[1]
    w, axes, bodies = scratch(WORK), scratch(much.size * AXIS), scratch(links * ASKED)
    states, constants, masses, torques = (
        motion.reshape(motion.size), k.reshape(k.size), inertia.reshape(inertia.size), tau.reshape(tau.size)
    )
    tau[:] = 0.0
    of = np.arange(len(q)) // (len(q) // k.shape[0])  # the machine that stands at each sample
    for first in range(0, len(q), LANES):
        last = min(first + LANES, len(q)) - 1
        n = (last - first + 8) // 8 * 8
        _begin(gravity, w, n)
        row = 0
        for link in range(links):
            _own(constants, of, w, link, links, first, last, n)
            _rest(w, n)
            at = row
            while row < much.size and drives[row, 0] == link:
                for order in range(3):
                    _drive(
                        states[order * len(q) * joints :], much[row:], w, 2 * order + drives[row, 1], drives[row, 2],
                        joints, first, last, n,
                    )
                row += 1
            if conventions[link] == 0:
                _axes_standard(w, n)
            elif conventions[link] == 1:
                _axes_modified(w, n)
            for d in range(at, row):
                _keep_axis(w, axes[AXIS * d :], drives[d, 1], n)
            if conventions[link] == 0:
                _move_standard(w, n)
            elif conventions[link] == 1:
                _move_modified(w, n)
            _weigh(masses[10 * link :], w, n)
            _ask(w, n)
            _keep_asked(w, bodies[ASKED * link :], n)
        _nothing(w, n)
        for link in range(links - 1, -1, -1):
            _also(w, bodies[ASKED * link :], n)
            while row > 0 and drives[row - 1, 0] == link:
                row -= 1
                _take_axis(w, axes[AXIS * row :], n)
                _give(w, n)
                _pay(w, much[row:], torques, drives[row, 2], joints, first, last)


def torque(motion, inertia, gravity, k, conventions, drives, much, tau):
    """Fill tau (N, n_q) [N mm, N]: what the joints must give, positive along positive joints."""
    _torque(motion, inertia, gravity, k, conventions, drives, much, tau)


@fast
def _regressor(motion, gravity, k, conventions, drives, much, Y):
    q = motion[0]
    links, joints = k.shape[1], q.shape[1]
    w, axes = scratch(WORK), scratch(much.size * AXIS)
    states, constants, found = motion.reshape(motion.size), k.reshape(k.size), Y.reshape(Y.size)
    width = 10 * links
    Y[:] = 0.0
    of = np.arange(len(q)) // (len(q) // k.shape[0])  # the machine that stands at each sample
    for first in range(0, len(q), LANES):
        last = min(first + LANES, len(q)) - 1
        n = (last - first + 8) // 8 * 8
        _begin(gravity, w, n)
        row = 0
        for link in range(links):
            _own(constants, of, w, link, links, first, last, n)
            _rest(w, n)
            at = row
            while row < much.size and drives[row, 0] == link:
                for order in range(3):
                    _drive(
                        states[order * len(q) * joints :], much[row:], w, 2 * order + drives[row, 1], drives[row, 2],
                        joints, first, last, n,
                    )
                row += 1
            if conventions[link] == 0:
                _axes_standard(w, n)
            elif conventions[link] == 1:
                _axes_modified(w, n)
            for d in range(at, row):
                _keep_axis(w, axes[AXIS * d :], drives[d, 1], n)
            if conventions[link] == 0:
                _move_standard(w, n)
            elif conventions[link] == 1:
                _move_modified(w, n)
            _ask_each(w, n)
            for d in range(row):
                _take_axis(w, axes[AXIS * d :], n)
                _give_each(w, n)
                _pay_each(w, much[d:], found, width * drives[d, 2] + 10 * link, width * joints, first, last)


def regressor(motion, gravity, k, conventions, drives, much, Y):
    """Fill Y (N, n_q, 10 links): what the joints must give for each inertial parameter, link by link, which is 1."""
    _regressor(motion, gravity, k, conventions, drives, much, Y)


@straight
def _fill_by(p, p_by, k, rows):
    """Fill the rates of what no sample changes of the links."""
    for lane in range(rows):
        alpha_now = p[12 * lane + 1]
        dalpha_now = p[12 * lane + 5]
        dbeta_now = p[12 * lane + 8]
        a_now_by = p_by[12 * lane + 0]
        alpha_now_by = p_by[12 * lane + 1]
        d_now_by = p_by[12 * lane + 2]
        theta_now_by = p_by[12 * lane + 3]
        da_now_by = p_by[12 * lane + 4]
        dalpha_now_by = p_by[12 * lane + 5]
        dd_now_by = p_by[12 * lane + 6]
        dtheta_now_by = p_by[12 * lane + 7]
        dbeta_now_by = p_by[12 * lane + 8]
        about_x_now = alpha_now + dalpha_now
        s26_now = cosine(dbeta_now)
        s28_now = cosine(about_x_now)
        s33_now = sine(about_x_now)
        s36_now = sine(dbeta_now)
        s8 = dtheta_now_by + theta_now_by
        s9 = d_now_by + dd_now_by
        s10 = a_now_by + da_now_by
        s11 = alpha_now_by + dalpha_now_by
        s12 = -dbeta_now_by*s36_now
        s13 = -s11*s33_now
        s14 = s11*s28_now
        s15 = dbeta_now_by*s26_now
        k[7 * lane + 0] = s8
        k[7 * lane + 1] = s9
        k[7 * lane + 2] = s10
        k[7 * lane + 3] = s12
        k[7 * lane + 4] = s13
        k[7 * lane + 5] = s14
        k[7 * lane + 6] = s15


@fast
def _constants_by(p, p_by, k):
    _fill_by(p, p_by, k, p.shape[0] * p.shape[1])


def constants_by(p, p_by):
    """Return how `constants` change (E, links, 7) as p (1, links, 12) does along each of p_by."""
    p_by = np.ascontiguousarray(p_by, dtype=float)
    k_by = np.empty((*p_by.shape[:2], 7))
    _constants_by(np.repeat(p, len(p_by), axis=0), p_by, k_by)
    return k_by


@straight
def _move_standard_by(w, w_by, n):
    """Rates of a link, standard convention: its frame, and how that moves, by the one before (846 operations)."""
    for lane in range(n):
        turn_now = w[0 + lane]
        slide_now = w[32 + lane]
        turn_t_now = w[64 + lane]
        slide_t_now = w[96 + lane]
        turn_tt_now = w[128 + lane]
        slide_tt_now = w[160 + lane]
        R_00_now = w[288 + lane]
        R_01_now = w[320 + lane]
        R_02_now = w[352 + lane]
        R_10_now = w[384 + lane]
        R_11_now = w[416 + lane]
        R_12_now = w[448 + lane]
        R_20_now = w[480 + lane]
        R_21_now = w[512 + lane]
        R_22_now = w[544 + lane]
        R_00_t_now = w[672 + lane]
        R_01_t_now = w[704 + lane]
        R_02_t_now = w[736 + lane]
        R_10_t_now = w[768 + lane]
        R_11_t_now = w[800 + lane]
        R_12_t_now = w[832 + lane]
        R_20_t_now = w[864 + lane]
        R_21_t_now = w[896 + lane]
        R_22_t_now = w[928 + lane]
        R_00_tt_now = w[1056 + lane]
        R_01_tt_now = w[1088 + lane]
        R_02_tt_now = w[1120 + lane]
        R_10_tt_now = w[1152 + lane]
        R_11_tt_now = w[1184 + lane]
        R_12_tt_now = w[1216 + lane]
        R_20_tt_now = w[1248 + lane]
        R_21_tt_now = w[1280 + lane]
        R_22_tt_now = w[1312 + lane]
        s0_now = w[1344 + lane]
        s2_now = w[1376 + lane]
        along_x_now = w[1408 + lane]
        s26_now = w[1440 + lane]
        s28_now = w[1472 + lane]
        s33_now = w[1504 + lane]
        s36_now = w[1536 + lane]
        ox_now_by = w_by[192 + lane]
        oy_now_by = w_by[224 + lane]
        oz_now_by = w_by[256 + lane]
        R_00_now_by = w_by[288 + lane]
        R_01_now_by = w_by[320 + lane]
        R_02_now_by = w_by[352 + lane]
        R_10_now_by = w_by[384 + lane]
        R_11_now_by = w_by[416 + lane]
        R_12_now_by = w_by[448 + lane]
        R_20_now_by = w_by[480 + lane]
        R_21_now_by = w_by[512 + lane]
        R_22_now_by = w_by[544 + lane]
        ox_t_now_by = w_by[576 + lane]
        oy_t_now_by = w_by[608 + lane]
        oz_t_now_by = w_by[640 + lane]
        R_00_t_now_by = w_by[672 + lane]
        R_01_t_now_by = w_by[704 + lane]
        R_02_t_now_by = w_by[736 + lane]
        R_10_t_now_by = w_by[768 + lane]
        R_11_t_now_by = w_by[800 + lane]
        R_12_t_now_by = w_by[832 + lane]
        R_20_t_now_by = w_by[864 + lane]
        R_21_t_now_by = w_by[896 + lane]
        R_22_t_now_by = w_by[928 + lane]
        ox_tt_now_by = w_by[960 + lane]
        oy_tt_now_by = w_by[992 + lane]
        oz_tt_now_by = w_by[1024 + lane]
        R_00_tt_now_by = w_by[1056 + lane]
        R_01_tt_now_by = w_by[1088 + lane]
        R_02_tt_now_by = w_by[1120 + lane]
        R_10_tt_now_by = w_by[1152 + lane]
        R_11_tt_now_by = w_by[1184 + lane]
        R_12_tt_now_by = w_by[1216 + lane]
        R_20_tt_now_by = w_by[1248 + lane]
        R_21_tt_now_by = w_by[1280 + lane]
        R_22_tt_now_by = w_by[1312 + lane]
        s0_now_by = w_by[1344 + lane]
        s2_now_by = w_by[1376 + lane]
        along_x_now_by = w_by[1408 + lane]
        s26_now_by = w_by[1440 + lane]
        s28_now_by = w_by[1472 + lane]
        s33_now_by = w_by[1504 + lane]
        s36_now_by = w_by[1536 + lane]
        about_z_now = s0_now + turn_now
        along_z_now = s2_now + slide_now
        s7_now = cosine(about_z_now)
        s9_now = sine(about_z_now)
        s11_now = R_00_now*s7_now + R_01_now*s9_now
        s17_now = R_10_now*s7_now + R_11_now*s9_now
        s23_now = R_20_now*s7_now + R_21_now*s9_now
        s32_now = -R_00_now*s9_now + R_01_now*s7_now
        s35_now = R_02_now*s28_now - s32_now*s33_now
        s49_now = -R_10_now*s9_now + R_11_now*s7_now
        s51_now = R_12_now*s28_now - s33_now*s49_now
        s64_now = -R_20_now*s9_now + R_21_now*s7_now
        s66_now = R_22_now*s28_now - s33_now*s64_now
        s78_now = -s9_now*turn_t_now
        s82_now = s7_now*turn_t_now
        s86_now = R_00_now*s78_now + R_00_t_now*s7_now + R_01_now*s82_now + R_01_t_now*s9_now
        s98_now = R_10_now*s78_now + R_10_t_now*s7_now + R_11_now*s82_now + R_11_t_now*s9_now
        s110_now = R_20_now*s78_now + R_20_t_now*s7_now + R_21_now*s82_now + R_21_t_now*s9_now
        s121_now = -R_00_now*s82_now - R_00_t_now*s9_now + R_01_now*s78_now + R_01_t_now*s7_now
        s123_now = R_02_t_now*s28_now - s121_now*s33_now
        s140_now = -R_10_now*s82_now - R_10_t_now*s9_now + R_11_now*s78_now + R_11_t_now*s7_now
        s142_now = R_12_t_now*s28_now - s140_now*s33_now
        s159_now = -R_20_now*s82_now - R_20_t_now*s9_now + R_21_now*s78_now + R_21_t_now*s7_now
        s161_now = R_22_t_now*s28_now - s159_now*s33_now
        s178_now = -s82_now*turn_t_now - s9_now*turn_tt_now
        s180_now = R_00_t_now*s78_now
        s187_now = s78_now*turn_t_now + s7_now*turn_tt_now
        s189_now = R_01_t_now*s82_now
        s194_now = R_00_now*s178_now + R_00_tt_now*s7_now + R_01_now*s187_now + R_01_tt_now*s9_now + 2*s180_now + 2*s189_now
        s204_now = R_10_t_now*s78_now
        s210_now = R_11_t_now*s82_now
        s215_now = R_10_now*s178_now + R_10_tt_now*s7_now + R_11_now*s187_now + R_11_tt_now*s9_now + 2*s204_now + 2*s210_now
        s225_now = R_20_t_now*s78_now
        s231_now = R_21_t_now*s82_now
        s236_now = R_20_now*s178_now + R_20_tt_now*s7_now + R_21_now*s187_now + R_21_tt_now*s9_now + 2*s225_now + 2*s231_now
        s242_now = R_01_t_now*s78_now
        s248_now = -R_00_t_now*s82_now
        s253_now = -R_00_now*s187_now - R_00_tt_now*s9_now + R_01_now*s178_now + R_01_tt_now*s7_now + 2*s242_now + 2*s248_now
        s255_now = R_02_tt_now*s28_now - s253_now*s33_now
        s267_now = R_11_t_now*s78_now
        s273_now = -R_10_t_now*s82_now
        s278_now = -R_10_now*s187_now - R_10_tt_now*s9_now + R_11_now*s178_now + R_11_tt_now*s7_now + 2*s267_now + 2*s273_now
        s280_now = R_12_tt_now*s28_now - s278_now*s33_now
        s292_now = R_21_t_now*s78_now
        s298_now = -R_20_t_now*s82_now
        s303_now = -R_20_now*s187_now - R_20_tt_now*s9_now + R_21_now*s178_now + R_21_tt_now*s7_now + 2*s292_now + 2*s298_now
        s305_now = R_22_tt_now*s28_now - s303_now*s33_now
        s261 = -s0_now_by*s9_now
        s262 = s0_now_by*s7_now
        s269 = R_00_now*s261 + R_00_now_by*s7_now + R_01_now*s262 + R_01_now_by*s9_now
        s276 = R_02_now*s2_now_by + R_02_now_by*along_z_now + along_x_now*s269 + along_x_now_by*s11_now + ox_now_by
        s283 = R_10_now*s261 + R_10_now_by*s7_now + R_11_now*s262 + R_11_now_by*s9_now
        s290 = R_12_now*s2_now_by + R_12_now_by*along_z_now + along_x_now*s283 + along_x_now_by*s17_now + oy_now_by
        s297 = R_20_now*s261 + R_20_now_by*s7_now + R_21_now*s262 + R_21_now_by*s9_now
        s304 = R_22_now*s2_now_by + R_22_now_by*along_z_now + along_x_now*s297 + along_x_now_by*s23_now + oz_now_by
        s311 = -R_00_now*s262 - R_00_now_by*s9_now + R_01_now*s261 + R_01_now_by*s7_now
        s318 = R_02_now*s28_now_by + R_02_now_by*s28_now - s311*s33_now - s32_now*s33_now_by
        s325 = s11_now*s26_now_by + s269*s26_now - s318*s36_now - s35_now*s36_now_by
        s332 = R_02_now*s33_now_by + R_02_now_by*s33_now + s28_now*s311 + s28_now_by*s32_now
        s339 = s11_now*s36_now_by + s269*s36_now + s26_now*s318 + s26_now_by*s35_now
        s346 = -R_10_now*s262 - R_10_now_by*s9_now + R_11_now*s261 + R_11_now_by*s7_now
        s353 = R_12_now*s28_now_by + R_12_now_by*s28_now - s33_now*s346 - s33_now_by*s49_now
        s360 = s17_now*s26_now_by + s26_now*s283 - s353*s36_now - s36_now_by*s51_now
        s367 = R_12_now*s33_now_by + R_12_now_by*s33_now + s28_now*s346 + s28_now_by*s49_now
        s374 = s17_now*s36_now_by + s26_now*s353 + s26_now_by*s51_now + s283*s36_now
        s381 = -R_20_now*s262 - R_20_now_by*s9_now + R_21_now*s261 + R_21_now_by*s7_now
        s388 = R_22_now*s28_now_by + R_22_now_by*s28_now - s33_now*s381 - s33_now_by*s64_now
        s395 = s23_now*s26_now_by + s26_now*s297 - s36_now*s388 - s36_now_by*s66_now
        s402 = R_22_now*s33_now_by + R_22_now_by*s33_now + s28_now*s381 + s28_now_by*s64_now
        s409 = s23_now*s36_now_by + s26_now*s388 + s26_now_by*s66_now + s297*s36_now
        s410 = -s262*turn_t_now
        s411 = s261*turn_t_now
        s423 = R_01_t_now*s262 + R_01_t_now_by*s9_now
        s424 = R_00_now*s410 + R_00_now_by*s78_now + R_00_t_now*s261 + R_00_t_now_by*s7_now + R_01_now*s411 + R_01_now_by*s82_now + s423
        s432 = R_02_now_by*slide_t_now + R_02_t_now*s2_now_by + R_02_t_now_by*along_z_now + along_x_now*s424 + along_x_now_by*s86_now + ox_t_now_by
        s444 = R_11_t_now*s262 + R_11_t_now_by*s9_now
        s445 = R_10_now*s410 + R_10_now_by*s78_now + R_10_t_now*s261 + R_10_t_now_by*s7_now + R_11_now*s411 + R_11_now_by*s82_now + s444
        s453 = R_12_now_by*slide_t_now + R_12_t_now*s2_now_by + R_12_t_now_by*along_z_now + along_x_now*s445 + along_x_now_by*s98_now + oy_t_now_by
        s465 = R_21_t_now*s262 + R_21_t_now_by*s9_now
        s466 = R_20_now*s410 + R_20_now_by*s78_now + R_20_t_now*s261 + R_20_t_now_by*s7_now + R_21_now*s411 + R_21_now_by*s82_now + s465
        s474 = R_22_now_by*slide_t_now + R_22_t_now*s2_now_by + R_22_t_now_by*along_z_now + along_x_now*s466 + along_x_now_by*s110_now + oz_t_now_by
        s486 = -R_00_t_now*s262 - R_00_t_now_by*s9_now
        s487 = -R_00_now*s411 - R_00_now_by*s82_now + R_01_now*s410 + R_01_now_by*s78_now + R_01_t_now*s261 + R_01_t_now_by*s7_now + s486
        s494 = R_02_t_now*s28_now_by + R_02_t_now_by*s28_now - s121_now*s33_now_by - s33_now*s487
        s501 = -s123_now*s36_now_by + s26_now*s424 + s26_now_by*s86_now - s36_now*s494
        s508 = R_02_t_now*s33_now_by + R_02_t_now_by*s33_now + s121_now*s28_now_by + s28_now*s487
        s515 = s123_now*s26_now_by + s26_now*s494 + s36_now*s424 + s36_now_by*s86_now
        s527 = -R_10_t_now*s262 - R_10_t_now_by*s9_now
        s528 = -R_10_now*s411 - R_10_now_by*s82_now + R_11_now*s410 + R_11_now_by*s78_now + R_11_t_now*s261 + R_11_t_now_by*s7_now + s527
        s535 = R_12_t_now*s28_now_by + R_12_t_now_by*s28_now - s140_now*s33_now_by - s33_now*s528
        s542 = -s142_now*s36_now_by + s26_now*s445 + s26_now_by*s98_now - s36_now*s535
        s549 = R_12_t_now*s33_now_by + R_12_t_now_by*s33_now + s140_now*s28_now_by + s28_now*s528
        s556 = s142_now*s26_now_by + s26_now*s535 + s36_now*s445 + s36_now_by*s98_now
        s568 = -R_20_t_now*s262 - R_20_t_now_by*s9_now
        s569 = -R_20_now*s411 - R_20_now_by*s82_now + R_21_now*s410 + R_21_now_by*s78_now + R_21_t_now*s261 + R_21_t_now_by*s7_now + s568
        s576 = R_22_t_now*s28_now_by + R_22_t_now_by*s28_now - s159_now*s33_now_by - s33_now*s569
        s583 = s110_now*s26_now_by - s161_now*s36_now_by + s26_now*s466 - s36_now*s576
        s590 = R_22_t_now*s33_now_by + R_22_t_now_by*s33_now + s159_now*s28_now_by + s28_now*s569
        s597 = s110_now*s36_now_by + s161_now*s26_now_by + s26_now*s576 + s36_now*s466
        s601 = -s262*turn_tt_now - s411*turn_t_now
        s607 = s261*turn_tt_now + s410*turn_t_now
        s612 = 2*R_01_t_now*s411 + 2*R_01_t_now_by*s82_now
        s615 = R_00_now*s601 + R_00_now_by*s178_now
        s618 = R_00_tt_now*s261 + R_00_tt_now_by*s7_now
        s621 = R_01_now*s607 + R_01_now_by*s187_now
        s624 = R_01_tt_now*s262 + R_01_tt_now_by*s9_now
        s625 = 2*R_00_t_now*s410 + 2*R_00_t_now_by*s78_now + s612 + s615 + s618 + s621 + s624
        s633 = along_x_now*s625 + along_x_now_by*s194_now
        s634 = R_02_now_by*slide_tt_now + 2*R_02_t_now_by*slide_t_now + R_02_tt_now*s2_now_by + R_02_tt_now_by*along_z_now + ox_tt_now_by + s633
        s643 = 2*R_11_t_now*s411 + 2*R_11_t_now_by*s82_now
        s646 = R_10_now*s601 + R_10_now_by*s178_now
        s649 = R_10_tt_now*s261 + R_10_tt_now_by*s7_now
        s652 = R_11_now*s607 + R_11_now_by*s187_now
        s655 = R_11_tt_now*s262 + R_11_tt_now_by*s9_now
        s656 = 2*R_10_t_now*s410 + 2*R_10_t_now_by*s78_now + s643 + s646 + s649 + s652 + s655
        s664 = along_x_now*s656 + along_x_now_by*s215_now
        s665 = R_12_now_by*slide_tt_now + 2*R_12_t_now_by*slide_t_now + R_12_tt_now*s2_now_by + R_12_tt_now_by*along_z_now + oy_tt_now_by + s664
        s674 = 2*R_21_t_now*s411 + 2*R_21_t_now_by*s82_now
        s677 = R_20_now*s601 + R_20_now_by*s178_now
        s680 = R_20_tt_now*s261 + R_20_tt_now_by*s7_now
        s683 = R_21_now*s607 + R_21_now_by*s187_now
        s686 = R_21_tt_now*s262 + R_21_tt_now_by*s9_now
        s687 = 2*R_20_t_now*s410 + 2*R_20_t_now_by*s78_now + s674 + s677 + s680 + s683 + s686
        s695 = along_x_now*s687 + along_x_now_by*s236_now
        s696 = R_22_now_by*slide_tt_now + 2*R_22_t_now_by*slide_t_now + R_22_tt_now*s2_now_by + R_22_tt_now_by*along_z_now + oz_tt_now_by + s695
        s704 = -2*R_00_t_now*s411 - 2*R_00_t_now_by*s82_now
        s707 = R_01_now*s601 + R_01_now_by*s178_now
        s710 = R_01_tt_now*s261 + R_01_tt_now_by*s7_now
        s713 = -R_00_now*s607 - R_00_now_by*s187_now
        s716 = -R_00_tt_now*s262 - R_00_tt_now_by*s9_now
        s717 = 2*R_01_t_now*s410 + 2*R_01_t_now_by*s78_now + s704 + s707 + s710 + s713 + s716
        s724 = R_02_tt_now*s28_now_by + R_02_tt_now_by*s28_now - s253_now*s33_now_by - s33_now*s717
        s731 = s194_now*s26_now_by - s255_now*s36_now_by + s26_now*s625 - s36_now*s724
        s738 = R_02_tt_now*s33_now_by + R_02_tt_now_by*s33_now + s253_now*s28_now_by + s28_now*s717
        s745 = s194_now*s36_now_by + s255_now*s26_now_by + s26_now*s724 + s36_now*s625
        s753 = -2*R_10_t_now*s411 - 2*R_10_t_now_by*s82_now
        s756 = R_11_now*s601 + R_11_now_by*s178_now
        s759 = R_11_tt_now*s261 + R_11_tt_now_by*s7_now
        s762 = -R_10_now*s607 - R_10_now_by*s187_now
        s765 = -R_10_tt_now*s262 - R_10_tt_now_by*s9_now
        s766 = 2*R_11_t_now*s410 + 2*R_11_t_now_by*s78_now + s753 + s756 + s759 + s762 + s765
        s773 = R_12_tt_now*s28_now_by + R_12_tt_now_by*s28_now - s278_now*s33_now_by - s33_now*s766
        s780 = s215_now*s26_now_by + s26_now*s656 - s280_now*s36_now_by - s36_now*s773
        s787 = R_12_tt_now*s33_now_by + R_12_tt_now_by*s33_now + s278_now*s28_now_by + s28_now*s766
        s794 = s215_now*s36_now_by + s26_now*s773 + s26_now_by*s280_now + s36_now*s656
        s802 = -2*R_20_t_now*s411 - 2*R_20_t_now_by*s82_now
        s805 = R_21_now*s601 + R_21_now_by*s178_now
        s808 = R_21_tt_now*s261 + R_21_tt_now_by*s7_now
        s811 = -R_20_now*s607 - R_20_now_by*s187_now
        s814 = -R_20_tt_now*s262 - R_20_tt_now_by*s9_now
        s815 = 2*R_21_t_now*s410 + 2*R_21_t_now_by*s78_now + s802 + s805 + s808 + s811 + s814
        s822 = R_22_tt_now*s28_now_by + R_22_tt_now_by*s28_now - s303_now*s33_now_by - s33_now*s815
        s829 = s236_now*s26_now_by + s26_now*s687 - s305_now*s36_now_by - s36_now*s822
        s836 = R_22_tt_now*s33_now_by + R_22_tt_now_by*s33_now + s28_now*s815 + s28_now_by*s303_now
        s843 = s236_now*s36_now_by + s26_now*s822 + s26_now_by*s305_now + s36_now*s687
        w_by[192 + lane] = s276
        w_by[224 + lane] = s290
        w_by[256 + lane] = s304
        w_by[288 + lane] = s325
        w_by[320 + lane] = s332
        w_by[352 + lane] = s339
        w_by[384 + lane] = s360
        w_by[416 + lane] = s367
        w_by[448 + lane] = s374
        w_by[480 + lane] = s395
        w_by[512 + lane] = s402
        w_by[544 + lane] = s409
        w_by[576 + lane] = s432
        w_by[608 + lane] = s453
        w_by[640 + lane] = s474
        w_by[672 + lane] = s501
        w_by[704 + lane] = s508
        w_by[736 + lane] = s515
        w_by[768 + lane] = s542
        w_by[800 + lane] = s549
        w_by[832 + lane] = s556
        w_by[864 + lane] = s583
        w_by[896 + lane] = s590
        w_by[928 + lane] = s597
        w_by[960 + lane] = s634
        w_by[992 + lane] = s665
        w_by[1024 + lane] = s696
        w_by[1056 + lane] = s731
        w_by[1088 + lane] = s738
        w_by[1120 + lane] = s745
        w_by[1152 + lane] = s780
        w_by[1184 + lane] = s787
        w_by[1216 + lane] = s794
        w_by[1248 + lane] = s829
        w_by[1280 + lane] = s836
        w_by[1312 + lane] = s843


@straight
def _axes_standard_by(w, w_by, n):
    """Rates of a link, standard convention: twists of all behind it by turn and slide of its joint (21 operations)."""
    for lane in range(n):
        ox_now = w[192 + lane]
        oy_now = w[224 + lane]
        oz_now = w[256 + lane]
        R_02_now = w[352 + lane]
        R_12_now = w[448 + lane]
        R_22_now = w[544 + lane]
        ox_now_by = w_by[192 + lane]
        oy_now_by = w_by[224 + lane]
        oz_now_by = w_by[256 + lane]
        R_02_now_by = w_by[352 + lane]
        R_12_now_by = w_by[448 + lane]
        R_22_now_by = w_by[544 + lane]
        s15 = -R_12_now*oz_now_by - R_12_now_by*oz_now + R_22_now*oy_now_by + R_22_now_by*oy_now
        s22 = R_02_now*oz_now_by + R_02_now_by*oz_now - R_22_now*ox_now_by - R_22_now_by*ox_now
        s29 = -R_02_now*oy_now_by - R_02_now_by*oy_now + R_12_now*ox_now_by + R_12_now_by*ox_now
        w_by[1984 + lane] = s15
        w_by[2016 + lane] = s22
        w_by[2048 + lane] = s29
        w_by[2080 + lane] = R_02_now_by
        w_by[2112 + lane] = R_12_now_by
        w_by[2144 + lane] = R_22_now_by
        w_by[2176 + lane] = R_02_now_by
        w_by[2208 + lane] = R_12_now_by
        w_by[2240 + lane] = R_22_now_by
        w_by[2272 + lane] = 0
        w_by[2304 + lane] = 0
        w_by[2336 + lane] = 0


@straight
def _move_modified_by(w, w_by, n):
    """Rates of a link, modified convention: its frame, and how that moves, by the one before (786 operations)."""
    for lane in range(n):
        turn_now = w[0 + lane]
        slide_now = w[32 + lane]
        turn_t_now = w[64 + lane]
        slide_t_now = w[96 + lane]
        turn_tt_now = w[128 + lane]
        slide_tt_now = w[160 + lane]
        R_00_now = w[288 + lane]
        R_01_now = w[320 + lane]
        R_02_now = w[352 + lane]
        R_10_now = w[384 + lane]
        R_11_now = w[416 + lane]
        R_12_now = w[448 + lane]
        R_20_now = w[480 + lane]
        R_21_now = w[512 + lane]
        R_22_now = w[544 + lane]
        R_00_t_now = w[672 + lane]
        R_01_t_now = w[704 + lane]
        R_02_t_now = w[736 + lane]
        R_10_t_now = w[768 + lane]
        R_11_t_now = w[800 + lane]
        R_12_t_now = w[832 + lane]
        R_20_t_now = w[864 + lane]
        R_21_t_now = w[896 + lane]
        R_22_t_now = w[928 + lane]
        R_00_tt_now = w[1056 + lane]
        R_01_tt_now = w[1088 + lane]
        R_02_tt_now = w[1120 + lane]
        R_10_tt_now = w[1152 + lane]
        R_11_tt_now = w[1184 + lane]
        R_12_tt_now = w[1216 + lane]
        R_20_tt_now = w[1248 + lane]
        R_21_tt_now = w[1280 + lane]
        R_22_tt_now = w[1312 + lane]
        s0_now = w[1344 + lane]
        s2_now = w[1376 + lane]
        along_x_now = w[1408 + lane]
        s26_now = w[1440 + lane]
        s28_now = w[1472 + lane]
        s33_now = w[1504 + lane]
        s36_now = w[1536 + lane]
        ox_now_by = w_by[192 + lane]
        oy_now_by = w_by[224 + lane]
        oz_now_by = w_by[256 + lane]
        R_00_now_by = w_by[288 + lane]
        R_01_now_by = w_by[320 + lane]
        R_02_now_by = w_by[352 + lane]
        R_10_now_by = w_by[384 + lane]
        R_11_now_by = w_by[416 + lane]
        R_12_now_by = w_by[448 + lane]
        R_20_now_by = w_by[480 + lane]
        R_21_now_by = w_by[512 + lane]
        R_22_now_by = w_by[544 + lane]
        ox_t_now_by = w_by[576 + lane]
        oy_t_now_by = w_by[608 + lane]
        oz_t_now_by = w_by[640 + lane]
        R_00_t_now_by = w_by[672 + lane]
        R_01_t_now_by = w_by[704 + lane]
        R_02_t_now_by = w_by[736 + lane]
        R_10_t_now_by = w_by[768 + lane]
        R_11_t_now_by = w_by[800 + lane]
        R_12_t_now_by = w_by[832 + lane]
        R_20_t_now_by = w_by[864 + lane]
        R_21_t_now_by = w_by[896 + lane]
        R_22_t_now_by = w_by[928 + lane]
        ox_tt_now_by = w_by[960 + lane]
        oy_tt_now_by = w_by[992 + lane]
        oz_tt_now_by = w_by[1024 + lane]
        R_00_tt_now_by = w_by[1056 + lane]
        R_01_tt_now_by = w_by[1088 + lane]
        R_02_tt_now_by = w_by[1120 + lane]
        R_10_tt_now_by = w_by[1152 + lane]
        R_11_tt_now_by = w_by[1184 + lane]
        R_12_tt_now_by = w_by[1216 + lane]
        R_20_tt_now_by = w_by[1248 + lane]
        R_21_tt_now_by = w_by[1280 + lane]
        R_22_tt_now_by = w_by[1312 + lane]
        s0_now_by = w_by[1344 + lane]
        s2_now_by = w_by[1376 + lane]
        along_x_now_by = w_by[1408 + lane]
        s26_now_by = w_by[1440 + lane]
        s28_now_by = w_by[1472 + lane]
        s33_now_by = w_by[1504 + lane]
        s36_now_by = w_by[1536 + lane]
        about_z_now = s0_now + turn_now
        along_z_now = s2_now + slide_now
        s7_now = cosine(about_z_now)
        s9_now = sine(about_z_now)
        s78_now = -s9_now*turn_t_now
        s82_now = s7_now*turn_t_now
        s178_now = -s82_now*turn_t_now - s9_now*turn_tt_now
        s187_now = s78_now*turn_t_now + s7_now*turn_tt_now
        s325_now = -R_01_now*s33_now + R_02_now*s28_now
        s327_now = R_00_now*s26_now - s325_now*s36_now
        s331_now = R_00_now*s36_now + s26_now*s325_now
        s336_now = -R_11_now*s33_now + R_12_now*s28_now
        s338_now = R_10_now*s26_now - s336_now*s36_now
        s342_now = R_10_now*s36_now + s26_now*s336_now
        s347_now = -R_21_now*s33_now + R_22_now*s28_now
        s349_now = R_20_now*s26_now - s347_now*s36_now
        s353_now = R_20_now*s36_now + s26_now*s347_now
        s358_now = R_01_now*s28_now + R_02_now*s33_now
        s366_now = R_11_now*s28_now + R_12_now*s33_now
        s374_now = R_21_now*s28_now + R_22_now*s33_now
        s625_now = -R_01_t_now*s33_now + R_02_t_now*s28_now
        s627_now = R_00_t_now*s26_now - s36_now*s625_now
        s631_now = R_00_t_now*s36_now + s26_now*s625_now
        s638_now = -R_11_t_now*s33_now + R_12_t_now*s28_now
        s640_now = R_10_t_now*s26_now - s36_now*s638_now
        s644_now = R_10_t_now*s36_now + s26_now*s638_now
        s651_now = -R_21_t_now*s33_now + R_22_t_now*s28_now
        s653_now = R_20_t_now*s26_now - s36_now*s651_now
        s657_now = R_20_t_now*s36_now + s26_now*s651_now
        s666_now = R_01_t_now*s28_now + R_02_t_now*s33_now
        s682_now = R_11_t_now*s28_now + R_12_t_now*s33_now
        s698_now = R_21_t_now*s28_now + R_22_t_now*s33_now
        s1169_now = -R_01_tt_now*s33_now + R_02_tt_now*s28_now
        s1171_now = R_00_tt_now*s26_now - s1169_now*s36_now
        s1175_now = R_00_tt_now*s36_now + s1169_now*s26_now
        s1185_now = -R_11_tt_now*s33_now + R_12_tt_now*s28_now
        s1187_now = R_10_tt_now*s26_now - s1185_now*s36_now
        s1191_now = R_10_tt_now*s36_now + s1185_now*s26_now
        s1201_now = -R_21_tt_now*s33_now + R_22_tt_now*s28_now
        s1203_now = R_20_tt_now*s26_now - s1201_now*s36_now
        s1207_now = R_20_tt_now*s36_now + s1201_now*s26_now
        s1222_now = R_01_tt_now*s28_now + R_02_tt_now*s33_now
        s1250_now = R_11_tt_now*s28_now + R_12_tt_now*s33_now
        s1278_now = R_21_tt_now*s28_now + R_22_tt_now*s33_now
        s261 = -s0_now_by*s9_now
        s262 = s0_now_by*s7_now
        s263 = -s262*turn_t_now
        s264 = s261*turn_t_now
        s267 = -s262*turn_tt_now - s264*turn_t_now
        s270 = s261*turn_tt_now + s263*turn_t_now
        s277 = -R_01_now*s33_now_by - R_01_now_by*s33_now + R_02_now*s28_now_by + R_02_now_by*s28_now
        s284 = R_00_now*s26_now_by + R_00_now_by*s26_now - s277*s36_now - s325_now*s36_now_by
        s291 = R_00_now*s36_now_by + R_00_now_by*s36_now + s26_now*s277 + s26_now_by*s325_now
        s298 = along_x_now*s284 + along_x_now_by*s327_now + along_z_now*s291 + ox_now_by + s2_now_by*s331_now
        s305 = -R_11_now*s33_now_by - R_11_now_by*s33_now + R_12_now*s28_now_by + R_12_now_by*s28_now
        s312 = R_10_now*s26_now_by + R_10_now_by*s26_now - s305*s36_now - s336_now*s36_now_by
        s319 = R_10_now*s36_now_by + R_10_now_by*s36_now + s26_now*s305 + s26_now_by*s336_now
        s326 = along_x_now*s312 + along_x_now_by*s338_now + along_z_now*s319 + oy_now_by + s2_now_by*s342_now
        s333 = -R_21_now*s33_now_by - R_21_now_by*s33_now + R_22_now*s28_now_by + R_22_now_by*s28_now
        s340 = R_20_now*s26_now_by + R_20_now_by*s26_now - s333*s36_now - s347_now*s36_now_by
        s347 = R_20_now*s36_now_by + R_20_now_by*s36_now + s26_now*s333 + s26_now_by*s347_now
        s354 = along_x_now*s340 + along_x_now_by*s349_now + along_z_now*s347 + oz_now_by + s2_now_by*s353_now
        s361 = R_01_now*s28_now_by + R_01_now_by*s28_now + R_02_now*s33_now_by + R_02_now_by*s33_now
        s368 = s261*s327_now + s262*s358_now + s284*s7_now + s361*s9_now
        s375 = s261*s358_now - s262*s327_now - s284*s9_now + s361*s7_now
        s382 = R_11_now*s28_now_by + R_11_now_by*s28_now + R_12_now*s33_now_by + R_12_now_by*s33_now
        s389 = s261*s338_now + s262*s366_now + s312*s7_now + s382*s9_now
        s396 = s261*s366_now - s262*s338_now - s312*s9_now + s382*s7_now
        s403 = R_21_now*s28_now_by + R_21_now_by*s28_now + R_22_now*s33_now_by + R_22_now_by*s33_now
        s410 = s261*s349_now + s262*s374_now + s340*s7_now + s403*s9_now
        s417 = s261*s374_now - s262*s349_now - s340*s9_now + s403*s7_now
        s424 = -R_01_t_now*s33_now_by - R_01_t_now_by*s33_now + R_02_t_now*s28_now_by + R_02_t_now_by*s28_now
        s431 = R_00_t_now*s26_now_by + R_00_t_now_by*s26_now - s36_now*s424 - s36_now_by*s625_now
        s438 = R_00_t_now*s36_now_by + R_00_t_now_by*s36_now + s26_now*s424 + s26_now_by*s625_now
        s446 = along_x_now*s431 + along_x_now_by*s627_now + along_z_now*s438 + ox_t_now_by + s291*slide_t_now + s2_now_by*s631_now
        s453 = -R_11_t_now*s33_now_by - R_11_t_now_by*s33_now + R_12_t_now*s28_now_by + R_12_t_now_by*s28_now
        s460 = R_10_t_now*s26_now_by + R_10_t_now_by*s26_now - s36_now*s453 - s36_now_by*s638_now
        s467 = R_10_t_now*s36_now_by + R_10_t_now_by*s36_now + s26_now*s453 + s26_now_by*s638_now
        s475 = along_x_now*s460 + along_x_now_by*s640_now + along_z_now*s467 + oy_t_now_by + s2_now_by*s644_now + s319*slide_t_now
        s482 = -R_21_t_now*s33_now_by - R_21_t_now_by*s33_now + R_22_t_now*s28_now_by + R_22_t_now_by*s28_now
        s489 = R_20_t_now*s26_now_by + R_20_t_now_by*s26_now - s36_now*s482 - s36_now_by*s651_now
        s496 = R_20_t_now*s36_now_by + R_20_t_now_by*s36_now + s26_now*s482 + s26_now_by*s651_now
        s504 = along_x_now*s489 + along_x_now_by*s653_now + along_z_now*s496 + oz_t_now_by + s2_now_by*s657_now + s347*slide_t_now
        s511 = R_01_t_now*s28_now_by + R_01_t_now_by*s28_now + R_02_t_now*s33_now_by + R_02_t_now_by*s33_now
        s523 = s262*s666_now + s511*s9_now
        s524 = s261*s627_now + s263*s327_now + s264*s358_now + s284*s78_now + s361*s82_now + s431*s7_now + s523
        s536 = -s262*s627_now - s431*s9_now
        s537 = s261*s666_now + s263*s358_now - s264*s327_now - s284*s82_now + s361*s78_now + s511*s7_now + s536
        s544 = R_11_t_now*s28_now_by + R_11_t_now_by*s28_now + R_12_t_now*s33_now_by + R_12_t_now_by*s33_now
        s556 = s262*s682_now + s544*s9_now
        s557 = s261*s640_now + s263*s338_now + s264*s366_now + s312*s78_now + s382*s82_now + s460*s7_now + s556
        s569 = -s262*s640_now - s460*s9_now
        s570 = s261*s682_now + s263*s366_now - s264*s338_now - s312*s82_now + s382*s78_now + s544*s7_now + s569
        s577 = R_21_t_now*s28_now_by + R_21_t_now_by*s28_now + R_22_t_now*s33_now_by + R_22_t_now_by*s33_now
        s589 = s262*s698_now + s577*s9_now
        s590 = s261*s653_now + s263*s349_now + s264*s374_now + s340*s78_now + s403*s82_now + s489*s7_now + s589
        s602 = -s262*s653_now - s489*s9_now
        s603 = s261*s698_now + s263*s374_now - s264*s349_now - s340*s82_now + s403*s78_now + s577*s7_now + s602
        s610 = -R_01_tt_now*s33_now_by - R_01_tt_now_by*s33_now + R_02_tt_now*s28_now_by + R_02_tt_now_by*s28_now
        s617 = R_00_tt_now*s26_now_by + R_00_tt_now_by*s26_now - s1169_now*s36_now_by - s36_now*s610
        s624 = R_00_tt_now*s36_now_by + R_00_tt_now_by*s36_now + s1169_now*s26_now_by + s26_now*s610
        s633 = s291*slide_tt_now
        s634 = along_x_now*s617 + along_x_now_by*s1171_now + along_z_now*s624 + ox_tt_now_by + s1175_now*s2_now_by + 2*s438*slide_t_now + s633
        s641 = -R_11_tt_now*s33_now_by - R_11_tt_now_by*s33_now + R_12_tt_now*s28_now_by + R_12_tt_now_by*s28_now
        s648 = R_10_tt_now*s26_now_by + R_10_tt_now_by*s26_now - s1185_now*s36_now_by - s36_now*s641
        s655 = R_10_tt_now*s36_now_by + R_10_tt_now_by*s36_now + s1185_now*s26_now_by + s26_now*s641
        s664 = s319*slide_tt_now
        s665 = along_x_now*s648 + along_x_now_by*s1187_now + along_z_now*s655 + oy_tt_now_by + s1191_now*s2_now_by + 2*s467*slide_t_now + s664
        s672 = -R_21_tt_now*s33_now_by - R_21_tt_now_by*s33_now + R_22_tt_now*s28_now_by + R_22_tt_now_by*s28_now
        s679 = R_20_tt_now*s26_now_by + R_20_tt_now_by*s26_now - s1201_now*s36_now_by - s36_now*s672
        s686 = R_20_tt_now*s36_now_by + R_20_tt_now_by*s36_now + s1201_now*s26_now_by + s26_now*s672
        s695 = s347*slide_tt_now
        s696 = along_x_now*s679 + along_x_now_by*s1203_now + along_z_now*s686 + oz_tt_now_by + s1207_now*s2_now_by + 2*s496*slide_t_now + s695
        s706 = R_01_tt_now*s28_now_by + R_01_tt_now_by*s28_now + R_02_tt_now*s33_now_by + R_02_tt_now_by*s33_now
        s711 = 2*s264*s666_now + 2*s511*s82_now
        s714 = s1171_now*s261 + s617*s7_now
        s717 = s1222_now*s262 + s706*s9_now
        s720 = s178_now*s284 + s267*s327_now
        s723 = s187_now*s361 + s270*s358_now
        s724 = 2*s263*s627_now + 2*s431*s78_now + s711 + s714 + s717 + s720 + s723
        s732 = -2*s264*s627_now - 2*s431*s82_now
        s735 = s1222_now*s261 + s706*s7_now
        s738 = s178_now*s361 + s267*s358_now
        s741 = -s1171_now*s262 - s617*s9_now
        s744 = -s187_now*s284 - s270*s327_now
        s745 = 2*s263*s666_now + 2*s511*s78_now + s732 + s735 + s738 + s741 + s744
        s755 = R_11_tt_now*s28_now_by + R_11_tt_now_by*s28_now + R_12_tt_now*s33_now_by + R_12_tt_now_by*s33_now
        s760 = 2*s264*s682_now + 2*s544*s82_now
        s763 = s1187_now*s261 + s648*s7_now
        s766 = s1250_now*s262 + s755*s9_now
        s769 = s178_now*s312 + s267*s338_now
        s772 = s187_now*s382 + s270*s366_now
        s773 = 2*s263*s640_now + 2*s460*s78_now + s760 + s763 + s766 + s769 + s772
        s781 = -2*s264*s640_now - 2*s460*s82_now
        s784 = s1250_now*s261 + s755*s7_now
        s787 = s178_now*s382 + s267*s366_now
        s790 = -s1187_now*s262 - s648*s9_now
        s793 = -s187_now*s312 - s270*s338_now
        s794 = 2*s263*s682_now + 2*s544*s78_now + s781 + s784 + s787 + s790 + s793
        s804 = R_21_tt_now*s28_now_by + R_21_tt_now_by*s28_now + R_22_tt_now*s33_now_by + R_22_tt_now_by*s33_now
        s809 = 2*s264*s698_now + 2*s577*s82_now
        s812 = s1203_now*s261 + s679*s7_now
        s815 = s1278_now*s262 + s804*s9_now
        s818 = s178_now*s340 + s267*s349_now
        s821 = s187_now*s403 + s270*s374_now
        s822 = 2*s263*s653_now + 2*s489*s78_now + s809 + s812 + s815 + s818 + s821
        s830 = -2*s264*s653_now - 2*s489*s82_now
        s833 = s1278_now*s261 + s7_now*s804
        s836 = s178_now*s403 + s267*s374_now
        s839 = -s1203_now*s262 - s679*s9_now
        s842 = -s187_now*s340 - s270*s349_now
        s843 = 2*s263*s698_now + 2*s577*s78_now + s830 + s833 + s836 + s839 + s842
        w_by[192 + lane] = s298
        w_by[224 + lane] = s326
        w_by[256 + lane] = s354
        w_by[288 + lane] = s368
        w_by[320 + lane] = s375
        w_by[352 + lane] = s291
        w_by[384 + lane] = s389
        w_by[416 + lane] = s396
        w_by[448 + lane] = s319
        w_by[480 + lane] = s410
        w_by[512 + lane] = s417
        w_by[544 + lane] = s347
        w_by[576 + lane] = s446
        w_by[608 + lane] = s475
        w_by[640 + lane] = s504
        w_by[672 + lane] = s524
        w_by[704 + lane] = s537
        w_by[736 + lane] = s438
        w_by[768 + lane] = s557
        w_by[800 + lane] = s570
        w_by[832 + lane] = s467
        w_by[864 + lane] = s590
        w_by[896 + lane] = s603
        w_by[928 + lane] = s496
        w_by[960 + lane] = s634
        w_by[992 + lane] = s665
        w_by[1024 + lane] = s696
        w_by[1056 + lane] = s724
        w_by[1088 + lane] = s745
        w_by[1120 + lane] = s624
        w_by[1152 + lane] = s773
        w_by[1184 + lane] = s794
        w_by[1216 + lane] = s655
        w_by[1248 + lane] = s822
        w_by[1280 + lane] = s843
        w_by[1312 + lane] = s686


@straight
def _axes_modified_by(w, w_by, n):
    """Rates of a link, modified convention: twists of all behind it by turn and slide of its joint (135 operations)."""
    for lane in range(n):
        ox_now = w[192 + lane]
        oy_now = w[224 + lane]
        oz_now = w[256 + lane]
        R_00_now = w[288 + lane]
        R_01_now = w[320 + lane]
        R_02_now = w[352 + lane]
        R_10_now = w[384 + lane]
        R_11_now = w[416 + lane]
        R_12_now = w[448 + lane]
        R_20_now = w[480 + lane]
        R_21_now = w[512 + lane]
        R_22_now = w[544 + lane]
        along_x_now = w[1408 + lane]
        s26_now = w[1440 + lane]
        s28_now = w[1472 + lane]
        s33_now = w[1504 + lane]
        s36_now = w[1536 + lane]
        ox_now_by = w_by[192 + lane]
        oy_now_by = w_by[224 + lane]
        oz_now_by = w_by[256 + lane]
        R_00_now_by = w_by[288 + lane]
        R_01_now_by = w_by[320 + lane]
        R_02_now_by = w_by[352 + lane]
        R_10_now_by = w_by[384 + lane]
        R_11_now_by = w_by[416 + lane]
        R_12_now_by = w_by[448 + lane]
        R_20_now_by = w_by[480 + lane]
        R_21_now_by = w_by[512 + lane]
        R_22_now_by = w_by[544 + lane]
        along_x_now_by = w_by[1408 + lane]
        s26_now_by = w_by[1440 + lane]
        s28_now_by = w_by[1472 + lane]
        s33_now_by = w_by[1504 + lane]
        s36_now_by = w_by[1536 + lane]
        s325_now = -R_01_now*s33_now + R_02_now*s28_now
        s331_now = R_00_now*s36_now + s26_now*s325_now
        s336_now = -R_11_now*s33_now + R_12_now*s28_now
        s342_now = R_10_now*s36_now + s26_now*s336_now
        s347_now = -R_21_now*s33_now + R_22_now*s28_now
        s353_now = R_20_now*s36_now + s26_now*s347_now
        s20 = R_20_now*s26_now - s347_now*s36_now
        s1299_now = -along_x_now*s20 - oz_now
        s25 = R_10_now*s26_now - s336_now*s36_now
        s1301_now = -along_x_now*s25 - oy_now
        s33 = R_00_now*s26_now - s325_now*s36_now
        s1304_now = -along_x_now*s33 - ox_now
        s48 = -R_01_now*s33_now_by - R_01_now_by*s33_now + R_02_now*s28_now_by + R_02_now_by*s28_now
        s55 = R_00_now*s36_now_by + R_00_now_by*s36_now + s26_now*s48 + s26_now_by*s325_now
        s62 = -R_11_now*s33_now_by - R_11_now_by*s33_now + R_12_now*s28_now_by + R_12_now_by*s28_now
        s69 = R_10_now*s36_now_by + R_10_now_by*s36_now + s26_now*s62 + s26_now_by*s336_now
        s76 = -R_21_now*s33_now_by - R_21_now_by*s33_now + R_22_now*s28_now_by + R_22_now_by*s28_now
        s83 = R_20_now*s36_now_by + R_20_now_by*s36_now + s26_now*s76 + s26_now_by*s347_now
        s94 = -along_x_now*(R_20_now*s26_now_by + R_20_now_by*s26_now - s347_now*s36_now_by - s36_now*s76) - along_x_now_by*s20 - oz_now_by
        s105 = -along_x_now*(R_10_now*s26_now_by + R_10_now_by*s26_now - s336_now*s36_now_by - s36_now*s62) - along_x_now_by*s25 - oy_now_by
        s112 = -s105*s353_now + s1299_now*s69 - s1301_now*s83 + s342_now*s94
        s123 = -along_x_now*(R_00_now*s26_now_by + R_00_now_by*s26_now - s325_now*s36_now_by - s36_now*s48) - along_x_now_by*s33 - ox_now_by
        s130 = s123*s353_now - s1299_now*s55 + s1304_now*s83 - s331_now*s94
        s137 = s105*s331_now - s123*s342_now + s1301_now*s55 - s1304_now*s69
        w_by[1984 + lane] = s112
        w_by[2016 + lane] = s130
        w_by[2048 + lane] = s137
        w_by[2080 + lane] = s55
        w_by[2112 + lane] = s69
        w_by[2144 + lane] = s83
        w_by[2176 + lane] = s55
        w_by[2208 + lane] = s69
        w_by[2240 + lane] = s83
        w_by[2272 + lane] = 0
        w_by[2304 + lane] = 0
        w_by[2336 + lane] = 0


@straight
def _ask_by(w, w_by, n):
    """Rates of force that a body asks for, and its moment about {O} (439 operations)."""
    for lane in range(n):
        ox_now = w[192 + lane]
        oy_now = w[224 + lane]
        oz_now = w[256 + lane]
        R_00_now = w[288 + lane]
        R_01_now = w[320 + lane]
        R_02_now = w[352 + lane]
        R_10_now = w[384 + lane]
        R_11_now = w[416 + lane]
        R_12_now = w[448 + lane]
        R_20_now = w[480 + lane]
        R_21_now = w[512 + lane]
        R_22_now = w[544 + lane]
        ox_tt_now = w[960 + lane]
        oy_tt_now = w[992 + lane]
        oz_tt_now = w[1024 + lane]
        R_00_tt_now = w[1056 + lane]
        R_01_tt_now = w[1088 + lane]
        R_02_tt_now = w[1120 + lane]
        R_10_tt_now = w[1152 + lane]
        R_11_tt_now = w[1184 + lane]
        R_12_tt_now = w[1216 + lane]
        R_20_tt_now = w[1248 + lane]
        R_21_tt_now = w[1280 + lane]
        R_22_tt_now = w[1312 + lane]
        m_now = w[1568 + lane]
        m_x_now = w[1600 + lane]
        m_y_now = w[1632 + lane]
        m_z_now = w[1664 + lane]
        ixx_now = w[1696 + lane]
        iyy_now = w[1728 + lane]
        izz_now = w[1760 + lane]
        ixy_now = w[1792 + lane]
        ixz_now = w[1824 + lane]
        iyz_now = w[1856 + lane]
        gx_now = w[1888 + lane]
        gy_now = w[1920 + lane]
        gz_now = w[1952 + lane]
        ox_now_by = w_by[192 + lane]
        oy_now_by = w_by[224 + lane]
        oz_now_by = w_by[256 + lane]
        R_00_now_by = w_by[288 + lane]
        R_01_now_by = w_by[320 + lane]
        R_02_now_by = w_by[352 + lane]
        R_10_now_by = w_by[384 + lane]
        R_11_now_by = w_by[416 + lane]
        R_12_now_by = w_by[448 + lane]
        R_20_now_by = w_by[480 + lane]
        R_21_now_by = w_by[512 + lane]
        R_22_now_by = w_by[544 + lane]
        ox_tt_now_by = w_by[960 + lane]
        oy_tt_now_by = w_by[992 + lane]
        oz_tt_now_by = w_by[1024 + lane]
        R_00_tt_now_by = w_by[1056 + lane]
        R_01_tt_now_by = w_by[1088 + lane]
        R_02_tt_now_by = w_by[1120 + lane]
        R_10_tt_now_by = w_by[1152 + lane]
        R_11_tt_now_by = w_by[1184 + lane]
        R_12_tt_now_by = w_by[1216 + lane]
        R_20_tt_now_by = w_by[1248 + lane]
        R_21_tt_now_by = w_by[1280 + lane]
        R_22_tt_now_by = w_by[1312 + lane]
        s1312_now = -gx_now + 0.001*ox_tt_now
        s1317_now = 0.001*R_00_tt_now*m_x_now + 0.001*R_01_tt_now*m_y_now + 0.001*R_02_tt_now*m_z_now + m_now*s1312_now
        s1319_now = -gy_now + 0.001*oy_tt_now
        s1324_now = 0.001*R_10_tt_now*m_x_now + 0.001*R_11_tt_now*m_y_now + 0.001*R_12_tt_now*m_z_now + m_now*s1319_now
        s1326_now = -gz_now + 0.001*oz_tt_now
        s1331_now = 0.001*R_20_tt_now*m_x_now + 0.001*R_21_tt_now*m_y_now + 0.001*R_22_tt_now*m_z_now + m_now*s1326_now
        s1336_now = -R_20_now*m_x_now - R_21_now*m_y_now - R_22_now*m_z_now
        s1341_now = R_10_now*m_x_now + R_11_now*m_y_now + R_12_now*m_z_now
        s1349_now = 0.5*R_20_now*ixx_now - 0.5*R_20_now*iyy_now - 0.5*R_20_now*izz_now + R_21_now*ixy_now + R_22_now*ixz_now
        s1356_now = R_20_now*ixy_now - 0.5*R_21_now*ixx_now + 0.5*R_21_now*iyy_now - 0.5*R_21_now*izz_now + R_22_now*iyz_now
        s1363_now = R_20_now*ixz_now + R_21_now*iyz_now - 0.5*R_22_now*ixx_now - 0.5*R_22_now*iyy_now + 0.5*R_22_now*izz_now
        s1370_now = -0.5*R_10_now*ixx_now + 0.5*R_10_now*iyy_now + 0.5*R_10_now*izz_now - R_11_now*ixy_now - R_12_now*ixz_now
        s1377_now = -R_10_now*ixy_now + 0.5*R_11_now*ixx_now - 0.5*R_11_now*iyy_now + 0.5*R_11_now*izz_now - R_12_now*iyz_now
        s1384_now = -R_10_now*ixz_now - R_11_now*iyz_now + 0.5*R_12_now*ixx_now + 0.5*R_12_now*iyy_now - 0.5*R_12_now*izz_now
        s1392_now = -R_00_now*m_x_now - R_01_now*m_y_now - R_02_now*m_z_now
        s1403_now = 0.5*R_00_now*ixx_now - 0.5*R_00_now*iyy_now - 0.5*R_00_now*izz_now + R_01_now*ixy_now + R_02_now*ixz_now
        s1410_now = R_00_now*ixy_now - 0.5*R_01_now*ixx_now + 0.5*R_01_now*iyy_now - 0.5*R_01_now*izz_now + R_02_now*iyz_now
        s1417_now = R_00_now*ixz_now + R_01_now*iyz_now - 0.5*R_02_now*ixx_now - 0.5*R_02_now*iyy_now + 0.5*R_02_now*izz_now
        s120 = 0.001*ox_tt_now_by
        s122 = 0.001*m_x_now
        s123 = 0.001*R_00_tt_now
        s125 = 0.001*m_y_now
        s126 = 0.001*R_01_tt_now
        s128 = 0.001*m_z_now
        s129 = 0.001*R_02_tt_now
        s131 = R_00_tt_now_by*s122 + R_01_tt_now_by*s125 + R_02_tt_now_by*s128 + m_now*s120
        s132 = 0.001*oy_tt_now_by
        s134 = 0.001*R_10_tt_now
        s136 = 0.001*R_11_tt_now
        s138 = 0.001*R_12_tt_now
        s140 = R_10_tt_now_by*s122 + R_11_tt_now_by*s125 + R_12_tt_now_by*s128 + m_now*s132
        s141 = 0.001*oz_tt_now_by
        s143 = 0.001*R_20_tt_now
        s145 = 0.001*R_21_tt_now
        s147 = 0.001*R_22_tt_now
        s149 = R_20_tt_now_by*s122 + R_21_tt_now_by*s125 + R_22_tt_now_by*s128 + m_now*s141
        s153 = -R_20_now_by*m_x_now - R_21_now_by*m_y_now - R_22_now_by*m_z_now
        s157 = R_10_now_by*m_x_now + R_11_now_by*m_y_now + R_12_now_by*m_z_now
        s163 = 0.5*ixx_now
        s166 = -0.5*iyy_now
        s168 = -0.5*izz_now
        s170 = R_20_now_by*s163 + R_20_now_by*s166 + R_20_now_by*s168 + R_21_now_by*ixy_now + R_22_now_by*ixz_now
        s171 = 0.001*s1349_now
        s174 = R_10_tt_now_by*s171 + s134*s170
        s181 = R_20_now_by*ixy_now - R_21_now_by*s163 - R_21_now_by*s166 + R_21_now_by*s168 + R_22_now_by*iyz_now
        s182 = 0.001*s1356_now
        s185 = R_11_tt_now_by*s182 + s136*s181
        s192 = R_20_now_by*ixz_now + R_21_now_by*iyz_now - R_22_now_by*s163 + R_22_now_by*s166 - R_22_now_by*s168
        s193 = 0.001*s1363_now
        s196 = R_12_tt_now_by*s193 + s138*s192
        s203 = -R_10_now_by*s163 - R_10_now_by*s166 - R_10_now_by*s168 - R_11_now_by*ixy_now - R_12_now_by*ixz_now
        s204 = 0.001*s1370_now
        s207 = R_20_tt_now_by*s204 + s143*s203
        s214 = -R_10_now_by*ixy_now + R_11_now_by*s163 + R_11_now_by*s166 - R_11_now_by*s168 - R_12_now_by*iyz_now
        s215 = 0.001*s1377_now
        s218 = R_21_tt_now_by*s215 + s145*s214
        s225 = -R_10_now_by*ixz_now - R_11_now_by*iyz_now + R_12_now_by*s163 - R_12_now_by*s166 + R_12_now_by*s168
        s226 = 0.001*s1384_now
        s229 = R_22_tt_now_by*s226 + s147*s225
        s232 = oy_now*s149 + oy_now_by*s1331_now
        s235 = s1319_now*s153 + s132*s1336_now
        s238 = s1326_now*s157 + s1341_now*s141
        s239 = -oz_now*s140 - oz_now_by*s1324_now + s174 + s185 + s196 + s207 + s218 + s229 + s232 + s235 + s238
        s243 = -R_00_now_by*m_x_now - R_01_now_by*m_y_now - R_02_now_by*m_z_now
        s249 = -R_00_tt_now_by*s171 - s123*s170
        s252 = -R_01_tt_now_by*s182 - s126*s181
        s255 = -R_02_tt_now_by*s193 - s129*s192
        s262 = R_00_now_by*s163 + R_00_now_by*s166 + R_00_now_by*s168 + R_01_now_by*ixy_now + R_02_now_by*ixz_now
        s263 = 0.001*s1403_now
        s266 = R_20_tt_now_by*s263 + s143*s262
        s273 = R_00_now_by*ixy_now - R_01_now_by*s163 - R_01_now_by*s166 + R_01_now_by*s168 + R_02_now_by*iyz_now
        s274 = 0.001*s1410_now
        s277 = R_21_tt_now_by*s274 + s145*s273
        s284 = R_00_now_by*ixz_now + R_01_now_by*iyz_now - R_02_now_by*s163 + R_02_now_by*s166 - R_02_now_by*s168
        s285 = 0.001*s1417_now
        s288 = R_22_tt_now_by*s285 + s147*s284
        s291 = oz_now*s131 + oz_now_by*s1317_now
        s294 = s1326_now*s243 + s1392_now*s141
        s297 = -s120*s1336_now - s1312_now*s153
        s298 = -ox_now*s149 - ox_now_by*s1331_now + s249 + s252 + s255 + s266 + s277 + s288 + s291 + s294 + s297
        s304 = -R_00_tt_now_by*s204 - s123*s203
        s307 = -R_01_tt_now_by*s215 - s126*s214
        s310 = -R_02_tt_now_by*s226 - s129*s225
        s313 = -R_10_tt_now_by*s263 - s134*s262
        s316 = -R_11_tt_now_by*s274 - s136*s273
        s319 = -R_12_tt_now_by*s285 - s138*s284
        s322 = ox_now*s140 + ox_now_by*s1324_now
        s325 = -s120*s1341_now - s1312_now*s157
        s328 = -s1319_now*s243 - s132*s1392_now
        s329 = -oy_now*s131 - oy_now_by*s1317_now + s304 + s307 + s310 + s313 + s316 + s319 + s322 + s325 + s328
        w_by[2560 + lane] = s131
        w_by[2592 + lane] = s140
        w_by[2624 + lane] = s149
        w_by[2656 + lane] = s239
        w_by[2688 + lane] = s298
        w_by[2720 + lane] = s329


@straight
def _give_by(w, w_by, n):
    """Rates of what a joint gives to what is asked behind it (23 operations)."""
    for lane in range(n):
        fx_now = w[2560 + lane]
        fy_now = w[2592 + lane]
        fz_now = w[2624 + lane]
        mx_now = w[2656 + lane]
        my_now = w[2688 + lane]
        mz_now = w[2720 + lane]
        ux_now = w[2368 + lane]
        uy_now = w[2400 + lane]
        uz_now = w[2432 + lane]
        wx_now = w[2464 + lane]
        wy_now = w[2496 + lane]
        wz_now = w[2528 + lane]
        fx_now_by = w_by[2560 + lane]
        fy_now_by = w_by[2592 + lane]
        fz_now_by = w_by[2624 + lane]
        mx_now_by = w_by[2656 + lane]
        my_now_by = w_by[2688 + lane]
        mz_now_by = w_by[2720 + lane]
        ux_now_by = w_by[2368 + lane]
        uy_now_by = w_by[2400 + lane]
        uz_now_by = w_by[2432 + lane]
        wx_now_by = w_by[2464 + lane]
        wy_now_by = w_by[2496 + lane]
        wz_now_by = w_by[2528 + lane]
        s15 = fz_now*uz_now_by + fz_now_by*uz_now
        s18 = mx_now*wx_now_by + mx_now_by*wx_now
        s21 = my_now*wy_now_by + my_now_by*wy_now
        s24 = mz_now*wz_now_by + mz_now_by*wz_now
        s25 = fx_now*ux_now_by + fx_now_by*ux_now + fy_now*uy_now_by + fy_now_by*uy_now + s15 + s18 + s21 + s24
        w_by[4672 + lane] = s25


@straight
def _hold(w_by, n):
    """Begin with a base that no error moves."""
    for lane in range(n):
        w_by[192 + lane] = 0.0
        w_by[224 + lane] = 0.0
        w_by[256 + lane] = 0.0
        w_by[288 + lane] = 0.0
        w_by[320 + lane] = 0.0
        w_by[352 + lane] = 0.0
        w_by[384 + lane] = 0.0
        w_by[416 + lane] = 0.0
        w_by[448 + lane] = 0.0
        w_by[480 + lane] = 0.0
        w_by[512 + lane] = 0.0
        w_by[544 + lane] = 0.0
        w_by[576 + lane] = 0.0
        w_by[608 + lane] = 0.0
        w_by[640 + lane] = 0.0
        w_by[672 + lane] = 0.0
        w_by[704 + lane] = 0.0
        w_by[736 + lane] = 0.0
        w_by[768 + lane] = 0.0
        w_by[800 + lane] = 0.0
        w_by[832 + lane] = 0.0
        w_by[864 + lane] = 0.0
        w_by[896 + lane] = 0.0
        w_by[928 + lane] = 0.0
        w_by[960 + lane] = 0.0
        w_by[992 + lane] = 0.0
        w_by[1024 + lane] = 0.0
        w_by[1056 + lane] = 0.0
        w_by[1088 + lane] = 0.0
        w_by[1120 + lane] = 0.0
        w_by[1152 + lane] = 0.0
        w_by[1184 + lane] = 0.0
        w_by[1216 + lane] = 0.0
        w_by[1248 + lane] = 0.0
        w_by[1280 + lane] = 0.0
        w_by[1312 + lane] = 0.0


@fast
def _torque_by(motion, inertia, gravity, k, k_by, conventions, drives, much, tau):
    q = motion[0]
    links, joints = k.shape[1], q.shape[1]
    w, axes, bodies = scratch(WORK), scratch(much.size * AXIS), scratch(links * ASKED)
    w_by, axes_by, bodies_by = scratch(WORK), scratch(much.size * AXIS), scratch(links * ASKED)
    states, constants, masses, torques = (
        motion.reshape(motion.size), k.reshape(k.size), inertia.reshape(inertia.size), tau.reshape(tau.size)
    )
    slopes, of = k_by.reshape(k_by.size), np.zeros(len(q), dtype=np.int64)
    tau[:] = 0.0
    for e in range(len(k_by)):
        found, own = torques[e * len(q) * joints :], slopes[e * links * 7 :]
        for first in range(0, len(q), LANES):
            last = min(first + LANES, len(q)) - 1
            n = (last - first + 8) // 8 * 8
            _begin(gravity, w, n)
            _hold(w_by, n)
            row = 0
            for link in range(links):
                _own(constants, of, w, link, links, first, last, n)
                _own(own, of, w_by, link, links, first, last, n)
                _rest(w, n)
                at = row
                while row < much.size and drives[row, 0] == link:
                    for order in range(3):
                        _drive(
                            states[order * len(q) * joints :], much[row:], w, 2 * order + drives[row, 1],
                            drives[row, 2], joints, first, last, n,
                        )
                    row += 1
                if conventions[link] == 0:
                    _axes_standard_by(w, w_by, n)
                    _axes_standard(w, n)
                elif conventions[link] == 1:
                    _axes_modified_by(w, w_by, n)
                    _axes_modified(w, n)
                for d in range(at, row):
                    _keep_axis(w, axes[AXIS * d :], drives[d, 1], n)
                    _keep_axis(w_by, axes_by[AXIS * d :], drives[d, 1], n)
                if conventions[link] == 0:
                    _move_standard_by(w, w_by, n)
                    _move_standard(w, n)
                elif conventions[link] == 1:
                    _move_modified_by(w, w_by, n)
                    _move_modified(w, n)
                _weigh(masses[10 * link :], w, n)
                _ask_by(w, w_by, n)
                _ask(w, n)
                _keep_asked(w, bodies[ASKED * link :], n)
                _keep_asked(w_by, bodies_by[ASKED * link :], n)
            _nothing(w, n)
            _nothing(w_by, n)
            for link in range(links - 1, -1, -1):
                _also(w, bodies[ASKED * link :], n)
                _also(w_by, bodies_by[ASKED * link :], n)
                while row > 0 and drives[row - 1, 0] == link:
                    row -= 1
                    _take_axis(w, axes[AXIS * row :], n)
                    _take_axis(w_by, axes_by[AXIS * row :], n)
                    _give_by(w, w_by, n)
                    _pay(w_by, much[row:], found, drives[row, 2], joints, first, last)


def torque_by(motion, inertia, gravity, k, k_by, conventions, drives, much, tau):
    """Fill tau (E, N, n_q) [N mm, N]: how `torque` of one machine changes, its joints held, along each of E errors.

    k_by (E, links, 7) is what `constants_by` makes of them.
    """
    _torque_by(motion, inertia, gravity, k, k_by, conventions, drives, much, tau)

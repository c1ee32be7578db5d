"""Dynamics of `serial`, many samples at once: Open chain of revolute and prismatic joints.

Generated from derive/mechanisms/serial.py by "deltacal kernels". Do not edit.
Template templates/chain/dynamics.py.jinja; sha256 of both 4c8f0426c0ad0ade; SymPy 1.14.0.

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

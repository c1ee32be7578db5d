"""Kinematics of `serial`, many poses at once: Open chain of revolute and prismatic joints.

Generated from derive/mechanisms/serial.py by "deltacal kernels". Do not edit.
Template templates/chain/kinematics.py.jinja; sha256 of both 66e67b577f52b09c; SymPy 1.14.0.

Arrays are C-contiguous float64, the pose first, lengths in mm, angles in rad:

q (N, n_q)  joints        tool (N or 1, 3)  reference point in the last frame
x (N, 12)  its position, rotation matrix of the last frame row by row
k (M, links, 10)  what `constants` makes of p; each of the M machines has N / M of the poses, one after the other
conventions (links,)  of each link, by their number in ``parameters.CONVENTIONS``
drives (n, 3), much (n,)  link, variable (0 its turn, 1 its slide), joint: by how much a joint moves a link;
    link by link

Poses are taken in blocks of up to 32, side by side: a loop over `lane` runs over the poses of a block. Links of
one robot file differ in nothing but these arrays, so that what is compiled serves every chain.
"""

import numpy as np

from deltacal_kernels.cache import kernel
from deltacal_kernels.elementary import cosine, scratch, sine
from deltacal_kernels.straight import straight

LANES = 32  # poses of a block
WORK = 2592  # numbers that a block computes with
FRAME = 384  # and those of the frames of a block
fast = kernel(nogil=True, error_model="numpy", fastmath={"contract"})


@straight
def _fill(p, k, rows):
    """Fill what no pose changes of the links of all machines (8 operations a link)."""
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
        dtx = p[12 * lane + 9]
        dty = p[12 * lane + 10]
        dtz = p[12 * lane + 11]
        s0 = dtheta + theta
        s2 = d + dd
        along_x = a + da
        about_x = alpha + dalpha
        s26 = cosine(dbeta)
        s28 = cosine(about_x)
        s33 = sine(about_x)
        s36 = sine(dbeta)
        k[10 * lane + 0] = s0
        k[10 * lane + 1] = s2
        k[10 * lane + 2] = along_x
        k[10 * lane + 3] = s26
        k[10 * lane + 4] = s28
        k[10 * lane + 5] = s33
        k[10 * lane + 6] = s36
        k[10 * lane + 7] = dtx
        k[10 * lane + 8] = dty
        k[10 * lane + 9] = dtz


@fast
def _constants(p, k):
    _fill(p, k, p.shape[0] * p.shape[1])


def constants(p):
    """Return k (M, links, 10), what no pose changes of a link, from p (M, links, 12)."""
    p = np.ascontiguousarray(p, dtype=float)
    k = np.empty((*p.shape[:2], 10))
    _constants(p, k)
    return k


@straight
def _place_standard(w, n):
    """A link, standard convention: its frame by the one before (70 operations)."""
    for lane in range(n):
        turn = w[0 + lane]
        slide = w[32 + lane]
        ox = w[160 + lane]
        oy = w[192 + lane]
        oz = w[224 + lane]
        R_00 = w[256 + lane]
        R_01 = w[288 + lane]
        R_02 = w[320 + lane]
        R_10 = w[352 + lane]
        R_11 = w[384 + lane]
        R_12 = w[416 + lane]
        R_20 = w[448 + lane]
        R_21 = w[480 + lane]
        R_22 = w[512 + lane]
        s0 = w[1888 + lane]
        s2 = w[1920 + lane]
        along_x = w[1952 + lane]
        s26 = w[1984 + lane]
        s28 = w[2016 + lane]
        s33 = w[2048 + lane]
        s36 = w[2080 + lane]
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
        w[160 + lane] = s13
        w[192 + lane] = s19
        w[224 + lane] = s25
        w[256 + lane] = s38
        w[288 + lane] = s41
        w[320 + lane] = s44
        w[352 + lane] = s53
        w[384 + lane] = s56
        w[416 + lane] = s59
        w[448 + lane] = s68
        w[480 + lane] = s71
        w[512 + lane] = s74


@straight
def _reach_standard(w, n):
    """A link, standard convention: its frame; shift of a point behind it and turn, by each error, by turn and slide of the joint (115 operations)."""
    for lane in range(n):
        turn = w[0 + lane]
        slide = w[32 + lane]
        ox = w[160 + lane]
        oy = w[192 + lane]
        oz = w[224 + lane]
        R_00 = w[256 + lane]
        R_01 = w[288 + lane]
        R_02 = w[320 + lane]
        R_10 = w[352 + lane]
        R_11 = w[384 + lane]
        R_12 = w[416 + lane]
        R_20 = w[448 + lane]
        R_21 = w[480 + lane]
        R_22 = w[512 + lane]
        px = w[64 + lane]
        py = w[96 + lane]
        pz = w[128 + lane]
        s0 = w[1888 + lane]
        s2 = w[1920 + lane]
        along_x = w[1952 + lane]
        s26 = w[1984 + lane]
        s28 = w[2016 + lane]
        s33 = w[2048 + lane]
        s36 = w[2080 + lane]
        about_z = s0 + turn
        along_z = s2 + slide
        s6 = R_02*along_z
        s7 = cosine(about_z)
        s9 = sine(about_z)
        s11 = R_00*s7 + R_01*s9
        s12 = along_x*s11
        s13 = ox + s12 + s6
        s14 = R_12*along_z
        s17 = R_10*s7 + R_11*s9
        s18 = along_x*s17
        s19 = oy + s14 + s18
        s20 = R_22*along_z
        s23 = R_20*s7 + R_21*s9
        s24 = along_x*s23
        s25 = oz + s20 + s24
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
        s75 = -oz + pz - s20
        s77 = -oy + py - s14
        s79 = s17*s75 - s23*s77
        s80 = -ox + px - s6
        s83 = -s11*s75 + s23*s80
        s86 = s11*s77 - s17*s80
        s87 = -oz + pz
        s89 = -oy + py
        s91 = R_12*s87 - R_22*s89
        s92 = -ox + px
        s95 = -R_02*s87 + R_22*s92
        s98 = R_02*s89 - R_12*s92
        s99 = -oz + pz - s20 - s24
        s101 = -oy + py - s14 - s18
        s103 = -s101*s71 + s56*s99
        s104 = -ox + px - s12 - s6
        s107 = s104*s71 - s41*s99
        s110 = s101*s41 - s104*s56
        w[160 + lane] = s13
        w[192 + lane] = s19
        w[224 + lane] = s25
        w[256 + lane] = s38
        w[288 + lane] = s41
        w[320 + lane] = s44
        w[352 + lane] = s53
        w[384 + lane] = s56
        w[416 + lane] = s59
        w[448 + lane] = s68
        w[480 + lane] = s71
        w[512 + lane] = s74
        w[544 + lane] = s11
        w[576 + lane] = s17
        w[608 + lane] = s23
        w[640 + lane] = 0
        w[672 + lane] = 0
        w[704 + lane] = 0
        w[736 + lane] = s79
        w[768 + lane] = s83
        w[800 + lane] = s86
        w[832 + lane] = s11
        w[864 + lane] = s17
        w[896 + lane] = s23
        w[928 + lane] = R_02
        w[960 + lane] = R_12
        w[992 + lane] = R_22
        w[1024 + lane] = 0
        w[1056 + lane] = 0
        w[1088 + lane] = 0
        w[1120 + lane] = s91
        w[1152 + lane] = s95
        w[1184 + lane] = s98
        w[1216 + lane] = R_02
        w[1248 + lane] = R_12
        w[1280 + lane] = R_22
        w[1312 + lane] = s103
        w[1344 + lane] = s107
        w[1376 + lane] = s110
        w[1408 + lane] = s41
        w[1440 + lane] = s56
        w[1472 + lane] = s71
        w[1504 + lane] = s91
        w[1536 + lane] = s95
        w[1568 + lane] = s98
        w[1600 + lane] = R_02
        w[1632 + lane] = R_12
        w[1664 + lane] = R_22
        w[1696 + lane] = R_02
        w[1728 + lane] = R_12
        w[1760 + lane] = R_22
        w[1792 + lane] = 0
        w[1824 + lane] = 0
        w[1856 + lane] = 0


@straight
def _exert_standard(w, n):
    """A link, standard convention: work of the load of all that it carries by each error, by turn and slide of its joint (119 operations)."""
    for lane in range(n):
        turn = w[0 + lane]
        slide = w[32 + lane]
        ox = w[160 + lane]
        oy = w[192 + lane]
        oz = w[224 + lane]
        R_00 = w[256 + lane]
        R_01 = w[288 + lane]
        R_02 = w[320 + lane]
        R_10 = w[352 + lane]
        R_11 = w[384 + lane]
        R_12 = w[416 + lane]
        R_20 = w[448 + lane]
        R_21 = w[480 + lane]
        R_22 = w[512 + lane]
        fx = w[2208 + lane]
        fy = w[2240 + lane]
        fz = w[2272 + lane]
        mx = w[2304 + lane]
        my = w[2336 + lane]
        mz = w[2368 + lane]
        s0 = w[1888 + lane]
        s2 = w[1920 + lane]
        along_x = w[1952 + lane]
        s28 = w[2016 + lane]
        s33 = w[2048 + lane]
        about_z = s0 + turn
        along_z = s2 + slide
        s6 = R_02*along_z
        s7 = cosine(about_z)
        s9 = sine(about_z)
        s11 = R_00*s7 + R_01*s9
        s13 = along_x*s11 + ox + s6
        s14 = R_12*along_z
        s17 = R_10*s7 + R_11*s9
        s19 = along_x*s17 + oy + s14
        s20 = R_22*along_z
        s23 = R_20*s7 + R_21*s9
        s25 = along_x*s23 + oz + s20
        s41 = R_02*s33 + s28*(-R_00*s9 + R_01*s7)
        s56 = R_12*s33 + s28*(-R_10*s9 + R_11*s7)
        s71 = R_22*s33 + s28*(-R_20*s9 + R_21*s7)
        s114 = fx*s11 + fy*s17 + fz*s23
        s115 = -oz - s20
        s117 = -oy - s14
        s121 = -ox - s6
        s125 = fy*(-s11*s115 + s121*s23)
        s129 = fz*(s11*s117 - s121*s17)
        s133 = fx*(s115*s17 - s117*s23) + mx*s11 + my*s17 + mz*s23 + s125 + s129
        s137 = R_02*fx + R_12*fy + R_22*fz
        s148 = fy*(R_02*oz - R_22*ox)
        s152 = fz*(-R_02*oy + R_12*ox)
        s153 = R_02*mx + R_12*my + R_22*mz + fx*(-R_12*oz + R_22*oy) + s148 + s152
        s161 = fy*(-s13*s71 + s25*s41)
        s165 = fz*(s13*s56 - s19*s41)
        s169 = fx*(s19*s71 - s25*s56) + mx*s41 + my*s56 + mz*s71 + s161 + s165
        w[544 + lane] = s114
        w[576 + lane] = s133
        w[608 + lane] = s137
        w[640 + lane] = s153
        w[672 + lane] = s169
        w[704 + lane] = s153
        w[736 + lane] = s137


@straight
def _place_modified(w, n):
    """A link, modified convention: its frame by the one before (70 operations)."""
    for lane in range(n):
        turn = w[0 + lane]
        slide = w[32 + lane]
        ox = w[160 + lane]
        oy = w[192 + lane]
        oz = w[224 + lane]
        R_00 = w[256 + lane]
        R_01 = w[288 + lane]
        R_02 = w[320 + lane]
        R_10 = w[352 + lane]
        R_11 = w[384 + lane]
        R_12 = w[416 + lane]
        R_20 = w[448 + lane]
        R_21 = w[480 + lane]
        R_22 = w[512 + lane]
        s0 = w[1888 + lane]
        s2 = w[1920 + lane]
        along_x = w[1952 + lane]
        s26 = w[1984 + lane]
        s28 = w[2016 + lane]
        s33 = w[2048 + lane]
        s36 = w[2080 + lane]
        about_z = s0 + turn
        along_z = s2 + slide
        s7 = cosine(about_z)
        s9 = sine(about_z)
        s172 = -R_01*s33 + R_02*s28
        s174 = R_00*s26 - s172*s36
        s178 = R_00*s36 + s172*s26
        s180 = along_x*s174 + along_z*s178 + ox
        s183 = -R_11*s33 + R_12*s28
        s185 = R_10*s26 - s183*s36
        s189 = R_10*s36 + s183*s26
        s191 = along_x*s185 + along_z*s189 + oy
        s194 = -R_21*s33 + R_22*s28
        s196 = R_20*s26 - s194*s36
        s200 = R_20*s36 + s194*s26
        s202 = along_x*s196 + along_z*s200 + oz
        s205 = R_01*s28 + R_02*s33
        s207 = s174*s7 + s205*s9
        s210 = -s174*s9 + s205*s7
        s213 = R_11*s28 + R_12*s33
        s215 = s185*s7 + s213*s9
        s218 = -s185*s9 + s213*s7
        s221 = R_21*s28 + R_22*s33
        s223 = s196*s7 + s221*s9
        s226 = -s196*s9 + s221*s7
        w[160 + lane] = s180
        w[192 + lane] = s191
        w[224 + lane] = s202
        w[256 + lane] = s207
        w[288 + lane] = s210
        w[320 + lane] = s178
        w[352 + lane] = s215
        w[384 + lane] = s218
        w[416 + lane] = s189
        w[448 + lane] = s223
        w[480 + lane] = s226
        w[512 + lane] = s200


@straight
def _reach_modified(w, n):
    """A link, modified convention: its frame; shift of a point behind it and turn, by each error, by turn and slide of the joint (106 operations)."""
    for lane in range(n):
        turn = w[0 + lane]
        slide = w[32 + lane]
        ox = w[160 + lane]
        oy = w[192 + lane]
        oz = w[224 + lane]
        R_00 = w[256 + lane]
        R_01 = w[288 + lane]
        R_02 = w[320 + lane]
        R_10 = w[352 + lane]
        R_11 = w[384 + lane]
        R_12 = w[416 + lane]
        R_20 = w[448 + lane]
        R_21 = w[480 + lane]
        R_22 = w[512 + lane]
        px = w[64 + lane]
        py = w[96 + lane]
        pz = w[128 + lane]
        s0 = w[1888 + lane]
        s2 = w[1920 + lane]
        along_x = w[1952 + lane]
        s26 = w[1984 + lane]
        s28 = w[2016 + lane]
        s33 = w[2048 + lane]
        s36 = w[2080 + lane]
        about_z = s0 + turn
        along_z = s2 + slide
        s7 = cosine(about_z)
        s9 = sine(about_z)
        s87 = -oz + pz
        s89 = -oy + py
        s92 = -ox + px
        s172 = -R_01*s33 + R_02*s28
        s174 = R_00*s26 - s172*s36
        s175 = along_x*s174
        s178 = R_00*s36 + s172*s26
        s180 = along_z*s178 + ox + s175
        s183 = -R_11*s33 + R_12*s28
        s185 = R_10*s26 - s183*s36
        s186 = along_x*s185
        s189 = R_10*s36 + s183*s26
        s191 = along_z*s189 + oy + s186
        s194 = -R_21*s33 + R_22*s28
        s196 = R_20*s26 - s194*s36
        s197 = along_x*s196
        s200 = R_20*s36 + s194*s26
        s202 = along_z*s200 + oz + s197
        s205 = R_01*s28 + R_02*s33
        s207 = s174*s7 + s205*s9
        s210 = -s174*s9 + s205*s7
        s213 = R_11*s28 + R_12*s33
        s215 = s185*s7 + s213*s9
        s218 = -s185*s9 + s213*s7
        s221 = R_21*s28 + R_22*s33
        s223 = s196*s7 + s221*s9
        s226 = -s196*s9 + s221*s7
        s229 = R_10*s87 - R_20*s89
        s232 = -R_00*s87 + R_20*s92
        s235 = R_00*s89 - R_10*s92
        s236 = -oz + pz - s197
        s238 = -oy + py - s186
        s240 = s189*s236 - s200*s238
        s241 = -ox + px - s175
        s244 = -s178*s236 + s200*s241
        s247 = s178*s238 - s189*s241
        s250 = s213*s87 - s221*s89
        s253 = -s205*s87 + s221*s92
        s256 = s205*s89 - s213*s92
        w[160 + lane] = s180
        w[192 + lane] = s191
        w[224 + lane] = s202
        w[256 + lane] = s207
        w[288 + lane] = s210
        w[320 + lane] = s178
        w[352 + lane] = s215
        w[384 + lane] = s218
        w[416 + lane] = s189
        w[448 + lane] = s223
        w[480 + lane] = s226
        w[512 + lane] = s200
        w[544 + lane] = s174
        w[576 + lane] = s185
        w[608 + lane] = s196
        w[640 + lane] = 0
        w[672 + lane] = 0
        w[704 + lane] = 0
        w[736 + lane] = s229
        w[768 + lane] = s232
        w[800 + lane] = s235
        w[832 + lane] = R_00
        w[864 + lane] = R_10
        w[896 + lane] = R_20
        w[928 + lane] = s178
        w[960 + lane] = s189
        w[992 + lane] = s200
        w[1024 + lane] = 0
        w[1056 + lane] = 0
        w[1088 + lane] = 0
        w[1120 + lane] = s240
        w[1152 + lane] = s244
        w[1184 + lane] = s247
        w[1216 + lane] = s178
        w[1248 + lane] = s189
        w[1280 + lane] = s200
        w[1312 + lane] = s250
        w[1344 + lane] = s253
        w[1376 + lane] = s256
        w[1408 + lane] = s205
        w[1440 + lane] = s213
        w[1472 + lane] = s221
        w[1504 + lane] = s240
        w[1536 + lane] = s244
        w[1568 + lane] = s247
        w[1600 + lane] = s178
        w[1632 + lane] = s189
        w[1664 + lane] = s200
        w[1696 + lane] = s178
        w[1728 + lane] = s189
        w[1760 + lane] = s200
        w[1792 + lane] = 0
        w[1824 + lane] = 0
        w[1856 + lane] = 0


@straight
def _exert_modified(w, n):
    """A link, modified convention: work of the load of all that it carries by each error, by turn and slide of its joint (115 operations)."""
    for lane in range(n):
        ox = w[160 + lane]
        oy = w[192 + lane]
        oz = w[224 + lane]
        R_00 = w[256 + lane]
        R_01 = w[288 + lane]
        R_02 = w[320 + lane]
        R_10 = w[352 + lane]
        R_11 = w[384 + lane]
        R_12 = w[416 + lane]
        R_20 = w[448 + lane]
        R_21 = w[480 + lane]
        R_22 = w[512 + lane]
        fx = w[2208 + lane]
        fy = w[2240 + lane]
        fz = w[2272 + lane]
        mx = w[2304 + lane]
        my = w[2336 + lane]
        mz = w[2368 + lane]
        along_x = w[1952 + lane]
        s26 = w[1984 + lane]
        s28 = w[2016 + lane]
        s33 = w[2048 + lane]
        s36 = w[2080 + lane]
        s172 = -R_01*s33 + R_02*s28
        s174 = R_00*s26 - s172*s36
        s178 = R_00*s36 + s172*s26
        s183 = -R_11*s33 + R_12*s28
        s185 = R_10*s26 - s183*s36
        s189 = R_10*s36 + s183*s26
        s194 = -R_21*s33 + R_22*s28
        s196 = R_20*s26 - s194*s36
        s200 = R_20*s36 + s194*s26
        s205 = R_01*s28 + R_02*s33
        s213 = R_11*s28 + R_12*s33
        s221 = R_21*s28 + R_22*s33
        s260 = fx*s174 + fy*s185 + fz*s196
        s271 = fy*(R_00*oz - R_20*ox)
        s275 = fz*(-R_00*oy + R_10*ox)
        s276 = R_00*mx + R_10*my + R_20*mz + fx*(-R_10*oz + R_20*oy) + s271 + s275
        s280 = fx*s178 + fy*s189 + fz*s200
        s281 = -along_x*s196 - oz
        s283 = -along_x*s185 - oy
        s287 = -along_x*s174 - ox
        s291 = fy*(-s178*s281 + s200*s287)
        s295 = fz*(s178*s283 - s189*s287)
        s299 = fx*(s189*s281 - s200*s283) + mx*s178 + my*s189 + mz*s200 + s291 + s295
        s307 = fy*(-ox*s221 + oz*s205)
        s311 = fz*(ox*s213 - oy*s205)
        s315 = fx*(oy*s221 - oz*s213) + mx*s205 + my*s213 + mz*s221 + s307 + s311
        w[544 + lane] = s260
        w[576 + lane] = s276
        w[608 + lane] = s280
        w[640 + lane] = s299
        w[672 + lane] = s315
        w[704 + lane] = s299
        w[736 + lane] = s280


@straight
def _tip(w, n):
    """Position of the tool point by the last frame (21 operations)."""
    for lane in range(n):
        ox = w[160 + lane]
        oy = w[192 + lane]
        oz = w[224 + lane]
        R_00 = w[256 + lane]
        R_01 = w[288 + lane]
        R_02 = w[320 + lane]
        R_10 = w[352 + lane]
        R_11 = w[384 + lane]
        R_12 = w[416 + lane]
        R_20 = w[448 + lane]
        R_21 = w[480 + lane]
        R_22 = w[512 + lane]
        tx = w[64 + lane]
        ty = w[96 + lane]
        tz = w[128 + lane]
        dtx = w[2112 + lane]
        dty = w[2144 + lane]
        dtz = w[2176 + lane]
        s316 = dtx + tx
        s318 = dty + ty
        s320 = dtz + tz
        s322 = R_00*s316 + R_01*s318 + R_02*s320 + ox
        s326 = R_10*s316 + R_11*s318 + R_12*s320 + oy
        s330 = R_20*s316 + R_21*s318 + R_22*s320 + oz
        w[64 + lane] = s322
        w[96 + lane] = s326
        w[128 + lane] = s330


@straight
def _reach_tip(w, n):
    """Shift of the tool point and turn by each error of the tool (0 operations)."""
    for lane in range(n):
        R_00 = w[256 + lane]
        R_01 = w[288 + lane]
        R_02 = w[320 + lane]
        R_10 = w[352 + lane]
        R_11 = w[384 + lane]
        R_12 = w[416 + lane]
        R_20 = w[448 + lane]
        R_21 = w[480 + lane]
        R_22 = w[512 + lane]
        w[544 + lane] = R_00
        w[576 + lane] = R_10
        w[608 + lane] = R_20
        w[640 + lane] = 0
        w[672 + lane] = 0
        w[704 + lane] = 0
        w[736 + lane] = R_01
        w[768 + lane] = R_11
        w[800 + lane] = R_21
        w[832 + lane] = 0
        w[864 + lane] = 0
        w[896 + lane] = 0
        w[928 + lane] = R_02
        w[960 + lane] = R_12
        w[992 + lane] = R_22
        w[1024 + lane] = 0
        w[1056 + lane] = 0
        w[1088 + lane] = 0


@straight
def _centre(w, n):
    """Where a link's weight acts, by its frame (18 operations)."""
    for lane in range(n):
        ox = w[160 + lane]
        oy = w[192 + lane]
        oz = w[224 + lane]
        R_00 = w[256 + lane]
        R_01 = w[288 + lane]
        R_02 = w[320 + lane]
        R_10 = w[352 + lane]
        R_11 = w[384 + lane]
        R_12 = w[416 + lane]
        R_20 = w[448 + lane]
        R_21 = w[480 + lane]
        R_22 = w[512 + lane]
        cx = w[64 + lane]
        cy = w[96 + lane]
        cz = w[128 + lane]
        s334 = R_00*cx + R_01*cy + R_02*cz + ox
        s338 = R_10*cx + R_11*cy + R_12*cz + oy
        s342 = R_20*cx + R_21*cy + R_22*cz + oz
        w[64 + lane] = s334
        w[96 + lane] = s338
        w[128 + lane] = s342


@straight
def _moment(w, n):
    """Moment about {O} of a force at a point (9 operations)."""
    for lane in range(n):
        px = w[64 + lane]
        py = w[96 + lane]
        pz = w[128 + lane]
        fx = w[2400 + lane]
        fy = w[2432 + lane]
        fz = w[2464 + lane]
        s345 = -fy*pz + fz*py
        s348 = fx*pz - fz*px
        s351 = -fx*py + fy*px
        w[2496 + lane] = s345
        w[2528 + lane] = s348
        w[2560 + lane] = s351


@straight
def _begin(w, n):
    """Begin with the frame of the base."""
    for lane in range(n):
        w[160 + lane] = 0.0
        w[192 + lane] = 0.0
        w[224 + lane] = 0.0
        w[256 + lane] = 1.0
        w[288 + lane] = 0.0
        w[320 + lane] = 0.0
        w[352 + lane] = 0.0
        w[384 + lane] = 1.0
        w[416 + lane] = 0.0
        w[448 + lane] = 0.0
        w[480 + lane] = 0.0
        w[512 + lane] = 1.0


@straight
def _rest(w, n):
    """Leave a link's joint at zero."""
    for lane in range(n):
        w[0 + lane] = 0.0
        w[32 + lane] = 0.0


@straight
def _drive(q, much, w, variable, j, joints, first, last, n):
    """Move a link's joint by one of the chain's, the last pose again for the rest of `n`."""
    for lane in range(n):
        m = min(first + lane, last)
        w[32 * (0 + variable) + lane] += much[0] * q[joints * m + j]


@straight
def _own(k, of, w, link, links, first, last, n):
    """Put what no pose changes of a link side by side, of the machine that stands at each pose."""
    for lane in range(n):
        at = 10 * (links * of[min(first + lane, last)] + link)
        w[1888 + lane] = k[at + 0]
        w[1920 + lane] = k[at + 1]
        w[1952 + lane] = k[at + 2]
        w[1984 + lane] = k[at + 3]
        w[2016 + lane] = k[at + 4]
        w[2048 + lane] = k[at + 5]
        w[2080 + lane] = k[at + 6]
        w[2112 + lane] = k[at + 7]
        w[2144 + lane] = k[at + 8]
        w[2176 + lane] = k[at + 9]


@fast
def _prepare(q, k, of, drives, much, w, link, at, links, joints, first, last, n):
    """Make a link ready: what it is, and how its joint stands; return the row of `drives` where the next one begins."""
    _own(k, of, w, link, links, first, last, n)
    _rest(w, n)
    while at < much.size and drives[at, 0] == link:
        _drive(q, much[at:], w, drives[at, 1], drives[at, 2], joints, first, last, n)
        at += 1
    return at


@straight
def _hold(points, w, width, first, last, n):
    """Put points of poses side by side, the last one again for the rest of `n`."""
    for lane in range(n):
        m = min(first + lane, last)
        w[64 + lane] = points[width * m + 0]
        w[96 + lane] = points[width * m + 1]
        w[128 + lane] = points[width * m + 2]


@straight
def _pick(points, forces, w, at, poses, first, last, n):
    """Put a weight's point and force side by side."""
    for lane in range(n):
        m = min(first + lane, last)
        w[64 + lane] = points[(at + 0) * poses + m]
        w[2400 + lane] = forces[(at + 0) * poses + m]
        w[96 + lane] = points[(at + 1) * poses + m]
        w[2432 + lane] = forces[(at + 1) * poses + m]
        w[128 + lane] = points[(at + 2) * poses + m]
        w[2464 + lane] = forces[(at + 2) * poses + m]


@straight
def _unladen(w, n):
    """Begin without a load."""
    for lane in range(n):
        w[2208 + lane] = 0.0
        w[2240 + lane] = 0.0
        w[2272 + lane] = 0.0
        w[2304 + lane] = 0.0
        w[2336 + lane] = 0.0
        w[2368 + lane] = 0.0


@straight
def _burden(w, n):
    """Add a force and its moment to the load."""
    for lane in range(n):
        w[2208 + lane] += w[2400 + lane]
        w[2240 + lane] += w[2432 + lane]
        w[2272 + lane] += w[2464 + lane]
        w[2304 + lane] += w[2496 + lane]
        w[2336 + lane] += w[2528 + lane]
        w[2368 + lane] += w[2560 + lane]


@straight
def _keep(w, frames):
    """Keep the present frames."""
    for j in range(384):
        frames[j] = w[160 + j]


@straight
def _return(w, frames):
    """Go back to frames that were kept."""
    for j in range(384):
        w[160 + j] = frames[j]


@straight
def _unload(w, x, first, last):
    """Write the poses."""
    for lane in range(last - first + 1):
        x[12 * (first + lane) + 0] = w[64 + lane]
        x[12 * (first + lane) + 1] = w[96 + lane]
        x[12 * (first + lane) + 2] = w[128 + lane]
        x[12 * (first + lane) + 3] = w[256 + lane]
        x[12 * (first + lane) + 4] = w[288 + lane]
        x[12 * (first + lane) + 5] = w[320 + lane]
        x[12 * (first + lane) + 6] = w[352 + lane]
        x[12 * (first + lane) + 7] = w[384 + lane]
        x[12 * (first + lane) + 8] = w[416 + lane]
        x[12 * (first + lane) + 9] = w[448 + lane]
        x[12 * (first + lane) + 10] = w[480 + lane]
        x[12 * (first + lane) + 11] = w[512 + lane]


@straight
def _spread(w, S, at, width, first, last):
    """Write the twists by the errors of a link, which stand in columns of S from `at` on."""
    for lane in range(last - first + 1):
        row = 6 * width * (first + lane) + at
        S[row + 0 * width + 0] = w[544 + lane]
        S[row + 0 * width + 1] = w[736 + lane]
        S[row + 0 * width + 2] = w[928 + lane]
        S[row + 0 * width + 3] = w[1120 + lane]
        S[row + 0 * width + 4] = w[1312 + lane]
        S[row + 1 * width + 0] = w[576 + lane]
        S[row + 1 * width + 1] = w[768 + lane]
        S[row + 1 * width + 2] = w[960 + lane]
        S[row + 1 * width + 3] = w[1152 + lane]
        S[row + 1 * width + 4] = w[1344 + lane]
        S[row + 2 * width + 0] = w[608 + lane]
        S[row + 2 * width + 1] = w[800 + lane]
        S[row + 2 * width + 2] = w[992 + lane]
        S[row + 2 * width + 3] = w[1184 + lane]
        S[row + 2 * width + 4] = w[1376 + lane]
        S[row + 3 * width + 0] = w[640 + lane]
        S[row + 3 * width + 1] = w[832 + lane]
        S[row + 3 * width + 2] = w[1024 + lane]
        S[row + 3 * width + 3] = w[1216 + lane]
        S[row + 3 * width + 4] = w[1408 + lane]
        S[row + 4 * width + 0] = w[672 + lane]
        S[row + 4 * width + 1] = w[864 + lane]
        S[row + 4 * width + 2] = w[1056 + lane]
        S[row + 4 * width + 3] = w[1248 + lane]
        S[row + 4 * width + 4] = w[1440 + lane]
        S[row + 5 * width + 0] = w[704 + lane]
        S[row + 5 * width + 1] = w[896 + lane]
        S[row + 5 * width + 2] = w[1088 + lane]
        S[row + 5 * width + 3] = w[1280 + lane]
        S[row + 5 * width + 4] = w[1472 + lane]


@straight
def _spread_tip(w, S, at, width, first, last):
    """Write the twists by the errors of the tool, which stand in columns of S from `at` on."""
    for lane in range(last - first + 1):
        row = 6 * width * (first + lane) + at
        S[row + 0 * width + 0] = w[544 + lane]
        S[row + 0 * width + 1] = w[736 + lane]
        S[row + 0 * width + 2] = w[928 + lane]
        S[row + 1 * width + 0] = w[576 + lane]
        S[row + 1 * width + 1] = w[768 + lane]
        S[row + 1 * width + 2] = w[960 + lane]
        S[row + 2 * width + 0] = w[608 + lane]
        S[row + 2 * width + 1] = w[800 + lane]
        S[row + 2 * width + 2] = w[992 + lane]
        S[row + 3 * width + 0] = w[640 + lane]
        S[row + 3 * width + 1] = w[832 + lane]
        S[row + 3 * width + 2] = w[1024 + lane]
        S[row + 4 * width + 0] = w[672 + lane]
        S[row + 4 * width + 1] = w[864 + lane]
        S[row + 4 * width + 2] = w[1056 + lane]
        S[row + 5 * width + 0] = w[704 + lane]
        S[row + 5 * width + 1] = w[896 + lane]
        S[row + 5 * width + 2] = w[1088 + lane]


@straight
def _add(w, much, S, variable, j, joints, first, last):
    """Add to the columns of the chain's joints how one of them moves all that is behind a link."""
    for lane in range(last - first + 1):
        row = 6 * joints * (first + lane) + j
        S[row + 0 * joints] += much[0] * w[32 * (6 * variable + 47) + lane]
        S[row + 1 * joints] += much[0] * w[32 * (6 * variable + 48) + lane]
        S[row + 2 * joints] += much[0] * w[32 * (6 * variable + 49) + lane]
        S[row + 3 * joints] += much[0] * w[32 * (6 * variable + 50) + lane]
        S[row + 4 * joints] += much[0] * w[32 * (6 * variable + 51) + lane]
        S[row + 5 * joints] += much[0] * w[32 * (6 * variable + 52) + lane]


@fast
def _forward(q, tool, k, conventions, drives, much, x):
    w, given, found, constants, tools = (
        scratch(WORK), q.reshape(q.size), x.reshape(x.size), k.reshape(k.size), tool.reshape(tool.size)
    )
    links, joints = k.shape[1], q.shape[1]
    of = np.arange(len(q)) // (len(q) // k.shape[0])  # the machine that stands at each pose
    for first in range(0, len(q), LANES):
        last = min(first + LANES, len(q)) - 1
        n = (last - first + 8) // 8 * 8
        _begin(w, n)
        row = 0
        for link in range(links):
            at, row = row, _prepare(given, constants, of, drives, much, w, link, row, links, joints, first, last, n)
            if conventions[link] == 0:
                _place_standard(w, n)
            elif conventions[link] == 1:
                _place_modified(w, n)
        _hold(tools, w, 3 if len(tool) > 1 else 0, first, last, n)
        _tip(w, n)
        _unload(w, found, first, last)


def forward(q, tool, k, conventions, drives, much, x):
    """Fill the poses x at joints q."""
    _forward(q, tool, k, conventions, drives, much, x)


@fast
def _sensitivity(x, q, k, conventions, drives, much, S_p, S_q):
    w, given, points, constants = scratch(WORK), q.reshape(q.size), x.reshape(x.size), k.reshape(k.size)
    by_errors, by_joints = S_p.reshape(S_p.size), S_q.reshape(S_q.size)
    links, joints, width = k.shape[1], q.shape[1], S_p.shape[2]
    S_q[:] = 0.0
    of = np.arange(len(q)) // (len(q) // k.shape[0])  # the machine that stands at each pose
    for first in range(0, len(q), LANES):
        last = min(first + LANES, len(q)) - 1
        n = (last - first + 8) // 8 * 8
        _begin(w, n)
        row = 0
        for link in range(links):
            at, row = row, _prepare(given, constants, of, drives, much, w, link, row, links, joints, first, last, n)
            if link == 0:
                _hold(points, w, 12, first, last, n)
            if conventions[link] == 0:
                _reach_standard(w, n)
            elif conventions[link] == 1:
                _reach_modified(w, n)
            _spread(w, by_errors, 5 * link, width, first, last)
            for d in range(at, row):
                _add(w, much[d:], by_joints, drives[d, 1], drives[d, 2], joints, first, last)
        _reach_tip(w, n)
        _spread_tip(w, by_errors, 5 * links, width, first, last)


def sensitivity(x, q, k, conventions, drives, much, S_p, S_q):
    """Fill the derivatives of the exact pose: S_p (N, 6, 5 links + 3) by errors, S_q (N, 6, n_q) by joints.

    Rows are the shift of the reference point and the turn of the last frame along the axes of {O}. Columns of S_p run
    link by link, those of the tool stand last. S_q is the velocity Jacobian.
    """
    _sensitivity(x, q, k, conventions, drives, much, S_p, S_q)


@straight
def _unload_point(w, points, at, poses, first, last):
    """Write points, poses last."""
    for lane in range(last - first + 1):
        points[(at + 0) * poses + first + lane] = w[64 + lane]
        points[(at + 1) * poses + first + lane] = w[96 + lane]
        points[(at + 2) * poses + first + lane] = w[128 + lane]


@fast
def _centres(q, k, conventions, drives, much, own, found):
    w, given, constants, places, points = (
        scratch(WORK), q.reshape(q.size), k.reshape(k.size), own.reshape(own.size), found.reshape(found.size)
    )
    links, joints = k.shape[1], q.shape[1]
    of = np.arange(len(q)) // (len(q) // k.shape[0])  # the machine that stands at each pose
    for first in range(0, len(q), LANES):
        last = min(first + LANES, len(q)) - 1
        n = (last - first + 8) // 8 * 8
        _begin(w, n)
        row = 0
        for link in range(links):
            at, row = row, _prepare(given, constants, of, drives, much, w, link, row, links, joints, first, last, n)
            if conventions[link] == 0:
                _place_standard(w, n)
            elif conventions[link] == 1:
                _place_modified(w, n)
            _hold(places[3 * link :], w, 0, 0, 0, n)
            _centre(w, n)
            _unload_point(w, points, 3 * link, len(q), first, last)


def centres(q, k, conventions, drives, much, own):
    """Return where the links' weights act (links, 3, N), by their places `own` (links, 3, 1) in the links' frames."""
    found = np.empty((len(own), 3, len(q)))
    _centres(q, k, conventions, drives, much, own, found)
    return found


@straight
def _felt(w, along, at, width, first, last):
    """Write what a load does along the errors of a link."""
    for lane in range(last - first + 1):
        along[width * (first + lane) + at + 0] = w[544 + lane]
        along[width * (first + lane) + at + 1] = w[576 + lane]
        along[width * (first + lane) + at + 2] = w[608 + lane]
        along[width * (first + lane) + at + 3] = w[640 + lane]
        along[width * (first + lane) + at + 4] = w[672 + lane]


@straight
def _pull(w, much, torque, variable, j, joints, first, last):
    """Add what a load does along a link's joint to the torque of the chain's."""
    for lane in range(last - first + 1):
        torque[joints * (first + lane) + j] += much[0] * w[32 * (variable + 22) + lane]


@straight
def _carried(w, moment, first, last):
    """Write the moment of all weights."""
    for lane in range(last - first + 1):
        moment[3 * (first + lane) + 0] = w[2304 + lane]
        moment[3 * (first + lane) + 1] = w[2336 + lane]
        moment[3 * (first + lane) + 2] = w[2368 + lane]


@fast
def _loads(q, k, conventions, drives, much, points, forces, bears, torque, along, moment):
    w, given, constants, kept = scratch(WORK), q.reshape(q.size), k.reshape(k.size), scratch((k.shape[1] + 1) * FRAME)
    places, pulls, felt, torques, moments = (
        points.reshape(points.size), forces.reshape(forces.size), along.reshape(along.size),
        torque.reshape(torque.size), moment.reshape(moment.size),
    )
    links, joints, width = k.shape[1], q.shape[1], 5 * k.shape[1]
    torque[:] = 0.0
    of = np.arange(len(q)) // (len(q) // k.shape[0])  # the machine that stands at each pose
    for first in range(0, len(q), LANES):
        last = min(first + LANES, len(q)) - 1
        n = (last - first + 8) // 8 * 8
        _begin(w, n)
        row = 0
        for link in range(links):
            at, row = row, _prepare(given, constants, of, drives, much, w, link, row, links, joints, first, last, n)
            _keep(w, kept[FRAME * link :])
            if conventions[link] == 0:
                _place_standard(w, n)
            elif conventions[link] == 1:
                _place_modified(w, n)
        _unladen(w, n)
        for link in range(links, -1, -1):
            for weight in range(len(bears)):
                if bears[weight] == link:
                    _pick(places, pulls, w, 3 * weight, len(q), first, last, n)
                    _moment(w, n)
                    _burden(w, n)
            if link < links:
                while row > 0 and drives[row - 1, 0] == link:
                    row -= 1
                _return(w, kept[FRAME * link :])
                at = _prepare(given, constants, of, drives, much, w, link, row, links, joints, first, last, n)
                if conventions[link] == 0:
                    _exert_standard(w, n)
                elif conventions[link] == 1:
                    _exert_modified(w, n)
                _felt(w, felt, 5 * link, width, first, last)
                for d in range(row, at):
                    _pull(w, much[d:], torques, drives[d, 1], drives[d, 2], joints, first, last)
        _carried(w, moments, first, last)


def loads(q, k, conventions, drives, much, points, forces, bears, torque, along, moment):
    """Fill what weights exert by virtual work: torque (N, n_q) on the joints, along (N, links, 5) by the errors.

    forces (n, 3, N) act at `points`, on the links that `bears` (n,) tells, or on what the last link carries. Their
    moment (N, 3) is that about {O}.
    """
    _loads(q, k, conventions, drives, much, points, forces, bears, torque, along, moment)

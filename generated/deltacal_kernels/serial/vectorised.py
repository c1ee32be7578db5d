"""Kinematics of `serial` in plain NumPy: Open chain of revolute and prismatic joints.

Generated from derive/mechanisms/serial.py by "deltacal kernels". Do not edit.
Template templates/chain/vectorised.py.jinja; sha256 of both 5ae32478784617ac; SymPy 1.14.0.

The functions of ``kinematics.py`` over all poses at once, from the same lowered kernels. Inside, poses stand last:
joint (2, N), the turn and the slide of a link's joint; frame (12, N), origin [mm] and rotation matrix row by row; point
and tool (3, N) [mm]; k (10, M), M being 1 or N.
"""

import numpy as np

BASE = np.array([0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0])  # its frame
BEHIND = len(BASE)  # where the twists begin behind a link's frame


def constants(p):
    """Return k (M, links, 10), what no pose changes of a link, from p (8 operations).

    p (M, links, 12): a alpha d theta da dalpha dd dtheta dbeta dtx dty dtz.
    """
    p = np.moveaxis(p, -1, 0).copy()  # value by value, so that all rows of one lie side by side
    k = np.zeros((10, *p.shape[1:]))
    a = p[0]
    alpha = p[1]
    d = p[2]
    theta = p[3]
    da = p[4]
    dalpha = p[5]
    dd = p[6]
    dtheta = p[7]
    dbeta = p[8]
    dtx = p[9]
    dty = p[10]
    dtz = p[11]
    s0 = dtheta + theta
    s2 = d + dd
    along_x = a + da
    about_x = alpha + dalpha
    s26 = np.cos(dbeta)
    s28 = np.cos(about_x)
    s33 = np.sin(about_x)
    s36 = np.sin(dbeta)
    k[0] = s0
    k[1] = s2
    k[2] = along_x
    k[3] = s26
    k[4] = s28
    k[5] = s33
    k[6] = s36
    k[7] = dtx
    k[8] = dty
    k[9] = dtz
    return np.ascontiguousarray(np.moveaxis(k, 0, -1))


def _place_standard(joint, frame, k):
    """A link, standard convention: its frame by the one before: (12, N)."""
    turn = joint[0]
    slide = joint[1]
    ox = frame[0]
    oy = frame[1]
    oz = frame[2]
    R_00 = frame[3]
    R_01 = frame[4]
    R_02 = frame[5]
    R_10 = frame[6]
    R_11 = frame[7]
    R_12 = frame[8]
    R_20 = frame[9]
    R_21 = frame[10]
    R_22 = frame[11]
    s0 = k[0]
    s2 = k[1]
    along_x = k[2]
    s26 = k[3]
    s28 = k[4]
    s33 = k[5]
    s36 = k[6]
    about_z = s0 + turn
    along_z = s2 + slide
    s7 = np.cos(about_z)
    s9 = np.sin(about_z)
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
    out = np.zeros((12, *frame.shape[1:]))
    out[0] = s13
    out[1] = s19
    out[2] = s25
    out[3] = s38
    out[4] = s41
    out[5] = s44
    out[6] = s53
    out[7] = s56
    out[8] = s59
    out[9] = s68
    out[10] = s71
    out[11] = s74
    return out


def _reach_standard(joint, frame, point, k):
    """A link, standard convention: its frame; shift of a point behind it and turn, by each error, by turn and slide of the joint: (54, N)."""
    turn = joint[0]
    slide = joint[1]
    ox = frame[0]
    oy = frame[1]
    oz = frame[2]
    R_00 = frame[3]
    R_01 = frame[4]
    R_02 = frame[5]
    R_10 = frame[6]
    R_11 = frame[7]
    R_12 = frame[8]
    R_20 = frame[9]
    R_21 = frame[10]
    R_22 = frame[11]
    px = point[0]
    py = point[1]
    pz = point[2]
    s0 = k[0]
    s2 = k[1]
    along_x = k[2]
    s26 = k[3]
    s28 = k[4]
    s33 = k[5]
    s36 = k[6]
    about_z = s0 + turn
    along_z = s2 + slide
    s6 = R_02*along_z
    s7 = np.cos(about_z)
    s9 = np.sin(about_z)
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
    out = np.zeros((54, *frame.shape[1:]))
    out[0] = s13
    out[1] = s19
    out[2] = s25
    out[3] = s38
    out[4] = s41
    out[5] = s44
    out[6] = s53
    out[7] = s56
    out[8] = s59
    out[9] = s68
    out[10] = s71
    out[11] = s74
    out[12] = s11
    out[13] = s17
    out[14] = s23
    out[15] = 0
    out[16] = 0
    out[17] = 0
    out[18] = s79
    out[19] = s83
    out[20] = s86
    out[21] = s11
    out[22] = s17
    out[23] = s23
    out[24] = R_02
    out[25] = R_12
    out[26] = R_22
    out[27] = 0
    out[28] = 0
    out[29] = 0
    out[30] = s91
    out[31] = s95
    out[32] = s98
    out[33] = R_02
    out[34] = R_12
    out[35] = R_22
    out[36] = s103
    out[37] = s107
    out[38] = s110
    out[39] = s41
    out[40] = s56
    out[41] = s71
    out[42] = s91
    out[43] = s95
    out[44] = s98
    out[45] = R_02
    out[46] = R_12
    out[47] = R_22
    out[48] = R_02
    out[49] = R_12
    out[50] = R_22
    out[51] = 0
    out[52] = 0
    out[53] = 0
    return out


def _exert_standard(joint, frame, load, k):
    """A link, standard convention: work of the load of all that it carries by each error, by turn and slide of its joint: (7, N)."""
    turn = joint[0]
    slide = joint[1]
    ox = frame[0]
    oy = frame[1]
    oz = frame[2]
    R_00 = frame[3]
    R_01 = frame[4]
    R_02 = frame[5]
    R_10 = frame[6]
    R_11 = frame[7]
    R_12 = frame[8]
    R_20 = frame[9]
    R_21 = frame[10]
    R_22 = frame[11]
    fx = load[0]
    fy = load[1]
    fz = load[2]
    mx = load[3]
    my = load[4]
    mz = load[5]
    s0 = k[0]
    s2 = k[1]
    along_x = k[2]
    s28 = k[4]
    s33 = k[5]
    about_z = s0 + turn
    along_z = s2 + slide
    s6 = R_02*along_z
    s7 = np.cos(about_z)
    s9 = np.sin(about_z)
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
    out = np.zeros((7, *frame.shape[1:]))
    out[0] = s114
    out[1] = s133
    out[2] = s137
    out[3] = s153
    out[4] = s169
    out[5] = s153
    out[6] = s137
    return out


def _place_modified(joint, frame, k):
    """A link, modified convention: its frame by the one before: (12, N)."""
    turn = joint[0]
    slide = joint[1]
    ox = frame[0]
    oy = frame[1]
    oz = frame[2]
    R_00 = frame[3]
    R_01 = frame[4]
    R_02 = frame[5]
    R_10 = frame[6]
    R_11 = frame[7]
    R_12 = frame[8]
    R_20 = frame[9]
    R_21 = frame[10]
    R_22 = frame[11]
    s0 = k[0]
    s2 = k[1]
    along_x = k[2]
    s26 = k[3]
    s28 = k[4]
    s33 = k[5]
    s36 = k[6]
    about_z = s0 + turn
    along_z = s2 + slide
    s7 = np.cos(about_z)
    s9 = np.sin(about_z)
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
    out = np.zeros((12, *frame.shape[1:]))
    out[0] = s180
    out[1] = s191
    out[2] = s202
    out[3] = s207
    out[4] = s210
    out[5] = s178
    out[6] = s215
    out[7] = s218
    out[8] = s189
    out[9] = s223
    out[10] = s226
    out[11] = s200
    return out


def _reach_modified(joint, frame, point, k):
    """A link, modified convention: its frame; shift of a point behind it and turn, by each error, by turn and slide of the joint: (54, N)."""
    turn = joint[0]
    slide = joint[1]
    ox = frame[0]
    oy = frame[1]
    oz = frame[2]
    R_00 = frame[3]
    R_01 = frame[4]
    R_02 = frame[5]
    R_10 = frame[6]
    R_11 = frame[7]
    R_12 = frame[8]
    R_20 = frame[9]
    R_21 = frame[10]
    R_22 = frame[11]
    px = point[0]
    py = point[1]
    pz = point[2]
    s0 = k[0]
    s2 = k[1]
    along_x = k[2]
    s26 = k[3]
    s28 = k[4]
    s33 = k[5]
    s36 = k[6]
    about_z = s0 + turn
    along_z = s2 + slide
    s7 = np.cos(about_z)
    s9 = np.sin(about_z)
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
    out = np.zeros((54, *frame.shape[1:]))
    out[0] = s180
    out[1] = s191
    out[2] = s202
    out[3] = s207
    out[4] = s210
    out[5] = s178
    out[6] = s215
    out[7] = s218
    out[8] = s189
    out[9] = s223
    out[10] = s226
    out[11] = s200
    out[12] = s174
    out[13] = s185
    out[14] = s196
    out[15] = 0
    out[16] = 0
    out[17] = 0
    out[18] = s229
    out[19] = s232
    out[20] = s235
    out[21] = R_00
    out[22] = R_10
    out[23] = R_20
    out[24] = s178
    out[25] = s189
    out[26] = s200
    out[27] = 0
    out[28] = 0
    out[29] = 0
    out[30] = s240
    out[31] = s244
    out[32] = s247
    out[33] = s178
    out[34] = s189
    out[35] = s200
    out[36] = s250
    out[37] = s253
    out[38] = s256
    out[39] = s205
    out[40] = s213
    out[41] = s221
    out[42] = s240
    out[43] = s244
    out[44] = s247
    out[45] = s178
    out[46] = s189
    out[47] = s200
    out[48] = s178
    out[49] = s189
    out[50] = s200
    out[51] = 0
    out[52] = 0
    out[53] = 0
    return out


def _exert_modified(joint, frame, load, k):
    """A link, modified convention: work of the load of all that it carries by each error, by turn and slide of its joint: (7, N)."""
    ox = frame[0]
    oy = frame[1]
    oz = frame[2]
    R_00 = frame[3]
    R_01 = frame[4]
    R_02 = frame[5]
    R_10 = frame[6]
    R_11 = frame[7]
    R_12 = frame[8]
    R_20 = frame[9]
    R_21 = frame[10]
    R_22 = frame[11]
    fx = load[0]
    fy = load[1]
    fz = load[2]
    mx = load[3]
    my = load[4]
    mz = load[5]
    along_x = k[2]
    s26 = k[3]
    s28 = k[4]
    s33 = k[5]
    s36 = k[6]
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
    out = np.zeros((7, *frame.shape[1:]))
    out[0] = s260
    out[1] = s276
    out[2] = s280
    out[3] = s299
    out[4] = s315
    out[5] = s299
    out[6] = s280
    return out


def _tip(frame, tool, k):
    """Position of the tool point by the last frame: (3, N)."""
    ox = frame[0]
    oy = frame[1]
    oz = frame[2]
    R_00 = frame[3]
    R_01 = frame[4]
    R_02 = frame[5]
    R_10 = frame[6]
    R_11 = frame[7]
    R_12 = frame[8]
    R_20 = frame[9]
    R_21 = frame[10]
    R_22 = frame[11]
    tx = tool[0]
    ty = tool[1]
    tz = tool[2]
    dtx = k[7]
    dty = k[8]
    dtz = k[9]
    s316 = dtx + tx
    s318 = dty + ty
    s320 = dtz + tz
    s322 = R_00*s316 + R_01*s318 + R_02*s320 + ox
    s326 = R_10*s316 + R_11*s318 + R_12*s320 + oy
    s330 = R_20*s316 + R_21*s318 + R_22*s320 + oz
    out = np.zeros((3, *frame.shape[1:]))
    out[0] = s322
    out[1] = s326
    out[2] = s330
    return out


def _reach_tip(frame):
    """Shift of the tool point and turn by each error of the tool: (18, N)."""
    R_00 = frame[3]
    R_01 = frame[4]
    R_02 = frame[5]
    R_10 = frame[6]
    R_11 = frame[7]
    R_12 = frame[8]
    R_20 = frame[9]
    R_21 = frame[10]
    R_22 = frame[11]
    out = np.zeros((18, *frame.shape[1:]))
    out[0] = R_00
    out[1] = R_10
    out[2] = R_20
    out[3] = 0
    out[4] = 0
    out[5] = 0
    out[6] = R_01
    out[7] = R_11
    out[8] = R_21
    out[9] = 0
    out[10] = 0
    out[11] = 0
    out[12] = R_02
    out[13] = R_12
    out[14] = R_22
    out[15] = 0
    out[16] = 0
    out[17] = 0
    return out


def _centre(frame, centre):
    """Where a link's weight acts, by its frame: (3, N)."""
    ox = frame[0]
    oy = frame[1]
    oz = frame[2]
    R_00 = frame[3]
    R_01 = frame[4]
    R_02 = frame[5]
    R_10 = frame[6]
    R_11 = frame[7]
    R_12 = frame[8]
    R_20 = frame[9]
    R_21 = frame[10]
    R_22 = frame[11]
    cx = centre[0]
    cy = centre[1]
    cz = centre[2]
    s334 = R_00*cx + R_01*cy + R_02*cz + ox
    s338 = R_10*cx + R_11*cy + R_12*cz + oy
    s342 = R_20*cx + R_21*cy + R_22*cz + oz
    out = np.zeros((3, *frame.shape[1:]))
    out[0] = s334
    out[1] = s338
    out[2] = s342
    return out


def _moment(point, load):
    """Moment about {O} of a force at a point: (3, N)."""
    px = point[0]
    py = point[1]
    pz = point[2]
    fx = load[0]
    fy = load[1]
    fz = load[2]
    s345 = -fy*pz + fz*py
    s348 = fx*pz - fz*px
    s351 = -fx*py + fy*px
    out = np.zeros((3, *load.shape[1:]))
    out[0] = s345
    out[1] = s348
    out[2] = s351
    return out


PLACE = (_place_standard, _place_modified)
REACH = (_reach_standard, _reach_modified)
EXERT = (_exert_standard, _exert_modified)


def _moved(q, links, drives, much):
    """Return the turn and the slide of each link's joint, (links, 2, N)."""
    joint = np.zeros((links, 2, len(q)))
    for (link, variable, j), by in zip(drives, much):
        joint[link, variable] += by * q[:, j]
    return joint


def _base(poses):
    return np.repeat(BASE[:, None], poses, axis=1)


def frames(q, k, conventions, drives, much):
    """Return the frames of the base and of every link, (links + 1, 12, N)."""
    found, joint = [_base(len(q))], _moved(q, len(conventions), drives, much)
    for link, convention in enumerate(conventions):
        found.append(PLACE[convention](joint[link], found[-1], k[:, link].T))
    return np.array(found)


def forward(q, tool, k, conventions, drives, much, x):
    """See ``kinematics.forward``."""
    frame, joint = _base(len(q)), _moved(q, len(conventions), drives, much)
    for link, convention in enumerate(conventions):
        frame = PLACE[convention](joint[link], frame, k[:, link].T)
    x[:, :3], x[:, 3:] = _tip(frame, tool.T, k[:, -1].T).T, frame[3:].T


def sensitivity(x, q, k, conventions, drives, much, S_p, S_q):
    """See ``kinematics.sensitivity``."""
    frame, joint, point, n = _base(len(q)), _moved(q, len(conventions), drives, much), x[:, :3].T, 0
    S_q[:] = 0.0
    for link, convention in enumerate(conventions):
        found = REACH[convention](joint[link], frame, point, k[:, link].T)
        frame, twists = found[:BEHIND], found[BEHIND:].reshape(7, 6, -1)
        S_p[:, :, 5 * link : 5 * (link + 1)] = twists[:5].T
        while n < len(much) and drives[n, 0] == link:
            S_q[:, :, drives[n, 2]] += much[n] * twists[5 + drives[n, 1]].T
            n += 1
    S_p[:, :, 5 * len(conventions) :] = _reach_tip(frame).reshape(3, 6, -1).T


def centres(q, k, conventions, drives, much, own):
    """Return where the links' weights act (links, 3, N), by their places `own` (links, 3) in the links' frames."""
    every = frames(q, k, conventions, drives, much)[1:]
    return np.array([_centre(frame, centre) for frame, centre in zip(every, own)])


def loads(q, k, conventions, drives, much, points, forces, bears, torque, along, moment):
    """Fill what weights exert by virtual work: torque (N, n_q) on the joints, along (N, links, 5) by the errors.

    forces (n, 3, N) act at `points`, on the links that `bears` (n,) tells, or on what the last link carries. Their
    moment (N, 3) is that about {O}.
    """
    every, joint, n = frames(q, k, conventions, drives, much), _moved(q, len(conventions), drives, much), len(much)
    load, torque[:] = np.zeros((6, len(q))), 0.0
    for link in range(len(conventions), -1, -1):
        for n_w in np.flatnonzero(bears == link):
            load[:3] += forces[n_w]
            load[3:] += _moment(points[n_w], forces[n_w])
        if link < len(conventions):
            work = EXERT[conventions[link]](joint[link], every[link], load, k[:, link].T)
            along[:, link] = work[:5].T
            while n > 0 and drives[n - 1, 0] == link:
                n -= 1
                torque[:, drives[n, 2]] += much[n] * work[5 + drives[n, 1]]
    moment[:] = load[3:].T

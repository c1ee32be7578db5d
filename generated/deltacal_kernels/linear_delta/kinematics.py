"""Kinematics of `linear_delta`, many poses at once: Linear delta, three towers and six rods.

Generated from derive/mechanisms/linear_delta.py by "deltacal kernels". Do not edit.
Template templates/mechanism/kinematics.py.jinja; sha256 of both 59f0ee4e88c126f3; SymPy 1.14.0.

Arrays are C-contiguous float64, the pose first, lengths in mm, angles in rad:

x (N, 6)  platform: px py pz cx cy cz
q (N, 3)  joints        tool (N or 1, 3)  reference point in {O'}
p (M, 3, 16)  one row of parameters per limb: r l phi home a c endstop arm radius angle lean_radial lean_tangential scale dl radius stretch
k (M, 3, 53)  what `constants` makes of p; each of the M machines has N / M of the poses, one after the other

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
    """What moves with a joint only; then the simplified limb as a sphere |P|^2 - 2 c.P + d = 0: c, d (20 operations)."""
    s60 = k[0]
    s59 = k[1]
    axis_x = k[2]
    s65 = k[3]
    axis_y = k[4]
    s68 = k[5]
    axis_z = k[6]
    s106 = k[7]
    s109 = k[8]
    s660 = k[14]
    s665 = k[15]
    h = k[16]
    s53 = k[40]
    for lane in range(n):
        q = w[0 + lane]
        tx = w[32 + lane]
        ty = w[64 + lane]
        tz = w[96 + lane]
        s61 = -q*s60
        s62 = s59 + s61
        C_x = axis_x*s62 + s65
        C_y = axis_y*s62 + s68
        C_z = axis_z*s62
        s107 = s106 - tx
        s110 = s109 - ty
        s687 = -s660 + tx
        s688 = -s665 + ty
        s689 = h + s61 + tz
        s693 = -s53 + (s687 * s687) + (s688 * s688) + (s689 * s689)
        w[1120 + lane] = s107
        w[1152 + lane] = s110
        w[1184 + lane] = C_x
        w[1216 + lane] = C_y
        w[1248 + lane] = C_z
        w[1280 + lane] = s687
        w[1312 + lane] = s688
        w[1344 + lane] = s689
        w[1376 + lane] = s693


@straight
def _rows(w, k, n):
    """Equations of a limb, their derivatives by shift and turn of the platform (124 operations)."""
    u_x = k[9]
    u_y = k[10]
    s128 = k[11]
    s714 = k[41]
    s870 = k[42]
    s1009 = k[43]
    s1011 = k[44]
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
        s107 = w[1120 + lane]
        s110 = w[1152 + lane]
        C_x = w[1184 + lane]
        C_y = w[1216 + lane]
        C_z = w[1248 + lane]
        s108 = R_11*s107
        s111 = R_12*s110
        s112 = -R_13*tz
        A_x = px + s108 + s111 + s112
        s114 = R_21*s107
        s115 = R_22*s110
        s116 = -R_23*tz
        A_y = py + s114 + s115 + s116
        s118 = R_31*s107
        s119 = R_32*s110
        s120 = -R_33*tz
        A_z = pz + s118 + s119 + s120
        d_x = A_x - C_x
        d_y = A_y - C_y
        d_z = A_z - C_z
        s_x = s128*(-R_11*u_y + R_12*u_x + u_y)
        s_y = s128*(-R_21*u_y + R_22*u_x - u_x)
        s_z = s128*(-R_31*u_y + R_32*u_x)
        s704 = 0.5*(s_x * s_x)
        s706 = 0.5*(s_y * s_y)
        s708 = 0.5*(s_z * s_z)
        s715 = 0.5*(d_x * d_x) + 0.5*(d_y * d_y) + 0.5*(d_z * d_z) + s704 + s706 + s708 + s714
        s871 = d_x*s_x + d_y*s_y + d_z*s_z + s870
        s1005 = -s118 - s119 - s120
        s1007 = s114 + s115 + s116
        s1013 = R_31*s1009 + R_32*s1011
        s1017 = -R_21*s1009 - R_22*s1011
        s1019 = d_y*s1005 + d_z*s1007 + s1013*s_y + s1017*s_z
        s1021 = -s108 - s111 - s112
        s1026 = R_11*s1009 + R_12*s1011
        s1028 = -d_x*s1005 + d_z*s1021 - s1013*s_x + s1026*s_z
        s1033 = -d_x*s1007 - d_y*s1021 - s1017*s_x - s1026*s_y
        s1038 = d_y*s1013 + d_z*s1017 + s1005*s_y + s1007*s_z
        s1043 = -d_x*s1013 + d_z*s1026 - s1005*s_x + s1021*s_z
        s1048 = -d_x*s1017 - d_y*s1026 - s1007*s_x - s1021*s_y
        w[608 + lane] = s715
        w[640 + lane] = d_x
        w[672 + lane] = d_y
        w[704 + lane] = d_z
        w[736 + lane] = s1019
        w[768 + lane] = s1028
        w[800 + lane] = s1033
        w[864 + lane] = s871
        w[896 + lane] = s_x
        w[928 + lane] = s_y
        w[960 + lane] = s_z
        w[992 + lane] = s1038
        w[1024 + lane] = s1043
        w[1056 + lane] = s1048


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
        F10 = w[2720 + lane]
        J10_0 = w[2752 + lane]
        J10_1 = w[2784 + lane]
        J10_2 = w[2816 + lane]
        J10_3 = w[2848 + lane]
        J10_4 = w[2880 + lane]
        J10_5 = w[2912 + lane]
        F11 = w[2976 + lane]
        J11_0 = w[3008 + lane]
        J11_1 = w[3040 + lane]
        J11_2 = w[3072 + lane]
        J11_3 = w[3104 + lane]
        J11_4 = w[3136 + lane]
        J11_5 = w[3168 + lane]
        F20 = w[4832 + lane]
        J20_0 = w[4864 + lane]
        J20_1 = w[4896 + lane]
        J20_2 = w[4928 + lane]
        J20_3 = w[4960 + lane]
        J20_4 = w[4992 + lane]
        J20_5 = w[5024 + lane]
        F21 = w[5088 + lane]
        J21_0 = w[5120 + lane]
        J21_1 = w[5152 + lane]
        J21_2 = w[5184 + lane]
        J21_3 = w[5216 + lane]
        J21_4 = w[5248 + lane]
        J21_5 = w[5280 + lane]
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
        w[6336 + lane] = s193
        w[6368 + lane] = s197
        w[6400 + lane] = s201
        w[6432 + lane] = w_00
        w[6464 + lane] = w_10
        w[6496 + lane] = w_20
        w[6528 + lane] = s216
        w[6560 + lane] = s231


@straight
def _start(w, k, n):
    """Joint of the simplified limb at a given position (22 operations)."""
    s660 = k[14]
    s665 = k[15]
    h = k[16]
    s672 = k[17]
    s674 = k[18]
    s680 = k[19]
    s684 = k[20]
    for lane in range(n):
        tx = w[32 + lane]
        ty = w[64 + lane]
        tz = w[96 + lane]
        px = w[128 + lane]
        py = w[160 + lane]
        pz = w[192 + lane]
        s669 = -h + pz - tz
        s670 = (s669 * s669)
        s673 = 0.5*s670 + s672 + 0.5*((px + s660 - tx) * (px + s660 - tx)) + 0.5*((py + s665 - ty) * (py + s665 - ty))
        s686 = s669*s684 - math.sqrt(s670*s680 + s673*s674)
        w[1408 + lane] = s686


@straight
def _more(w, k, n):
    """What else derivatives by joint and errors read of it (2 operations)."""
    s60 = k[0]
    s59 = k[1]
    for lane in range(n):
        q = w[0 + lane]
        s62 = -q*s60 + s59
        w[1440 + lane] = s62


@straight
def _joints(w, k, n):
    """Derivatives of a limb's equations by its joint (45 operations)."""
    u_x = k[9]
    u_y = k[10]
    s128 = k[11]
    s1049 = k[45]
    s1051 = k[46]
    s1053 = k[47]
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
        s107 = w[1120 + lane]
        s110 = w[1152 + lane]
        C_x = w[1184 + lane]
        C_y = w[1216 + lane]
        C_z = w[1248 + lane]
        A_x = R_11*s107 + R_12*s110 - R_13*tz + px
        A_y = R_21*s107 + R_22*s110 - R_23*tz + py
        A_z = R_31*s107 + R_32*s110 - R_33*tz + pz
        d_x = A_x - C_x
        d_y = A_y - C_y
        d_z = A_z - C_z
        s_x = s128*(-R_11*u_y + R_12*u_x + u_y)
        s_y = s128*(-R_21*u_y + R_22*u_x - u_x)
        s_z = s128*(-R_31*u_y + R_32*u_x)
        s1055 = d_x*s1049 + d_y*s1051 + d_z*s1053
        s1059 = s1049*s_x + s1051*s_y + s1053*s_z
        w[832 + lane] = s1055
        w[1088 + lane] = s1059


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
        F10 = w[2720 + lane]
        J10_0 = w[2752 + lane]
        J10_1 = w[2784 + lane]
        J10_2 = w[2816 + lane]
        J10_3 = w[2848 + lane]
        J10_4 = w[2880 + lane]
        J10_5 = w[2912 + lane]
        Q10 = w[2944 + lane]
        F11 = w[2976 + lane]
        J11_3 = w[3104 + lane]
        J11_4 = w[3136 + lane]
        J11_5 = w[3168 + lane]
        Q11 = w[3200 + lane]
        F20 = w[4832 + lane]
        J20_0 = w[4864 + lane]
        J20_1 = w[4896 + lane]
        J20_2 = w[4928 + lane]
        J20_3 = w[4960 + lane]
        J20_4 = w[4992 + lane]
        J20_5 = w[5024 + lane]
        Q20 = w[5056 + lane]
        F21 = w[5088 + lane]
        J21_3 = w[5216 + lane]
        J21_4 = w[5248 + lane]
        J21_5 = w[5280 + lane]
        Q21 = w[5312 + lane]
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
        w[7840 + lane] = s81
        w[7872 + lane] = s86
        w[7904 + lane] = s91
        w[7936 + lane] = w_00
        w[7968 + lane] = w_10
        w[8000 + lane] = w_20
        w[8032 + lane] = s106
        w[8064 + lane] = s114
        w[8096 + lane] = s122
        w[8128 + lane] = s130


@straight
def _errors(w, k, n):
    """Derivatives of a limb's equations by errors, by deflections (212 operations)."""
    axis_x = k[2]
    s65 = k[3]
    axis_y = k[4]
    s68 = k[5]
    axis_z = k[6]
    s106 = k[7]
    s109 = k[8]
    u_x = k[9]
    u_y = k[10]
    s128 = k[11]
    s58 = k[21]
    s280 = k[22]
    s286 = k[24]
    s326 = k[25]
    s354 = k[26]
    s358 = k[27]
    s361 = k[28]
    s397 = k[29]
    s425 = k[30]
    s429 = k[31]
    s432 = k[32]
    s468 = k[33]
    s495 = k[34]
    s498 = k[35]
    s501 = k[36]
    s834 = k[48]
    s147 = k[49]
    s862 = k[50]
    s864 = k[51]
    s1004 = k[52]
    for lane in range(n):
        q = w[0 + lane]
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
        s107 = w[1120 + lane]
        s110 = w[1152 + lane]
        C_x = w[1184 + lane]
        C_y = w[1216 + lane]
        C_z = w[1248 + lane]
        s62 = w[1440 + lane]
        A_x = R_11*s107 + R_12*s110 - R_13*tz + px
        A_y = R_21*s107 + R_22*s110 - R_23*tz + py
        A_z = R_31*s107 + R_32*s110 - R_33*tz + pz
        d_x = A_x - C_x
        d_y = A_y - C_y
        d_z = A_z - C_z
        s_x = s128*(-R_11*u_y + R_12*u_x + u_y)
        s_y = s128*(-R_21*u_y + R_22*u_x - u_x)
        s_z = s128*(-R_31*u_y + R_32*u_x)
        s716 = 2*s_z
        s718 = 2*s_y
        s720 = 2*s_x
        s722 = 2*d_z
        s723 = 0.5*s722
        s724 = 2*d_y
        s725 = 0.5*s724
        s726 = 2*d_x
        s727 = 0.5*s726
        s729 = 0.5*s128*s716
        s735 = 0.5*s128*s718
        s740 = 0.5*s128*s720
        s814 = -s62*s723
        s816 = -s62*s725
        s818 = -s62*s727
        s820 = -axis_x*s727 - axis_y*s725 - axis_z*s723
        s822 = -q*s820
        s832 = s58*s820
        s836 = s280*s820 + s834
        s840 = s286*s820 - s725*u_y - s727*u_x
        s841 = u_x*(-R_11*s740 - R_21*s735 - R_31*s729 + s740)
        s842 = -u_y*(R_12*s740 + R_22*s735 + R_32*s729 - s735)
        s843 = s106*(R_12*s727 + R_22*s725 + R_32*s723)
        s844 = -s109*(R_11*s727 + R_21*s725 + R_31*s723)
        s848 = s68*s727
        s849 = s358*s818
        s850 = s361*s820
        s851 = s326*s814 + s354*s816 - s65*s725 + s841 + s842 + s843 + s844 + s848 + s849 + s850
        s856 = s397*s814 + s425*s816 + s429*s818 + s432*s820
        s861 = s468*s814 + s495*s816 + s498*s818 + s501*s820
        s873 = d_z*s128
        s879 = d_y*s128
        s884 = d_x*s128
        s958 = -s62*s_z
        s960 = -s62*s_y
        s962 = -s62*s_x
        s964 = -axis_x*s_x - axis_y*s_y - axis_z*s_z
        s966 = -q*s964
        s976 = s58*s964
        s978 = -s147 + s280*s964
        s982 = s286*s964 - s_x*u_x - s_y*u_y
        s983 = u_x*(-R_11*s884 - R_21*s879 - R_31*s873 + s884)
        s984 = -u_y*(R_12*s884 + R_22*s879 + R_32*s873 - s879)
        s985 = s106*(R_12*s_x + R_22*s_y + R_32*s_z)
        s986 = -s109*(R_11*s_x + R_21*s_y + R_31*s_z)
        s990 = s68*s_x
        s991 = s358*s962
        s992 = s361*s964
        s993 = s326*s958 + s354*s960 - s65*s_y + s983 + s984 + s985 + s986 + s990 + s991 + s992
        s998 = s397*s958 + s425*s960 + s429*s962 + s432*s964
        s1003 = s468*s958 + s495*s960 + s498*s962 + s501*s964
        w[1472 + lane] = s832
        w[1504 + lane] = s836
        w[1536 + lane] = s840
        w[1568 + lane] = s851
        w[1600 + lane] = s856
        w[1632 + lane] = s861
        w[1664 + lane] = s822
        w[1696 + lane] = s862
        w[1728 + lane] = s840
        w[1760 + lane] = s864
        w[1792 + lane] = s976
        w[1824 + lane] = s978
        w[1856 + lane] = s982
        w[1888 + lane] = s993
        w[1920 + lane] = s998
        w[1952 + lane] = s1003
        w[1984 + lane] = s966
        w[2016 + lane] = s1004
        w[2048 + lane] = s982
        w[2080 + lane] = -s147


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
        J10_0 = w[2752 + lane]
        J10_1 = w[2784 + lane]
        J10_2 = w[2816 + lane]
        J10_3 = w[2848 + lane]
        J10_4 = w[2880 + lane]
        J10_5 = w[2912 + lane]
        J11_0 = w[3008 + lane]
        J11_1 = w[3040 + lane]
        J11_2 = w[3072 + lane]
        J11_3 = w[3104 + lane]
        J11_4 = w[3136 + lane]
        J11_5 = w[3168 + lane]
        J20_0 = w[4864 + lane]
        J20_1 = w[4896 + lane]
        J20_2 = w[4928 + lane]
        J20_3 = w[4960 + lane]
        J20_4 = w[4992 + lane]
        J20_5 = w[5024 + lane]
        J21_0 = w[5120 + lane]
        J21_1 = w[5152 + lane]
        J21_2 = w[5184 + lane]
        J21_3 = w[5216 + lane]
        J21_4 = w[5248 + lane]
        J21_5 = w[5280 + lane]
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
        w[6624 + lane] = s265
        w[6656 + lane] = s269
        w[6688 + lane] = s273
        w[6720 + lane] = s277
        w[6752 + lane] = s281
        w[6784 + lane] = s285
        w[6816 + lane] = s289
        w[6848 + lane] = s293
        w[6880 + lane] = s297
        w[6912 + lane] = s301
        w[6944 + lane] = s305
        w[6976 + lane] = s309
        w[7008 + lane] = s313
        w[7040 + lane] = s317
        w[7072 + lane] = s321
        w[7104 + lane] = s325
        w[7136 + lane] = s329
        w[7168 + lane] = s333
        w[7200 + lane] = -V_00
        w[7232 + lane] = -V_01
        w[7264 + lane] = -V_02
        w[7296 + lane] = -Si_inv_00
        w[7328 + lane] = -Si_inv_01
        w[7360 + lane] = -Si_inv_02
        w[7392 + lane] = -V_10
        w[7424 + lane] = -V_11
        w[7456 + lane] = -V_12
        w[7488 + lane] = -Si_inv_10
        w[7520 + lane] = -Si_inv_11
        w[7552 + lane] = -Si_inv_12
        w[7584 + lane] = -V_20
        w[7616 + lane] = -V_21
        w[7648 + lane] = -V_22
        w[7680 + lane] = -Si_inv_20
        w[7712 + lane] = -Si_inv_21
        w[7744 + lane] = -Si_inv_22
        w[7776 + lane] = s348
        w[7808 + lane] = s363


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
        y0 = w[6336 + lane]
        y1 = w[6368 + lane]
        y2 = w[6400 + lane]
        y3 = w[6432 + lane]
        y4 = w[6464 + lane]
        y5 = w[6496 + lane]
        going = w[6592 + lane]
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
        w[2240 + lane] = new_00
        w[4352 + lane] = new_00
        w[160 + lane] = new_10
        w[2272 + lane] = new_10
        w[4384 + lane] = new_10
        w[192 + lane] = new_20
        w[2304 + lane] = new_20
        w[4416 + lane] = new_20
        w[224 + lane] = new_30
        w[256 + lane] = new_40
        w[288 + lane] = new_50
        w[320 + lane] = s51
        w[2432 + lane] = s51
        w[4544 + lane] = s51
        w[352 + lane] = s54
        w[2464 + lane] = s54
        w[4576 + lane] = s54
        w[384 + lane] = s57
        w[2496 + lane] = s57
        w[4608 + lane] = s57
        w[416 + lane] = s59
        w[2528 + lane] = s59
        w[4640 + lane] = s59
        w[448 + lane] = s63
        w[2560 + lane] = s63
        w[4672 + lane] = s63
        w[480 + lane] = s66
        w[2592 + lane] = s66
        w[4704 + lane] = s66
        w[512 + lane] = s68
        w[2624 + lane] = s68
        w[4736 + lane] = s68
        w[544 + lane] = s70
        w[2656 + lane] = s70
        w[4768 + lane] = s70
        w[576 + lane] = s73
        w[2688 + lane] = s73
        w[4800 + lane] = s73


@straight
def _meet(w, n):
    """Put the platform where the simplified machine has it."""
    for lane in range(n):
        c_00 = w[1280 + lane]
        c_01 = w[1312 + lane]
        c_02 = w[1344 + lane]
        c_03 = w[1376 + lane]
        c_10 = w[3392 + lane]
        c_11 = w[3424 + lane]
        c_12 = w[3456 + lane]
        c_13 = w[3488 + lane]
        c_20 = w[5504 + lane]
        c_21 = w[5536 + lane]
        c_22 = w[5568 + lane]
        c_23 = w[5600 + lane]
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
        w[6592 + lane] = 0.0 if good else 1.0
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
        done = (w[6528 + lane] > 0.0)
        done = done & (w[6560 + lane] > 0.0)
        done = done & (abs(w[6336 + lane]) < STEP_DONE)
        done = done & (abs(w[6368 + lane]) < STEP_DONE)
        done = done & (abs(w[6400 + lane]) < STEP_DONE)
        done = done & (abs(w[6432 + lane]) < TURN_DONE)
        done = done & (abs(w[6464 + lane]) < TURN_DONE)
        done = done & (abs(w[6496 + lane]) < TURN_DONE)
        going = 0.0 if done | (w[6592 + lane] == 0.0) else 1.0
        w[6592 + lane] = going
        left += 1 if going == 1.0 else 0
    return left


@straight
def _settle_joints(w, n):
    """Mark the poses for which this step was the last; return how many go on."""
    left = 0
    for lane in range(n):
        done = (w[8032 + lane] > 0.0)
        done = done & (w[8064 + lane] > 0.0)
        done = done & (w[8096 + lane] > 0.0)
        done = done & (w[8128 + lane] > 0.0)
        done = done & (abs(w[7840 + lane]) < STEP_DONE)
        done = done & (abs(w[7872 + lane]) < STEP_DONE)
        done = done & (abs(w[7904 + lane]) < STEP_DONE)

        done = done & (abs(w[7936 + lane]) < TURN_DONE)
        done = done & (abs(w[7968 + lane]) < TURN_DONE)
        done = done & (abs(w[8000 + lane]) < TURN_DONE)
        going = 0.0 if done | (w[6592 + lane] == 0.0) else 1.0
        w[6592 + lane] = going
        left += 1 if going == 1.0 else 0
    return left


@straight
def _begin(w, n):
    """Let all poses go."""
    for lane in range(n):
        w[6592 + lane] = 1.0
        w[6336 + lane] = 0.0
        w[6368 + lane] = 0.0
        w[6400 + lane] = 0.0
        w[6432 + lane] = 0.0
        w[6464 + lane] = 0.0
        w[6496 + lane] = 0.0


@straight
def _started(w, n):
    """Take joints, and coordinates that no command asks for, from the simplified machine."""
    for lane in range(n):
        w[6592 + lane] = 0.0 if (abs(w[1408 + lane]) < math.inf) & (abs(w[3520 + lane]) < math.inf) & (abs(w[5632 + lane]) < math.inf) else 1.0
        w[0 + lane] = w[1408 + lane]
        w[2112 + lane] = w[3520 + lane]
        w[4224 + lane] = w[5632 + lane]
        w[224 + lane] = 0.0
        w[256 + lane] = 0.0
        w[288 + lane] = 0.0


@straight
def _turn_joints(w, n):
    """Move the joints by a step; what it does to the platform is left to `_move`."""
    for lane in range(n):
        going = w[6592 + lane]
        w[0 + lane] -= going * w[7840 + lane]
        w[2112 + lane] -= going * w[7872 + lane]
        w[4224 + lane] -= going * w[7904 + lane]
        w[6432 + lane] = w[7936 + lane]
        w[6464 + lane] = w[7968 + lane]
        w[6496 + lane] = w[8000 + lane]

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
        is_open = w[6592 + lane] != 0.0
        status[first + lane] = OPEN if is_open else SOLVED
        left += 1 if is_open else 0
    return left


@straight
def _unload_joints(w, q, first, last):
    for lane in range(last - first + 1):
        q[3 * (first + lane) + 0] = w[0 + lane]
        q[3 * (first + lane) + 1] = w[2112 + lane]
        q[3 * (first + lane) + 2] = w[4224 + lane]


@fast
def _forward(q, tool, k, x, status, warm):
    w = scratch(WORK + SPARE)
    w_1 = w[0:2112]
    w_2 = w[2112:4224]
    w_3 = w[4224:6336]
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
    w_1 = w[0:2112]
    w_2 = w[2112:4224]
    w_3 = w[4224:6336]
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
        own = machines[159 * (m // (runs // k.shape[0])) :]
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
    s60_0 = own[0 + 0]
    s660_0 = own[0 + 14]
    s665_0 = own[0 + 15]
    h_0 = own[0 + 16]
    s53_0 = own[0 + 40]
    s60_1 = own[53 + 0]
    s660_1 = own[53 + 14]
    s665_1 = own[53 + 15]
    h_1 = own[53 + 16]
    s53_1 = own[53 + 40]
    s60_2 = own[106 + 0]
    s660_2 = own[106 + 14]
    s665_2 = own[106 + 15]
    h_2 = own[106 + 16]
    s53_2 = own[106 + 40]
    for first in range(0, poses, SPHERES):  # in two short loops, of which a processor has several rounds at work
        count = min(SPHERES, poses - first)
        for lane in range(count):
            n = first + lane
            q_0 = q[3 * n + 0]
            s687_0 = -s660_0 + tx
            s688_0 = -s665_0 + ty
            s689_0 = h_0 - q_0*s60_0 + tz
            s693_0 = -s53_0 + (s687_0 * s687_0) + (s688_0 * s688_0) + (s689_0 * s689_0)
            c_00 = s687_0
            c_01 = s688_0
            c_02 = s689_0
            c_03 = s693_0
            q_1 = q[3 * n + 1]
            s687_1 = -s660_1 + tx
            s688_1 = -s665_1 + ty
            s689_1 = h_1 - q_1*s60_1 + tz
            s693_1 = -s53_1 + (s687_1 * s687_1) + (s688_1 * s688_1) + (s689_1 * s689_1)
            c_10 = s687_1
            c_11 = s688_1
            c_12 = s689_1
            c_13 = s693_1
            q_2 = q[3 * n + 2]
            s687_2 = -s660_2 + tx
            s688_2 = -s665_2 + ty
            s689_2 = h_2 - q_2*s60_2 + tz
            s693_2 = -s53_2 + (s687_2 * s687_2) + (s688_2 * s688_2) + (s689_2 * s689_2)
            c_20 = s687_2
            c_21 = s688_2
            c_22 = s689_2
            c_23 = s693_2
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
    """Fill x (N, 3) with the platform of the simplified machine, in closed form: exact where lean_radial, lean_tangential, dl, stretch are zero.

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
        own = machines[159 * (m // (runs // k.shape[0])) :]
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
    s660_0 = own[0 + 14]
    s665_0 = own[0 + 15]
    h_0 = own[0 + 16]
    s672_0 = own[0 + 17]
    s674_0 = own[0 + 18]
    s680_0 = own[0 + 19]
    s684_0 = own[0 + 20]
    s660_1 = own[53 + 14]
    s665_1 = own[53 + 15]
    h_1 = own[53 + 16]
    s672_1 = own[53 + 17]
    s674_1 = own[53 + 18]
    s680_1 = own[53 + 19]
    s684_1 = own[53 + 20]
    s660_2 = own[106 + 14]
    s665_2 = own[106 + 15]
    h_2 = own[106 + 16]
    s672_2 = own[106 + 17]
    s674_2 = own[106 + 18]
    s680_2 = own[106 + 19]
    s684_2 = own[106 + 20]
    for n in range(poses):
        px = target[3 * n + 0]
        py = target[3 * n + 1]
        pz = target[3 * n + 2]
        s669_0 = -h_0 + pz - tz
        s670_0 = (s669_0 * s669_0)
        s673_0 = 0.5*s670_0 + s672_0 + 0.5*((px + s660_0 - tx) * (px + s660_0 - tx)) + 0.5*((py + s665_0 - ty) * (py + s665_0 - ty))
        s686_0 = s669_0*s684_0 - math.sqrt(s670_0*s680_0 + s673_0*s674_0)
        q_00 = s686_0
        s669_1 = -h_1 + pz - tz
        s670_1 = (s669_1 * s669_1)
        s673_1 = 0.5*s670_1 + s672_1 + 0.5*((px + s660_1 - tx) * (px + s660_1 - tx)) + 0.5*((py + s665_1 - ty) * (py + s665_1 - ty))
        s686_1 = s669_1*s684_1 - math.sqrt(s670_1*s680_1 + s673_1*s674_1)
        q_10 = s686_1
        s669_2 = -h_2 + pz - tz
        s670_2 = (s669_2 * s669_2)
        s673_2 = 0.5*s670_2 + s672_2 + 0.5*((px + s660_2 - tx) * (px + s660_2 - tx)) + 0.5*((py + s665_2 - ty) * (py + s665_2 - ty))
        s686_2 = s669_2*s684_2 - math.sqrt(s670_2*s680_2 + s673_2*s674_2)
        q_20 = s686_2
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
    w_1 = w[0:2112]
    w_2 = w[2112:4224]
    w_3 = w[4224:6336]
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
        whole = 180 * (first + lane + 8) <= S_p.size  # else the last poses are written through scratch
        to, at = (S_p, 180 * (first + lane)) if whole else (w[WORK:], 0)
        for i in range(3):
            outer(to, at + 10 * i + 0, 180, 30, 6, w, (6624 + 32 * i + lane, 6720 + 32 * i + lane, ), 192, (1472 + 2112 * i + lane, 1792 + 2112 * i + lane, ), 32, 8)
            outer(to, at + 10 * i + 8, 180, 30, 6, w, (6624 + 32 * i + lane, 6720 + 32 * i + lane, ), 192, (1728 + 2112 * i + lane, 2048 + 2112 * i + lane, ), 32, 2)
        if not whole:
            for c in range(180 * (last + 1 - first - lane)):
                S_p[180 * (first + lane) + c] = to[c]
        whole = 18 * (first + lane + 8) <= S_q.size  # else the last poses are written through scratch
        to, at = (S_q, 18 * (first + lane)) if whole else (w[WORK:], 0)
        for i in range(3):
            outer(to, at + 1 * i + 0, 18, 3, 6, w, (6624 + 32 * i + lane, 6720 + 32 * i + lane, ), 192, (832 + 2112 * i + lane, 1088 + 2112 * i + lane, ), 32, 1)
        if not whole:
            for c in range(18 * (last + 1 - first - lane)):
                S_q[18 * (first + lane) + c] = to[c]
    left = 0
    for lane in range(last - first + 1):
        regular = (w[7776 + lane] > 0.0) & (w[7808 + lane] > 0.0)
        status[first + lane] = SOLVED if regular else OPEN
        left += 0 if regular else 1
    return left


def sensitivity(x, q, tool, k, S_p, S_q, status):
    """Fill the derivatives of the exact pose: S_p (N, 6, 30) by errors and deflections, S_q (N, 6, 3) by joints.

    Rows are px, py, pz, then turns of the platform about
    the axes of {O}. Columns of S_p run limb by limb. S_q is the velocity Jacobian.
    """
    if _sensitivity(x, q, tool, k, S_p, S_q, status):
        left = np.flatnonzero(status == OPEN)
        by_errors, by_joints, of = (
            np.empty((len(left), 6, 30)), np.empty((len(left), 6, 3)),
            np.zeros(len(left), dtype=np.int64),
        )
        vectorised.sensitivity(
            x[left], q[left], _of(tool, left, len(status)), _of(k, left, len(status)), by_errors, by_joints, of
        )
        S_p[left], S_q[left], status[left] = by_errors, by_joints, of

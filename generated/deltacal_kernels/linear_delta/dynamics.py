"""Dynamics of `linear_delta`, many samples at once: Linear delta, three towers and six rods.

Generated from derive/mechanisms/linear_delta.py by "deltacal kernels". Do not edit.
Template templates/mechanism/dynamics.py.jinja; sha256 of both 3e29bb078e2716fa; SymPy 1.14.0.

Arrays are C-contiguous float64, the sample first; mm, rad, s, kg, N:

x (N, 6)  platform: px py pz cx cy cz
motion (3, N, 3)  joints, their velocities, their accelerations      tool (N or 1, 3)  reference point in {O'}
k (M, 3, ...)  what `constants` of ``kinematics.py`` makes of p; each of the M machines has N / M of the samples
c (M, 3, 16)  what `constants` makes of p (M, 3, 16)
gravity (3,)  in {O} [m/s^2]      shares (3,)  of a rod's mass at either end: 1/6 where it is uniform
inertia (8,)  of `LIMB`, limb by limb, then of `PLATFORM`, of which the payload is the last

Samples stand side by side as in ``kinematics.py``: a limb has a second region d, and s holds what all limbs share. What
bodies ask for is linear in their inertial parameters: `torque` sums it up, `regressor` gives it one by one, without the
payload. Both are NaN where x is, and where the machine is singular or nearly so.
"""

import math

import numpy as np

from deltacal_kernels.cache import kernel
from deltacal_kernels.elementary import cosine, scratch, sine
from deltacal_kernels.straight import straight

from .blocks import LANES, WORK, hold, load
from .kinematics import _begin, _early, _inverse_of_rows, _joints, _more, _place, _rows
from .kinematics import _move as _move_platform

# (name, unit, meaning) of the inertial parameters of a limb, and of the platform
LIMB = (
    ("m_carriage", "kg", "mass of the carriage"),
    ("m_rod", "kg", "mass of each of the two rods"),
)
PLATFORM = (
    ("m_platform", "kg", "mass of the platform, at its centre"),
    ("payload", "kg", "mass at the reference point"),
)
OWN, SHARED = 1056, 2016  # numbers of a limb's second region; of what all share
fast = kernel(nogil=True, error_model="numpy", fastmath={"contract"})


def stated(geometry, masses, own):
    """Return what a robot file says of inertial parameters, by name: one value, or one per limb.

    `own` is a limb's own inertia about its centre of mass [kg mm^2].
    """
    carriage = masses["carriage"]
    distal_rod = masses["distal_rod"]
    platform = masses["platform"]
    return {
        "m_carriage": carriage,
        "m_rod": distal_rod,
        "m_platform": platform,
    }


@straight
def _fill(p, k, rows):
    for lane in range(rows):
        r = p[16 * lane + 0]
        l = p[16 * lane + 1]
        phi = p[16 * lane + 2]
        home = p[16 * lane + 3]
        a = p[16 * lane + 4]
        c = p[16 * lane + 5]
        endstop = p[16 * lane + 6]
        arm = p[16 * lane + 7]
        radius = p[16 * lane + 8]
        angle = p[16 * lane + 9]
        lean_radial = p[16 * lane + 10]
        lean_tangential = p[16 * lane + 11]
        scale = p[16 * lane + 12]
        dr = p[16 * lane + 14]
        s0 = angle + phi
        u_x = cosine(s0)
        u_y = sine(s0)
        arm_0 = arm + l
        r_0 = dr + r + radius
        s7 = lean_radial*u_x - lean_tangential*u_y
        s8 = (s7 * s7)
        s11 = -lean_radial*u_y - lean_tangential*u_x
        s12 = (s11 * s11)
        s13 = s12 + s8
        s21 = s13*(s13*(s13*(2.8114572543455206e-15*s12 + 2.8114572543455206e-15*s8 - 7.647163731819816e-13) + 1.6059043836821613e-10) - 2.505210838544172e-08)
        s29 = s13*(s13*(s13*(s13*(s21 + 2.7557319223985893e-06) - 0.0001984126984126984) + 0.008333333333333333) - 0.16666666666666666)
        s30 = s29 + 1
        axis_x = s30*s7
        axis_y = -s11*s30
        s40 = s13*(s13*(s13*(1.5619206968586225e-16*s12 + 1.5619206968586225e-16*s8 - 4.779477332387385e-14) + 1.1470745597729725e-11) - 2.08767569878681e-09)
        s48 = s13*(s13*(s13*(s13*(s40 + 2.755731922398589e-07) - 2.48015873015873e-05) + 0.001388888888888889) - 0.041666666666666664)
        s49 = s48 + 0.5
        axis_z = -(s11 * s11)*s49 - s49*(s7 * s7) + 1
        h = endstop + home + math.sqrt((arm_0 * arm_0) - (r_0 * r_0))
        s59 = h/axis_z
        s60 = scale + 1
        s64 = a + r_0
        s65 = s64*u_x
        s68 = s64*u_y
        s71 = a*u_x
        s74 = a*u_y
        s93 = 0.5*c
        s359 = -0.5*c*u_y
        s362 = 0.5*c*u_x
        s400 = -0.25*c*u_y
        s402 = 0.25*c*u_x
        k[16 * lane + 0] = s60
        k[16 * lane + 1] = s59
        k[16 * lane + 2] = axis_x
        k[16 * lane + 3] = s65
        k[16 * lane + 4] = axis_y
        k[16 * lane + 5] = s68
        k[16 * lane + 6] = axis_z
        k[16 * lane + 7] = s71
        k[16 * lane + 8] = s74
        k[16 * lane + 9] = u_x
        k[16 * lane + 10] = u_y
        k[16 * lane + 11] = s93
        k[16 * lane + 12] = s362
        k[16 * lane + 13] = s359
        k[16 * lane + 14] = s400
        k[16 * lane + 15] = s402


@fast
def _constants(p, k):
    _fill(p, k, p.shape[0] * p.shape[1])


def constants(p):
    """Return c (M, 3, 16), what no pose changes of bodies in motion, from p (101 operations)."""
    p = np.ascontiguousarray(p, dtype=float)
    c = np.empty((len(p), 3, 16))
    _constants(p, c)
    return c


@straight
def _move(w, d, s, n):
    """How the platform moves with each joint, and how it does (84 operations)."""
    for lane in range(n):
        M_0_0 = w[6624 + lane]
        M_0_1 = w[6656 + lane]
        M_0_2 = w[6688 + lane]
        M_0_3 = w[6720 + lane]
        M_0_4 = w[6752 + lane]
        M_0_5 = w[6784 + lane]
        M_1_0 = w[6816 + lane]
        M_1_1 = w[6848 + lane]
        M_1_2 = w[6880 + lane]
        M_1_3 = w[6912 + lane]
        M_1_4 = w[6944 + lane]
        M_1_5 = w[6976 + lane]
        M_2_0 = w[7008 + lane]
        M_2_1 = w[7040 + lane]
        M_2_2 = w[7072 + lane]
        M_2_3 = w[7104 + lane]
        M_2_4 = w[7136 + lane]
        M_2_5 = w[7168 + lane]
        M_3_0 = w[7200 + lane]
        M_3_1 = w[7232 + lane]
        M_3_2 = w[7264 + lane]
        M_3_3 = w[7296 + lane]
        M_3_4 = w[7328 + lane]
        M_3_5 = w[7360 + lane]
        M_4_0 = w[7392 + lane]
        M_4_1 = w[7424 + lane]
        M_4_2 = w[7456 + lane]
        M_4_3 = w[7488 + lane]
        M_4_4 = w[7520 + lane]
        M_4_5 = w[7552 + lane]
        M_5_0 = w[7584 + lane]
        M_5_1 = w[7616 + lane]
        M_5_2 = w[7648 + lane]
        M_5_3 = w[7680 + lane]
        M_5_4 = w[7712 + lane]
        M_5_5 = w[7744 + lane]
        q_t_0 = d[0 + lane]
        Q_0 = w[832 + lane]
        Q_3 = w[1088 + lane]
        q_t_1 = d[1056 + lane]
        Q_1 = w[2944 + lane]
        Q_4 = w[3200 + lane]
        q_t_2 = d[2112 + lane]
        Q_2 = w[5056 + lane]
        Q_5 = w[5312 + lane]
        V_0_0 = M_0_0*Q_0 + M_0_3*Q_3
        V_0_1 = M_0_1*Q_1 + M_0_4*Q_4
        V_0_2 = M_0_2*Q_2 + M_0_5*Q_5
        V_1_0 = M_1_0*Q_0 + M_1_3*Q_3
        V_1_1 = M_1_1*Q_1 + M_1_4*Q_4
        V_1_2 = M_1_2*Q_2 + M_1_5*Q_5
        V_2_0 = M_2_0*Q_0 + M_2_3*Q_3
        V_2_1 = M_2_1*Q_1 + M_2_4*Q_4
        V_2_2 = M_2_2*Q_2 + M_2_5*Q_5
        V_3_0 = M_3_0*Q_0 + M_3_3*Q_3
        V_3_1 = M_3_1*Q_1 + M_3_4*Q_4
        V_3_2 = M_3_2*Q_2 + M_3_5*Q_5
        V_4_0 = M_4_0*Q_0 + M_4_3*Q_3
        V_4_1 = M_4_1*Q_1 + M_4_4*Q_4
        V_4_2 = M_4_2*Q_2 + M_4_5*Q_5
        V_5_0 = M_5_0*Q_0 + M_5_3*Q_3
        V_5_1 = M_5_1*Q_1 + M_5_4*Q_4
        V_5_2 = M_5_2*Q_2 + M_5_5*Q_5
        s57 = V_0_0*q_t_0 + V_0_1*q_t_1 + V_0_2*q_t_2
        s61 = V_1_0*q_t_0 + V_1_1*q_t_1 + V_1_2*q_t_2
        s65 = V_2_0*q_t_0 + V_2_1*q_t_1 + V_2_2*q_t_2
        s69 = V_3_0*q_t_0 + V_3_1*q_t_1 + V_3_2*q_t_2
        s73 = V_4_0*q_t_0 + V_4_1*q_t_1 + V_4_2*q_t_2
        s77 = V_5_0*q_t_0 + V_5_1*q_t_1 + V_5_2*q_t_2
        s[0 + lane] = V_0_0
        s[32 + lane] = V_0_1
        s[64 + lane] = V_0_2
        s[96 + lane] = V_1_0
        s[128 + lane] = V_1_1
        s[160 + lane] = V_1_2
        s[192 + lane] = V_2_0
        s[224 + lane] = V_2_1
        s[256 + lane] = V_2_2
        s[288 + lane] = V_3_0
        s[320 + lane] = V_3_1
        s[352 + lane] = V_3_2
        s[384 + lane] = V_4_0
        s[416 + lane] = V_4_1
        s[448 + lane] = V_4_2
        s[480 + lane] = V_5_0
        s[512 + lane] = V_5_1
        s[544 + lane] = V_5_2
        s[576 + lane] = s57
        s[608 + lane] = s61
        s[640 + lane] = s65
        s[672 + lane] = s69
        s[704 + lane] = s73
        s[736 + lane] = s77


@straight
def _curved(w, d, s, k, gravity, shares, n):
    """Second derivatives of a limb's equations by time where nothing accelerates (206 operations)."""
    s60 = k[0]
    s59 = k[1]
    axis_x = k[2]
    s65 = k[3]
    axis_y = k[4]
    s68 = k[5]
    axis_z = k[6]
    s71 = k[7]
    s74 = k[8]
    u_x = k[9]
    u_y = k[10]
    s93 = k[11]
    for lane in range(n):
        q = w[0 + lane]
        tx = w[32 + lane]
        ty = w[64 + lane]
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
        v_px = s[576 + lane]
        v_py = s[608 + lane]
        v_pz = s[640 + lane]
        w_x = s[672 + lane]
        w_y = s[704 + lane]
        w_z = s[736 + lane]
        q_t = d[0 + lane]
        s62 = -q*s60 + s59
        C_x = axis_x*s62 + s65
        C_y = axis_y*s62 + s68
        C_z = axis_z*s62
        s72 = s71 - tx
        s75 = s74 - ty
        A_x = R_11*s72 + R_12*s75 - R_13*tz + px
        A_y = R_21*s72 + R_22*s75 - R_23*tz + py
        A_z = R_31*s72 + R_32*s75 - R_33*tz + pz
        d_x = A_x - C_x
        d_y = A_y - C_y
        d_z = A_z - C_z
        s_x = s93*(-R_11*u_y + R_12*u_x + u_y)
        s_y = s93*(-R_21*u_y + R_22*u_x - u_x)
        s_z = s93*(-R_31*u_y + R_32*u_x)
        s132 = -R_21*w_z + R_31*w_y
        s135 = -R_22*w_z + R_32*w_y
        s138 = -R_23*w_z + R_33*w_y
        s141 = R_11*w_z - R_31*w_x
        s144 = R_12*w_z - R_32*w_x
        s147 = R_13*w_z - R_33*w_x
        s150 = -R_11*w_y + R_21*w_x
        s153 = -R_12*w_y + R_22*w_x
        s156 = -R_13*w_y + R_23*w_x
        s157 = -q_t*s60
        s173 = -axis_x*s157 + s132*s72 + s135*s75 - s138*tz + v_px
        s174 = -axis_y*s157 + s141*s72 + s144*s75 - s147*tz + v_py
        s175 = -axis_z*s157 + s150*s72 + s153*s75 - s156*tz + v_pz
        s179 = s93*(-s132*u_y + s135*u_x)
        s183 = s93*(-s141*u_y + s144*u_x)
        s187 = s93*(-s150*u_y + s153*u_x)
        s219 = -s141*w_z + s150*w_y
        s222 = -s144*w_z + s153*w_y
        s228 = s132*w_z - s150*w_x
        s231 = s135*w_z - s153*w_x
        s237 = -s132*w_y + s141*w_x
        s240 = -s135*w_y + s144*w_x
        s247 = s219*s72 + s222*s75 - tz*(-s147*w_z + s156*w_y)
        s251 = s228*s72 + s231*s75 - tz*(s138*w_z - s156*w_x)
        s255 = s237*s72 + s240*s75 - tz*(-s138*w_y + s147*w_x)
        s259 = s93*(-s219*u_y + s222*u_x)
        s263 = s93*(-s228*u_y + s231*u_x)
        s267 = s93*(-s237*u_y + s240*u_x)
        s282 = d_z*s255 + (s175 * s175)
        s287 = (s179 * s179) + s259*s_x
        s292 = (s183 * s183) + s263*s_y
        s297 = (s187 * s187) + s267*s_z
        s298 = d_x*s247 + d_y*s251 + (s173 * s173) + (s174 * s174) + s282 + s287 + s292 + s297
        s300 = s173*s179
        s306 = s174*s183
        s312 = s175*s187
        s316 = d_z*s267 + s255*s_z + 2*s312
        s317 = d_x*s259 + d_y*s263 + s247*s_x + s251*s_y + 2*s300 + 2*s306 + s316
        d[64 + lane] = s298
        d[96 + lane] = s317


@straight
def _accelerate(w, d, s, n):
    """The platform's acceleration (102 operations)."""
    for lane in range(n):
        M_0_0 = w[6624 + lane]
        M_0_1 = w[6656 + lane]
        M_0_2 = w[6688 + lane]
        M_0_3 = w[6720 + lane]
        M_0_4 = w[6752 + lane]
        M_0_5 = w[6784 + lane]
        M_1_0 = w[6816 + lane]
        M_1_1 = w[6848 + lane]
        M_1_2 = w[6880 + lane]
        M_1_3 = w[6912 + lane]
        M_1_4 = w[6944 + lane]
        M_1_5 = w[6976 + lane]
        M_2_0 = w[7008 + lane]
        M_2_1 = w[7040 + lane]
        M_2_2 = w[7072 + lane]
        M_2_3 = w[7104 + lane]
        M_2_4 = w[7136 + lane]
        M_2_5 = w[7168 + lane]
        M_3_0 = w[7200 + lane]
        M_3_1 = w[7232 + lane]
        M_3_2 = w[7264 + lane]
        M_3_3 = w[7296 + lane]
        M_3_4 = w[7328 + lane]
        M_3_5 = w[7360 + lane]
        M_4_0 = w[7392 + lane]
        M_4_1 = w[7424 + lane]
        M_4_2 = w[7456 + lane]
        M_4_3 = w[7488 + lane]
        M_4_4 = w[7520 + lane]
        M_4_5 = w[7552 + lane]
        M_5_0 = w[7584 + lane]
        M_5_1 = w[7616 + lane]
        M_5_2 = w[7648 + lane]
        M_5_3 = w[7680 + lane]
        M_5_4 = w[7712 + lane]
        M_5_5 = w[7744 + lane]
        q_tt_0 = d[32 + lane]
        c_0 = d[64 + lane]
        c_3 = d[96 + lane]
        q_tt_1 = d[1088 + lane]
        c_1 = d[1120 + lane]
        c_4 = d[1152 + lane]
        q_tt_2 = d[2144 + lane]
        c_2 = d[2176 + lane]
        c_5 = d[2208 + lane]
        V_0_0 = s[0 + lane]
        V_0_1 = s[32 + lane]
        V_0_2 = s[64 + lane]
        V_1_0 = s[96 + lane]
        V_1_1 = s[128 + lane]
        V_1_2 = s[160 + lane]
        V_2_0 = s[192 + lane]
        V_2_1 = s[224 + lane]
        V_2_2 = s[256 + lane]
        V_3_0 = s[288 + lane]
        V_3_1 = s[320 + lane]
        V_3_2 = s[352 + lane]
        V_4_0 = s[384 + lane]
        V_4_1 = s[416 + lane]
        V_4_2 = s[448 + lane]
        V_5_0 = s[480 + lane]
        V_5_1 = s[512 + lane]
        V_5_2 = s[544 + lane]
        s4 = M_0_4*c_4
        s5 = M_0_5*c_5
        s6 = V_0_0*q_tt_0
        s7 = V_0_1*q_tt_1
        s8 = V_0_2*q_tt_2
        s9 = M_0_0*c_0 + M_0_1*c_1 + M_0_2*c_2 + M_0_3*c_3 + s4 + s5 + s6 + s7 + s8
        s14 = M_1_4*c_4
        s15 = M_1_5*c_5
        s16 = V_1_0*q_tt_0
        s17 = V_1_1*q_tt_1
        s18 = V_1_2*q_tt_2
        s19 = M_1_0*c_0 + M_1_1*c_1 + M_1_2*c_2 + M_1_3*c_3 + s14 + s15 + s16 + s17 + s18
        s24 = M_2_4*c_4
        s25 = M_2_5*c_5
        s26 = V_2_0*q_tt_0
        s27 = V_2_1*q_tt_1
        s28 = V_2_2*q_tt_2
        s29 = M_2_0*c_0 + M_2_1*c_1 + M_2_2*c_2 + M_2_3*c_3 + s24 + s25 + s26 + s27 + s28
        s34 = M_3_4*c_4
        s35 = M_3_5*c_5
        s36 = V_3_0*q_tt_0
        s37 = V_3_1*q_tt_1
        s38 = V_3_2*q_tt_2
        s39 = M_3_0*c_0 + M_3_1*c_1 + M_3_2*c_2 + M_3_3*c_3 + s34 + s35 + s36 + s37 + s38
        s44 = M_4_4*c_4
        s45 = M_4_5*c_5
        s46 = V_4_0*q_tt_0
        s47 = V_4_1*q_tt_1
        s48 = V_4_2*q_tt_2
        s49 = M_4_0*c_0 + M_4_1*c_1 + M_4_2*c_2 + M_4_3*c_3 + s44 + s45 + s46 + s47 + s48
        s54 = M_5_4*c_4
        s55 = M_5_5*c_5
        s56 = V_5_0*q_tt_0
        s57 = V_5_1*q_tt_1
        s58 = V_5_2*q_tt_2
        s59 = M_5_0*c_0 + M_5_1*c_1 + M_5_2*c_2 + M_5_3*c_3 + s54 + s55 + s56 + s57 + s58
        s[768 + lane] = s9
        s[800 + lane] = s19
        s[832 + lane] = s29
        s[864 + lane] = s39
        s[896 + lane] = s49
        s[928 + lane] = s59


@straight
def _limb_fields(w, d, s, k, gravity, shares, n):
    """Gravity less acceleration of the points of a limb (226 operations)."""
    gx = gravity[0]
    gy = gravity[1]
    gz = gravity[2]
    s60 = k[0]
    axis_x = k[2]
    axis_y = k[4]
    axis_z = k[6]
    s71 = k[7]
    s74 = k[8]
    s362 = k[12]
    s359 = k[13]
    s400 = k[14]
    s402 = k[15]
    for lane in range(n):
        tx = w[32 + lane]
        ty = w[64 + lane]
        tz = w[96 + lane]
        R_11 = w[320 + lane]
        R_12 = w[352 + lane]
        R_13 = w[384 + lane]
        R_21 = w[416 + lane]
        R_22 = w[448 + lane]
        R_23 = w[480 + lane]
        R_31 = w[512 + lane]
        R_32 = w[544 + lane]
        R_33 = w[576 + lane]
        w_x = s[672 + lane]
        w_y = s[704 + lane]
        w_z = s[736 + lane]
        v_px_t = s[768 + lane]
        v_py_t = s[800 + lane]
        v_pz_t = s[832 + lane]
        w_x_t = s[864 + lane]
        w_y_t = s[896 + lane]
        w_z_t = s[928 + lane]
        q_tt = d[32 + lane]
        s72 = s71 - tx
        s75 = s74 - ty
        s132 = -R_21*w_z + R_31*w_y
        s135 = -R_22*w_z + R_32*w_y
        s138 = -R_23*w_z + R_33*w_y
        s141 = R_11*w_z - R_31*w_x
        s144 = R_12*w_z - R_32*w_x
        s147 = R_13*w_z - R_33*w_x
        s150 = -R_11*w_y + R_21*w_x
        s153 = -R_12*w_y + R_22*w_x
        s156 = -R_13*w_y + R_23*w_x
        s845 = -R_21*w_z_t + R_31*w_y_t - s141*w_z + s150*w_y
        s850 = -R_22*w_z_t + R_32*w_y_t - s144*w_z + s153*w_y
        s860 = R_11*w_z_t - R_31*w_x_t + s132*w_z - s150*w_x
        s865 = R_12*w_z_t - R_32*w_x_t + s135*w_z - s153*w_x
        s875 = -R_11*w_y_t + R_21*w_x_t - s132*w_y + s141*w_x
        s880 = -R_12*w_y_t + R_22*w_x_t - s135*w_y + s144*w_x
        s886 = -q_tt*s60
        s887 = axis_x*s886
        s888 = axis_y*s886
        s889 = axis_z*s886
        s892 = -tz*(-R_23*w_z_t + R_33*w_y_t - s147*w_z + s156*w_y)
        s893 = s72*s845 + s75*s850 + s892 + v_px_t
        s896 = -tz*(R_13*w_z_t - R_33*w_x_t + s138*w_z - s156*w_x)
        s897 = s72*s860 + s75*s865 + s896 + v_py_t
        s900 = -tz*(-R_13*w_y_t + R_23*w_x_t - s138*w_y + s147*w_x)
        s901 = s72*s875 + s75*s880 + s900 + v_pz_t
        s1427 = s362*s850
        s1428 = s359*s845
        s1431 = s362*s865
        s1432 = s359*s860
        s1435 = s362*s880
        s1436 = s359*s875
        s1449 = 0.5*s893
        s1450 = 0.5*s887
        s1451 = s400*s845
        s1452 = s402*s850
        s1455 = 0.5*s897
        s1456 = 0.5*s888
        s1457 = s400*s860
        s1458 = s402*s865
        s1461 = 0.5*s901
        s1462 = 0.5*s889
        s1463 = s400*s875
        s1464 = s402*s880
        s1550 = gx - 0.001*s887
        s1552 = gy - 0.001*s888
        s1554 = gz - 0.001*s889
        s1556 = gx - 0.001*s1449 - 0.001*s1450 - 0.001*s1451 - 0.001*s1452
        s1558 = gy - 0.001*s1455 - 0.001*s1456 - 0.001*s1457 - 0.001*s1458
        s1560 = gz - 0.001*s1461 - 0.001*s1462 - 0.001*s1463 - 0.001*s1464
        s1562 = gx - 0.001*s1427 - 0.001*s1428 - 0.001*s893
        s1564 = gy - 0.001*s1431 - 0.001*s1432 - 0.001*s897
        s1566 = gz - 0.001*s1435 - 0.001*s1436 - 0.001*s901
        s1568 = gx - 0.001*s1449 - 0.001*s1450 + 0.001*s1451 + 0.001*s1452
        s1570 = gy - 0.001*s1455 - 0.001*s1456 + 0.001*s1457 + 0.001*s1458
        s1572 = gz - 0.001*s1461 - 0.001*s1462 + 0.001*s1463 + 0.001*s1464
        s1574 = gx + 0.001*s1427 + 0.001*s1428 - 0.001*s893
        s1576 = gy + 0.001*s1431 + 0.001*s1432 - 0.001*s897
        s1578 = gz + 0.001*s1435 + 0.001*s1436 - 0.001*s901
        d[128 + lane] = s1550
        d[160 + lane] = s1552
        d[192 + lane] = s1554
        d[224 + lane] = s1550
        d[256 + lane] = s1552
        d[288 + lane] = s1554
        d[320 + lane] = s1556
        d[352 + lane] = s1558
        d[384 + lane] = s1560
        d[416 + lane] = s1562
        d[448 + lane] = s1564
        d[480 + lane] = s1566
        d[512 + lane] = s1550
        d[544 + lane] = s1552
        d[576 + lane] = s1554
        d[608 + lane] = s1568
        d[640 + lane] = s1570
        d[672 + lane] = s1572
        d[704 + lane] = s1574
        d[736 + lane] = s1576
        d[768 + lane] = s1578


@straight
def _limb_asks(w, d, s, k, gravity, shares, n):
    """Loads per inertial parameter of a limb, along joint, shifts and turns (132 operations)."""
    share = shares[0]
    s60 = k[0]
    axis_x = k[2]
    axis_y = k[4]
    axis_z = k[6]
    s71 = k[7]
    s74 = k[8]
    s362 = k[12]
    s359 = k[13]
    s400 = k[14]
    s402 = k[15]
    for lane in range(n):
        tx = w[32 + lane]
        ty = w[64 + lane]
        tz = w[96 + lane]
        R_11 = w[320 + lane]
        R_12 = w[352 + lane]
        R_13 = w[384 + lane]
        R_21 = w[416 + lane]
        R_22 = w[448 + lane]
        R_23 = w[480 + lane]
        R_31 = w[512 + lane]
        R_32 = w[544 + lane]
        R_33 = w[576 + lane]
        f0x = d[128 + lane]
        f0y = d[160 + lane]
        f0z = d[192 + lane]
        f1x = d[224 + lane]
        f1y = d[256 + lane]
        f1z = d[288 + lane]
        f2x = d[320 + lane]
        f2y = d[352 + lane]
        f2z = d[384 + lane]
        f3x = d[416 + lane]
        f3y = d[448 + lane]
        f3z = d[480 + lane]
        f4x = d[512 + lane]
        f4y = d[544 + lane]
        f4z = d[576 + lane]
        f5x = d[608 + lane]
        f5y = d[640 + lane]
        f5z = d[672 + lane]
        f6x = d[704 + lane]
        f6y = d[736 + lane]
        f6z = d[768 + lane]
        s72 = s71 - tx
        s75 = s74 - ty
        s356 = -s60*(axis_x*f0x + axis_y*f0y + axis_z*f0z)
        s397 = 1 - 2*share
        s430 = f5z*s397
        s432 = f5y*s397
        s434 = f5x*s397
        s436 = f2z*s397
        s437 = -s430 + s436
        s443 = 0.5*s430 + 0.5*s436
        s445 = f2y*s397
        s446 = -s432 + s445
        s452 = 0.5*s432 + 0.5*s445
        s454 = f2x*s397
        s455 = -s434 + s454
        s461 = 0.5*s434 + 0.5*s454
        s465 = f6z*share
        s467 = f6y*share
        s469 = f6x*share
        s471 = f3z*share
        s472 = -s465 + s471
        s478 = f3y*share
        s479 = -s467 + s478
        s485 = f3x*share
        s486 = -s469 + s485
        s502 = s443 + s465 + s471
        s503 = -s502*tz
        s509 = s452 + s467 + s478
        s510 = -s509*tz
        s516 = s461 + s469 + s485
        s517 = -s516*tz
        s533 = axis_x*(f1x*share + f4x*share + s461)
        s534 = axis_y*(f1y*share + f4y*share + s452) + axis_z*(f1z*share + f4z*share + s443) + s533
        s535 = -s534*s60
        s539 = s362*s472 + s402*s437 + s502*s75
        s540 = s359*s472 + s400*s437 + s502*s72
        s541 = s362*s479 + s402*s446 + s509*s75
        s542 = s359*s479 + s400*s446 + s509*s72
        s543 = s362*s486 + s402*s455 + s516*s75
        s544 = s359*s486 + s400*s455 + s516*s72
        s555 = R_21*s540 + R_22*s539 + R_23*s503 - R_31*s542 - R_32*s541 - R_33*s510
        s562 = -R_11*s540 - R_12*s539 - R_13*s503 + R_31*s544 + R_32*s543 + R_33*s517
        s569 = R_11*s542 + R_12*s541 + R_13*s510 - R_21*s544 - R_22*s543 - R_23*s517
        d[800 + lane] = s356
        d[832 + lane] = s535
        d[864 + lane] = s516
        d[896 + lane] = s509
        d[928 + lane] = s502
        d[960 + lane] = s555
        d[992 + lane] = s562
        d[1024 + lane] = s569


@straight
def _platform_fields(w, d, s, gravity, n):
    """Gravity less acceleration of the points of a platform (126 operations)."""
    gx = gravity[0]
    gy = gravity[1]
    gz = gravity[2]
    for lane in range(n):
        tx = w[32 + lane]
        ty = w[64 + lane]
        tz = w[96 + lane]
        R_11 = w[320 + lane]
        R_12 = w[352 + lane]
        R_13 = w[384 + lane]
        R_21 = w[416 + lane]
        R_22 = w[448 + lane]
        R_23 = w[480 + lane]
        R_31 = w[512 + lane]
        R_32 = w[544 + lane]
        R_33 = w[576 + lane]
        w_x = s[672 + lane]
        w_y = s[704 + lane]
        w_z = s[736 + lane]
        v_px_t = s[768 + lane]
        v_py_t = s[800 + lane]
        v_pz_t = s[832 + lane]
        w_x_t = s[864 + lane]
        w_y_t = s[896 + lane]
        w_z_t = s[928 + lane]
        s164 = -R_21*w_z + R_31*w_y
        s167 = -R_22*w_z + R_32*w_y
        s170 = -R_23*w_z + R_33*w_y
        s173 = R_11*w_z - R_31*w_x
        s176 = R_12*w_z - R_32*w_x
        s179 = R_13*w_z - R_33*w_x
        s182 = -R_11*w_y + R_21*w_x
        s185 = -R_12*w_y + R_22*w_x
        s188 = -R_13*w_y + R_23*w_x
        s373 = -tx*(-R_21*w_z_t + R_31*w_y_t - s173*w_z + s182*w_y)
        s374 = -ty*(-R_22*w_z_t + R_32*w_y_t - s176*w_z + s185*w_y)
        s375 = s373 + s374 - tz*(-R_23*w_z_t + R_33*w_y_t - s179*w_z + s188*w_y) + v_px_t
        s377 = -tx*(R_11*w_z_t - R_31*w_x_t + s164*w_z - s182*w_x)
        s378 = -ty*(R_12*w_z_t - R_32*w_x_t + s167*w_z - s185*w_x)
        s379 = s377 + s378 - tz*(R_13*w_z_t - R_33*w_x_t + s170*w_z - s188*w_x) + v_py_t
        s381 = -tx*(-R_11*w_y_t + R_21*w_x_t - s164*w_y + s173*w_x)
        s382 = -ty*(-R_12*w_y_t + R_22*w_x_t - s167*w_y + s176*w_x)
        s383 = s381 + s382 - tz*(-R_13*w_y_t + R_23*w_x_t - s170*w_y + s179*w_x) + v_pz_t
        s487 = gx - 0.001*s375
        s489 = gy - 0.001*s379
        s491 = gz - 0.001*s383
        s493 = gx - 0.001*v_px_t
        s495 = gy - 0.001*v_py_t
        s497 = gz - 0.001*v_pz_t
        s[960 + lane] = s487
        s[992 + lane] = s489
        s[1024 + lane] = s491
        s[1056 + lane] = s493
        s[1088 + lane] = s495
        s[1120 + lane] = s497


@straight
def _platform_asks(w, d, s, n):
    """Loads per inertial parameter of a platform, along joint, shifts and turns (51 operations)."""
    for lane in range(n):
        tx = w[32 + lane]
        ty = w[64 + lane]
        tz = w[96 + lane]
        R_11 = w[320 + lane]
        R_12 = w[352 + lane]
        R_13 = w[384 + lane]
        R_21 = w[416 + lane]
        R_22 = w[448 + lane]
        R_23 = w[480 + lane]
        R_31 = w[512 + lane]
        R_32 = w[544 + lane]
        R_33 = w[576 + lane]
        f0x = s[960 + lane]
        f0y = s[992 + lane]
        f0z = s[1024 + lane]
        f1x = s[1056 + lane]
        f1y = s[1088 + lane]
        f1z = s[1120 + lane]
        s116 = -f0z*ty
        s118 = -f0z*tx
        s120 = -f0y*ty
        s122 = -f0y*tx
        s124 = -f0x*ty
        s126 = -f0x*tx
        s128 = -f0z*tz
        s130 = -f0y*tz
        s132 = -f0x*tz
        s143 = R_21*s118 + R_22*s116 + R_23*s128 - R_31*s122 - R_32*s120 - R_33*s130
        s150 = -R_11*s118 - R_12*s116 - R_13*s128 + R_31*s126 + R_32*s124 + R_33*s132
        s157 = R_11*s122 + R_12*s120 + R_13*s130 - R_21*s126 - R_22*s124 - R_23*s132
        s[1152 + lane] = f0x
        s[1184 + lane] = f0y
        s[1216 + lane] = f0z
        s[1248 + lane] = s143
        s[1280 + lane] = s150
        s[1312 + lane] = s157
        s[1344 + lane] = f1x
        s[1376 + lane] = f1y
        s[1408 + lane] = f1z


@straight
def _give(d, s, inertia, n):
    """What the joints give (102 operations)."""
    m_0 = inertia[0]
    m_1 = inertia[1]
    m_2 = inertia[2]
    m_3 = inertia[3]
    m_4 = inertia[4]
    m_5 = inertia[5]
    m_6 = inertia[6]
    m_7 = inertia[7]
    for lane in range(n):
        a_0_0 = d[800 + lane]
        a_0_1 = d[832 + lane]
        a_0_2 = d[864 + lane]
        a_0_3 = d[896 + lane]
        a_0_4 = d[928 + lane]
        a_0_5 = d[960 + lane]
        a_0_6 = d[992 + lane]
        a_0_7 = d[1024 + lane]
        a_1_0 = d[1856 + lane]
        a_1_1 = d[1888 + lane]
        a_1_2 = d[1920 + lane]
        a_1_3 = d[1952 + lane]
        a_1_4 = d[1984 + lane]
        a_1_5 = d[2016 + lane]
        a_1_6 = d[2048 + lane]
        a_1_7 = d[2080 + lane]
        a_2_0 = d[2912 + lane]
        a_2_1 = d[2944 + lane]
        a_2_2 = d[2976 + lane]
        a_2_3 = d[3008 + lane]
        a_2_4 = d[3040 + lane]
        a_2_5 = d[3072 + lane]
        a_2_6 = d[3104 + lane]
        a_2_7 = d[3136 + lane]
        a_p_0 = s[1152 + lane]
        a_p_1 = s[1184 + lane]
        a_p_2 = s[1216 + lane]
        a_p_3 = s[1248 + lane]
        a_p_4 = s[1280 + lane]
        a_p_5 = s[1312 + lane]
        a_p_6 = s[1344 + lane]
        a_p_7 = s[1376 + lane]
        a_p_8 = s[1408 + lane]
        V_0_0 = s[0 + lane]
        V_0_1 = s[32 + lane]
        V_0_2 = s[64 + lane]
        V_1_0 = s[96 + lane]
        V_1_1 = s[128 + lane]
        V_1_2 = s[160 + lane]
        V_2_0 = s[192 + lane]
        V_2_1 = s[224 + lane]
        V_2_2 = s[256 + lane]
        V_3_0 = s[288 + lane]
        V_3_1 = s[320 + lane]
        V_3_2 = s[352 + lane]
        V_4_0 = s[384 + lane]
        V_4_1 = s[416 + lane]
        V_4_2 = s[448 + lane]
        V_5_0 = s[480 + lane]
        V_5_1 = s[512 + lane]
        V_5_2 = s[544 + lane]
        W_0 = a_0_2*m_1 + a_1_2*m_3 + a_2_2*m_5 + a_p_0*m_6 + a_p_6*m_7
        W_1 = a_0_3*m_1 + a_1_3*m_3 + a_2_3*m_5 + a_p_1*m_6 + a_p_7*m_7
        W_2 = a_0_4*m_1 + a_1_4*m_3 + a_2_4*m_5 + a_p_2*m_6 + a_p_8*m_7
        W_3 = a_0_5*m_1 + a_1_5*m_3 + a_2_5*m_5 + a_p_3*m_6
        W_4 = a_0_6*m_1 + a_1_6*m_3 + a_2_6*m_5 + a_p_4*m_6
        W_5 = a_0_7*m_1 + a_1_7*m_3 + a_2_7*m_5 + a_p_5*m_6
        s38 = -V_5_0*W_5
        s39 = -a_0_0*m_0
        s40 = -a_0_1*m_1
        s41 = -V_0_0*W_0 - V_1_0*W_1 - V_2_0*W_2 - V_3_0*W_3 - V_4_0*W_4 + s38 + s39 + s40
        s47 = -V_5_1*W_5
        s48 = -a_1_0*m_2
        s49 = -a_1_1*m_3
        s50 = -V_0_1*W_0 - V_1_1*W_1 - V_2_1*W_2 - V_3_1*W_3 - V_4_1*W_4 + s47 + s48 + s49
        s56 = -V_5_2*W_5
        s57 = -a_2_0*m_4
        s58 = -a_2_1*m_5
        s59 = -V_0_2*W_0 - V_1_2*W_1 - V_2_2*W_2 - V_3_2*W_3 - V_4_2*W_4 + s56 + s57 + s58
        s[1440 + lane] = s41
        s[1472 + lane] = s50
        s[1504 + lane] = s59


@straight
def _give_each(d, s, n):
    """What the joints give for each inertial parameter (150 operations)."""
    for lane in range(n):
        a_0_0 = d[800 + lane]
        a_0_1 = d[832 + lane]
        a_0_2 = d[864 + lane]
        a_0_3 = d[896 + lane]
        a_0_4 = d[928 + lane]
        a_0_5 = d[960 + lane]
        a_0_6 = d[992 + lane]
        a_0_7 = d[1024 + lane]
        a_1_0 = d[1856 + lane]
        a_1_1 = d[1888 + lane]
        a_1_2 = d[1920 + lane]
        a_1_3 = d[1952 + lane]
        a_1_4 = d[1984 + lane]
        a_1_5 = d[2016 + lane]
        a_1_6 = d[2048 + lane]
        a_1_7 = d[2080 + lane]
        a_2_0 = d[2912 + lane]
        a_2_1 = d[2944 + lane]
        a_2_2 = d[2976 + lane]
        a_2_3 = d[3008 + lane]
        a_2_4 = d[3040 + lane]
        a_2_5 = d[3072 + lane]
        a_2_6 = d[3104 + lane]
        a_2_7 = d[3136 + lane]
        a_p_0 = s[1152 + lane]
        a_p_1 = s[1184 + lane]
        a_p_2 = s[1216 + lane]
        a_p_3 = s[1248 + lane]
        a_p_4 = s[1280 + lane]
        a_p_5 = s[1312 + lane]
        V_0_0 = s[0 + lane]
        V_0_1 = s[32 + lane]
        V_0_2 = s[64 + lane]
        V_1_0 = s[96 + lane]
        V_1_1 = s[128 + lane]
        V_1_2 = s[160 + lane]
        V_2_0 = s[192 + lane]
        V_2_1 = s[224 + lane]
        V_2_2 = s[256 + lane]
        V_3_0 = s[288 + lane]
        V_3_1 = s[320 + lane]
        V_3_2 = s[352 + lane]
        V_4_0 = s[384 + lane]
        V_4_1 = s[416 + lane]
        V_4_2 = s[448 + lane]
        V_5_0 = s[480 + lane]
        V_5_1 = s[512 + lane]
        V_5_2 = s[544 + lane]
        s5 = -V_5_0*a_0_7
        s6 = -V_0_0*a_0_2 - V_1_0*a_0_3 - V_2_0*a_0_4 - V_3_0*a_0_5 - V_4_0*a_0_6 - a_0_1 + s5
        s13 = -V_0_1*a_0_2 - V_1_1*a_0_3 - V_2_1*a_0_4 - V_3_1*a_0_5 - V_4_1*a_0_6 - V_5_1*a_0_7
        s20 = -V_0_2*a_0_2 - V_1_2*a_0_3 - V_2_2*a_0_4 - V_3_2*a_0_5 - V_4_2*a_0_6 - V_5_2*a_0_7
        s27 = -V_0_0*a_1_2 - V_1_0*a_1_3 - V_2_0*a_1_4 - V_3_0*a_1_5 - V_4_0*a_1_6 - V_5_0*a_1_7
        s33 = -V_5_1*a_1_7
        s34 = -V_0_1*a_1_2 - V_1_1*a_1_3 - V_2_1*a_1_4 - V_3_1*a_1_5 - V_4_1*a_1_6 - a_1_1 + s33
        s41 = -V_0_2*a_1_2 - V_1_2*a_1_3 - V_2_2*a_1_4 - V_3_2*a_1_5 - V_4_2*a_1_6 - V_5_2*a_1_7
        s48 = -V_0_0*a_2_2 - V_1_0*a_2_3 - V_2_0*a_2_4 - V_3_0*a_2_5 - V_4_0*a_2_6 - V_5_0*a_2_7
        s55 = -V_0_1*a_2_2 - V_1_1*a_2_3 - V_2_1*a_2_4 - V_3_1*a_2_5 - V_4_1*a_2_6 - V_5_1*a_2_7
        s61 = -V_5_2*a_2_7
        s62 = -V_0_2*a_2_2 - V_1_2*a_2_3 - V_2_2*a_2_4 - V_3_2*a_2_5 - V_4_2*a_2_6 - a_2_1 + s61
        s69 = -V_0_0*a_p_0 - V_1_0*a_p_1 - V_2_0*a_p_2 - V_3_0*a_p_3 - V_4_0*a_p_4 - V_5_0*a_p_5
        s76 = -V_0_1*a_p_0 - V_1_1*a_p_1 - V_2_1*a_p_2 - V_3_1*a_p_3 - V_4_1*a_p_4 - V_5_1*a_p_5
        s83 = -V_0_2*a_p_0 - V_1_2*a_p_1 - V_2_2*a_p_2 - V_3_2*a_p_3 - V_4_2*a_p_4 - V_5_2*a_p_5
        s[1536 + lane] = -a_0_0
        s[1568 + lane] = s6
        s[1600 + lane] = s13
        s[1632 + lane] = s20
        s[1664 + lane] = -a_1_0
        s[1696 + lane] = s27
        s[1728 + lane] = s34
        s[1760 + lane] = s41
        s[1792 + lane] = -a_2_0
        s[1824 + lane] = s48
        s[1856 + lane] = s55
        s[1888 + lane] = s62
        s[1920 + lane] = s69
        s[1952 + lane] = s76
        s[1984 + lane] = s83


@straight
def _rates(speeds, accelerations, d, first, last, n):
    """Put velocities and accelerations of the joints side by side, the last ones again for the rest of `n`."""
    for lane in range(n):
        m = min(first + lane, last)
        d[0 + lane] = speeds[3 * m + 0]
        d[32 + lane] = accelerations[3 * m + 0]
        d[1056 + lane] = speeds[3 * m + 1]
        d[1088 + lane] = accelerations[3 * m + 1]
        d[2112 + lane] = speeds[3 * m + 2]
        d[2144 + lane] = accelerations[3 * m + 2]


@straight
def _pay(w, s, tau, first, last):
    """Write what the joints give."""
    for lane in range(last - first + 1):
        regular = (w[7776 + lane] > 0.0) & (w[7808 + lane] > 0.0)
        tau[3 * (first + lane) + 0] = s[1440 + lane] if regular else math.nan
        tau[3 * (first + lane) + 1] = s[1472 + lane] if regular else math.nan
        tau[3 * (first + lane) + 2] = s[1504 + lane] if regular else math.nan


@straight
def _pay_each(w, s, Y, first, last):
    """Write what the joints give for each inertial parameter."""
    for lane in range(last - first + 1):
        regular = (w[7776 + lane] > 0.0) & (w[7808 + lane] > 0.0)
        Y[21 * (first + lane) + 0] = s[1536 + lane] if regular else math.nan
        Y[21 * (first + lane) + 1] = s[1568 + lane] if regular else math.nan
        Y[21 * (first + lane) + 2] = 0.0 if regular else math.nan
        Y[21 * (first + lane) + 3] = s[1696 + lane] if regular else math.nan
        Y[21 * (first + lane) + 4] = 0.0 if regular else math.nan
        Y[21 * (first + lane) + 5] = s[1824 + lane] if regular else math.nan
        Y[21 * (first + lane) + 6] = s[1920 + lane] if regular else math.nan
        Y[21 * (first + lane) + 7] = 0.0 if regular else math.nan
        Y[21 * (first + lane) + 8] = s[1600 + lane] if regular else math.nan
        Y[21 * (first + lane) + 9] = s[1664 + lane] if regular else math.nan
        Y[21 * (first + lane) + 10] = s[1728 + lane] if regular else math.nan
        Y[21 * (first + lane) + 11] = 0.0 if regular else math.nan
        Y[21 * (first + lane) + 12] = s[1856 + lane] if regular else math.nan
        Y[21 * (first + lane) + 13] = s[1952 + lane] if regular else math.nan
        Y[21 * (first + lane) + 14] = 0.0 if regular else math.nan
        Y[21 * (first + lane) + 15] = s[1632 + lane] if regular else math.nan
        Y[21 * (first + lane) + 16] = 0.0 if regular else math.nan
        Y[21 * (first + lane) + 17] = s[1760 + lane] if regular else math.nan
        Y[21 * (first + lane) + 18] = s[1792 + lane] if regular else math.nan
        Y[21 * (first + lane) + 19] = s[1888 + lane] if regular else math.nan
        Y[21 * (first + lane) + 20] = s[1984 + lane] if regular else math.nan


@fast
def _torque(x, motion, tool, k, c, gravity, shares, inertia, tau):
    found = tau.reshape(tau.size)
    w, d, s = scratch(WORK), scratch(3 * OWN), scratch(SHARED)
    w_1 = w[0:2112]
    w_2 = w[2112:4224]
    w_3 = w[4224:6336]
    d_1 = d[0 * OWN:1 * OWN]
    d_2 = d[1 * OWN:2 * OWN]
    d_3 = d[2 * OWN:3 * OWN]
    states = motion.reshape(motion.size)
    samples, machines = len(x), k.shape[0]
    speeds, accelerations = states[samples * 3 :], states[2 * samples * 3 :]
    if len(tool) == 1:
        hold(tool, w, 0, 0, LANES)
    each = samples // machines
    for m in range(machines):
        k_1, own_1 = k[m, 0], c[m, 0]
        k_2, own_2 = k[m, 1], c[m, 1]
        k_3, own_3 = k[m, 2], c[m, 2]
        for first in range(m * each, (m + 1) * each, LANES):
            last = min(first + LANES, (m + 1) * each) - 1
            n = (last - first + 8) // 8 * 8
            load(states, w, first, last, n)
            if len(tool) > 1:
                hold(tool, w, first, last, n)
            _rates(speeds, accelerations, d, first, last, n)
            _place(x, w, first, last, n)
            _begin(w, n)
            _move_platform(w, n)
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
            _inverse_of_rows(w, n)
            _move(w, d, s, n)
            _curved(w_1, d_1, s, own_1, gravity, shares[0:], n)
            _curved(w_2, d_2, s, own_2, gravity, shares[1:], n)
            _curved(w_3, d_3, s, own_3, gravity, shares[2:], n)
            _accelerate(w, d, s, n)
            _limb_fields(w_1, d_1, s, own_1, gravity, shares[0:], n)
            _limb_fields(w_2, d_2, s, own_2, gravity, shares[1:], n)
            _limb_fields(w_3, d_3, s, own_3, gravity, shares[2:], n)
            _limb_asks(w_1, d_1, s, own_1, gravity, shares[0:], n)
            _limb_asks(w_2, d_2, s, own_2, gravity, shares[1:], n)
            _limb_asks(w_3, d_3, s, own_3, gravity, shares[2:], n)
            _platform_fields(w, d, s, gravity, n)
            _platform_asks(w, d, s, n)
            _give(d, s, inertia, n)
            _pay(w, s, found, first, last)


def torque(x, motion, tool, k, c, gravity, shares, inertia, tau):
    """Fill tau (N, 3) [N mm, N]: what the joints must give, positive along positive joints."""
    _torque(x, motion, tool, k, c, gravity, shares, inertia, tau)


@fast
def _regressor(x, motion, tool, k, c, gravity, shares, Y):
    found = Y.reshape(Y.size)
    w, d, s = scratch(WORK), scratch(3 * OWN), scratch(SHARED)
    w_1 = w[0:2112]
    w_2 = w[2112:4224]
    w_3 = w[4224:6336]
    d_1 = d[0 * OWN:1 * OWN]
    d_2 = d[1 * OWN:2 * OWN]
    d_3 = d[2 * OWN:3 * OWN]
    states = motion.reshape(motion.size)
    samples, machines = len(x), k.shape[0]
    speeds, accelerations = states[samples * 3 :], states[2 * samples * 3 :]
    if len(tool) == 1:
        hold(tool, w, 0, 0, LANES)
    each = samples // machines
    for m in range(machines):
        k_1, own_1 = k[m, 0], c[m, 0]
        k_2, own_2 = k[m, 1], c[m, 1]
        k_3, own_3 = k[m, 2], c[m, 2]
        for first in range(m * each, (m + 1) * each, LANES):
            last = min(first + LANES, (m + 1) * each) - 1
            n = (last - first + 8) // 8 * 8
            load(states, w, first, last, n)
            if len(tool) > 1:
                hold(tool, w, first, last, n)
            _rates(speeds, accelerations, d, first, last, n)
            _place(x, w, first, last, n)
            _begin(w, n)
            _move_platform(w, n)
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
            _inverse_of_rows(w, n)
            _move(w, d, s, n)
            _curved(w_1, d_1, s, own_1, gravity, shares[0:], n)
            _curved(w_2, d_2, s, own_2, gravity, shares[1:], n)
            _curved(w_3, d_3, s, own_3, gravity, shares[2:], n)
            _accelerate(w, d, s, n)
            _limb_fields(w_1, d_1, s, own_1, gravity, shares[0:], n)
            _limb_fields(w_2, d_2, s, own_2, gravity, shares[1:], n)
            _limb_fields(w_3, d_3, s, own_3, gravity, shares[2:], n)
            _limb_asks(w_1, d_1, s, own_1, gravity, shares[0:], n)
            _limb_asks(w_2, d_2, s, own_2, gravity, shares[1:], n)
            _limb_asks(w_3, d_3, s, own_3, gravity, shares[2:], n)
            _platform_fields(w, d, s, gravity, n)
            _platform_asks(w, d, s, n)
            _give_each(d, s, n)
            _pay_each(w, s, found, first, last)


def regressor(x, motion, tool, k, c, gravity, shares, Y):
    """Fill Y (N, 3, 7): what the joints must give for each inertial parameter, which is 1."""
    _regressor(x, motion, tool, k, c, gravity, shares, Y)

"""Dynamics of `linear_delta`, many samples at once: Linear delta, three towers and six rods.

Generated from derive/mechanisms/linear_delta.py by "deltacal kernels". Do not edit.
Template templates/mechanism/dynamics.py.jinja; sha256 of both 96a57228e04ee532; SymPy 1.14.0.

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


@straight
def _fill_by(p, p_by, k, rows):
    for lane in range(rows):
        r_now = p[16 * lane + 0]
        l_now = p[16 * lane + 1]
        phi_now = p[16 * lane + 2]
        home_now = p[16 * lane + 3]
        a_now = p[16 * lane + 4]
        c_now = p[16 * lane + 5]
        endstop_now = p[16 * lane + 6]
        arm_now = p[16 * lane + 7]
        radius_now = p[16 * lane + 8]
        angle_now = p[16 * lane + 9]
        lean_radial_now = p[16 * lane + 10]
        lean_tangential_now = p[16 * lane + 11]
        dr_now = p[16 * lane + 14]
        r_now_by = p_by[16 * lane + 0]
        l_now_by = p_by[16 * lane + 1]
        phi_now_by = p_by[16 * lane + 2]
        home_now_by = p_by[16 * lane + 3]
        a_now_by = p_by[16 * lane + 4]
        c_now_by = p_by[16 * lane + 5]
        endstop_now_by = p_by[16 * lane + 6]
        arm_now_by = p_by[16 * lane + 7]
        radius_now_by = p_by[16 * lane + 8]
        angle_now_by = p_by[16 * lane + 9]
        lean_radial_now_by = p_by[16 * lane + 10]
        lean_tangential_now_by = p_by[16 * lane + 11]
        scale_now_by = p_by[16 * lane + 12]
        dr_now_by = p_by[16 * lane + 14]
        s0_now = angle_now + phi_now
        u_x_now = cosine(s0_now)
        u_y_now = sine(s0_now)
        arm_0_now = arm_now + l_now
        r_0_now = dr_now + r_now + radius_now
        s7_now = lean_radial_now*u_x_now - lean_tangential_now*u_y_now
        s8_now = (s7_now * s7_now)
        s11_now = -lean_radial_now*u_y_now - lean_tangential_now*u_x_now
        s12_now = (s11_now * s11_now)
        s13_now = s12_now + s8_now
        s16 = 2.8114572543455206e-15*s12_now + 2.8114572543455206e-15*s8_now - 7.647163731819816e-13
        s18 = s13_now*s16 + 1.6059043836821613e-10
        s20 = s13_now*s18 - 2.505210838544172e-08
        s21_now = s13_now*s20
        s22 = s21_now + 2.7557319223985893e-06
        s24 = s13_now*s22 - 0.0001984126984126984
        s26 = s13_now*s24 + 0.008333333333333333
        s28 = s13_now*s26 - 0.16666666666666666
        s29_now = s13_now*s28
        s30_now = s29_now + 1
        s35 = 1.5619206968586225e-16*s12_now + 1.5619206968586225e-16*s8_now - 4.779477332387385e-14
        s37 = s13_now*s35 + 1.1470745597729725e-11
        s39 = s13_now*s37 - 2.08767569878681e-09
        s40_now = s13_now*s39
        s41 = s40_now + 2.755731922398589e-07
        s43 = s13_now*s41 - 2.48015873015873e-05
        s45 = s13_now*s43 + 0.001388888888888889
        s47 = s13_now*s45 - 0.041666666666666664
        s48_now = s13_now*s47
        s49_now = s48_now + 0.5
        axis_z_now = -s12_now*s49_now - s49_now*s8_now + 1
        s55 = (arm_0_now * arm_0_now) - (r_0_now * r_0_now)
        h_now = endstop_now + home_now + math.sqrt(s55)
        s64_now = a_now + r_0_now
        s93_now = 0.5*c_now
        s71 = angle_now_by + phi_now_by
        s72 = -s71*u_y_now
        s73 = s71*u_x_now
        s75 = dr_now_by + r_now_by + radius_now_by
        s82 = lean_radial_now*s72 + lean_radial_now_by*u_x_now - lean_tangential_now*s73 - lean_tangential_now_by*u_y_now
        s84 = 2*s7_now*s82
        s91 = -lean_radial_now*s73 - lean_radial_now_by*u_y_now - lean_tangential_now*s72 - lean_tangential_now_by*u_x_now
        s93 = 2*s11_now*s91
        s94 = s84 + s93
        s106 = s13_now*(s13_now*(s13_now*(2.8114572543455206e-15*s84 + 2.8114572543455206e-15*s93) + s16*s94) + s18*s94) + s20*s94
        s118 = s13_now*(s13_now*(s13_now*(s106*s13_now + s22*s94) + s24*s94) + s26*s94) + s28*s94
        s121 = s118*s7_now + s30_now*s82
        s124 = -s118*s11_now - s30_now*s91
        s136 = s13_now*(s13_now*(s13_now*(1.5619206968586225e-16*s84 + 1.5619206968586225e-16*s93) + s35*s94) + s37*s94) + s39*s94
        s148 = s13_now*(s13_now*(s13_now*(s136*s13_now + s41*s94) + s43*s94) + s45*s94) + s47*s94
        s155 = -s12_now*s148 - s148*s8_now - s49_now*s84 - s49_now*s93
        s164 = endstop_now_by + home_now_by + 0.5*(2*arm_0_now*(arm_now_by + l_now_by) - 2*r_0_now*s75)/math.sqrt(s55)
        s169 = s164/axis_z_now - h_now*s155/(axis_z_now * axis_z_now)
        s170 = a_now_by + s75
        s173 = s170*u_x_now + s64_now*s72
        s176 = s170*u_y_now + s64_now*s73
        s179 = a_now*s72 + a_now_by*u_x_now
        s182 = a_now*s73 + a_now_by*u_y_now
        s183 = 0.5*c_now_by
        s187 = -0.5*c_now_by*u_y_now - s73*s93_now
        s191 = 0.5*c_now_by*u_x_now + s72*s93_now
        s193 = -0.25*c_now
        s196 = -0.25*c_now_by*u_y_now + s193*s73
        s200 = 0.25*c_now_by*u_x_now - s193*s72
        k[16 * lane + 0] = scale_now_by
        k[16 * lane + 1] = s169
        k[16 * lane + 2] = s121
        k[16 * lane + 3] = s173
        k[16 * lane + 4] = s124
        k[16 * lane + 5] = s176
        k[16 * lane + 6] = s155
        k[16 * lane + 7] = s179
        k[16 * lane + 8] = s182
        k[16 * lane + 9] = s72
        k[16 * lane + 10] = s73
        k[16 * lane + 11] = s183
        k[16 * lane + 12] = s191
        k[16 * lane + 13] = s187
        k[16 * lane + 14] = s196
        k[16 * lane + 15] = s200


@straight
def _fill_machine_by(p, p_by, k, rows):
    for lane in range(rows):
        r_now = p[16 * lane + 0]
        l_now = p[16 * lane + 1]
        phi_now = p[16 * lane + 2]
        home_now = p[16 * lane + 3]
        a_now = p[16 * lane + 4]
        c_now = p[16 * lane + 5]
        endstop_now = p[16 * lane + 6]
        arm_now = p[16 * lane + 7]
        radius_now = p[16 * lane + 8]
        angle_now = p[16 * lane + 9]
        lean_radial_now = p[16 * lane + 10]
        lean_tangential_now = p[16 * lane + 11]
        scale_now = p[16 * lane + 12]
        dl_now = p[16 * lane + 13]
        dr_now = p[16 * lane + 14]
        stretch_now = p[16 * lane + 15]
        r_now_by = p_by[16 * lane + 0]
        l_now_by = p_by[16 * lane + 1]
        phi_now_by = p_by[16 * lane + 2]
        home_now_by = p_by[16 * lane + 3]
        a_now_by = p_by[16 * lane + 4]
        c_now_by = p_by[16 * lane + 5]
        endstop_now_by = p_by[16 * lane + 6]
        arm_now_by = p_by[16 * lane + 7]
        radius_now_by = p_by[16 * lane + 8]
        angle_now_by = p_by[16 * lane + 9]
        lean_radial_now_by = p_by[16 * lane + 10]
        lean_tangential_now_by = p_by[16 * lane + 11]
        scale_now_by = p_by[16 * lane + 12]
        dl_now_by = p_by[16 * lane + 13]
        dr_now_by = p_by[16 * lane + 14]
        stretch_now_by = p_by[16 * lane + 15]
        s0_now = angle_now + phi_now
        u_x_now = cosine(s0_now)
        u_y_now = sine(s0_now)
        arm_0_now = arm_now + l_now
        r_0_now = dr_now + r_now + radius_now
        s7_now = lean_radial_now*u_x_now - lean_tangential_now*u_y_now
        s8_now = (s7_now * s7_now)
        s11_now = -lean_radial_now*u_y_now - lean_tangential_now*u_x_now
        s12_now = (s11_now * s11_now)
        s13_now = s12_now + s8_now
        s16_now = 2.8114572543455206e-15*s12_now + 2.8114572543455206e-15*s8_now - 7.647163731819816e-13
        s18_now = s13_now*s16_now + 1.6059043836821613e-10
        s20_now = s13_now*s18_now - 2.505210838544172e-08
        s22_now = s13_now*s20_now + 2.7557319223985893e-06
        s24_now = s13_now*s22_now - 0.0001984126984126984
        s26_now = s13_now*s24_now + 0.008333333333333333
        s28_now = s13_now*s26_now - 0.16666666666666666
        s30_now = s13_now*s28_now + 1
        axis_x_now = s30_now*s7_now
        axis_y_now = -s11_now*s30_now
        s35_now = 1.5619206968586225e-16*s12_now + 1.5619206968586225e-16*s8_now - 4.779477332387385e-14
        s37_now = s13_now*s35_now + 1.1470745597729725e-11
        s39_now = s13_now*s37_now - 2.08767569878681e-09
        s41_now = s13_now*s39_now + 2.755731922398589e-07
        s43_now = s13_now*s41_now - 2.48015873015873e-05
        s45_now = s13_now*s43_now + 0.001388888888888889
        s47_now = s13_now*s45_now - 0.041666666666666664
        s49_now = s13_now*s47_now + 0.5
        axis_z_now = -s12_now*s49_now - s49_now*s8_now + 1
        s53_now = (arm_0_now * arm_0_now)
        s55_now = -(r_0_now * r_0_now) + s53_now
        h_now = endstop_now + home_now + math.sqrt(s55_now)
        s58_now = (1.0 / axis_z_now)
        s60_now = scale_now + 1
        s64_now = a_now + r_0_now
        s128_now = 0.5*c_now
        s147_now = 0.5*dl_now
        s148_now = arm_0_now + s147_now + stretch_now
        s268_now = -2*s49_now*s7_now
        s269_now = 2*s11_now
        s270_now = 2*s7_now
        s271_now = -2*s11_now*s49_now
        s273_now = 0.5/math.sqrt(s55_now)
        s274_now = 2*arm_0_now
        s276_now = (1.0 / (axis_z_now * axis_z_now))
        s293_now = -s269_now*s7_now
        s294_now = s11_now*s270_now
        s295_now = s293_now + s294_now
        s86 = 1.5619206968586225e-16*s293_now + 1.5619206968586225e-16*s294_now
        s89 = s13_now*s86 + s295_now*s35_now
        s92 = s13_now*s89 + s295_now*s37_now
        s311_now = s13_now*s92 + s295_now*s39_now
        s98 = s13_now*s311_now + s295_now*s41_now
        s101 = s13_now*s98 + s295_now*s43_now
        s104 = s101*s13_now + s295_now*s45_now
        s319_now = s104*s13_now + s295_now*s47_now
        s326_now = s11_now*s268_now - s12_now*s319_now - s271_now*s7_now - s319_now*s8_now
        s115 = 2.8114572543455206e-15*s293_now + 2.8114572543455206e-15*s294_now
        s118 = s115*s13_now + s16_now*s295_now
        s121 = s118*s13_now + s18_now*s295_now
        s344_now = s121*s13_now + s20_now*s295_now
        s127 = s13_now*s344_now + s22_now*s295_now
        s130 = s127*s13_now + s24_now*s295_now
        s133 = s130*s13_now + s26_now*s295_now
        s352_now = s133*s13_now + s28_now*s295_now
        s364_now = -s269_now*u_y_now
        s365_now = s270_now*u_x_now
        s366_now = s364_now + s365_now
        s147 = 1.5619206968586225e-16*s364_now + 1.5619206968586225e-16*s365_now
        s150 = s13_now*s147 + s35_now*s366_now
        s153 = s13_now*s150 + s366_now*s37_now
        s382_now = s13_now*s153 + s366_now*s39_now
        s159 = s13_now*s382_now + s366_now*s41_now
        s162 = s13_now*s159 + s366_now*s43_now
        s165 = s13_now*s162 + s366_now*s45_now
        s390_now = s13_now*s165 + s366_now*s47_now
        s397_now = -s12_now*s390_now + s268_now*u_x_now - s271_now*u_y_now - s390_now*s8_now
        s177 = 2.8114572543455206e-15*s364_now + 2.8114572543455206e-15*s365_now
        s180 = s13_now*s177 + s16_now*s366_now
        s183 = s13_now*s180 + s18_now*s366_now
        s415_now = s13_now*s183 + s20_now*s366_now
        s189 = s13_now*s415_now + s22_now*s366_now
        s192 = s13_now*s189 + s24_now*s366_now
        s195 = s13_now*s192 + s26_now*s366_now
        s423_now = s13_now*s195 + s28_now*s366_now
        s435_now = -s269_now*u_x_now
        s436_now = -s270_now*u_y_now
        s437_now = s435_now + s436_now
        s210 = 1.5619206968586225e-16*s435_now + 1.5619206968586225e-16*s436_now
        s213 = s13_now*s210 + s35_now*s437_now
        s216 = s13_now*s213 + s37_now*s437_now
        s453_now = s13_now*s216 + s39_now*s437_now
        s222 = s13_now*s453_now + s41_now*s437_now
        s225 = s13_now*s222 + s437_now*s43_now
        s228 = s13_now*s225 + s437_now*s45_now
        s461_now = s13_now*s228 + s437_now*s47_now
        s468_now = -s12_now*s461_now - s268_now*u_y_now - s271_now*u_x_now - s461_now*s8_now
        s239 = 2.8114572543455206e-15*s435_now + 2.8114572543455206e-15*s436_now
        s242 = s13_now*s239 + s16_now*s437_now
        s245 = s13_now*s242 + s18_now*s437_now
        s485_now = s13_now*s245 + s20_now*s437_now
        s251 = s13_now*s485_now + s22_now*s437_now
        s254 = s13_now*s251 + s24_now*s437_now
        s257 = s13_now*s254 + s26_now*s437_now
        s493_now = s13_now*s257 + s28_now*s437_now
        s514_now = arm_0_now - s147_now + stretch_now
        s657_now = (1.0 / (s60_now * s60_now))
        s658_now = a_now + dr_now + r_now + radius_now
        s678_now = 2*scale_now + 2
        s306 = angle_now_by + phi_now_by
        s307 = -s306*u_y_now
        s308 = s306*u_x_now
        s309 = arm_now_by + l_now_by
        s310 = dr_now_by + r_now_by + radius_now_by
        s317 = lean_radial_now*s307 + lean_radial_now_by*u_x_now - lean_tangential_now*s308 - lean_tangential_now_by*u_y_now
        s318 = s270_now*s317
        s325 = -lean_radial_now*s308 - lean_radial_now_by*u_y_now - lean_tangential_now*s307 - lean_tangential_now_by*u_x_now
        s326 = s269_now*s325
        s327 = s318 + s326
        s330 = 2.8114572543455206e-15*s318 + 2.8114572543455206e-15*s326
        s333 = s13_now*s330 + s16_now*s327
        s336 = s13_now*s333 + s18_now*s327
        s339 = s13_now*s336 + s20_now*s327
        s342 = s13_now*s339 + s22_now*s327
        s345 = s13_now*s342 + s24_now*s327
        s348 = s13_now*s345 + s26_now*s327
        s351 = s13_now*s348 + s28_now*s327
        s354 = s30_now*s317 + s351*s7_now
        s357 = -s11_now*s351 - s30_now*s325
        s360 = 1.5619206968586225e-16*s318 + 1.5619206968586225e-16*s326
        s363 = s13_now*s360 + s327*s35_now
        s366 = s13_now*s363 + s327*s37_now
        s369 = s13_now*s366 + s327*s39_now
        s372 = s13_now*s369 + s327*s41_now
        s375 = s13_now*s372 + s327*s43_now
        s378 = s13_now*s375 + s327*s45_now
        s381 = s13_now*s378 + s327*s47_now
        s388 = -s12_now*s381 - s318*s49_now - s326*s49_now - s381*s8_now
        s389 = s274_now*s309
        s392 = -2*r_0_now*s310 + s389
        s394 = endstop_now_by + home_now_by + s273_now*s392
        s395 = -s276_now*s388
        s398 = h_now*s395 + s394*s58_now
        s399 = a_now_by + s310
        s402 = s307*s64_now + s399*u_x_now
        s405 = s308*s64_now + s399*u_y_now
        s408 = a_now*s307 + a_now_by*u_x_now
        s411 = a_now*s308 + a_now_by*u_y_now
        s412 = 0.5*c_now_by
        s413 = 0.5*dl_now_by
        s414 = s309 + s413 + stretch_now_by
        s417 = -s148_now*s414
        s418 = -2*s49_now
        s421 = -s270_now*s381 + s317*s418
        s422 = 2*s325
        s423 = 2*s317
        s426 = -s269_now*s381 + s325*s418
        s430 = -0.25*s392/(s55_now * math.sqrt(s55_now))
        s431 = 2*s309
        s434 = -2*s388/(axis_z_now * axis_z_now * axis_z_now)
        s441 = s273_now*s274_now*s395 + s273_now*s431*s58_now + s274_now*s430*s58_now
        s448 = -2*r_0_now*s273_now*s395 - 2*r_0_now*s430*s58_now - 2*s273_now*s310*s58_now
        s451 = -s269_now*s317 - s422*s7_now
        s454 = s11_now*s423 + s270_now*s325
        s455 = s451 + s454
        s467 = s13_now*(s13_now*(1.5619206968586225e-16*s451 + 1.5619206968586225e-16*s454) + s295_now*s360 + s327*s86 + s35_now*s455)
        s478 = s295_now*s366 + s39_now*s455
        s481 = s13_now*(s13_now*(s295_now*s363 + s327*s89 + s37_now*s455 + s467) + s327*s92 + s478)
        s492 = s295_now*s372 + s43_now*s455
        s495 = s101*s327
        s496 = s13_now*(s13_now*(s295_now*s369 + s311_now*s327 + s41_now*s455 + s481) + s327*s98 + s492) + s495
        s507 = s104*s327 + s13_now*(s295_now*s375 + s455*s45_now + s496) + s295_now*s378 + s455*s47_now
        s519 = -s318*s319_now - s507*s8_now
        s520 = s11_now*s421 - s12_now*s507 + s268_now*s325 - s271_now*s317 - s319_now*s326 - s426*s7_now + s519
        s532 = s118*s327
        s533 = s13_now*(s115*s327 + s13_now*(2.8114572543455206e-15*s451 + 2.8114572543455206e-15*s454) + s16_now*s455 + s295_now*s330) + s532
        s546 = s13_now*(s121*s327 + s13_now*(s18_now*s455 + s295_now*s333 + s533) + s20_now*s455 + s295_now*s336)
        s557 = s24_now*s455 + s295_now*s342
        s560 = s130*s327
        s561 = s13_now*(s127*s327 + s13_now*(s22_now*s455 + s295_now*s339 + s327*s344_now + s546) + s557) + s560
        s572 = s133*s327 + s13_now*(s26_now*s455 + s295_now*s345 + s561) + s28_now*s455 + s295_now*s348
        s576 = -s11_now*s572 - s325*s352_now + s354
        s580 = s317*s352_now - s357 + s572*s7_now
        s583 = -h_now*s276_now
        s587 = -h_now*s326_now*s434 - s276_now*s326_now*s394 + s520*s583
        s590 = -s269_now*s308 - s422*u_y_now
        s593 = s270_now*s307 + s423*u_x_now
        s594 = s590 + s593
        s606 = s13_now*(s13_now*(1.5619206968586225e-16*s590 + 1.5619206968586225e-16*s593) + s147*s327 + s35_now*s594 + s360*s366_now)
        s617 = s366*s366_now + s39_now*s594
        s620 = s13_now*(s13_now*(s150*s327 + s363*s366_now + s37_now*s594 + s606) + s153*s327 + s617)
        s631 = s366_now*s372 + s43_now*s594
        s634 = s13_now*(s13_now*(s327*s382_now + s366_now*s369 + s41_now*s594 + s620) + s159*s327 + s631)
        s645 = s366_now*s378 + s47_now*s594
        s646 = s13_now*(s162*s327 + s366_now*s375 + s45_now*s594 + s634) + s165*s327 + s645
        s658 = -s318*s390_now - s646*s8_now
        s659 = -s12_now*s646 + s268_now*s307 - s271_now*s308 - s326*s390_now + s421*u_x_now - s426*u_y_now + s658
        s662 = s308*s30_now + s351*u_y_now
        s674 = s13_now*(s13_now*(2.8114572543455206e-15*s590 + 2.8114572543455206e-15*s593) + s16_now*s594 + s177*s327 + s330*s366_now)
        s685 = s20_now*s594 + s336*s366_now
        s688 = s13_now*(s13_now*(s180*s327 + s18_now*s594 + s333*s366_now + s674) + s183*s327 + s685)
        s699 = s24_now*s594 + s342*s366_now
        s702 = s13_now*(s13_now*(s22_now*s594 + s327*s415_now + s339*s366_now + s688) + s189*s327 + s699)
        s713 = s28_now*s594 + s348*s366_now
        s714 = s13_now*(s192*s327 + s26_now*s594 + s345*s366_now + s702) + s195*s327 + s713
        s718 = -s11_now*s714 - s325*s423_now + s662
        s721 = s307*s30_now + s351*u_x_now
        s725 = s317*s423_now + s714*s7_now + s721
        s731 = -h_now*s397_now*s434 - s276_now*s394*s397_now + s583*s659
        s734 = -s269_now*s307 - s422*u_x_now
        s737 = -s270_now*s308 - s423*u_y_now
        s738 = s734 + s737
        s750 = s13_now*(s13_now*(1.5619206968586225e-16*s734 + 1.5619206968586225e-16*s737) + s210*s327 + s35_now*s738 + s360*s437_now)
        s761 = s366*s437_now + s39_now*s738
        s764 = s13_now*(s13_now*(s213*s327 + s363*s437_now + s37_now*s738 + s750) + s216*s327 + s761)
        s775 = s372*s437_now + s43_now*s738
        s778 = s13_now*(s13_now*(s327*s453_now + s369*s437_now + s41_now*s738 + s764) + s222*s327 + s775)
        s789 = s378*s437_now + s47_now*s738
        s790 = s13_now*(s225*s327 + s375*s437_now + s45_now*s738 + s778) + s228*s327 + s789
        s802 = -s318*s461_now - s790*s8_now
        s803 = -s12_now*s790 - s268_now*s308 - s271_now*s307 - s326*s461_now - s421*u_y_now - s426*u_x_now + s802
        s815 = s13_now*(s13_now*(2.8114572543455206e-15*s734 + 2.8114572543455206e-15*s737) + s16_now*s738 + s239*s327 + s330*s437_now)
        s826 = s20_now*s738 + s336*s437_now
        s829 = s13_now*(s13_now*(s18_now*s738 + s242*s327 + s333*s437_now + s815) + s245*s327 + s826)
        s840 = s24_now*s738 + s342*s437_now
        s843 = s13_now*(s13_now*(s22_now*s738 + s327*s485_now + s339*s437_now + s829) + s251*s327 + s840)
        s854 = s28_now*s738 + s348*s437_now
        s855 = s13_now*(s254*s327 + s26_now*s738 + s345*s437_now + s843) + s257*s327 + s854
        s859 = -s11_now*s855 - s325*s493_now + s721
        s863 = s317*s493_now - s662 + s7_now*s855
        s869 = -h_now*s434*s468_now - s276_now*s394*s468_now + s583*s803
        s870 = -0.5*s414
        s871 = s309 - s413 + stretch_now_by
        s874 = -s514_now*s871
        s875 = 0.5*s871
        s878 = -2*scale_now_by/(s60_now * s60_now * s60_now)
        s879 = a_now_by + dr_now_by + r_now_by + radius_now_by
        s883 = -s307*s658_now + s408 - s879*u_x_now
        s887 = -s308*s658_now + s411 - s879*u_y_now
        s888 = -0.5*s389
        s889 = -2*s878
        s890 = 2*scale_now_by
        s900 = 0.5*s678_now*s890/(s60_now * s60_now * s60_now * s60_now) - (s678_now * s678_now)*scale_now_by/(s60_now * s60_now * s60_now * s60_now * s60_now)
        s905 = -0.5*s657_now*s890 - 0.5*s678_now*s878
        s915 = -arm_0_now*stretch_now_by - 0.25*dl_now*dl_now_by - s309*stretch_now + s888 - stretch_now*stretch_now_by
        s917 = -0.5*s431 - stretch_now_by
        s918 = -0.25*dl_now_by
        s919 = -s309 - stretch_now_by
        s926 = -0.5*arm_0_now*dl_now_by - 0.5*dl_now_by*stretch_now - s147_now*s309 - s147_now*stretch_now_by
        s929 = -0.5*s309 - 0.5*stretch_now_by
        s933 = 0.5*c_now_by*u_y_now + s128_now*s308
        s937 = -0.5*c_now_by*u_x_now - s128_now*s307
        s940 = axis_x_now*scale_now_by + s354*s60_now
        s943 = axis_y_now*scale_now_by + s357*s60_now
        s946 = axis_z_now*scale_now_by + s388*s60_now
        k[53 * lane + 0] = scale_now_by
        k[53 * lane + 1] = s398
        k[53 * lane + 2] = s354
        k[53 * lane + 3] = s402
        k[53 * lane + 4] = s357
        k[53 * lane + 5] = s405
        k[53 * lane + 6] = s388
        k[53 * lane + 7] = s408
        k[53 * lane + 8] = s411
        k[53 * lane + 9] = s307
        k[53 * lane + 10] = s308
        k[53 * lane + 11] = s412
        k[53 * lane + 12] = s417
        k[53 * lane + 13] = s874
        k[53 * lane + 14] = s883
        k[53 * lane + 15] = s887
        k[53 * lane + 16] = s394
        k[53 * lane + 17] = s888
        k[53 * lane + 18] = s889
        k[53 * lane + 19] = s900
        k[53 * lane + 20] = s905
        k[53 * lane + 21] = s395
        k[53 * lane + 22] = s441
        k[53 * lane + 23] = -s414
        k[53 * lane + 24] = s448
        k[53 * lane + 25] = s520
        k[53 * lane + 26] = s576
        k[53 * lane + 27] = s580
        k[53 * lane + 28] = s587
        k[53 * lane + 29] = s659
        k[53 * lane + 30] = s718
        k[53 * lane + 31] = s725
        k[53 * lane + 32] = s731
        k[53 * lane + 33] = s803
        k[53 * lane + 34] = s859
        k[53 * lane + 35] = s863
        k[53 * lane + 36] = s869
        k[53 * lane + 37] = -s871
        k[53 * lane + 38] = s870
        k[53 * lane + 39] = s875
        k[53 * lane + 40] = s389
        k[53 * lane + 41] = s915
        k[53 * lane + 42] = s926
        k[53 * lane + 43] = s933
        k[53 * lane + 44] = s937
        k[53 * lane + 45] = s940
        k[53 * lane + 46] = s943
        k[53 * lane + 47] = s946
        k[53 * lane + 48] = s917
        k[53 * lane + 49] = s413
        k[53 * lane + 50] = s918
        k[53 * lane + 51] = s919
        k[53 * lane + 52] = s929


@fast
def _constants_by(p, p_by, k, c):
    _fill_machine_by(p, p_by, k, p.shape[0] * p.shape[1])
    _fill_by(p, p_by, c, p.shape[0] * p.shape[1])


def constants_by(p, p_by):
    """Return how k and c change, which `constants` of ``kinematics.py`` and of this module make of one machine's p
    (1, 3, 16), along each of p_by (E, 3, 16)."""
    p_by = np.ascontiguousarray(p_by, dtype=float)
    k_by = np.empty((len(p_by), 3, 53))
    c_by = np.empty((len(p_by), 3, 16))
    _constants_by(np.repeat(p, len(p_by), axis=0), p_by, k_by, c_by)
    return k_by, c_by


@straight
def _move_platform_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of the platform after a step, and its rotation matrix (187 operations)."""
    for lane in range(n):
        cx_now = w[224 + lane]
        cy_now = w[256 + lane]
        cz_now = w[288 + lane]
        y3_now = w[6432 + lane]
        y4_now = w[6464 + lane]
        y5_now = w[6496 + lane]
        going_now = w[6592 + lane]
        y0_now_by = w_by[6336 + lane]
        y1_now_by = w_by[6368 + lane]
        y2_now_by = w_by[6400 + lane]
        y3_now_by = w_by[6432 + lane]
        y4_now_by = w_by[6464 + lane]
        y5_now_by = w_by[6496 + lane]
        s10_now = 0.5*cz_now
        s11_now = 0.25*cx_now*cy_now
        s14_now = -0.5*cy_now
        s15_now = 0.25*cx_now*cz_now
        s10 = s14_now + s15_now
        s17_now = -going_now*s10*y5_now
        s14 = 0.25*(cx_now * cx_now) + 1
        s16 = s10_now + s11_now
        new_30_now = cx_now - going_now*s14*y3_now - going_now*s16*y4_now + s17_now
        s25_now = 0.5*cx_now
        s26_now = 0.25*cy_now*cz_now
        s21 = s25_now + s26_now
        s28_now = -going_now*s21*y5_now
        s23 = -s10_now + s11_now
        s27 = 0.25*(cy_now * cy_now) + 1
        new_40_now = cy_now - going_now*s23*y3_now - going_now*s27*y4_now + s28_now
        s32 = 0.25*(cz_now * cz_now) + 1
        s37_now = -going_now*s32*y5_now
        s34 = -s14_now + s15_now
        s36 = -s25_now + s26_now
        new_50_now = cz_now - going_now*s34*y3_now - going_now*s36*y4_now + s37_now
        s39_now = (new_30_now * new_30_now)
        s41_now = (new_40_now * new_40_now)
        s43_now = (new_50_now * new_50_now)
        s45 = 0.25*s39_now + 0.25*s41_now + 0.25*s43_now + 1
        s46_now = (1.0 / s45)
        s47_now = -0.5*s41_now
        s48_now = -0.5*s43_now
        s52_now = 0.5*new_30_now*new_40_now
        s55_now = 0.5*new_30_now*new_50_now
        s60_now = -0.5*s39_now
        s64_now = 0.5*new_40_now*new_50_now
        s74 = -going_now*y0_now_by
        s75 = -going_now*y1_now_by
        s76 = -going_now*y2_now_by
        s93 = -going_now*s10*y5_now_by - going_now*s14*y3_now_by - going_now*s16*y4_now_by
        s104 = -going_now*s21*y5_now_by - going_now*s23*y3_now_by - going_now*s27*y4_now_by
        s115 = -going_now*s32*y5_now_by - going_now*s34*y3_now_by - going_now*s36*y4_now_by
        s117 = 2*new_30_now*s93
        s119 = 2*new_40_now*s104
        s121 = 2*new_50_now*s115
        s127 = -(0.25*s117 + 0.25*s119 + 0.25*s121)/(s45 * s45)
        s128 = -0.5*s119
        s129 = -0.5*s121
        s133 = s127*(s47_now + s48_now) + s46_now*(s128 + s129)
        s134 = 0.5*new_40_now
        s135 = 0.5*new_30_now
        s138 = s104*s135 + s134*s93
        s142 = s127*(-new_50_now + s52_now) + s46_now*(-s115 + s138)
        s143 = 0.5*new_50_now
        s146 = s115*s135 + s143*s93
        s150 = s127*(new_40_now + s55_now) + s46_now*(s104 + s146)
        s154 = s127*(new_50_now + s52_now) + s46_now*(s115 + s138)
        s155 = -0.5*s117
        s159 = s127*(s48_now + s60_now) + s46_now*(s129 + s155)
        s162 = s104*s143 + s115*s134
        s166 = s127*(-new_30_now + s64_now) + s46_now*(s162 - s93)
        s170 = s127*(-new_40_now + s55_now) + s46_now*(-s104 + s146)
        s174 = s127*(new_30_now + s64_now) + s46_now*(s162 + s93)
        s178 = s127*(s47_now + s60_now) + s46_now*(s128 + s155)
        w_by[128 + lane] = s74
        w_by[2240 + lane] = s74
        w_by[4352 + lane] = s74
        w_by[160 + lane] = s75
        w_by[2272 + lane] = s75
        w_by[4384 + lane] = s75
        w_by[192 + lane] = s76
        w_by[2304 + lane] = s76
        w_by[4416 + lane] = s76
        w_by[224 + lane] = s93
        w_by[256 + lane] = s104
        w_by[288 + lane] = s115
        w_by[320 + lane] = s133
        w_by[2432 + lane] = s133
        w_by[4544 + lane] = s133
        w_by[352 + lane] = s142
        w_by[2464 + lane] = s142
        w_by[4576 + lane] = s142
        w_by[384 + lane] = s150
        w_by[2496 + lane] = s150
        w_by[4608 + lane] = s150
        w_by[416 + lane] = s154
        w_by[2528 + lane] = s154
        w_by[4640 + lane] = s154
        w_by[448 + lane] = s159
        w_by[2560 + lane] = s159
        w_by[4672 + lane] = s159
        w_by[480 + lane] = s166
        w_by[2592 + lane] = s166
        w_by[4704 + lane] = s166
        w_by[512 + lane] = s170
        w_by[2624 + lane] = s170
        w_by[4736 + lane] = s170
        w_by[544 + lane] = s174
        w_by[2656 + lane] = s174
        w_by[4768 + lane] = s174
        w_by[576 + lane] = s178
        w_by[2688 + lane] = s178
        w_by[4800 + lane] = s178


@straight
def _early_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of what moves with a joint only; then the simplified limb as a sphere |P|^2 - 2 c.P + d = 0: c, d (33 operations)."""
    s60_now = k[0]
    s59_now = k[1]
    axis_x_now = k[2]
    axis_y_now = k[4]
    axis_z_now = k[6]
    s660_now = k[14]
    s665_now = k[15]
    h_now = k[16]
    s60_now_by = k_by[0]
    s59_now_by = k_by[1]
    axis_x_now_by = k_by[2]
    s65_now_by = k_by[3]
    axis_y_now_by = k_by[4]
    s68_now_by = k_by[5]
    axis_z_now_by = k_by[6]
    s106_now_by = k_by[7]
    s109_now_by = k_by[8]
    s660_now_by = k_by[14]
    s665_now_by = k_by[15]
    h_now_by = k_by[16]
    s53_now_by = k_by[40]
    for lane in range(n):
        q_now = w[0 + lane]
        tx_now = w[32 + lane]
        ty_now = w[64 + lane]
        tz_now = w[96 + lane]
        s61_now = -q_now*s60_now
        s62_now = s59_now + s61_now
        s687_now = -s660_now + tx_now
        s688_now = -s665_now + ty_now
        s689_now = h_now + s61_now + tz_now
        s16 = -q_now*s60_now_by
        s17 = s16 + s59_now_by
        s21 = axis_x_now*s17 + axis_x_now_by*s62_now + s65_now_by
        s25 = axis_y_now*s17 + axis_y_now_by*s62_now + s68_now_by
        s28 = axis_z_now*s17 + axis_z_now_by*s62_now
        s29 = h_now_by + s16
        s36 = 2*s29*s689_now - s53_now_by - 2*s660_now_by*s687_now - 2*s665_now_by*s688_now
        w_by[1120 + lane] = s106_now_by
        w_by[1152 + lane] = s109_now_by
        w_by[1184 + lane] = s21
        w_by[1216 + lane] = s25
        w_by[1248 + lane] = s28
        w_by[1280 + lane] = -s660_now_by
        w_by[1312 + lane] = -s665_now_by
        w_by[1344 + lane] = s29
        w_by[1376 + lane] = s36


@straight
def _more_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of what else derivatives by joint and errors read of it (2 operations)."""
    s60_now_by = k_by[0]
    s59_now_by = k_by[1]
    for lane in range(n):
        q_now = w[0 + lane]
        s3 = -q_now*s60_now_by + s59_now_by
        w_by[1440 + lane] = s3


@straight
def _rows_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of equations of a limb, their derivatives by shift and turn of the platform (272 operations)."""
    u_x_now = k[9]
    u_y_now = k[10]
    s128_now = k[11]
    s1009_now = k[43]
    s1011_now = k[44]
    u_x_now_by = k_by[9]
    u_y_now_by = k_by[10]
    s128_now_by = k_by[11]
    s714_now_by = k_by[41]
    s870_now_by = k_by[42]
    s1009_now_by = k_by[43]
    s1011_now_by = k_by[44]
    for lane in range(n):
        tz_now = w[96 + lane]
        px_now = w[128 + lane]
        py_now = w[160 + lane]
        pz_now = w[192 + lane]
        R_11_now = w[320 + lane]
        R_12_now = w[352 + lane]
        R_13_now = w[384 + lane]
        R_21_now = w[416 + lane]
        R_22_now = w[448 + lane]
        R_23_now = w[480 + lane]
        R_31_now = w[512 + lane]
        R_32_now = w[544 + lane]
        R_33_now = w[576 + lane]
        s107_now = w[1120 + lane]
        s110_now = w[1152 + lane]
        C_x_now = w[1184 + lane]
        C_y_now = w[1216 + lane]
        C_z_now = w[1248 + lane]
        px_now_by = w_by[128 + lane]
        py_now_by = w_by[160 + lane]
        pz_now_by = w_by[192 + lane]
        R_11_now_by = w_by[320 + lane]
        R_12_now_by = w_by[352 + lane]
        R_13_now_by = w_by[384 + lane]
        R_21_now_by = w_by[416 + lane]
        R_22_now_by = w_by[448 + lane]
        R_23_now_by = w_by[480 + lane]
        R_31_now_by = w_by[512 + lane]
        R_32_now_by = w_by[544 + lane]
        R_33_now_by = w_by[576 + lane]
        s107_now_by = w_by[1120 + lane]
        s110_now_by = w_by[1152 + lane]
        C_x_now_by = w_by[1184 + lane]
        C_y_now_by = w_by[1216 + lane]
        C_z_now_by = w_by[1248 + lane]
        s108_now = R_11_now*s107_now
        s111_now = R_12_now*s110_now
        s112_now = -R_13_now*tz_now
        A_x_now = px_now + s108_now + s111_now + s112_now
        s114_now = R_21_now*s107_now
        s115_now = R_22_now*s110_now
        s116_now = -R_23_now*tz_now
        A_y_now = py_now + s114_now + s115_now + s116_now
        s118_now = R_31_now*s107_now
        s119_now = R_32_now*s110_now
        s120_now = -R_33_now*tz_now
        A_z_now = pz_now + s118_now + s119_now + s120_now
        d_x_now = A_x_now - C_x_now
        d_y_now = A_y_now - C_y_now
        d_z_now = A_z_now - C_z_now
        s17 = -R_11_now*u_y_now + R_12_now*u_x_now + u_y_now
        s_x_now = s128_now*s17
        s21 = -R_21_now*u_y_now + R_22_now*u_x_now - u_x_now
        s_y_now = s128_now*s21
        s25 = -R_31_now*u_y_now + R_32_now*u_x_now
        s_z_now = s128_now*s25
        s1005_now = -s118_now - s119_now - s120_now
        s1007_now = s114_now + s115_now + s116_now
        s1013_now = R_31_now*s1009_now + R_32_now*s1011_now
        s1017_now = -R_21_now*s1009_now - R_22_now*s1011_now
        s1021_now = -s108_now - s111_now - s112_now
        s1026_now = R_11_now*s1009_now + R_12_now*s1011_now
        s88 = R_11_now*s107_now_by + R_11_now_by*s107_now
        s91 = R_12_now*s110_now_by + R_12_now_by*s110_now
        s92 = -R_13_now_by*tz_now
        s96 = R_21_now*s107_now_by + R_21_now_by*s107_now
        s99 = R_22_now*s110_now_by + R_22_now_by*s110_now
        s100 = -R_23_now_by*tz_now
        s104 = R_31_now*s107_now_by + R_31_now_by*s107_now
        s107 = R_32_now*s110_now_by + R_32_now_by*s110_now
        s108 = -R_33_now_by*tz_now
        s110 = -C_x_now_by + px_now_by + s88 + s91 + s92
        s111 = -C_y_now_by + py_now_by + s100 + s96 + s99
        s112 = -C_z_now_by + pz_now_by + s104 + s107 + s108
        s122 = s128_now*(-R_11_now*u_y_now_by - R_11_now_by*u_y_now + R_12_now*u_x_now_by + R_12_now_by*u_x_now + u_y_now_by) + s128_now_by*s17
        s132 = s128_now*(-R_21_now*u_y_now_by - R_21_now_by*u_y_now + R_22_now*u_x_now_by + R_22_now_by*u_x_now - u_x_now_by) + s128_now_by*s21
        s142 = s128_now*(-R_31_now*u_y_now_by - R_31_now_by*u_y_now + R_32_now*u_x_now_by + R_32_now_by*u_x_now) + s128_now_by*s25
        s161 = d_x_now*s110 + d_y_now*s111 + d_z_now*s112 + s122*s_x_now + s132*s_y_now + s142*s_z_now + s714_now_by
        s171 = d_x_now*s122 + d_y_now*s132 + d_z_now*s142 + s110*s_x_now + s111*s_y_now + s112*s_z_now + s870_now_by
        s172 = -s104 - s107 - s108
        s173 = s100 + s96 + s99
        s180 = R_31_now*s1009_now_by + R_31_now_by*s1009_now + R_32_now*s1011_now_by + R_32_now_by*s1011_now
        s187 = -R_21_now*s1009_now_by - R_21_now_by*s1009_now - R_22_now*s1011_now_by - R_22_now_by*s1011_now
        s199 = s1017_now*s142 + s187*s_z_now
        s200 = d_y_now*s172 + d_z_now*s173 + s1005_now*s111 + s1007_now*s112 + s1013_now*s132 + s180*s_y_now + s199
        s201 = -s88 - s91 - s92
        s208 = R_11_now*s1009_now_by + R_11_now_by*s1009_now + R_12_now*s1011_now_by + R_12_now_by*s1011_now
        s220 = -s1013_now*s122 - s180*s_x_now
        s221 = -d_x_now*s172 + d_z_now*s201 - s1005_now*s110 + s1021_now*s112 + s1026_now*s142 + s208*s_z_now + s220
        s233 = -s1026_now*s132 - s208*s_y_now
        s234 = -d_x_now*s173 - d_y_now*s201 - s1007_now*s110 - s1017_now*s122 - s1021_now*s111 - s187*s_x_now + s233
        s246 = s1007_now*s142 + s173*s_z_now
        s247 = d_y_now*s180 + d_z_now*s187 + s1005_now*s132 + s1013_now*s111 + s1017_now*s112 + s172*s_y_now + s246
        s259 = -s1005_now*s122 - s172*s_x_now
        s260 = -d_x_now*s180 + d_z_now*s208 - s1013_now*s110 + s1021_now*s142 + s1026_now*s112 + s201*s_z_now + s259
        s272 = -s1021_now*s132 - s201*s_y_now
        s273 = -d_x_now*s187 - d_y_now*s208 - s1007_now*s122 - s1017_now*s110 - s1026_now*s111 - s173*s_x_now + s272
        w_by[608 + lane] = s161
        w_by[640 + lane] = s110
        w_by[672 + lane] = s111
        w_by[704 + lane] = s112
        w_by[736 + lane] = s200
        w_by[768 + lane] = s221
        w_by[800 + lane] = s234
        w_by[864 + lane] = s171
        w_by[896 + lane] = s122
        w_by[928 + lane] = s132
        w_by[960 + lane] = s142
        w_by[992 + lane] = s247
        w_by[1024 + lane] = s260
        w_by[1056 + lane] = s273


@straight
def _joints_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of derivatives of a limb's equations by its joint (122 operations)."""
    u_x_now = k[9]
    u_y_now = k[10]
    s128_now = k[11]
    s1049_now = k[45]
    s1051_now = k[46]
    s1053_now = k[47]
    u_x_now_by = k_by[9]
    u_y_now_by = k_by[10]
    s128_now_by = k_by[11]
    s1049_now_by = k_by[45]
    s1051_now_by = k_by[46]
    s1053_now_by = k_by[47]
    for lane in range(n):
        tz_now = w[96 + lane]
        px_now = w[128 + lane]
        py_now = w[160 + lane]
        pz_now = w[192 + lane]
        R_11_now = w[320 + lane]
        R_12_now = w[352 + lane]
        R_13_now = w[384 + lane]
        R_21_now = w[416 + lane]
        R_22_now = w[448 + lane]
        R_23_now = w[480 + lane]
        R_31_now = w[512 + lane]
        R_32_now = w[544 + lane]
        R_33_now = w[576 + lane]
        s107_now = w[1120 + lane]
        s110_now = w[1152 + lane]
        C_x_now = w[1184 + lane]
        C_y_now = w[1216 + lane]
        C_z_now = w[1248 + lane]
        px_now_by = w_by[128 + lane]
        py_now_by = w_by[160 + lane]
        pz_now_by = w_by[192 + lane]
        R_11_now_by = w_by[320 + lane]
        R_12_now_by = w_by[352 + lane]
        R_13_now_by = w_by[384 + lane]
        R_21_now_by = w_by[416 + lane]
        R_22_now_by = w_by[448 + lane]
        R_23_now_by = w_by[480 + lane]
        R_31_now_by = w_by[512 + lane]
        R_32_now_by = w_by[544 + lane]
        R_33_now_by = w_by[576 + lane]
        s107_now_by = w_by[1120 + lane]
        s110_now_by = w_by[1152 + lane]
        C_x_now_by = w_by[1184 + lane]
        C_y_now_by = w_by[1216 + lane]
        C_z_now_by = w_by[1248 + lane]
        A_x_now = R_11_now*s107_now + R_12_now*s110_now - R_13_now*tz_now + px_now
        A_y_now = R_21_now*s107_now + R_22_now*s110_now - R_23_now*tz_now + py_now
        A_z_now = R_31_now*s107_now + R_32_now*s110_now - R_33_now*tz_now + pz_now
        d_x_now = A_x_now - C_x_now
        d_y_now = A_y_now - C_y_now
        d_z_now = A_z_now - C_z_now
        s17 = -R_11_now*u_y_now + R_12_now*u_x_now + u_y_now
        s_x_now = s128_now*s17
        s21 = -R_21_now*u_y_now + R_22_now*u_x_now - u_x_now
        s_y_now = s128_now*s21
        s25 = -R_31_now*u_y_now + R_32_now*u_x_now
        s_z_now = s128_now*s25
        s92 = s1049_now*(-C_x_now_by + R_11_now*s107_now_by + R_11_now_by*s107_now + R_12_now*s110_now_by + R_12_now_by*s110_now - R_13_now_by*tz_now + px_now_by)
        s95 = s1051_now*(-C_y_now_by + R_21_now*s107_now_by + R_21_now_by*s107_now + R_22_now*s110_now_by + R_22_now_by*s110_now - R_23_now_by*tz_now + py_now_by)
        s98 = s1053_now*(-C_z_now_by + R_31_now*s107_now_by + R_31_now_by*s107_now + R_32_now*s110_now_by + R_32_now_by*s110_now - R_33_now_by*tz_now + pz_now_by)
        s101 = d_x_now*s1049_now_by + d_y_now*s1051_now_by + d_z_now*s1053_now_by + s92 + s95 + s98
        s103 = s1049_now*(s128_now*(-R_11_now*u_y_now_by - R_11_now_by*u_y_now + R_12_now*u_x_now_by + R_12_now_by*u_x_now + u_y_now_by) + s128_now_by*s17)
        s106 = s1051_now*(s128_now*(-R_21_now*u_y_now_by - R_21_now_by*u_y_now + R_22_now*u_x_now_by + R_22_now_by*u_x_now - u_x_now_by) + s128_now_by*s21)
        s109 = s1053_now*(s128_now*(-R_31_now*u_y_now_by - R_31_now_by*u_y_now + R_32_now*u_x_now_by + R_32_now_by*u_x_now) + s128_now_by*s25)
        s111 = s103 + s1049_now_by*s_x_now + s1051_now_by*s_y_now + s1053_now_by*s_z_now + s106 + s109
        w_by[832 + lane] = s101
        w_by[1088 + lane] = s111


@straight
def _inverse_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of minus the inverse of the derivatives, row by row; how far the equations are from dependent (1241 operations)."""
    for lane in range(n):
        J00_0_now = w[640 + lane]
        J00_1_now = w[672 + lane]
        J00_2_now = w[704 + lane]
        J00_3_now = w[736 + lane]
        J00_4_now = w[768 + lane]
        J00_5_now = w[800 + lane]
        J01_0_now = w[896 + lane]
        J01_1_now = w[928 + lane]
        J01_2_now = w[960 + lane]
        J01_3_now = w[992 + lane]
        J01_4_now = w[1024 + lane]
        J01_5_now = w[1056 + lane]
        J10_0_now = w[2752 + lane]
        J10_1_now = w[2784 + lane]
        J10_2_now = w[2816 + lane]
        J10_3_now = w[2848 + lane]
        J10_4_now = w[2880 + lane]
        J10_5_now = w[2912 + lane]
        J11_0_now = w[3008 + lane]
        J11_1_now = w[3040 + lane]
        J11_2_now = w[3072 + lane]
        J11_3_now = w[3104 + lane]
        J11_4_now = w[3136 + lane]
        J11_5_now = w[3168 + lane]
        J20_0_now = w[4864 + lane]
        J20_1_now = w[4896 + lane]
        J20_2_now = w[4928 + lane]
        J20_3_now = w[4960 + lane]
        J20_4_now = w[4992 + lane]
        J20_5_now = w[5024 + lane]
        J21_0_now = w[5120 + lane]
        J21_1_now = w[5152 + lane]
        J21_2_now = w[5184 + lane]
        J21_3_now = w[5216 + lane]
        J21_4_now = w[5248 + lane]
        J21_5_now = w[5280 + lane]
        J00_0_now_by = w_by[640 + lane]
        J00_1_now_by = w_by[672 + lane]
        J00_2_now_by = w_by[704 + lane]
        J00_3_now_by = w_by[736 + lane]
        J00_4_now_by = w_by[768 + lane]
        J00_5_now_by = w_by[800 + lane]
        J01_0_now_by = w_by[896 + lane]
        J01_1_now_by = w_by[928 + lane]
        J01_2_now_by = w_by[960 + lane]
        J01_3_now_by = w_by[992 + lane]
        J01_4_now_by = w_by[1024 + lane]
        J01_5_now_by = w_by[1056 + lane]
        J10_0_now_by = w_by[2752 + lane]
        J10_1_now_by = w_by[2784 + lane]
        J10_2_now_by = w_by[2816 + lane]
        J10_3_now_by = w_by[2848 + lane]
        J10_4_now_by = w_by[2880 + lane]
        J10_5_now_by = w_by[2912 + lane]
        J11_0_now_by = w_by[3008 + lane]
        J11_1_now_by = w_by[3040 + lane]
        J11_2_now_by = w_by[3072 + lane]
        J11_3_now_by = w_by[3104 + lane]
        J11_4_now_by = w_by[3136 + lane]
        J11_5_now_by = w_by[3168 + lane]
        J20_0_now_by = w_by[4864 + lane]
        J20_1_now_by = w_by[4896 + lane]
        J20_2_now_by = w_by[4928 + lane]
        J20_3_now_by = w_by[4960 + lane]
        J20_4_now_by = w_by[4992 + lane]
        J20_5_now_by = w_by[5024 + lane]
        J21_0_now_by = w_by[5120 + lane]
        J21_1_now_by = w_by[5152 + lane]
        J21_2_now_by = w_by[5184 + lane]
        J21_3_now_by = w_by[5216 + lane]
        J21_4_now_by = w_by[5248 + lane]
        J21_5_now_by = w_by[5280 + lane]
        G_cof_00_now = J10_1_now*J20_2_now - J10_2_now*J20_1_now
        G_cof_01_now = -J10_0_now*J20_2_now + J10_2_now*J20_0_now
        G_cof_02_now = J10_0_now*J20_1_now - J10_1_now*J20_0_now
        G_cof_10_now = -J00_1_now*J20_2_now + J00_2_now*J20_1_now
        G_cof_11_now = J00_0_now*J20_2_now - J00_2_now*J20_0_now
        G_cof_12_now = -J00_0_now*J20_1_now + J00_1_now*J20_0_now
        G_cof_20_now = J00_1_now*J10_2_now - J00_2_now*J10_1_now
        G_cof_21_now = -J00_0_now*J10_2_now + J00_2_now*J10_0_now
        G_cof_22_now = J00_0_now*J10_1_now - J00_1_now*J10_0_now
        G_det_00_now = G_cof_00_now*J00_0_now + G_cof_01_now*J00_1_now + G_cof_02_now*J00_2_now
        G_by_00_now = (1.0 / G_det_00_now)
        G_inv_00_now = G_by_00_now*G_cof_00_now
        G_inv_01_now = G_by_00_now*G_cof_10_now
        G_inv_02_now = G_by_00_now*G_cof_20_now
        G_inv_10_now = G_by_00_now*G_cof_01_now
        G_inv_11_now = G_by_00_now*G_cof_11_now
        G_inv_12_now = G_by_00_now*G_cof_21_now
        G_inv_20_now = G_by_00_now*G_cof_02_now
        G_inv_21_now = G_by_00_now*G_cof_12_now
        G_inv_22_now = G_by_00_now*G_cof_22_now
        U_00_now = G_inv_00_now*J00_3_now + G_inv_01_now*J10_3_now + G_inv_02_now*J20_3_now
        U_01_now = G_inv_00_now*J00_4_now + G_inv_01_now*J10_4_now + G_inv_02_now*J20_4_now
        U_02_now = G_inv_00_now*J00_5_now + G_inv_01_now*J10_5_now + G_inv_02_now*J20_5_now
        U_10_now = G_inv_10_now*J00_3_now + G_inv_11_now*J10_3_now + G_inv_12_now*J20_3_now
        U_11_now = G_inv_10_now*J00_4_now + G_inv_11_now*J10_4_now + G_inv_12_now*J20_4_now
        U_12_now = G_inv_10_now*J00_5_now + G_inv_11_now*J10_5_now + G_inv_12_now*J20_5_now
        U_20_now = G_inv_20_now*J00_3_now + G_inv_21_now*J10_3_now + G_inv_22_now*J20_3_now
        U_21_now = G_inv_20_now*J00_4_now + G_inv_21_now*J10_4_now + G_inv_22_now*J20_4_now
        U_22_now = G_inv_20_now*J00_5_now + G_inv_21_now*J10_5_now + G_inv_22_now*J20_5_now
        S_00_now = -J01_0_now*U_00_now - J01_1_now*U_10_now - J01_2_now*U_20_now + J01_3_now
        S_01_now = -J01_0_now*U_01_now - J01_1_now*U_11_now - J01_2_now*U_21_now + J01_4_now
        S_02_now = -J01_0_now*U_02_now - J01_1_now*U_12_now - J01_2_now*U_22_now + J01_5_now
        S_10_now = -J11_0_now*U_00_now - J11_1_now*U_10_now - J11_2_now*U_20_now + J11_3_now
        S_11_now = -J11_0_now*U_01_now - J11_1_now*U_11_now - J11_2_now*U_21_now + J11_4_now
        S_12_now = -J11_0_now*U_02_now - J11_1_now*U_12_now - J11_2_now*U_22_now + J11_5_now
        S_20_now = -J21_0_now*U_00_now - J21_1_now*U_10_now - J21_2_now*U_20_now + J21_3_now
        S_21_now = -J21_0_now*U_01_now - J21_1_now*U_11_now - J21_2_now*U_21_now + J21_4_now
        S_22_now = -J21_0_now*U_02_now - J21_1_now*U_12_now - J21_2_now*U_22_now + J21_5_now
        Si_cof_00_now = S_11_now*S_22_now - S_12_now*S_21_now
        Si_cof_01_now = -S_10_now*S_22_now + S_12_now*S_20_now
        Si_cof_02_now = S_10_now*S_21_now - S_11_now*S_20_now
        Si_cof_10_now = -S_01_now*S_22_now + S_02_now*S_21_now
        Si_cof_11_now = S_00_now*S_22_now - S_02_now*S_20_now
        Si_cof_12_now = -S_00_now*S_21_now + S_01_now*S_20_now
        Si_cof_20_now = S_01_now*S_12_now - S_02_now*S_11_now
        Si_cof_21_now = -S_00_now*S_12_now + S_02_now*S_10_now
        Si_cof_22_now = S_00_now*S_11_now - S_01_now*S_10_now
        Si_det_00_now = S_00_now*Si_cof_00_now + S_01_now*Si_cof_01_now + S_02_now*Si_cof_02_now
        Si_by_00_now = (1.0 / Si_det_00_now)
        Si_inv_00_now = Si_by_00_now*Si_cof_00_now
        Si_inv_01_now = Si_by_00_now*Si_cof_10_now
        Si_inv_02_now = Si_by_00_now*Si_cof_20_now
        Si_inv_10_now = Si_by_00_now*Si_cof_01_now
        Si_inv_11_now = Si_by_00_now*Si_cof_11_now
        Si_inv_12_now = Si_by_00_now*Si_cof_21_now
        Si_inv_20_now = Si_by_00_now*Si_cof_02_now
        Si_inv_21_now = Si_by_00_now*Si_cof_12_now
        Si_inv_22_now = Si_by_00_now*Si_cof_22_now
        s193_now = -J01_0_now*Si_inv_00_now - J11_0_now*Si_inv_01_now - J21_0_now*Si_inv_02_now
        s198_now = -J01_1_now*Si_inv_00_now - J11_1_now*Si_inv_01_now - J21_1_now*Si_inv_02_now
        s203_now = -J01_2_now*Si_inv_00_now - J11_2_now*Si_inv_01_now - J21_2_now*Si_inv_02_now
        V_00_now = G_inv_00_now*s193_now + G_inv_10_now*s198_now + G_inv_20_now*s203_now
        V_01_now = G_inv_01_now*s193_now + G_inv_11_now*s198_now + G_inv_21_now*s203_now
        V_02_now = G_inv_02_now*s193_now + G_inv_12_now*s198_now + G_inv_22_now*s203_now
        s217_now = -J01_0_now*Si_inv_10_now - J11_0_now*Si_inv_11_now - J21_0_now*Si_inv_12_now
        s222_now = -J01_1_now*Si_inv_10_now - J11_1_now*Si_inv_11_now - J21_1_now*Si_inv_12_now
        s227_now = -J01_2_now*Si_inv_10_now - J11_2_now*Si_inv_11_now - J21_2_now*Si_inv_12_now
        V_10_now = G_inv_00_now*s217_now + G_inv_10_now*s222_now + G_inv_20_now*s227_now
        V_11_now = G_inv_01_now*s217_now + G_inv_11_now*s222_now + G_inv_21_now*s227_now
        V_12_now = G_inv_02_now*s217_now + G_inv_12_now*s222_now + G_inv_22_now*s227_now
        s241_now = -J01_0_now*Si_inv_20_now - J11_0_now*Si_inv_21_now - J21_0_now*Si_inv_22_now
        s246_now = -J01_1_now*Si_inv_20_now - J11_1_now*Si_inv_21_now - J21_1_now*Si_inv_22_now
        s251_now = -J01_2_now*Si_inv_20_now - J11_2_now*Si_inv_21_now - J21_2_now*Si_inv_22_now
        V_20_now = G_inv_00_now*s241_now + G_inv_10_now*s246_now + G_inv_20_now*s251_now
        V_21_now = G_inv_01_now*s241_now + G_inv_11_now*s246_now + G_inv_21_now*s251_now
        V_22_now = G_inv_02_now*s241_now + G_inv_12_now*s246_now + G_inv_22_now*s251_now
        s342_now = (J10_0_now * J10_0_now) + (J10_1_now * J10_1_now) + (J10_2_now * J10_2_now)
        s346_now = (J20_0_now * J20_0_now) + (J20_1_now * J20_1_now) + (J20_2_now * J20_2_now)
        s310 = (J00_0_now * J00_0_now) + (J00_1_now * J00_1_now) + (J00_2_now * J00_2_now)
        s357_now = (J11_3_now * J11_3_now) + (J11_4_now * J11_4_now) + (J11_5_now * J11_5_now)
        s361_now = (J21_3_now * J21_3_now) + (J21_4_now * J21_4_now) + (J21_5_now * J21_5_now)
        s325 = (J01_3_now * J01_3_now) + (J01_4_now * J01_4_now) + (J01_5_now * J01_5_now)
        s334 = J10_1_now*J20_2_now_by + J10_1_now_by*J20_2_now - J10_2_now*J20_1_now_by - J10_2_now_by*J20_1_now
        s341 = -J10_0_now*J20_2_now_by - J10_0_now_by*J20_2_now + J10_2_now*J20_0_now_by + J10_2_now_by*J20_0_now
        s348 = J10_0_now*J20_1_now_by + J10_0_now_by*J20_1_now - J10_1_now*J20_0_now_by - J10_1_now_by*J20_0_now
        s400 = G_cof_00_now*J00_0_now_by + G_cof_01_now*J00_1_now_by + G_cof_02_now*J00_2_now_by + J00_0_now*s334 + J00_1_now*s341 + J00_2_now*s348
        s402 = -s400/(G_det_00_now * G_det_00_now)
        s405 = G_by_00_now*s334 + G_cof_00_now*s402
        s408 = G_by_00_now*(-J00_1_now*J20_2_now_by - J00_1_now_by*J20_2_now + J00_2_now*J20_1_now_by + J00_2_now_by*J20_1_now) + G_cof_10_now*s402
        s411 = G_by_00_now*(J00_1_now*J10_2_now_by + J00_1_now_by*J10_2_now - J00_2_now*J10_1_now_by - J00_2_now_by*J10_1_now) + G_cof_20_now*s402
        s414 = G_by_00_now*s341 + G_cof_01_now*s402
        s417 = G_by_00_now*(J00_0_now*J20_2_now_by + J00_0_now_by*J20_2_now - J00_2_now*J20_0_now_by - J00_2_now_by*J20_0_now) + G_cof_11_now*s402
        s420 = G_by_00_now*(-J00_0_now*J10_2_now_by - J00_0_now_by*J10_2_now + J00_2_now*J10_0_now_by + J00_2_now_by*J10_0_now) + G_cof_21_now*s402
        s423 = G_by_00_now*s348 + G_cof_02_now*s402
        s426 = G_by_00_now*(-J00_0_now*J20_1_now_by - J00_0_now_by*J20_1_now + J00_1_now*J20_0_now_by + J00_1_now_by*J20_0_now) + G_cof_12_now*s402
        s429 = G_by_00_now*(J00_0_now*J10_1_now_by + J00_0_now_by*J10_1_now - J00_1_now*J10_0_now_by - J00_1_now_by*J10_0_now) + G_cof_22_now*s402
        s439 = G_inv_00_now*J00_3_now_by + G_inv_01_now*J10_3_now_by + G_inv_02_now*J20_3_now_by + J00_3_now*s405 + J10_3_now*s408 + J20_3_now*s411
        s449 = G_inv_00_now*J00_4_now_by + G_inv_01_now*J10_4_now_by + G_inv_02_now*J20_4_now_by + J00_4_now*s405 + J10_4_now*s408 + J20_4_now*s411
        s459 = G_inv_00_now*J00_5_now_by + G_inv_01_now*J10_5_now_by + G_inv_02_now*J20_5_now_by + J00_5_now*s405 + J10_5_now*s408 + J20_5_now*s411
        s469 = G_inv_10_now*J00_3_now_by + G_inv_11_now*J10_3_now_by + G_inv_12_now*J20_3_now_by + J00_3_now*s414 + J10_3_now*s417 + J20_3_now*s420
        s479 = G_inv_10_now*J00_4_now_by + G_inv_11_now*J10_4_now_by + G_inv_12_now*J20_4_now_by + J00_4_now*s414 + J10_4_now*s417 + J20_4_now*s420
        s489 = G_inv_10_now*J00_5_now_by + G_inv_11_now*J10_5_now_by + G_inv_12_now*J20_5_now_by + J00_5_now*s414 + J10_5_now*s417 + J20_5_now*s420
        s499 = G_inv_20_now*J00_3_now_by + G_inv_21_now*J10_3_now_by + G_inv_22_now*J20_3_now_by + J00_3_now*s423 + J10_3_now*s426 + J20_3_now*s429
        s509 = G_inv_20_now*J00_4_now_by + G_inv_21_now*J10_4_now_by + G_inv_22_now*J20_4_now_by + J00_4_now*s423 + J10_4_now*s426 + J20_4_now*s429
        s519 = G_inv_20_now*J00_5_now_by + G_inv_21_now*J10_5_now_by + G_inv_22_now*J20_5_now_by + J00_5_now*s423 + J10_5_now*s426 + J20_5_now*s429
        s529 = -J01_0_now*s439 - J01_0_now_by*U_00_now - J01_1_now*s469 - J01_1_now_by*U_10_now - J01_2_now*s499 - J01_2_now_by*U_20_now + J01_3_now_by
        s539 = -J01_0_now*s449 - J01_0_now_by*U_01_now - J01_1_now*s479 - J01_1_now_by*U_11_now - J01_2_now*s509 - J01_2_now_by*U_21_now + J01_4_now_by
        s549 = -J01_0_now*s459 - J01_0_now_by*U_02_now - J01_1_now*s489 - J01_1_now_by*U_12_now - J01_2_now*s519 - J01_2_now_by*U_22_now + J01_5_now_by
        s559 = -J11_0_now*s439 - J11_0_now_by*U_00_now - J11_1_now*s469 - J11_1_now_by*U_10_now - J11_2_now*s499 - J11_2_now_by*U_20_now + J11_3_now_by
        s569 = -J11_0_now*s449 - J11_0_now_by*U_01_now - J11_1_now*s479 - J11_1_now_by*U_11_now - J11_2_now*s509 - J11_2_now_by*U_21_now + J11_4_now_by
        s579 = -J11_0_now*s459 - J11_0_now_by*U_02_now - J11_1_now*s489 - J11_1_now_by*U_12_now - J11_2_now*s519 - J11_2_now_by*U_22_now + J11_5_now_by
        s589 = -J21_0_now*s439 - J21_0_now_by*U_00_now - J21_1_now*s469 - J21_1_now_by*U_10_now - J21_2_now*s499 - J21_2_now_by*U_20_now + J21_3_now_by
        s599 = -J21_0_now*s449 - J21_0_now_by*U_01_now - J21_1_now*s479 - J21_1_now_by*U_11_now - J21_2_now*s509 - J21_2_now_by*U_21_now + J21_4_now_by
        s609 = -J21_0_now*s459 - J21_0_now_by*U_02_now - J21_1_now*s489 - J21_1_now_by*U_12_now - J21_2_now*s519 - J21_2_now_by*U_22_now + J21_5_now_by
        s616 = S_11_now*s609 - S_12_now*s599 - S_21_now*s579 + S_22_now*s569
        s623 = -S_10_now*s609 + S_12_now*s589 + S_20_now*s579 - S_22_now*s559
        s630 = S_10_now*s599 - S_11_now*s589 - S_20_now*s569 + S_21_now*s559
        s682 = S_00_now*s616 + S_01_now*s623 + S_02_now*s630 + Si_cof_00_now*s529 + Si_cof_01_now*s539 + Si_cof_02_now*s549
        s684 = -s682/(Si_det_00_now * Si_det_00_now)
        s687 = Si_by_00_now*s616 + Si_cof_00_now*s684
        s690 = Si_by_00_now*(-S_01_now*s609 + S_02_now*s599 + S_21_now*s549 - S_22_now*s539) + Si_cof_10_now*s684
        s693 = Si_by_00_now*(S_01_now*s579 - S_02_now*s569 - S_11_now*s549 + S_12_now*s539) + Si_cof_20_now*s684
        s696 = Si_by_00_now*s623 + Si_cof_01_now*s684
        s699 = Si_by_00_now*(S_00_now*s609 - S_02_now*s589 - S_20_now*s549 + S_22_now*s529) + Si_cof_11_now*s684
        s702 = Si_by_00_now*(-S_00_now*s579 + S_02_now*s559 + S_10_now*s549 - S_12_now*s529) + Si_cof_21_now*s684
        s705 = Si_by_00_now*s630 + Si_cof_02_now*s684
        s708 = Si_by_00_now*(-S_00_now*s599 + S_01_now*s589 + S_20_now*s539 - S_21_now*s529) + Si_cof_12_now*s684
        s711 = Si_by_00_now*(S_00_now*s569 - S_01_now*s559 - S_10_now*s539 + S_11_now*s529) + Si_cof_22_now*s684
        s721 = -J01_0_now*s687 - J01_0_now_by*Si_inv_00_now - J11_0_now*s690 - J11_0_now_by*Si_inv_01_now - J21_0_now*s693 - J21_0_now_by*Si_inv_02_now
        s731 = -J01_1_now*s687 - J01_1_now_by*Si_inv_00_now - J11_1_now*s690 - J11_1_now_by*Si_inv_01_now - J21_1_now*s693 - J21_1_now_by*Si_inv_02_now
        s741 = -J01_2_now*s687 - J01_2_now_by*Si_inv_00_now - J11_2_now*s690 - J11_2_now_by*Si_inv_01_now - J21_2_now*s693 - J21_2_now_by*Si_inv_02_now
        s751 = G_inv_00_now*s721 + G_inv_10_now*s731 + G_inv_20_now*s741 + s193_now*s405 + s198_now*s414 + s203_now*s423
        s761 = G_inv_01_now*s721 + G_inv_11_now*s731 + G_inv_21_now*s741 + s193_now*s408 + s198_now*s417 + s203_now*s426
        s771 = G_inv_02_now*s721 + G_inv_12_now*s731 + G_inv_22_now*s741 + s193_now*s411 + s198_now*s420 + s203_now*s429
        s781 = -J01_0_now*s696 - J01_0_now_by*Si_inv_10_now - J11_0_now*s699 - J11_0_now_by*Si_inv_11_now - J21_0_now*s702 - J21_0_now_by*Si_inv_12_now
        s791 = -J01_1_now*s696 - J01_1_now_by*Si_inv_10_now - J11_1_now*s699 - J11_1_now_by*Si_inv_11_now - J21_1_now*s702 - J21_1_now_by*Si_inv_12_now
        s801 = -J01_2_now*s696 - J01_2_now_by*Si_inv_10_now - J11_2_now*s699 - J11_2_now_by*Si_inv_11_now - J21_2_now*s702 - J21_2_now_by*Si_inv_12_now
        s811 = G_inv_00_now*s781 + G_inv_10_now*s791 + G_inv_20_now*s801 + s217_now*s405 + s222_now*s414 + s227_now*s423
        s821 = G_inv_01_now*s781 + G_inv_11_now*s791 + G_inv_21_now*s801 + s217_now*s408 + s222_now*s417 + s227_now*s426
        s831 = G_inv_02_now*s781 + G_inv_12_now*s791 + G_inv_22_now*s801 + s217_now*s411 + s222_now*s420 + s227_now*s429
        s841 = -J01_0_now*s705 - J01_0_now_by*Si_inv_20_now - J11_0_now*s708 - J11_0_now_by*Si_inv_21_now - J21_0_now*s711 - J21_0_now_by*Si_inv_22_now
        s851 = -J01_1_now*s705 - J01_1_now_by*Si_inv_20_now - J11_1_now*s708 - J11_1_now_by*Si_inv_21_now - J21_1_now*s711 - J21_1_now_by*Si_inv_22_now
        s861 = -J01_2_now*s705 - J01_2_now_by*Si_inv_20_now - J11_2_now*s708 - J11_2_now_by*Si_inv_21_now - J21_2_now*s711 - J21_2_now_by*Si_inv_22_now
        s871 = G_inv_00_now*s841 + G_inv_10_now*s851 + G_inv_20_now*s861 + s241_now*s405 + s246_now*s414 + s251_now*s423
        s881 = G_inv_01_now*s841 + G_inv_11_now*s851 + G_inv_21_now*s861 + s241_now*s408 + s246_now*s417 + s251_now*s426
        s891 = G_inv_02_now*s841 + G_inv_12_now*s851 + G_inv_22_now*s861 + s241_now*s411 + s246_now*s420 + s251_now*s429
        s901 = U_00_now*s751 + U_01_now*s811 + U_02_now*s871 + V_00_now*s439 + V_10_now*s449 + V_20_now*s459 - s405
        s911 = U_00_now*s761 + U_01_now*s821 + U_02_now*s881 + V_01_now*s439 + V_11_now*s449 + V_21_now*s459 - s408
        s921 = U_00_now*s771 + U_01_now*s831 + U_02_now*s891 + V_02_now*s439 + V_12_now*s449 + V_22_now*s459 - s411
        s931 = Si_inv_00_now*s439 + Si_inv_10_now*s449 + Si_inv_20_now*s459 + U_00_now*s687 + U_01_now*s696 + U_02_now*s705
        s941 = Si_inv_01_now*s439 + Si_inv_11_now*s449 + Si_inv_21_now*s459 + U_00_now*s690 + U_01_now*s699 + U_02_now*s708
        s951 = Si_inv_02_now*s439 + Si_inv_12_now*s449 + Si_inv_22_now*s459 + U_00_now*s693 + U_01_now*s702 + U_02_now*s711
        s961 = U_10_now*s751 + U_11_now*s811 + U_12_now*s871 + V_00_now*s469 + V_10_now*s479 + V_20_now*s489 - s414
        s971 = U_10_now*s761 + U_11_now*s821 + U_12_now*s881 + V_01_now*s469 + V_11_now*s479 + V_21_now*s489 - s417
        s981 = U_10_now*s771 + U_11_now*s831 + U_12_now*s891 + V_02_now*s469 + V_12_now*s479 + V_22_now*s489 - s420
        s991 = Si_inv_00_now*s469 + Si_inv_10_now*s479 + Si_inv_20_now*s489 + U_10_now*s687 + U_11_now*s696 + U_12_now*s705
        s1001 = Si_inv_01_now*s469 + Si_inv_11_now*s479 + Si_inv_21_now*s489 + U_10_now*s690 + U_11_now*s699 + U_12_now*s708
        s1011 = Si_inv_02_now*s469 + Si_inv_12_now*s479 + Si_inv_22_now*s489 + U_10_now*s693 + U_11_now*s702 + U_12_now*s711
        s1021 = U_20_now*s751 + U_21_now*s811 + U_22_now*s871 + V_00_now*s499 + V_10_now*s509 + V_20_now*s519 - s423
        s1031 = U_20_now*s761 + U_21_now*s821 + U_22_now*s881 + V_01_now*s499 + V_11_now*s509 + V_21_now*s519 - s426
        s1041 = U_20_now*s771 + U_21_now*s831 + U_22_now*s891 + V_02_now*s499 + V_12_now*s509 + V_22_now*s519 - s429
        s1051 = Si_inv_00_now*s499 + Si_inv_10_now*s509 + Si_inv_20_now*s519 + U_20_now*s687 + U_21_now*s696 + U_22_now*s705
        s1061 = Si_inv_01_now*s499 + Si_inv_11_now*s509 + Si_inv_21_now*s519 + U_20_now*s690 + U_21_now*s699 + U_22_now*s708
        s1071 = Si_inv_02_now*s499 + Si_inv_12_now*s509 + Si_inv_22_now*s519 + U_20_now*s693 + U_21_now*s702 + U_22_now*s711
        s1098 = -1.0e-12*s342_now*s346_now*(2*J00_0_now*J00_0_now_by + 2*J00_1_now*J00_1_now_by + 2*J00_2_now*J00_2_now_by)
        s1099 = -1.0e-12*s310*s346_now*(2*J10_0_now*J10_0_now_by + 2*J10_1_now*J10_1_now_by + 2*J10_2_now*J10_2_now_by)
        s1100 = -1.0e-12*s310*s342_now*(2*J20_0_now*J20_0_now_by + 2*J20_1_now*J20_1_now_by + 2*J20_2_now*J20_2_now_by)
        s1102 = 2*G_det_00_now*s400 + s1098 + s1099 + s1100
        s1129 = -1.0e-12*s357_now*s361_now*(2*J01_3_now*J01_3_now_by + 2*J01_4_now*J01_4_now_by + 2*J01_5_now*J01_5_now_by)
        s1130 = -1.0e-12*s325*s361_now*(2*J11_3_now*J11_3_now_by + 2*J11_4_now*J11_4_now_by + 2*J11_5_now*J11_5_now_by)
        s1131 = -1.0e-12*s325*s357_now*(2*J21_3_now*J21_3_now_by + 2*J21_4_now*J21_4_now_by + 2*J21_5_now*J21_5_now_by)
        s1133 = 2*Si_det_00_now*s682 + s1129 + s1130 + s1131
        w_by[6624 + lane] = s901
        w_by[6656 + lane] = s911
        w_by[6688 + lane] = s921
        w_by[6720 + lane] = s931
        w_by[6752 + lane] = s941
        w_by[6784 + lane] = s951
        w_by[6816 + lane] = s961
        w_by[6848 + lane] = s971
        w_by[6880 + lane] = s981
        w_by[6912 + lane] = s991
        w_by[6944 + lane] = s1001
        w_by[6976 + lane] = s1011
        w_by[7008 + lane] = s1021
        w_by[7040 + lane] = s1031
        w_by[7072 + lane] = s1041
        w_by[7104 + lane] = s1051
        w_by[7136 + lane] = s1061
        w_by[7168 + lane] = s1071
        w_by[7200 + lane] = -s751
        w_by[7232 + lane] = -s761
        w_by[7264 + lane] = -s771
        w_by[7296 + lane] = -s687
        w_by[7328 + lane] = -s690
        w_by[7360 + lane] = -s693
        w_by[7392 + lane] = -s811
        w_by[7424 + lane] = -s821
        w_by[7456 + lane] = -s831
        w_by[7488 + lane] = -s696
        w_by[7520 + lane] = -s699
        w_by[7552 + lane] = -s702
        w_by[7584 + lane] = -s871
        w_by[7616 + lane] = -s881
        w_by[7648 + lane] = -s891
        w_by[7680 + lane] = -s705
        w_by[7712 + lane] = -s708
        w_by[7744 + lane] = -s711
        w_by[7776 + lane] = s1102
        w_by[7808 + lane] = s1133


@straight
def _move_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of how the platform moves with each joint, and how it does (246 operations)."""
    for lane in range(n):
        M_0_0_now = w[6624 + lane]
        M_0_1_now = w[6656 + lane]
        M_0_2_now = w[6688 + lane]
        M_0_3_now = w[6720 + lane]
        M_0_4_now = w[6752 + lane]
        M_0_5_now = w[6784 + lane]
        M_1_0_now = w[6816 + lane]
        M_1_1_now = w[6848 + lane]
        M_1_2_now = w[6880 + lane]
        M_1_3_now = w[6912 + lane]
        M_1_4_now = w[6944 + lane]
        M_1_5_now = w[6976 + lane]
        M_2_0_now = w[7008 + lane]
        M_2_1_now = w[7040 + lane]
        M_2_2_now = w[7072 + lane]
        M_2_3_now = w[7104 + lane]
        M_2_4_now = w[7136 + lane]
        M_2_5_now = w[7168 + lane]
        M_3_0_now = w[7200 + lane]
        M_3_1_now = w[7232 + lane]
        M_3_2_now = w[7264 + lane]
        M_3_3_now = w[7296 + lane]
        M_3_4_now = w[7328 + lane]
        M_3_5_now = w[7360 + lane]
        M_4_0_now = w[7392 + lane]
        M_4_1_now = w[7424 + lane]
        M_4_2_now = w[7456 + lane]
        M_4_3_now = w[7488 + lane]
        M_4_4_now = w[7520 + lane]
        M_4_5_now = w[7552 + lane]
        M_5_0_now = w[7584 + lane]
        M_5_1_now = w[7616 + lane]
        M_5_2_now = w[7648 + lane]
        M_5_3_now = w[7680 + lane]
        M_5_4_now = w[7712 + lane]
        M_5_5_now = w[7744 + lane]
        q_t_0_now = d[0 + lane]
        Q_0_now = w[832 + lane]
        Q_3_now = w[1088 + lane]
        q_t_1_now = d[1056 + lane]
        Q_1_now = w[2944 + lane]
        Q_4_now = w[3200 + lane]
        q_t_2_now = d[2112 + lane]
        Q_2_now = w[5056 + lane]
        Q_5_now = w[5312 + lane]
        M_0_0_now_by = w_by[6624 + lane]
        M_0_1_now_by = w_by[6656 + lane]
        M_0_2_now_by = w_by[6688 + lane]
        M_0_3_now_by = w_by[6720 + lane]
        M_0_4_now_by = w_by[6752 + lane]
        M_0_5_now_by = w_by[6784 + lane]
        M_1_0_now_by = w_by[6816 + lane]
        M_1_1_now_by = w_by[6848 + lane]
        M_1_2_now_by = w_by[6880 + lane]
        M_1_3_now_by = w_by[6912 + lane]
        M_1_4_now_by = w_by[6944 + lane]
        M_1_5_now_by = w_by[6976 + lane]
        M_2_0_now_by = w_by[7008 + lane]
        M_2_1_now_by = w_by[7040 + lane]
        M_2_2_now_by = w_by[7072 + lane]
        M_2_3_now_by = w_by[7104 + lane]
        M_2_4_now_by = w_by[7136 + lane]
        M_2_5_now_by = w_by[7168 + lane]
        M_3_0_now_by = w_by[7200 + lane]
        M_3_1_now_by = w_by[7232 + lane]
        M_3_2_now_by = w_by[7264 + lane]
        M_3_3_now_by = w_by[7296 + lane]
        M_3_4_now_by = w_by[7328 + lane]
        M_3_5_now_by = w_by[7360 + lane]
        M_4_0_now_by = w_by[7392 + lane]
        M_4_1_now_by = w_by[7424 + lane]
        M_4_2_now_by = w_by[7456 + lane]
        M_4_3_now_by = w_by[7488 + lane]
        M_4_4_now_by = w_by[7520 + lane]
        M_4_5_now_by = w_by[7552 + lane]
        M_5_0_now_by = w_by[7584 + lane]
        M_5_1_now_by = w_by[7616 + lane]
        M_5_2_now_by = w_by[7648 + lane]
        M_5_3_now_by = w_by[7680 + lane]
        M_5_4_now_by = w_by[7712 + lane]
        M_5_5_now_by = w_by[7744 + lane]
        q_t_0_now_by = d_by[0 + lane]
        Q_0_now_by = w_by[832 + lane]
        Q_3_now_by = w_by[1088 + lane]
        q_t_1_now_by = d_by[1056 + lane]
        Q_1_now_by = w_by[2944 + lane]
        Q_4_now_by = w_by[3200 + lane]
        q_t_2_now_by = d_by[2112 + lane]
        Q_2_now_by = w_by[5056 + lane]
        Q_5_now_by = w_by[5312 + lane]
        V_0_0_now = M_0_0_now*Q_0_now + M_0_3_now*Q_3_now
        V_0_1_now = M_0_1_now*Q_1_now + M_0_4_now*Q_4_now
        V_0_2_now = M_0_2_now*Q_2_now + M_0_5_now*Q_5_now
        V_1_0_now = M_1_0_now*Q_0_now + M_1_3_now*Q_3_now
        V_1_1_now = M_1_1_now*Q_1_now + M_1_4_now*Q_4_now
        V_1_2_now = M_1_2_now*Q_2_now + M_1_5_now*Q_5_now
        V_2_0_now = M_2_0_now*Q_0_now + M_2_3_now*Q_3_now
        V_2_1_now = M_2_1_now*Q_1_now + M_2_4_now*Q_4_now
        V_2_2_now = M_2_2_now*Q_2_now + M_2_5_now*Q_5_now
        V_3_0_now = M_3_0_now*Q_0_now + M_3_3_now*Q_3_now
        V_3_1_now = M_3_1_now*Q_1_now + M_3_4_now*Q_4_now
        V_3_2_now = M_3_2_now*Q_2_now + M_3_5_now*Q_5_now
        V_4_0_now = M_4_0_now*Q_0_now + M_4_3_now*Q_3_now
        V_4_1_now = M_4_1_now*Q_1_now + M_4_4_now*Q_4_now
        V_4_2_now = M_4_2_now*Q_2_now + M_4_5_now*Q_5_now
        V_5_0_now = M_5_0_now*Q_0_now + M_5_3_now*Q_3_now
        V_5_1_now = M_5_1_now*Q_1_now + M_5_4_now*Q_4_now
        V_5_2_now = M_5_2_now*Q_2_now + M_5_5_now*Q_5_now
        s84 = M_0_0_now*Q_0_now_by + M_0_0_now_by*Q_0_now + M_0_3_now*Q_3_now_by + M_0_3_now_by*Q_3_now
        s91 = M_0_1_now*Q_1_now_by + M_0_1_now_by*Q_1_now + M_0_4_now*Q_4_now_by + M_0_4_now_by*Q_4_now
        s98 = M_0_2_now*Q_2_now_by + M_0_2_now_by*Q_2_now + M_0_5_now*Q_5_now_by + M_0_5_now_by*Q_5_now
        s105 = M_1_0_now*Q_0_now_by + M_1_0_now_by*Q_0_now + M_1_3_now*Q_3_now_by + M_1_3_now_by*Q_3_now
        s112 = M_1_1_now*Q_1_now_by + M_1_1_now_by*Q_1_now + M_1_4_now*Q_4_now_by + M_1_4_now_by*Q_4_now
        s119 = M_1_2_now*Q_2_now_by + M_1_2_now_by*Q_2_now + M_1_5_now*Q_5_now_by + M_1_5_now_by*Q_5_now
        s126 = M_2_0_now*Q_0_now_by + M_2_0_now_by*Q_0_now + M_2_3_now*Q_3_now_by + M_2_3_now_by*Q_3_now
        s133 = M_2_1_now*Q_1_now_by + M_2_1_now_by*Q_1_now + M_2_4_now*Q_4_now_by + M_2_4_now_by*Q_4_now
        s140 = M_2_2_now*Q_2_now_by + M_2_2_now_by*Q_2_now + M_2_5_now*Q_5_now_by + M_2_5_now_by*Q_5_now
        s147 = M_3_0_now*Q_0_now_by + M_3_0_now_by*Q_0_now + M_3_3_now*Q_3_now_by + M_3_3_now_by*Q_3_now
        s154 = M_3_1_now*Q_1_now_by + M_3_1_now_by*Q_1_now + M_3_4_now*Q_4_now_by + M_3_4_now_by*Q_4_now
        s161 = M_3_2_now*Q_2_now_by + M_3_2_now_by*Q_2_now + M_3_5_now*Q_5_now_by + M_3_5_now_by*Q_5_now
        s168 = M_4_0_now*Q_0_now_by + M_4_0_now_by*Q_0_now + M_4_3_now*Q_3_now_by + M_4_3_now_by*Q_3_now
        s175 = M_4_1_now*Q_1_now_by + M_4_1_now_by*Q_1_now + M_4_4_now*Q_4_now_by + M_4_4_now_by*Q_4_now
        s182 = M_4_2_now*Q_2_now_by + M_4_2_now_by*Q_2_now + M_4_5_now*Q_5_now_by + M_4_5_now_by*Q_5_now
        s189 = M_5_0_now*Q_0_now_by + M_5_0_now_by*Q_0_now + M_5_3_now*Q_3_now_by + M_5_3_now_by*Q_3_now
        s196 = M_5_1_now*Q_1_now_by + M_5_1_now_by*Q_1_now + M_5_4_now*Q_4_now_by + M_5_4_now_by*Q_4_now
        s203 = M_5_2_now*Q_2_now_by + M_5_2_now_by*Q_2_now + M_5_5_now*Q_5_now_by + M_5_5_now_by*Q_5_now
        s213 = V_0_0_now*q_t_0_now_by + V_0_1_now*q_t_1_now_by + V_0_2_now*q_t_2_now_by + q_t_0_now*s84 + q_t_1_now*s91 + q_t_2_now*s98
        s223 = V_1_0_now*q_t_0_now_by + V_1_1_now*q_t_1_now_by + V_1_2_now*q_t_2_now_by + q_t_0_now*s105 + q_t_1_now*s112 + q_t_2_now*s119
        s233 = V_2_0_now*q_t_0_now_by + V_2_1_now*q_t_1_now_by + V_2_2_now*q_t_2_now_by + q_t_0_now*s126 + q_t_1_now*s133 + q_t_2_now*s140
        s243 = V_3_0_now*q_t_0_now_by + V_3_1_now*q_t_1_now_by + V_3_2_now*q_t_2_now_by + q_t_0_now*s147 + q_t_1_now*s154 + q_t_2_now*s161
        s253 = V_4_0_now*q_t_0_now_by + V_4_1_now*q_t_1_now_by + V_4_2_now*q_t_2_now_by + q_t_0_now*s168 + q_t_1_now*s175 + q_t_2_now*s182
        s263 = V_5_0_now*q_t_0_now_by + V_5_1_now*q_t_1_now_by + V_5_2_now*q_t_2_now_by + q_t_0_now*s189 + q_t_1_now*s196 + q_t_2_now*s203
        s_by[0 + lane] = s84
        s_by[32 + lane] = s91
        s_by[64 + lane] = s98
        s_by[96 + lane] = s105
        s_by[128 + lane] = s112
        s_by[160 + lane] = s119
        s_by[192 + lane] = s126
        s_by[224 + lane] = s133
        s_by[256 + lane] = s140
        s_by[288 + lane] = s147
        s_by[320 + lane] = s154
        s_by[352 + lane] = s161
        s_by[384 + lane] = s168
        s_by[416 + lane] = s175
        s_by[448 + lane] = s182
        s_by[480 + lane] = s189
        s_by[512 + lane] = s196
        s_by[544 + lane] = s203
        s_by[576 + lane] = s213
        s_by[608 + lane] = s223
        s_by[640 + lane] = s233
        s_by[672 + lane] = s243
        s_by[704 + lane] = s253
        s_by[736 + lane] = s263


@straight
def _curved_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of second derivatives of a limb's equations by time where nothing accelerates (588 operations)."""
    s60_now = k[0]
    s59_now = k[1]
    axis_x_now = k[2]
    s65_now = k[3]
    axis_y_now = k[4]
    s68_now = k[5]
    axis_z_now = k[6]
    s71_now = k[7]
    s74_now = k[8]
    u_x_now = k[9]
    u_y_now = k[10]
    s93_now = k[11]
    s60_now_by = k_by[0]
    s59_now_by = k_by[1]
    axis_x_now_by = k_by[2]
    s65_now_by = k_by[3]
    axis_y_now_by = k_by[4]
    s68_now_by = k_by[5]
    axis_z_now_by = k_by[6]
    s71_now_by = k_by[7]
    s74_now_by = k_by[8]
    u_x_now_by = k_by[9]
    u_y_now_by = k_by[10]
    s93_now_by = k_by[11]
    for lane in range(n):
        q_now = w[0 + lane]
        tx_now = w[32 + lane]
        ty_now = w[64 + lane]
        tz_now = w[96 + lane]
        px_now = w[128 + lane]
        py_now = w[160 + lane]
        pz_now = w[192 + lane]
        R_11_now = w[320 + lane]
        R_12_now = w[352 + lane]
        R_13_now = w[384 + lane]
        R_21_now = w[416 + lane]
        R_22_now = w[448 + lane]
        R_23_now = w[480 + lane]
        R_31_now = w[512 + lane]
        R_32_now = w[544 + lane]
        R_33_now = w[576 + lane]
        v_px_now = s[576 + lane]
        v_py_now = s[608 + lane]
        v_pz_now = s[640 + lane]
        w_x_now = s[672 + lane]
        w_y_now = s[704 + lane]
        w_z_now = s[736 + lane]
        q_t_now = d[0 + lane]
        px_now_by = w_by[128 + lane]
        py_now_by = w_by[160 + lane]
        pz_now_by = w_by[192 + lane]
        R_11_now_by = w_by[320 + lane]
        R_12_now_by = w_by[352 + lane]
        R_13_now_by = w_by[384 + lane]
        R_21_now_by = w_by[416 + lane]
        R_22_now_by = w_by[448 + lane]
        R_23_now_by = w_by[480 + lane]
        R_31_now_by = w_by[512 + lane]
        R_32_now_by = w_by[544 + lane]
        R_33_now_by = w_by[576 + lane]
        v_px_now_by = s_by[576 + lane]
        v_py_now_by = s_by[608 + lane]
        v_pz_now_by = s_by[640 + lane]
        w_x_now_by = s_by[672 + lane]
        w_y_now_by = s_by[704 + lane]
        w_z_now_by = s_by[736 + lane]
        q_t_now_by = d_by[0 + lane]
        s62_now = -q_now*s60_now + s59_now
        C_x_now = axis_x_now*s62_now + s65_now
        C_y_now = axis_y_now*s62_now + s68_now
        C_z_now = axis_z_now*s62_now
        s72_now = s71_now - tx_now
        s75_now = s74_now - ty_now
        A_x_now = R_11_now*s72_now + R_12_now*s75_now - R_13_now*tz_now + px_now
        A_y_now = R_21_now*s72_now + R_22_now*s75_now - R_23_now*tz_now + py_now
        A_z_now = R_31_now*s72_now + R_32_now*s75_now - R_33_now*tz_now + pz_now
        d_x_now = A_x_now - C_x_now
        d_y_now = A_y_now - C_y_now
        d_z_now = A_z_now - C_z_now
        s26 = -R_11_now*u_y_now + R_12_now*u_x_now + u_y_now
        s_x_now = s26*s93_now
        s30 = -R_21_now*u_y_now + R_22_now*u_x_now - u_x_now
        s_y_now = s30*s93_now
        s34 = -R_31_now*u_y_now + R_32_now*u_x_now
        s_z_now = s34*s93_now
        s132_now = -R_21_now*w_z_now + R_31_now*w_y_now
        s135_now = -R_22_now*w_z_now + R_32_now*w_y_now
        s138_now = -R_23_now*w_z_now + R_33_now*w_y_now
        s141_now = R_11_now*w_z_now - R_31_now*w_x_now
        s144_now = R_12_now*w_z_now - R_32_now*w_x_now
        s147_now = R_13_now*w_z_now - R_33_now*w_x_now
        s150_now = -R_11_now*w_y_now + R_21_now*w_x_now
        s153_now = -R_12_now*w_y_now + R_22_now*w_x_now
        s156_now = -R_13_now*w_y_now + R_23_now*w_x_now
        s157_now = -q_t_now*s60_now
        s173_now = -axis_x_now*s157_now + s132_now*s72_now + s135_now*s75_now - s138_now*tz_now + v_px_now
        s174_now = -axis_y_now*s157_now + s141_now*s72_now + s144_now*s75_now - s147_now*tz_now + v_py_now
        s175_now = -axis_z_now*s157_now + s150_now*s72_now + s153_now*s75_now - s156_now*tz_now + v_pz_now
        s81 = -s132_now*u_y_now + s135_now*u_x_now
        s179_now = s81*s93_now
        s85 = -s141_now*u_y_now + s144_now*u_x_now
        s183_now = s85*s93_now
        s89 = -s150_now*u_y_now + s153_now*u_x_now
        s187_now = s89*s93_now
        s219_now = -s141_now*w_z_now + s150_now*w_y_now
        s222_now = -s144_now*w_z_now + s153_now*w_y_now
        s228_now = s132_now*w_z_now - s150_now*w_x_now
        s231_now = s135_now*w_z_now - s153_now*w_x_now
        s237_now = -s132_now*w_y_now + s141_now*w_x_now
        s240_now = -s135_now*w_y_now + s144_now*w_x_now
        s247_now = s219_now*s72_now + s222_now*s75_now - tz_now*(-s147_now*w_z_now + s156_now*w_y_now)
        s251_now = s228_now*s72_now + s231_now*s75_now - tz_now*(s138_now*w_z_now - s156_now*w_x_now)
        s255_now = s237_now*s72_now + s240_now*s75_now - tz_now*(-s138_now*w_y_now + s147_now*w_x_now)
        s132 = -s219_now*u_y_now + s222_now*u_x_now
        s259_now = s132*s93_now
        s136 = -s228_now*u_y_now + s231_now*u_x_now
        s263_now = s136*s93_now
        s140 = -s237_now*u_y_now + s240_now*u_x_now
        s267_now = s140*s93_now
        s174 = -q_now*s60_now_by + s59_now_by
        s193 = R_11_now*s71_now_by + R_11_now_by*s72_now + R_12_now*s74_now_by + R_12_now_by*s75_now - R_13_now_by*tz_now + px_now_by
        s201 = R_21_now*s71_now_by + R_21_now_by*s72_now + R_22_now*s74_now_by + R_22_now_by*s75_now - R_23_now_by*tz_now + py_now_by
        s209 = R_31_now*s71_now_by + R_31_now_by*s72_now + R_32_now*s74_now_by + R_32_now_by*s75_now - R_33_now_by*tz_now + pz_now_by
        s210 = -axis_x_now*s174 - axis_x_now_by*s62_now + s193 - s65_now_by
        s211 = -axis_y_now*s174 - axis_y_now_by*s62_now + s201 - s68_now_by
        s212 = -axis_z_now*s174 - axis_z_now_by*s62_now + s209
        s222 = s26*s93_now_by + s93_now*(-R_11_now*u_y_now_by - R_11_now_by*u_y_now + R_12_now*u_x_now_by + R_12_now_by*u_x_now + u_y_now_by)
        s232 = s30*s93_now_by + s93_now*(-R_21_now*u_y_now_by - R_21_now_by*u_y_now + R_22_now*u_x_now_by + R_22_now_by*u_x_now - u_x_now_by)
        s242 = s34*s93_now_by + s93_now*(-R_31_now*u_y_now_by - R_31_now_by*u_y_now + R_32_now*u_x_now_by + R_32_now_by*u_x_now)
        s249 = -R_21_now*w_z_now_by - R_21_now_by*w_z_now + R_31_now*w_y_now_by + R_31_now_by*w_y_now
        s256 = -R_22_now*w_z_now_by - R_22_now_by*w_z_now + R_32_now*w_y_now_by + R_32_now_by*w_y_now
        s263 = -R_23_now*w_z_now_by - R_23_now_by*w_z_now + R_33_now*w_y_now_by + R_33_now_by*w_y_now
        s270 = R_11_now*w_z_now_by + R_11_now_by*w_z_now - R_31_now*w_x_now_by - R_31_now_by*w_x_now
        s277 = R_12_now*w_z_now_by + R_12_now_by*w_z_now - R_32_now*w_x_now_by - R_32_now_by*w_x_now
        s284 = R_13_now*w_z_now_by + R_13_now_by*w_z_now - R_33_now*w_x_now_by - R_33_now_by*w_x_now
        s291 = -R_11_now*w_y_now_by - R_11_now_by*w_y_now + R_21_now*w_x_now_by + R_21_now_by*w_x_now
        s298 = -R_12_now*w_y_now_by - R_12_now_by*w_y_now + R_22_now*w_x_now_by + R_22_now_by*w_x_now
        s305 = -R_13_now*w_y_now_by - R_13_now_by*w_y_now + R_23_now*w_x_now_by + R_23_now_by*w_x_now
        s308 = -q_t_now*s60_now_by - q_t_now_by*s60_now
        s317 = -axis_x_now*s308 - axis_x_now_by*s157_now
        s319 = s132_now*s71_now_by + s135_now*s74_now_by + s249*s72_now + s256*s75_now - s263*tz_now + s317 + v_px_now_by
        s328 = -axis_y_now*s308 - axis_y_now_by*s157_now
        s330 = s141_now*s71_now_by + s144_now*s74_now_by + s270*s72_now + s277*s75_now - s284*tz_now + s328 + v_py_now_by
        s339 = -axis_z_now*s308 - axis_z_now_by*s157_now
        s341 = s150_now*s71_now_by + s153_now*s74_now_by + s291*s72_now + s298*s75_now - s305*tz_now + s339 + v_pz_now_by
        s351 = s81*s93_now_by + s93_now*(-s132_now*u_y_now_by + s135_now*u_x_now_by - s249*u_y_now + s256*u_x_now)
        s361 = s85*s93_now_by + s93_now*(-s141_now*u_y_now_by + s144_now*u_x_now_by - s270*u_y_now + s277*u_x_now)
        s371 = s89*s93_now_by + s93_now*(-s150_now*u_y_now_by + s153_now*u_x_now_by - s291*u_y_now + s298*u_x_now)
        s378 = -s141_now*w_z_now_by + s150_now*w_y_now_by - s270*w_z_now + s291*w_y_now
        s385 = -s144_now*w_z_now_by + s153_now*w_y_now_by - s277*w_z_now + s298*w_y_now
        s392 = s132_now*w_z_now_by - s150_now*w_x_now_by + s249*w_z_now - s291*w_x_now
        s399 = s135_now*w_z_now_by - s153_now*w_x_now_by + s256*w_z_now - s298*w_x_now
        s406 = -s132_now*w_y_now_by + s141_now*w_x_now_by - s249*w_y_now + s270*w_x_now
        s413 = -s135_now*w_y_now_by + s144_now*w_x_now_by - s256*w_y_now + s277*w_x_now
        s427 = -tz_now*(-s147_now*w_z_now_by + s156_now*w_y_now_by - s284*w_z_now + s305*w_y_now)
        s428 = s219_now*s71_now_by + s222_now*s74_now_by + s378*s72_now + s385*s75_now + s427
        s442 = -tz_now*(s138_now*w_z_now_by - s156_now*w_x_now_by + s263*w_z_now - s305*w_x_now)
        s443 = s228_now*s71_now_by + s231_now*s74_now_by + s392*s72_now + s399*s75_now + s442
        s457 = -tz_now*(-s138_now*w_y_now_by + s147_now*w_x_now_by - s263*w_y_now + s284*w_x_now)
        s458 = s237_now*s71_now_by + s240_now*s74_now_by + s406*s72_now + s413*s75_now + s457
        s468 = s132*s93_now_by + s93_now*(-s219_now*u_y_now_by + s222_now*u_x_now_by - s378*u_y_now + s385*u_x_now)
        s478 = s136*s93_now_by + s93_now*(-s228_now*u_y_now_by + s231_now*u_x_now_by - s392*u_y_now + s399*u_x_now)
        s488 = s140*s93_now_by + s93_now*(-s237_now*u_y_now_by + s240_now*u_x_now_by - s406*u_y_now + s413*u_x_now)
        s494 = d_z_now*s458 + 2*s175_now*s341 + s212*s255_now
        s500 = 2*s179_now*s351 + s222*s259_now + s468*s_x_now
        s506 = 2*s183_now*s361 + s232*s263_now + s478*s_y_now
        s512 = 2*s187_now*s371 + s242*s267_now + s488*s_z_now
        s519 = d_x_now*s428 + s210*s247_now
        s522 = d_y_now*s443 + s211*s251_now
        s523 = 2*s173_now*s319 + 2*s174_now*s330 + s494 + s500 + s506 + s512 + s519 + s522
        s539 = s242*s255_now + s458*s_z_now
        s540 = d_z_now*s488 + 2*s175_now*s371 + 2*s187_now*s341 + s212*s267_now + s539
        s542 = 2*s174_now*s361 + 2*s183_now*s330
        s545 = d_x_now*s468 + s210*s259_now
        s548 = d_y_now*s478 + s211*s263_now
        s551 = s222*s247_now + s428*s_x_now
        s554 = s232*s251_now + s443*s_y_now
        s555 = 2*s173_now*s351 + 2*s179_now*s319 + s540 + s542 + s545 + s548 + s551 + s554
        d_by[64 + lane] = s523
        d_by[96 + lane] = s555


@straight
def _accelerate_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of the platform's acceleration (210 operations)."""
    for lane in range(n):
        M_0_0_now = w[6624 + lane]
        M_0_1_now = w[6656 + lane]
        M_0_2_now = w[6688 + lane]
        M_0_3_now = w[6720 + lane]
        M_0_4_now = w[6752 + lane]
        M_0_5_now = w[6784 + lane]
        M_1_0_now = w[6816 + lane]
        M_1_1_now = w[6848 + lane]
        M_1_2_now = w[6880 + lane]
        M_1_3_now = w[6912 + lane]
        M_1_4_now = w[6944 + lane]
        M_1_5_now = w[6976 + lane]
        M_2_0_now = w[7008 + lane]
        M_2_1_now = w[7040 + lane]
        M_2_2_now = w[7072 + lane]
        M_2_3_now = w[7104 + lane]
        M_2_4_now = w[7136 + lane]
        M_2_5_now = w[7168 + lane]
        M_3_0_now = w[7200 + lane]
        M_3_1_now = w[7232 + lane]
        M_3_2_now = w[7264 + lane]
        M_3_3_now = w[7296 + lane]
        M_3_4_now = w[7328 + lane]
        M_3_5_now = w[7360 + lane]
        M_4_0_now = w[7392 + lane]
        M_4_1_now = w[7424 + lane]
        M_4_2_now = w[7456 + lane]
        M_4_3_now = w[7488 + lane]
        M_4_4_now = w[7520 + lane]
        M_4_5_now = w[7552 + lane]
        M_5_0_now = w[7584 + lane]
        M_5_1_now = w[7616 + lane]
        M_5_2_now = w[7648 + lane]
        M_5_3_now = w[7680 + lane]
        M_5_4_now = w[7712 + lane]
        M_5_5_now = w[7744 + lane]
        q_tt_0_now = d[32 + lane]
        c_0_now = d[64 + lane]
        c_3_now = d[96 + lane]
        q_tt_1_now = d[1088 + lane]
        c_1_now = d[1120 + lane]
        c_4_now = d[1152 + lane]
        q_tt_2_now = d[2144 + lane]
        c_2_now = d[2176 + lane]
        c_5_now = d[2208 + lane]
        V_0_0_now = s[0 + lane]
        V_0_1_now = s[32 + lane]
        V_0_2_now = s[64 + lane]
        V_1_0_now = s[96 + lane]
        V_1_1_now = s[128 + lane]
        V_1_2_now = s[160 + lane]
        V_2_0_now = s[192 + lane]
        V_2_1_now = s[224 + lane]
        V_2_2_now = s[256 + lane]
        V_3_0_now = s[288 + lane]
        V_3_1_now = s[320 + lane]
        V_3_2_now = s[352 + lane]
        V_4_0_now = s[384 + lane]
        V_4_1_now = s[416 + lane]
        V_4_2_now = s[448 + lane]
        V_5_0_now = s[480 + lane]
        V_5_1_now = s[512 + lane]
        V_5_2_now = s[544 + lane]
        M_0_0_now_by = w_by[6624 + lane]
        M_0_1_now_by = w_by[6656 + lane]
        M_0_2_now_by = w_by[6688 + lane]
        M_0_3_now_by = w_by[6720 + lane]
        M_0_4_now_by = w_by[6752 + lane]
        M_0_5_now_by = w_by[6784 + lane]
        M_1_0_now_by = w_by[6816 + lane]
        M_1_1_now_by = w_by[6848 + lane]
        M_1_2_now_by = w_by[6880 + lane]
        M_1_3_now_by = w_by[6912 + lane]
        M_1_4_now_by = w_by[6944 + lane]
        M_1_5_now_by = w_by[6976 + lane]
        M_2_0_now_by = w_by[7008 + lane]
        M_2_1_now_by = w_by[7040 + lane]
        M_2_2_now_by = w_by[7072 + lane]
        M_2_3_now_by = w_by[7104 + lane]
        M_2_4_now_by = w_by[7136 + lane]
        M_2_5_now_by = w_by[7168 + lane]
        M_3_0_now_by = w_by[7200 + lane]
        M_3_1_now_by = w_by[7232 + lane]
        M_3_2_now_by = w_by[7264 + lane]
        M_3_3_now_by = w_by[7296 + lane]
        M_3_4_now_by = w_by[7328 + lane]
        M_3_5_now_by = w_by[7360 + lane]
        M_4_0_now_by = w_by[7392 + lane]
        M_4_1_now_by = w_by[7424 + lane]
        M_4_2_now_by = w_by[7456 + lane]
        M_4_3_now_by = w_by[7488 + lane]
        M_4_4_now_by = w_by[7520 + lane]
        M_4_5_now_by = w_by[7552 + lane]
        M_5_0_now_by = w_by[7584 + lane]
        M_5_1_now_by = w_by[7616 + lane]
        M_5_2_now_by = w_by[7648 + lane]
        M_5_3_now_by = w_by[7680 + lane]
        M_5_4_now_by = w_by[7712 + lane]
        M_5_5_now_by = w_by[7744 + lane]
        q_tt_0_now_by = d_by[32 + lane]
        c_0_now_by = d_by[64 + lane]
        c_3_now_by = d_by[96 + lane]
        q_tt_1_now_by = d_by[1088 + lane]
        c_1_now_by = d_by[1120 + lane]
        c_4_now_by = d_by[1152 + lane]
        q_tt_2_now_by = d_by[2144 + lane]
        c_2_now_by = d_by[2176 + lane]
        c_5_now_by = d_by[2208 + lane]
        V_0_0_now_by = s_by[0 + lane]
        V_0_1_now_by = s_by[32 + lane]
        V_0_2_now_by = s_by[64 + lane]
        V_1_0_now_by = s_by[96 + lane]
        V_1_1_now_by = s_by[128 + lane]
        V_1_2_now_by = s_by[160 + lane]
        V_2_0_now_by = s_by[192 + lane]
        V_2_1_now_by = s_by[224 + lane]
        V_2_2_now_by = s_by[256 + lane]
        V_3_0_now_by = s_by[288 + lane]
        V_3_1_now_by = s_by[320 + lane]
        V_3_2_now_by = s_by[352 + lane]
        V_4_0_now_by = s_by[384 + lane]
        V_4_1_now_by = s_by[416 + lane]
        V_4_2_now_by = s_by[448 + lane]
        V_5_0_now_by = s_by[480 + lane]
        V_5_1_now_by = s_by[512 + lane]
        V_5_2_now_by = s_by[544 + lane]
        s65 = M_0_5_now*c_5_now_by + M_0_5_now_by*c_5_now
        s68 = V_0_0_now*q_tt_0_now_by + V_0_0_now_by*q_tt_0_now
        s71 = V_0_1_now*q_tt_1_now_by + V_0_1_now_by*q_tt_1_now
        s74 = V_0_2_now*q_tt_2_now_by + V_0_2_now_by*q_tt_2_now
        s77 = M_0_0_now*c_0_now_by + M_0_0_now_by*c_0_now
        s80 = M_0_1_now*c_1_now_by + M_0_1_now_by*c_1_now
        s83 = M_0_2_now*c_2_now_by + M_0_2_now_by*c_2_now
        s86 = M_0_3_now*c_3_now_by + M_0_3_now_by*c_3_now
        s87 = M_0_4_now*c_4_now_by + M_0_4_now_by*c_4_now + s65 + s68 + s71 + s74 + s77 + s80 + s83 + s86
        s93 = M_1_5_now*c_5_now_by + M_1_5_now_by*c_5_now
        s96 = V_1_0_now*q_tt_0_now_by + V_1_0_now_by*q_tt_0_now
        s99 = V_1_1_now*q_tt_1_now_by + V_1_1_now_by*q_tt_1_now
        s102 = V_1_2_now*q_tt_2_now_by + V_1_2_now_by*q_tt_2_now
        s105 = M_1_0_now*c_0_now_by + M_1_0_now_by*c_0_now
        s108 = M_1_1_now*c_1_now_by + M_1_1_now_by*c_1_now
        s111 = M_1_2_now*c_2_now_by + M_1_2_now_by*c_2_now
        s114 = M_1_3_now*c_3_now_by + M_1_3_now_by*c_3_now
        s115 = M_1_4_now*c_4_now_by + M_1_4_now_by*c_4_now + s102 + s105 + s108 + s111 + s114 + s93 + s96 + s99
        s121 = M_2_5_now*c_5_now_by + M_2_5_now_by*c_5_now
        s124 = V_2_0_now*q_tt_0_now_by + V_2_0_now_by*q_tt_0_now
        s127 = V_2_1_now*q_tt_1_now_by + V_2_1_now_by*q_tt_1_now
        s130 = V_2_2_now*q_tt_2_now_by + V_2_2_now_by*q_tt_2_now
        s133 = M_2_0_now*c_0_now_by + M_2_0_now_by*c_0_now
        s136 = M_2_1_now*c_1_now_by + M_2_1_now_by*c_1_now
        s139 = M_2_2_now*c_2_now_by + M_2_2_now_by*c_2_now
        s142 = M_2_3_now*c_3_now_by + M_2_3_now_by*c_3_now
        s143 = M_2_4_now*c_4_now_by + M_2_4_now_by*c_4_now + s121 + s124 + s127 + s130 + s133 + s136 + s139 + s142
        s149 = M_3_5_now*c_5_now_by + M_3_5_now_by*c_5_now
        s152 = V_3_0_now*q_tt_0_now_by + V_3_0_now_by*q_tt_0_now
        s155 = V_3_1_now*q_tt_1_now_by + V_3_1_now_by*q_tt_1_now
        s158 = V_3_2_now*q_tt_2_now_by + V_3_2_now_by*q_tt_2_now
        s161 = M_3_0_now*c_0_now_by + M_3_0_now_by*c_0_now
        s164 = M_3_1_now*c_1_now_by + M_3_1_now_by*c_1_now
        s167 = M_3_2_now*c_2_now_by + M_3_2_now_by*c_2_now
        s170 = M_3_3_now*c_3_now_by + M_3_3_now_by*c_3_now
        s171 = M_3_4_now*c_4_now_by + M_3_4_now_by*c_4_now + s149 + s152 + s155 + s158 + s161 + s164 + s167 + s170
        s177 = M_4_5_now*c_5_now_by + M_4_5_now_by*c_5_now
        s180 = V_4_0_now*q_tt_0_now_by + V_4_0_now_by*q_tt_0_now
        s183 = V_4_1_now*q_tt_1_now_by + V_4_1_now_by*q_tt_1_now
        s186 = V_4_2_now*q_tt_2_now_by + V_4_2_now_by*q_tt_2_now
        s189 = M_4_0_now*c_0_now_by + M_4_0_now_by*c_0_now
        s192 = M_4_1_now*c_1_now_by + M_4_1_now_by*c_1_now
        s195 = M_4_2_now*c_2_now_by + M_4_2_now_by*c_2_now
        s198 = M_4_3_now*c_3_now_by + M_4_3_now_by*c_3_now
        s199 = M_4_4_now*c_4_now_by + M_4_4_now_by*c_4_now + s177 + s180 + s183 + s186 + s189 + s192 + s195 + s198
        s205 = M_5_5_now*c_5_now_by + M_5_5_now_by*c_5_now
        s208 = V_5_0_now*q_tt_0_now_by + V_5_0_now_by*q_tt_0_now
        s211 = V_5_1_now*q_tt_1_now_by + V_5_1_now_by*q_tt_1_now
        s214 = V_5_2_now*q_tt_2_now_by + V_5_2_now_by*q_tt_2_now
        s217 = M_5_0_now*c_0_now_by + M_5_0_now_by*c_0_now
        s220 = M_5_1_now*c_1_now_by + M_5_1_now_by*c_1_now
        s223 = M_5_2_now*c_2_now_by + M_5_2_now_by*c_2_now
        s226 = M_5_3_now*c_3_now_by + M_5_3_now_by*c_3_now
        s227 = M_5_4_now*c_4_now_by + M_5_4_now_by*c_4_now + s205 + s208 + s211 + s214 + s217 + s220 + s223 + s226
        s_by[768 + lane] = s87
        s_by[800 + lane] = s115
        s_by[832 + lane] = s143
        s_by[864 + lane] = s171
        s_by[896 + lane] = s199
        s_by[928 + lane] = s227


@straight
def _limb_fields_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of gravity less acceleration of the points of a limb (449 operations)."""
    s60_now = k[0]
    axis_x_now = k[2]
    axis_y_now = k[4]
    axis_z_now = k[6]
    s71_now = k[7]
    s74_now = k[8]
    s362_now = k[12]
    s359_now = k[13]
    s400_now = k[14]
    s402_now = k[15]
    s60_now_by = k_by[0]
    axis_x_now_by = k_by[2]
    axis_y_now_by = k_by[4]
    axis_z_now_by = k_by[6]
    s71_now_by = k_by[7]
    s74_now_by = k_by[8]
    s362_now_by = k_by[12]
    s359_now_by = k_by[13]
    s400_now_by = k_by[14]
    s402_now_by = k_by[15]
    for lane in range(n):
        tx_now = w[32 + lane]
        ty_now = w[64 + lane]
        tz_now = w[96 + lane]
        R_11_now = w[320 + lane]
        R_12_now = w[352 + lane]
        R_13_now = w[384 + lane]
        R_21_now = w[416 + lane]
        R_22_now = w[448 + lane]
        R_23_now = w[480 + lane]
        R_31_now = w[512 + lane]
        R_32_now = w[544 + lane]
        R_33_now = w[576 + lane]
        w_x_now = s[672 + lane]
        w_y_now = s[704 + lane]
        w_z_now = s[736 + lane]
        w_x_t_now = s[864 + lane]
        w_y_t_now = s[896 + lane]
        w_z_t_now = s[928 + lane]
        q_tt_now = d[32 + lane]
        R_11_now_by = w_by[320 + lane]
        R_12_now_by = w_by[352 + lane]
        R_13_now_by = w_by[384 + lane]
        R_21_now_by = w_by[416 + lane]
        R_22_now_by = w_by[448 + lane]
        R_23_now_by = w_by[480 + lane]
        R_31_now_by = w_by[512 + lane]
        R_32_now_by = w_by[544 + lane]
        R_33_now_by = w_by[576 + lane]
        w_x_now_by = s_by[672 + lane]
        w_y_now_by = s_by[704 + lane]
        w_z_now_by = s_by[736 + lane]
        v_px_t_now_by = s_by[768 + lane]
        v_py_t_now_by = s_by[800 + lane]
        v_pz_t_now_by = s_by[832 + lane]
        w_x_t_now_by = s_by[864 + lane]
        w_y_t_now_by = s_by[896 + lane]
        w_z_t_now_by = s_by[928 + lane]
        q_tt_now_by = d_by[32 + lane]
        s72_now = s71_now - tx_now
        s75_now = s74_now - ty_now
        s132_now = -R_21_now*w_z_now + R_31_now*w_y_now
        s135_now = -R_22_now*w_z_now + R_32_now*w_y_now
        s138_now = -R_23_now*w_z_now + R_33_now*w_y_now
        s141_now = R_11_now*w_z_now - R_31_now*w_x_now
        s144_now = R_12_now*w_z_now - R_32_now*w_x_now
        s147_now = R_13_now*w_z_now - R_33_now*w_x_now
        s150_now = -R_11_now*w_y_now + R_21_now*w_x_now
        s153_now = -R_12_now*w_y_now + R_22_now*w_x_now
        s156_now = -R_13_now*w_y_now + R_23_now*w_x_now
        s845_now = -R_21_now*w_z_t_now + R_31_now*w_y_t_now - s141_now*w_z_now + s150_now*w_y_now
        s850_now = -R_22_now*w_z_t_now + R_32_now*w_y_t_now - s144_now*w_z_now + s153_now*w_y_now
        s860_now = R_11_now*w_z_t_now - R_31_now*w_x_t_now + s132_now*w_z_now - s150_now*w_x_now
        s865_now = R_12_now*w_z_t_now - R_32_now*w_x_t_now + s135_now*w_z_now - s153_now*w_x_now
        s875_now = -R_11_now*w_y_t_now + R_21_now*w_x_t_now - s132_now*w_y_now + s141_now*w_x_now
        s880_now = -R_12_now*w_y_t_now + R_22_now*w_x_t_now - s135_now*w_y_now + s144_now*w_x_now
        s886_now = -q_tt_now*s60_now
        s153 = -R_21_now*w_z_now_by - R_21_now_by*w_z_now + R_31_now*w_y_now_by + R_31_now_by*w_y_now
        s160 = -R_22_now*w_z_now_by - R_22_now_by*w_z_now + R_32_now*w_y_now_by + R_32_now_by*w_y_now
        s167 = -R_23_now*w_z_now_by - R_23_now_by*w_z_now + R_33_now*w_y_now_by + R_33_now_by*w_y_now
        s174 = R_11_now*w_z_now_by + R_11_now_by*w_z_now - R_31_now*w_x_now_by - R_31_now_by*w_x_now
        s181 = R_12_now*w_z_now_by + R_12_now_by*w_z_now - R_32_now*w_x_now_by - R_32_now_by*w_x_now
        s188 = R_13_now*w_z_now_by + R_13_now_by*w_z_now - R_33_now*w_x_now_by - R_33_now_by*w_x_now
        s195 = -R_11_now*w_y_now_by - R_11_now_by*w_y_now + R_21_now*w_x_now_by + R_21_now_by*w_x_now
        s202 = -R_12_now*w_y_now_by - R_12_now_by*w_y_now + R_22_now*w_x_now_by + R_22_now_by*w_x_now
        s209 = -R_13_now*w_y_now_by - R_13_now_by*w_y_now + R_23_now*w_x_now_by + R_23_now_by*w_x_now
        s221 = -s141_now*w_z_now_by - s174*w_z_now
        s222 = -R_21_now*w_z_t_now_by - R_21_now_by*w_z_t_now + R_31_now*w_y_t_now_by + R_31_now_by*w_y_t_now + s150_now*w_y_now_by + s195*w_y_now + s221
        s234 = -s144_now*w_z_now_by - s181*w_z_now
        s235 = -R_22_now*w_z_t_now_by - R_22_now_by*w_z_t_now + R_32_now*w_y_t_now_by + R_32_now_by*w_y_t_now + s153_now*w_y_now_by + s202*w_y_now + s234
        s247 = -s150_now*w_x_now_by - s195*w_x_now
        s248 = R_11_now*w_z_t_now_by + R_11_now_by*w_z_t_now - R_31_now*w_x_t_now_by - R_31_now_by*w_x_t_now + s132_now*w_z_now_by + s153*w_z_now + s247
        s260 = -s153_now*w_x_now_by - s202*w_x_now
        s261 = R_12_now*w_z_t_now_by + R_12_now_by*w_z_t_now - R_32_now*w_x_t_now_by - R_32_now_by*w_x_t_now + s135_now*w_z_now_by + s160*w_z_now + s260
        s273 = -s132_now*w_y_now_by - s153*w_y_now
        s274 = -R_11_now*w_y_t_now_by - R_11_now_by*w_y_t_now + R_21_now*w_x_t_now_by + R_21_now_by*w_x_t_now + s141_now*w_x_now_by + s174*w_x_now + s273
        s286 = -s135_now*w_y_now_by - s160*w_y_now
        s287 = -R_12_now*w_y_t_now_by - R_12_now_by*w_y_t_now + R_22_now*w_x_t_now_by + R_22_now_by*w_x_t_now + s144_now*w_x_now_by + s181*w_x_now + s286
        s290 = -q_tt_now*s60_now_by - q_tt_now_by*s60_now
        s293 = axis_x_now*s290 + axis_x_now_by*s886_now
        s296 = axis_y_now*s290 + axis_y_now_by*s886_now
        s299 = axis_z_now*s290 + axis_z_now_by*s886_now
        s311 = -s147_now*w_z_now_by - s188*w_z_now
        s312 = -R_23_now*w_z_t_now_by - R_23_now_by*w_z_t_now + R_33_now*w_y_t_now_by + R_33_now_by*w_y_t_now + s156_now*w_y_now_by + s209*w_y_now + s311
        s320 = s222*s72_now + s235*s75_now - s312*tz_now + s71_now_by*s845_now + s74_now_by*s850_now + v_px_t_now_by
        s332 = -s156_now*w_x_now_by - s209*w_x_now
        s333 = R_13_now*w_z_t_now_by + R_13_now_by*w_z_t_now - R_33_now*w_x_t_now_by - R_33_now_by*w_x_t_now + s138_now*w_z_now_by + s167*w_z_now + s332
        s341 = s248*s72_now + s261*s75_now - s333*tz_now + s71_now_by*s860_now + s74_now_by*s865_now + v_py_t_now_by
        s353 = -s138_now*w_y_now_by - s167*w_y_now
        s354 = -R_13_now*w_y_t_now_by - R_13_now_by*w_y_t_now + R_23_now*w_x_t_now_by + R_23_now_by*w_x_t_now + s147_now*w_x_now_by + s188*w_x_now + s353
        s362 = s274*s72_now + s287*s75_now - s354*tz_now + s71_now_by*s875_now + s74_now_by*s880_now + v_pz_t_now_by
        s405 = -0.001*s293
        s406 = -0.001*s296
        s407 = -0.001*s299
        s408 = -0.0005*s320
        s409 = -0.0005*s293
        s410 = -0.001*s222*s400_now - 0.001*s400_now_by*s845_now
        s411 = -0.001*s235*s402_now - 0.001*s402_now_by*s850_now
        s412 = s408 + s409 + s410 + s411
        s413 = -0.0005*s341
        s414 = -0.0005*s296
        s415 = -0.001*s248*s400_now - 0.001*s400_now_by*s860_now
        s416 = -0.001*s261*s402_now - 0.001*s402_now_by*s865_now
        s417 = s413 + s414 + s415 + s416
        s418 = -0.0005*s362
        s419 = -0.0005*s299
        s420 = -0.001*s274*s400_now - 0.001*s400_now_by*s875_now
        s421 = -0.001*s287*s402_now - 0.001*s402_now_by*s880_now
        s422 = s418 + s419 + s420 + s421
        s423 = -0.001*s235*s362_now - 0.001*s362_now_by*s850_now
        s424 = -0.001*s222*s359_now - 0.001*s359_now_by*s845_now
        s425 = -0.001*s320
        s426 = s423 + s424 + s425
        s427 = -0.001*s261*s362_now - 0.001*s362_now_by*s865_now
        s428 = -0.001*s248*s359_now - 0.001*s359_now_by*s860_now
        s429 = -0.001*s341
        s430 = s427 + s428 + s429
        s431 = -0.001*s287*s362_now - 0.001*s362_now_by*s880_now
        s432 = -0.001*s274*s359_now - 0.001*s359_now_by*s875_now
        s433 = -0.001*s362
        s434 = s431 + s432 + s433
        s435 = s408 + s409 - s410 - s411
        s436 = s413 + s414 - s415 - s416
        s437 = s418 + s419 - s420 - s421
        s438 = -s423 - s424 + s425
        s439 = -s427 - s428 + s429
        s440 = -s431 - s432 + s433
        d_by[128 + lane] = s405
        d_by[160 + lane] = s406
        d_by[192 + lane] = s407
        d_by[224 + lane] = s405
        d_by[256 + lane] = s406
        d_by[288 + lane] = s407
        d_by[320 + lane] = s412
        d_by[352 + lane] = s417
        d_by[384 + lane] = s422
        d_by[416 + lane] = s426
        d_by[448 + lane] = s430
        d_by[480 + lane] = s434
        d_by[512 + lane] = s405
        d_by[544 + lane] = s406
        d_by[576 + lane] = s407
        d_by[608 + lane] = s435
        d_by[640 + lane] = s436
        d_by[672 + lane] = s437
        d_by[704 + lane] = s438
        d_by[736 + lane] = s439
        d_by[768 + lane] = s440


@straight
def _limb_asks_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of loads per inertial parameter of a limb, along joint, shifts and turns (320 operations)."""
    share_now = shares[0]
    s60_now = k[0]
    axis_x_now = k[2]
    axis_y_now = k[4]
    axis_z_now = k[6]
    s71_now = k[7]
    s74_now = k[8]
    s362_now = k[12]
    s359_now = k[13]
    s400_now = k[14]
    s402_now = k[15]
    s60_now_by = k_by[0]
    axis_x_now_by = k_by[2]
    axis_y_now_by = k_by[4]
    axis_z_now_by = k_by[6]
    s71_now_by = k_by[7]
    s74_now_by = k_by[8]
    s362_now_by = k_by[12]
    s359_now_by = k_by[13]
    s400_now_by = k_by[14]
    s402_now_by = k_by[15]
    for lane in range(n):
        tx_now = w[32 + lane]
        ty_now = w[64 + lane]
        tz_now = w[96 + lane]
        R_11_now = w[320 + lane]
        R_12_now = w[352 + lane]
        R_13_now = w[384 + lane]
        R_21_now = w[416 + lane]
        R_22_now = w[448 + lane]
        R_23_now = w[480 + lane]
        R_31_now = w[512 + lane]
        R_32_now = w[544 + lane]
        R_33_now = w[576 + lane]
        f0x_now = d[128 + lane]
        f0y_now = d[160 + lane]
        f0z_now = d[192 + lane]
        f1x_now = d[224 + lane]
        f1y_now = d[256 + lane]
        f1z_now = d[288 + lane]
        f2x_now = d[320 + lane]
        f2y_now = d[352 + lane]
        f2z_now = d[384 + lane]
        f3x_now = d[416 + lane]
        f3y_now = d[448 + lane]
        f3z_now = d[480 + lane]
        f4x_now = d[512 + lane]
        f4y_now = d[544 + lane]
        f4z_now = d[576 + lane]
        f5x_now = d[608 + lane]
        f5y_now = d[640 + lane]
        f5z_now = d[672 + lane]
        f6x_now = d[704 + lane]
        f6y_now = d[736 + lane]
        f6z_now = d[768 + lane]
        R_11_now_by = w_by[320 + lane]
        R_12_now_by = w_by[352 + lane]
        R_13_now_by = w_by[384 + lane]
        R_21_now_by = w_by[416 + lane]
        R_22_now_by = w_by[448 + lane]
        R_23_now_by = w_by[480 + lane]
        R_31_now_by = w_by[512 + lane]
        R_32_now_by = w_by[544 + lane]
        R_33_now_by = w_by[576 + lane]
        f0x_now_by = d_by[128 + lane]
        f0y_now_by = d_by[160 + lane]
        f0z_now_by = d_by[192 + lane]
        f1x_now_by = d_by[224 + lane]
        f1y_now_by = d_by[256 + lane]
        f1z_now_by = d_by[288 + lane]
        f2x_now_by = d_by[320 + lane]
        f2y_now_by = d_by[352 + lane]
        f2z_now_by = d_by[384 + lane]
        f3x_now_by = d_by[416 + lane]
        f3y_now_by = d_by[448 + lane]
        f3z_now_by = d_by[480 + lane]
        f4x_now_by = d_by[512 + lane]
        f4y_now_by = d_by[544 + lane]
        f4z_now_by = d_by[576 + lane]
        f5x_now_by = d_by[608 + lane]
        f5y_now_by = d_by[640 + lane]
        f5z_now_by = d_by[672 + lane]
        f6x_now_by = d_by[704 + lane]
        f6y_now_by = d_by[736 + lane]
        f6z_now_by = d_by[768 + lane]
        s72_now = s71_now - tx_now
        s75_now = s74_now - ty_now
        s397_now = 1 - 2*share_now
        s430_now = f5z_now*s397_now
        s432_now = f5y_now*s397_now
        s434_now = f5x_now*s397_now
        s436_now = f2z_now*s397_now
        s437_now = -s430_now + s436_now
        s443_now = 0.5*s430_now + 0.5*s436_now
        s445_now = f2y_now*s397_now
        s446_now = -s432_now + s445_now
        s452_now = 0.5*s432_now + 0.5*s445_now
        s454_now = f2x_now*s397_now
        s455_now = -s434_now + s454_now
        s461_now = 0.5*s434_now + 0.5*s454_now
        s465_now = f6z_now*share_now
        s467_now = f6y_now*share_now
        s469_now = f6x_now*share_now
        s471_now = f3z_now*share_now
        s472_now = -s465_now + s471_now
        s478_now = f3y_now*share_now
        s479_now = -s467_now + s478_now
        s485_now = f3x_now*share_now
        s486_now = -s469_now + s485_now
        s502_now = s443_now + s465_now + s471_now
        s503_now = -s502_now*tz_now
        s509_now = s452_now + s467_now + s478_now
        s510_now = -s509_now*tz_now
        s516_now = s461_now + s469_now + s485_now
        s517_now = -s516_now*tz_now
        s44 = f1x_now*share_now + f4x_now*share_now + s461_now
        s533_now = axis_x_now*s44
        s48 = f1y_now*share_now + f4y_now*share_now + s452_now
        s52 = f1z_now*share_now + f4z_now*share_now + s443_now
        s534_now = axis_y_now*s48 + axis_z_now*s52 + s533_now
        s539_now = s362_now*s472_now + s402_now*s437_now + s502_now*s75_now
        s540_now = s359_now*s472_now + s400_now*s437_now + s502_now*s72_now
        s541_now = s362_now*s479_now + s402_now*s446_now + s509_now*s75_now
        s542_now = s359_now*s479_now + s400_now*s446_now + s509_now*s72_now
        s543_now = s362_now*s486_now + s402_now*s455_now + s516_now*s75_now
        s544_now = s359_now*s486_now + s400_now*s455_now + s516_now*s72_now
        s110 = axis_x_now*f0x_now_by + axis_x_now_by*f0x_now + axis_y_now*f0y_now_by + axis_y_now_by*f0y_now + axis_z_now*f0z_now_by + axis_z_now_by*f0z_now
        s113 = -s110*s60_now - s60_now_by*(axis_x_now*f0x_now + axis_y_now*f0y_now + axis_z_now*f0z_now)
        s114 = f5z_now_by*s397_now
        s115 = f5y_now_by*s397_now
        s116 = f5x_now_by*s397_now
        s117 = f2z_now_by*s397_now
        s118 = -s114 + s117
        s121 = 0.5*s114 + 0.5*s117
        s122 = f2y_now_by*s397_now
        s123 = -s115 + s122
        s126 = 0.5*s115 + 0.5*s122
        s127 = f2x_now_by*s397_now
        s128 = -s116 + s127
        s131 = 0.5*s116 + 0.5*s127
        s132 = f6z_now_by*share_now
        s133 = f6y_now_by*share_now
        s134 = f6x_now_by*share_now
        s135 = f3z_now_by*share_now
        s136 = -s132 + s135
        s137 = f3y_now_by*share_now
        s138 = -s133 + s137
        s139 = f3x_now_by*share_now
        s140 = -s134 + s139
        s141 = s121 + s132 + s135
        s142 = -s141*tz_now
        s143 = s126 + s133 + s137
        s144 = -s143*tz_now
        s145 = s131 + s134 + s139
        s146 = -s145*tz_now
        s158 = axis_y_now*(f1y_now_by*share_now + f4y_now_by*share_now + s126) + axis_y_now_by*s48
        s164 = axis_z_now*(f1z_now_by*share_now + f4z_now_by*share_now + s121) + axis_z_now_by*s52
        s167 = -s534_now*s60_now_by
        s168 = s167 - s60_now*(axis_x_now*(f1x_now_by*share_now + f4x_now_by*share_now + s131) + axis_x_now_by*s44 + s158 + s164)
        s178 = s118*s402_now + s136*s362_now + s141*s75_now + s362_now_by*s472_now + s402_now_by*s437_now + s502_now*s74_now_by
        s188 = s118*s400_now + s136*s359_now + s141*s72_now + s359_now_by*s472_now + s400_now_by*s437_now + s502_now*s71_now_by
        s198 = s123*s402_now + s138*s362_now + s143*s75_now + s362_now_by*s479_now + s402_now_by*s446_now + s509_now*s74_now_by
        s208 = s123*s400_now + s138*s359_now + s143*s72_now + s359_now_by*s479_now + s400_now_by*s446_now + s509_now*s71_now_by
        s218 = s128*s402_now + s140*s362_now + s145*s75_now + s362_now_by*s486_now + s402_now_by*s455_now + s516_now*s74_now_by
        s228 = s128*s400_now + s140*s359_now + s145*s72_now + s359_now_by*s486_now + s400_now_by*s455_now + s516_now*s71_now_by
        s237 = R_23_now*s142 + R_23_now_by*s503_now
        s240 = -R_31_now*s208 - R_31_now_by*s542_now
        s243 = -R_32_now*s198 - R_32_now_by*s541_now
        s246 = -R_33_now*s144 - R_33_now_by*s510_now
        s247 = R_21_now*s188 + R_21_now_by*s540_now + R_22_now*s178 + R_22_now_by*s539_now + s237 + s240 + s243 + s246
        s256 = R_33_now*s146 + R_33_now_by*s517_now
        s259 = -R_11_now*s188 - R_11_now_by*s540_now
        s262 = -R_12_now*s178 - R_12_now_by*s539_now
        s265 = -R_13_now*s142 - R_13_now_by*s503_now
        s266 = R_31_now*s228 + R_31_now_by*s544_now + R_32_now*s218 + R_32_now_by*s543_now + s256 + s259 + s262 + s265
        s275 = R_13_now*s144 + R_13_now_by*s510_now
        s278 = -R_21_now*s228 - R_21_now_by*s544_now
        s281 = -R_22_now*s218 - R_22_now_by*s543_now
        s284 = -R_23_now*s146 - R_23_now_by*s517_now
        s285 = R_11_now*s208 + R_11_now_by*s542_now + R_12_now*s198 + R_12_now_by*s541_now + s275 + s278 + s281 + s284
        d_by[800 + lane] = s113
        d_by[832 + lane] = s168
        d_by[864 + lane] = s145
        d_by[896 + lane] = s143
        d_by[928 + lane] = s141
        d_by[960 + lane] = s247
        d_by[992 + lane] = s266
        d_by[1024 + lane] = s285


@straight
def _platform_fields_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of gravity less acceleration of the points of a platform (270 operations)."""
    for lane in range(n):
        tx_now = w[32 + lane]
        ty_now = w[64 + lane]
        tz_now = w[96 + lane]
        R_11_now = w[320 + lane]
        R_12_now = w[352 + lane]
        R_13_now = w[384 + lane]
        R_21_now = w[416 + lane]
        R_22_now = w[448 + lane]
        R_23_now = w[480 + lane]
        R_31_now = w[512 + lane]
        R_32_now = w[544 + lane]
        R_33_now = w[576 + lane]
        w_x_now = s[672 + lane]
        w_y_now = s[704 + lane]
        w_z_now = s[736 + lane]
        w_x_t_now = s[864 + lane]
        w_y_t_now = s[896 + lane]
        w_z_t_now = s[928 + lane]
        R_11_now_by = w_by[320 + lane]
        R_12_now_by = w_by[352 + lane]
        R_13_now_by = w_by[384 + lane]
        R_21_now_by = w_by[416 + lane]
        R_22_now_by = w_by[448 + lane]
        R_23_now_by = w_by[480 + lane]
        R_31_now_by = w_by[512 + lane]
        R_32_now_by = w_by[544 + lane]
        R_33_now_by = w_by[576 + lane]
        w_x_now_by = s_by[672 + lane]
        w_y_now_by = s_by[704 + lane]
        w_z_now_by = s_by[736 + lane]
        v_px_t_now_by = s_by[768 + lane]
        v_py_t_now_by = s_by[800 + lane]
        v_pz_t_now_by = s_by[832 + lane]
        w_x_t_now_by = s_by[864 + lane]
        w_y_t_now_by = s_by[896 + lane]
        w_z_t_now_by = s_by[928 + lane]
        s164_now = -R_21_now*w_z_now + R_31_now*w_y_now
        s167_now = -R_22_now*w_z_now + R_32_now*w_y_now
        s170_now = -R_23_now*w_z_now + R_33_now*w_y_now
        s173_now = R_11_now*w_z_now - R_31_now*w_x_now
        s176_now = R_12_now*w_z_now - R_32_now*w_x_now
        s179_now = R_13_now*w_z_now - R_33_now*w_x_now
        s182_now = -R_11_now*w_y_now + R_21_now*w_x_now
        s185_now = -R_12_now*w_y_now + R_22_now*w_x_now
        s188_now = -R_13_now*w_y_now + R_23_now*w_x_now
        s102 = -R_21_now*w_z_now_by - R_21_now_by*w_z_now + R_31_now*w_y_now_by + R_31_now_by*w_y_now
        s109 = -R_22_now*w_z_now_by - R_22_now_by*w_z_now + R_32_now*w_y_now_by + R_32_now_by*w_y_now
        s116 = -R_23_now*w_z_now_by - R_23_now_by*w_z_now + R_33_now*w_y_now_by + R_33_now_by*w_y_now
        s123 = R_11_now*w_z_now_by + R_11_now_by*w_z_now - R_31_now*w_x_now_by - R_31_now_by*w_x_now
        s130 = R_12_now*w_z_now_by + R_12_now_by*w_z_now - R_32_now*w_x_now_by - R_32_now_by*w_x_now
        s137 = R_13_now*w_z_now_by + R_13_now_by*w_z_now - R_33_now*w_x_now_by - R_33_now_by*w_x_now
        s144 = -R_11_now*w_y_now_by - R_11_now_by*w_y_now + R_21_now*w_x_now_by + R_21_now_by*w_x_now
        s151 = -R_12_now*w_y_now_by - R_12_now_by*w_y_now + R_22_now*w_x_now_by + R_22_now_by*w_x_now
        s158 = -R_13_now*w_y_now_by - R_13_now_by*w_y_now + R_23_now*w_x_now_by + R_23_now_by*w_x_now
        s170 = -s123*w_z_now - s173_now*w_z_now_by
        s171 = -R_21_now*w_z_t_now_by - R_21_now_by*w_z_t_now + R_31_now*w_y_t_now_by + R_31_now_by*w_y_t_now + s144*w_y_now + s170 + s182_now*w_y_now_by
        s184 = -s130*w_z_now - s176_now*w_z_now_by
        s185 = -R_22_now*w_z_t_now_by - R_22_now_by*w_z_t_now + R_32_now*w_y_t_now_by + R_32_now_by*w_y_t_now + s151*w_y_now + s184 + s185_now*w_y_now_by
        s198 = -s137*w_z_now - s179_now*w_z_now_by
        s199 = -R_23_now*w_z_t_now_by - R_23_now_by*w_z_t_now + R_33_now*w_y_t_now_by + R_33_now_by*w_y_t_now + s158*w_y_now + s188_now*w_y_now_by + s198
        s213 = -s144*w_x_now - s182_now*w_x_now_by
        s214 = R_11_now*w_z_t_now_by + R_11_now_by*w_z_t_now - R_31_now*w_x_t_now_by - R_31_now_by*w_x_t_now + s102*w_z_now + s164_now*w_z_now_by + s213
        s227 = -s151*w_x_now - s185_now*w_x_now_by
        s228 = R_12_now*w_z_t_now_by + R_12_now_by*w_z_t_now - R_32_now*w_x_t_now_by - R_32_now_by*w_x_t_now + s109*w_z_now + s167_now*w_z_now_by + s227
        s241 = -s158*w_x_now - s188_now*w_x_now_by
        s242 = R_13_now*w_z_t_now_by + R_13_now_by*w_z_t_now - R_33_now*w_x_t_now_by - R_33_now_by*w_x_t_now + s116*w_z_now + s170_now*w_z_now_by + s241
        s256 = -s102*w_y_now - s164_now*w_y_now_by
        s257 = -R_11_now*w_y_t_now_by - R_11_now_by*w_y_t_now + R_21_now*w_x_t_now_by + R_21_now_by*w_x_t_now + s123*w_x_now + s173_now*w_x_now_by + s256
        s270 = -s109*w_y_now - s167_now*w_y_now_by
        s271 = -R_12_now*w_y_t_now_by - R_12_now_by*w_y_t_now + R_22_now*w_x_t_now_by + R_22_now_by*w_x_t_now + s130*w_x_now + s176_now*w_x_now_by + s270
        s284 = -s116*w_y_now - s170_now*w_y_now_by
        s285 = -R_13_now*w_y_t_now_by - R_13_now_by*w_y_t_now + R_23_now*w_x_t_now_by + R_23_now_by*w_x_t_now + s137*w_x_now + s179_now*w_x_now_by + s284
        s288 = 0.001*s171*tx_now + 0.001*s185*ty_now + 0.001*s199*tz_now - 0.001*v_px_t_now_by
        s289 = 0.001*s214*tx_now + 0.001*s228*ty_now + 0.001*s242*tz_now - 0.001*v_py_t_now_by
        s290 = 0.001*s257*tx_now + 0.001*s271*ty_now + 0.001*s285*tz_now - 0.001*v_pz_t_now_by
        s291 = -0.001*v_px_t_now_by
        s292 = -0.001*v_py_t_now_by
        s293 = -0.001*v_pz_t_now_by
        s_by[960 + lane] = s288
        s_by[992 + lane] = s289
        s_by[1024 + lane] = s290
        s_by[1056 + lane] = s291
        s_by[1088 + lane] = s292
        s_by[1120 + lane] = s293


@straight
def _platform_asks_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of loads per inertial parameter of a platform, along joint, shifts and turns (114 operations)."""
    for lane in range(n):
        tx_now = w[32 + lane]
        ty_now = w[64 + lane]
        tz_now = w[96 + lane]
        R_11_now = w[320 + lane]
        R_12_now = w[352 + lane]
        R_13_now = w[384 + lane]
        R_21_now = w[416 + lane]
        R_22_now = w[448 + lane]
        R_23_now = w[480 + lane]
        R_31_now = w[512 + lane]
        R_32_now = w[544 + lane]
        R_33_now = w[576 + lane]
        f0x_now = s[960 + lane]
        f0y_now = s[992 + lane]
        f0z_now = s[1024 + lane]
        R_11_now_by = w_by[320 + lane]
        R_12_now_by = w_by[352 + lane]
        R_13_now_by = w_by[384 + lane]
        R_21_now_by = w_by[416 + lane]
        R_22_now_by = w_by[448 + lane]
        R_23_now_by = w_by[480 + lane]
        R_31_now_by = w_by[512 + lane]
        R_32_now_by = w_by[544 + lane]
        R_33_now_by = w_by[576 + lane]
        f0x_now_by = s_by[960 + lane]
        f0y_now_by = s_by[992 + lane]
        f0z_now_by = s_by[1024 + lane]
        f1x_now_by = s_by[1056 + lane]
        f1y_now_by = s_by[1088 + lane]
        f1z_now_by = s_by[1120 + lane]
        s116_now = -f0z_now*ty_now
        s118_now = -f0z_now*tx_now
        s120_now = -f0y_now*ty_now
        s122_now = -f0y_now*tx_now
        s124_now = -f0x_now*ty_now
        s126_now = -f0x_now*tx_now
        s128_now = -f0z_now*tz_now
        s130_now = -f0y_now*tz_now
        s132_now = -f0x_now*tz_now
        s30 = -f0z_now_by*ty_now
        s31 = -f0z_now_by*tx_now
        s32 = -f0y_now_by*ty_now
        s33 = -f0y_now_by*tx_now
        s34 = -f0x_now_by*ty_now
        s35 = -f0x_now_by*tx_now
        s36 = -f0z_now_by*tz_now
        s37 = -f0y_now_by*tz_now
        s38 = -f0x_now_by*tz_now
        s47 = R_23_now*s36 + R_23_now_by*s128_now
        s50 = -R_31_now*s33 - R_31_now_by*s122_now
        s53 = -R_32_now*s32 - R_32_now_by*s120_now
        s56 = -R_33_now*s37 - R_33_now_by*s130_now
        s57 = R_21_now*s31 + R_21_now_by*s118_now + R_22_now*s30 + R_22_now_by*s116_now + s47 + s50 + s53 + s56
        s66 = R_33_now*s38 + R_33_now_by*s132_now
        s69 = -R_11_now*s31 - R_11_now_by*s118_now
        s72 = -R_12_now*s30 - R_12_now_by*s116_now
        s75 = -R_13_now*s36 - R_13_now_by*s128_now
        s76 = R_31_now*s35 + R_31_now_by*s126_now + R_32_now*s34 + R_32_now_by*s124_now + s66 + s69 + s72 + s75
        s85 = R_13_now*s37 + R_13_now_by*s130_now
        s88 = -R_21_now*s35 - R_21_now_by*s126_now
        s91 = -R_22_now*s34 - R_22_now_by*s124_now
        s94 = -R_23_now*s38 - R_23_now_by*s132_now
        s95 = R_11_now*s33 + R_11_now_by*s122_now + R_12_now*s32 + R_12_now_by*s120_now + s85 + s88 + s91 + s94
        s_by[1152 + lane] = f0x_now_by
        s_by[1184 + lane] = f0y_now_by
        s_by[1216 + lane] = f0z_now_by
        s_by[1248 + lane] = s57
        s_by[1280 + lane] = s76
        s_by[1312 + lane] = s95
        s_by[1344 + lane] = f1x_now_by
        s_by[1376 + lane] = f1y_now_by
        s_by[1408 + lane] = f1z_now_by


@straight
def _give_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of what the joints give (192 operations)."""
    m_0_now = inertia[0]
    m_1_now = inertia[1]
    m_2_now = inertia[2]
    m_3_now = inertia[3]
    m_4_now = inertia[4]
    m_5_now = inertia[5]
    m_6_now = inertia[6]
    m_7_now = inertia[7]
    for lane in range(n):
        a_0_2_now = d[864 + lane]
        a_0_3_now = d[896 + lane]
        a_0_4_now = d[928 + lane]
        a_0_5_now = d[960 + lane]
        a_0_6_now = d[992 + lane]
        a_0_7_now = d[1024 + lane]
        a_1_2_now = d[1920 + lane]
        a_1_3_now = d[1952 + lane]
        a_1_4_now = d[1984 + lane]
        a_1_5_now = d[2016 + lane]
        a_1_6_now = d[2048 + lane]
        a_1_7_now = d[2080 + lane]
        a_2_2_now = d[2976 + lane]
        a_2_3_now = d[3008 + lane]
        a_2_4_now = d[3040 + lane]
        a_2_5_now = d[3072 + lane]
        a_2_6_now = d[3104 + lane]
        a_2_7_now = d[3136 + lane]
        a_p_0_now = s[1152 + lane]
        a_p_1_now = s[1184 + lane]
        a_p_2_now = s[1216 + lane]
        a_p_3_now = s[1248 + lane]
        a_p_4_now = s[1280 + lane]
        a_p_5_now = s[1312 + lane]
        a_p_6_now = s[1344 + lane]
        a_p_7_now = s[1376 + lane]
        a_p_8_now = s[1408 + lane]
        V_0_0_now = s[0 + lane]
        V_0_1_now = s[32 + lane]
        V_0_2_now = s[64 + lane]
        V_1_0_now = s[96 + lane]
        V_1_1_now = s[128 + lane]
        V_1_2_now = s[160 + lane]
        V_2_0_now = s[192 + lane]
        V_2_1_now = s[224 + lane]
        V_2_2_now = s[256 + lane]
        V_3_0_now = s[288 + lane]
        V_3_1_now = s[320 + lane]
        V_3_2_now = s[352 + lane]
        V_4_0_now = s[384 + lane]
        V_4_1_now = s[416 + lane]
        V_4_2_now = s[448 + lane]
        V_5_0_now = s[480 + lane]
        V_5_1_now = s[512 + lane]
        V_5_2_now = s[544 + lane]
        a_0_0_now_by = d_by[800 + lane]
        a_0_1_now_by = d_by[832 + lane]
        a_0_2_now_by = d_by[864 + lane]
        a_0_3_now_by = d_by[896 + lane]
        a_0_4_now_by = d_by[928 + lane]
        a_0_5_now_by = d_by[960 + lane]
        a_0_6_now_by = d_by[992 + lane]
        a_0_7_now_by = d_by[1024 + lane]
        a_1_0_now_by = d_by[1856 + lane]
        a_1_1_now_by = d_by[1888 + lane]
        a_1_2_now_by = d_by[1920 + lane]
        a_1_3_now_by = d_by[1952 + lane]
        a_1_4_now_by = d_by[1984 + lane]
        a_1_5_now_by = d_by[2016 + lane]
        a_1_6_now_by = d_by[2048 + lane]
        a_1_7_now_by = d_by[2080 + lane]
        a_2_0_now_by = d_by[2912 + lane]
        a_2_1_now_by = d_by[2944 + lane]
        a_2_2_now_by = d_by[2976 + lane]
        a_2_3_now_by = d_by[3008 + lane]
        a_2_4_now_by = d_by[3040 + lane]
        a_2_5_now_by = d_by[3072 + lane]
        a_2_6_now_by = d_by[3104 + lane]
        a_2_7_now_by = d_by[3136 + lane]
        a_p_0_now_by = s_by[1152 + lane]
        a_p_1_now_by = s_by[1184 + lane]
        a_p_2_now_by = s_by[1216 + lane]
        a_p_3_now_by = s_by[1248 + lane]
        a_p_4_now_by = s_by[1280 + lane]
        a_p_5_now_by = s_by[1312 + lane]
        a_p_6_now_by = s_by[1344 + lane]
        a_p_7_now_by = s_by[1376 + lane]
        a_p_8_now_by = s_by[1408 + lane]
        V_0_0_now_by = s_by[0 + lane]
        V_0_1_now_by = s_by[32 + lane]
        V_0_2_now_by = s_by[64 + lane]
        V_1_0_now_by = s_by[96 + lane]
        V_1_1_now_by = s_by[128 + lane]
        V_1_2_now_by = s_by[160 + lane]
        V_2_0_now_by = s_by[192 + lane]
        V_2_1_now_by = s_by[224 + lane]
        V_2_2_now_by = s_by[256 + lane]
        V_3_0_now_by = s_by[288 + lane]
        V_3_1_now_by = s_by[320 + lane]
        V_3_2_now_by = s_by[352 + lane]
        V_4_0_now_by = s_by[384 + lane]
        V_4_1_now_by = s_by[416 + lane]
        V_4_2_now_by = s_by[448 + lane]
        V_5_0_now_by = s_by[480 + lane]
        V_5_1_now_by = s_by[512 + lane]
        V_5_2_now_by = s_by[544 + lane]
        W_0_now = a_0_2_now*m_1_now + a_1_2_now*m_3_now + a_2_2_now*m_5_now + a_p_0_now*m_6_now + a_p_6_now*m_7_now
        W_1_now = a_0_3_now*m_1_now + a_1_3_now*m_3_now + a_2_3_now*m_5_now + a_p_1_now*m_6_now + a_p_7_now*m_7_now
        W_2_now = a_0_4_now*m_1_now + a_1_4_now*m_3_now + a_2_4_now*m_5_now + a_p_2_now*m_6_now + a_p_8_now*m_7_now
        W_3_now = a_0_5_now*m_1_now + a_1_5_now*m_3_now + a_2_5_now*m_5_now + a_p_3_now*m_6_now
        W_4_now = a_0_6_now*m_1_now + a_1_6_now*m_3_now + a_2_6_now*m_5_now + a_p_4_now*m_6_now
        W_5_now = a_0_7_now*m_1_now + a_1_7_now*m_3_now + a_2_7_now*m_5_now + a_p_5_now*m_6_now
        s65 = a_0_2_now_by*m_1_now + a_1_2_now_by*m_3_now + a_2_2_now_by*m_5_now + a_p_0_now_by*m_6_now + a_p_6_now_by*m_7_now
        s71 = a_0_3_now_by*m_1_now + a_1_3_now_by*m_3_now + a_2_3_now_by*m_5_now + a_p_1_now_by*m_6_now + a_p_7_now_by*m_7_now
        s77 = a_0_4_now_by*m_1_now + a_1_4_now_by*m_3_now + a_2_4_now_by*m_5_now + a_p_2_now_by*m_6_now + a_p_8_now_by*m_7_now
        s82 = a_0_5_now_by*m_1_now + a_1_5_now_by*m_3_now + a_2_5_now_by*m_5_now + a_p_3_now_by*m_6_now
        s87 = a_0_6_now_by*m_1_now + a_1_6_now_by*m_3_now + a_2_6_now_by*m_5_now + a_p_4_now_by*m_6_now
        s92 = a_0_7_now_by*m_1_now + a_1_7_now_by*m_3_now + a_2_7_now_by*m_5_now + a_p_5_now_by*m_6_now
        s100 = -V_0_0_now*s65 - V_0_0_now_by*W_0_now
        s103 = -V_1_0_now*s71 - V_1_0_now_by*W_1_now
        s106 = -V_2_0_now*s77 - V_2_0_now_by*W_2_now
        s109 = -V_3_0_now*s82 - V_3_0_now_by*W_3_now
        s112 = -V_4_0_now*s87 - V_4_0_now_by*W_4_now
        s113 = -V_5_0_now*s92 - V_5_0_now_by*W_5_now - a_0_0_now_by*m_0_now - a_0_1_now_by*m_1_now + s100 + s103 + s106 + s109 + s112
        s121 = -V_0_1_now*s65 - V_0_1_now_by*W_0_now
        s124 = -V_1_1_now*s71 - V_1_1_now_by*W_1_now
        s127 = -V_2_1_now*s77 - V_2_1_now_by*W_2_now
        s130 = -V_3_1_now*s82 - V_3_1_now_by*W_3_now
        s133 = -V_4_1_now*s87 - V_4_1_now_by*W_4_now
        s134 = -V_5_1_now*s92 - V_5_1_now_by*W_5_now - a_1_0_now_by*m_2_now - a_1_1_now_by*m_3_now + s121 + s124 + s127 + s130 + s133
        s142 = -V_0_2_now*s65 - V_0_2_now_by*W_0_now
        s145 = -V_1_2_now*s71 - V_1_2_now_by*W_1_now
        s148 = -V_2_2_now*s77 - V_2_2_now_by*W_2_now
        s151 = -V_3_2_now*s82 - V_3_2_now_by*W_3_now
        s154 = -V_4_2_now*s87 - V_4_2_now_by*W_4_now
        s155 = -V_5_2_now*s92 - V_5_2_now_by*W_5_now - a_2_0_now_by*m_4_now - a_2_1_now_by*m_5_now + s142 + s145 + s148 + s151 + s154
        s_by[1440 + lane] = s113
        s_by[1472 + lane] = s134
        s_by[1504 + lane] = s155


@straight
def _step_by(moves, w_by, first, last, n):
    """Move the platform by its twists, which a step takes off, the last one again for the rest of `n`."""
    for lane in range(n):
        m = min(first + lane, last)
        w_by[6336 + lane] = -moves[6 * m + 0]
        w_by[6368 + lane] = -moves[6 * m + 1]
        w_by[6400 + lane] = -moves[6 * m + 2]
        w_by[6432 + lane] = -moves[6 * m + 3]
        w_by[6464 + lane] = -moves[6 * m + 4]
        w_by[6496 + lane] = -moves[6 * m + 5]


@straight
def _held(w, size):
    """Begin with nothing that changes."""
    for n in range(size):
        w[n] = 0.0


@straight
def _pay_by(w, s_by, tau, first, last):
    """Write how what the joints give changes."""
    for lane in range(last - first + 1):
        regular = (w[7776 + lane] > 0.0) & (w[7808 + lane] > 0.0)
        tau[3 * (first + lane) + 0] = s_by[1440 + lane] if regular else math.nan
        tau[3 * (first + lane) + 1] = s_by[1472 + lane] if regular else math.nan
        tau[3 * (first + lane) + 2] = s_by[1504 + lane] if regular else math.nan


@fast
def _torque_by(x, x_by, motion, tool, k, k_by, c, c_by, gravity, shares, inertia, tau):
    found, moves = tau.reshape(tau.size), x_by.reshape(x_by.size)
    w_by, d_by, s_by = scratch(WORK), scratch(3 * OWN), scratch(SHARED)
    _held(w_by, WORK)
    _held(d_by, 3 * OWN)
    _held(s_by, SHARED)
    u_1, e_1 = w_by[0:2112], d_by[0 * OWN:1 * OWN]
    u_2, e_2 = w_by[2112:4224], d_by[1 * OWN:2 * OWN]
    u_3, e_3 = w_by[4224:6336], d_by[2 * OWN:3 * OWN]
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
            for e in range(len(k_by)):
                k_by_1, own_by_1 = k_by[e, 0], c_by[e, 0]
                k_by_2, own_by_2 = k_by[e, 1], c_by[e, 1]
                k_by_3, own_by_3 = k_by[e, 2], c_by[e, 2]
                _step_by(moves[e * samples * 6 :], w_by, first, last, n)
                _move_platform_by(w, w_by, d, d_by, s, s_by, k_1, k_by_1, gravity, shares, inertia, n)
                _early_by(
                    w_1, u_1, d_1, e_1, s, s_by, k_1, k_by_1,
                    gravity, shares[0:], inertia, n,
                )
                _more_by(
                    w_1, u_1, d_1, e_1, s, s_by, k_1, k_by_1,
                    gravity, shares[0:], inertia, n,
                )
                _rows_by(
                    w_1, u_1, d_1, e_1, s, s_by, k_1, k_by_1,
                    gravity, shares[0:], inertia, n,
                )
                _joints_by(
                    w_1, u_1, d_1, e_1, s, s_by, k_1, k_by_1,
                    gravity, shares[0:], inertia, n,
                )
                _early_by(
                    w_2, u_2, d_2, e_2, s, s_by, k_2, k_by_2,
                    gravity, shares[1:], inertia, n,
                )
                _more_by(
                    w_2, u_2, d_2, e_2, s, s_by, k_2, k_by_2,
                    gravity, shares[1:], inertia, n,
                )
                _rows_by(
                    w_2, u_2, d_2, e_2, s, s_by, k_2, k_by_2,
                    gravity, shares[1:], inertia, n,
                )
                _joints_by(
                    w_2, u_2, d_2, e_2, s, s_by, k_2, k_by_2,
                    gravity, shares[1:], inertia, n,
                )
                _early_by(
                    w_3, u_3, d_3, e_3, s, s_by, k_3, k_by_3,
                    gravity, shares[2:], inertia, n,
                )
                _more_by(
                    w_3, u_3, d_3, e_3, s, s_by, k_3, k_by_3,
                    gravity, shares[2:], inertia, n,
                )
                _rows_by(
                    w_3, u_3, d_3, e_3, s, s_by, k_3, k_by_3,
                    gravity, shares[2:], inertia, n,
                )
                _joints_by(
                    w_3, u_3, d_3, e_3, s, s_by, k_3, k_by_3,
                    gravity, shares[2:], inertia, n,
                )
                _inverse_by(w, w_by, d, d_by, s, s_by, k_1, k_by_1, gravity, shares, inertia, n)
                _move_by(w, w_by, d, d_by, s, s_by, k_1, k_by_1, gravity, shares, inertia, n)
                _curved_by(
                    w_1, u_1, d_1, e_1, s, s_by, own_1, own_by_1,
                    gravity, shares[0:], inertia, n,
                )
                _curved_by(
                    w_2, u_2, d_2, e_2, s, s_by, own_2, own_by_2,
                    gravity, shares[1:], inertia, n,
                )
                _curved_by(
                    w_3, u_3, d_3, e_3, s, s_by, own_3, own_by_3,
                    gravity, shares[2:], inertia, n,
                )
                _accelerate_by(w, w_by, d, d_by, s, s_by, k_1, k_by_1, gravity, shares, inertia, n)
                _limb_fields_by(
                    w_1, u_1, d_1, e_1, s, s_by, own_1, own_by_1,
                    gravity, shares[0:], inertia, n,
                )
                _limb_asks_by(
                    w_1, u_1, d_1, e_1, s, s_by, own_1, own_by_1,
                    gravity, shares[0:], inertia, n,
                )
                _limb_fields_by(
                    w_2, u_2, d_2, e_2, s, s_by, own_2, own_by_2,
                    gravity, shares[1:], inertia, n,
                )
                _limb_asks_by(
                    w_2, u_2, d_2, e_2, s, s_by, own_2, own_by_2,
                    gravity, shares[1:], inertia, n,
                )
                _limb_fields_by(
                    w_3, u_3, d_3, e_3, s, s_by, own_3, own_by_3,
                    gravity, shares[2:], inertia, n,
                )
                _limb_asks_by(
                    w_3, u_3, d_3, e_3, s, s_by, own_3, own_by_3,
                    gravity, shares[2:], inertia, n,
                )
                _platform_fields_by(w, w_by, d, d_by, s, s_by, k_1, k_by_1, gravity, shares, inertia, n)
                _platform_asks_by(w, w_by, d, d_by, s, s_by, k_1, k_by_1, gravity, shares, inertia, n)
                _give_by(w, w_by, d, d_by, s, s_by, k_1, k_by_1, gravity, shares, inertia, n)
                _pay_by(w, s_by, found[e * samples * 3 :], first, last)


def torque_by(x, x_by, motion, tool, k, k_by, c, c_by, gravity, shares, inertia, tau):
    """Fill tau (E, N, 3) [N mm, N]: how `torque` of one machine changes along each of E errors, joints held.

    x_by (E, N, 6) are its platform's twists along them, shift and turn about the axes of {O}; k_by and c_by are
    what `constants_by` makes of them.
    """
    _torque_by(x, x_by, motion, tool, k, k_by, c, c_by, gravity, shares, inertia, tau)

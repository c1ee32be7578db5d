/*
 * Generated from derive/mechanisms/diamond.py by "deltacal kernels". Do not edit.
 * Template templates/mechanism/dynamics.c.jinja; sha256 of both 3729254c336c82c2; SymPy 1.14.0.
 *
 * The calibrated machine in motion: joints, their speeds and accelerations by those of the reference point, and what
 * the drives must give. w and d hold a region for each limb, w and s what all limbs share.
 */
#define LIMB_W 28
#define LIMB_D 26
#define PLATFORM_STEPS 8 /* of Newton's method, at most, until the platform stands at the joints */
#define PLATFORM_DONE 1e-9 /* mm and rad */

/* What moves with a joint only; then the simplified limb as a sphere |P|^2 - 2 c.P + d = 0: c, d (19 operations). */
static void early(double *w, const double *k)
{
    const double q = w[0];
    const double tx = w[1];
    const double ty = w[2];
    const double s6 = k[0];
    const double s9 = k[1];
    const double s12 = k[2];
    const double B_x = k[3];
    const double B_y = k[4];
    const double s27 = k[11];
    const double s7 = q + s6;
    const double s8 = cos(s7);
    const double s10 = s8*s9;
    const double s11 = sin(s7);
    const double C_x = B_x + s10 + s11*s12;
    const double s16 = s11*s9;
    const double C_y = B_y - s12*s8 + s16;
    const double s79 = B_x + s10 + tx;
    const double s80 = B_y + s16 + ty;
    const double s83 = -s27 + (s79 * s79) + (s80 * s80);
    w[10] = C_x;
    w[11] = C_y;
    w[12] = s79;
    w[13] = s80;
    w[14] = s83;
}

/* What else derivatives by joint and errors read of it (10 operations). */
static void more(double *w, const double *k)
{
    const double q = w[0];
    const double s6 = k[0];
    const double s9 = k[1];
    const double s12 = k[2];
    const double s7 = q + s6;
    const double s8 = cos(s7);
    const double s11 = sin(s7);
    const double s84 = s11*s9 - s12*s8;
    const double s86 = -s11*s12 - s8*s9;
    w[16] = s11;
    w[17] = s8;
    w[18] = s84;
    w[19] = s86;
}

/* Equations of a limb, their derivatives by shift and turn of the platform (10 operations). */
static void rows(double *w, const double *k)
{
    const double tx = w[1];
    const double ty = w[2];
    const double px = w[4];
    const double py = w[5];
    const double C_x = w[10];
    const double C_y = w[11];
    const double s28 = k[5];
    const double A_x = px - tx;
    const double A_y = py - ty;
    const double d_x = A_x - C_x;
    const double d_y = A_y - C_y;
    const double s29 = (1.0/2.0)*(d_x * d_x) + (1.0/2.0)*(d_y * d_y) + s28;
    w[6] = s29;
    w[7] = d_x;
    w[8] = d_y;
}

/* Derivatives of a limb's equations by its joint (7 operations). */
static void joints_of_rows(double *w, const double *k)
{
    const double tx = w[1];
    const double ty = w[2];
    const double px = w[4];
    const double py = w[5];
    const double C_x = w[10];
    const double C_y = w[11];
    const double s84 = w[18];
    const double s86 = w[19];
    const double A_x = px - tx;
    const double A_y = py - ty;
    const double d_x = A_x - C_x;
    const double d_y = A_y - C_y;
    const double s88 = d_x*s84 + d_y*s86;
    (void)(k);
    w[9] = s88;
}

/* Newton's step of the platform; how far the equations are from dependent (26 operations). */
static void step(double *w)
{
    const double F00 = w[6];
    const double J00_0 = w[7];
    const double J00_1 = w[8];
    const double F10 = w[34];
    const double J10_0 = w[35];
    const double J10_1 = w[36];
    const double G_det_00 = J00_0*J10_1 - J00_1*J10_0;
    const double G_by_00 = 1.0/G_det_00;
    const double G_inv_00 = G_by_00*J10_1;
    const double G_inv_01 = -G_by_00*J00_1;
    const double G_inv_10 = -G_by_00*J10_0;
    const double G_inv_11 = G_by_00*J00_0;
    const double u_00 = F00*G_inv_00 + F10*G_inv_01;
    const double u_10 = F00*G_inv_10 + F10*G_inv_11;
    const double s22 = (G_det_00 * G_det_00) - 9.9999999999999998e-13*((J00_0 * J00_0) + (J00_1 * J00_1))*((J10_0 * J10_0) + (J10_1 * J10_1));
    w[56] = u_00;
    w[57] = u_10;
    w[58] = s22;
}

/* Minus the inverse of the derivatives, row by row; how far the equations are from dependent (24 operations). */
static void inverse_of_rows(double *w)
{
    const double J00_0 = w[7];
    const double J00_1 = w[8];
    const double J10_0 = w[35];
    const double J10_1 = w[36];
    const double G_det_00 = J00_0*J10_1 - J00_1*J10_0;
    const double G_by_00 = 1.0/G_det_00;
    const double G_inv_00 = G_by_00*J10_1;
    const double G_inv_01 = -G_by_00*J00_1;
    const double G_inv_10 = -G_by_00*J10_0;
    const double G_inv_11 = G_by_00*J00_0;
    const double s22 = (G_det_00 * G_det_00) - 9.9999999999999998e-13*((J00_0 * J00_0) + (J00_1 * J00_1))*((J10_0 * J10_0) + (J10_1 * J10_1));
    w[60] = -G_inv_00;
    w[61] = -G_inv_01;
    w[62] = -G_inv_10;
    w[63] = -G_inv_11;
    w[64] = s22;
}

/* The platform after a step, and its rotation matrix (4 operations). */
static void place(double *w)
{
    const double px = w[4];
    const double py = w[5];
    const double y0 = w[56];
    const double y1 = w[57];
    const double going = w[59];
    const double new_00 = -going*y0 + px;
    const double new_10 = -going*y1 + py;
    w[4] = new_00;
    w[32] = new_00;
    w[5] = new_10;
    w[33] = new_10;
}

/* How the platform moves with each joint, and how it does (10 operations). */
static void move(const double *w, const double *d, double *s)
{
    const double M_0_0 = w[60];
    const double M_0_1 = w[61];
    const double M_1_0 = w[62];
    const double M_1_1 = w[63];
    const double q_t_0 = d[0];
    const double Q_0 = w[9];
    const double q_t_1 = d[26];
    const double Q_1 = w[37];
    const double V_0_0 = M_0_0*Q_0;
    const double V_0_1 = M_0_1*Q_1;
    const double V_1_0 = M_1_0*Q_0;
    const double V_1_1 = M_1_1*Q_1;
    const double s6 = V_0_0*q_t_0 + V_0_1*q_t_1;
    const double s9 = V_1_0*q_t_0 + V_1_1*q_t_1;
    s[0] = V_0_0;
    s[1] = V_0_1;
    s[2] = V_1_0;
    s[3] = V_1_1;
    s[4] = s6;
    s[5] = s9;
}

/* Second derivatives of a limb's equations by time where nothing accelerates (42 operations). */
static void curved(const double *w, double *d, const double *s, const double *k, const double *gravity, const double *shares)
{
    const double q = w[0];
    const double tx = w[1];
    const double ty = w[2];
    const double px = w[4];
    const double py = w[5];
    const double v_px = s[4];
    const double v_py = s[5];
    const double q_t = d[0];
    const double s6 = k[0];
    const double s9 = k[1];
    const double s12 = k[2];
    const double B_x = k[3];
    const double B_y = k[4];
    const double s7 = q + s6;
    const double s8 = cos(s7);
    const double s11 = sin(s7);
    const double C_x = B_x + s11*s12 + s8*s9;
    const double C_y = B_y + s11*s9 - s12*s8;
    const double A_x = px - tx;
    const double A_y = py - ty;
    const double d_x = A_x - C_x;
    const double d_y = A_y - C_y;
    const double s30 = -q_t*s11;
    const double s32 = q_t*s8;
    const double s38 = -s12*s32 - s30*s9 + v_px;
    const double s39 = s12*s30 - s32*s9 + v_py;
    const double s47 = -q_t*s32;
    const double s49 = q_t*s30;
    const double s64 = -d_y*(-s12*s47 + s49*s9) + (s39 * s39);
    const double s65 = -d_x*(s12*s49 + s47*s9) + (s38 * s38) + s64;
    (void)(gravity);
    (void)(shares);
    d[2] = s65;
}

/* The platform's acceleration (14 operations). */
static void accelerate(const double *w, const double *d, double *s)
{
    const double M_0_0 = w[60];
    const double M_0_1 = w[61];
    const double M_1_0 = w[62];
    const double M_1_1 = w[63];
    const double q_tt_0 = d[1];
    const double c_0 = d[2];
    const double q_tt_1 = d[27];
    const double c_1 = d[28];
    const double V_0_0 = s[0];
    const double V_0_1 = s[1];
    const double V_1_0 = s[2];
    const double V_1_1 = s[3];
    const double s4 = M_0_0*c_0 + M_0_1*c_1 + V_0_0*q_tt_0 + V_0_1*q_tt_1;
    const double s9 = M_1_0*c_0 + M_1_1*c_1 + V_1_0*q_tt_0 + V_1_1*q_tt_1;
    s[6] = s4;
    s[7] = s9;
}

/* Gravity less acceleration of the points of a limb (42 operations). */
static void limb_fields(const double *w, double *d, const double *s, const double *k, const double *gravity, const double *shares)
{
    const double q = w[0];
    const double v_px_t = s[6];
    const double v_py_t = s[7];
    const double q_t = d[0];
    const double q_tt = d[1];
    const double gx = gravity[0];
    const double gy = gravity[1];
    const double s6 = k[0];
    const double s9 = k[1];
    const double s12 = k[2];
    const double s7 = q + s6;
    const double s8 = cos(s7);
    const double s11 = sin(s7);
    const double s281 = -(q_t * q_t)*s8 - q_tt*s11;
    const double s282 = s281*s9;
    const double s284 = -(q_t * q_t)*s11 + q_tt*s8;
    const double s286 = s12*s284 + s282;
    const double s288 = s284*s9;
    const double s289 = -s12*s281 + s288;
    const double s435 = -1.0/1000.0*s282;
    const double s436 = gx + s435;
    const double s437 = -1.0/1000.0*s288;
    const double s438 = gy + s437;
    const double s439 = gx - s435;
    const double s440 = gy - s437;
    const double s442 = gx - 1.0/1000.0*s286;
    const double s444 = gy - 1.0/1000.0*s289;
    const double s446 = gx - 1.0/2000.0*s286 - 1.0/2000.0*v_px_t;
    const double s448 = gy - 1.0/2000.0*s289 - 1.0/2000.0*v_py_t;
    const double s450 = gx - 1.0/1000.0*v_px_t;
    const double s452 = gy - 1.0/1000.0*v_py_t;
    (void)(shares);
    d[6] = s436;
    d[7] = s438;
    d[9] = s439;
    d[10] = s440;
    d[12] = s442;
    d[13] = s444;
    d[15] = s446;
    d[16] = s448;
    d[18] = s450;
    d[19] = s452;
}

/* Loads per inertial parameter of a limb, along joint, shifts and turns (48 operations). */
static void limb_asks(const double *w, double *d, const double *s, const double *k, const double *gravity, const double *shares)
{
    const double q = w[0];
    const double share = shares[0];
    const double f1x = d[6];
    const double f1y = d[7];
    const double f2x = d[9];
    const double f2y = d[10];
    const double f3x = d[12];
    const double f3y = d[13];
    const double f4x = d[15];
    const double f4y = d[16];
    const double f5x = d[18];
    const double f5y = d[19];
    const double s6 = k[0];
    const double s9 = k[1];
    const double s12 = k[2];
    const double s72 = k[5];
    const double s108 = k[6];
    const double s7 = q + s6;
    const double s8 = cos(s7);
    const double s11 = sin(s7);
    const double s102 = -s11*s9*(f1x*s72 + f2x*s72) + s8*s9*(f1y*s72 + f2y*s72);
    const double s128 = -s11*s9*(f1x*s108 - f2x*s108) + s8*s9*(f1y*s108 - f2y*s108);
    const double s142 = 1 - 2*share;
    const double s156 = (1.0/2.0)*f4y*s142;
    const double s159 = (1.0/2.0)*f4x*s142;
    const double s169 = f5y*share + s156;
    const double s170 = f5x*share + s159;
    const double s171 = f3y*share + s156;
    const double s176 = f3x*share + s159;
    const double s185 = -s11*(-s12*s171 + s176*s9) + s8*(s12*s176 + s171*s9);
    (void)(s);
    (void)(gravity);
    d[21] = s102;
    d[22] = s128;
    d[23] = s185;
    d[24] = s170;
    d[25] = s169;
}

/* Gravity less acceleration of the points of a platform (4 operations). */
static void platform_fields(const double *w, const double *d, double *s, const double *gravity)
{
    const double v_px_t = s[6];
    const double v_py_t = s[7];
    const double gx = gravity[0];
    const double gy = gravity[1];
    const double s66 = gx - 1.0/1000.0*v_px_t;
    const double s68 = gy - 1.0/1000.0*v_py_t;
    (void)(w);
    (void)(d);
    s[8] = s66;
    s[9] = s68;
    s[11] = s66;
    s[12] = s68;
}

/* Loads per inertial parameter of a platform, along joint, shifts and turns (0 operations). */
static void platform_asks(const double *w, const double *d, double *s)
{
    const double f0x = s[8];
    const double f0y = s[9];
    const double f1x = s[11];
    const double f1y = s[12];
    (void)(w);
    (void)(d);
    s[14] = f0x;
    s[15] = f0y;
    s[16] = f1x;
    s[17] = f1y;
}

/* What the joints give (34 operations). */
static void give(const double *d, double *s, const double *inertia)
{
    const double a_0_0 = d[21];
    const double a_0_1 = d[22];
    const double a_0_2 = d[23];
    const double a_0_3 = d[24];
    const double a_0_4 = d[25];
    const double a_1_0 = d[47];
    const double a_1_1 = d[48];
    const double a_1_2 = d[49];
    const double a_1_3 = d[50];
    const double a_1_4 = d[51];
    const double a_p_0 = s[14];
    const double a_p_1 = s[15];
    const double a_p_2 = s[16];
    const double a_p_3 = s[17];
    const double V_0_0 = s[0];
    const double V_0_1 = s[1];
    const double V_1_0 = s[2];
    const double V_1_1 = s[3];
    const double m_1 = inertia[1];
    const double m_2 = inertia[2];
    const double m_3 = inertia[3];
    const double m_5 = inertia[5];
    const double m_6 = inertia[6];
    const double m_7 = inertia[7];
    const double m_8 = inertia[8];
    const double m_9 = inertia[9];
    const double W_0 = a_0_3*m_3 + a_1_3*m_7 + a_p_0*m_8 + a_p_2*m_9;
    const double W_1 = a_0_4*m_3 + a_1_4*m_7 + a_p_1*m_8 + a_p_3*m_9;
    const double s15 = -V_0_0*W_0 - V_1_0*W_1 - a_0_0*m_1 - a_0_1*m_2 - a_0_2*m_3;
    const double s21 = -V_0_1*W_0 - V_1_1*W_1 - a_1_0*m_5 - a_1_1*m_6 - a_1_2*m_7;
    s[18] = s15;
    s[19] = s21;
}

/* Solve A x = b in place; 0 where A is singular. */
static int solve(double A[2][2], double b[2])
{
    double largest = 0.0;
    int i, j, c;
    for (i = 0; i < 2; i++)
        for (j = 0; j < 2; j++)
            largest = fmax(largest, fabs(A[i][j]));
    for (c = 0; c < 2; c++) {
        int pivot = c;
        for (i = c + 1; i < 2; i++)
            if (fabs(A[i][c]) > fabs(A[pivot][c]))
                pivot = i;
        if (!(fabs(A[pivot][c]) > 1e-9 * largest))
            return 0;
        for (j = 0; j < 2; j++) {
            const double swap = A[c][j];
            A[c][j] = A[pivot][j];
            A[pivot][j] = swap;
        }
        {
            const double swap = b[c];
            b[c] = b[pivot];
            b[pivot] = swap;
        }
        for (i = c + 1; i < 2; i++) {
            const double factor = A[i][c] / A[c][c];
            for (j = c; j < 2; j++)
                A[i][j] -= factor * A[c][j];
            b[i] -= factor * b[c];
        }
    }
    for (c = 1; c >= 0; c--) {
        for (j = c + 1; j < 2; j++)
            b[c] -= A[c][j] * b[j];
        b[c] /= A[c][c];
    }
    return 1;
}

/* Solve how fast the joints move the commanded coordinates as asked. */
static int joint_rates(const double *s, double rates[2])
{
    double A[2][2];
    int i, c;
    for (c = 0; c < 2; c++)
        for (i = 0; i < 2; i++)
            A[c][i] = s[0 + 2 * c + i];
    return solve(A, rates);
}

/*
 * Set the machine in motion: q the joints as the geometry counts them, velocity and acceleration those of the commanded
 * coordinates. Fills the joints' speeds and accelerations; asks of all bodies then stand in d and s.
 */
static int in_motion(const double *target, const double *velocity, const double *acceleration, const double *q,
                     double *qd, double *qdd, double *d, double *s)
{
    double w[69] = { 0.0 };
    int i, c, steps;
    for (i = 0; i < 2; i++) {
        w[LIMB_W * i + 0] = q[i];
        for (c = 0; c < 3; c++)
            w[LIMB_W * i + 1 + c] = DELTACAL_TOOL[c];
        for (c = 0; c < 2; c++)
            w[LIMB_W * i + 4 + c] = c < 2 ? target[c] : 0.0;
        early(w + LIMB_W * i, DELTACAL_MOTION_K[i]);
        more(w + LIMB_W * i, DELTACAL_MOTION_K[i]);
    }
    w[59] = 1.0;
    place(w);
    for (steps = 0; steps < PLATFORM_STEPS; steps++) {
        double size = 0.0;
        for (i = 0; i < 2; i++)
            rows(w + LIMB_W * i, DELTACAL_MOTION_K[i]);
        step(w);
        place(w);
        for (c = 0; c < 2; c++)
            size = fmax(size, fabs(w[56 + c]));
        if (size < PLATFORM_DONE)
            break;
    }
    if (steps == PLATFORM_STEPS)
        return DELTACAL_SINGULAR;
    for (i = 0; i < 2; i++) {
        rows(w + LIMB_W * i, DELTACAL_MOTION_K[i]);
        joints_of_rows(w + LIMB_W * i, DELTACAL_MOTION_K[i]);
        d[LIMB_D * i + 0] = d[LIMB_D * i + 1] = 0.0;
    }
    inverse_of_rows(w);
    move(w, d, s);
    for (c = 0; c < 2; c++)
        qd[c] = velocity[c];
    if (!joint_rates(s, qd))
        return DELTACAL_SINGULAR;
    for (i = 0; i < 2; i++)
        d[LIMB_D * i + 0] = qd[i];
    move(w, d, s);
    for (i = 0; i < 2; i++)
        curved(w + LIMB_W * i, d + LIMB_D * i, s, DELTACAL_BODY_K[i], DELTACAL_GRAVITY, DELTACAL_SHARES + i);
    accelerate(w, d, s); /* of joints that do not accelerate */
    for (c = 0; c < 2; c++)
        qdd[c] = acceleration[c] - s[6 + c];
    if (!joint_rates(s, qdd))
        return DELTACAL_SINGULAR;
    for (i = 0; i < 2; i++)
        d[LIMB_D * i + 1] = qdd[i];
    accelerate(w, d, s);
    for (i = 0; i < 2; i++) {
        limb_fields(w + LIMB_W * i, d + LIMB_D * i, s, DELTACAL_BODY_K[i], DELTACAL_GRAVITY, DELTACAL_SHARES + i);
        limb_asks(w + LIMB_W * i, d + LIMB_D * i, s, DELTACAL_BODY_K[i], DELTACAL_GRAVITY, DELTACAL_SHARES + i);
    }
    platform_fields(w, d, s, DELTACAL_GRAVITY);
    platform_asks(w, d, s);
    return DELTACAL_SOLVED;
}

int deltacal_feedforward(struct deltacal_motion *held, const double target_mm[2],
                         const double velocity_mm_s[2], const double acceleration_mm_s2[2],
                         double payload_kg, double temp_C)
{
    double past[DELTACAL_PAST + 1] = { 0.0 }, h; /* since the last set point [s] */
    double x[2], speed[2], change[2]; /* of turns: Cayley vector, rad/s, rad/s^2 */
    double q[2], qd[2], qdd[2], joints[2], torque[2];
    double d[LIMB_D * 2] = { 0.0 }, s[30] = { 0.0 };
    int i, status, limited = 0;
    for (i = 0; i < 2; i++)
        if (!isfinite(target_mm[i]) || !isfinite(velocity_mm_s[i]) || !isfinite(acceleration_mm_s2[i]))
            return DELTACAL_NOT_A_NUMBER;
    if (!isfinite(payload_kg) || !isfinite(temp_C))
        return DELTACAL_NOT_A_NUMBER;
    status = deltacal_compensate(target_mm, joints);
    if (status != DELTACAL_SOLVED)
        return status;
    for (i = 0; i < 2; i++) {
        if (held->begun && !(fabs(joints[i] - held->joints_deg[i]) <= DELTACAL_MOST_SPEED[i] * held->period_s))
            return DELTACAL_JUMP;
        q[i] = DELTACAL_SIGN[i] * joints[i] / JOINT_PER_UNIT;
    }
    for (i = 0; i < 2; i++) {
        x[i] = target_mm[i];
        speed[i] = velocity_mm_s[i];
        change[i] = acceleration_mm_s2[i];
    }
    status = in_motion(x, speed, change, q, qd, qdd, d, s);
    if (status != DELTACAL_SOLVED)
        return status;
    recall(held, past);
    h = held->begun ? held->period_s : 0.0;
    for (i = 0; i < 2; i++) {
        double load, carried;
        give(d, s, DELTACAL_INERTIA[i]);
        load = DELTACAL_SIGN[i] * s[18 + i];
        give(d, s, DELTACAL_PAYLOAD);
        carried = DELTACAL_SIGN[i] * s[18 + i] * payload_kg;
        torque[i] = deltacal_drive(past, h, i, DELTACAL_SIGN[i] * q[i], DELTACAL_SIGN[i] * qd[i],
                                   DELTACAL_SIGN[i] * qdd[i], load + DELTACAL_PAYLOAD_LOADS[i] * carried, temp_C);
        torque[i] /= DELTACAL_READ[i];
        if (!isfinite(torque[i]))
            return DELTACAL_SINGULAR;
    }
    for (i = 0; i < 2; i++) {
        held->joints_deg[i] = joints[i];
        held->torque[i] = fmin(fmax(torque[i], DELTACAL_TORQUE_LOW[i]), DELTACAL_TORQUE_HIGH[i]);
        limited |= held->torque[i] != torque[i];
    }
    keep(held, past);
    held->begun = 1;
    return limited ? DELTACAL_LIMITED : DELTACAL_SOLVED;
}

/*
 * Generated from derive/mechanisms/simplified_parallelogram.py by "deltacal kernels". Do not edit.
 * Template templates/mechanism/dynamics.c.jinja; sha256 of both 738ea0bf60e47b0f; SymPy 1.14.0.
 *
 * The calibrated machine in motion: joints, their speeds and accelerations by those of the reference point, and what
 * the drives must give. w and d hold a region for each limb, w and s what all limbs share.
 */
#define LIMB_W 39
#define LIMB_D 23
#define PLATFORM_STEPS 8 /* of Newton's method, at most, until the platform stands at the joints */
#define PLATFORM_DONE 1e-9 /* mm and rad */

/* What moves with a joint only; then platform of the simplified machine at a given joint (11 operations). */
static void early(double *w, const double *k)
{
    const double q = w[0];
    const double tx = w[1];
    const double ty = w[2];
    const double q0 = k[0];
    const double s1 = k[1];
    const double A_x = k[2];
    const double h = k[3];
    const double s2 = q + q0;
    const double r_x = s1*sin(s2);
    const double r_y = -s1*cos(s2);
    const double B_x = A_x + r_x;
    const double s24 = A_x + r_x + tx;
    const double s25 = -h + r_y + ty;
    w[22] = B_x;
    w[23] = r_y;
    w[24] = s24;
    w[25] = s25;
    w[26] = 0;
}

/* What else derivatives by joint and errors read of it (4 operations). */
static void more(double *w, const double *k)
{
    const double q = w[0];
    const double q0 = k[0];
    const double s1 = k[1];
    const double s2 = q + q0;
    const double s3 = sin(s2);
    const double r_x = s1*s3;
    const double s5 = cos(s2);
    w[30] = r_x;
    w[31] = s3;
    w[32] = s5;
}

/* Equations of a limb, their derivatives by shift and turn of the platform (8 operations). */
static void rows(double *w, const double *k)
{
    const double tx = w[1];
    const double ty = w[2];
    const double px = w[4];
    const double py = w[5];
    const double cz = w[6];
    const double B_x = w[22];
    const double r_y = w[23];
    const double h = k[3];
    const double C_x = px - tx;
    const double C_y = h + py - ty;
    const double s10 = -B_x + C_x;
    const double s11 = C_y - r_y;
    const double s28 = (1.0/4.0)*(cz * cz) + 1;
    w[7] = s10;
    w[8] = 1;
    w[9] = 0;
    w[10] = 0;
    w[12] = s11;
    w[13] = 0;
    w[14] = 1;
    w[15] = 0;
    w[17] = cz;
    w[18] = 0;
    w[19] = 0;
    w[20] = s28;
}

/* Derivatives of a limb's equations by its joint (1 operations). */
static void joints_of_rows(double *w, const double *k)
{
    const double r_y = w[23];
    const double r_x = w[30];
    (void)(k);
    w[11] = r_y;
    w[16] = -r_x;
    w[21] = 0;
}

/* Newton's step of the platform; how far the equations are from dependent (77 operations). */
static void step(double *w)
{
    const double F00 = w[7];
    const double J00_0 = w[8];
    const double J00_1 = w[9];
    const double J00_2 = w[10];
    const double F01 = w[12];
    const double J01_0 = w[13];
    const double J01_1 = w[14];
    const double J01_2 = w[15];
    const double F02 = w[17];
    const double J02_0 = w[18];
    const double J02_1 = w[19];
    const double J02_2 = w[20];
    const double G_cof_00 = J01_1*J02_2 - J01_2*J02_1;
    const double G_cof_01 = -J01_0*J02_2 + J01_2*J02_0;
    const double G_cof_02 = J01_0*J02_1 - J01_1*J02_0;
    const double G_cof_10 = -J00_1*J02_2 + J00_2*J02_1;
    const double G_cof_11 = J00_0*J02_2 - J00_2*J02_0;
    const double G_cof_12 = -J00_0*J02_1 + J00_1*J02_0;
    const double G_cof_20 = J00_1*J01_2 - J00_2*J01_1;
    const double G_cof_21 = -J00_0*J01_2 + J00_2*J01_0;
    const double G_cof_22 = J00_0*J01_1 - J00_1*J01_0;
    const double G_det_00 = G_cof_00*J00_0 + G_cof_01*J00_1 + G_cof_02*J00_2;
    const double G_by_00 = 1.0/G_det_00;
    const double G_inv_00 = G_by_00*G_cof_00;
    const double G_inv_01 = G_by_00*G_cof_10;
    const double G_inv_02 = G_by_00*G_cof_20;
    const double G_inv_10 = G_by_00*G_cof_01;
    const double G_inv_11 = G_by_00*G_cof_11;
    const double G_inv_12 = G_by_00*G_cof_21;
    const double G_inv_20 = G_by_00*G_cof_02;
    const double G_inv_21 = G_by_00*G_cof_12;
    const double G_inv_22 = G_by_00*G_cof_22;
    const double u_00 = F00*G_inv_00 + F01*G_inv_01 + F02*G_inv_02;
    const double u_10 = F00*G_inv_10 + F01*G_inv_11 + F02*G_inv_12;
    const double u_20 = F00*G_inv_20 + F01*G_inv_21 + F02*G_inv_22;
    const double s61 = (J01_0 * J01_0) + (J01_1 * J01_1) + (J01_2 * J01_2);
    const double s65 = (J02_0 * J02_0) + (J02_1 * J02_1) + (J02_2 * J02_2);
    const double s67 = (G_det_00 * G_det_00) - 9.9999999999999998e-13*s61*s65*((J00_0 * J00_0) + (J00_1 * J00_1) + (J00_2 * J00_2));
    w[39] = u_00;
    w[40] = u_10;
    w[41] = u_20;
    w[42] = s67;
}

/* Minus the inverse of the derivatives, row by row; how far the equations are from dependent (71 operations). */
static void inverse_of_rows(double *w)
{
    const double J00_0 = w[8];
    const double J00_1 = w[9];
    const double J00_2 = w[10];
    const double J01_0 = w[13];
    const double J01_1 = w[14];
    const double J01_2 = w[15];
    const double J02_0 = w[18];
    const double J02_1 = w[19];
    const double J02_2 = w[20];
    const double G_cof_00 = J01_1*J02_2 - J01_2*J02_1;
    const double G_cof_01 = -J01_0*J02_2 + J01_2*J02_0;
    const double G_cof_02 = J01_0*J02_1 - J01_1*J02_0;
    const double G_cof_10 = -J00_1*J02_2 + J00_2*J02_1;
    const double G_cof_11 = J00_0*J02_2 - J00_2*J02_0;
    const double G_cof_12 = -J00_0*J02_1 + J00_1*J02_0;
    const double G_cof_20 = J00_1*J01_2 - J00_2*J01_1;
    const double G_cof_21 = -J00_0*J01_2 + J00_2*J01_0;
    const double G_cof_22 = J00_0*J01_1 - J00_1*J01_0;
    const double G_det_00 = G_cof_00*J00_0 + G_cof_01*J00_1 + G_cof_02*J00_2;
    const double G_by_00 = 1.0/G_det_00;
    const double G_inv_00 = G_by_00*G_cof_00;
    const double G_inv_01 = G_by_00*G_cof_10;
    const double G_inv_02 = G_by_00*G_cof_20;
    const double G_inv_10 = G_by_00*G_cof_01;
    const double G_inv_11 = G_by_00*G_cof_11;
    const double G_inv_12 = G_by_00*G_cof_21;
    const double G_inv_20 = G_by_00*G_cof_02;
    const double G_inv_21 = G_by_00*G_cof_12;
    const double G_inv_22 = G_by_00*G_cof_22;
    const double s61 = (J01_0 * J01_0) + (J01_1 * J01_1) + (J01_2 * J01_2);
    const double s65 = (J02_0 * J02_0) + (J02_1 * J02_1) + (J02_2 * J02_2);
    const double s67 = (G_det_00 * G_det_00) - 9.9999999999999998e-13*s61*s65*((J00_0 * J00_0) + (J00_1 * J00_1) + (J00_2 * J00_2));
    w[44] = -G_inv_00;
    w[45] = -G_inv_01;
    w[46] = -G_inv_02;
    w[47] = -G_inv_10;
    w[48] = -G_inv_11;
    w[49] = -G_inv_12;
    w[50] = -G_inv_20;
    w[51] = -G_inv_21;
    w[52] = -G_inv_22;
    w[53] = s67;
}

/* The platform after a step, and its rotation matrix (10 operations). */
static void place(double *w)
{
    const double px = w[4];
    const double py = w[5];
    const double cz = w[6];
    const double y0 = w[39];
    const double y1 = w[40];
    const double y2 = w[41];
    const double going = w[43];
    const double new_00 = -going*y0 + px;
    const double new_10 = -going*y1 + py;
    const double new_20 = cz - going*y2*((1.0/4.0)*(cz * cz) + 1);
    w[4] = new_00;
    w[5] = new_10;
    w[6] = new_20;
}

/* How the platform moves with each joint, and how it does (18 operations). */
static void move(const double *w, const double *d, double *s)
{
    const double M_0_0 = w[44];
    const double M_0_1 = w[45];
    const double M_0_2 = w[46];
    const double M_1_0 = w[47];
    const double M_1_1 = w[48];
    const double M_1_2 = w[49];
    const double M_2_0 = w[50];
    const double M_2_1 = w[51];
    const double M_2_2 = w[52];
    const double q_t_0 = d[0];
    const double Q_0 = w[11];
    const double Q_1 = w[16];
    const double Q_2 = w[21];
    const double V_0_0 = M_0_0*Q_0 + M_0_1*Q_1 + M_0_2*Q_2;
    const double V_1_0 = M_1_0*Q_0 + M_1_1*Q_1 + M_1_2*Q_2;
    const double V_2_0 = M_2_0*Q_0 + M_2_1*Q_1 + M_2_2*Q_2;
    const double s12 = V_0_0*q_t_0;
    const double s13 = V_1_0*q_t_0;
    const double s14 = V_2_0*q_t_0;
    s[0] = V_0_0;
    s[1] = V_1_0;
    s[2] = V_2_0;
    s[3] = s12;
    s[4] = s13;
    s[5] = s14;
}

/* Second derivatives of a limb's equations by time where nothing accelerates (12 operations). */
static void curved(const double *w, double *d, const double *s, const double *k, const double *gravity, const double *shares)
{
    const double q = w[0];
    const double q_t = d[0];
    const double q0 = k[0];
    const double s1 = k[1];
    const double s2 = q + q0;
    const double s19 = -(q_t * q_t)*s1*sin(s2);
    const double s21 = (q_t * q_t)*s1*cos(s2);
    (void)(s);
    (void)(gravity);
    (void)(shares);
    d[2] = -s19;
    d[3] = -s21;
    d[4] = 0;
}

/* The platform's acceleration (21 operations). */
static void accelerate(const double *w, const double *d, double *s)
{
    const double M_0_0 = w[44];
    const double M_0_1 = w[45];
    const double M_0_2 = w[46];
    const double M_1_0 = w[47];
    const double M_1_1 = w[48];
    const double M_1_2 = w[49];
    const double M_2_0 = w[50];
    const double M_2_1 = w[51];
    const double M_2_2 = w[52];
    const double q_tt_0 = d[1];
    const double c_0 = d[2];
    const double c_1 = d[3];
    const double c_2 = d[4];
    const double V_0_0 = s[0];
    const double V_1_0 = s[1];
    const double V_2_0 = s[2];
    const double s4 = M_0_0*c_0 + M_0_1*c_1 + M_0_2*c_2 + V_0_0*q_tt_0;
    const double s9 = M_1_0*c_0 + M_1_1*c_1 + M_1_2*c_2 + V_1_0*q_tt_0;
    const double s14 = M_2_0*c_0 + M_2_1*c_1 + M_2_2*c_2 + V_2_0*q_tt_0;
    s[6] = s4;
    s[7] = s9;
    s[8] = s14;
}

/* Gravity less acceleration of the points of a limb (27 operations). */
static void limb_fields(const double *w, double *d, const double *s, const double *k, const double *gravity, const double *shares)
{
    const double q = w[0];
    const double q_t = d[0];
    const double q_tt = d[1];
    const double gx = gravity[0];
    const double gy = gravity[1];
    const double q0 = k[0];
    const double s1 = k[1];
    const double s2 = q + q0;
    const double s3 = sin(s2);
    const double s5 = cos(s2);
    const double s180 = s1*(-(q_t * q_t)*s3 + q_tt*s5);
    const double s183 = -s1*(-(q_t * q_t)*s5 - q_tt*s3);
    const double s255 = -1.0/1000.0*s180;
    const double s256 = gx + s255;
    const double s257 = -1.0/1000.0*s183;
    const double s258 = gy + s257;
    const double s259 = gx - s255;
    const double s260 = gy - s257;
    const double s262 = gx - 1.0/2000.0*s180;
    const double s264 = gy - 1.0/2000.0*s183;
    (void)(s);
    (void)(shares);
    d[8] = s256;
    d[9] = s258;
    d[11] = s259;
    d[12] = s260;
    d[14] = s262;
    d[15] = s264;
    d[17] = s256;
    d[18] = s258;
}

/* Loads per inertial parameter of a limb, along joint, shifts and turns (40 operations). */
static void limb_asks(const double *w, double *d, const double *s, const double *k, const double *gravity, const double *shares)
{
    const double q = w[0];
    const double share = shares[0];
    const double f1x = d[8];
    const double f1y = d[9];
    const double f2x = d[11];
    const double f2y = d[12];
    const double f3x = d[14];
    const double f3y = d[15];
    const double f4x = d[17];
    const double f4y = d[18];
    const double q0 = k[0];
    const double s1 = k[1];
    const double s26 = k[2];
    const double s57 = k[3];
    const double s2 = q + q0;
    const double s3 = sin(s2);
    const double s5 = cos(s2);
    const double s52 = s1*s3*(f1y*s26 + f2y*s26) + s1*s5*(f1x*s26 + f2x*s26);
    const double s76 = s1*s3*(f1y*s57 - f2y*s57) + s1*s5*(f1x*s57 - f2x*s57);
    const double s85 = 1 - 2*share;
    const double s116 = s1*s5*((1.0/2.0)*f3x*s85 + f4x*share);
    const double s117 = s1*s3*((1.0/2.0)*f3y*s85 + f4y*share) + s116;
    (void)(s);
    (void)(gravity);
    d[20] = s52;
    d[21] = s76;
    d[22] = s117;
}

/* Gravity less acceleration of the points of a platform (4 operations). */
static void platform_fields(const double *w, const double *d, double *s, const double *gravity)
{
    const double v_px_t = s[6];
    const double v_py_t = s[7];
    const double gx = gravity[0];
    const double gy = gravity[1];
    const double s42 = gx - 1.0/1000.0*v_px_t;
    const double s44 = gy - 1.0/1000.0*v_py_t;
    (void)(w);
    (void)(d);
    s[9] = s42;
    s[10] = s44;
    s[12] = s42;
    s[13] = s44;
}

/* Loads per inertial parameter of a platform, along joint, shifts and turns (0 operations). */
static void platform_asks(const double *w, const double *d, double *s)
{
    const double f0x = s[9];
    const double f0y = s[10];
    const double f1x = s[12];
    const double f1y = s[13];
    (void)(w);
    (void)(d);
    s[15] = f0x;
    s[16] = f0y;
    s[17] = f1x;
    s[18] = f1y;
}

/* What the joints give (16 operations). */
static void give(const double *d, double *s, const double *inertia)
{
    const double a_0_0 = d[20];
    const double a_0_1 = d[21];
    const double a_0_2 = d[22];
    const double a_p_0 = s[15];
    const double a_p_1 = s[16];
    const double a_p_2 = s[17];
    const double a_p_3 = s[18];
    const double V_0_0 = s[0];
    const double V_1_0 = s[1];
    const double m_1 = inertia[1];
    const double m_2 = inertia[2];
    const double m_3 = inertia[3];
    const double m_4 = inertia[4];
    const double m_5 = inertia[5];
    const double W_0 = a_p_0*m_4 + a_p_2*m_5;
    const double W_1 = a_p_1*m_4 + a_p_3*m_5;
    const double s11 = -V_0_0*W_0 - V_1_0*W_1 - a_0_0*m_1 - a_0_1*m_2 - a_0_2*m_3;
    s[19] = s11;
}

/* Solve A x = b in place; 0 where A is singular. */
static int solve(double A[1][1], double b[1])
{
    double largest = 0.0;
    int i, j, c;
    for (i = 0; i < 1; i++)
        for (j = 0; j < 1; j++)
            largest = fmax(largest, fabs(A[i][j]));
    for (c = 0; c < 1; c++) {
        int pivot = c;
        for (i = c + 1; i < 1; i++)
            if (fabs(A[i][c]) > fabs(A[pivot][c]))
                pivot = i;
        if (!(fabs(A[pivot][c]) > 1e-9 * largest))
            return 0;
        for (j = 0; j < 1; j++) {
            const double swap = A[c][j];
            A[c][j] = A[pivot][j];
            A[pivot][j] = swap;
        }
        {
            const double swap = b[c];
            b[c] = b[pivot];
            b[pivot] = swap;
        }
        for (i = c + 1; i < 1; i++) {
            const double factor = A[i][c] / A[c][c];
            for (j = c; j < 1; j++)
                A[i][j] -= factor * A[c][j];
            b[i] -= factor * b[c];
        }
    }
    for (c = 0; c >= 0; c--) {
        for (j = c + 1; j < 1; j++)
            b[c] -= A[c][j] * b[j];
        b[c] /= A[c][c];
    }
    return 1;
}

/* Solve how fast the joints move the commanded coordinates as asked. */
static int joint_rates(const double *s, double rates[1])
{
    double A[1][1];
    int i, c;
    for (c = 0; c < 1; c++)
        for (i = 0; i < 1; i++)
            A[c][i] = s[0 + 1 * c + i];
    return solve(A, rates);
}

/*
 * Set the machine in motion: q the joints as the geometry counts them, velocity and acceleration those of the commanded
 * coordinates. Fills the joints' speeds and accelerations; asks of all bodies then stand in d and s.
 */
static int in_motion(const double *target, const double *velocity, const double *acceleration, const double *q,
                     double *qd, double *qdd, double *d, double *s)
{
    double w[58] = { 0.0 };
    int i, c, steps;
    for (i = 0; i < 1; i++) {
        w[LIMB_W * i + 0] = q[i];
        for (c = 0; c < 3; c++)
            w[LIMB_W * i + 1 + c] = DELTACAL_TOOL[c];
        for (c = 0; c < 3; c++)
            w[LIMB_W * i + 4 + c] = c < 1 ? target[c] : 0.0;
        early(w + LIMB_W * i, DELTACAL_MOTION_K[i]);
        more(w + LIMB_W * i, DELTACAL_MOTION_K[i]);
    }
    w[43] = 1.0;
    place(w);
    for (steps = 0; steps < PLATFORM_STEPS; steps++) {
        double size = 0.0;
        for (i = 0; i < 1; i++)
            rows(w + LIMB_W * i, DELTACAL_MOTION_K[i]);
        step(w);
        place(w);
        for (c = 0; c < 3; c++)
            size = fmax(size, fabs(w[39 + c]));
        if (size < PLATFORM_DONE)
            break;
    }
    if (steps == PLATFORM_STEPS)
        return DELTACAL_SINGULAR;
    for (i = 0; i < 1; i++) {
        rows(w + LIMB_W * i, DELTACAL_MOTION_K[i]);
        joints_of_rows(w + LIMB_W * i, DELTACAL_MOTION_K[i]);
        d[LIMB_D * i + 0] = d[LIMB_D * i + 1] = 0.0;
    }
    inverse_of_rows(w);
    move(w, d, s);
    for (c = 0; c < 1; c++)
        qd[c] = velocity[c];
    if (!joint_rates(s, qd))
        return DELTACAL_SINGULAR;
    for (i = 0; i < 1; i++)
        d[LIMB_D * i + 0] = qd[i];
    move(w, d, s);
    for (i = 0; i < 1; i++)
        curved(w + LIMB_W * i, d + LIMB_D * i, s, DELTACAL_BODY_K[i], DELTACAL_GRAVITY, DELTACAL_SHARES + i);
    accelerate(w, d, s); /* of joints that do not accelerate */
    for (c = 0; c < 1; c++)
        qdd[c] = acceleration[c] - s[6 + c];
    if (!joint_rates(s, qdd))
        return DELTACAL_SINGULAR;
    for (i = 0; i < 1; i++)
        d[LIMB_D * i + 1] = qdd[i];
    accelerate(w, d, s);
    for (i = 0; i < 1; i++) {
        limb_fields(w + LIMB_W * i, d + LIMB_D * i, s, DELTACAL_BODY_K[i], DELTACAL_GRAVITY, DELTACAL_SHARES + i);
        limb_asks(w + LIMB_W * i, d + LIMB_D * i, s, DELTACAL_BODY_K[i], DELTACAL_GRAVITY, DELTACAL_SHARES + i);
    }
    platform_fields(w, d, s, DELTACAL_GRAVITY);
    platform_asks(w, d, s);
    return DELTACAL_SOLVED;
}

int deltacal_feedforward(struct deltacal_motion *held, const double target_mm[1],
                         const double velocity_mm_s[1], const double acceleration_mm_s2[1],
                         double payload_kg, double temp_C)
{
    double past[DELTACAL_PAST + 1] = { 0.0 }, h; /* since the last set point [s] */
    double x[3], speed[1], change[1]; /* of turns: Cayley vector, rad/s, rad/s^2 */
    double q[1], qd[1], qdd[1], joints[1], torque[1];
    double d[LIMB_D * 1] = { 0.0 }, s[24] = { 0.0 };
    int i, status, limited = 0;
    for (i = 0; i < 1; i++)
        if (!isfinite(target_mm[i]) || !isfinite(velocity_mm_s[i]) || !isfinite(acceleration_mm_s2[i]))
            return DELTACAL_NOT_A_NUMBER;
    if (!isfinite(payload_kg) || !isfinite(temp_C))
        return DELTACAL_NOT_A_NUMBER;
    status = deltacal_compensate(target_mm, joints);
    if (status != DELTACAL_SOLVED)
        return status;
    for (i = 0; i < 1; i++) {
        if (held->begun && !(fabs(joints[i] - held->joints_deg[i]) <= DELTACAL_MOST_SPEED[i] * held->period_s))
            return DELTACAL_JUMP;
        q[i] = DELTACAL_SIGN[i] * joints[i] / JOINT_PER_UNIT;
    }
    for (i = 0; i < 1; i++) {
        x[i] = target_mm[i];
        speed[i] = velocity_mm_s[i];
        change[i] = acceleration_mm_s2[i];
    }
    status = in_motion(x, speed, change, q, qd, qdd, d, s);
    if (status != DELTACAL_SOLVED)
        return status;
    recall(held, past);
    h = held->begun ? held->period_s : 0.0;
    for (i = 0; i < 1; i++) {
        double load, carried;
        give(d, s, DELTACAL_INERTIA[i]);
        load = DELTACAL_SIGN[i] * s[19 + i];
        give(d, s, DELTACAL_PAYLOAD);
        carried = DELTACAL_SIGN[i] * s[19 + i] * payload_kg;
        torque[i] = deltacal_drive(past, h, i, DELTACAL_SIGN[i] * q[i], DELTACAL_SIGN[i] * qd[i],
                                   DELTACAL_SIGN[i] * qdd[i], load + DELTACAL_PAYLOAD_LOADS[i] * carried, temp_C);
        torque[i] /= DELTACAL_READ[i];
        if (!isfinite(torque[i]))
            return DELTACAL_SINGULAR;
    }
    for (i = 0; i < 1; i++) {
        held->joints_deg[i] = joints[i];
        held->torque[i] = fmin(fmax(torque[i], DELTACAL_TORQUE_LOW[i]), DELTACAL_TORQUE_HIGH[i]);
        limited |= held->torque[i] != torque[i];
    }
    keep(held, past);
    held->begun = 1;
    return limited ? DELTACAL_LIMITED : DELTACAL_SOLVED;
}

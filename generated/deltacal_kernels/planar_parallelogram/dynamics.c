/*
 * Generated from derive/mechanisms/planar_parallelogram.py by "deltacal kernels". Do not edit.
 * Template templates/mechanism/dynamics.c.jinja; sha256 of both caa1df205f9ff7b7; SymPy 1.14.0.
 *
 * The calibrated machine in motion: joints, their speeds and accelerations by those of the reference point, and what
 * the drives must give. w and d hold a region for each limb, w and s what all limbs share.
 */
#define LIMB_W 67
#define LIMB_D 28
#define PLATFORM_STEPS 8 /* of Newton's method, at most, until the platform stands at the joints */
#define PLATFORM_DONE 1e-9 /* mm and rad */

/* What moves with a joint only; then platform of the simplified machine at a given joint (69 operations). */
static void early(double *w, const double *k)
{
    const double q = w[0];
    const double tx = w[1];
    const double ty = w[2];
    const double h = k[0];
    const double q0 = k[1];
    const double s7 = k[2];
    const double b1_x = k[3];
    const double b2_x = k[4];
    const double b2_y = k[5];
    const double A1_x = k[8];
    const double s116 = k[13];
    const double s124 = k[16];
    const double s130 = k[17];
    const double s134 = k[18];
    const double s138 = k[20];
    const double s153 = k[22];
    const double s156 = k[23];
    const double s160 = k[25];
    const double s195 = k[27];
    const double C_y = -h + ty;
    const double s8 = q + q0;
    const double r1_x = s7*sin(s8);
    const double r1_y = -s7*cos(s8);
    const double s22 = b1_x - tx;
    const double s29 = b2_x - tx;
    const double s31 = -C_y + b2_y;
    const double s185 = r1_x*s116 + r1_y*s130 + r1_y*s134 + s124;
    const double s190 = r1_x*s130 + r1_x*s134 - r1_y*s116 + s138;
    const double s198 = (r1_x * r1_x) + r1_x*s153 + r1_x*s156 + (r1_y * r1_y) + r1_y*s195 + s160;
    const double s201 = sqrt((s185 * s185) + (s190 * s190) - (s198 * s198));
    const double s204 = -s185*s198 + s190*s201;
    const double s208 = -s185*s201 - s190*s198;
    const double s211 = pow((s204 * s204) + (s208 * s208), -1.0/2.0);
    const double s214 = A1_x - C_y*s204*s211 + r1_x - s208*s211*s22;
    const double s217 = C_y*s208*s211 + r1_y - s204*s211*s22;
    const double s221 = 2*tan((1.0/2.0)*atan2(s204, s208));
    w[26] = s22;
    w[27] = C_y;
    w[28] = s29;
    w[29] = s31;
    w[30] = r1_x;
    w[31] = r1_y;
    w[32] = s214;
    w[33] = s217;
    w[34] = s221;
}

/* What else derivatives by joint and errors read of it (3 operations). */
static void more(double *w, const double *k)
{
    const double q = w[0];
    const double q0 = k[1];
    const double s8 = q + q0;
    const double s9 = sin(s8);
    const double s11 = cos(s8);
    w[38] = s9;
    w[39] = s11;
}

/* Equations of a limb, their derivatives by shift and turn of the platform (38 operations). */
static void rows(double *w, const double *k)
{
    const double px = w[4];
    const double py = w[5];
    const double R_11 = w[7];
    const double R_12 = w[8];
    const double R_21 = w[9];
    const double R_22 = w[10];
    const double s22 = w[26];
    const double C_y = w[27];
    const double s29 = w[28];
    const double s31 = w[29];
    const double r1_x = w[30];
    const double r1_y = w[31];
    const double A2_x = k[6];
    const double A2_y = k[7];
    const double A1_x = k[8];
    const double s71 = k[9];
    const double s23 = R_11*s22;
    const double s24 = -C_y*R_12;
    const double B1_x = px + s23 + s24;
    const double s26 = R_21*s22;
    const double s27 = -C_y*R_22;
    const double B1_y = py + s26 + s27;
    const double s30 = R_11*s29;
    const double s32 = R_12*s31;
    const double B2_x = px + s30 + s32;
    const double s34 = R_21*s29;
    const double s35 = R_22*s31;
    const double B2_y = py + s34 + s35;
    const double r2_x = -A2_x + B2_x;
    const double r2_y = -A2_y + B2_y;
    const double s39 = -A1_x + B1_x - r1_x;
    const double s54 = B1_y - r1_y;
    const double s72 = (1.0/2.0)*(r2_x * r2_x) + (1.0/2.0)*(r2_y * r2_y) + s71;
    const double s222 = -s26 - s27;
    const double s223 = s23 + s24;
    const double s228 = r2_x*(-s34 - s35) + r2_y*(s30 + s32);
    w[11] = s39;
    w[12] = 1;
    w[13] = 0;
    w[14] = s222;
    w[16] = s54;
    w[17] = 0;
    w[18] = 1;
    w[19] = s223;
    w[21] = s72;
    w[22] = r2_x;
    w[23] = r2_y;
    w[24] = s228;
}

/* Derivatives of a limb's equations by its joint (1 operations). */
static void joints_of_rows(double *w, const double *k)
{
    const double r1_x = w[30];
    const double r1_y = w[31];
    (void)(k);
    w[15] = r1_y;
    w[20] = -r1_x;
    w[25] = 0;
}

/* Newton's step of the platform; how far the equations are from dependent (77 operations). */
static void step(double *w)
{
    const double F00 = w[11];
    const double J00_0 = w[12];
    const double J00_1 = w[13];
    const double J00_2 = w[14];
    const double F01 = w[16];
    const double J01_0 = w[17];
    const double J01_1 = w[18];
    const double J01_2 = w[19];
    const double F02 = w[21];
    const double J02_0 = w[22];
    const double J02_1 = w[23];
    const double J02_2 = w[24];
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
    w[67] = u_00;
    w[68] = u_10;
    w[69] = u_20;
    w[70] = s67;
}

/* Minus the inverse of the derivatives, row by row; how far the equations are from dependent (71 operations). */
static void inverse_of_rows(double *w)
{
    const double J00_0 = w[12];
    const double J00_1 = w[13];
    const double J00_2 = w[14];
    const double J01_0 = w[17];
    const double J01_1 = w[18];
    const double J01_2 = w[19];
    const double J02_0 = w[22];
    const double J02_1 = w[23];
    const double J02_2 = w[24];
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
    w[72] = -G_inv_00;
    w[73] = -G_inv_01;
    w[74] = -G_inv_02;
    w[75] = -G_inv_10;
    w[76] = -G_inv_11;
    w[77] = -G_inv_12;
    w[78] = -G_inv_20;
    w[79] = -G_inv_21;
    w[80] = -G_inv_22;
    w[81] = s67;
}

/* The platform after a step, and its rotation matrix (20 operations). */
static void place(double *w)
{
    const double px = w[4];
    const double py = w[5];
    const double cz = w[6];
    const double y0 = w[67];
    const double y1 = w[68];
    const double y2 = w[69];
    const double going = w[71];
    const double new_00 = -going*y0 + px;
    const double new_10 = -going*y1 + py;
    const double new_20 = cz - going*y2*((1.0/4.0)*(cz * cz) + 1);
    const double s9 = (new_20 * new_20);
    const double s12 = 1.0/((1.0/4.0)*s9 + 1);
    const double s14 = -1.0/2.0*s12*s9 + 1;
    const double s15 = -new_20*s12;
    w[4] = new_00;
    w[5] = new_10;
    w[6] = new_20;
    w[7] = s14;
    w[8] = s15;
    w[9] = -s15;
    w[10] = s14;
}

/* How the platform moves with each joint, and how it does (18 operations). */
static void move(const double *w, const double *d, double *s)
{
    const double M_0_0 = w[72];
    const double M_0_1 = w[73];
    const double M_0_2 = w[74];
    const double M_1_0 = w[75];
    const double M_1_1 = w[76];
    const double M_1_2 = w[77];
    const double M_2_0 = w[78];
    const double M_2_1 = w[79];
    const double M_2_2 = w[80];
    const double q_t_0 = d[0];
    const double Q_0 = w[15];
    const double Q_1 = w[20];
    const double Q_2 = w[25];
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

/* Second derivatives of a limb's equations by time where nothing accelerates (64 operations). */
static void curved(const double *w, double *d, const double *s, const double *k, const double *gravity, const double *shares)
{
    const double q = w[0];
    const double tx = w[1];
    const double ty = w[2];
    const double px = w[4];
    const double py = w[5];
    const double R_11 = w[7];
    const double R_12 = w[8];
    const double R_21 = w[9];
    const double R_22 = w[10];
    const double v_px = s[3];
    const double v_py = s[4];
    const double w_z = s[5];
    const double q_t = d[0];
    const double h = k[0];
    const double q0 = k[1];
    const double b1_x = k[2];
    const double b2_x = k[3];
    const double b2_y = k[4];
    const double A2_x = k[5];
    const double A2_y = k[6];
    const double s7 = k[7];
    const double C_y = -h + ty;
    const double s8 = q + q0;
    const double s13 = b1_x - tx;
    const double s20 = b2_x - tx;
    const double s22 = -C_y + b2_y;
    const double B2_x = R_11*s20 + R_12*s22 + px;
    const double B2_y = R_21*s20 + R_22*s22 + py;
    const double r2_x = -A2_x + B2_x;
    const double r2_y = -A2_y + B2_y;
    const double s40 = -R_21*w_z;
    const double s41 = -R_22*w_z;
    const double s42 = R_11*w_z;
    const double s43 = R_12*w_z;
    const double s56 = s20*s40 + s22*s41 + v_px;
    const double s59 = s20*s42 + s22*s43 + v_py;
    const double s69 = -s42*w_z;
    const double s70 = -s43*w_z;
    const double s71 = s40*w_z;
    const double s72 = s41*w_z;
    const double s89 = -C_y*s70 + (q_t * q_t)*s7*sin(s8) + s13*s69;
    const double s90 = -C_y*s72 - (q_t * q_t)*s7*cos(s8) + s13*s71;
    const double s100 = r2_y*(s20*s71 + s22*s72) + (s59 * s59);
    const double s101 = r2_x*(s20*s69 + s22*s70) + s100 + (s56 * s56);
    (void)(gravity);
    (void)(shares);
    d[2] = s89;
    d[3] = s90;
    d[4] = s101;
}

/* The platform's acceleration (21 operations). */
static void accelerate(const double *w, const double *d, double *s)
{
    const double M_0_0 = w[72];
    const double M_0_1 = w[73];
    const double M_0_2 = w[74];
    const double M_1_0 = w[75];
    const double M_1_1 = w[76];
    const double M_1_2 = w[77];
    const double M_2_0 = w[78];
    const double M_2_1 = w[79];
    const double M_2_2 = w[80];
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

/* Gravity less acceleration of the points of a limb (58 operations). */
static void limb_fields(const double *w, double *d, const double *s, const double *k, const double *gravity, const double *shares)
{
    const double q = w[0];
    const double tx = w[1];
    const double ty = w[2];
    const double R_11 = w[7];
    const double R_12 = w[8];
    const double R_21 = w[9];
    const double R_22 = w[10];
    const double w_z = s[5];
    const double v_px_t = s[6];
    const double v_py_t = s[7];
    const double w_z_t = s[8];
    const double q_t = d[0];
    const double q_tt = d[1];
    const double gx = gravity[0];
    const double gy = gravity[1];
    const double h = k[0];
    const double q0 = k[1];
    const double b2_x = k[3];
    const double b2_y = k[4];
    const double s7 = k[7];
    const double C_y = -h + ty;
    const double s8 = q + q0;
    const double s9 = sin(s8);
    const double s11 = cos(s8);
    const double s20 = b2_x - tx;
    const double s22 = -C_y + b2_y;
    const double s337 = s22*(-R_12*(w_z * w_z) - R_22*w_z_t);
    const double s338 = s20*(-R_11*(w_z * w_z) - R_21*w_z_t) + s337 + v_px_t;
    const double s341 = s20*(R_11*w_z_t - R_21*(w_z * w_z)) + s22*(R_12*w_z_t - R_22*(w_z * w_z)) + v_py_t;
    const double s535 = -1.0/1000.0*s7*(-(q_t * q_t)*s9 + q_tt*s11);
    const double s536 = gx + s535;
    const double s537 = (1.0/1000.0)*s7*(-(q_t * q_t)*s11 - q_tt*s9);
    const double s538 = gy + s537;
    const double s539 = gx - s535;
    const double s540 = gy - s537;
    const double s542 = gx - 1.0/2000.0*s338;
    const double s544 = gy - 1.0/2000.0*s341;
    const double s546 = gx - 1.0/1000.0*s338;
    const double s548 = gy - 1.0/1000.0*s341;
    (void)(shares);
    d[8] = s536;
    d[9] = s538;
    d[11] = s539;
    d[12] = s540;
    d[17] = s542;
    d[18] = s544;
    d[20] = s546;
    d[21] = s548;
}

/* Loads per inertial parameter of a limb, along joint, shifts and turns (49 operations). */
static void limb_asks(const double *w, double *d, const double *s, const double *k, const double *gravity, const double *shares)
{
    const double q = w[0];
    const double tx = w[1];
    const double ty = w[2];
    const double R_11 = w[7];
    const double R_12 = w[8];
    const double R_21 = w[9];
    const double R_22 = w[10];
    const double share = shares[0];
    const double f1x = d[8];
    const double f1y = d[9];
    const double f2x = d[11];
    const double f2y = d[12];
    const double f4x = d[17];
    const double f4y = d[18];
    const double f5x = d[20];
    const double f5y = d[21];
    const double h = k[0];
    const double q0 = k[1];
    const double b2_x = k[3];
    const double b2_y = k[4];
    const double s7 = k[7];
    const double s110 = k[8];
    const double s142 = k[9];
    const double C_y = -h + ty;
    const double s8 = q + q0;
    const double s9 = sin(s8);
    const double s11 = cos(s8);
    const double s20 = b2_x - tx;
    const double s22 = -C_y + b2_y;
    const double s137 = s11*s7*(f1x*s110 + f2x*s110) + s7*s9*(f1y*s110 + f2y*s110);
    const double s161 = s11*s7*(f1x*s142 - f2x*s142) + s7*s9*(f1y*s142 - f2y*s142);
    const double s174 = 1 - 2*share;
    const double s201 = (1.0/2.0)*f4y*s174 + f5y*share;
    const double s206 = (1.0/2.0)*f4x*s174 + f5x*share;
    const double s218 = R_11*s20*s201 + R_12*s201*s22 - R_21*s20*s206 - R_22*s206*s22;
    (void)(s);
    (void)(gravity);
    d[23] = s137;
    d[24] = s161;
    d[25] = s206;
    d[26] = s201;
    d[27] = s218;
}

/* Gravity less acceleration of the points of a platform (37 operations). */
static void platform_fields(const double *w, const double *d, double *s, const double *gravity)
{
    const double tx = w[1];
    const double ty = w[2];
    const double R_11 = w[7];
    const double R_12 = w[8];
    const double R_21 = w[9];
    const double R_22 = w[10];
    const double w_z = s[5];
    const double v_px_t = s[6];
    const double v_py_t = s[7];
    const double w_z_t = s[8];
    const double gx = gravity[0];
    const double gy = gravity[1];
    const double s133 = -ty*(-R_12*(w_z * w_z) - R_22*w_z_t);
    const double s138 = -tx*(R_11*w_z_t - R_21*(w_z * w_z)) - ty*(R_12*w_z_t - R_22*(w_z * w_z)) + v_py_t;
    const double s168 = gx - 1.0/1000.0*s133 + (1.0/1000.0)*tx*(-R_11*(w_z * w_z) - R_21*w_z_t) - 1.0/1000.0*v_px_t;
    const double s170 = gy - 1.0/1000.0*s138;
    const double s172 = gx - 1.0/1000.0*v_px_t;
    const double s174 = gy - 1.0/1000.0*v_py_t;
    (void)(d);
    s[9] = s168;
    s[10] = s170;
    s[12] = s172;
    s[13] = s174;
}

/* Loads per inertial parameter of a platform, along joint, shifts and turns (11 operations). */
static void platform_asks(const double *w, const double *d, double *s)
{
    const double tx = w[1];
    const double ty = w[2];
    const double R_11 = w[7];
    const double R_12 = w[8];
    const double R_21 = w[9];
    const double R_22 = w[10];
    const double f0x = s[9];
    const double f0y = s[10];
    const double f1x = s[12];
    const double f1y = s[13];
    const double s53 = -R_11*f0y*tx - R_12*f0y*ty + R_21*f0x*tx + R_22*f0x*ty;
    (void)(d);
    s[15] = f0x;
    s[16] = f0y;
    s[17] = s53;
    s[18] = f1x;
    s[19] = f1y;
}

/* What the joints give (23 operations). */
static void give(const double *d, double *s, const double *inertia)
{
    const double a_0_0 = d[23];
    const double a_0_1 = d[24];
    const double a_0_2 = d[25];
    const double a_0_3 = d[26];
    const double a_0_4 = d[27];
    const double a_p_0 = s[15];
    const double a_p_1 = s[16];
    const double a_p_2 = s[17];
    const double a_p_3 = s[18];
    const double a_p_4 = s[19];
    const double V_0_0 = s[0];
    const double V_1_0 = s[1];
    const double V_2_0 = s[2];
    const double m_1 = inertia[1];
    const double m_2 = inertia[2];
    const double m_3 = inertia[3];
    const double m_4 = inertia[4];
    const double m_5 = inertia[5];
    const double W_0 = a_0_2*m_3 + a_p_0*m_4 + a_p_3*m_5;
    const double W_1 = a_0_3*m_3 + a_p_1*m_4 + a_p_4*m_5;
    const double W_2 = a_0_4*m_3 + a_p_2*m_4;
    const double s16 = -V_0_0*W_0 - V_1_0*W_1 - V_2_0*W_2 - a_0_0*m_1 - a_0_1*m_2;
    s[20] = s16;
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
    double w[86] = { 0.0 };
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
    w[71] = 1.0;
    place(w);
    for (steps = 0; steps < PLATFORM_STEPS; steps++) {
        double size = 0.0;
        for (i = 0; i < 1; i++)
            rows(w + LIMB_W * i, DELTACAL_MOTION_K[i]);
        step(w);
        place(w);
        for (c = 0; c < 3; c++)
            size = fmax(size, fabs(w[67 + c]));
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
    double d[LIMB_D * 1] = { 0.0 }, s[25] = { 0.0 };
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
        load = DELTACAL_SIGN[i] * s[20 + i];
        give(d, s, DELTACAL_PAYLOAD);
        carried = DELTACAL_SIGN[i] * s[20 + i] * payload_kg;
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

/*
 * Generated from derive/mechanisms/robotennis.py by "deltacal kernels". Do not edit.
 * Template templates/mechanism/dynamics.c.jinja; sha256 of both ebe2e45820cc0c4b; SymPy 1.14.0.
 *
 * The calibrated machine in motion: joints, their speeds and accelerations by those of the reference point, and what
 * the drives must give. w and d hold a region for each limb, w and s what all limbs share.
 */
#define LIMB_W 38
#define LIMB_D 27
#define PLATFORM_STEPS 8 /* of Newton's method, at most, until the platform stands at the joints */
#define PLATFORM_DONE 1e-9 /* mm and rad */

/* What moves with a joint only; then the simplified limb as a sphere |P|^2 - 2 c.P + d = 0: c, d (30 operations). */
static void early(double *w, const double *k)
{
    const double q = w[0];
    const double tx = w[1];
    const double ty = w[2];
    const double tz = w[3];
    const double theta0 = k[0];
    const double u_x = k[1];
    const double u_y = k[2];
    const double s11 = k[3];
    const double s14 = k[4];
    const double s16 = k[5];
    const double s20 = k[6];
    const double s22 = k[7];
    const double tip_v = k[8];
    const double pz0 = k[11];
    const double s96 = k[15];
    const double s98 = k[16];
    const double s100 = k[17];
    const double s102 = k[18];
    const double s45 = k[23];
    const double s6 = q + theta0;
    const double s7 = cos(s6);
    const double arm_x = s7*u_x;
    const double arm_y = s7*u_y;
    const double arm_z = sin(s6);
    const double B_x = arm_x*s11 + arm_z*s14 + s16;
    const double B_y = arm_y*s11 + arm_z*s20 + s22;
    const double s24 = arm_z*s11;
    const double B_z = s24 + s7*tip_v;
    const double s138 = -s7*s98 - s96 + tx;
    const double s140 = -s100 - s102*s7 + ty;
    const double s141 = -pz0 + s24 + tz;
    const double s145 = (s138 * s138) + (s140 * s140) + (s141 * s141) - s45;
    w[12] = B_x;
    w[13] = B_y;
    w[14] = B_z;
    w[15] = s138;
    w[16] = s140;
    w[17] = s141;
    w[18] = s145;
}

/* What else derivatives by joint and errors read of it (16 operations). */
static void more(double *w, const double *k)
{
    const double q = w[0];
    const double theta0 = k[0];
    const double u_x = k[1];
    const double u_y = k[2];
    const double s11 = k[3];
    const double s14 = k[4];
    const double s20 = k[6];
    const double tip_v = k[8];
    const double s98 = k[16];
    const double s102 = k[18];
    const double s6 = q + theta0;
    const double s7 = cos(s6);
    const double arm_x = s7*u_x;
    const double arm_y = s7*u_y;
    const double arm_z = sin(s6);
    const double s148 = -arm_z*s98 - s14*s7;
    const double s152 = -arm_z*s102 - s20*s7;
    const double s156 = arm_z*tip_v - s11*s7;
    w[20] = s7;
    w[21] = arm_z;
    w[22] = arm_y;
    w[23] = arm_x;
    w[24] = s148;
    w[25] = s152;
    w[26] = s156;
}

/* Equations of a limb, their derivatives by shift and turn of the platform (20 operations). */
static void rows(double *w, const double *k)
{
    const double tx = w[1];
    const double ty = w[2];
    const double tz = w[3];
    const double px = w[4];
    const double py = w[5];
    const double pz = w[6];
    const double B_x = w[12];
    const double B_y = w[13];
    const double B_z = w[14];
    const double px0 = k[9];
    const double py0 = k[10];
    const double pz0 = k[11];
    const double s31 = k[12];
    const double s33 = k[13];
    const double s46 = k[14];
    const double centre_x = px + px0 - tx;
    const double centre_y = py + py0 - ty;
    const double centre_z = pz + pz0 - tz;
    const double C_x = centre_x + s31;
    const double C_y = centre_y + s33;
    const double rod_x = -B_x + C_x;
    const double rod_y = -B_y + C_y;
    const double rod_z = -B_z + centre_z;
    const double s47 = (1.0/2.0)*(rod_x * rod_x) + (1.0/2.0)*(rod_y * rod_y) + (1.0/2.0)*(rod_z * rod_z) + s46;
    w[7] = s47;
    w[8] = rod_x;
    w[9] = rod_y;
    w[10] = rod_z;
}

/* Derivatives of a limb's equations by its joint (16 operations). */
static void joints_of_rows(double *w, const double *k)
{
    const double tx = w[1];
    const double ty = w[2];
    const double tz = w[3];
    const double px = w[4];
    const double py = w[5];
    const double pz = w[6];
    const double B_x = w[12];
    const double B_y = w[13];
    const double B_z = w[14];
    const double s148 = w[24];
    const double s152 = w[25];
    const double s156 = w[26];
    const double px0 = k[9];
    const double py0 = k[10];
    const double pz0 = k[11];
    const double s31 = k[12];
    const double s33 = k[13];
    const double centre_x = px + px0 - tx;
    const double centre_y = py + py0 - ty;
    const double centre_z = pz + pz0 - tz;
    const double C_x = centre_x + s31;
    const double C_y = centre_y + s33;
    const double rod_x = -B_x + C_x;
    const double rod_y = -B_y + C_y;
    const double rod_z = -B_z + centre_z;
    const double s158 = rod_x*s148 + rod_y*s152 + rod_z*s156;
    w[11] = s158;
}

/* Newton's step of the platform; how far the equations are from dependent (77 operations). */
static void step(double *w)
{
    const double F00 = w[7];
    const double J00_0 = w[8];
    const double J00_1 = w[9];
    const double J00_2 = w[10];
    const double F10 = w[45];
    const double J10_0 = w[46];
    const double J10_1 = w[47];
    const double J10_2 = w[48];
    const double F20 = w[83];
    const double J20_0 = w[84];
    const double J20_1 = w[85];
    const double J20_2 = w[86];
    const double G_cof_00 = J10_1*J20_2 - J10_2*J20_1;
    const double G_cof_01 = -J10_0*J20_2 + J10_2*J20_0;
    const double G_cof_02 = J10_0*J20_1 - J10_1*J20_0;
    const double G_cof_10 = -J00_1*J20_2 + J00_2*J20_1;
    const double G_cof_11 = J00_0*J20_2 - J00_2*J20_0;
    const double G_cof_12 = -J00_0*J20_1 + J00_1*J20_0;
    const double G_cof_20 = J00_1*J10_2 - J00_2*J10_1;
    const double G_cof_21 = -J00_0*J10_2 + J00_2*J10_0;
    const double G_cof_22 = J00_0*J10_1 - J00_1*J10_0;
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
    const double u_00 = F00*G_inv_00 + F10*G_inv_01 + F20*G_inv_02;
    const double u_10 = F00*G_inv_10 + F10*G_inv_11 + F20*G_inv_12;
    const double u_20 = F00*G_inv_20 + F10*G_inv_21 + F20*G_inv_22;
    const double s61 = (J10_0 * J10_0) + (J10_1 * J10_1) + (J10_2 * J10_2);
    const double s65 = (J20_0 * J20_0) + (J20_1 * J20_1) + (J20_2 * J20_2);
    const double s67 = (G_det_00 * G_det_00) - 9.9999999999999998e-13*s61*s65*((J00_0 * J00_0) + (J00_1 * J00_1) + (J00_2 * J00_2));
    w[114] = u_00;
    w[115] = u_10;
    w[116] = u_20;
    w[117] = s67;
}

/* Minus the inverse of the derivatives, row by row; how far the equations are from dependent (71 operations). */
static void inverse_of_rows(double *w)
{
    const double J00_0 = w[8];
    const double J00_1 = w[9];
    const double J00_2 = w[10];
    const double J10_0 = w[46];
    const double J10_1 = w[47];
    const double J10_2 = w[48];
    const double J20_0 = w[84];
    const double J20_1 = w[85];
    const double J20_2 = w[86];
    const double G_cof_00 = J10_1*J20_2 - J10_2*J20_1;
    const double G_cof_01 = -J10_0*J20_2 + J10_2*J20_0;
    const double G_cof_02 = J10_0*J20_1 - J10_1*J20_0;
    const double G_cof_10 = -J00_1*J20_2 + J00_2*J20_1;
    const double G_cof_11 = J00_0*J20_2 - J00_2*J20_0;
    const double G_cof_12 = -J00_0*J20_1 + J00_1*J20_0;
    const double G_cof_20 = J00_1*J10_2 - J00_2*J10_1;
    const double G_cof_21 = -J00_0*J10_2 + J00_2*J10_0;
    const double G_cof_22 = J00_0*J10_1 - J00_1*J10_0;
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
    const double s61 = (J10_0 * J10_0) + (J10_1 * J10_1) + (J10_2 * J10_2);
    const double s65 = (J20_0 * J20_0) + (J20_1 * J20_1) + (J20_2 * J20_2);
    const double s67 = (G_det_00 * G_det_00) - 9.9999999999999998e-13*s61*s65*((J00_0 * J00_0) + (J00_1 * J00_1) + (J00_2 * J00_2));
    w[119] = -G_inv_00;
    w[120] = -G_inv_01;
    w[121] = -G_inv_02;
    w[122] = -G_inv_10;
    w[123] = -G_inv_11;
    w[124] = -G_inv_12;
    w[125] = -G_inv_20;
    w[126] = -G_inv_21;
    w[127] = -G_inv_22;
    w[128] = s67;
}

/* The platform after a step, and its rotation matrix (6 operations). */
static void place(double *w)
{
    const double px = w[4];
    const double py = w[5];
    const double pz = w[6];
    const double y0 = w[114];
    const double y1 = w[115];
    const double y2 = w[116];
    const double going = w[118];
    const double new_00 = -going*y0 + px;
    const double new_10 = -going*y1 + py;
    const double new_20 = -going*y2 + pz;
    w[4] = new_00;
    w[42] = new_00;
    w[80] = new_00;
    w[5] = new_10;
    w[43] = new_10;
    w[81] = new_10;
    w[6] = new_20;
    w[44] = new_20;
    w[82] = new_20;
}

/* How the platform moves with each joint, and how it does (24 operations). */
static void move(const double *w, const double *d, double *s)
{
    const double M_0_0 = w[119];
    const double M_0_1 = w[120];
    const double M_0_2 = w[121];
    const double M_1_0 = w[122];
    const double M_1_1 = w[123];
    const double M_1_2 = w[124];
    const double M_2_0 = w[125];
    const double M_2_1 = w[126];
    const double M_2_2 = w[127];
    const double q_t_0 = d[0];
    const double Q_0 = w[11];
    const double q_t_1 = d[27];
    const double Q_1 = w[49];
    const double q_t_2 = d[54];
    const double Q_2 = w[87];
    const double V_0_0 = M_0_0*Q_0;
    const double V_0_1 = M_0_1*Q_1;
    const double V_0_2 = M_0_2*Q_2;
    const double V_1_0 = M_1_0*Q_0;
    const double V_1_1 = M_1_1*Q_1;
    const double V_1_2 = M_1_2*Q_2;
    const double V_2_0 = M_2_0*Q_0;
    const double V_2_1 = M_2_1*Q_1;
    const double V_2_2 = M_2_2*Q_2;
    const double s12 = V_0_0*q_t_0 + V_0_1*q_t_1 + V_0_2*q_t_2;
    const double s16 = V_1_0*q_t_0 + V_1_1*q_t_1 + V_1_2*q_t_2;
    const double s20 = V_2_0*q_t_0 + V_2_1*q_t_1 + V_2_2*q_t_2;
    s[0] = V_0_0;
    s[1] = V_0_1;
    s[2] = V_0_2;
    s[3] = V_1_0;
    s[4] = V_1_1;
    s[5] = V_1_2;
    s[6] = V_2_0;
    s[7] = V_2_1;
    s[8] = V_2_2;
    s[9] = s12;
    s[10] = s16;
    s[11] = s20;
}

/* Second derivatives of a limb's equations by time where nothing accelerates (69 operations). */
static void curved(const double *w, double *d, const double *s, const double *k, const double *gravity, const double *shares)
{
    const double q = w[0];
    const double tx = w[1];
    const double ty = w[2];
    const double tz = w[3];
    const double px = w[4];
    const double py = w[5];
    const double pz = w[6];
    const double v_px = s[9];
    const double v_py = s[10];
    const double v_pz = s[11];
    const double q_t = d[0];
    const double theta0 = k[0];
    const double u_x = k[1];
    const double u_y = k[2];
    const double s11 = k[3];
    const double s14 = k[4];
    const double s16 = k[5];
    const double s20 = k[6];
    const double s22 = k[7];
    const double tip_v = k[8];
    const double px0 = k[9];
    const double py0 = k[10];
    const double pz0 = k[11];
    const double s31 = k[12];
    const double s33 = k[13];
    const double s6 = q + theta0;
    const double s7 = cos(s6);
    const double arm_x = s7*u_x;
    const double arm_y = s7*u_y;
    const double arm_z = sin(s6);
    const double B_x = arm_x*s11 + arm_z*s14 + s16;
    const double B_y = arm_y*s11 + arm_z*s20 + s22;
    const double B_z = arm_z*s11 + s7*tip_v;
    const double centre_x = px + px0 - tx;
    const double centre_y = py + py0 - ty;
    const double centre_z = pz + pz0 - tz;
    const double C_x = centre_x + s31;
    const double C_y = centre_y + s33;
    const double rod_x = -B_x + C_x;
    const double rod_y = -B_y + C_y;
    const double rod_z = -B_z + centre_z;
    const double s48 = -arm_z*q_t;
    const double s51 = q_t*s7;
    const double s61 = -s11*s48*u_x - s14*s51 + v_px;
    const double s62 = -s11*s48*u_y - s20*s51 + v_py;
    const double s63 = -s11*s51 - s48*tip_v + v_pz;
    const double s74 = -q_t*s51;
    const double s77 = q_t*s48;
    const double s96 = -rod_y*(s11*s74*u_y + s20*s77) + (s62 * s62);
    const double s101 = -rod_z*(s11*s77 + s74*tip_v) + (s63 * s63);
    const double s102 = -rod_x*(s11*s74*u_x + s14*s77) + s101 + (s61 * s61) + s96;
    (void)(gravity);
    (void)(shares);
    d[2] = s102;
}

/* The platform's acceleration (33 operations). */
static void accelerate(const double *w, const double *d, double *s)
{
    const double M_0_0 = w[119];
    const double M_0_1 = w[120];
    const double M_0_2 = w[121];
    const double M_1_0 = w[122];
    const double M_1_1 = w[123];
    const double M_1_2 = w[124];
    const double M_2_0 = w[125];
    const double M_2_1 = w[126];
    const double M_2_2 = w[127];
    const double q_tt_0 = d[1];
    const double c_0 = d[2];
    const double q_tt_1 = d[28];
    const double c_1 = d[29];
    const double q_tt_2 = d[55];
    const double c_2 = d[56];
    const double V_0_0 = s[0];
    const double V_0_1 = s[1];
    const double V_0_2 = s[2];
    const double V_1_0 = s[3];
    const double V_1_1 = s[4];
    const double V_1_2 = s[5];
    const double V_2_0 = s[6];
    const double V_2_1 = s[7];
    const double V_2_2 = s[8];
    const double s6 = M_0_0*c_0 + M_0_1*c_1 + M_0_2*c_2 + V_0_0*q_tt_0 + V_0_1*q_tt_1 + V_0_2*q_tt_2;
    const double s13 = M_1_0*c_0 + M_1_1*c_1 + M_1_2*c_2 + V_1_0*q_tt_0 + V_1_1*q_tt_1 + V_1_2*q_tt_2;
    const double s20 = M_2_0*c_0 + M_2_1*c_1 + M_2_2*c_2 + V_2_0*q_tt_0 + V_2_1*q_tt_1 + V_2_2*q_tt_2;
    s[12] = s6;
    s[13] = s13;
    s[14] = s20;
}

/* Gravity less acceleration of the points of a limb (59 operations). */
static void limb_fields(const double *w, double *d, const double *s, const double *k, const double *gravity, const double *shares)
{
    const double q = w[0];
    const double v_px_t = s[12];
    const double v_py_t = s[13];
    const double v_pz_t = s[14];
    const double q_t = d[0];
    const double q_tt = d[1];
    const double gx = gravity[0];
    const double gy = gravity[1];
    const double gz = gravity[2];
    const double theta0 = k[0];
    const double u_x = k[1];
    const double u_y = k[2];
    const double s11 = k[3];
    const double s14 = k[4];
    const double s20 = k[6];
    const double tip_v = k[8];
    const double s6 = q + theta0;
    const double s7 = cos(s6);
    const double arm_z = sin(s6);
    const double s412 = -arm_z*q_tt - (q_t * q_t)*s7;
    const double s416 = -arm_z*(q_t * q_t) + q_tt*s7;
    const double s417 = s11*s412*u_x;
    const double s419 = s14*s416 + s417;
    const double s420 = s11*s412*u_y;
    const double s422 = s20*s416 + s420;
    const double s423 = s11*s416;
    const double s425 = s412*tip_v + s423;
    const double s635 = -1.0/1000.0*s417;
    const double s636 = gx + s635;
    const double s637 = -1.0/1000.0*s420;
    const double s638 = gy + s637;
    const double s639 = -1.0/1000.0*s423;
    const double s640 = gz + s639;
    const double s641 = gx - s635;
    const double s642 = gy - s637;
    const double s643 = gz - s639;
    const double s645 = gx - 1.0/1000.0*s419;
    const double s647 = gy - 1.0/1000.0*s422;
    const double s649 = gz - 1.0/1000.0*s425;
    const double s651 = gx - 1.0/2000.0*s419 - 1.0/2000.0*v_px_t;
    const double s653 = gy - 1.0/2000.0*s422 - 1.0/2000.0*v_py_t;
    const double s655 = gz - 1.0/2000.0*s425 - 1.0/2000.0*v_pz_t;
    const double s657 = gx - 1.0/1000.0*v_px_t;
    const double s659 = gy - 1.0/1000.0*v_py_t;
    const double s661 = gz - 1.0/1000.0*v_pz_t;
    (void)(shares);
    d[6] = s636;
    d[7] = s638;
    d[8] = s640;
    d[9] = s641;
    d[10] = s642;
    d[11] = s643;
    d[12] = s645;
    d[13] = s647;
    d[14] = s649;
    d[15] = s651;
    d[16] = s653;
    d[17] = s655;
    d[18] = s657;
    d[19] = s659;
    d[20] = s661;
}

/* Loads per inertial parameter of a limb, along joint, shifts and turns (77 operations). */
static void limb_asks(const double *w, double *d, const double *s, const double *k, const double *gravity, const double *shares)
{
    const double q = w[0];
    const double share = shares[0];
    const double f1x = d[6];
    const double f1y = d[7];
    const double f1z = d[8];
    const double f2x = d[9];
    const double f2y = d[10];
    const double f2z = d[11];
    const double f3x = d[12];
    const double f3y = d[13];
    const double f3z = d[14];
    const double f4x = d[15];
    const double f4y = d[16];
    const double f4z = d[17];
    const double f5x = d[18];
    const double f5y = d[19];
    const double f5z = d[20];
    const double theta0 = k[0];
    const double u_x = k[1];
    const double u_y = k[2];
    const double s11 = k[3];
    const double s14 = k[4];
    const double s20 = k[6];
    const double tip_v = k[8];
    const double s109 = k[14];
    const double s162 = k[15];
    const double s6 = q + theta0;
    const double s7 = cos(s6);
    const double arm_z = sin(s6);
    const double s125 = -f2z*s11;
    const double s134 = f1z*s11;
    const double s154 = s11*u_x*(f1x*s109 + f2x*s109) + s11*u_y*(f1y*s109 + f2y*s109);
    const double s156 = -arm_z*s154 + s7*(-s109*s125 + s109*s134);
    const double s191 = s11*u_x*(f1x*s162 - f2x*s162) + s11*u_y*(f1y*s162 - f2y*s162);
    const double s193 = -arm_z*s191 + s7*(s125*s162 + s134*s162);
    const double s199 = 2 - 4*share;
    const double s225 = 2*share;
    const double s242 = (1.0/2.0)*f4z*s199;
    const double s245 = (1.0/2.0)*f4y*s199;
    const double s248 = (1.0/2.0)*f4x*s199;
    const double s250 = f5y*s225 + s245;
    const double s251 = f5x*s225 + s248;
    const double s252 = f5z*s225 + s242;
    const double s253 = f3z*s225 + s242;
    const double s258 = f3y*s225 + s245;
    const double s263 = f3x*s225 + s248;
    const double s275 = -arm_z*(s11*s258*u_y + s11*s263*u_x + s253*tip_v);
    const double s276 = s275 + s7*(s11*s253 + s14*s263 + s20*s258);
    (void)(s);
    (void)(gravity);
    d[21] = s156;
    d[22] = s193;
    d[23] = s276;
    d[24] = s251;
    d[25] = s250;
    d[26] = s252;
}

/* Gravity less acceleration of the points of a platform (6 operations). */
static void platform_fields(const double *w, const double *d, double *s, const double *gravity)
{
    const double v_px_t = s[12];
    const double v_py_t = s[13];
    const double v_pz_t = s[14];
    const double gx = gravity[0];
    const double gy = gravity[1];
    const double gz = gravity[2];
    const double s102 = gx - 1.0/1000.0*v_px_t;
    const double s104 = gy - 1.0/1000.0*v_py_t;
    const double s106 = gz - 1.0/1000.0*v_pz_t;
    (void)(w);
    (void)(d);
    s[15] = s102;
    s[16] = s104;
    s[17] = s106;
    s[18] = s102;
    s[19] = s104;
    s[20] = s106;
}

/* Loads per inertial parameter of a platform, along joint, shifts and turns (0 operations). */
static void platform_asks(const double *w, const double *d, double *s)
{
    const double f0x = s[15];
    const double f0y = s[16];
    const double f0z = s[17];
    const double f1x = s[18];
    const double f1y = s[19];
    const double f1z = s[20];
    (void)(w);
    (void)(d);
    s[21] = f0x;
    s[22] = f0y;
    s[23] = f0z;
    s[24] = f1x;
    s[25] = f1y;
    s[26] = f1z;
}

/* What the joints give (63 operations). */
static void give(const double *d, double *s, const double *inertia)
{
    const double a_0_0 = d[21];
    const double a_0_1 = d[22];
    const double a_0_2 = d[23];
    const double a_0_3 = d[24];
    const double a_0_4 = d[25];
    const double a_0_5 = d[26];
    const double a_1_0 = d[48];
    const double a_1_1 = d[49];
    const double a_1_2 = d[50];
    const double a_1_3 = d[51];
    const double a_1_4 = d[52];
    const double a_1_5 = d[53];
    const double a_2_0 = d[75];
    const double a_2_1 = d[76];
    const double a_2_2 = d[77];
    const double a_2_3 = d[78];
    const double a_2_4 = d[79];
    const double a_2_5 = d[80];
    const double a_p_0 = s[21];
    const double a_p_1 = s[22];
    const double a_p_2 = s[23];
    const double a_p_3 = s[24];
    const double a_p_4 = s[25];
    const double a_p_5 = s[26];
    const double V_0_0 = s[0];
    const double V_0_1 = s[1];
    const double V_0_2 = s[2];
    const double V_1_0 = s[3];
    const double V_1_1 = s[4];
    const double V_1_2 = s[5];
    const double V_2_0 = s[6];
    const double V_2_1 = s[7];
    const double V_2_2 = s[8];
    const double m_1 = inertia[1];
    const double m_2 = inertia[2];
    const double m_3 = inertia[3];
    const double m_5 = inertia[5];
    const double m_6 = inertia[6];
    const double m_7 = inertia[7];
    const double m_9 = inertia[9];
    const double m_10 = inertia[10];
    const double m_11 = inertia[11];
    const double m_12 = inertia[12];
    const double m_13 = inertia[13];
    const double W_0 = a_0_3*m_3 + a_1_3*m_7 + a_2_3*m_11 + a_p_0*m_12 + a_p_3*m_13;
    const double W_1 = a_0_4*m_3 + a_1_4*m_7 + a_2_4*m_11 + a_p_1*m_12 + a_p_4*m_13;
    const double W_2 = a_0_5*m_3 + a_1_5*m_7 + a_2_5*m_11 + a_p_2*m_12 + a_p_5*m_13;
    const double s24 = -V_0_0*W_0 - V_1_0*W_1 - V_2_0*W_2 - a_0_0*m_1 - a_0_1*m_2 - a_0_2*m_3;
    const double s31 = -V_0_1*W_0 - V_1_1*W_1 - V_2_1*W_2 - a_1_0*m_5 - a_1_1*m_6 - a_1_2*m_7;
    const double s38 = -V_0_2*W_0 - V_1_2*W_1 - V_2_2*W_2 - a_2_0*m_9 - a_2_1*m_10 - a_2_2*m_11;
    s[27] = s24;
    s[28] = s31;
    s[29] = s38;
}

/* Solve A x = b in place; 0 where A is singular. */
static int solve(double A[3][3], double b[3])
{
    double largest = 0.0;
    int i, j, c;
    for (i = 0; i < 3; i++)
        for (j = 0; j < 3; j++)
            largest = fmax(largest, fabs(A[i][j]));
    for (c = 0; c < 3; c++) {
        int pivot = c;
        for (i = c + 1; i < 3; i++)
            if (fabs(A[i][c]) > fabs(A[pivot][c]))
                pivot = i;
        if (!(fabs(A[pivot][c]) > 1e-9 * largest))
            return 0;
        for (j = 0; j < 3; j++) {
            const double swap = A[c][j];
            A[c][j] = A[pivot][j];
            A[pivot][j] = swap;
        }
        {
            const double swap = b[c];
            b[c] = b[pivot];
            b[pivot] = swap;
        }
        for (i = c + 1; i < 3; i++) {
            const double factor = A[i][c] / A[c][c];
            for (j = c; j < 3; j++)
                A[i][j] -= factor * A[c][j];
            b[i] -= factor * b[c];
        }
    }
    for (c = 2; c >= 0; c--) {
        for (j = c + 1; j < 3; j++)
            b[c] -= A[c][j] * b[j];
        b[c] /= A[c][c];
    }
    return 1;
}

/* Solve how fast the joints move the commanded coordinates as asked. */
static int joint_rates(const double *s, double rates[3])
{
    double A[3][3];
    int i, c;
    for (c = 0; c < 3; c++)
        for (i = 0; i < 3; i++)
            A[c][i] = s[0 + 3 * c + i];
    return solve(A, rates);
}

/*
 * Set the machine in motion: q the joints as the geometry counts them, velocity and acceleration those of the commanded
 * coordinates. Fills the joints' speeds and accelerations; asks of all bodies then stand in d and s.
 */
static int in_motion(const double *target, const double *velocity, const double *acceleration, const double *q,
                     double *qd, double *qdd, double *d, double *s)
{
    double w[135] = { 0.0 };
    int i, c, steps;
    for (i = 0; i < 3; i++) {
        w[LIMB_W * i + 0] = q[i];
        for (c = 0; c < 3; c++)
            w[LIMB_W * i + 1 + c] = DELTACAL_TOOL[c];
        for (c = 0; c < 3; c++)
            w[LIMB_W * i + 4 + c] = c < 3 ? target[c] : 0.0;
        early(w + LIMB_W * i, DELTACAL_MOTION_K[i]);
        more(w + LIMB_W * i, DELTACAL_MOTION_K[i]);
    }
    w[118] = 1.0;
    place(w);
    for (steps = 0; steps < PLATFORM_STEPS; steps++) {
        double size = 0.0;
        for (i = 0; i < 3; i++)
            rows(w + LIMB_W * i, DELTACAL_MOTION_K[i]);
        step(w);
        place(w);
        for (c = 0; c < 3; c++)
            size = fmax(size, fabs(w[114 + c]));
        if (size < PLATFORM_DONE)
            break;
    }
    if (steps == PLATFORM_STEPS)
        return DELTACAL_SINGULAR;
    for (i = 0; i < 3; i++) {
        rows(w + LIMB_W * i, DELTACAL_MOTION_K[i]);
        joints_of_rows(w + LIMB_W * i, DELTACAL_MOTION_K[i]);
        d[LIMB_D * i + 0] = d[LIMB_D * i + 1] = 0.0;
    }
    inverse_of_rows(w);
    move(w, d, s);
    for (c = 0; c < 3; c++)
        qd[c] = velocity[c];
    if (!joint_rates(s, qd))
        return DELTACAL_SINGULAR;
    for (i = 0; i < 3; i++)
        d[LIMB_D * i + 0] = qd[i];
    move(w, d, s);
    for (i = 0; i < 3; i++)
        curved(w + LIMB_W * i, d + LIMB_D * i, s, DELTACAL_BODY_K[i], DELTACAL_GRAVITY, DELTACAL_SHARES + i);
    accelerate(w, d, s); /* of joints that do not accelerate */
    for (c = 0; c < 3; c++)
        qdd[c] = acceleration[c] - s[12 + c];
    if (!joint_rates(s, qdd))
        return DELTACAL_SINGULAR;
    for (i = 0; i < 3; i++)
        d[LIMB_D * i + 1] = qdd[i];
    accelerate(w, d, s);
    for (i = 0; i < 3; i++) {
        limb_fields(w + LIMB_W * i, d + LIMB_D * i, s, DELTACAL_BODY_K[i], DELTACAL_GRAVITY, DELTACAL_SHARES + i);
        limb_asks(w + LIMB_W * i, d + LIMB_D * i, s, DELTACAL_BODY_K[i], DELTACAL_GRAVITY, DELTACAL_SHARES + i);
    }
    platform_fields(w, d, s, DELTACAL_GRAVITY);
    platform_asks(w, d, s);
    return DELTACAL_SOLVED;
}

int deltacal_feedforward(struct deltacal_motion *held, const double target_mm[3],
                         const double velocity_mm_s[3], const double acceleration_mm_s2[3],
                         double payload_kg, double temp_C)
{
    double past[DELTACAL_PAST + 1] = { 0.0 }, h; /* since the last set point [s] */
    double x[3], speed[3], change[3]; /* of turns: Cayley vector, rad/s, rad/s^2 */
    double q[3], qd[3], qdd[3], joints[3], torque[3];
    double d[LIMB_D * 3] = { 0.0 }, s[48] = { 0.0 };
    int i, status, limited = 0;
    for (i = 0; i < 3; i++)
        if (!isfinite(target_mm[i]) || !isfinite(velocity_mm_s[i]) || !isfinite(acceleration_mm_s2[i]))
            return DELTACAL_NOT_A_NUMBER;
    if (!isfinite(payload_kg) || !isfinite(temp_C))
        return DELTACAL_NOT_A_NUMBER;
    status = deltacal_compensate(target_mm, joints);
    if (status != DELTACAL_SOLVED)
        return status;
    for (i = 0; i < 3; i++) {
        if (held->begun && !(fabs(joints[i] - held->joints_deg[i]) <= DELTACAL_MOST_SPEED[i] * held->period_s))
            return DELTACAL_JUMP;
        q[i] = DELTACAL_SIGN[i] * joints[i] / JOINT_PER_UNIT;
    }
    for (i = 0; i < 3; i++) {
        x[i] = target_mm[i];
        speed[i] = velocity_mm_s[i];
        change[i] = acceleration_mm_s2[i];
    }
    status = in_motion(x, speed, change, q, qd, qdd, d, s);
    if (status != DELTACAL_SOLVED)
        return status;
    recall(held, past);
    h = held->begun ? held->period_s : 0.0;
    for (i = 0; i < 3; i++) {
        double load, carried;
        give(d, s, DELTACAL_INERTIA[i]);
        load = DELTACAL_SIGN[i] * s[27 + i];
        give(d, s, DELTACAL_PAYLOAD);
        carried = DELTACAL_SIGN[i] * s[27 + i] * payload_kg;
        torque[i] = deltacal_drive(past, h, i, DELTACAL_SIGN[i] * q[i], DELTACAL_SIGN[i] * qd[i],
                                   DELTACAL_SIGN[i] * qdd[i], load + DELTACAL_PAYLOAD_LOADS[i] * carried, temp_C);
        torque[i] /= DELTACAL_READ[i];
        if (!isfinite(torque[i]))
            return DELTACAL_SINGULAR;
    }
    for (i = 0; i < 3; i++) {
        held->joints_deg[i] = joints[i];
        held->torque[i] = fmin(fmax(torque[i], DELTACAL_TORQUE_LOW[i]), DELTACAL_TORQUE_HIGH[i]);
        limited |= held->torque[i] != torque[i];
    }
    keep(held, past);
    held->begun = 1;
    return limited ? DELTACAL_LIMITED : DELTACAL_SOLVED;
}

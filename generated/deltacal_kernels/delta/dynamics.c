/*
 * Generated from derive/mechanisms/delta.py by "deltacal kernels". Do not edit.
 * Template templates/mechanism/dynamics.c.jinja; sha256 of both 60410f6b3e056e42; SymPy 1.14.0.
 *
 * The calibrated machine in motion: joints, their speeds and accelerations by those of the reference point, and what
 * the drives must give. w and d hold a region for each limb, w and s what all limbs share.
 */
#define LIMB_W 94
#define LIMB_D 40
#define PLATFORM_STEPS 8 /* of Newton's method, at most, until the platform stands at the joints */
#define PLATFORM_DONE 1e-9 /* mm and rad */

/* What moves with a joint only; then the simplified limb as a sphere |P|^2 - 2 c.P + d = 0: c, d (62 operations). */
static void early(double *w, const double *k)
{
    const double q = w[0];
    const double tx = w[1];
    const double ty = w[2];
    const double tz = w[3];
    const double theta = k[0];
    const double R0_11 = k[1];
    const double R0_12 = k[2];
    const double R0_21 = k[3];
    const double R0_22 = k[4];
    const double R0_31 = k[5];
    const double R0_32 = k[6];
    const double s219 = k[7];
    const double tip_v = k[8];
    const double s223 = k[9];
    const double s228 = k[10];
    const double s233 = k[11];
    const double s235 = k[12];
    const double s238 = k[13];
    const double g_x = k[14];
    const double g_y = k[15];
    const double s253 = k[16];
    const double s257 = k[17];
    const double s261 = k[18];
    const double s1166 = k[24];
    const double s1168 = k[25];
    const double s1170 = k[26];
    const double s1172 = k[27];
    const double ez = k[28];
    const double s1184 = k[84];
    const double s163 = q + theta;
    const double s164 = cos(s163);
    const double s166 = sin(s163);
    const double R1_11 = R0_11*s164 + R0_12*s166;
    const double R1_12 = -R0_11*s166 + R0_12*s164;
    const double R1_21 = R0_21*s164 + R0_22*s166;
    const double R1_22 = -R0_21*s166 + R0_22*s164;
    const double R1_31 = R0_31*s164 + R0_32*s166;
    const double R1_32 = -R0_31*s166 + R0_32*s164;
    const double C_x = R1_11*s219 + R1_12*tip_v + s223;
    const double C_y = R1_21*s219 + R1_22*tip_v + s228;
    const double C_z = R1_31*s219 + R1_32*tip_v + s233;
    const double s236 = s235 - tx;
    const double s239 = s238 - ty;
    const double c1_x = R1_11*g_x + R1_12*g_y + s253;
    const double c1_y = R1_21*g_x + R1_22*g_y + s257;
    const double c1_z = R1_31*g_x + R1_32*g_y + s261;
    const double s1212 = -s1166 - s1168*s164 + tx;
    const double s1214 = -s1170 - s1172*s164 + ty;
    const double s1216 = ez + s166*s219 + tz;
    const double s1220 = -s1184 + (s1212 * s1212) + (s1214 * s1214) + (s1216 * s1216);
    w[35] = s236;
    w[36] = s239;
    w[37] = C_x;
    w[38] = C_y;
    w[39] = C_z;
    w[40] = c1_x;
    w[41] = c1_y;
    w[42] = c1_z;
    w[43] = s1212;
    w[44] = s1214;
    w[45] = s1216;
    w[46] = s1220;
}

/* What else derivatives by joint and errors read of it (39 operations). */
static void more(double *w, const double *k)
{
    const double q = w[0];
    const double theta = k[0];
    const double R0_11 = k[1];
    const double R0_12 = k[2];
    const double R0_21 = k[3];
    const double R0_22 = k[4];
    const double R0_31 = k[5];
    const double R0_32 = k[6];
    const double s219 = k[7];
    const double tip_v = k[8];
    const double g_x = k[14];
    const double g_y = k[15];
    const double s163 = q + theta;
    const double s164 = cos(s163);
    const double s166 = sin(s163);
    const double R1_11 = R0_11*s164 + R0_12*s166;
    const double R1_12 = -R0_11*s166 + R0_12*s164;
    const double R1_21 = R0_21*s164 + R0_22*s166;
    const double R1_22 = -R0_21*s166 + R0_22*s164;
    const double R1_31 = R0_31*s164 + R0_32*s166;
    const double R1_32 = -R0_31*s166 + R0_32*s164;
    const double s1750 = R1_11*tip_v - R1_12*s219;
    const double s1754 = R1_21*tip_v - R1_22*s219;
    const double s1758 = R1_31*tip_v - R1_32*s219;
    const double s1762 = R1_11*g_y - R1_12*g_x;
    const double s1766 = R1_21*g_y - R1_22*g_x;
    const double s1770 = R1_31*g_y - R1_32*g_x;
    w[48] = R1_32;
    w[49] = R1_31;
    w[50] = R1_22;
    w[51] = R1_21;
    w[52] = R1_12;
    w[53] = R1_11;
    w[54] = s166;
    w[55] = s164;
    w[56] = s1750;
    w[57] = s1754;
    w[58] = s1758;
    w[59] = s1762;
    w[60] = s1766;
    w[61] = s1770;
}

/* Equations of a limb, their derivatives by shift and turn of the platform (116 operations). */
static void rows(double *w, const double *k)
{
    const double tz = w[3];
    const double px = w[4];
    const double py = w[5];
    const double pz = w[6];
    const double R_11 = w[10];
    const double R_12 = w[11];
    const double R_13 = w[12];
    const double R_21 = w[13];
    const double R_22 = w[14];
    const double R_23 = w[15];
    const double R_31 = w[16];
    const double R_32 = w[17];
    const double R_33 = w[18];
    const double s236 = w[35];
    const double s239 = w[36];
    const double C_x = w[37];
    const double C_y = w[38];
    const double C_z = w[39];
    const double c1_x = w[40];
    const double c1_y = w[41];
    const double c1_z = w[42];
    const double h_x = k[19];
    const double h_y = k[20];
    const double h_z = k[21];
    const double s1243 = k[85];
    const double s1489 = k[86];
    const double s237 = R_11*s236;
    const double s240 = R_12*s239;
    const double s241 = -R_13*tz;
    const double A_x = px + s237 + s240 + s241;
    const double s243 = R_21*s236;
    const double s244 = R_22*s239;
    const double s245 = -R_23*tz;
    const double A_y = py + s243 + s244 + s245;
    const double s247 = R_31*s236;
    const double s248 = R_32*s239;
    const double s249 = -R_33*tz;
    const double A_z = pz + s247 + s248 + s249;
    const double a1_x = R_11*h_x + R_12*h_y + R_13*h_z;
    const double a1_y = R_21*h_x + R_22*h_y + R_23*h_z;
    const double a1_z = R_31*h_x + R_32*h_y + R_33*h_z;
    const double d_x = A_x - C_x;
    const double d_y = A_y - C_y;
    const double d_z = A_z - C_z;
    const double s_x = a1_x - c1_x;
    const double s_y = a1_y - c1_y;
    const double s_z = a1_z - c1_z;
    const double s1231 = (1.0/2.0)*(s_x * s_x);
    const double s1233 = (1.0/2.0)*(s_y * s_y);
    const double s1235 = (1.0/2.0)*(s_z * s_z);
    const double s1244 = (1.0/2.0)*(d_x * d_x) + (1.0/2.0)*(d_y * d_y) + (1.0/2.0)*(d_z * d_z) + s1231 + s1233 + s1235 + s1243;
    const double s1490 = d_x*s_x + d_y*s_y + d_z*s_z + s1489;
    const double s1715 = -s247 - s248 - s249;
    const double s1717 = s243 + s244 + s245;
    const double s1721 = a1_y*s_z - a1_z*s_y + d_y*s1715 + d_z*s1717;
    const double s1723 = -s237 - s240 - s241;
    const double s1727 = -a1_x*s_z + a1_z*s_x - d_x*s1715 + d_z*s1723;
    const double s1732 = a1_x*s_y - a1_y*s_x - d_x*s1717 - d_y*s1723;
    const double s1737 = a1_y*d_z - a1_z*d_y + s1715*s_y + s1717*s_z;
    const double s1742 = -a1_x*d_z + a1_z*d_x - s1715*s_x + s1723*s_z;
    const double s1747 = a1_x*d_y - a1_y*d_x - s1717*s_x - s1723*s_y;
    w[19] = s1244;
    w[20] = d_x;
    w[21] = d_y;
    w[22] = d_z;
    w[23] = s1721;
    w[24] = s1727;
    w[25] = s1732;
    w[27] = s1490;
    w[28] = s_x;
    w[29] = s_y;
    w[30] = s_z;
    w[31] = s1737;
    w[32] = s1742;
    w[33] = s1747;
}

/* Derivatives of a limb's equations by its joint (61 operations). */
static void joints_of_rows(double *w, const double *k)
{
    const double tz = w[3];
    const double px = w[4];
    const double py = w[5];
    const double pz = w[6];
    const double R_11 = w[10];
    const double R_12 = w[11];
    const double R_13 = w[12];
    const double R_21 = w[13];
    const double R_22 = w[14];
    const double R_23 = w[15];
    const double R_31 = w[16];
    const double R_32 = w[17];
    const double R_33 = w[18];
    const double s236 = w[35];
    const double s239 = w[36];
    const double C_x = w[37];
    const double C_y = w[38];
    const double C_z = w[39];
    const double c1_x = w[40];
    const double c1_y = w[41];
    const double c1_z = w[42];
    const double s1750 = w[56];
    const double s1754 = w[57];
    const double s1758 = w[58];
    const double s1762 = w[59];
    const double s1766 = w[60];
    const double s1770 = w[61];
    const double h_x = k[19];
    const double h_y = k[20];
    const double h_z = k[21];
    const double A_x = R_11*s236 + R_12*s239 - R_13*tz + px;
    const double A_y = R_21*s236 + R_22*s239 - R_23*tz + py;
    const double A_z = R_31*s236 + R_32*s239 - R_33*tz + pz;
    const double a1_x = R_11*h_x + R_12*h_y + R_13*h_z;
    const double a1_y = R_21*h_x + R_22*h_y + R_23*h_z;
    const double a1_z = R_31*h_x + R_32*h_y + R_33*h_z;
    const double d_x = A_x - C_x;
    const double d_y = A_y - C_y;
    const double d_z = A_z - C_z;
    const double s_x = a1_x - c1_x;
    const double s_y = a1_y - c1_y;
    const double s_z = a1_z - c1_z;
    const double s1772 = d_x*s1750 + d_y*s1754 + d_z*s1758 + s1762*s_x + s1766*s_y + s1770*s_z;
    const double s1779 = d_x*s1762 + d_y*s1766 + d_z*s1770 + s1750*s_x + s1754*s_y + s1758*s_z;
    w[26] = s1772;
    w[34] = s1779;
}

/* Newton's step of the platform; how far the equations are from dependent (289 operations). */
static void step(double *w)
{
    const double F00 = w[19];
    const double J00_0 = w[20];
    const double J00_1 = w[21];
    const double J00_2 = w[22];
    const double J00_3 = w[23];
    const double J00_4 = w[24];
    const double J00_5 = w[25];
    const double F01 = w[27];
    const double J01_0 = w[28];
    const double J01_1 = w[29];
    const double J01_2 = w[30];
    const double J01_3 = w[31];
    const double J01_4 = w[32];
    const double J01_5 = w[33];
    const double F10 = w[113];
    const double J10_0 = w[114];
    const double J10_1 = w[115];
    const double J10_2 = w[116];
    const double J10_3 = w[117];
    const double J10_4 = w[118];
    const double J10_5 = w[119];
    const double F11 = w[121];
    const double J11_0 = w[122];
    const double J11_1 = w[123];
    const double J11_2 = w[124];
    const double J11_3 = w[125];
    const double J11_4 = w[126];
    const double J11_5 = w[127];
    const double F20 = w[207];
    const double J20_0 = w[208];
    const double J20_1 = w[209];
    const double J20_2 = w[210];
    const double J20_3 = w[211];
    const double J20_4 = w[212];
    const double J20_5 = w[213];
    const double F21 = w[215];
    const double J21_0 = w[216];
    const double J21_1 = w[217];
    const double J21_2 = w[218];
    const double J21_3 = w[219];
    const double J21_4 = w[220];
    const double J21_5 = w[221];
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
    const double U_00 = G_inv_00*J00_3 + G_inv_01*J10_3 + G_inv_02*J20_3;
    const double U_01 = G_inv_00*J00_4 + G_inv_01*J10_4 + G_inv_02*J20_4;
    const double U_02 = G_inv_00*J00_5 + G_inv_01*J10_5 + G_inv_02*J20_5;
    const double U_10 = G_inv_10*J00_3 + G_inv_11*J10_3 + G_inv_12*J20_3;
    const double U_11 = G_inv_10*J00_4 + G_inv_11*J10_4 + G_inv_12*J20_4;
    const double U_12 = G_inv_10*J00_5 + G_inv_11*J10_5 + G_inv_12*J20_5;
    const double U_20 = G_inv_20*J00_3 + G_inv_21*J10_3 + G_inv_22*J20_3;
    const double U_21 = G_inv_20*J00_4 + G_inv_21*J10_4 + G_inv_22*J20_4;
    const double U_22 = G_inv_20*J00_5 + G_inv_21*J10_5 + G_inv_22*J20_5;
    const double S_00 = -J01_0*U_00 - J01_1*U_10 - J01_2*U_20 + J01_3;
    const double S_01 = -J01_0*U_01 - J01_1*U_11 - J01_2*U_21 + J01_4;
    const double S_02 = -J01_0*U_02 - J01_1*U_12 - J01_2*U_22 + J01_5;
    const double S_10 = -J11_0*U_00 - J11_1*U_10 - J11_2*U_20 + J11_3;
    const double S_11 = -J11_0*U_01 - J11_1*U_11 - J11_2*U_21 + J11_4;
    const double S_12 = -J11_0*U_02 - J11_1*U_12 - J11_2*U_22 + J11_5;
    const double S_20 = -J21_0*U_00 - J21_1*U_10 - J21_2*U_20 + J21_3;
    const double S_21 = -J21_0*U_01 - J21_1*U_11 - J21_2*U_21 + J21_4;
    const double S_22 = -J21_0*U_02 - J21_1*U_12 - J21_2*U_22 + J21_5;
    const double Si_cof_00 = S_11*S_22 - S_12*S_21;
    const double Si_cof_01 = -S_10*S_22 + S_12*S_20;
    const double Si_cof_02 = S_10*S_21 - S_11*S_20;
    const double Si_cof_10 = -S_01*S_22 + S_02*S_21;
    const double Si_cof_11 = S_00*S_22 - S_02*S_20;
    const double Si_cof_12 = -S_00*S_21 + S_01*S_20;
    const double Si_cof_20 = S_01*S_12 - S_02*S_11;
    const double Si_cof_21 = -S_00*S_12 + S_02*S_10;
    const double Si_cof_22 = S_00*S_11 - S_01*S_10;
    const double Si_det_00 = S_00*Si_cof_00 + S_01*Si_cof_01 + S_02*Si_cof_02;
    const double Si_by_00 = 1.0/Si_det_00;
    const double Si_inv_00 = Si_by_00*Si_cof_00;
    const double Si_inv_01 = Si_by_00*Si_cof_10;
    const double Si_inv_02 = Si_by_00*Si_cof_20;
    const double Si_inv_10 = Si_by_00*Si_cof_01;
    const double Si_inv_11 = Si_by_00*Si_cof_11;
    const double Si_inv_12 = Si_by_00*Si_cof_21;
    const double Si_inv_20 = Si_by_00*Si_cof_02;
    const double Si_inv_21 = Si_by_00*Si_cof_12;
    const double Si_inv_22 = Si_by_00*Si_cof_22;
    const double s169 = F01 - J01_0*u_00 - J01_1*u_10 - J01_2*u_20;
    const double s174 = F11 - J11_0*u_00 - J11_1*u_10 - J11_2*u_20;
    const double s179 = F21 - J21_0*u_00 - J21_1*u_10 - J21_2*u_20;
    const double w_00 = Si_inv_00*s169 + Si_inv_01*s174 + Si_inv_02*s179;
    const double w_10 = Si_inv_10*s169 + Si_inv_11*s174 + Si_inv_12*s179;
    const double w_20 = Si_inv_20*s169 + Si_inv_21*s174 + Si_inv_22*s179;
    const double s193 = -U_00*w_00 - U_01*w_10 - U_02*w_20 + u_00;
    const double s197 = -U_10*w_00 - U_11*w_10 - U_12*w_20 + u_10;
    const double s201 = -U_20*w_00 - U_21*w_10 - U_22*w_20 + u_20;
    const double s210 = (J10_0 * J10_0) + (J10_1 * J10_1) + (J10_2 * J10_2);
    const double s214 = (J20_0 * J20_0) + (J20_1 * J20_1) + (J20_2 * J20_2);
    const double s216 = (G_det_00 * G_det_00) - 9.9999999999999998e-13*s210*s214*((J00_0 * J00_0) + (J00_1 * J00_1) + (J00_2 * J00_2));
    const double s225 = (J11_3 * J11_3) + (J11_4 * J11_4) + (J11_5 * J11_5);
    const double s229 = (J21_3 * J21_3) + (J21_4 * J21_4) + (J21_5 * J21_5);
    const double s231 = (Si_det_00 * Si_det_00) - 9.9999999999999998e-13*s225*s229*((J01_3 * J01_3) + (J01_4 * J01_4) + (J01_5 * J01_5));
    w[282] = s193;
    w[283] = s197;
    w[284] = s201;
    w[285] = w_00;
    w[286] = w_10;
    w[287] = w_20;
    w[288] = s216;
    w[289] = s231;
}

/* Minus the inverse of the derivatives, row by row; how far the equations are from dependent (439 operations). */
static void inverse_of_rows(double *w)
{
    const double J00_0 = w[20];
    const double J00_1 = w[21];
    const double J00_2 = w[22];
    const double J00_3 = w[23];
    const double J00_4 = w[24];
    const double J00_5 = w[25];
    const double J01_0 = w[28];
    const double J01_1 = w[29];
    const double J01_2 = w[30];
    const double J01_3 = w[31];
    const double J01_4 = w[32];
    const double J01_5 = w[33];
    const double J10_0 = w[114];
    const double J10_1 = w[115];
    const double J10_2 = w[116];
    const double J10_3 = w[117];
    const double J10_4 = w[118];
    const double J10_5 = w[119];
    const double J11_0 = w[122];
    const double J11_1 = w[123];
    const double J11_2 = w[124];
    const double J11_3 = w[125];
    const double J11_4 = w[126];
    const double J11_5 = w[127];
    const double J20_0 = w[208];
    const double J20_1 = w[209];
    const double J20_2 = w[210];
    const double J20_3 = w[211];
    const double J20_4 = w[212];
    const double J20_5 = w[213];
    const double J21_0 = w[216];
    const double J21_1 = w[217];
    const double J21_2 = w[218];
    const double J21_3 = w[219];
    const double J21_4 = w[220];
    const double J21_5 = w[221];
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
    const double U_00 = G_inv_00*J00_3 + G_inv_01*J10_3 + G_inv_02*J20_3;
    const double U_01 = G_inv_00*J00_4 + G_inv_01*J10_4 + G_inv_02*J20_4;
    const double U_02 = G_inv_00*J00_5 + G_inv_01*J10_5 + G_inv_02*J20_5;
    const double U_10 = G_inv_10*J00_3 + G_inv_11*J10_3 + G_inv_12*J20_3;
    const double U_11 = G_inv_10*J00_4 + G_inv_11*J10_4 + G_inv_12*J20_4;
    const double U_12 = G_inv_10*J00_5 + G_inv_11*J10_5 + G_inv_12*J20_5;
    const double U_20 = G_inv_20*J00_3 + G_inv_21*J10_3 + G_inv_22*J20_3;
    const double U_21 = G_inv_20*J00_4 + G_inv_21*J10_4 + G_inv_22*J20_4;
    const double U_22 = G_inv_20*J00_5 + G_inv_21*J10_5 + G_inv_22*J20_5;
    const double S_00 = -J01_0*U_00 - J01_1*U_10 - J01_2*U_20 + J01_3;
    const double S_01 = -J01_0*U_01 - J01_1*U_11 - J01_2*U_21 + J01_4;
    const double S_02 = -J01_0*U_02 - J01_1*U_12 - J01_2*U_22 + J01_5;
    const double S_10 = -J11_0*U_00 - J11_1*U_10 - J11_2*U_20 + J11_3;
    const double S_11 = -J11_0*U_01 - J11_1*U_11 - J11_2*U_21 + J11_4;
    const double S_12 = -J11_0*U_02 - J11_1*U_12 - J11_2*U_22 + J11_5;
    const double S_20 = -J21_0*U_00 - J21_1*U_10 - J21_2*U_20 + J21_3;
    const double S_21 = -J21_0*U_01 - J21_1*U_11 - J21_2*U_21 + J21_4;
    const double S_22 = -J21_0*U_02 - J21_1*U_12 - J21_2*U_22 + J21_5;
    const double Si_cof_00 = S_11*S_22 - S_12*S_21;
    const double Si_cof_01 = -S_10*S_22 + S_12*S_20;
    const double Si_cof_02 = S_10*S_21 - S_11*S_20;
    const double Si_cof_10 = -S_01*S_22 + S_02*S_21;
    const double Si_cof_11 = S_00*S_22 - S_02*S_20;
    const double Si_cof_12 = -S_00*S_21 + S_01*S_20;
    const double Si_cof_20 = S_01*S_12 - S_02*S_11;
    const double Si_cof_21 = -S_00*S_12 + S_02*S_10;
    const double Si_cof_22 = S_00*S_11 - S_01*S_10;
    const double Si_det_00 = S_00*Si_cof_00 + S_01*Si_cof_01 + S_02*Si_cof_02;
    const double Si_by_00 = 1.0/Si_det_00;
    const double Si_inv_00 = Si_by_00*Si_cof_00;
    const double Si_inv_01 = Si_by_00*Si_cof_10;
    const double Si_inv_02 = Si_by_00*Si_cof_20;
    const double Si_inv_10 = Si_by_00*Si_cof_01;
    const double Si_inv_11 = Si_by_00*Si_cof_11;
    const double Si_inv_12 = Si_by_00*Si_cof_21;
    const double Si_inv_20 = Si_by_00*Si_cof_02;
    const double Si_inv_21 = Si_by_00*Si_cof_12;
    const double Si_inv_22 = Si_by_00*Si_cof_22;
    const double s193 = -J01_0*Si_inv_00 - J11_0*Si_inv_01 - J21_0*Si_inv_02;
    const double s198 = -J01_1*Si_inv_00 - J11_1*Si_inv_01 - J21_1*Si_inv_02;
    const double s203 = -J01_2*Si_inv_00 - J11_2*Si_inv_01 - J21_2*Si_inv_02;
    const double V_00 = G_inv_00*s193 + G_inv_10*s198 + G_inv_20*s203;
    const double V_01 = G_inv_01*s193 + G_inv_11*s198 + G_inv_21*s203;
    const double V_02 = G_inv_02*s193 + G_inv_12*s198 + G_inv_22*s203;
    const double s217 = -J01_0*Si_inv_10 - J11_0*Si_inv_11 - J21_0*Si_inv_12;
    const double s222 = -J01_1*Si_inv_10 - J11_1*Si_inv_11 - J21_1*Si_inv_12;
    const double s227 = -J01_2*Si_inv_10 - J11_2*Si_inv_11 - J21_2*Si_inv_12;
    const double V_10 = G_inv_00*s217 + G_inv_10*s222 + G_inv_20*s227;
    const double V_11 = G_inv_01*s217 + G_inv_11*s222 + G_inv_21*s227;
    const double V_12 = G_inv_02*s217 + G_inv_12*s222 + G_inv_22*s227;
    const double s241 = -J01_0*Si_inv_20 - J11_0*Si_inv_21 - J21_0*Si_inv_22;
    const double s246 = -J01_1*Si_inv_20 - J11_1*Si_inv_21 - J21_1*Si_inv_22;
    const double s251 = -J01_2*Si_inv_20 - J11_2*Si_inv_21 - J21_2*Si_inv_22;
    const double V_20 = G_inv_00*s241 + G_inv_10*s246 + G_inv_20*s251;
    const double V_21 = G_inv_01*s241 + G_inv_11*s246 + G_inv_21*s251;
    const double V_22 = G_inv_02*s241 + G_inv_12*s246 + G_inv_22*s251;
    const double s265 = -G_inv_00 + U_00*V_00 + U_01*V_10 + U_02*V_20;
    const double s269 = -G_inv_01 + U_00*V_01 + U_01*V_11 + U_02*V_21;
    const double s273 = -G_inv_02 + U_00*V_02 + U_01*V_12 + U_02*V_22;
    const double s277 = Si_inv_00*U_00 + Si_inv_10*U_01 + Si_inv_20*U_02;
    const double s281 = Si_inv_01*U_00 + Si_inv_11*U_01 + Si_inv_21*U_02;
    const double s285 = Si_inv_02*U_00 + Si_inv_12*U_01 + Si_inv_22*U_02;
    const double s289 = -G_inv_10 + U_10*V_00 + U_11*V_10 + U_12*V_20;
    const double s293 = -G_inv_11 + U_10*V_01 + U_11*V_11 + U_12*V_21;
    const double s297 = -G_inv_12 + U_10*V_02 + U_11*V_12 + U_12*V_22;
    const double s301 = Si_inv_00*U_10 + Si_inv_10*U_11 + Si_inv_20*U_12;
    const double s305 = Si_inv_01*U_10 + Si_inv_11*U_11 + Si_inv_21*U_12;
    const double s309 = Si_inv_02*U_10 + Si_inv_12*U_11 + Si_inv_22*U_12;
    const double s313 = -G_inv_20 + U_20*V_00 + U_21*V_10 + U_22*V_20;
    const double s317 = -G_inv_21 + U_20*V_01 + U_21*V_11 + U_22*V_21;
    const double s321 = -G_inv_22 + U_20*V_02 + U_21*V_12 + U_22*V_22;
    const double s325 = Si_inv_00*U_20 + Si_inv_10*U_21 + Si_inv_20*U_22;
    const double s329 = Si_inv_01*U_20 + Si_inv_11*U_21 + Si_inv_21*U_22;
    const double s333 = Si_inv_02*U_20 + Si_inv_12*U_21 + Si_inv_22*U_22;
    const double s342 = (J10_0 * J10_0) + (J10_1 * J10_1) + (J10_2 * J10_2);
    const double s346 = (J20_0 * J20_0) + (J20_1 * J20_1) + (J20_2 * J20_2);
    const double s348 = (G_det_00 * G_det_00) - 9.9999999999999998e-13*s342*s346*((J00_0 * J00_0) + (J00_1 * J00_1) + (J00_2 * J00_2));
    const double s357 = (J11_3 * J11_3) + (J11_4 * J11_4) + (J11_5 * J11_5);
    const double s361 = (J21_3 * J21_3) + (J21_4 * J21_4) + (J21_5 * J21_5);
    const double s363 = (Si_det_00 * Si_det_00) - 9.9999999999999998e-13*s357*s361*((J01_3 * J01_3) + (J01_4 * J01_4) + (J01_5 * J01_5));
    w[291] = s265;
    w[292] = s269;
    w[293] = s273;
    w[294] = s277;
    w[295] = s281;
    w[296] = s285;
    w[297] = s289;
    w[298] = s293;
    w[299] = s297;
    w[300] = s301;
    w[301] = s305;
    w[302] = s309;
    w[303] = s313;
    w[304] = s317;
    w[305] = s321;
    w[306] = s325;
    w[307] = s329;
    w[308] = s333;
    w[309] = -V_00;
    w[310] = -V_01;
    w[311] = -V_02;
    w[312] = -Si_inv_00;
    w[313] = -Si_inv_01;
    w[314] = -Si_inv_02;
    w[315] = -V_10;
    w[316] = -V_11;
    w[317] = -V_12;
    w[318] = -Si_inv_10;
    w[319] = -Si_inv_11;
    w[320] = -Si_inv_12;
    w[321] = -V_20;
    w[322] = -V_21;
    w[323] = -V_22;
    w[324] = -Si_inv_20;
    w[325] = -Si_inv_21;
    w[326] = -Si_inv_22;
    w[327] = s348;
    w[328] = s363;
}

/* The platform after a step, and its rotation matrix (104 operations). */
static void place(double *w)
{
    const double px = w[4];
    const double py = w[5];
    const double pz = w[6];
    const double cx = w[7];
    const double cy = w[8];
    const double cz = w[9];
    const double y0 = w[282];
    const double y1 = w[283];
    const double y2 = w[284];
    const double y3 = w[285];
    const double y4 = w[286];
    const double y5 = w[287];
    const double going = w[290];
    const double new_00 = -going*y0 + px;
    const double new_10 = -going*y1 + py;
    const double new_20 = -going*y2 + pz;
    const double s10 = (1.0/2.0)*cz;
    const double s11 = (1.0/4.0)*cx*cy;
    const double s14 = -1.0/2.0*cy;
    const double s15 = (1.0/4.0)*cx*cz;
    const double s17 = -going*y5*(s14 + s15);
    const double new_30 = cx - going*y3*((1.0/4.0)*(cx * cx) + 1) - going*y4*(s10 + s11) + s17;
    const double s25 = (1.0/2.0)*cx;
    const double s26 = (1.0/4.0)*cy*cz;
    const double s28 = -going*y5*(s25 + s26);
    const double new_40 = cy - going*y3*(-s10 + s11) - going*y4*((1.0/4.0)*(cy * cy) + 1) + s28;
    const double s37 = -going*y5*((1.0/4.0)*(cz * cz) + 1);
    const double new_50 = cz - going*y3*(-s14 + s15) - going*y4*(-s25 + s26) + s37;
    const double s39 = (new_30 * new_30);
    const double s41 = (new_40 * new_40);
    const double s43 = (new_50 * new_50);
    const double s46 = 1.0/((1.0/4.0)*s39 + (1.0/4.0)*s41 + (1.0/4.0)*s43 + 1);
    const double s47 = -1.0/2.0*s41;
    const double s48 = -1.0/2.0*s43;
    const double s51 = s46*(s47 + s48) + 1;
    const double s52 = (1.0/2.0)*new_30*new_40;
    const double s54 = s46*(-new_50 + s52);
    const double s55 = (1.0/2.0)*new_30*new_50;
    const double s57 = s46*(new_40 + s55);
    const double s59 = s46*(new_50 + s52);
    const double s60 = -1.0/2.0*s39;
    const double s63 = s46*(s48 + s60) + 1;
    const double s64 = (1.0/2.0)*new_40*new_50;
    const double s66 = s46*(-new_30 + s64);
    const double s68 = s46*(-new_40 + s55);
    const double s70 = s46*(new_30 + s64);
    const double s73 = s46*(s47 + s60) + 1;
    w[4] = new_00;
    w[98] = new_00;
    w[192] = new_00;
    w[5] = new_10;
    w[99] = new_10;
    w[193] = new_10;
    w[6] = new_20;
    w[100] = new_20;
    w[194] = new_20;
    w[7] = new_30;
    w[8] = new_40;
    w[9] = new_50;
    w[10] = s51;
    w[104] = s51;
    w[198] = s51;
    w[11] = s54;
    w[105] = s54;
    w[199] = s54;
    w[12] = s57;
    w[106] = s57;
    w[200] = s57;
    w[13] = s59;
    w[107] = s59;
    w[201] = s59;
    w[14] = s63;
    w[108] = s63;
    w[202] = s63;
    w[15] = s66;
    w[109] = s66;
    w[203] = s66;
    w[16] = s68;
    w[110] = s68;
    w[204] = s68;
    w[17] = s70;
    w[111] = s70;
    w[205] = s70;
    w[18] = s73;
    w[112] = s73;
    w[206] = s73;
}

/* How the platform moves with each joint, and how it does (84 operations). */
static void move(const double *w, const double *d, double *s)
{
    const double M_0_0 = w[291];
    const double M_0_1 = w[292];
    const double M_0_2 = w[293];
    const double M_0_3 = w[294];
    const double M_0_4 = w[295];
    const double M_0_5 = w[296];
    const double M_1_0 = w[297];
    const double M_1_1 = w[298];
    const double M_1_2 = w[299];
    const double M_1_3 = w[300];
    const double M_1_4 = w[301];
    const double M_1_5 = w[302];
    const double M_2_0 = w[303];
    const double M_2_1 = w[304];
    const double M_2_2 = w[305];
    const double M_2_3 = w[306];
    const double M_2_4 = w[307];
    const double M_2_5 = w[308];
    const double M_3_0 = w[309];
    const double M_3_1 = w[310];
    const double M_3_2 = w[311];
    const double M_3_3 = w[312];
    const double M_3_4 = w[313];
    const double M_3_5 = w[314];
    const double M_4_0 = w[315];
    const double M_4_1 = w[316];
    const double M_4_2 = w[317];
    const double M_4_3 = w[318];
    const double M_4_4 = w[319];
    const double M_4_5 = w[320];
    const double M_5_0 = w[321];
    const double M_5_1 = w[322];
    const double M_5_2 = w[323];
    const double M_5_3 = w[324];
    const double M_5_4 = w[325];
    const double M_5_5 = w[326];
    const double q_t_0 = d[0];
    const double Q_0 = w[26];
    const double Q_3 = w[34];
    const double q_t_1 = d[40];
    const double Q_1 = w[120];
    const double Q_4 = w[128];
    const double q_t_2 = d[80];
    const double Q_2 = w[214];
    const double Q_5 = w[222];
    const double V_0_0 = M_0_0*Q_0 + M_0_3*Q_3;
    const double V_0_1 = M_0_1*Q_1 + M_0_4*Q_4;
    const double V_0_2 = M_0_2*Q_2 + M_0_5*Q_5;
    const double V_1_0 = M_1_0*Q_0 + M_1_3*Q_3;
    const double V_1_1 = M_1_1*Q_1 + M_1_4*Q_4;
    const double V_1_2 = M_1_2*Q_2 + M_1_5*Q_5;
    const double V_2_0 = M_2_0*Q_0 + M_2_3*Q_3;
    const double V_2_1 = M_2_1*Q_1 + M_2_4*Q_4;
    const double V_2_2 = M_2_2*Q_2 + M_2_5*Q_5;
    const double V_3_0 = M_3_0*Q_0 + M_3_3*Q_3;
    const double V_3_1 = M_3_1*Q_1 + M_3_4*Q_4;
    const double V_3_2 = M_3_2*Q_2 + M_3_5*Q_5;
    const double V_4_0 = M_4_0*Q_0 + M_4_3*Q_3;
    const double V_4_1 = M_4_1*Q_1 + M_4_4*Q_4;
    const double V_4_2 = M_4_2*Q_2 + M_4_5*Q_5;
    const double V_5_0 = M_5_0*Q_0 + M_5_3*Q_3;
    const double V_5_1 = M_5_1*Q_1 + M_5_4*Q_4;
    const double V_5_2 = M_5_2*Q_2 + M_5_5*Q_5;
    const double s57 = V_0_0*q_t_0 + V_0_1*q_t_1 + V_0_2*q_t_2;
    const double s61 = V_1_0*q_t_0 + V_1_1*q_t_1 + V_1_2*q_t_2;
    const double s65 = V_2_0*q_t_0 + V_2_1*q_t_1 + V_2_2*q_t_2;
    const double s69 = V_3_0*q_t_0 + V_3_1*q_t_1 + V_3_2*q_t_2;
    const double s73 = V_4_0*q_t_0 + V_4_1*q_t_1 + V_4_2*q_t_2;
    const double s77 = V_5_0*q_t_0 + V_5_1*q_t_1 + V_5_2*q_t_2;
    s[0] = V_0_0;
    s[1] = V_0_1;
    s[2] = V_0_2;
    s[3] = V_1_0;
    s[4] = V_1_1;
    s[5] = V_1_2;
    s[6] = V_2_0;
    s[7] = V_2_1;
    s[8] = V_2_2;
    s[9] = V_3_0;
    s[10] = V_3_1;
    s[11] = V_3_2;
    s[12] = V_4_0;
    s[13] = V_4_1;
    s[14] = V_4_2;
    s[15] = V_5_0;
    s[16] = V_5_1;
    s[17] = V_5_2;
    s[18] = s57;
    s[19] = s61;
    s[20] = s65;
    s[21] = s69;
    s[22] = s73;
    s[23] = s77;
}

/* Second derivatives of a limb's equations by time where nothing accelerates (336 operations). */
static void curved(const double *w, double *d, const double *s, const double *k, const double *gravity, const double *shares)
{
    const double q = w[0];
    const double tx = w[1];
    const double ty = w[2];
    const double tz = w[3];
    const double px = w[4];
    const double py = w[5];
    const double pz = w[6];
    const double R_11 = w[10];
    const double R_12 = w[11];
    const double R_13 = w[12];
    const double R_21 = w[13];
    const double R_22 = w[14];
    const double R_23 = w[15];
    const double R_31 = w[16];
    const double R_32 = w[17];
    const double R_33 = w[18];
    const double v_px = s[18];
    const double v_py = s[19];
    const double v_pz = s[20];
    const double w_x = s[21];
    const double w_y = s[22];
    const double w_z = s[23];
    const double q_t = d[0];
    const double theta = k[0];
    const double R0_11 = k[1];
    const double R0_12 = k[2];
    const double R0_21 = k[3];
    const double R0_22 = k[4];
    const double R0_31 = k[5];
    const double R0_32 = k[6];
    const double s184 = k[7];
    const double tip_v = k[8];
    const double s188 = k[9];
    const double s193 = k[10];
    const double s198 = k[11];
    const double s200 = k[12];
    const double s203 = k[13];
    const double g_x = k[14];
    const double g_y = k[15];
    const double s218 = k[16];
    const double s222 = k[17];
    const double s226 = k[18];
    const double h_x = k[19];
    const double h_y = k[20];
    const double h_z = k[21];
    const double s163 = q + theta;
    const double s164 = cos(s163);
    const double s166 = sin(s163);
    const double R1_11 = R0_11*s164 + R0_12*s166;
    const double R1_12 = -R0_11*s166 + R0_12*s164;
    const double R1_21 = R0_21*s164 + R0_22*s166;
    const double R1_22 = -R0_21*s166 + R0_22*s164;
    const double R1_31 = R0_31*s164 + R0_32*s166;
    const double R1_32 = -R0_31*s166 + R0_32*s164;
    const double C_x = R1_11*s184 + R1_12*tip_v + s188;
    const double C_y = R1_21*s184 + R1_22*tip_v + s193;
    const double C_z = R1_31*s184 + R1_32*tip_v + s198;
    const double s201 = s200 - tx;
    const double s204 = s203 - ty;
    const double A_x = R_11*s201 + R_12*s204 - R_13*tz + px;
    const double A_y = R_21*s201 + R_22*s204 - R_23*tz + py;
    const double A_z = R_31*s201 + R_32*s204 - R_33*tz + pz;
    const double c1_x = R1_11*g_x + R1_12*g_y + s218;
    const double c1_y = R1_21*g_x + R1_22*g_y + s222;
    const double c1_z = R1_31*g_x + R1_32*g_y + s226;
    const double a1_x = R_11*h_x + R_12*h_y + R_13*h_z;
    const double a1_y = R_21*h_x + R_22*h_y + R_23*h_z;
    const double a1_z = R_31*h_x + R_32*h_y + R_33*h_z;
    const double d_x = A_x - C_x;
    const double d_y = A_y - C_y;
    const double d_z = A_z - C_z;
    const double s_x = a1_x - c1_x;
    const double s_y = a1_y - c1_y;
    const double s_z = a1_z - c1_z;
    const double s276 = -R_21*w_z + R_31*w_y;
    const double s279 = -R_22*w_z + R_32*w_y;
    const double s282 = -R_23*w_z + R_33*w_y;
    const double s285 = R_11*w_z - R_31*w_x;
    const double s288 = R_12*w_z - R_32*w_x;
    const double s291 = R_13*w_z - R_33*w_x;
    const double s294 = -R_11*w_y + R_21*w_x;
    const double s297 = -R_12*w_y + R_22*w_x;
    const double s300 = -R_13*w_y + R_23*w_x;
    const double s301 = -q_t*s166;
    const double s303 = q_t*s164;
    const double s305 = R0_11*s301 + R0_12*s303;
    const double s308 = -R0_11*s303 + R0_12*s301;
    const double s311 = R0_21*s301 + R0_22*s303;
    const double s314 = -R0_21*s303 + R0_22*s301;
    const double s317 = R0_31*s301 + R0_32*s303;
    const double s320 = -R0_31*s303 + R0_32*s301;
    const double s363 = -s184*s305 + s201*s276 + s204*s279 - s282*tz - s308*tip_v + v_px;
    const double s364 = -s184*s311 + s201*s285 + s204*s288 - s291*tz - s314*tip_v + v_py;
    const double s365 = -s184*s317 + s201*s294 + s204*s297 - s300*tz - s320*tip_v + v_pz;
    const double s366 = -g_x*s305 - g_y*s308 + h_x*s276 + h_y*s279 + h_z*s282;
    const double s367 = -g_x*s311 - g_y*s314 + h_x*s285 + h_y*s288 + h_z*s291;
    const double s368 = -g_x*s317 - g_y*s320 + h_x*s294 + h_y*s297 + h_z*s300;
    const double s400 = -s285*w_z + s294*w_y;
    const double s403 = -s288*w_z + s297*w_y;
    const double s406 = -s291*w_z + s300*w_y;
    const double s409 = s276*w_z - s294*w_x;
    const double s412 = s279*w_z - s297*w_x;
    const double s415 = s282*w_z - s300*w_x;
    const double s418 = -s276*w_y + s285*w_x;
    const double s421 = -s279*w_y + s288*w_x;
    const double s424 = -s282*w_y + s291*w_x;
    const double s425 = -q_t*s303;
    const double s427 = q_t*s301;
    const double s429 = R0_11*s425 + R0_12*s427;
    const double s432 = -R0_11*s427 + R0_12*s425;
    const double s435 = R0_21*s425 + R0_22*s427;
    const double s438 = -R0_21*s427 + R0_22*s425;
    const double s441 = R0_31*s425 + R0_32*s427;
    const double s444 = -R0_31*s427 + R0_32*s425;
    const double s487 = -s184*s429 + s201*s400 + s204*s403 - s406*tz - s432*tip_v;
    const double s488 = -s184*s435 + s201*s409 + s204*s412 - s415*tz - s438*tip_v;
    const double s489 = -s184*s441 + s201*s418 + s204*s421 - s424*tz - s444*tip_v;
    const double s490 = -g_x*s429 - g_y*s432 + h_x*s400 + h_y*s403 + h_z*s406;
    const double s491 = -g_x*s435 - g_y*s438 + h_x*s409 + h_y*s412 + h_z*s415;
    const double s492 = -g_x*s441 - g_y*s444 + h_x*s418 + h_y*s421 + h_z*s424;
    const double s507 = d_z*s489 + (s365 * s365);
    const double s512 = (s366 * s366) + s490*s_x;
    const double s517 = (s367 * s367) + s491*s_y;
    const double s522 = (s368 * s368) + s492*s_z;
    const double s523 = d_x*s487 + d_y*s488 + (s363 * s363) + (s364 * s364) + s507 + s512 + s517 + s522;
    const double s525 = s363*s366;
    const double s531 = s364*s367;
    const double s537 = s365*s368;
    const double s541 = d_z*s492 + s489*s_z + 2*s537;
    const double s542 = d_x*s490 + d_y*s491 + s487*s_x + s488*s_y + 2*s525 + 2*s531 + s541;
    (void)(gravity);
    (void)(shares);
    d[2] = s523;
    d[3] = s542;
}

/* The platform's acceleration (102 operations). */
static void accelerate(const double *w, const double *d, double *s)
{
    const double M_0_0 = w[291];
    const double M_0_1 = w[292];
    const double M_0_2 = w[293];
    const double M_0_3 = w[294];
    const double M_0_4 = w[295];
    const double M_0_5 = w[296];
    const double M_1_0 = w[297];
    const double M_1_1 = w[298];
    const double M_1_2 = w[299];
    const double M_1_3 = w[300];
    const double M_1_4 = w[301];
    const double M_1_5 = w[302];
    const double M_2_0 = w[303];
    const double M_2_1 = w[304];
    const double M_2_2 = w[305];
    const double M_2_3 = w[306];
    const double M_2_4 = w[307];
    const double M_2_5 = w[308];
    const double M_3_0 = w[309];
    const double M_3_1 = w[310];
    const double M_3_2 = w[311];
    const double M_3_3 = w[312];
    const double M_3_4 = w[313];
    const double M_3_5 = w[314];
    const double M_4_0 = w[315];
    const double M_4_1 = w[316];
    const double M_4_2 = w[317];
    const double M_4_3 = w[318];
    const double M_4_4 = w[319];
    const double M_4_5 = w[320];
    const double M_5_0 = w[321];
    const double M_5_1 = w[322];
    const double M_5_2 = w[323];
    const double M_5_3 = w[324];
    const double M_5_4 = w[325];
    const double M_5_5 = w[326];
    const double q_tt_0 = d[1];
    const double c_0 = d[2];
    const double c_3 = d[3];
    const double q_tt_1 = d[41];
    const double c_1 = d[42];
    const double c_4 = d[43];
    const double q_tt_2 = d[81];
    const double c_2 = d[82];
    const double c_5 = d[83];
    const double V_0_0 = s[0];
    const double V_0_1 = s[1];
    const double V_0_2 = s[2];
    const double V_1_0 = s[3];
    const double V_1_1 = s[4];
    const double V_1_2 = s[5];
    const double V_2_0 = s[6];
    const double V_2_1 = s[7];
    const double V_2_2 = s[8];
    const double V_3_0 = s[9];
    const double V_3_1 = s[10];
    const double V_3_2 = s[11];
    const double V_4_0 = s[12];
    const double V_4_1 = s[13];
    const double V_4_2 = s[14];
    const double V_5_0 = s[15];
    const double V_5_1 = s[16];
    const double V_5_2 = s[17];
    const double s4 = M_0_4*c_4;
    const double s5 = M_0_5*c_5;
    const double s6 = V_0_0*q_tt_0;
    const double s7 = V_0_1*q_tt_1;
    const double s8 = V_0_2*q_tt_2;
    const double s9 = M_0_0*c_0 + M_0_1*c_1 + M_0_2*c_2 + M_0_3*c_3 + s4 + s5 + s6 + s7 + s8;
    const double s14 = M_1_4*c_4;
    const double s15 = M_1_5*c_5;
    const double s16 = V_1_0*q_tt_0;
    const double s17 = V_1_1*q_tt_1;
    const double s18 = V_1_2*q_tt_2;
    const double s19 = M_1_0*c_0 + M_1_1*c_1 + M_1_2*c_2 + M_1_3*c_3 + s14 + s15 + s16 + s17 + s18;
    const double s24 = M_2_4*c_4;
    const double s25 = M_2_5*c_5;
    const double s26 = V_2_0*q_tt_0;
    const double s27 = V_2_1*q_tt_1;
    const double s28 = V_2_2*q_tt_2;
    const double s29 = M_2_0*c_0 + M_2_1*c_1 + M_2_2*c_2 + M_2_3*c_3 + s24 + s25 + s26 + s27 + s28;
    const double s34 = M_3_4*c_4;
    const double s35 = M_3_5*c_5;
    const double s36 = V_3_0*q_tt_0;
    const double s37 = V_3_1*q_tt_1;
    const double s38 = V_3_2*q_tt_2;
    const double s39 = M_3_0*c_0 + M_3_1*c_1 + M_3_2*c_2 + M_3_3*c_3 + s34 + s35 + s36 + s37 + s38;
    const double s44 = M_4_4*c_4;
    const double s45 = M_4_5*c_5;
    const double s46 = V_4_0*q_tt_0;
    const double s47 = V_4_1*q_tt_1;
    const double s48 = V_4_2*q_tt_2;
    const double s49 = M_4_0*c_0 + M_4_1*c_1 + M_4_2*c_2 + M_4_3*c_3 + s44 + s45 + s46 + s47 + s48;
    const double s54 = M_5_4*c_4;
    const double s55 = M_5_5*c_5;
    const double s56 = V_5_0*q_tt_0;
    const double s57 = V_5_1*q_tt_1;
    const double s58 = V_5_2*q_tt_2;
    const double s59 = M_5_0*c_0 + M_5_1*c_1 + M_5_2*c_2 + M_5_3*c_3 + s54 + s55 + s56 + s57 + s58;
    s[24] = s9;
    s[25] = s19;
    s[26] = s29;
    s[27] = s39;
    s[28] = s49;
    s[29] = s59;
}

/* Gravity less acceleration of the points of a limb (293 operations). */
static void limb_fields(const double *w, double *d, const double *s, const double *k, const double *gravity, const double *shares)
{
    const double q = w[0];
    const double tx = w[1];
    const double ty = w[2];
    const double tz = w[3];
    const double R_11 = w[10];
    const double R_12 = w[11];
    const double R_13 = w[12];
    const double R_21 = w[13];
    const double R_22 = w[14];
    const double R_23 = w[15];
    const double R_31 = w[16];
    const double R_32 = w[17];
    const double R_33 = w[18];
    const double w_x = s[21];
    const double w_y = s[22];
    const double w_z = s[23];
    const double v_px_t = s[24];
    const double v_py_t = s[25];
    const double v_pz_t = s[26];
    const double w_x_t = s[27];
    const double w_y_t = s[28];
    const double w_z_t = s[29];
    const double q_t = d[0];
    const double q_tt = d[1];
    const double gx = gravity[0];
    const double gy = gravity[1];
    const double gz = gravity[2];
    const double theta = k[0];
    const double R0_11 = k[1];
    const double R0_12 = k[2];
    const double R0_21 = k[3];
    const double R0_22 = k[4];
    const double R0_31 = k[5];
    const double R0_32 = k[6];
    const double s184 = k[7];
    const double tip_v = k[8];
    const double s200 = k[12];
    const double s203 = k[13];
    const double g_x = k[14];
    const double g_y = k[15];
    const double h_x = k[19];
    const double h_y = k[20];
    const double h_z = k[21];
    const double s163 = q + theta;
    const double s164 = cos(s163);
    const double s166 = sin(s163);
    const double s201 = s200 - tx;
    const double s204 = s203 - ty;
    const double s276 = -R_21*w_z + R_31*w_y;
    const double s279 = -R_22*w_z + R_32*w_y;
    const double s282 = -R_23*w_z + R_33*w_y;
    const double s285 = R_11*w_z - R_31*w_x;
    const double s288 = R_12*w_z - R_32*w_x;
    const double s291 = R_13*w_z - R_33*w_x;
    const double s294 = -R_11*w_y + R_21*w_x;
    const double s297 = -R_12*w_y + R_22*w_x;
    const double s300 = -R_13*w_y + R_23*w_x;
    const double s1344 = -R_21*w_z_t + R_31*w_y_t - s285*w_z + s294*w_y;
    const double s1349 = -R_22*w_z_t + R_32*w_y_t - s288*w_z + s297*w_y;
    const double s1354 = -R_23*w_z_t + R_33*w_y_t - s291*w_z + s300*w_y;
    const double s1359 = R_11*w_z_t - R_31*w_x_t + s276*w_z - s294*w_x;
    const double s1364 = R_12*w_z_t - R_32*w_x_t + s279*w_z - s297*w_x;
    const double s1369 = R_13*w_z_t - R_33*w_x_t + s282*w_z - s300*w_x;
    const double s1374 = -R_11*w_y_t + R_21*w_x_t - s276*w_y + s285*w_x;
    const double s1379 = -R_12*w_y_t + R_22*w_x_t - s279*w_y + s288*w_x;
    const double s1384 = -R_13*w_y_t + R_23*w_x_t - s282*w_y + s291*w_x;
    const double s1386 = -(q_t * q_t)*s164 - q_tt*s166;
    const double s1389 = -(q_t * q_t)*s166 + q_tt*s164;
    const double s1391 = R0_11*s1386 + R0_12*s1389;
    const double s1394 = -R0_11*s1389 + R0_12*s1386;
    const double s1397 = R0_21*s1386 + R0_22*s1389;
    const double s1400 = -R0_21*s1389 + R0_22*s1386;
    const double s1403 = R0_31*s1386 + R0_32*s1389;
    const double s1406 = -R0_31*s1389 + R0_32*s1386;
    const double s1407 = s1391*s184;
    const double s1409 = s1394*tip_v + s1407;
    const double s1410 = s1397*s184;
    const double s1412 = s1400*tip_v + s1410;
    const double s1413 = s1403*s184;
    const double s1415 = s1406*tip_v + s1413;
    const double s1419 = s1344*s201 + s1349*s204 - s1354*tz + v_px_t;
    const double s1423 = s1359*s201 + s1364*s204 - s1369*tz + v_py_t;
    const double s1427 = s1374*s201 + s1379*s204 - s1384*tz + v_pz_t;
    const double s1430 = g_x*s1391 + g_y*s1394;
    const double s1433 = g_x*s1397 + g_y*s1400;
    const double s1436 = g_x*s1403 + g_y*s1406;
    const double s1440 = h_x*s1344 + h_y*s1349 + h_z*s1354;
    const double s1444 = h_x*s1359 + h_y*s1364 + h_z*s1369;
    const double s1448 = h_x*s1374 + h_y*s1379 + h_z*s1384;
    const double s2123 = (1.0/2.0)*s1419;
    const double s2124 = (1.0/2.0)*s1409;
    const double s2125 = (1.0/2.0)*s1440;
    const double s2126 = (1.0/2.0)*s1430;
    const double s2129 = (1.0/2.0)*s1423;
    const double s2130 = (1.0/2.0)*s1412;
    const double s2131 = (1.0/2.0)*s1444;
    const double s2132 = (1.0/2.0)*s1433;
    const double s2135 = (1.0/2.0)*s1427;
    const double s2136 = (1.0/2.0)*s1415;
    const double s2137 = (1.0/2.0)*s1448;
    const double s2138 = (1.0/2.0)*s1436;
    const double s2255 = -1.0/1000.0*s1407;
    const double s2256 = gx + s2255;
    const double s2257 = -1.0/1000.0*s1410;
    const double s2258 = gy + s2257;
    const double s2259 = -1.0/1000.0*s1413;
    const double s2260 = gz + s2259;
    const double s2261 = gx - s2255;
    const double s2262 = gy - s2257;
    const double s2263 = gz - s2259;
    const double s2265 = gx - 1.0/1000.0*s1409 - 1.0/1000.0*s1430;
    const double s2267 = gy - 1.0/1000.0*s1412 - 1.0/1000.0*s1433;
    const double s2269 = gz - 1.0/1000.0*s1415 - 1.0/1000.0*s1436;
    const double s2271 = gx - 1.0/1000.0*s2123 - 1.0/1000.0*s2124 - 1.0/1000.0*s2125 - 1.0/1000.0*s2126;
    const double s2273 = gy - 1.0/1000.0*s2129 - 1.0/1000.0*s2130 - 1.0/1000.0*s2131 - 1.0/1000.0*s2132;
    const double s2275 = gz - 1.0/1000.0*s2135 - 1.0/1000.0*s2136 - 1.0/1000.0*s2137 - 1.0/1000.0*s2138;
    const double s2277 = gx - 1.0/1000.0*s1419 - 1.0/1000.0*s1440;
    const double s2279 = gy - 1.0/1000.0*s1423 - 1.0/1000.0*s1444;
    const double s2281 = gz - 1.0/1000.0*s1427 - 1.0/1000.0*s1448;
    const double s2283 = gx - 1.0/1000.0*s1409 + (1.0/1000.0)*s1430;
    const double s2285 = gy - 1.0/1000.0*s1412 + (1.0/1000.0)*s1433;
    const double s2287 = gz - 1.0/1000.0*s1415 + (1.0/1000.0)*s1436;
    const double s2289 = gx - 1.0/1000.0*s2123 - 1.0/1000.0*s2124 + (1.0/1000.0)*s2125 + (1.0/1000.0)*s2126;
    const double s2291 = gy - 1.0/1000.0*s2129 - 1.0/1000.0*s2130 + (1.0/1000.0)*s2131 + (1.0/1000.0)*s2132;
    const double s2293 = gz - 1.0/1000.0*s2135 - 1.0/1000.0*s2136 + (1.0/1000.0)*s2137 + (1.0/1000.0)*s2138;
    const double s2295 = gx - 1.0/1000.0*s1419 + (1.0/1000.0)*s1440;
    const double s2297 = gy - 1.0/1000.0*s1423 + (1.0/1000.0)*s1444;
    const double s2299 = gz - 1.0/1000.0*s1427 + (1.0/1000.0)*s1448;
    (void)(shares);
    d[7] = s2256;
    d[8] = s2258;
    d[9] = s2260;
    d[10] = s2261;
    d[11] = s2262;
    d[12] = s2263;
    d[13] = s2265;
    d[14] = s2267;
    d[15] = s2269;
    d[16] = s2271;
    d[17] = s2273;
    d[18] = s2275;
    d[19] = s2277;
    d[20] = s2279;
    d[21] = s2281;
    d[22] = s2283;
    d[23] = s2285;
    d[24] = s2287;
    d[25] = s2289;
    d[26] = s2291;
    d[27] = s2293;
    d[28] = s2295;
    d[29] = s2297;
    d[30] = s2299;
}

/* Loads per inertial parameter of a limb, along joint, shifts and turns (222 operations). */
static void limb_asks(const double *w, double *d, const double *s, const double *k, const double *gravity, const double *shares)
{
    const double q = w[0];
    const double tx = w[1];
    const double ty = w[2];
    const double tz = w[3];
    const double R_11 = w[10];
    const double R_12 = w[11];
    const double R_13 = w[12];
    const double R_21 = w[13];
    const double R_22 = w[14];
    const double R_23 = w[15];
    const double R_31 = w[16];
    const double R_32 = w[17];
    const double R_33 = w[18];
    const double share = shares[0];
    const double f1x = d[7];
    const double f1y = d[8];
    const double f1z = d[9];
    const double f2x = d[10];
    const double f2y = d[11];
    const double f2z = d[12];
    const double f3x = d[13];
    const double f3y = d[14];
    const double f3z = d[15];
    const double f4x = d[16];
    const double f4y = d[17];
    const double f4z = d[18];
    const double f5x = d[19];
    const double f5y = d[20];
    const double f5z = d[21];
    const double f6x = d[22];
    const double f6y = d[23];
    const double f6z = d[24];
    const double f7x = d[25];
    const double f7y = d[26];
    const double f7z = d[27];
    const double f8x = d[28];
    const double f8y = d[29];
    const double f8z = d[30];
    const double theta = k[0];
    const double R0_11 = k[1];
    const double R0_12 = k[2];
    const double R0_21 = k[3];
    const double R0_22 = k[4];
    const double R0_31 = k[5];
    const double R0_32 = k[6];
    const double s184 = k[7];
    const double tip_v = k[8];
    const double s200 = k[12];
    const double s203 = k[13];
    const double g_x = k[14];
    const double g_y = k[15];
    const double h_x = k[19];
    const double h_y = k[20];
    const double h_z = k[21];
    const double s577 = k[22];
    const double s639 = k[23];
    const double s163 = q + theta;
    const double s164 = cos(s163);
    const double s166 = sin(s163);
    const double s201 = s200 - tx;
    const double s204 = s203 - ty;
    const double s608 = s184*(f1z*s577 + f2z*s577);
    const double s611 = s184*(f1y*s577 + f2y*s577);
    const double s614 = s184*(f1x*s577 + f2x*s577);
    const double s631 = -s166*(R0_11*s614 + R0_21*s611 + R0_31*s608);
    const double s632 = s164*(R0_12*s614 + R0_22*s611 + R0_32*s608) + s631;
    const double s656 = s184*(f1z*s639 - f2z*s639);
    const double s659 = s184*(f1y*s639 - f2y*s639);
    const double s662 = s184*(f1x*s639 - f2x*s639);
    const double s679 = -s166*(R0_11*s662 + R0_21*s659 + R0_31*s656);
    const double s680 = s164*(R0_12*s662 + R0_22*s659 + R0_32*s656) + s679;
    const double s719 = 1 - 2*share;
    const double s750 = f7z*s719;
    const double s752 = f7y*s719;
    const double s754 = f7x*s719;
    const double s756 = f4z*s719;
    const double s758 = -1.0/2.0*s750 + (1.0/2.0)*s756;
    const double s760 = (1.0/2.0)*s750 + (1.0/2.0)*s756;
    const double s762 = f4y*s719;
    const double s764 = -1.0/2.0*s752 + (1.0/2.0)*s762;
    const double s766 = (1.0/2.0)*s752 + (1.0/2.0)*s762;
    const double s768 = f4x*s719;
    const double s770 = -1.0/2.0*s754 + (1.0/2.0)*s768;
    const double s772 = (1.0/2.0)*s754 + (1.0/2.0)*s768;
    const double s776 = f8z*share;
    const double s778 = f8y*share;
    const double s780 = f8x*share;
    const double s782 = f6z*share;
    const double s784 = f6y*share;
    const double s786 = f6x*share;
    const double s788 = f5z*share;
    const double s790 = f5y*share;
    const double s792 = f5x*share;
    const double s794 = f3z*share;
    const double s796 = f3y*share;
    const double s798 = f3x*share;
    const double s799 = s758 - s776 + s788;
    const double s806 = s764 - s778 + s790;
    const double s813 = s770 - s780 + s792;
    const double s820 = s758 - s782 + s794;
    const double s825 = s764 - s784 + s796;
    const double s830 = s770 - s786 + s798;
    const double s835 = s760 + s776 + s788;
    const double s842 = s766 + s778 + s790;
    const double s849 = s772 + s780 + s792;
    const double s858 = s760 + s782 + s794;
    const double s863 = s766 + s784 + s796;
    const double s868 = s772 + s786 + s798;
    const double s873 = g_y*s820 + s858*tip_v;
    const double s878 = g_x*s820 + s184*s858;
    const double s883 = g_y*s825 + s863*tip_v;
    const double s888 = g_x*s825 + s184*s863;
    const double s893 = g_y*s830 + s868*tip_v;
    const double s898 = g_x*s830 + s184*s868;
    const double s902 = s164*(-R0_11*s893 + R0_12*s898 - R0_21*s883 + R0_22*s888 - R0_31*s873 + R0_32*s878);
    const double s905 = R0_11*s898 + R0_12*s893 + R0_21*s888 + R0_22*s883 + R0_31*s878 + R0_32*s873;
    const double s907 = -s166*s905 + s902;
    const double s909 = h_z*s799 - s835*tz;
    const double s911 = h_y*s799 + s204*s835;
    const double s913 = h_x*s799 + s201*s835;
    const double s915 = h_z*s806 - s842*tz;
    const double s916 = h_y*s806 + s204*s842;
    const double s917 = h_x*s806 + s201*s842;
    const double s918 = h_z*s813 - s849*tz;
    const double s919 = h_y*s813 + s204*s849;
    const double s920 = h_x*s813 + s201*s849;
    const double s938 = R_21*s913 + R_22*s911 + R_23*s909 - R_31*s917 - R_32*s916 - R_33*s915;
    const double s945 = -R_11*s913 - R_12*s911 - R_13*s909 + R_31*s920 + R_32*s919 + R_33*s918;
    const double s952 = R_11*s917 + R_12*s916 + R_13*s915 - R_21*s920 - R_22*s919 - R_23*s918;
    (void)(s);
    (void)(gravity);
    d[31] = s632;
    d[32] = s680;
    d[33] = s907;
    d[34] = s849;
    d[35] = s842;
    d[36] = s835;
    d[37] = s938;
    d[38] = s945;
    d[39] = s952;
}

/* Gravity less acceleration of the points of a platform (126 operations). */
static void platform_fields(const double *w, const double *d, double *s, const double *gravity)
{
    const double tx = w[1];
    const double ty = w[2];
    const double tz = w[3];
    const double R_11 = w[10];
    const double R_12 = w[11];
    const double R_13 = w[12];
    const double R_21 = w[13];
    const double R_22 = w[14];
    const double R_23 = w[15];
    const double R_31 = w[16];
    const double R_32 = w[17];
    const double R_33 = w[18];
    const double w_x = s[21];
    const double w_y = s[22];
    const double w_z = s[23];
    const double v_px_t = s[24];
    const double v_py_t = s[25];
    const double v_pz_t = s[26];
    const double w_x_t = s[27];
    const double w_y_t = s[28];
    const double w_z_t = s[29];
    const double gx = gravity[0];
    const double gy = gravity[1];
    const double gz = gravity[2];
    const double s307 = -R_21*w_z + R_31*w_y;
    const double s310 = -R_22*w_z + R_32*w_y;
    const double s313 = -R_23*w_z + R_33*w_y;
    const double s316 = R_11*w_z - R_31*w_x;
    const double s319 = R_12*w_z - R_32*w_x;
    const double s322 = R_13*w_z - R_33*w_x;
    const double s325 = -R_11*w_y + R_21*w_x;
    const double s328 = -R_12*w_y + R_22*w_x;
    const double s331 = -R_13*w_y + R_23*w_x;
    const double s594 = -tx*(-R_21*w_z_t + R_31*w_y_t - s316*w_z + s325*w_y);
    const double s595 = -ty*(-R_22*w_z_t + R_32*w_y_t - s319*w_z + s328*w_y);
    const double s596 = s594 + s595 - tz*(-R_23*w_z_t + R_33*w_y_t - s322*w_z + s331*w_y) + v_px_t;
    const double s598 = -tx*(R_11*w_z_t - R_31*w_x_t + s307*w_z - s325*w_x);
    const double s599 = -ty*(R_12*w_z_t - R_32*w_x_t + s310*w_z - s328*w_x);
    const double s600 = s598 + s599 - tz*(R_13*w_z_t - R_33*w_x_t + s313*w_z - s331*w_x) + v_py_t;
    const double s602 = -tx*(-R_11*w_y_t + R_21*w_x_t - s307*w_y + s316*w_x);
    const double s603 = -ty*(-R_12*w_y_t + R_22*w_x_t - s310*w_y + s319*w_x);
    const double s604 = s602 + s603 - tz*(-R_13*w_y_t + R_23*w_x_t - s313*w_y + s322*w_x) + v_pz_t;
    const double s708 = gx - 1.0/1000.0*s596;
    const double s710 = gy - 1.0/1000.0*s600;
    const double s712 = gz - 1.0/1000.0*s604;
    const double s714 = gx - 1.0/1000.0*v_px_t;
    const double s716 = gy - 1.0/1000.0*v_py_t;
    const double s718 = gz - 1.0/1000.0*v_pz_t;
    (void)(d);
    s[30] = s708;
    s[31] = s710;
    s[32] = s712;
    s[33] = s714;
    s[34] = s716;
    s[35] = s718;
}

/* Loads per inertial parameter of a platform, along joint, shifts and turns (51 operations). */
static void platform_asks(const double *w, const double *d, double *s)
{
    const double tx = w[1];
    const double ty = w[2];
    const double tz = w[3];
    const double R_11 = w[10];
    const double R_12 = w[11];
    const double R_13 = w[12];
    const double R_21 = w[13];
    const double R_22 = w[14];
    const double R_23 = w[15];
    const double R_31 = w[16];
    const double R_32 = w[17];
    const double R_33 = w[18];
    const double f0x = s[30];
    const double f0y = s[31];
    const double f0z = s[32];
    const double f1x = s[33];
    const double f1y = s[34];
    const double f1z = s[35];
    const double s259 = -f0z*ty;
    const double s261 = -f0z*tx;
    const double s263 = -f0y*ty;
    const double s265 = -f0y*tx;
    const double s267 = -f0x*ty;
    const double s269 = -f0x*tx;
    const double s271 = -f0z*tz;
    const double s273 = -f0y*tz;
    const double s275 = -f0x*tz;
    const double s286 = R_21*s261 + R_22*s259 + R_23*s271 - R_31*s265 - R_32*s263 - R_33*s273;
    const double s293 = -R_11*s261 - R_12*s259 - R_13*s271 + R_31*s269 + R_32*s267 + R_33*s275;
    const double s300 = R_11*s265 + R_12*s263 + R_13*s273 - R_21*s269 - R_22*s267 - R_23*s275;
    (void)(d);
    s[36] = f0x;
    s[37] = f0y;
    s[38] = f0z;
    s[39] = s286;
    s[40] = s293;
    s[41] = s300;
    s[42] = f1x;
    s[43] = f1y;
    s[44] = f1z;
}

/* What the joints give (114 operations). */
static void give(const double *d, double *s, const double *inertia)
{
    const double a_0_0 = d[31];
    const double a_0_1 = d[32];
    const double a_0_2 = d[33];
    const double a_0_3 = d[34];
    const double a_0_4 = d[35];
    const double a_0_5 = d[36];
    const double a_0_6 = d[37];
    const double a_0_7 = d[38];
    const double a_0_8 = d[39];
    const double a_1_0 = d[71];
    const double a_1_1 = d[72];
    const double a_1_2 = d[73];
    const double a_1_3 = d[74];
    const double a_1_4 = d[75];
    const double a_1_5 = d[76];
    const double a_1_6 = d[77];
    const double a_1_7 = d[78];
    const double a_1_8 = d[79];
    const double a_2_0 = d[111];
    const double a_2_1 = d[112];
    const double a_2_2 = d[113];
    const double a_2_3 = d[114];
    const double a_2_4 = d[115];
    const double a_2_5 = d[116];
    const double a_2_6 = d[117];
    const double a_2_7 = d[118];
    const double a_2_8 = d[119];
    const double a_p_0 = s[36];
    const double a_p_1 = s[37];
    const double a_p_2 = s[38];
    const double a_p_3 = s[39];
    const double a_p_4 = s[40];
    const double a_p_5 = s[41];
    const double a_p_6 = s[42];
    const double a_p_7 = s[43];
    const double a_p_8 = s[44];
    const double V_0_0 = s[0];
    const double V_0_1 = s[1];
    const double V_0_2 = s[2];
    const double V_1_0 = s[3];
    const double V_1_1 = s[4];
    const double V_1_2 = s[5];
    const double V_2_0 = s[6];
    const double V_2_1 = s[7];
    const double V_2_2 = s[8];
    const double V_3_0 = s[9];
    const double V_3_1 = s[10];
    const double V_3_2 = s[11];
    const double V_4_0 = s[12];
    const double V_4_1 = s[13];
    const double V_4_2 = s[14];
    const double V_5_0 = s[15];
    const double V_5_1 = s[16];
    const double V_5_2 = s[17];
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
    const double W_0 = a_0_3*m_3 + a_1_3*m_7 + a_2_3*m_11 + a_p_0*m_12 + a_p_6*m_13;
    const double W_1 = a_0_4*m_3 + a_1_4*m_7 + a_2_4*m_11 + a_p_1*m_12 + a_p_7*m_13;
    const double W_2 = a_0_5*m_3 + a_1_5*m_7 + a_2_5*m_11 + a_p_2*m_12 + a_p_8*m_13;
    const double W_3 = a_0_6*m_3 + a_1_6*m_7 + a_2_6*m_11 + a_p_3*m_12;
    const double W_4 = a_0_7*m_3 + a_1_7*m_7 + a_2_7*m_11 + a_p_4*m_12;
    const double W_5 = a_0_8*m_3 + a_1_8*m_7 + a_2_8*m_11 + a_p_5*m_12;
    const double s37 = -V_4_0*W_4;
    const double s38 = -V_5_0*W_5;
    const double s39 = -a_0_0*m_1;
    const double s40 = -a_0_1*m_2;
    const double s41 = -a_0_2*m_3;
    const double s42 = -V_0_0*W_0 - V_1_0*W_1 - V_2_0*W_2 - V_3_0*W_3 + s37 + s38 + s39 + s40 + s41;
    const double s47 = -V_4_1*W_4;
    const double s48 = -V_5_1*W_5;
    const double s49 = -a_1_0*m_5;
    const double s50 = -a_1_1*m_6;
    const double s51 = -a_1_2*m_7;
    const double s52 = -V_0_1*W_0 - V_1_1*W_1 - V_2_1*W_2 - V_3_1*W_3 + s47 + s48 + s49 + s50 + s51;
    const double s57 = -V_4_2*W_4;
    const double s58 = -V_5_2*W_5;
    const double s59 = -a_2_0*m_9;
    const double s60 = -a_2_1*m_10;
    const double s61 = -a_2_2*m_11;
    const double s62 = -V_0_2*W_0 - V_1_2*W_1 - V_2_2*W_2 - V_3_2*W_3 + s57 + s58 + s59 + s60 + s61;
    s[45] = s42;
    s[46] = s52;
    s[47] = s62;
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
    double w[339] = { 0.0 };
    int i, c, steps;
    for (i = 0; i < 3; i++) {
        w[LIMB_W * i + 0] = q[i];
        for (c = 0; c < 3; c++)
            w[LIMB_W * i + 1 + c] = DELTACAL_TOOL[c];
        for (c = 0; c < 6; c++)
            w[LIMB_W * i + 4 + c] = c < 3 ? target[c] : 0.0;
        early(w + LIMB_W * i, DELTACAL_MOTION_K[i]);
        more(w + LIMB_W * i, DELTACAL_MOTION_K[i]);
    }
    w[290] = 1.0;
    place(w);
    for (steps = 0; steps < PLATFORM_STEPS; steps++) {
        double size = 0.0;
        for (i = 0; i < 3; i++)
            rows(w + LIMB_W * i, DELTACAL_MOTION_K[i]);
        step(w);
        place(w);
        for (c = 0; c < 6; c++)
            size = fmax(size, fabs(w[282 + c]));
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
        qdd[c] = acceleration[c] - s[24 + c];
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
    double x[6], speed[3], change[3]; /* of turns: Cayley vector, rad/s, rad/s^2 */
    double q[3], qd[3], qdd[3], joints[3], torque[3];
    double d[LIMB_D * 3] = { 0.0 }, s[66] = { 0.0 };
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
        load = DELTACAL_SIGN[i] * s[45 + i];
        give(d, s, DELTACAL_PAYLOAD);
        carried = DELTACAL_SIGN[i] * s[45 + i] * payload_kg;
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

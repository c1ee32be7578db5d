/*
 * Generated from derive/mechanisms/linear_delta.py by "deltacal kernels". Do not edit.
 * Template templates/mechanism/dynamics.c.jinja; sha256 of both af8197643aad78af; SymPy 1.14.0.
 *
 * The calibrated machine in motion: joints, their speeds and accelerations by those of the reference point, and what
 * the drives must give. w and d hold a region for each limb, w and s what all limbs share.
 */
#define LIMB_W 66
#define LIMB_D 33
#define PLATFORM_STEPS 8 /* of Newton's method, at most, until the platform stands at the joints */
#define PLATFORM_DONE 1e-9 /* mm and rad */

/* What moves with a joint only; then the simplified limb as a sphere |P|^2 - 2 c.P + d = 0: c, d (20 operations). */
static void early(double *w, const double *k)
{
    const double q = w[0];
    const double tx = w[1];
    const double ty = w[2];
    const double tz = w[3];
    const double s60 = k[0];
    const double s59 = k[1];
    const double axis_x = k[2];
    const double s65 = k[3];
    const double axis_y = k[4];
    const double s68 = k[5];
    const double axis_z = k[6];
    const double s106 = k[7];
    const double s109 = k[8];
    const double s660 = k[14];
    const double s665 = k[15];
    const double h = k[16];
    const double s53 = k[40];
    const double s61 = -q*s60;
    const double s62 = s59 + s61;
    const double C_x = axis_x*s62 + s65;
    const double C_y = axis_y*s62 + s68;
    const double C_z = axis_z*s62;
    const double s107 = s106 - tx;
    const double s110 = s109 - ty;
    const double s687 = -s660 + tx;
    const double s688 = -s665 + ty;
    const double s689 = h + s61 + tz;
    const double s693 = -s53 + (s687 * s687) + (s688 * s688) + (s689 * s689);
    w[35] = s107;
    w[36] = s110;
    w[37] = C_x;
    w[38] = C_y;
    w[39] = C_z;
    w[40] = s687;
    w[41] = s688;
    w[42] = s689;
    w[43] = s693;
}

/* What else derivatives by joint and errors read of it (2 operations). */
static void more(double *w, const double *k)
{
    const double q = w[0];
    const double s60 = k[0];
    const double s59 = k[1];
    const double s62 = -q*s60 + s59;
    w[45] = s62;
}

/* Equations of a limb, their derivatives by shift and turn of the platform (124 operations). */
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
    const double s107 = w[35];
    const double s110 = w[36];
    const double C_x = w[37];
    const double C_y = w[38];
    const double C_z = w[39];
    const double u_x = k[9];
    const double u_y = k[10];
    const double s128 = k[11];
    const double s714 = k[41];
    const double s870 = k[42];
    const double s1009 = k[43];
    const double s1011 = k[44];
    const double s108 = R_11*s107;
    const double s111 = R_12*s110;
    const double s112 = -R_13*tz;
    const double A_x = px + s108 + s111 + s112;
    const double s114 = R_21*s107;
    const double s115 = R_22*s110;
    const double s116 = -R_23*tz;
    const double A_y = py + s114 + s115 + s116;
    const double s118 = R_31*s107;
    const double s119 = R_32*s110;
    const double s120 = -R_33*tz;
    const double A_z = pz + s118 + s119 + s120;
    const double d_x = A_x - C_x;
    const double d_y = A_y - C_y;
    const double d_z = A_z - C_z;
    const double s_x = s128*(-R_11*u_y + R_12*u_x + u_y);
    const double s_y = s128*(-R_21*u_y + R_22*u_x - u_x);
    const double s_z = s128*(-R_31*u_y + R_32*u_x);
    const double s704 = (1.0/2.0)*(s_x * s_x);
    const double s706 = (1.0/2.0)*(s_y * s_y);
    const double s708 = (1.0/2.0)*(s_z * s_z);
    const double s715 = (1.0/2.0)*(d_x * d_x) + (1.0/2.0)*(d_y * d_y) + (1.0/2.0)*(d_z * d_z) + s704 + s706 + s708 + s714;
    const double s871 = d_x*s_x + d_y*s_y + d_z*s_z + s870;
    const double s1005 = -s118 - s119 - s120;
    const double s1007 = s114 + s115 + s116;
    const double s1013 = R_31*s1009 + R_32*s1011;
    const double s1017 = -R_21*s1009 - R_22*s1011;
    const double s1019 = d_y*s1005 + d_z*s1007 + s1013*s_y + s1017*s_z;
    const double s1021 = -s108 - s111 - s112;
    const double s1026 = R_11*s1009 + R_12*s1011;
    const double s1028 = -d_x*s1005 + d_z*s1021 - s1013*s_x + s1026*s_z;
    const double s1033 = -d_x*s1007 - d_y*s1021 - s1017*s_x - s1026*s_y;
    const double s1038 = d_y*s1013 + d_z*s1017 + s1005*s_y + s1007*s_z;
    const double s1043 = -d_x*s1013 + d_z*s1026 - s1005*s_x + s1021*s_z;
    const double s1048 = -d_x*s1017 - d_y*s1026 - s1007*s_x - s1021*s_y;
    w[19] = s715;
    w[20] = d_x;
    w[21] = d_y;
    w[22] = d_z;
    w[23] = s1019;
    w[24] = s1028;
    w[25] = s1033;
    w[27] = s871;
    w[28] = s_x;
    w[29] = s_y;
    w[30] = s_z;
    w[31] = s1038;
    w[32] = s1043;
    w[33] = s1048;
}

/* Derivatives of a limb's equations by its joint (45 operations). */
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
    const double s107 = w[35];
    const double s110 = w[36];
    const double C_x = w[37];
    const double C_y = w[38];
    const double C_z = w[39];
    const double u_x = k[9];
    const double u_y = k[10];
    const double s128 = k[11];
    const double s1049 = k[45];
    const double s1051 = k[46];
    const double s1053 = k[47];
    const double A_x = R_11*s107 + R_12*s110 - R_13*tz + px;
    const double A_y = R_21*s107 + R_22*s110 - R_23*tz + py;
    const double A_z = R_31*s107 + R_32*s110 - R_33*tz + pz;
    const double d_x = A_x - C_x;
    const double d_y = A_y - C_y;
    const double d_z = A_z - C_z;
    const double s_x = s128*(-R_11*u_y + R_12*u_x + u_y);
    const double s_y = s128*(-R_21*u_y + R_22*u_x - u_x);
    const double s_z = s128*(-R_31*u_y + R_32*u_x);
    const double s1055 = d_x*s1049 + d_y*s1051 + d_z*s1053;
    const double s1059 = s1049*s_x + s1051*s_y + s1053*s_z;
    w[26] = s1055;
    w[34] = s1059;
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
    const double F10 = w[85];
    const double J10_0 = w[86];
    const double J10_1 = w[87];
    const double J10_2 = w[88];
    const double J10_3 = w[89];
    const double J10_4 = w[90];
    const double J10_5 = w[91];
    const double F11 = w[93];
    const double J11_0 = w[94];
    const double J11_1 = w[95];
    const double J11_2 = w[96];
    const double J11_3 = w[97];
    const double J11_4 = w[98];
    const double J11_5 = w[99];
    const double F20 = w[151];
    const double J20_0 = w[152];
    const double J20_1 = w[153];
    const double J20_2 = w[154];
    const double J20_3 = w[155];
    const double J20_4 = w[156];
    const double J20_5 = w[157];
    const double F21 = w[159];
    const double J21_0 = w[160];
    const double J21_1 = w[161];
    const double J21_2 = w[162];
    const double J21_3 = w[163];
    const double J21_4 = w[164];
    const double J21_5 = w[165];
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
    w[198] = s193;
    w[199] = s197;
    w[200] = s201;
    w[201] = w_00;
    w[202] = w_10;
    w[203] = w_20;
    w[204] = s216;
    w[205] = s231;
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
    const double J10_0 = w[86];
    const double J10_1 = w[87];
    const double J10_2 = w[88];
    const double J10_3 = w[89];
    const double J10_4 = w[90];
    const double J10_5 = w[91];
    const double J11_0 = w[94];
    const double J11_1 = w[95];
    const double J11_2 = w[96];
    const double J11_3 = w[97];
    const double J11_4 = w[98];
    const double J11_5 = w[99];
    const double J20_0 = w[152];
    const double J20_1 = w[153];
    const double J20_2 = w[154];
    const double J20_3 = w[155];
    const double J20_4 = w[156];
    const double J20_5 = w[157];
    const double J21_0 = w[160];
    const double J21_1 = w[161];
    const double J21_2 = w[162];
    const double J21_3 = w[163];
    const double J21_4 = w[164];
    const double J21_5 = w[165];
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
    w[207] = s265;
    w[208] = s269;
    w[209] = s273;
    w[210] = s277;
    w[211] = s281;
    w[212] = s285;
    w[213] = s289;
    w[214] = s293;
    w[215] = s297;
    w[216] = s301;
    w[217] = s305;
    w[218] = s309;
    w[219] = s313;
    w[220] = s317;
    w[221] = s321;
    w[222] = s325;
    w[223] = s329;
    w[224] = s333;
    w[225] = -V_00;
    w[226] = -V_01;
    w[227] = -V_02;
    w[228] = -Si_inv_00;
    w[229] = -Si_inv_01;
    w[230] = -Si_inv_02;
    w[231] = -V_10;
    w[232] = -V_11;
    w[233] = -V_12;
    w[234] = -Si_inv_10;
    w[235] = -Si_inv_11;
    w[236] = -Si_inv_12;
    w[237] = -V_20;
    w[238] = -V_21;
    w[239] = -V_22;
    w[240] = -Si_inv_20;
    w[241] = -Si_inv_21;
    w[242] = -Si_inv_22;
    w[243] = s348;
    w[244] = s363;
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
    const double y0 = w[198];
    const double y1 = w[199];
    const double y2 = w[200];
    const double y3 = w[201];
    const double y4 = w[202];
    const double y5 = w[203];
    const double going = w[206];
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
    w[70] = new_00;
    w[136] = new_00;
    w[5] = new_10;
    w[71] = new_10;
    w[137] = new_10;
    w[6] = new_20;
    w[72] = new_20;
    w[138] = new_20;
    w[7] = new_30;
    w[8] = new_40;
    w[9] = new_50;
    w[10] = s51;
    w[76] = s51;
    w[142] = s51;
    w[11] = s54;
    w[77] = s54;
    w[143] = s54;
    w[12] = s57;
    w[78] = s57;
    w[144] = s57;
    w[13] = s59;
    w[79] = s59;
    w[145] = s59;
    w[14] = s63;
    w[80] = s63;
    w[146] = s63;
    w[15] = s66;
    w[81] = s66;
    w[147] = s66;
    w[16] = s68;
    w[82] = s68;
    w[148] = s68;
    w[17] = s70;
    w[83] = s70;
    w[149] = s70;
    w[18] = s73;
    w[84] = s73;
    w[150] = s73;
}

/* How the platform moves with each joint, and how it does (84 operations). */
static void move(const double *w, const double *d, double *s)
{
    const double M_0_0 = w[207];
    const double M_0_1 = w[208];
    const double M_0_2 = w[209];
    const double M_0_3 = w[210];
    const double M_0_4 = w[211];
    const double M_0_5 = w[212];
    const double M_1_0 = w[213];
    const double M_1_1 = w[214];
    const double M_1_2 = w[215];
    const double M_1_3 = w[216];
    const double M_1_4 = w[217];
    const double M_1_5 = w[218];
    const double M_2_0 = w[219];
    const double M_2_1 = w[220];
    const double M_2_2 = w[221];
    const double M_2_3 = w[222];
    const double M_2_4 = w[223];
    const double M_2_5 = w[224];
    const double M_3_0 = w[225];
    const double M_3_1 = w[226];
    const double M_3_2 = w[227];
    const double M_3_3 = w[228];
    const double M_3_4 = w[229];
    const double M_3_5 = w[230];
    const double M_4_0 = w[231];
    const double M_4_1 = w[232];
    const double M_4_2 = w[233];
    const double M_4_3 = w[234];
    const double M_4_4 = w[235];
    const double M_4_5 = w[236];
    const double M_5_0 = w[237];
    const double M_5_1 = w[238];
    const double M_5_2 = w[239];
    const double M_5_3 = w[240];
    const double M_5_4 = w[241];
    const double M_5_5 = w[242];
    const double q_t_0 = d[0];
    const double Q_0 = w[26];
    const double Q_3 = w[34];
    const double q_t_1 = d[33];
    const double Q_1 = w[92];
    const double Q_4 = w[100];
    const double q_t_2 = d[66];
    const double Q_2 = w[158];
    const double Q_5 = w[166];
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

/* Second derivatives of a limb's equations by time where nothing accelerates (206 operations). */
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
    const double s60 = k[0];
    const double s59 = k[1];
    const double axis_x = k[2];
    const double s65 = k[3];
    const double axis_y = k[4];
    const double s68 = k[5];
    const double axis_z = k[6];
    const double s71 = k[7];
    const double s74 = k[8];
    const double u_x = k[9];
    const double u_y = k[10];
    const double s93 = k[11];
    const double s62 = -q*s60 + s59;
    const double C_x = axis_x*s62 + s65;
    const double C_y = axis_y*s62 + s68;
    const double C_z = axis_z*s62;
    const double s72 = s71 - tx;
    const double s75 = s74 - ty;
    const double A_x = R_11*s72 + R_12*s75 - R_13*tz + px;
    const double A_y = R_21*s72 + R_22*s75 - R_23*tz + py;
    const double A_z = R_31*s72 + R_32*s75 - R_33*tz + pz;
    const double d_x = A_x - C_x;
    const double d_y = A_y - C_y;
    const double d_z = A_z - C_z;
    const double s_x = s93*(-R_11*u_y + R_12*u_x + u_y);
    const double s_y = s93*(-R_21*u_y + R_22*u_x - u_x);
    const double s_z = s93*(-R_31*u_y + R_32*u_x);
    const double s132 = -R_21*w_z + R_31*w_y;
    const double s135 = -R_22*w_z + R_32*w_y;
    const double s138 = -R_23*w_z + R_33*w_y;
    const double s141 = R_11*w_z - R_31*w_x;
    const double s144 = R_12*w_z - R_32*w_x;
    const double s147 = R_13*w_z - R_33*w_x;
    const double s150 = -R_11*w_y + R_21*w_x;
    const double s153 = -R_12*w_y + R_22*w_x;
    const double s156 = -R_13*w_y + R_23*w_x;
    const double s157 = -q_t*s60;
    const double s173 = -axis_x*s157 + s132*s72 + s135*s75 - s138*tz + v_px;
    const double s174 = -axis_y*s157 + s141*s72 + s144*s75 - s147*tz + v_py;
    const double s175 = -axis_z*s157 + s150*s72 + s153*s75 - s156*tz + v_pz;
    const double s179 = s93*(-s132*u_y + s135*u_x);
    const double s183 = s93*(-s141*u_y + s144*u_x);
    const double s187 = s93*(-s150*u_y + s153*u_x);
    const double s219 = -s141*w_z + s150*w_y;
    const double s222 = -s144*w_z + s153*w_y;
    const double s228 = s132*w_z - s150*w_x;
    const double s231 = s135*w_z - s153*w_x;
    const double s237 = -s132*w_y + s141*w_x;
    const double s240 = -s135*w_y + s144*w_x;
    const double s247 = s219*s72 + s222*s75 - tz*(-s147*w_z + s156*w_y);
    const double s251 = s228*s72 + s231*s75 - tz*(s138*w_z - s156*w_x);
    const double s255 = s237*s72 + s240*s75 - tz*(-s138*w_y + s147*w_x);
    const double s259 = s93*(-s219*u_y + s222*u_x);
    const double s263 = s93*(-s228*u_y + s231*u_x);
    const double s267 = s93*(-s237*u_y + s240*u_x);
    const double s282 = d_z*s255 + (s175 * s175);
    const double s287 = (s179 * s179) + s259*s_x;
    const double s292 = (s183 * s183) + s263*s_y;
    const double s297 = (s187 * s187) + s267*s_z;
    const double s298 = d_x*s247 + d_y*s251 + (s173 * s173) + (s174 * s174) + s282 + s287 + s292 + s297;
    const double s300 = s173*s179;
    const double s306 = s174*s183;
    const double s312 = s175*s187;
    const double s316 = d_z*s267 + s255*s_z + 2*s312;
    const double s317 = d_x*s259 + d_y*s263 + s247*s_x + s251*s_y + 2*s300 + 2*s306 + s316;
    (void)(gravity);
    (void)(shares);
    d[2] = s298;
    d[3] = s317;
}

/* The platform's acceleration (102 operations). */
static void accelerate(const double *w, const double *d, double *s)
{
    const double M_0_0 = w[207];
    const double M_0_1 = w[208];
    const double M_0_2 = w[209];
    const double M_0_3 = w[210];
    const double M_0_4 = w[211];
    const double M_0_5 = w[212];
    const double M_1_0 = w[213];
    const double M_1_1 = w[214];
    const double M_1_2 = w[215];
    const double M_1_3 = w[216];
    const double M_1_4 = w[217];
    const double M_1_5 = w[218];
    const double M_2_0 = w[219];
    const double M_2_1 = w[220];
    const double M_2_2 = w[221];
    const double M_2_3 = w[222];
    const double M_2_4 = w[223];
    const double M_2_5 = w[224];
    const double M_3_0 = w[225];
    const double M_3_1 = w[226];
    const double M_3_2 = w[227];
    const double M_3_3 = w[228];
    const double M_3_4 = w[229];
    const double M_3_5 = w[230];
    const double M_4_0 = w[231];
    const double M_4_1 = w[232];
    const double M_4_2 = w[233];
    const double M_4_3 = w[234];
    const double M_4_4 = w[235];
    const double M_4_5 = w[236];
    const double M_5_0 = w[237];
    const double M_5_1 = w[238];
    const double M_5_2 = w[239];
    const double M_5_3 = w[240];
    const double M_5_4 = w[241];
    const double M_5_5 = w[242];
    const double q_tt_0 = d[1];
    const double c_0 = d[2];
    const double c_3 = d[3];
    const double q_tt_1 = d[34];
    const double c_1 = d[35];
    const double c_4 = d[36];
    const double q_tt_2 = d[67];
    const double c_2 = d[68];
    const double c_5 = d[69];
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

/* Gravity less acceleration of the points of a limb (226 operations). */
static void limb_fields(const double *w, double *d, const double *s, const double *k, const double *gravity, const double *shares)
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
    const double q_tt = d[1];
    const double gx = gravity[0];
    const double gy = gravity[1];
    const double gz = gravity[2];
    const double s60 = k[0];
    const double axis_x = k[2];
    const double axis_y = k[4];
    const double axis_z = k[6];
    const double s71 = k[7];
    const double s74 = k[8];
    const double s362 = k[12];
    const double s359 = k[13];
    const double s400 = k[14];
    const double s402 = k[15];
    const double s72 = s71 - tx;
    const double s75 = s74 - ty;
    const double s132 = -R_21*w_z + R_31*w_y;
    const double s135 = -R_22*w_z + R_32*w_y;
    const double s138 = -R_23*w_z + R_33*w_y;
    const double s141 = R_11*w_z - R_31*w_x;
    const double s144 = R_12*w_z - R_32*w_x;
    const double s147 = R_13*w_z - R_33*w_x;
    const double s150 = -R_11*w_y + R_21*w_x;
    const double s153 = -R_12*w_y + R_22*w_x;
    const double s156 = -R_13*w_y + R_23*w_x;
    const double s845 = -R_21*w_z_t + R_31*w_y_t - s141*w_z + s150*w_y;
    const double s850 = -R_22*w_z_t + R_32*w_y_t - s144*w_z + s153*w_y;
    const double s860 = R_11*w_z_t - R_31*w_x_t + s132*w_z - s150*w_x;
    const double s865 = R_12*w_z_t - R_32*w_x_t + s135*w_z - s153*w_x;
    const double s875 = -R_11*w_y_t + R_21*w_x_t - s132*w_y + s141*w_x;
    const double s880 = -R_12*w_y_t + R_22*w_x_t - s135*w_y + s144*w_x;
    const double s886 = -q_tt*s60;
    const double s887 = axis_x*s886;
    const double s888 = axis_y*s886;
    const double s889 = axis_z*s886;
    const double s892 = -tz*(-R_23*w_z_t + R_33*w_y_t - s147*w_z + s156*w_y);
    const double s893 = s72*s845 + s75*s850 + s892 + v_px_t;
    const double s896 = -tz*(R_13*w_z_t - R_33*w_x_t + s138*w_z - s156*w_x);
    const double s897 = s72*s860 + s75*s865 + s896 + v_py_t;
    const double s900 = -tz*(-R_13*w_y_t + R_23*w_x_t - s138*w_y + s147*w_x);
    const double s901 = s72*s875 + s75*s880 + s900 + v_pz_t;
    const double s1427 = s362*s850;
    const double s1428 = s359*s845;
    const double s1431 = s362*s865;
    const double s1432 = s359*s860;
    const double s1435 = s362*s880;
    const double s1436 = s359*s875;
    const double s1449 = (1.0/2.0)*s893;
    const double s1450 = (1.0/2.0)*s887;
    const double s1451 = s400*s845;
    const double s1452 = s402*s850;
    const double s1455 = (1.0/2.0)*s897;
    const double s1456 = (1.0/2.0)*s888;
    const double s1457 = s400*s860;
    const double s1458 = s402*s865;
    const double s1461 = (1.0/2.0)*s901;
    const double s1462 = (1.0/2.0)*s889;
    const double s1463 = s400*s875;
    const double s1464 = s402*s880;
    const double s1550 = gx - 1.0/1000.0*s887;
    const double s1552 = gy - 1.0/1000.0*s888;
    const double s1554 = gz - 1.0/1000.0*s889;
    const double s1556 = gx - 1.0/1000.0*s1449 - 1.0/1000.0*s1450 - 1.0/1000.0*s1451 - 1.0/1000.0*s1452;
    const double s1558 = gy - 1.0/1000.0*s1455 - 1.0/1000.0*s1456 - 1.0/1000.0*s1457 - 1.0/1000.0*s1458;
    const double s1560 = gz - 1.0/1000.0*s1461 - 1.0/1000.0*s1462 - 1.0/1000.0*s1463 - 1.0/1000.0*s1464;
    const double s1562 = gx - 1.0/1000.0*s1427 - 1.0/1000.0*s1428 - 1.0/1000.0*s893;
    const double s1564 = gy - 1.0/1000.0*s1431 - 1.0/1000.0*s1432 - 1.0/1000.0*s897;
    const double s1566 = gz - 1.0/1000.0*s1435 - 1.0/1000.0*s1436 - 1.0/1000.0*s901;
    const double s1568 = gx - 1.0/1000.0*s1449 - 1.0/1000.0*s1450 + (1.0/1000.0)*s1451 + (1.0/1000.0)*s1452;
    const double s1570 = gy - 1.0/1000.0*s1455 - 1.0/1000.0*s1456 + (1.0/1000.0)*s1457 + (1.0/1000.0)*s1458;
    const double s1572 = gz - 1.0/1000.0*s1461 - 1.0/1000.0*s1462 + (1.0/1000.0)*s1463 + (1.0/1000.0)*s1464;
    const double s1574 = gx + (1.0/1000.0)*s1427 + (1.0/1000.0)*s1428 - 1.0/1000.0*s893;
    const double s1576 = gy + (1.0/1000.0)*s1431 + (1.0/1000.0)*s1432 - 1.0/1000.0*s897;
    const double s1578 = gz + (1.0/1000.0)*s1435 + (1.0/1000.0)*s1436 - 1.0/1000.0*s901;
    (void)(shares);
    d[4] = s1550;
    d[5] = s1552;
    d[6] = s1554;
    d[7] = s1550;
    d[8] = s1552;
    d[9] = s1554;
    d[10] = s1556;
    d[11] = s1558;
    d[12] = s1560;
    d[13] = s1562;
    d[14] = s1564;
    d[15] = s1566;
    d[16] = s1550;
    d[17] = s1552;
    d[18] = s1554;
    d[19] = s1568;
    d[20] = s1570;
    d[21] = s1572;
    d[22] = s1574;
    d[23] = s1576;
    d[24] = s1578;
}

/* Loads per inertial parameter of a limb, along joint, shifts and turns (132 operations). */
static void limb_asks(const double *w, double *d, const double *s, const double *k, const double *gravity, const double *shares)
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
    const double share = shares[0];
    const double f0x = d[4];
    const double f0y = d[5];
    const double f0z = d[6];
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
    const double s60 = k[0];
    const double axis_x = k[2];
    const double axis_y = k[4];
    const double axis_z = k[6];
    const double s71 = k[7];
    const double s74 = k[8];
    const double s362 = k[12];
    const double s359 = k[13];
    const double s400 = k[14];
    const double s402 = k[15];
    const double s72 = s71 - tx;
    const double s75 = s74 - ty;
    const double s356 = -s60*(axis_x*f0x + axis_y*f0y + axis_z*f0z);
    const double s397 = 1 - 2*share;
    const double s430 = f5z*s397;
    const double s432 = f5y*s397;
    const double s434 = f5x*s397;
    const double s436 = f2z*s397;
    const double s437 = -s430 + s436;
    const double s443 = (1.0/2.0)*s430 + (1.0/2.0)*s436;
    const double s445 = f2y*s397;
    const double s446 = -s432 + s445;
    const double s452 = (1.0/2.0)*s432 + (1.0/2.0)*s445;
    const double s454 = f2x*s397;
    const double s455 = -s434 + s454;
    const double s461 = (1.0/2.0)*s434 + (1.0/2.0)*s454;
    const double s465 = f6z*share;
    const double s467 = f6y*share;
    const double s469 = f6x*share;
    const double s471 = f3z*share;
    const double s472 = -s465 + s471;
    const double s478 = f3y*share;
    const double s479 = -s467 + s478;
    const double s485 = f3x*share;
    const double s486 = -s469 + s485;
    const double s502 = s443 + s465 + s471;
    const double s503 = -s502*tz;
    const double s509 = s452 + s467 + s478;
    const double s510 = -s509*tz;
    const double s516 = s461 + s469 + s485;
    const double s517 = -s516*tz;
    const double s533 = axis_x*(f1x*share + f4x*share + s461);
    const double s534 = axis_y*(f1y*share + f4y*share + s452) + axis_z*(f1z*share + f4z*share + s443) + s533;
    const double s535 = -s534*s60;
    const double s539 = s362*s472 + s402*s437 + s502*s75;
    const double s540 = s359*s472 + s400*s437 + s502*s72;
    const double s541 = s362*s479 + s402*s446 + s509*s75;
    const double s542 = s359*s479 + s400*s446 + s509*s72;
    const double s543 = s362*s486 + s402*s455 + s516*s75;
    const double s544 = s359*s486 + s400*s455 + s516*s72;
    const double s555 = R_21*s540 + R_22*s539 + R_23*s503 - R_31*s542 - R_32*s541 - R_33*s510;
    const double s562 = -R_11*s540 - R_12*s539 - R_13*s503 + R_31*s544 + R_32*s543 + R_33*s517;
    const double s569 = R_11*s542 + R_12*s541 + R_13*s510 - R_21*s544 - R_22*s543 - R_23*s517;
    (void)(s);
    (void)(gravity);
    d[25] = s356;
    d[26] = s535;
    d[27] = s516;
    d[28] = s509;
    d[29] = s502;
    d[30] = s555;
    d[31] = s562;
    d[32] = s569;
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
    const double s164 = -R_21*w_z + R_31*w_y;
    const double s167 = -R_22*w_z + R_32*w_y;
    const double s170 = -R_23*w_z + R_33*w_y;
    const double s173 = R_11*w_z - R_31*w_x;
    const double s176 = R_12*w_z - R_32*w_x;
    const double s179 = R_13*w_z - R_33*w_x;
    const double s182 = -R_11*w_y + R_21*w_x;
    const double s185 = -R_12*w_y + R_22*w_x;
    const double s188 = -R_13*w_y + R_23*w_x;
    const double s373 = -tx*(-R_21*w_z_t + R_31*w_y_t - s173*w_z + s182*w_y);
    const double s374 = -ty*(-R_22*w_z_t + R_32*w_y_t - s176*w_z + s185*w_y);
    const double s375 = s373 + s374 - tz*(-R_23*w_z_t + R_33*w_y_t - s179*w_z + s188*w_y) + v_px_t;
    const double s377 = -tx*(R_11*w_z_t - R_31*w_x_t + s164*w_z - s182*w_x);
    const double s378 = -ty*(R_12*w_z_t - R_32*w_x_t + s167*w_z - s185*w_x);
    const double s379 = s377 + s378 - tz*(R_13*w_z_t - R_33*w_x_t + s170*w_z - s188*w_x) + v_py_t;
    const double s381 = -tx*(-R_11*w_y_t + R_21*w_x_t - s164*w_y + s173*w_x);
    const double s382 = -ty*(-R_12*w_y_t + R_22*w_x_t - s167*w_y + s176*w_x);
    const double s383 = s381 + s382 - tz*(-R_13*w_y_t + R_23*w_x_t - s170*w_y + s179*w_x) + v_pz_t;
    const double s487 = gx - 1.0/1000.0*s375;
    const double s489 = gy - 1.0/1000.0*s379;
    const double s491 = gz - 1.0/1000.0*s383;
    const double s493 = gx - 1.0/1000.0*v_px_t;
    const double s495 = gy - 1.0/1000.0*v_py_t;
    const double s497 = gz - 1.0/1000.0*v_pz_t;
    (void)(d);
    s[30] = s487;
    s[31] = s489;
    s[32] = s491;
    s[33] = s493;
    s[34] = s495;
    s[35] = s497;
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
    const double s116 = -f0z*ty;
    const double s118 = -f0z*tx;
    const double s120 = -f0y*ty;
    const double s122 = -f0y*tx;
    const double s124 = -f0x*ty;
    const double s126 = -f0x*tx;
    const double s128 = -f0z*tz;
    const double s130 = -f0y*tz;
    const double s132 = -f0x*tz;
    const double s143 = R_21*s118 + R_22*s116 + R_23*s128 - R_31*s122 - R_32*s120 - R_33*s130;
    const double s150 = -R_11*s118 - R_12*s116 - R_13*s128 + R_31*s126 + R_32*s124 + R_33*s132;
    const double s157 = R_11*s122 + R_12*s120 + R_13*s130 - R_21*s126 - R_22*s124 - R_23*s132;
    (void)(d);
    s[36] = f0x;
    s[37] = f0y;
    s[38] = f0z;
    s[39] = s143;
    s[40] = s150;
    s[41] = s157;
    s[42] = f1x;
    s[43] = f1y;
    s[44] = f1z;
}

/* What the joints give (102 operations). */
static void give(const double *d, double *s, const double *inertia)
{
    const double a_0_0 = d[25];
    const double a_0_1 = d[26];
    const double a_0_2 = d[27];
    const double a_0_3 = d[28];
    const double a_0_4 = d[29];
    const double a_0_5 = d[30];
    const double a_0_6 = d[31];
    const double a_0_7 = d[32];
    const double a_1_0 = d[58];
    const double a_1_1 = d[59];
    const double a_1_2 = d[60];
    const double a_1_3 = d[61];
    const double a_1_4 = d[62];
    const double a_1_5 = d[63];
    const double a_1_6 = d[64];
    const double a_1_7 = d[65];
    const double a_2_0 = d[91];
    const double a_2_1 = d[92];
    const double a_2_2 = d[93];
    const double a_2_3 = d[94];
    const double a_2_4 = d[95];
    const double a_2_5 = d[96];
    const double a_2_6 = d[97];
    const double a_2_7 = d[98];
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
    const double m_0 = inertia[0];
    const double m_1 = inertia[1];
    const double m_2 = inertia[2];
    const double m_3 = inertia[3];
    const double m_4 = inertia[4];
    const double m_5 = inertia[5];
    const double m_6 = inertia[6];
    const double m_7 = inertia[7];
    const double W_0 = a_0_2*m_1 + a_1_2*m_3 + a_2_2*m_5 + a_p_0*m_6 + a_p_6*m_7;
    const double W_1 = a_0_3*m_1 + a_1_3*m_3 + a_2_3*m_5 + a_p_1*m_6 + a_p_7*m_7;
    const double W_2 = a_0_4*m_1 + a_1_4*m_3 + a_2_4*m_5 + a_p_2*m_6 + a_p_8*m_7;
    const double W_3 = a_0_5*m_1 + a_1_5*m_3 + a_2_5*m_5 + a_p_3*m_6;
    const double W_4 = a_0_6*m_1 + a_1_6*m_3 + a_2_6*m_5 + a_p_4*m_6;
    const double W_5 = a_0_7*m_1 + a_1_7*m_3 + a_2_7*m_5 + a_p_5*m_6;
    const double s38 = -V_5_0*W_5;
    const double s39 = -a_0_0*m_0;
    const double s40 = -a_0_1*m_1;
    const double s41 = -V_0_0*W_0 - V_1_0*W_1 - V_2_0*W_2 - V_3_0*W_3 - V_4_0*W_4 + s38 + s39 + s40;
    const double s47 = -V_5_1*W_5;
    const double s48 = -a_1_0*m_2;
    const double s49 = -a_1_1*m_3;
    const double s50 = -V_0_1*W_0 - V_1_1*W_1 - V_2_1*W_2 - V_3_1*W_3 - V_4_1*W_4 + s47 + s48 + s49;
    const double s56 = -V_5_2*W_5;
    const double s57 = -a_2_0*m_4;
    const double s58 = -a_2_1*m_5;
    const double s59 = -V_0_2*W_0 - V_1_2*W_1 - V_2_2*W_2 - V_3_2*W_3 - V_4_2*W_4 + s56 + s57 + s58;
    s[45] = s41;
    s[46] = s50;
    s[47] = s59;
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
    double w[255] = { 0.0 };
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
    w[206] = 1.0;
    place(w);
    for (steps = 0; steps < PLATFORM_STEPS; steps++) {
        double size = 0.0;
        for (i = 0; i < 3; i++)
            rows(w + LIMB_W * i, DELTACAL_MOTION_K[i]);
        step(w);
        place(w);
        for (c = 0; c < 6; c++)
            size = fmax(size, fabs(w[198 + c]));
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
    double d[LIMB_D * 3] = { 0.0 }, s[63] = { 0.0 };
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
        if (held->begun && !(fabs(joints[i] - held->joints_mm[i]) <= DELTACAL_MOST_SPEED[i] * held->period_s))
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
        held->joints_mm[i] = joints[i];
        held->torque[i] = fmin(fmax(torque[i], DELTACAL_TORQUE_LOW[i]), DELTACAL_TORQUE_HIGH[i]);
        limited |= held->torque[i] != torque[i];
    }
    keep(held, past);
    held->begun = 1;
    return limited ? DELTACAL_LIMITED : DELTACAL_SOLVED;
}

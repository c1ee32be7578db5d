/*
 * Generated from derive/mechanisms/delta.py by "deltacal kernels". Do not edit.
 * Template templates/mechanism/inverse.c.jinja; sha256 of both e0526c2acbc43ed9; SymPy 1.14.0.
 *
 * The exact compensator: inverse position of the calibrated machine, by Newton on joints and platform rotation.
 * An export puts the machine's numbers before this text: DELTACAL_K[3][32], DELTACAL_TOOL[3],
 * DELTACAL_SIGN[3]. Inside: mm and rad.
 */
#include <math.h>

#define DELTACAL_SOLVED 0
#define DELTACAL_UNREACHABLE 1
#define DELTACAL_SINGULAR 2
#define JOINT_PER_UNIT 57.295779513082320877 /* deg per rad */

/* Joint commands as the controller counts them, for a target of the reference point in the robot frame {O}. */
int deltacal_compensate(const double target_mm[3], double joints_deg[3]);


#define MAX_STEPS 30
#define STEP_DONE 3e-8 /* rad; after such a step a command is exact to its square */
#define STEP_LOST 1e5 /* rad; a step of this size leads nowhere */

/* Per rod of one limb: closure, its derivatives by the platform, by the joint (452 operations). */
static void newton(const double *x, double q, const double *tool, const double *k, double *out)
{
    const double px = x[0];
    const double py = x[1];
    const double pz = x[2];
    const double cx = x[3];
    const double cy = x[4];
    const double cz = x[5];
    const double tx = tool[0];
    const double ty = tool[1];
    const double tz = tool[2];
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
    const double h_x = k[19];
    const double h_y = k[20];
    const double h_z = k[21];
    const double s293 = k[22];
    const double s954 = k[23];
    const double s163 = q + theta;
    const double s164 = cos(s163);
    const double s166 = sin(s163);
    const double R1_11 = R0_11*s164 + R0_12*s166;
    const double R1_12 = -R0_11*s166 + R0_12*s164;
    const double R1_21 = R0_21*s164 + R0_22*s166;
    const double R1_22 = -R0_21*s166 + R0_22*s164;
    const double R1_31 = R0_31*s164 + R0_32*s166;
    const double R1_32 = -R0_31*s166 + R0_32*s164;
    const double s184 = (cx * cx);
    const double s186 = (cy * cy);
    const double s188 = (cz * cz);
    const double s190 = (1.0/4.0)*s184 + (1.0/4.0)*s186 + (1.0/4.0)*s188 + 1;
    const double s191 = 1.0/s190;
    const double s192 = -1.0/2.0*s186;
    const double s193 = -1.0/2.0*s188;
    const double s194 = s192 + s193;
    const double R_11 = s191*s194 + 1;
    const double s197 = (1.0/2.0)*cx*cy;
    const double s198 = -cz + s197;
    const double R_12 = s191*s198;
    const double s200 = (1.0/2.0)*cx*cz;
    const double s201 = cy + s200;
    const double R_13 = s191*s201;
    const double s203 = cz + s197;
    const double R_21 = s191*s203;
    const double s205 = -1.0/2.0*s184;
    const double s206 = s193 + s205;
    const double R_22 = s191*s206 + 1;
    const double s209 = (1.0/2.0)*cy*cz;
    const double s210 = -cx + s209;
    const double R_23 = s191*s210;
    const double s212 = -cy + s200;
    const double R_31 = s191*s212;
    const double s214 = cx + s209;
    const double R_32 = s191*s214;
    const double s216 = s192 + s205;
    const double R_33 = s191*s216 + 1;
    const double C_x = R1_11*s219 + R1_12*tip_v + s223;
    const double C_y = R1_21*s219 + R1_22*tip_v + s228;
    const double C_z = R1_31*s219 + R1_32*tip_v + s233;
    const double s236 = s235 - tx;
    const double s239 = s238 - ty;
    const double A_x = R_11*s236 + R_12*s239 - R_13*tz + px;
    const double A_y = R_21*s236 + R_22*s239 - R_23*tz + py;
    const double A_z = R_31*s236 + R_32*s239 - R_33*tz + pz;
    const double c1_x = R1_11*g_x + R1_12*g_y + s253;
    const double c1_y = R1_21*g_x + R1_22*g_y + s257;
    const double c1_z = R1_31*g_x + R1_32*g_y + s261;
    const double a1_x = R_11*h_x + R_12*h_y + R_13*h_z;
    const double a1_y = R_21*h_x + R_22*h_y + R_23*h_z;
    const double a1_z = R_31*h_x + R_32*h_y + R_33*h_z;
    const double d_x = A_x - C_x;
    const double d_y = A_y - C_y;
    const double d_z = A_z - C_z;
    const double s_x = a1_x - c1_x;
    const double s_y = a1_y - c1_y;
    const double s_z = a1_z - c1_z;
    const double s281 = d_x + s_x;
    const double s284 = d_y + s_y;
    const double s287 = d_z + s_z;
    const double s294 = (1.0/2.0)*(s281 * s281) + (1.0/2.0)*(s284 * s284) + (1.0/2.0)*(s287 * s287) + s293;
    const double s295 = 2*s287;
    const double s296 = (1.0/2.0)*s295;
    const double s297 = 2*s284;
    const double s298 = (1.0/2.0)*s297;
    const double s299 = 2*s281;
    const double s300 = (1.0/2.0)*s299;
    const double s348 = h_z*s296 - s296*tz;
    const double s350 = s191*s348;
    const double s351 = h_y*s296 + s239*s296;
    const double s353 = s191*s351;
    const double s354 = h_x*s296 + s236*s296;
    const double s356 = s191*s354;
    const double s357 = h_z*s298 - s298*tz;
    const double s359 = s191*s357;
    const double s360 = s353 + s359;
    const double s361 = (1.0/2.0)*cz;
    const double s362 = (1.0/2.0)*cy;
    const double s365 = h_y*s298 + s239*s298;
    const double s366 = s206*s365;
    const double s367 = s191*s365;
    const double s370 = h_x*s298 + s236*s298;
    const double s371 = s203*s370;
    const double s372 = s191*s370;
    const double s373 = h_z*s300 - s300*tz;
    const double s374 = s201*s373;
    const double s375 = s191*s373;
    const double s376 = s356 + s375;
    const double s377 = (1.0/2.0)*cx;
    const double s380 = h_y*s300 + s239*s300;
    const double s381 = s198*s380;
    const double s382 = s191*s380;
    const double s383 = s372 + s382;
    const double s386 = h_x*s300 + s236*s300;
    const double s387 = s194*s386;
    const double s388 = s191*s386;
    const double s393 = s210*s357 + s212*s354 + s214*s351 + s216*s348 + s366 + s371 + s374 + s381 + s387;
    const double s394 = (1.0 / (s190 * s190));
    const double s396 = -1.0/4.0*s393*s394;
    const double s398 = 2*cz;
    const double s401 = 2*cy;
    const double s404 = 2*cx;
    const double s406 = -g_y*s296 - s296*tip_v;
    const double s411 = -g_x*s296 - s219*s296;
    const double s416 = -g_y*s298 - s298*tip_v;
    const double s421 = -g_x*s298 - s219*s298;
    const double s426 = -g_y*s300 - s300*tip_v;
    const double s431 = -g_x*s300 - s219*s300;
    const double s435 = s164*(-R0_11*s426 + R0_12*s431 - R0_21*s416 + R0_22*s421 - R0_31*s406 + R0_32*s411);
    const double s438 = R0_11*s431 + R0_12*s426 + R0_21*s421 + R0_22*s416 + R0_31*s411 + R0_32*s406;
    const double s440 = -s166*s438 + s435;
    const double s444 = s353 - s359 + s361*s376 + s362*s383 + s404*(-1.0/2.0*s350 - 1.0/2.0*s367 + s396);
    const double s445 = -s356 + s360*s361 + s375 + s377*s383 + s401*(-1.0/2.0*s350 - 1.0/2.0*s388 + s396);
    const double s446 = s360*s362 + s372 + s376*s377 - s382 + s398*(-1.0/2.0*s367 - 1.0/2.0*s388 + s396);
    const double s943 = d_x - s_x;
    const double s946 = d_y - s_y;
    const double s949 = d_z - s_z;
    const double s955 = (1.0/2.0)*(s943 * s943) + (1.0/2.0)*(s946 * s946) + (1.0/2.0)*(s949 * s949) + s954;
    const double s956 = 2*s949;
    const double s957 = (1.0/2.0)*s956;
    const double s958 = 2*s946;
    const double s959 = (1.0/2.0)*s958;
    const double s960 = 2*s943;
    const double s961 = (1.0/2.0)*s960;
    const double s1009 = -h_z*s957 - s957*tz;
    const double s1011 = s1009*s191;
    const double s1012 = -h_y*s957 + s239*s957;
    const double s1014 = s1012*s191;
    const double s1015 = -h_x*s957 + s236*s957;
    const double s1017 = s1015*s191;
    const double s1018 = -h_z*s959 - s959*tz;
    const double s1020 = s1018*s191;
    const double s1021 = s1014 + s1020;
    const double s1024 = -h_y*s959 + s239*s959;
    const double s1025 = s1024*s206;
    const double s1026 = s1024*s191;
    const double s1029 = -h_x*s959 + s236*s959;
    const double s1030 = s1029*s203;
    const double s1031 = s1029*s191;
    const double s1032 = -h_z*s961 - s961*tz;
    const double s1033 = s1032*s201;
    const double s1034 = s1032*s191;
    const double s1035 = s1017 + s1034;
    const double s1038 = -h_y*s961 + s239*s961;
    const double s1039 = s1038*s198;
    const double s1040 = s1038*s191;
    const double s1041 = s1031 + s1040;
    const double s1044 = -h_x*s961 + s236*s961;
    const double s1045 = s1044*s194;
    const double s1046 = s1044*s191;
    const double s1051 = s1009*s216 + s1012*s214 + s1015*s212 + s1018*s210 + s1025 + s1030 + s1033 + s1039 + s1045;
    const double s1053 = -1.0/4.0*s1051*s394;
    const double s1060 = g_y*s957 - s957*tip_v;
    const double s1065 = g_x*s957 - s219*s957;
    const double s1070 = g_y*s959 - s959*tip_v;
    const double s1075 = g_x*s959 - s219*s959;
    const double s1080 = g_y*s961 - s961*tip_v;
    const double s1085 = g_x*s961 - s219*s961;
    const double s1089 = s164*(-R0_11*s1080 + R0_12*s1085 - R0_21*s1070 + R0_22*s1075 - R0_31*s1060 + R0_32*s1065);
    const double s1092 = R0_11*s1085 + R0_12*s1080 + R0_21*s1075 + R0_22*s1070 + R0_31*s1065 + R0_32*s1060;
    const double s1094 = s1089 - s1092*s166;
    const double s1098 = s1014 - s1020 + s1035*s361 + s1041*s362 + s404*(-1.0/2.0*s1011 - 1.0/2.0*s1026 + s1053);
    const double s1099 = -s1017 + s1021*s361 + s1034 + s1041*s377 + s401*(-1.0/2.0*s1011 - 1.0/2.0*s1046 + s1053);
    const double s1100 = s1021*s362 + s1031 + s1035*s377 - s1040 + s398*(-1.0/2.0*s1026 - 1.0/2.0*s1046 + s1053);
    out[0] = s294;
    out[1] = s300;
    out[2] = s298;
    out[3] = s296;
    out[4] = s444;
    out[5] = s445;
    out[6] = s446;
    out[7] = s440;
    out[8] = s955;
    out[9] = s961;
    out[10] = s959;
    out[11] = s957;
    out[12] = s1098;
    out[13] = s1099;
    out[14] = s1100;
    out[15] = s1094;
}

/* Joint of the simplified limb at a given position, then the platform's coordinates that follow from it (36 operations). */
static void joint(const double *x, double q, const double *tool, const double *k, double *out)
{
    const double px = x[0];
    const double py = x[1];
    const double pz = x[2];
    const double tx = tool[0];
    const double ty = tool[1];
    const double tz = tool[2];
    const double theta = k[0];
    const double s1166 = k[24];
    const double s1168 = k[25];
    const double s1170 = k[26];
    const double s1172 = k[27];
    const double ez = k[28];
    const double s1191 = k[29];
    const double s1198 = k[30];
    const double s1203 = k[31];
    const double s1167 = px + s1166 - tx;
    const double s1171 = py + s1170 - ty;
    const double s1174 = s1167*s1168 + s1171*s1172;
    const double s1176 = -ez + pz - tz;
    const double s1177 = (s1176 * s1176);
    const double s1192 = (1.0/2.0)*(s1167 * s1167) + (1.0/2.0)*(s1171 * s1171) + (1.0/2.0)*s1177 + s1191;
    const double s1201 = sqrt((s1174 * s1174) + s1177*s1198 - (s1192 * s1192));
    const double s1210 = -theta + atan2(-s1174*s1201 + s1176*s1192*s1203, -s1174*s1192 - s1176*s1201*s1203);
    (void)(q);
    out[0] = s1210;
}

#define ROD 8 /* per rod: closure, its derivatives by the position (3), by the rotation (3), by the joint */
#define LIMB (ROD * 2)
#define PIVOT_SINGULAR 1e-9 /* of the largest entry of the equations */

/*
 * Solve for the changes of the joints and of the platform's rotation that undo the closures while the reference point
 * stays in place. A limb's joint is eliminated with the rod that feels it most; what is left are 3 equations for
 * the rotation, solved by Gauss elimination. Returns 0 where they are singular.
 */
static int hold(double loop[3 * LIMB], double joints[3], double rotation[3])
{
    double A[3][4];
    double largest = 0.0;
    int row = 0, i, j, r, c;
    for (r = 0; r < 6; r++)
        for (c = 4; c < ROD; c++)
            if (fabs(loop[ROD * r + c]) > largest)
                largest = fabs(loop[ROD * r + c]);
    for (i = 0; i < 3; i++) {
        double *own = loop + LIMB * i, *best = own;
        double inverse;
        for (j = 1; j < 2; j++)
            if (fabs(own[ROD * j + ROD - 1]) > fabs(best[ROD - 1]))
                best = own + ROD * j;
        if (!(fabs(best[ROD - 1]) > PIVOT_SINGULAR * largest))
            return 0;
        inverse = 1.0 / best[ROD - 1];
        for (j = 0; j < 2; j++) {
            const double *rod = own + ROD * j;
            const double factor = rod[ROD - 1] * inverse;
            if (rod == best)
                continue;
            for (c = 0; c < 3; c++)
                A[row][c] = rod[4 + c] - factor * best[4 + c];
            A[row][3] = rod[0] - factor * best[0];
            row++;
        }
        joints[i] = best[0] * inverse;
        for (c = 0; c < 3; c++)
            own[4 + c] = best[4 + c] * inverse;
    }
    for (c = 0; c < 3; c++) {
        int pivot = c;
        for (r = c + 1; r < 3; r++)
            if (fabs(A[r][c]) > fabs(A[pivot][c]))
                pivot = r;
        if (!(fabs(A[pivot][c]) > PIVOT_SINGULAR * largest))
            return 0;
        for (j = c; j < 4; j++) {
            const double swap = A[c][j];
            A[c][j] = A[pivot][j];
            A[pivot][j] = swap;
        }
        for (r = c + 1; r < 3; r++) {
            const double factor = A[r][c] / A[c][c];
            for (j = c + 1; j < 4; j++)
                A[r][j] -= factor * A[c][j];
        }
    }
    for (c = 2; c >= 0; c--) {
        rotation[c] = A[c][3];
        for (j = c + 1; j < 3; j++)
            rotation[c] -= A[c][j] * rotation[j];
        rotation[c] /= A[c][c];
    }
    for (i = 0; i < 3; i++)
        for (c = 0; c < 3; c++)
            joints[i] -= loop[LIMB * i + 4 + c] * rotation[c];
    return 1;
}

int deltacal_compensate(const double target_mm[3], double joints_deg[3])
{
    double x[6], q[3], change[3], start[1], turned[3], loop[3 * LIMB];
    int i, c, steps;
    for (c = 0; c < 6; c++)
        x[c] = c < 3 ? target_mm[c] : 0.0;
    for (i = 0; i < 3; i++) {
        joint(x, 0.0, DELTACAL_TOOL, DELTACAL_K[i], start);
        q[i] = start[0];
        if (!isfinite(q[i]))
            return DELTACAL_UNREACHABLE;
    }
    for (steps = 0; steps < MAX_STEPS; steps++) {
        double size = 0.0;
        for (i = 0; i < 3; i++)
            newton(x, q[i], DELTACAL_TOOL, DELTACAL_K[i], loop + LIMB * i);
        if (!hold(loop, change, turned))
            return DELTACAL_SINGULAR;
        for (i = 0; i < 3; i++) {
            q[i] -= change[i];
            size = fmax(size, fabs(change[i]));
        }
        for (c = 0; c < 3; c++) {
            x[3 + c] -= turned[c];
            size = fmax(size, fabs(turned[c]));
        }
        if (size < STEP_DONE) {
            for (i = 0; i < 3; i++)
                joints_deg[i] = DELTACAL_SIGN[i] * q[i] * JOINT_PER_UNIT;
            return DELTACAL_SOLVED;
        }
        if (!(size < STEP_LOST))
            break;
    }
    return DELTACAL_UNREACHABLE;
}

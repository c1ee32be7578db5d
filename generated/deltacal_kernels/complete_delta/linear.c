/*
 * Generated from derive/mechanisms/complete_delta.py by "deltacal kernels". Do not edit.
 * Template templates/mechanism/linear.c.jinja; sha256 of both 19de11cffe5da691; SymPy 1.14.0.
 *
 * The linear compensator: nominal joints, and the change that holds the reference point to first order in the errors.
 * An export puts the machine's numbers before this text: DELTACAL_K[3][40], DELTACAL_TOOL[3],
 * DELTACAL_SIGN[3]. Inside: mm and rad.
 */
#include <math.h>

#define DELTACAL_SOLVED 0
#define DELTACAL_UNREACHABLE 1
#define DELTACAL_SINGULAR 2
#define JOINT_PER_UNIT 57.295779513082320877 /* deg per rad */

/* Joint commands as the controller counts them, for a target of the reference point in the robot frame {O}. */
int deltacal_compensate(const double target_mm[3], double joints_deg[3]);


/* Joint of the nominal limb at a given position (34 operations). */
static void nominal_joint(const double *x, double q, const double *tool, const double *k, double *out)
{
    const double px = x[0];
    const double py = x[1];
    const double pz = x[2];
    const double tx = tool[0];
    const double ty = tool[1];
    const double tz = tool[2];
    const double s125 = k[0];
    const double s127 = k[1];
    const double s129 = k[2];
    const double s131 = k[3];
    const double s148 = k[4];
    const double s143 = k[5];
    const double L = k[6];
    const double B1_z = pz - tz;
    const double s126 = px + s125 - tx;
    const double s130 = py + s129 - ty;
    const double s133 = s126*s127 + s130*s131;
    const double s135 = (B1_z * B1_z);
    const double s149 = (1.0/2.0)*(s126 * s126) + (1.0/2.0)*(s130 * s130) + (1.0/2.0)*s135 + s148;
    const double s153 = sqrt((s133 * s133) + s135*s143 - (s149 * s149));
    const double s160 = atan2(B1_z*L*s149 - s133*s153, -B1_z*L*s153 - s133*s149);
    (void)(q);
    out[0] = s160;
}

/* Per rod of one nominal limb: change of the closure by all errors, derivatives by rotation and joint (124 operations). */
static void linear(const double *x, double q, const double *tool, const double *k, double *out)
{
    const double px = x[0];
    const double py = x[1];
    const double pz = x[2];
    const double tx = tool[0];
    const double ty = tool[1];
    const double tz = tool[2];
    const double L = k[6];
    const double R0_12 = k[7];
    const double R0_12_errors = k[8];
    const double betay = k[9];
    const double R0_22 = k[10];
    const double R0_22_errors = k[11];
    const double betax = k[12];
    const double R0_32_errors = k[13];
    const double s46 = k[14];
    const double ay1 = k[15];
    const double g1_z_errors = k[16];
    const double s54 = k[17];
    const double s59 = k[18];
    const double s67 = k[19];
    const double s71 = k[20];
    const double h1_x = k[21];
    const double h1_y = k[22];
    const double bx1 = k[23];
    const double by1 = k[24];
    const double bz1 = k[25];
    const double s93 = k[26];
    const double ay2 = k[27];
    const double g2_z_errors = k[28];
    const double s99 = k[29];
    const double s102 = k[30];
    const double s108 = k[31];
    const double s110 = k[32];
    const double h2_x = k[33];
    const double h2_y = k[34];
    const double bx2 = k[35];
    const double by2 = k[36];
    const double bz2 = k[37];
    const double s164 = k[38];
    const double s182 = k[39];
    const double s14 = cos(q);
    const double s15 = R0_12*s14;
    const double s16 = sin(q);
    const double s17 = -R0_12*s16;
    const double R1_12_errors = R0_12_errors*s14 + betay*s16;
    const double s24 = R0_22*s14;
    const double s25 = -R0_22*s16;
    const double R1_22_errors = R0_22_errors*s14 - betax*s16;
    const double R1_32_errors = R0_32_errors*s14;
    const double s44 = L*s15;
    const double A1_x = s44 + s46;
    const double s48 = L*s17;
    const double s52 = L*R1_12_errors;
    const double A1_x_errors = ay1*s15 + g1_z_errors*s17 + s52 + s54;
    const double s57 = L*s24;
    const double A1_y = s57 + s59;
    const double s61 = L*s25;
    const double s65 = L*R1_22_errors;
    const double A1_y_errors = ay1*s24 + g1_z_errors*s25 + s65 + s67;
    const double s69 = L*s16;
    const double s70 = L*s14;
    const double s73 = L*R1_32_errors;
    const double A1_z_errors = ay1*s16 + g1_z_errors*s14 + s71 + s73;
    const double s76 = h1_x - tx;
    const double s77 = h1_y - ty;
    const double B1_x = px + s76;
    const double B1_y = py + s77;
    const double B1_z = pz - tz;
    const double d1_x = -A1_x + B1_x;
    const double d1_x_errors = -A1_x_errors + bx1;
    const double d1_y = -A1_y + B1_y;
    const double d1_y_errors = -A1_y_errors + by1;
    const double d1_z = B1_z - s69;
    const double d1_z_errors = -A1_z_errors + bz1;
    const double A2_x = s44 + s93;
    const double A2_x_errors = ay2*s15 + g2_z_errors*s17 + s52 + s99;
    const double A2_y = s102 + s57;
    const double A2_y_errors = ay2*s24 + g2_z_errors*s25 + s108 + s65;
    const double A2_z_errors = ay2*s16 + g2_z_errors*s14 + s110 + s73;
    const double s114 = h2_x - tx;
    const double s115 = h2_y - ty;
    const double B2_x = px + s114;
    const double B2_y = py + s115;
    const double B2_z = pz - tz;
    const double d2_x = -A2_x + B2_x;
    const double d2_x_errors = -A2_x_errors + bx2;
    const double d2_y = -A2_y + B2_y;
    const double d2_y_errors = -A2_y_errors + by2;
    const double d2_z = B2_z - s69;
    const double d2_z_errors = -A2_z_errors + bz2;
    const double s165 = d1_x*d1_x_errors + d1_y*d1_y_errors + d1_z*d1_z_errors + s164;
    const double s168 = d1_y*tz + d1_z*s77;
    const double s171 = -d1_x*tz - d1_z*s76;
    const double s174 = -d1_x*s77 + d1_y*s76;
    const double s178 = -d1_x*s48 - d1_y*s61 - d1_z*s70;
    const double s183 = d2_x*d2_x_errors + d2_y*d2_y_errors + d2_z*d2_z_errors + s182;
    const double s186 = d2_y*tz + d2_z*s115;
    const double s189 = -d2_x*tz - d2_z*s114;
    const double s192 = -d2_x*s115 + d2_y*s114;
    const double s196 = -d2_x*s48 - d2_y*s61 - d2_z*s70;
    out[0] = s165;
    out[4] = s168;
    out[5] = s171;
    out[6] = s174;
    out[7] = s178;
    out[8] = s183;
    out[12] = s186;
    out[13] = s189;
    out[14] = s192;
    out[15] = s196;
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
    double q[3], change[3], turned[3], loop[3 * LIMB];
    int i;
    for (i = 0; i < 3; i++) {
        nominal_joint(target_mm, 0.0, DELTACAL_TOOL, DELTACAL_K[i], &q[i]);
        if (!isfinite(q[i]))
            return DELTACAL_UNREACHABLE;
    }
    for (i = 0; i < 3; i++)
        linear(target_mm, q[i], DELTACAL_TOOL, DELTACAL_K[i], loop + LIMB * i);
    if (!hold(loop, change, turned))
        return DELTACAL_SINGULAR;
    for (i = 0; i < 3; i++)
        joints_deg[i] = DELTACAL_SIGN[i] * (q[i] - change[i]) * JOINT_PER_UNIT;
    return DELTACAL_SOLVED;
}

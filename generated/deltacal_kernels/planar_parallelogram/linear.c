/*
 * Generated from derive/mechanisms/planar_parallelogram.py by "deltacal kernels". Do not edit.
 * Template templates/mechanism/linear.c.jinja; sha256 of both b07098a2769e292c; SymPy 1.14.0.
 *
 * The linear compensator: nominal joints, and the change that holds the reference point to first order in the errors.
 * An export puts the machine's numbers before this text: DELTACAL_K[1][28], DELTACAL_TOOL[3],
 * DELTACAL_SIGN[1]. Inside: mm and rad.
 */
#include <math.h>

#define DELTACAL_SOLVED 0
#define DELTACAL_UNREACHABLE 1
#define DELTACAL_SINGULAR 2
#define JOINT_PER_UNIT 57.295779513082320877 /* deg per rad */

/* Joint commands as the controller counts them, for a target of the reference point in the robot frame {O}. */
int deltacal_compensate(const double target_mm[1], double joints_deg[1]);


/* Joint of the nominal limb at a given position (4 operations). */
static void nominal_joint(const double *x, double q, const double *tool, const double *k, double *out)
{
    const double px = x[0];
    const double tx = tool[0];
    const double s140 = k[0];
    const double s139 = k[1];
    const double s143 = asin(s139*(px + s140 - tx));
    (void)(q);
    out[0] = s143;
}

/* Per rod of one nominal limb: change of the closure by all errors, derivatives by rotation and joint (143 operations). */
static void linear(const double *x, double q, const double *tool, const double *k, double *out)
{
    const double px = x[0];
    const double tx = tool[0];
    const double ty = tool[1];
    const double l1 = k[2];
    const double s6 = k[3];
    const double s8 = k[4];
    const double s11 = k[5];
    const double s13 = k[6];
    const double s24 = k[7];
    const double s34 = k[8];
    const double s41 = k[9];
    const double s43 = k[10];
    const double s45 = k[11];
    const double s47 = k[12];
    const double b1x = k[13];
    const double h = k[14];
    const double dl1 = k[15];
    const double s75 = k[16];
    const double db1x = k[17];
    const double b2x = k[18];
    const double b2y = k[19];
    const double db2x = k[20];
    const double db2y = k[21];
    const double a2x = k[22];
    const double da2x = k[23];
    const double a2y = k[24];
    const double da2y = k[25];
    const double da1x = k[26];
    const double s148 = k[27];
    const double s0 = cos(q);
    const double s10 = sin(q);
    const double s14 = s0*s6 + s0*s8 + s10*s11 + s13;
    const double s25 = s0*s11 - s10*s6 - s10*s8 + s24;
    const double s48 = (s0 * s0)*s34 + s0*s45 + (s10 * s10)*s34 + s10*s41 + s10*s43 + s47;
    const double s51 = sqrt((s14 * s14) + (s25 * s25) - (s48 * s48));
    const double s54 = -s14*s48 + s25*s51;
    const double s58 = -s14*s51 - s25*s48;
    const double s61 = pow((s54 * s54) + (s58 * s58), -1.0/2.0);
    const double s62 = b1x + tx;
    const double nominal_py = -l1*s0 + s54*s61*s62 + s58*s61*(-h + ty);
    const double nominal_cz = 2*tan((1.0/2.0)*atan2(s54, s58));
    const double C_y = -h + ty;
    const double r1_x_q = l1*s0;
    const double r1_x_errors = dl1*s10 + s0*s75;
    const double r1_y_q = l1*s10;
    const double r1_y_errors = -dl1*s0 + s10*s75;
    const double s83 = (nominal_cz * nominal_cz);
    const double s85 = (1.0/4.0)*s83 + 1;
    const double s86 = 1.0/s85;
    const double s87 = -1.0/2.0*s83*s86;
    const double R_11 = s87 + 1;
    const double s89 = -nominal_cz*s86;
    const double s91 = (1.0 / (s85 * s85));
    const double s92 = (1.0/4.0)*(nominal_cz * nominal_cz * nominal_cz)*s91;
    const double R_11_cz = s89 + s92;
    const double R_12 = -nominal_cz*s86;
    const double s95 = (1.0/2.0)*s83*s91;
    const double R_12_cz = -s86 + s95;
    const double R_21 = nominal_cz*s86;
    const double R_21_cz = s86 - s95;
    const double R_22 = s87 + 1;
    const double R_22_cz = s89 + s92;
    const double B1_x_cz = -C_y*R_12_cz - R_11_cz*s62;
    const double B1_x_errors = -R_11*db1x;
    const double B1_y_cz = -C_y*R_22_cz - R_21_cz*s62;
    const double B1_y_errors = -R_21*db1x;
    const double s115 = b2x - tx;
    const double s117 = -C_y + b2y;
    const double B2_x = R_11*s115 + R_12*s117 + px;
    const double B2_x_cz = R_11_cz*s115 + R_12_cz*s117;
    const double B2_x_errors = R_11*db2x + R_12*db2y;
    const double B2_y = R_21*s115 + R_22*s117 + nominal_py;
    const double B2_y_cz = R_21_cz*s115 + R_22_cz*s117;
    const double B2_y_errors = R_21*db2x + R_22*db2y;
    const double r2_x = B2_x - a2x;
    const double r2_x_errors = B2_x_errors - da2x;
    const double r2_y = B2_y - a2y;
    const double r2_y_errors = B2_y_errors - da2y;
    const double s144 = B1_x_errors + da1x - r1_x_errors;
    const double s145 = B1_y_errors - r1_y_errors;
    const double s149 = r2_x*r2_x_errors + r2_y*r2_y_errors + s148;
    const double s152 = B2_x_cz*r2_x + B2_y_cz*r2_y;
    out[0] = s144;
    out[2] = 0;
    out[3] = B1_x_cz;
    out[4] = -r1_x_q;
    out[5] = s145;
    out[7] = 1;
    out[8] = B1_y_cz;
    out[9] = -r1_y_q;
    out[10] = s149;
    out[12] = r2_y;
    out[13] = s152;
    out[14] = 0;
}

#define ROD 5 /* per rod: closure, its derivatives by the position (1), by the rotation (2), by the joint */
#define LIMB (ROD * 3)
#define PIVOT_SINGULAR 1e-9 /* of the largest entry of the equations */

/*
 * Solve for the changes of the joints and of the platform's rotation that undo the closures while the reference point
 * stays in place. A limb's joint is eliminated with the rod that feels it most; what is left are 2 equations for
 * the rotation, solved by Gauss elimination. Returns 0 where they are singular.
 */
static int hold(double loop[1 * LIMB], double joints[1], double rotation[2])
{
    double A[2][3];
    double largest = 0.0;
    int row = 0, i, j, r, c;
    for (r = 0; r < 3; r++)
        for (c = 2; c < ROD; c++)
            if (fabs(loop[ROD * r + c]) > largest)
                largest = fabs(loop[ROD * r + c]);
    for (i = 0; i < 1; i++) {
        double *own = loop + LIMB * i, *best = own;
        double inverse;
        for (j = 1; j < 3; j++)
            if (fabs(own[ROD * j + ROD - 1]) > fabs(best[ROD - 1]))
                best = own + ROD * j;
        if (!(fabs(best[ROD - 1]) > PIVOT_SINGULAR * largest))
            return 0;
        inverse = 1.0 / best[ROD - 1];
        for (j = 0; j < 3; j++) {
            const double *rod = own + ROD * j;
            const double factor = rod[ROD - 1] * inverse;
            if (rod == best)
                continue;
            for (c = 0; c < 2; c++)
                A[row][c] = rod[2 + c] - factor * best[2 + c];
            A[row][2] = rod[0] - factor * best[0];
            row++;
        }
        joints[i] = best[0] * inverse;
        for (c = 0; c < 2; c++)
            own[2 + c] = best[2 + c] * inverse;
    }
    for (c = 0; c < 2; c++) {
        int pivot = c;
        for (r = c + 1; r < 2; r++)
            if (fabs(A[r][c]) > fabs(A[pivot][c]))
                pivot = r;
        if (!(fabs(A[pivot][c]) > PIVOT_SINGULAR * largest))
            return 0;
        for (j = c; j < 3; j++) {
            const double swap = A[c][j];
            A[c][j] = A[pivot][j];
            A[pivot][j] = swap;
        }
        for (r = c + 1; r < 2; r++) {
            const double factor = A[r][c] / A[c][c];
            for (j = c + 1; j < 3; j++)
                A[r][j] -= factor * A[c][j];
        }
    }
    for (c = 1; c >= 0; c--) {
        rotation[c] = A[c][2];
        for (j = c + 1; j < 2; j++)
            rotation[c] -= A[c][j] * rotation[j];
        rotation[c] /= A[c][c];
    }
    for (i = 0; i < 1; i++)
        for (c = 0; c < 2; c++)
            joints[i] -= loop[LIMB * i + 2 + c] * rotation[c];
    return 1;
}

int deltacal_compensate(const double target_mm[1], double joints_deg[1])
{
    double q[1], change[1], turned[2], loop[1 * LIMB];
    int i;
    for (i = 0; i < 1; i++) {
        nominal_joint(target_mm, 0.0, DELTACAL_TOOL, DELTACAL_K[i], &q[i]);
        if (!isfinite(q[i]))
            return DELTACAL_UNREACHABLE;
    }
    for (i = 0; i < 1; i++)
        linear(target_mm, q[i], DELTACAL_TOOL, DELTACAL_K[i], loop + LIMB * i);
    if (!hold(loop, change, turned))
        return DELTACAL_SINGULAR;
    for (i = 0; i < 1; i++)
        joints_deg[i] = DELTACAL_SIGN[i] * (q[i] - change[i]) * JOINT_PER_UNIT;
    return DELTACAL_SOLVED;
}

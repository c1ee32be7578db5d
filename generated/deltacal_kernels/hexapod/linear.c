/*
 * Generated from derive/mechanisms/hexapod.py by "deltacal kernels". Do not edit.
 * Template templates/mechanism/linear.c.jinja; sha256 of both 5df2e0b87475514e; SymPy 1.14.0.
 *
 * The linear compensator: nominal joints, and the change that holds the reference point to first order in the errors.
 * An export puts the machine's numbers before this text: DELTACAL_K[6][15], DELTACAL_TOOL[3],
 * DELTACAL_SIGN[6]. Inside: mm and rad.
 */
#include <math.h>

#define DELTACAL_SOLVED 0
#define DELTACAL_UNREACHABLE 1
#define DELTACAL_SINGULAR 2
#define JOINT_PER_UNIT 1.0

/* Joint commands as the controller counts them, for a target of the reference point in the robot frame {O}. */
int deltacal_compensate(const double target[6], double joints_mm[6]);


/* Joint of the nominal limb at a given position (75 operations). */
static void nominal_joint(const double *x, double q, const double *tool, const double *k, double *out)
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
    const double s40 = k[0];
    const double s44 = k[1];
    const double down = k[2];
    const double A_x = k[3];
    const double A_y = k[4];
    const double up = k[5];
    const double leg = k[6];
    const double s0 = (cx * cx);
    const double s2 = (cy * cy);
    const double s4 = (cz * cz);
    const double s7 = 1.0/((1.0/4.0)*s0 + (1.0/4.0)*s2 + (1.0/4.0)*s4 + 1);
    const double s8 = -1.0/2.0*s2;
    const double s9 = -1.0/2.0*s4;
    const double R_11 = s7*(s8 + s9) + 1;
    const double s13 = (1.0/2.0)*cx*cy;
    const double s16 = (1.0/2.0)*cx*cz;
    const double s21 = -1.0/2.0*s0;
    const double R_22 = s7*(s21 + s9) + 1;
    const double s25 = (1.0/2.0)*cy*cz;
    const double R_33 = s7*(s21 + s8) + 1;
    const double b_x = s40 - tx;
    const double b_y = s44 - ty;
    const double b_z = down - tz;
    const double s102 = ((-A_x + R_11*b_x + b_y*s7*(-cz + s13) + b_z*s7*(cy + s16) + px) * (-A_x + R_11*b_x + b_y*s7*(-cz + s13) + b_z*s7*(cy + s16) + px));
    const double s106 = ((-A_y + R_22*b_y + b_x*s7*(cz + s13) + b_z*s7*(-cx + s25) + py) * (-A_y + R_22*b_y + b_x*s7*(cz + s13) + b_z*s7*(-cx + s25) + py));
    const double s110 = ((R_33*b_z + b_x*s7*(-cy + s16) + b_y*s7*(cx + s25) + pz - up) * (R_33*b_z + b_x*s7*(-cy + s16) + b_y*s7*(cx + s25) + pz - up));
    const double s113 = -leg + sqrt(s102 + s106 + s110);
    (void)(q);
    out[0] = s113;
}

/* Per rod of one nominal limb: change of the closure by all errors, derivatives by rotation and joint (96 operations). */
static void linear(const double *x, double q, const double *tool, const double *k, double *out)
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
    const double s40 = k[0];
    const double s44 = k[1];
    const double down = k[2];
    const double A_x = k[3];
    const double A_y = k[4];
    const double up = k[5];
    const double leg = k[6];
    const double b_x_errors = k[7];
    const double b_y_errors = k[8];
    const double b_z_errors = k[9];
    const double ax = k[10];
    const double ay = k[11];
    const double az = k[12];
    const double scale = k[13];
    const double dl = k[14];
    const double s0 = (cx * cx);
    const double s2 = (cy * cy);
    const double s4 = (cz * cz);
    const double s7 = 1.0/((1.0/4.0)*s0 + (1.0/4.0)*s2 + (1.0/4.0)*s4 + 1);
    const double s8 = -1.0/2.0*s2;
    const double s9 = -1.0/2.0*s4;
    const double R_11 = s7*(s8 + s9) + 1;
    const double s13 = (1.0/2.0)*cx*cy;
    const double R_12 = s7*(-cz + s13);
    const double s16 = (1.0/2.0)*cx*cz;
    const double R_13 = s7*(cy + s16);
    const double R_21 = s7*(cz + s13);
    const double s21 = -1.0/2.0*s0;
    const double R_22 = s7*(s21 + s9) + 1;
    const double s25 = (1.0/2.0)*cy*cz;
    const double R_23 = s7*(-cx + s25);
    const double R_31 = s7*(-cy + s16);
    const double R_32 = s7*(cx + s25);
    const double R_33 = s7*(s21 + s8) + 1;
    const double b_x = s40 - tx;
    const double b_y = s44 - ty;
    const double b_z = down - tz;
    const double B_x = R_11*b_x + R_12*b_y + R_13*b_z + px;
    const double B_x_errors = R_11*b_x_errors + R_12*b_y_errors + R_13*b_z_errors;
    const double B_y = R_21*b_x + R_22*b_y + R_23*b_z + py;
    const double B_y_errors = R_21*b_x_errors + R_22*b_y_errors + R_23*b_z_errors;
    const double B_z = R_31*b_x + R_32*b_y + R_33*b_z + pz;
    const double B_z_errors = R_31*b_x_errors + R_32*b_y_errors + R_33*b_z_errors;
    const double d_x = -A_x + B_x;
    const double d_x_errors = B_x_errors - ax;
    const double d_y = -A_y + B_y;
    const double d_y_errors = B_y_errors - ay;
    const double d_z = B_z - up;
    const double d_z_errors = B_z_errors - az;
    const double s = leg + q;
    const double s_errors = dl + q*scale;
    const double s118 = d_x*d_x_errors + d_y*d_y_errors + d_z*d_z_errors - s*s_errors;
    out[0] = s118;
    out[7] = -s;
}

/* Coordinates of a target: position [mm], rotation vector [deg] (25 operations). */
static void stated(const double *x, double q, const double *tool, const double *k, double *out)
{
    const double px = x[0];
    const double py = x[1];
    const double pz = x[2];
    const double cx = x[3];
    const double cy = x[4];
    const double cz = x[5];
    const double s6 = 0.00030461741978670857*(cx * cx) + 0.00030461741978670857*(cy * cy) + 0.00030461741978670857*(cz * cz) + 1.0e-300;
    const double s7 = pow(s6, -1.0/2.0);
    const double s10 = tan((1.0/2.0)*sqrt(s6));
    const double s11 = 0.034906585039886591*cx*s10*s7;
    const double s12 = 0.034906585039886591*cy*s10*s7;
    const double s13 = 0.034906585039886591*cz*s10*s7;
    (void)(tool);
    (void)(k);
    (void)(q);
    out[0] = px;
    out[1] = py;
    out[2] = pz;
    out[3] = s11;
    out[4] = s12;
    out[5] = s13;
}

#define ROD 8 /* per rod: closure, its derivatives by the position (6), by the rotation (0), by the joint */
#define LIMB (ROD * 1)
#define PIVOT_SINGULAR 1e-9 /* of the largest entry of the equations */

/*
 * Solve for the changes of the joints and of the platform's rotation that undo the closures while the reference point
 * stays in place. A limb's joint is eliminated with the rod that feels it most; what is left are 0 equations for
 * the rotation, solved by Gauss elimination. Returns 0 where they are singular.
 */
static int hold(double loop[6 * LIMB], double joints[6], double rotation[1])
{
    double A[1][1];
    double largest = 0.0;
    int row = 0, i, j, r, c;
    for (r = 0; r < 6; r++)
        for (c = 7; c < ROD; c++)
            if (fabs(loop[ROD * r + c]) > largest)
                largest = fabs(loop[ROD * r + c]);
    for (i = 0; i < 6; i++) {
        double *own = loop + LIMB * i, *best = own;
        double inverse;
        for (j = 1; j < 1; j++)
            if (fabs(own[ROD * j + ROD - 1]) > fabs(best[ROD - 1]))
                best = own + ROD * j;
        if (!(fabs(best[ROD - 1]) > PIVOT_SINGULAR * largest))
            return 0;
        inverse = 1.0 / best[ROD - 1];
        for (j = 0; j < 1; j++) {
            const double *rod = own + ROD * j;
            const double factor = rod[ROD - 1] * inverse;
            if (rod == best)
                continue;
            for (c = 0; c < 0; c++)
                A[row][c] = rod[7 + c] - factor * best[7 + c];
            A[row][0] = rod[0] - factor * best[0];
            row++;
        }
        joints[i] = best[0] * inverse;
        for (c = 0; c < 0; c++)
            own[7 + c] = best[7 + c] * inverse;
    }
    for (c = 0; c < 0; c++) {
        int pivot = c;
        for (r = c + 1; r < 0; r++)
            if (fabs(A[r][c]) > fabs(A[pivot][c]))
                pivot = r;
        if (!(fabs(A[pivot][c]) > PIVOT_SINGULAR * largest))
            return 0;
        for (j = c; j < 1; j++) {
            const double swap = A[c][j];
            A[c][j] = A[pivot][j];
            A[pivot][j] = swap;
        }
        for (r = c + 1; r < 0; r++) {
            const double factor = A[r][c] / A[c][c];
            for (j = c + 1; j < 1; j++)
                A[r][j] -= factor * A[c][j];
        }
    }
    for (c = -1; c >= 0; c--) {
        rotation[c] = A[c][0];
        for (j = c + 1; j < 0; j++)
            rotation[c] -= A[c][j] * rotation[j];
        rotation[c] /= A[c][c];
    }
    for (i = 0; i < 6; i++)
        for (c = 0; c < 0; c++)
            joints[i] -= loop[LIMB * i + 7 + c] * rotation[c];
    return 1;
}

int deltacal_compensate(const double target[6], double joints_mm[6])
{
    double q[6], change[6], turned[1], loop[6 * LIMB];
    int i;
    double x[6];
    stated(target, 0.0, DELTACAL_TOOL, DELTACAL_K[0], x);
    for (i = 0; i < 6; i++) {
        nominal_joint(x, 0.0, DELTACAL_TOOL, DELTACAL_K[i], &q[i]);
        if (!isfinite(q[i]))
            return DELTACAL_UNREACHABLE;
    }
    for (i = 0; i < 6; i++)
        linear(x, q[i], DELTACAL_TOOL, DELTACAL_K[i], loop + LIMB * i);
    if (!hold(loop, change, turned))
        return DELTACAL_SINGULAR;
    for (i = 0; i < 6; i++)
        joints_mm[i] = DELTACAL_SIGN[i] * (q[i] - change[i]) * JOINT_PER_UNIT;
    return DELTACAL_SOLVED;
}

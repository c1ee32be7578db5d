/*
 * Generated from derive/mechanisms/diamond.py by "deltacal kernels". Do not edit.
 * Template templates/mechanism/linear.c.jinja; sha256 of both 5fe71c158ba610f2; SymPy 1.14.0.
 *
 * The linear compensator: nominal joints, and the change that holds the reference point to first order in the errors.
 * An export puts the machine's numbers before this text: DELTACAL_K[2][13], DELTACAL_TOOL[3],
 * DELTACAL_SIGN[2]. Inside: mm and rad.
 */
#include <math.h>

#define DELTACAL_SOLVED 0
#define DELTACAL_UNREACHABLE 1
#define DELTACAL_SINGULAR 2
#define JOINT_PER_UNIT 57.295779513082320877 /* deg per rad */

/* Joint commands as the controller counts them, for a target of the reference point in the robot frame {O}. */
int deltacal_compensate(const double target_mm[2], double joints_deg[2]);


/* Joint of the nominal limb at a given position (29 operations). */
static void nominal_joint(const double *x, double q, const double *tool, const double *k, double *out)
{
    const double px = x[0];
    const double py = x[1];
    const double tx = tool[0];
    const double ty = tool[1];
    const double base_y = k[0];
    const double B_x = k[1];
    const double s38 = k[2];
    const double s5 = k[3];
    const double s42 = k[4];
    const double s47 = k[5];
    const double s2 = k[6];
    const double s27 = -base_y + py - ty;
    const double s28 = -B_x + px - tx;
    const double s29 = (s28 * s28);
    const double s31 = (s27 * s27);
    const double s39 = (1.0/2.0)*s29 + (1.0/2.0)*s31 + s38;
    const double s46 = sqrt(s29*s42 + s31*s42 - (s39 * s39));
    const double s54 = -s2 + atan2(s27*s39*s5 + s28*s46*s47, -s27*s46*s47 + s28*s39*s5);
    (void)(q);
    out[0] = s54;
}

/* Per rod of one nominal limb: change of the closure by all errors, derivatives by rotation and joint (33 operations). */
static void linear(const double *x, double q, const double *tool, const double *k, double *out)
{
    const double px = x[0];
    const double py = x[1];
    const double tx = tool[0];
    const double ty = tool[1];
    const double base_y = k[0];
    const double B_x = k[1];
    const double s5 = k[3];
    const double s2 = k[6];
    const double s10 = k[7];
    const double s12 = k[8];
    const double s14 = k[9];
    const double ex = k[10];
    const double ey = k[11];
    const double s57 = k[12];
    const double s3 = q + s2;
    const double s4 = cos(s3);
    const double C_x = B_x + s4*s5;
    const double s8 = sin(s3);
    const double C_x_q = -s5*s8;
    const double C_x_errors = ex + s10*s4 + s12*s8 + s14*s8;
    const double C_y = -C_x_q + base_y;
    const double C_y_q = s4*s5;
    const double C_y_errors = ey + s10*s8 - s12*s4 - s14*s4;
    const double A_x = px - tx;
    const double A_y = py - ty;
    const double d_x = A_x - C_x;
    const double d_y = A_y - C_y;
    const double s58 = -C_x_errors*d_x - C_y_errors*d_y + s57;
    const double s61 = -C_x_q*d_x - C_y_q*d_y;
    out[0] = s58;
    out[3] = s61;
}

#define ROD 4 /* per rod: closure, its derivatives by the position (2), by the rotation (0), by the joint */
#define LIMB (ROD * 1)
#define PIVOT_SINGULAR 1e-9 /* of the largest entry of the equations */

/*
 * Solve for the changes of the joints and of the platform's rotation that undo the closures while the reference point
 * stays in place. A limb's joint is eliminated with the rod that feels it most; what is left are 0 equations for
 * the rotation, solved by Gauss elimination. Returns 0 where they are singular.
 */
static int hold(double loop[2 * LIMB], double joints[2], double rotation[1])
{
    double A[1][1];
    double largest = 0.0;
    int row = 0, i, j, r, c;
    for (r = 0; r < 2; r++)
        for (c = 3; c < ROD; c++)
            if (fabs(loop[ROD * r + c]) > largest)
                largest = fabs(loop[ROD * r + c]);
    for (i = 0; i < 2; i++) {
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
                A[row][c] = rod[3 + c] - factor * best[3 + c];
            A[row][0] = rod[0] - factor * best[0];
            row++;
        }
        joints[i] = best[0] * inverse;
        for (c = 0; c < 0; c++)
            own[3 + c] = best[3 + c] * inverse;
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
    for (i = 0; i < 2; i++)
        for (c = 0; c < 0; c++)
            joints[i] -= loop[LIMB * i + 3 + c] * rotation[c];
    return 1;
}

int deltacal_compensate(const double target_mm[2], double joints_deg[2])
{
    double q[2], change[2], turned[1], loop[2 * LIMB];
    int i;
    for (i = 0; i < 2; i++) {
        nominal_joint(target_mm, 0.0, DELTACAL_TOOL, DELTACAL_K[i], &q[i]);
        if (!isfinite(q[i]))
            return DELTACAL_UNREACHABLE;
    }
    for (i = 0; i < 2; i++)
        linear(target_mm, q[i], DELTACAL_TOOL, DELTACAL_K[i], loop + LIMB * i);
    if (!hold(loop, change, turned))
        return DELTACAL_SINGULAR;
    for (i = 0; i < 2; i++)
        joints_deg[i] = DELTACAL_SIGN[i] * (q[i] - change[i]) * JOINT_PER_UNIT;
    return DELTACAL_SOLVED;
}

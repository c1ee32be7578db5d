/*
 * Generated from derive/mechanisms/simplified_parallelogram.py by "deltacal kernels". Do not edit.
 * Template templates/mechanism/linear.c.jinja; sha256 of both 2b097cd11d6d08f5; SymPy 1.14.0.
 *
 * The linear compensator: nominal joints, and the change that holds the reference point to first order in the errors.
 * An export puts the machine's numbers before this text: DELTACAL_K[1][5], DELTACAL_TOOL[3],
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
    const double A_x = k[0];
    const double s19 = k[1];
    const double s22 = asin(s19*(-A_x + px - tx));
    (void)(q);
    out[0] = s22;
}

/* Per rod of one nominal limb: change of the closure by all errors, derivatives by rotation and joint (14 operations). */
static void linear(const double *x, double q, const double *tool, const double *k, double *out)
{
    const double l1 = k[2];
    const double dl1 = k[3];
    const double s8 = k[4];
    const double s0 = cos(q);
    const double s4 = sin(q);
    const double r_x_q = l1*s0;
    const double r_x_errors = dl1*s4 + s0*s8;
    const double r_y_q = l1*s4;
    const double r_y_errors = -dl1*s0 + s4*s8;
    (void)(x);
    (void)(tool);
    out[0] = -r_x_errors;
    out[2] = 0;
    out[3] = 0;
    out[4] = -r_x_q;
    out[5] = -r_y_errors;
    out[7] = 1;
    out[8] = 0;
    out[9] = -r_y_q;
    out[10] = 0;
    out[12] = 0;
    out[13] = 1;
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

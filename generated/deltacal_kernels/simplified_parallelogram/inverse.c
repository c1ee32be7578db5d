/*
 * Generated from derive/mechanisms/simplified_parallelogram.py by "deltacal kernels". Do not edit.
 * Template templates/mechanism/inverse.c.jinja; sha256 of both 0090ef1257367c53; SymPy 1.14.0.
 *
 * The exact compensator: inverse position of the calibrated machine, by Newton on joints and platform rotation.
 * An export puts the machine's numbers before this text: DELTACAL_K[1][6], DELTACAL_TOOL[3],
 * DELTACAL_SIGN[1]. Inside: mm and rad.
 */
#include <math.h>

#define DELTACAL_SOLVED 0
#define DELTACAL_UNREACHABLE 1
#define DELTACAL_SINGULAR 2
#define JOINT_PER_UNIT 57.295779513082320877 /* deg per rad */

/* Joint commands as the controller counts them, for a target of the reference point in the robot frame {O}. */
int deltacal_compensate(const double target_mm[1], double joints_deg[1]);


#define MAX_STEPS 30
#define STEP_DONE 3e-8 /* rad; after such a step a command is exact to its square */
#define STEP_LOST 1e5 /* rad; a step of this size leads nowhere */

/* Per rod of one limb: closure, its derivatives by the platform, by the joint (13 operations). */
static void newton(const double *x, double q, const double *tool, const double *k, double *out)
{
    const double px = x[0];
    const double py = x[1];
    const double cz = x[2];
    const double tx = tool[0];
    const double ty = tool[1];
    const double q0 = k[0];
    const double s1 = k[1];
    const double A_x = k[2];
    const double h = k[3];
    const double s2 = q + q0;
    const double r_x = s1*sin(s2);
    const double r_y = -s1*cos(s2);
    const double B_x = A_x + r_x;
    const double C_x = px - tx;
    const double C_y = h + py - ty;
    const double s10 = -B_x + C_x;
    const double s11 = C_y - r_y;
    out[0] = s10;
    out[1] = 1;
    out[2] = 0;
    out[3] = 0;
    out[4] = r_y;
    out[5] = s11;
    out[6] = 0;
    out[7] = 1;
    out[8] = 0;
    out[9] = -r_x;
    out[10] = cz;
    out[11] = 0;
    out[12] = 0;
    out[13] = 1;
    out[14] = 0;
}

/* Joint of the simplified limb at a given position, then the platform's coordinates that follow from it (13 operations). */
static void joint(const double *x, double q, const double *tool, const double *k, double *out)
{
    const double px = x[0];
    const double tx = tool[0];
    const double ty = tool[1];
    const double q0 = k[0];
    const double s1 = k[1];
    const double A_x = k[2];
    const double h = k[3];
    const double s12 = k[4];
    const double s17 = k[5];
    const double s13 = -A_x + px - tx;
    const double s16 = -q0 + asin(s12*s13);
    const double s23 = -h - s1*sqrt(-(s13 * s13)*s17 + 1) + ty;
    (void)(q);
    out[0] = s16;
    out[1] = s23;
    out[2] = 0;
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
    double x[3], q[1], change[1], start[3], turned[2], loop[1 * LIMB];
    int i, c, steps;
    for (c = 0; c < 3; c++)
        x[c] = c < 1 ? target_mm[c] : 0.0;
    for (i = 0; i < 1; i++) {
        joint(x, 0.0, DELTACAL_TOOL, DELTACAL_K[i], start);
        q[i] = start[0];
        if (!isfinite(q[i]))
            return DELTACAL_UNREACHABLE;
    }
    x[1] = start[1];
    x[2] = start[2];
    for (steps = 0; steps < MAX_STEPS; steps++) {
        double size = 0.0;
        for (i = 0; i < 1; i++)
            newton(x, q[i], DELTACAL_TOOL, DELTACAL_K[i], loop + LIMB * i);
        if (!hold(loop, change, turned))
            return DELTACAL_SINGULAR;
        for (i = 0; i < 1; i++) {
            q[i] -= change[i];
            size = fmax(size, fabs(change[i]));
        }
        for (c = 0; c < 2; c++) {
            x[1 + c] -= turned[c];
            size = fmax(size, fabs(turned[c]));
        }
        if (size < STEP_DONE) {
            for (i = 0; i < 1; i++)
                joints_deg[i] = DELTACAL_SIGN[i] * q[i] * JOINT_PER_UNIT;
            return DELTACAL_SOLVED;
        }
        if (!(size < STEP_LOST))
            break;
    }
    return DELTACAL_UNREACHABLE;
}

/*
 * Generated from derive/mechanisms/diamond.py by "deltacal kernels". Do not edit.
 * Template templates/mechanism/inverse.c.jinja; sha256 of both 86c2398e7402b1ad; SymPy 1.14.0.
 *
 * The exact compensator: inverse position of the calibrated machine, by Newton on joints and platform rotation.
 * An export puts the machine's numbers before this text: DELTACAL_K[2][9], DELTACAL_TOOL[3],
 * DELTACAL_SIGN[2]. Inside: mm and rad.
 */
#include <math.h>

#define DELTACAL_SOLVED 0
#define DELTACAL_UNREACHABLE 1
#define DELTACAL_SINGULAR 2
#define JOINT_PER_UNIT 57.295779513082320877 /* deg per rad */

/* Joint commands as the controller counts them, for a target of the reference point in the robot frame {O}. */
int deltacal_compensate(const double target_mm[2], double joints_deg[2]);


#define MAX_STEPS 30
#define STEP_DONE 3e-8 /* rad; after such a step a command is exact to its square */
#define STEP_LOST 1e5 /* rad; a step of this size leads nowhere */

/* Per rod of one limb: closure, its derivatives by the platform, by the joint (35 operations). */
static void newton(const double *x, double q, const double *tool, const double *k, double *out)
{
    const double px = x[0];
    const double py = x[1];
    const double tx = tool[0];
    const double ty = tool[1];
    const double s6 = k[0];
    const double s9 = k[1];
    const double s12 = k[2];
    const double B_x = k[3];
    const double B_y = k[4];
    const double s28 = k[5];
    const double s7 = q + s6;
    const double s8 = cos(s7);
    const double s11 = sin(s7);
    const double C_x = B_x + s11*s12 + s8*s9;
    const double C_y = B_y + s11*s9 - s12*s8;
    const double A_x = px - tx;
    const double A_y = py - ty;
    const double d_x = A_x - C_x;
    const double d_y = A_y - C_y;
    const double s29 = (1.0/2.0)*(d_x * d_x) + (1.0/2.0)*(d_y * d_y) + s28;
    const double s30 = 2*d_y;
    const double s31 = (1.0/2.0)*s30;
    const double s32 = 2*d_x;
    const double s33 = (1.0/2.0)*s32;
    const double s46 = -s11*(s12*s31 - s33*s9) + s8*(-s12*s33 - s31*s9);
    out[0] = s29;
    out[1] = s33;
    out[2] = s31;
    out[3] = s46;
}

/* Joint of the simplified limb at a given position, then the platform's coordinates that follow from it (29 operations). */
static void joint(const double *x, double q, const double *tool, const double *k, double *out)
{
    const double px = x[0];
    const double py = x[1];
    const double tx = tool[0];
    const double ty = tool[1];
    const double s6 = k[0];
    const double s9 = k[1];
    const double B_x = k[3];
    const double B_y = k[4];
    const double s62 = k[6];
    const double s66 = k[7];
    const double s71 = k[8];
    const double s53 = -B_y + py - ty;
    const double s54 = -B_x + px - tx;
    const double s55 = (s54 * s54);
    const double s57 = (s53 * s53);
    const double s63 = (1.0/2.0)*s55 + (1.0/2.0)*s57 + s62;
    const double s70 = sqrt(s55*s66 + s57*s66 - (s63 * s63));
    const double s78 = -s6 + atan2(s53*s63*s9 + s54*s70*s71, -s53*s70*s71 + s54*s63*s9);
    (void)(q);
    out[0] = s78;
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
    double x[2], q[2], change[2], start[1], turned[1], loop[2 * LIMB];
    int i, c, steps;
    for (c = 0; c < 2; c++)
        x[c] = c < 2 ? target_mm[c] : 0.0;
    for (i = 0; i < 2; i++) {
        joint(x, 0.0, DELTACAL_TOOL, DELTACAL_K[i], start);
        q[i] = start[0];
        if (!isfinite(q[i]))
            return DELTACAL_UNREACHABLE;
    }
    for (steps = 0; steps < MAX_STEPS; steps++) {
        double size = 0.0;
        for (i = 0; i < 2; i++)
            newton(x, q[i], DELTACAL_TOOL, DELTACAL_K[i], loop + LIMB * i);
        if (!hold(loop, change, turned))
            return DELTACAL_SINGULAR;
        for (i = 0; i < 2; i++) {
            q[i] -= change[i];
            size = fmax(size, fabs(change[i]));
        }
        for (c = 0; c < 0; c++) {
            x[2 + c] -= turned[c];
            size = fmax(size, fabs(turned[c]));
        }
        if (size < STEP_DONE) {
            for (i = 0; i < 2; i++)
                joints_deg[i] = DELTACAL_SIGN[i] * q[i] * JOINT_PER_UNIT;
            return DELTACAL_SOLVED;
        }
        if (!(size < STEP_LOST))
            break;
    }
    return DELTACAL_UNREACHABLE;
}

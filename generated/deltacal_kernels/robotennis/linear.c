/*
 * Generated from derive/mechanisms/robotennis.py by "deltacal kernels". Do not edit.
 * Template templates/mechanism/linear.c.jinja; sha256 of both b35c3b637e641907; SymPy 1.14.0.
 *
 * The linear compensator: nominal joints, and the change that holds the reference point to first order in the errors.
 * An export puts the machine's numbers before this text: DELTACAL_K[3][26], DELTACAL_TOOL[3],
 * DELTACAL_SIGN[3]. Inside: mm and rad.
 */
#include <math.h>

#define DELTACAL_SOLVED 0
#define DELTACAL_UNREACHABLE 1
#define DELTACAL_SINGULAR 2
#define JOINT_PER_UNIT 57.295779513082320877 /* deg per rad */

/* Joint commands as the controller counts them, for a target of the reference point in the robot frame {O}. */
int deltacal_compensate(const double target_mm[3], double joints_deg[3]);


/* Joint of the nominal limb at a given position (33 operations). */
static void nominal_joint(const double *x, double q, const double *tool, const double *k, double *out)
{
    const double px = x[0];
    const double py = x[1];
    const double pz = x[2];
    const double tx = tool[0];
    const double ty = tool[1];
    const double tz = tool[2];
    const double s58 = k[0];
    const double s60 = k[1];
    const double s62 = k[2];
    const double s64 = k[3];
    const double s81 = k[4];
    const double s76 = k[5];
    const double a = k[6];
    const double centre_z = pz - tz;
    const double s59 = px + s58 - tx;
    const double s63 = py + s62 - ty;
    const double s66 = s59*s60 + s63*s64;
    const double s68 = (centre_z * centre_z);
    const double s82 = (1.0/2.0)*(s59 * s59) + (1.0/2.0)*(s63 * s63) + (1.0/2.0)*s68 + s81;
    const double s86 = sqrt((s66 * s66) + s68*s76 - (s82 * s82));
    const double s93 = atan2(a*centre_z*s82 + s66*s86, a*centre_z*s86 - s66*s82);
    (void)(q);
    out[0] = s93;
}

/* Per rod of one nominal limb: change of the closure by all errors, derivatives by rotation and joint (61 operations). */
static void linear(const double *x, double q, const double *tool, const double *k, double *out)
{
    const double px = x[0];
    const double py = x[1];
    const double pz = x[2];
    const double tx = tool[0];
    const double ty = tool[1];
    const double tz = tool[2];
    const double a = k[6];
    const double s0 = k[7];
    const double s8 = k[8];
    const double s2 = k[9];
    const double s12 = k[10];
    const double theta0 = k[11];
    const double A_x = k[12];
    const double da = k[13];
    const double s23 = k[14];
    const double s22 = k[15];
    const double A_y = k[16];
    const double s32 = k[17];
    const double s31 = k[18];
    const double tip_v = k[19];
    const double s44 = k[20];
    const double s48 = k[21];
    const double C_x_errors = k[22];
    const double C_y_errors = k[23];
    const double pz0 = k[24];
    const double s97 = k[25];
    const double s4 = cos(q);
    const double arm_x = s0*s4;
    const double s6 = sin(q);
    const double arm_x_q = -s0*s6;
    const double arm_x_errors = s6*s8;
    const double arm_y = s2*s4;
    const double arm_y_q = -s2*s6;
    const double arm_y_errors = s12*s6;
    const double arm_z = sin(q);
    const double arm_z_q = cos(q);
    const double arm_z_errors = s4*theta0;
    const double B_x = A_x + a*arm_x;
    const double B_x_q = a*arm_x_q;
    const double B_x_errors = a*arm_x_errors + arm_x*da + s22 + s23*s6;
    const double B_y = A_y + a*arm_y;
    const double B_y_q = a*arm_y_q;
    const double B_y_errors = a*arm_y_errors + arm_y*da + s31 + s32*s6;
    const double B_z_q = a*arm_z_q;
    const double B_z_errors = a*arm_z_errors + arm_z*da + s4*tip_v;
    const double centre_x = px - tx;
    const double centre_y = py - ty;
    const double centre_z = pz - tz;
    const double C_x = centre_x + s44;
    const double C_y = centre_y + s48;
    const double rod_x = -B_x + C_x;
    const double rod_x_errors = -B_x_errors + C_x_errors;
    const double rod_y = -B_y + C_y;
    const double rod_y_errors = -B_y_errors + C_y_errors;
    const double rod_z = -a*arm_z + centre_z;
    const double rod_z_errors = -B_z_errors + pz0;
    const double s98 = rod_x*rod_x_errors + rod_y*rod_y_errors + rod_z*rod_z_errors + s97;
    const double s102 = -B_x_q*rod_x - B_y_q*rod_y - B_z_q*rod_z;
    out[0] = s98;
    out[4] = s102;
}

#define ROD 5 /* per rod: closure, its derivatives by the position (3), by the rotation (0), by the joint */
#define LIMB (ROD * 1)
#define PIVOT_SINGULAR 1e-9 /* of the largest entry of the equations */

/*
 * Solve for the changes of the joints and of the platform's rotation that undo the closures while the reference point
 * stays in place. A limb's joint is eliminated with the rod that feels it most; what is left are 0 equations for
 * the rotation, solved by Gauss elimination. Returns 0 where they are singular.
 */
static int hold(double loop[3 * LIMB], double joints[3], double rotation[1])
{
    double A[1][1];
    double largest = 0.0;
    int row = 0, i, j, r, c;
    for (r = 0; r < 3; r++)
        for (c = 4; c < ROD; c++)
            if (fabs(loop[ROD * r + c]) > largest)
                largest = fabs(loop[ROD * r + c]);
    for (i = 0; i < 3; i++) {
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
                A[row][c] = rod[4 + c] - factor * best[4 + c];
            A[row][0] = rod[0] - factor * best[0];
            row++;
        }
        joints[i] = best[0] * inverse;
        for (c = 0; c < 0; c++)
            own[4 + c] = best[4 + c] * inverse;
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
    for (i = 0; i < 3; i++)
        for (c = 0; c < 0; c++)
            joints[i] -= loop[LIMB * i + 4 + c] * rotation[c];
    return 1;
}

int deltacal_compensate(const double target_mm[3], double joints_deg[3])
{
    double q[3], change[3], turned[1], loop[3 * LIMB];
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

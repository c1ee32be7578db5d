/*
 * Generated from derive/mechanisms/robotennis.py by "deltacal kernels". Do not edit.
 * Template templates/mechanism/linear.c.jinja; sha256 of both 236911f7e679d9d1; SymPy 1.14.0.
 *
 * The linear compensator: nominal joints, and the change that holds the reference point to first order in the errors.
 * An export puts the machine's numbers before this text: DELTACAL_K[3][28], DELTACAL_TOOL[3],
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
    const double s75 = k[0];
    const double s77 = k[1];
    const double s81 = k[2];
    const double s83 = k[3];
    const double s100 = k[4];
    const double s95 = k[5];
    const double a = k[6];
    const double centre_z = pz - tz;
    const double s76 = px + s75 - tx;
    const double s82 = py + s81 - ty;
    const double s85 = s76*s77 + s82*s83;
    const double s87 = (centre_z * centre_z);
    const double s101 = s100 + (1.0/2.0)*(s76 * s76) + (1.0/2.0)*(s82 * s82) + (1.0/2.0)*s87;
    const double s105 = sqrt(-(s101 * s101) + (s85 * s85) + s87*s95);
    const double s112 = atan2(a*centre_z*s101 + s105*s85, a*centre_z*s105 - s101*s85);
    (void)(q);
    out[0] = s112;
}

/* Per rod of one nominal limb: change of the closure by all errors, derivatives by rotation and joint (65 operations). */
static void linear(const double *x, double q, const double *tool, const double *k, double *out)
{
    const double px = x[0];
    const double py = x[1];
    const double pz = x[2];
    const double tx = tool[0];
    const double ty = tool[1];
    const double tz = tool[2];
    const double a = k[6];
    const double u_x = k[7];
    const double u_x_errors = k[8];
    const double s18 = k[9];
    const double u_y = k[10];
    const double u_y_errors = k[11];
    const double s24 = k[12];
    const double theta0 = k[13];
    const double A_x = k[14];
    const double da = k[15];
    const double s36 = k[16];
    const double s38 = k[17];
    const double A_y = k[18];
    const double s46 = k[19];
    const double s48 = k[20];
    const double tip_v = k[21];
    const double s59 = k[22];
    const double s64 = k[23];
    const double C_x_errors = k[24];
    const double C_y_errors = k[25];
    const double pz0 = k[26];
    const double s116 = k[27];
    const double s13 = cos(q);
    const double arm_x = s13*u_x;
    const double s15 = sin(q);
    const double arm_x_q = -s15*u_x;
    const double arm_x_errors = s13*u_x_errors + s15*s18;
    const double arm_y = s13*u_y;
    const double arm_y_q = -s15*u_y;
    const double arm_y_errors = s13*u_y_errors + s15*s24;
    const double arm_z = sin(q);
    const double arm_z_q = cos(q);
    const double arm_z_errors = s13*theta0;
    const double B_x = A_x + a*arm_x;
    const double B_x_q = a*arm_x_q;
    const double B_x_errors = a*arm_x_errors + arm_x*da + s15*s36 + s38;
    const double B_y = A_y + a*arm_y;
    const double B_y_q = a*arm_y_q;
    const double B_y_errors = a*arm_y_errors + arm_y*da + s15*s46 + s48;
    const double B_z = a*arm_z;
    const double B_z_q = a*arm_z_q;
    const double B_z_errors = a*arm_z_errors + arm_z*da + s13*tip_v;
    const double centre_x = px - tx;
    const double centre_y = py - ty;
    const double centre_z = pz - tz;
    const double C_x = centre_x + s59;
    const double C_y = centre_y + s64;
    const double rod_x = -B_x + C_x;
    const double rod_x_errors = -B_x_errors + C_x_errors;
    const double rod_y = -B_y + C_y;
    const double rod_y_errors = -B_y_errors + C_y_errors;
    const double rod_z = -B_z + centre_z;
    const double rod_z_errors = -B_z_errors + pz0;
    const double s117 = rod_x*rod_x_errors + rod_y*rod_y_errors + rod_z*rod_z_errors + s116;
    const double s121 = -B_x_q*rod_x - B_y_q*rod_y - B_z_q*rod_z;
    out[0] = s117;
    out[4] = s121;
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

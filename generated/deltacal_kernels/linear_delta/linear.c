/*
 * Generated from derive/mechanisms/linear_delta.py by "deltacal kernels". Do not edit.
 * Template templates/mechanism/linear.c.jinja; sha256 of both bd75664e0668d0ef; SymPy 1.14.0.
 *
 * The linear compensator: nominal joints, and the change that holds the reference point to first order in the errors.
 * An export puts the machine's numbers before this text: DELTACAL_K[3][22], DELTACAL_TOOL[3],
 * DELTACAL_SIGN[3]. Inside: mm and rad.
 */
#include <math.h>

#define DELTACAL_SOLVED 0
#define DELTACAL_UNREACHABLE 1
#define DELTACAL_SINGULAR 2
#define JOINT_PER_UNIT 1.0

/* Joint commands as the controller counts them, for a target of the reference point in the robot frame {O}. */
int deltacal_compensate(const double target_mm[3], double joints_mm[3]);


/* Joint of the nominal limb at a given position (13 operations). */
static void nominal_joint(const double *x, double q, const double *tool, const double *k, double *out)
{
    const double px = x[0];
    const double py = x[1];
    const double pz = x[2];
    const double tx = tool[0];
    const double ty = tool[1];
    const double tz = tool[2];
    const double s55 = k[0];
    const double s60 = k[1];
    const double s12 = k[2];
    const double h = k[3];
    const double s64 = sqrt(s12 - ((px + s55 - tx) * (px + s55 - tx)) - ((py + s60 - ty) * (py + s60 - ty)));
    const double s65 = h - pz - s64 + tz;
    (void)(q);
    out[0] = s65;
}

/* Per rod of one nominal limb: change of the closure by all errors, derivatives by rotation and joint (54 operations). */
static void linear(const double *x, double q, const double *tool, const double *k, double *out)
{
    const double px = x[0];
    const double py = x[1];
    const double pz = x[2];
    const double tx = tool[0];
    const double ty = tool[1];
    const double tz = tool[2];
    const double h = k[3];
    const double axis_x_errors = k[4];
    const double s27 = k[5];
    const double axis_y_errors = k[6];
    const double s33 = k[7];
    const double scale = k[8];
    const double h_errors = k[9];
    const double s37 = k[10];
    const double s39 = k[11];
    const double s23 = k[12];
    const double s42 = k[13];
    const double s29 = k[14];
    const double s44 = k[15];
    const double s72 = k[16];
    const double s_z_cx = k[17];
    const double s_z_cy = k[18];
    const double s_x_cz = k[19];
    const double s_y_cz = k[20];
    const double s87 = k[21];
    const double s21 = h - q;
    const double C_x_errors = axis_x_errors*s21 + s27;
    const double C_y_errors = axis_y_errors*s21 + s33;
    const double C_z_errors = h_errors - q*scale;
    const double s38 = s37 - tx;
    const double s40 = s39 - ty;
    const double A_x = px + s38;
    const double A_y = py + s40;
    const double A_z = pz - tz;
    const double d_x = A_x - s23;
    const double d_x_errors = -C_x_errors + s42;
    const double d_y = A_y - s29;
    const double d_y_errors = -C_y_errors + s44;
    const double d_z = A_z - s21;
    const double s66 = d_x*d_x_errors;
    const double s67 = d_y*d_y_errors;
    const double s68 = -C_z_errors*d_z;
    const double s73 = s66 + s67 + s68 + s72;
    const double s74 = d_y*tz;
    const double s75 = d_z*s40;
    const double s76 = d_z*s_z_cx;
    const double s77 = s74 + s75 + s76;
    const double s78 = -d_x*tz;
    const double s79 = -d_z*s38;
    const double s80 = d_z*s_z_cy;
    const double s81 = s78 + s79 + s80;
    const double s82 = -d_x*s40;
    const double s83 = d_y*s38;
    const double s84 = d_x*s_x_cz;
    const double s85 = d_y*s_y_cz;
    const double s86 = s82 + s83 + s84 + s85;
    const double s88 = s66 + s67 + s68 + s87;
    const double s89 = s74 + s75 - s76;
    const double s90 = s78 + s79 - s80;
    const double s91 = s82 + s83 - s84 - s85;
    out[0] = s73;
    out[4] = s77;
    out[5] = s81;
    out[6] = s86;
    out[7] = d_z;
    out[8] = s88;
    out[12] = s89;
    out[13] = s90;
    out[14] = s91;
    out[15] = d_z;
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

int deltacal_compensate(const double target_mm[3], double joints_mm[3])
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
        joints_mm[i] = DELTACAL_SIGN[i] * (q[i] - change[i]) * JOINT_PER_UNIT;
    return DELTACAL_SOLVED;
}

/*
 * Generated from derive/mechanisms/delta.py by "deltacal kernels". Do not edit.
 * Template templates/mechanism/linear.c.jinja; sha256 of both cbe2e331eda6763b; SymPy 1.14.0.
 *
 * The linear compensator: nominal joints, and the change that holds the reference point to first order in the errors.
 * An export puts the machine's numbers before this text: DELTACAL_K[3][35], DELTACAL_TOOL[3],
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
    const double s106 = k[0];
    const double s108 = k[1];
    const double s110 = k[2];
    const double s112 = k[3];
    const double s129 = k[4];
    const double s124 = k[5];
    const double L = k[6];
    const double A_z = pz - tz;
    const double s107 = px + s106 - tx;
    const double s111 = py + s110 - ty;
    const double s114 = s107*s108 + s111*s112;
    const double s116 = (A_z * A_z);
    const double s130 = (1.0/2.0)*(s107 * s107) + (1.0/2.0)*(s111 * s111) + (1.0/2.0)*s116 + s129;
    const double s134 = sqrt((s114 * s114) + s116*s124 - (s130 * s130));
    const double s141 = atan2(A_z*L*s130 - s114*s134, -A_z*L*s134 - s114*s130);
    (void)(q);
    out[0] = s141;
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
    const double R0_11 = k[7];
    const double R0_11_errors = k[8];
    const double R0_12_errors = k[9];
    const double theta = k[10];
    const double R0_21 = k[11];
    const double R0_21_errors = k[12];
    const double R0_22_errors = k[13];
    const double B_x = k[14];
    const double dL = k[15];
    const double tip_v = k[16];
    const double s58 = k[17];
    const double B_y = k[18];
    const double s67 = k[19];
    const double ez = k[20];
    const double s75 = k[21];
    const double s77 = k[22];
    const double g_x_errors = k[23];
    const double g_y_errors = k[24];
    const double s87 = k[25];
    const double s94 = k[26];
    const double s98 = k[27];
    const double h_x_errors = k[28];
    const double h_y_errors = k[29];
    const double h_z_errors = k[30];
    const double s150 = k[31];
    const double h_y = k[32];
    const double h_x = k[33];
    const double s169 = k[34];
    const double s27 = cos(q);
    const double s28 = R0_11*s27;
    const double s29 = sin(q);
    const double s30 = -R0_11*s29;
    const double R1_11_errors = R0_11_errors*s27 + R0_12_errors*s29 + s30*theta;
    const double s39 = R0_21*s27;
    const double s40 = -R0_21*s29;
    const double R1_21_errors = R0_21_errors*s27 + R0_22_errors*s29 + s40*theta;
    const double R1_31_errors = s27*theta;
    const double C_x = B_x + L*s28;
    const double C_x_q = L*s30;
    const double C_x_errors = L*R1_11_errors + dL*s28 + s30*tip_v + s58;
    const double C_y = B_y + L*s39;
    const double C_y_q = L*s40;
    const double C_y_errors = L*R1_21_errors + dL*s39 + s40*tip_v + s67;
    const double C_z_q = L*s27;
    const double C_z_errors = L*R1_31_errors + dL*s29 + ez + s27*tip_v;
    const double s76 = s75 - tx;
    const double s78 = s77 - ty;
    const double A_x = px + s76;
    const double A_y = py + s78;
    const double A_z = pz - tz;
    const double c1_x_errors = g_x_errors*s28 + g_y_errors*s30 + s87;
    const double c1_y_errors = g_x_errors*s39 + g_y_errors*s40 + s94;
    const double c1_z_errors = g_x_errors*s29 + g_y_errors*s27 + s98;
    const double d_x = A_x - C_x;
    const double d_y = A_y - C_y;
    const double d_z = A_z - L*s29;
    const double s_x_errors = -c1_x_errors + h_x_errors;
    const double s_y_errors = -c1_y_errors + h_y_errors;
    const double s_z_errors = -c1_z_errors + h_z_errors;
    const double s142 = -C_x_errors*d_x;
    const double s143 = -C_y_errors*d_y;
    const double s144 = -C_z_errors*d_z;
    const double s145 = d_x*s_x_errors;
    const double s146 = d_y*s_y_errors;
    const double s147 = d_z*s_z_errors;
    const double s151 = s142 + s143 + s144 + s145 + s146 + s147 + s150;
    const double s152 = d_y*tz;
    const double s153 = d_z*s78;
    const double s154 = d_z*h_y;
    const double s155 = s152 + s153 + s154;
    const double s156 = -d_x*tz;
    const double s157 = -d_z*s76;
    const double s158 = -d_z*h_x;
    const double s159 = s156 + s157 + s158;
    const double s160 = -d_x*s78;
    const double s161 = d_y*s76;
    const double s162 = -d_x*h_y;
    const double s163 = d_y*h_x;
    const double s164 = s160 + s161 + s162 + s163;
    const double s168 = -C_x_q*d_x - C_y_q*d_y - C_z_q*d_z;
    const double s170 = s142 + s143 + s144 - s145 - s146 - s147 + s169;
    const double s171 = s152 + s153 - s154;
    const double s172 = s156 + s157 - s158;
    const double s173 = s160 + s161 - s162 - s163;
    out[0] = s151;
    out[4] = s155;
    out[5] = s159;
    out[6] = s164;
    out[7] = s168;
    out[8] = s170;
    out[12] = s171;
    out[13] = s172;
    out[14] = s173;
    out[15] = s168;
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

/*
 * Generated from derive/mechanisms/hexapod.py by "deltacal kernels". Do not edit.
 * Template templates/mechanism/inverse.c.jinja; sha256 of both 63e65434b6755068; SymPy 1.14.0.
 *
 * The exact compensator: inverse position of the calibrated machine, by Newton on joints and platform rotation.
 * An export puts the machine's numbers before this text: DELTACAL_K[6][12], DELTACAL_TOOL[3],
 * DELTACAL_SIGN[6]. Inside: mm and rad.
 */
#include <math.h>

#define DELTACAL_SOLVED 0
#define DELTACAL_UNREACHABLE 1
#define DELTACAL_SINGULAR 2
#define JOINT_PER_UNIT 1.0

/* Joint commands as the controller counts them, for a target of the reference point in the robot frame {O}. */
int deltacal_compensate(const double target[6], double joints_mm[6]);


#define MAX_STEPS 30
#define STEP_DONE 3e-8 /* rad; after such a step a command is exact to its square */
#define STEP_LOST 1e5 /* rad; a step of this size leads nowhere */

/* Per rod of one limb: closure, its derivatives by the platform, by the joint (169 operations). */
static void newton(const double *x, double q, const double *tool, const double *k, double *out)
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
    const double s44 = k[0];
    const double s48 = k[1];
    const double s50 = k[2];
    const double A_x = k[3];
    const double A_y = k[4];
    const double A_z = k[5];
    const double s67 = k[6];
    const double s69 = k[7];
    const double s0 = (cx * cx);
    const double s2 = (cy * cy);
    const double s4 = (cz * cz);
    const double s6 = (1.0/4.0)*s0 + (1.0/4.0)*s2 + (1.0/4.0)*s4 + 1;
    const double s7 = 1.0/s6;
    const double s8 = -1.0/2.0*s2;
    const double s9 = -1.0/2.0*s4;
    const double s10 = s8 + s9;
    const double R_11 = s10*s7 + 1;
    const double s13 = (1.0/2.0)*cx*cy;
    const double s14 = -cz + s13;
    const double R_12 = s14*s7;
    const double s16 = (1.0/2.0)*cx*cz;
    const double s17 = cy + s16;
    const double R_13 = s17*s7;
    const double s19 = cz + s13;
    const double R_21 = s19*s7;
    const double s21 = -1.0/2.0*s0;
    const double s22 = s21 + s9;
    const double R_22 = s22*s7 + 1;
    const double s25 = (1.0/2.0)*cy*cz;
    const double s26 = -cx + s25;
    const double R_23 = s26*s7;
    const double s28 = -cy + s16;
    const double R_31 = s28*s7;
    const double s30 = cx + s25;
    const double R_32 = s30*s7;
    const double s32 = s21 + s8;
    const double R_33 = s32*s7 + 1;
    const double b_x = s44 - tx;
    const double b_y = s48 - ty;
    const double b_z = s50 - tz;
    const double B_x = R_11*b_x + R_12*b_y + R_13*b_z + px;
    const double B_y = R_21*b_x + R_22*b_y + R_23*b_z + py;
    const double B_z = R_31*b_x + R_32*b_y + R_33*b_z + pz;
    const double d_x = -A_x + B_x;
    const double d_y = -A_y + B_y;
    const double d_z = -A_z + B_z;
    const double s = q*s67 + s69;
    const double s83 = (1.0/2.0)*(d_x * d_x) + (1.0/2.0)*(d_y * d_y) + (1.0/2.0)*(d_z * d_z) - 1.0/2.0*(s * s);
    const double s86 = 2*d_z;
    const double s87 = (1.0/2.0)*s86;
    const double s88 = 2*d_y;
    const double s89 = (1.0/2.0)*s88;
    const double s90 = 2*d_x;
    const double s91 = (1.0/2.0)*s90;
    const double s92 = -s*s67;
    const double s94 = b_z*s87;
    const double s96 = b_y*s87;
    const double s98 = b_x*s87;
    const double s100 = b_z*s89;
    const double s102 = b_y*s89;
    const double s104 = b_x*s89;
    const double s106 = b_z*s91;
    const double s108 = b_y*s91;
    const double s110 = b_x*s91;
    const double s115 = s7*s94;
    const double s117 = s7*s96;
    const double s119 = s7*s98;
    const double s121 = s100*s7;
    const double s123 = s117 + s121;
    const double s124 = (1.0/2.0)*cz;
    const double s125 = (1.0/2.0)*cy;
    const double s128 = s102*s7;
    const double s129 = s102*s22;
    const double s132 = s104*s7;
    const double s133 = s104*s19;
    const double s134 = s106*s7;
    const double s135 = s106*s17;
    const double s136 = s119 + s134;
    const double s137 = (1.0/2.0)*cx;
    const double s140 = s108*s7;
    const double s141 = s108*s14;
    const double s142 = s132 + s140;
    const double s145 = s110*s7;
    const double s146 = s10*s110;
    const double s151 = s100*s26 + s129 + s133 + s135 + s141 + s146 + s28*s98 + s30*s96 + s32*s94;
    const double s154 = -1.0/4.0*s151/(s6 * s6);
    const double s164 = 2*cx*(-1.0/2.0*s115 - 1.0/2.0*s128 + s154) + s117 - s121 + s124*s136 + s125*s142;
    const double s165 = 2*cy*(-1.0/2.0*s115 - 1.0/2.0*s145 + s154) - s119 + s123*s124 + s134 + s137*s142;
    const double s166 = 2*cz*(-1.0/2.0*s128 - 1.0/2.0*s145 + s154) + s123*s125 + s132 + s136*s137 - s140;
    out[0] = s83;
    out[1] = s91;
    out[2] = s89;
    out[3] = s87;
    out[4] = s164;
    out[5] = s165;
    out[6] = s166;
    out[7] = s92;
}

/* Joint of the simplified limb at a given position, then the platform's coordinates that follow from it (81 operations). */
static void joint(const double *x, double q, const double *tool, const double *k, double *out)
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
    const double s44 = k[0];
    const double s48 = k[1];
    const double s50 = k[2];
    const double A_x = k[3];
    const double A_y = k[4];
    const double A_z = k[5];
    const double s184 = k[8];
    const double s186 = k[9];
    const double s192 = k[10];
    const double s195 = k[11];
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
    const double b_x = s44 - tx;
    const double b_y = s48 - ty;
    const double b_z = s50 - tz;
    const double s171 = ((-A_x + R_11*b_x + b_y*s7*(-cz + s13) + b_z*s7*(cy + s16) + px) * (-A_x + R_11*b_x + b_y*s7*(-cz + s13) + b_z*s7*(cy + s16) + px));
    const double s176 = ((-A_y + R_22*b_y + b_x*s7*(cz + s13) + b_z*s7*(-cx + s25) + py) * (-A_y + R_22*b_y + b_x*s7*(cz + s13) + b_z*s7*(-cx + s25) + py));
    const double s181 = ((-A_z + R_33*b_z + b_x*s7*(-cy + s16) + b_y*s7*(cx + s25) + pz) * (-A_z + R_33*b_z + b_x*s7*(-cy + s16) + b_y*s7*(cx + s25) + pz));
    const double s196 = s195 + sqrt(s186*((1.0/2.0)*s171 + (1.0/2.0)*s176 + (1.0/2.0)*s181 + s184) + s192);
    (void)(q);
    out[0] = s196;
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
    double x[6], q[6], change[6], start[1], turned[1], loop[6 * LIMB];
    int i, c, steps;
    stated(target, 0.0, DELTACAL_TOOL, DELTACAL_K[0], x);
    for (i = 0; i < 6; i++) {
        joint(x, 0.0, DELTACAL_TOOL, DELTACAL_K[i], start);
        q[i] = start[0];
        if (!isfinite(q[i]))
            return DELTACAL_UNREACHABLE;
    }
    for (steps = 0; steps < MAX_STEPS; steps++) {
        double size = 0.0;
        for (i = 0; i < 6; i++)
            newton(x, q[i], DELTACAL_TOOL, DELTACAL_K[i], loop + LIMB * i);
        if (!hold(loop, change, turned))
            return DELTACAL_SINGULAR;
        for (i = 0; i < 6; i++) {
            q[i] -= change[i];
            size = fmax(size, fabs(change[i]));
        }
        for (c = 0; c < 0; c++) {
            x[6 + c] -= turned[c];
            size = fmax(size, fabs(turned[c]));
        }
        if (size < STEP_DONE) {
            for (i = 0; i < 6; i++)
                joints_mm[i] = DELTACAL_SIGN[i] * q[i] * JOINT_PER_UNIT;
            return DELTACAL_SOLVED;
        }
        if (!(size < STEP_LOST))
            break;
    }
    return DELTACAL_UNREACHABLE;
}

/*
 * Generated from derive/mechanisms/planar_parallelogram.py by "deltacal kernels". Do not edit.
 * Template templates/mechanism/inverse.c.jinja; sha256 of both e5481759e407a5b3; SymPy 1.14.0.
 *
 * The exact compensator: inverse position of the calibrated machine, by Newton on joints and platform rotation.
 * An export puts the machine's numbers before this text: DELTACAL_K[1][26], DELTACAL_TOOL[3],
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

/* Per rod of one limb: closure, its derivatives by the platform, by the joint (101 operations). */
static void newton(const double *x, double q, const double *tool, const double *k, double *out)
{
    const double px = x[0];
    const double py = x[1];
    const double cz = x[2];
    const double tx = tool[0];
    const double ty = tool[1];
    const double h = k[0];
    const double q0 = k[1];
    const double s7 = k[2];
    const double b1_x = k[3];
    const double b2_x = k[4];
    const double b2_y = k[5];
    const double A2_x = k[6];
    const double A2_y = k[7];
    const double A1_x = k[8];
    const double s71 = k[9];
    const double C_y = -h + ty;
    const double s8 = q + q0;
    const double r1_x = s7*sin(s8);
    const double r1_y = -s7*cos(s8);
    const double s13 = (cz * cz);
    const double s15 = (1.0/4.0)*s13 + 1;
    const double s16 = 1.0/s15;
    const double s17 = -1.0/2.0*s13*s16;
    const double R_11 = s17 + 1;
    const double R_12 = -cz*s16;
    const double R_21 = cz*s16;
    const double R_22 = s17 + 1;
    const double s22 = b1_x - tx;
    const double B1_x = -C_y*R_12 + R_11*s22 + px;
    const double B1_y = -C_y*R_22 + R_21*s22 + py;
    const double s29 = b2_x - tx;
    const double s31 = -C_y + b2_y;
    const double B2_x = R_11*s29 + R_12*s31 + px;
    const double B2_y = R_21*s29 + R_22*s31 + py;
    const double r2_x = -A2_x + B2_x;
    const double r2_y = -A2_y + B2_y;
    const double s39 = -A1_x + B1_x - r1_x;
    const double s42 = -1.0/2.0*s16;
    const double s43 = -1.0/2.0*s13;
    const double s47 = (1.0 / (s15 * s15));
    const double s51 = 2*cz;
    const double s53 = C_y*s16 + s51*(s22*s42 - 1.0/4.0*s47*(C_y*cz + s22*s43));
    const double s54 = B1_y - r1_y;
    const double s64 = s16*s22 + s51*(-C_y*s42 - 1.0/4.0*s47*(-C_y*s43 + cz*s22));
    const double s72 = (1.0/2.0)*(r2_x * r2_x) + (1.0/2.0)*(r2_y * r2_y) + s71;
    const double s73 = 2*r2_y;
    const double s74 = (1.0/2.0)*s73;
    const double s75 = 2*r2_x;
    const double s76 = (1.0/2.0)*s75;
    const double s79 = s29*s74;
    const double s81 = s31*s76;
    const double s91 = s29*s76 + s31*s74;
    const double s98 = s51*(s42*s91 - 1.0/4.0*s47*(cz*s79 - cz*s81 + s43*s91));
    const double s99 = s16*s79 - s16*s81 + s98;
    out[0] = s39;
    out[1] = 1;
    out[2] = 0;
    out[3] = s53;
    out[4] = r1_y;
    out[5] = s54;
    out[6] = 0;
    out[7] = 1;
    out[8] = s64;
    out[9] = -r1_x;
    out[10] = s72;
    out[11] = s76;
    out[12] = s74;
    out[13] = s99;
    out[14] = 0;
}

/* Joint of the simplified limb at a given position, then the platform's coordinates that follow from it (64 operations). */
static void joint(const double *x, double q, const double *tool, const double *k, double *out)
{
    const double px = x[0];
    const double tx = tool[0];
    const double ty = tool[1];
    const double h = k[0];
    const double q0 = k[1];
    const double s7 = k[2];
    const double b1_x = k[3];
    const double s103 = k[10];
    const double s102 = k[11];
    const double s108 = k[12];
    const double s116 = k[13];
    const double s120 = k[14];
    const double s122 = k[15];
    const double s124 = k[16];
    const double s130 = k[17];
    const double s134 = k[18];
    const double s136 = k[19];
    const double s138 = k[20];
    const double s149 = k[21];
    const double s153 = k[22];
    const double s156 = k[23];
    const double s158 = k[24];
    const double s160 = k[25];
    const double C_y = -h + ty;
    const double s104 = px + s103 - tx;
    const double s107 = -q0 + asin(s102*s104);
    const double s109 = (s104 * s104);
    const double s111 = -s108*s109 + 1;
    const double s112 = sqrt(s111);
    const double s125 = s104*s116 + s112*s120 + s112*s122 + s124;
    const double s139 = s104*s130 + s104*s134 + s112*s136 + s138;
    const double s161 = s104*s153 + s104*s156 + s109 + s111*s149 + s112*s158 + s160;
    const double s164 = sqrt((s125 * s125) + (s139 * s139) - (s161 * s161));
    const double s167 = -s125*s161 + s139*s164;
    const double s171 = -s125*s164 - s139*s161;
    const double s174 = pow((s167 * s167) + (s171 * s171), -1.0/2.0);
    const double s177 = C_y*s171*s174 - s112*s7 - s167*s174*(b1_x - tx);
    const double s181 = 2*tan((1.0/2.0)*atan2(s167, s171));
    (void)(q);
    out[0] = s107;
    out[1] = s177;
    out[2] = s181;
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

/*
 * Generated from derive/mechanisms/robotennis.py by "deltacal kernels". Do not edit.
 * Template templates/mechanism/inverse.c.jinja; sha256 of both 25a52854d2026daf; SymPy 1.14.0.
 *
 * The exact compensator: inverse position of the calibrated machine, by Newton on joints and platform rotation.
 * An export puts the machine's numbers before this text: DELTACAL_K[3][22], DELTACAL_TOOL[3],
 * DELTACAL_SIGN[3]. Inside: mm and rad.
 */
#include <math.h>

#define DELTACAL_SOLVED 0
#define DELTACAL_UNREACHABLE 1
#define DELTACAL_SINGULAR 2
#define JOINT_PER_UNIT 57.295779513082320877 /* deg per rad */

/* Joint commands as the controller counts them, for a target of the reference point in the robot frame {O}. */
int deltacal_compensate(const double target_mm[3], double joints_deg[3]);


#define MAX_STEPS 30
#define STEP_DONE 3e-8 /* rad; after such a step a command is exact to its square */
#define STEP_LOST 1e5 /* rad; a step of this size leads nowhere */

/* Per rod of one limb: closure, its derivatives by the platform, by the joint (60 operations). */
static void newton(const double *x, double q, const double *tool, const double *k, double *out)
{
    const double px = x[0];
    const double py = x[1];
    const double pz = x[2];
    const double tx = tool[0];
    const double ty = tool[1];
    const double tz = tool[2];
    const double theta0 = k[0];
    const double u_x = k[1];
    const double u_y = k[2];
    const double s11 = k[3];
    const double s14 = k[4];
    const double s16 = k[5];
    const double s20 = k[6];
    const double s22 = k[7];
    const double tip_v = k[8];
    const double px0 = k[9];
    const double py0 = k[10];
    const double pz0 = k[11];
    const double s31 = k[12];
    const double s33 = k[13];
    const double s46 = k[14];
    const double s6 = q + theta0;
    const double s7 = cos(s6);
    const double arm_x = s7*u_x;
    const double arm_y = s7*u_y;
    const double arm_z = sin(s6);
    const double B_x = arm_x*s11 + arm_z*s14 + s16;
    const double B_y = arm_y*s11 + arm_z*s20 + s22;
    const double B_z = arm_z*s11 + s7*tip_v;
    const double centre_x = px + px0 - tx;
    const double centre_y = py + py0 - ty;
    const double centre_z = pz + pz0 - tz;
    const double C_x = centre_x + s31;
    const double C_y = centre_y + s33;
    const double rod_x = -B_x + C_x;
    const double rod_y = -B_y + C_y;
    const double rod_z = -B_z + centre_z;
    const double s47 = (1.0/2.0)*(rod_x * rod_x) + (1.0/2.0)*(rod_y * rod_y) + (1.0/2.0)*(rod_z * rod_z) + s46;
    const double s48 = 2*rod_z;
    const double s49 = (1.0/2.0)*s48;
    const double s50 = 2*rod_y;
    const double s51 = (1.0/2.0)*s50;
    const double s52 = 2*rod_x;
    const double s53 = (1.0/2.0)*s52;
    const double s73 = -arm_z*(-s11*s51*u_y - s11*s53*u_x - s49*tip_v);
    const double s74 = s7*(-s11*s49 - s14*s53 - s20*s51) + s73;
    out[0] = s47;
    out[1] = s53;
    out[2] = s51;
    out[3] = s49;
    out[4] = s74;
}

/* Joint of the simplified limb at a given position, then the platform's coordinates that follow from it (35 operations). */
static void joint(const double *x, double q, const double *tool, const double *k, double *out)
{
    const double px = x[0];
    const double py = x[1];
    const double pz = x[2];
    const double tx = tool[0];
    const double ty = tool[1];
    const double tz = tool[2];
    const double theta0 = k[0];
    const double pz0 = k[11];
    const double s96 = k[15];
    const double s98 = k[16];
    const double s100 = k[17];
    const double s102 = k[18];
    const double s117 = k[19];
    const double s124 = k[20];
    const double s129 = k[21];
    const double centre_z = pz + pz0 - tz;
    const double s97 = px + s96 - tx;
    const double s101 = py + s100 - ty;
    const double s104 = s101*s102 + s97*s98;
    const double s106 = (centre_z * centre_z);
    const double s118 = (1.0/2.0)*(s101 * s101) + (1.0/2.0)*s106 + s117 + (1.0/2.0)*(s97 * s97);
    const double s127 = sqrt((s104 * s104) + s106*s124 - (s118 * s118));
    const double s136 = -theta0 + atan2(centre_z*s118*s129 + s104*s127, centre_z*s127*s129 - s104*s118);
    (void)(q);
    out[0] = s136;
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
    double x[3], q[3], change[3], start[1], turned[1], loop[3 * LIMB];
    int i, c, steps;
    for (c = 0; c < 3; c++)
        x[c] = c < 3 ? target_mm[c] : 0.0;
    for (i = 0; i < 3; i++) {
        joint(x, 0.0, DELTACAL_TOOL, DELTACAL_K[i], start);
        q[i] = start[0];
        if (!isfinite(q[i]))
            return DELTACAL_UNREACHABLE;
    }
    for (steps = 0; steps < MAX_STEPS; steps++) {
        double size = 0.0;
        for (i = 0; i < 3; i++)
            newton(x, q[i], DELTACAL_TOOL, DELTACAL_K[i], loop + LIMB * i);
        if (!hold(loop, change, turned))
            return DELTACAL_SINGULAR;
        for (i = 0; i < 3; i++) {
            q[i] -= change[i];
            size = fmax(size, fabs(change[i]));
        }
        for (c = 0; c < 0; c++) {
            x[3 + c] -= turned[c];
            size = fmax(size, fabs(turned[c]));
        }
        if (size < STEP_DONE) {
            for (i = 0; i < 3; i++)
                joints_deg[i] = DELTACAL_SIGN[i] * q[i] * JOINT_PER_UNIT;
            return DELTACAL_SOLVED;
        }
        if (!(size < STEP_LOST))
            break;
    }
    return DELTACAL_UNREACHABLE;
}

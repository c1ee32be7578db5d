/*
 * Generated from derive/mechanisms/linear_delta.py by "deltacal kernels". Do not edit.
 * Template templates/mechanism/inverse.c.jinja; sha256 of both 8df5f5952b5f2efa; SymPy 1.14.0.
 *
 * The exact compensator: inverse position of the calibrated machine, by Newton on joints and platform rotation.
 * An export puts the machine's numbers before this text: DELTACAL_K[3][21], DELTACAL_TOOL[3],
 * DELTACAL_SIGN[3]. Inside: mm and rad.
 */
#include <math.h>

#define DELTACAL_SOLVED 0
#define DELTACAL_UNREACHABLE 1
#define DELTACAL_SINGULAR 2
#define JOINT_PER_UNIT 1.0

/* Joint commands as the controller counts them, for a target of the reference point in the robot frame {O}. */
int deltacal_compensate(const double target_mm[3], double joints_mm[3]);


#define MAX_STEPS 30
#define STEP_DONE 3e-8 /* rad; after such a step a command is exact to its square */
#define STEP_LOST 1e5 /* rad; a step of this size leads nowhere */

/* Per rod of one limb: closure, its derivatives by the platform, by the joint (334 operations). */
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
    const double s60 = k[0];
    const double s59 = k[1];
    const double axis_x = k[2];
    const double s65 = k[3];
    const double axis_y = k[4];
    const double s68 = k[5];
    const double axis_z = k[6];
    const double s106 = k[7];
    const double s109 = k[8];
    const double u_x = k[9];
    const double u_y = k[10];
    const double s128 = k[11];
    const double s150 = k[12];
    const double s516 = k[13];
    const double s62 = -q*s60 + s59;
    const double C_x = axis_x*s62 + s65;
    const double C_y = axis_y*s62 + s68;
    const double C_z = axis_z*s62;
    const double s71 = (cx * cx);
    const double s73 = (cy * cy);
    const double s75 = (cz * cz);
    const double s77 = (1.0/4.0)*s71 + (1.0/4.0)*s73 + (1.0/4.0)*s75 + 1;
    const double s78 = 1.0/s77;
    const double s79 = -1.0/2.0*s73;
    const double s80 = -1.0/2.0*s75;
    const double s81 = s79 + s80;
    const double R_11 = s78*s81 + 1;
    const double s84 = (1.0/2.0)*cx*cy;
    const double s85 = -cz + s84;
    const double R_12 = s78*s85;
    const double s87 = (1.0/2.0)*cx*cz;
    const double s88 = cy + s87;
    const double R_13 = s78*s88;
    const double s90 = cz + s84;
    const double R_21 = s78*s90;
    const double s92 = -1.0/2.0*s71;
    const double s93 = s80 + s92;
    const double R_22 = s78*s93 + 1;
    const double s96 = (1.0/2.0)*cy*cz;
    const double s97 = -cx + s96;
    const double R_23 = s78*s97;
    const double s99 = -cy + s87;
    const double R_31 = s78*s99;
    const double s101 = cx + s96;
    const double R_32 = s101*s78;
    const double s103 = s79 + s92;
    const double R_33 = s103*s78 + 1;
    const double s107 = s106 - tx;
    const double s110 = s109 - ty;
    const double A_x = R_11*s107 + R_12*s110 - R_13*tz + px;
    const double A_y = R_21*s107 + R_22*s110 - R_23*tz + py;
    const double A_z = R_31*s107 + R_32*s110 - R_33*tz + pz;
    const double d_x = A_x - C_x;
    const double d_y = A_y - C_y;
    const double d_z = A_z - C_z;
    const double s_x = s128*(-R_11*u_y + R_12*u_x + u_y);
    const double s_y = s128*(-R_21*u_y + R_22*u_x - u_x);
    const double s_z = s128*(-R_31*u_y + R_32*u_x);
    const double s138 = d_x + s_x;
    const double s141 = d_y + s_y;
    const double s144 = d_z + s_z;
    const double s151 = (1.0/2.0)*(s138 * s138) + (1.0/2.0)*(s141 * s141) + (1.0/2.0)*(s144 * s144) + s150;
    const double s152 = 2*s144;
    const double s153 = (1.0/2.0)*s152;
    const double s154 = 2*s141;
    const double s155 = (1.0/2.0)*s154;
    const double s156 = 2*s138;
    const double s157 = (1.0/2.0)*s156;
    const double s159 = s128*s153;
    const double s165 = s128*s155;
    const double s170 = s128*s157;
    const double s176 = -s153*tz;
    const double s182 = -s155*tz;
    const double s188 = -s157*tz;
    const double s196 = s176*s78;
    const double s198 = s110*s153 + s159*u_x;
    const double s199 = s198*s78;
    const double s201 = s107*s153 - s159*u_y;
    const double s203 = s201*s78;
    const double s205 = s182*s78;
    const double s206 = s199 + s205;
    const double s207 = (1.0/2.0)*cz;
    const double s208 = (1.0/2.0)*cy;
    const double s211 = s110*s155 + s165*u_x;
    const double s212 = s211*s93;
    const double s213 = s211*s78;
    const double s216 = s107*s155 - s165*u_y;
    const double s217 = s216*s90;
    const double s218 = s216*s78;
    const double s219 = s188*s88;
    const double s220 = s188*s78;
    const double s221 = s203 + s220;
    const double s222 = (1.0/2.0)*cx;
    const double s225 = s110*s157 + s170*u_x;
    const double s226 = s225*s85;
    const double s227 = s225*s78;
    const double s228 = s218 + s227;
    const double s231 = s107*s157 - s170*u_y;
    const double s232 = s231*s81;
    const double s233 = s231*s78;
    const double s238 = s101*s198 + s103*s176 + s182*s97 + s201*s99 + s212 + s217 + s219 + s226 + s232;
    const double s239 = (1.0 / (s77 * s77));
    const double s241 = -1.0/4.0*s238*s239;
    const double s243 = 2*cz;
    const double s246 = 2*cy;
    const double s249 = 2*cx;
    const double s258 = -s60*(-axis_x*s157 - axis_y*s155 - axis_z*s153);
    const double s264 = s199 - s205 + s207*s221 + s208*s228 + s249*(-1.0/2.0*s196 - 1.0/2.0*s213 + s241);
    const double s265 = -s203 + s206*s207 + s220 + s222*s228 + s246*(-1.0/2.0*s196 - 1.0/2.0*s233 + s241);
    const double s266 = s206*s208 + s218 + s221*s222 - s227 + s243*(-1.0/2.0*s213 - 1.0/2.0*s233 + s241);
    const double s505 = d_x - s_x;
    const double s508 = d_y - s_y;
    const double s511 = d_z - s_z;
    const double s517 = (1.0/2.0)*(s505 * s505) + (1.0/2.0)*(s508 * s508) + (1.0/2.0)*(s511 * s511) + s516;
    const double s518 = 2*s511;
    const double s519 = (1.0/2.0)*s518;
    const double s520 = 2*s508;
    const double s521 = (1.0/2.0)*s520;
    const double s522 = 2*s505;
    const double s523 = (1.0/2.0)*s522;
    const double s525 = -s128*s519;
    const double s531 = -s128*s521;
    const double s536 = -s128*s523;
    const double s542 = -s519*tz;
    const double s548 = -s521*tz;
    const double s554 = -s523*tz;
    const double s562 = s542*s78;
    const double s564 = s110*s519 + s525*u_x;
    const double s565 = s564*s78;
    const double s567 = s107*s519 - s525*u_y;
    const double s569 = s567*s78;
    const double s571 = s548*s78;
    const double s572 = s565 + s571;
    const double s575 = s110*s521 + s531*u_x;
    const double s576 = s575*s93;
    const double s577 = s575*s78;
    const double s580 = s107*s521 - s531*u_y;
    const double s581 = s580*s90;
    const double s582 = s580*s78;
    const double s583 = s554*s88;
    const double s584 = s554*s78;
    const double s585 = s569 + s584;
    const double s588 = s110*s523 + s536*u_x;
    const double s589 = s588*s85;
    const double s590 = s588*s78;
    const double s591 = s582 + s590;
    const double s594 = s107*s523 - s536*u_y;
    const double s595 = s594*s81;
    const double s596 = s594*s78;
    const double s601 = s101*s564 + s103*s542 + s548*s97 + s567*s99 + s576 + s581 + s583 + s589 + s595;
    const double s603 = -1.0/4.0*s239*s601;
    const double s617 = -s60*(-axis_x*s523 - axis_y*s521 - axis_z*s519);
    const double s623 = s207*s585 + s208*s591 + s249*(-1.0/2.0*s562 - 1.0/2.0*s577 + s603) + s565 - s571;
    const double s624 = s207*s572 + s222*s591 + s246*(-1.0/2.0*s562 - 1.0/2.0*s596 + s603) - s569 + s584;
    const double s625 = s208*s572 + s222*s585 + s243*(-1.0/2.0*s577 - 1.0/2.0*s596 + s603) + s582 - s590;
    out[0] = s151;
    out[1] = s157;
    out[2] = s155;
    out[3] = s153;
    out[4] = s264;
    out[5] = s265;
    out[6] = s266;
    out[7] = s258;
    out[8] = s517;
    out[9] = s523;
    out[10] = s521;
    out[11] = s519;
    out[12] = s623;
    out[13] = s624;
    out[14] = s625;
    out[15] = s617;
}

/* Joint of the simplified limb at a given position, then the platform's coordinates that follow from it (22 operations). */
static void joint(const double *x, double q, const double *tool, const double *k, double *out)
{
    const double px = x[0];
    const double py = x[1];
    const double pz = x[2];
    const double tx = tool[0];
    const double ty = tool[1];
    const double tz = tool[2];
    const double s660 = k[14];
    const double s665 = k[15];
    const double h = k[16];
    const double s672 = k[17];
    const double s674 = k[18];
    const double s680 = k[19];
    const double s684 = k[20];
    const double s669 = -h + pz - tz;
    const double s670 = (s669 * s669);
    const double s673 = (1.0/2.0)*s670 + s672 + (1.0/2.0)*((px + s660 - tx) * (px + s660 - tx)) + (1.0/2.0)*((py + s665 - ty) * (py + s665 - ty));
    const double s686 = s669*s684 - sqrt(s670*s680 + s673*s674);
    (void)(q);
    out[0] = s686;
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
    double x[6], q[3], change[3], start[1], turned[3], loop[3 * LIMB];
    int i, c, steps;
    for (c = 0; c < 6; c++)
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
        for (c = 0; c < 3; c++) {
            x[3 + c] -= turned[c];
            size = fmax(size, fabs(turned[c]));
        }
        if (size < STEP_DONE) {
            for (i = 0; i < 3; i++)
                joints_mm[i] = DELTACAL_SIGN[i] * q[i] * JOINT_PER_UNIT;
            return DELTACAL_SOLVED;
        }
        if (!(size < STEP_LOST))
            break;
    }
    return DELTACAL_UNREACHABLE;
}

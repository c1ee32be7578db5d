/*
 * Generated from derive/mechanisms/complete_delta.py by "deltacal kernels". Do not edit.
 * Template templates/mechanism/inverse.c.jinja; sha256 of both b1572cc3133a2686; SymPy 1.14.0.
 *
 * The exact compensator: inverse position of the calibrated machine, by Newton on joints and platform rotation.
 * An export puts the machine's numbers before this text: DELTACAL_K[3][31], DELTACAL_TOOL[3],
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

/* Per rod of one limb: closure, its derivatives by the platform, by the joint (395 operations). */
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
    const double R0_12 = k[0];
    const double R0_13 = k[1];
    const double R0_22 = k[2];
    const double R0_23 = k[3];
    const double R0_32 = k[4];
    const double R0_33 = k[5];
    const double g1_y = k[6];
    const double g1_z = k[7];
    const double s147 = k[8];
    const double s153 = k[9];
    const double s155 = k[10];
    const double h1_x = k[11];
    const double h1_y = k[12];
    const double bz1 = k[13];
    const double g2_y = k[14];
    const double g2_z = k[15];
    const double s185 = k[16];
    const double s190 = k[17];
    const double s192 = k[18];
    const double h2_x = k[19];
    const double h2_y = k[20];
    const double bz2 = k[21];
    const double s222 = k[22];
    const double s671 = k[23];
    const double s78 = cos(q);
    const double s80 = sin(q);
    const double R1_12 = R0_12*s78 + R0_13*s80;
    const double R1_13 = -R0_12*s80 + R0_13*s78;
    const double R1_22 = R0_22*s78 + R0_23*s80;
    const double R1_23 = -R0_22*s80 + R0_23*s78;
    const double R1_32 = R0_32*s78 + R0_33*s80;
    const double R1_33 = -R0_32*s80 + R0_33*s78;
    const double s98 = (cx * cx);
    const double s100 = (cy * cy);
    const double s102 = (cz * cz);
    const double s104 = (1.0/4.0)*s100 + (1.0/4.0)*s102 + (1.0/4.0)*s98 + 1;
    const double s105 = 1.0/s104;
    const double s106 = -1.0/2.0*s100;
    const double s107 = -1.0/2.0*s102;
    const double s108 = s106 + s107;
    const double R_11 = s105*s108 + 1;
    const double s111 = (1.0/2.0)*cx*cy;
    const double s112 = -cz + s111;
    const double R_12 = s105*s112;
    const double s114 = (1.0/2.0)*cx*cz;
    const double s115 = cy + s114;
    const double R_13 = s105*s115;
    const double s117 = cz + s111;
    const double R_21 = s105*s117;
    const double s119 = -1.0/2.0*s98;
    const double s120 = s107 + s119;
    const double R_22 = s105*s120 + 1;
    const double s123 = (1.0/2.0)*cy*cz;
    const double s124 = -cx + s123;
    const double R_23 = s105*s124;
    const double s126 = -cy + s114;
    const double R_31 = s105*s126;
    const double s128 = cx + s123;
    const double R_32 = s105*s128;
    const double s130 = s106 + s119;
    const double R_33 = s105*s130 + 1;
    const double A1_x = R1_12*g1_y + R1_13*g1_z + s147;
    const double A1_y = R1_22*g1_y + R1_23*g1_z + s153;
    const double A1_z = R1_32*g1_y + R1_33*g1_z + s155;
    const double s159 = h1_x - tx;
    const double s161 = h1_y - ty;
    const double s163 = bz1 - tz;
    const double B1_x = R_11*s159 + R_12*s161 + R_13*s163 + px;
    const double B1_y = R_21*s159 + R_22*s161 + R_23*s163 + py;
    const double B1_z = R_31*s159 + R_32*s161 + R_33*s163 + pz;
    const double d1_x = -A1_x + B1_x;
    const double d1_y = -A1_y + B1_y;
    const double d1_z = -A1_z + B1_z;
    const double A2_x = R1_12*g2_y + R1_13*g2_z + s185;
    const double A2_y = R1_22*g2_y + R1_23*g2_z + s190;
    const double A2_z = R1_32*g2_y + R1_33*g2_z + s192;
    const double s196 = h2_x - tx;
    const double s198 = h2_y - ty;
    const double s200 = bz2 - tz;
    const double B2_x = R_11*s196 + R_12*s198 + R_13*s200 + px;
    const double B2_y = R_21*s196 + R_22*s198 + R_23*s200 + py;
    const double B2_z = R_31*s196 + R_32*s198 + R_33*s200 + pz;
    const double d2_x = -A2_x + B2_x;
    const double d2_y = -A2_y + B2_y;
    const double d2_z = -A2_z + B2_z;
    const double s223 = (1.0/2.0)*(d1_x * d1_x) + (1.0/2.0)*(d1_y * d1_y) + (1.0/2.0)*(d1_z * d1_z) + s222;
    const double s224 = 2*d1_z;
    const double s225 = (1.0/2.0)*s224;
    const double s226 = 2*d1_y;
    const double s227 = (1.0/2.0)*s226;
    const double s228 = 2*d1_x;
    const double s229 = (1.0/2.0)*s228;
    const double s230 = s163*s225;
    const double s232 = s161*s225;
    const double s234 = s159*s225;
    const double s236 = s163*s227;
    const double s238 = s161*s227;
    const double s240 = s159*s227;
    const double s242 = s163*s229;
    const double s245 = s161*s229;
    const double s248 = s159*s229;
    const double s251 = -g1_z*s225;
    const double s253 = -g1_y*s225;
    const double s255 = -g1_z*s227;
    const double s257 = -g1_y*s227;
    const double s259 = -g1_z*s229;
    const double s261 = -g1_y*s229;
    const double s264 = s105*s230;
    const double s266 = s105*s232;
    const double s268 = s105*s234;
    const double s270 = s105*s236;
    const double s271 = s266 + s270;
    const double s272 = (1.0/2.0)*cz;
    const double s273 = (1.0/2.0)*cy;
    const double s276 = s120*s238;
    const double s277 = s105*s238;
    const double s280 = s117*s240;
    const double s281 = s105*s240;
    const double s282 = s115*s242;
    const double s283 = s105*s242;
    const double s284 = s268 + s283;
    const double s285 = (1.0/2.0)*cx;
    const double s288 = s112*s245;
    const double s289 = s105*s245;
    const double s290 = s281 + s289;
    const double s293 = s108*s248;
    const double s294 = s105*s248;
    const double s299 = s124*s236 + s126*s234 + s128*s232 + s130*s230 + s276 + s280 + s282 + s288 + s293;
    const double s300 = (1.0 / (s104 * s104));
    const double s302 = -1.0/4.0*s299*s300;
    const double s304 = 2*cz;
    const double s307 = 2*cy;
    const double s310 = 2*cx;
    const double s335 = s78*(-R0_12*s259 + R0_13*s261 - R0_22*s255 + R0_23*s257 - R0_32*s251 + R0_33*s253);
    const double s338 = R0_12*s261 + R0_13*s259 + R0_22*s257 + R0_23*s255 + R0_32*s253 + R0_33*s251;
    const double s342 = s266 - s270 + s272*s284 + s273*s290 + s310*(-1.0/2.0*s264 - 1.0/2.0*s277 + s302);
    const double s343 = -s268 + s271*s272 + s283 + s285*s290 + s307*(-1.0/2.0*s264 - 1.0/2.0*s294 + s302);
    const double s344 = s271*s273 + s281 + s284*s285 - s289 + s304*(-1.0/2.0*s277 - 1.0/2.0*s294 + s302);
    const double s351 = s335 - s338*s80;
    const double s672 = (1.0/2.0)*(d2_x * d2_x) + (1.0/2.0)*(d2_y * d2_y) + (1.0/2.0)*(d2_z * d2_z) + s671;
    const double s673 = 2*d2_z;
    const double s674 = (1.0/2.0)*s673;
    const double s675 = 2*d2_y;
    const double s676 = (1.0/2.0)*s675;
    const double s677 = 2*d2_x;
    const double s678 = (1.0/2.0)*s677;
    const double s679 = s200*s674;
    const double s681 = s198*s674;
    const double s683 = s196*s674;
    const double s685 = s200*s676;
    const double s687 = s198*s676;
    const double s689 = s196*s676;
    const double s691 = s200*s678;
    const double s694 = s198*s678;
    const double s697 = s196*s678;
    const double s700 = -g2_z*s674;
    const double s702 = -g2_y*s674;
    const double s704 = -g2_z*s676;
    const double s706 = -g2_y*s676;
    const double s708 = -g2_z*s678;
    const double s710 = -g2_y*s678;
    const double s713 = s105*s679;
    const double s715 = s105*s681;
    const double s717 = s105*s683;
    const double s719 = s105*s685;
    const double s720 = s715 + s719;
    const double s723 = s120*s687;
    const double s724 = s105*s687;
    const double s727 = s117*s689;
    const double s728 = s105*s689;
    const double s729 = s115*s691;
    const double s730 = s105*s691;
    const double s731 = s717 + s730;
    const double s734 = s112*s694;
    const double s735 = s105*s694;
    const double s736 = s728 + s735;
    const double s739 = s108*s697;
    const double s740 = s105*s697;
    const double s745 = s124*s685 + s126*s683 + s128*s681 + s130*s679 + s723 + s727 + s729 + s734 + s739;
    const double s747 = -1.0/4.0*s300*s745;
    const double s777 = s78*(-R0_12*s708 + R0_13*s710 - R0_22*s704 + R0_23*s706 - R0_32*s700 + R0_33*s702);
    const double s780 = R0_12*s710 + R0_13*s708 + R0_22*s706 + R0_23*s704 + R0_32*s702 + R0_33*s700;
    const double s784 = s272*s731 + s273*s736 + s310*(-1.0/2.0*s713 - 1.0/2.0*s724 + s747) + s715 - s719;
    const double s785 = s272*s720 + s285*s736 + s307*(-1.0/2.0*s713 - 1.0/2.0*s740 + s747) - s717 + s730;
    const double s786 = s273*s720 + s285*s731 + s304*(-1.0/2.0*s724 - 1.0/2.0*s740 + s747) + s728 - s735;
    const double s793 = s777 - s780*s80;
    out[0] = s223;
    out[1] = s229;
    out[2] = s227;
    out[3] = s225;
    out[4] = s342;
    out[5] = s343;
    out[6] = s344;
    out[7] = s351;
    out[8] = s672;
    out[9] = s678;
    out[10] = s676;
    out[11] = s674;
    out[12] = s784;
    out[13] = s785;
    out[14] = s786;
    out[15] = s793;
}

/* Joint of the simplified limb at a given position, then the platform's coordinates that follow from it (34 operations). */
static void joint(const double *x, double q, const double *tool, const double *k, double *out)
{
    const double px = x[0];
    const double py = x[1];
    const double pz = x[2];
    const double tx = tool[0];
    const double ty = tool[1];
    const double tz = tool[2];
    const double s839 = k[24];
    const double s841 = k[25];
    const double s843 = k[26];
    const double s845 = k[27];
    const double s863 = k[28];
    const double s858 = k[29];
    const double L = k[30];
    const double s840 = px + s839 - tx;
    const double s844 = py + s843 - ty;
    const double s847 = s840*s841 + s844*s845;
    const double s849 = pz - tz;
    const double s850 = (s849 * s849);
    const double s864 = (1.0/2.0)*(s840 * s840) + (1.0/2.0)*(s844 * s844) + (1.0/2.0)*s850 + s863;
    const double s868 = sqrt((s847 * s847) + s850*s858 - (s864 * s864));
    const double s875 = atan2(L*s849*s864 - s847*s868, -L*s849*s868 - s847*s864);
    (void)(q);
    out[0] = s875;
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
                joints_deg[i] = DELTACAL_SIGN[i] * q[i] * JOINT_PER_UNIT;
            return DELTACAL_SOLVED;
        }
        if (!(size < STEP_LOST))
            break;
    }
    return DELTACAL_UNREACHABLE;
}

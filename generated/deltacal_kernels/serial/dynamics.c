/*
 * Generated from derive/mechanisms/serial.py by "deltacal kernels". Do not edit.
 * Template templates/chain/dynamics.c.jinja; sha256 of both eeae5f884be6fc97; SymPy 1.14.0.
 *
 * The calibrated chain in motion, link by link: a frame in {O} with its first and second derivatives by time, the
 * twists of all behind a joint by it, and what the bodies ask for.
 */
#define FRAME 36 /* origin, rotation row by row; their first, then their second derivatives */
#define BODY 10 /* inertial parameters of a link */

struct motion {
    double frame[DELTACAL_LINKS + 1][FRAME], axis[DELTACAL_DRIVES][6];
};

/* A link, standard convention: its frame, and how that moves, by the one before (320 operations). */
static void move_standard(const double *joint, const double *frame, const double *k, double *out)
{
    const double turn = joint[0];
    const double slide = joint[1];
    const double turn_t = joint[2];
    const double slide_t = joint[3];
    const double turn_tt = joint[4];
    const double slide_tt = joint[5];
    const double ox = frame[0];
    const double oy = frame[1];
    const double oz = frame[2];
    const double R_00 = frame[3];
    const double R_01 = frame[4];
    const double R_02 = frame[5];
    const double R_10 = frame[6];
    const double R_11 = frame[7];
    const double R_12 = frame[8];
    const double R_20 = frame[9];
    const double R_21 = frame[10];
    const double R_22 = frame[11];
    const double ox_t = frame[12];
    const double oy_t = frame[13];
    const double oz_t = frame[14];
    const double R_00_t = frame[15];
    const double R_01_t = frame[16];
    const double R_02_t = frame[17];
    const double R_10_t = frame[18];
    const double R_11_t = frame[19];
    const double R_12_t = frame[20];
    const double R_20_t = frame[21];
    const double R_21_t = frame[22];
    const double R_22_t = frame[23];
    const double ox_tt = frame[24];
    const double oy_tt = frame[25];
    const double oz_tt = frame[26];
    const double R_00_tt = frame[27];
    const double R_01_tt = frame[28];
    const double R_02_tt = frame[29];
    const double R_10_tt = frame[30];
    const double R_11_tt = frame[31];
    const double R_12_tt = frame[32];
    const double R_20_tt = frame[33];
    const double R_21_tt = frame[34];
    const double R_22_tt = frame[35];
    const double s0 = k[0];
    const double s2 = k[1];
    const double along_x = k[2];
    const double s26 = k[3];
    const double s28 = k[4];
    const double s33 = k[5];
    const double s36 = k[6];
    const double about_z = s0 + turn;
    const double along_z = s2 + slide;
    const double s7 = cos(about_z);
    const double s9 = sin(about_z);
    const double s11 = R_00*s7 + R_01*s9;
    const double s13 = R_02*along_z + along_x*s11 + ox;
    const double s17 = R_10*s7 + R_11*s9;
    const double s19 = R_12*along_z + along_x*s17 + oy;
    const double s23 = R_20*s7 + R_21*s9;
    const double s25 = R_22*along_z + along_x*s23 + oz;
    const double s32 = -R_00*s9 + R_01*s7;
    const double s35 = R_02*s28 - s32*s33;
    const double s38 = s11*s26 - s35*s36;
    const double s41 = R_02*s33 + s28*s32;
    const double s44 = s11*s36 + s26*s35;
    const double s49 = -R_10*s9 + R_11*s7;
    const double s51 = R_12*s28 - s33*s49;
    const double s53 = s17*s26 - s36*s51;
    const double s56 = R_12*s33 + s28*s49;
    const double s59 = s17*s36 + s26*s51;
    const double s64 = -R_20*s9 + R_21*s7;
    const double s66 = R_22*s28 - s33*s64;
    const double s68 = s23*s26 - s36*s66;
    const double s71 = R_22*s33 + s28*s64;
    const double s74 = s23*s36 + s26*s66;
    const double s78 = -s9*turn_t;
    const double s82 = s7*turn_t;
    const double s86 = R_00*s78 + R_00_t*s7 + R_01*s82 + R_01_t*s9;
    const double s88 = R_02*slide_t + R_02_t*along_z + along_x*s86 + ox_t;
    const double s98 = R_10*s78 + R_10_t*s7 + R_11*s82 + R_11_t*s9;
    const double s100 = R_12*slide_t + R_12_t*along_z + along_x*s98 + oy_t;
    const double s110 = R_20*s78 + R_20_t*s7 + R_21*s82 + R_21_t*s9;
    const double s112 = R_22*slide_t + R_22_t*along_z + along_x*s110 + oz_t;
    const double s121 = -R_00*s82 - R_00_t*s9 + R_01*s78 + R_01_t*s7;
    const double s123 = R_02_t*s28 - s121*s33;
    const double s125 = -s123*s36 + s26*s86;
    const double s128 = R_02_t*s33 + s121*s28;
    const double s131 = s123*s26 + s36*s86;
    const double s140 = -R_10*s82 - R_10_t*s9 + R_11*s78 + R_11_t*s7;
    const double s142 = R_12_t*s28 - s140*s33;
    const double s144 = -s142*s36 + s26*s98;
    const double s147 = R_12_t*s33 + s140*s28;
    const double s150 = s142*s26 + s36*s98;
    const double s159 = -R_20*s82 - R_20_t*s9 + R_21*s78 + R_21_t*s7;
    const double s161 = R_22_t*s28 - s159*s33;
    const double s163 = s110*s26 - s161*s36;
    const double s166 = R_22_t*s33 + s159*s28;
    const double s169 = s110*s36 + s161*s26;
    const double s171 = R_02_t*slide_t;
    const double s178 = -s82*turn_t - s9*turn_tt;
    const double s180 = R_00_t*s78;
    const double s187 = s7*turn_tt + s78*turn_t;
    const double s189 = R_01_t*s82;
    const double s194 = R_00*s178 + R_00_tt*s7 + R_01*s187 + R_01_tt*s9 + 2*s180 + 2*s189;
    const double s196 = R_02*slide_tt + R_02_tt*along_z + along_x*s194 + ox_tt + 2*s171;
    const double s198 = R_12_t*slide_t;
    const double s204 = R_10_t*s78;
    const double s210 = R_11_t*s82;
    const double s215 = R_10*s178 + R_10_tt*s7 + R_11*s187 + R_11_tt*s9 + 2*s204 + 2*s210;
    const double s217 = R_12*slide_tt + R_12_tt*along_z + along_x*s215 + oy_tt + 2*s198;
    const double s219 = R_22_t*slide_t;
    const double s225 = R_20_t*s78;
    const double s231 = R_21_t*s82;
    const double s236 = R_20*s178 + R_20_tt*s7 + R_21*s187 + R_21_tt*s9 + 2*s225 + 2*s231;
    const double s238 = R_22*slide_tt + R_22_tt*along_z + along_x*s236 + oz_tt + 2*s219;
    const double s242 = R_01_t*s78;
    const double s248 = -R_00_t*s82;
    const double s253 = -R_00*s187 - R_00_tt*s9 + R_01*s178 + R_01_tt*s7 + 2*s242 + 2*s248;
    const double s255 = R_02_tt*s28 - s253*s33;
    const double s257 = s194*s26 - s255*s36;
    const double s260 = R_02_tt*s33 + s253*s28;
    const double s263 = s194*s36 + s255*s26;
    const double s267 = R_11_t*s78;
    const double s273 = -R_10_t*s82;
    const double s278 = -R_10*s187 - R_10_tt*s9 + R_11*s178 + R_11_tt*s7 + 2*s267 + 2*s273;
    const double s280 = R_12_tt*s28 - s278*s33;
    const double s282 = s215*s26 - s280*s36;
    const double s285 = R_12_tt*s33 + s278*s28;
    const double s288 = s215*s36 + s26*s280;
    const double s292 = R_21_t*s78;
    const double s298 = -R_20_t*s82;
    const double s303 = -R_20*s187 - R_20_tt*s9 + R_21*s178 + R_21_tt*s7 + 2*s292 + 2*s298;
    const double s305 = R_22_tt*s28 - s303*s33;
    const double s307 = s236*s26 - s305*s36;
    const double s310 = R_22_tt*s33 + s28*s303;
    const double s313 = s236*s36 + s26*s305;
    out[0] = s13;
    out[1] = s19;
    out[2] = s25;
    out[3] = s38;
    out[4] = s41;
    out[5] = s44;
    out[6] = s53;
    out[7] = s56;
    out[8] = s59;
    out[9] = s68;
    out[10] = s71;
    out[11] = s74;
    out[12] = s88;
    out[13] = s100;
    out[14] = s112;
    out[15] = s125;
    out[16] = s128;
    out[17] = s131;
    out[18] = s144;
    out[19] = s147;
    out[20] = s150;
    out[21] = s163;
    out[22] = s166;
    out[23] = s169;
    out[24] = s196;
    out[25] = s217;
    out[26] = s238;
    out[27] = s257;
    out[28] = s260;
    out[29] = s263;
    out[30] = s282;
    out[31] = s285;
    out[32] = s288;
    out[33] = s307;
    out[34] = s310;
    out[35] = s313;
}

/* A link, standard convention: twists of all behind it by turn and slide of its joint (9 operations). */
static void axes_standard(const double *joint, const double *frame, const double *k, double *out)
{
    const double ox = frame[0];
    const double oy = frame[1];
    const double oz = frame[2];
    const double R_02 = frame[5];
    const double R_12 = frame[8];
    const double R_22 = frame[11];
    const double s316 = -R_12*oz + R_22*oy;
    const double s319 = R_02*oz - R_22*ox;
    const double s322 = -R_02*oy + R_12*ox;
    (void)(joint);
    (void)(k);
    out[0] = s316;
    out[1] = s319;
    out[2] = s322;
    out[3] = R_02;
    out[4] = R_12;
    out[5] = R_22;
    out[6] = R_02;
    out[7] = R_12;
    out[8] = R_22;
    out[9] = 0;
    out[10] = 0;
    out[11] = 0;
}

/* A link, modified convention: its frame, and how that moves, by the one before (320 operations). */
static void move_modified(const double *joint, const double *frame, const double *k, double *out)
{
    const double turn = joint[0];
    const double slide = joint[1];
    const double turn_t = joint[2];
    const double slide_t = joint[3];
    const double turn_tt = joint[4];
    const double slide_tt = joint[5];
    const double ox = frame[0];
    const double oy = frame[1];
    const double oz = frame[2];
    const double R_00 = frame[3];
    const double R_01 = frame[4];
    const double R_02 = frame[5];
    const double R_10 = frame[6];
    const double R_11 = frame[7];
    const double R_12 = frame[8];
    const double R_20 = frame[9];
    const double R_21 = frame[10];
    const double R_22 = frame[11];
    const double ox_t = frame[12];
    const double oy_t = frame[13];
    const double oz_t = frame[14];
    const double R_00_t = frame[15];
    const double R_01_t = frame[16];
    const double R_02_t = frame[17];
    const double R_10_t = frame[18];
    const double R_11_t = frame[19];
    const double R_12_t = frame[20];
    const double R_20_t = frame[21];
    const double R_21_t = frame[22];
    const double R_22_t = frame[23];
    const double ox_tt = frame[24];
    const double oy_tt = frame[25];
    const double oz_tt = frame[26];
    const double R_00_tt = frame[27];
    const double R_01_tt = frame[28];
    const double R_02_tt = frame[29];
    const double R_10_tt = frame[30];
    const double R_11_tt = frame[31];
    const double R_12_tt = frame[32];
    const double R_20_tt = frame[33];
    const double R_21_tt = frame[34];
    const double R_22_tt = frame[35];
    const double s0 = k[0];
    const double s2 = k[1];
    const double along_x = k[2];
    const double s26 = k[3];
    const double s28 = k[4];
    const double s33 = k[5];
    const double s36 = k[6];
    const double about_z = s0 + turn;
    const double along_z = s2 + slide;
    const double s7 = cos(about_z);
    const double s9 = sin(about_z);
    const double s78 = -s9*turn_t;
    const double s82 = s7*turn_t;
    const double s178 = -s82*turn_t - s9*turn_tt;
    const double s187 = s7*turn_tt + s78*turn_t;
    const double s325 = -R_01*s33 + R_02*s28;
    const double s327 = R_00*s26 - s325*s36;
    const double s331 = R_00*s36 + s26*s325;
    const double s333 = along_x*s327 + along_z*s331 + ox;
    const double s336 = -R_11*s33 + R_12*s28;
    const double s338 = R_10*s26 - s336*s36;
    const double s342 = R_10*s36 + s26*s336;
    const double s344 = along_x*s338 + along_z*s342 + oy;
    const double s347 = -R_21*s33 + R_22*s28;
    const double s349 = R_20*s26 - s347*s36;
    const double s353 = R_20*s36 + s26*s347;
    const double s355 = along_x*s349 + along_z*s353 + oz;
    const double s358 = R_01*s28 + R_02*s33;
    const double s360 = s327*s7 + s358*s9;
    const double s363 = -s327*s9 + s358*s7;
    const double s366 = R_11*s28 + R_12*s33;
    const double s368 = s338*s7 + s366*s9;
    const double s371 = -s338*s9 + s366*s7;
    const double s374 = R_21*s28 + R_22*s33;
    const double s376 = s349*s7 + s374*s9;
    const double s379 = -s349*s9 + s374*s7;
    const double s625 = -R_01_t*s33 + R_02_t*s28;
    const double s627 = R_00_t*s26 - s36*s625;
    const double s631 = R_00_t*s36 + s26*s625;
    const double s635 = along_x*s627 + along_z*s631 + ox_t + s331*slide_t;
    const double s638 = -R_11_t*s33 + R_12_t*s28;
    const double s640 = R_10_t*s26 - s36*s638;
    const double s644 = R_10_t*s36 + s26*s638;
    const double s648 = along_x*s640 + along_z*s644 + oy_t + s342*slide_t;
    const double s651 = -R_21_t*s33 + R_22_t*s28;
    const double s653 = R_20_t*s26 - s36*s651;
    const double s657 = R_20_t*s36 + s26*s651;
    const double s661 = along_x*s653 + along_z*s657 + oz_t + s353*slide_t;
    const double s666 = R_01_t*s28 + R_02_t*s33;
    const double s670 = s327*s78 + s358*s82 + s627*s7 + s666*s9;
    const double s677 = -s327*s82 + s358*s78 - s627*s9 + s666*s7;
    const double s682 = R_11_t*s28 + R_12_t*s33;
    const double s686 = s338*s78 + s366*s82 + s640*s7 + s682*s9;
    const double s693 = -s338*s82 + s366*s78 - s640*s9 + s682*s7;
    const double s698 = R_21_t*s28 + R_22_t*s33;
    const double s702 = s349*s78 + s374*s82 + s653*s7 + s698*s9;
    const double s709 = -s349*s82 + s374*s78 - s653*s9 + s698*s7;
    const double s1169 = -R_01_tt*s33 + R_02_tt*s28;
    const double s1171 = R_00_tt*s26 - s1169*s36;
    const double s1175 = R_00_tt*s36 + s1169*s26;
    const double s1176 = s631*slide_t;
    const double s1182 = along_x*s1171 + along_z*s1175 + ox_tt + 2*s1176 + s331*slide_tt;
    const double s1185 = -R_11_tt*s33 + R_12_tt*s28;
    const double s1187 = R_10_tt*s26 - s1185*s36;
    const double s1191 = R_10_tt*s36 + s1185*s26;
    const double s1192 = s644*slide_t;
    const double s1198 = along_x*s1187 + along_z*s1191 + oy_tt + 2*s1192 + s342*slide_tt;
    const double s1201 = -R_21_tt*s33 + R_22_tt*s28;
    const double s1203 = R_20_tt*s26 - s1201*s36;
    const double s1207 = R_20_tt*s36 + s1201*s26;
    const double s1208 = s657*slide_t;
    const double s1214 = along_x*s1203 + along_z*s1207 + oz_tt + 2*s1208 + s353*slide_tt;
    const double s1216 = s627*s78;
    const double s1222 = R_01_tt*s28 + R_02_tt*s33;
    const double s1224 = s666*s82;
    const double s1229 = s1171*s7 + 2*s1216 + s1222*s9 + 2*s1224 + s178*s327 + s187*s358;
    const double s1231 = s666*s78;
    const double s1237 = -s627*s82;
    const double s1242 = -s1171*s9 + s1222*s7 + 2*s1231 + 2*s1237 + s178*s358 - s187*s327;
    const double s1244 = s640*s78;
    const double s1250 = R_11_tt*s28 + R_12_tt*s33;
    const double s1252 = s682*s82;
    const double s1257 = s1187*s7 + 2*s1244 + s1250*s9 + 2*s1252 + s178*s338 + s187*s366;
    const double s1259 = s682*s78;
    const double s1265 = -s640*s82;
    const double s1270 = -s1187*s9 + s1250*s7 + 2*s1259 + 2*s1265 + s178*s366 - s187*s338;
    const double s1272 = s653*s78;
    const double s1278 = R_21_tt*s28 + R_22_tt*s33;
    const double s1280 = s698*s82;
    const double s1285 = s1203*s7 + 2*s1272 + s1278*s9 + 2*s1280 + s178*s349 + s187*s374;
    const double s1287 = s698*s78;
    const double s1293 = -s653*s82;
    const double s1298 = -s1203*s9 + s1278*s7 + 2*s1287 + 2*s1293 + s178*s374 - s187*s349;
    out[0] = s333;
    out[1] = s344;
    out[2] = s355;
    out[3] = s360;
    out[4] = s363;
    out[5] = s331;
    out[6] = s368;
    out[7] = s371;
    out[8] = s342;
    out[9] = s376;
    out[10] = s379;
    out[11] = s353;
    out[12] = s635;
    out[13] = s648;
    out[14] = s661;
    out[15] = s670;
    out[16] = s677;
    out[17] = s631;
    out[18] = s686;
    out[19] = s693;
    out[20] = s644;
    out[21] = s702;
    out[22] = s709;
    out[23] = s657;
    out[24] = s1182;
    out[25] = s1198;
    out[26] = s1214;
    out[27] = s1229;
    out[28] = s1242;
    out[29] = s1175;
    out[30] = s1257;
    out[31] = s1270;
    out[32] = s1191;
    out[33] = s1285;
    out[34] = s1298;
    out[35] = s1207;
}

/* A link, modified convention: twists of all behind it by turn and slide of its joint (45 operations). */
static void axes_modified(const double *joint, const double *frame, const double *k, double *out)
{
    const double ox = frame[0];
    const double oy = frame[1];
    const double oz = frame[2];
    const double R_00 = frame[3];
    const double R_01 = frame[4];
    const double R_02 = frame[5];
    const double R_10 = frame[6];
    const double R_11 = frame[7];
    const double R_12 = frame[8];
    const double R_20 = frame[9];
    const double R_21 = frame[10];
    const double R_22 = frame[11];
    const double along_x = k[2];
    const double s26 = k[3];
    const double s28 = k[4];
    const double s33 = k[5];
    const double s36 = k[6];
    const double s325 = -R_01*s33 + R_02*s28;
    const double s331 = R_00*s36 + s26*s325;
    const double s336 = -R_11*s33 + R_12*s28;
    const double s342 = R_10*s36 + s26*s336;
    const double s347 = -R_21*s33 + R_22*s28;
    const double s353 = R_20*s36 + s26*s347;
    const double s1299 = -along_x*(R_20*s26 - s347*s36) - oz;
    const double s1301 = -along_x*(R_10*s26 - s336*s36) - oy;
    const double s1303 = s1299*s342 - s1301*s353;
    const double s1304 = -along_x*(R_00*s26 - s325*s36) - ox;
    const double s1307 = -s1299*s331 + s1304*s353;
    const double s1310 = s1301*s331 - s1304*s342;
    (void)(joint);
    out[0] = s1303;
    out[1] = s1307;
    out[2] = s1310;
    out[3] = s331;
    out[4] = s342;
    out[5] = s353;
    out[6] = s331;
    out[7] = s342;
    out[8] = s353;
    out[9] = 0;
    out[10] = 0;
    out[11] = 0;
}

/* Force that a body asks for, and its moment about {O} (248 operations). */
static void ask(const double *frame, const double *body, const double *gravity, double *out)
{
    const double ox = frame[0];
    const double oy = frame[1];
    const double oz = frame[2];
    const double R_00 = frame[3];
    const double R_01 = frame[4];
    const double R_02 = frame[5];
    const double R_10 = frame[6];
    const double R_11 = frame[7];
    const double R_12 = frame[8];
    const double R_20 = frame[9];
    const double R_21 = frame[10];
    const double R_22 = frame[11];
    const double ox_tt = frame[24];
    const double oy_tt = frame[25];
    const double oz_tt = frame[26];
    const double R_00_tt = frame[27];
    const double R_01_tt = frame[28];
    const double R_02_tt = frame[29];
    const double R_10_tt = frame[30];
    const double R_11_tt = frame[31];
    const double R_12_tt = frame[32];
    const double R_20_tt = frame[33];
    const double R_21_tt = frame[34];
    const double R_22_tt = frame[35];
    const double m = body[0];
    const double m_x = body[1];
    const double m_y = body[2];
    const double m_z = body[3];
    const double ixx = body[4];
    const double iyy = body[5];
    const double izz = body[6];
    const double ixy = body[7];
    const double ixz = body[8];
    const double iyz = body[9];
    const double gx = gravity[0];
    const double gy = gravity[1];
    const double gz = gravity[2];
    const double s1312 = -gx + (1.0/1000.0)*ox_tt;
    const double s1317 = (1.0/1000.0)*R_00_tt*m_x + (1.0/1000.0)*R_01_tt*m_y + (1.0/1000.0)*R_02_tt*m_z + m*s1312;
    const double s1319 = -gy + (1.0/1000.0)*oy_tt;
    const double s1324 = (1.0/1000.0)*R_10_tt*m_x + (1.0/1000.0)*R_11_tt*m_y + (1.0/1000.0)*R_12_tt*m_z + m*s1319;
    const double s1326 = -gz + (1.0/1000.0)*oz_tt;
    const double s1331 = (1.0/1000.0)*R_20_tt*m_x + (1.0/1000.0)*R_21_tt*m_y + (1.0/1000.0)*R_22_tt*m_z + m*s1326;
    const double s1336 = -R_20*m_x - R_21*m_y - R_22*m_z;
    const double s1341 = R_10*m_x + R_11*m_y + R_12*m_z;
    const double s1343 = -oz*s1324;
    const double s1349 = (1.0/2.0)*R_20*ixx - 1.0/2.0*R_20*iyy - 1.0/2.0*R_20*izz + R_21*ixy + R_22*ixz;
    const double s1350 = (1.0/1000.0)*R_10_tt*s1349;
    const double s1356 = R_20*ixy - 1.0/2.0*R_21*ixx + (1.0/2.0)*R_21*iyy - 1.0/2.0*R_21*izz + R_22*iyz;
    const double s1357 = (1.0/1000.0)*R_11_tt*s1356;
    const double s1363 = R_20*ixz + R_21*iyz - 1.0/2.0*R_22*ixx - 1.0/2.0*R_22*iyy + (1.0/2.0)*R_22*izz;
    const double s1364 = (1.0/1000.0)*R_12_tt*s1363;
    const double s1370 = -1.0/2.0*R_10*ixx + (1.0/2.0)*R_10*iyy + (1.0/2.0)*R_10*izz - R_11*ixy - R_12*ixz;
    const double s1371 = (1.0/1000.0)*R_20_tt*s1370;
    const double s1377 = -R_10*ixy + (1.0/2.0)*R_11*ixx - 1.0/2.0*R_11*iyy + (1.0/2.0)*R_11*izz - R_12*iyz;
    const double s1378 = (1.0/1000.0)*R_21_tt*s1377;
    const double s1384 = -R_10*ixz - R_11*iyz + (1.0/2.0)*R_12*ixx + (1.0/2.0)*R_12*iyy - 1.0/2.0*R_12*izz;
    const double s1385 = (1.0/1000.0)*R_22_tt*s1384;
    const double s1386 = oy*s1331 + s1319*s1336 + s1326*s1341 + s1343 + s1350 + s1357 + s1364 + s1371 + s1378 + s1385;
    const double s1392 = -R_00*m_x - R_01*m_y - R_02*m_z;
    const double s1394 = -ox*s1331;
    const double s1395 = -1.0/1000.0*R_00_tt*s1349;
    const double s1396 = -1.0/1000.0*R_01_tt*s1356;
    const double s1397 = -1.0/1000.0*R_02_tt*s1363;
    const double s1403 = (1.0/2.0)*R_00*ixx - 1.0/2.0*R_00*iyy - 1.0/2.0*R_00*izz + R_01*ixy + R_02*ixz;
    const double s1404 = (1.0/1000.0)*R_20_tt*s1403;
    const double s1410 = R_00*ixy - 1.0/2.0*R_01*ixx + (1.0/2.0)*R_01*iyy - 1.0/2.0*R_01*izz + R_02*iyz;
    const double s1411 = (1.0/1000.0)*R_21_tt*s1410;
    const double s1417 = R_00*ixz + R_01*iyz - 1.0/2.0*R_02*ixx - 1.0/2.0*R_02*iyy + (1.0/2.0)*R_02*izz;
    const double s1418 = (1.0/1000.0)*R_22_tt*s1417;
    const double s1419 = oz*s1317 - s1312*s1336 + s1326*s1392 + s1394 + s1395 + s1396 + s1397 + s1404 + s1411 + s1418;
    const double s1423 = -oy*s1317;
    const double s1424 = -1.0/1000.0*R_00_tt*s1370;
    const double s1425 = -1.0/1000.0*R_01_tt*s1377;
    const double s1426 = -1.0/1000.0*R_02_tt*s1384;
    const double s1427 = -1.0/1000.0*R_10_tt*s1403;
    const double s1428 = -1.0/1000.0*R_11_tt*s1410;
    const double s1429 = -1.0/1000.0*R_12_tt*s1417;
    const double s1430 = ox*s1324 - s1312*s1341 - s1319*s1392 + s1423 + s1424 + s1425 + s1426 + s1427 + s1428 + s1429;
    out[0] = s1317;
    out[1] = s1324;
    out[2] = s1331;
    out[3] = s1386;
    out[4] = s1419;
    out[5] = s1430;
}

/* What a joint gives to what is asked behind it (11 operations). */
static void give(const double *axis, const double *asked, double *out)
{
    const double fx = asked[0];
    const double fy = asked[1];
    const double fz = asked[2];
    const double mx = asked[3];
    const double my = asked[4];
    const double mz = asked[5];
    const double ux = axis[0];
    const double uy = axis[1];
    const double uz = axis[2];
    const double wx = axis[3];
    const double wy = axis[4];
    const double wz = axis[5];
    const double s1581 = fx*ux + fy*uy + fz*uz + mx*wx + my*wy + mz*wz;
    out[0] = s1581;
}

static void axes_of(int link, const double *joint, const double *frame, double *out)
{
    const double *k = DELTACAL_LINK_K[link];
    if (DELTACAL_CONVENTION[link] == 0)
        axes_standard(joint, frame, k, out);
    else if (DELTACAL_CONVENTION[link] == 1)
        axes_modified(joint, frame, k, out);
}

static void move_of(int link, const double *joint, const double *frame, double *out)
{
    const double *k = DELTACAL_LINK_K[link];
    if (DELTACAL_CONVENTION[link] == 0)
        move_standard(joint, frame, k, out);
    else if (DELTACAL_CONVENTION[link] == 1)
        move_modified(joint, frame, k, out);
}

/* Set all links in motion: joints as the geometry counts them, their speeds and accelerations. */
static void in_motion(const double *q, const double *qd, const double *qdd, struct motion *m)
{
    int link, c, drive = 0;
    for (c = 0; c < FRAME; c++)
        m->frame[0][c] = c == 3 || c == 7 || c == 11 ? 1.0 : 0.0;
    for (link = 0; link < DELTACAL_LINKS; link++) {
        double joint[6] = { 0.0 }, twists[12];
        const int first = drive;
        for (; drive < DELTACAL_DRIVES && DELTACAL_DRIVE[drive][0] == link; drive++) {
            const int variable = DELTACAL_DRIVE[drive][1], j = DELTACAL_DRIVE[drive][2];
            joint[variable] += DELTACAL_MUCH[drive] * q[j];
            joint[2 + variable] += DELTACAL_MUCH[drive] * qd[j];
            joint[4 + variable] += DELTACAL_MUCH[drive] * qdd[j];
        }
        axes_of(link, joint, m->frame[link], twists);
        for (c = first; c < drive; c++) {
            int i;
            for (i = 0; i < 6; i++)
                m->axis[c][i] = twists[6 * DELTACAL_DRIVE[c][1] + i];
        }
        move_of(link, joint, m->frame[link], m->frame[link + 1]);
    }
}

/* Sum up what joint j must give to bodies behind it. */
static double given_by(const struct motion *m, int j, const double *bodies)
{
    double asked[6] = { 0.0 }, total = 0.0;
    int link, c, drive = DELTACAL_DRIVES;
    for (link = DELTACAL_LINKS - 1; link >= 0; link--) {
        double own[6];
        ask(m->frame[link + 1], bodies + BODY * link, DELTACAL_GRAVITY, own);
        for (c = 0; c < 6; c++)
            asked[c] += own[c];
        for (; drive > 0 && DELTACAL_DRIVE[drive - 1][0] == link; drive--)
            if (DELTACAL_DRIVE[drive - 1][2] == j) {
                double work[1];
                give(m->axis[drive - 1], asked, work);
                total += DELTACAL_MUCH[drive - 1] * work[0];
            }
    }
    return total;
}

/* Torques of the drives, by joints, speeds and accelerations as the geometry counts them. */
static int drives(const double *q, const double *qd, const double *qdd, double payload_kg, double temp_C, double h,
                  double *past, double *torque)
{
    struct motion m;
    int i;
    in_motion(q, qd, qdd, &m);
    for (i = 0; i < DELTACAL_JOINTS; i++) {
        const double sign = DELTACAL_SIGN[i];
        const double load = sign * given_by(&m, i, DELTACAL_INERTIA[i]);
        const double carried = sign * given_by(&m, i, DELTACAL_PAYLOAD) * payload_kg;
        torque[i] = deltacal_drive(past, h, i, sign * q[i], sign * qd[i], sign * qdd[i],
                                   load + DELTACAL_PAYLOAD_LOADS[i] * carried, temp_C);
        torque[i] /= DELTACAL_READ[i];
        if (!isfinite(torque[i]))
            return DELTACAL_NOT_A_NUMBER;
    }
    return DELTACAL_SOLVED;
}

/* Check a set point against joints' limits and the last one, and hand out joints and torques. */
static int handed_out(struct deltacal_motion *held, const double *q, const double *qd, const double *qdd,
                      double payload_kg, double temp_C)
{
    double joints[DELTACAL_JOINTS], torque[DELTACAL_JOINTS], past[DELTACAL_PAST + 1] = { 0.0 };
    int i, status, limited = 0;
    for (i = 0; i < DELTACAL_JOINTS; i++) {
        joints[i] = DELTACAL_SIGN[i] * q[i] / DELTACAL_FACTOR[i];
        if (!(joints[i] >= DELTACAL_JOINT_LOW[i] && joints[i] <= DELTACAL_JOINT_HIGH[i]))
            return DELTACAL_UNREACHABLE;
        if (held->begun && !(fabs(joints[i] - held->joints[i]) <= DELTACAL_MOST_SPEED[i] * held->period_s))
            return DELTACAL_JUMP;
    }
    recall(held, past);
    status = drives(q, qd, qdd, payload_kg, temp_C, held->begun ? held->period_s : 0.0, past, torque);
    if (status != DELTACAL_SOLVED)
        return status;
    for (i = 0; i < DELTACAL_JOINTS; i++) {
        held->joints[i] = joints[i];
        held->torque[i] = fmin(fmax(torque[i], DELTACAL_TORQUE_LOW[i]), DELTACAL_TORQUE_HIGH[i]);
        limited |= held->torque[i] != torque[i];
    }
    keep(held, past);
    held->begun = 1;
    return limited ? DELTACAL_LIMITED : DELTACAL_SOLVED;
}

static int all_finite(const double *a, const double *b, const double *c, int count)
{
    int i;
    for (i = 0; i < count; i++)
        if (!isfinite(a[i]) || !isfinite(b[i]) || !isfinite(c[i]))
            return 0;
    return 1;
}

int deltacal_feedforward_joints(struct deltacal_motion *held, const double joints[DELTACAL_JOINTS],
                                const double speeds[DELTACAL_JOINTS], const double accelerations[DELTACAL_JOINTS],
                                double payload_kg, double temp_C)
{
    double q[DELTACAL_JOINTS], qd[DELTACAL_JOINTS], qdd[DELTACAL_JOINTS];
    int i;
    if (!all_finite(joints, speeds, accelerations, DELTACAL_JOINTS) || !isfinite(payload_kg) || !isfinite(temp_C))
        return DELTACAL_NOT_A_NUMBER;
    for (i = 0; i < DELTACAL_JOINTS; i++) {
        const double factor = DELTACAL_SIGN[i] * DELTACAL_FACTOR[i];
        q[i] = factor * joints[i];
        qd[i] = factor * speeds[i];
        qdd[i] = factor * accelerations[i];
    }
    return handed_out(held, q, qd, qdd, payload_kg, temp_C);
}
#if DELTACAL_JOINTS == 6

#define POSE_STEPS 40 /* of Newton's method, at most */
#define POSE_FARTHEST 0.3 /* rad, of the chain's reach: a joint in one step */
#define POSE_DONE 1e-12 /* the same: the last step */
#define POSE_MM 1e-6 /* missed by more, the pose is out of reach */
#define POSE_RAD 1e-9

/* Solve A x = b in place; 0 where A is singular. */
static int solve(double A[6][6], double b[6])
{
    double largest = 0.0;
    int i, j, c;
    for (i = 0; i < 6; i++)
        for (j = 0; j < 6; j++)
            largest = fmax(largest, fabs(A[i][j]));
    for (c = 0; c < 6; c++) {
        int pivot = c;
        for (i = c + 1; i < 6; i++)
            if (fabs(A[i][c]) > fabs(A[pivot][c]))
                pivot = i;
        if (!(fabs(A[pivot][c]) > 1e-9 * largest))
            return 0;
        for (j = 0; j < 6; j++) {
            const double swap = A[c][j];
            A[c][j] = A[pivot][j];
            A[pivot][j] = swap;
        }
        {
            const double swap = b[c];
            b[c] = b[pivot];
            b[pivot] = swap;
        }
        for (i = c + 1; i < 6; i++) {
            const double factor = A[i][c] / A[c][c];
            for (j = c; j < 6; j++)
                A[i][j] -= factor * A[c][j];
            b[i] -= factor * b[c];
        }
    }
    for (c = 5; c >= 0; c--) {
        for (j = c + 1; j < 6; j++)
            b[c] -= A[c][j] * b[j];
        b[c] /= A[c][c];
    }
    return 1;
}

/* How the tool misses a target: shift, and turn to first order (81 operations). */
static void missed(const double *frame, const double *tool, const double *target, double *out)
{
    const double ox = frame[0];
    const double oy = frame[1];
    const double oz = frame[2];
    const double R_00 = frame[3];
    const double R_01 = frame[4];
    const double R_02 = frame[5];
    const double R_10 = frame[6];
    const double R_11 = frame[7];
    const double R_12 = frame[8];
    const double R_20 = frame[9];
    const double R_21 = frame[10];
    const double R_22 = frame[11];
    const double tool_x = tool[0];
    const double tool_y = tool[1];
    const double tool_z = tool[2];
    const double target0 = target[0];
    const double target1 = target[1];
    const double target2 = target[2];
    const double target3 = target[3];
    const double target4 = target[4];
    const double target5 = target[5];
    const double target6 = target[6];
    const double target7 = target[7];
    const double target8 = target[8];
    const double target9 = target[9];
    const double target10 = target[10];
    const double target11 = target[11];
    const double s1655 = -R_00*tool_x - R_01*tool_y - R_02*tool_z - ox + target0;
    const double s1659 = -R_10*tool_x - R_11*tool_y - R_12*tool_z - oy + target1;
    const double s1663 = -R_20*tool_x - R_21*tool_y - R_22*tool_z - oz + target2;
    const double s1667 = -1.0/2.0*R_20*target6;
    const double s1668 = -1.0/2.0*R_21*target7;
    const double s1669 = -1.0/2.0*R_22*target8;
    const double s1670 = (1.0/2.0)*R_10*target9 + (1.0/2.0)*R_11*target10 + (1.0/2.0)*R_12*target11 + s1667 + s1668 + s1669;
    const double s1674 = -1.0/2.0*R_00*target9;
    const double s1675 = -1.0/2.0*R_01*target10;
    const double s1676 = -1.0/2.0*R_02*target11;
    const double s1677 = (1.0/2.0)*R_20*target3 + (1.0/2.0)*R_21*target4 + (1.0/2.0)*R_22*target5 + s1674 + s1675 + s1676;
    const double s1681 = -1.0/2.0*R_10*target3;
    const double s1682 = -1.0/2.0*R_11*target4;
    const double s1683 = -1.0/2.0*R_12*target5;
    const double s1684 = (1.0/2.0)*R_00*target6 + (1.0/2.0)*R_01*target7 + (1.0/2.0)*R_02*target8 + s1681 + s1682 + s1683;
    out[0] = s1655;
    out[1] = s1659;
    out[2] = s1663;
    out[3] = s1670;
    out[4] = s1677;
    out[5] = s1684;
}

/* Twist of the tool point by that of a joint (30 operations). */
static void tip(const double *frame, const double *tool, const double *axis, double *out)
{
    const double ox = frame[0];
    const double oy = frame[1];
    const double oz = frame[2];
    const double R_00 = frame[3];
    const double R_01 = frame[4];
    const double R_02 = frame[5];
    const double R_10 = frame[6];
    const double R_11 = frame[7];
    const double R_12 = frame[8];
    const double R_20 = frame[9];
    const double R_21 = frame[10];
    const double R_22 = frame[11];
    const double ux = axis[0];
    const double uy = axis[1];
    const double uz = axis[2];
    const double wx = axis[3];
    const double wy = axis[4];
    const double wz = axis[5];
    const double tool_x = tool[0];
    const double tool_y = tool[1];
    const double tool_z = tool[2];
    const double s1685 = R_20*tool_x + R_21*tool_y + R_22*tool_z + oz;
    const double s1687 = R_10*tool_x + R_11*tool_y + R_12*tool_z + oy;
    const double s1689 = s1685*wy - s1687*wz + ux;
    const double s1690 = R_00*tool_x + R_01*tool_y + R_02*tool_z + ox;
    const double s1693 = -s1685*wx + s1690*wz + uy;
    const double s1696 = s1687*wx - s1690*wy + uz;
    out[0] = s1689;
    out[1] = s1693;
    out[2] = s1696;
    out[3] = wx;
    out[4] = wy;
    out[5] = wz;
}

/* How the tool accelerates (78 operations). */
static void led(const double *frame, const double *tool, double *out)
{
    const double R_00 = frame[3];
    const double R_01 = frame[4];
    const double R_02 = frame[5];
    const double R_10 = frame[6];
    const double R_11 = frame[7];
    const double R_12 = frame[8];
    const double R_20 = frame[9];
    const double R_21 = frame[10];
    const double R_22 = frame[11];
    const double ox_tt = frame[24];
    const double oy_tt = frame[25];
    const double oz_tt = frame[26];
    const double R_00_tt = frame[27];
    const double R_01_tt = frame[28];
    const double R_02_tt = frame[29];
    const double R_10_tt = frame[30];
    const double R_11_tt = frame[31];
    const double R_12_tt = frame[32];
    const double R_20_tt = frame[33];
    const double R_21_tt = frame[34];
    const double R_22_tt = frame[35];
    const double tool_x = tool[0];
    const double tool_y = tool[1];
    const double tool_z = tool[2];
    const double s1700 = R_00_tt*tool_x + R_01_tt*tool_y + R_02_tt*tool_z + ox_tt;
    const double s1704 = R_10_tt*tool_x + R_11_tt*tool_y + R_12_tt*tool_z + oy_tt;
    const double s1708 = R_20_tt*tool_x + R_21_tt*tool_y + R_22_tt*tool_z + oz_tt;
    const double s1712 = -1.0/2.0*R_10_tt*R_20;
    const double s1713 = -1.0/2.0*R_11_tt*R_21;
    const double s1714 = -1.0/2.0*R_12_tt*R_22;
    const double s1715 = (1.0/2.0)*R_10*R_20_tt + (1.0/2.0)*R_11*R_21_tt + (1.0/2.0)*R_12*R_22_tt + s1712 + s1713 + s1714;
    const double s1719 = -1.0/2.0*R_00*R_20_tt;
    const double s1720 = -1.0/2.0*R_01*R_21_tt;
    const double s1721 = -1.0/2.0*R_02*R_22_tt;
    const double s1722 = (1.0/2.0)*R_00_tt*R_20 + (1.0/2.0)*R_01_tt*R_21 + (1.0/2.0)*R_02_tt*R_22 + s1719 + s1720 + s1721;
    const double s1726 = -1.0/2.0*R_00_tt*R_10;
    const double s1727 = -1.0/2.0*R_01_tt*R_11;
    const double s1728 = -1.0/2.0*R_02_tt*R_12;
    const double s1729 = (1.0/2.0)*R_00*R_10_tt + (1.0/2.0)*R_01*R_11_tt + (1.0/2.0)*R_02*R_12_tt + s1726 + s1727 + s1728;
    out[0] = s1700;
    out[1] = s1704;
    out[2] = s1708;
    out[3] = s1715;
    out[4] = s1722;
    out[5] = s1729;
}

/* Rotation by a rotation vector, row by row (60 operations). */
static void turned(const double *vector, double *out)
{
    const double vx = vector[0];
    const double vy = vector[1];
    const double vz = vector[2];
    const double s1730 = (vy * vy);
    const double s1731 = (vx * vx);
    const double s1732 = (vz * vz);
    const double s1733 = s1730 + s1731 + s1732 + 1.0e-300;
    const double s1734 = 1.0/s1733;
    const double s1735 = sqrt(s1733);
    const double s1738 = ((sin((1.0/2.0)*s1735)) * (sin((1.0/2.0)*s1735)));
    const double s1739 = -2*s1730*s1734*s1738;
    const double s1740 = -2*s1732*s1734*s1738;
    const double s1741 = s1739 + s1740 + 1;
    const double s1742 = pow(s1733, -1.0/2.0);
    const double s1743 = sin(s1735);
    const double s1744 = -s1742*s1743*vz;
    const double s1745 = 2*s1734*s1738*vx*vy;
    const double s1746 = s1744 + s1745;
    const double s1747 = s1742*s1743*vy;
    const double s1748 = 2*s1734*s1738*vx*vz;
    const double s1749 = s1747 + s1748;
    const double s1750 = -s1744 + s1745;
    const double s1751 = -2*s1731*s1734*s1738;
    const double s1752 = s1740 + s1751 + 1;
    const double s1753 = -s1742*s1743*vx;
    const double s1754 = 2*s1734*s1738*vy*vz;
    const double s1755 = s1753 + s1754;
    const double s1756 = -s1747 + s1748;
    const double s1757 = -s1753 + s1754;
    const double s1758 = s1739 + s1751 + 1;
    out[0] = s1741;
    out[1] = s1746;
    out[2] = s1749;
    out[3] = s1750;
    out[4] = s1752;
    out[5] = s1755;
    out[6] = s1756;
    out[7] = s1757;
    out[8] = s1758;
}

/* Solve which joints move the tool point and turn the last frame as asked, in b; 0 where none do. */
static int joint_rates(const struct motion *m, double b[6])
{
    double A[6][6] = { { 0.0 } };
    int i, d;
    for (d = 0; d < DELTACAL_DRIVES; d++) {
        const int j = DELTACAL_DRIVE[d][2];
        double twist[6];
        tip(m->frame[DELTACAL_LINKS], DELTACAL_TOOL, m->axis[d], twist);
        for (i = 0; i < 6; i++)
            A[i][j] += DELTACAL_MUCH[d] * DELTACAL_REACHES[j] * twist[i] / (i < 3 ? DELTACAL_REACH[0] : 1.0);
    }
    for (i = 0; i < 3; i++)
        b[i] /= DELTACAL_REACH[0];
    if (!solve(A, b))
        return 0;
    for (i = 0; i < 6; i++)
        b[i] *= DELTACAL_REACHES[i];
    return 1;
}

/*
 * Find the joints at which the last frame stands in a pose, from those in q on; leaves the chain there, at rest, in m.
 */
static int stood(const double target[12], double q[6], struct motion *m)
{
    const double rest[6] = { 0.0 };
    double e[6], trace = 0.0;
    int i, c, steps, found = 0;
    for (steps = 0; steps < POSE_STEPS && !found; steps++) {
        double largest = 0.0;
        in_motion(q, rest, rest, m);
        missed(m->frame[DELTACAL_LINKS], DELTACAL_TOOL, target, e);
        if (!joint_rates(m, e))
            break;
        for (i = 0; i < 6; i++)
            largest = fmax(largest, fabs(e[i] / DELTACAL_REACHES[i]));
        found = largest < POSE_DONE;
        for (i = 0; i < 6; i++)
            q[i] += e[i] * (largest > POSE_FARTHEST ? POSE_FARTHEST / largest : 1.0);
    }
    in_motion(q, rest, rest, m);
    missed(m->frame[DELTACAL_LINKS], DELTACAL_TOOL, target, e);
    for (i = 0; i < 3; i++) {
        for (c = 0; c < 3; c++)
            trace += m->frame[DELTACAL_LINKS][3 + 3 * i + c] * target[3 + 3 * i + c];
        if (!(fabs(e[i]) < POSE_MM && fabs(e[3 + i]) < POSE_RAD))
            return DELTACAL_UNREACHABLE;
    }
    if (!(trace > 0.0)) /* half a turn is as far away as it can be */
        return DELTACAL_UNREACHABLE;
    return found ? DELTACAL_SOLVED : DELTACAL_SINGULAR;
}

int deltacal_feedforward(struct deltacal_motion *held, const double target[6], const double velocity[6],
                         const double acceleration[6], double payload_kg, double temp_C)
{
    const double rest[6] = { 0.0 };
    double q[6], qd[6], qdd[6], vector[3], place[12], drift[6];
    struct motion m;
    int i, status;
    if (!all_finite(target, velocity, acceleration, 6) || !isfinite(payload_kg) || !isfinite(temp_C))
        return DELTACAL_NOT_A_NUMBER;
    for (i = 0; i < 6; i++) {
        const double unit = i < 3 ? 1.0 : DEGREE;
        q[i] = DELTACAL_SIGN[i] * DELTACAL_FACTOR[i] * held->joints[i];
        qd[i] = unit * velocity[i];
        qdd[i] = unit * acceleration[i];
        if (!isfinite(q[i]))
            return DELTACAL_NOT_A_NUMBER;
    }
    for (i = 0; i < 3; i++) {
        place[i] = target[i];
        vector[i] = DEGREE * target[3 + i];
    }
    turned(vector, place + 3);
    status = stood(place, q, &m);
    if (status != DELTACAL_SOLVED)
        return status;
    if (!joint_rates(&m, qd))
        return DELTACAL_SINGULAR;
    in_motion(q, qd, rest, &m); /* of joints that do not accelerate */
    led(m.frame[DELTACAL_LINKS], DELTACAL_TOOL, drift);
    for (i = 0; i < 6; i++)
        qdd[i] -= drift[i];
    if (!joint_rates(&m, qdd))
        return DELTACAL_SINGULAR;
    return handed_out(held, q, qd, qdd, payload_kg, temp_C);
}
#endif

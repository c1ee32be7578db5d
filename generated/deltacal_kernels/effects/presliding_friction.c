/*
 * Generated from derive/effects/presliding_friction.py by "deltacal kernels". Do not edit.
 * Template templates/effect.c.jinja; sha256 of both 7ec6c10a03bc3bb9; SymPy 1.14.0.
 *
 * Dry friction that builds up over a way: what the drive gives.
 * State s: qd; units mm, rad, N, s, K.
 */
static double presliding_friction(const double *s, const double *c, const double *constants)
{
    const double qd = s[0];
    const double c_stiffness = c[0];
    const double travel = constants[0];
    const double z = s[1];
    const double s2 = c_stiffness*travel*(z - ((qd > 0) ? 1.0 : ((qd < 0) ? -1.0 : 0.0)));
    return s2;
}

/* What is remembered (behind the states in s) at the first set point. */
static void presliding_friction_start(double *z, const double *s, const double *c, const double *constants)
{
    (void)(s);
    (void)(c);
    (void)(constants);
    z[0] = 0.0;
}

/* What is remembered after h seconds, in which the states went straight from s to to. */
static void presliding_friction_step(double *z, const double *s, const double *to, double h, const double *c,
                                     const double *constants)
{
    const double qd = s[0];
    const double travel = constants[0];
    const double qd_to = to[0];
    const double own_z = z[0];
    const double s0 = 1.0/travel;
    const double s3 = (1.0/2.0)*qd + (1.0/2.0)*qd_to;
    const double x_z = -h*s0*s3*((s3 > 0) ? 1.0 : ((s3 < 0) ? -1.0 : 0.0));
    const double s13 = x_z*(x_z*(x_z*((1.0/6402373705728000.0)*x_z + 1.0/355687428096000.0) + 1.0/20922789888000.0) + 1.0/1307674368000.0) + 1.0/87178291200.0;
    const double s21 = x_z*(x_z*(x_z*(s13*x_z + 1.0/6227020800.0) + 1.0/479001600.0) + 1.0/39916800.0) + 1.0/3628800.0;
    const double s29 = x_z*(x_z*(x_z*(s21*x_z + 1.0/362880.0) + 1.0/40320.0) + 1.0/5040.0) + 1.0/720.0;
    const double s37 = x_z*(x_z*(x_z*(s29*x_z + 1.0/120.0) + 1.0/24.0) + 1.0/6.0) + 1.0/2.0;
    const double s40 = fabs(x_z);
    const double s42 = exp(x_z);
    const double phi1_z = ((s40 < 1) ? (
   s37*x_z + 1
)
: (
   (s42 - 1)/x_z
));
    const double s53 = x_z*(x_z*(x_z*((1.0/121645100408832000.0)*x_z + 1.0/6402373705728000.0) + 1.0/355687428096000.0) + 1.0/20922789888000.0) + 1.0/1307674368000.0;
    const double s61 = x_z*(x_z*(x_z*(s53*x_z + 1.0/87178291200.0) + 1.0/6227020800.0) + 1.0/479001600.0) + 1.0/39916800.0;
    const double s69 = x_z*(x_z*(x_z*(s61*x_z + 1.0/3628800.0) + 1.0/362880.0) + 1.0/40320.0) + 1.0/5040.0;
    const double s77 = x_z*(x_z*(x_z*(s69*x_z + 1.0/720.0) + 1.0/120.0) + 1.0/24.0) + 1.0/6.0;
    const double phi2_z = ((s40 < 1) ? (
   s77*x_z + 1.0/2.0
)
: (
   (s42 - x_z - 1)/(x_z * x_z)
));
    const double s156 = ((qd_to > 0) ? 1.0 : ((qd_to < 0) ? -1.0 : 0.0));
    const double s160 = ((qd > 0) ? 1.0 : ((qd < 0) ? -1.0 : 0.0));
    const double s162 = -s160*own_z + 1;
    const double s167 = phi1_z*qd*s0*s162 + phi2_z*(-qd*s0*s162 + qd_to*s0*(-s156*own_z + 1));
    const double s169 = h*s167 + own_z;
    (void)(c);
    z[0] = s169;
}

/*
 * Generated from derive/effects/joint_scale.py by "deltacal kernels". Do not edit.
 * Template templates/effect.c.jinja; sha256 of both 335acca1d7146733; SymPy 1.14.0.
 *
 * Gear ratio or encoder scale is off: by how much the joint is moved [rad or mm].
 * State s: q; units mm, rad, N, s, K.
 */
static double joint_scale(const double *s, const double *c, const double *constants)
{
    const double q = s[0];
    const double c_scale = c[0];
    const double s0 = q*c_scale;
    (void)(constants);
    return s0;
}

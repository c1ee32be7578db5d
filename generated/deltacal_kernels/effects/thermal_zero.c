/*
 * Generated from derive/effects/thermal_zero.py by "deltacal kernels". Do not edit.
 * Template templates/effect.c.jinja; sha256 of both 2dbb40a72d104396; SymPy 1.14.0.
 *
 * Joint zero moves with temperature: by how much the joint is moved [rad or mm].
 * State s: warming; units mm, rad, N, s, K.
 */
static double thermal_zero(const double *s, const double *c, const double *constants)
{
    const double warming = s[0];
    const double c_drift = c[0];
    const double s0 = c_drift*warming;
    (void)(constants);
    return s0;
}

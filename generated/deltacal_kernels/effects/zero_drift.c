/*
 * Generated from derive/effects/zero_drift.py by "deltacal kernels". Do not edit.
 * Template templates/effect.c.jinja; sha256 of both e3d18371e4604865; SymPy 1.14.0.
 *
 * Joint zero moves with time: by how much the joint is moved [rad or mm].
 * State s: time; units mm, rad, N, s, K.
 */
static double zero_drift(const double *s, const double *c, const double *constants)
{
    const double time = s[0];
    const double c_rate = c[0];
    const double s0 = (1.0/3600.0)*c_rate*time;
    (void)(constants);
    return s0;
}

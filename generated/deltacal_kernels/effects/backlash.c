/*
 * Generated from derive/effects/backlash.py by "deltacal kernels". Do not edit.
 * Template templates/effect.c.jinja; sha256 of both 5b9f0203b60a2324; SymPy 1.14.0.
 *
 * Play, flips with the direction of approach: by how much the joint is moved [rad or mm].
 * State s: approach; units mm, rad, N, s, K.
 */
static double backlash(const double *s, const double *c, const double *constants)
{
    const double approach = s[0];
    const double c_width = c[0];
    const double s0 = -1.0/2.0*approach*c_width;
    (void)(constants);
    return s0;
}

/*
 * Generated from derive/effects/zero_jump.py by "deltacal kernels". Do not edit.
 * Template templates/effect.c.jinja; sha256 of both 80c25d85eb6342a8; SymPy 1.14.0.
 *
 * Joint zero jumps once: by how much the joint is moved [rad or mm].
 * State s: after; units mm, rad, N, s, K.
 */
static double zero_jump(const double *s, const double *c, const double *constants)
{
    const double after = s[0];
    const double c_size = c[0];
    const double s0 = after*c_size;
    (void)(constants);
    return s0;
}

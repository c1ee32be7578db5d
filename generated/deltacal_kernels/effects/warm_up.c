/*
 * Generated from derive/effects/warm_up.py by "deltacal kernels". Do not edit.
 * Template templates/effect.c.jinja; sha256 of both e00a15561ff60e63; SymPy 1.14.0.
 *
 * The joint's zero creeps while the machine warms up: by how much the joint is moved [rad or mm].
 * State s: time; units mm, rad, N, s, K.
 */
static double warm_up(const double *s, const double *c, const double *constants)
{
    const double time = s[0];
    const double c_size = c[0];
    const double time_constant = constants[0];
    const double s4 = c_size*(1 - exp(-time/time_constant));
    return s4;
}

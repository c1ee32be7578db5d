/*
 * Generated from derive/effects/transmission_eccentricity.py by "deltacal kernels". Do not edit.
 * Template templates/effect.c.jinja; sha256 of both bd0031a8e5bb9306; SymPy 1.14.0.
 *
 * Periodic error of the transmission: by how much the joint is moved [rad or mm].
 * State s: turn; units mm, rad, N, s, K.
 */
static double transmission_eccentricity(const double *s, const double *c, const double *constants)
{
    const double turn = s[0];
    const double c_cos = c[0];
    const double c_sin = c[1];
    const double order = constants[0];
    const double s0 = order*turn;
    const double s5 = c_cos*cos(s0) + c_sin*sin(s0);
    return s5;
}

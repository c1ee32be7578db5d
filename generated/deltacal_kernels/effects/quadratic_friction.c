/*
 * Generated from derive/effects/quadratic_friction.py by "deltacal kernels". Do not edit.
 * Template templates/effect.c.jinja; sha256 of both 7e949202dc6c41d9; SymPy 1.14.0.
 *
 * Friction by the square of the speed: what the drive gives.
 * State s: qd; units mm, rad, N, s, K.
 */
static double quadratic_friction(const double *s, const double *c, const double *constants)
{
    const double qd = s[0];
    const double c_quadratic = c[0];
    const double s1 = qd*c_quadratic*fabs(qd);
    (void)(constants);
    return s1;
}

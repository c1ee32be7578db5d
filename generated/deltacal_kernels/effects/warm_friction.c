/*
 * Generated from derive/effects/warm_friction.py by "deltacal kernels". Do not edit.
 * Template templates/effect.c.jinja; sha256 of both 7f6aea952aa7c37e; SymPy 1.14.0.
 *
 * Friction that changes with the temperature: what the drive gives.
 * State s: qd warming; units mm, rad, N, s, K.
 */
static double warm_friction(const double *s, const double *c, const double *constants)
{
    const double qd = s[0];
    const double warming = s[1];
    const double c_warm = c[0];
    const double s0 = qd*c_warm*warming;
    (void)(constants);
    return s0;
}

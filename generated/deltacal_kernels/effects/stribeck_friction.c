/*
 * Generated from derive/effects/stribeck_friction.py by "deltacal kernels". Do not edit.
 * Template templates/effect.c.jinja; sha256 of both 57c1e1b82318f083; SymPy 1.14.0.
 *
 * More friction near rest than in motion: what the drive gives.
 * State s: qd; units mm, rad, N, s, K.
 */
static double stribeck_friction(const double *s, const double *c, const double *constants)
{
    const double qd = s[0];
    const double c_stribeck = c[0];
    const double velocity = constants[0];
    const double s5 = c_stribeck*exp(-(qd * qd)/(velocity * velocity))*((qd > 0) ? 1.0 : ((qd < 0) ? -1.0 : 0.0));
    return s5;
}

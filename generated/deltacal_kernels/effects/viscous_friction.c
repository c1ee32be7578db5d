/*
 * Generated from derive/effects/viscous_friction.py by "deltacal kernels". Do not edit.
 * Template templates/effect.c.jinja; sha256 of both b86012a3f5edca2b; SymPy 1.14.0.
 *
 * Friction that grows with the speed: what the drive gives.
 * State s: qd; units mm, rad, N, s, K.
 */
static double viscous_friction(const double *s, const double *c, const double *constants)
{
    const double qd = s[0];
    const double c_viscous = c[0];
    const double s0 = qd*c_viscous;
    (void)(constants);
    return s0;
}

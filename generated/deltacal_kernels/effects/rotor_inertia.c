/*
 * Generated from derive/effects/rotor_inertia.py by "deltacal kernels". Do not edit.
 * Template templates/effect.c.jinja; sha256 of both aba85ef353940cb1; SymPy 1.14.0.
 *
 * Inertia of the drive: what the drive gives.
 * State s: qdd; units mm, rad, N, s, K.
 */
static double rotor_inertia(const double *s, const double *c, const double *constants)
{
    const double qdd = s[0];
    const double c_inertia = c[0];
    const double s0 = c_inertia*qdd;
    (void)(constants);
    return s0;
}

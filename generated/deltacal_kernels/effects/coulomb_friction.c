/*
 * Generated from derive/effects/coulomb_friction.py by "deltacal kernels". Do not edit.
 * Template templates/effect.c.jinja; sha256 of both ad0f73933c444470; SymPy 1.14.0.
 *
 * Dry friction: what the drive gives.
 * State s: qd; units mm, rad, N, s, K.
 */
static double coulomb_friction(const double *s, const double *c, const double *constants)
{
    const double qd = s[0];
    const double c_coulomb = c[0];
    const double s1 = c_coulomb*((qd > 0) ? 1.0 : ((qd < 0) ? -1.0 : 0.0));
    (void)(constants);
    return s1;
}

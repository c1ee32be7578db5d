/*
 * Generated from derive/effects/load_friction.py by "deltacal kernels". Do not edit.
 * Template templates/effect.c.jinja; sha256 of both 49743f5b27d794bf; SymPy 1.14.0.
 *
 * Friction that grows with the load: what the drive gives.
 * State s: qd torque; units mm, rad, N, s, K.
 */
static double load_friction(const double *s, const double *c, const double *constants)
{
    const double qd = s[0];
    const double torque = s[1];
    const double c_load = c[0];
    const double s2 = c_load*fabs(torque)*((qd > 0) ? 1.0 : ((qd < 0) ? -1.0 : 0.0));
    (void)(constants);
    return s2;
}

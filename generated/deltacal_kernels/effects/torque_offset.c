/*
 * Generated from derive/effects/torque_offset.py by "deltacal kernels". Do not edit.
 * Template templates/effect.c.jinja; sha256 of both 4eaeee3b761b7f4a; SymPy 1.14.0.
 *
 * Constant torque: what the drive gives.
 * State s: ; units mm, rad, N, s, K.
 */
static double torque_offset(const double *s, const double *c, const double *constants)
{
    const double c_offset = c[0];
    (void)(s);
    (void)(constants);
    return c_offset;
}

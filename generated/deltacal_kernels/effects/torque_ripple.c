/*
 * Generated from derive/effects/torque_ripple.py by "deltacal kernels". Do not edit.
 * Template templates/effect.c.jinja; sha256 of both b385d4f40316a826; SymPy 1.14.0.
 *
 * Torque that repeats with the turn of the joint: what the drive gives.
 * State s: turn; units mm, rad, N, s, K.
 */
static double torque_ripple(const double *s, const double *c, const double *constants)
{
    const double turn = s[0];
    const double c_cos = c[0];
    const double c_sin = c[1];
    const double order = constants[0];
    const double s0 = order*turn;
    const double s5 = c_cos*cos(s0) + c_sin*sin(s0);
    return s5;
}

"""Links of `serial`: Open chain of revolute and prismatic joints.

Generated from derive/mechanisms/serial.py by "deltacal kernels". Do not edit.
Template templates/chain/links.py.jinja; sha256 of both 7873b3bb8104a813; SymPy 1.14.0.

Plain NumPy over all poses at once, which stand last in every array: x (2, N) the joint's variable as a turn and as a
slide, one of them zero; p (9, M) the link's parameters, M being 1 or N:
a alpha d theta da dalpha dd dtheta dbeta.
"""

import numpy as np

TURN, SLIDE = 5, 6  # of the joint among the twists


def _standard(x, p):
    """A link, standard convention: rotation, shift; shift and turn by each error, by turn and slide: (54, N)."""
    turn = x[0]
    slide = x[1]
    a = p[0]
    alpha = p[1]
    d = p[2]
    theta = p[3]
    da = p[4]
    dalpha = p[5]
    dd = p[6]
    dtheta = p[7]
    dbeta = p[8]
    about_z = dtheta + theta + turn
    along_z = d + dd + slide
    along_x = a + da
    about_x = alpha + dalpha
    s4 = np.cos(dbeta)
    s5 = np.cos(about_z)
    s7 = np.sin(about_x)
    s8 = np.sin(dbeta)
    s9 = np.sin(about_z)
    s11 = s4*s5 - s7*s8*s9
    s12 = np.cos(about_x)
    s13 = -s12*s9
    s16 = s4*s7*s9 + s5*s8
    s19 = s4*s9 + s5*s7*s8
    s20 = s12*s5
    s23 = -s4*s5*s7 + s8*s9
    s24 = -s12*s8
    s25 = s12*s4
    s26 = along_x*s5
    s27 = along_x*s9
    out = np.zeros((54, *x.shape[1:]))
    out[0] = s11
    out[1] = s13
    out[2] = s16
    out[3] = s19
    out[4] = s20
    out[5] = s23
    out[6] = s24
    out[7] = s7
    out[8] = s25
    out[9] = s26
    out[10] = s27
    out[11] = along_z
    out[12] = s5
    out[13] = s9
    out[21] = s5
    out[22] = s9
    out[26] = 1
    out[30] = -s27
    out[31] = s26
    out[35] = 1
    out[39] = s13
    out[40] = s20
    out[41] = s7
    out[42] = -s27
    out[43] = s26
    out[47] = 1
    out[50] = 1
    return out


def _modified(x, p):
    """A link, modified convention: rotation, shift; shift and turn by each error, by turn and slide: (54, N)."""
    turn = x[0]
    slide = x[1]
    a = p[0]
    alpha = p[1]
    d = p[2]
    theta = p[3]
    da = p[4]
    dalpha = p[5]
    dd = p[6]
    dtheta = p[7]
    dbeta = p[8]
    about_z = dtheta + theta + turn
    along_z = d + dd + slide
    along_x = a + da
    about_x = alpha + dalpha
    s4 = np.cos(dbeta)
    s5 = np.cos(about_z)
    s6 = s4*s5
    s7 = np.sin(about_z)
    s8 = -s4*s7
    s9 = np.sin(dbeta)
    s10 = np.cos(about_x)
    s12 = np.sin(about_x)
    s14 = s10*s7 + s12*s5*s9
    s17 = s10*s5 - s12*s7*s9
    s18 = -s12*s4
    s21 = -s10*s5*s9 + s12*s7
    s24 = s10*s7*s9 + s12*s5
    s25 = s10*s4
    s28 = along_x*s4 + along_z*s9
    s31 = along_x*s12*s9 - along_z*s12*s4
    s34 = -along_x*s10*s9 + along_z*s10*s4
    s35 = s12*s9
    s36 = -s10*s9
    s39 = s10*s34 - s12*s31
    s40 = s12*s28
    s41 = -s10*s28
    out = np.zeros((54, *x.shape[1:]))
    out[0] = s6
    out[1] = s8
    out[2] = s9
    out[3] = s14
    out[4] = s17
    out[5] = s18
    out[6] = s21
    out[7] = s24
    out[8] = s25
    out[9] = s28
    out[10] = s31
    out[11] = s34
    out[12] = s4
    out[13] = s35
    out[14] = s36
    out[19] = -s34
    out[20] = s31
    out[21] = 1
    out[24] = s9
    out[25] = s18
    out[26] = s25
    out[33] = s9
    out[34] = s18
    out[35] = s25
    out[36] = s39
    out[37] = s40
    out[38] = s41
    out[40] = s10
    out[41] = s12
    out[45] = s9
    out[46] = s18
    out[47] = s25
    out[48] = s9
    out[49] = s18
    out[50] = s25
    return out


def link(convention, x, p):
    """Return rotation (3, 3, N) and shift (3, N) from the link's frame to the one before, and twists (7, 2, 3, N).

    A twist is the shift of the link's origin and the turn of the link, in the frame before, by an error, by the joint's
    turn or by its slide.
    """
    out = {"standard": _standard, "modified": _modified}[convention](x, p)
    return out[:9].reshape(3, 3, -1), out[9:12], out[12:].reshape(7, 2, 3, -1)

"""Rotations of bodies and their Cayley vectors, in plain NumPy.

Written by "deltacal kernels". Do not edit.

c = 2 tan(t/2) n is the Cayley vector of a rotation by an angle t about n. ``poses.py`` has the same for poses,
compiled.
"""

import numpy as np


def matrix(c):
    """Return rotations (N, 3, 3) by Cayley vectors (N, 3)."""
    c = np.ascontiguousarray(np.asarray(c).reshape(-1, 3).T)
    cx = c[0]
    cy = c[1]
    cz = c[2]
    s0 = (cx * cx)
    s2 = (cy * cy)
    s4 = (cz * cz)
    s7 = (1.0 / (0.25*s0 + 0.25*s2 + 0.25*s4 + 1))
    s8 = -0.5*s2
    s9 = -0.5*s4
    s12 = s7*(s8 + s9) + 1
    s13 = 0.5*cx*cy
    s15 = s7*(-cz + s13)
    s16 = 0.5*cx*cz
    s18 = s7*(cy + s16)
    s20 = s7*(cz + s13)
    s21 = -0.5*s0
    s24 = s7*(s21 + s9) + 1
    s25 = 0.5*cy*cz
    s27 = s7*(-cx + s25)
    s29 = s7*(-cy + s16)
    s31 = s7*(cx + s25)
    s34 = s7*(s21 + s8) + 1
    out = np.zeros((9, c.shape[1]))
    out[0] = s12
    out[1] = s15
    out[2] = s18
    out[3] = s20
    out[4] = s24
    out[5] = s27
    out[6] = s29
    out[7] = s31
    out[8] = s34
    return np.ascontiguousarray(out.T).reshape(-1, 3, 3)


def vector(R):
    """Return Cayley vectors (N, 3) of rotations (N, 3, 3) by less than half a turn."""
    R = np.ascontiguousarray(np.asarray(R).reshape(-1, 9).T)
    R_00 = R[0]
    R_01 = R[1]
    R_02 = R[2]
    R_10 = R[3]
    R_11 = R[4]
    R_12 = R[5]
    R_20 = R[6]
    R_21 = R[7]
    R_22 = R[8]
    s1 = (1.0 / (R_00 + R_11 + R_22 + 1))
    s3 = 2*s1*(-R_12 + R_21)
    s5 = 2*s1*(R_02 - R_20)
    s7 = 2*s1*(-R_01 + R_10)
    out = np.zeros((3, R.shape[1]))
    out[0] = s3
    out[1] = s5
    out[2] = s7
    return np.ascontiguousarray(out.T)


def spin(c):
    """Return W (N, 3, 3) by which a change of a Cayley vector (N, 3) turns a body: ``axial(dR R^T) = W dc``."""
    c = np.ascontiguousarray(np.asarray(c).reshape(-1, 3).T)
    cx = c[0]
    cy = c[1]
    cz = c[2]
    s7 = (1.0 / (0.25*(cx * cx) + 0.25*(cy * cy) + 0.25*(cz * cz) + 1))
    s35 = -0.5*cz*s7
    s36 = 0.5*cy*s7
    s37 = -0.5*cx*s7
    out = np.zeros((9, c.shape[1]))
    out[0] = s7
    out[1] = s35
    out[2] = s36
    out[3] = -s35
    out[4] = s7
    out[5] = s37
    out[6] = -s36
    out[7] = -s37
    out[8] = s7
    return np.ascontiguousarray(out.T).reshape(-1, 3, 3)


def swept(p):
    """Return how positions (N, 3) move by turns about the axes of {O}: (N, 3, 3), a column for each axis."""
    p = np.ascontiguousarray(np.asarray(p).reshape(-1, 3).T)
    px = p[0]
    py = p[1]
    pz = p[2]
    out = np.zeros((9, p.shape[1]))
    out[1] = pz
    out[2] = -py
    out[3] = -pz
    out[5] = px
    out[6] = py
    out[7] = -px
    return np.ascontiguousarray(out.T).reshape(-1, 3, 3)


def aim(p):
    """Return the turns about z, then x, that bring the axis y along lines (N, 3): (N, 2)."""
    p = np.ascontiguousarray(np.asarray(p).reshape(-1, 3).T)
    px = p[0]
    py = p[1]
    pz = p[2]
    s0 = np.arctan2(-px, py)
    s5 = np.arctan2(pz, np.sqrt((px * px) + (py * py)))
    out = np.zeros((2, p.shape[1]))
    out[0] = s0
    out[1] = s5
    return np.ascontiguousarray(out.T)


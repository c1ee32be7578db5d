"""What a camera's images show, in plain NumPy.

Written by "deltacal kernels". Do not edit.

Numbers of a quantity stand first: pixel (2, ...) u v; sight (2, ...) x y of the direction (x, y, 1) in the camera's
frame, z along the optical axis; by_pixel (4, ...) its derivatives, by u and v of x, then of y; lens (5,) focal lengths
along u and v and principal point [px], radial distortion; centre (3,) and radius of a ball [mm].
"""

import numpy as np


def direction(pixel, sight, lens):
    """Return direction of sight (2, ...) of a pixel, by one that is nearly right."""
    u = pixel[0]
    v = pixel[1]
    x = sight[0]
    y = sight[1]
    fu = lens[0]
    fv = lens[1]
    u0 = lens[2]
    v0 = lens[3]
    k = lens[4]
    s6 = (1.0 / (k*((x * x) + (y * y)) + 1))
    s8 = s6*(u - u0)/fu
    s11 = s6*(v - v0)/fv
    out = np.zeros((2, *sight.shape[1:]))
    out[0] = s8
    out[1] = s11
    return out


def by_sight(sight, lens):
    """Return derivatives (4, ...) of a pixel by its direction of sight."""
    x = sight[0]
    y = sight[1]
    fu = lens[0]
    fv = lens[1]
    k = lens[4]
    s1 = (x * x)
    s2 = (y * y)
    s5 = k*(s1 + s2) + 1
    s14 = 2*fu*k*s1 + fu*s5
    s15 = 2*fu*k*x*y
    s16 = 2*fv*k*x*y
    s19 = 2*fv*k*s2 + fv*s5
    out = np.zeros((4, *sight.shape[1:]))
    out[0] = s14
    out[1] = s15
    out[2] = s16
    out[3] = s19
    return out


def outline(sight, by_pixel, centre, radius):
    """Return how far inside a ball's outline pixels lie [px], and the direction that leads inward (3, ...)."""
    x = sight[0]
    y = sight[1]
    x_u = by_pixel[0]
    x_v = by_pixel[1]
    y_u = by_pixel[2]
    y_v = by_pixel[3]
    cx = centre[0]
    cy = centre[1]
    cz = centre[2]
    s1 = cx - cz*x
    s4 = -cy + cz*y
    s8 = -cx*y + cy*x
    s10 = (s1 * s1) + (s4 * s4) + (s8 * s8)
    s11 = np.sqrt(s10)
    s14 = cx*x + cy*y + cz
    s41 = (1.0 / ((s11 * s11) + (s14 * s14)))
    s43 = -s11*s41
    s50 = -0.5*s14*s41/np.sqrt(s10)
    s52 = 2*s50*s8
    s68 = -cx*s52 - cy*s43 + 2*cz*s4*s50
    s69 = -cx*s43 + cy*s52 - 2*cz*s1*s50
    s72 = s68*y_u + s69*x_u
    s76 = s68*y_v + s69*x_v
    s80 = 1/np.sqrt((s72 * s72) + (s76 * s76))
    s81 = s80*(np.asin(radius/np.sqrt((cx * cx) + (cy * cy) + (cz * cz))) - np.arctan2(s11, s14))
    s82 = s72*s80
    s83 = s76*s80
    out = np.zeros((3, *sight.shape[1:]))
    out[0] = s81
    out[1] = s82
    out[2] = s83
    return out


def tangent(along, side, radius):
    """Return factors of a ball's centre, along and in depth, and what their sum is (3, ...)."""
    s0 = along*side
    s4 = radius*np.sqrt((along * along) + 1)
    out = np.zeros((3, *along.shape))
    out[0] = -side
    out[1] = s0
    out[2] = s4
    return out

"""Generalised loads of `delta`: Delta, three arms and six rods.

Generated from derive/mechanisms/delta.py by "deltacal kernels". Do not edit.
Template templates/mechanism/statics.py.jinja; sha256 of both ee9027167b6aa7a1; SymPy 1.14.0.

Plain NumPy over all poses at once. masses: proximal proximal_com distal_rod platform; payload (N,) in kg at the
reference point; gravity (3,) in m/s^2; loads in N (along lengths) and N mm (along angles).
"""

import numpy as np


def _limb(x, q, tool, p, masses, gravity):
    """Generalised loads of one limb's weights: on its joint, on the platform: (N, 7)."""
    cx = x[:, 3]
    cy = x[:, 4]
    cz = x[:, 5]
    tx = tool[:, 0]
    ty = tool[:, 1]
    tz = tool[:, 2]
    q = q
    gx = gravity[0]
    gy = gravity[1]
    gz = gravity[2]
    proximal = masses[0]
    proximal_com = masses[1]
    distal_rod = masses[2]
    a = p[:, 1]
    L = p[:, 2]
    phi = p[:, 5]
    theta = p[:, 6]
    dL = p[:, 10]
    alpha0 = p[:, 11]
    beta0 = p[:, 12]
    tip_v = p[:, 20]
    s0 = (beta0 * beta0)
    s1 = (alpha0 * alpha0)
    s2 = s0 + s1
    s10 = s2*(s2*(s2*(1.5619206968586225e-16*s0 + 1.5619206968586225e-16*s1 - 4.779477332387385e-14) + 1.1470745597729725e-11) - 2.08767569878681e-09)
    s18 = s2*(s2*(s2*(s2*(s10 + 2.755731922398589e-07) - 2.48015873015873e-05) + 0.001388888888888889) - 0.041666666666666664)
    s19 = s18 + 0.5
    s21 = -s0*s19 + 1
    s22 = np.cos(phi)
    s31 = s2*(s2*(s2*(2.8114572543455206e-15*s0 + 2.8114572543455206e-15*s1 - 7.647163731819816e-13) + 1.6059043836821613e-10) - 2.505210838544172e-08)
    s39 = s2*(s2*(s2*(s2*(s31 + 2.7557319223985893e-06) - 0.0001984126984126984) + 0.008333333333333333) - 0.16666666666666666)
    s40 = s39 + 1
    s41 = np.sin(phi)
    R0_11 = -beta0*s40*s41 + s21*s22
    R0_12 = alpha0*beta0*s19*s22 + alpha0*s40*s41
    R0_21 = beta0*s22*s40 + s21*s41
    R0_22 = alpha0*beta0*s19*s41 - alpha0*s22*s40
    R0_31 = alpha0*beta0*s19
    R0_32 = -s1*s19 + 1
    s163 = q + theta
    s184 = (cx * cx)
    s186 = (cy * cy)
    s188 = (cz * cz)
    s190 = 0.25*s184 + 0.25*s186 + 0.25*s188 + 1
    s191 = (1.0 / s190)
    s192 = -0.5*s186
    s193 = -0.5*s188
    s197 = 0.5*cx*cy
    s200 = 0.5*cx*cz
    s205 = -0.5*s184
    s209 = 0.5*cy*cz
    s219 = L + dL
    s233 = a*s22 - tx
    s236 = a*s41 - ty
    s305 = 2*distal_rod
    s308 = 0.5*gz*s305
    s311 = 0.5*gy*s305
    s314 = 0.5*gx*s305
    s317 = proximal_com*s219
    s334 = -s308*tz
    s336 = s236*s308
    s338 = s233*s308
    s340 = -s311*tz
    s342 = s236*s311
    s344 = s233*s311
    s346 = -s314*tz
    s348 = s236*s314
    s353 = s233*s314
    s360 = s308*tip_v
    s366 = s311*tip_v
    s372 = s314*tip_v
    s378 = s191*s334
    s380 = s191*s336
    s381 = s338*(-cy + s200)
    s382 = s191*s338
    s383 = s340*(-cx + s209)
    s384 = s191*s340
    s385 = s380 + s384
    s386 = 0.5*cz
    s387 = 0.5*cy
    s390 = s342*(s193 + s205)
    s391 = s191*s342
    s394 = s344*(cz + s197)
    s395 = s191*s344
    s396 = s346*(cy + s200)
    s397 = s191*s346
    s398 = s382 + s397
    s399 = 0.5*cx
    s402 = s348*(-cz + s197)
    s403 = s191*s348
    s404 = s395 + s403
    s407 = s353*(s192 + s193)
    s408 = s191*s353
    s413 = s334*(s192 + s205) + s336*(cx + s209) + s381 + s383 + s390 + s394 + s396 + s402 + s407
    s416 = -0.25*s413/(s190 * s190)
    s430 = gz*proximal*s317 + s219*s308
    s439 = gy*proximal*s317 + s219*s311
    s448 = gx*proximal*s317 + s219*s314
    s451 = -R0_11*s372 + R0_12*s448 - R0_21*s366 + R0_22*s439 - R0_31*s360 + R0_32*s430
    s455 = R0_11*s448 + R0_12*s372 + R0_21*s439 + R0_22*s366 + R0_31*s430 + R0_32*s360
    s457 = s451*np.cos(s163) - s455*np.sin(s163)
    s581 = 2*cx*(-0.5*s378 - 0.5*s391 + s416) + s380 - s384 + s386*s398 + s387*s404
    s582 = 2*cy*(-0.5*s378 - 0.5*s408 + s416) - s382 + s385*s386 + s397 + s399*s404
    s583 = 2*cz*(-0.5*s391 - 0.5*s408 + s416) + s385*s387 + s395 + s398*s399 - s403
    out = np.zeros((len(x), 7))
    out[:, 0] = s457
    out[:, 1] = s314
    out[:, 2] = s311
    out[:, 3] = s308
    out[:, 4] = s581
    out[:, 5] = s582
    out[:, 6] = s583
    return out


def _platform(x, tool, masses, payload, gravity):
    """Generalised loads of the platform's weight and of the payload: (N, 6)."""
    cx = x[:, 3]
    cy = x[:, 4]
    cz = x[:, 5]
    tx = tool[:, 0]
    ty = tool[:, 1]
    tz = tool[:, 2]
    payload = payload
    gx = gravity[0]
    gy = gravity[1]
    gz = gravity[2]
    platform = masses[3]
    s184 = (cx * cx)
    s186 = (cy * cy)
    s188 = (cz * cz)
    s190 = 0.25*s184 + 0.25*s186 + 0.25*s188 + 1
    s191 = (1.0 / s190)
    s192 = -0.5*s186
    s193 = -0.5*s188
    s197 = 0.5*cx*cy
    s200 = 0.5*cx*cz
    s205 = -0.5*s184
    s209 = 0.5*cy*cz
    s386 = 0.5*cz
    s387 = 0.5*cy
    s399 = 0.5*cx
    s609 = gz*platform
    s610 = -s609*ty
    s612 = -s609*tx
    s615 = gy*platform
    s616 = -s615*ty
    s618 = -s615*tx
    s621 = gx*platform
    s622 = -s621*ty
    s624 = -s621*tx
    s632 = -s609*tz
    s634 = -s615*tz
    s636 = -s621*tz
    s639 = s191*s632
    s641 = s191*s610
    s642 = s612*(-cy + s200)
    s643 = s191*s612
    s644 = s634*(-cx + s209)
    s645 = s191*s634
    s646 = s641 + s645
    s649 = s616*(s193 + s205)
    s650 = s191*s616
    s653 = s618*(cz + s197)
    s654 = s191*s618
    s655 = s636*(cy + s200)
    s656 = s191*s636
    s657 = s643 + s656
    s660 = s622*(-cz + s197)
    s661 = s191*s622
    s662 = s654 + s661
    s665 = s624*(s192 + s193)
    s666 = s191*s624
    s671 = s610*(cx + s209) + s632*(s192 + s205) + s642 + s644 + s649 + s653 + s655 + s660 + s665
    s673 = -0.25*s671/(s190 * s190)
    s681 = gz*payload + s609
    s685 = gy*payload + s615
    s687 = gx*payload + s621
    s689 = 2*cx*(-0.5*s639 - 0.5*s650 + s673) + s386*s657 + s387*s662 + s641 - s645
    s690 = 2*cy*(-0.5*s639 - 0.5*s666 + s673) + s386*s646 + s399*s662 - s643 + s656
    s691 = 2*cz*(-0.5*s650 - 0.5*s666 + s673) + s387*s646 + s399*s657 + s654 - s661
    out = np.zeros((len(x), 6))
    out[:, 0] = s687
    out[:, 1] = s685
    out[:, 2] = s681
    out[:, 3] = s689
    out[:, 4] = s690
    out[:, 5] = s691
    return out


def loads(x, q, tool, p, masses, payload, gravity):
    """Return the generalised loads W_q (N, 3) on the joints and W_x (N, 6) on the platform."""
    W_q = np.zeros((len(x), 3))
    W_x = _platform(x, tool, masses, payload, gravity)
    for i in range(3):
        own = _limb(x, q[:, i], tool, p[:, i], masses, gravity)
        W_q[:, i] = own[:, 0]
        W_x += own[:, 1:]
    return W_q, W_x

"""Generalised loads of `delta`: Delta, three arms and six rods, row by row for Numba.

Generated from derive/mechanisms/delta.py by "deltacal kernels". Do not edit.
Template templates/rows.py.jinja; sha256 of both c1c307846330d03c; SymPy 1.14.0.

Functions of the NumPy module of this name, to be called likewise but for defaults, on C-contiguous arrays. Each is a
loop over rows; an array of one row counts for all of them.
"""

import math

import numpy as np

from deltacal_kernels.cache import kernel
from deltacal_kernels.elementary import cosine, sine
from deltacal_kernels.straight import straight

# of the arrays that each takes
DIMENSIONS = {"limb": (2, 1, 2, 2, 1, 2), "limb_points": (2, 1, 2, 2, 1), "platform": (2, 2, 1, 1, 2), "platform_points": (2, 2, 1, 2)}

fast = kernel(nogil=True, error_model="numpy", fastmath={"contract"})


@straight
def _limb(x, q, tool, p, masses, fields, x_every, q_every, tool_every, p_every, fields_every, out, many):
    """385 operations a row."""
    for lane in range(many):
        px = x[x_every * lane + 0]
        py = x[x_every * lane + 1]
        pz = x[x_every * lane + 2]
        cx = x[x_every * lane + 3]
        cy = x[x_every * lane + 4]
        cz = x[x_every * lane + 5]
        tx = tool[tool_every * lane + 0]
        ty = tool[tool_every * lane + 1]
        tz = tool[tool_every * lane + 2]
        q_here = q[q_every * lane]
        proximal = masses[0]
        proximal_com = masses[1]
        distal_rod = masses[2]
        b = p[p_every * lane + 0]
        a = p[p_every * lane + 1]
        L = p[p_every * lane + 2]
        phi = p[p_every * lane + 5]
        theta = p[p_every * lane + 6]
        ex = p[p_every * lane + 7]
        ey = p[p_every * lane + 8]
        ez = p[p_every * lane + 9]
        dL = p[p_every * lane + 10]
        alpha0 = p[p_every * lane + 11]
        beta0 = p[p_every * lane + 12]
        tip_v = p[p_every * lane + 20]
        tip_w = p[p_every * lane + 21]
        f0x = fields[fields_every * lane + 0]
        f0y = fields[fields_every * lane + 1]
        f0z = fields[fields_every * lane + 2]
        f1x = fields[fields_every * lane + 3]
        f1y = fields[fields_every * lane + 4]
        f1z = fields[fields_every * lane + 5]
        f2x = fields[fields_every * lane + 6]
        f2y = fields[fields_every * lane + 7]
        f2z = fields[fields_every * lane + 8]
        s0 = (beta0 * beta0)
        s1 = (alpha0 * alpha0)
        s2 = s0 + s1
        s10 = s2*(s2*(s2*(1.5619206968586225e-16*s0 + 1.5619206968586225e-16*s1 - 4.779477332387385e-14) + 1.1470745597729725e-11) - 2.08767569878681e-09)
        s18 = s2*(s2*(s2*(s2*(s10 + 2.755731922398589e-07) - 2.48015873015873e-05) + 0.001388888888888889) - 0.041666666666666664)
        s19 = s18 + 0.5
        s20 = -s0*s19
        s21 = s20 + 1
        s22 = cosine(phi)
        s31 = s2*(s2*(s2*(2.8114572543455206e-15*s0 + 2.8114572543455206e-15*s1 - 7.647163731819816e-13) + 1.6059043836821613e-10) - 2.505210838544172e-08)
        s39 = s2*(s2*(s2*(s2*(s31 + 2.7557319223985893e-06) - 0.0001984126984126984) + 0.008333333333333333) - 0.16666666666666666)
        s40 = s39 + 1
        s41 = sine(phi)
        s42 = -beta0*s40*s41
        R0_11 = s21*s22 + s42
        R0_12 = alpha0*beta0*s19*s22 + alpha0*s40*s41
        s47 = -s1*s19
        s48 = s20 + s47 + 1
        s50 = beta0*s22*s40
        R0_13 = s41*s48 + s50
        R0_21 = s21*s41 + s50
        R0_22 = alpha0*beta0*s19*s41 - alpha0*s22*s40
        R0_23 = -s22*s48 - s42
        R0_31 = alpha0*beta0*s19
        R0_32 = s47 + 1
        R0_33 = -alpha0*s40
        B_x = b*s22 + ex
        B_y = b*s41 + ey
        s163 = q_here + theta
        s164 = cosine(s163)
        s166 = sine(s163)
        R1_11 = R0_11*s164 + R0_12*s166
        R1_12 = -R0_11*s166 + R0_12*s164
        R1_21 = R0_21*s164 + R0_22*s166
        R1_22 = -R0_21*s166 + R0_22*s164
        R1_31 = R0_31*s164 + R0_32*s166
        R1_32 = -R0_31*s166 + R0_32*s164
        s184 = (cx * cx)
        s186 = (cy * cy)
        s188 = (cz * cz)
        s190 = 0.25*s184 + 0.25*s186 + 0.25*s188 + 1
        s191 = (1.0 / s190)
        s192 = -0.5*s186
        s193 = -0.5*s188
        s194 = s192 + s193
        R_11 = s191*s194 + 1
        s197 = 0.5*cx*cy
        s198 = -cz + s197
        R_12 = s191*s198
        s200 = 0.5*cx*cz
        s201 = cy + s200
        R_13 = s191*s201
        s203 = cz + s197
        R_21 = s191*s203
        s205 = -0.5*s184
        s206 = s193 + s205
        R_22 = s191*s206 + 1
        s209 = 0.5*cy*cz
        s210 = -cx + s209
        R_23 = s191*s210
        s212 = -cy + s200
        R_31 = s191*s212
        s214 = cx + s209
        R_32 = s191*s214
        s216 = s192 + s205
        R_33 = s191*s216 + 1
        s219 = L + dL
        C_x = B_x + R0_13*tip_w + R1_11*s219 + R1_12*tip_v
        C_y = B_y + R0_23*tip_w + R1_21*s219 + R1_22*tip_v
        C_z = R0_33*tip_w + R1_31*s219 + R1_32*tip_v + ez
        s233 = a*s22 - tx
        s236 = a*s41 - ty
        A_x = R_11*s233 + R_12*s236 - R_13*tz + px
        A_y = R_21*s233 + R_22*s236 - R_23*tz + py
        A_z = R_31*s233 + R_32*s236 - R_33*tz + pz
        s289 = B_x + R1_11*proximal_com*s219
        s292 = B_y + R1_21*proximal_com*s219
        s295 = R1_31*proximal_com*s219 + ez
        s302 = proximal_com*s219
        s319 = distal_rod*f1z
        s321 = distal_rod*f1y
        s323 = distal_rod*f1x
        s325 = distal_rod*f2z
        s327 = distal_rod*f2y
        s329 = distal_rod*f2x
        s331 = -s325*tz
        s333 = s236*s325
        s335 = s233*s325
        s337 = -s327*tz
        s339 = s236*s327
        s341 = s233*s327
        s343 = -s329*tz
        s345 = s236*s329
        s350 = s233*s329
        s357 = s319*tip_v
        s363 = s321*tip_v
        s369 = s323*tip_v
        s375 = s191*s331
        s377 = s191*s333
        s379 = s191*s335
        s381 = s191*s337
        s382 = s377 + s381
        s383 = 0.5*cz
        s384 = 0.5*cy
        s387 = s206*s339
        s388 = s191*s339
        s391 = s203*s341
        s392 = s191*s341
        s393 = s201*s343
        s394 = s191*s343
        s395 = s379 + s394
        s396 = 0.5*cx
        s399 = s198*s345
        s400 = s191*s345
        s401 = s392 + s400
        s404 = s194*s350
        s405 = s191*s350
        s410 = s210*s337 + s212*s335 + s214*s333 + s216*s331 + s387 + s391 + s393 + s399 + s404
        s413 = -0.25*s410/(s190 * s190)
        s427 = f0z*proximal*s302 + s219*s319
        s436 = f0y*proximal*s302 + s219*s321
        s445 = f0x*proximal*s302 + s219*s323
        s449 = s164*(-R0_11*s369 + R0_12*s445 - R0_21*s363 + R0_22*s436 - R0_31*s357 + R0_32*s427)
        s452 = R0_11*s445 + R0_12*s369 + R0_21*s436 + R0_22*s363 + R0_31*s427 + R0_32*s357
        s454 = -s166*s452 + s449
        s576 = 2*cx*(-0.5*s375 - 0.5*s388 + s413) + s377 - s381 + s383*s395 + s384*s401
        s577 = 2*cy*(-0.5*s375 - 0.5*s405 + s413) - s379 + s382*s383 + s394 + s396*s401
        s578 = 2*cz*(-0.5*s388 - 0.5*s405 + s413) + s382*s384 + s392 + s395*s396 - s400
        s594 = proximal*(-f0y*s295 + f0z*s292)
        s595 = distal_rod*(A_y*f2z - A_z*f2y) + distal_rod*(C_y*f1z - C_z*f1y) + s594
        s607 = proximal*(f0x*s295 - f0z*s289)
        s608 = distal_rod*(-A_x*f2z + A_z*f2x) + distal_rod*(-C_x*f1z + C_z*f1x) + s607
        s620 = proximal*(-f0x*s292 + f0y*s289)
        s621 = distal_rod*(A_x*f2y - A_y*f2x) + distal_rod*(C_x*f1y - C_y*f1x) + s620
        out[10 * lane + 0] = s454
        out[10 * lane + 1] = s329
        out[10 * lane + 2] = s327
        out[10 * lane + 3] = s325
        out[10 * lane + 4] = s576
        out[10 * lane + 5] = s577
        out[10 * lane + 6] = s578
        out[10 * lane + 7] = s595
        out[10 * lane + 8] = s608
        out[10 * lane + 9] = s621


@fast
def limb(x, q, tool, p, masses, fields):
    """Return what the NumPy function of this name returns."""
    many = len(x)
    x_every = x.size // len(x) if len(x) > 1 else 0
    q_every = q.size // len(q) if len(q) > 1 else 0
    tool_every = tool.size // len(tool) if len(tool) > 1 else 0
    p_every = p.size // len(p) if len(p) > 1 else 0
    fields_every = fields.size // len(fields) if len(fields) > 1 else 0
    out = np.zeros((many, 10))
    _limb(x, q, tool, p, masses, fields, x_every, q_every, tool_every, p_every, fields_every, out, many)
    return out.reshape(many, 10)


@straight
def _limb_points(x, q, tool, p, masses, x_every, q_every, tool_every, p_every, out, many):
    """212 operations a row."""
    for lane in range(many):
        px = x[x_every * lane + 0]
        py = x[x_every * lane + 1]
        pz = x[x_every * lane + 2]
        cx = x[x_every * lane + 3]
        cy = x[x_every * lane + 4]
        cz = x[x_every * lane + 5]
        tx = tool[tool_every * lane + 0]
        ty = tool[tool_every * lane + 1]
        tz = tool[tool_every * lane + 2]
        q_here = q[q_every * lane]
        proximal_com = masses[1]
        b = p[p_every * lane + 0]
        a = p[p_every * lane + 1]
        L = p[p_every * lane + 2]
        phi = p[p_every * lane + 5]
        theta = p[p_every * lane + 6]
        ex = p[p_every * lane + 7]
        ey = p[p_every * lane + 8]
        ez = p[p_every * lane + 9]
        dL = p[p_every * lane + 10]
        alpha0 = p[p_every * lane + 11]
        beta0 = p[p_every * lane + 12]
        tip_v = p[p_every * lane + 20]
        tip_w = p[p_every * lane + 21]
        s0 = (beta0 * beta0)
        s1 = (alpha0 * alpha0)
        s2 = s0 + s1
        s10 = s2*(s2*(s2*(1.5619206968586225e-16*s0 + 1.5619206968586225e-16*s1 - 4.779477332387385e-14) + 1.1470745597729725e-11) - 2.08767569878681e-09)
        s18 = s2*(s2*(s2*(s2*(s10 + 2.755731922398589e-07) - 2.48015873015873e-05) + 0.001388888888888889) - 0.041666666666666664)
        s19 = s18 + 0.5
        s20 = -s0*s19
        s21 = s20 + 1
        s22 = cosine(phi)
        s31 = s2*(s2*(s2*(2.8114572543455206e-15*s0 + 2.8114572543455206e-15*s1 - 7.647163731819816e-13) + 1.6059043836821613e-10) - 2.505210838544172e-08)
        s39 = s2*(s2*(s2*(s2*(s31 + 2.7557319223985893e-06) - 0.0001984126984126984) + 0.008333333333333333) - 0.16666666666666666)
        s40 = s39 + 1
        s41 = sine(phi)
        s42 = -beta0*s40*s41
        R0_11 = s21*s22 + s42
        R0_12 = alpha0*beta0*s19*s22 + alpha0*s40*s41
        s47 = -s1*s19
        s48 = s20 + s47 + 1
        s50 = beta0*s22*s40
        R0_13 = s41*s48 + s50
        R0_21 = s21*s41 + s50
        R0_22 = alpha0*beta0*s19*s41 - alpha0*s22*s40
        R0_23 = -s22*s48 - s42
        R0_31 = alpha0*beta0*s19
        R0_32 = s47 + 1
        R0_33 = -alpha0*s40
        B_x = b*s22 + ex
        B_y = b*s41 + ey
        s163 = q_here + theta
        s164 = cosine(s163)
        s166 = sine(s163)
        R1_11 = R0_11*s164 + R0_12*s166
        R1_12 = -R0_11*s166 + R0_12*s164
        R1_21 = R0_21*s164 + R0_22*s166
        R1_22 = -R0_21*s166 + R0_22*s164
        R1_31 = R0_31*s164 + R0_32*s166
        R1_32 = -R0_31*s166 + R0_32*s164
        s184 = (cx * cx)
        s186 = (cy * cy)
        s188 = (cz * cz)
        s191 = (1.0 / (0.25*s184 + 0.25*s186 + 0.25*s188 + 1))
        s192 = -0.5*s186
        s193 = -0.5*s188
        R_11 = s191*(s192 + s193) + 1
        s197 = 0.5*cx*cy
        R_12 = s191*(-cz + s197)
        s200 = 0.5*cx*cz
        R_13 = s191*(cy + s200)
        R_21 = s191*(cz + s197)
        s205 = -0.5*s184
        R_22 = s191*(s193 + s205) + 1
        s209 = 0.5*cy*cz
        R_23 = s191*(-cx + s209)
        R_31 = s191*(-cy + s200)
        R_32 = s191*(cx + s209)
        R_33 = s191*(s192 + s205) + 1
        s219 = L + dL
        C_x = B_x + R0_13*tip_w + R1_11*s219 + R1_12*tip_v
        C_y = B_y + R0_23*tip_w + R1_21*s219 + R1_22*tip_v
        C_z = R0_33*tip_w + R1_31*s219 + R1_32*tip_v + ez
        s233 = a*s22 - tx
        s236 = a*s41 - ty
        A_x = R_11*s233 + R_12*s236 - R_13*tz + px
        A_y = R_21*s233 + R_22*s236 - R_23*tz + py
        A_z = R_31*s233 + R_32*s236 - R_33*tz + pz
        s289 = B_x + R1_11*proximal_com*s219
        s292 = B_y + R1_21*proximal_com*s219
        s295 = R1_31*proximal_com*s219 + ez
        out[9 * lane + 0] = s289
        out[9 * lane + 1] = s292
        out[9 * lane + 2] = s295
        out[9 * lane + 3] = C_x
        out[9 * lane + 4] = C_y
        out[9 * lane + 5] = C_z
        out[9 * lane + 6] = A_x
        out[9 * lane + 7] = A_y
        out[9 * lane + 8] = A_z


@fast
def limb_points(x, q, tool, p, masses):
    """Return what the NumPy function of this name returns."""
    many = len(x)
    x_every = x.size // len(x) if len(x) > 1 else 0
    q_every = q.size // len(q) if len(q) > 1 else 0
    tool_every = tool.size // len(tool) if len(tool) > 1 else 0
    p_every = p.size // len(p) if len(p) > 1 else 0
    out = np.zeros((many, 9))
    _limb_points(x, q, tool, p, masses, x_every, q_every, tool_every, p_every, out, many)
    return out.reshape(many, 9)


@straight
def _platform(x, tool, masses, payload, fields, x_every, tool_every, payload_every, fields_every, out, many):
    """187 operations a row."""
    for lane in range(many):
        px = x[x_every * lane + 0]
        py = x[x_every * lane + 1]
        pz = x[x_every * lane + 2]
        cx = x[x_every * lane + 3]
        cy = x[x_every * lane + 4]
        cz = x[x_every * lane + 5]
        tx = tool[tool_every * lane + 0]
        ty = tool[tool_every * lane + 1]
        tz = tool[tool_every * lane + 2]
        payload_here = payload[payload_every * lane]
        platform = masses[3]
        f0x = fields[fields_every * lane + 0]
        f0y = fields[fields_every * lane + 1]
        f0z = fields[fields_every * lane + 2]
        f1x = fields[fields_every * lane + 3]
        f1y = fields[fields_every * lane + 4]
        f1z = fields[fields_every * lane + 5]
        s184 = (cx * cx)
        s186 = (cy * cy)
        s188 = (cz * cz)
        s190 = 0.25*s184 + 0.25*s186 + 0.25*s188 + 1
        s191 = (1.0 / s190)
        s192 = -0.5*s186
        s193 = -0.5*s188
        s194 = s192 + s193
        R_11 = s191*s194 + 1
        s197 = 0.5*cx*cy
        s198 = -cz + s197
        R_12 = s191*s198
        s200 = 0.5*cx*cz
        s201 = cy + s200
        R_13 = s191*s201
        s203 = cz + s197
        R_21 = s191*s203
        s205 = -0.5*s184
        s206 = s193 + s205
        R_22 = s191*s206 + 1
        s209 = 0.5*cy*cz
        s210 = -cx + s209
        R_23 = s191*s210
        s212 = -cy + s200
        R_31 = s191*s212
        s214 = cx + s209
        R_32 = s191*s214
        s216 = s192 + s205
        R_33 = s191*s216 + 1
        s285 = -R_11*tx - R_12*ty - R_13*tz + px
        s289 = -R_21*tx - R_22*ty - R_23*tz + py
        s293 = -R_31*tx - R_32*ty - R_33*tz + pz
        s299 = f0z*platform
        s300 = -s299*ty
        s302 = -s299*tx
        s305 = f0y*platform
        s306 = -s305*ty
        s308 = -s305*tx
        s311 = f0x*platform
        s312 = -s311*ty
        s314 = -s311*tx
        s322 = -s299*tz
        s324 = -s305*tz
        s326 = -s311*tz
        s329 = s191*s322
        s331 = s191*s300
        s333 = s191*s302
        s335 = s191*s324
        s336 = s331 + s335
        s337 = 0.5*cz
        s338 = 0.5*cy
        s341 = s206*s306
        s342 = s191*s306
        s345 = s203*s308
        s346 = s191*s308
        s347 = s201*s326
        s348 = s191*s326
        s349 = s333 + s348
        s350 = 0.5*cx
        s353 = s198*s312
        s354 = s191*s312
        s355 = s346 + s354
        s358 = s194*s314
        s359 = s191*s314
        s364 = s210*s324 + s212*s302 + s214*s300 + s216*s322 + s341 + s345 + s347 + s353 + s358
        s367 = -0.25*s364/(s190 * s190)
        s377 = f1z*payload_here + s299
        s380 = f1y*payload_here + s305
        s381 = f1x*payload_here + s311
        s383 = 2*cx*(-0.5*s329 - 0.5*s342 + s367) + s331 - s335 + s337*s349 + s338*s355
        s384 = 2*cy*(-0.5*s329 - 0.5*s359 + s367) - s333 + s336*s337 + s348 + s350*s355
        s385 = 2*cz*(-0.5*s342 - 0.5*s359 + s367) + s336*s338 + s346 + s349*s350 - s354
        s394 = payload_here*(-f1y*pz + f1z*py) + platform*(-f0y*s293 + f0z*s289)
        s403 = payload_here*(f1x*pz - f1z*px) + platform*(f0x*s293 - f0z*s285)
        s412 = payload_here*(-f1x*py + f1y*px) + platform*(-f0x*s289 + f0y*s285)
        out[9 * lane + 0] = s381
        out[9 * lane + 1] = s380
        out[9 * lane + 2] = s377
        out[9 * lane + 3] = s383
        out[9 * lane + 4] = s384
        out[9 * lane + 5] = s385
        out[9 * lane + 6] = s394
        out[9 * lane + 7] = s403
        out[9 * lane + 8] = s412


@fast
def platform(x, tool, masses, payload, fields):
    """Return what the NumPy function of this name returns."""
    many = len(x)
    x_every = x.size // len(x) if len(x) > 1 else 0
    tool_every = tool.size // len(tool) if len(tool) > 1 else 0
    payload_every = payload.size // len(payload) if len(payload) > 1 else 0
    fields_every = fields.size // len(fields) if len(fields) > 1 else 0
    out = np.zeros((many, 9))
    _platform(x, tool, masses, payload, fields, x_every, tool_every, payload_every, fields_every, out, many)
    return out.reshape(many, 9)


@straight
def _platform_points(x, tool, masses, payload, x_every, tool_every, payload_every, out, many):
    """61 operations a row."""
    for lane in range(many):
        px = x[x_every * lane + 0]
        py = x[x_every * lane + 1]
        pz = x[x_every * lane + 2]
        cx = x[x_every * lane + 3]
        cy = x[x_every * lane + 4]
        cz = x[x_every * lane + 5]
        tx = tool[tool_every * lane + 0]
        ty = tool[tool_every * lane + 1]
        tz = tool[tool_every * lane + 2]
        s184 = (cx * cx)
        s186 = (cy * cy)
        s188 = (cz * cz)
        s191 = (1.0 / (0.25*s184 + 0.25*s186 + 0.25*s188 + 1))
        s192 = -0.5*s186
        s193 = -0.5*s188
        R_11 = s191*(s192 + s193) + 1
        s197 = 0.5*cx*cy
        R_12 = s191*(-cz + s197)
        s200 = 0.5*cx*cz
        R_13 = s191*(cy + s200)
        R_21 = s191*(cz + s197)
        s205 = -0.5*s184
        R_22 = s191*(s193 + s205) + 1
        s209 = 0.5*cy*cz
        R_23 = s191*(-cx + s209)
        R_31 = s191*(-cy + s200)
        R_32 = s191*(cx + s209)
        R_33 = s191*(s192 + s205) + 1
        s285 = -R_11*tx - R_12*ty - R_13*tz + px
        s289 = -R_21*tx - R_22*ty - R_23*tz + py
        s293 = -R_31*tx - R_32*ty - R_33*tz + pz
        out[6 * lane + 0] = s285
        out[6 * lane + 1] = s289
        out[6 * lane + 2] = s293
        out[6 * lane + 3] = px
        out[6 * lane + 4] = py
        out[6 * lane + 5] = pz


@fast
def platform_points(x, tool, masses, payload):
    """Return what the NumPy function of this name returns."""
    many = len(x)
    x_every = x.size // len(x) if len(x) > 1 else 0
    tool_every = tool.size // len(tool) if len(tool) > 1 else 0
    payload_every = payload.size // len(payload) if len(payload) > 1 else 0
    out = np.zeros((many, 6))
    _platform_points(x, tool, masses, payload, x_every, tool_every, payload_every, out, many)
    return out.reshape(many, 6)

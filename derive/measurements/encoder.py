"""A second encoder on a joint itself, behind its gearbox: ``y = sign (theta + zero)``.

It sees what the geometry sees, play, windings and eccentricities of the transmission included, from a zero of its own.
"""

from __future__ import annotations

import sympy as sp

from derive.spec import Joint, Measurement, Quantity
from derive.vectors import Algebra

theta, sign, zero, dzero, turns = sp.symbols("theta sign zero dzero turns", real=True)


def measurement(v: Algebra) -> Measurement:
    """Return the kind of measurement; nothing in it turns."""
    return Measurement(
        name="encoder",
        meaning="joint as a second encoder on it counts [mm, rad]",
        source="derive/measurements/encoder.py",
        platforms=(Joint(theta),),
        given=(
            Quantity(sign, "1", "1, or -1 where the controller counts against the geometry"),
            Quantity(zero, "rad", "zero of the encoder"),
            Quantity(turns, "1", "1 where the joint turns, 0 where it slides and a zero counts in mm"),
        ),
        unknown=(Quantity(dzero, "rad", "zero of the encoder", typical=0.05, label="enc_zero"),),
        reading=(sign * (theta + zero + dzero),),
        after=(sign, zero + dzero, turns),
        columns=("enc{i}_{unit}",),
        start=(1.0, 0.0, 1.0),
        scale=100.0,
    )

"""The calibrated machine of Traslosheros et al. 2013, and points of its workspace."""

from __future__ import annotations

import numpy as np

from tests.claims import independent_traslosheros as own
from tests.claims.independent_traslosheros import CALIBRATED

RNG_POINTS = 300
NOISE = np.array([0.0025, 0.0049, 0.0212])  # Table 3, standard deviations [mm]
TRUE = own.closed(CALIBRATED)  # the calibrated limbs; the home position is where they put it
POINTS = own.workspace_points(RNG_POINTS, np.random.default_rng(0))

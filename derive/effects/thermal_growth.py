"""Links and base grow with temperature: each length times ``1 + expansion (T - 20)``."""

import sympy as sp

from derive.effects import coefficient, state
from derive.spec import Effect

warming, L, l, b, phi = state("warming L l b phi")
proximal = coefficient("expansion_proximal", "1/K", 1.0, "expansion of the arms")
distal = coefficient("expansion_distal", "1/K", 1.0, "expansion of the rods")
base = coefficient("expansion_base", "1/K", 1.0, "expansion of the base")
EFFECT = Effect(
    name="thermal_growth",
    title="links and base grow with temperature",
    source="derive/effects/thermal_growth.py",
    per_limb=False,
    coefficients=(proximal, distal, base),
    targets={
        "error.L": L * proximal.symbol * warming,
        "error.l": l * distal.symbol * warming,
        "error.ex": b * sp.cos(phi) * base.symbol * warming,
        "error.ey": b * sp.sin(phi) * base.symbol * warming,
    },
)

"""Links and base grow with temperature: each length times ``1 + expansion (T - 20)``."""

from derive.effects import coefficient, state
from derive.spec import Effect

warming, L, l, b = state("warming L l b")
proximal = coefficient("expansion_proximal", "1/K", 1.0, "expansion of the arms")
distal = coefficient("expansion_distal", "1/K", 1.0, "expansion of the rods")
base = coefficient("expansion_base", "1/K", 1.0, "expansion of the base")
EFFECT = Effect(
    name="thermal_growth",
    title="links and base grow with temperature",
    advice="Measure and work at one temperature, or command by the temperature of the links.",
    source="derive/effects/thermal_growth.py",
    per_limb=False,
    coefficients=(proximal, distal, base),
    targets={
        "limb.arm": L * proximal.symbol * warming,
        "limb.rod": l * distal.symbol * warming,
        "limb.outwards": b * base.symbol * warming,
    },
)

"""Links and base grow with temperature: each length times ``1 + expansion (T - 20)``."""

from derive.effects import coefficient, state
from derive.language.effects import Effect, Reference

warming, L, l, b = state("warming L l b")
proximal = coefficient("expansion_proximal", "1/K", 1.0, "expansion of the arms, or of a chain's links", (-1e-5, 1e-4))
distal = coefficient("expansion_distal", "1/K", 1.0, "expansion of the rods", (-1e-5, 1e-4))
base = coefficient("expansion_base", "1/K", 1.0, "expansion of the base", (-1e-5, 1e-4))
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
    tests=(
        Reference(
            {"warming": 10.0, "L": 375.0, "l": 950.0, "b": 200.0},
            {"expansion_proximal": 1.2e-5, "expansion_distal": 1e-6, "expansion_base": 2.4e-5},
            {"limb.arm": 0.045, "limb.rod": 0.0095, "limb.outwards": 0.048},
        ),
    ),
)

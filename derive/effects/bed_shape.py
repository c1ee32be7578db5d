"""The probed bed is not flat: its height over the plane is a polynomial of x and y over the machine's radius.

A nozzle at the height z stands at ``z - bed(x, y)`` above the bed.
"""

from derive.effects import coefficient, state
from derive.language.effects import Effect, Reference

ORDER = 3
x, y, b = state("x y b")
powers = [(n - j, j) for n in range(1, ORDER + 1) for j in range(n + 1)]
terms = {
    coefficient(
        "x" * i + "y" * j, "mm", 1.0, f"height of the bed along x^{i} y^{j}, at the machine's radius", (-5.0, 5.0)
    ): (i, j)
    for i, j in powers
}
flat = dict.fromkeys((c.name for c in terms), 0.0)
EFFECT = Effect(
    name="bed_shape",
    title="the bed is not flat",
    source="derive/effects/bed_shape.py",
    advice="Use a flatter bed, or print with a bed mesh; the geometry must not take it over.",
    per_limb=False,
    coefficients=tuple(terms),
    targets={"height": -sum(c.symbol * (x / b) ** i * (y / b) ** j for c, (i, j) in terms.items())},
    tests=(
        Reference({"x": 80.0, "y": -40.0, "b": 160.0}, flat | {"x": 0.2, "xx": 0.4}, {"height": -0.1 - 0.1}),
        Reference({"x": 80.0, "y": -40.0, "b": 160.0}, flat | {"xy": 0.8, "yyy": 1.6}, {"height": 0.1 + 0.025}),
    ),
)

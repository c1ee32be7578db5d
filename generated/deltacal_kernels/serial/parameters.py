"""Tables of `serial`: Open chain of revolute and prismatic joints.

Generated from derive/mechanisms/serial.py by "deltacal kernels". Do not edit.
Template templates/chain/parameters.py.jinja; sha256 of both 3586ac59660d1e00; SymPy 1.14.0.
Units: mm, rad, kg. Everything here belongs to one link; the robot file says how many there are.
"""

NAME = "serial"
TITLE = "Open chain of revolute and prismatic joints"
REFERENCE = "Denavit, Hartenberg 1955, J. Appl. Mech. 22; Craig 1986; Hayati 1983, IEEE CDC 22"
CHAIN = True
CONVENTIONS = ("standard", "modified", )

# (key of the joint's table in the robot file, unit, meaning): the first columns of a link's row of p
GEOMETRY = (
    ("a", "mm", "a: length of the link"),
    ("alpha", "rad", "alpha: twist"),
    ("d", "mm", "d: offset along the axis"),
    ("theta", "rad", "theta: added to the reading"),
)

# (name, unit, meaning, size of an ordinary error): the next columns, one source error each
ERRORS = (
    ("a", "mm", "length of the link", 0.3),
    ("alpha", "rad", "twist", 0.0017453292519943296),
    ("d", "mm", "offset along the axis", 0.3),
    ("theta", "rad", "zero of the joint", 0.0017453292519943296),
    ("beta", "rad", "turn about y between parallel axes", 0.0017453292519943296),
)

# the same, of the tool: the next columns, equal in every row
COMMON = (
    ("tx", "mm", "tool point, x of the last frame", 1.0),
    ("ty", "mm", "tool point, y of the last frame", 1.0),
    ("tz", "mm", "tool point, z of the last frame", 1.0),
)

"""A Delta robot in Exudyn, a multibody engine made by others: bodies, joints, springs, weights, and no formula of ours.

Three arms on revolute joints, six rods between ball joints, a platform. A rod is a distance constraint between its two
ends, with half its mass at either; an elastic rod is a spring there. An elastic joint is a
torsion spring between the motor's angle and the arm, an elastic arm a tip that slides on two springs normal to the arm
(it carries the rods' pull; their half masses at the elbow stay on the arm), an elastic frame a base on two torsion
springs about {O}. The pose is the engine's static equilibrium of all that under gravity.

What has no body (backlash, drift, harmonics, heat, latency) is put in as the motor's angle or a length, by the
definition of the effect. Three effects are defined by a torque that no single spring feels: the payload's alone, that
of inertia, and the absolute value of the torque. For these the engine's own joint reaction is read, with the loads in
question and nothing else, and the motor turned by the definition until nothing moves.

Nothing of `deltacal_gen` is imported here. In and out: mm, deg, kg, s, degC; inside: m, rad, N.

References
----------
Gerstmayr, J.: Exudyn - a C++-based Python package for flexible multibody systems. Multibody System Dynamics 60
(2024), 533-561.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

Array = np.ndarray
SETTLED = 1e-9  # rad: change of the motors' angles between two solutions
STEP_S = 1e-3  # of the second difference that gives the accelerations of the masses
SPRINGS = {"joint_compliance", "proximal_bending", "distal_compliance", "base_compliance"}
REACTIONS = {"payload_deflection", "inertial_deflection", "friction_windup"}


class NoEquilibriumError(RuntimeError):
    """The engine found no static equilibrium."""


@cache
def _exudyn() -> Any:
    import exudyn

    exudyn.config.suppressWarnings = True
    exudyn.SetWriteToConsole(False)
    return exudyn


def available() -> bool:
    """Tell whether the engine is installed (the extra `proof`)."""
    try:
        _exudyn()
    except ImportError:
        return False
    return True


def version() -> str:
    """Return the engine's name and version."""
    return f"Exudyn {_exudyn().__version__}"


@dataclass(frozen=True)
class Load:
    """Which weights pull at a machine: gravity [m/s^2], or minus the accelerations of the masses themselves."""

    gravity: Array | None = None
    fields: Array | None = None
    moments: Array | None = None  # N m, about the joints
    only_payload: bool = False


@dataclass
class Pose:
    """What the engine found: O' [m], the platform's rotation, where the masses are [m], torques at the joints [N m]."""

    origin: Array
    turn: Array
    points: Array
    torques: Array


@dataclass
class Delta:
    """A machine with its errors and effects.

    Parameters
    ----------
    robot : mapping
        The tables of a robot file.
    errors : mapping
        Source errors by name [mm, deg]: the table `parameters` of a TRUTH.toml.
    effects : sequence of mappings
        The tables `effects` of a TRUTH.toml: `name`, `limbs`, and the effect's parameters in the units of
        `deltacal effects`, one number or one for each limb.
    """

    robot: Mapping[str, Any]
    errors: Mapping[str, float]
    effects: Sequence[Mapping[str, Any]] = ()
    gravity: Array = field(init=False)

    def __post_init__(self) -> None:
        masses = self.robot.get("masses", {})
        self.gravity = np.array(masses.get("gravity", (0.0, 0.0, -9.81)), dtype=float)
        self.phi = np.deg2rad(self.robot.get("joints", {}).get("limb_angle_deg", (-90.0, 30.0, 150.0)))
        self._model = _Model(self)
        self._sign = np.array(self.robot.get("joints", {}).get("sign", (1.0, 1.0, 1.0)), dtype=float)

    def measured(self, joints: Array, tools: Array, channels: Mapping[str, Array], clock: Array) -> tuple[Array, Array]:
        """Return where the measured points are in {O} [mm], (N, 3), and the platform's rotations, (N, 3, 3).

        Parameters
        ----------
        joints : (N, 3) array
            As the controller reports them [deg].
        tools : (N, 3) array
            The measured points in {O'} [mm].
        channels : mapping of (N,) arrays
            As in a recording.
        clock : (N,) array
            What tells when a joint's zero jumps: time [s], or the number of the row.

        Raises
        ------
        NoEquilibriumError
            A pose cannot be reached, or the engine does not converge.
        """
        points, turns = np.empty((len(joints), 3)), np.empty((len(joints), 3, 3))
        for n, q in enumerate(joints):
            row = {name: float(values[n]) for name, values in channels.items()}
            tool = tools[n] + self._tool_error(tools[n])
            pose = self.pose(q, row, tool, float(clock[n]))
            points[n], turns[n] = 1000 * pose.origin + pose.turn @ tool, pose.turn
        return points, turns

    def pose(self, q: Array, row: Mapping[str, float], tool: Array, clock: float = 0.0) -> Pose:
        """Return the machine's equilibrium at joints q (3,) [deg] and one row's channels."""
        sizes = self._sizes(row)
        motors = self._motors(q, row, clock)
        payload = row.get("payload_kg", 0.0)
        if np.isnan(payload):
            payload = 0.0
        everything = Load(gravity=self.gravity)
        model = self._model.at(sizes, tool / 1000, payload)
        if not any(e["name"] in REACTIONS for e in self.effects):
            return model.solve(motors, everything)
        turned = motors
        for _ in range(20):
            pose = model.solve(turned, everything)
            wanted = motors + self._reaction(model, turned, pose, row)
            if np.abs(wanted - turned).max() < SETTLED:
                return pose
            turned = wanted
        raise NoEquilibriumError("the joints' reactions do not settle")

    # -------------------------------------------------------------------------------------- errors and definitions

    def error(self, name: str, limb: int) -> float:
        """Return a source error of a limb [mm, deg]."""
        return float(self.errors.get(f"{name}_{limb + 1}", 0.0))

    def values(self, name: str, parameter: str) -> Array:
        """Return an effect's parameter limb by limb (3,), zero where a limb has none."""
        out = np.zeros(3)
        for effect in self.effects:
            if effect["name"] == name:
                limbs = np.array(effect.get("limbs", (1, 2, 3))) - 1
                out[limbs] += effect.get(parameter, 0.0)
        return out

    def _sizes(self, row: Mapping[str, float]) -> dict[str, Array]:
        """Return the lengths of each limb [m] at a row's temperature."""
        g = {k: float(np.ravel(v)[0]) / 1000 for k, v in self.robot["geometry"].items() if k != "tool"}
        warm = row.get("temp_C", 20.0) - 20.0

        def length(key: str, error: str | None, expansion: str) -> Array:
            extra = np.array([self.error(error, i) / 1000 if error else 0.0 for i in range(3)])
            growth = self.values("thermal_growth", expansion)
            return (g[key] + extra) * (1 + growth * warm if growth.any() else 1)

        return {
            "b": length("base_radius", None, "expansion_base"),
            "L": length("proximal_length", "L", "expansion_proximal"),
            "l": length("distal_length", "l", "expansion_distal"),
            "a": np.full(3, g["platform_radius"]),
            "c": np.full(3, g["joint_spacing"]),
        }

    def _motors(self, q: Array, row: Mapping[str, float], clock: float) -> Array:
        """Return the angle of each motor [rad] by the definitions that need no load."""
        q = self._sign * q  # deg
        out = q.copy()

        def channel(pattern: str) -> Array:
            return self._sign * [row[pattern.format(i)] for i in (1, 2, 3)]

        for effect in self.effects:
            name = effect["name"]
            of = lambda p, name=name: self.values(name, p)  # noqa: E731
            if name == "transmission_eccentricity":
                k = of("order") * np.deg2rad(q)
                out += of("cos") * np.cos(k) + of("sin") * np.sin(k)
            elif name == "joint_scale":
                out += of("scale") * q
            elif name == "backlash":
                out -= channel("approach{}") * of("width") / 2
            elif name == "thermal_zero":
                out += of("drift") * (row["temp_C"] - 20)
            elif name == "zero_drift":
                out += of("rate") * row["time_s"] / 3600
            elif name == "zero_jump":
                out += np.where(clock >= of("when"), of("size"), 0.0)
            elif name == "latency":
                out += -of("delay") * channel("qd{}_deg_s")
                if "qdd1_deg_s2" in row:
                    out += of("delay") ** 2 / 2 * channel("qdd{}_deg_s2")
        return np.deg2rad(out)

    def _reaction(self, model: _Model, motors: Array, pose: Pose, row: Mapping[str, float]) -> Array:
        """Return by how much the joints turn [rad] under the engine's own reactions [N m], by definition."""
        out = np.zeros(3)
        for name in {e["name"] for e in self.effects} & REACTIONS:
            compliance = np.deg2rad(self.values(name, "compliance"))
            if name == "friction_windup":
                approach = self._sign * [row[f"approach{i}"] for i in (1, 2, 3)]
                out -= approach * compliance * np.abs(pose.torques)
            elif name == "payload_deflection":
                only = Load(gravity=self.gravity, only_payload=True)
                out += compliance * model.solve(motors, only).torques
            else:
                speed, acceleration = (
                    np.deg2rad(self._sign * [row.get(p.format(i), 0.0) for i in (1, 2, 3)])
                    for p in ("qd{}_deg_s", "qdd{}_deg_s2")
                )
                at = [
                    model.solve(motors + speed * t + acceleration * t**2 / 2, Load()).points
                    for t in (-STEP_S, 0.0, STEP_S)
                ]
                against = Load(
                    fields=-(at[0] - 2 * at[1] + at[2]) / STEP_S**2, moments=-model.arm_inertia * acceleration
                )
                out += compliance * model.solve(motors, against).torques
        return out

    def _tool_error(self, tool: Array) -> Array:
        """Return by how much a measured point is displaced in {O'} [mm]."""
        out = np.zeros(3)
        for effect in self.effects:
            if effect["name"] == "instrument_offset":
                offsets = np.column_stack([np.atleast_1d(effect.get(f"offset_{axis}", 0.0)) for axis in "xyz"])
                for at, offset in zip(effect.get("tools") or [tool], offsets, strict=True):
                    if np.linalg.norm(tool - np.asarray(at)) < 1e-6:
                        out += offset
        return out


def _turned(*vector: float) -> Array:
    """Return the rotation by a rotation vector [deg]."""
    return np.asarray(Rotation.from_rotvec(vector, degrees=True).as_matrix())


def _about_z(angle: float) -> Array:
    cos, sin = np.cos(angle), np.sin(angle)
    return np.array([[cos, -sin, 0.0], [sin, cos, 0.0], [0.0, 0.0, 1.0]])


class _Model:
    """The multibody system of a machine: built once, then moved from pose to pose by its frames, lengths and loads.

    A frame is where something is fixed to a body: a position and, where it matters, a rotation.
    """

    def __init__(self, delta: Delta) -> None:
        self._exu = _exudyn()
        self.delta = delta
        masses = delta.robot.get("masses", {})
        self.com = masses.get("proximal_com", 0.5)
        rod, error = masses.get("distal_rod", 0.0) / 2, delta.error
        own, arm = masses.get("proximal_inertia"), masses.get("proximal", 0.0)
        length = float(delta.robot["geometry"]["proximal_length"]) / 1000
        self.arm_inertia = arm * length**2 / 12 if own is None else float(own) * 1e-6  # kg m^2
        self.directions, self.joints, self.axes, self.hands = [], [], [], []
        for i, phi in enumerate(delta.phi):
            cos, sin = np.cos(phi), np.sin(phi)
            nominal = np.array([[cos, 0.0, sin], [sin, 0.0, -cos], [0.0, 1.0, 0.0]])  # [u0 v0 w0]
            alpha, beta = error("alpha0", i) - error("alpha03", i), error("beta0", i) - error("beta03", i)
            self.directions.append(nominal[:, 0])
            self.joints.append(nominal @ _turned(error("alpha0", i), error("beta0", i), 0))
            self.axes.append(_turned(error("alpha2", i), error("beta2", i), 0)[:, 2])
            self.hands.append((nominal @ _turned(alpha, beta, 0))[:, 2])
        self.twist = np.deg2rad(delta.values("joint_compliance", "compliance"))  # rad/(N m)
        self.bend = delta.values("proximal_bending", "compliance") / 1000  # m/N
        self.stretch = delta.values("distal_compliance", "compliance") / 1000
        self.runout = [delta.values("joint_axis_runout", k) / 1000 for k in ("cos", "sin")]
        self.tilt = [np.deg2rad(delta.values("base_compliance", f"compliance_{axis}")[0]) for axis in "xy"]
        # of each limb: the arm, both rods at the elbow, both at the platform; then the platform and the payload
        self.masses = np.array([arm, rod, rod, rod, rod] * 3 + [masses.get("platform", 0.0), 0.0])
        self._same: tuple[float, ...] = ()
        self._build()

    def _build(self) -> None:
        self.container = self._exu.SystemContainer()
        self.mbs = self.container.AddSystem()
        self.nodes: list[Any] = []
        base = self.mbs.AddObject(self._items.ObjectGround())
        if any(self.tilt):
            ground, base = base, self._body()
            self._joint(self._frame(ground), self._frame(base), [0, 0, 0, *self.tilt, 0])
        self.pivots, self.tips, self.elbows, self.weights, self.reactions = [], [], [], [], []
        arms = [self._arm(base, i) for i in range(3)]
        platform = self._body()
        self.rods = [self._rod(platform, i, j) for i in range(3) for j in (0, 1)]
        self.weights += [self._frame(platform), self._frame(platform)]
        force, torque = self._items.LoadForceVector, self._items.LoadTorqueVector
        self.forces = [self.mbs.AddLoad(force(markerNumber=m, loadVector=[0, 0, 0])) for m in self.weights]
        self.moments = [
            self.mbs.AddLoad(torque(markerNumber=self._frame(arm), loadVector=[0, 0, 0], bodyFixed=True))
            for arm in arms
        ]
        self.mbs.Assemble()
        self.settings = self._exu.SimulationSettings()
        self.settings.solutionSettings.writeSolutionToFile = False
        self.settings.staticSolver.verboseMode = 0
        self.settings.staticSolver.newton.relativeTolerance = 1e-10
        self.settings.staticSolver.newton.absoluteTolerance = 1e-10

    @property
    def _items(self) -> Any:
        from exudyn import itemInterface

        return itemInterface

    def _body(self) -> Any:
        self.nodes.append(self.mbs.AddNode(self._items.NodeRigidBodyEP(referenceCoordinates=[0, 0, 0, 1, 0, 0, 0])))
        inertia = [1, 1, 1, 0, 0, 0]  # in a static equilibrium only loads weigh
        body = self._items.ObjectRigidBody(physicsMass=1.0, physicsInertia=inertia, nodeNumber=self.nodes[-1])
        return self.mbs.AddObject(body)

    def _frame(self, of: Any) -> Any:
        return self.mbs.AddMarker(self._items.MarkerBodyRigid(bodyNumber=of, localHT=np.eye(4)))

    def _joint(self, one: Any, two: Any, springs: Sequence[float]) -> Any:
        """Join two frames by springs of a compliance along and about each axis, rigidly where it is 0.

        Returns the object that feels the torque about the third axis.
        """
        items, fixed = self._items, [0 if compliance else 1 for compliance in springs]
        made = self.mbs.AddObject(items.GenericJoint(markerNumbers=[one, two], constrainedAxes=fixed))
        if not any(springs):
            return made
        stiffness = np.diag([1 / c if c else 0.0 for c in springs])
        spring = self.mbs.AddObject(items.RigidBodySpringDamper(markerNumbers=[one, two], stiffness=stiffness))
        return spring if springs[5] else made

    def _arm(self, base: Any, i: int) -> Any:
        """Add the arm of a limb with its frames, and its tip as a body of its own where it bends; return the arm."""
        arm = tip = self._body()
        self.pivots.append(self._frame(base))
        self.reactions.append(self._joint(self.pivots[i], self._frame(arm), [0, 0, 0, 0, 0, self.twist[i]]))
        self.tips.append(None)
        if self.bend[i]:
            tip = self._body()
            self.tips[i] = self._frame(arm)
            self._joint(self.tips[i], self._frame(tip), [0, self.bend[i], self.bend[i], 0, 0, 0])
        self.elbows.append([self._frame(tip), self._frame(tip)])
        self.weights += [self._frame(arm) for _ in range(3)] + [None, None]
        return arm

    def _rod(self, platform: Any, i: int, j: int) -> tuple[Any, str]:
        """Add a rod from an elbow to the platform; return it, and what its length is called."""
        end = self.weights[5 * i + 3 + j] = self._frame(platform)
        ends = [self.elbows[i][j], end]
        if not self.stretch[i]:
            rigid = self._items.DistanceConstraint(markerNumbers=ends, distance=1.0)
            return self.mbs.AddObject(rigid), "distance"
        stiffness = 1 / self.stretch[i]
        spring = self._items.SpringDamper(markerNumbers=ends, referenceLength=1.0, stiffness=stiffness)
        return self.mbs.AddObject(spring), "referenceLength"

    def at(self, sizes: Mapping[str, Array], tool: Array, payload: float) -> _Model:
        """Set lengths [m], measured point [m] and payload [kg]."""
        if (same := (*np.ravel(list(sizes.values())), *tool, payload)) == self._same:
            return self
        self._same, self.sizes, self.masses[-1] = same, sizes, payload
        error, mbs = self.delta.error, self.mbs
        for i in range(3):
            elbow = np.array([sizes["L"][i], 0, 0])
            half = (sizes["c"][i] + error("dc", i) / 1000) / 2 * self.axes[i]
            self._fix(self.weights[5 * i], self.com * elbow)
            if self.tips[i] is not None:
                self._fix(self.tips[i], elbow)
            for j, side in enumerate((+1, -1)):
                self._fix(self.weights[5 * i + 1 + j], elbow + side * half)
                self._fix(self.elbows[i][j], side * half + (elbow if self.tips[i] is None else 0))
                hand = sizes["a"][i] * self.directions[i] + side * sizes["c"][i] / 2 * self.hands[i]
                self._fix(self.weights[5 * i + 3 + j], hand)
                made, length = self.rods[2 * i + j]
                mbs.SetObjectParameter(made, length, float(sizes["l"][i] + side * error("dl", i) / 2000))
        self._fix(self.weights[-1], tool)
        return self

    def _fix(self, marker: Any, position: Array, turn: Array | None = None) -> None:
        T = np.eye(4)
        T[:3, 3] = position
        if turn is not None:
            T[:3, :3] = turn
        self.mbs.SetMarkerParameter(marker, "localHT", T)

    def solve(self, motors: Array, load: Load) -> Pose:
        """Return the static equilibrium at motors' angles (3,) [rad] under a load."""
        mbs, sizes, start, elbows = self.mbs, self.sizes, [], []
        if any(self.tilt):
            start.append((np.zeros(3), np.eye(3)))
        for i in range(3):
            theta = motors[i] + np.deg2rad(self.delta.error("theta", i))
            orbit = self.runout[0][i] * np.cos(theta) + self.runout[1][i] * np.sin(theta)
            offset = np.array([self.delta.error(f"e{axis}", i) for axis in "xyz"]) / 1000
            pivot = (sizes["b"][i] + orbit) * self.directions[i] + offset
            turn = self.joints[i] @ _about_z(theta)
            self._fix(self.pivots[i], pivot, turn)
            elbows.append(pivot + sizes["L"][i] * turn[:, 0])
            start += [(pivot, turn)] + ([(elbows[i], turn)] if self.tips[i] is not None else [])
        start.append((self._start(elbows), np.eye(3)))
        quaternions = Rotation.from_matrix([turn for _, turn in start]).as_quat(scalar_first=True)
        state = [[*p, q[0] - 1, *q[1:]] for (p, _), q in zip(start, quaternions, strict=True)]
        mbs.systemData.SetODE2Coordinates(np.ravel(state), self._exu.ConfigurationType.Initial)

        pulls = np.zeros((len(self.masses), 3))
        if load.fields is not None or load.gravity is not None:
            pulls[:] = self.masses[:, None] * (load.gravity if load.fields is None else load.fields)
        if load.only_payload:
            pulls[:-1] = 0.0
        for force, pull in zip(self.forces, pulls, strict=True):
            mbs.SetLoadParameter(force, "loadVector", pull)
        about = np.zeros(3) if load.moments is None else load.moments
        for moment, m in zip(self.moments, about, strict=True):
            mbs.SetLoadParameter(moment, "loadVector", [0.0, 0.0, float(m)])
        try:
            done = mbs.SolveStatic(self.settings)
        except Exception as error:  # of types of the engine's own
            raise NoEquilibriumError("the engine did not converge") from error
        if not done:
            raise NoEquilibriumError("the engine did not converge")
        kind = self._exu.OutputVariableType
        return Pose(
            origin=np.array(mbs.GetNodeOutput(self.nodes[-1], kind.Position)),
            turn=np.array(mbs.GetNodeOutput(self.nodes[-1], kind.RotationMatrix)).reshape(3, 3),
            points=np.array([mbs.GetMarkerOutput(m, kind.Position) for m in self.weights]),
            torques=np.array([mbs.GetObjectOutput(r, kind.TorqueLocal)[2] for r in self.reactions]),
        )

    def _start(self, elbows: Sequence[Array]) -> Array:
        """Return about where O' is: the lower of the two points at the rods' length from all elbows, without errors."""
        p = [e - self.sizes["a"][i] * self.directions[i] for i, e in enumerate(elbows)]
        r = self.sizes["l"]
        ex = (p[1] - p[0]) / (d := np.linalg.norm(p[1] - p[0]))
        i = ex @ (p[2] - p[0])
        ey = (p[2] - p[0] - i * ex) / (j := np.linalg.norm(p[2] - p[0] - i * ex))
        x = (r[0] ** 2 - r[1] ** 2 + d**2) / (2 * d)
        y = (r[0] ** 2 - r[2] ** 2 + i**2 + j**2 - 2 * i * x) / (2 * j)
        under = r[0] ** 2 - x**2 - y**2
        if under < 0:
            raise NoEquilibriumError("out of reach")
        ez = np.cross(ex, ey)
        found: Array = p[0] + x * ex + y * ey - np.sign(ez[2]) * np.sqrt(under) * ez
        return found

"""What is unknown of the instrument and has a name: its value, and whether readings or only priors know it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from deltacal_gen.estimation.fit import Fit
from deltacal_gen.machine.registry import Array
from deltacal_gen.results.result import Parameter, Status
from deltacal_gen.units import to_internal

FREER = 10.0  # times a prior: what grows along with priors that loosen is not known by the readings
GROWS = 1.5  # by how much it may grow all the same
NOWHERE = 1e4  # ordinary sizes: where an unknown of the instrument may stand that nothing sees


@dataclass(frozen=True, eq=False)
class Doubt:
    """How surely parameters and the unknowns of an instrument are known together.

    Attributes
    ----------
    covariance : (n + n_m, n + n_m) array
        Of parameters in ordinary sizes of theirs, with their priors.
    unassumed, free : (n + n_m, n + n_m) arrays
        The same where priors that no drawing gives are looser, and where all are.
    sizes : (n + n_m,) array
        The ordinary sizes [mm, rad, 1].
    """

    covariance: Array
    unassumed: Array
    free: Array
    sizes: Array

    @staticmethod
    def of(final: Fit, given: tuple[bool, ...]) -> Doubt:
        """Return what a fit leaves in doubt; `given` says which parameters the robot file's tolerances know."""
        problem, instrument = final.problem, final.instrument
        state = problem.linearise(final.errors, instrument, final.machine)
        typical = np.tile(instrument.kind.typical[list(instrument.free)], len(instrument.state))
        sizes = np.concatenate([problem.scale, typical[: instrument.n_unknown]])
        J = np.concatenate([state.J_p, state.J_m], axis=2) * sizes
        weight = np.sqrt(final.weights)[:, None] / final.sigma
        rows = (J * weight[..., None])[np.isfinite(state.residual)]
        information, n = rows.T @ rows, len(problem.scale)
        held = np.zeros(len(sizes), dtype=bool)
        held[: len(given)] = given

        def covariance(assumed: float, told: float) -> Array:
            priors = np.where(held, 1 / told**2, 1 / assumed**2)
            priors[n:] = 1 / NOWHERE**2
            scale = 1 / np.sqrt(np.diag(information) + priors)
            whole = (information + np.diag(priors)) * np.outer(scale, scale)
            return np.asarray(np.linalg.pinv(whole, hermitian=True, rcond=1e-15) * np.outer(scale, scale))

        return Doubt(covariance(1.0, 1.0), covariance(FREER, 1.0), covariance(FREER, FREER), sizes)

    def status(self, j: int) -> Status:
        """Return what the value of an entry rests on."""
        own, loose, looser = (np.sqrt(C[j, j]) for C in (self.covariance, self.unassumed, self.free))
        if loose > GROWS * own:
            return Status.NOT_PINNED
        return Status.BY_PRIOR if looser > GROWS * own else Status.IDENTIFIED


def instrument_parameters(final: Fit, given: tuple[bool, ...] = ()) -> tuple[Parameter, ...]:
    """Return the unknowns of an instrument that answers give by name, set-up by set-up, in the units of files."""
    instrument, kind = final.instrument, final.instrument.kind
    wanted = [u for u in instrument.free if kind.unknown[u][0] in kind.reported]
    if not wanted:
        return ()
    doubt, n, each = Doubt.of(final, given), len(final.problem.scale), len(instrument.free)
    out = []
    for s in range(len(instrument.state)):
        for u in wanted:
            j = n + s * each + instrument.free.index(u)
            name, unit = instrument.unknown[j - n]
            status, std = doubt.status(j), float(np.sqrt(doubt.covariance[j, j]) * doubt.sizes[j])
            out.append(
                Parameter(
                    name=name,
                    value=float(instrument.state[s, kind.reported[kind.unknown[u][0]]]) / to_internal(unit),
                    std=None if status is Status.NOT_PINNED else std / to_internal(unit),
                    unit=instrument.reported[name],
                    status=status,
                )
            )
    return tuple(out)

"""A crushing test of a campaign."""

from grus.campaign.outcome import Findings
from grus.campaign.run import Run
from grus.campaign.store import Store
from grus.crushing.arrays import to_arrays
from grus.crushing.result import CrushingResult
from grus.crushing.test import crush


def simulate(run: Run, store: Store, restart: bool) -> Findings:
    """All that the test of a grain gives."""
    result = crush(run.card, run.grain)
    return Findings(result.record, figures(result), to_arrays(result))


def figures(result: CrushingResult) -> dict[str, float]:
    """Numbers of a crushing test, in SI."""
    return {
        "broken": float(result.broken),
        "gap": result.gap,
        "peak.force": result.peak_force,
        "peak.closing": result.peak_closing,
        "peak.strength": result.strength,
        "maximum.force": result.max_force,
        "maximum.closing": result.max_closing,
        "maximum.strength": result.max_strength,
        "elements": float(result.specimen.element_count),
        "clumps": float(result.specimen.clump_count),
        "bonds.initial": float(result.bonds),
        "bonds.broken": float(result.tension_breaks + result.shear_breaks),
        "bonds.broken_in_tension": float(result.tension_breaks),
        "bonds.broken_in_shear": float(result.shear_breaks),
        "fragments": float(result.after.fragment_count),
        "energy.error": result.energy_error,
    }

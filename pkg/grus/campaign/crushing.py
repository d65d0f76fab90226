"""A crushing test of a campaign."""

from grus.campaign.run import Run
from grus.campaign.store import Store
from grus.crushing.result import CrushingResult
from grus.crushing.test import crush
from grus.record import Record


def simulate(run: Run, store: Store, restart: bool) -> tuple[Record, dict[str, float]]:
    """Force and displacement of a grain."""
    result = crush(run.card, run.grain)
    return result.record, figures(result)


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

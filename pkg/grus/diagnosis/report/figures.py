"""Figures of a diagnosis."""

from matplotlib.figure import Figure

from grus.diagnosis.diagnosis import Diagnosis
from grus.diagnosis.report.curves import curves
from grus.diagnosis.report.differences import differences
from grus.diagnosis.verdict import NAMED
from grus.mechanisms import MECHANISMS
from grus.plotting.diagnosis_curves import curves_plot
from grus.plotting.diagnosis_holds import holds_plot
from grus.plotting.diagnosis_misfit import misfit_plot
from grus.plotting.diagnosis_residuals import residuals_plot
from grus.plotting.diagnosis_suspects import suspects_plot


def figures(diagnosis: Diagnosis) -> dict[str, Figure]:
    """By the names of their files; "holds" only where there are holds with times."""
    stages, record = curves(diagnosis), diagnosis.recording
    compared = diagnosis.calibration.compared
    holds = [one for one in stages if one.kind == "hold"] if diagnosis.protocol.timed else []
    groups = [
        str(diagnosis.protocol.segments[e.stage].stage) if e.channel == "strain" else e.channel
        for e in compared.entries
    ]
    plots = {"curves": curves_plot(record, stages), "misfit": misfit_plot(differences(diagnosis))}
    if holds:
        plots["holds"] = holds_plot(record, holds)
    named = frozenset(_title(one.name) for one in diagnosis.culprits)
    chances, missing = _suspects(diagnosis)
    return plots | {
        "suspects": suspects_plot(chances, named, NAMED, missing),
        "residuals": residuals_plot(diagnosis.whiteness.residuals, groups),
    }


def _suspects(diagnosis: Diagnosis) -> tuple[dict[str, float], dict[str, str]]:
    """By title: probabilities, the likely first, and why others were not looked for."""
    known = diagnosis.decision.probability
    looked_for = {one.mechanism.name for one in diagnosis.library.fingerprints}
    names = sorted(looked_for | {"nothing", "unknown"}, key=lambda name: -known.get(name, 0.0))
    missing = {
        _title(name): "runs are missing"
        if name in diagnosis.library.skipped
        else "cannot show here"
        for name in MECHANISMS
        if name not in looked_for
    }
    return {_title(name): known.get(name, 0.0) for name in names}, missing


def _title(name: str) -> str:
    own = {"nothing": "Nothing left out", "unknown": "Something unknown"}
    return own.get(name) or MECHANISMS[name].title

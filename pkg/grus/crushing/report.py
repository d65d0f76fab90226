"""Files that tell the outcome of a group of crushing tests."""

import json
import platform
from pathlib import Path

import pandas as pd

from grus.crushing.group import GroupResult
from grus.crushing.picture import fragment_picture
from grus.files import replacing, write_text
from grus.plotting import force_displacement_plot, save, weibull_plot
from grus.scene.vtk import write_vtk
from grus.statistics import WeibullFit
from grus.version import __version__


def write_report(group: GroupResult, folder: str | Path) -> dict:
    """Writes result.json, curves.csv, plots (PNG and SVG) and VTK files into `folder`; returns what result.json holds."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    result = numbers(group)
    _write_curves(group, folder / "curves.csv")
    curves = [(grain.record["closing"], grain.record["force"]) for grain in group.grains]
    peaks = [
        (g.peak_closing, g.peak_force) if g.broken else (g.max_closing, g.max_force)
        for g in group.grains
    ]
    title = group.card.name
    figures = {
        "force-displacement": force_displacement_plot(curves, peaks, title=title),
        "fragments": fragment_picture(group.grains),
    }
    fit = group.weibull_or_reason()
    if not isinstance(fit, str):
        figures["weibull"] = weibull_plot(fit, title=title)
    for name, figure in figures.items():
        save(figure, folder / name)
    result["files"] = ["curves.csv", "result.json", *(f"{name}.png" for name in figures), "vtk/"]
    for grain in group.grains:
        for moment in ("before", "after"):
            path = folder / "vtk" / f"grain-{grain.grain:04d}-{moment}.vtp"
            path.parent.mkdir(exist_ok=True)
            write_vtk(path, grain.specimen, getattr(grain, moment))
    # Last, so that a result.json stands for a complete folder.
    write_text(folder / "result.json", json.dumps(result, indent=1) + "\n")
    return result


def numbers(group: GroupResult) -> dict:
    """Everything that was found, as plain JSON."""
    result = {
        "grains": len(group.grains),
        "broken": int((~group.censored).sum()),
        "card": group.card.to_dict(),
        "card_hash": group.card.content_hash(),
        "versions": {
            "grus": __version__,
            "yade": _yade_version(),
            "python": platform.python_version(),
        },
        "worst_energy_error": max((g.energy_error for g in group.grains), key=abs),
        "tests": [grain.summary() for grain in group.grains],
    }
    if group.failed:
        result["failed"] = {str(grain): reason for grain, reason in group.failed.items()}
    result["weibull"] = _weibull_numbers(group.weibull_or_reason())
    result["weibull_by_maximum"] = _weibull_numbers(group.weibull_or_reason(by="maximum"))
    return result


def _weibull_numbers(fit: WeibullFit | str) -> dict:
    """The fit, or {"refused": why} where there is none."""
    if isinstance(fit, str):
        return {"refused": fit}
    return {
        "modulus": fit.modulus,
        "modulus_ci": list(fit.modulus_ci),
        "modulus_unbiased": fit.modulus_unbiased,
        "sigma0": fit.sigma0,
        "sigma0_ci": list(fit.sigma0_ci),
        "sigma0_unit": "Pa",
        "confidence": fit.confidence,
        "anderson_darling": fit.anderson_darling,
        "p_value": fit.p_value,
    }


def _write_curves(group: GroupResult, path: Path) -> None:
    frames = []
    for grain in group.grains:
        frame = grain.record.frame()
        frame.insert(0, "grain", grain.grain)
        frames.append(frame)
    with replacing(path) as partial:
        pd.concat(frames, ignore_index=True).to_csv(partial, index=False, float_format="%.9g")


def _yade_version() -> str:
    from yade import config

    return config.version

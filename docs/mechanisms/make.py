"""Makes the pictures of the mechanisms anew: PYTHONPATH=pkg /usr/bin/python3 docs/mechanisms/make.py [NAME ...]

What has been run is kept in results/validation-creep.
"""

import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "validation" / "creep"))

from tests import card, run  # noqa: E402

from grus.mechanisms import MECHANISMS  # noqa: E402
from grus.oedometer import laboratory  # noqa: E402
from grus.plotting import save, style  # noqa: E402
from grus.plotting.style import BLUE, VERMILION  # noqa: E402
from grus.record import Record  # noqa: E402

FIGURES = Path(__file__).resolve().parent / "figures"
HOUR, KILO = 3600.0, 1e3
STAGES = [
    "load to 150 kPa in 1 h",
    "load to 300 kPa in 1 h",
    "hold for 24 h",
    "unload to 100 kPa in 1 h",
]
SHOWN: dict[str, dict[str, float]] = {
    "bond_ageing": {"reference_time": 1e4},
    "wall_friction": {"coefficient": 0.3},
    "platen_compliance": {"compliance": 2e-10, "closure": 2e-5},
    "hertzian_contact": {"stress": 2e5},
    "contact_plasticity": {"unloading_ratio": 2.5},
    "rolling_resistance": {"rolling_friction": 0.3},
    "strength_scatter": {"coefficient_of_variation": 0.3},
    "wetting_collapse": {"strength_factor": 0.8},
    "loading_too_fast": {"speed": 1.5},
    "instrument_drift": {"strain_rate": 5e-9},
}
"""Values of the parameters that are shown."""


def compression(axes: Axes, records: dict[str, Record]) -> None:
    """Strain, downwards, against top stress."""
    for (name, record), colour in zip(records.items(), (BLUE, VERMILION)):
        strain = 100 * record["axial_strain"]
        axes.plot(record["axial_stress"] / KILO, strain, color=colour, label=name)
    axes.set(xlabel=r"Stress on top $\sigma$ [kPa]", ylabel=r"Axial strain $\varepsilon$ [%]")
    axes.invert_yaxis()
    axes.legend()


def holds(axes: Axes, records: dict[str, Record]) -> None:
    """Strain since the begin of each hold against the logarithm of its time."""
    for record, marker in zip(records.values(), ("--", "-")):
        parts = [one for one in record.segments if one.kind == "hold"]
        for number, one in enumerate(parts):
            time = record["time"][one.rows] - one.t0
            strain = record["axial_strain"][one.rows]
            level = one.stress_to / KILO
            axes.plot(
                time[1:] / HOUR,
                100 * (strain[1:] - strain[0]),
                marker,
                color=f"C{number}",
                label=f"{level:g} kPa" if marker == "-" else None,
            )
    axes.set(
        xscale="log", xlabel="Time since the begin of the hold [h]", ylabel="Strain in the hold [%]"
    )
    axes.invert_yaxis()
    axes.legend(title="solid: with; dashed: without")


def base_against_top(axes: Axes, records: dict[str, Record]) -> None:
    for (name, record), colour in zip(records.items(), (BLUE, VERMILION)):
        axes.plot(
            record["axial_stress"] / KILO, record["base_stress"] / KILO, color=colour, label=name
        )
    axes.set(xlabel="Stress on top [kPa]", ylabel="Stress on the base [kPa]")


def against_time(axes: Axes, records: dict[str, Record]) -> None:
    for record, colour in zip(records.values(), (BLUE, VERMILION)):
        axes.plot(record["time"] / HOUR, 100 * record["axial_strain"], color=colour)
    axes.set(xlabel="Laboratory time [h]", ylabel=r"Axial strain $\varepsilon$ [%]")
    axes.invert_yaxis()


def broken(axes: Axes, records: dict[str, Record]) -> None:
    for record, colour in zip(records.values(), (BLUE, VERMILION)):
        axes.plot(record["axial_stress"] / KILO, record["ae_events"], color=colour)
    axes.set(xlabel="Stress on top [kPa]", ylabel="Broken bonds")


def difference(axes: Axes, records: dict[str, Record]) -> None:
    """What the mechanism adds to the strain of the same readings."""
    plain, distorted = records.values()
    extra = 100 * (distorted["axial_strain"] - plain["axial_strain"])
    axes.plot(plain["axial_stress"] / KILO, extra, color=VERMILION)
    axes.set(xlabel="Stress on top [kPa]", ylabel="Extra strain [%]")
    axes.invert_yaxis()


def top_over_base(axes: Axes, records: dict[str, Record]) -> None:
    """In the load to the highest stress."""
    for record, colour in zip(records.values(), (BLUE, VERMILION)):
        one = max((s for s in record.segments if s.kind == "load"), key=lambda s: s.stress_to)
        top, base = record["axial_stress"][one.rows], record["base_stress"][one.rows]
        axes.plot(top / KILO, top / base, ".-", color=colour)
    axes.set(xlabel="Stress on top, last load [kPa]", ylabel="Top over base stress")


def first_loading(axes: Axes, records: dict[str, Record]) -> None:
    for record, colour in zip(records.values(), (BLUE, VERMILION)):
        rows = np.concatenate(
            [np.arange(one.first, one.last + 1) for one in record.segments if one.kind == "load"]
        )
        rows = rows[record["axial_strain"][rows] > 0]
        axes.loglog(
            record["axial_stress"][rows] / KILO, 100 * record["axial_strain"][rows], color=colour
        )
    axes.set(xlabel="Stress on top, first loading [kPa]", ylabel="Axial strain [%]")


def recovered(axes: Axes, records: dict[str, Record]) -> None:
    for record, colour in zip(records.values(), (BLUE, VERMILION)):
        one = next(one for one in record.segments if one.kind == "unload")
        strain = record["axial_strain"][one.rows]
        axes.plot(record["axial_stress"][one.rows] / KILO, 100 * (strain[0] - strain), color=colour)
    axes.set(xlabel="Stress on top, unloading [kPa]", ylabel="Strain that comes back [%]")


def lateral(axes: Axes, records: dict[str, Record]) -> None:
    for record, colour in zip(records.values(), (BLUE, VERMILION)):
        ratio = record["lateral_stress"] / record["axial_stress"]
        axes.plot(record["axial_stress"] / KILO, ratio, color=colour)
    axes.set(xlabel="Stress on top [kPa]", ylabel="Lateral over axial stress")


RIGHT: dict[str, Callable[[Axes, dict[str, Record]], None]] = {
    "bond_ageing": holds,
    "wall_friction": base_against_top,
    "platen_compliance": difference,
    "hertzian_contact": first_loading,
    "contact_plasticity": recovered,
    "rolling_resistance": lateral,
    "strength_scatter": broken,
    "wetting_collapse": against_time,
    "loading_too_fast": top_over_base,
    "instrument_drift": against_time,
}
"""What the second panel shows."""


@style()
def picture(name: str) -> Figure:
    """The standard test without and with the mechanism."""
    mechanism, values = MECHANISMS[name], SHOWN[name]
    standard = card().with_overrides({"oedometer.stages": STAGES})
    changed = mechanism.distort(laboratory(run(standard, name, **values)), values)
    records = {"without": laboratory(run(standard, None)), f"with {name}": changed}
    figure = Figure(figsize=(8.6, 3.5), layout="constrained")
    left, right = figure.subplots(1, 2)
    compression(left, records)
    RIGHT[name](right, records)
    figure.suptitle(mechanism.title, fontsize=10.5)
    return figure


def main(names: list[str]) -> None:
    for name in names or MECHANISMS:
        save(picture(name), FIGURES / name)
        (FIGURES / f"{name}.svg").unlink()


if __name__ == "__main__":
    main(sys.argv[1:])

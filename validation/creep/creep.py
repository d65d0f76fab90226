"""Creep in the staged test: PYTHONPATH=pkg /usr/bin/python3 validation/creep/creep.py

Each specimen is tested with bonds that age and with bonds that do not; what has been run is not run again.
"""

import json

import numpy as np
from matplotlib.figure import Figure
from tests import DAY, FIGURES, LEVELS, card, run

from grus.files import write_text
from grus.oedometer import OedometerResult, laboratory
from grus.plotting import save, style
from grus.record import Record, Segment

SEEDS = (1, 2, 3)
AGEING = {"reference_time": 1e4, "exponent": 20.0}
BEGIN = 60.0
"""Time in a hold from which on the slope is fitted [s]."""


def main() -> None:
    tests = [(run(card(seed), None), run(card(seed), "bond_ageing", **AGEING)) for seed in SEEDS]
    found = {
        "ageing": AGEING,
        "seeds": SEEDS,
        "stress [kPa]": LEVELS,
        "with ageing": [numbers(aged) for _, aged in tests],
        "without": [numbers(plain) for plain, _ in tests],
    }
    found["delayed over immediate"] = ratios(found["with ageing"])
    FIGURES.mkdir(exist_ok=True)
    write_text(FIGURES / "creep.json", json.dumps(found, indent=1) + "\n")
    save(plot([laboratory(aged) for _, aged in tests], found), FIGURES / "creep")
    print(json.dumps(found, indent=1))


def numbers(result: OedometerResult) -> dict:
    """Of one test, a value a stress: strains of load and hold, slope of the hold, share of creep, and e/e0 at the end."""
    record = laboratory(result)
    held = [hold(record, stage) for stage in range(2, 2 + 2 * len(LEVELS), 2)]
    load = [change(record, one.first, previous(record, one)) for one in held]
    creep = [change(record, one.last, one.first) for one in held]
    back = hold(record, 2 + 2 * len(LEVELS))
    void = [end.void_ratio / result.seated.void_ratio for end in result.stages]
    return {
        "load": load,
        "creep": creep,
        "share": [c / (c + i) for c, i in zip(creep, load)],
        "slope": [slope(record, one)[0] for one in held],
        "linearity": [slope(record, one)[1] for one in held],
        "creep unloaded": change(record, back.last, back.first),
        "e/e0 after each hold": void[2 : 2 + 2 * len(LEVELS) : 2],
        "broken after each hold": [int(record["ae_events"][one.last]) for one in held],
        "steps": result.stages[-1].steps,
    }


def hold(record: Record, stage: int) -> Segment:
    return next(one for one in record.segments if one.stage == stage)


def previous(record: Record, one: Segment) -> int:
    """Row at which the load before a hold begins."""
    return next(other.first for other in record.segments if other.stage == one.stage - 1)


def change(record: Record, last: int, first: int) -> float:
    return float(record["axial_strain"][last] - record["axial_strain"][first])


def slope(record: Record, one: Segment) -> tuple[float, float]:
    """Strain per decade of time in a hold, by least squares on the logarithm of time, and the coefficient of determination."""
    time = record["time"][one.rows] - one.t0
    strain = record["axial_strain"][one.rows]
    at = np.geomspace(BEGIN, DAY, 60)
    # Creep is a staircase: at each time the last reading before it.
    values = strain[np.searchsorted(time, at * (1 + 1e-9), side="right") - 1]
    decades = np.log10(at)
    fit = np.polyfit(decades, values, 1)
    spread = np.sum((values - values.mean()) ** 2)
    residual = np.sum((values - np.polyval(fit, decades)) ** 2)
    return float(fit[0]), float(1 - residual / spread) if spread > 0 else float("nan")


def ratios(tests: list[dict]) -> dict:
    """Delayed over immediate compressibility of each stage after the first: strain a decade of time over strain a decade of
    stress (Oldecop & Alonso 2007 have one value for a rock)."""
    decades = np.log10(np.array(LEVELS[1:]) / np.array(LEVELS[:-1]))
    immediate = np.array([one["load"][1:] for one in tests]) / decades
    delayed = np.array([one["slope"][1:] for one in tests])
    return {
        "immediate": immediate.mean(axis=0).tolist(),
        "delayed": delayed.mean(axis=0).tolist(),
        "ratio": (delayed.mean(axis=0) / immediate.mean(axis=0)).tolist(),
        "correlation": float(np.corrcoef(immediate.ravel(), delayed.ravel())[0, 1]),
    }


@style()
def plot(records: list[Record], found: dict) -> Figure:
    """Strain in the holds, their slopes, and the share of creep."""
    figure = Figure(figsize=(10.5, 3.6), layout="constrained")
    left, middle, right = figure.subplots(1, 3)
    record = records[0]
    for number, level in enumerate((*LEVELS, "unloaded")):
        one = hold(record, 2 + 2 * number)
        time = (record["time"][one.rows] - one.t0)[1:] / 3600
        strain = record["axial_strain"][one.rows]
        name = f"{level} kPa" if number < len(LEVELS) else str(level)
        left.step(time, 100 * (strain[1:] - strain[0]), where="post", label=name)
    left.set(xscale="log", xlabel="Time in the hold [h]", ylabel="Strain in the hold [%]")
    left.set_title(f"Specimen {SEEDS[0]}")
    left.invert_yaxis()
    left.legend()
    for axes, key, label in (
        (middle, "slope", "Strain a decade of time [%]"),
        (right, "share", "Share of creep in the stage strain [%]"),
    ):
        values = 100 * np.array([one[key] for one in found["with ageing"]])
        for seed, row in zip(SEEDS, values):
            axes.plot(LEVELS, row, "o", alpha=0.5, label=f"specimen {seed}")
        axes.plot(LEVELS, values.mean(axis=0), "k-", label="mean")
        axes.set(xlabel="Axial stress [kPa]", ylabel=label, ylim=(0, None))
    middle.legend()
    return figure


if __name__ == "__main__":
    main()

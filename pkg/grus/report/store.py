"""The page of the store of campaigns."""

import io
from collections.abc import Sequence

import numpy as np
from matplotlib.figure import Figure

from grus.campaign.outcome import Outcome
from grus.campaign.store import Store
from grus.card import Card
from grus.errors import GrusError
from grus.plotting import force_displacement_plot, new_figure, style, weibull_plot
from grus.plotting.labels import log_ticks
from grus.report.content import Content, Grid, Picture, flat
from grus.statistics import fit_weibull

FIGURES = {
    "crush": {
        "strength MPa": ("peak.strength", 1e-6),
        "bonds broken": ("bonds.broken", 1),
        "fragments": ("fragments", 1),
        "energy error %": ("energy.error", 100),
    },
    "oedometer": {
        "yield kPa": ("yield.stress", 1e-3),
        "onset of breakage kPa": ("onset.stress", 1e-3),
        "void ratio": ("void_ratio.final", 1),
        "K0": ("K0.final", 1),
        "bonds broken": ("bonds.broken", 1),
    },
}
FIGURES["recording"] = {
    name: FIGURES["oedometer"][name] for name in ("void ratio", "K0", "bonds broken")
}
"""Header -> figure, factor, of each kind of run."""
MOST_VALUES = 8
"""Values of a key that are shown."""
MOST_RUNS = 500
"""Rows of a table at most."""
MOST_CURVES = 60
"""Curves in a plot at most."""


def store_content(store: Store) -> Content:
    """Raises GrusError when nothing is in the store."""
    lines: list[str] = []
    outcomes = sorted(store.outcomes(lines.append), key=_order)
    if not outcomes:
        raise GrusError(f"{store.folder}: no run in it; allowed: a store with one run or more")
    good = [one for one in outcomes if one.failed is None]
    cards = [flat(one.card) for one in outcomes]
    varied = {}
    for key in dict.fromkeys(key for card in cards for key in card):
        values = list(dict.fromkeys(card.get(key, "none") for card in cards))
        if len(values) > 1:
            varied[key] = _several(values)
    kinds = dict.fromkeys(one.kind for one in outcomes)
    pictures, grids, notes = [], [], [f"damaged: {line}" for line in lines]
    for kind in kinds:
        own = [one for one in outcomes if one.kind == kind]
        alike = set(varied) <= {"seed"}
        pictures += _pictures(kind, [one for one in own if one.failed is None], alike)
        grids.append(_grid(kind, own, varied))
        if len(own) > MOST_RUNS:
            notes.append(f"of {len(own)} runs of the kind {kind} the first {MOST_RUNS} are shown")
    seconds = sum(one.seconds for one in good)
    summary = [
        (
            "runs",
            f"{len(outcomes)} ({', '.join(kinds)}), of which {len(outcomes) - len(good)} failed",
        ),
        ("simulated", f"{seconds:.3g} s in all"),
        ("varied", ", ".join(varied) or "nothing"),
    ]
    return Content(
        what="Campaign",
        name=", ".join(dict.fromkeys(one.card["name"] for one in outcomes)),
        summary=summary,
        pictures=pictures,
        grids=grids,
        card=outcomes[0].card,
        card_hash=Card.from_dict(outcomes[0].card).content_hash(),
        versions=(good or outcomes)[0].versions,
        repeat=_repeat(kinds, outcomes, varied),
        varied=varied,
        notes=notes,
    )


def _order(outcome: Outcome) -> tuple:
    """Runs that differ in seed and grain alone stand together."""
    setting = {key: value for key, value in flat(outcome.card).items() if key != "seed"}
    return outcome.kind, tuple(setting.items()), outcome.card["seed"], outcome.grain


def _several(values: Sequence[str]) -> str:
    shown = ", ".join(values[:MOST_VALUES])
    return shown if len(values) <= MOST_VALUES else f"{shown}, ... ({len(values)} values)"


def _grid(kind: str, outcomes: Sequence[Outcome], varied: dict[str, str]) -> Grid:
    columns = FIGURES[kind]
    grains = any(one.grain for one in outcomes)
    failures = any(one.failed for one in outcomes)
    header = ["run", *varied, *(["grain"] * grains), *columns, *(["failed"] * failures)]
    rows = []
    for one in outcomes[:MOST_RUNS]:
        card = flat(one.card)
        changes = [card.get(key, "none") for key in varied]
        figures = [
            f"{factor * one.figures[name]:.4g}" if name in one.figures else "-"
            for name, factor in columns.values()
        ]
        grain, failed = [str(one.grain)] * grains, [one.failed or ""] * failures
        rows.append([one.key[:12], *changes, *grain, *figures, *failed])
    return Grid(f"Runs of the kind {kind}", header, rows)


def _pictures(kind: str, outcomes: Sequence[Outcome], alike: bool) -> list[Picture]:
    """Curves; and of crushed grains that are `alike`, of one model, their Weibull distribution."""
    if not outcomes:
        return []
    if kind != "crush":
        return [_picture("Compression", _compression(outcomes[:MOST_CURVES]))]
    curves = [(one.record["closing"], one.record["force"]) for one in outcomes[:MOST_CURVES]]
    pictures = [_picture("Force and displacement", force_displacement_plot(curves))]
    if not alike:
        return pictures
    strengths = np.array([one.figures["peak.strength"] for one in outcomes])
    unbroken = np.array([one.figures["broken"] == 0 for one in outcomes])
    try:
        fit = fit_weibull(strengths, censored=unbroken if unbroken.any() else None)
    except GrusError:
        return pictures  # too few grains, or all alike
    return [*pictures, _picture("Strengths of all grains", weibull_plot(fit))]


@style()
def _compression(outcomes: Sequence[Outcome]) -> Figure:
    figure, axes = new_figure()
    for one in outcomes:
        record = one.record
        axes.plot(1e-3 * record["axial_stress"], 100 * record["axial_strain"], lw=0.9, alpha=0.7)
    axes.set_xscale("log")
    low, high = axes.get_xlim()
    ticks = log_ticks(low, high)
    axes.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
    axes.set_xticks([], minor=True)
    axes.invert_yaxis()
    axes.set_xlabel("Axial stress [kPa]")
    axes.set_ylabel("Axial strain [%]")
    return figure


def _picture(title: str, figure: Figure) -> Picture:
    file = io.BytesIO()
    with style():
        figure.savefig(file, format="svg", metadata={"Date": None, "Creator": None})
    return Picture(title, file.getvalue(), "svg+xml")


def _repeat(kinds: dict, outcomes: Sequence[Outcome], varied: dict[str, str]) -> list[str]:
    """The command, where seeds alone differ; else how the card of a run is got at."""
    plain = len(kinds) == 1 and set(varied) <= {"seed"} and not any(one.grain for one in outcomes)
    if plain:
        seeds = ",".join(str(seed) for seed in sorted({one.card["seed"] for one in outcomes}))
        return [f"grus campaign card.toml --kind {outcomes[0].kind} --seeds {seeds} --out again"]
    return [
        "from grus.campaign import Store, campaign",
        "",
        'runs = [outcome.run() for outcome in Store("STORE").outcomes()]',
        'campaign(runs, Store("again"))',
    ]

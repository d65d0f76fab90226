"""The page of an oedometer test."""

from collections.abc import Sequence

from grus.oedometer.result import stage_name
from grus.report.content import Content, Grid, Picture

HEADER = (
    "stage",
    "stress kPa",
    "strain %",
    "void ratio",
    "K0",
    "bonds broken",
    "fragments",
    "Hardin",
    "Einav",
    "energy error %",
)


def specimen_content(found: dict, pictures: Sequence[Picture]) -> Content:
    """found: what result.json holds."""
    bonds, void, card = found["bonds"], found["void_ratio"], found["card"]
    share = f", {bonds['broken_share']:.2%} of all" if bonds["broken_share"] is not None else ""
    summary = [
        (
            "specimen",
            f"{found['grains']} grains, {found['elements']} elements in {found['clumps']} clumps, "
            f"{bonds['initial']} bonds",
        ),
        ("void ratio", f"{void['initial']:.4f} at the start, {void['final']:.4f} at the end"),
        ("yield", _stress(found["yield"])),
        ("sustained breakage", _stress(found["onset"])),
        (
            "bonds broken",
            f"{bonds['broken_in_tension']} in tension, {bonds['broken_in_shear']} in shear{share}",
        ),
        ("K0", f"{found['K0']['highest_stress']:.3g} at the highest stress"),
        (
            "energy",
            f"balance closes to {abs(found['energy']['error']):.2%} at stage ends, at worst",
        ),
        ("mass", f"of all fragments kept to {found['mass']['error']:.1g}"),
    ]
    return Content(
        what="Oedometer test",
        name=card["name"],
        summary=summary,
        pictures=pictures,
        grids=[Grid("Stages", HEADER, [_row(stage) for stage in found["stages"]])],
        card=card,
        card_hash=found["card_hash"],
        versions=found["versions"],
        repeat=["grus oedometer card.toml --out again"],
    )


def _row(stage: dict) -> list[str]:
    indices = stage["breakage"]
    return [
        stage_name(stage["kind"], stage["target"]),
        f"{1e-3 * stage['axial_stress']:.4g}",
        f"{100 * stage['axial_strain']:.3f}",
        f"{stage['void_ratio']:.4f}",
        f"{stage['K0']:.2f}",
        str(stage["tension_breaks"] + stage["shear_breaks"]),
        str(stage["fragments"]),
        *(f"{indices[name]:.3g}" if name in indices else "-" for name in ("hardin", "einav")),
        f"{100 * stage['energy_error']:.2g}",
    ]


def _stress(found: dict) -> str:
    if found["stress"] is None:
        return f"none; {found['why']}"
    low, high = (1e-3 * end for end in found["interval"])
    return f"{1e-3 * found['stress']:.3g} kPa ({found['confidence']:.0%} interval {low:.3g} to {high:.3g})"

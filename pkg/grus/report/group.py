"""The page of a group of crushing tests."""

from collections.abc import Sequence

from grus.report.content import Content, Grid, Picture

COLUMNS = {
    "grain": ("grain", 1, "d"),
    "strength MPa": ("strength_Pa", 1e-6, ".4g"),
    "peak force kN": ("peak_force_N", 1e-3, ".4g"),
    "at closing mm": ("peak_closing_m", 1e3, ".4g"),
    "largest stress MPa": ("max_strength_Pa", 1e-6, ".4g"),
    "bonds": ("bonds", 1, "d"),
    "broken in tension": ("tension_breaks", 1, "d"),
    "in shear": ("shear_breaks", 1, "d"),
    "fragments": ("fragments", 1, "d"),
    "energy error %": ("energy_error", 100, ".2g"),
}
"""Header -> name in result.json, factor, format."""


def group_content(found: dict, pictures: Sequence[Picture]) -> Content:
    """found: what result.json holds."""
    tests, card = found["tests"], found["card"]
    strength = [1e-6 * test["strength_Pa"] for test in tests]
    failed = found.get("failed", {})
    mean = sum(strength) / len(strength)
    summary = [
        ("grains", f"{found['grains']}, of which {found['broken']} crushed"),
        *[(f"grain {grain}", f"failed: {reason}") for grain, reason in failed.items()],
        ("strength", f"{mean:.3g} MPa on average, {min(strength):.3g} to {max(strength):.3g} MPa"),
        *_weibull(found["weibull"], "first drop of the force"),
        *_weibull(found["weibull_by_maximum"], "largest force"),
        (
            "energy",
            f"balance closes to {abs(found['worst_energy_error']):.2%} of the work, at worst",
        ),
    ]
    rows = [
        [format(test[name] * factor, form) for name, factor, form in COLUMNS.values()]
        for test in tests
    ]
    return Content(
        what="Crushing of single grains",
        name=card["name"],
        summary=summary,
        pictures=pictures,
        grids=[Grid("Grains", list(COLUMNS), rows)],
        card=card,
        card_hash=found["card_hash"],
        versions=found["versions"],
        repeat=[f"grus crush card.toml --grains {found['grains'] + len(failed)} --out again"],
    )


def _weibull(fit: dict, by: str) -> list[tuple[str, str]]:
    name = f"Weibull, {by}"
    if "refused" in fit:
        return [(name, f"no fit; {fit['refused']}")]
    low, high = fit["modulus_ci"]
    text = (
        f"modulus {fit['modulus']:.2f} ({fit['confidence']:.0%} interval {low:.2f} to {high:.2f}), "
        f"characteristic strength {1e-6 * fit['sigma0']:.3g} MPa"
    )
    if fit["p_value"] is not None:
        p = fit["p_value"]
        verdict = "not rejected" if p >= 0.05 else "REJECTED"
        shown = f"= {p:.2g}" if p >= 0.001 else "< 0.001"
        text += f", Anderson-Darling p {shown}: {verdict} at 5 %"
    return [(name, text)]

"""One screen about a group of crushing tests."""

import numpy as np

from grus.crushing.group import GroupResult


def summary(group: GroupResult) -> str:
    """Strengths, their Weibull distribution, breakage and the energy balance, in plain lines."""
    grains = group.grains
    strength = group.strengths / 1e6
    tension = sum(g.tension_breaks for g in grains)
    shear = sum(g.shear_breaks for g in grains)
    bonds = sum(g.bonds for g in grains)
    lines = [
        ("model", f"{group.card.name}, {group.card.dimension}D, seed {group.card.seed}"),
        ("grains", f"{len(grains)}, of which {int((~group.censored).sum())} crushed"),
        *_failed(group),
        ("a grain has", _mean(grains, "elements, clumps, bonds")),
        (
            "strength",
            f"{strength.mean():.3g} MPa on average, {strength.min():.3g} to {strength.max():.3g} MPa",
        ),
        *_weibull(group),
        (
            "bonds broken",
            f"{tension} in tension, {shear} in shear, {(tension + shear) / max(bonds, 1):.0%} of all",
        ),
        (
            "energy",
            f"balance closes to {max(abs(g.energy_error) for g in grains):.2%} of the work, at worst",
        ),
    ]
    return "\n".join(f"{name:<14}{text}" for name, text in lines)


def _failed(group: GroupResult) -> list[tuple[str, str]]:
    if not group.failed:
        return []
    grain, reason = next(iter(group.failed.items()))
    return [
        ("failed", f"{len(group.failed)} more, which count in nothing; grain {grain}: {reason}")
    ]


def _mean(grains: tuple, what: str) -> str:
    counts = np.mean(
        [[g.specimen.element_count, g.specimen.clump_count, g.bonds] for g in grains], axis=0
    )
    return ", ".join(f"{count:.0f} {name}" for count, name in zip(counts, what.split(", ")))


def _weibull(group: GroupResult) -> list[tuple[str, str]]:
    fit = group.weibull_or_reason()
    if isinstance(fit, str):
        return [("Weibull", f"no fit; {fit}")]
    low, high = fit.modulus_ci
    share = f"{fit.confidence:.0%}"
    lines = [
        ("Weibull", f"modulus {fit.modulus:.2f} ({share} interval {low:.2f} to {high:.2f})"),
        ("", f"characteristic strength {fit.sigma0 / 1e6:.3g} MPa"),
    ]
    if fit.p_value is not None:
        verdict = "not rejected" if fit.p_value >= 0.05 else "REJECTED"
        lines.append(("", f"Anderson-Darling p = {fit.p_value:.2f}: {verdict} at 5 %"))
    return lines

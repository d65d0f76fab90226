"""Looking for the strength at which a mechanism has a wanted effect, with few and noisy runs."""

from collections.abc import Sequence


def next_strength(points: Sequence[tuple[float, float]], farthest: float) -> float:
    """Strength to be run next, on a logarithmic scale.

    points: strengths that were run, and the logarithms of the effect of each over the wanted one. Between strengths of smaller
    and of larger effect it is where the line through the nearest two meets 0; where noise has mixed them, through the two of nearest
    effect. Beyond all that was run it is where the line through the last two does, but not more than `farthest` away.
    """
    below, above = [p for p in points if p[1] < 0], [p for p in points if p[1] >= 0]
    if below and above:
        (low, under), (high, over) = max(below), min(above)
        if low > high:
            low, under = max(below, key=lambda p: p[1])
            high, over = min(above, key=lambda p: p[1])
        return low - under * (high - low) / (over - under)
    (end, effect), *others = sorted(points, reverse=bool(below))
    rise = (effect - others[0][1]) / (end - others[0][0]) if others else 0.0
    away = min(abs(effect) / rise, farthest) if rise > 0 else farthest
    return end + away if below else end - away

"""A score on one screen."""

from grus.proof.score import BETTER, CLEAR, Count, Score

AIMS = {
    "named": (f"single effects above {CLEAR:g} times the scatter named, nothing else", 0.9),
    "pairs": ("pairs of such effects, both named", 0.7),
    "quiet": ("trials without effect, nothing named", 0.95),
    "unknown": ('effects outside the library called unknown or "cannot tell"', 0.8),
    "weak": ("weak effects, nothing wrong named", None),
    "improved": (f"error on stages left out fell {BETTER:g} times or more", None),
}
"""What is counted, and the share that is asked for."""


def summary(found: Score) -> str:
    """Counts beside what is asked for."""
    lines = []
    for name, (words, aim) in AIMS.items():
        count: Count = getattr(found, name)
        share = "" if count.all == 0 else f"{count.share:6.0%}"
        asked = "" if aim is None else f"   asked: {aim:.0%}"
        lines.append(f"{words:66s} {count.good:3d} of {count.all:3d} {share:>6s}{asked}")
    lines.append(f"{'mean square error of stated probabilities (Brier)':66s} {found.brier:.3f}")
    return "\n".join(lines)

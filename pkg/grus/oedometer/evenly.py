"""Choosing some of many."""


def evenly(count: int, most: int) -> list[int]:
    """The numbers 0 to count - 1, or `most` (2 or more) of them, first and last included and as even as can be."""
    if count <= most:
        return list(range(count))
    return [round(i * (count - 1) / (most - 1)) for i in range(most)]

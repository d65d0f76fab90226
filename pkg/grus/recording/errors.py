"""Refusal of a recording."""

from grus.card.show import shorten
from grus.errors import GrusError, one_line


class RecordingError(GrusError):
    """A recording is refused, in one line: `FILE: PLACE: what is wrong; allowed: ...`."""

    @classmethod
    def of(cls, source: str, place: str, reason: str, allowed: str = "") -> "RecordingError":
        """place: column and line, '' where it is the file as a whole."""
        parts = [one_line(source), one_line(place)] if place else [one_line(source)]
        message = f"{': '.join(parts)}: {one_line(reason)}"
        return cls(message + (f"; allowed: {one_line(allowed)}" if allowed else ""))


def quoted(text: object) -> str:
    """A cell or header as a message repeats it: in quotes, cut short."""
    return f'"{one_line(shorten(str(text)))}"'

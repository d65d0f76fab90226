"""The header of a recording: which column is which channel, in which unit."""

import re

from grus.recording.channels import BY_KEY, CHANNELS, Channel, key
from grus.recording.errors import RecordingError, quoted
from grus.recording.table import Table

_HEADER = re.compile(r"(.*?)\s*(?:\[([^\]]*)\]|\(([^)]*)\))\s*", re.DOTALL)


def split(text: str) -> tuple[str, str]:
    """Name and unit of a column, '' for a unit that is not given: `axial_stress [kPa]`, `axial stress (kPa)`."""
    match = _HEADER.fullmatch(text)
    if match is None:
        return text.strip(), ""
    return match[1].strip(), (match[2] if match[2] is not None else match[3]).strip()


def columns(table: Table) -> tuple[dict[str, tuple[int, str]], list[str]]:
    """Index and unit of the column of each channel by the channel's name, and the columns that are none.

    RecordingError for a channel that occurs twice, and without a stress or a strain.
    """
    found: dict[str, tuple[int, str]] = {}
    others: list[str] = []
    for index, text in enumerate(table.header):
        name, unit = split(text)
        channel = BY_KEY.get(key(name))
        if channel is None:
            others += [text] if text else []
            continue
        if channel.name in found:
            both = f"{quoted(table.header[found[channel.name][0]])} and {quoted(text)}"
            reason = f"two columns for {channel.name}: {both}"
            raise RecordingError.of(table.source, "header", reason, "one column each")
        found[channel.name] = (index, unit)
    for what, names in (("stress", ["axial_stress"]), ("strain", ["axial_strain", "settlement"])):
        if not any(name in found for name in names):
            headers = ", ".join(quoted(text) for text in table.header[:8] if text)
            allowed = " or ".join(_example(name) for name in names)
            reason = f"no column with a {what} among {headers}"
            raise RecordingError.of(table.source, "header", reason, allowed)
    return found, others


def _example(name: str) -> str:
    return next(channel.example for channel in CHANNELS if channel.name == name)


def channel_of(name: str) -> Channel:
    """The channel of that name."""
    return BY_KEY[key(name)]

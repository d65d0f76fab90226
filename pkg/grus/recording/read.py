"""Reading a recording."""

import hashlib
from os import PathLike
from pathlib import Path

import numpy as np

from grus.card.errors import Problem
from grus.card.interval import POSITIVE
from grus.card.quantity import Quantity
from grus.record import Record
from grus.recording.channels import CHANNELS
from grus.recording.clean import Readings, drop_missing, merge_stamps
from grus.recording.errors import RecordingError, quoted
from grus.recording.header import channel_of, columns
from grus.recording.numbers import check_decimals, numbers, stamps
from grus.recording.sense import check
from grus.recording.spreadsheet import MAGIC, read_spreadsheet
from grus.recording.table import Table
from grus.recording.text_file import read_text
from grus.recording.units import UnitError, to_si

HEIGHT = Quantity({"m": "a length"}, POSITIVE, "20 mm")
LARGEST = 300_000_000  # bytes


def read(path: str | PathLike, *, height: str | None = None, sheet: str | None = None) -> Record:
    """Record of a laboratory test from a CSV or xlsx file, all channels in SI, compression positive.

    height: of the specimen ("20 mm"), needed for settlements when no comment `# height = 20 mm` gives it. sheet: of a
    spreadsheet, by default the first that has a channel in its header.

    `axial_stress` and `axial_strain` are always there; `time` and the others where the file has them, with NaN for
    readings that are missing. `meta` holds the file's name, its SHA-256, the height if there is one, and the comments;
    `notes` what was done to the readings. Raises RecordingError, a GrusError, for what is no recording.
    """
    source = str(path)
    content = _content(path, source)
    if content.startswith(MAGIC):
        table = read_spreadsheet(content, source, sheet)
    else:
        table = read_text(content, source)
    found, others = columns(table)
    readings, strain_unit = _readings(table, found, others, _height(table, height, found))
    if "time" in readings.channels:
        merge_stamps(readings)
    check(readings, strain_unit)
    meta: dict[str, str | float] = {f"comment {name}": v for name, v in table.comments.items()}
    meta["source"] = Path(source).name
    meta["sha256"] = hashlib.sha256(content).hexdigest()
    given = _height(table, height, found)
    if given is not None:
        meta["height"] = float(given)
    units = {channel.name: channel.unit for channel in CHANNELS}
    channels = {
        channel.name: readings.channels[channel.name]
        for channel in CHANNELS
        if channel.name in readings.channels
    }
    return Record(
        channels, {name: units[name] for name in channels}, meta, notes=tuple(readings.notes)
    )


def _content(path: str | PathLike, source: str) -> bytes:
    try:
        with Path(path).open("rb") as file:
            content = file.read(LARGEST + 1)
    except OSError as error:
        reason = f"cannot be read: {error.strerror}"
        raise RecordingError.of(source, "", reason, "a CSV or xlsx file") from None
    except ValueError:
        raise RecordingError.of(
            source, "", "not the name of a file", "a CSV or xlsx file"
        ) from None
    if not content.strip():
        raise RecordingError.of(source, "", "empty", "a header with units and lines of numbers")
    if len(content) > LARGEST:
        raise RecordingError.of(source, "", "too large for a recording", f"{LARGEST} bytes")
    return content


def _height(table: Table, height: str | None, found: dict[str, tuple[int, str]]) -> float | None:
    """Height of the specimen [m], that of the caller before that of the file."""
    written = height
    if written is None:
        written = next((v for k, v in table.comments.items() if k.casefold() == "height"), None)
    if written is None:
        if "axial_strain" not in found:
            reason = "a settlement needs the height of the specimen"
            allowed = 'a comment "# height = 20 mm", or the height given with the file'
            raise RecordingError.of(table.source, "", reason, allowed)
        return None
    try:
        return float(HEIGHT.read(written))
    except Problem as problem:
        place = f"height = {quoted(written)}"
        raise RecordingError.of(table.source, place, problem.reason, problem.allowed) from None


def _readings(
    table: Table, found: dict[str, tuple[int, str]], others: list[str], height: float | None
) -> tuple[Readings, str]:
    """Channels in SI, without the lines that lack one that is needed; and the unit of the strain in the header."""
    if len(table.rows) < 2:
        raise RecordingError.of(
            table.source, "", f"lines of numbers: {len(table.rows)}", "two or more"
        )
    readings = Readings(table.source, {}, np.array(table.lines), list(table.notes))
    if others:
        names = ", ".join(quoted(name) for name in others[:8])
        readings.notes.append(f"columns that are no channel, not read: {names}")
    if "axial_strain" in found and "settlement" in found:
        readings.notes.append("settlement not read, since there is an axial_strain")
        found = {name: place for name, place in found.items() if name != "settlement"}
    check_decimals(table, [index for index, _ in found.values()])
    for name, (index, unit) in found.items():
        readings.channels[name] = _column(table, name, index, unit)
    needed = ["axial_stress", "axial_strain" if "axial_strain" in found else "settlement"]
    drop_missing(readings, needed + ["time"] * ("time" in found))
    for name in list(readings.channels):
        if np.isnan(readings.channels[name]).all():
            del readings.channels[name]
            readings.notes.append(f"{name} not read: no numbers in it")
    if "settlement" in readings.channels:
        readings.channels["axial_strain"] = readings.channels.pop("settlement") / height
        readings.notes.append(f"axial strain: settlement over a height of {1e3 * height:g} mm")
    events = readings.channels.get("ae_events")
    if events is not None and (np.diff(events[~np.isnan(events)]) < 0).any():
        readings.channels["ae_events"] = np.nancumsum(events)
        readings.notes.append("ae_events added up, since they are counts of each reading")
    return readings, found.get("axial_strain", (0, ""))[1]


def _column(table: Table, name: str, index: int, unit: str) -> np.ndarray:
    """A channel (n,) in SI."""
    channel = channel_of(name)
    if name == "time" and not unit:
        seconds = stamps(table, index)
        if seconds is not None:
            return seconds
    if not unit and name != "ae_events":
        place = f"column {quoted(table.header[index])}"
        raise RecordingError.of(
            table.source, place, "no unit", f"{channel.what}, {channel.example}"
        )
    values = numbers(table, index)
    try:
        converted = to_si(values, unit or "1", channel)
    except UnitError as error:
        place = f"column {quoted(table.header[index])}"
        allowed = f"{channel.what}, for example {channel.example}"
        raise RecordingError.of(table.source, place, str(error), allowed) from None
    return converted

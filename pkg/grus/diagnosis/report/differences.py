"""Where recording and base differ, cell by cell."""

from dataclasses import dataclass

import numpy as np

from grus.diagnosis.diagnosis import Diagnosis
from grus.diagnosis.layout import Entry
from grus.diagnosis.report.spoken import quantity
from grus.diagnosis.report.stages import CHANNELS, done
from grus.diagnosis.report.words import CLEAR, chance


@dataclass(frozen=True)
class Row:
    """A row of the map: a stage with a field a cell, or a ratio of stresses with a field a stage.

    name: what was done. share: of the misfit. clear: whether it is more than noise and scatter explain. fields: words in each, where the cell ends or the number of the stage.
    deviations (m,): recording less base in standard deviations of noise and scatter.
    """

    name: str
    share: float
    clear: bool
    fields: tuple[str, ...]
    deviations: np.ndarray


def differences(diagnosis: Diagnosis) -> list[Row]:
    """All that is compared, stages first."""
    compared = diagnosis.calibration.compared
    spread = np.sqrt(np.diag(diagnosis.library.covariance + compared.noise))
    scaled = diagnosis.difference / spread
    # The misfit has the same order.
    misfit, found = iter(diagnosis.misfit), []
    for place, segment in enumerate(diagnosis.protocol.segments):
        own = np.flatnonzero(compared.where(stage=place, channel="strain"))
        if len(own):
            fields = tuple(_end(diagnosis, compared.entries[i]) for i in own)
            name = f"{segment.stage}  {done(segment)}"
            one = next(misfit)
            clear = chance(diagnosis, one) < CLEAR
            found.append(Row(name, one.share, clear, fields, scaled[own]))
    for channel, words in CHANNELS.items():
        own = np.flatnonzero(compared.where(channel=channel))
        if channel != "strain" and len(own):
            stages = [diagnosis.protocol.segments[compared.entries[i].stage].stage for i in own]
            parts = [one for one in diagnosis.misfit if one.channel == channel]
            share = sum(one.share for one in parts)
            clear = any(chance(diagnosis, one) < CLEAR for one in parts)
            fields = tuple(f"stage {stage}" for stage in stages)
            found.append(Row(words, share, clear, fields, scaled[own]))
    return found


def _end(diagnosis: Diagnosis, entry: Entry) -> str:
    """Where a cell ends, in words."""
    segment = diagnosis.protocol.segments[entry.stage]
    if entry.kind != "hold":
        return quantity(entry.end, "Pa")
    if segment.t0 is None:
        return "end"
    return quantity(entry.end * (segment.t1 - segment.t0), "s")

"""Compression curves: yield, onset of breakage, compression and swelling index.

Pure functions of numbers; nothing here needs YADE.
"""

from grus.compression.index import CompressionIndex, compression_index
from grus.compression.loading import first_loading
from grus.compression.onset import BreakageOnset, breakage_onset
from grus.compression.yielding import YieldStress, yield_stress

__all__ = [
    "BreakageOnset",
    "CompressionIndex",
    "YieldStress",
    "breakage_onset",
    "compression_index",
    "first_loading",
    "yield_stress",
]

"""Public recordings of laboratory tests: list, fetch, and read as records."""

from grus.public_data.catalogue import DATASETS
from grus.public_data.dataset import Dataset, Origin
from grus.public_data.store import fetch, find_dataset, is_kept, load

__all__ = ["DATASETS", "Dataset", "Origin", "fetch", "find_dataset", "is_kept", "load"]

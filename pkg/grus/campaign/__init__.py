"""Many runs of the same kind of test: on the cores of this machine or on a cluster, each stored when it is over."""

from importlib import import_module

from grus.campaign.outcome import Outcome
from grus.campaign.run import Run
from grus.campaign.store import Store

__all__ = ["Outcome", "Run", "Store", "campaign", "workers"]

_OF_DASK = {"campaign": "grus.campaign.conduct", "workers": "grus.campaign.cluster"}


def __getattr__(name: str) -> object:
    # At first use, so that the processes of the simulations do not wait for Dask.
    if name not in _OF_DASK:
        raise AttributeError(f"module 'grus.campaign' has no attribute '{name}'")
    return getattr(import_module(_OF_DASK[name]), name)

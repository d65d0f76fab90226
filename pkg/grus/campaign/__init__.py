"""Many runs of the same kind of test: on the cores of this machine or on a cluster, each stored when it is over."""

from importlib import import_module

__all__ = ["Outcome", "Run", "Store", "campaign", "workers"]

_FILES = {
    "Outcome": "grus.campaign.outcome",
    "Run": "grus.campaign.run",
    "Store": "grus.campaign.store",
    "campaign": "grus.campaign.conduct",
    "workers": "grus.campaign.cluster",
}


def __getattr__(name: str) -> object:
    # At first use: the processes of the simulations do not wait for Dask, and Dask's workers not for cards.
    if name not in _FILES:
        raise AttributeError(f"module 'grus.campaign' has no attribute '{name}'")
    return getattr(import_module(_FILES[name]), name)

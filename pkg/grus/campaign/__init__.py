"""Many runs of the same kind of test: on the cores of this machine or on a cluster, each stored when it is over."""

from grus.lazy import at_first_use

__all__ = ["Outcome", "Run", "Store", "campaign", "workers"]

# At first use: the processes of the simulations do not wait for Dask, and Dask's workers not for cards.
__getattr__ = at_first_use(
    __name__,
    {
        "Outcome": "grus.campaign.outcome",
        "Run": "grus.campaign.run",
        "Store": "grus.campaign.store",
        "campaign": "grus.campaign.conduct",
        "workers": "grus.campaign.cluster",
    },
)

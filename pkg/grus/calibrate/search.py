"""Where the next trials are made: optuna's tree-structured Parzen estimator (Bergstra et al. 2011)."""

import warnings
from collections.abc import Sequence

import optuna
from scipy.stats import qmc

from grus.calibrate.parameter import Parameter

FIRST = 8
"""Trials that a Sobol sequence spreads over the bounds before the search learns from them."""


class Search:
    """Trials follow from parameters, seed and the misfits of the trials before, whatever the number of workers.

    Its state is therefore nowhere stored: a search that was cut off is gone through again, with runs from the store.
    """

    def __init__(self, parameters: Sequence[Parameter], seed: int) -> None:
        optuna.logging.set_verbosity(optuna.logging.WARNING)
        self._names = [parameter.name for parameter in parameters]
        with warnings.catch_warnings():
            # Two options that optuna calls experimental, and which are in the versions of both Debians.
            warnings.simplefilter("ignore", optuna.exceptions.ExperimentalWarning)
            sampler = optuna.samplers.TPESampler(
                n_startup_trials=FIRST, multivariate=True, constant_liar=True, seed=seed
            )
        self._study = optuna.create_study(sampler=sampler)
        for point in qmc.Sobol(len(self._names), seed=seed).random(FIRST):
            self.propose(point.tolist())

    def propose(self, shares: Sequence[float]) -> None:
        """The next trial to be asked for is this one."""
        self._study.enqueue_trial(dict(zip(self._names, shares)))

    def ask(self) -> tuple[int, tuple[float, ...]]:
        """Number of the next trial, and the share of each parameter."""
        trial = self._study.ask()
        return trial.number, tuple(trial.suggest_float(name, 0.0, 1.0) for name in self._names)

    def tell(self, number: int, misfit: float) -> None:
        """How the trial went."""
        self._study.tell(number, misfit)

"""Real samples: fits against a direct search, and the physics that their authors report."""

import numpy as np
import pandas as pd
import pytest
from scipy.optimize import minimize
from scipy.stats import weibull_min

from grus.statistics import fit_weibull, size_effect


def test_concrete_fatigue_lives(static_fatigue):
    """Plain-concrete lives at five stress ratios, complete groups of 15 (Castillo & Hadi 1995)."""
    table = pd.read_csv(static_fatigue / "concrete.csv")
    for _, group in table.groupby("ratio"):
        lives = group["kilocycles"].to_numpy()
        fit = fit_weibull(lives)
        shape, _, scale = weibull_min.fit(lives, floc=0)
        assert (fit.n, fit.broken) == (15, 15)
        assert (fit.modulus, fit.sigma0) == pytest.approx((shape, scale), rel=1e-4)
        assert fit.p_value > 0.01


def test_kevlar_vessels(static_fatigue):
    """Stress-rupture lives under constant pressure, 22 of them right-censored.

    The regression takes any covariate that acts as a power: here the pressure.
    """
    table = pd.read_csv(static_fatigue / "kevlarvessels.csv")
    table = table.loc[table.index.repeat(table["count"])]
    fits = {
        pressure: fit_weibull(group["time"], censored=group["event"].to_numpy() == 0)
        for pressure, group in table.groupby("pressure")
    }
    assert {p: fit.n - fit.broken for p, fit in fits.items()} == {
        3400: 16,
        3700: 6,
        4000: 0,
        4300: 0,
    }
    effect = size_effect(list(fits), list(fits.values()), 3)
    x = np.log(table["pressure"] / 4000.0).to_numpy()
    time, broken = table["time"].to_numpy(), table["event"].to_numpy() == 1

    def loss(p):
        law = np.exp(p[0]), 0.0, np.exp(p[1] + p[2] * x)
        return -np.where(
            broken, weibull_min.logpdf(time, *law), weibull_min.logsf(time, *law)
        ).sum()

    options = {"xatol": 1e-9, "fatol": 1e-12, "maxiter": 5000}
    found = minimize(loss, [0.0, 7.0, -20.0], method="Nelder-Mead", options=options)
    assert effect.modulus == pytest.approx(np.exp(found.x[0]), rel=1e-6)
    assert effect.slope == pytest.approx(found.x[2], rel=1e-6)
    assert effect.strength(4000.0) == pytest.approx(np.exp(found.x[1]), rel=1e-6)
    # delayed failure: life falls with a high power of the pressure
    assert effect.slope_ci[1] < -10.0

"""Grus's classes are YADE classes like any other."""

import grus
import pytest
from yade import O, utils
from yade.wrapper import BondLedger, BondMat, BondPhys, BondState, CrushingPlatens

CLASSES = [
    grus.BondAgeing,
    grus.BondLedger,
    grus.BondMat,
    grus.BondPhys,
    grus.BondState,
    grus.BondTimeStepper,
    grus.CrushingPlatens,
    grus.GrainLoop,
    grus.InteractionSorter,
    grus.Ip2_BondMat_BondMat_BondPhys,
    grus.Law2_ScGeom_BondPhys_Bonded,
]


@pytest.mark.parametrize("cls", CLASSES)
def test_every_attribute_is_explained(cls):
    assert cls.__doc__.strip()
    for name in cls().dict():
        if name in vars(cls):
            assert len(vars(cls)[name].__doc__.split(":ydefault:")[0].strip()) > 10, name


def test_keywords_and_attributes():
    material = BondMat(bond="parallel", tensileStrength=3e6, kn=1e9)
    assert (material.bond, material.tensileStrength, material.kn) == ("parallel", 3e6, 1e9)
    material.tensileStrength = 4e6
    assert material.dict()["tensileStrength"] == 4e6


@pytest.mark.parametrize(
    "key, value, allowed",
    [
        ("bond", "glue", "'contact', 'none', 'parallel'"),
        ("bondStiffness", "N/m", "'area', 'modulus', 'total'"),
        ("scatter", "uniform", "'none', 'normal', 'weibull'"),
        ("tensileStrength", -1.0, "0 or more"),
        ("momentContribution", 1.5, "0 to 1"),
        ("bondRadiusRatio", 0.0, "more than 0"),
        ("bondFrictionAngle", 1.6, "0 to below pi/2"),
        ("kn", float("nan"), "a finite number"),
        ("ks", float("inf"), "a finite number"),
        ("bondKn", float("inf"), "0 or more"),
        ("grainModulus", -1.0, "0 or more"),
    ],
)
def test_bad_material_is_refused(key, value, allowed):
    with pytest.raises(ValueError) as refusal:
        BondMat(**{key: value})
    assert f"BondMat.{key}" in str(refusal.value) and allowed in str(refusal.value)
    with pytest.raises(ValueError):
        setattr(BondMat(), key, value)


def test_bad_platens_are_refused():
    with pytest.raises(ValueError, match="control = 'slowly'; allowed: 'force', 'speed'"):
        CrushingPlatens(control="slowly")
    with pytest.raises(ValueError, match="peakDrop"):
        CrushingPlatens(peakDrop=1.0)


def test_platens_without_walls_end_the_run_with_one_line():
    O.reset()
    O.engines = [CrushingPlatens(bottom=3, top=4, speed=1)]
    with pytest.raises(RuntimeError, match="no body with id 3"):
        O.step()


def test_material_makes_its_state():
    assert isinstance(BondMat().newAssocState(), BondState)


def test_results_are_read_only():
    with pytest.raises(AttributeError):
        BondPhys().bonded = True
    with pytest.raises(AttributeError):
        BondLedger().slidingWork = 1.0


def test_scatter_needs_its_parameter():
    with pytest.raises(ValueError, match="BondMat.scatterParameter = 0; allowed: more than 0"):
        BondMat(scatter="weibull")
    with pytest.raises(ValueError, match="BondMat.scatterParameter = 50; allowed: below 1"):
        BondMat(scatter="normal", scatterParameter=50)
    assert BondMat(scatter="weibull", scatterParameter=3).scatter == "weibull"


@pytest.mark.parametrize(
    "key, settings", [("speed", {}), ("forceRate", {"speed": 1, "control": "force"})]
)
def test_platens_that_would_never_close_are_refused(key, settings):
    O.reset()
    walls = [O.bodies.append(utils.wall(float(z), axis=1)) for z in (0, 1)]
    O.engines = [CrushingPlatens(bottom=walls[0], top=walls[1], **settings)]
    with pytest.raises(ValueError, match=f"CrushingPlatens.{key} = 0"):
        O.step()

"""The oedometer's servo on a column of three grains."""

import random

import pytest
from box import Box
from scenes import engine
from yade import O
from yade.wrapper import OedometerServo

STRONG = {"bond__tensile_strength": "1 GPa", "bond__shear_strength": "1 GPa"}


@pytest.fixture(scope="module")
def stages() -> dict[str, dict]:
    """What the servo said at the end of three stages of a column that does not break."""
    box = Box(**STRONG)
    found = {}
    for name, stress in {"first": 100e3, "second": 200e3, "back": 100e3}.items():
        box.stage(stress)
        s = box.servo
        names = ("topStress", "bottomStress", "strain", "voidRatio", "K0", "unbalanced", "work")
        found[name] = {key: getattr(s, key) for key in names} | {"stress": stress}
    found["record"] = {name: getattr(s, name) for name in dir(s) if name.startswith("record")}
    return found


@pytest.mark.parametrize("name", ["first", "second", "back"])
def test_ends_at_the_target_and_at_rest(stages, name):
    stage = stages[name]
    for platen in ("topStress", "bottomStress"):
        assert abs(stage[platen] / stage["stress"] - 1) <= 0.01
    assert stage["unbalanced"] <= 1e-3


def test_strain_and_void_ratio_follow_the_stress(stages):
    first, second, back = (stages[name] for name in ("first", "second", "back"))
    assert 0 < first["strain"] < second["strain"] and back["strain"] < second["strain"]
    assert first["voidRatio"] > second["voidRatio"] < back["voidRatio"]
    assert 0 < second["K0"] < 1


def test_record_holds_all_stages_in_order(stages):
    record = stages["record"]
    assert {
        len(series)
        for name, series in record.items()
        if name not in ("recordStrain", "recordStress")
    } == {len(record["recordHeight"])}
    assert sorted(set(record["recordStage"])) == [0, 1, 2]
    assert record["recordStage"] == sorted(record["recordStage"])
    assert record["recordTension"][-1] == record["recordShear"][-1] == 0


def test_energy_balance_closes(stages):
    r = {
        name[6:].lower(): series[-1]
        for name, series in stages["record"].items()
        if isinstance(series, list)
    }
    spent = r["elastic"] + r["kinetic"] + r["released"] + r["sliding"] + r["damped"]
    assert spent == pytest.approx(r["work"], abs=0.01 * max(stages["record"]["recordWork"]))


def test_platens_never_pass_the_speed_limit_whatever_the_stiffness_does():
    box = Box(servo={"maxSpeed": 0.05, "relaxation": 1.0})
    box.servo.begin(1e6)
    jump = random.Random(3)
    fastest = 0.0
    for _ in range(150):
        O.run(25, True)
        platens = [O.bodies[wall].state.vel[1] for wall in box.walls[1]]
        fastest = max(fastest, *map(abs, platens))
        for wall in box.walls[1]:
            for contact in O.bodies[wall].intrs():
                if contact.isReal:
                    contact.phys.kn = 10 ** jump.uniform(5, 11)
    assert fastest == 0.05


def test_side_walls_stay():
    box = Box()
    before = [O.bodies[wall].state.pos[0] for wall in box.walls[0]]
    box.servo.begin(100e3)
    O.run(2000, True)
    assert [O.bodies[wall].state.pos[0] for wall in box.walls[0]] == before


def test_goes_on_bit_by_bit_after_loading(tmp_path):
    box = Box()
    box.servo.begin(100e3)
    O.run(3000, True)
    O.save(str(tmp_path / "box.yade.gz"))
    O.run(3000, True)
    expected = [tuple(body.state.pos) for body in O.bodies], list(box.servo.recordTop)
    O.reset()
    O.load(str(tmp_path / "box.yade.gz"))
    O.run(3000, True)
    found = [tuple(body.state.pos) for body in O.bodies], list(engine(OedometerServo).recordTop)
    assert found == expected


def test_adaptive_speed_is_slow_while_bonds_break():
    box = Box(
        servo={
            "maxSpeed": 0.05,
            "fastSpeed": 0.4,
            "kineticLimit": 1e9,
            "gradientLimit": 1e9,
            "inertialLimit": 1e9,
        }
    )
    box.servo.begin(5e6)  # far beyond what the column can carry
    O.run(1000, True)
    assert 0.05 < box.servo.speedLimit <= 0.4
    while box.servo.ledger.breaks == 0:
        O.run(100, True)
    assert box.servo.speedLimit == 0.05


@pytest.mark.parametrize(
    "key, value",
    [
        ("tolerance", 0.0),
        ("maxSpeed", 0.0),
        ("relaxation", 2.0),
        ("fastSpeed", 1e-9),
        ("moving", "base"),
    ],
)
def test_bad_settings_are_refused(key, value):
    with pytest.raises(ValueError, match=f"OedometerServo.{key}"):
        OedometerServo(**{key: value})


def test_bad_targets_and_walls_are_refused():
    with pytest.raises(ValueError, match="more than 0 Pa"):
        OedometerServo().begin(0.0)
    box = Box()
    box.servo.begin(100e3)
    O.bodies[box.servo.top].state.pos = (0, -1, 0)
    with pytest.raises(RuntimeError, match="the platens have met"):
        O.step()
    box = Box()
    box.servo.sides = [99]
    box.servo.begin(100e3)
    with pytest.raises(RuntimeError, match="body 99 of sides is not a Wall"):
        O.step()

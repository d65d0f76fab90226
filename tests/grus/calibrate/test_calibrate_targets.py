"""Files of targets: what they may hold, and what is refused."""

from pathlib import Path

import numpy as np
import pytest

from grus.calibrate import read_targets
from grus.card import Card
from grus.errors import GrusError

ROOT = Path(__file__).parents[3]
MODELS = ROOT / "models"
FITTED = '[parameters]\nbond.tensile_strength = { low = "1 MPa", high = "2 MPa" }\n'
WANTED = "[targets]\nweibull_modulus = { value = 3, tolerance = 0.5 }\n"


def test_values_are_in_si(card, write):
    text = FITTED + '[targets]\nyield_stress = { value = "300 kPa", tolerance = "0.02 MPa" }'
    found = read_targets(write(text), card)
    assert (found.parameters[0].low, found.parameters[0].high) == (1e6, 2e6)
    assert found.targets[0].values == (3e5,) and found.targets[0].tolerance == 2e4
    assert found.grains == 30 and found.specimens == 1


def test_value_of_a_share(card, write):
    text = '[parameters]\nbond.tensile_strength = { low = "1 MPa", high = "4 MPa", logarithmic = true }\n'
    parameter = read_targets(write(text + WANTED), card).parameters[0]
    assert [parameter.value(share) for share in (0, 0.5, 1)] == [1e6, 2e6, 4e6]
    assert parameter.overrides(2e6) == {"bond.tensile_strength": "2000000.0 Pa"}


def test_recording_as_a_curve(card, write, tmp_path):
    stress = np.concatenate([np.geomspace(1, 500, 60), [100]])
    rows = "".join(f"{s:.6g},{0.01 * s:.6g}\n" for s in stress)
    (tmp_path / "test.csv").write_text("axial_stress [kPa],axial_strain [%]\n" + rows)
    text = FITTED + '[targets]\ncompression_curve = { file = "test.csv", tolerance = 1e-4 }'
    curve = read_targets(write(text), card).targets[0]
    assert len(curve.stress) == len(curve.values) == 20
    assert 5e3 <= curve.stress[0] and curve.stress[-1] <= 3e5, "what the card tests"
    first, last = (1e-7 * s for s in (curve.stress[0], curve.stress[-1]))
    assert curve.values[0] == 0
    assert curve.values[-1] == pytest.approx((last - first) / (1 - first), rel=1e-3)


def test_shipped_targets_fit_the_shipped_card():
    card = Card.from_file(MODELS / "montesinho.toml")
    assert read_targets(MODELS / "targets" / "montesinho.toml", card).parameters


def test_targets_on_the_page_are_good(write):
    page = (ROOT / "docs" / "commands" / "calibrate.md").read_text("utf-8")
    text = page.partition("```toml\n")[2].partition("```")[0]
    found = read_targets(write(text), Card.from_file(MODELS / "quick.toml"))
    assert len(found.parameters) == 2 and len(found.targets) == 4


@pytest.mark.parametrize(
    "text, complaint",
    [
        ("", "parameters: is missing"),
        (WANTED, "parameters: is missing"),
        (FITTED, "targets: is missing"),
        ("[parameters]\n" + WANTED, "no key to fit"),
        (FITTED + "[targets]", "no target"),
        (FITTED + WANTED + "[limits]", "limits = a table: unknown key"),
        ("grains = 2\n" + FITTED + WANTED, "grains = 2: out of bounds"),
        (FITTED + "[targets]\nstrength = 3", "targets.strength = 3: unknown key"),
        (FITTED + "[targets]\nweibull_modulus = 3", "targets.weibull_modulus = 3: not a table"),
        (
            FITTED + "[targets]\nweibull_modulus = { value = 3 }",
            "targets.weibull_modulus.tolerance: is missing",
        ),
        (
            FITTED + '[targets]\nyield_stress = { value = "1 kg", tolerance = "1 Pa" }',
            "yield_stress.value",
        ),
        (FITTED.replace("tensile", "tensle") + WANTED, "parameters.bond.tensle_strength"),
        (FITTED.replace("2 MPa", "2 m") + WANTED, 'strength.high = "2 m"'),
        (FITTED.replace("2 MPa", "2 N") + WANTED, "bounds in N and Pa"),
        (FITTED.replace("2 MPa", "1 MPa") + WANTED, "low below high"),
        (FITTED.replace(" }", ', tied = ["bond.tensile_strength"] }') + WANTED, "fitted twice"),
        (FITTED.replace(" }", ', tied = ["bond.kind"] }') + WANTED, "bond.kind is no key"),
        (
            "[parameters]\nbond.kind = { low = 1, high = 2 }\n" + WANTED,
            "no key of a card that holds a number",
        ),
        ("[parameters]\nbond.grain_scatter.modulus = 3\n" + WANTED, "not a table"),
        (
            "[parameters]\nbond.scatter.coefficient_of_variation = { low = 0.1, high = 0.2 }\n"
            + WANTED,
            "parameters.bond.scatter.coefficient_of_variation.low: ",
        ),
        (FITTED + "[targets.compression_curve]\ntolerance = 0.1", "no curve"),
        (FITTED + '[targets.compression_curve]\ntolerance = 0.1\nfile = "none.csv"', "none.csv"),
        (
            FITTED
            + '[targets.compression_curve]\ntolerance = 0.1\nstress = ["1 MPa"]\nvoid_ratio = [0.2]',
            "stresses that the stages of the card reach",
        ),
        (
            FITTED
            + '[targets.compression_curve]\ntolerance = 0.1\nstress = ["9 kPa", "8 kPa"]\nvoid_ratio = [0.2, 0.1]',
            "stresses that do not rise",
        ),
        (
            FITTED
            + '[targets.compression_curve]\ntolerance = 0.1\nstress = ["9 kPa"]\naxial_strain = [0.1]',
            "2 or more",
        ),
    ],
)
def test_nonsense_is_refused_in_one_line(card, write, text, complaint):
    path = write(text)
    with pytest.raises(GrusError) as refusal:
        read_targets(path, card)
    message = str(refusal.value)
    assert complaint in message and path.name in message or "none.csv" in message
    assert message.isprintable()


def test_card_without_the_test_is_refused(card, write):
    text = FITTED + '[targets]\nyield_stress = { value = "1 MPa", tolerance = "1 kPa" }'
    with pytest.raises(GrusError, match="oedometer is missing"):
        read_targets(write(text), card.with_overrides({"oedometer": None}))

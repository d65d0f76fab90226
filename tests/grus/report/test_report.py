"""Pages about folders of results: all kinds, and what is no such folder."""

import json
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pytest
import tomllib

import grus
from grus.campaign import Outcome, Run, Store
from grus.card import Card
from grus.commands import main
from grus.crushing import crush_group, write_report
from grus.errors import GrusError
from grus.record import Record
from grus.report import content_of, write_page
from grus.report.content import readable

PLANE = Path(__file__).parents[2] / "cards" / "plane.toml"
VERSIONS = {"grus": grus.__version__, "yade": "2023.02a", "python": "3.11.2"}


@pytest.fixture(scope="module")
def card() -> Card:
    return Card.from_file(PLANE)


@pytest.fixture(scope="module")
def crushed(card, tmp_path_factory) -> Path:
    folder = tmp_path_factory.mktemp("crushed")
    write_report(crush_group(card, 4, folder, jobs=1), folder)
    return folder


@pytest.fixture
def store(card, tmp_path) -> Store:
    """Two crushing tests, a recording, and one that failed."""
    store = Store(tmp_path / "store").make()
    closing = np.linspace(0, 1e-5, 9)
    force = Record({"closing": closing, "force": 1e9 * closing}, {"closing": "m", "force": "N"})
    for seed in (5, 7):
        run = Run("crush", card.with_overrides({"seed": seed}))
        figures = {"peak.strength": 1e6 + seed, "broken": 1.0, "bonds.broken": 3.0}
        store.save(_outcome(run, force, figures))
    stress = Record(
        {"axial_stress": 1e5 * (1 + closing), "axial_strain": closing},
        {"axial_stress": "Pa", "axial_strain": "1"},
    )
    store.save(_outcome(Run("recording", card), stress, {"K0.final": 0.5}))
    refused = Run("crush", card.with_overrides({"crush.peak_drop": 0.2}))
    store.save(
        Outcome(refused.key, "crush", refused.card.to_dict(), failed="<no> platens", refused=True)
    )
    return store


def _outcome(run: Run, record: Record, figures: dict) -> Outcome:
    card = run.card.to_dict()
    return Outcome(run.key, run.kind, card, run.grain, record, figures, versions=VERSIONS)


class Page(HTMLParser):
    """Sources of all that a page loads, and its text."""

    def __init__(self, path: Path) -> None:
        super().__init__()
        self.loaded, self.text = [], ""
        self.feed(path.read_text("utf-8"))

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ("src", "href"):
                self.loaded.append(value)

    def handle_data(self, data):
        self.text += data


def test_group_of_grains(crushed, card, tmp_path):
    page = Page(write_page(content_of(crushed), tmp_path / "page.html"))
    assert len([one for one in page.loaded if one.startswith("data:image")]) >= 2
    found = json.loads((crushed / "result.json").read_text())
    assert f"{1e-6 * found['tests'][2]['strength_Pa']:.4g}" in page.text
    for text in ("Weibull", "bond.tensile_strength", "1 MPa", found["card_hash"], "--grains 4"):
        assert text in page.text
    toml = page.text[page.text.index('name = "plane"') :]
    assert Card.from_dict(tomllib.loads(toml)) == card, "the card on the page is the card"


def test_nothing_is_loaded_from_elsewhere(crushed, store, tmp_path):
    for folder in (crushed, store.folder):
        page = Page(write_page(content_of(folder), tmp_path / "page.html"))
        assert page.loaded and all(one.startswith("data:") for one in page.loaded)


def test_campaign(store, card, tmp_path):
    content = content_of(store.folder)
    assert set(content.varied) == {"seed", "crush.peak_drop"}
    assert content.varied["seed"] == f"5, 7, {card.seed}"
    assert [grid.title for grid in content.grids] == [
        "Runs of the kind crush",
        "Runs of the kind recording",
    ]
    assert not any(key == "seed" for key, _ in content.parameters)
    page = Page(write_page(content, tmp_path / "page.html"))
    assert "<no> platens" in page.text and "4 (crush, recording), of which 1 failed" in page.text


def test_damaged_runs_are_told(store):
    path = next(iter(store.runs.iterdir()))
    path.write_bytes(path.read_bytes()[:-1])
    assert [path.name in note for note in content_of(store.folder).notes] == [True]


def test_oedometer(card, tmp_path):
    from grus.oedometer import oedometer
    from grus.oedometer import write_report as write

    folder = tmp_path / "test"
    gentle = card.with_overrides({"oedometer.stages": ["load to 20 kPa"]})
    write(oedometer(gentle, folder), folder)
    assert main(["report", str(folder)]) == 0
    page = Page(folder / "report.html")
    for text in ("load to 20 kPa", "void ratio", "grus oedometer card.toml"):
        assert text in page.text
    assert len([one for one in page.loaded if one.startswith("data:image")]) >= 5


@pytest.mark.parametrize("content", [None, "{", "[]", "{}", '{"files": []}'])
def test_other_folders_are_refused(tmp_path, capsys, content):
    if content is not None:
        (tmp_path / "result.json").write_text(content)
    assert main(["report", str(tmp_path)]) == 2
    complaint = capsys.readouterr().err
    assert len(complaint.splitlines()) == 1 and str(tmp_path) in complaint
    assert not (tmp_path / "report.html").exists()


def test_empty_store_is_refused(tmp_path):
    with pytest.raises(GrusError, match="no run in it"):
        content_of(Store(tmp_path).make().folder)


@pytest.mark.parametrize(
    "value, text",
    [
        ("1000000.0 Pa", "1 MPa"),
        ("3000000000.0 N/m", "3 GN/m"),
        ("0.0006 m", "0.6 mm"),
        ("2052.0 kg/m^3", "2052 kg/m^3"),
        ("0.0 Pa", "0 Pa"),
        ("load to 100000.0 Pa", "load to 100 kPa"),
        ("parallel", "parallel"),
        (0.5, "0.5"),
        (True, "true"),
    ],
)
def test_values_are_readable(value, text):
    assert readable(value) == text

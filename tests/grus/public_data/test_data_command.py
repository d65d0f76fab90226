"""`grus data`."""

import pytest
from matplotlib.image import imread

from grus.commands import main
from grus.public_data import DATASETS
from grus.recording import read


def test_list_names_origin_licence_checksum_and_citation(capsys):
    assert main(["data", "list"]) == 0
    out = capsys.readouterr().out
    for one in DATASETS.values():
        for text in (one.name, one.test, one.sha256, one.origin.licence, one.origin.citation):
            assert text in out
        assert one.origin.page in out
    assert "(not fetched)" in out


def test_fetch_from_a_folder_and_list_again(capsys, shared, store):
    assert main(["data", "fetch", "--from", str(shared)]) == 0
    assert len(capsys.readouterr().out.splitlines()) == len(DATASETS)
    assert (store / "glass-beads" / "obsdata.dat").exists()
    main(["data", "list"])
    assert "(not fetched)" not in capsys.readouterr().out


def test_show_draws_the_recording_with_its_segments(capsys, shared, tmp_path):
    out = tmp_path / "out"
    assert main(["data", "show", "glass-beads", "--from", str(shared), "--out", str(out)]) == 0
    shown = capsys.readouterr().out
    assert shown.count("hold") == 3 and "reload" in shown and "BSD-3-Clause" in shown
    names = ["glass-beads.csv", "glass-beads.png", "glass-beads.svg"]
    assert sorted(path.name for path in out.iterdir()) == names
    assert imread(out / "glass-beads.png").shape[1] == 1680
    assert len(read(out / "glass-beads.csv")) == 101


@pytest.mark.parametrize(
    "arguments, said",
    [
        (["show"], "grus data: show needs a NAME and --out; see grus data --help"),
        (["show", "glass-beads"], "grus data: show needs a NAME and --out"),
        (["fetch", "glass-beads", "--out", "x"], "grus data: --out goes with show"),
        (["list", "glass-beads"], "grus data: list needs neither a NAME nor --from"),
        (["draw"], "'draw' is not one of 'list', 'fetch', 'show'"),
        (["show", "none", "--out", "x"], "grus: recording 'none' is not known; allowed: "),
        (["fetch", "none"], "grus: recording 'none' is not known"),
        (["fetch", "glass-beads", "--from", "/nowhere"], "grus: /nowhere: no file obsdata.dat"),
    ],
)
def test_refused_in_one_line(capsys, tmp_path, monkeypatch, arguments, said):
    monkeypatch.chdir(tmp_path)
    assert main(["data", *arguments]) == 2
    captured = capsys.readouterr()
    assert captured.out == "" and len(captured.err.splitlines()) == 1
    assert said in captured.err
    assert list(tmp_path.iterdir()) == []

"""Files are fetched from their origin or a folder, checked, and kept."""

import hashlib
import threading
from dataclasses import replace
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer

import numpy as np
import pytest

from grus.errors import GrusError
from grus.public_data import DATASETS, fetch, find_dataset, is_kept, load
from grus.record import Record

CONTENT = b"1 2\n3 4\n"


class Quiet(SimpleHTTPRequestHandler):
    """A server that writes no log."""

    def log_message(self, *_) -> None:
        pass


def read_pairs(path) -> Record:
    stress, strain = np.loadtxt(path).T
    return Record(
        {"axial_stress": stress, "axial_strain": strain},
        {"axial_stress": "Pa", "axial_strain": "1"},
        notes=("a note of the file",),
    )


@pytest.fixture
def known(monkeypatch):
    """A recording `small` with the checksum of CONTENT, of an origin without a network."""
    small = replace(
        DATASETS["glass-beads"],
        name="small",
        local="small",
        file="small.dat",
        sha256=hashlib.sha256(CONTENT).hexdigest(),
        convert=read_pairs,
    )
    monkeypatch.setattr("grus.public_data.dataset.RAW", "http://127.0.0.1:9")
    monkeypatch.setattr("grus.public_data.store.DATASETS", {"small": small})
    return small


@pytest.fixture
def origin(known, tmp_path, monkeypatch):
    """The folder of the origin on a server of this machine."""
    folder = tmp_path / "origin" / known.origin.repository / known.origin.commit
    folder = folder / known.origin.folder
    folder.mkdir(parents=True)
    handler = partial(Quiet, directory=tmp_path / "origin")
    with ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        address = f"http://127.0.0.1:{server.server_address[1]}"
        monkeypatch.setattr("grus.public_data.dataset.RAW", address)
        yield folder
        server.shutdown()


def test_fetched_from_the_origin_once(known, origin, store):
    (origin / "small.dat").write_bytes(CONTENT)
    assert not is_kept("small")
    assert fetch("small") == store / "small" / "small.dat" and is_kept("small")
    (origin / "small.dat").unlink()
    assert fetch("small").read_bytes() == CONTENT


def test_a_file_of_another_content_is_refused(known, origin, store):
    (origin / "small.dat").write_bytes(b"1 2\n3 5\n")
    with pytest.raises(GrusError, match=f"of another content; allowed: .* SHA-256 {known.sha256}"):
        fetch("small")
    assert not list(store.rglob("small.dat"))


def test_a_file_that_is_gone_is_told(known, origin):
    with pytest.raises(GrusError, match=r"small\.dat: answer 404; allowed: .*--from FOLDER"):
        fetch("small")


def test_no_network_is_told(known):
    with pytest.raises(GrusError, match=r"http://127\.0\.0\.1:9/.*: no answer; allowed: ") as error:
        fetch("small")
    assert str(error.value).isprintable()


@pytest.mark.parametrize("inside", ["", "small"])
def test_taken_from_a_folder(known, tmp_path, inside):
    (tmp_path / "mine" / inside).mkdir(parents=True)
    (tmp_path / "mine" / inside / "small.dat").write_bytes(CONTENT)
    assert fetch("small", tmp_path / "mine").read_bytes() == CONTENT


def test_the_checksum_of_a_folder_is_compared(known, tmp_path, store):
    (tmp_path / "small.dat").write_bytes(b"else")
    with pytest.raises(GrusError, match=f"of another content; allowed: {known.sha256}"):
        fetch("small", tmp_path)
    assert not store.exists()


def test_a_folder_without_the_file(known, tmp_path):
    with pytest.raises(GrusError, match="no file small.dat; allowed: "):
        fetch("small", tmp_path)


def test_a_damaged_file_of_the_store_is_replaced(known, tmp_path):
    (tmp_path / "small.dat").write_bytes(CONTENT)
    fetch("small", tmp_path).write_bytes(b"damaged")
    assert fetch("small", tmp_path).read_bytes() == CONTENT


def test_a_record_tells_where_it_comes_from(known, tmp_path):
    (tmp_path / "small.dat").write_bytes(CONTENT)
    record = load("small", tmp_path)
    assert list(record["axial_stress"]) == [1, 3]
    assert record.meta["sha256"] == known.sha256 and record.meta["licence"] == "BSD-3-Clause"
    assert record.notes == ("a note of the file", known.origin.caution)


def test_unknown_names_are_refused():
    with pytest.raises(
        GrusError, match="recording 'none' is not known; allowed: glass-beads, ice-02"
    ):
        find_dataset("none")


def test_the_catalogue_is_whole():
    for name, one in DATASETS.items():
        assert one.name == name and len(one.sha256) == 64 and one.test and one.origin.citation
        assert one.origin.licence and len(one.origin.commit) == 40
        assert one.origin.commit in one.origin.url(one.file)

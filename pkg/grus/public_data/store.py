"""Files of public recordings: fetched, checked, kept."""

import shutil
from dataclasses import replace
from os import PathLike
from pathlib import Path

import pooch
import requests

from grus.errors import GrusError
from grus.files import replacing
from grus.public_data.catalogue import DATASETS
from grus.public_data.dataset import Dataset
from grus.record import Record

ENVIRONMENT = "GRUS_DATA"
"""Environment variable with another folder for the files."""


def find_dataset(name: str) -> Dataset:
    """The recording of that name; GrusError when there is none."""
    if name not in DATASETS:
        raise GrusError(f"recording {name!r} is not known; allowed: {', '.join(DATASETS)}")
    return DATASETS[name]


def fetch(name: str, folder: str | PathLike | None = None) -> Path:
    """File of a recording in the store, fetched from its origin, or taken from a folder, unless it is there.

    The store is the user's cache, or the folder in the environment variable GRUS_DATA. Raises GrusError for an unknown
    name, a file that is not in the folder, one of another content (SHA-256), and an origin that does not answer.
    """
    wanted = find_dataset(name)
    store = _store()
    kept = Path(store.abspath) / wanted.key
    if kept.is_file() and pooch.file_hash(str(kept)) == wanted.sha256:
        return kept
    if folder is not None:
        return _take(wanted, Path(folder), kept)
    try:
        return Path(store.fetch(wanted.key))
    except (requests.RequestException, ValueError) as error:
        reason = "of another content" if isinstance(error, ValueError) else "no answer"
        if isinstance(error, requests.HTTPError) and error.response is not None:
            reason = f"answer {error.response.status_code}"
        raise GrusError(
            f"{store.urls[wanted.key]}: {reason}; allowed: the file with SHA-256 {wanted.sha256}, "
            "from there or by --from FOLDER"
        ) from error


def load(name: str, folder: str | PathLike | None = None) -> Record:
    """Record of a public recording, fetched as `fetch` does; `meta` says where it comes from."""
    wanted = find_dataset(name)
    record = wanted.convert(fetch(name, folder))
    origin = wanted.origin
    meta: dict[str, str | float] = {
        "source": wanted.name,
        "url": origin.url(wanted.file),
        "sha256": wanted.sha256,
        "licence": origin.licence,
        "citation": origin.citation,
    }
    return replace(record, meta=record.meta | meta, notes=(*record.notes, origin.caution))


def is_kept(name: str) -> bool:
    """Whether the file of a recording is in the store."""
    return (Path(_store().abspath) / find_dataset(name).key).is_file()


def _store() -> pooch.Pooch:
    pooch.get_logger().setLevel("WARNING")
    return pooch.create(
        path=pooch.os_cache("grus"),
        base_url="",
        env=ENVIRONMENT,
        registry={one.key: f"sha256:{one.sha256}" for one in DATASETS.values()},
        urls={one.key: one.origin.url(one.file) for one in DATASETS.values()},
    )


def _take(wanted: Dataset, folder: Path, kept: Path) -> Path:
    """Copies the file out of the folder, or out of the origin's folder in it."""
    places = (folder / wanted.file, folder / wanted.key)
    found = next((place for place in places if place.is_file()), None)
    if found is None:
        raise GrusError(
            f"{folder}: no file {wanted.file}; allowed: {' or '.join(map(str, places))}"
        )
    sha256 = pooch.file_hash(str(found))
    if sha256 != wanted.sha256:
        raise GrusError(f"{found}: SHA-256 {sha256}: of another content; allowed: {wanted.sha256}")
    kept.parent.mkdir(parents=True, exist_ok=True)
    with replacing(kept) as partial:
        shutil.copyfile(found, partial)
    return kept

"""Telling what a folder of results is, and reading it."""

import json
from pathlib import Path

from grus.campaign.store import Store
from grus.errors import GrusError
from grus.report.calibration import calibration_content
from grus.report.content import Content, Picture
from grus.report.group import group_content
from grus.report.specimen import specimen_content
from grus.report.store import store_content

LARGEST = 500_000
"""Bytes of a drawing above which its pixels are shown instead."""


def content_of(folder: str | Path) -> Content:
    """Content of the page of a folder that `grus crush`, `grus oedometer`, `grus campaign` or `grus calibrate` has filled.

    Raises GrusError for a folder with anything else, or with results that are not complete.
    """
    folder = Path(folder)
    if (folder / "runs").is_dir():
        return store_content(Store(folder))
    found = _found(folder)
    if "tests" in found:
        return group_content(found, _pictures(folder, found))
    if "stages" in found:
        return specimen_content(found, _pictures(folder, found))
    if found.get("what") == "calibration":
        return calibration_content(found, _pictures(folder, found))
    raise GrusError(f"{folder / 'result.json'}: of no test; {ALLOWED}")


ALLOWED = (
    "allowed: a folder that grus crush, grus oedometer, grus campaign or grus calibrate has filled"
)


def _found(folder: Path) -> dict:
    path = folder / "result.json"
    try:
        found = json.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        raise GrusError(f"{folder}: no result.json; {ALLOWED}") from None
    except ValueError as error:
        raise GrusError(f"{path}: cannot be read ({error}); {ALLOWED}") from None
    if not isinstance(found, dict):
        raise GrusError(f"{path}: of no test; {ALLOWED}")
    return found


def _pictures(folder: Path, found: dict) -> list[Picture]:
    pictures = []
    for name in found["files"]:
        if name.endswith(".png"):
            path = (folder / name).with_suffix(".svg")
            if path.stat().st_size > LARGEST:
                path = folder / name
            kind = "svg+xml" if path.suffix == ".svg" else "png"
            title = path.stem.replace("-", " ")
            pictures.append(Picture(title[:1].upper() + title[1:], path.read_bytes(), kind))
    return pictures

"""Reading a TOML file of unknown quality."""

import os
import tomllib
from pathlib import Path
from typing import Any

from grus.card.errors import CardError, Problem

LARGEST = 100_000  # bytes; /dev/zero is a file, too


def read(path: str | os.PathLike, what: str = "a model card") -> dict[str, Any]:
    """Tables of a TOML file; CardError, which says `what` it should be, when it cannot be read or is not TOML."""
    source = str(path)
    try:
        with Path(path).open("rb") as file:
            content = file.read(LARGEST + 1)
    except OSError as error:
        raise _refusal(source, f"cannot be read: {error.strerror}", f"{what} in TOML") from None
    except ValueError:
        raise _refusal(source, "not the name of a file", f"{what} in TOML") from None
    if len(content) > LARGEST:
        raise _refusal(source, f"too large for {what}", f"at most {LARGEST} bytes")
    return _parse(content, source, what)


def _parse(content: bytes, source: str, what: str) -> dict[str, Any]:
    try:
        # Some editors put a byte-order mark first, which is no part of the text.
        return tomllib.loads(content.decode("utf-8-sig"))
    except UnicodeDecodeError as error:
        line = content.count(b"\n", 0, error.start) + 1
        raise _refusal(source, f"not text in UTF-8 (line {line})") from None
    except RecursionError:
        raise _refusal(source, f"not {what}, nested too deeply") from None
    except ValueError as error:  # syntax, or an integer of thousands of digits
        raise _refusal(source, f"not valid TOML: {error}") from None


def _refusal(source: str, reason: str, allowed: str = "") -> CardError:
    return CardError.of(source, [Problem(reason, allowed)])

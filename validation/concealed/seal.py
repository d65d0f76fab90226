"""Sealing of answers: what is committed before a diagnosis is a hash that tells nothing, and binds."""

import hashlib
import json


def canonical(answer: dict) -> str:
    """The answer as the text that is hashed: JSON with sorted keys and no spaces."""
    return json.dumps(answer, sort_keys=True, separators=(",", ":"))


def seal(salt: str, answer: dict) -> str:
    """SHA-256 of salt and answer, hexadecimal."""
    return hashlib.sha256((salt + canonical(answer)).encode()).hexdigest()


def verify(seals: dict[str, str], answers: dict[str, dict]) -> list[str]:
    """Trials whose answer is not the one that was sealed, or that have only one of both.

    seals: trial -> hash. answers: trial -> {"salt": ..., "answer": ...}.
    """
    return sorted(
        name
        for name in seals.keys() | answers.keys()
        if name not in seals
        or name not in answers
        or seal(answers[name]["salt"], answers[name]["answer"]) != seals[name]
    )

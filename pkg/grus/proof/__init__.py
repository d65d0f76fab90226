"""Proof of the diagnosis: trials in which an effect is concealed, and how they were judged."""

from grus.proof.prove import prove
from grus.proof.report import write_report
from grus.proof.score import Score, score
from grus.proof.summary import summary

__all__ = ["Score", "prove", "score", "summary", "write_report"]

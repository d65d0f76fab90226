"""Grus in YADE against formulas, against YADE's own laws, and against the balance of energy."""

from grus.verification.row import Row
from grus.verification.suite import verify
from grus.verification.table import print_table
from grus.verification.verification import Verification

__all__ = ["Row", "Verification", "print_table", "verify"]

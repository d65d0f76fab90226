"""What a user sees of a diagnosis: a page, figures, numbers, and one screen."""

from grus.diagnosis.report.summary import summary
from grus.diagnosis.report.write import write_report

__all__ = ["summary", "write_report"]

"""One page about a folder of results."""

from grus.report.page import write_page
from grus.report.read import content_of

__all__ = ["content_of", "write_page"]

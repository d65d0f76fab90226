"""The page: one HTML file that needs no other."""

import base64
from pathlib import Path

from jinja2 import Environment, FileSystemLoader, StrictUndefined

from grus.files import write_text
from grus.report.content import Content, Picture

TEMPLATE = "page.html.j2"


def write_page(content: Content, path: str | Path) -> Path:
    """Writes the page, complete or not at all."""
    return write_text(path, page(content))


def page(content: Content) -> str:
    """HTML with all pictures inside."""
    environment = Environment(
        loader=FileSystemLoader(Path(__file__).parent), autoescape=True, undefined=StrictUndefined
    )
    return environment.get_template(TEMPLATE).render(content=content, inside=_inside)


def _inside(picture: Picture) -> str:
    return f"data:image/{picture.kind};base64,{base64.b64encode(picture.data).decode()}"

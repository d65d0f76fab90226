"""Formulas as MathML, which browsers show by themselves: no script and no network is needed to read the pages."""

from inspect import signature

from docutils import nodes
from docutils.utils.math.latex2mathml import tex2mathml
from sphinx.application import Sphinx
from sphinx.util import logging

_INLINE_FIRST = "inline" in signature(tex2mathml).parameters  # docutils before 0.21


def add_mathml(app: Sphinx) -> None:
    """Makes MathML the form of formulas in HTML."""
    pair = (_visit(block=False), None), (_visit(block=True), None)
    app.add_html_math_renderer("mathml", *pair)
    app.config.html_math_renderer = "mathml"


def _visit(block: bool):
    def visit(translator, node: nodes.Element) -> None:
        try:
            translator.body.append(tex2mathml(node.astext(), block != _INLINE_FIRST))
        except (SyntaxError, ValueError) as error:
            logging.getLogger(__name__).warning("formula: %s", error, location=node)
        raise nodes.SkipNode

    return visit

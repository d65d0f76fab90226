"""Parts of the pages that are made from Grus itself while they are built, so that they cannot go stale.

Directives: `attributes CLASS`, `keys SECTION`, `options COMMAND` and `mechanism NAME`. Their content, one sentence that says where
to find the same in a terminal, is what a reader of the plain Markdown sees; the built page shows the table instead.
"""

from sphinx.application import Sphinx

from generated.attributes import Attributes
from generated.keys import Keys
from generated.mathml import add_mathml
from generated.mechanism import MechanismTable
from generated.options import Options


def setup(app: Sphinx) -> dict[str, bool]:
    """Entry point of Sphinx."""
    app.add_directive("attributes", Attributes)
    app.add_directive("keys", Keys)
    app.add_directive("mechanism", MechanismTable)
    app.add_directive("options", Options)
    add_mathml(app)
    # Every page is read anew each time: its tables may have changed, and warnings must not be told only once.
    app.connect("env-get-outdated", lambda app, env, *changes: sorted(env.found_docs))
    return {"parallel_read_safe": False}  # YADE, which the tables ask, does not survive a fork

"""`python3 -m grus.commands`."""

import sys

from grus.commands import main

sys.exit(main())

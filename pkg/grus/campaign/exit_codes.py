"""How the process of a simulation ends."""

DONE = 0
"""Its outcome is in the store, that of a test that its card makes impossible too; or the specimen is."""
REFUSED = 2
"""The specimen cannot be prepared, or not here; the last line on standard error says why."""
UNWRITABLE = 74
"""The store cannot be written: full, read-only, or not allowed; the last line on standard error says which."""

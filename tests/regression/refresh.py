"""Stores the figures of the small cards anew, on purpose, and says what changed: scripts/refresh-regression"""

import json
from pathlib import Path
from tempfile import TemporaryDirectory

from compare import STORED, THREADS, compute, differences


def main() -> None:
    stored = json.loads(STORED.read_text()) if STORED.exists() else {}
    with TemporaryDirectory() as specimens:
        found = {threads: compute(threads, Path(specimens)) for threads in THREADS}
    changed = [
        f"{threads} thread(s): {one}"
        for threads in THREADS
        # Several threads never repeat themselves; rounding is no change.
        for one in differences(stored.get(threads, {}), found[threads], threads > "1" or None)
    ]
    print("\n".join(changed) or "nothing changed")
    if changed:
        STORED.write_text(json.dumps(found, indent=1) + "\n")
        print(f"{len(changed)} figures changed; stored in {STORED}")


if __name__ == "__main__":
    main()

"""A block in YADE, timed whenever it is asked: `python -m grus.bench.yade_script CASE LOOP`, for `Worker`."""

import json
import sys
import time

import grus  # noqa: F401  loads YADE
from yade import O

from grus.bench.cases import Case
from grus.bench.scene import build


def main() -> None:
    """Answers each number of steps on standard input with the seconds that they took."""
    elements, bonds = build(Case(**json.loads(sys.argv[1])), sys.argv[2])
    print(json.dumps({"elements": elements, "bonds": bonds}), flush=True)
    for line in sys.stdin:
        last = O.iter + int(line)
        start = time.perf_counter()
        while O.iter < last:
            O.step()
        print(time.perf_counter() - start, flush=True)


if __name__ == "__main__":
    main()

"""One oedometer test of the paper: `one.py GRAINS SEED SPEED` (speed of the platens in m/s)."""

import sys
from pathlib import Path

from tests import card, folder, specimens

import grus
from grus.oedometer import write_report


def main(grains: int, seed: int, speed: float) -> None:
    model = card(grains, seed, speed)
    last = [""]

    def tell(share: float, line: str) -> None:
        if line[:20] != last[0]:
            print(f"{share:4.0%} {line}", flush=True)
        last[0] = line[:20]

    result = grus.oedometer(model, folder(grains, seed, speed), tell, specimens=specimens())
    write_report(result, folder(grains, seed, speed))


if __name__ == "__main__":
    main(int(sys.argv[1]), int(sys.argv[2]), float(sys.argv[3]))

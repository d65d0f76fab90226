"""One oedometer test of the paper: `run.py GRAINS SEED SPEED STRENGTH` (speed of the platens in m/s, strength of bonds in MPa)."""

import sys

from tests import card, folder, specimens

import grus  # noqa: F401  loads YADE
from grus.oedometer import oedometer, write_report


def main(grains: int, seed: int, speed: float, strength: float) -> None:
    out = folder(grains, seed, speed, strength)
    result = oedometer(
        card(grains, seed, speed, strength),
        out,
        lambda share, line: print(f"{share:4.0%} {line}", flush=True),
        specimens=specimens(),
    )
    write_report(result, out)


if __name__ == "__main__":
    main(int(sys.argv[1]), int(sys.argv[2]), float(sys.argv[3]), float(sys.argv[4]))

"""One oedometer test of the paper: `run.py GRAINS SEED SPEED STRENGTH` (speed of the platens in m/s, or 'adaptive'; strength of
bonds in MPa)."""

import sys

from tests import SPEEDS, card, folder, packing, specimens

import grus  # noqa: F401  loads YADE
from grus.oedometer import oedometer, write_report


def main(grains: int, seed: int, speed: float, strength: float, adaptive: bool) -> None:
    out = folder(grains, seed, speed, strength, adaptive)
    result = oedometer(
        card(grains, seed, speed, strength, adaptive),
        out,
        lambda share, line: print(f"{share:4.0%} {line}", flush=True),
        specimens=specimens(),
        specimen_card=packing(grains, seed),
    )
    write_report(result, out)


if __name__ == "__main__":
    adaptive = sys.argv[3] == "adaptive"
    speed = SPEEDS[0] if adaptive else float(sys.argv[3])
    main(int(sys.argv[1]), int(sys.argv[2]), speed, float(sys.argv[4]), adaptive)

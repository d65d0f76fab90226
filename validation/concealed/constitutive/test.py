"""One oedometer test of one specimen."""

from functools import lru_cache

import numpy as np

from constitutive.apparatus import Apparatus, PoreWater, Walls
from constitutive.rockfill import Layer, Rockfill, specimen
from curve import Curve
from programs import SEATING, Stage, stages

LAYERS = 8  # with friction of walls; alone, one is enough
STEP = 2.5  # of stress in a ramp [kPa]
HOLD = 80  # steps of a hold
MOVING = 0.85  # share of the time of a ramp in which platens that are too fast move


@lru_cache(maxsize=256)
def run(material: Rockfill, apparatus: Apparatus, program: str, seed: int) -> Curve:
    """The test of the specimen of this seed; the same seed has the same specimen whatever acts on it."""
    draw = np.random.default_rng([seed, 1])
    made = specimen(material, draw)
    count = LAYERS if apparatus.wall_friction else 1
    layers = [Layer(made, np.random.default_rng([seed, 2]), SEATING) for _ in range(count)]
    walls = Walls(apparatus, count)
    water = PoreWater(apparatus.drainage_time) if apparatus.drainage_time else None
    strains, base, time, top = np.zeros(count), SEATING, 0.0, SEATING
    rows = [(0.0, SEATING, 0.0, SEATING, 0.0, 0)]
    for number, stage in enumerate(stages(program)):
        for hours, shown, acting in _path(stage, apparatus):
            time += hours
            if water:
                acting -= water.advance(acting - top, hours)
                top = shown
            local, base = walls.stresses(acting, strains)
            strains = np.array(
                [layer.advance(s, hours, time) for layer, s in zip(layers, local, strict=True)]
            )
            events = float(np.mean([layer.events() for layer in layers]))
            rows.append((time, shown, float(strains.mean()), base, events, number))
    table = np.array(rows).T
    strain = table[2] + apparatus.shown(table[1], table[0])
    others = {"base_stress": table[3], "ae_events": table[4]}
    return Curve(table[0], table[1], strain, table[5].astype(int), others)


def _path(stage: Stage, apparatus: Apparatus) -> list[tuple[float, float, float]]:
    """Steps of a stage: hours, stress that is shown and stress that acts on the specimen [kPa]."""
    if stage.hold:
        ends = np.r_[0, np.geomspace(1e-3, 1, HOLD)] * stage.hours
        lost = apparatus.leak * -np.expm1(-ends[1:] / apparatus.leak_time)
        return [
            (float(h), stage.end, stage.end * (1 - float(share)))
            for h, share in zip(np.diff(ends), lost, strict=True)
        ]
    count = int(np.ceil(abs(stage.end - stage.start) / STEP))
    shares = np.arange(1, count + 1) / count
    shown = stage.start + (stage.end - stage.start) * shares
    if not apparatus.overstress:
        return [(stage.hours / count, float(s), float(s)) for s in shown]
    # Too fast: the specimen lags behind the platens by the stress of the wave, and catches up when they stand.
    behind = np.sign(stage.end - stage.start) * apparatus.overstress
    build_up = -np.expm1(-np.abs(shown - stage.start) / apparatus.overstress)
    steps = [
        (MOVING * stage.hours / count, float(s), max(float(s - behind * b), 0.2 * float(s)))
        for s, b in zip(shown, build_up, strict=True)
    ]
    left = steps[-1][2] - stage.end
    rest = 20
    for k in range(1, rest + 1):
        acting = stage.end + left * np.exp(-6 * k / rest)
        steps.append(((1 - MOVING) * stage.hours / rest, stage.end, float(acting)))
    return steps

"""Compaction: unbreakable grains are pressed together until they rest at the void ratio that is asked for."""

from dataclasses import replace
from math import atan

import numpy as np
from yade import O
from yade.wrapper import BondMat

from grus.card import Card
from grus.preparation.press import QUIET, Press, element_stiffness
from grus.preparation.rigid import fit_rigid
from grus.preparation.stream import Step, stream
from grus.preparation.walls import wall_box
from grus.scene import grain_material, stop_grains
from grus.specimen import Specimen

SKIN = 1.0
"""Of GrainLoop, over the radius of an element: grains move fast here, and elements of one grain are no pairs."""
EAGER = 1.0
"""Share of the stress error that the servo removes in a step."""
ROUGH = 0.02
"""Unbalanced force at which grains count as resting here; the seating goes on from there."""
OPENING = 2
"""Way by which opposite walls move apart to let go of the overlaps, over an overlap for each grain across."""
RELEASE = 400
"""Time steps in which they open."""
BEAT, TAPS = 1000, 60
"""Time steps from one tap or one change of friction to the next, and how many taps there are at most."""
SOFTEST_TAP, HARDEST_TAP = 0.7, 5.0
"""Largest speed that the first and the last tap give a grain, over root(stress / density)."""
HELD, LEAST, LOWERINGS = 4.0, 0.1, 15
"""Friction while the platens close and the least before none, over the card's, and in how many steps it falls from one to the
other, by way of the card's."""
RESISTING, PATIENCE = 0.95, 20
"""Share of the seating stress on both platens at which grains count as resisting, and for how many beats this is waited for."""
SLOWEST = 0.1
"""Share of their speed at which platens still close: they wait while the stress is reached and the grains give way."""
CYCLES = 12
"""Rounds of densifying and settling at most."""
ENOUGH = 0.6
"""Share of the tolerance within which the void ratio is met; the rest is room for the seating."""


class Compaction:
    """Grains that cannot break or bend, each one rigid clump, with soft contacts at first.

    parts: the grains, joined, each at the place of its exo-sphere; size: of the box [m]; attempt: number of the
    packing, for its taps; margin: void ratio that the grains are expected to lose while they come to rest.
    """

    def __init__(
        self, card: Card, parts: Specimen, size: np.ndarray, attempt: int = 0, margin: float = 0.0
    ) -> None:
        self.card, self.grains, self.margin = card, parts, margin
        self.final = element_stiffness(grain_material(card), card.element.radius)
        self.soft = min(self.final, soft_stiffness(card, parts))
        self.taps = stream(card.seed, Step.TAPS, attempt)
        material = BondMat(
            label="grain",
            density=card.element.density,
            kn=self.soft,
            ks=self.soft,
            thickness=card.thickness or 0,
            frictionAngle=atan(card.contact.friction_coefficient),
        )
        corners = np.array([np.zeros(len(size)), size])
        rigid = replace(parts, clump=parts.grain)
        self.press = Press(
            card,
            rigid,
            corners,
            material,
            card.preparation.compaction_speed,
            SKIN * card.element.radius,
        )

    def run(self) -> tuple[float, float]:
        """Compacts; returns the void ratios at which the grains first came to rest, and at last.

        The platens close on grains that hold each other by more than the card's friction, which then falls to it.
        While they rest at a larger void ratio than asked for, friction is taken from them (down to
        `preparation.friction`), and if that is not enough they are tapped, until the void ratio is met. Then friction is
        given back, and contacts get their final stiffness. The small way that the platens still go until all rest is
        measured, and allowed for in the next cycle if it was too short.
        """
        press, target = self.press, self.card.specimen.void_ratio
        enough = target + ENOUGH * self.card.preparation.void_ratio_tolerance
        press.servo.relaxation = EAGER
        press.expect(ROUGH, QUIET // 5)
        stop, first = target + self.card.preparation.void_ratio_tolerance + self.margin, None
        self._close(stop)
        for _ in range(CYCLES):
            dense = press.void_ratio <= max(stop, enough) or self._densify(stop)
            before = press.void_ratio
            after = self._settle()
            first = after if first is None else first
            if after <= enough or not dense:
                break
            stop = min(target + max(before - after, 0), after)
            press.set_stiffness(self.soft)
            press.expect(ROUGH, QUIET // 5)
        return first, after

    def result(self) -> tuple[Specimen, np.ndarray]:
        """The grains as they were made, clumps and all, where they lie now; corners (2, dimension) of the box [m]."""
        placed = fit_rigid(self.grains, self.press.positions())
        return replace(self.grains, position=placed), np.array(wall_box(self.press.walls))

    def _close(self, stop: float) -> None:
        """Closes the platens until the void ratio falls to `stop`, or until the grains resist: on friction that then
        falls, step by step, to what they have.

        Grains that are compacted with that friction alone do not come to rest until they are far denser, the more so
        the larger the box: what has begun to flow goes on.
        """
        own = self.card.contact.friction_coefficient
        self.press.set_friction(HELD * own)
        for _ in range(self._closing_beats()):
            self._follow()
            if self.press.run(BEAT, stop) or self.press.resists(RESISTING):
                break
        for friction in own * _by_equal_factors(HELD, 1, LOWERINGS):
            stop_grains()
            self.press.set_friction(float(friction))
            self._press_on(PATIENCE)

    def _press_on(self, beats: int, stop: float | None = None) -> bool:
        """At most so many beats until the grains resist again; whether the void ratio falls to `stop` first."""
        for _ in range(beats):
            if self.press.run(BEAT, stop):
                return True
            if self.press.resists(RESISTING):
                break
        return False

    def _follow(self) -> None:
        """Gives the grains the velocities of a box that closes evenly, so that they need not be pushed together from its
        ends, which takes the longer the larger it is."""
        axis = self.card.dimension - 1
        ends = [O.bodies[wall].state for wall in self.press.walls[axis]]
        low, high = (one.pos[axis] for one in ends)
        below, above = (one.vel[axis] for one in ends)
        for grain in self.press.movable():
            share = (grain.state.pos[axis] - low) / (high - low)
            velocity = np.zeros(3)
            velocity[axis] = below + share * (above - below)
            grain.state.vel = tuple(velocity.tolist())
            grain.state.angVel = (0, 0, 0)

    def _closing_beats(self) -> int:
        """Most beats of closing: as many as the way to the box asked for takes at `SLOWEST` of the platens' speed."""
        lower, upper = wall_box(self.press.walls)
        height = float(upper[-1] - lower[-1])
        ratio = (1 + self.card.specimen.void_ratio) / (1 + self.press.void_ratio)
        way = max(height * (1 - ratio), 0)
        beat = SLOWEST * self.card.preparation.compaction_speed * O.dt * BEAT
        return 1 + int(way / beat)

    def _densify(self, stop: float) -> bool:
        """Takes friction from the grains little by little, then taps them harder and harder.

        Returns whether the void ratio falls to `stop`.
        """
        p = self.card.preparation
        own = self.card.contact.friction_coefficient
        falling = own * np.append(_by_equal_factors(1, LEAST, LOWERINGS), 0)
        for friction in np.maximum(falling, p.friction):
            stop_grains()
            self.press.set_friction(float(friction))
            if self._press_on(PATIENCE, stop):
                return True
        sound = (p.seating_stress / self.card.element.density) ** 0.5
        for speed in sound * _by_equal_factors(SOFTEST_TAP, HARDEST_TAP, TAPS):
            self._tap(speed)
            if self.press.run(BEAT, stop):
                return True
        return False

    def _tap(self, speed: float) -> None:
        """Gives every grain a velocity at random, up to `speed` [m/s] along each axis."""
        dimension = self.card.dimension
        for grain in self.press.movable():
            kick = np.zeros(3)
            kick[:dimension] = speed * (2 * self.taps.random(dimension) - 1)
            grain.state.vel = tuple(kick.tolist())

    def _settle(self) -> float:
        """Gives friction back and lets all come to rest, with soft and then with hard contacts; the void ratio then.

        In between the box opens until overlaps are gone: hardening contacts as they are would lock stress between the
        sides. The sides then stay a little wider.
        """
        press, p = self.press, self.card.preparation
        stop_grains()
        press.set_friction(self.card.contact.friction_coefficient)
        press.to_rest()
        overlap = OPENING * p.compaction_overlap * self.card.element.radius
        lower, upper = wall_box(press.walls)
        across = (upper - lower) / self.grains.grain_diameter.mean()
        press.open((across * overlap).tolist(), RELEASE)
        press.set_stiffness(self.final)
        press.expect(ROUGH, QUIET)
        press.to_rest()
        return press.void_ratio


def _by_equal_factors(first: float, last: float, count: int) -> np.ndarray:
    """From `first` to `last`, rounded: the same on all machines."""
    return np.geomspace(first, last, count).round(6)


def soft_stiffness(card: Card, grains: Specimen) -> float:
    """Element stiffness [N/m] with which grains overlap by `preparation.compaction_overlap` under the seating stress.

    The mean contact force is taken as the stress times the square of the mean diameter, in the plane times diameter
    and thickness; a contact is two elements in series.
    """
    p = card.preparation
    diameter = float(grains.grain_diameter.mean())
    area = diameter * (card.thickness if card.dimension == 2 else diameter)
    return 2 * p.seating_stress * area / (p.compaction_overlap * card.element.radius)


def start_box(card: Card, exo_radius: np.ndarray, base: np.ndarray, fraction: float) -> np.ndarray:
    """Size (dimension,) [m] of the box of which exo-spheres fill the share `fraction`."""
    unit = np.pi if card.dimension == 2 else 4 / 3 * np.pi
    volume = unit * float(np.prod([exo_radius] * card.dimension, axis=0).sum()) / fraction
    return np.append(base, volume / base.prod())

"""What a card is calibrated to."""

from dataclasses import dataclass

from grus.calibrate.parameter import Parameter

CRUSH, OEDOMETER = "crush", "oedometer"
CURVE = "compression_curve"


@dataclass(frozen=True)
class Target:
    """One thing that the model should show.

    name: as in the file. kind: the test that shows it, 'crush' or 'oedometer'. quantity: what is compared. unit: its SI
    unit. values: (k,), one but for a curve. tolerance: standard deviation of each of them, in the same unit.
    stress: where the values of a curve are (k,) [Pa], rising; empty for a single value.
    """

    name: str
    kind: str
    quantity: str
    unit: str
    values: tuple[float, ...]
    tolerance: float
    stress: tuple[float, ...] = ()


@dataclass(frozen=True)
class Targets:
    """A file of targets.

    source: how messages name it. grains: how many are crushed for each trial. specimens: how many are compressed, with
    the seeds that follow that of the card.
    """

    source: str
    parameters: tuple[Parameter, ...]
    targets: tuple[Target, ...]
    grains: int
    specimens: int

    def of(self, kind: str) -> tuple[Target, ...]:
        """Those that a kind of test shows."""
        return tuple(target for target in self.targets if target.kind == kind)

"""What lies between a parameter of a mechanism in the laboratory and in the runs of the small model."""

from dataclasses import dataclass

from grus.diagnosis.plan import INSTRUMENT


@dataclass(frozen=True)
class Scaling:
    """stiffness: factor of the calibration, by which strains of the recording were multiplied. stress: stresses that are
    simulated over those of the recording. height: of the small model over that of the recording's specimen.
    """

    stiffness: float = 1.0
    stress: float = 1.0
    height: float = 1.0

    def simulated(self, name: str, unit: str) -> float:
        """Value of the parameter of a mechanism in the runs over that in the laboratory.

        What an instrument adds to the strain was multiplied with it; what it adds to a length is a strain by the height of the
        specimen. Records of the runs have the stresses of the laboratory before an instrument reads them.
        """
        if name in INSTRUMENT:
            what = unit.split("/")[0]
            if what == "Pa":
                return 1.0
            return self.stiffness * (self.height if what == "m" else 1.0)
        return self.stress if unit == "Pa" else 1.0

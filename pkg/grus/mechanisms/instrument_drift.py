"""Drift and offset of the instrument."""

from dataclasses import replace

from grus.errors import GrusError
from grus.mechanisms.mechanism import Mechanism, Parameter, Values
from grus.record import Record


def _distort(record: Record, values: Values) -> Record:
    strain = record["axial_strain"] + values["strain_offset"]
    stress = record["axial_stress"]
    if values["strain_rate"] or values["stress_rate"]:
        if "time" not in record.channels:
            raise GrusError(
                "record channel time is missing; allowed: a record with a time, or no drift"
            )
        passed = record["time"] - record["time"][0]
        strain = strain + values["strain_rate"] * passed
        stress = stress + values["stress_rate"] * passed
    return replace(
        record, channels=record.channels | {"axial_stress": stress, "axial_strain": strain}
    )


MECHANISM = Mechanism(
    name="instrument_drift",
    title="Drift and offset of the instrument",
    acts_on="instrument",
    parameters=(
        Parameter(
            "strain_rate",
            "1/s",
            low=-1e-6,
            high=1e-6,
            sizes=(2e-10, 1e-9, 5e-9),
            logarithmic=False,
            meaning="Drift of the strain reading; 1e-9 1/s are 0.0086 % a day.",
            off=0.0,
        ),
        Parameter(
            "strain_offset",
            "1",
            low=-0.05,
            high=0.05,
            sizes=(0.0,),
            logarithmic=False,
            meaning="Error of the zero of the strain reading.",
            off=0.0,
        ),
        Parameter(
            "stress_rate",
            "Pa/s",
            low=-10.0,
            high=10.0,
            sizes=(0.0,),
            logarithmic=False,
            meaning="Drift of the stress reading.",
            off=0.0,
        ),
    ),
    summary="The reading wanders while the specimen does not: a fault of the recording.",
    signs="Strain that goes on linearly with time, at the same rate under any stress and after unloading, without acoustic events.",
    on_record=_distort,
)

"""The public recordings that Grus knows."""

from grus.public_data.dataset import Dataset, Origin
from grus.public_data.glass_beads import glass_beads
from grus.public_data.ice_powder import ice_powder
from grus.public_data.soil_sheets import dense, incremental, loose, rates, steps

GRAINLEARNING = Origin(
    repository="GrainLearning/grainLearning",
    commit="fcbf493c1543ce941e1150c0007ca3a85f10b03c",
    folder="tests/data/oedo_sim_data",
    licence="BSD-3-Clause",
    citation="GrainLearning, tests/data/oedo_sim_data/obsdata.dat",
    caution="The origin calls it observation data of an oedometer; it does not name the experiment.",
)
FIRN = Origin(
    repository="daniel-furman/Furman-and-Goldsby",
    commit="89645275aace68ad1dbf897ac5de72696685bffc",
    folder="data",
    licence="MIT",
    citation="Furman & Goldsby, The Rheological Behavior of Firn: experimental observations",
    caution="Loads are not in the files, but in the authors' script; the temperature of each test is not told.",
)
MINISOILLAB = Origin(
    repository="d-zo/miniSoilLAB",
    commit="f5e17f9448089b780083869cf35bb6750b3fd2be",
    folder="example_spreadsheets",
    licence="GPL-3.0",
    citation="d-zo, miniSoilLAB, example spreadsheets",
    caution="Anonymous sheets of a laboratory; the origin does not say that they are measurements.",
)

_ICE = {
    2: "3990ef4d9f0ec4d3a40bcc8afcdb3a3498b89e599d45ee682b5efd339ea88ee1",
    3: "8c2c473ac4a3c3531334de6bd5a9e6d5a3742cfbf3ab57e462ded2e288fc290e",
    4: "e9c696459dbc2f41d35bc3d8467bc660c9f06c7ef0144548cebe1efb7e6ce480",
    5: "04ac900dee03c361ff59f733cbcd4e7287bc276075671f28d046db42d6a9bbe3",
    6: "56bf347fbb0d3577b9b0ac0e60189db357b054e01ea9a78a515a676c20a4c011",
    7: "a29e0bfa82d29b843b2b7f5839d76d84503d39439a1907b55750bf4cef4308b3",
}
_INCREMENTS = "80c88ada3ac9d03d8230b8f7490ce4d8d91fd5a5875e89841020b5568cf68624"
_RATES = "443d6c709a74812440b0ca3722e368e12860a3179d0f8b508bfd56cf07ae78fa"
_ONCE = "0915da9dbe24577c1172c596084a74f431333f26c0764f5c3da51df7e5cc177f"
_STEPS = "0f341e1b910af3d760420d61ae37798977b9d1f6d09df62369d2bb14599ed4fd"
_SOIL = (
    (
        "soil-increments",
        "Oedo-CRL_01.xlsx",
        _INCREMENTS,
        "four steps of load, a day each",
        incremental,
    ),
    ("soil-rates", "Oedo-CRS-Visko_01.xlsx", _RATES, "constant rates with unloading, 48 h", rates),
    ("soil-loose", "Oedo-CRS_01.xlsx", _ONCE, "loose soil compressed once, no times", loose),
    ("soil-dense", "Oedo-CRS_01.xlsx", _ONCE, "dense soil compressed once, no times", dense),
    ("soil-steps", "Oedo-dicht_01.xlsx", _STEPS, "ends of stages, unloaded and reloaded", steps),
)

DATASETS = {
    dataset.name: dataset
    for dataset in (
        Dataset(
            "glass-beads",
            GRAINLEARNING,
            "glass-beads",
            "obsdata.dat",
            "8cb53714c1875af06a07d4959c7d0f7e9ad4266c4c3133eb125978ec1a0aef28",
            "glass beads, loaded to 52 MPa and unloaded twice, no times",
            glass_beads,
        ),
        *(
            Dataset(
                f"ice-{number:02d}",
                FIRN,
                "ice-powder",
                f"compaction_id_{number:02d}.csv",
                sha256,
                "ice powder in a die under dead loads, up to weeks",
                ice_powder(number),
            )
            for number, sha256 in _ICE.items()
        ),
        *(
            Dataset(name, MINISOILLAB, "clay-consolidation", file, sha256, test, convert)
            for name, file, sha256, test, convert in _SOIL
        ),
    )
}
"""By name."""

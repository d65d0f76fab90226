"""A specimen in YADE: the one place that puts elements, bonds and engines into a scene and takes results out."""

from grus.scene.bonding import bond
from grus.scene.contacts import Contacts, contacts
from grus.scene.insert import insert
from grus.scene.grain_engines import CALMING, LOOPS, GrainEngines, set_damping, stop_grains
from grus.scene.loop import InteractionEngines
from grus.scene.material import grain_material, platen_material
from grus.scene.snapshot import Snapshot, snapshot

__all__ = [
    "CALMING",
    "Contacts",
    "LOOPS",
    "GrainEngines",
    "InteractionEngines",
    "Snapshot",
    "bond",
    "contacts",
    "grain_material",
    "insert",
    "platen_material",
    "set_damping",
    "snapshot",
    "stop_grains",
]

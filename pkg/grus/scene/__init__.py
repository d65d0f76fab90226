"""A specimen in YADE: the one place that puts elements, bonds and engines into a scene and takes results out."""

from grus.scene.bonding import bond
from grus.scene.contacts import Contacts, contacts
from grus.scene.insert import insert
from grus.scene.grain_engines import LOOPS, GrainEngines, stop_grains
from grus.scene.loop import InteractionEngines
from grus.scene.material import grain_material, platen_material
from grus.scene.snapshot import Snapshot, snapshot

__all__ = [
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
    "snapshot",
    "stop_grains",
]

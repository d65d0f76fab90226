"""Contacts between grains that are not linear, by what Python writes into YADE's own linear ones."""

import builtins

import numpy as np

from dem.scene import O, Specimen, wrapper

PERIOD = 20  # steps between two looks at the contacts
LIST = 400  # steps between two looks for new ones
SOFTEST, STIFFEST = 0.1, 3.0  # of Hertzian contacts over linear ones


class _Contacts:
    """Changes the contacts of a specimen every PERIOD steps."""

    def __init__(self, specimen: Specimen):
        self.specimen, self.seen, self.known = specimen, -LIST, []
        self.linear = O.materials[0].young * specimen.element
        builtins.concealed_contacts = self.look  # PyRunner knows text, no functions
        command = "__import__('builtins').concealed_contacts()"
        O.engines = O.engines + [wrapper.PyRunner(iterPeriod=PERIOD, command=command)]

    def look(self) -> None:
        if O.iter - self.seen >= LIST:
            self.known, self.seen = self.specimen.contacts(), O.iter
        for contact in self.known:
            if contact.isReal:
                self.change(contact)


class Hertzian(_Contacts):
    """Force ~ overlap^1.5, as the linear contact at `force` [N]; by secants."""

    def __init__(self, specimen: Specimen, force: float):
        super().__init__(specimen)
        self.overlap = force / self.linear

    def change(self, contact) -> None:
        share = np.sqrt(max(contact.geom.penetrationDepth, 0.0) / self.overlap)
        stiffness = self.linear * float(min(max(share, SOFTEST), STIFFEST))
        contact.phys.kn = contact.phys.ks = stiffness


class Plastic(_Contacts):
    """Unloading and reloading are `ratio` times stiffer than first loading (Luding 2008, without adhesion)."""

    def __init__(self, specimen: Specimen, ratio: float):
        super().__init__(specimen)
        self.ratio, self.largest = ratio, {}

    def change(self, contact) -> None:
        overlap, key = contact.geom.penetrationDepth, (contact.id1, contact.id2)
        if overlap >= self.largest.get(key, 0.0):
            self.largest[key] = overlap
            contact.phys.kn, contact.phys.unp = self.linear, 0.0
        else:
            contact.phys.kn = self.ratio * self.linear
            contact.phys.unp = self.largest[key] * (1 - 1 / self.ratio)

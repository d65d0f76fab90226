# Prepares the specimen of a card for its oedometer test, step by step. From the top folder of Grus:
#     PYTHONPATH=pkg yade -n -x scripts/prepare.py models/quick.toml [FOLDER]
# `grus.preparation.prepare` does the same, and tries further packings when the first one misses.
import numpy as np

import grus  # makes Grus's classes known to YADE
from grus.preparation.compaction import Compaction, start_box
from grus.preparation.diameters import base, diameters
from grus.preparation.exo import grow, place, solid_fraction
from grus.preparation.grain import sized_grain
from grus.preparation.preparation import specimen_key
from grus.preparation.seating import seat
from grus.preparation.stream import Step, stream
from grus.script import arguments
from grus.specimen import join

card, folder = arguments(folder=".")  # or from a table of yade-batch

# The grains, each of the size that the grading gives it; plain arrays, no YADE so far.
sizes = diameters(card)
grains = [sized_grain(card, number, diameter) for number, diameter in enumerate(sizes.tolist())]
print(f"{len(grains)} grains, {sum(grain.element_count for grain in grains)} elements")

# Exo-spheres around them find a place at random while they are small, then grow to hold the grains.
reach = np.array([(np.linalg.norm(g.position, axis=1) + g.radius).max() for g in grains])
box = start_box(card, reach, base(card), solid_fraction(card))
places = place(card.preparation.start_factor * reach, box, stream(card.seed, Step.PLACES))
centres = grow(card, places, reach, box)

# The grains take their places, unbreakable for now, and the platens close until the void ratio is met.
compaction = Compaction(card, join(grains, centres, meta={"maker": "preparation"}), box)
compaction.run()
specimen, corners = compaction.result()

# Bonds are made, very strong at first. At rest they get their strength, and none may break.
key = specimen_key(card)
prepared = seat(card, specimen, corners, key)
missed = abs(prepared.void_ratio - card.specimen.void_ratio)
assert missed <= card.preparation.void_ratio_tolerance, f"void ratio {prepared.void_ratio:.4f}"
prepared.save(f"{folder}/specimen-{key[:16]}.h5")  # where a test of this card looks for it

print(
    f"void ratio {prepared.void_ratio:.4f} by outlines, {prepared.void_ratio_elements:.4f} by elements"
)
print(f"height {1e3 * prepared.height:.2f} mm")
print(
    f"stress {1e-3 * prepared.axial_stress:.3f} kPa on the platens, {1e-3 * prepared.side_stress:.3f} kPa on the sides"
)
print(
    f"largest bond stress {1e-3 * prepared.largest_tension:.3g} kPa in tension, {1e-3 * prepared.largest_shear:.3g} kPa in shear"
)

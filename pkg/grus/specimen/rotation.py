"""Random rotations as matrices."""

import numpy as np
from scipy.spatial.transform import Rotation


def plane_rotation(angle: float) -> np.ndarray:
    """Matrix (3, 3) of the rotation by `angle` [rad] about z, counter-clockwise."""
    return Rotation.from_rotvec([0.0, 0.0, angle]).as_matrix()


def random_rotation(generator: np.random.Generator) -> np.ndarray:
    """Matrix (3, 3) of a rotation that is uniform over all rotations of space.

    The unit quaternion of Shoemake (1992), Graphics Gems III, 124-132.
    """
    share, first, second = generator.random(3)
    short, long = np.sqrt(1 - share), np.sqrt(share)
    first, second = 2 * np.pi * first, 2 * np.pi * second
    quaternion = [short * np.sin(first), short * np.cos(first)]
    quaternion += [long * np.sin(second), long * np.cos(second)]
    return Rotation.from_quat(quaternion).as_matrix()

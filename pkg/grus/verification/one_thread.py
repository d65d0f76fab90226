"""One thread for the current scene, whatever OMP_NUM_THREADS says: two spheres are no work for more."""

from yade import O


def one_thread() -> None:
    """Call it when O.engines is complete."""
    for engine in O.engines:
        engine.ompThreads = 1

"""Timings and cases that several tests share."""

from grus.bench import Case, Timing

SPHERES = [Case(2, 150, False), Case(3, 150, False)]


def timing(loop: str, step: float, case: Case = Case(2, 1000, True)) -> Timing:
    return Timing(case, loop, elements=900, bonds=2000, step=step, repeats=7)

"""Every case of the verification, and what a wrong expectation does to it."""

import pytest

from grus.verification.breaking import breaking_rows
from grus.verification.elastic import elastic_rows
from grus.verification.formulas import BondedPair

PARTS = ["formulas", "other laws", "time step", "energy"]


def test_every_row_is_within_its_tolerance(verification):
    bad = [f"{row.case}, {row.quantity}: {row.deviation:.1e}" for row in verification.failed]
    assert not bad and verification.passed


def test_every_part_counts(verification):
    assert list(dict.fromkeys(row.part for row in verification.rows)) == PARTS
    counted = [row.part for row in verification.rows if row.tolerance is not None]
    assert set(counted) == set(PARTS)
    assert len(set((row.case, row.quantity) for row in verification.rows)) == len(verification.rows)


def test_every_row_explains_itself(verification):
    for row in verification.rows:
        assert row.case and row.quantity and row.unit and row.note.endswith((".", "'"))
        assert "\n" not in row.note


@pytest.mark.parametrize("law", ["CohFrict", "JCFpm"])
@pytest.mark.parametrize("loading", ["pulled apart", "sheared", "compressed"])
def test_blocks_break_alike(verification, law, loading):
    """The blocks do break, and well past their peak."""
    curves = verification.curves[loading]
    ours, other = curves["Grus"], curves[law]
    assert ours.spheres == 100 and len(ours.force) == len(other.force)
    assert ours.broken > ours.broken_at_peak and ours.broken > 0.2 * ours.bonds[0]
    assert abs(other.peak / ours.peak - 1) < 1e-3


def test_progress(verification, calls):
    last = calls[-1][1]
    assert calls == [(done, last) for done in range(last + 1)]


def test_the_scene_of_the_caller_is_left_alone(verification, scene):
    assert scene == [(1, 0), (1, 0)]


def test_wrong_stiffness_fails(monkeypatch):
    """An expectation with a bending stiffness 1e-9 too large is found out, and only where the pair bends."""
    right = BondedPair.bond_load

    def wrong(self, motion):
        normal, shear, bending, twist = right(self, motion)
        return normal, shear, bending * (1 + 1e-9), twist

    monkeypatch.setattr(BondedPair, "bond_load", wrong)
    failed = {row.case for row in elastic_rows() if not row.passed}
    assert "parallel bond, spheres: bending" in failed and "parallel bond, discs: bending" in failed
    assert not any(case.startswith("contact") or case.endswith(": tension") for case in failed)


def test_wrong_strength_fails(monkeypatch):
    """A strength 1e-6 off: the bond does not break where expected, and no stress is reported."""
    right = BondedPair.load_to_break

    def wrong(self, motion):
        factor, mode = right(self, motion)
        return factor * (1 - 1e-6), mode

    monkeypatch.setattr(BondedPair, "load_to_break", wrong)
    strengths = [row for row in breaking_rows() if row.quantity == "strength"]
    assert strengths and not any(row.passed for row in strengths)


def test_wrong_mode_fails(monkeypatch):
    right = BondedPair.load_to_break
    monkeypatch.setattr(
        BondedPair, "load_to_break", lambda self, m: (right(self, m)[0], 3 - right(self, m)[1])
    )
    strengths = [row for row in breaking_rows() if row.quantity == "strength"]
    assert not any(row.passed for row in strengths)

"""What a test is like from the seating to the last stage, in the plane and in space."""

import numpy as np
import pytest

from grus.grading import Fragments
from grus.oedometer import Analysis, oedometer
from grus.oedometer.run import SEATING
from grus.oedometer.test import UNITS


def last_rows(result) -> np.ndarray:
    return Analysis.of(result).rows


def test_stages_are_those_of_the_card(result):
    asked = [("seat", 5e3), *((one.kind, one.stress) for one in result.card.oedometer.stages)]
    assert [(end.kind, end.target) for end in result.stages] == asked
    assert [end.number for end in result.stages] == list(range(len(asked)))
    assert [result.stages[i].name for i in (0, -1)] == ["seat at 5 kPa", "unload to 50 kPa"]


def test_stages_end_at_their_stress_and_at_rest(result):
    limits = result.card.oedometer
    rows = last_rows(result)
    for platen in ("top_stress", "bottom_stress"):
        reached = result.record[platen][rows]
        targets = np.array([end.target for end in result.stages])
        tolerance = [SEATING if end.kind == "seat" else limits.tolerance for end in result.stages]
        assert (np.abs(reached - targets) <= tolerance * targets).all()
    assert (result.record["unbalanced"][rows] <= limits.unbalanced_limit).all()


def test_record_has_all_columns_and_steps_in_order(result):
    record = result.record
    assert list(record.channels) == list(UNITS)
    assert (np.diff(record["iter"]) > 0).all() and (np.diff(record["stage"]) >= 0).all()
    assert (np.diff(result.broken) >= 0).all()
    rows = last_rows(result)
    assert record["height"][rows].tolist() == [end.height for end in result.stages]
    assert result.void_ratio[rows] == pytest.approx([end.void_ratio for end in result.stages])
    assert result.broken[rows].tolist() == [end.breaks for end in result.stages]


def test_readings_are_as_dense_as_the_card_says(result):
    limits, record = result.card.oedometer, result.record
    same_stage = np.diff(record["stage"]) == 0
    strain = np.abs(np.diff(record["height"])) / record["height"][0]
    assert strain[same_stage].max() < 2 * limits.record_strain


def test_test_starts_at_the_void_ratio_of_the_specimen(result):
    assert result.seated.void_ratio == pytest.approx(result.prepared.void_ratio, abs=1e-4)
    assert result.seated.breaks == 0
    assert result.bonds == len(result.prepared.specimen.bonds())


def test_some_bonds_break_and_the_specimen_is_compressed(result):
    assert 0 < result.stages[-1].breaks < 0.2 * result.bonds
    loads = [end for end in result.stages if end.kind != "unload"]
    assert (np.diff([end.void_ratio for end in loads]) < 0).all()


def test_energy_balance_closes_at_every_stage(result):
    assert np.abs(result.energy_error[last_rows(result)]).max() < 0.01


def test_bonds_of_a_stage_are_those_that_have_not_broken(result):
    for end in result.stages:
        assert len(end.state.bonds) == result.bonds - end.breaks


def test_mass_is_conserved(result):
    assert Analysis.of(result).lost_mass() < 1e-12


def test_grading_follows_the_fragments_of_each_stage(result):
    analysis = Analysis.of(result)
    specimen = result.prepared.specimen
    assert analysis.fragments[0].count == specimen.grain_count
    for end, fragments, grading in zip(result.stages, analysis.fragments, analysis.gradings):
        assert fragments.count == end.state.fragment_count
        again = Fragments.of_bonds(specimen, end.state.bonds)
        assert sorted(again.volume) == pytest.approx(sorted(fragments.volume))
        assert grading.passing[0] == 0 and (grading.sizes == analysis.gradings[0].sizes).all()
    none = analysis.breakage[0]
    assert (none.hardin, none.einav, none.marsal, none.lee_farhoomand) == (0, 0, 0, 1)
    broken = analysis.fragments[-1].count > specimen.grain_count
    assert (analysis.breakage[-1].marsal > 0) == broken


def test_unloading_is_elastic(result):
    """Hardly a bond breaks, and what the specimen gives back is most of its elastic energy; friction takes the rest.

    A bond that friction has kept from its last bit of load may still break on the way back.
    """
    loaded, unloaded = result.stages[-2:]
    assert unloaded.kind == "unload"
    assert unloaded.breaks - loaded.breaks <= max(1, 0.05 * loaded.breaks)
    assert unloaded.void_ratio > loaded.void_ratio
    record, (before, after) = result.record, last_rows(result)[-2:]
    given_back = record["work"][before] - record["work"][after]
    released = record["elastic_energy"][before] - record["elastic_energy"][after]
    assert given_back > 0.5 * released > 0


def test_contact_forces_carry_the_stress(result):
    """The forces on the walls that the contacts of a stage give are the stresses of its end."""
    end, prepared = result.stages[-1], result.prepared
    axis = result.card.dimension - 1
    contacts = end.contacts
    on_wall = contacts.pairs[:, 0] == -1
    radius = prepared.specimen.radius.max()
    height = contacts.point[:, axis]
    for platen in (height[on_wall].min(), height[on_wall].max()):
        here = on_wall & (np.abs(height - platen) < 0.1 * radius)
        across = np.linalg.norm(
            contacts.point - end.state.position[contacts.pairs[:, 1]], axis=1
        ) - np.abs(height - end.state.position[contacts.pairs[:, 1], axis])
        here &= across < 0.1 * radius  # not one of a side wall in the corner
        area = prepared.box_volume / prepared.height
        stress = contacts.force[here].sum() / area
        assert stress == pytest.approx(end.axial_stress, rel=result.card.oedometer.tolerance)


def test_both_loops_give_the_same_before_anything_breaks(gentle, tmp_path, specimens):
    """A stage ends anywhere within its tolerance of 1 %, so that strains agree within that."""
    found = {
        loop: oedometer(
            gentle.with_overrides({"oedometer.loop": loop}), tmp_path / loop, specimens=specimens
        )
        for loop in ("GrainLoop", "InteractionLoop")
    }
    for one, other in zip(*(result.stages for result in found.values())):
        assert one.breaks == other.breaks
        start = one.height - found["GrainLoop"].seated.height
        start_other = other.height - found["InteractionLoop"].seated.height
        assert start_other == pytest.approx(start, rel=0.01, abs=1e-12)
        assert other.K0 == pytest.approx(one.K0, rel=0.02)

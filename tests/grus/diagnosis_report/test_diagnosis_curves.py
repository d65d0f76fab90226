"""Curves behind the numbers."""

import numpy as np

from grus.diagnosis.report.curves import curves
from grus.diagnosis.report.differences import differences


def test_recorded_curve_is_that_of_the_readings(named):
    record = named.recording
    for one in curves(named):
        inside = np.interp(one.time, record["time"][one.rows], record["axial_strain"][one.rows])
        assert np.abs(one.recorded - inside).max() < 0.05 * np.ptp(record["axial_strain"])


def test_models_end_where_their_changes_lead(named):
    compared, scale = named.calibration.compared, named.calibration.stiffness
    strain = compared.where(channel="strain")
    found = curves(named)
    stages = sum(one.after[-1] - one.after[0] for one in found)
    whole = named.library.scatter.mean + named.improvement.change
    assert np.isclose(stages, whole[strain].sum() / scale)


def test_what_is_foreseen_begins_with_the_recording(named):
    left_out = {named.protocol.segments[k].stage for k in named.improvement.left_out}
    for one in curves(named):
        assert (one.foreseen is not None) == (one.stage in left_out)
        for model in one.foreseen or ():
            assert model[0] == one.recorded[0]


def test_without_a_fit_there_is_the_base_only(nothing):
    assert all(one.after is None and one.foreseen is None for one in curves(nothing))


def test_map_has_all_numbers_and_shares(named):
    rows = differences(named)
    assert sum(len(row.deviations) for row in rows) == len(named.difference)
    assert np.isclose(sum(row.share for row in rows), 1)
    assert next(row for row in rows if "4  hold" in row.name).clear

"""From probabilities to a verdict, and from runs to its confirmation."""

import pytest

from grus.diagnosis.evidence import Explanation
from grus.diagnosis.verdict import Decision, confirmed, decide

NAMED = Decision("named", ("bond_ageing",), {"bond_ageing": 0.99})


def explanations(**shares: float) -> list[Explanation]:
    """Of single suspects by the names of their mechanisms; "nothing" is the empty set."""
    return [
        Explanation(() if name == "nothing" else (f"{name}:size",), 0.0, (), share)
        for name, share in shares.items()
    ]


@pytest.mark.parametrize(
    "shares, whiteness, kind, named",
    [
        ({"bond_ageing": 0.9, "nothing": 0.1}, 1.0, "named", ("bond_ageing",)),
        ({"bond_ageing": 0.6, "nothing": 0.4}, 1.0, "cannot_tell", ("bond_ageing",)),
        ({"bond_ageing": 0.3, "nothing": 0.7}, 1.0, "nothing", ()),
        ({"bond_ageing": 0.9, "nothing": 0.1}, 1e-5, "unknown", ()),
        ({"unknown": 0.6, "bond_ageing": 0.4}, 1.0, "unknown", ()),
    ],
)
def test_verdict_by_probability(shares, whiteness, kind, named):
    decision = decide(explanations(**shares), whiteness=whiteness)
    assert (decision.kind, decision.named) == (kind, named)


def test_nothing_is_unknown_while_mechanisms_have_not_been_run():
    decision = decide(explanations(unknown=0.9, nothing=0.1), complete=False)
    assert decision.kind == "cannot_tell"


@pytest.mark.parametrize(
    "reproduced, between, kind",
    [
        (1.0, False, "named"),
        (0.21, False, "named"),
        (4.8, False, "named"),
        (0.19, False, "cannot_tell"),
        (5.2, False, "cannot_tell"),
        (-1.0, False, "cannot_tell"),
        (None, False, "cannot_tell"),
        (0.07, True, "named"),
    ],
)
def test_what_runs_do_not_reproduce_is_not_named(reproduced, between, kind):
    decision = confirmed(NAMED, reproduced, between)
    assert (decision.kind, decision.named) == (kind, NAMED.named)

"""A campaign in a process of its own, for tests that disturb it. Arguments: store, jobs, scheduler or '-'."""

import sys

from campaigns import disturbed_runs

from grus.campaign import Store, campaign

store, jobs, scheduler = sys.argv[1:]
outcomes = campaign(
    disturbed_runs(),
    Store(store),
    int(jobs),
    None if scheduler == "-" else scheduler,
    tell=lambda line: print(line, flush=True),
)
print("failed:", [outcome.failed for outcome in outcomes.values() if outcome.failed])

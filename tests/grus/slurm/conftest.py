"""Slurm on this machine alone: its three daemons in a temporary configuration, which end with the tests."""

import os
import shutil
import socket
import subprocess
import time
from collections.abc import Callable
from pathlib import Path

import pytest

PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch")
PATH = os.environ["PATH"] + os.pathsep + "/usr/sbin"
CONFIGURATION = """
ClusterName=grus
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
MpiDefault=none
ReturnToService=2
MessageTimeout=90
NodeName={host} NodeAddr=127.0.0.1 CPUs={processors} State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


@pytest.fixture(scope="session")
def slurm(tmp_path_factory):
    """Environment in which Slurm's commands find the daemons."""
    if os.geteuid() != 0:
        pytest.skip("Slurm's daemons need root")
    missing = [name for name in PROGRAMS if not shutil.which(name, path=PATH)]
    if missing:
        pytest.skip(f"{', '.join(missing)} missing: apt-get install slurm-wlm")
    folder = tmp_path_factory.mktemp("slurm")
    host = socket.gethostname().split(".")[0]
    configuration = folder / "slurm.conf"
    for name in ("state", "spool"):
        (folder / name).mkdir()
    key = folder / "munge.key"
    key.touch(mode=0o600)
    key.write_bytes(os.urandom(1024))
    configuration.write_text(
        CONFIGURATION.format(host=host, ports=_ports(), folder=folder, processors=os.cpu_count())
    )
    environment = os.environ | {"SLURM_CONF": str(configuration), "PATH": PATH}
    munge = [f"--{name}={folder}/munge.{name}" for name in ("socket", "pid-file", "log-file")]
    munge += [f"--key-file={key}", f"--seed-file={folder}/munge.seed"]
    daemons = [
        # --force: for a socket below a folder that only root may enter
        (["munged", "--foreground", "--force", *munge], lambda: (folder / "munge.socket").exists()),
        (["slurmctld", "-D", "-i"], lambda: _answers(environment, "scontrol", "ping")),
        (["slurmd", "-D"], lambda: "idle" in _said(environment, "sinfo", "-h", "-o", "%T")),
    ]
    started: list[subprocess.Popen] = []
    try:
        for command, ready in daemons:
            log = (folder / f"{command[0]}.log").open("wb")
            started.append(subprocess.Popen(command, env=environment, stdout=log, stderr=log))
            _until(ready, started[-1], folder / f"{command[0]}.log")
        yield environment
        _until(lambda: not _said(environment, "squeue", "-h"), started[-1], configuration)
    finally:
        for daemon in reversed(started):
            daemon.terminate()
            try:
                daemon.wait(30)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()


def _ports() -> list[int]:
    """Two that are free."""
    with socket.socket() as one, socket.socket() as two:
        for each in (one, two):
            each.bind(("127.0.0.1", 0))
        return [each.getsockname()[1] for each in (one, two)]


def _run(environment: dict, *command: str) -> subprocess.CompletedProcess:
    return subprocess.run(command, env=environment, capture_output=True, text=True)


def _answers(environment: dict, *command: str) -> bool:
    return _run(environment, *command).returncode == 0


def _said(environment: dict, *command: str) -> str:
    return _run(environment, *command).stdout


def _until(ready: Callable[[], bool], daemon: subprocess.Popen, log: Path) -> None:
    for _ in range(600):
        if ready():
            return
        assert daemon.poll() is None, log.read_text()
        time.sleep(0.2)
    raise AssertionError(log.read_text())

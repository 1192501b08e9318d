"""A real Slurm of one node on loopback, started in a temporary directory and ended with it. It
needs root and Debian's slurmctld, slurmd, slurm-client and munge; nothing outside the directory is
read or changed."""

from __future__ import annotations

import os
import shutil
import socket
import subprocess
import time
from pathlib import Path

PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "squeue", "scancel", "sinfo")
CONFIG = """ClusterName=loop
SlurmctldHost={host}(127.0.0.1)
SlurmUser=root
SlurmctldPort={port}
SlurmdPort={port_2}
AuthType=auth/munge
AuthInfo=socket={place}/munge.sock
StateSaveLocation={place}/state
SlurmdSpoolDir={place}/spool
SlurmctldPidFile={place}/ctld.pid
SlurmdPidFile={place}/slurmd.pid
SlurmctldLogFile={place}/ctld.log
SlurmdLogFile={place}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
AccountingStorageType=accounting_storage/none
ReturnToService=2
NodeName={host} NodeAddr=127.0.0.1 CPUs={cpus} State=UNKNOWN
PartitionName=main Nodes={host} Default=YES MaxTime=INFINITE State=UP
"""


def free_ports() -> tuple[int, int]:
    """Two ports of 127.0.0.1 that nobody listens on."""
    with socket.socket() as one, socket.socket() as two:
        one.bind(("127.0.0.1", 0))
        two.bind(("127.0.0.1", 0))
        return one.getsockname()[1], two.getsockname()[1]


class SlurmNode:
    """start() gives the reason where Slurm cannot run here, else None; then `environment` reaches it."""

    def __init__(self, place: Path) -> None:
        self.place = place
        self.environment = dict(os.environ, SLURM_CONF=str(place / "slurm.conf"))
        self._daemons: list[subprocess.Popen] = []

    def start(self) -> str | None:
        path = os.pathsep.join((os.environ.get("PATH", ""), "/usr/sbin", "/sbin"))
        programs = {name: shutil.which(name, path=path) for name in PROGRAMS}
        missing = [name for name, found in programs.items() if found is None]
        if missing:
            return f"not installed: {', '.join(missing)}"
        if os.geteuid() != 0:
            return "only root can start slurmd"
        for name in ("state", "spool", "munge"):
            (self.place / name).mkdir()
        port, port_2 = free_ports()
        (self.place / "slurm.conf").write_text(CONFIG.format(
            place=self.place, host=socket.gethostname().split(".")[0], port=port, port_2=port_2,
            cpus=len(os.sched_getaffinity(0))))
        key = self.place / "munge/key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o400)
        self._run(programs["munged"], "--foreground", "--force", f"--socket={self.place}/munge.sock",
                  f"--key-file={key}", f"--pid-file={self.place}/munge/pid",
                  f"--seed-file={self.place}/munge/seed", f"--log-file={self.place}/munge/log")
        self._await(lambda: (self.place / "munge.sock").exists())
        self._run(programs["slurmctld"], "-D")
        self._run(programs["slurmd"], "-D")
        if not self._await(lambda: "idle" in self.ask("sinfo", "-h", "-o", "%t")):
            return f"Slurm did not come up: {self.ask('sinfo')}"
        return None

    def ask(self, *words: str) -> str:
        """Standard output of one of Slurm's commands."""
        return subprocess.run(words, env=self.environment, capture_output=True, text=True,
                              timeout=30, check=False).stdout

    def stop(self) -> None:
        """Ends the daemons that start() started."""
        for daemon in reversed(self._daemons):
            daemon.terminate()
        for daemon in self._daemons:
            try:
                daemon.wait(timeout=10)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()

    def _run(self, *words: str) -> None:
        self._daemons.append(subprocess.Popen(words, env=self.environment, stdout=subprocess.DEVNULL,
                                              stderr=subprocess.DEVNULL))

    def _await(self, ready, patience_s: float = 30) -> bool:
        end = time.monotonic() + patience_s
        while not ready():
            if time.monotonic() > end:
                return False
            time.sleep(0.1)
        return True

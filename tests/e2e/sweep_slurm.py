#!/usr/bin/python3
"""A sweep as a job array of a real Slurm: a cluster of one node, in a folder of its own, on ports of its own. Its table is that of the local pool.

Usage: sweep_slurm.py SCREE
Exit code 77: Slurm is not installed (Debian: munge slurmctld slurmd slurm-client), or does not start here.
"""
import getpass
import os
import pathlib
import shutil
import socket
import subprocess
import sys
import tempfile
import time

CASE = pathlib.Path(__file__).resolve().parent / "sweep" / "slide.toml"
GRID = ["--param", "joint.plane.friction_deg=5:40:8", "--until", "0.1"]
SKIPPED = 77
PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "sinfo", "scontrol")
CONFIGURATION = """\
ClusterName=scree
SlurmctldHost={host}(127.0.0.1)
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={home}/munge.socket
CryptoType=crypto/munge
StateSaveLocation={home}/state
SlurmdSpoolDir={home}/spool
SlurmctldPidFile={home}/slurmctld.pid
SlurmdPidFile={home}/slurmd.pid
SlurmctldPort={controller}
SlurmdPort={daemon}
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SchedulerParameters=sched_interval=2,bf_interval=2
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
NodeName={host} NodeAddr=127.0.0.1 CPUs={cores} State=UNKNOWN
PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP
"""


def free_port():
    with socket.socket() as s:
        s.bind(("127.0.0.1", 0))
        return s.getsockname()[1]


class Cluster:
    """Runs munged, slurmctld and slurmd; they are stopped at the end."""

    def __init__(self, home):
        self.home, self.daemons = home, []
        self.environment = dict(os.environ, SLURM_CONF=str(home / "slurm.conf"), PATH=os.environ["PATH"] + ":/usr/sbin", OMP_WAIT_POLICY="passive")
        for name in ("state", "spool"):
            (home / name).mkdir()
        (home / "slurm.conf").write_text(CONFIGURATION.format(host=socket.gethostname().split(".")[0], user=getpass.getuser(), home=home,
                                                              controller=free_port(), daemon=free_port(), cores=os.cpu_count()))
        key = home / "munge.key"
        key.write_bytes(os.urandom(1024))
        key.chmod(0o600)

    def __enter__(self):
        h = self.home
        self.start("munged", "--foreground", "--force", f"--key-file={h}/munge.key", f"--socket={h}/munge.socket", f"--pid-file={h}/munged.pid",
                   f"--log-file={h}/munged.log", f"--seed-file={h}/munge.seed")
        self.wait(lambda: (h / "munge.socket").exists(), 10)
        self.start("slurmctld", "-D")
        self.start("slurmd", "-D")
        return self

    def __exit__(self, *_):
        for daemon in reversed(self.daemons):
            daemon.terminate()
            try:
                daemon.wait(10)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()

    def start(self, *command):
        with open(self.home / f"{command[0]}.out", "w") as out:
            self.daemons.append(subprocess.Popen(command, stdout=out, stderr=out, env=self.environment))

    @staticmethod
    def wait(holds, seconds):
        until = time.monotonic() + seconds
        while not holds() and time.monotonic() < until:
            time.sleep(0.2)
        return holds()

    def is_up(self):
        return self.wait(lambda: "idle" in self.run("sinfo", "-h", "-o", "%t").stdout, 60)

    def run(self, *command, timeout=300):
        return subprocess.run(list(map(str, command)), capture_output=True, text=True, env=self.environment, timeout=timeout)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    path = os.environ["PATH"] + ":/usr/sbin"
    if missing := [p for p in PROGRAMS if shutil.which(p, path=path) is None]:
        print("skipped: no", ", ".join(missing))
        return SKIPPED
    scree, faults = sys.argv[1], 0
    with tempfile.TemporaryDirectory(prefix="scree-slurm-") as name:
        work = pathlib.Path(name)
        work.chmod(0o755)
        (home := work / "slurm").mkdir()
        with Cluster(home) as cluster:
            if not cluster.is_up():
                print("skipped: Slurm does not start here:", *(p.read_text()[-500:] for p in home.glob("*.out")), sep="\n")
                return SKIPPED
            local = cluster.run(scree, "sweep", CASE, *GRID, "--out", work / "local")
            array = cluster.run(scree, "sweep", CASE, *GRID, "--out", work / "array", "--on", "slurm")
            print(array.stdout, array.stderr, sep="")
            same = local.returncode == 0 == array.returncode and (work / "local/sweep.csv").read_bytes() == (work / "array/sweep.csv").read_bytes()
            faults += not same
            print("the table of the job array is that of the local pool" if same else f"FAULT: {local} {array}")
            again = cluster.run(scree, "sweep", CASE, *GRID, "--out", work / "array", "--on", "slurm")
            idle = again.returncode == 0 and "job" not in again.stdout
            faults += not idle
            print("the same command again submits nothing" if idle else f"FAULT: {again}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

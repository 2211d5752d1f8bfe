#!/usr/bin/python3
"""External events that end a run: signals, a closed terminal, output that no program reads. Each must leave a
checkpoint, closed results and exit code 130, within 2 s. Other commands end without a message where their output is not
read.

Usage: signals.py SCREE
"""
import json
import os
import pathlib
import pty
import resource
import signal
import subprocess
import sys
import tempfile
import time

import h5py

CASE = pathlib.Path(__file__).resolve().parent / "resume/motion.toml"
LONG = ["--set", "stage.0.duration=1000.0"]
MOST, MOST_WALL = 2.0, 30.0  # s of processor time; s of wall time, on a busy machine
ENVIRONMENT = dict(os.environ, OMP_WAIT_POLICY="passive", OMP_NUM_THREADS="1")
SCREE = sys.argv[1]
faults = []


def fault(text):
    faults.append(text)
    print("FAULT: " + text, flush=True)


def start(command, run, **streams):
    ask = {"run": ["run", CASE, "--out", run, *LONG], "resume": ["resume", run]}[command]
    return subprocess.Popen([SCREE, *map(str, ask)], env=ENVIRONMENT, **streams)


def wait_for_steps(run, process, before=0):
    """Waits until the results contain a later instant than before."""
    until = time.monotonic() + 60
    while not (run / "energy.csv").exists() or len((run / "energy.csv").read_bytes().splitlines()) <= before + 3:
        if process.poll() is not None or time.monotonic() > until:
            raise SystemExit(f"the run did not begin: exit code {process.poll()}")
        time.sleep(0.02)


def cpu_seconds(process):
    """Processor time of a process that has not been waited for yet."""
    fields = pathlib.Path(f"/proc/{process.pid}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def cpu_of_children():
    """Processor time of all child processes that have been waited for."""
    spent = resource.getrusage(resource.RUSAGE_CHILDREN)
    return spent.ru_utime + spent.ru_stime


def log_of(run):
    return (run / "run.log").read_text()[-300:] if (run / "run.log").exists() else "no log"


def stopped(what, run, process, began):
    of_others, used = cpu_of_children(), cpu_seconds(process)
    try:
        process.wait(timeout=MOST_WALL)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()
    took, wall = cpu_of_children() - of_others, time.monotonic() - began
    print(f"{what}: exit code {process.returncode}, {wall:.2f} s, {took - used:.2f} s of processor time", flush=True)
    if process.returncode != 130:
        fault(f"{what}: exit code {process.returncode}: {log_of(run)}")
    if took - used > MOST or wall > MOST_WALL:
        fault(f"{what}: {wall:.2f} s, {took - used:.2f} s of processor time")
    if not list(run.glob("checkpoint.*.scree")):
        fault(f"{what}: no checkpoint")
    if not (run / "summary.json").exists() or json.loads((run / "summary.json").read_text())["status"] != "interrupted":
        fault(f"{what}: the results are not closed")
        return
    with h5py.File(run / "run.vtkhdf") as file:
        if len(file["VTKHDF/Steps/Values"]) < 1:
            fault(f"{what}: no frame")


def goes_on(what, run):
    time_reached = json.loads((run / "summary.json").read_text())["final_time"]
    done = subprocess.run([SCREE, "resume", str(run), "--quiet", "--until", f"{time_reached + 0.05:.6f}"],
                          env=ENVIRONMENT, capture_output=True, text=True, timeout=100)
    if done.returncode != 0:
        fault(f"{what}, resumed: exit code {done.returncode}: {done.stderr.strip()}")


def signals(scratch):
    null = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    for name in ("SIGHUP", "SIGINT", "SIGTERM"):
        run = scratch / name
        process = start("run", run, **null)
        wait_for_steps(run, process)
        began = time.monotonic()
        process.send_signal(getattr(signal, name))
        stopped(name, run, process, began)
        goes_on(name, run)
    run = scratch / "SIGTERM"
    lines = len((run / "energy.csv").read_bytes().splitlines())
    process = subprocess.Popen([SCREE, "resume", str(run), "--until", "900"], env=ENVIRONMENT, **null)
    wait_for_steps(run, process, lines)
    began = time.monotonic()
    process.send_signal(signal.SIGHUP)
    stopped("SIGHUP of resume", run, process, began)
    # Two signals at once, as timeout(1) and systemd send them, count as one.
    run = scratch / "both"
    process = start("run", run, **null)
    wait_for_steps(run, process)
    began = time.monotonic()
    for name in (signal.SIGTERM, signal.SIGHUP, signal.SIGTERM, signal.SIGHUP):
        process.send_signal(name)
        time.sleep(0.002)
    stopped("two at once", run, process, began)
    # nohup: SIGHUP is ignored before the program starts, and remains ignored.
    run = scratch / "nohup"
    process = start("run", run, **null, preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
    wait_for_steps(run, process)
    process.send_signal(signal.SIGHUP)
    time.sleep(0.3)
    if process.poll() is not None:
        fault(f"nohup: the run ended, exit code {process.returncode}")
    process.terminate()
    process.wait()


def closed_terminal(scratch):
    """The terminal of a session is closed: its leader, the run, receives SIGHUP, and writes fail."""
    for how in ("a session's", "another's"):
        run = scratch / ("terminal of " + how)
        master, slave = pty.openpty()
        process = start("run", run, stdin=slave, stdout=slave, stderr=slave, start_new_session=how == "a session's")
        os.close(slave)
        os.set_blocking(master, False)
        while not (run / "energy.csv").exists():
            try:
                os.read(master, 4096)
            except BlockingIOError:
                time.sleep(0.02)
        wait_for_steps(run, process)
        began = time.monotonic()
        os.close(master)
        stopped(f"{how} terminal closed", run, process, began)


def broken_output(scratch):
    for what in ("stdout", "stderr"):
        run = scratch / what
        reader, writer = os.pipe()
        streams = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL, what: writer}
        process = start("run", run, **streams)
        os.close(writer)
        wait_for_steps(run, process)
        began = time.monotonic()
        os.close(reader)
        stopped(what + " broken", run, process, began)
        goes_on(what + " broken", run)
    run = scratch / "full"
    with open("/dev/full", "wb") as full:
        began = time.monotonic()
        stopped("stdout on a full disk", run, start("run", run, stdout=full, stderr=subprocess.DEVNULL), began)
    # A reader that does not read: the pipe is full when the signal comes.
    run = scratch / "unread"
    reader, writer = os.pipe()
    os.set_blocking(writer, False)
    try:
        while True:
            os.write(writer, b"x" * 4096)
    except BlockingIOError:
        os.set_blocking(writer, True)
    process = start("run", run, stdout=writer, stderr=subprocess.DEVNULL)
    time.sleep(0.7)
    began = time.monotonic()
    process.terminate()
    stopped("SIGTERM while output waits", run, process, began)
    os.close(writer)
    os.close(reader)
    done = subprocess.run(["bash", "-c", '"$0" run "$1" --out "$2" ' + " ".join(LONG) + ' | head -1; exit ${PIPESTATUS[0]}',
                           SCREE, str(CASE), str(scratch / "head")], env=ENVIRONMENT, capture_output=True, timeout=60)
    if done.returncode != 130 or not list((scratch / "head").glob("checkpoint.*.scree")):
        fault(f"run | head -1: exit code {done.returncode}: {done.stderr}")
    # Standard output closed: no file of the run may take its place.
    run = scratch / "closed"
    done = subprocess.run(["bash", "-c", '"$0" run "$1" --out "$2" --until 0.02 >&- 2>&-', SCREE, str(CASE), str(run)],
                          env=ENVIRONMENT, timeout=60)
    if done.returncode != 0:
        fault(f"stdout closed: exit code {done.returncode}")
    else:
        h5py.File(run / "run.vtkhdf").close()


def other_commands(scratch):
    for words in (["schema"], ["schema", "--markdown"], ["cases", "list"], ["completion", "bash"], ["--help"],
                  ["check", str(CASE), "--blocks"], ["watch", str(scratch / "SIGHUP"), "--once"]):
        for ignored in (False, True):  # some programs start others with signals ignored
            reader, writer = os.pipe()
            os.close(reader)
            process = subprocess.Popen([SCREE, *words], stdout=writer, stderr=subprocess.PIPE, text=True,
                                       restore_signals=not ignored)
            os.close(writer)
            err = process.communicate(timeout=60)[1]
            if process.returncode not in (-signal.SIGPIPE, 0) or err:
                fault(f"{' '.join(words)} with nobody reading: exit code {process.returncode}: {err.strip()}")
    with open("/dev/full", "wb") as full:
        done = subprocess.run([SCREE, "schema"], stdout=full, stderr=subprocess.PIPE, text=True, check=False)
    if done.returncode != 5 or "No space left" not in done.stderr:
        fault(f"schema on a full disk: exit code {done.returncode}: {done.stderr}")


with tempfile.TemporaryDirectory(prefix="scree-signals-") as folder:
    for test in (signals, closed_terminal, broken_output, other_commands):
        test(pathlib.Path(folder))
sys.exit(1 if faults else 0)

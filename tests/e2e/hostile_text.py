#!/usr/bin/python3
"""Terminal control characters in every input of a command: the output never contains them unescaped.

Usage: hostile_text.py SCREE
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

SCREE = os.path.abspath(sys.argv[1])
CASE = (pathlib.Path(__file__).resolve().parent / "resume/motion.toml").read_text()
PULSE = pathlib.Path(__file__).resolve().parent / "resume/pulse.csv"
# ESC, BEL, CR, CSI as one C1 character and as a raw byte, right-to-left override, isolate, a mark of direction.
EVIL = b"x\x1b[31m\x07\r\xc2\x9b1m\x9b2m\xe2\x80\xae\xe2\x81\xa6\xe2\x80\x8f\xd8\x9cy"
EVIL_UTF8 = EVIL.replace(b"\x9b2m", b"")  # TOML accepts valid UTF-8 only
ESCAPED = "x\\u001b[31m\\u0007\\r\\u009b1m\\u202e\\u2066\\u200f\\u061cy"
RAW = re.compile(b"[\x00-\x08\x0b-\x1f\x7f]|\xc2[\x80-\x9f]|\xd8\x9c|\xe2\x80[\x8e\x8f\xa8-\xae]|\xe2\x81[\xa6-\xa9]")
faults = []
commands = 0


def check(what, data):
    found = RAW.search(data)
    try:
        data.decode()
    except UnicodeDecodeError as error:
        found = error
    if found:
        faults.append(what)
        print(f"FAULT: {what}: {found}", flush=True)


def scree(*words, code=None, **options):
    global commands
    commands += 1
    done = subprocess.run([SCREE, *words], capture_output=True, timeout=100, check=False, **options)
    what = " ".join(w.decode(errors="backslashreplace") if isinstance(w, bytes) else str(w) for w in words)
    check(what[:200] + ": stdout", done.stdout)
    check(what[:200] + ": stderr", done.stderr)
    if (code is not None and done.returncode != code) or done.returncode < 0:
        faults.append(what)
        print(f"FAULT: {what}: exit code {done.returncode}: {done.stderr!r}", flush=True)
    return done


def test(scratch):
    os.chdir(scratch)
    shutil.copy(PULSE, "pulse.csv")
    # In a case file: refused, with line and column.
    for k, (old, new) in enumerate([
            ('title = "Resume: ground motion"', f'title = "{ESCAPED}"'),
            ('name = "low"', f'name = "{ESCAPED}"'), ('name = "high"', f'name = "{ESCAPED}"'),
            ('name = "shake"', f'name = "{ESCAPED}"'), ('[material.rock]', f'[material."{ESCAPED}"]'),
            ('[joint.rough]', f'[joint."{ESCAPED}"]'), ('material = "rock"', f'material = "{ESCAPED}"'),
            ('file = "pulse.csv"', f'file = "{ESCAPED}"'), ('[model]', f'[model]\n"{ESCAPED}" = 1'),
            ('unit = "m/s2"', f'unit = "{ESCAPED}"')]):
        assert old in CASE, old
        pathlib.Path("case.toml").write_text(CASE.replace(old, new, 1))
        for command in ("check", "run"):
            done = scree(command, "case.toml", code=3)
            if not re.match(rb"case\.toml:\d+:\d+: error: ", done.stderr) or b"hint: " not in done.stderr:
                faults.append(str(k))
                print(f"FAULT: {new}: {done.stderr!r}")
    for text in (b'title = "' + EVIL_UTF8 + b'"\n', b"title = '" + EVIL_UTF8, EVIL, b"# " + EVIL + b"\n", EVIL_UTF8 + b" = 1\n",
                 b"x = 1 " + EVIL_UTF8, b"[" + EVIL_UTF8 + b"]\n"):
        pathlib.Path("case.toml").write_bytes(text)
        scree("check", "case.toml", code=3)
    pathlib.Path("case.toml").write_text(CASE)
    for setting in (b"title='" + EVIL + b"'", f'title="{ESCAPED}"', EVIL + b"=1", b"stage.0.duration=" + EVIL, EVIL):
        scree("check", "case.toml", "--set", setting, code=3)
    pathlib.Path("pulse.csv").write_bytes(EVIL + b"," + EVIL + b"\n0,0\n" + EVIL + b",1\n")
    scree("check", "case.toml", code=3)
    shutil.copy(PULSE, "pulse.csv")
    # In names of files, folders and runs, and in any word of the command line.
    folder = b"run" + EVIL
    shutil.copy("case.toml", EVIL + b".toml")
    scree("check", EVIL + b".toml", code=0)
    scree("run", EVIL + b".toml", "--out", folder, "--until", "0.02", "--name", EVIL, "--audit", code=0)
    check("run.log", pathlib.Path(os.fsdecode(folder), "run.log").read_bytes())
    check("summary.json", pathlib.Path(os.fsdecode(folder), "summary.json").read_bytes())
    json.loads(pathlib.Path(os.fsdecode(folder), "summary.json").read_text())
    scree("run", "case.toml", "--out", folder, code=5)
    scree("resume", folder, "--until", "0.04", code=0)
    check("run.log", pathlib.Path(os.fsdecode(folder), "run.log").read_bytes())
    scree("watch", folder, code=0)
    for picture in (b"a.svg", b"a.png", EVIL + b".svg"):
        scree("snapshot", folder, "--labels", "--out", picture, code=0)
    check("a.svg", pathlib.Path("a.svg").read_bytes())
    scree("snapshot", folder, "--history", "--out", "h.svg", code=0)
    check("h.svg", pathlib.Path("h.svg").read_bytes())
    for words in (["--at", EVIL], ["--field", EVIL], ["--history", EVIL], ["--out", EVIL], ["--window", EVIL], ["--arrows", EVIL]):
        scree("snapshot", folder, *words)
    scree("replay", folder, "--speed", "0", "--live", b"file://" + EVIL + b".lcm")
    scree("watch", b"file://" + EVIL + b".lcm", "--timeout", "1")
    for words in ([EVIL], ["run", EVIL], ["check", EVIL], ["resume", EVIL], ["watch", b"./" + EVIL], ["watch", EVIL + b"://"],
                  ["snapshot", EVIL], ["replay", EVIL], ["replay", folder, "--live", EVIL], ["cases", EVIL],
                  ["cases", "verify", EVIL], ["completion", EVIL], ["schema", EVIL], ["run", b"--" + EVIL],
                  ["control", EVIL + b"://", "stop"], ["control", "x", EVIL], ["check", "case.toml", "--" + "y", EVIL],
                  ["run", "case.toml", b"--live=" + EVIL], ["run", "case.toml", "--threads", EVIL]):
        scree(*words)
    # A stored run of another program, with arbitrary names and texts in the file.
    names(folder)
    # The case library in a folder with such a name.
    library = pathlib.Path(os.fsdecode(b"lib" + EVIL), os.fsdecode(EVIL))
    library.mkdir(parents=True)
    shutil.copy("case.toml", library / "case.toml")
    shutil.copy("pulse.csv", library / "pulse.csv")
    (library / "expected.toml").write_bytes(b'[[quantity]]\nname = "' + ESCAPED.encode() + b'"\n')
    environment = dict(os.environ, SCREE_CASES=os.fsdecode(b"lib" + EVIL))
    scree("cases", "list", env=environment)
    scree("cases", "verify", env=environment)
    scree("cases", "verify", "none", env=environment)


def names(folder):
    import h5py
    run = os.fsencode(os.path.join(os.getcwd(), "stored"))
    shutil.copytree(folder, run)

    def spoil(_, item):
        for key, value in item.attrs.items():
            if key in ("title", "status", "reason", "version", "stage") and isinstance(value, (bytes, str)):
                item.attrs[key] = EVIL_UTF8.decode()
        if isinstance(item, h5py.Dataset) and item.dtype.kind == "O" and item.shape:
            item[...] = [EVIL_UTF8.decode()] * item.shape[0]

    with h5py.File(os.fsdecode(run) + "/run.vtkhdf", "a") as file:
        file.visititems(spoil)
        spoil("/", file)
    for words in (["watch", run], ["snapshot", run, "--labels", "--out", "s.svg"], ["snapshot", run, "--history", "--out", "s.svg"],
                  ["snapshot", run, "--at", "nothing"], ["snapshot", run, "--history", "nothing"],
                  ["replay", run, "--speed", "0", "--live", "file://s.lcm"], ["watch", "file://s.lcm", "--once", "--timeout", "2"],
                  ["watch", "file://s.lcm", "--timeout", "2"]):
        scree(*words)


with tempfile.TemporaryDirectory(prefix="scree-text-") as place:
    test(place)
    os.chdir("/")
print(f"{commands} commands, {len(faults)} faults")
sys.exit(1 if faults else 0)

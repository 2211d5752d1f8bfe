#!/usr/bin/python3
"""The table of speed and memory: what the work of docs/performance.md takes, by the command as a user runs it.

    tests/bench/table.py --scree build/release/app/scree --baseline OLD/scree [--rows NAME ...] [--repeats 5]

Every figure is processor time of a whole process (user and system, all its threads), of a long run less a short one of
the same case, so that set-up and the first frame count in neither; both programs take turns, round after round, and the
least and the median of the rounds are printed, with the ratio of the medians. Without --baseline there is no ratio.

--full adds what takes minutes (10,000 and 100,000 blocks). --history FILE (default BUILD/bench/history.jsonl beside the
program) gets a line a run: date, commit, machine, every figure; the last line of the same machine is compared with.
--plots FOLDER writes growth plots (SVG). Nothing else may run on the machine: the load is printed.
"""
import argparse
import datetime
import json
import os
import pathlib
import platform
import shutil
import statistics
import subprocess
import sys
import tempfile

import h5py

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import bench_cases
import bench_plots

ROOT = pathlib.Path(__file__).resolve().parents[2]
NEW, OLD = "new", "baseline"
PLOTS = {"memory": ("Peak memory", "bytes"), "point": ("A closed contact point of an explicit wall, a step", "ns"),
         "step": ("A step of a wall of N blocks", "ms")}


class Program:
    """One build of the command, and how it is run."""

    def __init__(self, name, path, scratch):
        self.name, self.path, self.scratch = name, pathlib.Path(path).resolve(), scratch / name
        self.scratch.mkdir()

    def __call__(self, *arguments, threads=1):
        """CPU seconds and wall seconds of a command that must succeed.

        It runs in a shell: a process that Python starts itself begins with the peak memory of Python, and its summary would report that.
        """
        environment = dict(os.environ, OMP_NUM_THREADS=str(threads))  # threads wait as they do for users
        environment.pop("OMP_WAIT_POLICY", None)
        command = [str(self.path), *map(str, arguments)]
        begin = datetime.datetime.now()
        process = subprocess.Popen(["/bin/sh", "-c", '"$@"; exit $?', "sh", *command], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, env=environment)
        error = process.stderr.read()
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode != 0:
            raise RuntimeError(f"{' '.join(command)}: exit code {process.returncode}: {error.strip()}")
        return used.ru_utime + used.ru_stime, (datetime.datetime.now() - begin).total_seconds()

    def run(self, case, name, *arguments, threads=1):
        """A run from the start: its CPU and wall seconds, and its summary."""
        out = self.scratch / name
        use = self("run", case, "--out", out, "--overwrite", "--quiet", "--threads", threads, *arguments, threads=threads)
        return use, json.loads((out / "summary.json").read_text())

    def resumed(self, prepared, until, threads=1):
        """Seconds and summary of a copy of a run that continues until a time."""
        out = self.scratch / "resumed"
        shutil.rmtree(out, ignore_errors=True)
        shutil.copytree(self.scratch / prepared, out)
        use = self("resume", out, "--until", until, "--quiet", "--threads", threads, threads=threads)
        return use, json.loads((out / "summary.json").read_text())


class Figure:
    """Results of a row by program: one value per round."""

    def __init__(self, row, unit, must=None, higher=False):
        self.row, self.unit, self.must, self.higher, self.values = row, unit, must, higher, {}

    def add(self, program, value):
        self.values.setdefault(program.name, []).append(value)

    def least(self, name):
        return (max if self.higher else min)(self.values[name])

    def median(self, name):
        return statistics.median(self.values[name])

    def ratio(self):
        return self.median(NEW) / self.median(OLD) if NEW in self.values and OLD in self.values else None


class Table:
    def __init__(self, programs, repeats, full, scratch):
        self.programs, self.repeats, self.full, self.scratch, self.figures = programs, repeats, full, scratch, {}
        self.growth = {name: (title, unit, {}) for name, (title, unit) in PLOTS.items()}

    def figure(self, row, unit, must=None, higher=False):
        return self.figures.setdefault(row, Figure(row, unit, must, higher))

    def grow(self, plot, series, n, value, program=None):
        """Adds a point to a growth plot; of a program, where two are compared."""
        if program is not None and len(self.programs) > 1:
            series = f"{program.name}: {series}"
        self.growth[plot][2].setdefault(series, []).append((n, value))

    def case(self, name, text):
        path = self.scratch / f"{name}.toml"
        path.write_text(text)
        return path

    def rounds(self, measure):
        """Runs the programs in turns; `measure(program)` adds the values of a round."""
        for k in range(self.repeats):
            for program in self.programs if k % 2 == 0 else self.programs[::-1]:
                measure(program)

    def steps(self, prepared, at, short, long, add, threads=1):
        """Rounds of steps after a prepared run: add(program, CPU s per step, summary)."""
        def measure(program):
            (a, _), first = program.resumed(prepared, at + short, threads)
            (b, _), second = program.resumed(prepared, at + long, threads)
            add(program, (b - a) / (second["steps"] - first["steps"]), second)
        self.rounds(measure)


# --- rows ----------------------------------------------------------------------------------------------------------


def explicit_wall(table, courses=30):
    """Explicit steps of a settled wall of DDA blocks: cost per step, and per closed contact point."""
    blocks = bench_cases.wall_blocks(courses)
    case = table.case(f"explicit-{courses}", bench_cases.wall(courses, "explicit"))
    for program in table.programs:
        program.run(case, f"explicit-{courses}", "--until", bench_cases.settled(courses))
    main = courses == 30
    step = table.figure(f"explicit DDA, wall of {blocks} blocks: a step", "ms", 0.7 if main else None)
    point = table.figure(f"explicit DDA, wall of {blocks} blocks: a closed contact point", "ns", 120)

    def add(program, seconds, summary):
        step.add(program, 1e3 * seconds)
        point.add(program, 1e9 * seconds / summary["contacts"])
    table.steps(f"explicit-{courses}", bench_cases.settled(courses), 0.002, 0.002 + 0.3 / courses, add)
    for p in table.programs:
        table.grow("point", "explicit", 1e6 * step.median(p.name) / point.median(p.name), point.median(p.name), p)
        table.grow("step", "explicit", blocks, step.median(p.name), p)


def explicit_points(table):
    """Growth of the cost per contact point."""
    for courses in (10, 60) + ((100,) if table.full else ()):
        explicit_wall(table, courses)


def slope(table):
    """Shaking of cases/staged-slope, after shorter rest than the case has: elements, contacts and the step bound."""
    case = ROOT / "cases/staged-slope/case.toml"
    short = [word for key, value in (("settle", 0.01), ("hold", 0.01), ("shaking", 0.1))
             for word in ("--set", f"stage.{key}.duration={value}")]
    begin = 0.53  # gravity takes 0.5 s
    for program in table.programs:
        program.run(case, "slope", "--until", begin, *short)
    rate = table.figure("staged-slope, shaking", "1e6 element steps/s", 6, higher=True)
    step = table.figure("staged-slope, shaking: a step", "ms")

    def add(program, seconds, found):
        rate.add(program, 1e-6 * found["elements"] / seconds)
        step.add(program, 1e3 * seconds)
    table.steps("slope", begin, 0.002, 0.062, add)  # set-up takes seconds, and varies


def implicit_wall(table, courses=30):
    blocks = bench_cases.wall_blocks(courses)
    long = min(0.105, 3.0 / courses)
    for kind, must in (("rest", 5), ("shaken", 10)):
        name = f"implicit-{kind}-{courses}"
        case = table.case(name, bench_cases.wall(courses, "implicit", kind == "shaken"))
        for program in table.programs:
            program.run(case, name, "--until", bench_cases.settled(courses))
        figure = table.figure(f"implicit DDA, wall of {blocks} blocks, {kind}, 1 ms: a step", "ms", must if courses == 30 else None)
        table.steps(name, bench_cases.settled(courses), 0.005, 0.005 + long, lambda p, s, _, f=figure: f.add(p, 1e3 * s))
        for p in table.programs:
            table.grow("step", f"implicit, {kind}", blocks, figure.median(p.name), p)


def box2d(table, courses=30):
    """The same walls in Box2D, where tests/bench/box2d_wall.cpp was built (libbox2d-dev)."""
    driver = table.programs[0].path.parents[1] / "tests/bench_box2d_wall"
    if not driver.exists():
        print(f"# box2d: skipped, there is no {driver}", file=sys.stderr)
        return
    for kind in ("rest", "shaken"):
        figure = table.figure(f"Box2D, 8/3 iterations, wall of {bench_cases.wall_blocks(courses)} blocks, {kind}, 1 ms: a step", "ms")
        for _ in range(table.repeats):
            told = subprocess.run([driver, str(courses), "500", "0.001", kind], capture_output=True, text=True, check=True).stdout
            figure.add(table.programs[0], float(told.rsplit(":", 1)[1].split()[0]))


def implicit_growth(table):
    for courses in (15, 60) + ((100, 316) if table.full else ()):
        implicit_wall(table, courses)


def partitioned(table):
    """Whole-process CPU of the cases with explicit and implicit blocks in one step."""
    cases = {name: ROOT / "cases" / name / "case.toml" for name in ("four-blocks", "slope-ei")}
    cases["stiff-stack"] = table.case("stiff-stack", bench_cases.STIFF_STACK)
    for name, case in cases.items():
        figure = table.figure(f"{name}: whole process", "s", None)
        table.rounds(lambda p, f=figure, c=case, n=name: f.add(p, p.run(c, n)[0][0]))


def sleeping(table):
    """Steps of 20 piles of 52 blocks, one of which is shaken: 19 asleep, against all awake."""
    program = table.programs[0]
    for kind, asleep, short, long in (("explicit", 0.05, 0.002, 0.102), ("implicit", 0.3, 0.005, 0.255)):
        names = {}
        for sleep in ("1e-6", "0.0"):
            names[sleep] = f"piles-{kind}-{sleep}"
            program.run(table.case(names[sleep], bench_cases.piles(kind, sleep)), names[sleep], "--until", bench_cases.SETTLED + asleep)
        step = table.figure(f"{kind} DDA, 1,040 blocks in 20 piles, 19 asleep: a step", "ms")
        share = table.figure(f"{kind} DDA, 1,040 blocks in 20 piles, 19 asleep: of a step with all awake", "%", 15)
        for _ in range(table.repeats):
            of = {}
            for sleep, name in names.items():
                (a, _), first = program.resumed(name, bench_cases.SETTLED + asleep + short)
                (b, _), second = program.resumed(name, bench_cases.SETTLED + asleep + long)
                of[sleep] = (b - a) / (second["steps"] - first["steps"])
            step.add(program, 1e3 * of["1e-6"])
            share.add(program, 100.0 * of["1e-6"] / of["0.0"])


def jinping(table):
    """Whole-process CPU of the staged run, and the share of output: the difference to the same run without frames."""
    case = ROOT / "cases/jinping/case.toml"
    whole = table.figure("jinping, staged: whole process", "s")
    share = table.figure("jinping: output, of the whole process", "%", 8)

    def measure(program):
        (with_frames, _), summary = program.run(case, "jinping")
        (without, _), _ = program.run(case, "jinping-none", "--set", "output.every=1e6", "--set", "output.history_every=1e6")
        whole.add(program, with_frames)
        share.add(program, 100.0 * (with_frames - without) / with_frames)
        table.figure("jinping: output, by the run's own clock", "%", 8)
        if "cpu_seconds_of" in summary:
            table.figure("jinping: output, by the run's own clock", "%", 8).add(
                program, 100.0 * summary["cpu_seconds_of"]["output"] / summary["cpu_seconds"])
    table.rounds(measure)


def two_blocks(table):
    """A hundred frames of two blocks: size of the output, CPU."""
    case = table.case("two-blocks", bench_cases.TWO_BLOCKS)
    size = table.figure("two blocks, 101 frames: run.vtkhdf", "kB", 300)
    folder = table.figure("two blocks, 101 frames: run.vtkhdf and run.xmf", "kB")
    cpu = table.figure("two blocks, 101 frames: whole process", "ms")

    def measure(program):
        (seconds, _), _ = program.run(case, "two-blocks")
        out = program.scratch / "two-blocks"
        bytes_of = {n: (out / n).stat().st_size for n in ("run.vtkhdf", "run.xmf")}
        size.add(program, 1e-3 * bytes_of["run.vtkhdf"])
        folder.add(program, 1e-3 * sum(bytes_of.values()))
        cpu.add(program, 1e3 * seconds)
    table.rounds(measure)


def memory(table):
    """Peak memory over N: of a wall at rest (blocks, with their contacts), of the same blocks apart, of an NMM block."""
    sizes = (10, 30, 60) + ((100, 200, 316) if table.full else ())
    for program in table.programs[:1]:
        touching, apart, contacts, elements = [], [], [], []
        for courses in sizes:
            n = bench_cases.wall_blocks(courses)
            for kind, points in (("touching", touching), ("apart", apart)):
                case = table.case(f"{kind}-{courses}", bench_cases.wall(courses, "explicit", apart=kind == "apart", settle=False))
                _, summary = program.run(case, "memory", "--until", 1e-4, "--set", "output.contacts=true")
                points.append((n, summary["peak_memory_bytes"]))
                if kind == "touching":  # all contact points in the list, open ones too
                    with h5py.File(program.scratch / "memory/run.vtkhdf") as file:
                        contacts.append(int(file["contacts/frames/count"][-1]))
        for cover in (0.5, 0.25, 0.125) + ((0.0625,) if table.full else ()):
            case = table.case(f"block-{cover}", bench_cases.mesh(cover))
            _, summary = program.run(case, "memory", "--until", 1e-6)
            elements.append((summary["elements"], summary["peak_memory_bytes"]))
        each = lambda points: (points[-1][1] - points[0][1]) / (points[-1][0] - points[0][0])
        table.figure("memory: a block of a wall, contacts included, explicit", "kB").add(program, 1e-3 * each(touching))
        table.figure("memory: a block that touches nothing", "kB").add(program, 1e-3 * each(apart))
        table.figure("memory: a contact point that is watched, explicit", "kB").add(
            program, 1e-3 * (each(touching) - each(apart)) * (sizes and (touching[-1][0] - touching[0][0]) / (contacts[-1] - contacts[0])))
        table.figure("memory: an element of the NMM, explicit", "kB").add(program, 1e-3 * each(elements))
        for name, points in (("blocks in a wall", touching), ("blocks apart", apart), ("NMM elements", elements)):
            for n, value in points:
                table.grow("memory", name, n, value)


def threads(table):
    """Wall time of two threads over one; a shared machine shows less."""
    if (os.cpu_count() or 1) < 2:
        return
    for kind, name, long in (("explicit", "explicit-60", 0.042), ("implicit", "implicit-rest-60", 0.105)):
        if not all((p.scratch / name).exists() for p in table.programs):
            print(f"# threads: not measured for {kind} steps without the row {'points' if kind == 'explicit' else 'growth'}", file=sys.stderr)
            continue
        figure = table.figure(f"two threads, {kind}, wall of {bench_cases.wall_blocks(60)} blocks: wall time of one over that of two", "1", 1.6, higher=True)

        def measure(program, name=name, figure=figure, long=long):
            begin = bench_cases.settled(60)
            wall = [program.resumed(name, begin + long, n)[0][1] - program.resumed(name, begin + 0.002, n)[0][1]
                    for n in (1, 2)]
            figure.add(program, wall[0] / wall[1])
        table.rounds(measure)


def large(table):
    """100,000 blocks: check, set-up up to the first step, one implicit step; memory. Smaller walls for the growth plots."""
    if not table.full:
        return
    largest = 316
    check = table.figure("100,000 blocks: check", "s", 15)
    enter = table.figure("100,000 blocks: to the first step", "s")
    one = table.figure("100,000 blocks: an implicit step", "s", 8)
    peak = table.figure("100,000 blocks: memory", "GB", 2.5)
    for courses in (30, 60, 100, 200, largest):
        case = table.case("large", bench_cases.wall(courses, "implicit", settle=False))
        blocks = bench_cases.wall_blocks(courses)
        for program in table.programs:
            (first, _), before = program.run(case, "large", "--until", 0.001)
            steps = max(1, 20000 // blocks)  # a single step of a small wall is less than what the clock varies by
            (second, _), summary = program.run(case, "large", "--until", 0.001 * (1 + steps))
            if program.name == NEW:  # by the run's own clock: set-up takes longer than a step, and varies
                step = (summary["cpu_seconds_of"]["implicit"] - before["cpu_seconds_of"]["implicit"]) / steps
                table.grow("step", "implicit, after the first from rest", blocks, 1e3 * step)
                table.grow("memory", "blocks in a wall, implicit", blocks, summary["peak_memory_bytes"])
            if courses < largest:
                continue
            check.add(program, program("check", case)[0])
            one.add(program, second - first)
            enter.add(program, first - (second - first))
            peak.add(program, 1e-9 * summary["peak_memory_bytes"])


ROWS = {"explicit": explicit_wall, "points": explicit_points, "slope": slope, "implicit": implicit_wall, "box2d": box2d, "growth": implicit_growth,
        "partitioned": partitioned, "sleeping": sleeping, "jinping": jinping, "two-blocks": two_blocks, "memory": memory, "threads": threads, "large": large}


# --- what is printed and kept --------------------------------------------------------------------------------------


def machine():
    model = next((line.split(":", 1)[1].strip() for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines()
                  if line.startswith("model name")), platform.machine())
    return {"cpu": model, "cores": os.cpu_count(), "system": platform.system() + " " + platform.release()}


def commit():
    git = lambda *a: subprocess.run(["git", "-C", ROOT, *a], capture_output=True, text=True, check=False).stdout.strip()
    return git("rev-parse", "--short", "HEAD") + ("+" if git("status", "--porcelain", "--untracked-files=no") else "")


def last_of(history, here):
    lines = [json.loads(line) for line in history.read_text().splitlines()] if history.exists() else []
    return next((line for line in reversed(lines) if line["machine"] == here), None)


def printed(table, before):
    head = ["work", "unit", "least", "median"] + (["baseline: median", "ratio"] if len(table.programs) > 1 else []) + ["must", "last time"]
    lines = []
    for f in table.figures.values():
        if NEW not in f.values:
            continue
        line = [f.row, f.unit, f"{f.least(NEW):.3g}", f"{f.median(NEW):.3g}"]
        if len(table.programs) > 1:
            line += [f"{f.median(OLD):.3g}", f"{f.ratio():.2f}"] if OLD in f.values else ["", ""]
        line.append("" if f.must is None else f"{f.must:g}")
        old = (before or {}).get("figures", {}).get(f.row)
        line.append("" if old is None else f"{f.median(NEW) / old['median']:.2f} x" if old["median"] else "")
        lines.append(line)
    print("| " + " | ".join(head) + " |\n|" + "---|" * len(head))
    for line in lines:
        print("| " + " | ".join(line) + " |")
    return [f.row for f in table.figures.values() if before and NEW in f.values and (old := before["figures"].get(f.row))
            and old["median"] and (f.median(NEW) / old["median"] > 1.15) != f.higher
            and abs(f.median(NEW) / old["median"] - 1.0) > 0.15]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scree", default=ROOT / "build/release/app/scree", type=pathlib.Path)
    parser.add_argument("--baseline", type=pathlib.Path, help="another build of the command, to compare with")
    parser.add_argument("--rows", nargs="+", choices=ROWS, default=list(ROWS))
    parser.add_argument("--repeats", type=int, default=5)
    parser.add_argument("--full", action="store_true", help="10,000 and 100,000 blocks too")
    parser.add_argument("--history", type=pathlib.Path)
    parser.add_argument("--plots", type=pathlib.Path)
    arguments = parser.parse_args()
    history = arguments.history or arguments.scree.resolve().parents[1] / "bench/history.jsonl"
    with tempfile.TemporaryDirectory(prefix="scree-bench-") as scratch:
        scratch = pathlib.Path(scratch)
        programs = [Program(NEW, arguments.scree, scratch)]
        if arguments.baseline:
            programs.append(Program(OLD, arguments.baseline, scratch))
        table = Table(programs, arguments.repeats, arguments.full, scratch)
        (scratch / "shaking.csv").write_text(bench_cases.shaking())
        for name in arguments.rows:
            print(f"# {name} ...", file=sys.stderr, flush=True)
            ROWS[name](table)
    here = machine()
    before = last_of(history, here)
    print(f"commit {commit()}, {here['cpu']}, {here['cores']} cores, load {os.getloadavg()[0]:.1f}; {arguments.repeats} rounds\n")
    slower = printed(table, before)
    record = {"date": datetime.datetime.now().isoformat(timespec="seconds"), "commit": commit(), "machine": here, "load": os.getloadavg()[0],
              "figures": {f.row: {"unit": f.unit, "least": f.least(NEW), "median": f.median(NEW),
                                  **({"baseline": f.median(OLD), "ratio": f.ratio()} if OLD in f.values else {})}
                          for f in table.figures.values() if NEW in f.values},
              "growth": {name: series for name, (_, _, series) in table.growth.items() if series}}
    history.parent.mkdir(parents=True, exist_ok=True)
    with history.open("a") as file:
        file.write(json.dumps(record) + "\n")
    if arguments.plots:
        bench_plots.write(arguments.plots, table.growth)
    for row in slower:
        print(f"SLOWER than last time by more than 15 %: {row}")


if __name__ == "__main__":
    main()

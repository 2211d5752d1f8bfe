#!/usr/bin/env python3
"""Small mutations of the physics, and the tests that must see them.

  mutate.py list                       the records as a table
  mutate.py check [--build DIR]        every record still fits the source; with a build folder, its killer exists
  mutate.py run [--only PART ...]      builds a copy of the tree that holds all mutants, and runs their killers

A record is a [[mutant]] in a .toml file beside this program:

  id      = "contact-length-doubled"      its name
  file    = "coupling/contact/law/joint_springs.cpp"
  text    = "return «kCornerLength» *"    found once in the file, however lines are broken; what is marked is replaced
  with    = "0.2"                         by this
  breaks  = "a corner stands for twice its length"
  program = "test_unit_coupling"          the program that must fail, ...
  filter  = "JointSprings.*"              ... with this --gtest_filter
  ctest   = "e2e.cases"                   or, in place of the two, a test by the name that ctest knows

All mutants live in one copy, each asleep until SCREE_MUTANT has its number: an expression becomes
(mutant(7) ? (with) : (text)), one or more statements become if (mutant(7)) { with } else { text }. So the sources are
compiled once, not once a mutant. `run --apart` builds each by itself, from the text as a person would have typed it.

`run` first runs every killer on the copy with all mutants asleep: a test that fails there kills nothing. A mutant whose
killer passes has survived; with --tier it meets every other test of the quick tier too. The exit code is 0 if at least
95 % were killed (--least) and no record is stale.
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time
import tomllib

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
KEYS = {"id", "file", "text", "with", "breaks", "program", "filter", "ctest"}
SWITCH = "namespace scree::mutation { extern const int chosen; }\n#line 1\n"
CHOSEN = """
#include <cstdlib>
namespace scree::mutation {
extern const int chosen;
const int chosen = std::getenv("SCREE_MUTANT") != nullptr ? std::atoi(std::getenv("SCREE_MUTANT")) : -1;
}
"""
HOLDS_CHOSEN = "model/model.cpp"


class Mutant:
    def __init__(self, record, number, source):
        unknown = set(record) - KEYS
        missing = {"id", "file", "text", "with", "breaks"} - set(record)
        if unknown or missing:
            sys.exit(f"{source}: {record.get('id', '?')}: unknown {sorted(unknown)}, missing {sorted(missing)}")
        if ("ctest" in record) == ("program" in record and "filter" in record):
            sys.exit(f"{source}: {record['id']}: either program and filter, or ctest")
        self.number = number
        self.id, self.file, self.text, self.new = record["id"], record["file"], record["text"], record["with"]
        self.breaks = record["breaks"]
        self.program, self.filter, self.ctest = record.get("program"), record.get("filter"), record.get("ctest")

    @property
    def killer(self):
        return self.ctest or f"{self.program} {self.filter}"

    def find(self, root):
        """Begin and end of the marked part in the file's text. Raises ValueError where the record is stale."""
        path = root / self.file
        if not path.is_file():
            raise ValueError(f"no file {self.file}")
        if self.text.count("«") != 1 or self.text.count("»") != 1:
            raise ValueError("the text marks no part with « and »")
        before, rest = self.text.split("«")
        marked, after = rest.split("»")

        def pattern(part):
            return r"\s+".join(re.escape(word) for word in re.split(r"\s+", part))

        text = path.read_text()
        found = list(re.finditer(f"{pattern(before)}({pattern(marked)}){pattern(after)}", text))
        if len(found) != 1:
            raise ValueError(f"its text is in {self.file} {len(found)} times")
        begin = found[0].start(1)
        if re.match(r"\s*(static |inline )*constexpr [^({]*=", text[text.rfind("\n", 0, begin) + 1:begin]):
            raise ValueError("it marks a constant expression; mark where that is used")
        return found[0].span(1)


def read_mutants():
    mutants = []
    for path in sorted(HERE.glob("*.toml")):
        for record in tomllib.loads(path.read_text())["mutant"]:
            mutants.append(Mutant(record, len(mutants), path.name))
    names = [m.id for m in mutants]
    twice = {n for n in names if names.count(n) > 1}
    if twice:
        sys.exit(f"ids given twice: {sorted(twice)}")
    return mutants


def stale(mutants, root):
    out = []
    for m in mutants:
        try:
            m.find(root)
        except ValueError as e:
            out.append(f"{m.id}: {e}")
    return out


def missing_killers(mutants, build):
    """Killers that the build's ctest does not list; programs that are not built there are left out."""
    listed = subprocess.run(["ctest", "--show-only=json-v1", "--test-dir", str(build)], capture_output=True, text=True,
                            check=True).stdout
    tests = [t["name"] for t in json.loads(listed)["tests"]]
    out = []
    for m in mutants:
        if f"{m.program}_NOT_BUILT" in tests:
            continue
        if not any(m.ctest == name or any(fits(part, name) for part in (m.filter or "").split(":")) for name in tests):
            out.append(f"{m.id}: no test fits {m.killer}")
    return out


def fits(part, name):
    return re.fullmatch(re.escape(part).replace(r"\*", ".*").replace(r"\?", "."), name) is not None


# ---- the copy ---------------------------------------------------------------------------------------------------


def write_if_new(path, data):
    if path.is_file() and path.read_bytes() == data:
        return
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(data)


def statement(text):
    return text.rstrip().endswith((";", "}"))


def with_all(mutants, text, root):
    """The file's text with these mutants in it, asleep."""
    spans = {}
    for m in mutants:
        spans.setdefault(m.find(root), []).append(m)
    last = len(text)
    for (begin, end), here in sorted(spans.items(), reverse=True):
        if end > last:
            sys.exit(f"{here[0].file}: the marked parts of {here[0].id} and of another mutant overlap")
        last = begin
        old = text[begin:end]
        for m in here:
            awake = f"scree::mutation::chosen == {m.number}"
            old = (f"{{ if ({awake}) {{ {m.new} }} else {{ {old} }} }}" if statement(old)
                   else f"(({awake}) ? ({m.new}) : ({old}))")
        text = text[:begin] + old + text[end:]
    return text


def copy_tree(root, scratch, mutants, apart=None):
    """Sources of the tree, with all mutants asleep or with one awake; only what differs is written."""
    listed = subprocess.run(["git", "-C", str(root), "ls-files", "-co", "--exclude-standard", "-z"],
                            capture_output=True, check=True).stdout.decode()
    by_file = {}
    for m in mutants:
        by_file.setdefault(m.file, []).append(m)
    for name in filter(None, listed.split("\0")):
        source = root / name
        if not source.is_file():
            continue
        data = source.read_bytes()
        if apart is not None:
            if name == apart.file:
                begin, end = apart.find(root)
                text = data.decode()
                data = (text[:begin] + apart.new + text[end:]).encode()
        elif name in by_file:
            data = (SWITCH + with_all(by_file[name], data.decode(), root)).encode()
        if apart is None and name == HOLDS_CHOSEN:
            data += CHOSEN.encode()
        write_if_new(scratch / name, data)
        shutil.copymode(source, scratch / name)


def build(scratch, targets, jobs, log):
    folder = scratch / "build" / "release"
    with open(log, "a") as out:
        if not (folder / "build.ninja").is_file():
            subprocess.run(["cmake", "--preset", "release", "-DSCREE_TESTS=ON", "-DSCREE_UNITY=OFF"], cwd=scratch, stdout=out, stderr=out,
                           check=True)
        result = subprocess.run(["cmake", "--build", "--preset", "release", "--parallel", str(jobs), "--target",
                                 *sorted(targets)], cwd=scratch, stdout=out, stderr=out)
    if result.returncode != 0:
        print(f"the copy does not build, see {log}", file=sys.stderr)
    return result.returncode == 0


# ---- runs -------------------------------------------------------------------------------------------------------


def run_killer(m, folder, number, limit):
    """(killed, seconds) of a mutant's killer with the mutant of that number awake; None: all asleep."""
    env = dict(os.environ, OMP_WAIT_POLICY="passive")
    env.pop("SCREE_MUTANT", None)
    if number is not None:
        env["SCREE_MUTANT"] = str(number)
    if m.ctest:
        command = ["ctest", "--test-dir", str(folder), "--no-tests=error", "-R", f"^{re.escape(m.ctest)}$"]
    else:
        command = [str(folder / "tests" / m.program), f"--gtest_filter={m.filter}", "--gtest_brief=1"]
    begin = time.monotonic()
    try:
        result = subprocess.run(command, env=env, timeout=limit, capture_output=True, text=True)
        seconds = time.monotonic() - begin
        ran = m.ctest or not re.search(r"\[==========\] 0 tests|Running 0 tests| 0 tests from 0 ", result.stdout)
        return result.returncode != 0 or not ran, seconds
    except subprocess.TimeoutExpired:
        return True, time.monotonic() - begin


def whole_tier(folder, m, jobs):
    """The first test of the quick tier that sees the mutant; empty: none does."""
    env = dict(os.environ, OMP_WAIT_POLICY="passive", SCREE_MUTANT=str(m.number))
    result = subprocess.run(["ctest", "--test-dir", str(folder), "-LE", "^full$", "--stop-on-failure", "--parallel",
                             str(jobs), "--timeout", "300"], env=env, capture_output=True, text=True)
    failed = re.search(r"^\s*\d+ - (\S+) \(", result.stdout, re.M)
    return failed.group(1) if failed else ("" if result.returncode == 0 else "ctest")


def run(args, every, mutants):
    log = args.scratch / "mutation.log"
    args.scratch.mkdir(parents=True, exist_ok=True)
    folder = args.scratch / "build" / "release"
    targets = {m.program for m in mutants if m.program}
    if args.tier or any(m.ctest for m in mutants):
        targets = {"all"}
    begin = time.monotonic()
    if not args.apart:
        copy_tree(args.root, args.scratch, every)
        if not build(args.scratch, targets, args.jobs, log):
            return 2
        print(f"built {', '.join(sorted(targets))} with {len(every)} mutants in {time.monotonic() - begin:.0f} s",
              flush=True)
    else:
        copy_tree(args.root, args.scratch, [], None)
        if not build(args.scratch, targets, args.jobs, log):
            return 2
    # What the killers say of the tree as it is.
    sound, limits = {}, {}
    killers = {m.killer: m for m in mutants}
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        for killer, (failed, seconds) in zip(killers, pool.map(lambda m: run_killer(m, folder, None, 600.0),
                                                               killers.values())):
            sound[killer] = not failed
            limits[killer] = max(30.0, 20.0 * seconds)
    broken = sorted(k for k, ok in sound.items() if not ok)
    for killer in broken:
        print(f"fails with no mutant awake, and kills none: {killer}", flush=True)

    def meet(m):
        if args.apart:
            copy_tree(args.root, args.scratch, [], m)
            if not build(args.scratch, {m.program} if m.program else {"all"}, args.jobs, log):
                return "does not build"
        if not sound[m.killer]:
            return "killer broken"
        killed, _ = run_killer(m, folder, None if args.apart else m.number, limits[m.killer])
        if killed:
            return "killed"
        other = whole_tier(folder, m, args.jobs) if args.tier and not args.apart else ""
        return f"killed by {other}" if other else "SURVIVED"

    with concurrent.futures.ThreadPoolExecutor(1 if args.apart or args.tier else args.jobs) as pool:
        results = []
        for m, said in zip(mutants, pool.map(meet, mutants)):
            results.append(said)
            print(f"{said:<14} {m.id:<44} {m.killer}", flush=True)
    killed = sum(r.startswith("killed") for r in results)
    share = killed / len(mutants)
    print(f"{killed} of {len(mutants)} killed, {100.0 * share:.1f} % ({args.least:g} % are asked for), "
          f"{time.monotonic() - begin:.0f} s")
    for m, said in zip(mutants, results):
        if not said.startswith("killed"):
            print(f"  {said}: {m.id} ({m.file}): {m.breaks}")
    return 0 if 100.0 * share >= args.least else 1


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    commands.add_parser("list")
    check = commands.add_parser("check")
    check.add_argument("--build", type=pathlib.Path, help="a build folder: killers must be among its tests")
    runs = commands.add_parser("run")
    runs.add_argument("--only", nargs="+", help="mutants whose id, file or program holds one of these")
    runs.add_argument("--apart", action="store_true", help="build each mutant by itself")
    runs.add_argument("--tier", action="store_true", help="survivors meet the whole quick tier")
    runs.add_argument("--least", type=float, default=95.0, help="percent that must be killed (95)")
    runs.add_argument("--jobs", type=int, default=os.cpu_count())
    runs.add_argument("--scratch", type=pathlib.Path, default=ROOT / "build" / "mutation",
                      help="folder of the copy (build/mutation); kept, so that another run builds only what changed")
    parser.add_argument("--root", type=pathlib.Path, default=ROOT, help=argparse.SUPPRESS)
    args = parser.parse_args()
    mutants = read_mutants()
    if args.command == "list":
        for m in mutants:
            print(f"{m.id:<44} {m.file:<44} {m.breaks}\n{'':<44} {m.killer}")
        print(f"{len(mutants)} mutants")
        return 0
    wrong = stale(mutants, args.root)
    if args.command == "check" and args.build:
        wrong += missing_killers(mutants, args.build)
    for line in wrong:
        print(f"stale: {line}", file=sys.stderr)
    if args.command == "check":
        print(f"{len(mutants)} mutants, {len(wrong)} stale")
        return 1 if wrong or len(mutants) < 80 else 0
    if wrong:
        return 2
    wanted = [m for m in mutants
              if not args.only or any(part in f"{m.id} {m.file} {m.program}" for part in args.only)]
    return run(args, mutants, wanted) if wanted else sys.exit("no such mutant")


if __name__ == "__main__":
    sys.exit(main())

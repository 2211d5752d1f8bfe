#!/usr/bin/python3
"""Extreme but legal numbers: every number of valid small cases, one at a time, is multiplied by powers of ten and set
to its bounds.

Usage: wild_numbers.py SCREE [--full] [--case NAME] [--key TEXT] [--jobs N]

Each run must end with 0, 3 or 4 within the time and the memory below, an error of 3 with file:line:column and the key
or with the time and the stage. A run that takes longer must have reported how many steps it will take. Prints a table
of the runs that violate this. --full, or SCREE_FULL=1 in the environment: every power from 1e-9 to 1e9; otherwise one
of them for every key, in turn, and the ends of cover_size.
"""
import argparse
import concurrent.futures
import os
import pathlib
import re
import resource
import subprocess
import sys
import tempfile
import time
import tomllib

MEMORY = 2 << 30       # bytes of address space
TIME = 10.0            # s, within which a run must have ended or reported its number of steps
PATIENCE = 1.0         # s, after which a run that has reported it is stopped
CASES = pathlib.Path(__file__).parent / "wild"
BAD_CASE, NOT_CONVERGED = 3, 4
SAID = re.compile(r"draw about \S+ lines|\d+ steps  \S+ steps/s|about \S+ of them|about \S+ elements")


def numbers(tree, path=""):
    """Keys of a case with their numbers, as --set names them."""
    items = tree.items() if isinstance(tree, dict) else enumerate(tree)
    for name, value in items:
        key = f"{path}.{name}" if path else str(name)
        if isinstance(value, bool) or isinstance(value, str):
            continue
        if isinstance(value, (int, float)):
            yield key, value
        elif isinstance(value, list) and flat(value):
            yield key, value
        else:
            yield from numbers(value, key)


def flat(value):
    return all(isinstance(v, (int, float)) or isinstance(v, list) and flat(v) for v in value)


def bounds(scree):
    """Least and largest allowed value of a key, by its path in the schema."""
    found, section = {}, ""
    for line in subprocess.run([scree, "schema"], text=True, capture_output=True, check=True).stdout.splitlines():
        if head := re.match(r"\[+([^\]]*(?:\[\])?[^\]]*)\]+ ", line):
            section = head[1] + "."
        elif key := re.match(r"  (\w+)  (.*)$", line):
            low = re.search(r"(-?[\d.e+-]+) (<=?) value", key[2])
            high = re.search(r"value (<=?) (-?[\d.e+-]+)", key[2])
            least = re.search(r"(>=?) (-?[\d.e+-]+)", key[2])
            edges = [low[1] if low else least[2] if least else None, high[2].rstrip(",") if high else None]
            found[section + key[1]] = [float(e) for e in edges if e is not None]
    return found


def schema_path(key):
    parts = []
    for part in key.split("."):
        if part.isdigit():
            parts[-1] += "[]"
        elif parts and parts[-1] in ("material", "joint", "motion", "function"):
            parts.append("NAME")
        else:
            parts.append(part)
    return ".".join(parts)


def scaled(value, factor):
    if isinstance(value, list):
        return [scaled(v, factor) for v in value]
    product = value * factor
    return round(product) if isinstance(value, int) and factor >= 1 else product


def text_of(value):
    return "[" + ", ".join(map(text_of, value)) + "]" if isinstance(value, list) else repr(value)


def limit():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))


def attempt(scree, case, key, value, work):
    """Fault of the run; empty if there is none."""
    out = pathlib.Path(tempfile.mkdtemp(dir=work))
    log = out / "said"
    with open(log, "w") as said:
        process = subprocess.Popen([scree, "run", case, "--out", out / "run", "--threads", "1", "--set", f"{key}={value}"],
                                   stdout=said, stderr=subprocess.STDOUT, preexec_fn=limit,
                                   env=os.environ | {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"})
        code, begin = None, time.monotonic()
        while code is None and time.monotonic() < begin + TIME:
            try:
                code = process.wait(0.2)
            except subprocess.TimeoutExpired:
                if time.monotonic() > begin + PATIENCE and SAID.search(log.read_text(errors="replace")):
                    break
        if code is None:
            process.kill()
            process.wait()
    said = log.read_text(errors="replace")
    subprocess.run(["rm", "-rf", out], check=True)
    if code is None:
        return "" if SAID.search(said) else f"says nothing for {TIME:g} s: {said.strip()[-150:]!r}"
    if code not in (0, BAD_CASE, NOT_CONVERGED):
        return f"exit {code}: {said.strip()[-150:]!r}"
    if code == BAD_CASE and not re.search(r":\d+:\d+: |t = \S+ s|stage '", said):
        return f"no place: {said.strip()[-200:]!r}"
    return ""


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("scree")
    parser.add_argument("--full", action="store_true", default=bool(os.environ.get("SCREE_FULL")))
    parser.add_argument("--case", default="")
    parser.add_argument("--key", default="")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    options = parser.parse_args()
    edges = bounds(options.scree)
    trials, turn = [], 0
    for case in sorted(CASES.glob("*.toml")):
        if options.case not in case.stem:
            continue
        for key, value in numbers(tomllib.loads(case.read_text())):
            if options.key not in key:
                continue
            powers = [p for p in range(-9, 10) if p]
            if not options.full:
                powers = [-9, -3, 9] if key.endswith("cover_size") else [(-9, 3, -6, 9, -3, 6)[turn % 6]]
            turn += 1
            values = [scaled(value, 10.0**p) for p in powers]
            if options.full or turn % 4 == 0:
                values += [int(e) if e.is_integer() and isinstance(value, int) else e for e in edges.get(schema_path(key), [])
                           if not isinstance(value, list)]
            trials += [(case, key, text_of(v)) for v in values]
    with tempfile.TemporaryDirectory() as work, concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        found = list(pool.map(lambda t: attempt(options.scree, *t, work), trials))
    wrong = [(t, f) for t, f in zip(trials, found) if f]
    for (case, key, value), what in wrong:
        print(f"{case.stem:12} {key} = {value[:60]}: {what}")
    print(f"{len(trials)} runs, {len(wrong)} of them wrong")
    return 1 if wrong or not trials else 0


if __name__ == "__main__":
    sys.exit(main())

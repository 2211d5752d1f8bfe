#!/usr/bin/python3
"""libFuzzer on every harness of this folder, under the address and undefined-behaviour sanitizers.

Usage: fuzz.py [--runs N] [--seconds S] [--build] [HARNESS ...]
Executions of each (10^6, or until the seconds are over), from the seeds that the harness makes and the kept inputs. What fails is
kept in tests/fuzz/corpus/HARNESS, where every build tries it from then on. Needs clang-14; --build configures and builds the preset first.
"""
import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
BUILD = ROOT / "build/fuzz/tests/fuzz"
ALL = ["control", "live", "checkpoint", "records", "case"]
LONGEST = {"records": 4096, "case": 8192}  # bytes of an input; 65,536 for the other harnesses


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("harness", nargs="*", default=ALL, metavar="HARNESS")
    parser.add_argument("--runs", type=int, default=1_000_000)
    parser.add_argument("--seconds", type=int, default=0, help="at most, for each; 0: no limit")
    parser.add_argument("--build", action="store_true")
    options = parser.parse_args()
    if options.build:
        subprocess.run(["cmake", "--preset", "fuzz"], cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
        subprocess.run(["cmake", "--build", "--preset", "fuzz", "--parallel", str(os.cpu_count()), "--target",
                        *(f"fuzz_{name}" for name in ALL)], cwd=ROOT, check=True)
    failed = False
    for name in options.harness:
        program, kept = BUILD / f"fuzz_{name}", HERE / "corpus" / name
        with tempfile.TemporaryDirectory(prefix="scree-fuzz-") as folder:
            place = pathlib.Path(folder)
            subprocess.run([program], env=dict(os.environ, SCREE_SEEDS=str(place / "seeds")), check=True)
            (place / "new").mkdir()
            folders = [place / "new", place / "seeds", *([kept] if kept.exists() else [])]
            # Without the entropic schedule, whose bookkeeping takes a quarter of the time of short executions.
            command = [program, f"-runs={options.runs}", "-entropic=0", f"-max_total_time={options.seconds}", "-timeout=120", "-rss_limit_mb=4000",
                       f"-max_len={LONGEST.get(name, 65536)}", "-print_final_stats=1", f"-artifact_prefix={place}/fault-", *folders]
            done = subprocess.run(command, capture_output=True, text=True, errors="replace", cwd=place)
            runs = re.search(r"stat::number_of_executed_units: (\d+)", done.stderr)
            seen = re.findall(r"cov: (\d+) ft: (\d+)", done.stderr)
            print(f"{name}: {runs[1] if runs else '?'} executions, {seen[-1][0] if seen else '?'} places covered, "
                  f"{len(list((place / 'new').iterdir()))} inputs found, exit code {done.returncode}", flush=True)
            faults = sorted(f for f in place.glob("fault-*") if not f.name.startswith("fault-slow-unit"))
            for fault in faults:
                kept.mkdir(parents=True, exist_ok=True)
                shutil.copy(fault, kept / fault.name)
                print(f"  kept: {kept / fault.name}")
            if done.returncode != 0:
                failed = True
                told = [line for line in done.stderr.splitlines() if not re.match(r"#\d+\s+(NEW|REDUCE|pulse|INITED)", line)]
                print("\n".join("    " + line for line in told[-60:]))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())

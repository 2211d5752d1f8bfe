#!/usr/bin/env python3
"""The reference programs of the case library check themselves and must print the tables stored next to them: the same
numbers to 1e-9 of the largest number of their column (the last digits of sines differ between processors).

usage: references.py SOURCE_FOLDER
"""
import csv
import pathlib
import subprocess
import sys


def number(text):
    try:
        return float(text)
    except ValueError:
        return None


tables = sorted(pathlib.Path(sys.argv[1]).glob("cases/*/reference/*.csv"))
if not tables:
    sys.exit("references.py: no tables found")
for table in tables:
    program = table.with_name(table.stem.replace("-", "_") + ".py")
    printed = subprocess.run([sys.executable, program], capture_output=True, text=True, check=False)
    if printed.returncode != 0:
        sys.exit(f"{program} ended with {printed.returncode}: {printed.stderr}")
    now, stored = (list(csv.reader(text.splitlines())) for text in (printed.stdout, table.read_text()))
    if len(now) != len(stored) or any(len(a) != len(b) for a, b in zip(now, stored)):
        sys.exit(f"{table}: {len(stored)} lines, {program.name} prints {len(now)}, or their columns differ")
    width = max(map(len, stored))
    scale = [max((abs(number(row[c]) or 0.0) for row in stored if c < len(row)), default=0.0) for c in range(width)]
    for line, (a, b) in enumerate(zip(now, stored), 1):
        for c, (x, y) in enumerate(zip(a, b)):
            if x != y and (number(x) is None or number(y) is None or abs(number(x) - number(y)) > 1e-9 * scale[c]):
                sys.exit(f"{table}:{line}: {y} is stored, {program.name} prints {x}")
    print(f"ok: {table.parent.parent.name}/{table.name}, {len(stored)} lines")

#!/usr/bin/env python3
"""docs/cases.md: the case library beside its two sources, from cases/sources.toml and from README.md and expected.toml of every case.

usage: tools/cases_page.py [--check]            writes docs/cases.md, with what docs/cases-found.csv has; --check: compares only
       tools/cases_page.py --run [SCREE] [CASE ...]   runs these cases (default: all), full tier, brings docs/cases-found.csv, docs/cases-plots.csv and the
                                                plots in docs/images/cases up to date, then writes the page

A row of docs/cases-found.csv whose quantity or bound has changed since is not shown: run the case again. Values of timings differ from run to run.
"""
import csv
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE, FOUND, PLOTS = ROOT / "docs/cases.md", ROOT / "docs/cases-found.csv", ROOT / "docs/cases-plots.csv"
IMAGES = ROOT / "docs/images/cases"
SHOWN = 3  # plots of a case; `scree cases verify --report` draws all


def cases():
    return sorted(p.parent.name for p in ROOT.glob("cases/*/expected.toml"))


def cell(text):
    return text.replace("|", "\\|").replace("<", "\\<").replace("\n", " ")


def lead(name):
    """First paragraph of the case's README, without its pictures."""
    paragraphs = (ROOT / "cases" / name / "README.md").read_text().split("\n\n")
    return next(p.replace("\n", " ").strip() for p in paragraphs[1:] if not p.lstrip().startswith(("!", "|")))


def tiers(expected):
    """Whether each quantity belongs to the full tier, by its own tier or that of a variant that it uses."""
    full = {v["name"] for v in expected.get("variant", []) if v.get("tier") == "full"}
    first = expected.get("variant", [{}])[0].get("name", "case")
    for q in expected["quantity"]:
        taken = [*q.get("variants", [q.get("variant", first)]), q.get("over"), q.get("against"), q.get("minus")]
        yield q, "full" if q.get("tier") == "full" or any(t in full for t in taken) else "quick"


def found_rows():
    if not FOUND.exists():
        return {}
    with open(FOUND, newline="") as file:
        return {(r["case"], r["quantity"]): r for r in csv.DictReader(file)}


def plot_rows():
    """Titles of the plots in IMAGES by file name."""
    if not PLOTS.exists():
        return {}
    with open(PLOTS, newline="") as file:
        return {r["file"]: r["title"] for r in csv.DictReader(file)}


def write_rows(path, columns, rows):
    with open(path, "w", newline="") as file:
        writer = csv.DictWriter(file, columns, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def number(x):
    return f"{x:.6g}"


def wanted(q):
    """Bounds as `scree cases verify` writes them."""
    if "reference" in q:
        tolerance = q["absolute"] if "absolute" in q else q["tolerance"] * abs(q["reference"])
        return f"{number(q['reference'])} +- {tolerance:.3g}"
    low = f">= {number(q['at_least'])}" if "at_least" in q else ""
    high = f"<= {number(q['at_most'])}" if "at_most" in q else ""
    return ", ".join(x for x in (low, high) if x)


def page():
    names, found, plots = cases(), found_rows(), plot_rows()
    sources = tomllib.loads((ROOT / "cases/sources.toml").read_text())["source"]
    out = ["# The case library", "",
           "Every numbered example, table of results and figure of results of the two sources that Scree was built from, with the case that does it or the reason why there is none; then every case with all its rows.",
           "`scree cases verify NAME` runs the quick rows of a case, `--full` those that take longer too, `--exhaustive` the whole of long tables as well (sliding: two hours of processor time); `--jobs N` runs N cases at a time, `--table` and `--report` write tables and plots, `scree gallery` a page with a picture and the report of every case.",
           "The README of a case says what the source gives, what is assumed instead of what it does not give, and what differs. Written by `tools/cases_page.py` from the cases; numbers found are of `tools/cases_page.py --run`, those of time",
           "of a machine that did other things beside.", ""]
    named = set()
    for source in sources:
        out += [f"## {source['name']}, by its numbers", "", f"Source [{source['key']}](bibliography.md#{source['key'].lower()}).", "", "| what | case | remark |", "|---|---|---|"]
        for what, case, remark in source["item"]:
            if case and case not in names:
                sys.exit(f"cases/sources.toml: there is no case {case}")
            if not case and not remark:
                sys.exit(f"cases/sources.toml: neither a case nor a reason: {what}")
            named.add(case)
            out.append(f"| {cell(what)} | {f'[{case}](#{case})' if case else 'none'} | {cell(remark)} |")
        out.append("")
    others = [n for n in names if n not in named]
    out += ["## Cases of other origin", "", ", ".join(f"[{n}](#{n})" for n in others) + ".", "", "## The cases", ""]
    for name in names:
        expected = tomllib.loads((ROOT / "cases" / name / "expected.toml").read_text())
        out += [f'### <a id="{name}"></a>{name}', "", lead(name), "", f"Case, reference and account: `cases/{name}`.", ""]
        if (ROOT / "cases" / name / "picture.png").exists():  # HTML, since the picture is outside docs/; tools/docs_site.sh copies it
            out += [f'<img src="../cases/{name}/picture.png" alt="{name}" width="720">', ""]
        out += ["| quantity | wanted | found | tier | why this bound |", "|---|---|---|---|---|"]
        for q, tier in tiers(expected):
            row = found.get((name, q["name"]))
            value = row["found"] if row and row["wanted"] == wanted(q) else ""
            value = f"{value} ({row['verdict']})" if value and row["verdict"] != "pass" else value
            out.append(f"| {cell(q['name'])} | {cell(wanted(q))} | {value} | {tier} | {cell(q['reason'])} |")
        out.append("")
        for file, title in plots.items():
            if file.rpartition("-")[0] == name:
                out += [f"![{title}](images/cases/{file})", ""]
    return "\n".join(out)


def run(arguments):
    scree = next((a for a in arguments if "/" in a), str(ROOT / "build/release/app/scree"))
    chosen = [a for a in arguments if "/" not in a] or cases()
    rows, plots = found_rows(), plot_rows()
    IMAGES.mkdir(parents=True, exist_ok=True)
    for name in chosen:
        with tempfile.TemporaryDirectory() as folder:
            table = os.path.join(folder, "t.csv")
            subprocess.run([scree, "cases", "verify", name, "--full", "--table", table, "--report", folder], check=False, cwd=ROOT)
            with open(table, newline="") as file:
                new = {(r["case"], r["quantity"]): r for r in csv.DictReader(file)}
            for old in [f for f in plots if f.rpartition("-")[0] == name]:
                del plots[old]
                (IMAGES / old).unlink(missing_ok=True)
            for title, file in re.findall(r"^!\[(.*)\]\((\S+\.png)\)$", pathlib.Path(folder, "cases.md").read_text(), re.M)[:SHOWN]:
                plots[file] = title
                shutil.copy(os.path.join(folder, file), IMAGES / file)
        rows = {k: r for k, r in rows.items() if k[0] != name} | new
        # Written after each case, so that an interrupted command loses nothing.
        write_rows(FOUND, ["case", "quantity", "wanted", "found", "verdict"], (rows[k] for k in sorted(rows)))
        write_rows(PLOTS, ["file", "title"], ({"file": f, "title": plots[f]} for f in sorted(plots, key=lambda f: (f.rpartition("-")[0], int(f.rpartition("-")[2][:-4])))))


def main():
    arguments = sys.argv[1:]
    if arguments[:1] == ["--run"]:
        run(arguments[1:])
    elif arguments not in ([], ["--check"]):
        sys.exit(__doc__)
    text = page()
    if arguments == ["--check"]:
        if not PAGE.exists() or PAGE.read_text() != text:
            sys.exit("docs/cases.md is not what tools/cases_page.py writes: run it")
        print(f"ok: docs/cases.md, {len(cases())} cases")
        return
    PAGE.write_text(text)


if __name__ == "__main__":
    main()

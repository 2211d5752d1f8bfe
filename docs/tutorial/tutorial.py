"""Runs the commands of index.md, the blocks marked sh, in a copy of this folder, and compares its numbers, or writes them and the pictures.

usage: tutorial.py SCREE check|write [WORK]

Numbers stand in the text between <!--n NAME--> and <!---->. They hold to 2 %: a factor of safety is known to its bracket, and other processors have other last bits.
Between <!--t NAME--> and <!----> stands a bound, which what is found must not pass; between <!--w NAME--> and <!----> a number that depends on the last bits: it holds to 10 %.
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
MARK = re.compile(r"<!--([ntw]) (\w+)-->(.*?)<!---->")
SAME = 0.02
WIDE = 0.1  # of what a thousandth of a modulus changes by a twentieth
PICTURES = {"model.png": "model.png", "failed.png": "fos/failed.png", "shaken.png": "shaken.png", "monitors.png": "monitors.png", "anchored.png": "anchored.png",
            "anchored-shaken.png": "anchored-shaken.png"}


def found_in(folder):
    """What the runs came to, by name, as written in the text."""
    read = lambda name: json.loads((folder / name).read_text())
    before, after = read("fos.json"), read("anchored-fos.json")
    shaken, anchored = read("shaken/summary.json"), read("anchored-shaken/summary.json")
    failed = next(r for r in before["runs"] if r["factor"] == before["fails"])
    far = max(shaken["blocks"], key=lambda b: b["displacement"])
    assert before["status"] == after["status"] == "found" and before["mode"] == "slides", (before["status"], after["status"], before["mode"])
    assert shaken["status"] == anchored["status"] == "done"
    return {
        "fos_before": "%.4g" % before["fos"],
        "fos_after": "%.3g" % after["fos"],
        "moving_before": str(sum(b["mode"] != "stands" for b in failed["blocks"])),
        "rock_before": "%.2g" % before["rock_at_rest"][0]["utilisation"],
        "farthest_block": far["name"],
        "shaken_before": "%.3g" % far["displacement"],
        "shaken_after": "%.2g" % max(b["displacement"] for b in anchored["blocks"]),
        "rigid": "%.2g" % read("rigid.json")["records"][0]["newmark_horizontal"]["displacement_m"]["mean"],
        "closure": "%.0e" % max(shaken["ledger"]["relative_closure"], anchored["ledger"]["relative_closure"]),
    }


def differs(kind, written, found):
    try:
        a, b = float(written), float(found)
    except ValueError:
        return written != found
    if kind == "t":
        return b > 10.0 * max(a, 1e-13)  # rounding, of other processors too
    return abs(a - b) > (WIDE if kind == "w" else SAME) * max(abs(a), abs(b)) + 0.5 * 10.0 ** -len(written.partition(".")[2])  # and its last digit


def run(scree, work):
    folder = work / "docs" / "tutorial"
    shutil.copytree(HERE, folder, dirs_exist_ok=True)
    (work / "cases").mkdir(exist_ok=True)
    shutil.copytree(ROOT / "cases" / "staged-slope", work / "cases" / "staged-slope", dirs_exist_ok=True)
    path = {**os.environ, "PATH": os.path.dirname(os.path.abspath(scree)) + os.pathsep + os.environ["PATH"]}
    for block in re.findall(r"^```sh\n(.*?)^```", (HERE / "index.md").read_text(), flags=re.M | re.S):
        for line in block.splitlines():
            print("$ " + line, flush=True)
            subprocess.run(["bash", "-c", line], cwd=folder, env=path, check=True)
    return folder


def main():
    work = pathlib.Path(sys.argv[3] if len(sys.argv) > 3 else tempfile.mkdtemp(prefix="scree-tutorial-"))
    work.mkdir(parents=True, exist_ok=True)
    folder = run(sys.argv[1], work)
    found, text = found_in(folder), (HERE / "index.md").read_text()
    for name, made in PICTURES.items():
        assert (folder / made).stat().st_size > 10000, made
    if sys.argv[2] == "write":
        (HERE / "index.md").write_text(MARK.sub(lambda m: "<!--%s %s-->%s<!---->" % (m[1], m[2], found[m[2]]), text))
        (HERE / "images").mkdir(exist_ok=True)
        for name, made in PICTURES.items():
            shutil.copy(folder / made, HERE / "images" / name)
        print(found)
        return
    named = MARK.findall(text)
    wrong = ["%s: the text has %s, found is %s" % (name, written, found[name]) for kind, name, written in named if differs(kind, written, found[name])]
    assert {name for _, name, _ in named} == set(found), "every number that is found stands in the text"
    print("\n".join(wrong) or "%d numbers of the text hold" % len(named))
    if len(sys.argv) <= 3:
        shutil.rmtree(work)
    sys.exit(bool(wrong))


main()

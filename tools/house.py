#!/usr/bin/python3
"""How liveable the sources are: long functions, branches, headers, circles of folders, names of files that are not there, files
without a test of their name or a mutant (tests/mutation), files at the top level that do not belong there.

Usage: house.py [--list] [--strict]
A row a measure: how many, the limit, the worst. --list names all; --strict ends with 1 where a limit is passed.
Functions are found by their braces, which clang-format puts where this expects them.
"""
import argparse
import pathlib
import re
import subprocess
import sys
import tomllib

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests/arrows"))
import check_arrows  # noqa: E402

FOLDERS = ("model", "nmm", "dda", "coupling", "io", "app", "tests")
TESTED = ("model", "nmm", "dda", "coupling")
TOP = {".ci", ".clang-format", ".clang-tidy", ".gitignore", "CHANGELOG.md", "CMakeLists.txt", "CMakePresets.json", "LICENSE", "README.md", "app", "cases",
       "check", "cmake", "coupling", "dda", "demo", "docs", "io", "model", "nmm", "packages.txt", "tests", "tools"}
LINES, LONG_SHARE, BRANCHES, HEADER = 100, 60, 25, 250
NO_FUNCTION = re.compile(r"\s*(namespace|struct|class|enum|union|extern|template|const|constexpr|static const|inline const|inline constexpr)\b")
BRANCH = re.compile(r"\b(if|for|while|case|catch)\b|&&|\|\||\?(?!\?)")
CITED = re.compile(r"(?<![\w./-])((?:[a-z0-9_-]+/)*[a-z0-9_-]+\.(?:h|cpp|cc|c|md|py|sh|toml))(?![\w/])")


def sources():
    names = subprocess.run(["git", "ls-files", *FOLDERS], cwd=ROOT, capture_output=True, text=True, check=True).stdout.split()
    return [name for name in names if name.endswith((".h", ".cpp"))]


def functions(name):
    """(first line, lines, branches) of every function of a file."""
    lines = (ROOT / name).read_text().splitlines()
    i = 0
    while i < len(lines):
        first = i
        if lines[i].endswith("{") and re.match(r" {3,}", lines[i]):  # the last line of a function head that began on an earlier line
            while first > 0 and re.match(r" {3,}", lines[first]):
                first -= 1
        head = re.match(r"^( {0,2})\S", lines[first])
        text = "".join(lines[first:i + 1])
        if lines[i].endswith("{") and head and "(" in text and not re.match(NO_FUNCTION, text) and (first == i or not lines[first].endswith(("{", ";", "}"))):
            end = next((j for j in range(i + 1, len(lines)) if lines[j].startswith(head[1] + "}")), len(lines) - 1)
            body = [re.sub(r'"(\\.|[^"\\])*"|//.*', "", line) for line in lines[i + 1:end]]
            yield first + 1, end - i - 1, sum(len(BRANCH.findall(line)) for line in body)
            i = end
        i += 1


def dangling():
    """Comments that name a file that does not exist."""
    known = subprocess.run(["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=True).stdout.split()
    tails = {"/".join(pathlib.PurePath(f).parts[-n:]) for f in known for n in range(1, 6)}
    written = {"case.toml", "cases.md", "lcm_udpm.c", "read_live.py"}
    for name in sources():
        for number, line in enumerate((ROOT / name).read_text().splitlines(), 1):
            comment = re.search(r"//(.*)", line)
            if comment and "include" not in line:
                for file in CITED.findall(comment[1]):
                    if file not in tails and file not in written:
                        yield f"{name}:{number}: {file}"


def untested():
    """Numerical sources without a test of the same name, and without a mutant that a test of another name kills."""
    tests = {pathlib.PurePath(name).stem for name in sources() if name.startswith("tests/")}
    mutated = {m["file"] for records in sorted(ROOT.glob("tests/mutation/*.toml")) for m in tomllib.loads(records.read_text())["mutant"]}
    for name in sources():
        stem = pathlib.PurePath(name).stem
        if name.startswith(TESTED) and name.endswith(".cpp") and f"{stem}_test" not in tests and name not in mutated:
            yield name


def strays():
    """Files and folders of the repository at the top level that are not on the list."""
    known = subprocess.run(["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=True).stdout.split()
    return sorted({name.split("/")[0] for name in known} - TOP)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--strict", action="store_true")
    options = parser.parse_args()
    found = [(length, branches, f"{name}:{line}") for name in sources() for line, length, branches in functions(name)]
    code = [f for f in found if not f[2].startswith("tests/")]
    headers = [(len((ROOT / n).read_text().splitlines()), n) for n in sources() if n.endswith(".h")]
    short = sum(length <= LONG_SHARE for length, _, _ in found) / len(found)
    rows = [
        (f"functions over {LINES} lines", 0, [f"{where} {length}" for length, _, where in sorted(found, reverse=True) if length > LINES]),
        (f"functions over {BRANCHES} branches, but for tests", 0,
         [f"{where} {branches}" for _, branches, where in sorted(code, key=lambda f: -f[1]) if branches > BRANCHES]),
        (f"headers over {HEADER} lines", 0, [f"{name} {length}" for length, name in sorted(headers, reverse=True) if length > HEADER]),
        ("circles of folders", 0, [" ".join(c) for c in check_arrows.circles(ROOT)]),
        ("comments that name a file which is not there", 0, list(dangling())),
        ("files without a test of their name or a mutant that is killed", 0, list(untested())),
        ("files at the top level that are not on the list", 0, strays()),
    ]
    print(f"{len(sources())} files, {len(found)} functions, {100 * short:.1f} % of at most {LONG_SHARE} lines")
    failed = short < 0.99
    for name, limit, what in rows:
        failed = failed or len(what) > limit
        print(f"{len(what):5}  {name}" + (f": {what[0]}" if what else ""))
        if options.list:
            print("".join(f"         {w}\n" for w in what), end="")
    return 1 if failed and options.strict else 0


if __name__ == "__main__":
    sys.exit(main())

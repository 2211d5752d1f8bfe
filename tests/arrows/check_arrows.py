"""Checks which folder includes and links which:  app -> io -> coupling -> {nmm, dda} -> model.

usage: check_arrows.py ROOT     exit code 0: all as allowed; 1: violations, one a line; 2: nothing to check
"""
import pathlib
import re
import sys

ALLOWED = {
    "model": set(),
    "nmm": {"model"},
    "dda": {"model"},
    "coupling": {"model", "nmm", "dda"},
    "io": {"model", "coupling"},
    "app": {"model", "nmm", "dda", "coupling", "io"},
}
# Folders that no layer may include from.
OUTSIDE = {"tests", "cases", "docs", "tools"}
# The methods link the model and the compile options, nothing else: a third method needs no more.
ONLY_LINKS = {"nmm": {"scree::model", "scree_options"}, "dda": {"scree::model", "scree_options"}}

INCLUDE = re.compile(r'^\s*#\s*include\s*["<]([^">]+)[">]')
LINK = re.compile(r"target_link_libraries\s*\(([^)]*)\)")
KEYWORDS = {"PUBLIC", "PRIVATE", "INTERFACE"}


def layer_of(root, file, name):
    """The top folder that `#include "name"` in `file` takes its file from, None for a library's header."""
    beside = (file.parent / name).resolve()
    path = beside if beside.is_file() else (root / name).resolve()
    if not path.is_relative_to(root):
        return None
    top = path.relative_to(root).parts[0]
    return top if top in ALLOWED or top in OUTSIDE else None


def include_violations(root):
    """Returns the violations and the numbers of files and includes seen."""
    found, files, includes = [], 0, 0
    for layer, allowed in ALLOWED.items():
        for file in sorted((root / layer).rglob("*")):
            if file.suffix not in {".h", ".hpp", ".cpp"}:
                continue
            files += 1
            for number, line in enumerate(file.read_text(encoding="utf-8", errors="replace").splitlines(), 1):
                match = INCLUDE.match(line)
                if not match:
                    continue
                includes += 1
                target = layer_of(root, file, match[1])
                if target not in allowed | {layer, None}:
                    found.append(f"{file.relative_to(root)}:{number}: {layer} may not include {match[1]}")
    return found, files, includes


def link_violations(root):
    found = []
    for layer, allowed in ALLOWED.items():
        lists = root / layer / "CMakeLists.txt"
        if not lists.is_file():
            found.append(f"{layer}/CMakeLists.txt: missing")
            continue
        text = re.sub(r"#.*", "", lists.read_text(encoding="utf-8"))
        for call in LINK.findall(text):
            for word in call.split()[1:]:
                if word in KEYWORDS:
                    continue
                ours = re.fullmatch(r"scree(?:::|_)(\w+)", word)
                target = ours[1] if ours and ours[1] in ALLOWED else None
                if target not in allowed | {None} or word not in ONLY_LINKS.get(layer, {word}):
                    found.append(f"{layer}/CMakeLists.txt: {layer} may not link {word}")
    return found


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    root = pathlib.Path(sys.argv[1]).resolve()
    found, files, includes = include_violations(root)
    if not includes:
        print(f"no includes in {root}: not the top of the project?", file=sys.stderr)
        return 2
    found += link_violations(root)
    print(*found, sep="\n", end="\n" if found else "")
    print(f"{files} files, {includes} includes, {len(found)} violations")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())

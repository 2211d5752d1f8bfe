"""Checks which folder includes and links which:  app -> io -> coupling -> {nmm, dda} -> model; the rooms of coupling; no circle of folders; and whether sources include <Eigen/LU>
where they need it.

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
# The subfolders ("rooms") of coupling from bottom to top: each may include only from those before it.
ROOMS = ["coupling/ledger", "coupling/linear", "coupling", "coupling/bodies", "coupling/bolts", "coupling/contact/law", "coupling/contact/geometry",
         "coupling/contact/search", "coupling/contact/table", "coupling/contact/audit", "coupling/contact", "coupling/onefold",
         "coupling/unknowns", "coupling/interface", "coupling/integrate", "coupling/transfer", "coupling/stages"]
# Inside io:  case -> drawing,  watch -> live -> results,  report -> {pictures, viewer},  serve -> {report, live},  pictures -> results,  checkpoint -> results;  text is below all of them.
INSIDE = {
    "io/text": set(),
    "io/drawing": {"io/text"},
    "io/case": {"io/drawing", "io/text"},
    "io/results": {"io/text"},
    "io/pictures": {"io/results", "io/text"},
    "io/checkpoint": {"io/results", "io/text"},
    "io/live": {"io/results", "io/text"},
    "io/viewer": set(),
    "io/report": {"io/pictures", "io/results", "io/text", "io/viewer"},
    "io/serve": {"io/live", "io/report", "io/results", "io/text", "io/viewer"},
    "io/watch": {"io/live", "io/results", "io/text"},
}
# Folders that no layer may include from.
OUTSIDE = {"tests", "cases", "docs", "tools"}
# The methods link the model and the compile options only: a third method requires no more.
ONLY_LINKS = {"nmm": {"scree::model", "scree_options"}, "dda": {"scree::model", "scree_options"}}

INCLUDE = re.compile(r'^\s*#\s*include\s*["<]([^">]+)[">]')
LINK = re.compile(r"target_link_libraries\s*\(([^)]*)\)")
KEYWORDS = {"PUBLIC", "PRIVATE", "INTERFACE"}


def source_of(root, file, name):
    """The top folder, and the first two folders, of the file that `#include "name"` in `file` refers to; None for a
    library's header."""
    beside = (file.parent / name).resolve()
    path = beside if beside.is_file() else (root / name).resolve()
    if not path.is_relative_to(root):
        return None, None
    parts = path.relative_to(root).parts
    return (parts[0], "/".join(parts[:2])) if parts[0] in ALLOWED or parts[0] in OUTSIDE else (None, None)


def include_violations(root):
    """Returns the violations and the numbers of files and includes seen."""
    found, files, includes = [], 0, 0
    for layer, allowed in ALLOWED.items():
        for file in sorted((root / layer).rglob("*")):
            if file.suffix not in {".h", ".hpp", ".cpp"}:
                continue
            files += 1
            folder = "/".join(file.relative_to(root).parts[:2])
            for number, line in enumerate(file.read_text(encoding="utf-8", errors="replace").splitlines(), 1):
                match = INCLUDE.match(line)
                if not match:
                    continue
                includes += 1
                target, inside = source_of(root, file, match[1])
                if target not in allowed | {layer, None}:
                    found.append(f"{file.relative_to(root)}:{number}: {layer} may not include {match[1]}")
                elif folder in INSIDE and inside in INSIDE and inside not in INSIDE[folder] | {folder}:
                    found.append(f"{file.relative_to(root)}:{number}: {folder} may not include {match[1]}")
    return found, files, includes


def folder_includes(root):
    """(file, line, folder, folder of what it includes) of every include from another folder of the layers."""
    for layer in ALLOWED:
        for file in sorted((root / layer).rglob("*")):
            if file.suffix not in {".h", ".hpp", ".cpp"}:
                continue
            here = file.parent.relative_to(root).as_posix()
            for number, line in enumerate(file.read_text(encoding="utf-8", errors="replace").splitlines(), 1):
                match = INCLUDE.match(line)
                there = match and pathlib.PurePosixPath(match[1]).parent.as_posix()
                if match and there != here and there.split("/")[0] in ALLOWED:
                    yield file.relative_to(root), number, here, there


def room_violations(root):
    """Includes from a higher room, and rooms that ROOMS does not list."""
    found = []
    for file, number, here, there in folder_includes(root):
        if here.split("/")[0] != "coupling" or there.split("/")[0] != "coupling":
            continue
        for folder in (here, there):
            if folder not in ROOMS:
                found.append(f"{file}:{number}: {folder} has no place in ROOMS of check_arrows.py")
        if here in ROOMS and there in ROOMS and ROOMS.index(there) > ROOMS.index(here):
            found.append(f"{file}:{number}: {here} may not include from {there}")
    return found


def missing_definitions(root):
    """Sources that call functions of Eigen which <Eigen/LU> defines and <Eigen/Core> only declares: they link only where
    another source of the same unit includes it (cmake/unity.cmake)."""
    found = []
    for layer in [*ALLOWED, "tests"]:
        for file in sorted((root / layer).rglob("*.cpp")):
            text = file.read_text(encoding="utf-8", errors="replace")
            if re.search(r"\.(inverse|determinant)\(\)", text) and not re.search(r"<Eigen/(LU|Dense)>", text):
                found.append(f"{file.relative_to(root)}: calls inverse() or determinant() and does not include <Eigen/LU>")
    return found


def circles(root):
    """Folders that include each other, directly or indirectly: tuples of their names."""
    to = {}
    for _, _, here, there in folder_includes(root):
        to.setdefault(here, set()).add(there)

    def reached(start):
        seen, ahead = set(), [start]
        while ahead:
            for folder in to.get(ahead.pop(), set()) - seen:
                seen.add(folder)
                ahead.append(folder)
        return seen

    reach = {folder: reached(folder) for folder in to}
    return sorted({tuple(sorted({a} | {b for b in reach[a] if a in reach.get(b, ())})) for a in reach if a in reach[a]})


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
    found += link_violations(root) + room_violations(root) + missing_definitions(root)
    if not found:  # a forbidden include is reported by itself
        found += ["folders that include each other: " + ", ".join(circle) for circle in circles(root)]
    print(*found, sep="\n", end="\n" if found else "")
    print(f"{files} files, {includes} includes, {len(found)} violations")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())

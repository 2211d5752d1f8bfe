"""Checks what comments and docs refer to: keys of the bibliography, sections, files and links.

usage: check_docs.py ROOT     exit code 0: all is there; 1: faults, one a line; 2: nothing to check

- `@source` of a comment names a key of docs/bibliography.md, as [Qu2013], or a page of docs/theory with a section,
  as docs/theory/dda.md, "Exact rotation". It names no document outside the repository.
- A comment names no page ending in .md that the repository does not have.
- A link of a page of docs, or of README.md and CHANGELOG.md, leads to a file and an anchor that are there. `path/of/file.h` in docs/theory
  and docs/bibliography.md is a file of the repository.
"""
import pathlib
import re
import sys

FOLDERS = ("model", "nmm", "dda", "coupling", "io", "app", "tests")
BIBLIOGRAPHY = "docs/bibliography.md"
KEY = re.compile(r"\[([A-Z][A-Za-z]*\d[\dA-Za-z-]*|[A-Z]{3,})\](?!\()")
SECTION = re.compile(r'(docs/[\w./-]+\.md)(?:, "([^"]+)")?')
OUTSIDE = re.compile(r"\b(the thesis|thesis|keynote|spec/[\w.-]+)\b", re.I)
PAGE = re.compile(r"(?<![\w./-])((?:[\w-]+/)*[\w-]+\.md)\b")
# Made by a program at run time, not part of the repository.
WRITTEN = {"cases.md"}
LINK = re.compile(r"(?<!\\)\[(?:[^\[\]]|\[[^\[\]]*\])*\]\(([^()\s]+)(?:\s+\"[^\"]*\")?\)")
CODE_PATH = re.compile(r"`((?:[\w.-]+/)+[\w.-]+\.(?:h|cpp|cc|py|sh|toml|cmake|md))`")


def without_code(text):
    """The same lines, with blocks and spans of code blanked."""
    text = re.sub(r"^(```|~~~).*?^\1", lambda m: "\n" * m[0].count("\n"), text, flags=re.M | re.S)
    return re.sub(r"`[^`\n]*`", "", text)


def slug(heading):
    """The anchor of a heading, as GitHub and MkDocs generate it for plain words."""
    text = re.sub(r"[`*]|\[([^\]]*)\]\([^)]*\)", lambda m: m[1] or "", heading).strip().lower()
    return re.sub(r"[\s]+", "-", re.sub(r"[^\w\s-]", "", text))


class Pages:
    """Pages of Markdown, with their headings and anchors, read once."""

    def __init__(self, root):
        self.root = root
        self.known = {}

    def of(self, path):
        if path not in self.known:
            text = path.read_text(encoding="utf-8")
            plain = re.sub(r"^(```|~~~).*?^\1", "", text, flags=re.M | re.S)
            headings = [m[1].strip() for m in re.finditer(r"^#{1,6} +(.+?)#*$", plain, re.M)]
            anchors = {slug(h) for h in headings} | set(re.findall(r'<a (?:id|name)="([^"]+)"', text))
            self.known[path] = headings, anchors
        return self.known[path]


def keys_of(root):
    return set(re.findall(r"\*\*\[([^\]]+)\]\*\*", (root / BIBLIOGRAPHY).read_text(encoding="utf-8")))


def comments(text):
    """(line, text) of every comment of a C++ file; lines of // that follow one another are one."""
    first, lines = 0, []
    for number, line in enumerate([*text.splitlines(), ""], 1):
        match = re.search(r"(?:^|\s)//+(?!/)(.*)", line)
        alone = match and not line[:match.start()].strip()
        if lines and not alone:
            yield first, lines
            lines = []
        if match:
            if not lines:
                first = number
            lines.append(match[1])
            if not alone:
                yield first, lines
                lines = []


def sources_in(first, lines):
    """(line, text) of every @source of a comment: up to the next @, or to a line that is not indented."""
    for at, line in enumerate(lines):
        if "@source" not in line:
            continue
        text = line.split("@source", 1)[1].split("@", 1)[0]
        for more in lines[at + 1:]:
            if not more.startswith("  ") or "@" in more:
                break
            text += " " + more.strip()
        yield first + at, text


def code_faults(root, pages, keys):
    files = 0
    tails = {"/".join(path.relative_to(root).parts[-n:]) for path in root.rglob("*.md")
             if not path.relative_to(root).parts[0].startswith("build") for n in range(1, 6)}
    faults = []
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix not in {".h", ".cpp"}:
                continue
            files += 1
            name = path.relative_to(root)
            text = path.read_text(encoding="utf-8", errors="replace")
            for first, lines in comments(text):
                for number, source in sources_in(first, lines):
                    faults += [f"{name}:{number}: {fault}" for fault in source_faults(root, pages, keys, source)]
                for at, line in enumerate(lines):
                    faults += [f"{name}:{first + at}: no page {page}" for page in PAGE.findall(line)
                               if page not in tails and page not in WRITTEN]
    return faults, files


def source_faults(root, pages, keys, text):
    named = KEY.findall(text)
    sections = SECTION.findall(text)
    if not named and not sections:
        yield f"@source names no key of {BIBLIOGRAPHY} and no section of docs/theory: {text.strip()}"
    for key in named:
        if key not in keys:
            yield f"{BIBLIOGRAPHY} has no [{key}]"
    for page, section in sections:
        if not (root / page).is_file():
            yield f"no file {page}"
        elif section and section not in pages.of(root / page)[0]:
            yield f'{page} has no section "{section}"'
        elif not section:
            yield f"no section of {page} is named"
    if outside := OUTSIDE.search(text):
        yield f"'{outside[1]}' in a @source: name the key"


def link_faults(root, pages, keys):
    texts = [root / "README.md", root / "CHANGELOG.md", *sorted((root / "docs").rglob("*.md"))]
    faults, links = [], 0
    for path in (p for p in texts if p.is_file()):
        name = path.relative_to(root)
        theory = name.parts[:2] == ("docs", "theory") or str(name) == BIBLIOGRAPHY
        whole = path.read_text(encoding="utf-8")
        for number, (raw, line) in enumerate(zip(whole.splitlines(), without_code(whole).splitlines()), 1):
            definitions = re.findall(r"^\[[^\]]+\]: +(\S+)", line)
            for target in [*LINK.findall(line), *definitions]:
                if re.match(r"[a-z]+:", target):
                    continue
                links += 1
                file, _, anchor = target.partition("#")
                to = (path.parent / file).resolve() if file else path
                if not to.exists():
                    faults.append(f"{name}:{number}: no file {target}")
                elif anchor and (to.suffix != ".md" or anchor not in pages.of(to)[1]):
                    faults.append(f"{name}:{number}: no anchor {target}")
            if not theory:
                continue
            for code in CODE_PATH.findall(raw):
                if not (root / code).is_file():
                    faults.append(f"{name}:{number}: no file {code}")
            if definitions:
                continue
            for key in KEY.findall(line):
                if key not in keys:
                    faults.append(f"{name}:{number}: {BIBLIOGRAPHY} has no [{key}]")
    return faults, links


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    root = pathlib.Path(sys.argv[1]).resolve()
    if not (root / BIBLIOGRAPHY).is_file():
        print(f"no {BIBLIOGRAPHY} in {root}: not the top of the project?", file=sys.stderr)
        return 2
    pages, keys = Pages(root), keys_of(root)
    in_code, files = code_faults(root, pages, keys)
    in_links, links = link_faults(root, pages, keys)
    if not files or not links:
        print(f"no sources or no links in {root}", file=sys.stderr)
        return 2
    faults = in_code + in_links
    print(*faults, sep="\n", end="\n" if faults else "")
    print(f"{files} files, {links} links, {len(keys)} keys, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""check_pages.py

Checks the documents: each page has at most MOST_WORDS words (a log of measurements: beside its tables). Every relative
link leads to a file or folder of the repository, and its anchor to a heading or an <a id> of that page. A path in
`code`, from one of the repository's folders, is there. No page has a heading twice. No comment of a source begins with
"Of", "What" or "The same", for then it seldom is a sentence.
"""
import pathlib
import re
import sys

MOST_WORDS = 1500
# Pages with one purpose each. The changelog may be longer, and names files of former days.
SHORT_PAGES = ["README.md", "CONTRIBUTING.md", "SECURITY.md", "docs/*.md", "core/README.md", "platform/README.md",
               "platform/*/README.md"]
LOGS = ["docs/log/*.md"]
OTHER_PAGES = ["CHANGELOG.md"]

CODE = re.compile(r"^```.*?^```$", re.DOTALL | re.MULTILINE)
INLINE_CODE = re.compile(r"`[^`\n]*`")
PATH = re.compile(r"`((?:baker|core|docs|platform|tests|toolchains|tools)/[^`\s]*)[^`\n]*`")
LINK = re.compile(r"\]\(([^()\s]+)\)")
HEADING = re.compile(r"^#+ +(.*?)\s*$", re.MULTILINE)
ANCHOR = re.compile(r'<a id="([^"]+)">')
SOURCES = ["baker", "core", "platform", "tests", "tools"]
HALF_SENTENCE = re.compile(r"^(?![ \t]*(?://|#) )[^\n]*\n[ \t]*(?://|#) ((?:Of|What|The same)\b[^\n]*)", re.MULTILINE)
COMMENT = re.compile(r"<!--.*?-->", re.DOTALL)


def prose(text):
    """A page without its tables, code and comments."""
    text = COMMENT.sub("", CODE.sub("", text))
    return "\n".join(line for line in text.split("\n") if not line.startswith("|"))


def anchors(text):
    """Names a page's headings and <a id> as links do, by GitHub's rule."""
    text = CODE.sub("", text)
    names = set(ANCHOR.findall(text))
    for heading in HEADING.findall(text):
        plain = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading)
        slug = re.sub(r"[^\w\- ]", "", plain.lower()).replace(" ", "-")
        count = 0
        while (name := slug if count == 0 else f"{slug}-{count}") in names:
            count += 1
        names.add(name)
    return names


def broken_links(root, page):
    text = INLINE_CODE.sub("", CODE.sub("", page.read_text(encoding="utf-8")))
    for link in LINK.findall(text):
        if re.match(r"[a-z]+:", link):
            continue
        path, _, anchor = link.partition("#")
        target = (page.parent / path).resolve() if path else page
        if not target.is_relative_to(root) or not target.exists():
            yield f"{link} leads nowhere"
        elif anchor and (target.suffix != ".md" or anchor not in anchors(target.read_text(encoding="utf-8"))):
            yield f"{link}: {target.relative_to(root)} has no such heading"


def lost_paths(root, text):
    for path in PATH.findall(CODE.sub("", text)):
        if not re.search(r"[*…<>{}$]", path) and not (root / path).exists():
            yield f"{path} is not there"


def double_headings(text):
    headings = HEADING.findall(CODE.sub("", text))
    for heading in sorted({h for h in headings if headings.count(h) > 1}):
        yield f"the heading '{heading}' occurs twice"


def half_sentences(root):
    for source in (path for folder in SOURCES for path in sorted((root / folder).rglob("*"))):
        if source.suffix in (".h", ".cpp", ".inc", ".c", ".py", ".sh"):
            for comment in HALF_SENTENCE.findall(source.read_text(encoding="utf-8")):
                yield f"{source.relative_to(root)}: say in a whole sentence: {comment}"


def pages(root, patterns):
    return sorted(page for pattern in patterns for page in root.glob(pattern))


def faults(root):
    """A line for each fault of the pages below `root`."""
    short, logs = pages(root, SHORT_PAGES), pages(root, LOGS)
    found = []
    for page in short + logs + pages(root, OTHER_PAGES):
        name = page.relative_to(root)
        text = page.read_text(encoding="utf-8")
        words = len((prose(text) if page in logs else text).split())
        if page in short + logs and words > MOST_WORDS:
            found.append(f"{name} has {words} words; a page has one purpose and at most {MOST_WORDS}: divide it")
        found += [f"{name}: {fault}" for fault in broken_links(root, page)]
        if page in short + logs:
            found += [f"{name}: {fault}" for fault in [*lost_paths(root, text), *double_headings(text)]]
    return found + list(half_sentences(root))


if __name__ == "__main__":
    sys.exit("\n".join(faults(pathlib.Path(__file__).resolve().parents[2])) or None)

#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# tools/lab/copy_tables.py [--check]
# Copies rows of measured tables (docs/log) into README.md, SECURITY.md, core/README.md and docs/*.md, so that no page
# holds a figure copied by hand.
# A page says what it wants in a comment: the first table below HEADING that has the columns (none named: all of them), and of it
# the rows that match a regular expression.
#     <!-- copied: docs/log/tradeoff.md; HEADING; ROWS; COLUMN | COLUMN -->
#     <!-- copied: end -->
# A number within a line is the first group that a regular expression finds in a file:
#     <!-- value: FILE; EXPRESSION -->1,024<!-- end -->
# A whole file, as a block of code:
#     <!-- printed: FILE -->
#     <!-- printed: end -->
# With --check it writes nothing and fails if a page differs from the tables.
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
BLOCK = re.compile(r'(<!-- copied: (?!end)(.*?) -->\n).*?(<!-- copied: end -->)', re.DOTALL)
PRINTED = re.compile(r'(<!-- printed: (?!end)(.*?) -->\n).*?(<!-- printed: end -->)', re.DOTALL)

VALUE = re.compile(r'(<!-- value: ([^;]*); (.*?) -->)[^<]*(<!-- end -->)')


def cells(line):
    return [cell.strip() for cell in line.strip().strip('|').split('|')]


def tables_below(file, heading):
    """The tables under a heading, each a list of lines."""
    lines = (ROOT / file).read_text(encoding='utf-8').split('\n')
    at = [re.sub('^#+ ', '', line) if line.startswith('#') else None for line in lines].index(heading)
    tables = [[]]
    for line in lines[at + 1:]:
        if line.startswith('#'):
            break
        if line.startswith('|'):
            tables[-1].append(line)
        elif tables[-1]:
            tables.append([])
    return [table for table in tables if table]


def copied(order):
    file, heading, rows, names = (part.strip() for part in order.split(';'))
    columns = names.split(' | ') if names else []
    table = next(t for t in tables_below(file, heading) if set(columns) <= set(cells(t[0])))
    kept = [cells(table[0]).index(name) for name in columns] or range(len(cells(table[0])))

    def row(line, gap=' '):
        return '|' + '|'.join(gap + cells(line)[k] + gap for k in kept) + '|\n'
    return row(table[0]) + row(table[1], gap='') + ''.join(row(line) for line in table[2:] if re.search(rows, line))


def value(file, expression):
    """A whole number as a page writes it."""
    return f'{int(re.search(expression, (ROOT / file).read_text(encoding="utf-8"))[1]):,}'


def printed(file):
    path = ROOT / file
    language = {'.h': 'c', '.cpp': 'cpp'}.get(path.suffix, path.suffix[1:])
    return f'```{language}\n{path.read_text(encoding="utf-8")}```\n'


def main(check):
    stale = []
    pages = [ROOT / 'README.md', ROOT / 'SECURITY.md', ROOT / 'core' / 'README.md', *sorted((ROOT / 'docs').glob('*.md'))]
    for page in pages:
        text = page.read_text(encoding='utf-8')
        new = BLOCK.sub(lambda found: found[1] + copied(found[2]) + found[3], text)
        new = VALUE.sub(lambda found: found[1] + value(found[2], found[3]) + found[4], new)
        new = PRINTED.sub(lambda found: found[1] + printed(found[2]) + found[3], new)
        if new != text:
            stale.append(str(page.relative_to(ROOT)))
            if not check:
                page.write_text(new, encoding='utf-8')
    if check and stale:
        sys.exit('out of date: ' + ', '.join(stale) + '; run tools/lab/copy_tables.py and commit them')


if sys.argv[1:] not in ([], ['--check']):
    sys.exit('say nothing, or --check')
main(check=bool(sys.argv[1:]))

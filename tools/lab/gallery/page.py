#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""page.py row NAME TITLE DB | put | --check

The index of docs/gallery, made of docs/log/data/gallery.json. row: a row of it, from the JSON of `lumi inspect` on
standard input. put: takes such rows, keeps those of other objects, and writes index.html and README.md. --check: fails if
these are not what the data makes, or where the folder's pages are missing or larger than they may be; serves the folder
and follows every link of every page.
"""
import functools
import html
import http.server
import json
import pathlib
import re
import sys
import threading
import urllib.parse
import urllib.request

ROOT = pathlib.Path(__file__).resolve().parents[3]
DATA, OUT = ROOT / "docs/log/data/gallery.json", ROOT / "docs/gallery"
PARTS = {"rp2040": "RP2040", "rp2350": "RP2350", "esp32s3": "ESP32-S3", "stm32f4": "STM32F407", "stm32h7": "STM32H743"}
ORDER = ["watch", "car", "clock", "potion", "skull"]
PICTURE_BYTES, PAGE_BYTES, ALL_PAGES_BYTES = 250_000, 450_000, 2_500_000

STYLE = """:root{color-scheme:light dark;--ground:#f4f2ee;--card:#fff;--ink:#1d2127;--faint:#5b626c;--line:#dcd8d0;--link:#0a5c8a}
@media (prefers-color-scheme:dark){:root{--ground:#14171b;--card:#1c2026;--ink:#e8e6e1;--faint:#a0a7b1;--line:#333a43;--link:#7cc4ee}}
*{box-sizing:border-box}
body{margin:0;background:var(--ground);color:var(--ink);font:16px/1.5 system-ui,sans-serif}
header,main,footer{max-width:1280px;margin:0 auto;padding:0 20px}
header{padding-top:36px}
h1{font-size:clamp(26px,4vw,38px);line-height:1.15;margin:0 0 10px}
header p,footer p{max-width:44em;margin:0 0 12px;color:var(--faint)}
main{display:grid;gap:20px;padding-top:16px;padding-bottom:28px}
@media (min-width:640px){main{grid-template-columns:repeat(2,1fr)}}
@media (min-width:1100px){main{grid-template-columns:repeat(COLUMNS,1fr)}}
article{background:var(--card);border:1px solid var(--line);border-radius:14px;overflow:hidden;display:flex;flex-direction:column}
article>a{display:block;background:#202428;text-align:center}
article>a:focus-visible{outline:3px solid var(--link);outline-offset:-3px}
img{display:block;width:min(100%,320px);height:auto;aspect-ratio:1;margin:0 auto}
.text{display:flex;flex-direction:column;flex:1;padding:14px 16px 16px}
h2{font-size:18px;margin:0 0 2px}
.text p{margin:0 0 8px;color:var(--faint);font-size:15px}
table{border-collapse:collapse;width:100%;margin:auto 0 12px;font-size:14px;font-variant-numeric:tabular-nums}
th{font-weight:400;color:var(--faint);text-align:left;padding:3px 0}
td{text-align:right;padding:3px 0}
tr+tr>*{border-top:1px solid var(--line)}
code{display:block;padding:8px;background:var(--ground);border-radius:8px;font:12px/1.4 ui-monospace,monospace;overflow-x:auto;white-space:pre}
a{color:var(--link)}
.turn{align-self:start;font-weight:600;margin-bottom:8px}
"""

WORDS = ("Every picture here is drawn by the integer code that a microcontroller runs, from a field of a few hundred "
         "thousand bytes in its flash. Touch one to turn it.")
FIGURES = ("dB: PSNR against path-traced pictures from four sides that no bake aimed at. Frames a second: one core, 240×240 "
           "pixels, outlines antialiased, modelled from counted instructions.")


def row(name, title, db, inspected):
    return {"name": name, "title": title, "bytes": inspected["bytes"], "triangles": inspected["triangles"],
            "psnr_db": float(db), "ram_bytes": sum(inspected["ram_bytes"]["antialiased"].values()),
            "fps": {part: inspected["frames_per_second"]["antialiased"][part] for part in PARTS}}


def kilobytes(count):
    return f"{round(count / 1000)} kB"


def embed(item):
    return f"lumi embed {item['name']}.lumi -o {item['name']}.S"


def card(item):
    rates = "".join(f"<tr><th scope=row>{PARTS[part]}<td>{round(item['fps'][part])} frames/s" for part in PARTS)
    name, title = item["name"], html.escape(item["title"])
    return f"""<article>
<a href="{name}.html"><img src="{name}.webp" width="240" height="240" alt="{title} turns"></a>
<div class=text>
<h2>{title}</h2>
<p>{kilobytes(item["bytes"])} flash, {kilobytes(item["ram_bytes"])} RAM, {item["psnr_db"]:.1f} dB</p>
<a class=turn href="{name}.html" aria-label="Turn it: {title}">Turn it</a>
<table>{rates}</table>
<code>{embed(item)}</code>
</div>
</article>
"""


def style_for(items):
    """On a desk no card stands alone in a row of its own."""
    return STYLE.replace("COLUMNS", "4" if len(items) % 4 == 0 else "3")


def index(items):
    return f"""<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>LumiPath gallery</title>
<link rel="icon" href="data:,">
<style>
{style_for(items)}</style>
<header>
<h1>Path-traced objects, drawn by microcontrollers</h1>
<p>{WORDS}</p>
</header>
<main>
{"".join(map(card, items))}</main>
<footer><p>{FIGURES}</p></footer>
</html>
"""


def readme(items):
    lines = ["# Gallery", "", WORDS.replace(" Touch one to turn it.", "") + " The pages in this folder turn them by hand: open",
             "[index.html](index.html) of a copy of the repository in a browser. `tools/lab/gallery.sh` makes all of it.", "",
             "| | object | flash | RAM | likeness | RP2040 | STM32H743 |", "|---|---|---:|---:|---:|---:|---:|"]
    for item in items:
        lines.append(f"| ![{item['title']} turns]({item['name']}.webp) | [{item['title']}]({item['name']}.html) | "
                     f"{kilobytes(item['bytes'])} | {kilobytes(item['ram_bytes'])} | {item['psnr_db']:.1f} dB | "
                     f"{round(item['fps']['rp2040'])} | {round(item['fps']['stm32h7'])} |")
    return "\n".join(lines + ["", FIGURES.replace("Frames a second:", "The last columns are frames a second:"), ""])


def load():
    return json.loads(DATA.read_text())["objects"] if DATA.exists() else []


def pages(items):
    return {OUT / "index.html": index(items), OUT / "README.md": readme(items)}


def put(rows):
    known = {item["name"]: item for item in load()} | {item["name"]: item for item in rows}
    items = [known[name] for name in ORDER if name in known]
    text = ",\n".join("  " + json.dumps(item, ensure_ascii=False) for item in items)
    DATA.write_text('{"objects": [\n' + text + "\n]}\n")
    for path, content in pages(items).items():
        path.write_text(content)


def size_faults():
    for path in OUT.glob("*.webp"):
        if path.stat().st_size > PICTURE_BYTES:
            yield f"{path.name} has {path.stat().st_size} bytes, at most {PICTURE_BYTES} are meant"
    sizes = {path.name: path.stat().st_size for path in OUT.glob("*.html")}
    yield from (f"{name} has {size} bytes, at most {PAGE_BYTES} are meant" for name, size in sizes.items() if size > PAGE_BYTES)
    if sum(sizes.values()) > ALL_PAGES_BYTES:
        yield f"the pages have {sum(sizes.values())} bytes, at most {ALL_PAGES_BYTES} are meant"


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


def fetched(address):
    try:
        with urllib.request.urlopen(address) as answer:
            return answer.read()
    except OSError:
        return None


def link_faults():
    """Serves the folder, begins at its root, and follows links until no new one is found."""
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Quiet, directory=OUT))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    start = f"http://127.0.0.1:{server.server_port}/"
    waiting, seen = [(start, "the folder")], set()
    while waiting:
        address, of = waiting.pop()
        if address in seen:
            continue
        seen.add(address)
        data = fetched(address)
        if not data:
            yield f"{of}: {address.removeprefix(start)} is missing or empty"
        elif address.endswith(("/", ".html")):
            markup = re.sub(rb"<script.*?</script>", b"", data, flags=re.DOTALL).decode()
            for link in re.findall(r"""\s(?:href|src)=["']?([^"'\s>]+)""", markup):
                if not re.match(r"(data|https?|mailto):|#", link):
                    waiting.append((urllib.parse.urljoin(address, link), address.removeprefix(start) or "index.html"))
    server.shutdown()
    for path in OUT.iterdir():
        if path.suffix != ".md" and start + path.name not in seen | {start + "index.html"}:
            yield f"no link leads to {path.name}"


def faults():
    items = load()
    if not items:
        yield "docs/log/data/gallery.json holds no object"
    for path, content in pages(items).items():
        if not path.exists() or path.read_text() != content:
            yield f"{path.relative_to(ROOT)} is not what the data makes; run page.py put </dev/null"
    yield from size_faults()
    yield from link_faults()


def main(words):
    if words[:1] == ["row"] and len(words) == 4:
        print(json.dumps(row(*words[1:], json.load(sys.stdin)), ensure_ascii=False))
    elif words == ["put"]:
        put([json.loads(line) for line in sys.stdin if line.strip()])
    elif words == ["--check"]:
        found = list(faults())
        print("\n".join(found) or f"{OUT.relative_to(ROOT)}: {len(load())} objects, every link leads somewhere")
        return 1 if found else 0
    else:
        sys.exit(__doc__)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

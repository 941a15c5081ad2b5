#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""pages.py LUMI SHARE

Writes man pages and bash completion into a `share` folder, made of what `LUMI ... --help` says: they cannot say anything
else.
"""
import pathlib
import re
import subprocess
import sys

COMPLETION = """# bash completion of lumi, written by tools/packaging/pages.py
_lumi() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} words='' flags='' only=''
  [[ $word != = ]] || word=''
  [[ $before != = ]] || before=${COMP_WORDS[COMP_CWORD-2]}
  ((COMP_CWORD > 1)) || words="%(program)s"
  case ${COMP_WORDS[1]},$before in
%(values)s  esac
  case ${COMP_WORDS[1]} in
%(flags)s  esac
  if ((COMP_CWORD == 1)) || [[ -n $words ]]; then
    only=yes
  elif [[ -z $only && $word == -* ]]; then
    words=$flags only=yes
  fi
  COMPREPLY=()
  if [[ -n $only ]]; then
    compopt +o default 2>/dev/null
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
  fi
}
complete -o default -F _lumi lumi
"""


class Command:
    """Returns the help of `lumi WORDS`."""

    def __init__(self, lumi, words=()):
        self.words, self.name = words, "-".join(["lumi", *words])
        text = subprocess.run([lumi, *words, "--help"], check=True, capture_output=True, text=True).stdout
        head, *parts = re.split(r"^(?!Example)([A-Z][a-z ]+):\n(?=  )", text, flags=re.MULTILINE)
        self.description, self.usage = head.split("\nUsage: ")
        bodies = dict(zip(parts[::2], parts[1::2]))
        last = parts[-2]
        bodies[last], _, self.notes = bodies[last].partition("\n\n")
        self.arguments, found = (self.items(bodies.pop(title, "")) for title in ("Positionals", "Subcommands"))
        self.options = [item for body in bodies.values() for item in self.items(body)]
        self.commands = [Command(lumi, (*words, name)) for name, _ in found]

    @staticmethod
    def items(body):
        """(what stands at the left, its description): the description begins after two spaces, or on the next lines."""
        found = []
        for line in body.splitlines():
            if re.match(r"  \S", line):
                name, _, text = line.strip().replace("  (required)", " (required)").partition("  ")
                found.append([name, text.strip()])
            elif line.strip():
                found[-1][1] = f"{found[-1][1]} {line.strip()}".strip()
        return found

    def everything(self):
        return [self, *(command for below in self.commands for command in below.everything())]

    def flags(self):
        names = [flag for command in self.everything() for option, _ in command.options
                 for flag in option.split(" ")[0].split(",")]
        return " ".join(dict.fromkeys(names))


def troff(text):
    """Hyphens that can be copied, and no line that looks like a macro."""
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return re.sub(r"^(?=[.'])", r"\\&", text, flags=re.MULTILINE)


def man_page(command, version):
    def section(title, text):
        return f".SH {title}\n{text}" if text else ""

    def listed(items):
        return "".join(".TP\n\\fB{}\\fR{}\n{}\n".format(*map(troff, [*re.match(r"(\S+)(.*)", name).groups(), text]))
                       for name, text in items)
    below = [(f"{other.name}(1)", other.description) for other in command.everything()[1:]]
    return (f'.TH {command.name.upper()} 1 "" "lumi {version}" LumiPath\n'
            + section("NAME", f"{troff(command.name)} \\- {troff(command.description.strip())}\n")
            + section("SYNOPSIS", f".B {troff(command.usage.strip())}\n")
            + section("ARGUMENTS", listed(command.arguments)) + section("OPTIONS", listed(command.options))
            + section("COMMANDS", listed(below)) + section("NOTES", f".nf\n{troff(command.notes.strip())}\n.fi\n")
            + ("" if not command.words else section("SEE ALSO", ".BR lumi (1)\n")))


def value_cases(command):
    """Completes what follows an option: one of its words, nothing for a number; files where no case says otherwise."""
    name, text = command.words[0], ""
    for other in command.everything():
        if other.commands:
            below = " ".join(one.words[-1] for one in other.commands)
            text += f'    {name},{name}) words="{below} {other.flags()}" ;;\n'
        for option, _ in other.options:
            flags, _, rest = option.partition(" ")
            listed = re.search(r"\{(.*?)\}", rest) or re.fullmatch(r"([a-z0-9]+(?:\|[a-z0-9]+)+)(?:=.*)?", rest.strip())
            if listed or re.search(r"INT|FLOAT", rest):
                patterns = "|".join(f"{name},{flag}" for flag in flags.split(","))
                words = " ".join(re.split(r"[|,]", listed[1])) if listed else ""
                text += f'    {patterns}) words="{words}" only=yes ;;\n'
    return text


def completion(lumi):
    program = [command.words[0] for command in lumi.commands]
    own = [flag for option, _ in lumi.options for flag in option.split(" ")[0].split(",")]
    return COMPLETION % {
        "program": " ".join(program + own),
        "values": "".join(map(value_cases, lumi.commands)),
        "flags": "".join(f'    {command.words[0]}) flags="{command.flags()}" ;;\n' for command in lumi.commands)}


def main(program, share):
    lumi, share = Command(program), pathlib.Path(share)
    version = subprocess.run([program, "--version"], check=True, capture_output=True, text=True).stdout.split()[1]
    pages = {share / f"man/man1/{command.name}.1": man_page(command, version) for command in lumi.everything()}
    pages[share / "bash-completion/completions/lumi"] = completion(lumi)
    for path, text in pages.items():
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])

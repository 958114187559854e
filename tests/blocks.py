#!/usr/bin/env python3
"""Runs the shell blocks of the pages exactly as printed, and checks that neither a shell block nor a Python block is left out.

  tests/blocks.py check                       every sh block of every page is in the tables below
  tests/blocks.py python                      the pages with python blocks that tests/Python/pages.py runs
  tests/blocks.py run PAGE#SECTION [N...]     run the blocks of a section, or its N-th blocks, in the current folder
  tests/blocks.py show PAGE#SECTION KIND [N]  print the N-th block of this kind (default 1): input for a command
  tests/blocks.py ran FILE                    each block of SCRIPTS and each python block is in FILE, where `run` and pages.py wrote it, and no other block
PAGE is relative to the repository. SECTION is the anchor of the heading right above the block, as in a link.
A text block right after a sh block is the output of that block. `run` adds a line to the file that FOOTBALL_BLOCKS names.
"""

import os
import pathlib
import re
import subprocess
import sys
from collections import Counter
from typing import NamedTuple

ROOT = pathlib.Path(__file__).resolve().parent.parent

# The script that runs all blocks of a section, except those in NOT_RUN.
SCRIPTS = {
    "README.md#install": "tests/package.sh",
    "README.md#start": ".ci/run",
    "CONTRIBUTING.md#build-test-measure": ".ci/run",
    "docs/c.md#c-c-and-unreal": "tests/native.sh",
    "docs/lua.md#a-game": "tests/native.sh",
    "docs/c.md#rust": "tests/native.sh",
    "docs/javascript.md#threejs": "tests/npm.sh",
    "docs/command-line.md#install": "tests/tool.sh",
    "docs/command-line.md#a-kick": "tests/tool.sh",
    "docs/command-line.md#a-replay": "tests/tool.sh",
    "docs/command-line.md#a-page-to-play-with": "tests/tool.sh",
    "docs/cookbook.md#see-what-it-does": "tests/tool.sh",
    "docs/data-sets.md#data-sets-tracks-and-python": "tests/tool.sh",
    "docs/data-sets.md#many-machines": "tests/tool.sh",
    "docs/data-sets.md#pygame": "tests/native.sh",
    "docs/data-sets.md#python": "tests/native.sh",
    "docs/getting-started.md#install": "tests/package.sh",
    "docs/getting-started.md#a-first-kick": "tests/package.sh",
    "samples/Live/README.md#following-a-ball-live-a-page": ".ci/run",
    "samples/Network/README.md#two-machines-one-match": ".ci/run",
}

# The blocks that no script runs, and the reason.
NOT_RUN = {
    ("CONTRIBUTING.md#build-test-measure", 2): "the first command is that of README.md#start, which .ci/run runs; the second command runs a part of these tests again",
    ("CONTRIBUTING.md#build-test-measure", 5): "takes minutes, and its times mean nothing beside other processes",
    ("CONTRIBUTING.md#build-test-measure", 6): "is .ci/run itself",
    ("docs/c.md#c-c-and-unreal", 1): ".ci/release runs this command; tests/native.sh uses the library of the release",
    ("docs/javascript.md#javascript-npm-web-pages-and-threejs", 1): ".ci/release runs these commands; tests/npm.sh installs the package of the release",
    ("docs/lua.md#a-game", 1): "opens a window, and runs until someone closes it",
    ("docs/javascript.md#threejs", 2): "serves until someone stops it",
    ("docs/cookbook.md#how-do-i-use-it-with-monogame", 1): "needs packages of MonoGame; the tests compile the program against stand-ins",
    ("docs/cookbook.md#how-do-i-use-it-with-raylib", 1): "needs the package Raylib-cs; the tests compile the program against stand-ins",
    ("docs/command-line.md#install", 1): ".ci/release runs this command; tests/tool.sh installs the tool of the release",
    ("docs/data-sets.md#pygame", 1): "opens a window, and runs until someone closes it",
    ("docs/data-sets.md#python", 1): ".ci/release runs this command; tests/native.sh installs the wheel of the release",
    ("docs/godot.md#gdscript-without-c", 1): ".ci/release runs this command; tests/native.sh plays the extension of the release",
    ("docs/performance.md#warm-up-the-first-step-is-slow", 1): ".ci/release runs this command; tests/package.sh uses the packages of the release",
    ("docs/following.md#see-it", 1): "serves until someone stops it; tests/Web.Tests opens its page",
    ("samples/Live/README.md#following-a-ball-live-a-page", 2): "serves until someone stops it; tests/Web.Tests opens its page",
}

# The python blocks that tests/Python/pages.py does not run, and the reason. tests/native.sh calls it for every page with other python blocks.
PYTHON_NOT_RUN = {
    ("docs/data-sets.md#files", 1): "tests/tool.sh runs it in the folder of the sweep",
    ("docs/data-sets.md#files", 2): "needs pandas and pyarrow",
}

# A shell command belongs in a sh block. A block without a kind could contain one.
OTHER_SHELLS = {"", "bash", "bat", "cmd", "console", "fish", "powershell", "ps1", "pwsh", "shell", "shell-session", "shellsession", "terminal", "zsh"}


class Block(NamedTuple):
    section: str
    kind: str
    line: int
    code: str
    adjoins: bool  # only blank lines since the block before


def blocks(page):
    """The fenced blocks of a page, in order."""
    found, section, fence, adjoins, used = [], f"{page}#", None, False, Counter()
    for number, line in enumerate((ROOT / page).read_text(encoding="utf-8").splitlines(), 1):
        if fence is not None:
            if re.fullmatch(rf"\s*{fence[0]}`*\s*", line):
                found.append(Block(section, fence[1], fence[2], "".join(f"{each}\n" for each in fence[4]), adjoins))
                fence, adjoins = None, True
            else:
                fence[4].append(line[len(fence[3]):] if line.startswith(fence[3]) else line.lstrip())
        elif opening := re.match(r"(\s*)(```+)\s*([^`]*)$", line):
            fence = (opening[2], opening[3].strip(), number, opening[1], [])
        elif heading := re.match(r"#+ +(.*)", line):
            slug = re.sub(r"[^\w\- ]", "", heading[1].lower()).strip().replace(" ", "-")
            section = f"{page}#{slug}" + (f"-{used[slug]}" if used[slug] else "")
            used[slug] += 1
            adjoins = False
        elif line.strip():
            adjoins = False
    if fence is not None:
        sys.exit(f"{page}, line {fence[2]}: the block has no end.")
    return found


def is_shell(block):
    return block.kind.split(" ")[0] == "sh"


def shell_blocks(section):
    """The sh blocks of a section, each with the text block right after it or None."""
    page = section.split("#")[0]
    of_page = blocks(page)
    return [
        (block, of_page[i + 1] if i + 1 < len(of_page) and of_page[i + 1].kind == "text" and of_page[i + 1].adjoins else None)
        for i, block in enumerate(of_page)
        if is_shell(block) and block.section == section
    ]


def python_blocks(page):
    """The python blocks of a page that run, as (section, number, block, the text block right after it or None)."""
    of_page, numbers, found = blocks(page), Counter(), []
    for i, block in enumerate(of_page):
        if block.kind == "python":
            numbers[block.section] += 1
            if (block.section, numbers[block.section]) not in PYTHON_NOT_RUN:
                prints = of_page[i + 1] if i + 1 < len(of_page) and of_page[i + 1].kind == "text" and of_page[i + 1].adjoins else None
                found.append((block.section, numbers[block.section], block, prints))
    return found


def pages():
    """The pages of the repository."""
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard", "*.md"], cwd=ROOT, check=True, capture_output=True, text=True).stdout
    return listed.splitlines()


def all_blocks():
    """Every sh block of every page, as (section, number), and its line."""
    found = {}
    for page in pages():
        numbers = Counter()
        for block in blocks(page):
            if block.kind.split(" ")[0].lower() in OTHER_SHELLS:
                sys.exit(f"{page}, line {block.line}: the kind of the block is '{block.kind}'; for a shell command, write sh.")
            if is_shell(block):
                numbers[block.section] += 1
                found[block.section, numbers[block.section]] = block
    return found


def check():
    found = all_blocks()
    wrong = [f"{section}, line {block.line}: no script runs this block. Add the section to SCRIPTS or the block to NOT_RUN in tests/blocks.py."
             for (section, number), block in found.items() if section not in SCRIPTS and (section, number) not in NOT_RUN]
    wrong += [f"{section}: SCRIPTS contains this section, but it has no sh block." for section in SCRIPTS if not any(section == each for each, _ in found)]
    wrong += [f"{section}, block {number}: NOT_RUN contains this block, but the page does not." for section, number in NOT_RUN if (section, number) not in found]
    wrong += [f"{section}: {script} does not name this section." for section, script in SCRIPTS.items() if section not in (ROOT / script).read_text(encoding="utf-8")]
    python = Counter(block.section for page in pages() for block in blocks(page) if block.kind == "python")
    wrong += [f"{section}, python block {number}: PYTHON_NOT_RUN contains this block, but the page does not." for section, number in PYTHON_NOT_RUN if number > python[section]]
    start = [block.code.strip().count("\n") + 1 for (section, _), block in found.items() if section == "README.md#start"]
    if start != [1, 1]:
        wrong.append(f"README.md#start: the blocks have {start} commands; it must have two blocks with one command each.")
    if wrong:
        sys.exit("\n".join(wrong))
    return found


def run(section, numbers):
    chosen = shell_blocks(section)
    if not chosen:
        sys.exit(f"{section} has no sh block.")
    for number in numbers or [n for n in range(1, len(chosen) + 1) if (section, n) not in NOT_RUN]:
        if not 1 <= number <= len(chosen):
            sys.exit(f"{section} has {len(chosen)} sh blocks, not {number}.")
        block, prints = chosen[number - 1]
        done = subprocess.run(["bash", "-euo", "pipefail", "-c", block.code], stdin=subprocess.DEVNULL, stdout=None if prints is None else subprocess.PIPE, text=True)
        if done.returncode != 0:
            print(f"{section}, line {block.line}: exit code {done.returncode}", file=sys.stderr)
            sys.exit(done.returncode if done.returncode > 0 else 1)
        if prints is not None:
            print(done.stdout, end="")
            if done.stdout.strip() != prints.code.strip():
                sys.exit(f"{section}, line {block.line}: the block prints\n{done.stdout}and the page says\n{prints.code}")
        if record := os.environ.get("FOOTBALL_BLOCKS"):
            with open(record, "a", encoding="utf-8") as file:
                file.write(f"{section} {number}\n")


def show(section, kind, number):
    of_kind = [block for block in blocks(section.split("#")[0]) if block.section == section and block.kind == kind]
    if len(of_kind) < number:
        sys.exit(f"{section} has {len(of_kind)} {kind} blocks, not {number}.")
    print(of_kind[number - 1].code, end="")


def ran(record):
    found = check()
    lines = pathlib.Path(record).read_text(encoding="utf-8").splitlines()
    done = {(section, int(number)) for section, number in (line.split(" ") for line in lines if not line.startswith("python "))}
    wrong = [f"{section}, line {block.line}: {SCRIPTS[section]} did not run this block."
             for (section, number), block in found.items() if (section, number) not in NOT_RUN and (section, number) not in done]
    wrong += [f"{section}, block {number}: NOT_RUN contains this block, but it ran." for section, number in NOT_RUN if (section, number) in done]
    python = [f"python {section} {number}" for page in pages() for section, number, _, _ in python_blocks(page)]
    wrong += [f"{block}: tests/Python/pages.py did not run this block." for block in python if block not in lines]
    if wrong:
        sys.exit("\n".join(wrong))
    print(f"ok    blocks: all {len(found)} sh blocks of {len({section.split('#')[0] for section, _ in found})} pages: "
          f"{len(found) - len(NOT_RUN)} ran as printed, {len(NOT_RUN)} have a reason not to; "
          f"{len(python)} python blocks ran and printed the output on the page, {len(PYTHON_NOT_RUN)} have a reason not to")


def main(arguments):
    match arguments:
        case ["check"]:
            found = check()
            print(f"ok    blocks: {len(found)} sh blocks, {len(NOT_RUN)} of them not run, with the reason")
        case ["python"]:
            print(*(page for page in pages() if python_blocks(page)), sep="\n")
        case ["run", section, *numbers] if all(number.isdigit() for number in numbers):
            run(section, [int(number) for number in numbers])
        case ["show", section, kind, *number] if len(number) <= 1 and all(each.isdigit() and each != "0" for each in number):
            show(section, kind, int(number[0]) if number else 1)
        case ["ran", record]:
            ran(record)
        case _:
            sys.exit(__doc__)


if __name__ == "__main__":
    main(sys.argv[1:])

"""Runs the programs of a page of the docs, and compares what they print with the text block after them.

    pages.py PAGE[#HEADING]       the python blocks of the page, or of the section from HEADING to the end; each is a complete program
    pages.py --c PAGE PREFIX      the c blocks, complete programs too, linked with the library in PREFIX
With FOOTBALL_REGENERATE=1, the output is written into the page instead.
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile

is_c = sys.argv[1] == "--c"
path, _, heading = sys.argv[2 if is_c else 1].partition("#")
page = pathlib.Path(path)
start = page.read_text(encoding="utf-8").index(f"\n## {heading}\n") if heading else 0
kind = "c" if is_c else "python"
blocks = re.findall(rf"```{kind}\n(.*?)```\n(?:\n```text\n(.*?)```)?", page.read_text(encoding="utf-8")[start:], re.S)
if not blocks:
    sys.exit(f"{page} has no {kind} block")
with tempfile.TemporaryDirectory() as folder:
    for i, (code, expected) in enumerate(blocks):
        source = pathlib.Path(folder) / f"program{i}.{'c' if is_c else 'py'}"
        source.write_text(code, encoding="utf-8")
        if is_c:
            prefix, program = sys.argv[3], str(source.with_suffix(""))
            subprocess.run(["gcc", "-std=c99", "-Wall", "-Wextra", "-Werror", f"-I{prefix}/include", str(source), "-o", program, f"-L{prefix}/lib", "-lfootball_physics", f"-Wl,-rpath,{prefix}/lib"], check=True)
            command = [program]
        else:
            command = [sys.executable, str(source)]
        said = subprocess.run(command, check=True, capture_output=True, text=True, cwd=folder).stdout
        if os.environ.get("FOOTBALL_REGENERATE") == "1":
            text = page.read_text(encoding="utf-8")
            end = text.index(code, start) + len(code)
            page.write_text(text[:end] + text[end:].replace(f"```text\n{expected}```", f"```text\n{said}```", 1), encoding="utf-8")
        elif said.strip() != expected.strip():
            sys.exit(f"{page.name}, {kind} block {i + 1} prints\n{said}but the page contains\n{expected}")
print(f"docs/{page.name}: {len(blocks)} {kind} programs run and print the output on the page")

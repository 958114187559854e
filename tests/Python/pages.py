"""Runs the programs of a page of the docs, and compares what they print with the text block after them.

    pages.py PAGE[#HEADING]       the python blocks of the page, or of the section from HEADING to the end; each is a complete program
    pages.py --c PAGE PREFIX      the c blocks, complete programs too, linked with the library in PREFIX
    pages.py --lua PAGE PREFIX    the lua blocks, complete programs too, run by LÖVE without a window; out/native is PREFIX
With FOOTBALL_REGENERATE=1, the output is written into the page instead.
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile

kind = sys.argv[1][2:] if sys.argv[1] in ("--c", "--lua") else "python"
path, _, heading = sys.argv[1 if kind == "python" else 2].partition("#")
page = pathlib.Path(path)
start = page.read_text(encoding="utf-8").index(f"\n## {heading}\n") if heading else 0
blocks = re.findall(rf"```{kind}\n(.*?)```\n(?:\n```text\n(.*?)```)?", page.read_text(encoding="utf-8")[start:], re.S)
if not blocks:
    sys.exit(f"{page} has no {kind} block")
with tempfile.TemporaryDirectory() as folder:
    for i, (code, expected) in enumerate(blocks):
        source = pathlib.Path(folder) / f"program{i}.{'py' if kind == 'python' else kind}"
        source.write_text(code, encoding="utf-8")
        if kind == "c":
            prefix, program = sys.argv[3], str(source.with_suffix(""))
            subprocess.run(["gcc", "-std=c99", "-Wall", "-Wextra", "-Werror", f"-I{prefix}/include", str(source), "-o", program, f"-L{prefix}/lib", "-lfootball_physics", f"-Wl,-rpath,{prefix}/lib"], check=True)
            command = [program]
        elif kind == "lua":
            game, out = source.with_suffix(""), pathlib.Path(folder) / "out"
            game.mkdir()
            out.mkdir(exist_ok=True)
            if i == 0:
                (out / "native").symlink_to(pathlib.Path(sys.argv[3]).absolute())
            (game / "conf.lua").write_text("function love.conf(t) t.modules.window, t.modules.graphics, t.modules.audio = false, false, false end", encoding="utf-8")
            (game / "main.lua").write_text(f"love.errorhandler = print\n{code}love.event.quit()\n", encoding="utf-8")
            command = ["love", str(game)]
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

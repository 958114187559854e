"""Runs the programs of a page of the docs, and compares what they print with the text block after them.

    pages.py PAGE                 the python blocks, complete programs, except those in PYTHON_NOT_RUN of tests/blocks.py
    pages.py --c PAGE PREFIX      the c blocks, complete programs too, linked with the library in PREFIX
    pages.py --lua PAGE PREFIX    the lua blocks, complete programs too, run by LÖVE without a window; out/native is PREFIX
PAGE is relative to the repository. With FOOTBALL_REGENERATE=1, the output is written into the page instead.
A line for each python block is added to the file that FOOTBALL_BLOCKS names.
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests"))
import blocks as printed  # noqa: E402

kind = sys.argv[1][2:] if sys.argv[1] in ("--c", "--lua") else "python"
name = sys.argv[1 if kind == "python" else 2]
page = ROOT / name
if kind == "python":
    programs = [(block.code, prints.code if prints else None, f"python {section} {number}") for section, number, block, prints in printed.python_blocks(name)]
else:
    programs = [(code, expected, None) for code, expected in re.findall(rf"```{kind}\n(.*?)```\n(?:\n```text\n(.*?)```)?", page.read_text(encoding="utf-8"), re.S)]
if not programs:
    sys.exit(f"{name} has no {kind} block that runs")
start = 0
with tempfile.TemporaryDirectory() as folder:
    for i, (code, expected, record) in enumerate(programs):
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
        text = page.read_text(encoding="utf-8")
        start = text.index(code, start) + len(code)
        if os.environ.get("FOOTBALL_REGENERATE") == "1":
            page.write_text(text[:start] + text[start:].replace(f"```text\n{expected or ''}```", f"```text\n{said}```", 1), encoding="utf-8")
        elif said.strip() != (expected or "").strip():
            sys.exit(f"{name}, {kind} block {i + 1} prints\n{said}but the page contains\n{expected or 'no output'}")
        if record and os.environ.get("FOOTBALL_BLOCKS"):
            with open(os.environ["FOOTBALL_BLOCKS"], "a", encoding="utf-8") as file:
                file.write(record + "\n")
print(f"{name}: {len(programs)} {kind} programs run and print the output on the page")

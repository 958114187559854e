#!/usr/bin/env python3
"""Applies small errors to a copy of the library, one at a time, and lists the errors that no test of behaviour detects.

  tests/mutations.py [NAME...]     all entries of tests/mutations.json, or the named ones; exit code 1 if one survives

An entry names a file, a text that occurs once in the file, the wrong text, and the tests concerned. If these tests pass, the script runs the others, except for the
tests of the command line and of the repository's files. It does not run the golden hashes (tests/Package.Tests). Build the tests first:
dotnet build -c Release tests/Football.Physics.Tests
dotnet build -c Release tests/Football.Physics.Labs.Tests
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
PROJECTS = ["Football.Physics.Tests", "Football.Physics.Labs.Tests"]
# The library, and its parts in other folders: the path of a file begins with the name of the part.
PARTS = {"": "src/Football.Physics", "Batch": "src/Football.Physics.Batch", "Engines": "src/Football.Physics.Engines", "Thesis": "src/Football.Physics.Thesis", "Tracks": "src/Football.Physics.Tracks"}
OTHERS = "FullyQualifiedName!~FootballPhysics.Tool.Tests.&FullyQualifiedName!~.Architecture.&FullyQualifiedName!~.Api.&FullyQualifiedName!~ChangedLawTests&FullyQualifiedName!~ProfileTests&FullyQualifiedName!~ReferenceBoundTests"
ENVIRONMENT = {**os.environ, "DOTNET_CLI_TELEMETRY_OPTOUT": "1", "MSBUILDDISABLENODEREUSE": "1"}


def run(command, folder):
    return subprocess.run(command, cwd=folder, env=ENVIRONMENT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


def project_of(test):
    """The project that contains a test class."""
    has = re.compile(rf"class {test.split('.')[0]}\b")
    found = [name for name in PROJECTS if any(has.search(path.read_text()) for path in (ROOT / "tests" / name).rglob("*.cs"))]
    return found[0] if found else sys.exit(f"there is no test class {test}")


def failures(work, name, project, chosen):
    """The chosen tests of a project that fail."""
    test = run(["dotnet", "vstest", str(work / project / (project + ".dll")), "--TestCaseFilter:" + chosen], work)
    if "Total:" not in test.stdout or "No test matches" in test.stdout:
        sys.exit(f"{name}: no tests ran:\n" + test.stdout[-2000:])
    return re.findall(r"^\s*Failed FootballPhysics\.(?:\w+\.)*(\w+\.\w+)", test.stdout, re.MULTILINE) or (["?"] if test.returncode else [])


def named(tests):
    return "|".join("FullyQualifiedName~" + test for test in tests)


def place(mutation):
    """The part and the file in it, or None if the text does not occur exactly once."""
    room, _, rest = mutation["file"].partition("/")
    part, file = (PARTS[room], rest) if room in PARTS else (PARTS[""], mutation["file"])
    path = ROOT / part / file
    return (part, file) if path.exists() and path.read_text().count(mutation["old"]) == 1 else None


def main():
    mutations = json.loads((ROOT / "tests/mutations.json").read_text())
    wanted = [m for m in mutations if not sys.argv[1:] or m["name"] in sys.argv[1:]]
    places = {m["name"]: place(m) for m in wanted}
    lost = [name for name in sys.argv[1:] if name not in places] + [name for name in places if not places[name]]
    wanted = [m for m in wanted if places[m["name"]]]
    for name in lost:
        print(f"LOST      {name}: its text does not occur exactly once in its file")

    survivors = []
    with tempfile.TemporaryDirectory() as work:
        work = pathlib.Path(work)
        for name in ["BannedSymbols.txt", "Directory.Build.props", "Directory.Build.targets", "Directory.Packages.props", "global.json", "README.md", "LICENSE"]:
            shutil.copy(ROOT / name, work / name)
        for part in [*PARTS.values(), "src/Packaging"]:
            shutil.copytree(ROOT / part, work / part, ignore=shutil.ignore_patterns("bin"))
        for project in PROJECTS:
            shutil.copytree(ROOT / "tests" / project / "bin/Release/net10.0", work / project)
        (work / "Football.Physics.sln").write_text("")
        concerned = sorted({test for m in wanted for test in m["tests"]})
        projects = {test: project_of(test) for test in concerned}
        plain = []
        for project in sorted(set(projects.values())):
            plain += failures(work, "unchanged", project, named([test for test in concerned if projects[test] == project]))
        if plain:
            sys.exit("these tests fail without any error: " + ", ".join(sorted(set(plain))))

        for m in wanted:
            part, file = places[m["name"]]
            path = work / part / file
            text = path.read_text()
            path.write_text(text.replace(m["old"], m["new"]))
            # A folder without a project is compiled into the library.
            project = part if (work / part / (pathlib.Path(part).name + ".csproj")).exists() else PARTS[""]
            build = run(["dotnet", "build", "-c", "Release", project, "-f", "net10.0", "-p:TargetFrameworks=net10.0", "-p:RunAnalyzers=false",
                         "--nologo", "-v", "q", "-o", str(work / "mutant")], work)
            path.write_text(text)
            if build.returncode != 0:
                sys.exit(f"{m['name']} does not compile:\n" + build.stdout[-2000:])

            for project in PROJECTS:
                for built in PARTS.values():
                    name = pathlib.Path(built).name + ".dll"
                    if (work / "mutant" / name).exists():
                        shutil.copy(work / "mutant" / name, work / project / name)
            failed = [test for project in sorted({projects[test] for test in m["tests"]})
                      for test in failures(work, m["name"], project, named([test for test in m["tests"] if projects[test] == project]))]
            others = [] if failed else failures(work, m["name"], PROJECTS[0], OTHERS)
            survivors += [] if failed or others else [m["name"]]
            seen = "  " + ", ".join(sorted(set(failed))[:3]) if failed else "  by others: " + ", ".join(sorted(set(others))[:6]) if others else ""
            print(("caught    " if failed or others else "SURVIVED  ") + m["name"] + " " + m["what"] + seen, flush=True)
    print(f"{len(wanted) - len(survivors)} of {len(wanted)} caught, {len(survivors)} survived" + (f", {len(lost)} lost" if lost else ""))
    sys.exit(1 if survivors or lost else 0)


main()

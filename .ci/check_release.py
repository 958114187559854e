#!/usr/bin/env python3
"""Checks the artefacts of a release against the documented rules of their registries, and with the registries' own programs if they are installed.

  .ci/check_release.py DIR VERSION

nuget.org: https://learn.microsoft.com/nuget/reference/nuspec and https://learn.microsoft.com/nuget/create-packages/symbol-packages-snupkg; `dotnet nuget push` into a folder
npm: https://docs.npmjs.com/cli/configuring-npm/package-json; `npm publish --dry-run` and publint
PyPI: https://packaging.python.org/specifications/core-metadata; `twine check --strict`
Unity: https://docs.unity3d.com/Manual/upm-manifestPkg.html
Godot: https://docs.godotengine.org/en/stable/community/asset_library/submitting_to_assetlib.html
"""

import configparser
import hashlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import xml.etree.ElementTree as xml
import zipfile

SEMVER = re.compile(r"\d+\.\d+\.\d+(-[0-9A-Za-z.-]+)?")
MIB = 1 << 20


class Checks:
    def __init__(self, version: str) -> None:
        self.version, self.faults = version, []

    def that(self, holds: bool, name: str, fault: str) -> None:
        if not holds:
            self.faults.append(f"{name}: {fault}")

    def program(self, name: str, command: list[str], folder: pathlib.Path, **environment: str) -> None:
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, stdin=subprocess.DEVNULL, env={**os.environ, **environment})
        self.that(done.returncode == 0, name, f"{' '.join(pathlib.Path(word).name for word in command)} fails:\n{(done.stdout + done.stderr).strip()}")
        print(f"{'ok' if done.returncode == 0 else 'FAIL':<6}{name}: {' '.join(pathlib.Path(word).name for word in command)}")


def nuget(checks: Checks, path: pathlib.Path) -> None:
    name = path.name
    with zipfile.ZipFile(path) as package:
        files = {entry.filename: entry for entry in package.infolist()}
        [manifest] = [file for file in files if file.endswith(".nuspec") and "/" not in file]
        root = xml.fromstring(package.read(manifest))
        meta = {child.tag.split("}")[1]: child for child in root[0]}
        text = {key: (child.text or "").strip() for key, child in meta.items()}
        checks.that(re.fullmatch(r"\w+([.-]\w+)*", text["id"]) and len(text["id"]) <= 100, name, f"the id is {text['id']}")
        checks.that(text["version"] == checks.version, name, f"the version is {text['version']}")
        if path.suffix == ".snupkg":
            checks.that(all(re.search(r"\.(pdb|nuspec|xml|psmdcp|rels|p7s)$", file) for file in files), name, "a symbol package contains only .pdb files")
            checks.that(all(package.read(file)[:4] == b"BSJB" for file in files if file.endswith(".pdb")), name, "a .pdb file is not portable")
            with zipfile.ZipFile(path.with_suffix(".nupkg")) as library:
                missing = [file for file in files if file.endswith(".pdb") and file[:-3] + "dll" not in library.namelist()]
            checks.that(not missing, name, f"no assembly for {missing}")
            return
        checks.that(path.stat().st_size <= 250 * MIB, name, "more than 250 MiB")
        for key, most in (("description", 4000), ("tags", 4000), ("releaseNotes", 35000)):
            checks.that(0 < len(text.get(key, "")) <= most, name, f"{key} has {len(text.get(key, ''))} characters; allowed: 1 … {most}")
        checks.that(text.get("authors"), name, "no author")
        checks.that(meta["license"].get("type") == "expression" and text["license"] == "MIT", name, "no licence expression")
        icon, readme = files.get(text.get("icon", "")), files.get(text.get("readme", ""))
        checks.that(icon and icon.file_size <= MIB and package.read(icon)[:4] == b"\x89PNG", name, "the icon is missing, is no PNG file, or has more than 1 MiB")
        checks.that(readme and 0 < readme.file_size <= MIB, name, "the README is missing or has more than 1 MiB")
        if readme:
            relative = re.findall(r"\]\((?!https?:|#)[^)]*\)", package.read(readme).decode())
            checks.that(not relative, name, f"the README has links into a folder: {relative[:3]}")
        repository = meta.get("repository")
        checks.that(repository is not None and repository.get("url", "").startswith("https://") and re.fullmatch("[0-9a-f]{40}", repository.get("commit", "")), name,
                    "no repository with an https address and a commit. Pass --address URL")
        checks.that(text.get("projectUrl", "").startswith("https://"), name, "no project address. Pass --address URL")
        sbom = json.loads(package.read("_manifest/bom.cdx.json"))
        checks.that(sbom["bomFormat"] == "CycloneDX" and sbom["metadata"]["component"]["version"] == checks.version, name, "no SBOM of this version")
        for dependency in root.iter(root.tag.replace("package", "dependency")):
            if dependency.get("id").startswith("Football."):
                checks.that(dependency.get("version") == f"[{checks.version}]", name, f"depends on {dependency.get('id')} {dependency.get('version')}")
    checks.that(path.with_suffix(".snupkg").exists(), name, "no symbols")


def npm(checks: Checks, path: pathlib.Path, work: pathlib.Path) -> None:
    name = path.name
    with tarfile.open(path) as archive:
        files = set(archive.getnames())
        manifest = json.load(archive.extractfile("package/package.json"))
    checks.that(manifest["name"] == "football-physics" and manifest["version"] == checks.version, name, f"is {manifest['name']} {manifest['version']}")
    for key in ("description", "license", "repository", "types", "exports", "sideEffects", "engines", "type"):
        checks.that(key in manifest, name, f"no {key}" + (". Pass --address URL" if key == "repository" else ""))
    if "repository" in manifest:
        checks.that(re.fullmatch(r"git\+https://.*\.git", manifest["repository"]["url"]), name, f"the repository is {manifest['repository']['url']}")
    entries = [manifest["types"], manifest["main"], *(each for entry in manifest["exports"].values() for each in (entry.values() if isinstance(entry, dict) else [entry]))]
    for entry in entries:
        pattern = re.escape("package/" + entry.removeprefix("./")).replace(r"\*", ".+")
        checks.that(any(re.fullmatch(pattern, file) for file in files), name, f"{entry} is not in the package")
    for file in ("README.md", "LICENSE"):
        checks.that(f"package/{file}" in files, name, f"no {file}")
    if shutil.which("npm"):
        # A pre-release does not become "latest". Without a registry, the address stays unused: the dry run only packs and reads.
        tag = "next" if "-" in checks.version else "latest"
        checks.program(name, ["npm", "publish", "--dry-run", "--ignore-scripts", "--tag", tag, str(path)], work)
        if shutil.which("publint"):
            checks.program(name, ["publint", "run", str(path), "--strict"], work)
        else:
            print(f"--    {name}: publint is not installed")


def pypi(checks: Checks, paths: list[pathlib.Path], work: pathlib.Path) -> None:
    for path in paths:
        name = path.name
        checks.that(path.stat().st_size <= 100 * MIB, name, "more than 100 MiB")
        checks.that(re.search(r"-(manylinux_2_\d+_(x86_64|aarch64)|macosx_\d+_\d+_arm64|win_amd64)\.whl$", name), name, "the registry does not accept this tag of a platform")
        with zipfile.ZipFile(path) as wheel:
            [metadata] = [file for file in wheel.namelist() if file.endswith(".dist-info/METADATA")]
            head, _, body = wheel.read(metadata).decode().partition("\n\n")
            [record] = [file for file in wheel.namelist() if file.endswith(".dist-info/RECORD")]
            checks.that({line.rsplit(",", 2)[0] for line in wheel.read(record).decode().split()} == set(wheel.namelist()), name, "RECORD does not list its files")
        checks.that("\nProject-URL: Homepage, https://" in head, name, "no address. Pass --address URL")
        checks.that(not re.search(r"\]\((?!https?:|#)", body), name, "the description has links into a folder")
    twine = shutil.which("twine")
    if twine:
        checks.program(", ".join(path.name for path in paths), [twine, "check", "--strict", *map(str, paths)], work)
    else:
        print("--    wheels: twine is not installed")


def unity(checks: Checks, path: pathlib.Path) -> None:
    name = path.name
    with tarfile.open(path) as archive:
        files = {file.removeprefix("package/") for file in archive.getnames()}
        manifest = json.load(archive.extractfile("package/package.json"))
    checks.that(manifest["version"] == checks.version and SEMVER.fullmatch(manifest["version"]), name, f"the version is {manifest['version']}")
    checks.that(re.fullmatch(r"[a-z0-9_.-]+", manifest["name"]) and len(manifest["name"]) <= 214, name, f"the name is {manifest['name']}")
    for key in ("displayName", "description", "unity", "license", "author"):
        checks.that(manifest.get(key), name, f"no {key}")
    for key in ("documentationUrl", "changelogUrl", "licensesUrl"):
        checks.that(manifest.get(key, "").startswith("https://"), name, f"no {key}. Pass --address URL")
    checks.that(len(manifest["samples"]) == 2 and all(any(file.startswith(sample["path"] + "/") for file in files) for sample in manifest["samples"]), name, "a sample is missing")
    for kind in ("dll", "xml"):
        checks.that(f"Plugins/Football.Physics.{kind}" in files, name, f"no Plugins/Football.Physics.{kind}")
    # The engine writes no .meta file into a package from a registry, and ignores an asset without one. It ignores folders that end with a tilde.
    bare = [file for file in files if not file.endswith(".meta") and not file.startswith("Documentation~/") and f"{file}.meta" not in files]
    checks.that(not bare, name, f"no .meta file for {bare[:3]}")


def godot(checks: Checks, path: pathlib.Path, addon: str, config: str) -> None:
    name = path.name
    with zipfile.ZipFile(path) as archive:
        files = set(archive.namelist())
        checks.that(all(file.startswith(f"addons/{addon}/") for file in files), name, f"a file is outside addons/{addon}")
        checks.that(any(f"addons/{addon}/LICENSE{end}" in files for end in ("", ".md")), name, "no licence")
        text = archive.read(f"addons/{addon}/{config}").decode()
        if config == "plugin.cfg":
            plugin = configparser.ConfigParser()
            plugin.read_string(text)
            checks.that(plugin["plugin"]["version"].strip('"') == checks.version, name, f"the version is {plugin['plugin']['version']}")
            checks.that(f"addons/{addon}/packages/Football.Physics.{checks.version}.nupkg" in files, name, "no package Football.Physics")
        else:
            system = path.stem.rsplit("-", 2)[1:]
            named = re.findall(r"res://(addons/football/bin/[^\"]*)", text)
            here = [file for file in files if "/bin/" in file]
            checks.that(here and set(here) <= set(named), name, f"{config} does not name {sorted(set(here) - set(named))} of {system}")


def library(checks: Checks, path: pathlib.Path) -> None:
    with tarfile.open(path) as archive:
        files = set(archive.getnames())
    for file in ("include/football_physics.h", "lib/cmake/football_physics/football_physics-config.cmake", "LICENSE"):
        checks.that(file in files, path.name, f"no {file}")
    checks.that(any(re.fullmatch(r"(lib|bin)/(lib)?football_physics\.(so|dylib|dll)", file) for file in files), path.name, "no library")


def main(folder: str, version: str) -> None:
    here, checks = pathlib.Path(folder).resolve(), Checks(version)
    kinds = [
        ("Football.Physics*.*nupkg", 8, lambda path: nuget(checks, path)),
        ("football-physics-[0-9]*.tgz", 1, lambda path: npm(checks, path, work)),
        ("com.football.physics-*.tgz", 1, lambda path: unity(checks, path)),
        ("football-physics-godot-*.zip", 1, lambda path: godot(checks, path, "football_physics", "plugin.cfg")),
        ("football-physics-gdextension-*.zip", 1, lambda path: godot(checks, path, "football", "football.gdextension")),
        ("football-physics-c-*.tar.gz", 1, lambda path: library(checks, path)),
        ("football-physics-site-*.zip", 1, lambda path: checks.that("index.html" in zipfile.ZipFile(path).namelist(), path.name, "no index.html")),
        ("RELEASE_NOTES.md", 1, lambda path: checks.that(path.stat().st_size > 100, path.name, "is empty")),
    ]
    with tempfile.TemporaryDirectory() as temporary:
        work = pathlib.Path(temporary)
        for pattern, least, check in kinds:
            found = sorted(here.glob(pattern))
            checks.that(len(found) >= least, pattern, f"{len(found)} files; expected: at least {least}")
            for path in found:
                check(path)
        wheels = sorted(here.glob("*.whl"))
        checks.that(len(wheels) > 0, "*.whl", "no wheel")
        pypi(checks, wheels, work)
        # The client's own checks of a package and its symbols; the feed is a folder.
        (work / "feed").mkdir()
        packages = sorted(here.glob("*.nupkg"))
        checks.program(f"{len(packages)} packages", ["dotnet", "nuget", "push", str(here / "*.nupkg"), "--source", str(work / "feed")], work)
        pushed = sorted(path.name for path in (work / "feed").rglob("*nupkg"))
        checks.that(set(pushed) >= {path.name for path in packages}, "packages", f"the feed has {pushed}")
    sums = dict(reversed(line.split("  ", 1)) for line in (here / "SHA256SUMS").read_text().splitlines())
    files = {path.name for path in here.iterdir() if path.is_file()} - {"SHA256SUMS"}
    checks.that(set(sums) == files, "SHA256SUMS", f"lists other files than the folder: {sorted(set(sums) ^ files)[:5]}")
    checks.that(all(hashlib.sha256((here / name).read_bytes()).hexdigest() == sums[name] for name in files & set(sums)), "SHA256SUMS", "a file has another hash")
    large = [path.name for path in here.iterdir() if path.stat().st_size >= 2 << 30]
    checks.that(not large, "GitHub", f"a file of a release has less than 2 GiB: {large}")
    for fault in checks.faults:
        print(f"FAIL  {fault}", file=sys.stderr)
    if checks.faults:
        sys.exit(f"{len(checks.faults)} faults in {len(files)} artefacts")
    print(f"ok    {len(files)} artefacts of {version} keep the rules of their registries")


if __name__ == "__main__":
    main(*sys.argv[1:])

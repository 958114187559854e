"""Builds the wheel with the standard library and the .NET SDK alone: the package, and the C library that build.sh of Football.Physics.Native made.

    python3 build_wheel.py LIBRARY DIR [PLATFORM]       PLATFORM: a wheel's tag, default manylinux_2_31 for a library for Linux, otherwise that of this machine
"""

import base64
import hashlib
import pathlib
import re
import subprocess
import sys
import sysconfig
import zipfile

HERE = pathlib.Path(__file__).parent
TIME = (2026, 1, 1, 0, 0, 0)
# That of Debian 11.
GLIBC = 31
VERSION = ["dotnet", "msbuild", str(HERE.parent / "Football.Physics"), "-restore", "-t:FindVersion", "-getProperty:Version"]


def description() -> str:
    """The Python section of the page about data sets, as a page of its own."""
    page = (HERE.parents[1] / "docs" / "data-sets.md").read_text(encoding="utf-8")
    section = page[page.index("\n## Python\n") + 1:]
    return re.sub(r"^#(#+ )", r"\1", section, flags=re.M)


def platform_of(library: bytes) -> str:
    """The tag of the platform that a library runs on. PyPI accepts a library for Linux only if its tag states the glibc that it needs."""
    if library[:4] != b"\x7fELF":
        return sysconfig.get_platform()
    newest = max(int(minor) for minor in re.findall(rb"\0GLIBC_2\.(\d+)", library))
    if newest > GLIBC:
        sys.exit(f"the library needs glibc 2.{newest}; allowed: up to 2.{GLIBC}. Build it with build.sh of Football.Physics.Native")
    machine = {62: "x86_64", 183: "aarch64"}[int.from_bytes(library[18:20], "little")]
    return f"manylinux_2_{GLIBC}_{machine}"


def python_version(version: str) -> str:
    """A version as Python writes it: 0.2.1-alpha.0.3, three commits after a tag, becomes 0.2.1a0.post3."""
    version = re.sub(r"-(a|b|rc)[a-z]*\.(\d+)", r"\1\2", version)
    return re.sub(r"((?:a|b|rc)\d+)\.(\d+)$", r"\1.post\2", version)


def main(library: str, folder: str, platform: str = "") -> pathlib.Path:
    version = python_version(subprocess.run(VERSION, check=True, capture_output=True, text=True).stdout.strip())
    tag = "py3-none-" + (platform or platform_of(pathlib.Path(library).read_bytes())).replace("-", "_").replace(".", "_")
    info = f"football_physics-{version}.dist-info"
    files = {f"football_physics/{path.name}": path.read_bytes() for path in sorted((HERE / "football_physics").iterdir()) if path.suffix in (".py", ".typed")}
    files[f"football_physics/{pathlib.Path(library).name}"] = pathlib.Path(library).read_bytes()
    files[f"{info}/METADATA"] = (
        f"Metadata-Version: 2.1\nName: football-physics\nVersion: {version}\nSummary: The flight, bounce and roll of a football.\n"
        "License: MIT\nRequires-Python: >=3.9\nRequires-Dist: numpy>=1.20\nDescription-Content-Type: text/markdown\n\n"
    ).encode() + description().encode()
    files[f"{info}/LICENSE"] = (HERE.parents[1] / "LICENSE").read_bytes()
    files[f"{info}/WHEEL"] = f"Wheel-Version: 1.0\nGenerator: build_wheel.py\nRoot-Is-Purelib: false\nTag: {tag}\n".encode()
    record = [f"{name},sha256={base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b'=').decode()},{len(data)}" for name, data in files.items()]
    files[f"{info}/RECORD"] = "\n".join([*record, f"{info}/RECORD,,", ""]).encode()
    wheel = pathlib.Path(folder) / f"football_physics-{version}-{tag}.whl"
    wheel.parent.mkdir(parents=True, exist_ok=True)
    # The same bytes wherever it is built.
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in files.items():
            entry = zipfile.ZipInfo(name, TIME)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = 0o644 << 16
            archive.writestr(entry, data)
    print(wheel)
    return wheel


if __name__ == "__main__":
    main(*sys.argv[1:])

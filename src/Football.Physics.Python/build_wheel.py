"""Builds the wheel with the standard library and the .NET SDK alone: the package, and the C library that build.sh of Football.Physics.Native made.

    python3 build_wheel.py LIBRARY DIR [PLATFORM]       PLATFORM: a wheel's tag, default manylinux_2_31 for a library for Linux, otherwise that of this machine
"""

import base64
import hashlib
import json
import pathlib
import re
import subprocess
import sys
import sysconfig
import urllib.parse
import zipfile

HERE = pathlib.Path(__file__).parent
TIME = (2026, 1, 1, 0, 0, 0)
# That of Debian 11.
GLIBC = 31
FACTS = ["dotnet", "msbuild", str(HERE.parent / "Football.Physics"), "-restore", "-t:FindVersion;InitializeSourceControlInformation;PublishAddressOfProject",
         "-getProperty:Version", "-getProperty:ProjectUrl"]


def facts() -> tuple[str, str]:
    """The version, and the address of the project, which can be empty."""
    said = json.loads(subprocess.run(FACTS, check=True, capture_output=True, text=True).stdout)["Properties"]
    return said["Version"], re.sub(r"(\.git)?/*$", "", said["ProjectUrl"])


def description(address: str) -> str:
    """The Python section of the page about data sets, as a page of its own. A link into the repository gets its address; without an address, only its words stay. Pictures are left out."""
    page = (HERE.parents[1] / "docs" / "data-sets.md").read_text(encoding="utf-8")
    section = page[page.index("\n## Python\n") + 1:]
    section = re.sub(r"^#(#+ )", r"\1", section, flags=re.M)
    section = re.sub(r"!\[[^\]]*\]\([^)]*\)\s+", "", section)
    folder = f"{address}/blob/HEAD/docs/"
    return re.sub(r"\[([^\]]*)\]\((?!https?:)([^)]*)\)", lambda link: f"[{link[1]}]({urllib.parse.urljoin(folder + 'data-sets.md', link[2])})" if address else link[1], section)


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
    version, address = facts()
    version = python_version(version)
    tag = "py3-none-" + (platform or platform_of(pathlib.Path(library).read_bytes())).replace("-", "_").replace(".", "_")
    info = f"football_physics-{version}.dist-info"
    files = {f"football_physics/{path.name}": path.read_bytes() for path in sorted((HERE / "football_physics").iterdir()) if path.suffix in (".py", ".typed")}
    files[f"football_physics/{pathlib.Path(library).name}"] = pathlib.Path(library).read_bytes()
    urls = {"Homepage": address, "Changelog": f"{address}/blob/HEAD/docs/changelog.md", "Issues": f"{address}/issues"} if address else {}
    files[f"{info}/METADATA"] = "".join(f"{line}\n" for line in [
        "Metadata-Version: 2.1", "Name: football-physics", f"Version: {version}", "Summary: The flight, bounce and roll of a football.",
        "Author: Football.Physics contributors", "License: MIT", "Keywords: football,soccer,ball,physics,simulation,trajectory",
        *(f"Project-URL: {name}, {url}" for name, url in urls.items()),
        "Classifier: Development Status :: 4 - Beta", "Classifier: Intended Audience :: Developers", "Classifier: Intended Audience :: Science/Research", "Classifier: License :: OSI Approved :: MIT License",
        "Classifier: Programming Language :: Python :: 3", "Classifier: Topic :: Scientific/Engineering :: Physics", "Classifier: Typing :: Typed",
        "Requires-Python: >=3.9", "Requires-Dist: numpy>=1.20", "Description-Content-Type: text/markdown", "",
    ]).encode() + description(address).encode()
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

#!/usr/bin/env python3
"""Packs a folder: equal files give equal bytes, wherever and whenever they are packed.

  .ci/archive.py FILE.zip FOLDER       FILE.tar.gz too, which keeps which files are programs
"""

import gzip
import io
import pathlib
import sys
import tarfile
import zipfile

TIME = (2026, 1, 1, 0, 0, 0)
SECONDS = 1767225600  # that time


def main(target: str, folder: str) -> None:
    files = {path.relative_to(folder).as_posix(): path for path in pathlib.Path(folder).rglob("*") if path.is_file()}
    if target.endswith(".zip"):
        with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
            for name in sorted(files):
                entry = zipfile.ZipInfo(name, TIME)
                entry.compress_type = zipfile.ZIP_DEFLATED
                entry.external_attr = 0o644 << 16
                archive.writestr(entry, files[name].read_bytes())
        return
    packed = io.BytesIO()
    with tarfile.open(fileobj=packed, mode="w", format=tarfile.USTAR_FORMAT) as archive:
        for name in sorted(files):
            data = files[name].read_bytes()
            entry = tarfile.TarInfo(name)
            entry.size, entry.mtime, entry.mode = len(data), SECONDS, 0o755 if files[name].stat().st_mode & 0o100 else 0o644
            archive.addfile(entry, io.BytesIO(data))
    # A fixed time and no name: the header of gzip would otherwise contain both.
    with open(target, "wb") as file, gzip.GzipFile("", "wb", 9, file, 0) as zipped:
        zipped.write(packed.getvalue())


if __name__ == "__main__":
    main(*sys.argv[1:])

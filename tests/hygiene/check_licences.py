#!/usr/bin/env python3
# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""check_licences.py ROOT INCLUDES [BUILD]: no header of CGAL under the GPL is included, but by the
sources below. INCLUDES is the folder that has CGAL's; each of its headers names its licence. In a
build folder of Ninja what the objects there read is looked at as well, from any header."""

import re
import subprocess
import sys
from pathlib import Path

# What uses them, and is built with TENSORTOPO_WITH_CGAL_GPL only. No library does.
ALLOWED = {
    "analysis/src/analyze/surface/jet_curvature.cpp",
    "tests/embedding/intersections.cpp",
    "tests/extract/parts/test_against_cgal_triangulation.cpp",
}
FOLDERS = "lib analysis proofs-check theory tests examples".split()

licence_of = {}


def is_gpl(header):
    """By its SPDX line. "LGPL" is not; a header without such a line is taken for one that is."""
    if header not in licence_of:
        text = header.read_text(encoding="utf-8", errors="replace")
        found = re.search(r"SPDX-License-Identifier:(.*)", text)
        licence_of[header] = found is None or re.search(r"(?<!L)GPL", found[1]) is not None
    return licence_of[header]


def direct(root, includes):
    """Sources and the headers under the GPL that they name; how many of CGAL's they name."""
    found, named = {}, 0
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix not in (".hpp", ".cpp", ".h"):
                continue
            text = path.read_text(encoding="utf-8", errors="replace")
            for name in re.findall(r"#\s*include\s*[<\"](CGAL/[^>\"]+)", text):
                named += 1
                if is_gpl(includes / name):
                    found.setdefault(str(path.relative_to(root)), set()).add(name)
    return found, named


def transitive(root, build):
    """The main sources of a build's objects and the headers under the GPL that were read for them;
    how many of CGAL's were read."""
    run = subprocess.run(
        ["ninja", "-C", build, "-t", "deps"], capture_output=True, text=True, check=True
    )
    found, read, main = {}, 0, None
    for line in run.stdout.split("\n"):
        if not line.startswith("    "):
            main = None
            continue
        path = (Path(build) / line.strip()).resolve()
        if main is None:
            main = path
        if "/CGAL/" not in str(path) or not path.is_file():
            continue
        read += 1
        if is_gpl(path):
            name = str(main.relative_to(root)) if main.is_relative_to(root) else str(main)
            found.setdefault(name, set()).add("CGAL/" + str(path).split("/CGAL/", 1)[1])
    return found, read


def main():
    root, includes = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
    named, count = direct(root, includes)
    if count == 0:
        sys.exit(f"found no source in {root} that includes CGAL")
    offences = [f"{path} includes what is under the GPL: {sorted(named[path])}" for path in named]
    offences = [text for text in offences if text.split(" ")[0] not in ALLOWED]
    offences += [f"{path} is allowed to and does not" for path in sorted(ALLOWED - set(named))]
    read = 0
    if len(sys.argv) > 3 and (Path(sys.argv[3]) / "build.ninja").exists():
        built, read = transitive(root, sys.argv[3])
        offences += [
            f"the object of {path} has what is under the GPL: {sorted(built[path])[:3]}"
            for path in sorted(built)
            if path not in ALLOWED
        ]
    for offence in offences:
        print(offence)
    if offences:
        sys.exit(f"{len(offences)} offences")
    print(f"{count} includes of CGAL in sources, {read} in objects, {len(licence_of)} headers")


main()

#!/usr/bin/env python3
# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""check_sources.py ROOT: rules that no compiler checks. Prints each offence; fails if there is one."""

import os
import re
import subprocess
import sys
from pathlib import Path

# A folder of lib includes only itself and folders before it.
ORDER = """scalar algebra tensor field manifold mesh hash quadric families extract stability certify
           partition sweep persistence modes io python vtk""".split()

# Sources in lib/extract of members of a class that has a file for its definition.
MEMBERS = {
    "subdivision/refinement_cuts",
    "surface/cells/embedded_cell",
    "patch/delaunay/delaunay_segments",
}

# Files of code in one folder, so that a reader can take in its list.
MOST_FILES = 25

LONGEST_FILE, LONG_FILE, LONGEST_README = 450, 400, 100

# A small literal is a tolerance until proved otherwise: file|literal|why it is there.
TOLERANCES = """
lib/extract/patch/quality/improve_triangles.cpp|1e-13|a moved vertex is as close to the level as those of the meshing, else it stays
lib/io/src/fields/small_tensors.cpp|1e-9|share below which a note says that a tensor is nearly isotropic
lib/extract/patch/charts/dominant_chart.cpp|1e-15|the end of a Newton iteration
lib/extract/patch/charts/dominant_chart.cpp|1e-12|a guess that did not converge is none; the place of what it gives is checked
lib/extract/run/budget.hpp|2e-7|levels thinner than this are not worth the large budget
lib/extract/run/budget.hpp|1e-13|nor these the regular one
lib/extract/run/budget.hpp|1e-15|nor the faces of these
lib/extract/level/multiprecision_level.hpp|1e-9|thinner levels have roots and doubtful signs looked at in 50 digits, and other cuts of edges; either is right
lib/extract/subdivision/refinement_vertex.cpp|1e-3|thinner levels keep to places of 52 bits, a limit of work: what is proved is proved either way
lib/extract/topology/regions/superlevel_paths.cpp|1e-6|where a walk gives up, and how far outside a Newton iteration may end; its places are proved to be in the superlevel set
lib/extract/patch/fill/fill_loops.cpp|1e-4|whether a Newton iteration has found the level; shape only
lib/extract/patch/fill/fill_loops.cpp|1e-14|the same, by roundings of the mode
lib/extract/patch/charts/manifold_mesher.cpp|1e-9|how far rounding may misplace a quadrant that is skipped; samples only
lib/extract/curves/special/degenerate_throughout.cpp|1e-9|deviators farther from parallel than rounding are; all others are compared in rationals
lib/extract/level/level_in_tet.cpp|1e-4|keeps moved vertices off the sides; shape only
lib/extract/level/level_in_tet.cpp|1e-14|the end of a Newton iteration
lib/extract/level/proofs/screen.hpp|2.2e-7|bound of the rounding of a Lode angle, derived beside it
lib/extract/level/proofs/screen.hpp|1e-3|size below which the bound is not claimed
lib/mesh/src/unmatched_faces.cpp|1e-13|bound of the rounding of a product of normals, derived beside it
lib/mesh/src/validate.cpp|1e-100|shortest edge of which the cube is a normal double; shorter ones are refused
lib/io/src/formats/nifti_image.cpp|1e-7|where the standard takes a turn by half a circle for one, of numbers in float32
lib/io/src/fields/tensor_array.cpp|1e-9|largest asymmetry taken for rounding by the program that wrote the file
lib/sweep/src/sweep.cpp|1e-280|a smaller mode is not written with the digits of a decimal that ModeValue reads
lib/persistence/src/ascent.cpp|1e-2|how close a face is for a step to be tried towards it; steps are proved in intervals
lib/persistence/src/linking/linking_number.cpp|1e-9|wider boxes of segments, so that rounding misses no crossing; crossings are decided exactly
lib/persistence/src/numeric_mode.cpp|1e-5|a step of finite differences, for a guess
lib/persistence/src/numeric_mode.cpp|1e-9|keeps a quotient finite, for a guess
lib/persistence/src/persistence_pairs.cpp|1e-9|lengths that agree to nine digits are reported as a tie
lib/vtk/src/tensor_grid.cpp|1e-9|the same, of tensors in memory
"""

offences = 0
lines_of = {}


def report(rule, found):
    """Each of `found` offends against `rule`."""
    global offences
    for offence in found:
        print(f"{rule}: {offence}")
        offences += 1


def lines(path):
    """The lines of a file of text."""
    if path not in lines_of:
        lines_of[path] = Path(path).read_text(encoding="utf-8", errors="replace").split("\n")
    return lines_of[path]


def matches(pattern, paths, ignore=None):
    """Lines in which a pattern is found, but for those that `ignore` is found in."""
    pattern = re.compile(pattern)
    ignore = re.compile(ignore) if ignore else None
    for path in paths:
        for number, line in enumerate(lines(path), 1):
            if pattern.search(line):
                found = f"{path}:{number}:{line}"
                if not (ignore and ignore.search(found)):
                    yield found


def files_below(folders):
    """All files that people wrote, sorted."""
    for top in folders:
        for folder, inner, names in os.walk(top):
            inner[:] = [
                n for n in inner if n not in ("data", "out", "__pycache__") and not n.startswith("build")
            ]
            for name in names:
                yield os.path.join(folder, name)


def tracked(*patterns):
    """Files of the repository; none outside of one."""
    result = subprocess.run(["git", "ls-files", "-z", *patterns], capture_output=True, check=False)
    return [name for name in result.stdout.decode().split("\0") if name]


def is_source(path):
    """C++, CMake and scripts."""
    return bool(
        re.search(r"(\.(hpp|cpp|h|cmake|cmake\.in|sh|inc)|/CMakeLists\.txt)$", path)
        or path.startswith(".ci/")
        or re.match(r"\.docs/(.*\.py|make|Doxyfile)$", path)
        or path == "tests/run"
        or re.match(r"tests/hygiene/.*\.py$", path)
    )


def check_layout(sources):
    """Where files are, and which of them include which."""
    report(
        "has no place at the top",
        sorted(
            {name.split("/")[0] for name in tracked()}
            - {"LICENSE", "README.md", "CMakeLists.txt", "CMakePresets.json"}
            - {"lib", "theory", "analysis", "tests", "proofs-check", "examples"}
            - {name.split("/")[0] for name in tracked() if name.startswith(".")}
        ),
    )
    code = [path for path in tracked() if re.search(r"\.(cpp|hpp|py|v)$", path)]
    folders = [os.path.dirname(path) for path in code]
    report(
        f"more than {MOST_FILES} files of code in a folder",
        sorted({folder for folder in folders if folders.count(folder) > MOST_FILES}),
    )
    in_lib = [path for path in sources if path.startswith("lib/")]
    for place, folder in enumerate(ORDER):
        above = "|".join(ORDER[: place + 1])
        report(
            "includes a folder below its own",
            matches(
                r"#include [\"<]tensortopo/",
                [path for path in in_lib if path.startswith(f"lib/{folder}/")],
                rf"#include [\"<]tensortopo/({above})/|^lib/python/.*tensortopo/theory/",
            ),
        )
    report(
        "folder without a place in the order",
        (f.path for f in os.scandir("lib") if f.is_dir() and f.name not in [*ORDER, "cmake"]),
    )
    report(
        "includes by a way around", matches(r'#include "(\.\./|lib/|analysis/|tests/)', in_lib)
    )
    extract = [path for path in in_lib if path.startswith("lib/extract/")]
    headers = [path for path in extract if path.endswith(".hpp")]
    names = [os.path.basename(path) for path in headers]
    for path in extract:
        if not path.endswith(".cpp"):
            continue
        folder, stem = os.path.dirname(path), path.removesuffix(".cpp")
        public = f"{folder}/include/tensortopo/extract/{os.path.basename(stem)}.hpp"
        if (
            f"{stem}.hpp" not in headers
            and public not in headers
            and stem.removeprefix("lib/extract/") not in MEMBERS
        ):
            report("no header of its name", [path])
    # Private headers are named by their folder, so that a reader sees the direction of an include.
    report("an include without its folder", matches(r'#include "[^/"]+"', extract))
    report("two headers of one name", sorted({name for name in names if names.count(name) > 1}))


def check_libraries(sources):
    """Who may include which library, and call which function."""
    lib = [path for path in sources if re.match(r"lib/.*\.(hpp|cpp|h)$", path)]
    headers = [path for path in sources if re.search(r"\.(hpp|h)$", path)]
    report(
        "VTK outside lib/io and lib/vtk", matches("#include [<\"]vtk", lib, r"^lib/(io|vtk)/")
    )
    report(
        "VTK in a public header",
        matches("#include [<\"]vtk", [path for path in lib if path.startswith("lib/io/include/")]),
    )
    report(
        "a function or format that machines differ in; see lib/scalar",
        matches(
            r"std::(sin|cos|tan|asin|acos|atan|atan2|sinh|cosh|tanh|exp|exp2|expm1|log|log2|log10"
            r"|log1p|pow|cbrt|hypot)\b|\blong double\b",
            lib,
            r"^lib/scalar/(src/elementary/|"
            r"include/tensortopo/scalar/(elementary|(software_)?extended)\.hpp:)",
        ),
    )
    # The exception is the header that defines Interval.
    report(
        "CGAL in a header",
        matches(
            "#include [<\"]CGAL/", headers, r"^lib/scalar/include/tensortopo/scalar/interval\.hpp:"
        ),
    )
    report(
        "a checker that uses what it checks",
        matches("#include [<\"]tensortopo/", [p for p in sources if p.startswith("proofs-check/")]),
    )


def check_each_file(sources, pages):
    """Marks, guards, lengths."""
    cpp = [path for path in sources if re.search(r"\.(hpp|cpp|h)$", path)]
    headers = [path for path in cpp if not path.endswith(".cpp")]
    texts = [*sources, *pages, "CMakePresets.json"]
    report(
        "no SPDX header",
        (
            path
            for path in sources
            if not any("SPDX-License-Identifier: Apache-2.0" in line for line in lines(path)[:3])
        ),
    )
    for path in cpp:
        count = len(lines(path)) - 1
        if count > LONGEST_FILE:
            report("too long", [f"{path}: {count} lines"])
        elif count > LONG_FILE:
            print(f"note: {path}: {count} lines, look for a seam", file=sys.stderr)
    report(
        "no include guard",
        (path for path in headers if not any(x.startswith("#pragma once") for x in lines(path))),
    )
    report("using namespace in a header", matches(r"^\s*using namespace", headers))
    report("unfinished", matches(r"\b(TO" r"DO|FIX" r"ME|XX" r"X)\b", sources))
    report(
        "path of one machine",
        matches(r"(^|[^A-Za-z0-9_.}])/(wo" r"rk|ho" r"me|ro" r"ot|Us" r"ers)/", texts),
    )
    report(
        "package registry",
        matches(
            r"(py" r"pi|np" r"mjs|crates|rubygems|files\.pythonhosted|conan|vcpkg)\.(org|com|io)\b",
            texts,
        ),
    )


def check_tolerances(sources):
    """Small literals in lib have their reason above."""
    known = {tuple(line.split("|")[:2]) for line in TOLERANCES.split("\n")}
    literal = re.compile(r"(?<![A-Za-z0-9_.])[0-9]+\.?[0-9]*[eE]-[0-9]+")
    for path in sources:
        if not re.match(r"lib/.*\.(hpp|cpp|h)$", path):
            continue
        for number, line in enumerate(lines(path), 1):
            code = re.sub(r'"[^"]*"', "", line.split("//")[0])
            report(
                "tolerance without a reason in tests/hygiene/check_sources.py",
                (
                    f"{path}:{number}: {found}"
                    for found in literal.findall(code)
                    if (path, found) not in known
                ),
            )


def check_pages(pages, sources):
    """What pages name is there."""
    tests = "\n".join(
        "\n".join(lines(path)) for path in sources if re.match(r"tests/.*\.cpp$", path)
    )
    named = r"^(?:TEST|TEST_P|TEST_F|RC_GTEST_PROP)\((\w+),\s*(\w+)[,)]"
    written = {f"{suite}.{name}" for suite, name in re.findall(named, tests, re.M)}
    limits = "lib/extract/LIMITS.md"
    report(
        "names a test that is not there",
        sorted(set(re.findall(r"`([A-Z][A-Za-z]+\.[A-Z][A-Za-z]+)`", "\n".join(lines(limits)))) - written),
    )
    if len(lines("README.md")) - 1 > LONGEST_README:
        report(f"a page of more than {LONGEST_README} lines", ["README.md"])
    for page in pages:
        for target in re.findall(r"\]\(([^)#:]+)\)", "\n".join(lines(page))):
            if not os.path.exists(os.path.join(os.path.dirname(page), target)):
                report("links to what is not there", [f"{page}: {target}"])


def main():
    os.chdir(sys.argv[1])
    folders = [".ci", ".docs", "lib", "theory", "analysis", "proofs-check", "tests", "examples"]
    files = sorted(files_below(filter(os.path.isdir, folders)))
    sources = ["CMakeLists.txt", *filter(is_source, files)]
    pages = ["README.md", *(path for path in files if path.endswith(".md"))]
    if sum(path.startswith("lib/") for path in sources) < 20:
        sys.exit(f"found no sources in {sys.argv[1]}")
    check_layout(sources)
    check_libraries(sources)
    check_each_file(sources, pages)
    check_tolerances(sources)
    check_pages(pages, sources)
    report(
        "has appended data, which readers in use refuse; write it as inline binary",
        (
            path
            for path in tracked("examples/*.vt[uip]")
            if b"<AppendedData" in Path(path).read_bytes()
        ),
    )
    if offences:
        sys.exit(f"{offences} offences")
    print(f"{len(sources)} files")


main()

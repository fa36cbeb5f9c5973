# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""Fields in pieces, extracted piece after piece: time, memory, and totals of the surface.

streamed.py PROGRAM TETRAHEDRA:PIECES...: writes Kelvin's field in pieces, extracts and certifies mode 1/2 with
--stream, has the certificate checked with the field as one file, and prints the table of
lib/partition/SCALE.md. In a folder that is removed afterwards; 10^8 tetrahedra take 5 GB there, and 18 GB of
memory to check.
"""
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

COLUMNS = ["tetrahedra", "pieces", "triangles", "parts", "loops", "Euler", "area", "certificate, MB", "claims",
           "seconds", "peak, GB", "certified by check", "seconds of check", "peak of check, GB"]


def run(*words):
    """Standard output, seconds of processor and peak memory in GB of a program."""
    process = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    output = process.stdout.read()
    _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        sys.exit(f"{' '.join(words)} failed")
    return output, usage.ru_utime + usage.ru_stime, usage.ru_maxrss * 1024 / 1e9


def totals(output):
    """What `extract` says of the field, the surface and the certificate."""
    tets = re.search(r"(\d+) tetrahedra", output)[1]
    triangles, parts, loops, euler, area = re.search(
        r"^ +1/2 +\d+ +(\d+) +(\d+) +(\d+) +(-?\d+) +(\S+)", output, re.M).groups()
    size, claims = re.search(r"(\d+) bytes, (\d+) claims certified", output).groups()
    return tets, triangles, parts, loops, euler, area, int(size) / 1e6, claims


def main():
    print("| " + " | ".join(COLUMNS) + " |")
    print("|" + " --- |" * len(COLUMNS))
    for size in sys.argv[2:]:
        tets, pieces = size.split(":")
        with tempfile.TemporaryDirectory() as folder:
            field, whole, surface, certificate = (
                str(Path(folder, name)) for name in ("f.pvtu", "f.vtu", "s.vtp", "s.json"))
            run(sys.argv[1], "generate", "kelvin", "--tets", tets, "--pieces", pieces, "--field-only", "-o", field)
            output, seconds, peak = run(sys.argv[1], "extract", field, "--stream", "--mode", "1/2", "-o", surface,
                                        "--certify", certificate)
            run(sys.argv[1], "convert", field, "-o", whole)
            checked, check_seconds, check_peak = run(sys.argv[1], "check", whole, surface, certificate)
        certified = re.search(r"(\d+) certified, 0 refuted", checked)[1]
        tets, triangles, parts, loops, euler, area, megabytes, claims = totals(output)
        print(f"| {int(tets):,} | {pieces} | {int(triangles):,} | {parts} | {loops} | {euler} | {area} "
              f"| {megabytes:.1f} | {int(claims):,} | {seconds:.0f} | {peak:.2f} "
              f"| {int(certified):,} | {check_seconds:.0f} | {check_peak:.2f} |")


if __name__ == "__main__":
    main()

# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""check_reports.py PROGRAM SCHEMAS DATA: every kind of JSON report follows its schema.

Runs the program so that each kind of report is written with and without what is optional in it,
and validates what it prints against SCHEMAS/NAME.json. A key that a schema does not know, or does
not describe, is a failure, as is a schema that no report was compared with.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

import jsonschema


def undescribed(schema, path=""):
    """Paths of properties without a description."""
    found = []
    for key, value in schema.get("properties", {}).items():
        if not value.get("description"):
            found.append(f"{path}/{key}")
        found += undescribed(value, f"{path}/{key}")
    for key in ("items", "additionalProperties"):
        if isinstance(schema.get(key), dict):
            found += undescribed(schema[key], f"{path}/{key}")
    return found


def main():
    program, schemas, data = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    slab = str((data / "s4_slab_small_C3D8I.vtu").resolve())
    failures = []
    compared = dict.fromkeys(sorted(p.stem for p in schemas.glob("*.json")), 0)
    known = {name: json.loads((schemas / f"{name}.json").read_text()) for name in compared}
    for name, schema in known.items():
        jsonschema.Draft202012Validator.check_schema(schema)
        failures += [f"{name}{path}: no description" for path in undescribed(schema)]

    with tempfile.TemporaryDirectory() as folder:

        def run(*words, statuses=(0, 1)):
            done = subprocess.run([program, *words, "--json"], cwd=folder, capture_output=True,
                                  text=True, check=False)
            if done.returncode not in statuses:
                failures.append(f"{' '.join(words)}: exit status {done.returncode}: {done.stderr}")
                return
            report = json.loads(done.stdout)
            name = report["schema"]["name"]
            if name not in known:  # of a subcommand whose report has a page of its own
                return
            compared[name] += 1
            for error in jsonschema.Draft202012Validator(known[name]).iter_errors(report):
                where = "/".join(str(part) for part in error.absolute_path)
                failures.append(f"{' '.join(words)}: {name}/{where}: {error.message}")

        run("generate", "linear", "-o", "g.vtu")
        run("generate", "complex", "-o", "k.vtu", "--seed", "4", "--mode", "1/2")
        run("generate", "nongeneric", "-o", "n.vtu", "--count", "8", "--field-only")
        run("generate", "kelvin", "-o", "e.vtu", "--field-only", "--count", "2", "--together")
        run("extract", slab, "-o", "s.vtp", "--mode", "1/2", "--mode", "-1", "--generalized")
        run("extract", slab, "-o", "s.vtp", "--mode", "1/2", "--certify", "s.json")
        run("extract", slab, "-o", "p.vtp", "--mode", "1/2", "--memory", "2GiB")
        run("check", slab, "s.vtp", "s.json")
        (pathlib.Path(folder) / "isotropic.vtk").write_text(
            "# vtk DataFile Version 3.0\nisotropic vertex\nASCII\nDATASET UNSTRUCTURED_GRID\n"
            "POINTS 4 double\n0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n"
            "POINT_DATA 4\nFIELD f 1\nstress 6 4 double\n200 200 200 0 0 0\n"
            "-160 660 -500 -380 -480 140\n-160 360 -200 -180 400 300\n476 -876 400 -532 20 140\n")
        run("extract", "isotropic.vtk", "-o", "t.vtp", "--mode", "4/5", "--strict")
        # Two tetrahedra whose faces lie on each other, without sharing vertices; one is isotropic.
        (pathlib.Path(folder) / "torn.vtk").write_text(
            "# vtk DataFile Version 3.0\ntorn\nASCII\nDATASET UNSTRUCTURED_GRID\n"
            "POINTS 8 double\n0 0 0 1 0 0 0 1 0 0 0 1 0 0 0 1 0 0 0 1 0 0 0 -1\n"
            "CELLS 2 10\n4 0 1 2 3 4 4 6 5 7\nCELL_TYPES 2\n10 10\n"
            "POINT_DATA 8\nFIELD f 1\nstress 6 8 double\n200 200 200 0 0 0\n"
            "-160 660 -500 -380 -480 140\n-160 360 -200 -180 400 300\n476 -876 400 -532 20 140\n"
            + "7 7 7 0 0 0\n" * 4)
        for name in ("isotropic.vtk", "torn.vtk"):
            run("extract", name, "-o", "t.vtp", "--mode", "1/2", "--mode", "1")
            run("extract", name, "-o", "t.vtp", "--invariant", "magnitude", "--value", "350")
            run("analyze", name, "--sweep=-1:1:5")
            run("analyze", name, "--persistence")
            run("analyze", name, "--graph")
            run("report", name, "-o", "t.html", "--mode", "1/2")
            run("convert", name, "-o", "t.vtu")
        run("extract", slab, "-o", "u.vtp", "--mode", "1/2", "--uncertainty", "1%")
        run("extract", slab, "-o", "u.vtp", "--mode", "1/2", "--mode", "1", "--min-persistence", "0.02")
        run("extract", slab, "-o", "u.vtp", "--mode", "1/2", "--mode", "1", "--min-area", "5",
            "--min-length", "2", "--where", "z > 1")
        run("extract", slab, "-o", "c.vtp", "--mode", "1", "--certify", "c.json")
        run("extract", "k.vtu", "-o", "m.vtp", "--mode", "1/2", "--max-error", "0.5")
        run("extract", "k.vtu", "-o", "b.vtp", "--mode", "1/2", "--method", "marching")
        run("extract", "k.vtu", "-o", "s.vtp", "--mode", "1/2")
        for number in range(8):
            run("extract", f"n-{number:04}.vtu", "-o", "n.vtp", "--mode", "0")
            run("extract", f"n-{number:04}.vtu", "-o", "n.vtp", "--mode", "1")
            run("analyze", f"n-{number:04}.vtu", "--sweep=-1:1:5")
        run("extract", "k.vtu", "-o", "i.vtp", "--invariant", "magnitude", "--value", "2")
        run("extract", "k.vtu", "-o", "i.vtp", "--invariant", "anisotropy", "--value", "9/10",
            "--certify", "i.json")
        run("convert", "k.vtu", "-o", "copy.vtu")
        (pathlib.Path(folder) / "series.pvd").write_text(
            '<VTKFile type="Collection"><Collection><DataSet timestep="0" file="k.vtu"/>'
            '<DataSet timestep="1" file="copy.vtu"/></Collection></VTKFile>')
        run("extract", "series.pvd", "-o", "series_{step}.vtp", "--mode", "1/2")
        run("render", "k.vtu", "-o", "p.png", "--size", "32x32", "--mode", "1/2")
        run("render", "k.vtu", "-o", "p.png", "--size", "32x32", "--animate", "0:0.5:2")
        run("render", "k.vtu", "-o", "p.png", "--mode", "1/2", "--tet", "any", "--direction", "1,0,0",
            "--size", "96x96")
        run("render", "k.vtu", "-o", "p.png", "--size", "32x32", "--invariant", "magnitude",
            "--value", "2")
        run("conformance", "--surface", "k.reference.vtp", "--input", "k.vtu", "--mode", "1/2",
            "--truth", "k.truth.json")
        run("conformance", "--surface", "b.vtp", "--input", "k.vtu", "--mode", "1/2")
        suite = {"suite": [{"kind": "linear", "modes": ["0", "1/2"], "count": 2}]}
        (pathlib.Path(folder) / "suite.json").write_text(json.dumps(suite))
        run("conformance", "--suite", "suite.json")
        run("analyze", "s.vtp")
        run("analyze", "s.vtp", "--mesh", "k.vtu", "--smooth", "--recover", "--against", "b.vtp",
            "--ridges", "r.vtp", "-o", "a.vtp")
        run("analyze", "k.vtu", "--sweep", "0:0.3:3")
        run("analyze", "k.vtu", "--persistence")
        run("analyze", "k.vtu", "--graph")
        run("analyze", "k.vtu", "--graph", "-o", "tree.vtp")
        run("analyze", "k.vtu", "--persistence", "-o", "pairs.vtp", "--chart", "p.png")
        run("analyze", "k.vtu", "--sweep", "0.2:0.3:2", "--check", "2", "-o", "d.png")
        run("check", slab, "s.vtp", "s.json")  # refuted: the surface is another one by now
        run("check", slab, "c.vtp", "c.json", "--expect-mode", "1/2")
        run("verify", "--fields", "2")
        run("verify", "--input", "k.vtu", "--fields", "5", "--theorem", "mode-range")
        run("proofs")
        run("report", "k.vtu", "-o", "p.html", "--mode", "1/2", "--no-sweep")
        run("report", "g.vtu", "-o", "q.html", "--mode", "1/2", "--no-certificate")
        run("report", "k.vtu", "-o", "p.html", "--mode", "1/2", "--no-sweep", "--uncertainty", "1%")
        run("bench", "--input", "g.vtu", "--mode", "1/2")
        run("bench", "--input", "g.vtu", "--mode", "0", "--only", "errors")
        run("bench", "--input", "g.vtu", "--scaling", "mode")

        # ParaView 5.11 with a recent expat reads no appended data, and shows such files as empty.
        written = [p for p in pathlib.Path(folder).iterdir() if p.suffix in (".vtp", ".vtu")]
        failures += [f"{p.name} has appended data" for p in written if b"<AppendedData" in p.read_bytes()]
        if not {"a.vtp", "r.vtp", "tree.vtp", "pairs.vtp", "s.vtp", "k.vtu"} <= {p.name for p in written}:
            failures.append("files of analyses were not written")

    failures += [f"no report was compared with {name}.json" for name, n in compared.items() if n == 0]
    print(", ".join(f"{name} {count}" for name, count in compared.items()))
    for failure in failures:
        print(failure)
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()

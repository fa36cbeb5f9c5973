# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""Surfaces in parts on MPI: the parts are the whole surface, and their certificates are certified; forgeries are not."""
import hashlib
import importlib.util
import json
import os
import shutil
import textwrap

import numpy as np
import pytest
from conftest import tried
from test_mpi import mpirun, write_pieces

import tensortopo as tt
from tensortopo._parts import certificate_of_parts  # pylint: disable=protected-access
from tensortopo._vtk_xml import piece_text, read_piece

pytestmark = pytest.mark.skipif(
    shutil.which("mpirun") is None or importlib.util.find_spec("mpi4py") is None,
    reason="needs mpirun and mpi4py",
)


def owners(field, parts, kind, axis=0):
    """At random, or slabs across an axis."""
    if kind == "random":
        return np.random.default_rng(11).integers(0, parts, len(field.tets))
    x = field.points[field.tets].mean(axis=1)[:, axis]
    return np.searchsorted(np.quantile(x, np.arange(1, parts) / parts), x)


def extract(folder, mode, ranks=2, certify=True):
    words = ["--certify", folder / "surface.json"] if certify else []
    done = mpirun(ranks, folder / "field.pvtu", "-o", folder / "surface.pvtp", "--mode", mode, *words)
    assert done.returncode == 0, done.stderr


def corners(points, triangles):
    """Triangles by the bits of their corners, each from its smallest, in order."""
    rows = np.asarray(points)[np.asarray(triangles)]
    listed = []
    for row in rows:
        turns = [tuple(np.roll(row, -k, axis=0).ravel()) for k in range(3)]
        listed.append(min(turns))
    return sorted(listed)


def part_of(path):
    piece = read_piece(path)
    triangles = piece.sections["Polys"]["connectivity"].values.reshape(-1, 3)
    points = next(iter(piece.sections["Points"].values())).values.reshape(-1, 3)
    return points, triangles, piece.sections


@pytest.mark.parametrize("mode, parts, kind", tried([("1/2", 5, "random"), ("1/2", 2, "slabs"),
                                                     ("99/100", 3, "slabs"), ("99/100", 4, "random")]))  # fmt: skip
def test_parts_are_the_whole_surface_and_certified(slab, program, tmp_path, mode, parts, kind):
    files = write_pieces(slab, owners(slab, parts, kind), tmp_path)
    extract(tmp_path, mode)
    program("convert", tmp_path / "field.pvtu", "-o", tmp_path / "whole.vtu", "--quiet")
    program("extract", tmp_path / "whole.vtu", "-o", tmp_path / "whole.vtp", "--mode", mode, "--quiet")
    points, triangles, whole = part_of(tmp_path / "whole.vtp")
    all_triangles, numbers = [], {}
    of_whole = dict(zip(map(tuple, points[triangles].reshape(-1, 9)), whole["CellData"]["component"].values))
    for k, file in enumerate(files):
        surface = tmp_path / "surface" / f"surface_{k}.vtp"
        verdict = tt.check(file, surface, surface.with_suffix(".json"), expect_complete=True)
        assert verdict, verdict.text
        own_points, own_triangles, sections = part_of(surface)
        all_triangles += corners(own_points, own_triangles)
        numbered = sections["CellData"]["whole_component"].values
        for row, number in zip(own_points[own_triangles].reshape(-1, 9), numbered):
            numbers.setdefault(number, set()).add(of_whole.get(tuple(row)))
    assert sorted(all_triangles) == corners(points, triangles)
    assert all(found == {number} for number, found in numbers.items())
    for check in (tt.check, program_check(program)):
        assert check(tmp_path / "field.pvtu", tmp_path / "surface.pvtp", tmp_path / "surface.json")
    claims = json.loads((tmp_path / "surface.json").read_text())["whole"]
    assert claims["triangles"] == len(triangles) and claims["vertices"] == len(points)
    assert claims["components"] == whole["CellData"]["component"].values.max() + 1


def program_check(program):
    return lambda *files: "certified:" in program("check", *files, "--expect-complete")


def test_files_do_not_depend_on_the_ranks(corner, tmp_path):
    made = []
    for ranks in (1, 4):  # one of four has no piece
        folder = tmp_path / str(ranks)
        folder.mkdir()
        write_pieces(corner, owners(corner, 3, "slabs"), folder)
        extract(folder, "1/2", ranks)
        extract(folder, "1/2", ranks)  # takes the place of what is there
        names = sorted(p.relative_to(folder) for p in folder.rglob("*"))
        made.append({name: (folder / name).read_bytes() for name in names if (folder / name).is_file()})
    assert made[0] == made[1]
    assert not [name for name in made[0] if name.name.startswith(".")]


def test_vtk_opens_parts_also_those_without_triangles(slab, tmp_path):
    # One part is a single cell that the level does not meet.
    surface = slab.mode_surface("99/100")
    empty = np.setdiff1d(np.arange(len(slab.tets)), surface.cell_ids)[0]
    owner = owners(slab, 2, "slabs")
    owner[empty] = 2
    write_pieces(slab, owner, tmp_path)
    extract(tmp_path, "99/100")
    assert len(part_of(tmp_path / "surface" / "surface_2.vtp")[1]) == 0
    verdict = tt.check(tmp_path / "field.pvtu", tmp_path / "surface.pvtp", tmp_path / "surface.json")
    assert verdict, verdict.text
    vtk = pytest.importorskip("vtkmodules.vtkIOXML")
    reader = vtk.vtkXMLPPolyDataReader()
    reader.SetFileName(str(tmp_path / "surface.pvtp"))
    reader.Update()
    data = reader.GetOutput()
    assert data.GetNumberOfPolys() == len(surface.triangles)
    of_points, of_cells = data.GetPointData(), data.GetCellData()
    assert {of_points.GetArrayName(i) for i in range(of_points.GetNumberOfArrays())} == {
        "mode", "medium_eigenvector", "dominant_eigenvector", "whole_normal", "residual"}  # fmt: skip
    assert {of_cells.GetArrayName(i) for i in range(of_cells.GetNumberOfArrays())} == {
        "tet", "component", "whole_component"}  # fmt: skip


def refused(folder, text, ranks=2, script=("-m", "tensortopo.mpi"), output="surface.pvtp"):
    before = {p: p.stat().st_mtime_ns for p in folder.rglob("*") if p.is_file()}
    done = mpirun(ranks, folder / "field.pvtu", "-o", folder / output, "--mode", "1/2", "--certify",
                  folder / "surface.json", python=script)  # fmt: skip
    assert done.returncode != 0
    assert text in done.stderr, done.stderr
    assert {p: p.stat().st_mtime_ns for p in folder.rglob("*") if p.is_file()} == before
    assert not list(folder.glob(".tensortopo-*"))


def failing(folder, action):
    """A driver of which a rank fails while parts are written."""
    script = folder / "failing.py"
    script.write_text(textwrap.dedent(f"""
        import os, signal, sys
        from mpi4py import MPI
        import tensortopo._ranks_parts as parts
        import tensortopo.mpi as driver
        def fail(*args):
            {action}
        if MPI.COMM_WORLD.rank == 1:
            parts.part_surface = fail
        sys.exit(driver.main())
    """))
    return (str(script),)


def test_what_fails_leaves_no_file(corner, tmp_path):
    write_pieces(corner, owners(corner, 3, "slabs"), tmp_path)
    script = failing(tmp_path, 'raise ValueError("on purpose")')
    refused(tmp_path, "on purpose", script=script)
    (tmp_path / "surface").mkdir()
    (tmp_path / "surface" / "notes.txt").write_text("mine")
    refused(tmp_path, "notes.txt, which is no part of a surface")
    shutil.rmtree(tmp_path / "surface")
    refused(tmp_path, "must end in .vtp or .pvtp", output="surface.vtk")
    done = mpirun(2, tmp_path / "piece0.vtu", tmp_path / "piece1.vtu", tmp_path / "piece2.vtu", "-o",
                  tmp_path / "surface.pvtp", "--mode", "1/2", "--certify", tmp_path / "s.json")  # fmt: skip
    assert done.returncode != 0 and "is about a .pvtu" in done.stderr
    assert not (tmp_path / "surface").exists() and not (tmp_path / "surface.pvtp").exists()


def test_a_lost_rank_leaves_no_output(corner, tmp_path):
    write_pieces(corner, owners(corner, 3, "slabs"), tmp_path)
    script = failing(tmp_path, "os.kill(os.getpid(), signal.SIGKILL)")
    done = mpirun(2, tmp_path / "field.pvtu", "-o", tmp_path / "surface.pvtp", "--mode", "1/2",
                  python=script)  # fmt: skip
    assert done.returncode != 0
    assert not [p for p in tmp_path.iterdir() if p.name.startswith("surface")]


# ---- forgeries: files are altered, and all hashes are made right again ----


class Parts:
    """A surface in parts that a forger alters."""

    def __init__(self, folder):
        self.folder = folder
        self.document = json.loads((folder / "surface.json").read_text())

    def path(self, part, role):
        return self.folder / self.document["parts"][part][role]["file"]

    def certificate(self, part):
        return json.loads(self.path(part, "certificate").read_text())

    def write_surface(self, part, points, triangles, sections):
        """The part's .vtp anew, with hashes in its certificate."""
        n = len(triangles)
        arrays = {name: {k: v.values for k, v in sections[name].items()} for name in ("PointData", "CellData")}
        counts = {"NumberOfPoints": len(points), "NumberOfVerts": 0, "NumberOfPolys": n}
        polys = {"connectivity": triangles.astype(np.int64).ravel(),
                 "offsets": np.arange(3, 3 * n + 1, 3, dtype=np.int64)}  # fmt: skip
        text = piece_text("PolyData", counts, {**arrays, "Points": {"Points": points}, "Polys": polys})
        self.path(part, "surface").write_text(text)
        certificate = self.certificate(part)
        numbers = hashlib.sha256(np.int64(len(points)).tobytes())
        numbers.update(np.asarray(points, "<f8").tobytes())
        for values in ([n], triangles, arrays["CellData"]["tet"]):
            numbers.update(np.ascontiguousarray(values, "<i8").tobytes())
        certificate["surface"].update(sha256=numbers.hexdigest(), triangles=n, vertices=len(points))
        for entry in certificate["surface"]["arrays"]:
            values = arrays["PointData" if entry[0] == "points" else "CellData"][entry[1]]
            entry[3] = hashlib.sha256(np.ascontiguousarray(values, "<f8").tobytes()).hexdigest()
        self.path(part, "certificate").write_text(json.dumps(certificate))

    def replace(self, part, field):
        """Another field in the place of a part's, with its own surface and certificate."""
        surface = field.mode_surface("1/2", certify=True)
        tt.write(self.path(part, "input"), field)
        tt.write(self.path(part, "surface"), surface)
        self.path(part, "certificate").write_bytes(surface.certificate)

    def finish(self, **claims):
        """Hashes of all files, and claims of the whole."""
        self.document["whole"].update(claims)
        listed = [
            {role: (part[role]["file"], hashlib.sha256(self.path(k, role).read_bytes()).hexdigest())
             for role in ("input", "surface", "certificate")}
            for k, part in enumerate(self.document["parts"])
        ]  # fmt: skip
        data = certificate_of_parts(self.document["mode"], listed, self.document["whole"])
        (self.folder / "surface.json").write_bytes(data)

    def name_pieces(self):
        """The .pvtu and the .pvtp name the parts that the certificate names."""
        for name, role in (("field.pvtu", "input"), ("surface.pvtp", "surface")):
            lines = (self.folder / name).read_text().splitlines()
            at = next(i for i, line in enumerate(lines) if line.startswith("<Piece "))
            rest = [line for line in lines if not line.startswith("<Piece ")]
            rest[at:at] = [f'<Piece Source="{part[role]["file"]}"/>' for part in self.document["parts"]]
            (self.folder / name).write_text("\n".join(rest))

    def verdict(self):
        return tt.check(*(self.folder / name for name in ("field.pvtu", "surface.pvtp", "surface.json")))

    def is_refuted(self, text):
        verdict = self.verdict()
        assert verdict.status == "refuted", verdict.text
        found = [f"{f.entity}: claimed {f.claimed}; derived {f.derived}" for f in verdict.refutations]
        assert any(text in line for line in found), found


@pytest.fixture(scope="module")
def honest(corner, tmp_path_factory):
    folder = tmp_path_factory.mktemp("honest")
    write_pieces(corner, owners(corner, 3, "slabs", axis=1), folder)
    extract(folder, "1/2")
    return folder


@pytest.fixture
def parts(honest, tmp_path):
    shutil.copytree(honest, tmp_path / "forged")
    return Parts(tmp_path / "forged")


def seam_places(parts, a, b):
    """Places that the meshes of two parts have in common."""
    points = [{tuple(p) for p in tt.read(parts.path(k, "input")).points} for k in (a, b)]
    return points[0] & points[1]


def test_honest_parts_are_certified_and_hashes_can_be_made_again(parts):
    parts.finish()
    assert parts.verdict()


@pytest.mark.parametrize("key", ["tetrahedra", "vertices", "triangles", "components",
                                 "euler_characteristic", "boundary_loops"])  # fmt: skip
def test_a_wrong_number_of_the_whole(parts, key):
    parts.finish(**{key: parts.document["whole"][key] + 1})
    parts.is_refuted(f"whole, {key}")


def test_altered_files_without_repair(parts):
    path = parts.path(1, "certificate")
    path.write_text(path.read_text() + " ")
    parts.is_refuted("part 1's certificate's sha256")


def test_a_missing_part(parts):
    del parts.document["parts"][1]
    parts.finish()
    parts.is_refuted("pieces of the field: claimed 2; derived 3")
    parts.name_pieces()
    parts.is_refuted("whole, tetrahedra")


def test_a_part_twice(parts):
    first = parts.document["parts"][0]
    again = {role: {"file": f"again{os.path.splitext(first[role]['file'])[1]}"} for role in first}
    for role in first:
        shutil.copy(parts.folder / first[role]["file"], parts.folder / again[role]["file"])
    parts.document["parts"].append(again)
    parts.name_pieces()
    parts.finish()
    parts.is_refuted("one file twice")
    parts.document["parts"][3] = first
    parts.name_pieces()
    parts.finish()
    with pytest.raises(tt.FileError, match="names piece0.vtu twice"):
        parts.verdict()


def test_swapped_parts(parts):
    parts.document["parts"].reverse()
    parts.finish()
    parts.is_refuted("part 0's field: claimed piece2.vtu; derived piece0.vtu")


def test_surfaces_of_parts_swapped(parts):
    a, b = parts.document["parts"][0], parts.document["parts"][2]
    a["surface"], b["surface"] = b["surface"], a["surface"]
    a["certificate"], b["certificate"] = b["certificate"], a["certificate"]
    parts.name_pieces()
    parts.finish()
    parts.is_refuted("part 0, input's sha256")


def test_a_part_of_another_mesh(parts, slab):
    field = tt.read(parts.path(2, "input"))
    moved = tt.Field(field.points * 2.0 + 7.0, field.tensors, field.tets)
    parts.replace(2, moved)
    parts.finish()
    parts.is_refuted("whole, ")


def test_a_changed_tensor_at_the_seam(parts):
    places = seam_places(parts, 1, 2)
    field = tt.read(parts.path(2, "input"))
    tensors = field.tensors.copy()
    at = next(i for i, p in enumerate(field.points) if tuple(p) in places)
    tensors[at, 0] = np.nextafter(tensors[at, 0], np.inf)
    changed = tt.Field(field.points, tensors, field.tets)
    parts.replace(2, changed)
    parts.finish()
    parts.is_refuted("one tensor; derived different tensors in parts 1 and 2")


def border_vertices(triangles):
    sides = {(t[i], t[(i + 1) % 3]) for t in triangles.tolist() for i in range(3)}
    return {a for a, b in sides if (b, a) not in sides}


def common_vertices(parts, a, b):
    """Vertices of part a's surface that part b's has, too."""
    own, triangles, sections = part_of(parts.path(a, "surface"))
    other = {tuple(p) for p in part_of(parts.path(b, "surface"))[0]}
    return own, triangles, sections, [v for v in sorted(border_vertices(triangles)) if tuple(own[v]) in other]


def test_a_vertex_on_the_seam_moved_by_a_bit(parts):
    points, triangles, sections, common = common_vertices(parts, 2, 1)
    points = points.copy()
    axis = int(np.argmax(np.abs(points[common[0]])))
    points[common[0], axis] = np.nextafter(points[common[0], axis], np.inf)
    parts.write_surface(2, points, triangles, sections)
    own = tt.check(parts.path(2, "input"), parts.path(2, "surface"), parts.path(2, "certificate"))
    parts.finish()
    # Within rounding the part alone cannot tell.
    parts.is_refuted("the same edges of triangles on both sides" if own.refuted == 0 else "part 2, ")


def test_a_lost_triangle_beside_the_seam(parts):
    points, triangles, sections, common = common_vertices(parts, 2, 1)
    component = sections["CellData"]["component"].values
    beside = next(t for t, row in enumerate(triangles.tolist())
                  if len(set(row) & set(common)) == 2 and component[t] in component[:t])  # fmt: skip
    kept = np.delete(np.arange(len(triangles)), beside)
    for array in sections["CellData"].values():
        array.values = array.values[kept]
    parts.write_surface(2, points, triangles[kept], sections)
    certificate = parts.certificate(2)
    certificate["levels"][0]["triangles"][1] -= 1
    parts.path(2, "certificate").write_text(json.dumps(certificate))
    parts.finish(triangles=parts.document["whole"]["triangles"] - 1)
    parts.is_refuted("part 2, mode 1/2, ")


def test_numbers_of_components_that_do_not_fit(parts):
    points, triangles, sections = part_of(parts.path(0, "surface"))
    array = sections["CellData"]["whole_component"]
    array.values = array.values.copy()
    array.values[array.values == array.values[0]] = parts.document["whole"]["components"] + 3
    parts.write_surface(0, points, triangles, sections)
    parts.finish()
    parts.is_refuted("whole_component")


def test_components_of_another_shape(parts):
    points, triangles, sections = part_of(parts.path(0, "surface"))
    array = sections["CellData"].pop("whole_component")
    own = parts.certificate(0)["surface"]["arrays"]
    for of, values in (("triangles", np.tile(array.values[:, None], 3)), ("points", np.zeros(len(points)))):
        certificate = parts.certificate(0)
        listed = [entry for entry in own if entry[1] != "whole_component"]
        listed.append([of, "whole_component", 3 if of == "triangles" else 1, ""])
        certificate["surface"]["arrays"] = sorted(listed)
        parts.path(0, "certificate").write_text(json.dumps(certificate))
        again = {name: dict(section) for name, section in sections.items()}
        again["CellData" if of == "triangles" else "PointData"]["whole_component"] = type(array)(values)
        parts.write_surface(0, points, triangles, again)
        parts.finish()
        parts.is_refuted("part 0's whole_component")


@pytest.mark.parametrize("name", ["../{}", "/{}", "./{}", "below/../{}", "below//{}"])
def test_names_that_are_elsewhere(parts, name):
    (parts.folder / "below").mkdir()
    for role, file in (("input", "field.pvtu"), ("surface", "surface.pvtp"), ("certificate", "surface.json")):
        first = parts.document["parts"][0][role]["file"]
        parts.document["parts"][0][role]["file"] = name.format(first)
        parts.name_pieces()
        (parts.folder / "surface.json").write_text(json.dumps(parts.document))
        with pytest.raises(tt.FileError, match=f"{file}: names .*, which is not beside it"):
            parts.verdict()
        parts.document["parts"][0][role]["file"] = first


def test_names_of_certified_parts_are_beside(corner, tmp_path):
    (tmp_path / "a").mkdir()
    (tmp_path / "b").mkdir()
    write_pieces(corner, owners(corner, 2, "slabs"), tmp_path / "a")
    words = ["-o", tmp_path / "a" / "surface.pvtp", "--mode", "1/2", "--certify"]
    done = mpirun(1, tmp_path / "a" / "field.pvtu", *words, tmp_path / "b" / "surface.json")
    assert done.returncode == 3 and "names ../a/surface, which a certificate" in done.stderr
    text = (tmp_path / "a" / "field.pvtu").read_text()
    (tmp_path / "b" / "field.pvtu").write_text(text.replace('Source="', 'Source="../a/'))
    done = mpirun(1, tmp_path / "b" / "field.pvtu", *words, tmp_path / "a" / "surface.json")
    assert done.returncode == 3 and "names ../a/piece0.vtu, which a certificate" in done.stderr
    assert not (tmp_path / "a" / "surface").exists()
    done = mpirun(1, tmp_path / "b" / "field.pvtu", *words[:-1])  # without a certificate VTK's names will do
    assert done.returncode == 0, done.stderr
    done = mpirun(1, tmp_path / "a" / "field.pvtu", *words, tmp_path / "surface.json")  # above the parts
    assert done.returncode == 0, done.stderr
    assert tt.check(tmp_path / "a" / "field.pvtu", tmp_path / "a" / "surface.pvtp", tmp_path / "surface.json")


def test_a_document_that_is_none(parts):
    data = (parts.folder / "surface.json").read_text()
    for old, new, text in (("of parts", "of part", "no certificate of parts"), ('"mode"', '"mood"', "mode"),
                           ('"1/2"', '"2/4"', "lowest terms")):  # fmt: skip
        (parts.folder / "surface.json").write_text(data.replace(old, new, 1))
        with pytest.raises(tt.FileError, match=text):
            parts.verdict()
    (parts.folder / "surface.json").write_text(data)
    with pytest.raises(tt.FileError, match="is a certificate of parts"):
        tt.check(parts.path(0, "input"), parts.path(0, "surface"), parts.folder / "surface.json")
    with pytest.raises(tt.FileError, match="is no certificate of parts"):
        tt.check(parts.folder / "field.pvtu", parts.folder / "surface.pvtp", parts.path(0, "certificate"))
    (parts.folder / "surface.pvtp").write_text("<VTKFile/>")
    with pytest.raises(tt.FileError, match="surface.pvtp: is no VTK file of type PPolyData"):
        parts.verdict()

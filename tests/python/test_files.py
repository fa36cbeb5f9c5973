# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""Reading and writing."""
import base64
import sys
import zlib
from types import SimpleNamespace

import numpy as np
import pytest

import tensortopo as tt


def test_fields_come_back_bit_for_bit(data, tmp_path):
    files = sorted(data.glob("*.vtu"))
    assert len(files) == 4
    for file in files:
        field = tt.read(file)
        tt.write(tmp_path / "f.vtu", field)
        again = tt.read(tmp_path / "f.vtu")
        assert again.sha256 == field.sha256 and again.tensor_name == field.tensor_name
        assert len(field.tets) > 100


def array(name, kind, values, form, width, compress):
    dtype = {"Float64": "<f8", "Float32": "<f4", "Int64": "<i8", "Int32": "<i4", "UInt8": "u1"}[kind]
    data = np.asarray(values).astype(dtype).tobytes()
    if form == "ascii":
        text = " ".join(repr(x) for x in np.asarray(values).astype(dtype).ravel().tolist())
    elif compress:
        packed = zlib.compress(data)
        head = np.array([1, len(data), 0, len(packed)], "<u4").tobytes()
        text = (base64.b64encode(head) + base64.b64encode(packed)).decode()
    else:
        text = base64.b64encode(np.array([len(data)], "<u4").tobytes() + data).decode()
    return (f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{width}" '
            f'format="{form}">\n{text}\n</DataArray>')  # fmt: skip


def vtu(tetrahedron, form="ascii", compress=False, types=(10,), extra=""):
    points, tensors, tets = tetrahedron
    compressor = ' compressor="vtkZLibDataCompressor"' if compress else ""

    def make(*args):
        return array(*args, compress)

    return f"""<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian"{compressor}>
<UnstructuredGrid><Piece NumberOfPoints="4" NumberOfCells="{len(types)}">
<PointData>{make("T", "Float32", tensors, form, 6)}{extra}</PointData>
<Points>{make("Points", "Float64", points, form, 3)}</Points>
<Cells>{make("connectivity", "Int32", np.ravel(tets), form, 1)}
{make("offsets", "Int64", [4 * (i + 1) for i in range(len(types))], form, 1)}
{make("types", "UInt8", types, form, 1)}</Cells>
</Piece></UnstructuredGrid></VTKFile>"""


@pytest.mark.parametrize("form, compress", [("ascii", False), ("binary", False), ("binary", True)])
def test_encodings(tetrahedron, tmp_path, form, compress):
    file = tmp_path / "f.vtu"
    file.write_text(vtu(tetrahedron, form, compress))
    assert tt.read(file).sha256 == tt.Field(*tetrahedron).sha256


def test_every_truncation_is_a_file_error(tetrahedron, tmp_path):
    whole = vtu(tetrahedron, "binary", True)
    file = tmp_path / "f.vtu"
    cuts = range(0, len(whole) - 10, 37)
    for cut in cuts:
        file.write_text(whole[:cut])
        with pytest.raises(tt.FileError, match="f.vtu"):
            tt.read(file)
    assert len(cuts) > 20


def test_what_a_file_says_is_obeyed_or_refused(tetrahedron, tmp_path):
    file = tmp_path / "f.vtu"
    text = vtu(tetrahedron)
    names = " ".join(f'ComponentName{i}="S{c}"' for i, c in enumerate(("xx", "yy", "zz", "yz", "xz", "xy")))
    file.write_text(text.replace('Name="T"', f'Name="T" {names}'))
    points, tensors, tets = tetrahedron
    assert tt.read(file).sha256 == tt.Field(points, tensors, tets, "voigt").sha256
    with pytest.raises(tt.FileError, match="voigt"):
        tt.read(file, components="vtk")
    digits = names.translate(str.maketrans("xyz", "123"))
    file.write_text(text.replace('Name="T"', f'Name="T" {digits}'))
    assert tt.read(file).sha256 == tt.Field(points, tensors, tets, "voigt").sha256
    # What the program refuses is refused here, too, whatever is asked for.
    for spelled, message in (("ZZ XX YY YZ XZ XY", "not supported"), ("XX XX ZZ XY YZ XZ", "alike"),
                             ("0 1 2 3 4 5", "says no order"), ("a b c d e f", "says no order")):
        labels = " ".join(f'ComponentName{i}="{c}"' for i, c in enumerate(spelled.split()))
        file.write_text(text.replace('Name="T"', f'Name="T" {labels}'))
        with pytest.raises(tt.FileError, match=message):
            tt.read(file)
        if message == "says no order":
            assert tt.read(file, components="fsl").sha256 == tt.Field(points, tensors, tets, "fsl").sha256
        else:
            with pytest.raises(tt.FileError, match=message):
                tt.read(file, components="vtk")
    file.write_text(text.replace('Name="T"', 'Name="T" ComponentName0="XX"'))
    with pytest.raises(tt.FileError, match="says no order"):
        tt.read(file)
    file.write_text(text)
    assert tt.read(file, components="fsl").sha256 == tt.Field(points, tensors, tets, "fsl").sha256
    with pytest.raises(tt.FileError, match="no point array"):
        tt.read(file, tensor="S")


@pytest.mark.parametrize(
    "old, new, message",
    [
        ('type="UnstructuredGrid" v', 'type="PolyData" v', "pieces"),
        ("vtkZLibDataCompressor", "vtkLZ4DataCompressor", "vtkLZ4DataCompressor"),
        ("<Points>", "<Points><Other/>", None),
        ("</Piece>", "</Piece><Piece/>", "2 pieces"),
        ("VTKFile", "OtherFile", "no VTK file"),
    ],
)
def test_other_files_are_refused_with_the_reason(tetrahedron, tmp_path, old, new, message):
    file = tmp_path / "f.vtu"
    file.write_text(vtu(tetrahedron, "binary", True).replace(old, new))
    if message is None:
        tt.read(file)
    else:
        with pytest.raises(tt.FileError, match=message):
            tt.read(file)


def test_other_cells_are_refused_by_name(tetrahedron, tmp_path):
    file = tmp_path / "f.vtu"
    file.write_text(vtu(tetrahedron, types=(12,)))
    with pytest.raises(tt.FileError, match="hexahedra"):
        tt.read(file)


def test_files_appear_whole_or_not_at_all(slab, tmp_path):
    with pytest.raises(ValueError):
        tt.write(tmp_path / "f.vtp", slab)
    with pytest.raises(tt.FileError):
        tt.write(tmp_path / "no" / "f.vtu", slab)
    with pytest.raises(tt.FileError, match="gone.vtu"):
        tt.read(tmp_path / "gone.vtu")
    assert list(tmp_path.iterdir()) == []


def meshio_of(tetrahedron):
    points, tensors, tets = tetrahedron
    blocks = [SimpleNamespace(type="triangle", data=np.array([[0, 1, 2]])),
              SimpleNamespace(type="tetra", data=np.array(tets))]  # fmt: skip
    return SimpleNamespace(points=np.array(points), cells=blocks, point_data={"S": np.array(tensors)})


def test_meshio_meshes(tetrahedron):
    mesh = meshio_of(tetrahedron)
    field = tt.from_meshio(mesh)
    assert field.sha256 == tt.Field(*tetrahedron).sha256
    assert list(field.cell_ids) == [1] and field.tensor_name == "S"
    mesh.cells[0].type = "hexahedron"
    with pytest.raises(ValueError, match="hexahedron"):
        tt.from_meshio(mesh)


def test_pyvista_grids(tetrahedron):
    points, tensors, tets = tetrahedron
    grid = SimpleNamespace(points=np.array(points), cells_dict={10: np.array(tets)},
                           celltypes=[10], point_data={"S": np.array(tensors)})  # fmt: skip
    assert tt.from_pyvista(grid).sha256 == tt.Field(*tetrahedron).sha256
    assert tt.PyVistaAccessor(grid).field("S").tensor_name == "S"


def test_installed_bridges_give_meshes(slab):
    surface = slab.mode_surface(0.5)
    meshio = pytest.importorskip("meshio")
    mesh = tt.to_meshio(surface)
    assert isinstance(mesh, meshio.Mesh) and len(mesh.cells[0].data) == len(surface.triangles)


def test_files_of_other_kinds_go_to_meshio(slab, tmp_path):
    meshio = pytest.importorskip("meshio")
    mesh = meshio.Mesh(np.array(slab.points), [("tetra", np.array(slab.tets))],
                       point_data={"S": np.array(slab.tensors)})  # fmt: skip
    meshio.write(tmp_path / "f.vtk", mesh)
    assert tt.read(tmp_path / "f.vtk").sha256 == slab.sha256
    with pytest.raises(tt.FileError, match="none.msh"):
        tt.read(tmp_path / "none.msh")


def test_nothing_else_is_imported():
    assert "vtk" not in sys.modules and "vtkmodules" not in sys.modules

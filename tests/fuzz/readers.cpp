// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "readers.hpp"

#include <cmath>
#include <memory>
#include <stdexcept>

#include "certified_readers.hpp"
#include "checker_readers.hpp"
#include "fields/read_mesh_of.hpp"
#include "formats/field_format.hpp"
#include "generate/truth.hpp"
#include "surfaces/read_formats.hpp"
#include "tensortopo/io/io_error.hpp"
#include "tensortopo/mesh/validate.hpp"

namespace tensortopo::test {
namespace {

void require(bool holds, const char* law) {
  if (!holds) throw std::logic_error(law);
}

/// Whether other files are read with it (pieces, parts, a mask), which errors may be about.
bool is_index(const std::filesystem::path& file) {
  return file.extension() == ".pvtu" || file.extension() == ".pvd" || file.extension() == ".nii";
}

/// The error must be one line of printable characters that names the file.
template <class Read>
void one_line_or_result(const std::filesystem::path& file, const Read& read) {
  try {
    read();
  } catch (const IoError& error) {
    const std::string_view text = error.what();
    if (error.file() == file)
      require(text.starts_with(file.string()), "an error does not begin with the file");
    else
      require(is_index(file), "an error is about another file");
    require(text.size() <= 2003, "an error is too long");
    for (const char c : text)
      require(static_cast<unsigned char>(c) >= ' ' && c != 127, "an error is not one line");
  }
}

std::shared_ptr<const detail::InputFile> file_of(const std::string& name, std::string_view bytes) {
  return std::make_shared<detail::InputFile>(detail::InputFile{name, std::string(bytes)});
}

void require_lists(const IndexLists& lists, std::size_t points, std::size_t least) {
  std::size_t begin = 0;
  for (const std::size_t end : lists.ends) {
    require(end >= begin + least, "a list is too short");
    begin = end;
  }
  require(begin == lists.points.size(), "lists do not end together");
  for (const auto v : lists.points)
    require(v >= 0 && static_cast<std::size_t>(v) < points, "an index is out of range");
}

void read_surface(const char* name, std::string_view bytes) {
  one_line_or_result(name, [&] {
    const SurfaceFile file = detail::read_surface_of(file_of(name, bytes));
    require_lists(file.lines, file.points.size(), 2);
    require_lists(file.polygons, file.points.size(), 3);
    for (const auto& p : file.points)
      require(std::isfinite(p.x + 0 * p.y + 0 * p.z), "a coordinate is not finite");
    for (const auto& array : file.point_data)
      require(array.values.size() == array.components * file.points.size(), "point data");
    for (const auto& array : file.cell_data)
      require(array.values.size() == array.components * (file.lines.size() + file.polygons.size()),
              "cell data");
    require(triangulated(file).size() == file.polygons.points.size() - 2 * file.polygons.size(),
            "not as many triangles as corners");
  });
}

/// Of the files that name others; a folder with some that can be named.
const std::string kParts = TENSORTOPO_FUZZ_DATA "/parts/";

/// Options that go with the bytes, so that an input tries the same ones again.
ReadOptions options_for(const std::string& name, std::string_view bytes) {
  unsigned choice = 0;
  for (const char c : bytes) choice = 31 * choice + static_cast<unsigned char>(c);
  choice ^= choice >> 16;
  const auto draw = [&choice](unsigned below) {
    const unsigned drawn = choice % below;
    choice /= below;
    return drawn;
  };
  ReadOptions options;
  options.tetrahedralize = true;
  options.cell_to_point = draw(2) == 0;
  options.merge_points = draw(2) == 0;
  options.symmetrize = draw(2) == 0;
  if (draw(2) == 0) options.tensor = "stress";
  if (draw(2) == 0) options.mean = draw(2) == 0 ? MeanWeights::plain : MeanWeights::volume;
  if (draw(2) == 0) options.quadratic = QuadraticCells::corners;
  if (draw(2) == 0) options.materials = draw(2) == 0 ? "none" : "ObjectId";
  if (draw(2) == 0) options.cell_values = draw(2) == 0 ? CellValues::nodes : CellValues::points;
  if (draw(4) == 0) options.step = draw(3);
  if (name.ends_with(".nii")) {
    options.components = component_order("vtk");
    if (draw(2) == 0) options.mask = kParts + "mask.nii";
  }
  return options;
}

void read_field(const std::string& name, std::string_view bytes, const ReadOptions& options) {
  one_line_or_result(name, [&] {
    const ReadResult read = detail::read_mesh_of(file_of(name, bytes), options);
    require(validate(read.mesh).empty(), "the mesh has defects");
    require(read.mesh.cell_ids.size() == read.mesh.tets.size(), "cell ids");
    for (const auto& t : read.mesh.tensors)
      for (const double x : {t.xx, t.yy, t.zz, t.xy, t.yz, t.xz})
        require(std::isfinite(x), "a tensor is not finite");
    for (const std::string& note : read.report.all_notes())
      for (const char c : note)
        require(static_cast<unsigned char>(c) >= ' ' && c != 127, "a note is not one line");
  });
}

void read_field(const std::string& name, std::string_view bytes) {
  ReadOptions options;
  options.cell_to_point = options.tetrahedralize = true;
  read_field(name, bytes, options);
  read_field(name, bytes, options_for(name, bytes));
  if (const auto steps = detail::format_of(name).steps; steps != nullptr)
    one_line_or_result(name, [&] { steps(file_of(name, bytes)); });
}

}  // namespace

const std::vector<FuzzedReader>& fuzzed_readers() {
  static const std::vector<FuzzedReader> readers = [] {
    std::vector<FuzzedReader> list{
        {"obj", [](std::string_view bytes) { read_surface("f.obj", bytes); }},
        {"off", [](std::string_view bytes) { read_surface("f.off", bytes); }},
        {"ply", [](std::string_view bytes) { read_surface("f.ply", bytes); }},
        {"stl", [](std::string_view bytes) { read_surface("f.stl", bytes); }},
        {"vtp", [](std::string_view bytes) { read_surface("f.vtp", bytes); }},
        {"vtk", [](std::string_view bytes) { read_field("f.vtk", bytes); }},
        {"vtu", [](std::string_view bytes) { read_field("f.vtu", bytes); }},
        {"vti", [](std::string_view bytes) { read_field("f.vti", bytes); }},
        {"frd", [](std::string_view bytes) { read_field("f.frd", bytes); }},
        {"exo", [](std::string_view bytes) { read_field("f.e", bytes); }},
        {"nii", [](std::string_view bytes) { read_field("f.nii", bytes); }},
        {"pvtu", [](std::string_view bytes) { read_field(kParts + "f.pvtu", bytes); }},
        {"pvd", [](std::string_view bytes) { read_field(kParts + "f.pvd", bytes); }},
        {"truth", [](std::string_view bytes) {
           one_line_or_result("f.json", [&] { parse_truth(std::string(bytes), "f.json"); });
         }}};
    for (const FuzzedReader& reader : checker_readers()) list.push_back(reader);
    for (const FuzzedReader& reader : certified_readers()) list.push_back(reader);
    return list;
  }();
  return readers;
}

}  // namespace tensortopo::test

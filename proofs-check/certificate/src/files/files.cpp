// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "files/files.hpp"

#include <openssl/evp.h>
#include <openssl/sha.h>

#include <algorithm>
#include <map>
#include <memory>
#include <stdexcept>

#include "certificate_check/check_certificate.hpp"
#include "files/component_names.hpp"
#include "files/document.hpp"
#include "files/grid.hpp"
#include "files/vtk_legacy.hpp"
#include "files/vtk_xml.hpp"
#include "mesh/complex.hpp"

namespace certificate {
namespace {

/// The name of a file, to say what is wrong with it.
struct Named {
  const std::string& name;

  [[noreturn]] void fail(const std::string& what) const { throw Malformed(name, what); }
};

/// The numbers of one cell or point after the other; cells ascend or not.
template <std::size_t Count>
std::vector<std::array<double, Count>> grouped(const Named& file,
                                               const std::vector<double>& numbers,
                                               std::size_t count) {
  if (count > 0x7fffffff || numbers.size() != Count * count) file.fail("not as many as declared");
  std::vector<std::array<double, Count>> result(count);
  for (std::size_t i = 0; i < numbers.size(); ++i) result[i / Count][i % Count] = numbers[i];
  return result;
}

/// Calls add(i, corners) for each cell of this many corners that is asked for. The others' corners
/// are not looked at, but each cell's follow those of the one before.
template <std::size_t Count, class Asked, class Add>
void read_cells(const Named& file, const std::vector<std::uint64_t>& connectivity,
                const std::vector<std::uint64_t>& offsets, std::size_t points, const Asked& asked,
                const Add& add) {
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    const std::string name = "cell " + std::to_string(i);
    const std::uint64_t first = i == 0 ? 0 : offsets[i - 1];
    if (first > offsets[i] || offsets[i] > connectivity.size())
      file.fail(name + " has offsets that are none");
    if (!asked(i)) continue;
    if (offsets[i] - first != Count) file.fail(name + " has the wrong number of corners");
    std::array<std::uint32_t, Count> corners;
    for (std::size_t k = 0; k < Count; ++k) {
      if (connectivity[first + k] >= points) file.fail(name + " has a corner that is no point");
      corners[k] = static_cast<std::uint32_t>(connectivity[first + k]);
      if (std::find(corners.begin(), corners.begin() + k, corners[k]) != corners.begin() + k)
        file.fail(name + " has a corner twice");
    }
    add(i, corners);
  }
  if ((offsets.empty() ? 0 : offsets.back()) != connectivity.size())
    file.fail("corners that no cell has");
}

/// SHA-256 of numbers of 64 bits, little-endian as the machine is.
class Digest {
 public:
  Digest() {
    if (context_ == nullptr || EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) != 1)
      throw std::runtime_error("no SHA-256");
  }
  Digest& add(std::string_view bytes) { return add(bytes.data(), bytes.size()); }
  Digest& add(std::uint64_t word) { return add(&word, 8); }
  template <std::size_t Count>
  Digest& add(const std::vector<std::array<double, Count>>& items) {
    return add(items.data(), items.size() * sizeof(items[0]));
  }
  template <std::size_t Count>
  Digest& add(const std::vector<std::array<std::uint32_t, Count>>& items) {
    constexpr std::size_t kTogether = 512;
    std::array<std::uint64_t, kTogether * Count> words;
    for (std::size_t first = 0; first < items.size(); first += kTogether) {
      std::size_t n = 0;
      for (std::size_t i = first; i < std::min(first + kTogether, items.size()); ++i)
        for (const std::uint64_t x : items[i]) words[n++] = x;
      add(words.data(), 8 * n);
    }
    return *this;
  }
  Digest& add(const std::vector<std::uint64_t>& items) {
    return add(items.data(), 8 * items.size());
  }
  Digest& add(const std::vector<double>& items) { return add(items.data(), 8 * items.size()); }
  std::string hex() const {
    std::array<unsigned char, SHA256_DIGEST_LENGTH> digest;
    EVP_DigestFinal_ex(context_.get(), digest.data(), nullptr);
    std::string text;
    for (const unsigned char byte : digest)
      text += {"0123456789abcdef"[byte >> 4], "0123456789abcdef"[byte & 15]};
    return text;
  }

 private:
  struct Free {
    void operator()(EVP_MD_CTX* context) const { EVP_MD_CTX_free(context); }
  };
  Digest& add(const void* bytes, std::size_t size) {
    EVP_DigestUpdate(context_.get(), bytes, size);
    return *this;
  }
  std::unique_ptr<EVP_MD_CTX, Free> context_{EVP_MD_CTX_new()};
};

}  // namespace

std::string sha256_of(std::string_view bytes) { return Digest().add(bytes).hex(); }

std::string InputFile::sha256() const {
  return Digest().add(points.size()).add(points).add(tensors).add(tets.size()).add(tets).hex();
}

std::string Triangles::sha256() const {
  return Digest().add(points.size()).add(points).add(triangles.size()).add(triangles).add(cells)
      .hex();
}

std::string Polylines::sha256() const {
  Digest digest;
  digest.add(points.size()).add(points).add(lines.size());
  for (const auto& line : lines) {
    digest.add(line.size());
    for (const std::uint64_t v : line) digest.add(v);
  }
  return digest.add(cells).hex();
}

std::string Array::sha256() const { return Digest().add(numbers).hex(); }

std::string Radii::sha256() const { return Digest().add(numbers).hex(); }

namespace {

Grid read_xml_grid(const File& source, const std::string& tensor, std::size_t components) {
  const XmlFile file(source, "UnstructuredGrid", {"Cells"});
  Grid grid{file.numbers("Points", "", 3), file.numbers("PointData", tensor, components),
            file.component_names("PointData", tensor),
            file.naturals("Cells", "types"), file.naturals("Cells", "connectivity"),
            file.naturals("Cells", "offsets")};
  if (grid.points.size() != 3 * file.count("NumberOfPoints") ||
      grid.types.size() != file.count("NumberOfCells"))
    file.fail("not as many as declared");
  return grid;
}

/// Where XX YY ZZ XY YZ XZ are.
const std::map<std::string, std::array<std::size_t, 6>> kOrders{
    {"vtk", {0, 1, 2, 3, 4, 5}},    {"voigt", {0, 1, 2, 5, 3, 4}},
    {"abaqus", {0, 1, 2, 3, 5, 4}}, {"nifti", {0, 2, 5, 1, 4, 3}},
    {"fsl", {0, 3, 5, 1, 4, 2}},    {"full", {0, 4, 8, 1, 5, 2}}};

/// Is a cell of this type (of VTK's) empty, a point, a line or a face?
bool is_flat(std::uint64_t type) {
  constexpr std::array<std::uint64_t, 20> kOthers{21, 22, 23, 28, 30, 34, 35, 36, 51, 52,
                                                  53, 54, 60, 61, 62, 63, 68, 69, 70, 75};
  return type < 10 || type == 76 || type == 77 ||
         std::find(kOthers.begin(), kOthers.end(), type) != kOthers.end();
}

/// The grid of a file, with an array of its points.
Grid read_grid(const File& file, const std::string& array, std::size_t components) {
  const bool is_legacy = file.has_extension(".vtk");
  if (!is_legacy && !file.has_extension(".vtu"))
    throw Malformed(file.name, "neither a .vtu nor a .vtk, which certificates are about; "
                               "tensortopo convert makes one");
  return is_legacy ? read_legacy_grid(file, array, components)
                   : read_xml_grid(file, array, components);
}

}  // namespace

Radii read_radii(const File& source, const std::string& array, std::size_t points) {
  const Named file{source.name};
  if (array.empty()) throw Malformed("", "radii of an array without name");
  Radii result{read_grid(source, array, 1).tensors};
  if (result.numbers.size() != points)
    file.fail("the array '" + array + "' has not one number for each point");
  for (const double radius : result.numbers)
    if (!(radius >= 0 && radius <= 0x1p1000))
      file.fail("the array '" + array + "' has a number that is no radius");
  return result;
}

std::string listing_of(const std::string& order) {
  if (order == "full") return "XX XY XZ YX YY YZ ZX ZY ZZ";
  const auto found = kOrders.find(order);
  if (found == kOrders.end()) return {};
  constexpr std::array<const char*, 6> kNames{"XX", "YY", "ZZ", "XY", "YZ", "XZ"};
  std::array<const char*, 6> listed{};
  for (std::size_t k = 0; k < 6; ++k) listed[found->second[k]] = kNames[k];
  std::string result;
  for (const char* name : listed) result += (result.empty() ? "" : " ") + std::string(name);
  return result;
}

InputFile read_input(const File& source, const std::string& tensor,
                     const std::string& components) {
  const Named file{source.name};
  const auto order = kOrders.find(components);
  if (order == kOrders.end())  // the certificate's fault, not this file's
    throw Malformed("", "/input/components: unknown order of components");
  const std::size_t width = components == "full" ? 9 : 6;
  const Grid grid = read_grid(source, tensor, width);
  InputFile input;
  for (const std::string& part : grid.names)
    if (!part.empty()) input.names += (input.names.empty() ? "" : " ") + part;
  const Spelling spelling = spelling_of(grid.names, order->second);
  input.names_say_order = spelling == Spelling::agrees;
  if (spelling == Spelling::differs)
    file.fail("names the components of '" + tensor + "' " + input.names + ", which is not the order " +
              components + " of the certificate");
  input.points = grouped<3>(file, grid.points, grid.points.size() / 3);
  const auto read = [&]<std::size_t Width>() {
    for (const auto& t : grouped<Width>(file, grid.tensors, input.points.size())) {
      std::array<double, 6>& result = input.tensors.emplace_back();
      bool is_symmetric = true;
      for (std::size_t k = 0; k < 6; ++k) {
        const std::size_t i = order->second[k];
        result[k] = t[i];
        const double mirrored = Width == 9 ? t[i % 3 * 3 + i / 3] : t[i];
        if (mirrored == t[i]) continue;
        result[k] = t[i] / 2 + mirrored / 2;
        is_symmetric = false;
      }
      if (!is_symmetric) ++input.symmetrized;
    }
  };
  if (width == 9)
    read.operator()<9>();
  else
    read.operator()<6>();
  if (grid.types.size() != grid.offsets.size()) file.fail("not the cells that it declares");
  for (const std::uint64_t type : grid.types)  // others wrap them around
    if (type > 255) file.fail("a type of cells above 255");
  constexpr std::uint64_t kTetrahedron = 10;
  read_cells<4>(
      file, grid.connectivity, grid.offsets, input.points.size(),
      [&](std::size_t i) {
        if (grid.types[i] == kTetrahedron) return true;
        ++(is_flat(grid.types[i]) ? input.flat_cells : input.other_cells);
        return false;
      },
      [&](std::size_t i, auto corners) {
        std::sort(corners.begin(), corners.end());
        input.tets.push_back(corners);
        input.cells.push_back(i);
      });
  if (const auto defect = defect_of(input.tets, input.points)) file.fail(*defect);
  input.doubled_points = count_doubled(input.tets, input.points);
  return input;
}

namespace {

/// Adds the arrays of a section, but the tetrahedra, by name. Of no points or cells there is nothing
/// to add: an array without numbers says nothing.
void add_arrays(const XmlFile& file, const char* section, const char* of, std::size_t count,
                std::vector<Array>& arrays) {
  const std::size_t first = arrays.size();
  for (const auto& [name, components] : file.arrays(section)) {
    if (of != std::string("points") && name == "tet") continue;
    Array array{of, name, components, file.numbers(section, name, components)};
    if (of == std::string("points") && name == "tet") file.fail("an array 'tet' of points");
    if (components > 1000 || array.numbers.size() != components * count)
      file.fail("array '" + name + "' has not as many numbers as declared");
    if (count > 0) arrays.push_back(std::move(array));
  }
  std::sort(arrays.begin() + static_cast<std::ptrdiff_t>(first), arrays.end(),
            [](const Array& a, const Array& b) { return a.name < b.name; });
}

/// Cells of other kinds are neither counted nor there, so that reading by sections gives the
/// same as reading by counts.
/// @param others  their sections
void require_no_cells(const XmlFile& file, const std::array<const char*, 3>& others,
                      const std::string& kind) {
  for (const std::string section : others) {
    bool has_cells = file.count(("NumberOf" + section).c_str()) != 0;
    for (const auto& [name, components] : file.arrays(section.c_str()))
      has_cells = has_cells || !file.numbers(section.c_str(), name, components).empty();
    if (has_cells) file.fail("holds more than " + kind);
  }
}

/// What triangles and polylines have alike: points, arrays and the tetrahedra of the cells.
/// @return how many cells; if none, there may be no array of tetrahedra
template <class Output>
std::size_t read_common(const XmlFile& file, const std::string& name, const char* counted,
                        const char* kind, Output& output) {
  output.points = grouped<3>({name}, file.numbers("Points", "", 3), file.count("NumberOfPoints"));
  const std::size_t cells = file.count(counted);
  add_arrays(file, "PointData", "points", output.points.size(), output.arrays);
  add_arrays(file, "CellData", kind, cells, output.arrays);
  if (cells == 0) return 0;
  output.cells = file.naturals("CellData", "tet");
  if (output.cells.size() != cells) file.fail("not the " + std::string(kind) + " that it declares");
  return cells;
}

const std::vector<std::string_view> kSections{"Verts", "Lines", "Strips", "Polys"};

}  // namespace

Triangles read_triangles(const File& source) {
  const std::string& name = source.name;
  const XmlFile file(source, "PolyData", kSections);
  require_no_cells(file, {"Verts", "Lines", "Strips"}, "triangles");
  file.require_only("Polys", {"connectivity", "offsets"});
  Triangles result;
  const std::size_t cells = read_common(file, name, "NumberOfPolys", "triangles", result);
  if (cells == 0) return result;
  const auto offsets = file.naturals("Polys", "offsets");
  if (offsets.size() != cells) file.fail("not the cells that it declares");
  read_cells<3>(
      {name}, file.naturals("Polys", "connectivity"), offsets, result.points.size(),
      [](std::size_t) { return true; },
      [&](std::size_t, const auto& corners) { result.triangles.push_back(corners); });
  return result;
}

Polylines read_polylines(const File& source) {
  const std::string& name = source.name;
  const XmlFile file(source, "PolyData", kSections);
  require_no_cells(file, {"Verts", "Strips", "Polys"}, "lines");
  file.require_only("Lines", {"connectivity", "offsets"});
  Polylines result;
  const std::size_t cells = read_common(file, name, "NumberOfLines", "lines", result);
  if (cells == 0) return result;
  const auto offsets = file.naturals("Lines", "offsets");
  const auto connectivity = file.naturals("Lines", "connectivity");
  if (offsets.size() != cells) file.fail("not the cells that it declares");
  std::uint64_t first = 0;
  for (std::size_t i = 0; i < cells; ++i) {
    const std::string line = "line " + std::to_string(i);
    if (offsets[i] < first + 2 || offsets[i] > connectivity.size())
      file.fail(line + " has the wrong number of points");
    auto& points = result.lines.emplace_back();
    for (; first < offsets[i]; ++first) {
      if (connectivity[first] >= result.points.size()) file.fail(line + " has a point that is none");
      points.push_back(static_cast<std::uint32_t>(connectivity[first]));
    }
    auto sorted = points;
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
      file.fail(line + " has a point twice");
  }
  return result;
}

}  // namespace certificate

// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "parts/write_parts.hpp"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "tensortopo/hash/sha256.hpp"
#include "tensortopo/mesh/as_size.hpp"

namespace tensortopo::filters {

namespace {

std::string sha256_of(const std::string& bytes) {
  Sha256 sum;
  sum.add(bytes);
  return sum.hex();
}

constexpr std::size_t kHexDigits = 64;

/// One name of the tensors, of all ranks that have parts.
std::string common_tensor(const std::vector<std::string>& names) {
  const std::string& first = names.front();
  const auto other = std::find_if(names.begin(), names.end(),
                                  [&](const std::string& name) { return name != first; });
  if (other != names.end())
    throw std::runtime_error("the tensors are called " + first + " on one rank and " + *other +
                             " on another; choose one array");
  return first;
}

}  // namespace

PartsFiles require_parts_files(const std::string& certificate_file, const Ranks& ranks,
                               const WholeMesh& mesh) {
  if (mesh.tets == 0)
    throw std::runtime_error("the field has no tetrahedra, so there is nothing to certify");
  PartsFiles files(certificate_file);
  if (ranks.own() == 0) files.require_place();
  return files;
}

WholeOutput whole_output(const ModeValue& mode, const WholeSurface& counts) {
  return {mode.text(),
          "surface",
          surface_pieces(),
          {{"vertices", counts.vertices},
           {"triangles", counts.triangles},
           {"components", counts.components},
           {"euler_characteristic", counts.euler_characteristic},
           {"boundary_loops", counts.boundary_loops}}};
}

WholeOutput whole_output(const ModeValue& mode, const WholeCurves& counts) {
  return {mode.text(),
          "polylines",
          curve_pieces(),
          {{"vertices", counts.vertices},
           {"lines", counts.lines},
           {"components", counts.components},
           {"closed_components", counts.closed_components}}};
}

std::vector<TetMesh::Index> of_own_cells(const MeshPiece& piece,
                                         const std::vector<TetMesh::Index>& tets,
                                         const std::vector<TetMesh::Index>& numbers) {
  std::vector<TetMesh::Index> result;
  for (const std::size_t cell : own_cells(piece, tets, 0, tets.size()))
    result.push_back(numbers[cell]);
  return result;
}

void write_parts(const Ranks& ranks, const WholeMesh& mesh, const PartsFiles& files,
                 const WholeOutput& whole, const TensorGrid& grid,
                 const std::function<PartBytes()>& make) {
  const auto has_part = [&](std::size_t rank) { return !mesh.owned_ids[rank].empty(); };
  const std::size_t own = as_size(ranks.own());
  std::size_t number = 0;  // of this rank's part
  for (std::size_t r = 0; r < own; ++r)
    if (has_part(r)) ++number;

  PartBytes bytes;
  std::unique_ptr<NewFolder> folder;  // on the first rank
  ranks.together([&] {
    if (has_part(own)) bytes = make();
  });
  ranks.together([&] {
    if (own != 0) return;
    files.require_place();
    folder = std::make_unique<NewFolder>(files.folder);
  });
  const std::filesystem::path made =
      ranks.gather(folder ? folder->path().string() : std::string()).front();
  std::string hashes;
  ranks.together([&] {
    if (!has_part(own)) return;
    const auto write = [&](const std::string& name, const std::string& data) {
      write_bytes(made / name, data, files.folder / name);
      hashes += sha256_of(data);
    };
    write(files.field_of(number), bytes.field);
    write(files.output_of(number), bytes.output);
    write(files.certificate_of(number), bytes.certificate);
  });
  const auto names = ranks.gather(has_part(own) ? tensor_name(grid) : std::string());
  const auto sums = ranks.gather(hashes);
  ranks.together([&] {
    if (own != 0) return;
    std::vector<CertifiedPart> listed;
    std::vector<std::string> tensors, fields, outputs;
    for (std::size_t r = 0; r < sums.size(); ++r) {
      if (!has_part(r)) continue;
      const std::size_t part = listed.size();
      const auto sum = [&](std::size_t i) { return sums[r].substr(i * kHexDigits, kHexDigits); };
      tensors.push_back(names[r]);
      fields.push_back(files.below(files.field_of(part)));
      outputs.push_back(files.below(files.output_of(part)));
      listed.push_back({{fields.back(), sum(0)},
                        {outputs.back(), sum(1)},
                        {files.below(files.certificate_of(part)), sum(2)}});
    }
    WholeNumbers numbers{{"tetrahedra", mesh.tets}};
    numbers.insert(numbers.end(), whole.numbers.begin(), whole.numbers.end());
    folder->put_in_place(
        {{files.field, bytes_of(field_pieces(common_tensor(tensors)), fields)},
         {files.output, bytes_of(whole.pieces, outputs)},
         {files.certificate,
          parts_certificate_bytes(whole.mode, whole.role, listed, numbers)}});
  });
}

}  // namespace tensortopo::filters

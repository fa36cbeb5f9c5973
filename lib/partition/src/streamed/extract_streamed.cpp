// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/partition/extract_streamed.hpp"

#include <algorithm>
#include <list>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <vector>

#include "agreeing_pieces.hpp"
#include "streamed/piece_index.hpp"
#include "tensortopo/hash/number_hash.hpp"

namespace tensortopo {

namespace {

using Index = TetMesh::Index;

/// A piece with the ids of its points.
struct ReadPiece {
  std::int32_t number = 0;
  TetMesh mesh;
  std::vector<std::int64_t> ids;
};

/// Keeps the pieces that were asked for last.
class PieceCache {
 public:
  PieceCache(const PieceSource& source, const detail::PieceIndex& index) : source_(source), index_(index) {}

  std::shared_ptr<const ReadPiece> get(std::int32_t number) {
    const auto found = std::find_if(pieces_.begin(), pieces_.end(),
                                    [&](const auto& piece) { return piece->number == number; });
    if (found != pieces_.end()) {
      pieces_.splice(pieces_.begin(), pieces_, found);
    } else {
      if (pieces_.size() == kMost) pieces_.pop_back();
      pieces_.push_front(std::make_shared<const ReadPiece>(
          ReadPiece{number, source_.read(number), index_.pieces[as_size(number)].point_ids()}));
    }
    return pieces_.front();
  }

 private:
  static constexpr std::size_t kMost = 4;
  const PieceSource& source_;
  const detail::PieceIndex& index_;
  std::list<std::shared_ptr<const ReadPiece>> pieces_;
};

/// Collects tetrahedra of several pieces as one `MeshPiece`.
class PieceBuilder {
 public:
  explicit PieceBuilder(const detail::PieceIndex& index) : index_(index) { piece_.whole_tets = index.tets; }

  /// @param is_taken  is_taken(t): whether a tetrahedron is one of them
  template <class IsTaken>
  void add(const ReadPiece& from, bool is_owned, const IsTaken& is_taken) {
    for (std::size_t t = 0; t < from.mesh.tets.size(); ++t) {
      if (!is_taken(t)) continue;
      std::array<std::int64_t, 4> corners{};
      for (std::size_t k = 0; k < 4; ++k) {
        corners[k] = from.ids[as_size(from.mesh.tets[t][k])];
        add_vertex(from, from.mesh.tets[t][k]);
      }
      corners_.push_back(corners);
      piece_.mesh.cell_ids.push_back(index_.pieces[as_size(from.number)].first_tet +
                                     static_cast<std::int64_t>(t));
      piece_.is_owned.push_back(is_owned);
    }
  }
  /// Once for each use.
  void add_vertex(const ReadPiece& from, Index v) {
    vertices_.push_back(
        {from.ids[as_size(v)], from.mesh.points[as_size(v)], from.mesh.tensors[as_size(v)]});
    if (vertices_.size() > 2 * distinct_ + 100'000) make_distinct();
  }

  MeshPiece finish() {
    make_distinct();
    for (const Vertex& v : vertices_) {
      piece_.vertex_ids.push_back(v.id);
      piece_.mesh.points.push_back(v.point);
      piece_.mesh.tensors.push_back(v.tensor);
    }
    for (const auto& corners : corners_) {
      auto& tet = piece_.mesh.tets.emplace_back();
      for (std::size_t k = 0; k < 4; ++k)
        tet[k] = static_cast<Index>(
            std::lower_bound(piece_.vertex_ids.begin(), piece_.vertex_ids.end(), corners[k]) -
            piece_.vertex_ids.begin());
    }
    return std::move(piece_);
  }

 private:
  struct Vertex {
    std::int64_t id;
    Vector3<double> point;
    SymmetricTensor<double> tensor;
  };

  void make_distinct() {
    std::sort(vertices_.begin(), vertices_.end(),
              [](const Vertex& u, const Vertex& v) { return u.id < v.id; });
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end(),
                                [](const Vertex& u, const Vertex& v) { return u.id == v.id; }),
                    vertices_.end());
    distinct_ = vertices_.size();
  }

  const detail::PieceIndex& index_;
  MeshPiece piece_;
  std::vector<Vertex> vertices_;
  std::size_t distinct_ = 0;
  std::vector<std::array<std::int64_t, 4>> corners_;
};

/// The tetrahedra of one piece, with layers of others around.
MeshPiece piece_with_ghosts(PieceCache& cache, const detail::PieceIndex& index, std::int32_t number,
                            int layers) {
  // Of each piece that is near the tetrahedra that are held.
  std::vector<std::pair<std::int32_t, std::vector<char>>> held;
  const auto own = cache.get(number);
  held.emplace_back(number, std::vector<char>(own->mesh.tets.size(), 1));
  for (int layer = 0; layer < layers; ++layer) {
    std::unordered_set<std::int64_t> near;
    for (const auto& [p, is_held] : held) {
      const auto piece = cache.get(p);
      for (std::size_t t = 0; t < is_held.size(); ++t)
        if (is_held[t] != 0)
          for (const Index v : piece->mesh.tets[t]) near.insert(piece->ids[as_size(v)]);
    }
    for (std::size_t i = 0, before = held.size(); i < before; ++i)
      for (const std::int32_t q : index.pieces[as_size(held[i].first)].neighbours)
        if (std::none_of(held.begin(), held.end(), [&](const auto& h) { return h.first == q; }))
          held.emplace_back(q, std::vector<char>(index.pieces[as_size(q)].tets, 0));
    for (auto& [p, is_held] : held) {
      if (p == number) continue;
      const auto piece = cache.get(p);
      std::vector<char> is_near;
      for (const std::int64_t id : piece->ids) is_near.push_back(near.contains(id));
      for (std::size_t t = 0; t < is_held.size(); ++t)
        is_held[t] |= std::any_of(piece->mesh.tets[t].begin(), piece->mesh.tets[t].end(),
                                  [&](Index v) { return is_near[as_size(v)] != 0; });
    }
  }
  PieceBuilder builder(index);
  for (const auto& [p, is_held] : held)
    builder.add(*cache.get(p), p == number,
                [&which = is_held](std::size_t t) { return which[t] != 0; });
  std::vector<char> is_used(own->mesh.points.size(), 0);
  for (const auto& tet : own->mesh.tets)
    for (const Index v : tet) is_used[as_size(v)] = 1;
  for (std::size_t v = 0; v < is_used.size(); ++v)
    if (is_used[v] == 0) builder.add_vertex(*own, static_cast<Index>(v));
  return builder.finish();
}

std::string hash_of(const PieceSource& source, const detail::PieceIndex& index) {
  FieldHash hash(as_size(index.points), as_size(index.tets));
  for (std::int32_t p = 0; p < source.pieces; ++p) {
    const TetMesh mesh = source.read(p);
    index.pieces[as_size(p)].for_each_new_point([&](std::size_t v) { hash.add(mesh.points[v]); });
  }
  for (std::int32_t p = 0; p < source.pieces; ++p) {
    const TetMesh mesh = source.read(p);
    index.pieces[as_size(p)].for_each_new_point([&](std::size_t v) { hash.add(mesh.tensors[v]); });
  }
  for (std::int32_t p = 0; p < source.pieces; ++p) {
    const auto ids = index.pieces[as_size(p)].point_ids();
    for (const auto& tet : source.read(p).tets)
      hash.add(std::array{ids[as_size(tet[0])], ids[as_size(tet[1])], ids[as_size(tet[2])],
                          ids[as_size(tet[3])]});
  }
  return hash.hex();
}

/// What all pieces give together.
/// @param extract  extract(piece, options): of one of them
template <class Extract>
auto merged_stream(const StreamedMesh& mesh, const ExtractOptions& options,
                   const Extract& extract) {
  if (!options.density.empty() || !options.part.empty())
    throw std::invalid_argument("options: density and part are not for a mesh read in pieces");
  const auto all_pieces = [&](int layers) {
    PieceCache cache(mesh.source(), mesh.index());
    std::vector<decltype(extract(MeshPiece{}, options))> all;
    for (std::int32_t p = 0; p < mesh.source().pieces; ++p)
      all.push_back(extract(piece_with_ghosts(cache, mesh.index(), p, layers),
                            options_of_piece(options, p, mesh.source().pieces)));
    return all;
  };
  return merge_agreeing_pieces(all_pieces, mesh.tets());
}

}  // namespace

StreamedMesh::StreamedMesh(PieceSource source)
    : source_(std::move(source)), index_(std::make_shared<const detail::PieceIndex>(source_)) {}

std::size_t StreamedMesh::points() const { return as_size(index_->points); }

std::size_t StreamedMesh::tets() const { return as_size(index_->tets); }

const TornFaces& StreamedMesh::torn_faces() const { return index_->torn_faces; }

bool StreamedMesh::is_in_parts() const {
  const auto& pieces = index_->pieces;
  const auto has_points = [](const IndexedPiece& piece) { return piece.points > 0; };
  return std::count_if(pieces.begin(), pieces.end(), has_points) > 1 &&
         std::all_of(pieces.begin(), pieces.end(),
                     [](const IndexedPiece& piece) { return piece.neighbours.empty(); });
}

std::string StreamedMesh::field_sha256() const { return hash_of(source_, *index_); }

MergedSurface extract_streamed(const StreamedMesh& mesh, const ModeValue& mode,
                               const ExtractOptions& options) {
  return merged_stream(mesh, options, [&](const MeshPiece& piece, const ExtractOptions& own) {
    return extract_piece(piece, mode, own);
  });
}

MergedCurves extract_streamed(const StreamedMesh& mesh, Degeneracy kind,
                              const ExtractOptions& options) {
  return merged_stream(mesh, options, [&](const MeshPiece& piece, const ExtractOptions& own) {
    return extract_curve_piece(piece, kind, own);
  });
}

}  // namespace tensortopo

// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <openssl/sha.h>

#include <algorithm>
#include <bit>

#include "compare_distance.hpp"

namespace certificate {
namespace {

/// SHA-256 of numbers of 64 bits, little-endian as the machine is.
class Digest {
 public:
  void add(std::uint64_t word) { bytes_.append(reinterpret_cast<const char*>(&word), 8); }
  void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
  template <class T, std::size_t Count>
  void add(const std::array<T, Count>& items) {
    for (const T& item : items) add(widen(item));
  }
  template <class T>
  void add(const std::vector<T>& items) {
    for (const T& item : items) add(item);
  }
  std::string hex() const {
    std::array<unsigned char, SHA256_DIGEST_LENGTH> digest;
    SHA256(reinterpret_cast<const unsigned char*>(bytes_.data()), bytes_.size(), digest.data());
    std::string text;
    for (const unsigned char byte : digest) {
      text += "0123456789abcdef"[byte >> 4];
      text += "0123456789abcdef"[byte & 15];
    }
    return text;
  }

 private:
  static double widen(double x) { return x; }
  static std::uint64_t widen(std::uint32_t x) { return x; }
  std::string bytes_;
};

std::string hash_of(const Input& input) {
  Digest digest;
  digest.add(std::uint64_t{input.points.size()});
  digest.add(input.points);
  digest.add(input.tensors);
  digest.add(std::uint64_t{input.tets.size()});
  digest.add(input.tets);
  return digest.hex();
}

std::string hash_of(const Triangles& surface) {
  Digest digest;
  digest.add(std::uint64_t{surface.points.size()});
  digest.add(surface.points);
  digest.add(std::uint64_t{surface.triangles.size()});
  digest.add(surface.triangles);
  digest.add(surface.cells);
  return digest.hex();
}

/// The tetrahedra about which a level claims nothing. False if there is no such tetrahedron.
bool mark_left_out(const LevelClaims& claims, const Input& input, std::vector<bool>& left_out,
                   Ledger& ledger) {
  for (const auto& [cell, reason] : claims.undecided) {
    const auto place = std::lower_bound(input.cells.begin(), input.cells.end(), cell);
    if (place == input.cells.end() || *place != cell) {
      ledger.refute("tetrahedron " + std::to_string(cell), reason, "no such tetrahedron");
      return false;
    }
    left_out[static_cast<std::size_t>(place - input.cells.begin())] = true;
    ledger.leave_open("tetrahedron " + std::to_string(cell), reason);
  }
  return true;
}

void check_level(const LevelClaims& claims, const Input& input, const Field& field,
                 const Triangles& surface, Ledger& ledger) {
  const Level level(claims.numerator, claims.denominator);
  std::vector<bool> left_out(input.tets.size());
  ledger.begin("left out");
  if (!mark_left_out(claims, input, left_out, ledger)) return;
  const Topology topology = derive_topology(input, field, level, left_out);
  const LevelCase c{input, field, level, surface, claims, topology};
  ledger.begin("vertices on the level");
  ledger.settle(claims.on_level == topology.on_level, "vertices on the level",
                std::to_string(claims.on_level), std::to_string(topology.on_level));
  ledger.begin("edges");
  const CrossingVertices vertices = compare_edges(c, ledger);
  ledger.begin("faces");
  compare_faces(c, vertices, ledger);
  ledger.begin("tetrahedra");
  compare_tets(c, vertices, ledger);
  ledger.begin("surface");
  const auto placed = compare_surface(c, vertices, left_out, ledger);
  ledger.begin("distances");
  // Where something is refuted, vertices need not be where they are claimed to be.
  const bool is_sound = placed && !ledger.has_refuted();
  if (claims.distance) compare_distance(c, is_sound ? &*placed : nullptr, left_out, ledger);
  ledger.count(level.decided_by_balls(), level.decided_exactly());
}

}  // namespace

Report check_certificate(const std::string& input_file, const std::string& surface_file,
                         const std::string& certificate_file) {
  const Claims claims = read_claims(certificate_file);
  const Input input = read_input(input_file, claims.tensor, claims.components);
  const Triangles surface = read_triangles(surface_file);
  Report report;
  Ledger ledger(report);
  ledger.begin("files");
  const auto compare = [&](const char* what, const auto& claimed, const auto& derived) {
    ledger.settle(claimed == derived, what, claimed, derived);
  };
  using std::to_string;
  compare("points", to_string(claims.points), to_string(input.points.size()));
  compare("tetrahedra", to_string(claims.tetrahedra), to_string(input.tets.size()));
  compare("input's sha256", claims.input_sha256, hash_of(input));
  compare("vertices", to_string(claims.vertices), to_string(surface.points.size()));
  compare("triangles", to_string(claims.triangles), to_string(surface.triangles.size()));
  compare("surface's sha256", claims.surface_sha256, hash_of(surface));
  Number vertices = 0, triangles = 0;
  bool in_order = true;
  for (const LevelClaims& level : claims.levels) {
    in_order = in_order && level.vertices[0] == vertices && level.triangles[0] == triangles &&
               level.vertices[1] <= surface.points.size() - vertices &&
               level.triangles[1] <= surface.triangles.size() - triangles;
    if (!in_order) break;
    vertices += level.vertices[1], triangles += level.triangles[1];
  }
  in_order = in_order && vertices == surface.points.size() && triangles == surface.triangles.size();
  ledger.settle(in_order, "levels", "all of the surface, one after the other", "they are not");
  if (report.refuted > 0) return report;  // of another field or surface nothing need be derived

  const Field field(input);
  for (const LevelClaims& level : claims.levels) {
    ledger.level = "mode " + level.mode + ", ";
    check_level(level, input, field, surface, ledger);
  }
  return report;
}

}  // namespace certificate

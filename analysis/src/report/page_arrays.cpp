// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "report/page_arrays.hpp"

#include <openssl/evp.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

#include "tensortopo/mesh/validate.hpp"

namespace tensortopo {

namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie");

template <class T>
void append(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// A direction's components as bytes; lengths are at most 1.
void append_direction(std::vector<std::int8_t>& bytes, const Vector3<double>& v) {
  for (const double x : {v.x, v.y, v.z})
    bytes.push_back(static_cast<std::int8_t>(std::lround(127 * std::clamp(x, -1.0, 1.0))));
}

}  // namespace

PageArrays::PageArrays(const TetMesh& mesh) : mesh_(mesh) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  Vector3<double> low{infinite, infinite, infinite}, high{-infinite, -infinite, -infinite};
  for (const auto& t : mesh.tets)
    for (const auto v : t) {
      const auto& p = mesh.points[as_size(v)];
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
  if (mesh.tets.empty()) return;
  centre_ = 0.5 * (low + high);
  radius_ = std::max(0.5 * length(high - low), std::numeric_limits<double>::min());
}

void PageArrays::put(const Vector3<double>& p) {
  const Vector3<double> q = p - centre_;
  for (const double x : {q.x, q.y, q.z}) append(bytes_, static_cast<float>(x / radius_));
}

PageArrays::Json PageArrays::place(char kind, std::size_t offset, std::size_t length) {
  const std::string name = kind == 'i' ? "i1" : std::string(1, kind) + '4';
  bytes_.resize((bytes_.size() + 3) / 4 * 4);
  return {name, offset, length};
}

template <class T>
PageArrays::Json PageArrays::put_all(char kind, const std::vector<T>& values) {
  const std::size_t offset = bytes_.size();
  for (const T value : values) append(bytes_, value);
  return place(kind, offset, values.size());
}

PageArrays::Json PageArrays::add(const SurfaceMesh& s, std::size_t first_vertex,
                                 std::size_t vertices, std::size_t first_triangle,
                                 std::size_t triangles,
                                 std::span<const std::int32_t> stable) {
  Json arrays;
  const std::size_t offset = bytes_.size();
  std::vector<std::int8_t> normals, medium, dominant;
  std::vector<float> residual;
  for (std::size_t v = first_vertex; v < first_vertex + vertices; ++v) {
    put(s.points[v]);
    append_direction(normals, s.normal[v]);
    append_direction(medium, s.medium_eigenvector[v]);
    append_direction(dominant, s.dominant_eigenvector[v]);
    residual.push_back(static_cast<float>(s.residual[v]));
  }
  arrays["points"] = place('f', offset, 3 * vertices);
  arrays["normals"] = put_all('i', normals);
  arrays["medium"] = put_all('i', medium);
  arrays["dominant"] = put_all('i', dominant);
  arrays["residual"] = put_all('f', residual);
  std::vector<std::uint32_t> corners, components;
  const std::size_t end = first_triangle + triangles;
  const auto least = triangles == 0 ? 0 : s.component[first_triangle];
  for (std::size_t t = first_triangle; t < end; ++t) {
    for (const auto v : s.triangles[t])
      corners.push_back(static_cast<std::uint32_t>(as_size(v) - first_vertex));
    components.push_back(static_cast<std::uint32_t>(s.component[t] - least));
  }
  arrays["triangles"] = put_all('u', corners);
  arrays["component"] = put_all('u', components);
  if (!stable.empty()) {
    const auto own = stable.subspan(first_triangle, triangles);
    arrays["stable"] = put_all('i', std::vector<std::int8_t>(own.begin(), own.end()));
  }
  return arrays;
}

PageArrays::Json PageArrays::add(const CurveMesh& curves, double mode,
                                 std::span<const std::int32_t> stable, bool is_stable) {
  const std::size_t offset = bytes_.size();
  for (std::size_t l = 0; l < curves.lines.size(); ++l) {
    const auto& line = curves.lines[l];
    if (curves.mode[as_size(line.front())] != mode) continue;
    if (!stable.empty() && (stable[l] != 0) != is_stable) continue;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
      put(curves.points[as_size(line[i])]), put(curves.points[as_size(line[i + 1])]);
  }
  return place('f', offset, (bytes_.size() - offset) / sizeof(float));
}

PageArrays::Json PageArrays::add(const std::vector<LeftOut>& cells) {
  const std::size_t offset = bytes_.size();
  for (const LeftOut& cell : cells) {
    const auto& t = mesh_.tets[as_size(cell.tet)];
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t k = i + 1; k < 4; ++k)
        put(mesh_.points[as_size(t[i])]), put(mesh_.points[as_size(t[k])]);
  }
  return place('f', offset, (bytes_.size() - offset) / sizeof(float));
}

PageArrays::Json PageArrays::add_outline() {
  std::vector<OuterFace> outer;
  validate(mesh_, &outer);
  using Edge = std::array<TetMesh::Index, 2>;
  std::map<Edge, std::vector<Vector3<double>>> normals;
  for (const OuterFace& face : outer) {
    const auto& v = face.vertices;
    const auto& p = mesh_.points;
    const auto normal = unit_or_zero(cross(p[as_size(v[1])] - p[as_size(v[0])],
                                           p[as_size(v[2])] - p[as_size(v[0])]));
    for (std::size_t i = 0; i < 3; ++i)
      normals[{std::min(v[i], v[(i + 1) % 3]), std::max(v[i], v[(i + 1) % 3])}].push_back(normal);
  }
  const std::size_t offset = bytes_.size();
  constexpr double cosine = 0.9;  // some 25 degrees
  for (const auto& [edge, list] : normals)
    if (list.size() != 2 || dot(list[0], list[1]) < cosine)
      put(mesh_.points[as_size(edge[0])]), put(mesh_.points[as_size(edge[1])]);
  return place('f', offset, (bytes_.size() - offset) / sizeof(float));
}

std::string PageArrays::text() const {
  z_stream stream{};
  constexpr int gzip = 15 + 16;
  if (deflateInit2(&stream, 9, Z_DEFLATED, gzip, 8, Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::runtime_error("zlib does not start");
  std::string packed(deflateBound(&stream, bytes_.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes_.data()));
  stream.avail_in = static_cast<uInt>(bytes_.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  const bool is_done = bytes_.size() <= std::numeric_limits<uInt>::max() &&
                       deflate(&stream, Z_FINISH) == Z_STREAM_END;
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  if (!is_done) throw std::length_error("the surfaces are too large for a page");
  return to_base64(packed);
}

std::string to_base64(std::string_view bytes) {
  std::string text((bytes.size() + 2) / 3 * 4 + 1, '\0');  // and a zero at the end
  // In parts that its argument can hold, of whole groups of three.
  constexpr std::size_t most = 3 << 20;
  std::size_t written = 0;
  for (std::size_t i = 0; i < bytes.size(); i += most) {
    const auto part = bytes.substr(i, most);
    written += static_cast<std::size_t>(
        EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data() + written),
                        reinterpret_cast<const unsigned char*>(part.data()),
                        static_cast<int>(part.size())));
  }
  text.resize(written);
  return text;
}

std::string policy_hash(std::string_view text) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int size = 0;
  if (EVP_Digest(text.data(), text.size(), digest.data(), &size, EVP_sha256(), nullptr) != 1)
    throw std::runtime_error("the cryptography library gives no SHA-256");
  return "'sha256-" + to_base64({reinterpret_cast<const char*>(digest.data()), size}) + "'";
}

}  // namespace tensortopo

// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace certificate {

/// The text with `?` for each character that is not seen, or changes how others are: names in files
/// are anything, and a terminal obeys them. These are controls, spaces but U+0020, what Unicode lets
/// displays ignore, private use, and bytes that are no UTF-8.
std::string printable(std::string_view text);

/// A file that cannot be read as what it should be; what() is "FILE: what is wrong", in one line.
class Malformed : public std::runtime_error {
 public:
  Malformed(const std::string& file, const std::string& problem)
      : std::runtime_error(printable(file + ": " + problem)), file_(file), problem_(problem) {}

  const std::string& file() const { return file_; }
  const std::string& problem() const { return problem_; }

 private:
  std::string file_, problem_;
};

/// A claim that is wrong, or could not be decided.
struct Finding {
  std::string entity, claimed, derived;
  /// Of a refutation, unless both values tell already: what a reader can check by hand, as points of
  /// a simplex, exactly, and on which sides of the level they are.
  std::string witness;
};

/// What came of the claims of one kind.
struct Verdicts {
  std::string kind;
  std::size_t certified = 0, refuted = 0, undecided = 0;
};

/// A connected component of a level's surface or curves, as the output's cells have it.
struct Component {
  long euler_characteristic = 0;   ///< of a surface
  std::size_t boundary_loops = 0;  ///< of a surface
  bool closed = false;             ///< of a curve
  std::size_t cells = 0;           ///< triangles or lines
};

/// What a certificate is about at one level, and what came of it. What is said of components holds
/// of the level if all of its claims are certified, and else is only what the output has.
struct LevelReport {
  std::string name;  ///< "mode 1/2", "magnitude 3/2"
  std::size_t certified = 0, refuted = 0, undecided = 0;
  std::vector<Component> components;
  std::map<std::string, std::vector<std::uint64_t>> left_out;  ///< tetrahedra, by reason
  std::string bound;       ///< of the distance, in the mesh's units; empty if none is claimed
  std::size_t bounded = 0;  ///< triangles to which the bound applies
  std::size_t coarse = 0;   ///< tetrahedra to which only the coarse bound applies
  std::string coarse_bound;
  /// At most by so much the mode, or other invariant, at the coordinates of vertices differs from the
  /// level's value; nothing if the triangles are not as claimed.
  std::optional<double> residual;
  bool near = false;       ///< whether these bounds are certified
  bool claims_embedded = false;  ///< that the triangles are
  bool embedded = false;         ///< whether that is certified
  std::size_t vertices = 0;  ///< of the surface
  /// Arrays of eigenvectors and normals: at how many vertices they are shown to be that.
  std::map<std::string, std::size_t> vectors;
  bool claims_isotopy = false;  ///< that triangles are isotopic to the level in tetrahedra
  std::size_t isotopic = 0;     ///< tetrahedra for which it is claimed and shown
  /// Tetrahedra with triangles for which it is not, by reason; not those left out.
  std::map<std::string, std::vector<std::uint64_t>> not_isotopic;
  double moved = 0;  ///< at most so far rounding has moved the vertices of those shown
  bool claims_stability = false;  ///< that components are in all fields within a radius
  double radius = 0;  ///< the largest, of an array
  std::string radius_array = {};  ///< the input's array that has one for each point, or empty
  bool radius_of_deviator = false;  ///< a share of each vertex' deviator, else in the tensor's units
  std::vector<std::uint64_t> stable_components;  ///< certified, by their smallest vertices
  std::size_t stable_crossings = 0;  ///< certified: edges, or faces of curves, crossed alike in all

  std::size_t left_out_count() const;
};

/// The files that a certificate is about.
struct Subject {
  std::string input, output, tensor;
  std::string order;            ///< of the components, by name: "vtk"
  std::string listing;          ///< the same spelled out: "XX YY ZZ XY YZ XZ"
  std::string names;            ///< as the input's file names them; empty if it does not
  bool names_say_order = false; ///< whether these names spell `order`
  std::string sha256;           ///< of the field's numbers, as derived
  std::size_t points = 0, tetrahedra = 0;
  std::size_t isotropic = 0;    ///< tetrahedra in which all tensors are, so that no mode is defined
  std::size_t other_cells = 0;  ///< of the input: neither tetrahedra nor faces, lines or points
  std::size_t flat_cells = 0;   ///< of the input: points, lines and faces, which have no volume
  std::size_t doubled_points = 0;  ///< of tetrahedra, at the place of another: surfaces are torn there
  std::size_t symmetrized = 0;  ///< tensors of nine components, of which two differ that should not
  bool of_curves = false;
  std::size_t vertices = 0, cells = 0;  ///< of the output
  std::vector<std::string> bound_only;  ///< arrays of which only the hash is compared
};

/// What a caller demands to be certified.
struct Demands {
  std::vector<std::string> modes;  ///< fractions or decimals: each must be a level
  std::string tensor;              ///< empty: any
  /// No tetrahedron may be left out, no other cell with a volume skipped, nor all be isotropic.
  bool complete = false;
};

/// What came of a certificate's claims, each counted once.
struct Report {
  std::size_t certified = 0, refuted = 0, undecided = 0;
  Subject subject;
  std::vector<LevelReport> levels;
  std::vector<Verdicts> kinds;  ///< the same by kind
  /// How many sides and proofs were settled by doubles with an error bound, and by integers.
  std::uint64_t by_balls = 0, by_integers = 0;
  std::vector<Finding> refutations;  ///< the first ones
  std::vector<Finding> open;         ///< the first undecided ones

  std::size_t claims() const { return certified + refuted + undecided; }
  /// "refuted" if one claim is, else "undecided" if one is, else "certified".
  std::string status() const;
  /// Which demands are not met, in words; none if all are. Throws std::invalid_argument for a mode
  /// that is no number.
  std::vector<std::string> unmet(const Demands& demands) const;
};

/// Told now and then, by the thread that called, what is derived and how much of it, in [0, 1].
using Progress = std::function<void(std::string_view what, double part)>;

/// Checks each claim of a certificate (proofs-check/certificate/FORMAT.md) about the field in
/// `input` (.vtu, .vtk) and the triangles in `surface` (.vtp), deriving the truth from the input's bits.
/// If `surface` is a .pvtp, a certificate of parts, about a .pvtu.
/// The report does not depend on the number of threads. Throws Malformed, std::bad_alloc.
/// Reads a field as a check does, and says how: all of `Subject` that is about the input. Throws
/// Malformed.
/// @param order  of the components, by name
Subject read_subject(const std::string& input, const std::string& tensor, const std::string& order);

Report check_certificate(const std::string& input, const std::string& surface,
                         const std::string& certificate, const Progress& progress = {});

/// @param unmet  demands that are not met
std::string to_text(const Report& report, const std::vector<std::string>& unmet = {});
std::string to_json(const Report& report, const std::vector<std::string>& unmet = {});

}  // namespace certificate

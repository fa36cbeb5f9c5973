// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/theory/trial.hpp"

#include <utility>

#include "tensortopo/tensor/mode.hpp"

namespace tensortopo::theory {
namespace {

Deviator<Rational> random_deviator(Random& random) {
  Deviator<Rational> d;
  for (Rational* entry : {&d.a, &d.b, &d.xy, &d.yz, &d.xz}) *entry = random.fraction();
  return d;
}

// Eigenvalues 2 B^2 - 2 A^2 apart from multiples of it: all of A^2 + B^2 = 1, B the larger one.
Frame frame_with_singularities(Random& random) {
  const Rational t = Rational(random.integer(1, 23)) / Rational(24), one(1);
  const Rational size = one + t * t;
  Rational a = (one - t * t) / size, b = (t + t) / size;
  if (b < a) std::swap(a, b);
  const Rational g(random.integer(1, 9)), aa = a * a, bb = b * b, three(3);
  const Rational middle = g * (bb - aa);
  return {{Rational(middle + three * g * aa), middle, Rational(middle - three * g * bb)},
          random_basis(random),
          std::array{a, b}};
}

Frame random_frame(Random& random, std::size_t kind) {
  if (kind == 6) return frame_with_singularities(random);
  Rational high(random.integer(1, 9)), middle(random.integer(0, 9));
  if (kind == 7) middle = 0;
  if (kind == 8) middle = high;
  if (high < middle) std::swap(high, middle);
  Frame frame = {{high, middle, Rational(-(high + middle))}, random_basis(random), std::nullopt};
  if (kind == 8) frame.singular = std::array{Rational(0), Rational(1)};
  return frame;
}

// Ranks below 4 as they come in practice: a vanishing tensor at a vertex, a plane of symmetry, a
// tensor that depends on the others.
void make_deficient(TetrahedronField<Rational>& field, Random& random) {
  auto& t = field.vertex;
  switch (random.integer(0, 2)) {
    case 0:
      t[3] = {};
      break;
    case 1:
      for (auto& d : t) d.yz = d.xz = 0;
      break;
    default:
      t[3] = random.fraction() * t[0] + random.fraction() * t[1] + random.fraction() * t[2];
  }
}

}  // namespace

Trial random_trial(std::uint64_t seed, std::size_t index) {
  // Two rounds, so that neighbouring seeds and neighbouring indices have nothing in common.
  Trial trial;
  trial.random = Random(Random(Random(seed).next() + index).next());
  Random& random = trial.random;
  const std::size_t kind = index % 10;
  if (kind >= 4 && kind <= 8) {
    trial.frame = random_frame(random, kind);
    const auto normal = tensor_of(trial.frame->eigenvalues, trial.frame->eigenvectors);
    trial.field = field_orthogonal_to(normal, random);
    return trial;
  }
  for (auto& d : trial.field.vertex) d = random_deviator(random);
  if (kind == 9) make_deficient(trial.field, random);
  return trial;
}

TetrahedronField<Rational> field_orthogonal_to(const SymmetricTensor<Rational>& tensor,
                                               Random& random) {
  TetrahedronField<Rational> field;
  const Deviator<Rational> normal = deviator(tensor);
  for (auto& d : field.vertex) {
    d = random_deviator(random);
    const Rational share = norm_form(normal, d) / norm_form(normal);
    d = d - share * normal;
  }
  return field;
}

Basis basis_of_quaternion(const std::array<int, 4>& quaternion) {
  const Rational w(quaternion[0]), x(quaternion[1]), y(quaternion[2]), z(quaternion[3]), two(2);
  const Rational size = Rational(1) / Rational(w * w + x * x + y * y + z * z);
  const Vector3<Rational> first = {w * w + x * x - y * y - z * z, two * (x * y + w * z),
                                   two * (x * z - w * y)};
  const Vector3<Rational> second = {two * (x * y - w * z), w * w - x * x + y * y - z * z,
                                    two * (y * z + w * x)};
  const Vector3<Rational> e1 = size * first, e2 = size * second;
  return {e1, e2, cross(e1, e2)};
}

Basis random_basis(Random& random) {
  const int w = random.nonzero(5), x = random.integer(-5, 5), y = random.integer(-5, 5),
            z = random.integer(-5, 5);
  return basis_of_quaternion({w, x, y, z});
}

SymmetricTensor<Rational> tensor_of(const std::array<Rational, 3>& eigenvalues,
                                    const Basis& basis) {
  SymmetricTensor<Rational> t;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3<Rational>& e = basis[i];
    const SymmetricTensor<Rational> projection = {e.x * e.x, e.y * e.y, e.z * e.z,
                                                  e.x * e.y, e.y * e.z, e.x * e.z};
    t = t + eigenvalues[i] * projection;
  }
  return t;
}

SymmetricTensor<Rational> tensor_at_random_point(const Trial& trial, Random& random) {
  const Rational x = random.fraction(), y = random.fraction(), z = random.fraction();
  return to_tensor(trial.field.at({Rational(1) - x - y - z, x, y, z}));
}

std::string text(const SymmetricTensor<Rational>& t) {
  return "[" + t.xx.str() + ", " + t.yy.str() + ", " + t.zz.str() + ", " + t.xy.str() + ", " +
         t.yz.str() + ", " + t.xz.str() + "]";
}

std::string text(const Vector3<Rational>& v) {
  return "(" + v.x.str() + ", " + v.y.str() + ", " + v.z.str() + ")";
}

std::string text(const TetrahedronField<Rational>& field) {
  std::string words;
  for (const auto& d : field.vertex) words += (words.empty() ? "" : " ") + text(to_tensor(d));
  return words;
}

}  // namespace tensortopo::theory

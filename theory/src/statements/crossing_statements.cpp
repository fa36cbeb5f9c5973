// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Where the lift of medium eigenvectors to the sphere jumps along mode curves.
#include "dominant_form.hpp"
#include "frames.hpp"
#include "groups.hpp"
#include "member.hpp"

namespace tensortopo::theory {
namespace {

// d.T (v x d), T characteristic.
Rational sigma_of(const Tensor& n, const Vector3<Rational>& v, const Vector3<Rational>& d) {
  return dot(d, n * cross(v, d));
}

// Of v and -v the one for which sigma is not positive: the vector with which the paper lists the
// tensor.
Vector3<Rational> lifted(const Tensor& n, const Vector3<Rational>& v, const Vector3<Rational>& d) {
  return sigma_of(n, v, d) > 0 ? -v : v;
}

struct CircleAngle {
  Rational cosine, sine;
};

// A point of the circle of tensors with the dominant eigenvector e3 and one parameter s; they lie
// in one plane, which is a mode curve's.
struct CirclePoint {
  Vector3<Rational> medium;
  Tensor tensor;
};
CirclePoint on_circle(const Rational& s, const CircleAngle& a, const Basis& e) {
  const Vector3<Rational> v = a.cosine * e[0] + a.sine * e[1];
  return {v, tensor_with(s, v, e[2])};
}

CircleAngle random_circle_angle(Random& random) {
  const Rational t = random.fraction(), size = Rational(1) + t * t;
  return {Rational((Rational(1) - t * t) / size), Rational((t + t) / size)};
}

void crossing_test(const Trial& trial, Facts<Rational>& facts) {
  Random random = trial.random;
  const Basis e = random_basis(random);
  const Rational s = fraction(random.integer(1, 23), 24);
  const Rational p(random.nonzero(9)), q(random.integer(-9, 9));
  // Any field with the circle in it.
  const Tensor n = p * product_of(e[2], e[0]) + q * product_of(e[2], e[1]);
  const std::array<CircleAngle, 2> angles = {random_circle_angle(random), random_circle_angle(random)};
  const Rational half = facts.claimed(1, 2);
  std::array<CirclePoint, 2> at;
  std::array<Rational, 2> sigma;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& [cosine, sine] = angles[i];
    at[i] = on_circle(s, angles[i], e);
    sigma[i] = sigma_of(n, at[i].medium, e[2]);
    facts.about([&] { return place(n, at[i].medium, s); });
    facts.zero("<T, t>", inner(n, at[i].tensor));
    facts.equal("sigma along the circle", sigma[i], half * (p * sine - q * cosine));
    facts.equal("sigma for the opposite vector", sigma_of(n, -at[i].medium, e[2]), -sigma[i]);
    facts.equal("sigma for the opposite dominant vector", sigma_of(n, at[i].medium, -e[2]),
                sigma[i]);
  }
  facts.configuration({s, Rational(q / p), angles[0].cosine, angles[1].cosine});
  // Where the vector is carried along by less than a right angle, the product of the lifted ones
  // shows whether sigma has changed its sign.
  const Rational turned = dot(at[0].medium, at[1].medium);
  if (turned == 0 || sigma[0] == 0 || sigma[1] == 0) return;
  const bool is_carried = turned > 0;
  const Vector3<Rational> second = is_carried ? at[1].medium : -at[1].medium;
  const bool has_crossed = sigma[0] * sigma_of(n, second, e[2]) < 0;
  const bool is_negative = dot(lifted(n, at[0].medium, e[2]), lifted(n, at[1].medium, e[2])) < 0;
  facts.holds("negative product of the lifted vectors where sigma changes its sign",
              is_negative == has_crossed);
  // Carried along by more than a right angle it shows the opposite.
  if (!is_carried) {
    const bool changes = sigma[0] * sigma[1] < 0;
    facts.holds("the opposite beyond a right angle", is_negative != changes);
  }
}

// Characteristic tensor yz: sigma is -cos(angle) along the circle of medium vectors (cos, sin, 0).
Outcome dot_product_fails() {
  const Tensor n = {0, 0, 0, 0, 1, 0};
  const Rational s = fraction(1, 2), three = fraction(3, 5), four = fraction(4, 5), zero(0), one(1);
  const auto product = [&](const CircleAngle& a, const CircleAngle& b) {
    const CirclePoint p = on_circle(s, a, axes()), q = on_circle(s, b, axes());
    return dot(lifted(n, p.medium, axes()[2]), lifted(n, q.medium, axes()[2]));
  };
  // From -53 to 53 degrees sigma stays negative; from 0 to 143 it changes its sign once.
  const Rational without = product({three, -four}, {three, four}),
                 with = product({one, zero}, {-four, three});
  if (without >= 0 || with <= 0) return Outcome::holds();
  return Outcome::violated(
      "characteristic tensor along " + text(n) +
      ", s = 1/2, dominant eigenvector (0, 0, 1): from medium (3/5, -4/5, 0) to (3/5, 4/5, 0) "
      "the boundary is not met and the product is " +
      without.str() + "; from (1, 0, 0) to (-4/5, 3/5, 0) it is met once and the product is " +
      with.str());
}

// v x M, M the traceless part of the characteristic tensor across v: the neutral tensor with medium
// eigenvector v, times |v|^4.
Tensor neutral_tensor(const Tensor& n, const Vector3<Rational>& v) {
  const Rational q = dot(v, v);
  const Vector3<Rational> image = n * v;
  const Rational alpha = dot(v, image);
  const Tensor m = q * q * n - Rational(Rational(2) * q) * product_of(v, image) +
                   alpha * projection_to(v) +
                   (alpha / Rational(2)) * (isotropic(q) - projection_to(v));
  const Vector3<Rational> x = cross(v, m * Vector3<Rational>{1, 0, 0}),
                          y = cross(v, m * Vector3<Rational>{0, 1, 0}),
                          z = cross(v, m * Vector3<Rational>{0, 0, 1});
  return {x.x, y.y, z.z, y.x, z.y, z.x};
}

struct SidesOfLine {
  Vector3<Rational> before, after;
  Tensor first, second;
};

// On either side of the line of a singularity, at the vectors s + k e and -s + k e.
SidesOfLine sides_of_line(const Tensor& n, const Vector3<Rational>& s, const Vector3<Rational>& e,
                          const Rational& k) {
  const Vector3<Rational> before = s + k * e, after = -s + k * e;
  return {before, after, neutral_tensor(n, before), neutral_tensor(n, after)};
}

// sin^2 of the angle between two tensors, times their squared norms.
Rational squared_sine(const Tensor& s, const Tensor& t) {
  const Rational product = inner(s, t);
  return inner(s, s) * inner(t, t) - product * product;
}

void neutral_lift(const Trial& trial, Facts<Rational>& facts) {
  Random random = trial.random;
  Rational a, b;
  const Values values = values_with_singularities(random, a, b);
  const Basis basis = random_basis(random);
  const Tensor n = tensor_of(values, basis);
  facts.configuration({values[1] / values[0]});
  const Vector3<Rational> any = random_basis(random)[2];
  const Rational minus = facts.claimed(-1);
  facts.about([&] { return place(n, any, Rational(0)); });
  facts.equal("tensors of v and -v", neutral_tensor(n, -any), minus * neutral_tensor(n, any));
  for (const Rational& sign : {Rational(1), Rational(-1)}) {
    const Vector3<Rational> s = Rational(sign * a) * basis[0] + b * basis[2];
    // The sides come close to each other: the squared sine falls with the square of the distance.
    std::array<Rational, 2> apart;
    for (std::size_t i = 0; i < 2; ++i) {
      const Rational k = i == 0 ? fraction(1, 100) : fraction(1, 1000);
      const SidesOfLine sides = sides_of_line(n, s, basis[1], k);
      facts.about([&] { return place(n, sides.before, Rational(0)); });
      for (const auto& [v, t] :
           {std::pair(sides.before, sides.first), std::pair(sides.after, sides.second)}) {
        facts.zero("<T, t>", inner(n, t));
        facts.zero("determinant", determinant(t));
        facts.equal("t v", t * v, Vector3<Rational>{0, 0, 0});
      }
      facts.positive("tensors of one sign on both sides", inner(sides.first, sides.second));
      facts.negative("product of the lifted vectors", dot(sides.before, sides.after));
      apart[i] = squared_sine(sides.first, sides.second) /
                 (inner(sides.first, sides.first) * inner(sides.second, sides.second));
    }
    facts.about([&] { return place(n, s, Rational(0)); });
    facts.positive("the tensors come together", facts.claimed(1, 50) * apart[0] - apart[1]);
  }
}

// Singularities along (+-3, 0, 4): A = 3/5 and B = 4/5.
Outcome lift_jumps_at_singular_line() {
  // (l1 - l2) / (l1 - l3) = 27/75 = 9/25.
  const Tensor n = {34, 7, -41, 0, 0, 0};
  const Vector3<Rational> s = {3, 0, 4}, e = {0, 1, 0};
  const SidesOfLine sides = sides_of_line(n, s, e, fraction(1, 10));
  const bool neutral = determinant(sides.first) == 0 && determinant(sides.second) == 0 &&
                       inner(sides.first, n) == 0 && inner(sides.second, n) == 0;
  const Rational norms = inner(sides.first, sides.first) * inner(sides.second, sides.second);
  const bool close = inner(sides.first, sides.second) > 0 &&
                     Rational(100) * squared_sine(sides.first, sides.second) < norms;
  if (!neutral || !close || dot(sides.before, sides.after) >= 0) return Outcome::holds();
  return Outcome::violated("characteristic tensor along " + text(n) +
                           ": neutral tensors with medium eigenvectors along " +
                           text(sides.before) + " and " + text(sides.after) +
                           ", on either side of the line of (3, 0, 4), are less than 6 degrees "
                           "apart, and so on ever closer to the line");
}

}  // namespace

std::vector<Statement> crossing_statements() {
  return {
      {.id = "crossing-test",
       .paper = "Mode Surface Extraction inside a Tetrahedron, dot product of medium eigenvectors",
       .claim = "A segment of a mode curve meets the boundary of the complex domain if and only if "
                "the product of the medium eigenvectors of its ends, lifted to the sphere, is "
                "negative.",
       .hypotheses = "two tensors of a mode curve on which the dominant eigenvector is constant",
       .corrected =
           "If the eigenvector turns by less than a right angle along the segment and the "
           "boundary is met once at most. What decides is the sign of sigma = d.T (v x d), "
           "with v carried along.",
       .flaws = {Flaw::substantive},
       .check = crossing_test,
       .paper_at_witness = dot_product_fails,
       .steps = {"boundary-crossing", "sigma-squared"},
       .reader = "Along a curve sigma is continuous if v is; it is zero exactly on the boundary."},
      {.id = "neutral-lift",
       .paper = "Neutral Surface Extraction, the two differences",
       .claim = "For neutral surfaces there is no complex domain, and no crossings of its boundary "
                "need to be detected.",
       .hypotheses = "a characteristic tensor with rational singularities and three eigenvalues",
       .corrected = "Of v and -v one has the tensor of positive weight, and that lift to the "
                    "sphere jumps across the line of a singularity s, from next to s to next to "
                    "-s: these crossings are to be detected. (On the projective plane, the paper's "
                    "medium eigenvector manifold, nothing jumps; but the pipeline is that of the "
                    "sphere.)",
       .flaws = {Flaw::substantive},
       .check = neutral_lift,
       .paper_at_witness = lift_jumps_at_singular_line,
       .steps = {"singular-lines", "singularities-plane"}},
  };
}

}  // namespace tensortopo::theory

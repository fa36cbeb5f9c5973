// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Coordinates of the sphere of medium eigenvectors, its singularities and its projections.
#include <algorithm>

#include "frames.hpp"
#include "groups.hpp"

namespace tensortopo::theory {
namespace {

// Cosine and sine of a rational half angle, squared.
struct SquaredAngle {
  Rational cosine, sine;
};
SquaredAngle random_squared_angle(Random& random) {
  const Rational t = random.fraction(), tt = t * t, size = Rational(1) + tt;
  const Rational c = (Rational(1) - tt) / size, s = (t + t) / size;
  return {c * c, s * s};
}

// A^2 and B^2: shares of the gaps between the characteristic eigenvalues.
struct Shares {
  Rational major, minor;
};
Shares shares_of(const Values& l) {
  const Rational width = l[0] - l[2];
  return {Rational((l[0] - l[1]) / width), Rational((l[1] - l[2]) / width)};
}

const auto quad_parameterization = [](const Trial& trial, auto& facts) {
  const auto values = characteristic_values(trial);
  if (!values) return facts.not_applicable(kNoFrame);
  Random random = trial.random;
  const auto theta = random_squared_angle(random), eta = random_squared_angle(random);
  const Shares shares = shares_of(*values);
  facts.configuration(shape_of(*values, {theta.cosine, eta.cosine}));
  const auto one = facts.claimed(1);
  const auto ct = facts.number(theta.cosine), st = facts.number(theta.sine);
  const auto ce = facts.number(eta.cosine), se = facts.number(eta.sine);
  const auto aa = facts.number(shares.major), bb = facts.number(shares.minor);
  const auto l = triple_in(facts, *values);
  const std::array m = {ct * (one - bb * ce), st * se, ce * (one - aa * ct)};
  facts.about([&] {
    return "characteristic eigenvalues as " + triple_text(*values) + ", cos^2 of theta and eta " +
           theta.cosine.str() + " and " + eta.cosine.str();
  });
  facts.equal("squared length of the vector", m[0] + m[1] + m[2], facts.claimed(1));
  // The eigenvalues of the projected tensor are functions of one coordinate each.
  const auto plus = l[1] + (l[0] - l[1]) * st, minus = l[1] - (l[1] - l[2]) * se;
  facts.equal("sum of the eigenvalues across v", -alpha_of(l, m), plus + minus);
  const auto half = facts.claimed(1, 2);
  const auto beta = l[0] * l[0] * m[0] + l[1] * l[1] * m[1] + l[2] * l[2] * m[2];
  facts.equal("product of the eigenvalues across v", beta - half * squared_norm(l), plus * minus);
};

// For eigenvalues (2, 1, -3): f = (2 + 3 - 2) / 4 - 1 is as printed (2 * 1 + 3 - 2) / (-3 - 1).
Outcome printed_parameterization() {
  const Values l = {2, 1, -3};
  const Rational f = (l[1] + l[1] - l[2] - l[0]) / (l[2] - l[1]);
  const SquaredAngle theta = {fraction(9, 25), fraction(16, 25)}, eta = theta;
  const Rational length =
      theta.cosine * (f * eta.cosine + 1) + theta.cosine * eta.sine + eta.cosine;
  if (length == 1) return Outcome::holds();
  return Outcome::violated("characteristic eigenvalues as " + triple_text(l) +
                           ", cosines of theta and eta 3/5: the printed vector has the squared "
                           "length " +
                           length.str() +
                           "; and its first two coordinates are multiples of cos(theta), so their "
                           "quotient does not depend on theta");
}

const auto straight_boundary = [](const Trial& trial, auto& facts) {
  Random random = trial.random;
  // A tensor whose restriction to the plane across v is diagonal, of determinant <= 0.
  const Basis basis = random_basis(random);
  Rational plus = random.fraction(), minus = random.fraction();
  if (plus < minus) std::swap(plus, minus);
  Tensor n = plus * projection_to(basis[0]) + minus * projection_to(basis[1]) -
             Rational(plus + minus) * projection_to(basis[2]) +
             random.fraction() * product_of(basis[0], basis[2]) +
             random.fraction() * product_of(basis[1], basis[2]);
  if (determinant(n) > 0) {
    n = Rational(-1) * n;
    const Rational former = plus;
    plus = -minus, minus = -former;
  }
  const Rational exact_s = random.part();
  const auto s = facts.number(exact_s), one = facts.claimed(1);
  const auto p = facts.number(plus), q = facts.number(minus);
  const auto first = (one - s) * p - (one + s) * q, second = (one + s) * p - (one - s) * q;
  const auto v = facts.vector(basis[2]);
  facts.about([&] { return place(n, basis[2], exact_s); });
  const auto form =
      boundary_form(facts.tensor(n), v, facts.claimed(1, 4) * (facts.number(1) - s * s));
  facts.equal("boundary function as a product", form, facts.claimed(1, 4) * first * second);
  facts.not_negative("the factor that does not vanish inside", second);
  if (boundary_form(n, basis[2], boundary_weight(exact_s)) < 0) {
    facts.negative("the straight factor in the complex domain", first);
  } else {
    facts.not_negative("the straight factor in the real domain", first);
  }
};

const auto singularity_lines = [](const Trial& trial, auto& facts) {
  using Scalar = ScalarOf<std::decay_t<decltype(facts)>>;
  Random random = trial.random;
  Rational a, b;
  Values values = values_with_singularities(random, a, b);
  Basis basis = random_basis(random);
  TetrahedronField<Rational> field;
  const bool is_known = characteristic_values(trial) && trial.frame->singular;
  if (is_known) {
    a = (*trial.frame->singular)[0], b = (*trial.frame->singular)[1];
    values = trial.frame->eigenvalues;
    basis = trial.frame->eigenvectors;
    field = trial.field;
  } else {
    field = field_orthogonal_to(tensor_of(values, basis), random);
    if (field_rank(field) != 4) return facts.not_applicable("rank below 4");
  }
  const Tensor exact = tensor_of(values, basis);
  const auto n = facts.tensor(exact);
  const Scalar medium = facts.number(values[1]);
  const Vector3<Rational>& e = basis[1];
  facts.configuration(shape_of(values));
  for (const Rational& sign : {Rational(1), Rational(-1)}) {
    const Vector3<Rational> s = Rational(sign * a) * basis[0] + b * basis[2];
    const Vector3<Rational> f = cross(s, e);
    facts.about([&] { return place(exact, s, Rational(0)); });
    // Across s the characteristic tensor is isotropic; so the traceless tensors with kernel s, a
    // plane of them, are all in the field: a line of points, if c = 0 is not all of it.
    const auto ee = facts.vector(e), ff = facts.vector(f);
    const Scalar factor = facts.claimed(1);
    facts.equal("T across s", dot(ee, n * ee), factor * medium);
    facts.equal("T across s", dot(ff, n * ff), factor * medium);
    facts.zero("T across s, mixed", dot(ee, n * ff));
    // By another way: of the field's own tensors those with kernel s are a plane, as the images of
    // s under the four have rank two.
    std::array<Vector3<Scalar>, 4> image;
    Scalar area(0);
    for (std::size_t i = 0; i < 4; ++i) {
      image[i] = facts.tensor(to_tensor(field.vertex[i])) * facts.vector(s);
      for (std::size_t j = 0; j < i; ++j) {
        const auto normal = cross(image[i], image[j]);
        area = area + dot(normal, normal);
        for (std::size_t k = 0; k < j; ++k) {
          facts.zero("volume of the images of s under three vertex tensors", dot(normal, image[k]));
        }
      }
    }
    facts.positive("area of the images under two", area);
    const Rational p(random.nonzero(9)), q(random.integer(-9, 9));
    const Tensor member = p * (projection_to(e) - projection_to(f)) + q * product_of(e, f);
    const auto t = facts.tensor(member);
    facts.zero("<T, t> of a tensor with kernel s", inner(n, t));
    facts.equal("t s", t * facts.vector(s), Vector3<Scalar>{Scalar(0), Scalar(0), Scalar(0)});
    // Eigenvalues r, 0, -r: neutral, and s the medium eigenvector.
    const Scalar half = facts.claimed(1, 2);
    facts.equal("t^3 and |t|^2 t / 2", square(t) * (t * ee), Scalar(half * inner(t, t)) * (t * ee));
  }
};

// [[4x, y, -1 - 2x], [y, -5x, z], [-1 - 2x, z, x]] and the singularity (1, 0, 2): T s = 0 asks for
// a vanishing weight of the constant part.
Outcome line_at_infinity() {
  const Tensor constant = {0, 0, 0, 0, 0, -1}, along_x = {4, -5, 1, 0, 0, -2},
               along_y = {0, 0, 0, 1, 0, 0}, along_z = {0, 0, 0, 0, 1, 0};
  const Vector3<Rational> s = {1, 0, 2};
  // Images of s: the constant part is the only one with a part along (2, 0, 1).
  const Vector3<Rational> image = constant * s;
  const Vector3<Rational> across = {2, 0, 1};
  const bool alone = dot(along_x * s, across) == 0 && dot(along_y * s, across) == 0 &&
                     dot(along_z * s, across) == 0 && dot(image, across) != 0;
  TetrahedronField<Rational> field;
  field.vertex = {deviator(constant), deviator(along_x), deviator(along_y), deviator(along_z)};
  const Tensor n = to_tensor(characteristic_direction(field));
  const Vector3<Rational> e = {0, 1, 0}, f = {2, 0, -1};
  const bool singular =
      n != Tensor{} && dot(e, n * f) == 0 && dot(f, n * f) == dot(f, f) * dot(e, n * e);
  if (!alone || !singular) return Outcome::holds();
  return Outcome::violated(
      "T = [[4x, y, -1-2x], [y, -5x, z], [-1-2x, z, x]], singularity along "
      "(1, 0, 2): T s = 0 only where the constant part has the weight 0: the "
      "line is at infinity");
}

template <class Scalar>
struct Projected {
  Scalar x, y, squares;
};

template <class Scalar>
Scalar determinant3(const Vector3<Scalar>& a, const Vector3<Scalar>& b, const Vector3<Scalar>& c) {
  return dot(a, cross(b, c));
}

const auto stereographic = [](const Trial& trial, auto& facts) {
  using Scalar = ScalarOf<std::decay_t<decltype(facts)>>;
  Random random = trial.random;
  const Basis basis = random_basis(random);
  const Vector3<Rational>& pole = basis[2];
  std::array<Vector3<Rational>, 4> exact;
  for (auto& v : exact) {
    v = random_basis(random)[0];
    if (v == pole) return facts.not_applicable("the pole itself was drawn");
  }
  std::vector<Rational> products;
  for (std::size_t i = 0; i < 4; ++i) {
    products.push_back(dot(pole, exact[i]));
    for (std::size_t j = 0; j < i; ++j) products.push_back(dot(exact[i], exact[j]));
  }
  facts.configuration(products);
  std::array<Vector3<Scalar>, 4> v;
  std::array<Projected<Scalar>, 4> at;
  Scalar denominators(1);
  for (std::size_t i = 0; i < 4; ++i) {
    v[i] = facts.vector(exact[i]);
    const Scalar below = Scalar(1) - dot(v[i], facts.vector(pole));
    const Scalar x = dot(v[i], facts.vector(basis[0])) / below,
                 y = dot(v[i], facts.vector(basis[1])) / below;
    at[i] = {x, y, x * x + y * y};
    denominators = denominators * below;
  }
  // Positive if the fourth image is in the circle of the three others, when these turn to the left.
  const auto relative = [&](std::size_t i) {
    return Vector3<Scalar>{at[i].x - at[3].x, at[i].y - at[3].y, at[i].squares - at[3].squares};
  };
  const Scalar in_circle = determinant3(relative(0), relative(1), relative(2));
  const Scalar side = determinant3(v[0] - v[3], v[1] - v[3], v[2] - v[3]);
  facts.about([&] {
    std::string words = "pole " + text(pole) + ", points";
    for (const auto& point : exact) words += " " + text(point);
    return words;
  });
  const Scalar twice = facts.claimed(2);
  facts.equal("in-circle determinant and side of the plane", in_circle * denominators,
              twice * side);
  // The conclusion, on the four points: a triangle of the hull whose cap does not hold the pole is
  // a Delaunay triangle of the images, and one whose cap does is not.
  for (std::size_t last = 0; last < 4; ++last) {
    std::array<std::size_t, 3> of{};
    for (std::size_t i = 0, k = 0; i < 4; ++i)
      if (i != last) of[k++] = i;
    const auto side_of_plane = [&](const Vector3<Rational>& p) {
      return determinant3<Rational>(exact[of[0]] - p, exact[of[1]] - p, exact[of[2]] - p);
    };
    const Rational of_fourth = side_of_plane(exact[last]), of_pole = side_of_plane(pole);
    if (of_fourth == 0 || of_pole == 0) continue;
    const auto place_in_plane = [&](std::size_t i) {
      const Rational below = Rational(1) - dot(exact[i], pole);
      const Rational x = dot(exact[i], basis[0]) / below, y = dot(exact[i], basis[1]) / below;
      return Vector3<Rational>{x, y, Rational(x * x + y * y)};
    };
    const auto other = place_in_plane(last);
    const auto row = [&](std::size_t i) { return place_in_plane(of[i]) - other; };
    const auto corner = [&](std::size_t i) {
      const auto p = place_in_plane(of[i]);
      return Vector3<Rational>{p.x, p.y, Rational(1)};
    };
    const Rational inside =
        determinant3(row(0), row(1), row(2)) * determinant3(corner(0), corner(1), corner(2));
    // The fourth on the pole's side: the empty cap is the other one, without the pole.
    const bool is_kept = inside < 0, pole_in_empty_cap = (of_fourth > 0) != (of_pole > 0);
    facts.holds("kept exactly if the pole is not in the empty cap", is_kept == !pole_in_empty_cap);
  }
  const auto flat = [&](std::size_t i) { return Vector3<Scalar>{at[i].x, at[i].y, Scalar(1)}; };
  const Scalar turn = determinant3(flat(0), flat(1), flat(2));
  const auto p = facts.vector(pole);
  const Scalar side_of_pole = determinant3(v[0] - p, v[1] - p, v[2] - p);
  const Scalar below_fourth = Scalar(1) - dot(v[3], p), minus = facts.claimed(-1);
  facts.equal("turn of the images and side of the pole", turn * denominators,
              minus * below_fourth * side_of_pole);
};

// Three points around the pole and one below: the cap of the three that holds the pole is empty,
// so they are a facet of the hull; in the plane the fourth image is in their circle.
Outcome pole_in_an_empty_cap() {
  const Rational p = fraction(3, 5), h = fraction(4, 5);
  const std::array<Vector3<Rational>, 3> around = {{{p, 0, h}, {0, p, h}, {-p, 0, h}}};
  const Vector3<Rational> below = {0, 0, -1}, pole = {0, 0, 1};
  const auto side_of = [&](const Vector3<Rational>& v) {
    return determinant3(Vector3<Rational>(around[0] - v), Vector3<Rational>(around[1] - v),
                        Vector3<Rational>(around[2] - v));
  };
  // Images x / (1 - z): at radius 3, and the origin.
  const bool in_circle = below.x == 0 && below.y == 0 && p / (Rational(1) - h) == 3;
  if (side_of(below) * side_of(pole) >= 0 || !in_circle) return Outcome::holds();
  return Outcome::violated("pole (0, 0, 1), points " + text(around[0]) + ", " + text(around[1]) +
                           ", " + text(around[2]) + " and " + text(below) +
                           ": the first three are a Delaunay triangle of the sphere, with the "
                           "pole in its empty cap, but their image has that of the fourth inside");
}

}  // namespace

std::vector<Statement> sphere_statements() {
  const std::string frame =
      "a field of rank 4 whose characteristic tensor has rational eigenvectors";
  return {
      {.id = "quad-parameterization",
       .paper = "Mode Surface Extraction inside a Tetrahedron, quad parameterization",
       .claim = "(cos(theta) sqrt(f cos^2(eta) + 1), cos(theta) sin(eta), cos(eta)) covers the "
                "sphere by a grid of quadrilaterals whose irregular points are the "
                "singularities.",
       .hypotheses = frame,
       .corrected = "With sin(theta) sin(eta) for y, one letter of the print, and divided by its "
                    "length. Another chart, used here, has unit vectors as it stands: (cos(theta) "
                    "sqrt(1 - B^2 cos^2(eta)), sin(theta) sin(eta), cos(eta) sqrt(1 - A^2 "
                    "cos^2(theta))) with A^2 = (l1 - l2)/(l1 - l3), B^2 = (l2 - l3)/(l1 - l3).",
       .sharper = "In that chart, sphero-conal coordinates, the eigenvalues of the projected "
                  "characteristic tensor are l2 + (l1 - l2) sin^2(theta) and l2 - (l2 - l3) "
                  "sin^2(eta).",
       .special = "At mode -1 of the characteristic tensor they are spherical coordinates.",
       .flaws = {Flaw::wording},
       .check = quad_parameterization,
       .paper_at_witness = printed_parameterization,
       .steps = {"quads", "quad-factor", "sphero-conal-unit", "sphero-conal-orthogonal",
                 "sphero-conal-metric", "sphero-conal-eigenvalues"},
       .reader = "That the chart covers the sphere once but for its four irregular points."},
      {.id = "straight-boundary",
       .paper = "none (the boundary of the complex domain in the quad parameterization)",
       .claim = "With d+ >= d- the eigenvalues of the projected characteristic tensor, the complex "
                "domain is where d- > d+ (1 - s)/(1 + s): beyond a straight segment.",
       .hypotheses = "a characteristic tensor with rational d+, d- and v",
       .check = straight_boundary,
       .steps = {"boundary-factors", "boundary-factor-sign", "boundary-straight"}},
      {.id = "singularity-lines",
       .paper = "Neutral Surface Extraction, singularities",
       .claim = "Each singularity belongs to a straight line of the neutral surface.",
       .hypotheses = "a field of rank 4 with rational singularities",
       .corrected = "In projective space; the line can be at infinity. It is the set of the "
                    "field's tensors that map the singularity to 0, all with it as medium "
                    "eigenvector.",
       .special = "At mode -1 of the characteristic tensor the two lines are one.",
       .flaws = {Flaw::projective},
       .check = singularity_lines,
       .paper_at_witness = line_at_infinity,
       .steps = {"singular-lines", "singularities-plane"}},
      {.id = "stereographic-delaunay",
       .paper = "Mode Surface Extraction inside a Tetrahedron, stereographic projection",
       .claim = "Stereographic projection keeps the Delaunay property, because it maps circles to "
                "circles.",
       .hypotheses = "four rational points of the sphere and a rational pole",
       .corrected = "A point is inside the image of a circle exactly if the circle's plane "
                    "separates it from the pole: all Delaunay triangles are kept but those with "
                    "the pole in their empty cap. So the pole must lie outside the region.",
       .flaws = {Flaw::substantive},
       .check = stereographic,
       .paper_at_witness = pole_in_an_empty_cap,
       .reader = "A Delaunay triangle of points on a sphere is a facet of their hull."},
  };
}

}  // namespace tensortopo::theory

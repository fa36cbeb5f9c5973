// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// kernel_values COUNT SEED: the checker's forms of COUNT random simplices with small integer
// entries, and its answers about them, one simplex a line, for compare.ml.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <random>

#include "mode_rule.hpp"

namespace {

using certificate::Tensor;

std::mt19937_64 generator;
int number(int size) { return static_cast<int>(generator() % static_cast<unsigned>(2 * size + 1)) - size; }

template <std::size_t V, std::size_t D>
void print(const certificate::Polynomial<std::int64_t, V, D>& p) {
  for (const std::int64_t c : p.coefficients) std::printf(" %lld", static_cast<long long>(c));
}

/// @param alike  the corners are close to each other, so that many are on one side of the level
template <std::size_t V>
void print_simplex(bool alike) {
  Tensor<std::int64_t> base{};
  for (std::size_t k = 0; k < 6; ++k) base[k] = alike ? number(8) : 0;
  std::array<Tensor<std::int64_t>, V> corners{};
  std::array<const Tensor<std::int64_t>*, V> pointers{};
  std::array<int, V> direction{};
  std::printf("%zu", V);
  for (std::size_t i = 0; i < V; ++i) {
    pointers[i] = &corners[i];
    for (std::size_t k = 0; k < 6; ++k) {
      corners[i][k] = base[k] + number(alike ? 1 : 9);
      std::printf(" %lld", static_cast<long long>(corners[i][k]));
    }
  }
  for (int& d : direction) std::printf(" %d", d = number(9));
  const std::int64_t num = number(9), den = 19 + number(9);
  std::printf(" %lld %lld", static_cast<long long>(num), static_cast<long long>(den));
  const certificate::Forms<std::int64_t, V> f(pointers);
  print(f.p);
  print(f.q);
  print(increase(f, direction));
  print(combination<std::int64_t>(54 * den * den, f.q * f.q, -num * num, f.p * f.p * f.p));
  std::array<Tensor<mpz_class>, V> exact{};
  std::array<const Tensor<mpz_class>*, V> exact_pointers{};
  for (std::size_t i = 0; i < V; ++i) {
    for (std::size_t k = 0; k < 8; ++k) exact[i][k] = static_cast<long>(corners[i][k]);
    exact_pointers[i] = &exact[i];
  }
  const certificate::ModeRule rule(mpz_class(static_cast<long>(num)),
                                   mpz_class(static_cast<long>(den)));
  const certificate::Forms<mpz_class, V> g(exact_pointers);
  for (const bool above : {true, false})
    std::printf(" %d", rule.lies(above, g) == certificate::Answer::yes ? 1 : 0);
  std::putchar('\n');
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("usage: kernel_values COUNT SEED\n", stderr);
    return 2;
  }
  const long count = std::atol(argv[1]);
  generator.seed(static_cast<std::uint64_t>(std::atol(argv[2])));
  // One tetrahedron and three triangles to every six edges.
  for (long n = 0; n < count; ++n) {
    const bool alike = n % 20 < 10;
    if (n % 10 == 0) print_simplex<4>(alike);
    else if (n % 10 < 4) print_simplex<3>(alike);
    else print_simplex<2>(alike);
  }
  return 0;
}

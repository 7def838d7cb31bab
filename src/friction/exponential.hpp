#pragma once

#include <array>
#include <bit>
#include <cstdint>

// Elementary functions of a law's inner step. Libm's cost 6 to 20 ns a call; these are inlined, exact to a
// few units in the last place on the ranges named, and the same on every CPU.

namespace fingerpad {

/// 2^(-i/32), rounded once.
inline constexpr std::array<double, 32> powers_of_half = [] {
  std::array<double, 32> table{};
  for (int i = 0; i < 32; ++i) {
    const long double x = -i * 0.693147180559945309417232121458L / 32;
    long double sum = 1, term = 1;
    for (int k = 1; k < 30; ++k) sum += term *= x / k;
    table[static_cast<std::size_t>(i)] = static_cast<double>(sum);
  }
  return table;
}();

/// e^(-x) for 0 <= x < 700, to 3e-16 of itself.
inline double exp_of_minus(double x) noexcept {
  // x = k ln2/32 - r with |r| <= ln2/64; ln2/32 in two parts, the first short enough for an exact product.
  constexpr double high = 0x1.62e42fefa0000p-6, low = 0x1.cf79abc9e3b3ap-45;
  const double above = x * (32 / 0.693147180559945309) + 0.5;  // >= 0: cut off, it is the nearest
  const auto k = static_cast<std::int64_t>(above);
  const auto steps = static_cast<double>(k);
  const double r = (steps * high - x) + steps * low;
  const double r2 = r * r;
  const double grown =
      r + r2 * ((1.0 / 2 + r * (1.0 / 6)) + r2 * ((1.0 / 24 + r * (1.0 / 120)) + r2 * (1.0 / 720)));
  const auto bits = std::bit_cast<std::uint64_t>(powers_of_half[static_cast<std::size_t>(k & 31)]);
  const auto scale = std::bit_cast<double>(bits - (static_cast<std::uint64_t>(k >> 5) << 52));
  return scale + scale * grown;
}

/// 1 - e^(-x) and (1 - e^(-x))/x.
struct Yielding {
  double share, per_x;
};

/// For x > 0, both to 1e-13 of themselves.
inline Yielding yielding(double x) noexcept {
  if (x > 1e-3) {
    const double per_x = 1 / x;  // beside the exponential, not after it
    const double share = x < 40 ? 1 - exp_of_minus(x) : 1;
    return {share, share * per_x};
  }
  const double per_x = 1 - x * (1.0 / 2 - x * (1.0 / 6 - x * (1.0 / 24)));
  return {x * per_x, per_x};
}

/// sin(pi u) for |u| <= 1/2, to 3e-16: its series as far as u^21, summed in pairs.
inline double sine_of_half_turns(double u) noexcept {
  const double q = u * u, q2 = q * q, q4 = q2 * q2;
  const double low =
      (3.141592653589793 + q * -5.16771278004997) + q2 * (2.5501640398773455 + q * -0.5992645293207921);
  const double middle = (0.08214588661112823 + q * -0.0073704309457143504) +
                        q2 * (0.00046630280576761255 + q * -2.1915353447830217e-05);
  const double high = (7.952054001475513e-07 + q * -2.2948428997269873e-08) + q2 * 5.392664662608129e-10;
  return u * (low + q4 * (middle + q4 * high));
}

/// x^(-1/3) for x in 1e-290 .. 1e290, to 5e-16 of itself; finite for 0.
inline double inverse_cube_root(double x) noexcept {
  // A third of the exponent, by whole numbers: within 4 %. Three steps of third order follow.
  double y = std::bit_cast<double>(0x553ef0ff289dd796ull - std::bit_cast<std::uint64_t>(x) / 3);
  for (int i = 0; i < 3; ++i) {
    const double off = 1 - x * y * (y * y);
    y += y * off * (1.0 / 3 + off * (2.0 / 9));
  }
  return y;
}

}  // namespace fingerpad

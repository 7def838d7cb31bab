#pragma once

#include <cmath>

namespace fingerpad::four_floats {

/// Four floats that are reckoned with as one: what every machine has an instruction for.
using FourFloats [[gnu::vector_size(16)]] = float;

/// @pre a multiple of 16 bytes
inline FourFloats load(const float* lanes) noexcept {
  return *reinterpret_cast<const FourFloats*>(lanes);
}

#if defined(__SSE__)
inline FourFloats greater_of(const FourFloats& a, const FourFloats& b) noexcept {
  return __builtin_ia32_maxps(a, b);
}
inline FourFloats lesser_of(const FourFloats& a, const FourFloats& b) noexcept {
  return __builtin_ia32_minps(a, b);
}
inline FourFloats root_of(const FourFloats& a) noexcept {
  return __builtin_ia32_sqrtps(a);
}
/// A bit for each lane that is all ones.
template <class AllOrNothing>
unsigned to_mask(const AllOrNothing& lanes) noexcept {
  using AnyFour [[gnu::vector_size(16), gnu::may_alias]] = float;
  return static_cast<unsigned>(__builtin_ia32_movmskps(reinterpret_cast<const AnyFour&>(lanes)));
}
#else
inline FourFloats greater_of(const FourFloats& a, const FourFloats& b) noexcept {
  return a > b ? a : b;
}
inline FourFloats lesser_of(const FourFloats& a, const FourFloats& b) noexcept {
  return a < b ? a : b;
}
inline FourFloats root_of(const FourFloats& a) noexcept {
  return FourFloats{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
}
template <class AllOrNothing>
unsigned to_mask(const AllOrNothing& lanes) noexcept {
  unsigned mask = 0;
  for (int k = 0; k < 4; ++k) mask |= static_cast<unsigned>(lanes[k] & 1) << k;
  return mask;
}
#endif

}  // namespace fingerpad::four_floats

#include "contact/packet_gathering.hpp"

#include <cmath>

#include "contact/float_lanes.hpp"

namespace fingerpad {
namespace {

constexpr std::size_t four_wide = 4;  // lanes of a double
using Doubles [[gnu::vector_size(sizeof(double) * four_wide)]] = double;
using Four [[gnu::vector_size(sizeof(float) * four_wide)]] = float;

/// Four discs side by side, as PacketDiscs has eight.
struct FourDiscs {
  Four centre[3], across[3], radius, thick;
};

/// Of four rows of four the columns.
FINGERPAD_INLINED void transpose(const Four* row, Four* column) noexcept {
  const Four low = __builtin_shufflevector(row[0], row[1], 0, 4, 1, 5),
             low_next = __builtin_shufflevector(row[2], row[3], 0, 4, 1, 5),
             high = __builtin_shufflevector(row[0], row[1], 2, 6, 3, 7),
             high_next = __builtin_shufflevector(row[2], row[3], 2, 6, 3, 7);
  column[0] = __builtin_shufflevector(low, low_next, 0, 1, 4, 5);
  column[1] = __builtin_shufflevector(low, low_next, 2, 3, 6, 7);
  column[2] = __builtin_shufflevector(high, high_next, 0, 1, 4, 5);
  column[3] = __builtin_shufflevector(high, high_next, 2, 3, 6, 7);
}

/// Four of a gathering's discs from `first` on; where it has fewer, its last again.
FINGERPAD_INLINED void load(FourDiscs& four, const PacketDisc* discs, const std::uint32_t* packet,
                            std::size_t first, std::size_t count) noexcept {
  static_assert(sizeof(PacketDisc) == 2 * sizeof(Four));
  Four row[2][four_wide], column[2][four_wide];
  for (std::size_t k = 0; k < four_wide; ++k) {
    const Four* disc = reinterpret_cast<const Four*>(&discs[packet[std::min(first + k, count - 1)]]);
    row[0][k] = disc[0];
    row[1][k] = disc[1];
  }
  transpose(row[0], column[0]);
  transpose(row[1], column[1]);
  for (int i = 0; i < 3; ++i) {
    four.centre[i] = column[0][i];
    four.across[i] = column[1][i];
  }
  four.radius = column[0][3];
  four.thick = column[1][3];
}

FINGERPAD_INLINED void take_roots(Doubles& v) noexcept {
#if defined(__SSE2__)
  // By shuffles, see float_lanes::take_roots.
  using Two [[gnu::vector_size(16)]] = double;
  const Two low = __builtin_ia32_sqrtpd(__builtin_shufflevector(v, v, 0, 1)),
            high = __builtin_ia32_sqrtpd(__builtin_shufflevector(v, v, 2, 3));
  v = __builtin_shufflevector(low, high, 0, 1, 2, 3);
#else
  for (std::size_t i = 0; i < four_wide; ++i) v[i] = std::sqrt(v[i]);
#endif
}

FINGERPAD_INLINED Doubles at_least_zero(const Doubles& v) noexcept {
  return v > Doubles{} ? v : Doubles{};
}

/// The square of the way beside the disc is a quadratic function of the place on the way; what it is taken
/// for is no larger anywhere: `across` is of length 1 up to a float's rounding, and `lost` is more than what
/// its terms lose in double.
FINGERPAD_INLINED void measure(const PacketDisc* discs, const PathPiece& way,
                               PacketGathering& gathering) noexcept {
  constexpr double shorter = 1 - 1e-6, longer = 1 + 1e-6, lost = 1e-14, least = 1e-300;
  const double half2 = way.half.squaredNorm();
  for (std::size_t first = 0; first < gathering.count; first += four_wide) {
    FourDiscs four;
    load(four, discs, gathering.packet.data(), first, gathering.count);
    Doubles height = {}, rise = {}, off2 = {}, off_half = {};
    for (int i = 0; i < 3; ++i) {
      const Doubles across = __builtin_convertvector(four.across[i], Doubles),
                    off = way.middle[i] - __builtin_convertvector(four.centre[i], Doubles);
      height += across * off;
      rise += across * way.half[i];
      off2 += off * off;
      off_half += off * way.half[i];
    }
    const Doubles bend = half2 - rise * rise * longer, slope = off_half - height * rise * longer;
    const Doubles upward = at_least_zero(bend), sunk = bend - upward;
    Doubles at = -slope / (upward + least);
    at = at > 1 ? Doubles{} + 1 : at;
    at = at < -1 ? Doubles{} - 1 : at;
    Doubles along = at_least_zero(off2 - height * height * longer + at * (2 * slope + at * upward) + sunk -
                                  lost * (off2 + half2));
    take_roots(along);
    height = height < Doubles{} ? -height : height;
    rise = rise < Doubles{} ? -rise : rise;
    const Doubles above = at_least_zero(at_least_zero(height - rise) * shorter -
                                        __builtin_convertvector(four.thick, Doubles)),
                  beside = at_least_zero(along - __builtin_convertvector(four.radius, Doubles));
    *reinterpret_cast<Doubles*>(gathering.distance2.data() + first) = above * above + beside * beside;
  }
}

void plain(const PacketDisc* discs, const PathPiece& way, PacketGathering& gathering) noexcept {
  measure(discs, way, gathering);
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] void with_avx2_measure(const PacketDisc* discs, const PathPiece& way,
                                               PacketGathering& gathering) noexcept {
  measure(discs, way, gathering);
}
#endif

/// Of more than a list holds leaves those that are nearer than the first that it cannot hold; returns the
/// square of that one's distance.
double leave_nearest(PacketGathering& gathering) noexcept {
  std::array<double, PacketGathering::most> sorted{};
  std::copy_n(gathering.distance2.begin(), gathering.count, sorted.begin());
  const auto first_out = sorted.begin() + PacketList::most;
  std::nth_element(sorted.begin(), first_out, sorted.begin() + static_cast<std::ptrdiff_t>(gathering.count));
  std::size_t kept = 0;
  for (std::size_t i = 0; i < gathering.count; ++i) {
    if (!(gathering.distance2[i] < *first_out)) continue;
    gathering.packet[kept] = gathering.packet[i];
    gathering.distance2[kept++] = gathering.distance2[i];
  }
  gathering.count = kept;
  return *first_out;
}

}  // namespace

DiscMeasure plain_disc_measure() noexcept {
  return plain;
}

DiscMeasure fastest_disc_measure() noexcept {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) return with_avx2_measure;
#endif
  return plain;
}

double put_into(PacketList& list, const PacketDisc* discs, const Vec3& anchor, double within,
                PacketGathering& gathering) noexcept {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < gathering.count; ++i) {
    gathering.packet[kept] = gathering.packet[i];
    gathering.distance2[kept] = gathering.distance2[i];
    kept += gathering.distance2[i] <= within * within ? 1 : 0;
  }
  gathering.count = kept;
  const double clear = kept > PacketList::most ? std::sqrt(leave_nearest(gathering)) : within;

  list.count = static_cast<int>(gathering.count);
  list.anchor = anchor;
  Four spread = {};
  for (std::size_t first = 0; first < gathering.count; first += four_wide) {
    FourDiscs four;
    load(four, discs, gathering.packet.data(), first, gathering.count);
    PacketDiscs& into = list.discs[first / packet_width];
    const std::size_t lane = first % packet_width;
    const auto put = [lane](TrianglePacket::Lanes& lanes, const Four& v) {
      *reinterpret_cast<Four*>(lanes.data() + lane) = v;
    };
    Four reaches = four.radius + four.thick;
    for (int i = 0; i < 3; ++i) {
      const auto axis = static_cast<std::size_t>(i);
      const Four centre = four.centre[i] - static_cast<float>(anchor[i]);
      put(into.centre[axis], centre);
      put(into.across[axis], four.across[i]);
      reaches += centre < Four{} ? -centre : centre;
    }
    put(into.radius, four.radius);
    put(into.thick, four.thick);
    spread = reaches > spread ? reaches : spread;
  }
  std::copy_n(gathering.packet.begin(), gathering.count, list.packet.begin());
  list.spread = std::max(std::max(spread[0], spread[1]), std::max(spread[2], spread[3]));
  return clear;
}

}  // namespace fingerpad

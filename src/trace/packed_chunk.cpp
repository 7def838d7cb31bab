// A chunk through HDF5's shuffle and deflate, beside HDF5: that library does it under one lock for all
// threads.
#include <zlib.h>

#include "trace/hdf5_internal.hpp"

namespace fingerpad::hdf5 {
namespace {

/// Shuffling is the first filter of a column, deflating the second: a bit each.
constexpr std::uint32_t deflate_bit = 2;

/// First bytes of all values, then second ones: neighbours are alike then.
void shuffle(std::span<const std::byte> from, std::size_t value_bytes, std::byte* out) noexcept {
  const std::size_t count = from.size() / value_bytes;
  for (std::size_t byte = 0; byte < value_bytes; ++byte) {
    const std::byte* source = from.data() + byte;
    for (std::size_t i = 0; i < count; ++i) *out++ = source[i * value_bytes];
  }
}

}  // namespace

ChunkBytes packed_chunk(std::span<const std::byte> chunk, std::size_t value_bytes,
                        std::vector<std::byte>& room) {
  uLongf packed_bytes = compressBound(static_cast<uLong>(chunk.size()));
  room.resize(chunk.size() + packed_bytes);
  shuffle(chunk, value_bytes, room.data());
  std::byte* packed = room.data() + chunk.size();
  const int status =
      compress2(reinterpret_cast<Bytef*>(packed), &packed_bytes, reinterpret_cast<const Bytef*>(room.data()),
                static_cast<uLong>(chunk.size()), deflate_level);
  if (status != Z_OK || packed_bytes >= chunk.size())
    return {std::span(room.data(), chunk.size()), deflate_bit};
  return {std::span(packed, packed_bytes), 0};
}

}  // namespace fingerpad::hdf5

#include "base/content_hash.hpp"

#include <fmt/format.h>

#include <array>
#include <limits>

#include "base/input_file.hpp"

namespace fingerpad {

std::uint64_t content_hash(std::span<const std::byte> bytes, std::uint64_t seed) noexcept {
  std::uint64_t hash = seed;
  for (const std::byte b : bytes) hash = (hash ^ static_cast<std::uint64_t>(b)) * 1099511628211ull;
  return hash;
}

std::string file_hash(const std::string& path) {
  InputFile file(path, {"what is hashed", std::numeric_limits<std::uint64_t>::max()});
  std::array<char, 1 << 16> block{};
  std::uint64_t hash = content_hash({});
  while (const std::size_t count = file.read(block.data(), block.size())) {
    hash = content_hash(std::as_bytes(std::span(block.data(), count)), hash);
  }
  return fmt::format("{:016x}", hash);
}

}  // namespace fingerpad

#include "base/content_hash.hpp"

#include <fmt/format.h>

#include <array>
#include <fstream>

#include "base/error.hpp"

namespace fingerpad {

std::uint64_t content_hash(std::span<const std::byte> bytes, std::uint64_t seed) noexcept {
  std::uint64_t hash = seed;
  for (const std::byte b : bytes) hash = (hash ^ static_cast<std::uint64_t>(b)) * 1099511628211ull;
  return hash;
}

std::string file_hash(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw refused(path, "cannot be read");
  std::array<char, 1 << 16> block{};
  std::uint64_t hash = content_hash({});
  while (file) {
    file.read(block.data(), block.size());
    hash =
        content_hash(std::as_bytes(std::span(block.data(), static_cast<std::size_t>(file.gcount()))), hash);
  }
  return fmt::format("{:016x}", hash);
}

}  // namespace fingerpad

#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace fingerpad {

/// FNV-1a, 64 bits (Fowler, Noll, Vo): tells files apart by content; no defence against forgery.
/// Chain calls by passing the last result as `seed`.
std::uint64_t content_hash(std::span<const std::byte> bytes,
                           std::uint64_t seed = 14695981039346656037ull) noexcept;

/// The hash of a whole file as 16 hex digits. Throws Error (refused) if it cannot be read.
std::string file_hash(const std::string& path);

}  // namespace fingerpad

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace fingerpad {

/// Writes to an HDF5 file that are held back, and then made in an order that leaves the file whole wherever a
/// process is killed. First comes what the file begins with, which says how long it is; then what is new,
/// which nothing points to yet; then what stood there before, from the start to the end: of a tree of chunks
/// the root stands before its leaves, and a leaf gives a chunk away only when the root knows who has it. (A
/// killed process may have written a part of what it was about to, but only up to the end of a page of
/// memory.)
class HeldWrites {
 public:
  /// Holds a copy. False if it overlaps what is held, or there is no memory: release() first, then write it.
  bool hold(std::uint64_t at, std::span<const std::byte> bytes) noexcept;

  /// @param new_from  from here on nothing has been written yet
  /// @param write     (std::uint64_t at, std::span<const std::byte>), does not throw
  template <typename Write>
  void release(std::uint64_t new_from, const Write& write) noexcept {
    put_in_order(new_from);
    for (const Held& held : held_)
      write(held.at, std::span<const std::byte>(bytes_).subspan(held.first, held.size));
    held_.clear();
    bytes_.clear();
  }

 private:
  struct Held {
    std::uint64_t at;         // in the file
    std::size_t first, size;  // in bytes_
  };
  void put_in_order(std::uint64_t new_from) noexcept;

  std::vector<Held> held_;
  std::vector<std::byte> bytes_;
};

}  // namespace fingerpad

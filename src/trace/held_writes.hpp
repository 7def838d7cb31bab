#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace fingerpad {

/// Writes to an HDF5 file that are held back, and then made in an order that leaves the file whole wherever a
/// process is killed: first what the file begins with, which says how long it is, then from its end to its
/// start, page by page. What was added stands behind what points to it, and how many entries a list has
/// stands in front of them; so what is new is there before anything says that it is. (A killed process may
/// have written a part of what it was about to, but only up to the end of a page of memory.)
class HeldWrites {
 public:
  /// Holds a copy. False if it overlaps what is held, or there is no memory: release() first, then write it.
  bool hold(std::uint64_t at, std::span<const std::byte> bytes) noexcept;

  /// @param write  (std::uint64_t at, std::span<const std::byte>), does not throw
  template <typename Write>
  void release(const Write& write) noexcept {
    put_in_order();
    for (const Held& held : held_) {
      for (std::size_t end = held.size; end > 0;) {
        const std::size_t start = start_of_page(held.at, end);
        write(held.at + start, std::span(bytes_).subspan(held.first + start, end - start));
        end = start;
      }
    }
    held_.clear();
    bytes_.clear();
  }

 private:
  struct Held {
    std::uint64_t at;         // in the file
    std::size_t first, size;  // in bytes_
  };
  void put_in_order() noexcept;
  static std::size_t start_of_page(std::uint64_t at, std::size_t end) noexcept;

  std::vector<Held> held_;
  std::vector<std::byte> bytes_;
};

}  // namespace fingerpad

#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "contact/contact_method.hpp"

namespace fingerpad {

/// What a contact method answered tick by tick, bit for bit: 72 bytes a tick where one surface holds the
/// finger, 8 where none does, up to 256 where three do.
class ContactTape {
 public:
  /// @param ticks       that are to come
  /// @param most_bytes  it does not grow beyond
  ContactTape(long ticks, std::size_t most_bytes);

  /// Takes the next tick's answer. One that does not fit spoils the tape. noexcept, allocates nothing.
  void append(const Contact& contact) noexcept;
  /// From now on it is of no use.
  void spoil() noexcept { is_spoiled_ = true; }
  /// Whether it has all the ticks that were to come.
  bool is_whole() const noexcept { return !is_spoiled_ && ticks_ == expected_ticks_; }
  std::size_t bytes() const noexcept { return size_; }
  /// Gives back what it was given and did not need, where there is memory for the copy.
  void trim() noexcept;

  /// Reads a tape from its first tick on.
  class Reader {
   public:
    /// @pre the tape stays
    explicit Reader(const ContactTape& tape) noexcept : tape_(&tape) {}
    /// Puts the next tick's answer into `contact`; false behind the last. noexcept, allocates nothing.
    bool next(Contact& contact) noexcept;
    /// Goes past the next tick, and tells where its first hold is: on none where there is none.
    struct Facet {
      int surface = -1, triangle = -1;
    };
    Facet pass() noexcept;

   private:
    const ContactTape* tape_;
    std::size_t at_ = 0;
  };

 private:
  /// Memory that is taken when it is first written to; null where there is none.
  std::unique_ptr<std::byte[]> bytes_;
  std::size_t capacity_ = 0, size_ = 0;
  long expected_ticks_, ticks_ = 0;
  bool is_spoiled_ = false;
};

}  // namespace fingerpad

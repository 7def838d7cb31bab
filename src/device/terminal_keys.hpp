#pragma once

#include <functional>
#include <string_view>
#include <thread>

#include "device/wake_up.hpp"

namespace fingerpad {

/// Keys typed at the terminal that is standard input, one by one and unseen, while this lives; the terminal
/// is then as before. A thread of its own reads them.
class TerminalKeys {
 public:
  /// @param take  called on that thread with "up", "down", "left", "right", "page up", "page down", or the
  ///              character itself
  /// Throws Error (usage) where standard input is no terminal.
  explicit TerminalKeys(std::function<void(std::string_view)> take);
  ~TerminalKeys();
  TerminalKeys(const TerminalKeys&) = delete;
  TerminalKeys& operator=(const TerminalKeys&) = delete;

 private:
  void run();

  std::function<void(std::string_view)> take_;
  WakeUp stop_;
  std::thread thread_;
};

/// Throws Error (usage) where it is none.
void need_terminal_keys();

/// Whether standard input is a terminal that this program may read now: it is none of the background.
bool has_terminal_keys() noexcept;

/// The key with which what was typed begins: its name, and how many bytes it is; 0 bytes where more must
/// come first. What is no key of those has no name.
struct TypedKey {
  std::string_view name;
  std::size_t bytes = 0;
};
TypedKey first_key(std::string_view typed) noexcept;

}  // namespace fingerpad

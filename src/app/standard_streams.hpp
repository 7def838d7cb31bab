#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string_view>
#include <type_traits>
#include <utility>

#include "base/printable_text.hpp"

namespace fingerpad {

/// The first call of main. Descriptors 0 to 2 that the caller has closed are opened so that every use of them
/// fails: else the first file of the run would get such a number, and a message would be written into it. A
/// file that grows over `ulimit -f` becomes an error of the write, and no longer ends the program.
void guard_standard_streams() noexcept;

/// The last call of main: writes what is still due and looks whether all was written. Lost standard output is
/// told on standard error.
/// @returns `code`; 1 (fault) where that is 0 but something was lost
int close_standard_streams(int code) noexcept;

/// Writes text as it is; what the program prints goes through here, by one thread at a time. noexcept: what
/// cannot be written is for close_standard_streams() to see, so that nobody has to stop working because
/// nobody listens.
void write_stream(std::FILE* stream, std::string_view text) noexcept;

/// A value as the program tells it: texts, which may hold a file's own words, as printable() has them.
template <typename Value>
auto as_told(const Value& value) {
  if constexpr (std::is_convertible_v<const Value&, std::string_view>) {
    return printable(value);
  } else {
    return value;
  }
}

/// To standard output. Texts among the values cannot end the line or reach the terminal's controls: what
/// has lines of its own goes to write_stream().
template <typename... Values>
void print_out(fmt::format_string<std::decay_t<decltype(as_told(std::declval<Values>()))>...> text,
               const Values&... values) {
  write_stream(stdout, fmt::format(text, as_told(values)...));
}

/// To standard error, in the same way.
template <typename... Values>
void print_err(fmt::format_string<std::decay_t<decltype(as_told(std::declval<Values>()))>...> text,
               const Values&... values) {
  write_stream(stderr, fmt::format(text, as_told(values)...));
}

}  // namespace fingerpad

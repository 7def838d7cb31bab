#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string_view>
#include <utility>

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

/// To standard output.
template <typename... Values>
void print_out(fmt::format_string<Values...> text, Values&&... values) {
  write_stream(stdout, fmt::format(text, std::forward<Values>(values)...));
}

/// To standard error.
template <typename... Values>
void print_err(fmt::format_string<Values...> text, Values&&... values) {
  write_stream(stderr, fmt::format(text, std::forward<Values>(values)...));
}

}  // namespace fingerpad

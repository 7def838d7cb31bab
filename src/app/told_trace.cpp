#include "app/told_trace.hpp"

#include "app/standard_streams.hpp"

namespace fingerpad {

void tell_early_end(const std::string& path, const std::string& words) {
  if (!words.empty()) print_err("fingerpad: warning: {}: {}\n", path, words);
}

Trace read_told_trace(const std::string& path, TraceContents contents) {
  Trace trace = read_trace(path, contents);
  refuse_no_rows(trace, path);
  tell_early_end(path, early_end_words(trace));
  return trace;
}

}  // namespace fingerpad

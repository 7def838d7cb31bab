#include "base/csv_cell.hpp"

#include "base/printable_text.hpp"

namespace fingerpad {

std::string csv_cell(std::string_view words) {
  std::string text = printable(words);
  if (text.find_first_of(",\"") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

}  // namespace fingerpad

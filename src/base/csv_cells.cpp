#include "base/csv_cells.hpp"

#include <algorithm>
#include <array>

#include "base/number_text.hpp"

namespace fingerpad {
namespace {

bool is_blank(char c) noexcept {
  return c == ' ' || c == '\t' || c == '\r';
}

/// Whether `c` ends a cell.
bool parts(char c, char separator) noexcept {
  return separator == ' ' ? is_blank(c) : c == separator;
}

/// Where the cell ends that begins at `line`'s beginning. A quote counts where a cell begins with it; within
/// such a cell two of them are one of its text.
std::size_t cell_end(std::string_view line, char separator) noexcept {
  std::size_t at = 0;
  while (at < line.size() && is_blank(line[at]) && !parts(line[at], separator)) ++at;
  if (at < line.size() && line[at] == '"') {
    std::size_t closing = line.find('"', at + 1);
    while (closing != std::string_view::npos && line.substr(closing + 1).starts_with('"'))
      closing = line.find('"', closing + 2);
    if (closing != std::string_view::npos) at = closing + 1;
  }
  if (separator != ' ') return std::min(line.find(separator, at), line.size());
  while (at < line.size() && !parts(line[at], separator)) ++at;
  return at;
}

std::string_view unquoted(std::string_view cell) noexcept {
  if (cell.size() < 2 || cell.front() != '"' || cell.back() != '"') return cell;
  return trimmed(cell.substr(1, cell.size() - 2));
}

}  // namespace

std::string_view separator_words(char separator) noexcept {
  switch (separator) {
    case ';':
      return "';'";
    case '\t':
      return "tabs";
    case '|':
      return "'|'";
    case ' ':
      return "blanks";
    default:
      return "','";
  }
}

std::string_view trimmed(std::string_view text) noexcept {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

void split_csv(std::string_view line, char separator, std::vector<std::string_view>& cells) {
  cells.clear();
  if (separator == ' ') line = trimmed(line);
  while (true) {
    const std::size_t end = cell_end(line, separator);
    cells.push_back(unquoted(trimmed(line.substr(0, end))));
    if (end == line.size()) return;
    line.remove_prefix(end + 1);
    if (separator == ' ') line = trimmed(line);
  }
}

std::vector<std::string_view> csv_cells(std::string_view line, char separator) {
  std::vector<std::string_view> cells;
  split_csv(line, separator, cells);
  return cells;
}

std::optional<double> csv_number(std::string_view cell, char decimal) noexcept {
  if (decimal == '.') return parse_number(cell);
  std::array<char, 64> pointed{};
  if (cell.size() > pointed.size() || cell.find('.') != std::string_view::npos) return std::nullopt;
  std::copy(cell.begin(), cell.end(), pointed.begin());
  // A second mark stays what it is, and is no part of a number.
  const std::size_t mark = cell.find(decimal);
  if (mark != std::string_view::npos) pointed[mark] = '.';
  return parse_number({pointed.data(), cell.size()});
}

}  // namespace fingerpad

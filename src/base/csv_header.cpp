#include "base/csv_header.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <string>

#include "base/nearest_word.hpp"
#include "base/printable_text.hpp"

namespace fingerpad {
namespace {

bool is_row_of_numbers(std::string_view line) noexcept {
  return line.find_first_not_of("0123456789+-.,;eE \t\r\"") == std::string_view::npos &&
         line.find_first_of("0123456789") != std::string_view::npos;
}

/// Whether a first line begins an XML file: with a declaration, a comment or a tag. A header of a table may
/// look like a tag, since some programs name their columns <DATE>,<TIME>: a line is taken for a header where
/// a separator stands in its first name or right behind it.
bool is_xml(std::string_view line, char separator) {
  if (line.starts_with("<?") || line.starts_with("<!")) return true;
  if (line.size() < 2 || line[0] != '<' ||
      !(std::isalpha(static_cast<unsigned char>(line[1])) || line[1] == '_'))
    return false;
  const std::string marks = separator == found_separator ? ",;|\t" : std::string(1, separator);
  if (line.substr(0, line.find_first_of(" >/")).find_first_of(marks) != std::string_view::npos) return false;
  const std::size_t behind = line.find_first_not_of(separator == ' ' ? "" : " ", line.find('>') + 1);
  return line.find('>') == std::string_view::npos || behind == std::string_view::npos ||
         marks.find(line[behind]) == std::string::npos;
}

bool names_all(std::string_view line, char separator, const std::vector<std::string_view>& names) {
  const auto cells = csv_cells(line, separator);
  return std::all_of(names.begin(), names.end(), [&cells](std::string_view name) {
    return std::find(cells.begin(), cells.end(), name) != cells.end();
  });
}

bool names_any(std::string_view line, char separator, const std::vector<std::string_view>& names) {
  const auto cells = csv_cells(line, separator);
  return std::find_first_of(cells.begin(), cells.end(), names.begin(), names.end()) != cells.end();
}

/// The mark under which the header names what is required; where none does, the one that parts it most,
/// under which what is missing can be told.
char separator_of(const CsvHeader& header, const CsvRequest& request) {
  std::vector<char> fit;
  char most = ',';
  std::size_t most_cells = 0;
  for (const char mark : {',', ';', '\t'}) {
    if (mark == request.dialect.decimal) continue;
    if (names_all(header.line, mark, request.required)) fit.push_back(mark);
    const std::size_t cells = csv_cells(header.line, mark).size();
    if (cells > most_cells) most = mark;
    most_cells = std::max(cells, most_cells);
  }
  if (fit.size() == 1) return fit.front();
  if (fit.empty() && request.dialect.decimal == ',' && names_any(header.line, ',', request.required)) {
    throw refused(header.place,
                  "its cells are parted by ',', which cannot be the decimal mark as well: leave the decimal "
                  "mark out where its numbers have points, else part its cells by ;");
  }
  if (fit.size() > 1) {
    throw refused(header.place, fmt::format("its cells may be parted by {} or by {}: say separator",
                                            separator_words(fit[0]), separator_words(fit[1])));
  }
  return most_cells < 2 || names_all(header.line, ' ', request.required) ? ' ' : most;
}

/// The mark that parts a row of numbers: the one under which it has the most cells.
char mark_of_numbers(std::string_view line, const CsvDialect& dialect) {
  if (dialect.separator != found_separator) return dialect.separator;
  char best = ' ';
  for (const char mark : {',', ';', '\t'})
    if (mark != dialect.decimal && csv_cells(line, mark).size() > csv_cells(line, best).size()) best = mark;
  return best;
}

bool names_required(std::string_view line, const CsvRequest& request) {
  if (request.dialect.separator != found_separator)
    return names_all(line, request.dialect.separator, request.required);
  return std::ranges::any_of(std::string_view(",;\t "),
                             [&](char mark) { return names_all(line, mark, request.required); });
}

/// A line that may name the columns, and where it stands.
struct NamingLine {
  std::string line, place;
  long number = 0;
};

/// The first line below `first` that names all that is required. Where none does that is near, the one that
/// begins the lines of words above the first row of numbers, of as many cells as it: its names can be told.
NamingLine look_below(TextLines& lines, NamingLine first, const CsvRequest& request) {
  constexpr int most_lines = 200;  // programs write some dozens about an instrument
  std::vector<NamingLine> words = {std::move(first)};
  std::string_view line;
  for (int k = 0; k < most_lines && lines.next(line); ++k) {
    if (is_passed_over(line)) continue;
    if (names_required(line, request)) return {std::string(line), lines.place(), lines.number()};
    const char mark = mark_of_numbers(line, request.dialect);
    const std::size_t cells = csv_cells(line, mark).size();
    if (is_row_of_numbers(trimmed(line)) && cells >= request.required.size()) {
      auto begin = words.end();
      while (begin != words.begin() && csv_cells(std::prev(begin)->line, mark).size() == cells) --begin;
      return begin == words.end() ? words.front() : *begin;
    }
    words.push_back({std::string(line), lines.place(), lines.number()});
  }
  return words.front();
}

/// Whether a line that holds zero bytes is one of UTF-16 without its mark: every other byte of a letter that
/// ASCII has is zero.
bool is_wide_text(std::string_view line) {
  constexpr std::size_t fewest = 2;
  const auto zeros = static_cast<std::size_t>(std::count(line.begin(), line.end(), '\0'));
  return zeros >= fewest && 5 * zeros >= 2 * line.size() &&
         line.find(std::string_view("\0\0", 2)) == line.npos;
}

/// What to do about a header whose letters are no UTF-8: no name that is typed in is found in it.
std::string_view encoding_mend(std::string_view line) {
  return is_utf8(line)
             ? ""
             : "; its header is no UTF-8 (Latin-1?): save the table as UTF-8, or its names are not found";
}

}  // namespace

bool is_passed_over(std::string_view line) noexcept {
  const std::string_view text = trimmed(line);
  return text.empty() || text.front() == '#';
}

CsvHeader read_csv_header(TextLines& lines, const CsvRequest& request) {
  CsvHeader header;
  std::string comment, comment_place;
  for (std::string_view line; lines.next(line);) {
    const std::string_view text = trimmed(line);
    if (text.empty()) continue;
    if (text.find('\0') != std::string_view::npos)
      throw refused(lines.where(), is_wide_text(text) ? "is a UTF-16 text: save it as UTF-8 or ASCII"
                                                      : "is no text: it holds a zero byte");
    if (is_xml(text, request.dialect.separator))
      throw refused(lines.where(), fmt::format("is XML and no table{}{}",
                                               request.xml_mend.empty() ? "" : ": ", request.xml_mend));
    if (text.front() == '#') {
      comment = text.substr(1);
      comment_place = lines.place();
      continue;
    }
    header.line = line;
    header.place = lines.place();
    if (!trimmed(comment).empty() && is_row_of_numbers(text)) {
      header.first_row = header.line;
      header.line = comment;
      header.place = comment_place;
    } else if (!names_required(header.line, request)) {
      const long first = lines.number();
      const NamingLine below = look_below(lines, {header.line, header.place, first}, request);
      header.line = below.line;
      header.place = below.place;
      if (below.number > first)
        header.above =
            fmt::format("its header is line {}, and what stands above that is passed over", below.number);
    }
    header.separator = request.dialect.separator;
    if (header.separator == found_separator) header.separator = separator_of(header, request);
    return header;
  }
  throw refused(lines.where(), "is empty");
}

Error missing_column(const CsvHeader& header, std::string_view name, const CsvRequest& request) {
  constexpr std::size_t most_shown_bytes = 400;
  std::vector<std::string> there, unasked;
  const auto asks_for = [](const std::vector<std::string_view>& names, std::string_view cell) {
    return std::find(names.begin(), names.end(), cell) != names.end();
  };
  for (const std::string_view cell : csv_cells(header.line, header.separator)) {
    if (cell.empty()) continue;
    there.push_back(printable(cell, 60));
    if (!asks_for(request.required, cell) && !asks_for(request.optional, cell))
      unasked.push_back(there.back());
  }
  const std::string nearest = nearest_word(name, unasked);  // one that is read already is not meant
  const bool has_none = is_row_of_numbers(trimmed(header.line));
  const std::string mend = has_none ? "put a line of names above these numbers" : request.mend;
  return refused(header.place,
                 fmt::format("no column '{}'{}; its header must name the columns {}, and it names {}{}{}{}",
                             printable(name, 60),
                             nearest.empty() || has_none ? "" : fmt::format(" (did you mean '{}'?)", nearest),
                             fmt::join(request.required, ","), printable(word_list(there), most_shown_bytes),
                             mend.empty() ? "" : ": ", mend, encoding_mend(header.line)));
}

}  // namespace fingerpad

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

/// The mark that parts a row of numbers: the one under which it has the most cells. A blank after each comma,
/// and a tab, part the same cells as blanks.
char mark_of_numbers(std::string_view line, const CsvDialect& dialect) {
  if (dialect.separator != found_separator) return dialect.separator;
  char best = ' ';
  std::size_t most = csv_cells(line, best).size();
  for (const char mark : {',', ';', '\t'}) {
    const std::size_t cells = mark == dialect.decimal ? 0 : csv_cells(line, mark).size();
    if (cells < most) continue;
    best = mark;
    most = cells;
  }
  return best;
}

/// Whether a line names all that is required, under one of the marks that may part it.
bool names_required(std::string_view line, const CsvRequest& request, std::string_view marks) {
  if (request.dialect.separator != found_separator)
    return names_all(line, request.dialect.separator, request.required);
  return std::ranges::any_of(marks, [&](char mark) { return names_all(line, mark, request.required); });
}

/// A line that may name the columns, and where it stands.
struct NamingLine {
  std::string line, place;
  long number = 0;
  bool has_end = true;
  std::string first_row = {};  ///< CsvHeader::first_row
};
NamingLine last_of(const TextLines& lines, std::string_view line) {
  return {std::string(line), lines.place(), lines.number(), lines.ended()};
}

/// Of lines of words above a row of numbers, which begins the table: the topmost of those right above it that
/// have as many cells. The first of all if none has, and where lines between it and the row would be lost to
/// whoever reads on.
NamingLine naming_line_of(const std::vector<NamingLine>& words, std::string_view row, char mark,
                          const CsvRequest& request) {
  const std::size_t cells = csv_cells(row, mark).size();
  auto begin = words.end();
  while (begin != words.begin() && csv_cells(std::prev(begin)->line, mark).size() == cells) --begin;
  if (begin == words.end()) return words.front();
  NamingLine found = *begin;
  if (!names_all(found.line, mark, request.required)) return found;
  if (std::next(begin) != words.end()) return words.front();
  found.first_row = row;
  return found;
}

/// The first line below `first` that names all that is required; else the one that names the columns of the
/// first row of numbers, which tells what they are called. So it does where blanks part them: these part any
/// sentence. `first` where there is neither near by.
NamingLine look_below(TextLines& lines, NamingLine first, const CsvRequest& request) {
  constexpr int most_lines = 200;  // programs write some dozens about an instrument
  constexpr std::size_t most_bytes = 64 << 10;
  std::vector<NamingLine> words = {std::move(first)};
  std::size_t bytes = 0;
  std::string_view line;
  for (int k = 0; k < most_lines && bytes < most_bytes && lines.next(line); ++k) {
    bytes += line.size();
    if (line.find('\0') != std::string_view::npos) break;
    if (is_passed_over(line)) continue;
    if (names_required(line, request, ",;\t")) return last_of(lines, line);
    if (is_row_of_numbers(trimmed(line))) {
      const char mark = mark_of_numbers(line, request.dialect);
      if (csv_cells(line, mark).size() >= request.required.size())
        return naming_line_of(words, line, mark, request);
    }
    words.push_back(last_of(lines, line));
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

/// What a file is whose first line holds a zero byte.
std::string_view binary_words(std::string_view line) {
  if (line.starts_with("PK\x03\x04")) return ", but a zip file, as Excel's .xlsx is: save it as CSV";
  if (line.starts_with("\xd0\xcf\x11\xe0")) return ", but a file of an old Excel: save it as CSV";
  if (line.starts_with("\x1f\x8b")) return ", but a gzip file: unpack it";
  return ": it holds a zero byte";
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
                                                      : fmt::format("is no text{}", binary_words(text)));
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
    header.has_end = lines.ended();
    if (!trimmed(comment).empty() && is_row_of_numbers(text)) {
      header.first_row = header.line;
      header.line = comment;
      header.place = comment_place;
    } else if (request.takes_lines_above && !names_required(header.line, request, ",;\t ")) {
      const long first = lines.number();
      const NamingLine below = look_below(lines, last_of(lines, line), request);
      header.line = below.line;
      header.place = below.place;
      header.has_end = below.has_end;
      header.first_row = below.first_row;
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

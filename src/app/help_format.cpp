#include "app/help_format.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <sstream>

#include "app/option_words.hpp"

namespace fingerpad {
namespace {

constexpr std::size_t usual_width = 100, least_width = 60, greatest_width = 120;
/// Of an option with what it takes.
constexpr std::size_t name_column = 28;
constexpr std::size_t hang_of_footer = 2;

/// Blanks that a line begins with.
std::size_t indentation(const std::string& line) {
  return std::min(line.find_first_not_of(' '), line.size());
}

/// What a line goes on with after a break at `end`: a remark of a scene's line as a remark, so that what is
/// copied from the help is still a scene.
std::string next_row(const std::string& line, std::size_t end, std::size_t width, std::size_t hang) {
  const std::size_t remark = line.find(" # ");
  if (remark < end && remark < width / 2) return std::string(remark + 1, ' ') + "# ";
  return std::string(indentation(line) + hang, ' ');
}

std::string wrapped_line(const std::string& line, std::size_t width, std::size_t hang) {
  std::string text, row = line.substr(0, indentation(line));
  bool is_empty = true;
  std::size_t from = row.size();
  while (from < line.size()) {
    const std::size_t word = std::min(line.find_first_not_of(' ', from), line.size()),
                      end = std::min(line.find(' ', word), line.size());
    if (!is_empty && row.size() + end - from > width) {
      text += row + "\n";
      row = next_row(line, from, width, hang) + line.substr(word, end - word);
    } else {
      row += line.substr(from, end - from);
    }
    is_empty = false;
    from = end;
  }
  return text + row;
}

/// Parts a text into lines of at most `width` letters, where it has blanks. A line keeps its indentation.
/// @param hang  blanks before the lines that a line goes on in, beside its own indentation
std::string wrapped(const std::string& text, std::size_t width, std::size_t hang) {
  std::istringstream lines(text);
  std::string all;
  for (std::string line; std::getline(lines, line);) all += wrapped_line(line, width, hang) + "\n";
  if (!all.empty()) all.pop_back();
  return all;
}

}  // namespace

std::size_t help_width() {
  winsize size{};
  if (isatty(STDOUT_FILENO) == 0 || ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0)
    return usual_width;
  return std::clamp<std::size_t>(size.ws_col, least_width, greatest_width);
}

std::string HelpFormat::entry(const std::string& name, const std::string& words) const {
  const std::string left = "  " + name;
  const bool fits = left.size() + 2 <= name_column;
  const std::string first =
      fits ? left + std::string(name_column - left.size(), ' ') : left + "\n" + std::string(name_column, ' ');
  const std::string text = wrapped(words, width_ - name_column, 0);
  return first + CLI::detail::find_and_replace(text, "\n", "\n" + std::string(name_column, ' ')) + "\n";
}

std::string HelpFormat::make_option(const CLI::Option* option, bool is_positional) const {
  const bool is_many = option->get_expected_max() == CLI::detail::expected_max_vector_size;
  std::string name = is_positional ? option->get_name(true) : option->get_name(false, true);
  const std::string takes = is_positional ? "" : placeholder(*option);
  if (!takes.empty()) name += " " + takes;
  return entry(name + (is_many ? "..." : ""), about(*option));
}

std::string HelpFormat::make_description(const CLI::App* app) const {
  return wrapped(app->get_description(), width_, 0) + "\n";
}

std::string HelpFormat::make_usage(const CLI::App* app, std::string name) const {
  return wrapped(Formatter::make_usage(app, std::move(name)), width_, hang_of_footer) + "\n";
}

std::string HelpFormat::make_footer(const CLI::App* app) const {
  const std::string& footer = app->get_footer();
  return footer.empty() ? "" : wrapped(footer, width_, hang_of_footer) + "\n";
}

std::string HelpFormat::make_subcommand(const CLI::App* command) const {
  return entry(command->get_name(), command->get_description());
}

}  // namespace fingerpad

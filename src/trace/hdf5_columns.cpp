#include "trace/hdf5_columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdint>
#include <filesystem>
#include <optional>

#include "base/error.hpp"
#include "base/path_words.hpp"
#include "trace/handover.hpp"
#include "trace/hdf5_file.hpp"
#include "trace/hdf5_trial.hpp"

namespace fingerpad {
namespace {

void tell_columns(const std::string& path, const std::vector<std::string>& names, Teller& tell) {
  const hdf5::Handle file = hdf5::open_file(path);
  tell(hdf5::read_text(file, "scene"));
  tell(hdf5::read_texts(file, "columns"));
  tell(hdf5::read_whole(file, "every").value_or(1));
  std::optional<std::uint64_t> rows;
  for (const std::string& name : names) {
    const bool is_there = hdf5::has_link(file, name);
    tell(is_there);
    if (!is_there) continue;
    const hdf5::Handle column = hdf5::open_dataset(file, name, "column");
    // Rows that take bytes for certain: so what a file unfolds to has a bound.
    if (!rows && hdf5::is_deflated(column))
      throw refused(path,
                    fmt::format("is refused: the column '{0}' is compressed, which the first may not be: "
                                "'h5repack -f {0}:NONE IN.h5 OUT.h5' undoes that",
                                name));
    const std::vector<std::uint64_t> extents = hdf5::extents(column);
    const std::optional<std::uint64_t> length = hdf5::length_of_row(extents);
    if (!length)
      throw refused(path, fmt::format("the column '{}' is {}; a column is N numbers (or N x 1)", name,
                                      extents.empty() ? "of no numbers, or of more than two dimensions"
                                                      : fmt::format("{}", fmt::join(extents, " x "))));
    if (rows && *rows != *length)
      throw refused(
          path, fmt::format("the column '{}' has {} rows, those before it have {}", name, *length, *rows));
    rows = length;
    if (*rows > hdf5::stored_values(column))
      throw refused(path, fmt::format("is damaged: the column '{}' has fewer numbers than it says", name));
    std::vector<double> numbers(static_cast<std::size_t>(*rows));
    if (!hdf5::read_all(column, numbers))
      throw refused(path, fmt::format("the column '{}' cannot be read as numbers", name));
    tell(numbers);
  }
  tell.flush();
}

Hdf5Columns hear_columns(std::size_t names, Hearer& hear) {
  Hdf5Columns found;
  found.columns.resize(names);
  hear(found.scene_text);
  hear(found.chosen);
  hear(found.every);
  for (std::size_t k = 0; k < names; ++k) {
    bool is_there = false;
    hear(is_there);
    found.present.push_back(is_there);
    if (is_there) hear(found.columns[k]);
  }
  return found;
}

}  // namespace

Hdf5Columns read_hdf5_columns(const std::string& path, const std::vector<std::string>& names) {
  constexpr std::uint64_t bytes_per_second = std::uint64_t{50} << 20;  // far slower than any reading
  std::error_code vanished;
  const std::uint64_t bytes = std::filesystem::file_size(path, vanished);
  if (vanished) throw refused(path, "cannot be read: " + path_words(path, vanished.value()));
  // The first column, never compressed, has no more rows than the file has bytes, and no other has more;
  // numbers of four bytes or one are told as eight.
  const std::uint64_t told_bytes = (std::uint64_t{1} << 20) + bytes + 8 * bytes * names.size();
  return read_in_trial(
      path,
      {.seconds = 2 + bytes * names.size() / bytes_per_second,
       .memory_bytes = (std::uint64_t{256} << 20) + 8 * bytes},
      told_bytes, [&](Teller& tell) { tell_columns(path, names, tell); },
      [&](Hearer& hear) { return hear_columns(names.size(), hear); });
}

std::string read_hdf5_contents(const std::string& path) {
  constexpr std::uint64_t room = std::uint64_t{1} << 20;
  return read_in_trial(
      path, {.seconds = 2, .memory_bytes = std::uint64_t{256} << 20}, room,
      [&](Teller& tell) {
        tell(hdf5::contents_words(hdf5::open_file(path)));
        tell.flush();
      },
      [](Hearer& hear) {
        std::string words;
        hear(words);
        return words;
      });
}

}  // namespace fingerpad

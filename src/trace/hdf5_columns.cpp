#include "trace/hdf5_columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
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

/// What a column is measured in, by its own word.
std::string unit_of(const hdf5::Handle& column, const std::string& path, const std::string& name) {
  for (const char* attribute : {"unit", "units"}) {
    if (!hdf5::has_attribute(column, attribute)) continue;
    try {
      const std::vector<std::string> words = hdf5::read_texts(column, attribute);
      if (words.size() == 1) return words.front();
    } catch (const Error&) {  // told below
    }
    throw refused(path,
                  fmt::format("the column '{}' has an attribute '{}' that is no single text, as m or mm are",
                              name, attribute));
  }
  return {};
}

/// Where no column takes bytes for certain, what they unfold to must have another bound.
void refuse_unfolding(const std::string& path, const std::string& name, std::uint64_t rows,
                      std::uint64_t columns, std::uint64_t file_bytes) {
  if (rows <= most_unfolded * file_bytes / (columns * sizeof(double))) return;
  throw refused(path,
                fmt::format("is refused: its columns are compressed to less than one part in {1} of their "
                            "numbers: 'h5repack -f {0}:NONE IN.h5 OUT.h5' undoes that for '{0}', which is "
                            "enough",
                            name, most_unfolded));
}

void tell_columns(const std::string& path, const std::vector<std::string>& names, std::uint64_t file_bytes,
                  Teller& tell) {
  const hdf5::Handle file = hdf5::open_file(path);
  const auto columns = static_cast<std::uint64_t>(std::count_if(
      names.begin(), names.end(), [&](const std::string& name) { return hdf5::has_link(file, name); }));
  tell(hdf5::has_attribute(file, "scene"));
  tell(hdf5::read_text(file, "scene"));
  tell(hdf5::read_texts(file, "columns"));
  tell(hdf5::read_whole(file, "every").value_or(1));
  std::optional<std::uint64_t> rows;
  for (const std::string& name : names) {
    const bool is_there = hdf5::has_link(file, name);
    tell(is_there);
    if (!is_there) continue;
    const hdf5::Handle column = hdf5::open_dataset(file, name, "column");
    const std::vector<std::uint64_t> extents = hdf5::extents(column);
    const std::optional<std::uint64_t> length = hdf5::length_of_row(extents);
    if (!length)
      throw refused(path, fmt::format("the column '{}' is {}; a column is N numbers (or N x 1)", name,
                                      extents.empty() ? "of no numbers, or of more than two dimensions"
                                                      : fmt::format("{}", fmt::join(extents, " x "))));
    if (rows && *rows != *length)
      throw refused(
          path, fmt::format("the column '{}' has {} rows, those before it have {}", name, *length, *rows));
    if (!rows && hdf5::is_deflated(column)) refuse_unfolding(path, name, *length, columns, file_bytes);
    rows = length;
    if (*rows > hdf5::stored_values(column))
      throw refused(path, fmt::format("is damaged: the column '{}' has fewer numbers than it says", name));
    std::vector<double> numbers(static_cast<std::size_t>(*rows));
    if (!hdf5::read_all(column, numbers))
      throw refused(path, fmt::format("the column '{}' cannot be read as numbers", name));
    tell(unit_of(column, path, name));
    tell(numbers);
  }
  tell.flush();
}

Hdf5Columns hear_columns(std::size_t names, Hearer& hear) {
  Hdf5Columns found;
  found.columns.resize(names);
  found.units.resize(names);
  hear(found.is_trace);
  hear(found.scene_text);
  hear(found.chosen);
  hear(found.every);
  for (std::size_t k = 0; k < names; ++k) {
    bool is_there = false;
    hear(is_there);
    found.present.push_back(is_there);
    if (!is_there) continue;
    hear(found.units[k]);
    hear(found.columns[k]);
  }
  return found;
}

}  // namespace

Hdf5Columns read_hdf5_columns(const std::string& path, const std::vector<std::string>& names) {
  constexpr std::uint64_t bytes_per_second = std::uint64_t{50} << 20;  // far slower than any reading
  std::error_code vanished;
  const std::uint64_t bytes = std::filesystem::file_size(path, vanished);
  if (vanished) throw refused(path, "cannot be read: " + path_words(path, vanished.value()));
  // A first column that is not compressed has no more rows than the file has bytes, and no other has more;
  // numbers of four bytes or one are told as eight.
  const std::uint64_t told_bytes =
      (std::uint64_t{1} << 20) + bytes + std::max<std::uint64_t>(8 * names.size(), most_unfolded) * bytes;
  return read_in_trial(
      path,
      {.seconds = 2 + bytes * names.size() / bytes_per_second,
       .memory_bytes = (std::uint64_t{256} << 20) + most_unfolded * bytes},
      told_bytes, [&](Teller& tell) { tell_columns(path, names, bytes, tell); },
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

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "base/error.hpp"
#include "fuzz/entries.hpp"
#include "fuzz/input_file.hpp"
#include "fuzz/promise.hpp"
#include "scene/scene_file.hpp"
#include "trace/hdf5_file.hpp"
#include "trace/hdf5_trace.hpp"
#include "trace/trace_column.hpp"

namespace fingerpad::test {
namespace {

/// Choices made by the input's bytes; 0, the sane choice, once they are used up.
class Choices {
 public:
  explicit Choices(std::string_view bytes) : bytes_(bytes) {}

  std::uint8_t byte() {
    if (bytes_.empty()) return 0;
    const auto value = static_cast<std::uint8_t>(bytes_.front());
    bytes_.remove_prefix(1);
    return value;
  }
  bool rarely() { return byte() == 255; }
  std::string text() {
    const std::size_t asked = byte();  // first: it takes a byte itself
    const std::size_t size = std::min(asked, bytes_.size());
    std::string taken(bytes_.substr(0, size));
    bytes_.remove_prefix(size);
    return taken;
  }
  /// Small whole numbers, the sane one, troublesome ones, or any bits.
  double number(double sane) {
    const std::uint8_t choice = byte();
    constexpr double infinite = std::numeric_limits<double>::infinity();
    constexpr std::array<double, 8> troublesome = {
        -1, infinite, -infinite, std::numeric_limits<double>::quiet_NaN(), 1e300, -1e300, 5e-324, 1e11};
    if (choice < 128) return sane;
    if (choice < 240) return choice - 184;
    if (choice < 248) return troublesome[choice - 240U];
    std::array<char, sizeof(double)> bits{};
    for (char& c : bits) c = static_cast<char>(byte());
    double value = 0;
    std::memcpy(&value, bits.data(), sizeof(value));
    return value;
  }
  int whole(int sane) {
    const std::uint8_t choice = byte();
    if (choice < 128) return sane;
    if (choice < 250) return choice - 184;
    return choice % 2 == 0 ? std::numeric_limits<int>::max() : std::numeric_limits<int>::min();
  }

 private:
  std::string_view bytes_;
};

using hdf5::Handle;

/// An attribute of `sane.size()` numbers, or of another length, or a text, or none.
void write_numbers(const Handle& object, const std::string& name, std::vector<double> sane,
                   Choices& choices) {
  const std::uint8_t way = choices.byte();
  if (way == 255) return;
  if (way == 254) {
    hdf5::write_text(object, name, choices.text());
    return;
  }
  if (way == 253) sane.resize(sane.size() + 1);
  for (double& value : sane) value = choices.number(value);
  hdf5::write_numbers(object, name, sane);
}

void write_text(const Handle& object, const std::string& name, const std::string& sane, Choices& choices) {
  const std::uint8_t way = choices.byte();
  if (way == 255) return;
  if (way == 254) {
    hdf5::write_whole(object, name, choices.byte());
  } else if (way == 253) {
    hdf5::write_texts(object, name, {choices.text(), choices.text()});
  } else {
    hdf5::write_text(object, name, way < 128 ? sane : choices.text());
  }
}

void write_info(const Handle& file, Choices& choices) {
  write_text(file, "scene_name", "fuzzed", choices);
  write_text(file, "scene", "[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n", choices);
  for (const char* name : {"version", "motion_file", "motion_hash", "profile", "mesh_files", "mesh_hashes"}) {
    write_text(file, name, "", choices);
  }
  write_numbers(file, "seed", {1}, choices);
  write_numbers(file, "rate_hz", {1000}, choices);
  if (!choices.rarely()) hdf5::write_flag(file, "complete", choices.byte() % 2 == 0);
}

void write_columns(const Handle& file, Choices& choices) {
  const std::size_t rows = choices.byte() % 4;
  for (const TraceColumn& column : trace_columns()) {
    const std::string name(column.name);
    const std::uint8_t way = choices.byte();
    if (way == 255) continue;
    if (way == 254) {
      hdf5::write_table(file, name, Points::Zero(3, 1), "m");
      continue;
    }
    const bool numbered = name == "part" || name == "triangle";
    std::vector<double> values(way == 253 ? rows + 1 : rows, numbered ? -1 : 0);
    if (way < 128) {  // a small fixed dataset: many times faster than a column that can grow
      hdf5::write_list(file, name, std::vector<int>(values.begin(), values.end()));
      continue;
    }
    for (double& value : values) value = choices.number(value);
    const std::array types = {hdf5::NumberType::float64, hdf5::NumberType::int32, hdf5::NumberType::uint8};
    const Handle made = hdf5::create_column(file, name, types[way % types.size()], std::string(column.unit));
    if (!values.empty()) hdf5::append(made, 0, values);
  }
}

void write_part(const Handle& group, Choices& choices) {
  const int vertices = choices.byte() % 8;
  Points points(3, vertices);
  for (int v = 0; v < vertices; ++v) {
    for (int axis = 0; axis < 3; ++axis) points(axis, v) = choices.number((v >> axis & 1) != 0 ? 0.01 : 0);
  }
  IndexTriples triples(3, choices.byte() % 8);
  for (int& corner : triples.reshaped()) corner = choices.whole(choices.byte() % 8);
  std::vector<int> numbers(static_cast<std::size_t>(triples.cols()) + (choices.rarely() ? 1 : 0));
  for (int& number : numbers) number = choices.whole(0);
  if (!choices.rarely()) hdf5::write_table(group, "vertices_m", points, "m");
  if (!choices.rarely()) hdf5::write_table(group, "triangles", triples);
  if (!choices.rarely()) hdf5::write_list(group, "file_triangle", numbers);
}

void write_surface(const Handle& group, Choices& choices) {
  for (const char* name : {"stiffness_n_per_m", "damping_n_s_per_m", "mu_static", "mu_dynamic"}) {
    write_numbers(group, name, {0.3}, choices);
  }
  const bool plane = choices.byte() % 2 == 0;
  write_text(group, "kind", plane ? "plane" : "part", choices);
  if (plane) {
    write_numbers(group, "point_m", {0, 0, 0}, choices);
    write_numbers(group, "normal", {0, 0, 1}, choices);
    return;
  }
  write_text(group, "mesh", "part.stl", choices);
  write_text(group, "mesh_hash", "", choices);
  write_numbers(group, "position_m", {0, 0, 0}, choices);
  write_numbers(group, "rotation", {1, 0, 0, 0, 1, 0, 0, 0, 1}, choices);
  write_numbers(group, "crease_deg", {30}, choices);
  write_part(group, choices);
}

void write_trace(const std::string& path, Choices& choices) {
  const hdf5::Turn turn;
  const Handle file = hdf5::create_file(path);
  write_info(file, choices);
  write_columns(file, choices);
  if (choices.rarely()) return;
  const Handle all = hdf5::create_group(file, "surfaces");
  const std::uint64_t count = choices.byte() % 3;
  hdf5::write_whole(all, "count", choices.rarely() ? count + choices.byte() : count);
  for (std::uint64_t i = 0; i < count; ++i) {
    write_surface(hdf5::create_group(all, fmt::format("{}", i)), choices);
  }
}

/// As read_trace does it, in this process: what stumbles here is ours, not HDF5's.
Trace read_here(const std::string& path) {
  std::string told;
  Teller tell([&told](std::string_view bytes) { told += bytes; });
  tell_trace(path, TraceContents::all, tell);
  std::size_t heard = 0;
  const auto next = [&](std::span<char> out) {
    const bool enough = told.size() - heard >= out.size();
    if (enough) heard += told.copy(out.data(), out.size(), heard);
    return enough;
  };
  Hearer hear(next, told.size());
  Trace trace = hear_trace(path, TraceContents::all, hear);
  promise(heard == told.size(), "all that is told is heard");
  return trace;
}

}  // namespace

void fuzz_trace_hdf5(std::string_view bytes) {
  const InputFile file("", ".h5");
  Choices choices(bytes);
  write_trace(file.path(), choices);
  try {
    const Trace trace = read_here(file.path());
    for (const TickRecord& row : trace.rows) promise(std::isfinite(row.t_s), "times are finite");
    read_recorded_scene(trace.info.scene_text, trace.info.profile_text, file.path());
  } catch (const Error&) {
    return;
  }
}

}  // namespace fingerpad::test

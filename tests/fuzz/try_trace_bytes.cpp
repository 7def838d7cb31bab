#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <vector>

#include "base/error.hpp"
#include "fuzz/entries.hpp"
#include "fuzz/input_file.hpp"
#include "fuzz/promise.hpp"
#include "part/part.hpp"
#include "touch/world.hpp"
#include "trace/file_seal.hpp"
#include "trace/hdf5_trace.hpp"
#include "trace/trace_writer.hpp"

namespace fingerpad::test {
namespace {

World tetrahedron_and_plane() {
  TriangleSoup soup;
  soup.vertices_P.resize(3, 4);
  soup.vertices_P << 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1;
  soup.triangles.resize(3, 4);
  soup.triangles << 0, 0, 0, 1, 2, 1, 3, 2, 1, 3, 2, 3;
  Surface part;
  part.part = std::make_shared<const Part>(make_part(soup, 0.5));
  part.mesh = "tetrahedron.stl";
  World world;
  world.surfaces = {part, Surface{}};
  return world;
}

/// A whole trace of a few rows without its seal, and where in it not all is zero: HDF5's records, the texts
/// and the rows.
struct Original {
  std::string bytes;
  std::vector<std::size_t> places;
};

Original make_original() {
  const InputFile file("", ".h5");
  TraceInfo info;
  info.scene_name = info.scene_text = info.version = "fuzzed";
  info.mesh_files = {"tetrahedron.stl"};
  info.mesh_hashes = {"0123456789abcdef"};
  const auto writer = TraceWriter::create(file.path(), TraceFormat::hdf5, info, tetrahedron_and_plane());
  writer->append(std::vector<TickRecord>(3));
  writer->finish();
  std::ifstream stream(file.path(), std::ios::binary);
  Original original{{std::istreambuf_iterator<char>(stream), {}}, {}};
  original.bytes.resize(original.bytes.size() - 32);
  constexpr std::size_t around = 8;
  for (std::size_t i = 0; i < original.bytes.size(); ++i) {
    const auto near = original.bytes.substr(i - std::min(i, around), 2 * around);
    if (near.find_first_not_of('\0') != std::string::npos) original.places.push_back(i);
  }
  return original;
}

/// The first byte cuts the file short if it is not 0; then three bytes a change: where (two), and the value.
std::string changed(const Original& original, std::string_view bytes) {
  const auto byte = [&bytes](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
  std::string out = original.bytes;
  if (!bytes.empty()) out.resize(out.size() - out.size() * byte(0) / 512);
  for (std::size_t i = 1; i + 2 < bytes.size(); i += 3) {
    const std::size_t place = original.places[(byte(i) * 256U + byte(i + 1)) % original.places.size()];
    if (place < out.size()) out[place] = bytes[i + 2];
  }
  return out;
}

void check(const Trace& trace) {
  for (const TickRecord& row : trace.rows) promise(std::isfinite(row.t_s), "times are finite");
  if (!trace.world) return;
  for (const Surface& surface : trace.world->surfaces) {
    if (!surface.part) continue;
    for (const int corner : surface.part->triangles.reshaped()) {
      promise(surface.part->vertices.col(corner).allFinite(), "corners are finite");
    }
  }
}

}  // namespace

void fuzz_trace_hdf5_bytes(std::string_view bytes) {
  static const Original original = make_original();
  const InputFile file(changed(original, bytes), ".h5");
  seal_file(file.path());
  try {
    check(read_trace(file.path()));
  } catch (const Error& error) {
    promise(error.kind() == ErrorKind::refused, "a forged file is no fault of the program");
  }
}

void fuzz_trace_told(std::string_view bytes) {
  const auto next = [&bytes](std::span<char> out) {
    if (bytes.size() < out.size()) return false;
    bytes.copy(out.data(), out.size());
    bytes.remove_prefix(out.size());
    return true;
  };
  Hearer hear(next, std::uint64_t{1} << 20);
  try {
    check(hear_trace("told", TraceContents::all, hear));
  } catch (const Error& error) {
    promise(error.kind() == ErrorKind::refused, "a forged file is no fault of the program");
  } catch (const ToldTooLittle&) {
    return;
  } catch (const ToldTooMuch&) {
    return;
  }
}

}  // namespace fingerpad::test

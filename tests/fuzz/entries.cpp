#include "fuzz/entries.hpp"

#include <algorithm>
#include <vector>

#include "part/mesh_format.hpp"

namespace fingerpad::test {
namespace {

std::vector<FuzzEntry> all_entries() {
  std::vector<FuzzEntry> entries;
  for (const MeshFormat& format : mesh_format_table()) {
    const std::string_view ending = format.endings.front();
    entries.push_back(
        {std::string(ending.substr(1)), [ending](std::string_view bytes) { fuzz_mesh(bytes, ending); }});
  }
  entries.insert(entries.end(), {{"scene", fuzz_scene},
                                 {"motion", fuzz_motion},
                                 {"profile", fuzz_profile},
                                 {"trace_csv", fuzz_trace_csv},
                                 {"trace_hdf5", fuzz_trace_hdf5},
                                 {"trace_hdf5_bytes", fuzz_trace_hdf5_bytes},
                                 {"trace_told", fuzz_trace_told},
                                 {"device_packets", fuzz_device_packets},
                                 {"haply_frame", fuzz_haply_frame}});
  return entries;
}

}  // namespace

std::span<const FuzzEntry> fuzz_entries() {
  static const std::vector<FuzzEntry> entries = all_entries();
  return entries;
}

const FuzzEntry* find_fuzz_entry(std::string_view name) {
  const auto entries = fuzz_entries();
  const auto found =
      std::find_if(entries.begin(), entries.end(), [&](const FuzzEntry& e) { return e.name == name; });
  return found == entries.end() ? nullptr : &*found;
}

}  // namespace fingerpad::test

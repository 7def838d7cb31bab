#include <cstddef>
#include <cstdint>

#include "fuzz/entries.hpp"

// libFuzzer's entry, built once for each FuzzEntry (tests/CMakeLists.txt names it).
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto* entry = fingerpad::test::find_fuzz_entry(FINGERPAD_FUZZ_ENTRY);
  entry->run({reinterpret_cast<const char*>(data), size});
  return 0;
}

#include "base/build_identity.hpp"

#include <fmt/format.h>
#include <link.h>

#include <cstring>
#include <span>
#include <string_view>

namespace fingerpad {
namespace {

/// Notes stand at multiples of four bytes.
std::size_t padded(std::size_t bytes) noexcept {
  return (bytes + 3) / 4 * 4;
}

std::string hex(std::span<const unsigned char> bytes) {
  std::string text;
  for (const unsigned char byte : bytes) text += fmt::format("{:02x}", byte);
  return text;
}

/// The build id among the notes of a segment; empty where it is not.
std::string build_id_in(std::span<const unsigned char> notes) {
  constexpr std::string_view owner("GNU\0", 4);
  while (notes.size() >= sizeof(ElfW(Nhdr))) {
    ElfW(Nhdr) note;
    std::memcpy(&note, notes.data(), sizeof(note));
    const std::size_t name_at = sizeof(note), id_at = name_at + padded(note.n_namesz),
                      end = id_at + padded(note.n_descsz);
    if (end > notes.size()) break;
    const bool is_ours =
        note.n_namesz == owner.size() && std::memcmp(notes.data() + name_at, owner.data(), owner.size()) == 0;
    if (is_ours && note.n_type == NT_GNU_BUILD_ID) return hex(notes.subspan(id_at, note.n_descsz));
    notes = notes.subspan(end);
  }
  return {};
}

/// Looks into the first module alone, which is the program itself.
int look_into_program(dl_phdr_info* module, std::size_t /*size*/, void* out) {
  for (std::size_t k = 0; k < module->dlpi_phnum; ++k) {
    const ElfW(Phdr)& segment = module->dlpi_phdr[k];
    if (segment.p_type != PT_NOTE) continue;
    // NOLINTNEXTLINE(performance-no-int-to-ptr): that is how the loader tells it
    const auto* const notes = reinterpret_cast<const unsigned char*>(module->dlpi_addr + segment.p_vaddr);
    const std::string id = build_id_in({notes, segment.p_memsz});
    if (id.empty()) continue;
    *static_cast<std::string*>(out) = id;
    break;
  }
  return 1;
}

}  // namespace

std::string build_identity() {
  std::string id;
  dl_iterate_phdr(look_into_program, &id);
  return id;
}

std::string short_build_identity() {
  constexpr std::size_t digits = 12;
  return build_identity().substr(0, digits);
}

}  // namespace fingerpad

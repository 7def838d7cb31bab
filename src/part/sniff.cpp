#include "part/sniff.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <utility>

#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/nearest_word.hpp"
#include "part/mesh_format.hpp"
#include "part/text_cursor.hpp"

namespace fingerpad {
namespace {

using namespace std::string_view_literals;

/// What begins like this is no mesh that is read here.
std::string_view known_stranger(std::string_view bytes) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 14> beginnings{
      {{"\x89PNG"sv, "a PNG picture"},
       {"\xff\xd8\xff"sv, "a JPEG picture"},
       {"GIF8"sv, "a GIF picture"},
       {"%PDF"sv, "a PDF document"},
       {"PK\x03\x04"sv, "a ZIP archive (a 3MF is one)"},
       {"\x1f\x8b"sv, "a gzip archive: unpack it first"},
       {"\x89HDF"sv, "an HDF5 file"},
       {"\x7f"
        "ELF"sv,
        "a program"},
       {"glTF"sv, "a binary glTF"},
       {"<?xml"sv, "an XML text"},
       {"<html"sv, "a web page"},
       {"<!DOCTYPE"sv, "a web page"},
       {"version https://git-lfs"sv, "a Git LFS pointer: the mesh itself was not fetched"},
       {"Kaydara FBX"sv, "an FBX file"}}};
  for (const auto& [beginning, name] : beginnings) {
    if (bytes.substr(0, beginning.size()) == beginning) return name;
  }
  return {};
}

bool is_utf16(std::string_view bytes) {
  const std::string_view mark = bytes.substr(0, 2);
  if (mark == "\xfe\xff"sv || mark == "\xff\xfe"sv) return true;
  // Without a mark: every other byte of the beginning is zero.
  constexpr std::size_t look = 64;
  if (bytes.size() < look) return false;
  std::array<std::size_t, 2> zeros{0, 0};
  for (std::size_t i = 0; i < look; ++i) zeros[i % 2] += bytes[i] == '\0' ? 1 : 0;
  return (zeros[0] == look / 2 && zeros[1] == 0) || (zeros[1] == look / 2 && zeros[0] == 0);
}

template <typename Is>
const MeshFormat* find_format(const Is& is) {
  const auto table = mesh_format_table();
  const auto found = std::find_if(table.begin(), table.end(), is);
  return found == table.end() ? nullptr : &*found;
}

/// The format that the content proves; null where it could be several.
const MeshFormat* format_of_content(std::string_view bytes) {
  return find_format([bytes](const MeshFormat& format) { return format.proves(bytes); });
}

/// The format of a stream, which has no name that says it, by its first word.
const MeshFormat* format_of_stream(std::string_view bytes) {
  TextCursor cursor(bytes);
  std::string_view word = cursor.word();
  while (word.starts_with('#')) {
    cursor.rest_of_line();
    word = cursor.word();
  }
  return find_format([word](const MeshFormat& format) { return format.begins(word); });
}

std::string read_formats() {
  return mesh_format_names("and") + " are read";
}

/// What a scene is to be called, behind an ending that may be meant for its own.
std::string scene_hint(const std::string& ending) {
  if (same_word(ending, ".toml")) return "; a scene's ends in .toml, in small letters";
  return nearest_word(ending, {".toml"}).empty() ? "" : "; a scene's ends in .toml";
}

void refuse_step(const std::string& ending, std::string_view bytes) {
  const bool named = same_word(ending, ".stp") || same_word(ending, ".step") || same_word(ending, ".p21");
  if (bytes.substr(0, 12) == "ISO-10303-21") {
    throw refused("",
                  "is a STEP file, exact surfaces without triangles: tessellate it to STL, OBJ or PLY by the "
                  "CAD program's export, FreeCAD or gmsh (gmsh part.step -2 -o part.stl)");
  }
  if (!named) return;
  const MeshFormat* content = format_of_content(bytes);
  if (content == nullptr && same_word(bytes.substr(0, 6), "solid ")) content = format_of_stream("solid");
  if (content == nullptr)
    throw refused("", "is named as a STEP file, but does not begin as one (ISO-10303-21)");
  throw refused("", "is named as a STEP file, but its bytes are those of an " + std::string(content->name) +
                        " mesh: rename it");
}

}  // namespace

const MeshFormat& mesh_format(const std::string& path, std::string_view bytes) {
  if (bytes.empty()) throw refused("", "is empty (0 bytes)");
  const std::string ending = std::filesystem::path(path).extension().string();
  refuse_step(ending, bytes);
  const MeshFormat* content = format_of_content(bytes);
  const bool stream = stream_descriptor(path).has_value();
  const MeshFormat* named = !stream              ? format_of_ending(ending)
                            : content != nullptr ? content
                                                 : format_of_stream(bytes);
  if (content != nullptr && named != nullptr && content != named) {
    throw refused("", "is named as " + std::string(named->name) + ", but its bytes are those of " +
                          std::string(content->name) + ": rename it");
  }
  if (content == nullptr) {
    const std::string_view stranger = known_stranger(bytes);
    if (!stranger.empty()) throw refused("", "is " + std::string(stranger) + ", not a mesh");
    if (is_utf16(bytes)) throw refused("", "is a UTF-16 text: save it as UTF-8 or ASCII");
  }
  if (named == nullptr && stream)
    throw refused("", "is no mesh that its first words tell: " + read_formats());
  if (named == nullptr)
    throw refused("", "its name ends in '" + shown(ending) + "': " + read_formats() + scene_hint(ending));
  return *named;
}

std::size_t stl_announced_count(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, sizeof(count));
  return count;
}

bool is_binary_stl_size(std::string_view bytes) {
  return bytes.size() >= 84 && bytes.size() == 84 + 50 * stl_announced_count(bytes);
}

void refuse_binary(std::string_view bytes) {
  const auto zero = bytes.find('\0');
  if (zero == std::string_view::npos) return;
  throw refused("byte " + std::to_string(zero), "holds a zero byte: binary data where text should stand");
}

}  // namespace fingerpad

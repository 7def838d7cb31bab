#include "part/sniff.hpp"

#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "base/input_file.hpp"
#include "part/text_cursor.hpp"

namespace fingerpad {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view formats = "STL, OBJ, PLY and OFF are read";

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

std::optional<MeshFormat> format_of_name(const std::string& ending) {
  if (same_word(ending, ".stl")) return MeshFormat::stl;
  if (same_word(ending, ".obj")) return MeshFormat::obj;
  if (same_word(ending, ".ply")) return MeshFormat::ply;
  if (same_word(ending, ".off")) return MeshFormat::off;
  return std::nullopt;
}

/// The format that the content proves; nothing where it could be several.
std::optional<MeshFormat> format_of_content(std::string_view bytes) {
  if (is_binary_stl_size(bytes)) return MeshFormat::stl;
  if (bytes.substr(0, 4) == "ply\n" || bytes.substr(0, 4) == "ply\r") return MeshFormat::ply;
  if (bytes.substr(0, 4) == "OFF\n" || bytes.substr(0, 4) == "OFF\r") return MeshFormat::off;
  if (bytes.substr(0, 6) == "solid " && bytes.substr(0, 1000).find("facet") != std::string_view::npos) {
    return MeshFormat::stl;
  }
  return std::nullopt;
}

/// The format of a stream, which has no name that says it, by its first word.
std::optional<MeshFormat> format_of_stream(std::string_view bytes) {
  TextCursor cursor(bytes);
  std::string_view word = cursor.word();
  while (word.starts_with('#')) {
    cursor.rest_of_line();
    word = cursor.word();
  }
  if (same_word(word, "solid")) return MeshFormat::stl;
  if (word.ends_with("OFF")) return MeshFormat::off;
  for (const std::string_view keyword : {"v", "vn", "vt", "vp", "o", "g", "s", "mtllib", "usemtl"}) {
    if (word == keyword) return MeshFormat::obj;
  }
  return std::nullopt;
}

std::string_view name_of(MeshFormat format) {
  static constexpr std::array<std::string_view, 4> names{"STL", "OBJ", "PLY", "OFF"};
  return names[static_cast<std::size_t>(format)];
}

void refuse_step(const std::string& ending, std::string_view bytes) {
  const bool named = same_word(ending, ".stp") || same_word(ending, ".step") || same_word(ending, ".p21");
  if (bytes.substr(0, 12) == "ISO-10303-21") {
    throw refused(
        "",
        "is a STEP file, exact surfaces without triangles: export STL, OBJ or PLY from the CAD program, or "
        "make an STL of it with FreeCAD or gmsh (gmsh part.step -2 -o part.stl)");
  }
  if (!named) return;
  auto content = format_of_content(bytes);
  if (!content && same_word(bytes.substr(0, 6), "solid ")) content = MeshFormat::stl;
  if (!content) throw refused("", "is named as a STEP file, but does not begin as one (ISO-10303-21)");
  throw refused("", "is named as a STEP file, but its bytes are those of an " +
                        std::string(name_of(*content)) + " mesh: rename it");
}

}  // namespace

MeshFormat mesh_format(const std::string& path, std::string_view bytes) {
  if (bytes.empty()) throw refused("", "is empty (0 bytes)");
  const std::string ending = std::filesystem::path(path).extension().string();
  refuse_step(ending, bytes);
  const auto content = format_of_content(bytes);
  const bool stream = stream_descriptor(path).has_value();
  const auto named = !stream ? format_of_name(ending) : content ? content : format_of_stream(bytes);
  if (content && named && *content != *named) {
    throw refused("", "is named as " + std::string(name_of(*named)) + ", but its bytes are those of " +
                          std::string(name_of(*content)) + ": rename it");
  }
  if (!content) {
    const std::string_view stranger = known_stranger(bytes);
    if (!stranger.empty()) throw refused("", "is " + std::string(stranger) + ", not a mesh");
    if (is_utf16(bytes)) throw refused("", "is a UTF-16 text: save it as UTF-8 or ASCII");
  }
  if (!named && stream) throw refused("", "is no mesh that its first words tell: " + std::string(formats));
  if (!named) {
    throw refused("", "its name ends in '" + shown(ending) + "': " + std::string(formats));
  }
  if (*named == MeshFormat::obj || *named == MeshFormat::off) refuse_binary(bytes);
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

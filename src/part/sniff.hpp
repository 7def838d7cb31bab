#pragma once

#include <string>
#include <string_view>

namespace fingerpad {

struct MeshFormat;

/// The row of the format that the file's name and its first bytes agree on, or for a stream its first words.
/// Throws Error (refused) where they do not, for an empty file, and for what is no mesh at all (a picture, an
/// archive, a B-rep, a UTF-16 text), told as what it is.
const MeshFormat& mesh_format(const std::string& path, std::string_view bytes);

/// Whether the size is the binary STL's: 84 bytes and 50 for each triangle of the count at byte 80. Decides
/// before any word in the header, since many a binary STL begins with "solid".
bool is_binary_stl_size(std::string_view bytes);

/// The count at byte 80. @pre 84 bytes.
std::size_t stl_announced_count(std::string_view bytes);

/// Throws Error (refused) at the first byte that no text has.
void refuse_binary(std::string_view bytes);

}  // namespace fingerpad

#pragma once

#include <filesystem>
#include <string>

#include "part/part.hpp"

namespace fingerpad::test {

/// Writes bytes into a file of scratch_dir()'s kind of folder and returns its path.
std::filesystem::path write_file(const std::filesystem::path& folder, const std::string& name,
                                 const std::string& bytes);

/// A coordinate as a reader in float32 has it.
double as_float32(double coordinate);

/// The soup as the bytes of a binary STL (coordinates become float32; lengths as they are, no unit).
std::string binary_stl(const TriangleSoup& soup);

/// As a text STL, OBJ, OFF and text PLY, with 17 digits.
std::string text_stl(const TriangleSoup& soup);
std::string obj_text(const TriangleSoup& soup);
std::string off_text(const TriangleSoup& soup);
std::string ply_text(const TriangleSoup& soup);

/// As a binary PLY with double coordinates, little-endian.
std::string binary_ply(const TriangleSoup& soup);

}  // namespace fingerpad::test

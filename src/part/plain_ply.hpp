#pragma once

#include <string>

#include "part/ply_header.hpp"
#include "part/raw_mesh.hpp"

namespace fingerpad {

/// Rewrites a scanned PLY so that OpenMesh reads it rightly and ends.
///
/// Its header reader runs on for ever on an odd version number, takes words of comments for keywords, drops
/// face properties before the list (and then reads their bytes as counts), and keeps random counts once a
/// number of a text was not to its liking. A plain file gets a plain header before its own body; any other
/// becomes a bare binary PLY of the scanned numbers, and `mesh.binary` says so.
void write_plainly(std::string& bytes, const PlyHeader& header, RawMesh& mesh);

}  // namespace fingerpad

#pragma once

#include <string>

namespace fingerpad {

/// Makes the line ends of a mesh file what every reader knows, in place: the mark of UTF-8 at a text's
/// beginning and the Ctrl-Z at its end (DOS) are taken away, and a bare CR (old Mac) becomes an LF, in the
/// header of a binary PLY too. CR LF stays. Binary data is not touched.
///
/// Without it a mark hides the first keyword, so that an OBJ loses its first vertex and every index shifts,
/// and a bare CR hides what follows it in a comment or a name.
/// Throws Error (refused) for binary data behind a mark of UTF-8: a text tool has changed it.
void make_text_plain(std::string& bytes);

}  // namespace fingerpad

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fingerpad {

/// An element of an XML file that holds text of its own.
struct XmlText {
  std::string path;       ///< of the names of the elements around it and its own, small letters: "force/x"
  std::string_view text;  ///< as it stands there
  long line = 0;          ///< of its tag
};

/// The texts of an XML file that is but numbers and words between tags. The root's name is left out of paths;
/// attributes, comments and processing instructions are passed over. Throws Error (refused, `where:line`) for
/// a tag that is not closed or closes another, for more than one root, for CDATA, for DOCTYPE and
/// entities, which a recording has no need of, and for names of over 64 characters, more than 10000 texts and
/// elements more than 32 deep: what a file makes the program hold is bounded by its own size.
/// @param xml  outlives the texts
std::vector<XmlText> xml_texts(std::string_view xml, const std::string& where);

}  // namespace fingerpad

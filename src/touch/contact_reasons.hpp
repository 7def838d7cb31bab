#pragma once

#include <string>

#include "touch/contact_choice.hpp"
#include "touch/contact_verdict.hpp"

namespace fingerpad {

/// Why the choice fell as it did, for one part: "FILE: proxy, because WHY; smooth normals, because WHY
/// (auto)".
/// @param kept_tolerance  ContactLimit's, of that part
std::string reason_of(const ContactVerdict& verdict, std::size_t i, double kept_tolerance);

/// What of the scene's tolerances is not kept on one part.
/// @param mend  what would keep it (mend_of); "": all is kept
ContactLimit limit_of(const ContactVerdict& verdict, std::size_t i, const std::string& mend);

}  // namespace fingerpad

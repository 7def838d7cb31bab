#pragma once

#include <span>
#include <string>

#include "touch/contact_case.hpp"
#include "touch/contact_choice.hpp"

namespace fingerpad {

/// What was chosen, and among what.
struct ContactVerdict {
  const ContactPair& chosen;
  std::span<const ContactPair> all;
  bool method_open = false, normals_open = false;
};

/// Why the choice fell as it did, for one part: "FILE: proxy, because WHY; smooth normals, because WHY
/// (auto)".
std::string reason_of(const ContactVerdict& verdict, std::span<const ContactCase> cases, std::size_t i);

/// What of the force tolerance is not kept on one part, and what would keep it.
ContactLimit limit_of(const ContactVerdict& verdict, std::span<const ContactCase> cases, std::size_t i);

}  // namespace fingerpad

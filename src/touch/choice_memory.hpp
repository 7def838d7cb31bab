#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "touch/contact_choice.hpp"

namespace fingerpad {

/// Choices of contact that were made, by all that choose_contact() looks at: the jobs of a set touch a part
/// in few ways, and a choice takes hundredths of a second a part and more. Thread-safe.
class ChoiceMemory {
 public:
  std::optional<ContactChoice> find(const std::string& key) const;
  void keep(const std::string& key, const ContactChoice& choice);

 private:
  mutable std::mutex mutex_;
  std::map<std::string, ContactChoice> choices_;
};

/// What a choice for this scene goes by, as text: worlds of one key are given one choice.
/// @param world  all of whose surfaces are there
std::string choice_key(const Scene& scene, const World& world);

}  // namespace fingerpad

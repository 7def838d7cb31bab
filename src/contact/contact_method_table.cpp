#include "contact/contact_method_table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace fingerpad {

const ContactMethodEntry* find_contact_method(std::string_view name) noexcept {
  const auto table = contact_method_table();
  const auto found = std::find_if(table.begin(), table.end(),
                                  [name](const ContactMethodEntry& entry) { return entry.name == name; });
  return found == table.end() ? nullptr : &*found;
}

std::string contact_help_text() {
  std::string text = "\nMethods for [contact] method (auto: the cheapest that holds, with its reason):\n";
  for (const ContactMethodEntry& method : contact_method_table())
    text += fmt::format("  {:<17}{}\n      {}\n", method.name, method.summary, method.holds);
  text += "\nNormals for [contact] normals, or auto:\n";
  for (const Normals normals : normals_table())
    text += fmt::format("  {:<17}{}\n", normals->name, normals->summary);
  return text;
}

}  // namespace fingerpad

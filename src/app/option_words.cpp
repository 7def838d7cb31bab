#include "app/option_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace fingerpad {
namespace {

/// Choices that take more letters than this stand behind the description.
constexpr std::size_t longest_choices = 24;

/// What CLI11 puts together as "NAME:check": "INT:INT in [1 - 1024]", "TEXT:{h5,csv,none}", "FLOAT:X".
struct TypeName {
  std::string name, check;
};

TypeName type_name_of(const CLI::Option& option) {
  const std::string all = option.get_type_name();
  const std::size_t colon = all.find(':');
  if (colon == std::string::npos) return {all, ""};
  return {all.substr(0, colon), all.substr(colon + 1)};
}

bool is_list(std::string_view check) {
  return check.starts_with('{') && check.ends_with('}');
}

/// "h5", "csv", "none" of "{h5,csv,none}".
std::vector<std::string> choices(const std::string& check) {
  std::vector<std::string> words = CLI::detail::split(check.substr(1, check.size() - 2), ',');
  const auto comma = std::find(words.begin(), words.end(), "");  // as one of them it parts nothing
  if (comma != words.end()) *comma = ",";
  return words;
}

std::string side_by_side(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, "|"));
}

/// "1 to 1024" of "INT in [1 - 1024]"; of "FLOAT in [0 - 1e+09]" "from 0".
std::string range(const std::string& check) {
  constexpr std::string_view begin = " in [", between = " - ";
  const std::size_t at = check.find(begin), middle = check.rfind(between);
  if (at == std::string::npos || middle == std::string::npos || !check.ends_with(']')) return "";
  const std::string low = check.substr(at + begin.size(), middle - at - begin.size()),
                    high = check.substr(middle + between.size(), check.size() - middle - between.size() - 1);
  constexpr double as_good_as_none = 1e6;
  return std::stod(high) >= as_good_as_none ? "from " + low : low + " to " + high;
}

bool takes_nothing(const CLI::Option& option) {
  return option.get_expected_max() == 0 || option.get_type_size_max() == 0;
}

}  // namespace

std::string placeholder(const CLI::Option& option) {
  if (takes_nothing(option)) return "";
  const TypeName type = type_name_of(option);
  if (is_list(type.check)) {
    const std::string words = side_by_side(choices(type.check));
    return words.size() <= longest_choices ? words : "WORD";
  }
  const bool is_word = std::all_of(type.check.begin(), type.check.end(),
                                   [](unsigned char letter) { return std::isupper(letter) != 0; });
  if (!type.check.empty() && is_word) return type.check;
  if (type.name == "INT" || type.name == "UINT") return "N";
  return type.name == "FLOAT" ? "X" : type.name;
}

std::string about(const CLI::Option& option) {
  const std::string& description = option.get_description();
  const TypeName type = type_name_of(option);
  std::vector<std::string> further;
  if (option.get_required()) further.emplace_back("needed");
  for (const CLI::Option* with : option.get_needs()) further.push_back("with " + with->get_name());
  if (is_list(type.check)) {
    const std::vector<std::string> words = choices(type.check);
    const bool is_told = std::all_of(words.begin(), words.end(), [&](const std::string& word) {
      return description.find(word) != std::string::npos;
    });
    if (!is_told && side_by_side(words).size() > longest_choices)
      further.push_back(fmt::format("one of {}", fmt::join(words, ", ")));
  }
  if (const std::string bounds = range(type.check); !bounds.empty()) further.push_back(bounds);
  if (const std::string& usual = option.get_default_str(); !usual.empty() && !takes_nothing(option))
    further.push_back("default: " + usual);
  return further.empty() ? description : fmt::format("{} ({})", description, fmt::join(further, "; "));
}

std::vector<const CLI::Option*> shown_options(const CLI::App& app, bool positional) {
  std::vector<const CLI::Option*> shown;
  for (const CLI::Option* option : app.get_options()) {
    if (!option->get_group().empty() && option->get_positional() == positional) shown.push_back(option);
  }
  return shown;
}

}  // namespace fingerpad

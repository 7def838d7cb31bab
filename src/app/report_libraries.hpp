#pragma once

#include <string>
#include <vector>

namespace fingerpad {

/// What a page needs of other people's code, as Debian packages it.
struct ReportLibraries {
  std::string scripts, styles;  ///< to stand in a page as they are
  struct Licence {
    std::string package, text;
  };
  std::vector<Licence> licences;
};

/// Where Debian puts them.
inline constexpr const char* debian_javascript_folder = "/usr/share/javascript";

/// Reads them. Throws Error (usage), with the package to install, where a file is missing.
/// @param folder  as debian_javascript_folder
ReportLibraries read_report_libraries(const std::string& folder);

}  // namespace fingerpad

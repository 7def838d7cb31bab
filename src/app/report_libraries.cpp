#include "app/report_libraries.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "base/base64.hpp"
#include "base/error.hpp"
#include "base/input_file.hpp"

namespace fingerpad {
namespace {

namespace fs = std::filesystem;

struct LibraryFile {
  const char* package;
  const char* path;
};

// In the order in which they need each other.
constexpr LibraryFile scripts[] = {
    {"libjs-jquery", "jquery/jquery.min.js"},
    {"libjs-jquery-datatables", "jquery-datatables/jquery.dataTables.min.js"},
    {"libjs-dygraphs", "dygraphs/dygraph.min.js"},
    {"libjs-three", "three/three.min.js"},
    {"libjs-three", "three/examples/js/controls/OrbitControls.js"},
    {"libjs-three", "three/examples/js/lines/LineSegmentsGeometry.js"},
    {"libjs-three", "three/examples/js/lines/LineMaterial.js"},
    {"libjs-three", "three/examples/js/lines/LineSegments2.js"},
};
constexpr LibraryFile styles[] = {
    {"libjs-jquery-datatables", "jquery-datatables/css/jquery.dataTables.min.css"},
    {"libjs-dygraphs", "dygraphs/dygraph.min.css"},
};
constexpr const char* packages[] = {"libjs-jquery", "libjs-jquery-datatables", "libjs-dygraphs",
                                    "libjs-three"};

std::string read_library_file(const fs::path& path, const char* package) {
  const InputKind kind{"a library of the report's", std::uint64_t{16} << 20};
  if (const auto why = why_unreadable(path.string(), kind)) {
    throw Error(
        ErrorKind::usage, path.string(),
        fmt::format("a report's page holds this file of the Debian package {0}, but {1}; `apt install "
                    "{0}` brings it",
                    package, *why));
  }
  return read_whole_file(path.string(), kind);
}

void replace_all(std::string& text, std::string_view what, std::string_view by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
}

/// A map of the source is a file beside the library, which a page of one file has not.
void drop_source_map(std::string& text) {
  for (const std::string_view mark : {"//# sourceMappingURL=", "/*# sourceMappingURL="}) {
    for (std::size_t at = 0; (at = text.find(mark, at)) != std::string::npos;) {
      const std::size_t end = text.find('\n', at);
      text.erase(at, end == std::string::npos ? end : end - at);
    }
  }
}

/// Pictures that a style sheet names become part of it.
void embed_pictures(std::string& style, const fs::path& folder, const char* package) {
  constexpr std::string_view mark = "url(\"../";
  for (std::size_t at = 0; (at = style.find(mark, at)) != std::string::npos;) {
    const std::size_t begin = at + mark.size(), end = style.find("\")", begin);
    if (end == std::string::npos) return;
    const std::string picture = read_library_file(folder / ".." / style.substr(begin, end - begin), package);
    const std::string embedded = "url(\"data:image/png;base64," + base64(picture);
    style.replace(at, end - at, embedded);
    at += embedded.size();
  }
}

}  // namespace

ReportLibraries read_report_libraries(const std::string& folder) {
  ReportLibraries libraries;
  for (const LibraryFile& file : scripts) {
    std::string text = read_library_file(fs::path(folder) / file.path, file.package);
    drop_source_map(text);
    replace_all(text, "</script", "<\\/script");
    libraries.scripts += fmt::format("<script>\n{}\n</script>\n", text);
  }
  for (const LibraryFile& file : styles) {
    const fs::path path = fs::path(folder) / file.path;
    std::string text = read_library_file(path, file.package);
    drop_source_map(text);
    embed_pictures(text, path.parent_path(), file.package);
    libraries.styles += fmt::format("<style>\n{}\n</style>\n", text);
  }
  for (const char* package : packages) {
    const fs::path path = fs::path("/usr/share/doc") / package / "copyright";
    libraries.licences.push_back({package, read_library_file(path, package)});
  }
  return libraries;
}

}  // namespace fingerpad

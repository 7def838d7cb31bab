#include <fmt/format.h>

#include <OpenMesh/Core/IO/reader/OBJReader.hh>
#include <algorithm>
#include <array>

#include "base/error.hpp"
#include "part/mesh_format.hpp"
#include "part/openmesh_reader.hpp"
#include "part/raw_mesh.hpp"
#include "part/sniff.hpp"
#include "part/text_cursor.hpp"

namespace fingerpad {
namespace {

/// One pass over the lines. Positive indices are checked at the end, as a face may stand before its vertices.
class ObjText {
 public:
  explicit ObjText(std::string& bytes) : bytes_(bytes), cursor_(bytes) {}

  RawMesh scan() {
    mesh_.format = "OBJ";
    join_continued_lines();
    while (!cursor_.at_end()) {
      const std::size_t from = cursor_.offset();
      const std::string_view keyword = cursor_.word_in_line();
      if (keyword == "v") {
        vertex();
      } else if (keyword == "f" || keyword == "fo") {
        face();
      } else {
        other(keyword);
        cursor_.rest_of_line();
        blank(from);
        continue;
      }
      cursor_.rest_of_line();
      // Within the line: a file without comments must not be searched to its end on every line.
      const std::size_t comment = std::string_view(bytes_).substr(from, cursor_.offset() - from).find('#');
      if (comment != std::string_view::npos) blank(from + comment);
    }
    const int count = static_cast<int>(mesh_.vertices.size());
    for (int& corner : mesh_.corners) {
      if (corner >= count) corner = -1;
    }
    if (strange_ > 0) {
      mesh_.warnings.push_back(
          fmt::format("{} lines begin with a word that is none of OBJ's ('{}' on line {}): "
                      "they are passed over",
                      strange_, first_strange_, first_strange_line_));
    }
    if (free_form_)
      mesh_.warnings.emplace_back("free-form curves and surfaces are passed over: only faces are touched");
    return std::move(mesh_);
  }

 private:
  /// A backslash at a line's end: the next line belongs to this one. OpenMesh does not know that. A comment
  /// that ends so (`# C:\models\`) does not swallow the next line: there may be a vertex on it.
  void join_continued_lines() {
    std::size_t searched = 0;  // behind the last line joined
    for (std::size_t at = bytes_.find('\\'); at != std::string::npos; at = bytes_.find('\\', at + 1)) {
      std::size_t end = at + 1;
      if (end < bytes_.size() && bytes_[end] == '\r') ++end;
      if (end < bytes_.size() && bytes_[end] != '\n') continue;
      const std::string_view before = std::string_view(bytes_).substr(searched, at - searched);
      const std::size_t start = before.rfind('\n') + 1;  // npos + 1 is 0
      searched = std::min(end + 1, bytes_.size());
      if (before.find('#', start) != std::string_view::npos) continue;
      std::fill_n(bytes_.begin() + static_cast<std::ptrdiff_t>(at), std::min(end + 1, bytes_.size()) - at,
                  ' ');
      joined_ = true;
    }
  }

  /// Counted lines run behind the file's where lines were joined.
  std::string place() const { return joined_ ? "about " + cursor_.place() : cursor_.place(); }

  void blank(std::size_t from) {
    for (std::size_t i = from; i < cursor_.offset(); ++i) {
      if (bytes_[i] != '\n') bytes_[i] = ' ';
    }
  }

  /// A statement that is passed over. What cannot be one of any writer's is refused, for it may be a vertex
  /// or a face that something in front of it hides.
  void other(std::string_view keyword) {
    if (keyword.empty() || keyword[0] == '#' || is_statement(keyword)) {
      if (keyword == "curv2" || keyword == "surf") free_form_ = true;
      return;
    }
    const auto is_plain = [](char c) { return c > ' ' && c <= '~'; };
    const bool letter = (keyword[0] | 0x20) >= 'a' && (keyword[0] | 0x20) <= 'z';
    if ((!letter && keyword[0] != '/' && keyword[0] != '!' && keyword[0] != ';') ||
        !std::all_of(keyword.begin(), keyword.end(), is_plain)) {
      throw refused(place(), "'" + shown(keyword) + "' begins no line of an OBJ");
    }
    if (strange_++ > 0) return;
    first_strange_ = shown(keyword);
    first_strange_line_ = cursor_.line();
  }

  /// Every statement of the format but vertices and faces.
  static bool is_statement(std::string_view word) {
    static constexpr std::array<std::string_view, 47> statements{
        "vn",        "vt",       "g",     "s",      "o",           "usemtl", "mtllib", "vp",
        "l",         "p",        "mg",    "cstype", "deg",         "bmat",   "step",   "curv",
        "curv2",     "surf",     "parm",  "trim",   "hole",        "scrv",   "sp",     "end",
        "con",       "bevel",    "lod",   "usemap", "maplib",      "call",   "csh",    "shadow_obj",
        "trace_obj", "ctech",    "stech", "bsp",    "bzp",         "cdc",    "cdp",    "res",
        "c_interp",  "d_interp", "vc",    "mtl",    "subdivision", "e",      "t"};
    return std::find(statements.begin(), statements.end(), word) != statements.end();
  }

  void vertex() {
    Vec3 numbers;
    for (int i = 0; i < 3; ++i) {
      const std::string_view word = cursor_.word_in_line();
      const auto number = coordinate_of(word);
      if (!number) throw refused(place(), not_a_number(word));
      numbers[i] = *number;
    }
    mesh_.add_vertex(numbers, static_cast<std::size_t>(cursor_.line()));
    // A weight or a colour may follow; any other word is of a line whose end something hides.
    for (std::string_view word = cursor_.word_in_line(); !word.empty() && word[0] != '#';
         word = cursor_.word_in_line()) {
      if (!coordinate_of(word)) throw refused(place(), not_a_number(word) + " behind a vertex");
    }
  }

  void face() {
    for (std::string_view word = cursor_.word_in_line(); !word.empty(); word = cursor_.word_in_line()) {
      if (word[0] == '#') break;
      const auto index = integer_of(word.substr(0, word.find('/')));
      if (!index) throw refused(place(), "'" + shown(word) + "' is no corner of a face");
      mesh_.corners.push_back(vertex_number(*index));
    }
    mesh_.end_polygon();
  }

  /// From 1, or from the last one backwards.
  int vertex_number(long long index) const {
    const auto count = static_cast<long long>(mesh_.vertices.size());
    const long long number = index < 0 ? count + index : index - 1;
    return number < 0 || number > 0x3fffffff ? -1 : static_cast<int>(number);
  }

  std::string& bytes_;
  TextCursor cursor_;
  RawMesh mesh_;
  bool joined_ = false, free_form_ = false;
  long strange_ = 0, first_strange_line_ = 0;
  std::string first_strange_;
};

RawMesh scan_obj(std::string& bytes) {
  refuse_binary(bytes);
  return ObjText(bytes).scan();
}

bool begins_obj(std::string_view word) {
  constexpr std::array<std::string_view, 9> keywords{"v", "vn", "vt",     "vp",    "o",
                                                     "g", "s",  "mtllib", "usemtl"};
  return std::find(keywords.begin(), keywords.end(), word) != keywords.end();
}

}  // namespace

MeshFormat obj_format() noexcept {
  static constexpr std::string_view endings[] = {".obj"};
  return {"OBJ",
          endings,
          [](std::string_view) { return false; },
          begins_obj,
          scan_obj,
          [](const std::string& bytes, const RawMesh& mesh, const LoadProgress& progress) {
            return read_by_openmesh(OpenMesh::IO::OBJReader(), bytes, mesh, progress);
          }};
}

}  // namespace fingerpad

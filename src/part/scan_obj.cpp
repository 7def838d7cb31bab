#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "part/raw_mesh.hpp"
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
        if (keyword == "curv2" || keyword == "surf") free_form_ = true;
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
    if (free_form_)
      mesh_.warnings.emplace_back("free-form curves and surfaces are passed over: only faces are touched");
    return std::move(mesh_);
  }

 private:
  /// A backslash at a line's end: the next line belongs to this one. OpenMesh does not know that.
  void join_continued_lines() {
    for (std::size_t at = bytes_.find('\\'); at != std::string::npos; at = bytes_.find('\\', at + 1)) {
      std::size_t end = at + 1;
      if (end < bytes_.size() && bytes_[end] == '\r') ++end;
      if (end < bytes_.size() && bytes_[end] != '\n') continue;
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

  void vertex() {
    Vec3 numbers;
    for (int i = 0; i < 3; ++i) {
      const std::string_view word = cursor_.word_in_line();
      const auto number = coordinate_of(word);
      if (!number) throw refused(place(), not_a_number(word));
      numbers[i] = *number;
    }
    mesh_.add_vertex(numbers, static_cast<std::size_t>(cursor_.line()));
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
};

}  // namespace

RawMesh scan_obj(std::string& bytes) {
  return ObjText(bytes).scan();
}

}  // namespace fingerpad

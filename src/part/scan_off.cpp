#include <fmt/format.h>

#include <OpenMesh/Core/IO/reader/OFFReader.hh>

#include "base/error.hpp"
#include "part/mesh_format.hpp"
#include "part/openmesh_reader.hpp"
#include "part/raw_mesh.hpp"
#include "part/sniff.hpp"
#include "part/text_cursor.hpp"

namespace fingerpad {
namespace {

/// A line of words without its comment; lines that are empty then are passed over.
class OffText {
 public:
  explicit OffText(std::string& bytes) : bytes_(bytes), file_(bytes) {}

  RawMesh scan() {
    mesh_.format = "OFF";
    header();
    for (long long i = 0; i < vertex_count_; ++i) vertex();
    for (long long i = 0; i < face_count_; ++i) face();
    bytes_ = std::move(plain_);
    return std::move(mesh_);
  }

 private:
  /// Copies what was read of the line. OpenMesh gets the bare mesh: it stumbles over comments between lines,
  /// over a header that shares its line, and over face colours that the header does not name. A number that
  /// its stream cannot take would leave its counters at random values, so `otherwise` stands for a line with
  /// such a one.
  void keep_line(bool takes, const std::string& otherwise) {
    plain_.append(takes ? line_text_.substr(0, line_.offset()) : std::string_view(otherwise)).append("\n");
  }

  bool next_line() {
    while (!file_.at_end()) {
      line_number_ = file_.line();
      const std::string_view line = file_.rest_of_line();
      line_text_ = line.substr(0, line.find('#'));
      line_ = TextCursor(line_text_);
      if (!TextCursor(line_).word_in_line().empty()) return true;
    }
    return false;
  }

  std::string place() const { return fmt::format("line {}", line_number_); }

  void need_line(std::string_view of_what) {
    if (next_line()) return;
    throw refused(fmt::format("line {}", file_.line()),
                  fmt::format("truncated: the file ends within its {}", of_what));
  }

  void header() {
    need_line("header");
    std::string_view word = line_.word_in_line();
    const auto name = word.find("OFF");
    if (name == std::string_view::npos)
      throw refused(place(), "'" + shown(word) + "' where 'OFF' should stand");
    if (word.substr(0, name).find_first_of("4n") != std::string_view::npos) {
      throw refused(place(), "'" + shown(word) + "' has points of other than three dimensions");
    }
    word.remove_prefix(name + 3);  // counts may follow without a blank
    if (word.empty()) word = line_.word_in_line();
    if (same_word(word, "BINARY"))
      throw refused(place(), "binary OFF is not read: save as text OFF, PLY or STL");
    if (word.empty()) {
      need_line("header");
      word = line_.word_in_line();
    }
    const long long vertices = count(word), faces = count(line_.word_in_line());
    const std::size_t left = bytes_.size() - file_.offset() + 1;              // a last line needs no end
    vertex_count_ = plausible_count(vertices, 6, left, place(), "vertices");  // "0 0 0\n"
    face_count_ = plausible_count(faces, 2, left, place(), "faces");          // "0\n"
    plain_ = fmt::format("OFF\n{} {} 0\n", vertex_count_, face_count_);
  }

  long long count(std::string_view word) const {
    const auto number = integer_of(word);
    if (!number)
      throw refused(place(), "the counts of vertices and faces should stand here: " + not_a_number(word));
    return *number;
  }

  /// What is wrong with a word where a number should stand.
  std::string complaint(std::string_view word) const {
    return word.empty() && file_.at_end() ? "truncated: the file ends here" : not_a_number(word);
  }

  void vertex() {
    need_line("vertices");
    Vec3 numbers;
    for (int i = 0; i < 3; ++i) {
      const std::string_view word = line_.word_in_line();
      const auto number = coordinate_of(word);
      if (!number) throw refused(place(), complaint(word));
      numbers[i] = *number;
    }
    const std::size_t nonfinite = mesh_.nonfinite.size();
    mesh_.add_vertex(numbers, static_cast<std::size_t>(line_number_));
    keep_line(mesh_.nonfinite.size() == nonfinite, "0 0 0");
  }

  void face() {
    need_line("faces");
    const auto corners = integer_of(line_.word_in_line());
    bool in_range = true;
    if (!corners || *corners < 0) throw refused(place(), "a face begins with the number of its corners");
    for (long long k = 0; k < *corners; ++k) {
      const std::string_view word = line_.word_in_line();
      const auto index = integer_of(word);
      if (!index)
        throw refused(place(), fmt::format("corner {} of {}: {}", k + 1, *corners, complaint(word)));
      const bool names_one = *index >= 0 && *index < vertex_count_;
      mesh_.corners.push_back(names_one ? static_cast<int>(*index) : -1);
      in_range = in_range && names_one;
    }
    mesh_.end_polygon();
    keep_line(in_range, "0");
  }

  std::string& bytes_;
  TextCursor file_, line_{std::string_view()};
  long line_number_ = 1;
  std::string_view line_text_;
  std::string plain_;
  long long vertex_count_ = 0, face_count_ = 0;
  RawMesh mesh_;
};

RawMesh scan_off(std::string& bytes) {
  refuse_binary(bytes);
  return OffText(bytes).scan();
}

}  // namespace

MeshFormat off_format() noexcept {
  static constexpr std::string_view endings[] = {".off"};
  return {"OFF",
          endings,
          [](std::string_view bytes) { return bytes.starts_with("OFF\n") || bytes.starts_with("OFF\r"); },
          [](std::string_view word) { return word.ends_with("OFF"); },
          scan_off,
          [](const std::string& bytes, const RawMesh& mesh, const LoadProgress& progress) {
            return read_by_openmesh(OpenMesh::IO::OFFReader(), bytes, mesh, progress);
          }};
}

}  // namespace fingerpad

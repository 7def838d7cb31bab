#include <fmt/format.h>

#include <OpenMesh/Core/IO/reader/PLYReader.hh>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "base/error.hpp"
#include "part/mesh_format.hpp"
#include "part/openmesh_reader.hpp"
#include "part/plain_ply.hpp"
#include "part/ply_header.hpp"
#include "part/raw_mesh.hpp"
#include "part/sniff.hpp"
#include "part/text_cursor.hpp"

namespace fingerpad {
namespace {

template <typename T>
double scalar(const char* at, bool swapped) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), at, sizeof(T));
  if (swapped) std::reverse(raw.begin(), raw.end());
  return static_cast<double>(std::bit_cast<T>(raw));
}

/// The numbers of the body, one after the other, whatever its form.
class PlyNumbers {
 public:
  PlyNumbers(std::string_view bytes, const PlyHeader& header)
      : bytes_(bytes),
        form_(header.form),
        at_(header.body),
        text_(bytes.substr(header.body), header.body_line) {}

  double next(PlyType type) {
    if (form_ == PlyHeader::Form::text) return next_word(type);
    if (ply_size(type) > bytes_.size() - at_) throw truncated();
    const char* at = bytes_.data() + at_;
    at_ += ply_size(type);
    const bool swapped = (form_ == PlyHeader::Form::big_endian) != (std::endian::native == std::endian::big);
    switch (type) {
      case PlyType::int8:
        return scalar<std::int8_t>(at, swapped);
      case PlyType::uint8:
        return scalar<std::uint8_t>(at, swapped);
      case PlyType::int16:
        return scalar<std::int16_t>(at, swapped);
      case PlyType::uint16:
        return scalar<std::uint16_t>(at, swapped);
      case PlyType::int32:
        return scalar<std::int32_t>(at, swapped);
      case PlyType::uint32:
        return scalar<std::uint32_t>(at, swapped);
      case PlyType::float32:
        return scalar<float>(at, swapped);
      case PlyType::float64:
        return scalar<double>(at, swapped);
    }
    return 0;
  }

  /// The number of items in a list: not negative, and no more than the rest of the file can hold.
  long long next_count(const PlyProperty& list) {
    const std::size_t where = place_number();
    const auto count = static_cast<long long>(next(list.count_type));
    const bool text = form_ == PlyHeader::Form::text;
    const std::size_t left = text ? bytes_.size() - at_ - text_.offset() + 1 : bytes_.size() - at_;
    const std::size_t least = text ? 2 : ply_size(list.type);
    // The place is only put into words for a count that will be refused: they took half of the scan.
    if (count >= 0 && static_cast<std::size_t>(count) <= left / least) return count;
    return plausible_count(count, least, left, place_words(where), "items in a list");
  }

  /// No fewer than there are numbers to come.
  std::size_t bytes_left() const { return bytes_.size() - at_; }

  std::size_t place_number() const {
    return form_ == PlyHeader::Form::text ? static_cast<std::size_t>(text_.line()) : at_;
  }
  std::string place() const { return place_words(place_number()); }

 private:
  std::string place_words(std::size_t number) const {
    return fmt::format("{} {}", form_ == PlyHeader::Form::text ? "line" : "byte", number);
  }
  Error truncated() const { return refused(place(), "truncated: the file ends before its last element"); }

  double next_word(PlyType type) {
    const std::string_view word = text_.word();
    if (word.empty()) throw truncated();
    if (type == PlyType::float32 || type == PlyType::float64) {
      if (const auto number = coordinate_of(word)) return *number;
    } else if (const auto number = integer_of(word)) {
      return static_cast<double>(*number);
    }
    throw refused(place(), not_a_number(word));
  }

  std::string_view bytes_;
  PlyHeader::Form form_;
  std::size_t at_;
  TextCursor text_;
};

class PlyScan {
 public:
  PlyScan(std::string_view bytes, const PlyHeader& header) : header_(header), numbers_(bytes, header) {}

  RawMesh scan() {
    mesh_.binary = header_.form != PlyHeader::Form::text;
    mesh_.format = mesh_.binary ? "binary PLY" : "text PLY";
    if (mesh_.binary) mesh_.place_unit = "byte";
    for (const PlyElement& element : header_.elements) {
      if (element.name == "vertex") {
        vertices(element);
      } else if (element.name == "face") {
        faces(element);
      } else {
        if (element.name == "tristrips")
          mesh_.warnings.emplace_back("triangle strips are passed over: save as faces");
        for (long long i = 0; i < element.count; ++i) skip(element, 0, element.properties.size());
      }
    }
    const int count = static_cast<int>(mesh_.vertices.size());
    for (int& corner : mesh_.corners) {
      if (corner >= count) corner = -1;
    }
    return std::move(mesh_);
  }

 private:
  void skip(const PlyElement& element, std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
      const PlyProperty& property = element.properties[i];
      const long long count = property.is_list ? numbers_.next_count(property) : 1;
      for (long long k = 0; k < count; ++k) numbers_.next(property.type);
    }
  }

  void vertices(const PlyElement& element) {
    const std::array<int, 3> axes{element.find("x"), element.find("y"), element.find("z")};
    mesh_.float32 = mesh_.binary;
    for (const int axis : axes) {
      if (axis < 0 || element.properties[static_cast<std::size_t>(axis)].is_list) {
        throw refused("header", "the vertices have no x, y and z");
      }
      const PlyType type = element.properties[static_cast<std::size_t>(axis)].type;
      mesh_.float32 = mesh_.float32 && type == PlyType::float32;
    }
    mesh_.vertices.reserve(mesh_.vertices.size() + static_cast<std::size_t>(element.count));
    for (long long i = 0; i < element.count; ++i) {
      Vec3 vertex = Vec3::Zero();
      const std::size_t place = numbers_.place_number();
      for (std::size_t p = 0; p < element.properties.size(); ++p) {
        const auto axis = std::find(axes.begin(), axes.end(), static_cast<int>(p));
        if (axis == axes.end()) {
          skip(element, p, p + 1);
        } else {
          vertex[axis - axes.begin()] = numbers_.next(element.properties[p].type);
        }
      }
      mesh_.add_vertex(vertex, place);
    }
  }

  void faces(const PlyElement& element) {
    const int named = std::max(element.find("vertex_indices"), element.find("vertex_index"));
    if (named < 0 || !element.properties[static_cast<std::size_t>(named)].is_list) {
      if (element.count > 0) throw refused("header", "the faces have no list vertex_indices");
      return;
    }
    const auto list = static_cast<std::size_t>(named);
    const auto announced = static_cast<std::size_t>(element.count);  // the file has the bytes for it
    mesh_.ends.reserve(mesh_.ends.size() + announced);
    mesh_.corners.reserve(mesh_.corners.size() + std::min(3 * announced, numbers_.bytes_left()));
    for (long long i = 0; i < element.count; ++i) {
      skip(element, 0, list);
      const long long count = numbers_.next_count(element.properties[list]);
      for (long long k = 0; k < count; ++k) {
        const double index = numbers_.next(element.properties[list].type);
        const bool whole =
            index >= 0 && index <= std::numeric_limits<int>::max() && index == std::floor(index);
        mesh_.corners.push_back(whole ? static_cast<int>(index) : -1);
      }
      mesh_.end_polygon();
      skip(element, list + 1, element.properties.size());
    }
  }

  const PlyHeader& header_;
  PlyNumbers numbers_;
  RawMesh mesh_;
};

RawMesh scan_ply(std::string& bytes) {
  const PlyHeader header = read_ply_header(bytes);
  if (header.form == PlyHeader::Form::text) refuse_binary(bytes);
  RawMesh mesh = PlyScan(bytes, header).scan();
  write_plainly(bytes, header, mesh);
  return mesh;
}

}  // namespace

MeshFormat ply_format() noexcept {
  static constexpr std::string_view endings[] = {".ply"};
  return {"PLY",
          endings,
          [](std::string_view bytes) { return bytes.starts_with("ply\n") || bytes.starts_with("ply\r"); },
          [](std::string_view) { return false; },
          scan_ply,
          [](const std::string& bytes, const RawMesh& mesh, const LoadProgress& progress) {
            return read_by_openmesh(OpenMesh::IO::PLYReader(), bytes, mesh, progress);
          }};
}

}  // namespace fingerpad

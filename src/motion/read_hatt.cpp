#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>

#include "base/csv_cells.hpp"
#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/printable_text.hpp"
#include "motion/field_format.hpp"
#include "motion/flat_xml.hpp"

// Penn Haptic Texture Toolkit (Culbertson, Lopez Delgado, Kuchenbecker 2014, "The Penn Haptic Texture Toolkit
// for Modeling, Rendering, and Evaluating Haptic Virtual Textures", University of Pennsylvania): ten seconds
// of a hand-held tool on each of a hundred surfaces at 10 kHz, as XML. For non-commercial research.
//
// The layout is that which an independent public reader of the report's recorded data (PennHattAdapter of the
// project tactile_toolkit, with its test) takes: SampleRate in Hz; ForceUnits, PositionUnits; Force with x, y
// and z (or ForceX, ForceY, ForceZ), ForceNormal and ForceTangential, Position with x, y and z likewise, each
// a list of numbers parted by blanks, commas or semicolons; Accel and Speed are passed over. Not verified:
// the report itself and real files; the axes of Force against the surface, and its sense. So Force is taken
// only where its z, or that turned round, is ForceNormal: then z is the surface's normal, and forces are
// turned to those on the tool. Positions are in the axes of the tracker, whose z need not be that of the
// force: that is said with the recording.

namespace fingerpad {
namespace {

constexpr InputKind hatt_file = {"a recording (XML)", std::uint64_t{256} << 20, false};

/// The elements of a recording.
struct HattElements {
  const std::string& path;
  const std::vector<XmlText>& texts;

  Error fault(const XmlText& text, const std::string& what) const {
    return refused(fmt::format("{}:{}", path, text.line), what);
  }
  const XmlText* find(std::string_view name) const {
    const XmlText* found = nullptr;
    for (const XmlText& text : texts) {
      if (text.path != name) continue;
      if (found != nullptr) throw fault(text, fmt::format("has a second element '{}'", name));
      found = &text;
    }
    return found;
  }
  /// The numbers of an element; none where it is not there.
  std::vector<double> numbers(std::string_view name) const {
    std::vector<double> read;
    const XmlText* element = find(name);
    if (element == nullptr) return read;
    constexpr std::string_view marks = " \t\r\n,;";
    std::string_view rest = element->text;
    for (std::size_t at = rest.find_first_not_of(marks); at != std::string_view::npos;
         at = rest.find_first_not_of(marks)) {
      rest.remove_prefix(at);
      const std::string_view word = rest.substr(0, rest.find_first_of(marks));
      const auto value = csv_number(word, '.');
      if (!value || !std::isfinite(*value))
        throw fault(*element,
                    fmt::format("'{}' in '{}' is no number", printable(std::string(word), 40), name));
      read.push_back(*value);
      rest.remove_prefix(word.size());
    }
    return read;
  }
  /// Three components as points; 3 x 0 where none is there.
  Points vectors(const std::string& name) const {
    std::array<std::vector<double>, 3> axes;
    for (std::size_t k = 0; k < 3; ++k) {
      axes[k] = numbers(name + "/" + "xyz"[k]);
      if (axes[k].empty()) axes[k] = numbers(name + "xyz"[k]);
    }
    if (axes[0].size() != axes[1].size() || axes[0].size() != axes[2].size())
      throw refused(path, fmt::format("'{}' has {}, {} and {} numbers along x, y and z", name, axes[0].size(),
                                      axes[1].size(), axes[2].size()));
    Points points(3, static_cast<Eigen::Index>(axes[0].size()));
    for (Eigen::Index k = 0; k < 3; ++k)
      points.row(k) =
          Eigen::Map<const Eigen::RowVectorXd>(axes[static_cast<std::size_t>(k)].data(), points.cols());
    return points;
  }
  /// The unit that an element names.
  std::string unit(std::string_view name) const {
    const XmlText* element = find(name);
    return element == nullptr ? "" : std::string(trimmed(element->text));
  }
};

double hatt_metres(const HattElements& elements, const RecordingFormat& format) {
  const std::string unit = elements.unit("positionunits");
  if (unit == "m") return 1;
  if (unit == "mm") return 1e-3;
  if (unit.empty() && format.says_unit) return format.metres_per_unit;
  throw refused(elements.path, fmt::format("PositionUnits {}; known are m and mm{}",
                                           unit.empty() ? "is missing" : "is '" + printable(unit, 20) + "'",
                                           unit.empty() ? ": say unit in [motion], or --unit" : ""));
}

/// 1 or -1 where z of the force, so turned, is the normal force; 0 where neither is.
int normal_sense(const Points& force, const std::vector<double>& normal) {
  if (static_cast<std::size_t>(force.cols()) != normal.size() || normal.empty()) return 0;
  double square = 0;
  std::array<double, 2> off{};
  for (std::size_t i = 0; i < normal.size(); ++i) {
    const double z = force(2, static_cast<Eigen::Index>(i));
    square += normal[i] * normal[i];
    off[0] += (z - normal[i]) * (z - normal[i]);
    off[1] += (-z - normal[i]) * (-z - normal[i]);
  }
  constexpr double alike = 0.05;  // RMS: what rounding and filtering of either leave
  if (!(square > 0)) return 0;
  if (off[0] <= alike * alike * square) return 1;
  return off[1] <= alike * alike * square ? -1 : 0;
}

void take_hatt_forces(const HattElements& elements, FieldRecording& recording) {
  Motion& motion = recording.motion;
  const auto samples = static_cast<std::size_t>(motion.p_WQ.cols());
  if (const std::string unit = elements.unit("forceunits"); !unit.empty() && unit != "N")
    throw refused(elements.path, fmt::format("ForceUnits is '{}'; known is N", printable(unit, 20)));
  motion.normal_force_n = elements.numbers("forcenormal");
  const Points force = elements.vectors("force");
  if (force.cols() > 0 && static_cast<std::size_t>(force.cols()) != samples)
    throw refused(elements.path, fmt::format("has {} positions and {} forces", samples, force.cols()));
  if (!motion.normal_force_n.empty() && motion.normal_force_n.size() != samples)
    throw refused(elements.path, fmt::format("has {} positions and {} normal forces", samples,
                                             motion.normal_force_n.size()));
  const int sense = normal_sense(force, motion.normal_force_n);
  if (sense != 0) {
    motion.force_W_n = sense * force;
    recording.notes.push_back(fmt::format("z of Force is {}ForceNormal: forces are those on the tool",
                                          sense > 0 ? "" : "the opposite of "));
  } else if (force.cols() > 0) {
    recording.notes.push_back(
        "Force is passed over: neither its z nor that turned round is ForceNormal, so its axes "
        "against the surface are not known");
  }
}

FieldRecording read_hatt(const std::string& path, const RecordingFormat& format) {
  const std::string xml = read_whole_file(path, hatt_file);
  const std::vector<XmlText> texts = xml_texts(xml, path);
  const HattElements elements{path, texts};
  FieldRecording recording;
  const std::vector<double> rate_hz = elements.numbers("samplerate");
  if (rate_hz.size() != 1 || !(rate_hz[0] > 0))
    throw refused(path, "has no SampleRate in Hz, which a recording of the Penn Haptic Texture Toolkit has");
  Motion& motion = recording.motion;
  motion.p_WQ = elements.vectors("position");
  if (motion.p_WQ.cols() == 0)
    throw refused(path, "has no Position: it is a model or a part of a recording, without the tool's way");
  motion.p_WQ *= hatt_metres(elements, format);
  for (Eigen::Index i = 0; i < motion.p_WQ.cols(); ++i) {
    motion.t_s.push_back(static_cast<double>(i) / rate_hz[0]);
    if (const std::string fault = sample_fault(motion.t_s.back(), motion.p_WQ.col(i)); !fault.empty())
      throw refused(path, fmt::format("sample {}: {}", i + 1, fault));
  }
  take_hatt_forces(elements, recording);
  recording.notes.push_back(
      fmt::format("read as hatt: {} samples at {} Hz of a hand-held tool; positions are in the "
                  "tracker's axes",
                  motion.t_s.size(), rate_hz[0]));
  return recording;
}

std::vector<std::string> hatt_files(const std::string& path, const RecordingFormat&) {
  return {path};
}

}  // namespace

FieldFormat hatt_format() noexcept {
  static constexpr std::array<std::string_view, 1> keys{"unit"};  // where PositionUnits is missing
  constexpr bool has_one_frame = false;
  return {"hatt",     "Penn Haptic Texture Toolkit: its recorded data, XML",
          "a tool",   false,
          hatt_files, read_hatt,
          keys,       has_one_frame};
}

}  // namespace fingerpad

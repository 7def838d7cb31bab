#pragma once

#include <span>
#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "touch/tick_record.hpp"

namespace fingerpad {

/// A touch against time, as the paper draws it: along the one direction in which the finger mostly rubbed.
struct TouchSeries {
  Vec3 direction_W = Vec3::UnitX();  ///< unit
  std::string direction_name;        ///< "x" where it is a world axis, to half a degree, else "u"
  std::vector<double> t_s;
  std::vector<double> position_m;     ///< along the direction: of the contact point, of the finger while free
  std::vector<double> centre_m;       ///< of the stick centre; nan unless sticking
  std::vector<double> speed_m_per_s;  ///< tangential; nan while free and on the first tick of a contact
  std::vector<double> normal_force_n;
  /// Along the direction where the finger rubs straight over a flat place: then it is the friction's
  /// component in the world. Elsewhere friction_along_sliding.
  std::vector<double> friction_n;
  std::string friction_name;  ///< "friction along x", "friction along the sliding direction"
  std::string friction_sign;  ///< what its sign means: "- against it"
  std::vector<double> mu;     ///< nan while free
  std::vector<Phase> phase;
  /// Slip has just given way to stick (the paper's points a, fig. 9) on the one wall that holds the finger:
  /// of several the phase is the greatest's, and passes from one to another without an end of slip. Not where
  /// the finger is lifted straight off, at rest along the surface for its last ticks.
  std::vector<bool> slip_ends;
};

/// The direction of most motion: the first principal axis of the contact points (of the finger where nothing
/// was touched). Signed so that its largest component is positive.
Vec3 main_direction(std::span<const TickRecord> rows);

/// "x", "y", "z" of a world axis, to half a degree, else "u".
std::string direction_name(const Vec3& direction_W);
bool is_world_axis(const Vec3& direction_W);

/// Whether two unit vectors lie along one line, to half a degree, whichever way each points.
bool are_along_one_line(const Vec3& a_W, const Vec3& b_W);

/// How a finger rubs.
struct RubLine {
  Vec3 direction_W = Vec3::UnitX();  ///< main_direction
  bool is_straight =
      false;           ///< along it, where the surface does not turn, to half a degree; likewise at rest
  bool moves = false;  ///< while it touches
};
RubLine rub_line(std::span<const TickRecord> rows);

TouchSeries touch_series(std::span<const TickRecord> rows, const Vec3& direction_W);

/// The friction on the finger along the way that the finger slides in the tangent plane [N]: negative where
/// it holds the finger back, positive where a stretched pad still pushes it on. Where the finger is slower
/// than a thousandth of its fastest, the way is the one that it had before, and before its first slide that
/// of this one, as where the rows begin within a rest. 0 while free.
std::vector<double> friction_along_sliding(std::span<const TickRecord> rows);

/// At each row how fast the finger has got on over the last `span_s` of its contact [m/s]: the way from where
/// it was then, straight on, which levels out the steps of an encoder (and what goes to and fro within the
/// span); nan while free and on the first tick of a contact.
std::vector<double> net_speed(std::span<const TickRecord> rows, double span_s);

/// Tangential speed from one tick to the next [m/s]; nan unless both are in contact.
double tangential_speed(const TickRecord& before, const TickRecord& row);

/// For a reading: the same in contact; in the air the finger's own.
double shown_speed(const TickRecord& before, const TickRecord& row);

}  // namespace fingerpad

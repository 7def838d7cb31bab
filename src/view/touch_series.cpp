#include "view/touch_series.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace fingerpad {
namespace {

constexpr double half_degree_cosine = 0.99996192;

/// Not s, which is how far the finger has gone along the surface (Over::travel).
constexpr const char* turned_direction_name = "u";

const Vec3& place_of(const TickRecord& row) {
  return row.phase == Phase::free ? row.p_WQ : row.contact_W;
}

/// Whether the finger rubs along one line over a place where the surface does not turn, to half a degree.
bool rubs_straight(std::span<const TickRecord> rows, const Vec3& direction_W) {
  constexpr double half_degree = 0.0087;
  const TickRecord* first = nullptr;
  double along_squared = 0, across_squared = 0;
  for (const TickRecord& row : rows) {
    if (row.phase == Phase::free) continue;
    if (first == nullptr) first = &row;
    if (std::abs(row.normal_W.dot(direction_W)) > half_degree) return false;
    const Vec3 way = row.contact_W - first->contact_W;
    const double along = way.dot(direction_W);
    along_squared += along * along;
    across_squared += (way - along * direction_W).squaredNorm();
  }
  return across_squared <= half_degree * half_degree * along_squared;
}

/// What the finger goes in the tangent plane from one tick to the next; zero unless both touch.
Vec3 tangential_step(const TickRecord& before, const TickRecord& row) {
  if (row.phase == Phase::free || before.phase == Phase::free) return Vec3::Zero();
  const Vec3 step = row.p_WQ - before.p_WQ;
  return step - step.dot(row.normal_W) * row.normal_W;
}

/// Whether the pad sticks at a row after slip only because it is lifted straight off, as a released finger
/// is.
bool is_lifted_off(std::span<const TickRecord> rows, std::size_t stick) {
  constexpr double resting_share = 1e-3;
  if (stick < 2) return false;
  const double resting = resting_share * tangential_speed(rows[stick - 2], rows[stick - 1]);
  std::size_t i = stick;
  for (; i < rows.size() && rows[i].phase == Phase::stick; ++i) {
    if (!(tangential_speed(rows[i - 1], rows[i]) < resting)) return false;
  }
  return i < rows.size() && rows[i].phase == Phase::free;
}

bool moves_in_touch(std::span<const TickRecord> rows) {
  const TickRecord* first = nullptr;
  for (const TickRecord& row : rows) {
    if (row.phase == Phase::free) continue;
    if (first != nullptr && row.contact_W != first->contact_W) return true;
    if (first == nullptr) first = &row;
  }
  return false;
}

}  // namespace

std::string direction_name(const Vec3& direction_W) {
  constexpr const char* names[] = {"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis) {
    if (direction_W[axis] > half_degree_cosine) return names[axis];
  }
  return turned_direction_name;
}

bool is_world_axis(const Vec3& direction_W) {
  return direction_name(direction_W) != turned_direction_name;
}

bool are_along_one_line(const Vec3& a_W, const Vec3& b_W) {
  return std::abs(a_W.dot(b_W)) > half_degree_cosine;
}

RubLine rub_line(std::span<const TickRecord> rows) {
  const Vec3 direction_W = main_direction(rows);
  return {direction_W, rubs_straight(rows, direction_W), moves_in_touch(rows)};
}

std::vector<double> friction_along_sliding(std::span<const TickRecord> rows) {
  constexpr double resting_share = 1e-3;
  double fastest = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double speed = tangential_speed(rows[i - 1], rows[i]);
    if (speed > fastest) fastest = speed;
  }
  const auto slides = [&](std::size_t i) {
    return i > 0 && tangential_speed(rows[i - 1], rows[i]) > resting_share * fastest;
  };
  std::size_t first = 0;
  while (first < rows.size() && !slides(first)) ++first;
  const bool any = first < rows.size();
  Vec3 way = any ? tangential_step(rows[first - 1], rows[first]).normalized() : Vec3(Vec3::Zero());
  std::vector<double> friction_n;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (slides(i)) way = tangential_step(rows[i - 1], rows[i]).normalized();
    friction_n.push_back(rows[i].phase == Phase::free ? 0 : rows[i].friction_W_n.dot(way));
  }
  return friction_n;
}

Vec3 main_direction(std::span<const TickRecord> rows) {
  bool any_contact = false;
  for (const TickRecord& row : rows) any_contact |= row.phase != Phase::free;
  Vec3 mean = Vec3::Zero();
  double count = 0;
  for (const TickRecord& row : rows) {
    if (any_contact && row.phase == Phase::free) continue;
    mean += place_of(row);
    ++count;
  }
  if (count < 2) return Vec3::UnitX();
  mean /= count;
  Mat3 spread = Mat3::Zero();
  for (const TickRecord& row : rows) {
    if (any_contact && row.phase == Phase::free) continue;
    const Vec3 offset = place_of(row) - mean;
    spread += offset * offset.transpose();
  }
  // What rests spreads by the mean's rounding.
  const double rounding_m = 1e-12 * mean.norm();
  if (!(spread.trace() > count * rounding_m * rounding_m) || !spread.allFinite()) return Vec3::UnitX();
  Vec3 direction = Eigen::SelfAdjointEigenSolver<Mat3>(spread).eigenvectors().col(2);
  int largest = 0;
  direction.cwiseAbs().maxCoeff(&largest);
  if (direction[largest] < 0) direction = -direction;
  return direction;
}

double tangential_speed(const TickRecord& before, const TickRecord& row) {
  const double dt_s = row.t_s - before.t_s;
  if (row.phase == Phase::free || before.phase == Phase::free || !(dt_s > 0)) return TickRecord::nan;
  return tangential_step(before, row).norm() / dt_s;
}

std::vector<double> net_speed(std::span<const TickRecord> rows, double span_s) {
  std::vector<double> speeds;
  speeds.reserve(rows.size());
  std::size_t first = 0;  // of the span
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].phase == Phase::free) first = i + 1;
    while (first + 1 < i && rows[first].t_s < rows[i].t_s - span_s) ++first;
    speeds.push_back(first < i ? tangential_speed(rows[first], rows[i]) : TickRecord::nan);
  }
  return speeds;
}

double shown_speed(const TickRecord& before, const TickRecord& row) {
  const double dt_s = row.t_s - before.t_s;
  const bool in_contact = row.phase != Phase::free && before.phase != Phase::free;
  if (in_contact || !(dt_s > 0)) return tangential_speed(before, row);
  return (row.p_WQ - before.p_WQ).norm() / dt_s;
}

TouchSeries touch_series(std::span<const TickRecord> rows, const Vec3& direction_W) {
  TouchSeries series;
  series.direction_W = direction_W;
  series.direction_name = direction_name(direction_W);
  const bool world_axis = is_world_axis(direction_W);
  const Vec3 origin = world_axis || rows.empty() ? Vec3::Zero() : place_of(rows.front());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const TickRecord& row = rows[i];
    const bool free = row.phase == Phase::free;
    series.t_s.push_back(row.t_s);
    series.position_m.push_back((place_of(row) - origin).dot(direction_W));
    series.centre_m.push_back((row.stick_centre_W - origin).dot(direction_W));
    series.speed_m_per_s.push_back(i > 0 ? tangential_speed(rows[i - 1], row) : TickRecord::nan);
    series.normal_force_n.push_back(row.normal_force_n);
    series.friction_n.push_back(row.friction_W_n.dot(direction_W));
    series.mu.push_back(free ? TickRecord::nan : row.mu);
    const bool is_stick_after_slip =
        !series.phase.empty() && series.phase.back() == Phase::slip && row.phase == Phase::stick;
    series.slip_ends.push_back(is_stick_after_slip && row.walls <= 1 && !is_lifted_off(rows, i));
    series.phase.push_back(row.phase);
  }
  series.friction_name = "friction along " + series.direction_name;
  series.friction_sign = "+ pushes towards +" + series.direction_name;
  if (!rubs_straight(rows, direction_W)) {
    series.friction_n = friction_along_sliding(rows);
    series.friction_name = "friction along the sliding direction";
    series.friction_sign = "- against it";
  }
  return series;
}

}  // namespace fingerpad

#include "view/free_sight.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "touch/parts_ball.hpp"
#include "view/picture.hpp"
#include "view/surface_hit.hpp"

namespace fingerpad {
namespace {

/// Contacts to look at, the one that matters most first.
std::vector<const TickRecord*> sighted_rows(const ViewInput& input, const TickRecord* shown) {
  constexpr std::size_t most = 16;
  std::vector<const TickRecord*> contacts;
  const auto add = [&](std::size_t row) {
    if (input.rows[row].phase != Phase::free) contacts.push_back(&input.rows[row]);
  };
  if (input.rows.empty()) return contacts;
  if (shown != nullptr && shown->phase != Phase::free)
    contacts.push_back(shown);
  else
    add(static_cast<std::size_t>(telling_row(input)));
  for (std::size_t i = 0; i < most; ++i) add(i * (input.rows.size() - 1) / (most - 1));
  return contacts;
}

/// Directions spread evenly over the sphere (a Fibonacci lattice).
std::vector<Vec3> sight_directions() {
  constexpr int count = 150;
  std::vector<Vec3> directions;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2.0 * i + 1) / count, turn = i * std::numbers::pi * (3 - std::sqrt(5.0));
    const double level = std::sqrt(1 - z * z);
    directions.emplace_back(level * std::cos(turn), level * std::sin(turn), z);
  }
  return directions;
}

class SightedContacts {
 public:
  SightedContacts(const ViewInput& input, const TickRecord* shown, const Ball& parts)
      : surfaces_(input.world->surfaces), parts_(parts), rows_(sighted_rows(input, shown)) {}

  bool empty() const { return rows_.empty(); }
  /// Which share is seen; the first counts as much as all others.
  double share(const Vec3& towards_eye_W) const {
    if (rows_.size() == 1) return is_seen(*rows_.front(), towards_eye_W) ? 1 : 0;
    double seen = 0;
    for (std::size_t i = 1; i < rows_.size(); ++i) seen += is_seen(*rows_[i], towards_eye_W) ? 1 : 0;
    const double others = seen / static_cast<double>(rows_.size() - 1);
    return (others + (is_seen(*rows_.front(), towards_eye_W) ? 1 : 0)) / 2;
  }

 private:
  bool is_seen(const TickRecord& row, const Vec3& towards_eye_W) const {
    if (!(row.normal_W.dot(towards_eye_W) > 0)) return false;
    // Just over the facet that is touched.
    const Vec3 from_W = row.contact_W + 1e-4 * parts_.radius_m * row.normal_W;
    const double reach_m = (from_W - parts_.centre_W).norm() + 2 * parts_.radius_m;
    const Vec3 to_W = from_W + reach_m * towards_eye_W;
    return std::none_of(surfaces_.begin(), surfaces_.end(),
                        [&](const Surface& surface) { return line_hit(surface, from_W, to_W).has_value(); });
  }

  const std::vector<Surface>& surfaces_;
  Ball parts_;
  std::vector<const TickRecord*> rows_;
};

}  // namespace

Vec3 free_sight(const ViewInput& input, const TickRecord* shown, const Vec3& towards_eye_W) {
  const auto parts = input.world ? ball_of_parts(*input.world) : std::nullopt;
  if (!parts) return towards_eye_W;
  const SightedContacts contacts(input, shown, *parts);
  constexpr double enough = 0.75;  // the first and half of the others
  if (contacts.empty() || contacts.share(towards_eye_W) >= enough) return towards_eye_W;

  const std::vector<Vec3> directions = sight_directions();
  std::vector<double> shares;
  shares.reserve(directions.size());
  for (const Vec3& direction : directions) shares.push_back(contacts.share(direction));
  constexpr double near = 0.94;  // cosine of 20 degrees
  constexpr double wide_weight = 0.5, wanted_weight = 0.2;
  Vec3 best = towards_eye_W;
  double best_worth = -1;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    if (!(shares[i] > 0)) continue;
    double around = 0, count = 0;
    for (std::size_t k = 0; k < directions.size(); ++k) {
      if (directions[k].dot(directions[i]) < near) continue;
      around += shares[k];
      ++count;
    }
    const double worth =
        shares[i] + wide_weight * around / count + wanted_weight * directions[i].dot(towards_eye_W);
    if (worth <= best_worth) continue;
    best_worth = worth;
    best = directions[i];
  }
  return best;
}

}  // namespace fingerpad

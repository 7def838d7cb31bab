#include "replay/pop_throughs.hpp"

#include <new>
#include <utility>

#include "contact/fast_proxy.hpp"
#include "part/border.hpp"

namespace fingerpad {
namespace {

/// Cosines. A push goes along the motion within 60 degrees of it, and another is the same within 60 degrees;
/// one that is off by more than 120 has turned round.
constexpr double push_along_motion = 0.5, same_push = 0.5, turned_round = -0.5;
constexpr double most_depth_per_motion = 3;
/// The guide's steps along a way, each with all the time it needs to come to rest [s].
constexpr int guide_steps = 64;
constexpr double guide_step_s = 1;
constexpr double rounding = 1e-12;  // of a position, as a fraction of the numbers it came from

}  // namespace

PopThroughs::PopThroughs(std::shared_ptr<const World> world, double radius_m)
    : world_(std::move(world)), radius_m_(radius_m) {
  if (world_) sides_.resize(world_->surfaces.size(), Sides::unknown);
}

bool PopThroughs::is_open(std::size_t surface) noexcept {
  if (sides_[surface] == Sides::unknown) {
    sides_[surface] = has_border(*world_->surfaces[surface].part) ? Sides::both : Sides::outside;
  }
  return sides_[surface] == Sides::both;
}

bool PopThroughs::way_enters_a_part(const Vec3& to_W) noexcept {
  if (!world_) return false;
  for (std::size_t i = 0; i < world_->surfaces.size(); ++i) {
    const Surface& surface = world_->surfaces[i];
    if (!surface.part) continue;
    const Part& part = *surface.part;
    const auto from_centre = [&](const Vec3& p_W) {
      return Vec3(surface.R_WP.transpose() * (p_W - surface.p_WP) - part.centre_P);
    };
    Vec3 from = from_centre(last_.p_WQ), to = from_centre(to_W);
    SegmentHit hit = surface.tree->first_crossing(from, to);
    if (hit.triangle < 0 && is_open(i)) {
      // From behind: the way back enters.
      std::swap(from, to);
      hit = surface.tree->first_crossing(from, to);
    }
    if (hit.triangle < 0) continue;
    // A way that ends on the surface has not gone through it.
    const double past_m = (1 - hit.along) * part.facet_normals.col(hit.triangle).dot(from - to);
    if (past_m > rounding * (part.size_m() + part.centre_P.norm() + to_W.norm())) return true;
  }
  return false;
}

/// The guide at the way's end, until it is moved again. Null where it tells nothing, and the worse is taken
/// to be true: without memory for it, and where it is held from the beginning, as a finger that was inside
/// all along.
const ProxyContact* PopThroughs::guided(const Vec3& to_W) noexcept {
  try {
    if (!guide_)
      guide_ = fast_proxy(placed_surfaces(*world_), radius_m_, Normals::facet, Looks(Looks::unlimited));
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
  guide_->reset();
  const Vec3 from_W = last_.p_WQ;
  if (guide_->move(from_W, guide_step_s).touching()) return nullptr;
  for (int k = 1; k < guide_steps; ++k)
    guide_->move(from_W + (to_W - from_W) * (static_cast<double>(k) / guide_steps), guide_step_s);
  for (int k = 0; k < guide_steps; ++k) {
    const ProxyContact& end = guide_->move(to_W, guide_step_s);
    if (!end.touching() || end.settled) return &end;
  }
  return &guide_->state().contact;
}

bool PopThroughs::is_held_back(const Vec3& to_W) noexcept {
  const ProxyContact* end = guided(to_W);
  return end == nullptr || end->touching();
}

/// Whether a surface itself lets the finger come to where it is pushed on, as a ball that slides round a
/// corner.
bool PopThroughs::is_led_round(const Seen& now) noexcept {
  if (!world_) return false;
  const ProxyContact* end = guided(now.p_WQ);
  return end != nullptr && (!end->touching() || end->normal_W.dot(now.normal_W) > same_push);
}

bool PopThroughs::popped(const Seen& now) noexcept {
  const Vec3 motion_W = now.p_WQ - last_.p_WQ;
  const double moved_m = motion_W.norm();
  const bool was_free = last_.phase == Phase::free, is_free = now.phase == Phase::free;
  if (was_free && is_free) return moved_m > 0 && way_enters_a_part(now.p_WQ) && is_held_back(now.p_WQ);
  if (is_free) return !last_.is_catching_up && most_depth_per_motion * moved_m < last_.depth_m;
  if (was_free) return now.normal_W.dot(motion_W) > push_along_motion * moved_m && !is_led_round(now);
  if (last_.is_catching_up || now.normal_W.dot(last_.normal_W) > turned_round) return false;
  // Out of what is convex no push changes by more than the finger moves.
  const double rounded_m = rounding * (now.p_WQ.norm() + last_.p_WQ.norm());
  if ((now.push_m() - last_.push_m()).norm() > moved_m + rounded_m) return true;
  return last_.is_inside_one_wall() && now.is_inside_one_wall() && !way_enters_a_part(now.p_WQ);
}

bool PopThroughs::is_by_one_wall(const TickRecord& record) const noexcept {
  if (record.walls != 1) return false;
  return !world_ || record.surface < 0 ||
         !world_->surfaces[static_cast<std::size_t>(record.surface)].is_plane();
}

void PopThroughs::observe(const TickRecord& record) noexcept {
  const Seen now{record.p_WQ,           record.contact_W, record.normal_W,
                 record.depth_m,        record.phase,     record.unsettled || was_unsettled_,
                 is_by_one_wall(record)};
  if (any_ && popped(now)) ++count_;
  last_ = now;
  was_unsettled_ = record.unsettled;
  any_ = true;
}

}  // namespace fingerpad

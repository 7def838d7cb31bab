#include "replay/contact_store.hpp"

#include <algorithm>
#include <utility>

#include "contact/contact_method_table.hpp"
#include "scene/scene.hpp"

namespace fingerpad {

bool ContactCourse::Place::operator==(const Place& other) const {
  return !tree.owner_before(other.tree) && !other.tree.owner_before(tree) && p_WP == other.p_WP &&
         R_WP == other.R_WP && plane_point_W == other.plane_point_W && plane_normal_W == other.plane_normal_W;
}

ContactCourse::ContactCourse(const Scene& scene, const World& world, const FingerPath& path)
    : method_(find_contact_method(settled_contact(scene, world).method)),
      normals_(settled_contact(scene, world).normals),
      radius_m_(scene.finger.radius_m),
      path_(path) {
  for (const PlacedSurface& surface : world.surfaces)
    places_.push_back(
        {surface.tree, surface.p_WP, surface.plane_point_W, surface.plane_normal_W, surface.R_WP});
}

bool ContactCourse::operator==(const ContactCourse& other) const {
  return method_ == other.method_ && normals_ == other.normals_ && radius_m_ == other.radius_m_ &&
         places_ == other.places_ && path_.goes_as(other.path_);
}

ContactWrap ContactStore::Share::wrap() const {
  if (played_)
    return [tape = played_](std::unique_ptr<ContactMethod> method, std::vector<PlacedSurface> surfaces) {
      return played_contact(std::move(method), tape, std::move(surfaces));
    };
  if (recorded_)
    return [tape = recorded_](std::unique_ptr<ContactMethod> method, const std::vector<PlacedSurface>&) {
      return recording_contact(std::move(method), tape);
    };
  return {};
}

ContactStore::Share& ContactStore::Share::operator=(Share&& other) noexcept {
  std::swap(store_, other.store_);
  course_.swap(other.course_);
  played_.swap(other.played_);
  recorded_.swap(other.recorded_);
  std::swap(reserved_bytes_, other.reserved_bytes_);
  return *this;
}

ContactStore::Share::~Share() {
  if (reserved_bytes_ > 0) store_->give_back(reserved_bytes_);
}

void ContactStore::Share::finish() {
  if (!recorded_ || !recorded_->is_whole()) return;
  recorded_->trim();
  store_->keep({std::move(course_), std::move(recorded_)});
}

bool ContactStore::may_share(const Scene& scene) noexcept {
  return !scene.hand.has_value();
}

ContactStore::Share ContactStore::share(const Scene& scene, const World& world, const FingerPath& path) {
  Share share;
  if (!may_share(scene)) return share;
  share.store_ = this;
  share.course_ = std::make_shared<const ContactCourse>(scene, world, path);
  const std::lock_guard lock(mutex_);
  const auto kept =
      std::ranges::find_if(kept_, [&](const Kept& one) { return *one.course == *share.course_; });
  if (kept == kept_.end()) {
    const std::size_t bytes = contact_bytes_a_tick * static_cast<std::size_t>(path.tick_count());
    if (bytes > most_bytes_ - reserved_bytes_) return share;
    share.recorded_ = std::make_shared<ContactTape>(path.tick_count(), bytes);
    reserved_bytes_ += share.reserved_bytes_ = bytes;
    return share;
  }
  kept_.splice(kept_.begin(), kept_, kept);
  share.played_ = kept->tape;
  ++played_count_;
  return share;
}

void ContactStore::keep(const Kept& kept) {
  const std::lock_guard lock(mutex_);
  if (std::ranges::any_of(kept_, [&](const Kept& one) { return *one.course == *kept.course; })) return;
  kept_.push_front(kept);
  bytes_ += kept.bytes();
  while (bytes_ > most_bytes_ && kept_.size() > 1) {
    bytes_ -= kept_.back().bytes();
    kept_.pop_back();
  }
}

void ContactStore::give_back(std::size_t reserved_bytes) {
  const std::lock_guard lock(mutex_);
  reserved_bytes_ -= reserved_bytes;
}

long ContactStore::played_count() const {
  const std::lock_guard lock(mutex_);
  return played_count_;
}

}  // namespace fingerpad

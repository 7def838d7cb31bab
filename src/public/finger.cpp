#include "fingerpad/finger.hpp"

#include "base/error.hpp"
#include "friction/law_table.hpp"
#include "public/finger_impl.hpp"
#include "public/finger_scene.hpp"
#include "public/part_surface_impl.hpp"
#include "public/touch_world_impl.hpp"
#include "scene/scene_file.hpp"
#include "touch/rate_choice.hpp"

namespace fingerpad {
namespace {

Scene first_scene(const std::string& path) {
  SceneJob job = std::move(read_scene_file(path).jobs.front());
  if (!job.error.empty()) throw refused("", job.error);
  settle_live_rate(job.scene);
  job.scene.hand.reset();  // the caller moves the finger
  return std::move(job.scene);
}

}  // namespace

std::vector<FrictionLawInfo> friction_laws() {
  std::vector<FrictionLawInfo> laws;
  for (const LawEntry& row : law_table()) {
    FrictionLawInfo& law = laws.emplace_back();
    law.name = row.name;
    law.summary = row.summary;
    for (const LawParameter& parameter : row.parameters)
      law.parameters.push_back(
          {std::string(parameter.key), parameter.default_value, std::string(parameter.meaning)});
  }
  return laws;
}

Finger::Finger(const TouchWorld& world, const FingerOptions& options) {
  Scene scene = scene_of(options);
  auto made = std::make_shared<World>();
  std::vector<PartMeasures> measures;
  for (const TouchWorld::Impl::PlacedPart& part : world.impl_->parts) {
    made->surfaces.push_back(part.placed);
    made->verdicts.push_back(part.surface->verdict);
    if (leaves_a_choice(scene.contact)) measures.push_back(part.surface->measures());
  }
  for (const Surface& plane : world.impl_->planes) made->surfaces.push_back(plane);
  if (made->surfaces.empty()) throw refused("TouchWorld", "there is nothing to touch: add a part or a plane");
  settle_contact(*made, scene, measures);
  impl_ = std::make_unique<Impl>(std::move(scene), std::move(made));
}

Finger Finger::of_scene(const std::string& scene_path) {
  Scene scene = first_scene(scene_path);
  auto world = load_world(scene);
  return Finger(std::make_unique<Impl>(std::move(scene), std::move(world)));
}

Finger::Finger(std::unique_ptr<Impl> impl) noexcept : impl_(std::move(impl)) {}
Finger::~Finger() = default;
Finger::Finger(Finger&&) noexcept = default;
Finger& Finger::operator=(Finger&&) noexcept = default;

TickRecord Finger::tick(const FingerSample& sample) noexcept {
  return impl_->touch.tick(sample);
}

void Finger::reset() noexcept {
  impl_->touch.reset();
}

double Finger::rate_hz() const noexcept {
  return impl_->scene.motion.rate_hz;
}

std::string Finger::contact_method() const {
  return std::string(method_in(*impl_->world, impl_->contact.method));
}

const std::vector<std::string>& Finger::reasons() const noexcept {
  return impl_->contact.reasons;
}

}  // namespace fingerpad

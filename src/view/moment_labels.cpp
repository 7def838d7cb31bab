#include "view/moment_labels.hpp"

#include "base/tangent_frame.hpp"
#include "view/frame_labels.hpp"

namespace fingerpad {

std::array<Vec3, 3> drawn_forces_W_n(const TickRecord& row) {
  return {row.normal_W * row.normal_force_n, row.friction_W_n, row.force_W_n};
}

InSight moment_in_sight(const ContactMoment& moment, const DrawSpace& space,
                        const std::function<Vec2(const Vec3& p_mm)>& on_screen, double mm_per_n) {
  const TickRecord& row = moment.row;
  if (row.phase == Phase::free) return {on_screen(space.to_draw(row.p_WQ)), {}};
  const Vec3 contact_mm = space.to_draw(row.contact_W);
  InSight in_sight{on_screen(contact_mm), {}};
  if (mm_per_n == 0) return in_sight;
  for (const Vec3& force_W_n : drawn_forces_W_n(row))
    in_sight.tips_px.push_back(on_screen(contact_mm + force_W_n * mm_per_n));
  return in_sight;
}

std::vector<OverlayFacts::Label> moment_labels(const ContactMoment& moment, const GlyphChoice& choice,
                                               const DrawSpace& space,
                                               const std::function<Vec2(const Vec3& p_mm)>& on_screen,
                                               std::span<const Box> boxes, const Layout& layout) {
  const TickRecord& row = moment.row;
  const Vec3 contact = space.to_draw(row.contact_W);
  const auto seen = [&](const Vec3& way_mm) {
    return ScreenArrow{on_screen(contact), on_screen(contact + way_mm)};
  };
  const Mat3 frame = tangent_frame(row.normal_W, moment.finger_direction_W);
  std::vector<NamedAxis> axes;
  for (const int axis : {2, 0, 1}) {
    constexpr const char* names[] = {"Cx", "Cy", "n"};
    axes.push_back({names[axis], seen(frame.col(axis) * frame_axis_sizes(axis) * choice.size_mm)});
  }
  std::vector<ScreenArrow> forces;
  if (choice.forces) {
    for (const Vec3& force_W_n : drawn_forces_W_n(row)) forces.push_back(seen(force_W_n * choice.mm_per_n));
  }
  return frame_labels(axes, forces, boxes, layout.scene, layout.em);
}

}  // namespace fingerpad

#include "view/stage_vtk.hpp"

#include <vtkCamera.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkMapper.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "view/camera_vtk.hpp"
#include "view/clipping_range_vtk.hpp"
#include "view/drawing_item_vtk.hpp"
#include "view/glyph_choice.hpp"
#include "view/moment_labels.hpp"
#include "view/surface_mesh_vtk.hpp"

namespace fingerpad {

Stage::Stage(const ViewInput& input, int width, int height, bool charts, bool timeline)
    : input_(input),
      shown_(input),
      extent_(extent_of(input)),
      column_(charts),
      timeline_(timeline),
      arrow_scale_(input.rows),
      view_(scene_, input_, extent_, space_) {
  shown_.go_to(-HUGE_VAL);
  space_.origin_W = extent_.everything().centre_W;
  vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
  window_->SetMultiSamples(4);
  window_->SetNumberOfLayers(2);
  world_ = std::make_unique<WorldProps>(input, space_, extent_);
  pace_ = std::make_unique<TurningPace>(input.world, space_, *world_);
  close_up_ = std::make_unique<CloseUp>(input, space_, *world_);
  add_renderers();
  world_->add_still_to(scene_);
  world_->add_clear_to(moving_);
  add_glyphs(moving_, solid_);
  add_glyphs(moving_, clear_, true);
  add_flat();
  resize(width, height);
  reset_camera();
}

void Stage::add_renderers() {
  window_->AddRenderer(scene_);
  window_->AddRenderer(moving_);
  close_up_->add_to(window_);
  column_.add_to(window_);
  window_->AddRenderer(flat_);
  flat_->InteractiveOff();
  scene_->GradientBackgroundOn();
  paint_grounds();
  light(scene_);
  moving_->PreserveColorBufferOn();
  moving_->PreserveDepthBufferOn();
  moving_->SetActiveCamera(scene_->GetActiveCamera());
  moving_->InteractiveOff();
  light(moving_);
  flat_->SetLayer(1);
  // It has no use for depths, and to clear them takes time without a graphics card.
  flat_->PreserveDepthBufferOn();
}

void Stage::add_flat() {
  for (const auto& [item, device] :
       {std::pair{readings_item_.Get(), readings_device_.Get()}, std::pair{item_.Get(), device_.Get()}}) {
    vtkNew<vtkContextActor> flat;
    flat->SetForceDevice(device);
    flat->GetScene()->SetRenderer(flat_);
    flat->GetScene()->AddItem(item);
    flat_->AddActor(flat);
  }
}

Stage::~Stage() = default;

void Stage::resize(int width, int height) {
  const int* now = window_->GetSize();
  if (now[0] != width || now[1] != height) window_->SetSize(width, height);
  layout_ = layout_for(width, height, column_.wanted(), timeline_);
  column_.lay_out(layout_);
  place_renderers();
  view_.lay_out(layout_);
}

void Stage::place(vtkRenderer* renderer, const Box& box) {
  const double w = layout_.window.width, h = layout_.window.height;
  renderer->SetViewport(box.left / w, box.bottom / h, box.right() / w, box.top() / h);
}

void Stage::place_renderers() {
  place(scene_, layout_.scene);
  place(moving_, layout_.scene);
  world_->set_line_width(std::max(1.0, 0.09 * layout_.em));
}

void Stage::paint_grounds() {
  const bool dark = state_.dark;
  column_.set_dark(dark);
  for (ThemeDevice* const device : {device_.Get(), readings_device_.Get()}) device->set_dark(dark);
  dark ? scene_->SetBackground(0.11, 0.12, 0.14) : scene_->SetBackground(0.93, 0.945, 0.96);
  dark ? scene_->SetBackground2(0.2, 0.21, 0.24) : scene_->SetBackground2(0.995, 0.997, 1.0);
  dark ? close_up_->scene()->SetBackground(0.16, 0.17, 0.19)
       : close_up_->scene()->SetBackground(0.97, 0.975, 0.98);
}

void Stage::reset_camera() {
  view_.reset(state_.look, moment_ ? &moment_->row : nullptr);
}

void Stage::keep_clear_of_readings() {
  view_.keep_clear_of_readings();
  reset_camera();
}

void Stage::show(const std::optional<TickRecord>& row, double speed_m_per_s) {
  moment_.reset();
  if (row) {
    shown_.go_to(row->t_s);
    moment_ = contact_moment(now(), *row);
    arrow_scale_.see(*row);
  }
  speed_m_per_s_ = speed_m_per_s;
}

/// The finger of a live touch, which may be anywhere.
std::optional<FingerInSight> Stage::finger_in_sight() const {
  if (!moment_ || !input_.rows.empty() || !state_.finger) return std::nullopt;
  const double radius_m = moment_->finger_radius_m,
               sizes = radius_m > 0 ? ball_finger_sizes : point_finger_sizes;
  return FingerInSight{moment_->row.p_WQ, -moment_->finger_direction_W, radius_m,
                       radius_m > 0 ? ball_finger_radii * radius_m : 0, sizes * glyph_size_em * layout_.em};
}

/// Half of what the close-up would show [mm]; none where it is not asked for, or would show no more than the
/// scene does.
std::optional<double> Stage::close_up_half_height_mm() const {
  if (!moment_ || moment_->row.phase == Phase::free || !state_.close_up) return std::nullopt;
  const double half_mm = moment_->region_reach_m > 0 ? 2e3 * moment_->region_reach_m : 1;
  constexpr double least_gain = 1.2;
  if (!(layout_.inset.height / (2 * half_mm) > least_gain * view_.px_per_mm())) return std::nullopt;
  return half_mm;
}

/// Finds room for what lies over the scene, and shows the close-up where it has some.
void Stage::place_overlay(OverlayFacts& facts, const GlyphInk& ink) {
  const std::optional<double> half_mm = close_up_half_height_mm();
  facts.panels = panels_.boxes(panel_layout());
  const auto on_screen = [this](const Vec3& p_mm) { return view_.on_screen(p_mm); };
  const double arrows_mm_per_n = state_.forces ? facts.mm_per_n : 0;
  const InSight in_sight =
      moment_ ? moment_in_sight(*moment_, space_, on_screen, arrows_mm_per_n) : InSight{};
  find_room(places_, facts, state_, layout_, in_sight, half_mm.has_value());
  const bool is_live = input_.rows.empty();
  if (is_live && state_.finger) tell_lost_finger(facts, layout_);
  if (!half_mm || facts.inset.width == 0) {
    close_up_->hide();
    return;
  }
  facts.inset_px_per_mm = layout_.inset.height / (2 * *half_mm);
  const TickRecord& row = moment_->row;
  double mu_static = 0;
  const auto surface = static_cast<std::size_t>(row.surface);
  if (row.surface >= 0 && now().world && surface < now().world->surfaces.size()) {
    mu_static = now().world->surfaces[surface].properties.mu_static;
  }
  close_up_->show(*moment_, facts.inset, layout_.window, *half_mm, mu_static * row.normal_force_n, ink);
}

void Stage::project_labels(OverlayFacts& facts, const GlyphChoice& choice) {
  if (!moment_ || moment_->row.phase == Phase::free || !state_.frame) return;
  std::vector<Box> boxes = facts.panels;
  boxes.insert(boxes.end(), {facts.inset, facts.hud, facts.legend});
  facts.labels = moment_labels(
      *moment_, choice, space_, [this](const Vec3& p_mm) { return view_.on_screen(p_mm); }, boxes, layout_);
}

void Stage::project_marks(OverlayFacts& facts) {
  for (const Vec3& mark_W : marks_.places_W()) facts.marks.push_back(view_.on_screen(space_.to_draw(mark_W)));
  facts.marks_words = marks_.words();
}

OverlayFacts Stage::overlay_facts() const {
  OverlayFacts facts = facts_to_tell(input_, now(), words_, moment_);
  facts.axes_px = axes_on_screen(scene_);
  facts.px_per_mm = view_.px_per_mm();
  facts.max_force_n = extent_.max_force_n;
  facts.speed_m_per_s = speed_m_per_s_;
  facts.grid_mm = world_->grid_m() * 1e3;
  return facts;
}

void Stage::render() {
  const GlyphChoice choice = glyph_choice(state_, layout_, view_.px_per_mm(), arrow_scale_.force_n());
  const ContactGlyphs glyphs = moment_ ? contact_glyphs(*moment_, space_, choice) : ContactGlyphs{};
  copy_mesh(glyphs.solid, solid_);
  copy_mesh(glyphs.clear, clear_);
  paint_grounds();
  world_->show_wireframe(state_.wireframe);
  world_->show_creases(state_.creases);
  world_->show_path(state_.path, state_.colouring == PathColouring::force);
  OverlayFacts facts = overlay_facts();
  facts.mm_per_n = choice.mm_per_n;
  place_overlay(facts, choice.ink);

  column_.prepare(keeping_);
  std::vector<std::shared_ptr<const Drawing>> drawings;
  if (column_.shows() && timeline_ && moment_) drawings.push_back(column_.cursor(moment_->row.t_s));
  project_labels(facts, choice);
  project_marks(facts);
  auto overlay = std::make_shared<Drawing>(ground_drawing(facts, state_, layout_));
  if (!state_.help) panels_.paint(*overlay, panel_layout());
  overlay->append(overlay_drawing(facts, state_, layout_));
  drawings.push_back(std::move(overlay));
  item_->show(std::move(drawings));
  readings_item_->show({std::make_shared<const Drawing>(readings_drawing(facts, state_, layout_))});
  draw();
}

void Stage::draw() {
  set_clipping_range(scene_->GetActiveCamera(), world_->bounds_mm(), 1e3 * extent_.everything().radius_m,
                     {solid_.Get(), clear_.Get()});
  pace_->choose(scene_->GetActiveCamera());
  scene_->set_keeping(keeping_ && !shows_coarse());  // what turns is stale before it is put back
  const long drawn_before = still_drawn();
  const auto start = std::chrono::steady_clock::now();
  window_->Render();
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  pace_->note(took.count(), still_drawn() != drawn_before);
  if (pace_->gives_up_smooth_edges()) window_->SetMultiSamples(0);
}

std::optional<double> Stage::time_at(double x_px, double y_px) const {
  if (!timeline_ || input_.rows.empty()) return std::nullopt;
  const double first = input_.rows.front().t_s, last = input_.rows.back().t_s;
  if (layout_.timeline.holds(x_px, y_px)) {
    const Box slider = time_slider(layout_);
    return first + std::clamp((x_px - slider.left) / slider.width, 0.0, 1.0) * (last - first);
  }
  if (column_.shows() && layout_.charts.holds(x_px, y_px)) return column_.board().place().x_at(x_px);
  return std::nullopt;
}

PointedScene Stage::pointed() const {
  PointedScene pointed = view_.pointed();
  // The help page takes the mouse wherever it is.
  pointed.panels = state_.help ? std::vector<Box>{layout_.window} : panels_.boxes(panel_layout());
  return pointed;
}

}  // namespace fingerpad

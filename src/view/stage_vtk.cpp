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

#include "view/axis.hpp"
#include "view/camera_vtk.hpp"
#include "view/clipping_range_vtk.hpp"
#include "view/drawing_item_vtk.hpp"
#include "view/moment_labels.hpp"
#include "view/overlay_hud.hpp"
#include "view/surface_mesh_vtk.hpp"
#include "view/surface_words.hpp"

namespace fingerpad {

Stage::Stage(const ViewInput& input, int width, int height, bool charts, bool timeline)
    : input_(input),
      shown_(input),
      extent_(extent_of(input)),
      column_(charts),
      timeline_(timeline),
      arrow_scale_(input.rows) {
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
  // A view that nobody has turned, moved or zoomed since is fitted to the new size.
  const bool is_fitted = !fitted_.empty() && view_of(scene_->GetActiveCamera()) == fitted_;
  layout_ = layout_for(width, height, column_.wanted(), timeline_);
  column_.lay_out(layout_);
  place_renderers();
  if (is_fitted) fit();
}

void Stage::place(vtkRenderer* renderer, const Box& box) {
  const double w = layout_.window.width, h = layout_.window.height;
  renderer->SetViewport(box.left / w, box.bottom / h, box.right() / w, box.top() / h);
}

void Stage::place_renderers() {
  place(scene_, layout_.scene);
  make_way_for_readings();
  place(moving_, layout_.scene);
  world_->set_line_width(std::max(1.0, 0.09 * layout_.em));
}

/// Brings what is looked at to the size of the scene.
void Stage::fit() {
  if (look_)
    set_look(scene_, input_, extent_, space_, *look_, width_to_height());
  else
    set_scene_camera(scene_, input_, looked_at_ ? &*looked_at_ : nullptr, extent_, space_, width_to_height());
  fitted_ = view_of(scene_->GetActiveCamera());
}

void Stage::look(const LookFrom& from) {
  look_ = from;
  fit();
}

void Stage::look_at_all() {
  const Mat3 axes = axes_on_screen(scene_);
  look({axes.row(2), axes.row(1)});
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
  look_ = state_.look;
  looked_at_.reset();
  if (moment_) looked_at_ = moment_->row;
  fit();
}

void Stage::keep_clear_of_readings() {
  clear_of_readings_ = true;
  make_way_for_readings();
  reset_camera();
}

/// The strip at the left in which the readings stand, where the scene is wide enough to spare it.
double Stage::readings_strip_px() const {
  const double strip = (readings_width_em + 1.4) * layout_.em;
  return clear_of_readings_ && layout_.scene.width > 3 * strip ? strip : 0;
}

double Stage::width_to_height() const {
  return (layout_.scene.width - readings_strip_px()) / layout_.scene.height;
}

/// What is in the middle comes to the middle of what is left of the scene; views still turn round it.
void Stage::make_way_for_readings() {
  scene_->GetActiveCamera()->SetWindowCenter(-readings_strip_px() / layout_.scene.width, 0);
}

void Stage::zoom(double factor) {
  vtkCamera* camera = scene_->GetActiveCamera();
  const double scale = camera->GetParallelScale() / factor;
  const double whole_mm = 1e3 * extent_.everything().radius_m;
  camera->SetParallelScale(std::clamp(scale, 1e-5 * whole_mm, 30 * whole_mm));
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

void Stage::show_hint(std::string hint, std::vector<std::string> help) {
  hint_ = std::move(hint);
  help_ = std::move(help);
}

double Stage::px_per_mm() const {
  return layout_.scene.height / (2 * scene_->GetActiveCamera()->GetParallelScale());
}

/// Whether the close-up is worth its room, and how much it shows.
bool Stage::shows_close_up(double scene_px_per_mm) {
  inset_px_per_mm_ = 0;
  if (!moment_ || moment_->row.phase == Phase::free || !state_.close_up) return false;
  inset_half_height_mm_ = 1;
  if (moment_->region_reach_m > 0) inset_half_height_mm_ = 2e3 * moment_->region_reach_m;
  const double px_per_mm = layout_.inset.height / (2 * inset_half_height_mm_);
  if (!(px_per_mm > 1.2 * scene_px_per_mm)) return false;
  inset_px_per_mm_ = px_per_mm;
  return true;
}

/// Finds room for readings, legend and close-up, none over the contact, its arrows above all.
void Stage::place_overlay(OverlayFacts& facts) {
  std::optional<Vec2> contact_px;
  std::vector<Vec2> tips_px;
  if (moment_ && moment_->row.phase != Phase::free) {
    const Vec3 contact = space_.to_draw(moment_->row.contact_W);
    contact_px = on_screen(contact);
    if (state_.forces) {
      for (const Vec3& force_W_n : drawn_forces_W_n(moment_->row))
        tips_px.push_back(on_screen(contact + force_W_n * facts.mm_per_n));
    }
  } else if (moment_) {
    contact_px = on_screen(space_.to_draw(moment_->row.p_WQ));
  }
  facts.finger_px = contact_px;
  const Vec2 whole = readings_size(facts, layout_.em);
  // Of a small scene they would hide too much.
  constexpr double most_share = 0.2;
  facts.brief = whole.x() * whole.y() > most_share * layout_.scene.width * layout_.scene.height ||
                layout_.window.width < least_width_with_charts_px ||
                layout_.window.height < least_height_with_charts_px;
  const Vec2 hud = state_.hud ? readings_size(facts, layout_.em) : Vec2(0, 0);
  const Vec2 legend = state_.hud ? legend_size(facts, state_, layout_.em) : Vec2(0, 0);
  const double side = shows_close_up(facts.px_per_mm) ? layout_.inset.width : 0;
  using enum Corner;
  Layout below_alarm = layout_;
  below_alarm.scene.height -= alarm_line(facts, layout_).height;
  const auto boxes = places_.place(below_alarm,
                                   {{hud.x(), hud.y(), {top_left, top_right, bottom_right}},
                                    {side, side, {top_right, bottom_right, top_left, bottom_left}},
                                    {legend.x(), legend.y(), {bottom_left, bottom_right, top_left}}},
                                   contact_px, panels_.boxes(below_alarm), tips_px);
  facts.hud = boxes[0];
  inset_ = boxes[1];
  facts.legend = boxes[2];
  if (inset_.width == 0) inset_px_per_mm_ = 0;
  facts.inset = inset_;
  facts.inset_px_per_mm = inset_px_per_mm_;
}

void Stage::place_close_up() {
  if (!(inset_px_per_mm_ > 0)) {
    close_up_->hide();
    return;
  }
  const TickRecord& row = moment_->row;
  double mu_static = 0;
  const auto surface = static_cast<std::size_t>(row.surface);
  if (row.surface >= 0 && now().world && surface < now().world->surfaces.size()) {
    mu_static = now().world->surfaces[surface].properties.mu_static;
  }
  close_up_->show(*moment_, inset_, layout_.window, inset_half_height_mm_, mu_static * row.normal_force_n,
                  glyph_ink());
}

/// A part's faces are bright in the dark, too; between its wires it is dark.
GlyphInk Stage::glyph_ink() const {
  if (!state_.dark || !state_.wireframe) return {};
  return {in_the_dark(colours::ink), in_the_dark(colours::black)};
}

Vec2 Stage::on_screen(const Vec3& p_mm) {
  scene_->SetWorldPoint(p_mm.x(), p_mm.y(), p_mm.z(), 1);
  scene_->WorldToDisplay();
  const double* px = scene_->GetDisplayPoint();
  return {px[0], px[1]};
}

void Stage::project_labels(OverlayFacts& facts, const GlyphChoice& choice) {
  if (!moment_ || moment_->row.phase == Phase::free || !state_.frame) return;
  const Box boxes[] = {inset_, facts.hud, facts.legend};
  facts.labels = moment_labels(
      *moment_, choice, space_, [this](const Vec3& p_mm) { return on_screen(p_mm); }, boxes, layout_);
}

void Stage::project_marks(OverlayFacts& facts) {
  for (const Vec3& mark_W : marks_.places_W()) facts.marks.push_back(on_screen(space_.to_draw(mark_W)));
  facts.marks_words = marks_.words();
}

OverlayFacts Stage::overlay_facts() {
  OverlayFacts facts;
  facts.title = input_.title;
  facts.subtitle = subtitle_of(now(), input_.title);
  facts.about = about_lines(input_);
  facts.hint = hint_;
  facts.alarm = alarm_;
  facts.readings = readings_;
  facts.tick_bars = tick_bars_;
  facts.help = help_;
  facts.axes_px = axes_on_screen(scene_);
  facts.px_per_mm = px_per_mm();
  facts.invitation = invitation_;
  facts.message = message_;
  facts.notice = input_.notice;
  facts.path = input_.rows.size() > 1;
  facts.max_force_n = extent_.max_force_n;
  facts.speed_m_per_s = speed_m_per_s_;
  facts.grid_mm = world_->grid_m() * 1e3;
  if (moment_) {
    facts.row = moment_->row;
    facts.region = moment_->region.has_value();
    facts.surface_name = input_.world ? surface_name(*input_.world, moment_->row.surface, 18) : "-";
  }
  if (!input_.rows.empty()) {
    facts.t_first_s = input_.rows.front().t_s;
    facts.t_last_s = input_.rows.back().t_s;
  }
  return facts;
}

void Stage::render() {
  const double px = px_per_mm();
  GlyphChoice choice;
  choice.size_mm = 1.15 * layout_.em / px;
  const double longest_mm = 0.3 * std::min(layout_.scene.width, layout_.scene.height) / px;
  choice.mm_per_n = round_down_125(longest_mm / arrow_scale_.force_n());
  choice.finger = state_.finger;
  choice.forces = state_.forces;
  choice.frame = state_.frame;
  choice.ink = glyph_ink();
  const ContactGlyphs glyphs = moment_ ? contact_glyphs(*moment_, space_, choice) : ContactGlyphs{};
  copy_mesh(glyphs.solid, solid_);
  copy_mesh(glyphs.clear, clear_);
  paint_grounds();
  world_->show_wireframe(state_.wireframe);
  world_->show_creases(state_.creases);
  world_->show_path(state_.path, state_.colouring == PathColouring::force);
  OverlayFacts facts = overlay_facts();
  facts.mm_per_n = choice.mm_per_n;
  place_overlay(facts);
  place_close_up();

  column_.prepare(keeping_);
  std::vector<std::shared_ptr<const Drawing>> drawings;
  if (column_.shows() && timeline_ && moment_) drawings.push_back(column_.cursor(moment_->row.t_s));
  project_labels(facts, choice);
  project_marks(facts);
  auto overlay = std::make_shared<Drawing>();
  if (!state_.help) panels_.paint(*overlay, layout_);
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

std::pair<Vec3, Vec3> Stage::line_of_sight(double x_px, double y_px) {
  const auto at_depth = [&](double depth) {
    scene_->SetDisplayPoint(x_px, y_px, depth);
    scene_->DisplayToWorld();
    const double* p = scene_->GetWorldPoint();
    return Vec3(p[0] / p[3], p[1] / p[3], p[2] / p[3]);
  };
  return {at_depth(0), at_depth(1)};
}

PointedScene Stage::pointed() {
  PointedScene pointed;
  pointed.scene = layout_.scene;
  pointed.panels = panels_.boxes(layout_);
  const auto [near_mm, far_mm] = line_of_sight(0, 0);
  pointed.lines = {near_mm, far_mm, line_of_sight(1, 0).first - near_mm, line_of_sight(0, 1).first - near_mm};
  pointed.towards_eye_W = -Vec3(scene_->GetActiveCamera()->GetDirectionOfProjection());
  return pointed;
}

}  // namespace fingerpad

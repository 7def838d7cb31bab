#include "view/turning_pace_vtk.hpp"

#include <vtkCamera.h>

#include <algorithm>

#include "view/camera_vtk.hpp"

namespace fingerpad {
namespace {

/// A frame that takes longer is not smooth.
constexpr double smooth_frame_s = 0.04;
/// A view that has not turned for so long rests.
constexpr std::chrono::milliseconds rest{250};

}  // namespace

void TurningPace::watch(vtkCamera* camera) {
  std::vector<double> now = view_of(camera);
  if (!camera_then_.empty() && now != camera_then_) turned_at_ = Clock::now();
  camera_then_ = std::move(now);
}

bool TurningPace::has_come_to_rest() const {
  return shown_coarse_ && Clock::now() - *turned_at_ >= rest;
}

void TurningPace::choose(vtkCamera* camera) {
  watch(camera);
  const bool may = pace_ == Pace::coarse || (pace_ == Pace::smooth && is_slow_);
  if (may && !coarse_) coarse_ = std::make_unique<CoarseMeshes>(world_, space_);
  const bool turns = turned_at_ && Clock::now() - *turned_at_ < rest;
  shown_coarse_ = may && turns && coarse_->are_ready();
  if (shown_coarse_) props_.set_coarse(coarse_->meshes());
  props_.show_coarse(shown_coarse_);
}

void TurningPace::note(double frame_s, bool drew_parts) {
  if (drew_parts && !shown_coarse_) is_slow_ = frame_s > smooth_frame_s;
  slow_s_ = std::max(0.0, slow_s_ + frame_s - smooth_frame_s);
}

bool TurningPace::gives_up_smooth_edges() const {
  // Without a graphics card they cost most of a frame; a smooth motion is worth more.
  constexpr double patience_s = 0.5;
  return slow_s_ > patience_s && pace_ != Pace::exact;
}

}  // namespace fingerpad

#include "view/playback.hpp"

#include <algorithm>

#include "view/picture.hpp"

namespace fingerpad {

Playback::Playback(const ViewInput& input) : input_(input), t_s_(input.rows.front().t_s) {}

void Playback::go_to(double t_s) {
  t_s_ = std::clamp(t_s, input_.rows.front().t_s, input_.rows.back().t_s);
  row_ = row_at(input_, t_s_);
}

void Playback::step(long rows) {
  playing_ = false;
  row_ = std::clamp<long>(row_ + rows, 0, static_cast<long>(input_.rows.size()) - 1);
  t_s_ = input_.rows[static_cast<std::size_t>(row_)].t_s;
}

void Playback::toggle() {
  playing_ = !playing_;
  if (playing_ && t_s_ >= input_.rows.back().t_s) go_to(input_.rows.front().t_s);
}

void Playback::change_speed(bool faster) {
  speed_ = std::clamp(speed_ * (faster ? 2 : 0.5), 1.0 / 1024, 16.0);
}

bool Playback::advance(double elapsed_s) {
  if (!playing_) return false;
  const long before = row_;
  go_to(t_s_ + elapsed_s * speed_);
  if (t_s_ < input_.rows.back().t_s) return row_ != before;
  playing_ = false;
  return true;
}

}  // namespace fingerpad

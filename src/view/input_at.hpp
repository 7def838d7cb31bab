#pragma once

#include "view/view_input.hpp"

namespace fingerpad {

/// What is shown, with the scene and the surfaces as they are at the moment shown: a recording may have
/// changed them on its way, and whoever touches changes them now.
class InputAt {
 public:
  /// @param input  kept by reference
  explicit InputAt(const ViewInput& input) : input_(input) {}

  /// As the recording had it by then.
  void go_to(double t_s);
  /// From now on.
  void put(const Scene& scene);
  /// Without rows.
  const ViewInput& now() const { return now_; }

 private:
  const ViewInput& input_;
  ViewInput now_;
  std::size_t changes_put_ = 0;  ///< of the input's, in now_
};

}  // namespace fingerpad

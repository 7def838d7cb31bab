#include "view/input_at.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "touch/touch_swap.hpp"
#include "touch/world.hpp"

namespace fingerpad {

void InputAt::put(const Scene& scene) {
  now_.scene = scene;
  if (now_.world) now_.world = changed_world(*now_.world, scene);
}

void InputAt::go_to(double t_s) {
  const auto& changes = input_.changes;
  const auto due = static_cast<std::size_t>(std::count_if(
      changes.begin(), changes.end(), [t_s](const SceneChange& one) { return one.t_s <= t_s; }));
  const bool first = !now_.scene && !now_.world;
  if (due == changes_put_ && !first) return;
  changes_put_ = due;
  now_.scene = input_.scene;
  now_.world = input_.world;
  now_.contact_words = input_.contact_words;
  if (due == 0 || !input_.scene) return;
  Scene scene = *input_.scene;
  try {
    for (std::size_t i = 0; i < due; ++i) {
      apply(changes[i], scene);
      if (changes[i].key.starts_with("contact.")) now_.contact_words.clear();
    }
  } catch (const Error&) {  // a trace of another program's: its picture is worth more than its words
    return;
  }
  put(scene);
}

}  // namespace fingerpad

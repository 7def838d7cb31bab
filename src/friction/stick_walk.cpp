#include "friction/stick_walk.hpp"

namespace fingerpad {

StickEnd walk_of_teeth(PlaneVector ratio, const PlaneVector& way, double low, double high) noexcept {
  StickEnd end;
  const bool has_teeth = low < high * (1 - 1e-9);
  double share = 0;
  for (int ruptures = 0; ruptures < most_stick_events; ++ruptures) {
    const double left = 1 - share;
    const double passed = rupture_share(ratio, way, high, left);
    if (passed > left) {
      end.ratio = ratio + left * way;
      return end;
    }
    ratio = ratio + passed * way;
    share += passed;
    end.centre_moved = true;
    if (!has_teeth) {  // it is dragged along at the limit
      end.ratio = many_teeth(ratio, (1 - share) * way, high, high).ratio;
      return end;
    }
    ratio = fallen(ratio, passed, low, high);
    end.ruptures = ruptures + 1;
    end.last_event = share;
    if (!(share < 1)) break;
  }
  end.ratio = ratio;
  if (!(share < 1)) return end;
  const Teeth rest = many_teeth(ratio, (1 - share) * way, low, high);
  end.ratio = rest.ratio;
  end.ruptures += rest.count;
  end.last_event = 1;
  return end;
}

}  // namespace fingerpad

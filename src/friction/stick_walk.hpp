#pragma once

#include "friction/law.hpp"
#include "friction/stick_events.hpp"
#include "friction/stick_spring.hpp"

namespace fingerpad {

/// How a pad slides, for the walk: |force|/load at a speed, and the speed at which stick begins. A slide of
/// any law has these members; one with a spring of its own stiffness takes a load of 1 and forces for mu.
struct CoulombSlide {
  double mu_static, mu_dynamic;
  double restick_m_per_s;
  bool sticks_at_once;  ///< level: whenever it is slow; else only when the speed falls through

  double force_ratio(double /*speed_m_per_s*/) const noexcept { return mu_dynamic; }
};

/// A tick as the walk sees it: the stick spring's way, in force ratios against shares of the tick.
struct StickWay {
  PlaneVector ratio;             ///< q at the start of the tick; in slip of no account
  PlaneVector before, now;       ///< how far q would move over the last tick and over this one
  PlaneVector direction_before;  ///< unit: of slip in the last tick and in this one
  PlaneVector direction_now;
  TickVelocity velocity;
  double slipped_scale = 1;  ///< what the slip force of the last tick was multiplied by before it was written
};

/// Where a tick ends.
struct StickEnd {
  Phase phase = Phase::stick;
  PlaneVector ratio;          ///< q
  double last_event = 0;      ///< share of the tick at which slip, or the last spell of stick, began
  int ruptures = 0;           ///< of the tick
  bool centre_moved = false;  ///< stick has begun anew
};

/// Ruptures and resticks that a walk carries out one by one; what is left of its teeth it takes at once.
inline constexpr int most_stick_events = 64;

/// The walk of a spring alone: wherever it ruptures it gives way along itself, from |q| = high to low, and
/// holds again at once. That is a tick which begins in stick and is slow to its end, of a law that sticks at
/// once and slides with the same force at any speed: then it is StickWalk's answer, to the bit, for less.
/// @param ratio  q at the start of the tick
/// @param way    how far q would move over the tick
StickEnd walk_of_teeth(PlaneVector ratio, const PlaneVector& way, double low, double high) noexcept;

/// The walk through one tick's events, each at its own place (DESIGN: over a tick the motion is a straight
/// line): rupture is where |q| passes mu_s, restick where the speed falls to v_min. A fall within the second
/// half of the last tick shows only now: it is carried out at its own place too, before this tick begins.
/// Bounded: after most_stick_events the rest of the teeth is taken at once.
template <typename Spring, typename Slide>
class StickWalk {
 public:
  StickWalk(const Spring& spring, const Slide& slide, const StickWay& way) noexcept
      : spring_(spring), slide_(slide), way_(way) {}

  /// @param phase       at the end of the last tick, stick or slip
  /// @param last_event  of the last tick
  StickEnd run(Phase phase, double last_event) noexcept {
    end_.phase = phase;
    end_.ratio = way_.ratio;
    begin(last_event);
    for (int events = 0; share_ < 1; ++events) {
      if (events == most_stick_events) {
        take_the_rest();
        break;
      }
      if (end_.phase == Phase::stick) {
        stick_on();
      } else {
        slip_on();
      }
    }
    return end_;
  }

 private:
  void begin(double last_event) noexcept {
    // A tick that was slow already has been judged in its own time.
    const bool was_fast = is_longer(way_.velocity.before_m_per_s, slide_.restick_m_per_s);
    const double earliest = was_fast || end_.phase == Phase::stick ? std::max(-0.5, last_event - 1) : 0;
    if (end_.phase == Phase::slip) {
      share_ = earliest;
      scale_ = way_.slipped_scale;
      return;
    }
    // It ruptured in the last tick's second half and was held to be slow; by now it is seen to have been
    // fast.
    if (last_event > 0.5 && way_.velocity.speed_at(earliest) > slide_.restick_m_per_s) {
      end_.phase = Phase::slip;
      share_ = earliest;
    }
  }

  const PlaneVector& way() const noexcept { return share_ < 0 ? way_.before : way_.now; }
  double piece_end() const noexcept { return share_ < 0 ? 0 : 1; }
  double low() const noexcept {
    return spring_.ratio_at(slide_.force_ratio(way_.velocity.speed_at(share_)), slide_.mu_static);
  }

  void stick_on() noexcept {
    const double left = piece_end() - share_;
    const double passed = rupture_share(end_.ratio, way(), slide_.mu_static, left);
    if (passed > left) {
      end_.ratio = end_.ratio + left * way();
      share_ = piece_end();
      return;
    }
    end_.ratio = end_.ratio + passed * way();
    share_ += passed;
    const bool is_slow = slide_.sticks_at_once && !(way_.velocity.speed_at(share_) > slide_.restick_m_per_s);
    if (is_slow && low() >= slide_.mu_static * (1 - 1e-9)) {
      drag_on();
      return;
    }
    ++end_.ruptures;
    note_event();
    if (!is_slow) {
      end_.phase = Phase::slip;
      scale_ = 1;
      return;
    }
    // Slow: it gives way along the spring, and holds again at once.
    end_.ratio = fallen(end_.ratio, passed, low(), slide_.mu_static);
    end_.centre_moved = true;
  }

  /// Slow, and the force of slip is not below the limit: no tooth to fall from. The spring is dragged along
  /// at the limit, without a rupture; that is stick by the rule of the speed, until the speed rises above it.
  void drag_on() noexcept {
    const double rises = way_.velocity.rises_above(slide_.restick_m_per_s, share_);
    const double until = std::min(rises, piece_end());
    end_.ratio = many_teeth(end_.ratio, (until - share_) * way(), slide_.mu_static, slide_.mu_static).ratio;
    end_.centre_moved = true;
    share_ = until;
    if (rises > until) return;
    ++end_.ruptures;
    note_event();
    end_.phase = Phase::slip;
    slip_to_the_end();
  }

  /// Of slip at this share: where the finger turns back it stops first, and sticks as it came.
  PlaneVector slip_direction() const noexcept {
    const bool turns = way_.direction_before.dot(way_.direction_now) < 0;
    return share_ < 0 || turns ? way_.direction_before : way_.direction_now;
  }

  void slip_on() noexcept {
    const double v_min = slide_.restick_m_per_s;
    const double begins = slide_.sticks_at_once ? way_.velocity.falls_to(v_min, share_)
                                                : way_.velocity.falls_through(v_min, share_);
    const double written = begins < 1 ? scale_ * slide_.force_ratio(way_.velocity.speed_at(begins)) : 0;
    // A spring that would start beyond its rupture limit (strong vibration) waits for the next tick.
    if (begins >= 1 || written > slide_.mu_static * (1 + 1e-12)) {
      slip_to_the_end();
      return;
    }
    share_ = begins;
    end_.ratio = spring_.ratio_at(written, slide_.mu_static) * slip_direction();
    end_.phase = Phase::stick;
    end_.centre_moved = true;
    note_event();
  }

  /// Fast: the spring stands at the slip force along the velocity. Slow (after a rupture under `crossing`, or
  /// at rest): it is dragged at that force, so that neither a creep nor a tremor turns it.
  void slip_to_the_end() noexcept {
    const double share = std::max(share_, 0.0);
    share_ = 1;
    if (is_longer(way_.velocity.now_m_per_s, slide_.restick_m_per_s)) {
      end_.ratio = low() * way_.direction_now;
    } else {
      end_.ratio = shortened(end_.ratio + (1 - share) * way_.now, low());
    }
  }

  void take_the_rest() noexcept {
    const double left = 1 - std::max(share_, 0.0);
    if (end_.phase == Phase::stick && slide_.sticks_at_once) {
      const Teeth teeth = many_teeth(end_.ratio, left * way_.now, low(), slide_.mu_static);
      end_.ratio = teeth.ratio;
      end_.ruptures += teeth.count;
      end_.last_event = 1;
    } else if (end_.phase == Phase::slip) {
      slip_to_the_end();
    }
  }

  void note_event() noexcept { end_.last_event = std::max(share_, 0.0); }

  const Spring& spring_;
  const Slide& slide_;
  const StickWay& way_;
  StickEnd end_;
  double share_ = 0;
  double scale_ = 1;
};

}  // namespace fingerpad

#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "replay/pop_throughs.hpp"
#include "replay/residual_figures.hpp"
#include "touch/tick_record.hpp"

namespace fingerpad {

/// What a run comes to, gathered tick by tick: the figures of `summary.csv`.
class Figures {
 public:
  Figures() = default;
  /// @param world  where the run takes place: then ways through parts that no contact shows count as
  /// pop-throughs too
  explicit Figures(std::shared_ptr<const World> world) : pop_throughs_(std::move(world)) {}

  void observe(const TickRecord& record) noexcept;

  /// Names with units, in the order of values().
  static std::span<const std::string_view> names() noexcept;
  /// One of values() by its name.
  /// @pre it is among names()
  static double of(const std::vector<double>& values, std::string_view name) noexcept;
  /// The figures as numbers: counts, then depths, forces, coefficients, the work of friction on the
  /// finger, the ticks on which a remedy acted, the energy that the loop has made (0: passive), and how often
  /// a finger started inside of a part, so that a proxy had to be put outside, or where it does not fit, so
  /// that there was no place for a proxy; pop-throughs; the greatest
  /// change of the whole force from tick to tick; the greatest change of the normal force (as a vector) per
  /// metre that the finger moved in the tick, which a stiffness alone explains up to its own number; the
  /// ticks whose force was not finite (0: promised); and those, in touch or not, whose proxy stopped before
  /// it was at rest because the bound of a tick's work was reached, not because the finger moved little; and
  /// the RMS, the bias and the lag of the residual, nan where no force was measured. The mean coefficient in
  /// slip is nan where nothing slipped under a normal force.
  std::vector<double> values() const;

  /// Teeth of the sawtooth, from one rupture to the next, and those of them that lasted under two ticks: no
  /// sampling shows them. A tooth that ended because the contact jumped from one wall to another is no such
  /// tooth, nor are those of two walls one after the other.
  long teeth() const noexcept { return teeth_; }
  long coarse_teeth() const noexcept { return coarse_teeth_; }

 private:
  void observe_phase(const TickRecord& record) noexcept;
  void observe_step(const TickRecord& record) noexcept;

  long ticks_ = 0, contact_ticks_ = 0, stick_ticks_ = 0, slip_ticks_ = 0, ruptures_ = 0;
  long teeth_ = 0, coarse_teeth_ = 0, tooth_ticks_ = 0;
  bool has_ruptured_ = false, tooth_crossed_ = false;
  Vec3 last_contact_W_ = Vec3::Zero();
  Phase last_phase_ = Phase::free;
  double max_depth_m_ = 0, sum_normal_n_ = 0, max_normal_n_ = 0, max_friction_n_ = 0;
  double sum_slip_mu_ = 0, max_mu_ = 0, friction_work_j_ = 0;
  long pressed_slip_ticks_ = 0;
  Vec3 last_p_WQ_ = Vec3::Zero();
  // Passivity observer (Hannaford & Ryu 2002): what the held forces have given to the finger so far, and its
  // most. A loop that began out of contact stores nothing, so whatever it gives on balance it has made; one
  // whose first tick is in contact begins with what the surfaces' springs store there.
  Vec3 last_force_W_n_ = Vec3::Zero();
  double given_j_ = 0, energy_made_j_ = 0;
  long remedied_ticks_ = 0, inside_starts_ = 0, nonfinite_ticks_ = 0, unsettled_ticks_ = 0;
  PopThroughs pop_throughs_;
  Vec3 last_normal_W_n_ = Vec3::Zero();
  double max_step_n_ = 0, max_step_n_per_m_ = 0;
  ResidualFigures residual_;
};

}  // namespace fingerpad

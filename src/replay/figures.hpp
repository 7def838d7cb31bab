#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "replay/run_totals.hpp"
#include "touch/tick_record.hpp"

namespace fingerpad {

/// What a run comes to, gathered tick by tick: the figures of `summary.csv`.
class Figures {
 public:
  Figures() = default;
  /// @param world  where the run takes place: then ways through parts that no contact shows count as
  /// pop-throughs too
  Figures(std::shared_ptr<const World> world, double radius_m) {
    totals_.pop_throughs = PopThroughs(std::move(world), radius_m);
  }

  void observe(const TickRecord& record) noexcept;

  /// Names with units, in the order of values().
  static std::span<const std::string_view> names() noexcept;
  /// One of values() by its name.
  /// @pre it is among names()
  static double of(const std::vector<double>& values, std::string_view name) noexcept;
  /// The figures as numbers, in the order of the summary's columns, whose rows say what each is.
  std::vector<double> values() const;

  /// Teeth of the sawtooth, from one rupture to the next, and those of them that lasted under two ticks: no
  /// sampling shows them. A tooth that ended because the contact jumped from one wall to another is no such
  /// tooth, nor are those of two walls one after the other.
  long teeth() const noexcept { return totals_.teeth; }
  long coarse_teeth() const noexcept { return totals_.coarse_teeth; }

 private:
  void observe_phase(const TickRecord& record) noexcept;
  void observe_step(const TickRecord& record) noexcept;
  void observe_work(const TickRecord& record) noexcept;

  RunTotals totals_;
  long tooth_ticks_ = 0;
  bool has_ruptured_ = false, tooth_crossed_ = false;
  Vec3 last_contact_W_ = Vec3::Zero();
  Phase last_phase_ = Phase::free;
  Vec3 last_p_WQ_ = Vec3::Zero();
  // Passivity observer (Hannaford & Ryu 2002): what the held forces have given to the finger so far; its most
  // is what they have made. A loop that began out of contact stores nothing, so whatever it gives on balance
  // it has made; one whose first tick is in contact begins with what the surfaces' springs store there.
  Vec3 last_force_W_n_ = Vec3::Zero(), last_friction_W_n_ = Vec3::Zero(), last_torque_W_n_m_ = Vec3::Zero();
  double given_j_ = 0;
  Vec3 last_normal_W_n_ = Vec3::Zero();
};

}  // namespace fingerpad

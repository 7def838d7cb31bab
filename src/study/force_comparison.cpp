#include "study/force_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "scene/scene.hpp"

namespace fingerpad {
namespace {

double share_of(double part, double whole) {
  return whole > 0 ? part / whole : 0;
}

/// "6.2", "0.31", "104": two digits, or whole per cents.
std::string percent(double share) {
  return share < 0.995 ? fmt::format("{:.2g}", 100 * share) : fmt::format("{:.0f}", 100 * share);
}

}  // namespace

Promises::Promises(const ContactSettings& contact)
    : force_tolerance(contact.force_tolerance),
      mu_tolerance(contact.mu_tolerance),
      least_force_n(0.1 * contact.greatest_force_n) {}

void ForceComparison::add(const StretchRun& run, const StretchRun& model) {
  const auto every = static_cast<std::size_t>(std::lround(model.rate_hz / run.rate_hz));
  assert(static_cast<double>(every) * run.rate_hz == model.rate_hz);
  Vec3 last_contact_n = Vec3::Zero(), last_model_n = Vec3::Zero();
  for (std::size_t k = 0; k < run.tick_count() && k * every < model.tick_count(); ++k) {
    const Vec3 &force_n = run.force_W_n[k], &model_force_n = model.force_W_n[k * every];
    const Vec3 &friction_n = run.friction_W_n[k], &model_friction_n = model.friction_W_n[k * every];
    const Vec3 contact_n = force_n - friction_n, model_contact_n = model_force_n - model_friction_n;
    const double off_n = (force_n - model_force_n).norm();
    const double contact_off_n = (contact_n - model_contact_n).norm();
    const double share = off_n / std::max(model_force_n.norm(), least_force_n_);
    const double contact_share = contact_off_n / std::max(model_contact_n.norm(), least_force_n_);
    sums_.force_rms_share += off_n * off_n;
    sums_.contact_rms_share += contact_off_n * contact_off_n;
    sums_.force_largest_share = std::max(sums_.force_largest_share, share);
    sums_.contact_largest_share = std::max(sums_.contact_largest_share, contact_share);
    contact_shares_.push_back(contact_share);
    model_square_ += model_force_n.squaredNorm();
    model_contact_square_ += model_contact_n.squaredNorm();
    friction_n_ += friction_n.norm();
    normal_n_ += static_cast<double>(run.normal_n[k]);
    if (k > 0) {
      const double beyond_n = (contact_n - last_contact_n).norm() - (model_contact_n - last_model_n).norm();
      sums_.step_beyond_n = std::max(sums_.step_beyond_n, beyond_n);
    }
    last_contact_n = contact_n;
    last_model_n = model_contact_n;
  }
  for (std::size_t k = 0; k < model.tick_count(); ++k) {
    model_friction_n_ += model.friction_W_n[k].norm();
    model_normal_n_ += static_cast<double>(model.normal_n[k]);
  }
  sums_.ruptures_missed += model.ruptures - run.ruptures;
  sums_.pop_throughs += run.pop_throughs;
}

ForceFigures ForceComparison::figures() const {
  ForceFigures figures = sums_;
  figures.ticks = static_cast<long>(contact_shares_.size());
  figures.force_rms_share = std::sqrt(share_of(sums_.force_rms_share, model_square_));
  figures.contact_rms_share = std::sqrt(share_of(sums_.contact_rms_share, model_contact_square_));
  figures.mean_mu = share_of(friction_n_, normal_n_);
  figures.model_mean_mu = share_of(model_friction_n_, model_normal_n_);
  figures.mu_error_share = share_of(std::abs(figures.mean_mu - figures.model_mean_mu), figures.model_mean_mu);
  if (contact_shares_.empty()) return figures;
  std::vector<double> shares = contact_shares_;
  // The last of the least 99 %.
  const auto most =
      shares.begin() + static_cast<std::ptrdiff_t>(std::ceil(0.99 * static_cast<double>(shares.size()))) - 1;
  std::nth_element(shares.begin(), most, shares.end());
  figures.contact_99_share = *most;
  return figures;
}

std::vector<std::string> broken_promises(const ForceFigures& figures, const Promises& promises) {
  std::vector<std::string> broken;
  if (figures.pop_throughs > 0)
    broken.push_back(
        fmt::format("{} pop-through{}", figures.pop_throughs, figures.pop_throughs > 1 ? "s" : ""));
  if (figures.contact_99_share > promises.force_tolerance) {
    broken.push_back(
        fmt::format("on one tick in a hundred its force is off by {} % or more, where {:.3g} % is asked for",
                    percent(figures.contact_99_share), 100 * promises.force_tolerance));
  }
  if (figures.mu_error_share > promises.mu_tolerance) {
    broken.push_back(
        fmt::format("its mean coefficient of friction is off by {} %, where {:.3g} % is asked for",
                    percent(figures.mu_error_share), 100 * promises.mu_tolerance));
  }
  return broken;
}

}  // namespace fingerpad

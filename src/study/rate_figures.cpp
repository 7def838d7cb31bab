#include "study/rate_figures.hpp"

#include <cmath>

namespace fingerpad {
namespace {

/// The share of teeth, from one rupture to the next in unbroken contact, that last under two ticks.
double unseen_teeth_share(const std::vector<StretchRun>& model, double rate_hz) {
  double teeth = 0, unseen = 0;
  for (const StretchRun& run : model) {
    const double shortest = 2 * run.rate_hz / rate_hz;
    double since = -1;  // ticks since the last rupture; below 0: none in this contact
    for (std::size_t k = 0; k < run.tick_count(); ++k) {
      if (!(run.normal_n[k] > 0)) since = -1;
      if (since >= 0) ++since;
      if (run.broke[k] == 0) continue;
      if (since >= 0) ++teeth;
      if (since >= 0 && since < shortest) ++unseen;
      since = 0;
    }
  }
  return teeth > 0 ? unseen / teeth : 0;
}

}  // namespace

RateFigures rate_figures(const std::vector<StretchRun>& model, double rate_hz) {
  double mu_square = 0, mu_sum = 0, force_square = 0, model_square = 0, count = 0;
  for (const StretchRun& run : model) {
    const auto every = static_cast<std::size_t>(std::lround(run.rate_hz / rate_hz));
    const auto mu_at = [&run](std::size_t k) {
      return run.friction_W_n[k].norm() / static_cast<double>(run.normal_n[k]);
    };
    for (std::size_t k = 0; k < run.tick_count(); ++k) {
      const std::size_t held = k - k % every;
      if (!(run.normal_n[k] > 0) || !(run.normal_n[held] > 0)) continue;
      const double mu = mu_at(k), mu_off = mu - mu_at(held);
      mu_square += mu_off * mu_off;
      mu_sum += mu;
      force_square += (run.force_W_n[k] - run.force_W_n[held]).squaredNorm();
      model_square += run.force_W_n[k].squaredNorm();
      ++count;
    }
  }
  if (count == 0) return {rate_hz};
  const double mean_mu = mu_sum / count;
  return {rate_hz, mean_mu > 0 ? std::sqrt(mu_square / count) / mean_mu : 0,
          model_square > 0 ? std::sqrt(force_square / model_square) : 0, unseen_teeth_share(model, rate_hz)};
}

}  // namespace fingerpad

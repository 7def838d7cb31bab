#pragma once

#include <map>
#include <span>
#include <utility>
#include <vector>

#include "touch/contact_verdict.hpp"

namespace fingerpad {

/// The verdicts on some parts under scenes that differ in a number or two: what they have in common is
/// reckoned once, and so is a part that stands there several times.
class ContactReckoning {
 public:
  /// @param surfaces  parts first
  /// @param measures  one for each part; both outlive this
  ContactReckoning(std::span<const Surface> surfaces, std::span<const PartMeasures> measures);

  /// @param finer  the facets are taken to be so many times smaller: they turn by so much less and cut in by
  /// the square of it less, patches fit so much better, and a ball in a hollow is near the square as many
  ContactVerdict on_all(const Scene& scene, int finer = 1);
  /// As if nothing but part i had to be touched well; on a single part that is on_all(). Its cases are one.
  ContactVerdict on_one(const Scene& scene, std::size_t i, int finer = 1);

  std::size_t part_count() const noexcept { return measures_.size(); }
  long reckoned() const noexcept { return errors_.reckoned(); }

 private:
  ContactCase case_of(const Scene& scene, std::size_t i, int finer);
  const CrowdedHollow& crowded_in(std::size_t i, double radius_m);

  std::span<const Surface> surfaces_;
  std::span<const PartMeasures> measures_;
  std::vector<std::size_t> same_as_;  ///< the first part of the same shape
  std::map<std::pair<std::size_t, double>, CrowdedHollow> crowded_;
  ErrorMemory errors_;
};

}  // namespace fingerpad

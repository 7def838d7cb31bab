#include <utility>

#include "contact/contact_method_table.hpp"
#include "contact/fast_proxy.hpp"

namespace fingerpad {

/// The closest-point method with searches that look at no more than so many triangles in a tick.
std::unique_ptr<ContactMethod> brief_closest_point(std::vector<PlacedSurface> surfaces, double radius_m,
                                                   Normals normals, long most_looks);

namespace {

/// A proxy that stays on the surfaces: what it stands on holds the finger.
class ProxyMethod final : public ContactMethod {
 public:
  ProxyMethod(std::vector<PlacedSurface> surfaces, double radius_m, Normals normals)
      : proxy_(fast_proxy(surfaces, radius_m, normals)),
        until_placed_(
            brief_closest_point(std::move(surfaces), radius_m, normals, ServoLooks::most_unplaced)) {}

  const Contact& touch(const Vec3& p_WQ, double dt_s) noexcept override {
    const ProxyContact& proxy = proxy_.move(p_WQ, dt_s);
    if (proxy.placed) return proxy;
    unplaced_ = until_placed_->touch(p_WQ, dt_s);
    unplaced_.started = proxy.started;
    unplaced_.placed = false;
    unplaced_.broken_off = proxy.broken_off;
    unplaced_.behind = proxy.behind;
    return unplaced_;
  }

  void reset() noexcept override {
    proxy_.reset();
    until_placed_->reset();
  }

 private:
  Proxy proxy_;
  std::unique_ptr<ContactMethod> until_placed_;  ///< serves where no place for the ball has been found yet
  Contact unplaced_;
};

}  // namespace

ContactMethodEntry proxy_method() noexcept {
  return {.name = "proxy",
          .summary = "a ball that follows the finger and stays outside (god-object; Zilles & Salisbury 1995)",
          .holds =
              "holds thin walls, knife edges, corners, open and badly wound meshes, several surfaces at once",
          .starts_outside = true,
          .holds_several = true,
          .may_lag = true,
          .lags_on_facets = true,
          .fails = proxy_fails,
          .make = [](std::vector<PlacedSurface> surfaces, double radius_m,
                     Normals normals) -> std::unique_ptr<ContactMethod> {
            return std::make_unique<ProxyMethod>(std::move(surfaces), radius_m, normals);
          }};
}

}  // namespace fingerpad

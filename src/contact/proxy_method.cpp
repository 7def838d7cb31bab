#include <utility>

#include "contact/contact_method_table.hpp"
#include "contact/proxy.hpp"

namespace fingerpad {

/// The closest-point method with searches that look at no more than so many triangles in a tick.
std::unique_ptr<ContactMethod> brief_closest_point(std::vector<PlacedSurface> surfaces, double radius_m,
                                                   Normals normals, long most_looks);

void take_holds(const ProxyContact& proxy, Contact& contact) noexcept {
  contact.hold_count = proxy.touching ? proxy.hold_count : 0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(contact.hold_count); ++k)
    contact.holds[k] = proxy.holds[k];
  contact.depth_m = proxy.depth_m;
  contact.point_W = proxy.point_W;
  contact.normal_W = proxy.normal_W;
}

namespace {

/// A proxy that stays on the surfaces: what it stands on holds the finger.
class ProxyMethod final : public ContactMethod {
 public:
  ProxyMethod(std::vector<PlacedSurface> surfaces, double radius_m, Normals normals)
      : proxy_(fast_proxy(surfaces, radius_m, normals)),
        until_placed_(brief_closest_point(std::move(surfaces), radius_m, normals, ProxyLimits::most_looks)) {}

  const Contact& touch(const Vec3& p_WQ, double dt_s) noexcept override {
    const ProxyContact& proxy = proxy_.move(p_WQ, dt_s);
    if (!proxy.placed) contact_ = until_placed_->touch(p_WQ, dt_s);
    contact_.started = proxy.started;
    contact_.placed = proxy.placed;
    contact_.broken_off = proxy.broken_off;
    if (!proxy.placed) return contact_;
    take_holds(proxy, contact_);
    return contact_;
  }

  void reset() noexcept override {
    proxy_.reset();
    until_placed_->reset();
  }

 private:
  Proxy proxy_;
  std::unique_ptr<ContactMethod> until_placed_;  ///< serves where no place for the ball has been found yet
  Contact contact_;
};

std::string nothing(const ContactDemand& /*demand*/) {
  return {};
}

}  // namespace

ContactMethodEntry proxy_method() noexcept {
  return {"proxy",
          "a ball that follows the finger and stays outside (god-object; Zilles & Salisbury 1995)",
          "holds thin walls, knife edges, corners, open and badly wound meshes, several surfaces at once",
          true,
          true,
          false,
          true,
          proxy_fails,
          nothing,
          [](std::vector<PlacedSurface> surfaces, double radius_m,
             Normals normals) -> std::unique_ptr<ContactMethod> {
            return std::make_unique<ProxyMethod>(std::move(surfaces), radius_m, normals);
          }};
}

}  // namespace fingerpad

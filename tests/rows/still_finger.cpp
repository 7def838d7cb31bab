#include "device/device_table.hpp"

namespace fingerpad {
namespace {

class StillFinger final : public LiveDevice {
 public:
  explicit StillFinger(const FingerSample& start) : finger_(start) {}
  FingerSample advance(double dt_s) noexcept override {
    finger_.t_s += dt_s;
    return finger_;
  }

 private:
  FingerSample finger_;
};

}  // namespace

DeviceEntry still_device() noexcept {
  return {"still", "a finger that stays where it is",
          [](const DeviceSetup& setup) -> std::unique_ptr<LiveDevice> {
            return std::make_unique<StillFinger>(setup.start);
          }};
}

}  // namespace fingerpad

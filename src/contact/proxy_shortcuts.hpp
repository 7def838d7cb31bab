#pragma once

#include "contact/proxy_state.hpp"

namespace fingerpad {

/// Shortcuts that a proxy's sight takes for it, from a state where it knows what the proxy would do. For
/// speed alone; here none is taken.
class ProxyShortcuts {
 public:
  virtual ~ProxyShortcuts() = default;

  /// At the tick's start: takes the proxy to where it comes to rest, and reports. False where that is not
  /// known; the proxy may then be on its way there.
  virtual bool carry(ProxyState&) noexcept { return false; }
  /// The proxy has come to rest.
  virtual void note_rest(const ProxyState&) noexcept {}
  /// At the tick's end: takes the proxy to the same place in closed form, and reports. False if not known.
  virtual bool slide(ProxyState&) noexcept { return false; }
  /// The proxy leaves what it rested on; steps may follow.
  virtual void let_go() noexcept {}
};

}  // namespace fingerpad

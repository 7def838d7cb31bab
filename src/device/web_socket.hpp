#pragma once

#include <memory>
#include <string>

namespace fingerpad {

/// A WebSocket to a service of this machine. One thread; every call waits only for as long as it is told.
class WebSocket {
 public:
  enum class Heard { message, nothing, closed };

  /// Connects to ws://HOST:PORT/. Throws Error (usage) where no such service answers within 2 s.
  WebSocket(const std::string& host, int port);
  ~WebSocket();
  WebSocket(const WebSocket&) = delete;
  WebSocket& operator=(const WebSocket&) = delete;

  /// The next message. What has not come by then may come in a later call.
  Heard hear(std::string& message, int patience_ms);
  /// @returns false where the service is gone, or takes nothing for 1 s
  bool say(const std::string& message);

 private:
  struct Connection;
  std::unique_ptr<Connection> connection_;
};

}  // namespace fingerpad

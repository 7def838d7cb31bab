#include "device/web_socket.hpp"

#include <fmt/format.h>

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <functional>
#include <optional>

#include "base/error.hpp"

namespace fingerpad {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
using Tcp = asio::ip::tcp;
using ErrorCode = boost::system::error_code;

constexpr std::chrono::milliseconds connecting{2000}, saying{1000};
constexpr std::size_t longest_message = std::size_t{1} << 20;

}  // namespace

struct WebSocket::Connection {
  asio::io_context work;
  beast::websocket::stream<Tcp::socket> stream{work};
  beast::flat_buffer buffer;
  std::optional<ErrorCode> heard;  ///< how the reading that is under way has ended
  bool hears = false;              ///< one is under way

  ~Connection() {
    // Whatever is under way ends with the socket, and then its handlers run.
    ErrorCode ignored;
    stream.next_layer().close(ignored);
    try {
      work.restart();
      work.run_for(saying);
    } catch (...) {  // NOLINT(bugprone-empty-catch): nobody is left who waits for them
    }
  }

  /// Runs until `done` or for so long; handlers of other work run as well.
  void run_until(const std::function<bool()>& done, std::chrono::milliseconds patience) {
    const auto end = std::chrono::steady_clock::now() + patience;
    work.restart();
    while (!done() && work.run_one_until(end) > 0) {
    }
  }

  /// Runs one operation to its end. @returns how it ended; timed_out where it has not, and then no other may
  /// be begun
  ErrorCode finish(std::chrono::milliseconds patience,
                   const std::function<void(std::function<void(ErrorCode)>)>& begin) {
    // The handler may outlive this call.
    const auto ended = std::make_shared<std::optional<ErrorCode>>();
    begin([ended](ErrorCode how) { *ended = how; });
    run_until([&] { return ended->has_value(); }, patience);
    return ended->value_or(asio::error::timed_out);
  }
};

WebSocket::WebSocket(const std::string& host, int port) : connection_(std::make_unique<Connection>()) {
  Connection& c = *connection_;
  const std::string name = fmt::format("{}:{}", host, port);
  ErrorCode failure;
  Tcp::resolver resolver(c.work);
  const auto places = resolver.resolve(host, std::to_string(port), failure);
  if (!failure) {
    failure = c.finish(connecting, [&](auto done) {
      asio::async_connect(c.stream.next_layer(), places,
                          [done](ErrorCode how, const Tcp::endpoint&) { done(how); });
    });
  }
  if (!failure) {
    c.stream.next_layer().set_option(Tcp::no_delay(true), failure);
    c.stream.read_message_max(longest_message);
    failure = c.finish(connecting, [&](auto done) {
      c.stream.async_handshake(name, "/", [done](ErrorCode how) { done(how); });
    });
  }
  if (failure)
    throw Error(ErrorKind::usage, "ws://" + name, "no service answers there: " + failure.message());
}

WebSocket::~WebSocket() = default;

WebSocket::Heard WebSocket::hear(std::string& message, int patience_ms) {
  Connection& c = *connection_;
  if (!c.hears) {
    c.hears = true;
    c.heard.reset();
    c.stream.async_read(c.buffer, [&c](ErrorCode how, std::size_t) { c.heard = how; });
  }
  c.run_until([&] { return c.heard.has_value(); }, std::chrono::milliseconds(patience_ms));
  if (!c.heard) return Heard::nothing;
  if (*c.heard) return Heard::closed;
  c.hears = false;
  message = beast::buffers_to_string(c.buffer.data());
  c.buffer.consume(c.buffer.size());
  return Heard::message;
}

bool WebSocket::say(const std::string& message) {
  Connection& c = *connection_;
  c.stream.text(true);
  const auto kept = std::make_shared<const std::string>(message);  // for as long as it is being written
  return !c.finish(saying, [&](auto done) {
    c.stream.async_write(asio::buffer(*kept), [done, kept](ErrorCode how, std::size_t) { done(how); });
  });
}

}  // namespace fingerpad

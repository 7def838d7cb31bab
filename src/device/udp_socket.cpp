#include "device/udp_socket.hpp"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <memory>

#include "base/error.hpp"

namespace fingerpad {
namespace {

static_assert(sizeof(sockaddr_in6) <= sizeof(PacketSender::address));

/// "ADDRESS:PORT" of a socket, [ADDRESS]:PORT with IPv6.
std::string socket_name(int descriptor) {
  sockaddr_storage own{};
  socklen_t length = sizeof(own);
  char host[INET6_ADDRSTRLEN] = "", port[8] = "";
  if (getsockname(descriptor, reinterpret_cast<sockaddr*>(&own), &length) == 0)
    getnameinfo(reinterpret_cast<sockaddr*>(&own), length, host, sizeof(host), port, sizeof(port),
                NI_NUMERICHOST | NI_NUMERICSERV);
  return own.ss_family == AF_INET6 ? fmt::format("[{}]:{}", host, port) : fmt::format("{}:{}", host, port);
}

}  // namespace

UdpSocket::UdpSocket(const std::string& address, int port) {
  addrinfo hints{};
  hints.ai_family = AF_UNSPEC;
  hints.ai_socktype = SOCK_DGRAM;
  hints.ai_flags = AI_NUMERICHOST | AI_NUMERICSERV | AI_PASSIVE;
  addrinfo* found = nullptr;
  if (address.empty() || getaddrinfo(address.c_str(), std::to_string(port).c_str(), &hints, &found) != 0) {
    throw Error(ErrorKind::usage, "--bind " + address,
                "is no address: give one of this machine's in numbers, as 127.0.0.1");
  }
  const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> owned(found, freeaddrinfo);
  descriptor_ = socket(found->ai_family, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (descriptor_ < 0 || bind(descriptor_, found->ai_addr, found->ai_addrlen) != 0) {
    const int failure = errno;
    if (descriptor_ >= 0) close(descriptor_);
    throw Error(ErrorKind::usage, fmt::format("{} port {}", address, port),
                fmt::format("cannot be listened on: {}; --port N takes another port, --bind ADDRESS another "
                            "address of this machine",
                            std::strerror(failure)));
  }
  name_ = socket_name(descriptor_);
}

UdpSocket::~UdpSocket() {
  close(descriptor_);
}

long UdpSocket::receive(std::span<unsigned char> buffer, PacketSender& sender) noexcept {
  sockaddr_storage from{};
  socklen_t length = sizeof(from);
  const ssize_t count =
      recvfrom(descriptor_, buffer.data(), buffer.size(), 0, reinterpret_cast<sockaddr*>(&from), &length);
  if (count < 0) return -1;
  sender = {};
  sender.length = std::min<unsigned>(length, sizeof(sender.address));
  std::memcpy(sender.address.data(), &from, sender.length);
  return count;
}

void UdpSocket::send(std::span<const unsigned char> bytes, const PacketSender& to) noexcept {
  sockaddr_storage address{};
  std::memcpy(&address, to.address.data(), to.length);
  [[maybe_unused]] const ssize_t sent = sendto(descriptor_, bytes.data(), bytes.size(), MSG_NOSIGNAL,
                                               reinterpret_cast<const sockaddr*>(&address), to.length);
}

}  // namespace fingerpad

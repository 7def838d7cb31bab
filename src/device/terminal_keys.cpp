#include "device/terminal_keys.hpp"

#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <utility>

#include "base/error.hpp"

namespace fingerpad {
namespace {

termios terminal_before;  // of the one that lives: a program has one standard input

}  // namespace

TypedKey first_key(std::string_view typed) noexcept {
  if (typed.empty()) return {};
  if (typed[0] != '\x1b') return {typed.substr(0, 1), 1};
  if (typed.size() > 1 && typed[1] != '[' && typed[1] != 'O') return {{}, 1};  // the key Escape
  if (typed.size() < 3) return {};
  constexpr std::pair<std::string_view, std::string_view> sequences[] = {
      {"[A", "up"},    {"OA", "up"},   {"[B", "down"}, {"OB", "down"},     {"[C", "right"},
      {"OC", "right"}, {"[D", "left"}, {"OD", "left"}, {"[5~", "page up"}, {"[6~", "page down"}};
  for (const auto& [sequence, name] : sequences) {
    if (typed.substr(1, sequence.size()) == sequence) return {name, 1 + sequence.size()};
  }
  // Another sequence ends with its first letter or tilde.
  for (std::size_t k = 2; k < typed.size(); ++k) {
    if (typed[k] >= '@' && typed[k] <= '~') return {{}, k + 1};
  }
  return {{}, typed.size() > 16 ? typed.size() : 0};
}

bool has_terminal_keys() noexcept {
  return isatty(STDIN_FILENO) == 1 && tcgetpgrp(STDIN_FILENO) == getpgrp();
}

void need_terminal_keys() {
  termios unread{};
  if (has_terminal_keys() && tcgetattr(STDIN_FILENO, &unread) == 0) return;
  throw Error(ErrorKind::usage, "standard input",
              "is no terminal of this program's, and --device keyboard is moved by the keys of one: start it "
              "in one, in the foreground");
}

TerminalKeys::TerminalKeys(std::function<void(std::string_view)> take) : take_(std::move(take)) {
  need_terminal_keys();
  tcgetattr(STDIN_FILENO, &terminal_before);
  termios raw = terminal_before;
  raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);  // key by key, unseen; Ctrl-C still ends the program
  raw.c_cc[VMIN] = 1;
  raw.c_cc[VTIME] = 0;
  tcsetattr(STDIN_FILENO, TCSANOW, &raw);
  thread_ = std::thread([this] { run(); });
}

TerminalKeys::~TerminalKeys() {
  stop_.wake();
  thread_.join();
  tcsetattr(STDIN_FILENO, TCSANOW, &terminal_before);
}

void TerminalKeys::run() {
  std::string typed;
  for (;;) {
    const WakeUp::Woken woken = stop_.wait_with(STDIN_FILENO);
    if (woken.by_wake || woken.broken) return;
    char buffer[64];
    const ssize_t count = read(STDIN_FILENO, buffer, sizeof(buffer));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return;  // the terminal is gone
    typed.append(buffer, static_cast<std::size_t>(count));
    for (TypedKey key = first_key(typed); key.bytes > 0; key = first_key(typed)) {
      if (!key.name.empty()) take_(key.name);
      typed.erase(0, key.bytes);
    }
  }
}

}  // namespace fingerpad

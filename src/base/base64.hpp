#pragma once

#include <string>
#include <string_view>

namespace fingerpad {

/// Bytes as text (RFC 4648), with the `=` at its end.
std::string base64(std::string_view bytes);

}  // namespace fingerpad

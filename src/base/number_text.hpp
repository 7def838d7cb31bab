#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace fingerpad {

/// The shortest text that reads back as the same double; "nan", "inf", "-inf" (never "-nan").
std::string number_text(double value);

/// The number for a person to read, rounded to so many significant digits and written out, "150" and not
/// "1.5e+02": all but what is below 1e-4 or from 1e9 on. Never "-0".
std::string rounded_text(double value, int digits);

/// The number for a person to read, with so many digits behind the point; never "-0.000".
std::string fixed_text(double value, int digits);

/// Appends number_text(value) to `out` (the form for large tables).
void append_number(std::string& out, double value);

/// The number that `text` spells in full (decimal point, whatever the locale; surrounding blanks allowed;
/// "nan" and "inf" are numbers here); nothing if anything else stands in it.
std::optional<double> parse_number(std::string_view text) noexcept;

}  // namespace fingerpad

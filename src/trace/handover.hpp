#pragma once

#include <cstdint>
#include <cstring>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/types.hpp"

/// Values on their way from a child process to its parent, one program both: numbers as they lie in memory,
/// whatever has a length behind it. `tell(value)` and `hear(value)` look alike, so that one function says
/// what a struct consists of for both.
namespace fingerpad {

class Teller {
 public:
  explicit Teller(std::function<void(std::string_view)> say) : say_(std::move(say)) {}

  template <typename Number>
  requires std::is_arithmetic_v<Number>
  void operator()(Number value) { put(&value, sizeof(value)); }
  template <typename Number>
  void numbers(std::span<const Number> values) {
    put(values.data(), values.size_bytes());
  }
  void operator()(const std::string& text) {
    (*this)(std::uint64_t{text.size()});
    put(text.data(), text.size());
  }
  template <typename Value>
  void operator()(const std::vector<Value>& values) {
    (*this)(std::uint64_t{values.size()});
    if constexpr (std::is_arithmetic_v<Value> && !std::is_same_v<Value, bool>) {
      numbers(std::span<const Value>(values));
    } else {
      for (const Value& value : values) (*this)(value);
    }
  }
  template <typename Number, int Rows, int Columns>
  void operator()(const Eigen::Matrix<Number, Rows, Columns>& values) {
    (*this)(static_cast<std::uint64_t>(values.cols()));
    numbers(std::span<const Number>(values.data(), static_cast<std::size_t>(values.size())));
  }
  /// Says what is still held back.
  void flush() {
    say_(held_);
    held_.clear();
  }

 private:
  void put(const void* bytes, std::size_t count) {
    held_.append(static_cast<const char*>(bytes), count);
    if (held_.size() > std::size_t{1} << 18) flush();
  }

  std::function<void(std::string_view)> say_;
  std::string held_;
};

/// What was told ends before what it should say.
struct ToldTooLittle : std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// It says more than it may.
struct ToldTooMuch : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Takes nothing on trust: a child that read a forged file may say anything. Throws ToldTooLittle and
/// ToldTooMuch.
class Hearer {
 public:
  /// @param hear       fills a buffer; false if there are fewer bytes
  /// @param max_bytes  that may be told in all
  Hearer(std::function<bool(std::span<char>)> hear, std::uint64_t max_bytes)
      : hear_(std::move(hear)), left_(max_bytes) {}

  template <typename Number>
  requires std::is_arithmetic_v<Number>
  void operator()(Number& value) {
    if constexpr (std::is_same_v<Number, bool>) {
      value = one<unsigned char>() != 0;
    } else {
      take(&value, sizeof(value));
    }
  }
  template <typename Number>
  Number one() {
    Number value{};
    (*this)(value);
    return value;
  }
  template <typename Number>
  void numbers(std::span<Number> values) {
    take(values.data(), values.size_bytes());
  }
  void operator()(std::string& text) {
    text.resize(length(1));
    take(text.data(), text.size());
  }
  template <typename Value>
  void operator()(std::vector<Value>& values) {
    values.clear();
    if constexpr (std::is_arithmetic_v<Value>) {
      values.resize(length(sizeof(Value)));
      numbers(std::span<Value>(values));
    } else {
      for (std::size_t left = length(sizeof(std::uint64_t)); left > 0; --left) {
        values.emplace_back();
        (*this)(values.back());
      }
    }
  }
  template <typename Number, int Rows, int Columns>
  void operator()(Eigen::Matrix<Number, Rows, Columns>& values) {
    const auto columns = static_cast<Eigen::Index>(length(sizeof(Number) * Rows));
    if (Columns != Eigen::Dynamic && columns != Columns) throw ToldTooMuch("another size");
    values.resize(Rows, columns);
    numbers(std::span<Number>(values.data(), static_cast<std::size_t>(values.size())));
  }

  /// How many elements follow, of at least so many bytes each.
  std::size_t length(std::size_t element_bytes) {
    const auto count = one<std::uint64_t>();
    if (count > left_ / element_bytes) throw ToldTooMuch("too much");
    return static_cast<std::size_t>(count);
  }

 private:
  void take(void* out, std::size_t count) {
    if (count > left_) throw ToldTooMuch("too much");
    left_ -= count;
    if (!hear_({static_cast<char*>(out), count})) throw ToldTooLittle("too little");
  }

  std::function<bool(std::span<char>)> hear_;
  std::uint64_t left_;
};

}  // namespace fingerpad

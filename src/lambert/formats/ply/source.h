#pragma once
/// The values behind a PLY header, one after the other, from text or from bytes of either order.

#include "lambert/base/error.h"
#include "lambert/base/number.h"
#include "lambert/formats/ply/header.h"

#include <bit>
#include <cstring>
#include <string>
#include <string_view>

namespace lambert::ply {

template <class T>
T load(const char* p, bool swap) {
  char bytes[sizeof(T)];
  for (std::size_t i = 0; i < sizeof(T); ++i) bytes[i] = swap ? p[sizeof(T) - 1 - i] : p[i];
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

/// Whether bytes in this encoding must be turned round on this machine.
inline bool needs_swap(Encoding e) {
  return (e == Encoding::big_endian) == (std::endian::native == std::endian::little);
}

/// The value of type `t` at `p`, as a Result (double or std::int64_t).
template <class Result>
Result load_as(const char* p, Type t, bool swap) {
  switch (t) {
    case Type::int8: return static_cast<Result>(load<std::int8_t>(p, swap));
    case Type::uint8: return static_cast<Result>(load<std::uint8_t>(p, swap));
    case Type::int16: return static_cast<Result>(load<std::int16_t>(p, swap));
    case Type::uint16: return static_cast<Result>(load<std::uint16_t>(p, swap));
    case Type::int32: return static_cast<Result>(load<std::int32_t>(p, swap));
    case Type::uint32: return static_cast<Result>(load<std::uint32_t>(p, swap));
    case Type::float32: return static_cast<Result>(load<float>(p, swap));
    default: return static_cast<Result>(load<double>(p, swap));
  }
}

class BinarySource {
 public:
  BinarySource(std::string_view data, const Header& h, const std::string& name)
      : data_(data), offset_(h.data_offset), swap_(needs_swap(h.encoding)), name_(name) {}

  float real(Type t) { return static_cast<float>(take<double>(t)); }
  std::int64_t integer(Type t) { return take<std::int64_t>(t); }
  void skip(Type t, std::size_t count) {
    if (count > (data_.size() - offset_) / size_of(t)) fail("the file ends too early");
    offset_ += count * size_of(t);
  }
  std::size_t offset() const { return offset_; }
  [[noreturn]] void fail(const std::string& why) const {
    throw Error(name_ + ": byte " + std::to_string(offset_) + ": " + why);
  }

 private:
  template <class Result>
  Result take(Type t) {
    const std::size_t at = offset_;
    skip(t, 1);
    return load_as<Result>(data_.data() + at, t, swap_);
  }

  std::string_view data_;
  std::size_t offset_;
  bool swap_;
  const std::string& name_;
};

class AsciiSource {
 public:
  AsciiSource(std::string_view data, const Header& h, const std::string& name)
      : p_(data.data() + h.data_offset),
        end_(data.data() + data.size()),
        line_start_(p_),
        line_(h.data_line),
        name_(name) {}

  float real(Type) {
    float value = 0;
    take([&] { return parse_float(p_, end_, value); }, "a finite number");
    return value;
  }
  std::int64_t integer(Type) {
    std::int64_t value = 0;
    take([&] { return parse_int(p_, end_, value); }, "an integer");
    return value;
  }
  void skip(Type, std::size_t count) {
    for (; count > 0; --count) take([&] { return word_end(); }, "a value");
  }
  /// At the value last taken.
  [[noreturn]] void fail(const std::string& why) const {
    throw Error({name_, line_, static_cast<std::size_t>(word_ - line_start_) + 1}, why);
  }

 private:
  static bool is_space(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; }
  const char* word_end() const {
    const char* last = p_;
    while (last != end_ && !is_space(*last)) ++last;
    return last;
  }
  void skip_space() {
    for (; p_ != end_ && is_space(*p_); ++p_) {
      if (*p_ == '\n') ++line_, line_start_ = p_ + 1;
    }
  }
  template <class Parse>
  void take(Parse parse, const char* expected) {
    skip_space();
    word_ = p_;
    if (p_ == end_) fail("the file ends too early");
    const char* last = parse();
    if (!last || (last != end_ && !is_space(*last))) {
      const std::string_view word(p_, static_cast<std::size_t>(word_end() - p_));
      fail(std::string("expected ") + expected + ", found '" + printable(word) + "'");
    }
    p_ = last;
  }

  const char *p_, *end_, *line_start_;
  const char* word_ = p_;  // the one last taken, for messages
  std::size_t line_;
  const std::string& name_;
};

}  // namespace lambert::ply

#include "lambert/base/settings.h"

#include "lambert/base/error.h"
#include "lambert/base/number.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace lambert {
namespace {

std::string float_text(float value) {
  std::string text;
  append_number(text, value);
  return text;
}

template <class T>
T parse_number(const Setting& s, std::string_view value, const char* kind) {
  T number{};
  const auto [end, status] = std::from_chars(value.data(), value.data() + value.size(), number);
  if (status != std::errc() || end != value.data() + value.size())
    throw Error("setting '" + s.key + "': expected " + kind + ", got '" + std::string(value) + "'");
  const auto refuse = [&](const std::string& expected) {
    throw Error("setting '" + s.key + "': expected " + kind + expected + ", got '" + std::string(value) + "'");
  };
  if (s.least && number < static_cast<T>(*s.least)) refuse(" of at least " + std::to_string(*s.least));
  if (s.above && !(static_cast<float>(number) > *s.above)) refuse(" above " + float_text(*s.above));
  if (s.most && static_cast<float>(number) > *s.most) refuse(" of at most " + float_text(*s.most));
  return number;
}

struct Assign {
  const Setting& s;
  std::string_view value;
  void operator()(int* t) const { *t = parse_number<int>(s, value, "a whole number"); }
  void operator()(float* t) const {
    const float number = parse_number<float>(s, value, "a number");
    if (!std::isfinite(number))
      throw Error("setting '" + s.key + "': expected a finite number, got '" + std::string(value) + "'");
    *t = number;
  }
  void operator()(bool* t) const {
    if (value != "true" && value != "false")
      throw Error("setting '" + s.key + "': expected true or false, got '" + std::string(value) + "'");
    *t = value == "true";
  }
  void operator()(std::string* t) const {
    if (!s.choices.empty() && std::find(s.choices.begin(), s.choices.end(), value) == s.choices.end())
      throw Error("setting '" + s.key + "': unknown value " + unknown_word(value, s.choices));
    *t = value;
  }
};

struct Print {
  std::string operator()(const int* t) const { return std::to_string(*t); }
  std::string operator()(const float* t) const {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, *t).ptr;
    return {text, end};
  }
  std::string operator()(const bool* t) const { return *t ? "true" : "false"; }
  std::string operator()(const std::string* t) const { return *t; }
};

}  // namespace

void SettingTable::set(std::string_view key, std::string_view value) {
  for (Setting& s : settings_)
    if (s.key == key) return std::visit(Assign{s, value}, s.target);
  std::vector<std::string> known;
  for (const Setting& s : settings_) known.push_back(s.key);
  throw Error("unknown setting " + unknown_word(key, known));
}

std::string to_string(const Setting& s) {
  return std::visit([](const auto* t) { return Print{}(t); }, s.target);
}

}  // namespace lambert

#include "lambert/formats/gltf/json.h"

#include "lambert/base/error.h"
#include "lambert/base/number.h"

#include <cmath>
#include <limits>

namespace lambert::gltf {
namespace {

const char* kind_of(const Json& json) {
  static constexpr const char* names[] = {"null", "a boolean", "a number", "a string", "an array", "an object"};
  return names[json.value.index()];
}

/// JSON pointers write "/" as "~1" and "~" as "~0" (RFC 6901).
std::string pointer_token(std::string_view key) {
  std::string token;
  for (const char c : printable(key)) {
    if (c == '~') {
      token += "~0";
    } else if (c == '/') {
      token += "~1";
    } else {
      token += c;
    }
  }
  return token;
}

}  // namespace

std::string JsonView::place() const { return *file_ + ": " + (pointer_.empty() ? "/" : pointer_); }

void JsonView::fail(const std::string& why) const { throw Error(place() + ": " + why); }

template <class T>
const T& JsonView::as(const char* what) const {
  if (!value_) fail(std::string("expected ") + what + ", found nothing");
  const T* value = std::get_if<T>(&value_->value);
  if (!value) fail(std::string("expected ") + what + ", found " + kind_of(*value_));
  return *value;
}

JsonView JsonView::operator[](std::string_view key) const {
  JsonView member = *this;
  member.pointer_ += "/" + pointer_token(key);
  member.value_ = nullptr;
  if (!value_) return member;
  for (const Json::Member& m : as<Json::Object>("an object")) {
    if (m.key != key) continue;
    member.value_ = &m.value;
    break;
  }
  return member;
}

JsonView JsonView::operator[](std::size_t index) const {
  JsonView element = *this;
  element.pointer_ += "/" + std::to_string(index);
  element.value_ = nullptr;
  if (!value_) return element;
  const auto& array = as<Json::Array>("an array");
  if (index < array.size()) element.value_ = &array[index];
  return element;
}

std::size_t JsonView::size() const { return value_ ? as<Json::Array>("an array").size() : 0; }

std::vector<std::string> JsonView::keys() const {
  std::vector<std::string> keys;
  if (!value_) return keys;
  for (const Json::Member& m : as<Json::Object>("an object")) keys.push_back(m.key);
  return keys;
}

bool JsonView::boolean(bool fallback) const { return value_ ? as<bool>("true or false") : fallback; }

float JsonView::number() const {
  const double d = as<double>("a number");
  if (std::abs(d) > static_cast<double>(std::numeric_limits<float>::max())) fail("this number is too large");
  return static_cast<float>(d);
}

std::size_t JsonView::count() const {
  const double d = as<double>("a whole number");
  if (!(d >= 0 && d <= 0x1p53) || d != std::floor(d)) fail("expected a whole number that is not negative");
  return static_cast<std::size_t>(d);
}

std::string JsonView::text() const { return as<std::string>("a string"); }

std::vector<float> JsonView::numbers() const {
  std::vector<float> numbers;
  for_each(*this, [&](const JsonView& n) { numbers.push_back(n.number()); });
  return numbers;
}

std::vector<float> JsonView::exactly(std::size_t length) const {
  if (size() != length) fail("expected " + std::to_string(length) + " numbers, found " + std::to_string(size()));
  return numbers();
}

glm::vec2 JsonView::vec2(glm::vec2 fallback) const {
  if (!value_) return fallback;
  const auto n = exactly(2);
  return {n[0], n[1]};
}
glm::vec3 JsonView::vec3(glm::vec3 fallback) const {
  if (!value_) return fallback;
  const auto n = exactly(3);
  return {n[0], n[1], n[2]};
}
glm::vec4 JsonView::vec4(glm::vec4 fallback) const {
  if (!value_) return fallback;
  const auto n = exactly(4);
  return {n[0], n[1], n[2], n[3]};
}

}  // namespace lambert::gltf

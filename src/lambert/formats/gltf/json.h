#pragma once
/// JSON as the glTF reader sees it: a small tree, and views of it that know their place in the file.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace lambert::gltf {

struct Json {
  struct Member;
  using Array = std::vector<Json>;
  using Object = std::vector<Member>;  // in the file's order
  std::variant<std::monostate, bool, double, std::string, Array, Object> value;
};
struct Json::Member {
  std::string key;
  Json value;
};

/// Throws Error with `name`, line and column. Nesting deeper than max_json_depth is refused.
Json parse_json(std::string_view text, const std::string& name);

/// A value, or the absence of one, together with its JSON pointer: every complaint says "file: /meshes/0/name: why".
/// The tree and the file's name must outlive it.
class JsonView {
 public:
  JsonView(const Json& root, const std::string& file) : value_(&root), file_(&file) {}

  bool exists() const { return value_ != nullptr; }
  explicit operator bool() const { return exists(); }
  const std::string& pointer() const { return pointer_; }
  /// "file: /meshes/0", as in errors.
  std::string place() const;
  [[noreturn]] void fail(const std::string& why) const;

  /// The member of an object; absent when there is none, or when this is absent itself.
  JsonView operator[](std::string_view key) const;
  JsonView operator[](std::size_t index) const;
  JsonView extension(std::string_view name) const { return (*this)["extensions"][name]; }
  /// Of an array; 0 when absent.
  std::size_t size() const;
  /// Of an object, in the file's order; none when absent.
  std::vector<std::string> keys() const;

  /// These throw Error when the value is of another kind or, without a fallback, when it is absent.
  bool boolean(bool fallback) const;
  float number() const;
  float number(float fallback) const { return exists() ? number() : fallback; }
  std::size_t count() const;  ///< an integer from 0 to 2^53
  std::size_t count(std::size_t fallback) const { return exists() ? count() : fallback; }
  std::string text() const;
  std::string text(std::string_view fallback) const { return exists() ? text() : std::string(fallback); }
  std::vector<float> numbers() const;  ///< none when absent
  glm::vec2 vec2(glm::vec2 fallback) const;
  glm::vec3 vec3(glm::vec3 fallback) const;
  glm::vec4 vec4(glm::vec4 fallback) const;

 private:
  template <class T>
  const T& as(const char* what) const;
  std::vector<float> exactly(std::size_t length) const;

  const Json* value_;
  const std::string* file_;
  std::string pointer_;
};

/// Calls f(element) for every element of an array, which may be absent.
template <class F>
void for_each(const JsonView& array, F&& f) {
  for (std::size_t i = 0, n = array.size(); i < n; ++i) f(array[i]);
}

}  // namespace lambert::gltf

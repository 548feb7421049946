#pragma once
/// The parameters of a directive: "type name" followed by values.

#include "lambert/base/notes.h"
#include "lambert/base/vec.h"
#include "lambert/formats/pbrt/colour_space.h"
#include "lambert/formats/pbrt/tokenizer.h"

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace lambert::pbrt {

enum class ParameterType : std::uint8_t {
  integer,
  floating,
  point2,
  vector2,
  point3,
  vector3,
  normal,
  spectrum,
  rgb,
  blackbody,
  boolean,
  string,
  texture,
};
const char* type_name(ParameterType t);
std::vector<std::string> parameter_type_names();

struct Parameter {
  ParameterType type = ParameterType::floating;
  std::string name;
  Place place;
  std::vector<float> floats;         ///< of all types with real numbers, flat
  std::vector<int> integers;         ///< of "integer", and 0 or 1 for "bool"
  std::vector<std::string> strings;  ///< of "string", "texture" and named spectra
  ColourSpace colour_space;          ///< of "rgb"
  bool inherited = false;            ///< set by Attribute: need not concern every kind of shape, light or material
  mutable bool used = false;

  [[noreturn]] void fail(const std::string& message) const { throw Error(place, message); }
};

/// Looks parameters up by name and type, and remembers which nobody asked for. Asking for one of another type, or of
/// another number of values, throws Error with the parameter's place.
class ParameterList {
 public:
  ParameterList() = default;
  /// `owner` is the directive as messages name it: Shape "sphere".
  ParameterList(std::string owner, Place place) : owner_(std::move(owner)), place_(std::move(place)) {}

  /// Throws Error when there is one of that name.
  void add(Parameter p);
  /// Adds those of `defaults` whose names are not there yet.
  void inherit(const std::vector<Parameter>& defaults);

  bool has(std::string_view name) const;
  /// Null when absent. Marks it as used.
  const Parameter* find(std::string_view name, std::initializer_list<ParameterType> allowed) const;

  float number(std::string_view name, float fallback) const;
  int integer(std::string_view name, int fallback) const;
  bool boolean(std::string_view name, bool fallback) const;
  std::string string(std::string_view name, std::string fallback) const;
  Vec3 point(std::string_view name, Vec3 fallback) const;
  std::vector<float> numbers(std::string_view name) const;
  std::vector<int> integers(std::string_view name) const;
  std::vector<std::string> strings(std::string_view name) const;
  std::vector<Vec3> vectors3(std::string_view name, ParameterType type) const;
  std::vector<Vec2> vectors2(std::string_view name, ParameterType type) const;

  const std::vector<Parameter>& all() const { return parameters_; }
  const std::string& owner() const { return owner_; }
  const Place& place() const { return place_; }
  /// Throws Error at the directive.
  [[noreturn]] void fail(const std::string& message) const { throw Error(place_, owner_ + ": " + message); }
  void note_unused(Notes& notes) const;
  /// Asks for nothing, but does not report anything either.
  void ignore_all() const;

 private:
  const Parameter* find_single(std::string_view name, ParameterType type, std::size_t values) const;

  std::string owner_;
  Place place_;
  std::vector<Parameter> parameters_;
};

/// Reads parameters up to the next directive.
void parse_parameters(Tokenizer& tokens, const ColourSpace& colour_space, ParameterList& list);

}  // namespace lambert::pbrt

#pragma once
/// The directives of the language, in three tables.

#include "lambert/formats/pbrt/builder.h"

#include <cstdint>
#include <span>
#include <string>

namespace lambert::pbrt {

class Parser;

/// One directive that is being read: its word `at` is taken, its arguments are not.
struct Call {
  Parser& parser;
  Builder& builder;
  Tokenizer& tokens;
  const Token& at;

  Place place() const { return tokens.place(at); }
  [[noreturn]] void fail(const std::string& message) const { tokens.fail(at, std::string(at.text) + ": " + message); }
  /// The parameters that follow. `type` is the quoted word before them.
  ParameterList parameters(const std::string& type = "") const {
    ParameterList list(std::string(at.text) + (type.empty() ? "" : " \"" + type + "\""), place());
    parse_parameters(tokens, builder.colour_space(), list);
    return list;
  }
};

enum class Where : std::uint8_t { anywhere, before_world, in_world };

struct Directive {
  const char* name;
  Where where;
  void (*handler)(Call&);
};

std::span<const Directive> transform_directives();
std::span<const Directive> setting_directives();  ///< before WorldBegin
std::span<const Directive> world_directives();

}  // namespace lambert::pbrt

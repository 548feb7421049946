#include "lambert/base/number.h"
#include "lambert/formats/pbrt/old_syntax.h"
#include "lambert/formats/pbrt/parameters.h"

#include <array>
#include <utility>

namespace lambert::pbrt {
namespace {

bool holds_strings(ParameterType t) { return t == ParameterType::string || t == ParameterType::texture; }

/// How many numbers make one value.
std::size_t group_size(ParameterType t) {
  switch (t) {
    case ParameterType::point2:
    case ParameterType::vector2: return 2;
    case ParameterType::point3:
    case ParameterType::vector3:
    case ParameterType::normal:
    case ParameterType::rgb: return 3;
    default: return 1;
  }
}

ParameterType parse_type(const Tokenizer& tokens, const Token& declaration, const std::string& word) {
  for (std::size_t i = 0; i < parameter_type_names().size(); ++i) {
    if (word == type_name(static_cast<ParameterType>(i))) return static_cast<ParameterType>(i);
  }
  // Accepted by pbrt-v4 as well.
  constexpr std::array<std::pair<std::string_view, ParameterType>, 3> short_names{
      {{"point", ParameterType::point3}, {"vector", ParameterType::vector3}, {"normal3", ParameterType::normal}}};
  for (const auto& [name, type] : short_names) {
    if (word == name) return type;
  }
  tokens.fail(declaration, "unknown parameter type " + unknown_word(printable(word), parameter_type_names()) +
                               old_parameter_type_hint(word));
}

Parameter parse_declaration(const Tokenizer& tokens, const Token& t) {
  const std::string declaration = tokens.string_value(t);
  const auto word = [&, position = std::size_t{0}]() mutable {
    const std::size_t first = std::min(declaration.find_first_not_of(" \t", position), declaration.size());
    position = std::min(declaration.find_first_of(" \t", first), declaration.size());
    return declaration.substr(first, position - first);
  };
  auto next_word = word;
  const std::string type = next_word(), name = next_word();
  if (name.empty() || !next_word().empty()) {
    tokens.fail(t, "expected a parameter as \"type name\", found " + describe(t));
  }
  Parameter p;
  p.type = parse_type(tokens, t, type);
  p.name = name;
  p.place = tokens.place(t);
  return p;
}

int parse_boolean(const Tokenizer& tokens, const Token& t) {
  if (t.kind == TokenKind::word || t.kind == TokenKind::string) {
    if (t.text == "true") return 1;
    if (t.text == "false") return 0;
  }
  tokens.fail(t, "expected true or false, found " + describe(t));
}

/// All values of one kind that stand next: a run of numbers, or one string or word.
void parse_some_values(Tokenizer& tokens, Parameter& p) {
  const Token t = tokens.peek();
  if (p.type == ParameterType::boolean) {
    p.integers.push_back(parse_boolean(tokens, tokens.next()));
  } else if (t.kind == TokenKind::string && (holds_strings(p.type) || p.type == ParameterType::spectrum)) {
    p.strings.push_back(tokens.string_value(tokens.next()));
  } else if (t.kind == TokenKind::number && p.type == ParameterType::integer) {
    tokens.read_numbers(p.integers);
  } else if (t.kind == TokenKind::number && !holds_strings(p.type)) {
    tokens.read_numbers(p.floats);
  } else {
    tokens.fail(t, std::string("expected ") + (holds_strings(p.type) ? "a string" : "a number") + " for parameter '" +
                       p.name + "' of type '" + type_name(p.type) + "', found " + describe(t));
  }
}

void parse_values(Tokenizer& tokens, Parameter& p) {
  if (tokens.peek().kind != TokenKind::open) {
    parse_some_values(tokens, p);
  } else {
    tokens.next();
    while (tokens.peek().kind != TokenKind::close) {
      if (tokens.peek().kind == TokenKind::end) p.fail("the values of parameter '" + p.name + "' have no closing ']'");
      parse_some_values(tokens, p);
    }
    tokens.next();
  }
  const std::size_t values = p.floats.size() + p.integers.size() + p.strings.size();
  if (values == 0) p.fail("parameter '" + p.name + "' has no values");
  if (const std::size_t group = group_size(p.type); p.floats.size() % group != 0) {
    p.fail("parameter '" + p.name + "' of type '" + type_name(p.type) + "' takes " + std::to_string(group) +
           " numbers per value, found " + std::to_string(p.floats.size()));
  }
}

}  // namespace

void parse_parameters(Tokenizer& tokens, const ColourSpace& colour_space, ParameterList& list) {
  while (tokens.peek().kind == TokenKind::string) {
    Parameter p = parse_declaration(tokens, tokens.next());
    p.colour_space = colour_space;
    parse_values(tokens, p);
    list.add(std::move(p));
  }
}

}  // namespace lambert::pbrt

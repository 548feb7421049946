#pragma once
/// A compositing expression as a tree, from text or JSON and back. The grammar (blanks between words do not matter but
/// as their ends):
///
///   expression = operand, { infix, operand } ;                    (* from the left, all of one precedence *)
///   operand    = primary, { postfix } ;
///   primary    = file | generator | "(", expression, ")" ;
///   infix      = "over" | "in" | … ;
///   postfix    = word, [ name ], [ primary ], { number }, { option } ;   (* which of them, language.h says *)
///   generator  = word, "(", number, { ",", number }, { ",", ( number | option ) }, ")" ;
///   option     = name, "=", number ;
///   number     = decimal | "[", key, { [ "," ], key }, "]" ;
///   key        = decimal, ":", decimal ;                          (* frame:value *)
///   name       = bare | quoted ;
///   file       = bare with one of . / # % in it | quoted ;
///   bare       = { any but blank ( ) [ ] , : = " ' } ;
///   quoted     = '"', { any but " \ | \" | \\ }, '"' ;            (* or with ' for " *)

#include "lambert/image/composite/language.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace lambert::composite {

struct Key {
  double frame = 0, value = 0;
  bool operator==(const Key&) const = default;
};

/// A constant, or keys in order of their frames.
struct Number {
  double value = 0;
  std::vector<Key> keys;
  /// Linear between keys; the first and the last key hold before and after.
  double at(double frame) const;
  bool operator==(const Number&) const = default;
};

struct Expression {
  const Word* word = nullptr;      ///< null: a file
  std::string text;                ///< the file, or the name that the word takes
  std::vector<Number> numbers;     ///< one for each parameter of the word, and further ones of a word with `more`
  std::vector<Expression> inputs;  ///< A and B; A and M; A; none
  std::size_t place = 0;           ///< its byte in the text that it was read from; no part of its value
  bool operator==(const Expression& o) const {
    return word == o.word && text == o.text && numbers == o.numbers && inputs == o.inputs;
  }
};

/// Trees are at most so deep: as many elements may be joined by infix words without parentheses.
inline constexpr std::size_t max_depth = 2000;
/// Each costs the parser three calls, which sanitizers make large.
inline constexpr std::size_t max_parentheses = 256;

/// Throws Error with `name`, line, column, the word and what was expected: syntax, a number out of its range, keys that
/// are not in order.
Expression parse_expression(std::string_view text, const std::string& name = "expression");
/// On one line, with no more parentheses than needed; reads back as an equal tree.
std::string to_text(const Expression& expression);

/// {"file": "a.exr"}, or {"word": "key-colour", "inputs": [A], "numbers": {"r": 0.1, "g": [[1, 0], [24, 1]], …},
/// "text": "…"}, where more than two inputs of an infix word stand for ((A word B) word C) and numbers may be an array.
/// Throws Error as parse_expression does; brackets may nest max_json_depth deep.
Expression parse_json_expression(std::string_view text, const std::string& name);
/// Reads back as an equal tree where the brackets nest no deeper and names are UTF-8.
std::string to_json(const Expression& expression);

/// The files that it names, each once, in order.
std::vector<std::string> files_of(const Expression& expression);

}  // namespace lambert::composite

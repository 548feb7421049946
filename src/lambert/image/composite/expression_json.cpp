#include "lambert/image/composite/check_numbers.h"
#include "lambert/image/composite/json_tree.h"

#include "lambert/base/error.h"
#include "lambert/base/number.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

namespace lambert::composite {
namespace {

class Reader {
 public:
  Reader(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  struct Part {
    Expression tree;
    std::size_t depth = 1;
  };

  Part tree(const JsonValue& v) const {
    if (v.kind == JsonKind::string) return {file(v, v)};
    if (v.kind != JsonKind::object) fail(v.at, "expected an object with \"file\" or \"word\", or the name of a file");
    if (const JsonValue* name = member(v, "file")) {
      check_members(v, {"file"});
      return {file(v, *name)};
    }
    check_members(v, {"word", "inputs", "numbers", "text"});
    const JsonValue* name = member(v, "word");
    if (!name) fail(v.at, "expected \"file\" or \"word\"");
    Expression e{.word = word(*name), .place = v.at.begin};
    text(v, e);
    numbers(v, e);
    return with_inputs(v, std::move(e));
  }

 private:
  [[noreturn]] void fail(TextRange at, const std::string& message) const {
    throw Error(location_in(text_, name_, at.begin), message);
  }

  static const JsonValue* member(const JsonValue& v, std::string_view name) {
    for (std::size_t i = 0; i < v.keys.size(); ++i)
      if (v.keys[i].first == name) return &v.values[i];
    return nullptr;
  }

  void check_members(const JsonValue& v, const std::vector<std::string>& known) const {
    for (std::size_t i = 0; i < v.keys.size(); ++i) {
      const auto& [name, at] = v.keys[i];
      if (std::find(known.begin(), known.end(), name) == known.end())
        fail(at, "unknown member " + unknown_word(name, known));
      for (std::size_t j = 0; j < i; ++j)
        if (v.keys[j].first == name) fail(at, "'" + printable(name) + "' is given twice");
    }
  }

  Expression file(const JsonValue& v, const JsonValue& name) const {
    if (name.kind != JsonKind::string || name.string.empty()) fail(name.at, "expected the name of a file");
    Expression e{.place = v.at.begin};
    e.text = name.string;
    return e;
  }

  const Word* word(const JsonValue& name) const {
    if (name.kind != JsonKind::string) fail(name.at, "expected a word");
    const Word* found = find_word(name.string);
    if (found) return found;
    std::vector<std::string> known;
    for (const Word& w : all_words()) known.emplace_back(w.name);
    fail(name.at, "unknown word " + unknown_word(name.string, known));
  }

  void text(const JsonValue& v, Expression& e) const {
    const JsonValue* name = member(v, "text");
    const std::string who(e.word->name);
    if (e.word->text.empty()) {
      if (name) fail(name->at, who + " takes no text");
      return;
    }
    if (!name || name->kind != JsonKind::string)
      fail(name ? name->at : v.at, who + ": expected \"text\", the name of a " + std::string(e.word->text));
    e.text = name->string;
  }

  void numbers(const JsonValue& v, Expression& e) const {
    const JsonValue* given = member(v, "numbers");
    const Parameters& parameters = e.word->parameters;
    if (given && given->kind == JsonKind::array) {
      const bool fits = e.word->more ? given->values.size() >= parameters.size() && given->values.size() % 2 == 0
                                     : given->values.size() <= parameters.size();
      if (!fits) fail(given->at, "wrong count of numbers: " + usage(*e.word));
      for (std::size_t i = 0; i < given->values.size(); ++i)
        e.numbers.push_back(number(given->values[i], parameter_of(*e.word, i)));
    } else if (given && given->kind != JsonKind::object) {
      fail(given->at, "expected an array or an object of numbers");
    } else if (given) {
      std::vector<std::string> known;
      for (const Parameter& p : parameters) known.emplace_back(p.name);
      check_members(*given, known);
    }
    for (std::size_t i = e.numbers.size(); i < parameters.size(); ++i) {
      const Parameter& p = parameters[i];
      const JsonValue* value = given && given->kind == JsonKind::object ? member(*given, p.name) : nullptr;
      if (value)
        e.numbers.push_back(number(*value, p));
      else if (p.otherwise)
        e.numbers.push_back({.value = *p.otherwise});
      else
        fail(given ? given->at : v.at, "expected a number '" + std::string(p.name) + "': " + usage(*e.word));
    }
  }

  double decimal(const JsonValue& v) const {
    if (v.kind != JsonKind::number) fail(v.at, "expected a number");
    return v.number;
  }

  Number number(const JsonValue& v, const Parameter& parameter) const {
    Number n;
    if (v.kind == JsonKind::array) {
      for (const JsonValue& key : v.values) {
        if (key.kind != JsonKind::array || key.values.size() != 2) fail(key.at, "expected [frame, value]");
        n.keys.push_back({decimal(key.values[0]), decimal(key.values[1])});
      }
      if (n.keys.empty()) fail(v.at, "expected a number or [[frame, value], …]");
    } else {
      n.value = decimal(v);
    }
    if (const std::string fault = fault_of(n, parameter); !fault.empty()) fail(v.at, fault);
    return n;
  }

  Part with_inputs(const JsonValue& v, Expression e) const {
    const JsonValue* given = member(v, "inputs");
    const Form form = e.word->form;
    const std::size_t least = form == Form::generator ? 0 : (form == Form::infix || e.word->second ? 2 : 1);
    const std::size_t count = given ? given->values.size() : 0;
    if ((given && given->kind != JsonKind::array) || (form == Form::infix ? count < least : count != least))
      fail(given ? given->at : v.at, std::string(e.word->name) + ": expected \"inputs\", an array of " +
                                         std::to_string(least) + (form == Form::infix ? " or more" : ""));
    std::size_t depth = 1;
    for (std::size_t i = 0; i < count; ++i) {
      if (i >= 2) {
        Expression outer{.word = e.word, .place = e.place};
        outer.inputs.push_back(std::move(e));
        e = std::move(outer);
        ++depth;
      }
      Part input = tree(given->values[i]);
      depth = std::max(depth, input.depth + 1);
      if (depth > max_depth) fail(given->at, "the tree is deeper than " + std::to_string(max_depth));
      e.inputs.push_back(std::move(input.tree));
    }
    return {std::move(e), depth};
  }

  std::string_view text_;
  std::string name_;
};

void append_string(std::string& text, std::string_view s) {
  text += '"';
  for (const char c : s) {
    if (c == '"' || c == '\\') text += '\\';
    if (static_cast<unsigned char>(c) < 0x20) {
      std::array<char, 8> code;
      std::snprintf(code.data(), code.size(), "\\u%04x", static_cast<unsigned>(c));
      text += code.data();
    } else {
      text += c;
    }
  }
  text += '"';
}

void append(std::string& text, const Number& n) {
  if (n.keys.empty()) return append_number(text, n.value);
  for (std::size_t i = 0; i < n.keys.size(); ++i) {
    text += i ? ", [" : "[[";
    append_number(text, n.keys[i].frame);
    text += ", ";
    append_number(text, n.keys[i].value);
    text += ']';
  }
  text += ']';
}

/// A, B, C … of ((A word B) word C) ….
std::vector<const Expression*> chain(const Expression& e) {
  std::vector<const Expression*> inputs;
  const Expression* at = &e;
  while (e.word->form == Form::infix && at->inputs[0].word == e.word) {
    inputs.push_back(&at->inputs[1]);
    at = &at->inputs[0];
  }
  for (std::size_t i = at->inputs.size(); i-- > 0;) inputs.push_back(&at->inputs[i]);
  std::reverse(inputs.begin(), inputs.end());
  return inputs;
}

void append(std::string& text, const Expression& e, const std::string& indent) {
  if (!e.word) {
    text += "{\"file\": ";
    append_string(text, e.text);
    text += '}';
    return;
  }
  text += "{\"word\": ";
  append_string(text, e.word->name);
  if (!e.word->text.empty()) {
    text += ", \"text\": ";
    append_string(text, e.text);
  }
  const Parameters& parameters = e.word->parameters;
  for (std::size_t i = 0; i < e.numbers.size(); ++i) {
    text += i ? ", " : (e.word->more ? ", \"numbers\": [" : ", \"numbers\": {");
    if (!e.word->more) {
      append_string(text, parameters[i].name);
      text += ": ";
    }
    append(text, e.numbers[i]);
  }
  if (!e.numbers.empty()) text += e.word->more ? ']' : '}';
  const std::vector<const Expression*> inputs = chain(e);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    text += (i ? ",\n" : ", \"inputs\": [\n") + indent + "  ";
    append(text, *inputs[i], indent + "  ");
  }
  text += inputs.empty() ? "}" : "]}";
}

}  // namespace

Expression parse_json_expression(std::string_view text, const std::string& name) {
  const JsonValue root = parse_json_tree(text, name);
  return Reader(text, name).tree(root).tree;
}

std::string to_json(const Expression& expression) {
  std::string text;
  append(text, expression, "");
  return text + "\n";
}

}  // namespace lambert::composite

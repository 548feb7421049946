#include "lambert/image/composite/expression.h"

#include "lambert/base/number.h"
#include "lambert/image/composite/lexer.h"

#include <algorithm>

namespace lambert::composite {
namespace {

void append_quoted(std::string& text, std::string_view name) {
  text += '"';
  for (const char c : name) {
    if (c == '"' || c == '\\') text += '\\';
    text += c;
  }
  text += '"';
}

void append(std::string& text, const Number& number) {
  if (number.keys.empty()) return append_number(text, number.value);
  char before = '[';
  for (const Key& key : number.keys) {
    text += before;
    append_number(text, key.frame);
    text += ':';
    append_number(text, key.value);
    before = ' ';
  }
  text += ']';
}

/// Numbers and options, the latter where they are not the default. `separator` also stands before the first one.
void append_numbers(std::string& text, const Expression& e, std::string_view separator, std::string_view first) {
  const Parameters& parameters = e.word->parameters;
  for (std::size_t i = 0; i < e.numbers.size(); ++i) {
    const bool option = i < parameters.size() && parameters[i].otherwise;
    if (option && e.numbers[i] == Number{*parameters[i].otherwise, {}}) continue;
    text += i == 0 ? first : separator;
    if (option) text += std::string(parameters[i].name) + "=";
    append(text, e.numbers[i]);
  }
}

bool is_infix(const Expression& e) { return e.word && e.word->form == Form::infix; }
bool is_primary(const Expression& e) { return !e.word || e.word->form == Form::generator; }

void append(std::string& text, const Expression& e);

void append_in(std::string& text, const Expression& e, bool parentheses) {
  if (parentheses) text += '(';
  append(text, e);
  if (parentheses) text += ')';
}

void append(std::string& text, const Expression& e) {
  if (!e.word) {
    if (is_bare(e.text) && looks_like_file(e.text) && !find_word(e.text))
      text += e.text;
    else
      append_quoted(text, e.text);
    return;
  }
  if (e.word->form == Form::generator) {
    text += std::string(e.word->name) + "(";
    append_numbers(text, e, ", ", "");
    text += ')';
    return;
  }
  append_in(text, e.inputs[0], e.word->form == Form::postfix && is_infix(e.inputs[0]));
  text += " " + std::string(e.word->name);
  if (e.word->form == Form::infix) {
    text += ' ';
    append_in(text, e.inputs[1], is_infix(e.inputs[1]));
    return;
  }
  if (!e.word->text.empty()) {
    text += ' ';
    is_bare(e.text) ? static_cast<void>(text += e.text) : append_quoted(text, e.text);
  }
  if (e.word->second) {
    text += ' ';
    append_in(text, e.inputs[1], !is_primary(e.inputs[1]));
  }
  append_numbers(text, e, " ", " ");
}

void collect(const Expression& e, std::vector<std::string>& files) {
  if (!e.word && std::find(files.begin(), files.end(), e.text) == files.end()) files.push_back(e.text);
  for (const Expression& input : e.inputs) collect(input, files);
}

}  // namespace

double Number::at(double frame) const {
  if (keys.empty()) return value;
  const auto after = std::find_if(keys.begin(), keys.end(), [&](const Key& k) { return k.frame > frame; });
  if (after == keys.begin()) return after->value;
  const Key& before = *(after - 1);
  if (after == keys.end()) return before.value;
  const double t = (frame - before.frame) / (after->frame - before.frame);
  return (1 - t) * before.value + t * after->value;
}

std::string to_text(const Expression& expression) {
  std::string text;
  append(text, expression);
  return text;
}

std::vector<std::string> files_of(const Expression& expression) {
  std::vector<std::string> files;
  collect(expression, files);
  return files;
}

}  // namespace lambert::composite

#include "lambert/image/composite/check_numbers.h"
#include "lambert/image/composite/lexer.h"

#include "lambert/base/error.h"

#include <algorithm>
#include <utility>

namespace lambert::composite {
namespace {

class Parser {
 public:
  Parser(std::string_view text, const std::string& name) : lexer_(text, name) {}

  Expression all() {
    Expression e = expression(0).tree;
    if (lexer_.token().kind != TokenKind::end) fail_behind_operand();
    return e;
  }

 private:
  struct Part {
    Expression tree;
    std::size_t depth = 1;
  };

  const Token& token() const { return lexer_.token(); }

  void expect(char sign, const std::string& why = {}) {
    if (!token().is(sign)) lexer_.fail(std::string("'") + sign + "'" + why);
    lexer_.next();
  }

  /// The word at hand if it has that form.
  const Word* word_of(Form form) const {
    if (token().kind != TokenKind::word) return nullptr;
    const Word* word = find_word(token().text);
    return word && word->form == form ? word : nullptr;
  }

  [[noreturn]] void fail_behind_operand() const {
    std::vector<std::string> known = word_names(Form::infix);
    const std::vector<std::string> postfix = word_names(Form::postfix);
    known.insert(known.end(), postfix.begin(), postfix.end());
    if (token().kind == TokenKind::word)
      lexer_.fail_at(token().at.begin, "expected an operator or the end, found " + unknown_word(token().text, known));
    lexer_.fail("an operator (over, in, mask, blur …) or the end");
  }

  void check_depth(const Part& part) const {
    if (part.depth > max_depth) lexer_.fail_at(part.tree.place, "the tree is deeper than " + std::to_string(max_depth));
  }

  Part expression(std::size_t open) {
    Part left = operand(open);
    while (const Word* word = word_of(Form::infix)) {
      const std::size_t place = lexer_.next().at.begin;
      Part right = operand(open);
      Part joined{.tree = {.word = word, .place = place}, .depth = std::max(left.depth, right.depth) + 1};
      joined.tree.inputs.reserve(2);
      joined.tree.inputs.push_back(std::move(left.tree));
      joined.tree.inputs.push_back(std::move(right.tree));
      check_depth(joined);
      left = std::move(joined);
    }
    return left;
  }

  Part operand(std::size_t open) {
    Part part = primary(open);
    while (const Word* word = word_of(Form::postfix)) {
      Part outer{.tree = {.word = word, .place = lexer_.next().at.begin}, .depth = part.depth + 1};
      outer.tree.inputs.push_back(std::move(part.tree));
      if (!word->text.empty()) outer.tree.text = name_for(*word);
      if (word->second) {
        Part second = primary(open);
        outer.depth = std::max(outer.depth, second.depth + 1);
        outer.tree.inputs.push_back(std::move(second.tree));
      }
      for (const Parameter& p : word->parameters)
        if (!p.otherwise) outer.tree.numbers.push_back(number(p));
      std::vector<std::string> given;
      while (token().kind == TokenKind::word && lexer_.following() == '=') option(outer.tree, given);
      finish(outer.tree);
      check_depth(outer);
      part = std::move(outer);
    }
    return part;
  }

  std::string name_for(const Word& word) {
    if (token().kind != TokenKind::word && token().kind != TokenKind::quoted)
      lexer_.fail("the name of a " + std::string(word.text));
    return lexer_.next().text;
  }

  Part primary(std::size_t open) {
    if (open > max_parentheses)
      lexer_.fail_at(token().at.begin, "more than " + std::to_string(max_parentheses) + " parentheses");
    if (token().is('(')) {
      lexer_.next();
      Part inner = expression(open + 1);
      if (!token().is(')')) {
        if (token().kind == TokenKind::word) fail_behind_operand();
        lexer_.fail("an operator or ')'");
      }
      lexer_.next();
      return inner;
    }
    if (token().kind == TokenKind::quoted || (token().kind == TokenKind::word && looks_like_file(token().text))) {
      if (token().text.empty()) lexer_.fail("the name of a file");
      Part file{.tree = {.place = token().at.begin}};
      file.tree.text = lexer_.next().text;
      return file;
    }
    if (const Word* word = word_of(Form::generator)) return generator(*word);
    if (token().kind == TokenKind::word && !find_word(token().text))
      lexer_.fail_at(token().at.begin, "expected a file, '(' or a generator, found " +
                                           unknown_word(token().text, word_names(Form::generator)) +
                                           "; a file without . / # or % in its name needs quotes");
    lexer_.fail("a file, '(' or a generator (colour, disk …)");
  }

  Part generator(const Word& word) {
    Part part{.tree = {.word = &word, .place = lexer_.next().at.begin}};
    std::vector<Number>& numbers = part.tree.numbers;
    expect('(', " behind " + std::string(word.name));
    const std::size_t least = required(word);
    std::vector<std::string> given;
    while (!token().is(')')) {
      if (!numbers.empty()) expect(',', " or ')'");
      if (token().kind == TokenKind::word && lexer_.following() == '=' && numbers.size() >= least) {
        option(part.tree, given);
        continue;
      }
      if (!given.empty()) lexer_.fail("')'");
      if (numbers.size() >= word.parameters.size() && !word.more)
        lexer_.fail_at(token().at.begin, "expected ')', as " + usage(word) + " has no further numbers");
      numbers.push_back(number(parameter_of(word, numbers.size())));
    }
    if (numbers.size() < least || (word.more && numbers.size() % 2 != 0))
      lexer_.fail("a further number: " + usage(word));
    lexer_.next();
    finish(part.tree);
    return part;
  }

  static std::size_t required(const Word& word) {
    return static_cast<std::size_t>(std::count_if(word.parameters.begin(), word.parameters.end(),
                                                  [](const Parameter& p) { return !p.otherwise.has_value(); }));
  }

  /// name=number, at its place among the numbers; the others without a value get their defaults.
  void option(Expression& tree, std::vector<std::string>& given) {
    const Parameters& parameters = tree.word->parameters;
    const auto found = std::find_if(parameters.begin(), parameters.end(),
                                    [&](const Parameter& p) { return p.otherwise && p.name == token().text; });
    if (found == parameters.end()) {
      std::vector<std::string> known;
      for (const Parameter& p : parameters)
        if (p.otherwise) known.emplace_back(p.name);
      lexer_.fail_at(token().at.begin,
                     std::string(tree.word->name) + " has no option " + unknown_word(token().text, known));
    }
    const auto index = static_cast<std::size_t>(found - parameters.begin());
    if ((given.empty() && index < tree.numbers.size()) ||
        std::find(given.begin(), given.end(), found->name) != given.end())
      lexer_.fail_at(token().at.begin, "'" + token().text + "' is given twice");
    given.emplace_back(found->name);
    lexer_.next();
    expect('=');
    finish(tree);
    tree.numbers[index] = number(*found);
  }

  static void finish(Expression& tree) {
    const Parameters& parameters = tree.word->parameters;
    while (tree.numbers.size() < parameters.size())
      tree.numbers.push_back({.value = *parameters[tree.numbers.size()].otherwise});
  }

  double decimal(const std::string& what) {
    if (token().kind != TokenKind::number) lexer_.fail(what);
    return lexer_.next().number;
  }

  Number number(const Parameter& parameter) {
    const std::size_t place = token().at.begin;
    const std::string what = "a number (" + std::string(parameter.name) + ")";
    Number n;
    if (token().is('[')) {
      do {
        lexer_.next();
        while (!token().is(']')) {
          if (token().is(',')) break;
          Key key{.frame = decimal("frame:value")};
          expect(':', " and the value at that frame");
          key.value = decimal("the value at that frame");
          n.keys.push_back(key);
        }
      } while (token().is(','));
      if (n.keys.empty()) lexer_.fail("frame:value");
      expect(']');
    } else {
      n.value = decimal(what);
    }
    if (const std::string fault = fault_of(n, parameter); !fault.empty()) lexer_.fail_at(place, fault);
    return n;
  }

  Lexer lexer_;
};

}  // namespace

Expression parse_expression(std::string_view text, const std::string& name) { return Parser(text, name).all(); }

}  // namespace lambert::composite

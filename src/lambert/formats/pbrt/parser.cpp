#include "lambert/formats/pbrt/parser.h"

#include "lambert/base/number.h"
#include "lambert/formats/input_file.h"
#include "lambert/formats/pbrt/directives.h"
#include "lambert/formats/pbrt/old_syntax.h"

#include <algorithm>

namespace lambert::pbrt {
namespace {

// Files that include others twice each would grow without bound even with few levels.
constexpr std::size_t max_include_depth = 64, max_files = 100000;

const Directive& find_directive(const Tokenizer& tokens, const Token& t) {
  std::vector<std::string> known;
  for (const std::span<const Directive> table : {transform_directives(), setting_directives(), world_directives()}) {
    for (const Directive& d : table) {
      if (t.text == d.name) return d;
      known.emplace_back(d.name);
    }
  }
  if (const std::string hint = old_directive_hint(t.text); !hint.empty()) tokens.fail(t, hint);
  tokens.fail(t, "unknown directive " + unknown_word(printable(t.text), known));
}

}  // namespace

void Parser::parse(std::string_view text, const std::string& name) {
  Tokenizer tokens(text, name);
  parse_directives(tokens);
  builder_.finish(tokens.place(tokens.peek()));
}

void Parser::parse_directives(Tokenizer& tokens) {
  while (tokens.peek().kind != TokenKind::end) parse_directive(tokens, tokens.next());
}

void Parser::parse_directive(Tokenizer& tokens, const Token& t) {
  if (t.kind != TokenKind::word) tokens.fail(t, "expected a directive, found " + describe(t));
  const Directive& d = find_directive(tokens, t);
  if (d.where == Where::in_world && !builder_.in_world()) {
    tokens.fail(t, std::string(d.name) + " must stand behind WorldBegin");
  }
  if (d.where == Where::before_world && builder_.in_world()) {
    tokens.fail(t, std::string(d.name) + " must stand before WorldBegin");
  }
  Call call{*this, builder_, tokens, t};
  d.handler(call);
}

void Parser::include(const std::string& file, const Place& place) {
  std::error_code ignored;
  const std::filesystem::path path = builder_.context().resolve(file);
  const std::filesystem::path canonical = std::filesystem::weakly_canonical(path, ignored);
  if (std::find(open_files_.begin(), open_files_.end(), canonical) != open_files_.end()) {
    throw Error(place, "'" + file + "' includes itself");
  }
  if (open_files_.size() >= max_include_depth || ++files_read_ > max_files) {
    throw Error(place, "too many files include each other");
  }
  const InputFile content = [&] {
    try {
      return InputFile(path);
    } catch (const Error& e) {
      throw Error(place, e.what());
    }
  }();
  open_files_.push_back(canonical);
  Tokenizer tokens(content.text(), path.string());
  parse_directives(tokens);
  open_files_.pop_back();
}

}  // namespace lambert::pbrt

#pragma once
#include "lambert/formats/pbrt/builder.h"

#include <cstddef>
#include <filesystem>
#include <string_view>
#include <vector>

namespace lambert::pbrt {

/// Reads the directives of a text and of the files that it includes.
class Parser {
 public:
  explicit Parser(Builder& builder) : builder_(builder) {}
  /// `name` stands for the text in messages.
  void parse(std::string_view text, const std::string& name);
  /// `file` is relative to the scene's folder. Throws Error at `place` when it includes itself.
  void include(const std::string& file, const Place& place);

 private:
  void parse_directives(Tokenizer& tokens);
  void parse_directive(Tokenizer& tokens, const Token& t);

  Builder& builder_;
  std::vector<std::filesystem::path> open_files_;
  std::size_t files_read_ = 0;
};

}  // namespace lambert::pbrt

#pragma once
#include "lambert/image/composite/elements.h"
#include "lambert/image/composite/expression.h"

#include <functional>
#include <string>

namespace lambert::composite {

/// The file that stands for a name in the expression at a frame (a number may be between two frames).
using FileAtFrame = std::function<std::string(const std::string& name, double frame)>;

/// The elements of a tree at a frame. Reads the headers of its files; Throws Error naming what is wrong with a file, or
/// "text:line:column: …" of what the expression asks for in vain.
ElementPtr plan(const Expression& expression, double frame, const FileAtFrame& file, const Wanted& wanted,
                Pictures& pictures, std::string_view text, const std::string& name);

}  // namespace lambert::composite

#pragma once
#include "lambert/image/composite/expression.h"

#include <string>
#include <string_view>
#include <vector>

namespace lambert::composite {

/// "1-48", "1-48x2" (every second), "7", "48-1", and several of these parted by commas. Throws Error naming the word;
/// at most 100,000 frames.
std::vector<int> parse_frames(std::string_view text);

/// True for names with "####" (as many digits at least) or "%04d" in their last part.
bool has_frame_pattern(std::string_view name);
/// The name with the pattern filled in; other names as they are.
std::string name_at_frame(std::string_view name, int frame);

struct FileAt {
  std::string pattern;
  std::string file;
};
/// The files that are read at a frame, "frame" of the expression applied, which rounds to whole frames.
std::vector<FileAt> files_at(const Expression& expression, double frame);
/// Throws Error naming the first file of these that does not exist, with its pattern and frame.
void check_files(const Expression& expression, const std::vector<int>& frames);

}  // namespace lambert::composite

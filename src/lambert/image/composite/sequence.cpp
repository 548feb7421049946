#include "lambert/image/composite/sequence.h"

#include "lambert/base/error.h"
#include "lambert/base/number.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <optional>

namespace lambert::composite {
namespace {

constexpr std::size_t most_frames = 100'000;
constexpr std::int64_t last_frame = 1'000'000'000;

struct Pattern {
  std::size_t begin, end, digits;
};

/// The last one of the name.
std::optional<Pattern> find_pattern(std::string_view name) {
  const std::size_t part = name.rfind('/') == std::string_view::npos ? 0 : name.rfind('/') + 1;
  std::optional<Pattern> found;
  for (std::size_t i = part; i < name.size();) {
    if (name[i] == '#') {
      std::size_t end = i;
      while (end < name.size() && name[end] == '#') ++end;
      found = {i, end, end - i};
      i = end;
    } else if (name[i] == '%') {
      std::size_t end = i + 1, digits = 0;
      while (end < name.size() && name[end] >= '0' && name[end] <= '9' && digits < 100)
        digits = digits * 10 + static_cast<std::size_t>(name[end++] - '0');
      if (end < name.size() && name[end] == 'd') found = {i, end + 1, digits};
      i = end;
    } else {
      ++i;
    }
  }
  return found;
}

void collect(const Expression& e, double frame, std::vector<FileAt>& files) {
  if (!e.word) files.push_back({e.text, name_at_frame(e.text, static_cast<int>(std::lround(frame)))});
  const bool elsewhen = e.word && e.word->verb == Verb::frame;
  for (const Expression& input : e.inputs) collect(input, elsewhen ? e.numbers[0].at(frame) : frame, files);
}

/// A frame at the start of `text`, which is cut off.
int take_frame(std::string_view& text, std::string_view all) {
  std::int64_t value = 0;
  const char* end = parse_int(text.data(), text.data() + text.size(), value);
  if (!end || std::abs(value) > last_frame)
    throw Error("frames: expected FIRST-LAST or FIRST-LASTxSTEP, got '" + printable(all) + "'");
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return static_cast<int>(value);
}

bool take(std::string_view& text, char c) {
  if (text.empty() || text[0] != c) return false;
  text.remove_prefix(1);
  return true;
}

}  // namespace

std::vector<int> parse_frames(std::string_view text) {
  std::vector<int> frames;
  std::string_view rest = text;
  do {
    const int first = take_frame(rest, text);
    const int last = take(rest, '-') ? take_frame(rest, text) : first;
    const int step = take(rest, 'x') ? take_frame(rest, text) : 1;
    if (step < 1) throw Error("frames: expected a step from 1, got '" + printable(text) + "'");
    const int direction = last >= first ? 1 : -1;
    for (std::int64_t f = first; direction * (last - f) >= 0; f += std::int64_t{direction} * step) {
      if (frames.size() == most_frames) throw Error("frames: more than " + std::to_string(most_frames));
      frames.push_back(static_cast<int>(f));
    }
  } while (take(rest, ','));
  if (!rest.empty()) throw Error("frames: expected ',' or the end, found '" + printable(rest) + "'");
  return frames;
}

bool has_frame_pattern(std::string_view name) { return find_pattern(name).has_value(); }

std::string name_at_frame(std::string_view name, int frame) {
  const std::optional<Pattern> pattern = find_pattern(name);
  if (!pattern) return std::string(name);
  std::string digits = std::to_string(std::abs(static_cast<std::int64_t>(frame)));
  if (digits.size() < pattern->digits) digits.insert(0, pattern->digits - digits.size(), '0');
  if (frame < 0) digits.insert(0, 1, '-');
  return std::string(name.substr(0, pattern->begin)) + digits + std::string(name.substr(pattern->end));
}

std::vector<FileAt> files_at(const Expression& expression, double frame) {
  std::vector<FileAt> files;
  collect(expression, frame, files);
  return files;
}

void check_files(const Expression& expression, const std::vector<int>& frames) {
  for (const int frame : frames)
    for (const FileAt& f : files_at(expression, frame)) {
      std::error_code ignored;
      if (f.file == "-" || std::filesystem::exists(f.file, ignored)) continue;
      const bool one_of_many = has_frame_pattern(f.pattern);
      throw Error(f.file + ": there is no such file" +
                  (one_of_many ? " (" + f.pattern + " at frame " + std::to_string(frame) + ")" : ""));
    }
}

}  // namespace lambert::composite

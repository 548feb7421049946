#include "lambert/base/error.h"

#include <algorithm>
#include <numeric>

namespace lambert {
namespace {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({substituted, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string SourceLocation::to_string() const {
  std::string s = file;
  if (line) s += ":" + std::to_string(line);
  if (line && column) s += ":" + std::to_string(column);
  return s;
}

Error::Error(const SourceLocation& where, const std::string& message)
    : std::runtime_error(where.file.empty() ? message : where.to_string() + ": " + message) {}

std::string unknown_word(std::string_view word, const std::vector<std::string>& allowed) {
  // A hostile word must not make the message long.
  const std::string shown(word.substr(0, 60));
  std::string s = "'" + shown + "'";
  const auto nearest = std::min_element(allowed.begin(), allowed.end(), [&](const auto& a, const auto& b) {
    return edit_distance(shown, a) < edit_distance(shown, b);
  });
  const std::size_t slips = shown.size() <= 3 ? 1 : 2;
  if (nearest != allowed.end() && edit_distance(shown, *nearest) <= slips) s += "; did you mean '" + *nearest + "'?";
  if (allowed.empty()) return s;
  s += " (known: ";
  for (std::size_t i = 0; i < allowed.size(); ++i) s += (i ? ", " : "") + allowed[i];
  return s + ")";
}

}  // namespace lambert

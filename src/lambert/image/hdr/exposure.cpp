#include "lambert/image/hdr/exposure.h"

#include "lambert/base/error.h"
#include "lambert/base/file.h"
#include "lambert/base/lines.h"
#include "lambert/base/number.h"

#include <cmath>
#include <optional>

namespace lambert::hdr {
namespace {

/// The whole of `word` as a number, or a fraction of two.
std::optional<double> number_or_fraction(std::string_view word) {
  const char* const end = word.data() + word.size();
  double value = 0;
  const char* p = parse_double(word.data(), end, value);
  if (p && p != end && *p == '/') {
    double below = 0;
    p = parse_double(p + 1, end, below);
    value /= below;
  }
  if (!p || p != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  constexpr std::string_view blanks = " \t\r,;";
  for (std::size_t at = line.find_first_not_of(blanks); at != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(blanks, end);
  }
  return words;
}

constexpr const char* time_expected = "expected an exposure time in seconds above 0, such as 1/60 or 0.5, got '";

double positive(std::string_view word, const SourceLocation& where, const char* expected) {
  const std::optional<double> value = number_or_fraction(word);
  if (!value || *value <= 0) throw Error(where, expected + printable(word) + "'");
  return *value;
}

ListedExposure parse_line(const std::vector<std::string_view>& words, bool hdrgen, const SourceLocation& where) {
  if (words.size() < 2)
    throw Error(where, "expected a file and its exposure time, got only '" + printable(words[0]) + "'");
  if (words.size() > 5) throw Error(where, "expected at most 5 words, got " + std::to_string(words.size()));
  ListedExposure e;
  e.file = std::filesystem::path(std::string(words[0]));
  const double second = positive(words[1], where, time_expected);
  e.setting.time = hdrgen ? 1 / second : second;
  if (words.size() > 2) e.setting.f_number = positive(words[2], where, "expected an f-number above 0, got '");
  if (words.size() > 3) e.setting.iso = positive(words[3], where, "expected an ISO speed above 0, got '");
  if (words.size() > 4) {
    const std::optional<double> density = number_or_fraction(words[4]);
    if (!density || std::abs(*density) > 30)
      throw Error(where, "expected the density of a filter, got '" + printable(words[4]) + "'");
    e.setting.density = *density;
  }
  return e;
}

}  // namespace

double relative_exposure(const ExposureSetting& s) {
  const double n = s.f_number > 0 ? s.f_number : 1;
  return s.time * (s.iso > 0 ? s.iso / 100 : 1) / (n * n) * std::pow(10.0, -s.density);
}

double parse_exposure_time(std::string_view word, const std::string& what) {
  if (word.ends_with('s')) word.remove_suffix(1);
  const std::optional<double> value = number_or_fraction(word);
  if (!value || *value <= 0) throw Error(what + ": " + time_expected + printable(word) + "'");
  return *value;
}

std::vector<ListedExposure> read_exposure_list(const std::filesystem::path& path) {
  const MappedFile file(path);
  const bool hdrgen = path.extension() == ".hdrgen";
  std::vector<ListedExposure> list;
  for_lines(file.text(), [&](std::string_view line, std::size_t number) {
    const std::vector<std::string_view> words = words_of(line.substr(0, line.find('#')));
    if (words.empty()) return;
    ListedExposure e = parse_line(words, hdrgen, {path.string(), number});
    if (e.file.is_relative()) e.file = path.parent_path() / e.file;
    list.push_back(std::move(e));
  });
  if (list.empty()) throw Error(path.string() + ": lists no photographs");
  return list;
}

std::vector<double> relative_exposures(const std::vector<std::string>& names,
                                       const std::vector<ExposureSetting>& settings) {
  std::vector<double> exposures;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    const ExposureSetting& s = settings[i];
    if (s.time <= 0)
      throw Error(names[i] + ": its exposure time is not known: no EXIF data says it; give --times, --stops or --list");
    const auto same_kind = [&](double first, double value, const char* what) {
      if ((first > 0) == (value > 0)) return;
      const std::string& without = value > 0 ? names[0] : names[i];
      throw Error(without + ": has no " + what + " but " + (value > 0 ? names[i] : names[0]) +
                  " has: give the exposures with --times, --stops or --list");
    };
    same_kind(settings[0].f_number, s.f_number, "f-number");
    same_kind(settings[0].iso, s.iso, "ISO speed");
    exposures.push_back(relative_exposure(s));
  }
  return exposures;
}

}  // namespace lambert::hdr

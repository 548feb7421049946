#include "lambert/base/error.h"
#include "lambert/base/file.h"
#include "lambert/base/lines.h"
#include "lambert/base/number.h"
#include "lambert/image/hdr/response.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lambert::hdr {
namespace {

struct Row {
  double key = 0;
  std::array<double, 3> value{};
};

Row parse_row(std::string_view line, const SourceLocation& where, std::size_t& columns) {
  std::vector<double> numbers;
  const char *p = line.data(), *const end = p + line.size();
  const auto skip = [&] {
    while (p != end && (*p == ' ' || *p == ',' || *p == ';' || *p == '\t' || *p == '\r')) ++p;
  };
  for (skip(); p != end; skip()) {
    double number = 0;
    const char* next = parse_double(p, end, number);
    if (!next)
      throw Error({where.file, where.line, static_cast<std::size_t>(p - line.data()) + 1},
                  "expected a number, got '" + printable(std::string_view(p, end)) + "'");
    numbers.push_back(number);
    p = next;
  }
  if (numbers.size() != 2 && numbers.size() != 4)
    throw Error(where, "expected two or four numbers, got " + std::to_string(numbers.size()));
  if (columns != 0 && columns != numbers.size())
    throw Error(where, "expected " + std::to_string(columns) + " numbers as in the rows before");
  columns = numbers.size();
  Row row{.key = numbers[0]};
  for (std::size_t c = 0; c < 3; ++c) row.value[c] = numbers[columns == 2 ? 1 : c + 1];
  return row;
}

std::vector<Row> read_rows(const std::filesystem::path& path) {
  const MappedFile file(path);
  std::vector<Row> rows;
  std::size_t columns = 0;
  for_lines(file.text(), [&](std::string_view line, std::size_t number) {
    line = line.substr(0, line.find('#'));
    if (line.find_first_not_of(" \t\r,;") == std::string_view::npos) return;
    const SourceLocation where{path.string(), number};
    const Row row = parse_row(line, where, columns);
    if (row.key < 0 || row.value[0] < 0 || row.value[1] < 0 || row.value[2] < 0)
      throw Error(where, "expected numbers of 0 or above");
    if (!rows.empty() && row.key <= rows.back().key) throw Error(where, "expected the first column to climb");
    for (std::size_t c = 0; c < 3 && !rows.empty(); ++c)
      if (row.value[c] < rows.back().value[c]) throw Error(where, "expected no column to fall");
    rows.push_back(row);
    if (rows.size() > 65536) throw Error(where, "expected at most 65536 rows");
  });
  if (rows.size() < 2) throw Error(path.string() + ": expected at least two rows of a response");
  return rows;
}

/// Linear between rows, from column to column; flat outside.
template <class X, class Y>
double interpolate(const std::vector<Row>& rows, double at, X x, Y y) {
  const auto above =
      std::upper_bound(rows.begin(), rows.end(), at, [&](double value, const Row& row) { return value < x(row); });
  if (above == rows.begin()) return y(rows.front());
  if (above == rows.end()) return y(rows.back());
  const Row &low = *(above - 1), &high = *above;
  return y(low) + (y(high) - y(low)) * (at - x(low)) / (x(high) - x(low));
}

double key(const Row& row) { return row.key; }

}  // namespace

Response read_response(const std::filesystem::path& path, std::size_t channels, std::size_t levels) {
  const std::vector<Row> rows = read_rows(path);
  const bool by_code = rows.back().key > 1;
  Response r{.name = path.filename().string()};
  for (std::size_t c = 0; c < channels; ++c) {
    const auto value = [c](const Row& row) { return row.value[c]; };
    const double top = value(rows.back());
    if (!(top > value(rows.front()))) throw Error(path.string() + ": a response that is the same everywhere");
    if (!by_code && top > 1) throw Error(path.string() + ": expected pixel values of at most 1");
    std::vector<float>& table = r.exposure.emplace_back(levels);
    for (std::size_t i = 0; i < levels; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(levels - 1);
      table[i] = static_cast<float>(by_code ? interpolate(rows, share * rows.back().key, key, value) / top
                                            : interpolate(rows, share, value, key) / rows.back().key);
    }
    table.back() = 1;
  }
  return r;
}

std::string response_csv(const Response& r, ResponseTable table) {
  const double top = static_cast<double>(r.levels() - 1);
  std::string text = table == ResponseTable::by_code ? "# code, exposure behind it (1 at the top code): r, g, b\n"
                                                     : "# exposure_L_times_t, r, g, b (0..1)\n";
  const auto put = [&](double first, auto value) {
    append_number(text, static_cast<float>(first));
    for (std::size_t c = 0; c < 3; ++c) text += ",", append_number(text, static_cast<float>(value(r.channel(c))));
    text += "\n";
  };
  if (table == ResponseTable::by_code) {
    for (std::size_t i = 0; i < r.levels(); ++i)
      put(static_cast<double>(i), [i](const auto& channel) { return channel[i]; });
    return text;
  }
  std::vector<double> exposures{0};
  for (int k = 1; k <= 256; ++k) exposures.push_back(k / 256.0);
  for (int k = 4 * 16 + 1; k <= 16 * 16; ++k) exposures.push_back(std::exp2(-k / 16.0));
  std::sort(exposures.begin(), exposures.end());
  exposures.erase(std::unique(exposures.begin(), exposures.end()), exposures.end());
  for (const double x : exposures) put(x, [&](const auto& channel) { return encode(channel, x) / top; });
  return text;
}

}  // namespace lambert::hdr

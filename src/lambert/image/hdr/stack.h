#pragma once
/// Photographs of one scene, exposed differently.

#include "lambert/base/progress.h"
#include "lambert/base/vec.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace lambert::hdr {

struct Span {
  int begin = 0, end = 0;
  bool operator==(const Span&) const = default;
};

/// Bytes for 256 levels, words for more.
using Codes = std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>>;

/// One photograph: the codes of its file as they are, rows from the top, channels interleaved.
struct Frame {
  std::string name;
  double exposure = 1;  ///< relative_exposure()
  Codes codes;
  /// Of each row the columns that the photograph covers, when it was moved; empty: all.
  std::vector<Span> covered;
};

/// In order of exposure, the darkest first.
struct ExposureStack {
  int width = 0, height = 0;
  std::size_t channels = 3;  ///< 1 or 3
  int levels = 256;          ///< codes are 0 … levels - 1: 256 or 65536
  std::vector<Frame> frames;

  std::size_t row_size() const { return static_cast<std::size_t>(width) * channels; }
  /// Every so many rows have about `values` codes.
  std::size_t row_step(std::size_t values) const {
    return std::max<std::size_t>(1, static_cast<std::size_t>(height) * row_size() / values);
  }
  /// body(std::uint8_t()) or body(std::uint16_t()): the type of the codes, for codes<>() and row<>().
  template <class Body>
  decltype(auto) with_code_type(const Body& body) const {
    return levels <= 256 ? body(std::uint8_t{}) : body(std::uint16_t{});
  }
  template <class Code>
  std::span<const Code> codes(std::size_t frame) const {
    return std::get<std::vector<Code>>(frames[frame].codes);
  }
  template <class Code>
  const Code* row(std::size_t frame, int y) const {
    return codes<Code>(frame).data() + static_cast<std::size_t>(y) * row_size();
  }
  Span covered(std::size_t frame, int y) const {
    const auto& c = frames[frame].covered;
    return c.empty() ? Span{0, width} : c[static_cast<std::size_t>(y)];
  }
};

/// Reads PNG, JPEG, TIFF and WebP files of 8 or 16 bits; grey ones stay grey, alpha is dropped. Photographs of 8 bits
/// among some of 16 are taken times 257. Throws Error naming the file that cannot be used: another size, other
/// channels, a radiance format.
ExposureStack read_stack(const std::vector<std::string>& files, const std::vector<double>& exposures,
                         const FractionSink& progress = {});

/// Sorts by exposure. Throws Error with the reason where the exposures cannot be right: all equal (nearer than 1 %), or
/// a longer exposure that is not brighter.
void check_exposures(ExposureStack& stack);

}  // namespace lambert::hdr

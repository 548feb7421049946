#include "stress/boolean_case.h"

#include "lambert/polygon/boolean/valid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace lambert::polygon {
namespace {

class Bytes {
 public:
  explicit Bytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  bool empty() const { return bytes_.empty(); }
  /// 0 when there are none left.
  unsigned next() {
    if (bytes_.empty()) return 0;
    const unsigned byte = bytes_.front();
    bytes_ = bytes_.subspan(1);
    return byte;
  }
  unsigned below(unsigned limit) { return next() % limit; }
  /// In [-1, 1).
  double real() {
    std::uint64_t bits = 0;
    for (int i = 0; i < 4; ++i) bits = bits << 8 | next();
    return static_cast<double>(bits) * 0x1p-31 - 1;
  }

 private:
  std::span<const std::uint8_t> bytes_;
};

struct Manner {
  unsigned kind, grid, scale;
};

double coordinate(Bytes& bytes, const Manner& manner) {
  const auto cell = [&] { return static_cast<double>(bytes.below(manner.grid)); };
  switch (manner.kind) {
    case 0: return cell();
    case 1: return cell() * 0.1 + 1e6;  // 0.1 is no double: almost a grid
    case 2: {
      double x = cell() / 3;
      for (unsigned steps = bytes.below(4); steps > 0; --steps) x = std::nextafter(x, 10);
      return x;
    }
    case 3: return bytes.real();
    case 4: return cell() + 0x1p-45 * bytes.real();
    default: return bytes.below(4) == 0 ? bytes.real() : cell();
  }
}

double scale_of(Bytes& bytes, const Manner& manner) {
  constexpr std::array<double, 8> scales{1, 1, 1, 1e-150, 1e150, 1e-300, 1e-320, 1};
  constexpr std::array<double, 8> mixed{1, 1e-150, 1e150, 1e-8, 1e8, 1e-300, 0x1p-52, 1e-320};
  return manner.scale < scales.size() ? scales[manner.scale] : mixed[bytes.below(mixed.size())];
}

Rings decode_rings(Bytes& bytes, const Manner& manner) {
  Rings rings;
  const unsigned count = 1 + bytes.below(3) / 2 + bytes.below(4) / 3;
  for (unsigned r = 0; r < count; ++r) {
    Ring& ring = rings.emplace_back();
    const unsigned size = bytes.below(7) + 3 - (bytes.below(16) == 0 ? 2 : 0);
    while (ring.size() < size) {
      const unsigned choice = bytes.below(16);
      if (choice == 0 && !ring.empty()) {
        ring.push_back(ring[bytes.below(static_cast<unsigned>(ring.size()))]);
      } else if (choice == 1 && ring.size() > 1) {
        const Vec2d a = ring[ring.size() - 2], b = ring.back();  // on the line of the last edge, or almost
        ring.push_back(a + 0.25 * static_cast<double>(bytes.below(9)) * (b - a));
      } else if (choice == 2 && rings.size() > 1) {
        ring.push_back(rings.front()[bytes.below(static_cast<unsigned>(rings.front().size()))]);
      } else {
        const double scale = scale_of(bytes, manner);
        const double x = coordinate(bytes, manner) * scale;
        ring.emplace_back(x, coordinate(bytes, manner) * scale);
      }
    }
  }
  return rings;
}

double extent(const BooleanCase& input) {
  double largest = 0;
  for (const Rings* rings : {&input.subject, &input.clip}) {
    for (const Ring& ring : *rings) {
      for (const Vec2d p : ring) largest = std::max(largest, std::max(std::abs(p.x), std::abs(p.y)));
    }
  }
  return largest;
}

}  // namespace

BooleanCase decode_case(std::span<const std::uint8_t> data) {
  Bytes bytes(data);
  BooleanCase result;
  result.rule = static_cast<FillRule>(bytes.below(4));
  const Manner manner{bytes.below(6), 2 + bytes.below(7), bytes.below(11)};
  result.subject = decode_rings(bytes, manner);
  result.clip = decode_rings(bytes, manner);
  if (bytes.below(8) == 0 && !result.clip.empty()) result.clip.front() = result.subject.front();
  return result;
}

std::string find_fault(const BooleanCase& input) {
  constexpr std::array operations{BooleanOp::unite, BooleanOp::intersect, BooleanOp::subtract, BooleanOp::exclude};
  constexpr std::array names{"union", "intersection", "difference", "xor"};
  const double size = extent(input), unit = size > 0 ? 1 / size : 1;
  std::array<double, 4> areas{};
  for (std::size_t i = 0; i < operations.size(); ++i) {
    const std::string name = names[i];
    const Regions result = boolean(operations[i], input.subject, input.clip, input.rule);
    if (const auto invalid = check_valid(result)) return name + " is invalid: " + invalid->message();
    if (normalised(rings_of(result)) != result) return name + " is not normal";
    if (operations[i] != BooleanOp::subtract && boolean(operations[i], input.clip, input.subject, input.rule) != result)
      return name + " is not symmetric";
    for (const Region& region : result) {
      for (Ring ring : rings_of(region)) {
        for (Vec2d& p : ring) p = std::isfinite(unit) ? p * unit : Vec2d(std::ldexp(p.x, 1000), std::ldexp(p.y, 1000));
        areas[i] += signed_area(ring);
      }
    }
  }
  const double subject = area(normalised(input.subject, input.rule)) * unit * unit;
  if (std::abs(areas[3] - (areas[0] - areas[1])) > 1e-9) return "xor is not union less intersection";
  if (size > 1e-140 && std::abs(areas[1] + areas[2] - subject) > 1e-9)
    return "intersection and difference do not add up";
  return {};
}

std::string to_code(const BooleanCase& input) {
  std::string code = "rule " + std::to_string(static_cast<int>(input.rule));
  for (const Rings* rings : {&input.subject, &input.clip}) {
    code += "\n{";
    for (const Ring& ring : *rings) {
      code += "{";
      for (const Vec2d p : ring) {
        std::array<char, 80> text{};
        std::snprintf(text.data(), text.size(), "{%a, %a}, ", p.x, p.y);
        code += text.data();
      }
      code += "},\n ";
    }
    code += "}";
  }
  return code + "\n";
}

}  // namespace lambert::polygon

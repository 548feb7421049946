#include "lambert/image/probe/suns.h"

#include "lambert/image/probe/linear_radiance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <unordered_map>

namespace lambert::probe {
namespace {

class Finder {
 public:
  Finder(Probe& sky, const SunSettings& settings) : sky_(sky), settings_(settings), measure_(texel_measure(sky)) {}

  std::optional<Sun> take_brightest() {
    const Texel peak = brightest();
    const float top = luminance(at(peak));
    if (!(top > 0)) return std::nullopt;
    const std::vector<Texel> disk = connected(peak, settings_.threshold * top);
    if (disk.empty()) return std::nullopt;
    double mean = 0, solid_angle = 0, all = 0;
    for_each([&](const Texel& t) {
      mean += static_cast<double>(luminance(at(t)) * omega(t)), all += static_cast<double>(omega(t));
    });
    for (const Texel& t : disk) {
      mean -= static_cast<double>(luminance(at(t)) * omega(t)), solid_angle += static_cast<double>(omega(t));
    }
    mean /= std::max(all - solid_angle, 1e-6);
    if (!(static_cast<double>(top) > static_cast<double>(settings_.contrast) * mean)) return std::nullopt;
    return take(disk, top, solid_angle);
  }

 private:
  template <class F>
  void for_each(const F& f) const {
    for (int c = 0; c < static_cast<int>(sky_.charts.size()); ++c)
      for (int y = 0; y < sky_.height(); ++y)
        for (int x = 0; x < sky_.width(); ++x) f(Texel{c, x, y});
  }
  Rgb at(const Texel& t) const { return sky_.charts[static_cast<std::size_t>(t.chart)].rgb(t.x, t.y); }
  float omega(const Texel& t) const {
    return measure_.solid_angle[static_cast<std::size_t>(t.y) * static_cast<std::size_t>(sky_.width()) +
                                static_cast<std::size_t>(t.x)];
  }
  std::size_t key(const Texel& t) const {
    return (static_cast<std::size_t>(t.chart) * static_cast<std::size_t>(sky_.height()) +
            static_cast<std::size_t>(t.y)) *
               static_cast<std::size_t>(sky_.width()) +
           static_cast<std::size_t>(t.x);
  }

  Texel brightest() const {
    Texel best{0, 0, 0};
    float top = -1;
    for_each([&](const Texel& t) {
      if (const float l = luminance(at(t)); l > top && omega(t) > 0) top = l, best = t;
    });
    return best;
  }

  /// What is connected to `from` by sides of texels and at least as bright; empty when it is too large for a sun.
  std::vector<Texel> connected(const Texel& from, float low) const {
    std::vector<Texel> found{from};
    std::unordered_map<std::size_t, bool> seen{{key(from), true}};
    float solid_angle = omega(from);
    if (solid_angle > settings_.largest) return {};
    for (std::size_t i = 0; i < found.size(); ++i)
      for (const Vec2i step : {Vec2i(1, 0), Vec2i(-1, 0), Vec2i(0, 1), Vec2i(0, -1)}) {
        const auto n = neighbour(sky_, found[i], step);
        if (!n || seen.contains(key(*n)) || !(luminance(at(*n)) >= low) || !(omega(*n) > 0)) continue;
        seen[key(*n)] = true;
        found.push_back(*n);
        if ((solid_angle += omega(*n)) > settings_.largest) return {};
      }
    return found;
  }

  /// ∫ L d dω over the texels, of r, g, b.
  std::array<Vec3d, 3> moments_of(const std::vector<Texel>& texels) const {
    std::array<Vec3d, 3> sum{};
    for (const Texel& t : texels) {
      const auto moments = radiance_moments(sky_, t);
      for (std::size_t k = 0; k < 3; ++k) sum[k] += moments[k];
    }
    return sum;
  }

  std::vector<Texel> touched_by(const std::vector<Texel>& disk) const {
    std::vector<Texel> touched;
    for (const Texel& t : disk) add_touched(sky_, t, touched);
    std::sort(touched.begin(), touched.end(), [&](const Texel& a, const Texel& b) { return key(a) < key(b); });
    const auto same = [&](const Texel& a, const Texel& b) { return key(a) == key(b); };
    touched.erase(std::unique(touched.begin(), touched.end(), same), touched.end());
    return touched;
  }

  Sun take(const std::vector<Texel>& disk, float top, double solid_angle) {
    const std::vector<Texel> touched = touched_by(disk);
    const auto before = moments_of(touched);
    Vec3d radiance(0);
    for (const Texel& t : disk) radiance += Vec3d(at(t).r, at(t).g, at(t).b) * static_cast<double>(omega(t));
    fill(disk);
    const auto after = moments_of(touched);
    std::array<Vec3d, 3> moment;
    for (std::size_t k = 0; k < 3; ++k) moment[k] = before[k] - after[k];
    const Vec3d towards = 0.2126 * moment[0] + 0.7152 * moment[1] + 0.0722 * moment[2];
    const double size = length(towards);
    const Vec3d axis = size > 0 ? towards / size : Vec3d(0);
    const auto rgb = [](Vec3d v) {
      return Rgb(static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z));
    };
    Sun sun;
    if (size > 0) sun.direction = Vec3(axis);
    sun.irradiance = rgb({dot(moment[0], axis), dot(moment[1], axis), dot(moment[2], axis)});
    sun.radiance = rgb(radiance / std::max(solid_angle, 1e-12));
    sun.solid_angle = static_cast<float>(solid_angle);
    // ω = 2π (1 - cos r)
    sun.angular_radius =
        static_cast<float>(2 * std::asin(std::sqrt(std::min(1.0, solid_angle / (4 * std::numbers::pi)))));
    sun.peak = top;
    return sun;
  }

  /// Each texel the mean of its four neighbours, from the mean of the rim on.
  void fill(const std::vector<Texel>& disk) {
    std::unordered_map<std::size_t, std::size_t> index;
    for (std::size_t i = 0; i < disk.size(); ++i) index[key(disk[i])] = i;
    struct Sides {
      std::vector<std::size_t> inner;
      Rgb outer;
      float count = 0;
    };
    std::vector<Sides> sides(disk.size());
    Rgb rim;
    float rim_count = 0;
    for (std::size_t i = 0; i < disk.size(); ++i)
      for (const Vec2i step : {Vec2i(1, 0), Vec2i(-1, 0), Vec2i(0, 1), Vec2i(0, -1)}) {
        const auto n = neighbour(sky_, disk[i], step);
        if (!n) continue;
        if (const auto found = index.find(key(*n)); found != index.end()) {
          sides[i].inner.push_back(found->second);
        } else {
          const Rgb c = at(*n);
          sides[i].outer += c, rim += c, ++rim_count;
        }
        ++sides[i].count;
      }
    std::vector<Rgb> value(disk.size(), rim_count > 0 ? rim / rim_count : Rgb()), next = value;
    for (int sweep = 0; sweep < 200; ++sweep) {
      for (std::size_t i = 0; i < disk.size(); ++i) {
        Rgb sum = sides[i].outer;
        for (const std::size_t k : sides[i].inner) sum += value[k];
        if (sides[i].count > 0) next[i] = sum / sides[i].count;
      }
      std::swap(value, next);
    }
    for (std::size_t i = 0; i < disk.size(); ++i) {
      Image& image = sky_.charts[static_cast<std::size_t>(disk[i].chart)];
      const Rgb old = at(disk[i]);
      const Rgb filled(std::min(value[i].r, old.r), std::min(value[i].g, old.g), std::min(value[i].b, old.b));
      if (image.has_colour())
        image.set_rgb(disk[i].x, disk[i].y, filled);
      else
        image.at(disk[i].x, disk[i].y, 0) = filled.r;
    }
  }

  Probe& sky_;
  SunSettings settings_;
  TexelMeasure measure_;
};

}  // namespace

SunsAndSky separate_suns(const Probe& probe, const SunSettings& settings) {
  SunsAndSky result{{}, probe};
  Finder finder(result.sky, settings);
  for (int i = 0; i < settings.most; ++i) {
    const auto sun = finder.take_brightest();
    if (!sun) break;
    result.suns.push_back(*sun);
  }
  std::stable_sort(result.suns.begin(), result.suns.end(),
                   [](const Sun& a, const Sun& b) { return luminance(a.irradiance) > luminance(b.irradiance); });
  return result;
}

}  // namespace lambert::probe

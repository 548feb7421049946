#pragma once
#include "lambert/base/rgb.h"
#include "lambert/base/vec.h"
#include "lambert/image/image.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace lambert {

/// A rectangle of pixels: min inclusive, max exclusive.
struct PixelRect {
  Vec2i min{0}, max{0};
  Vec2i size() const { return max - min; }
  std::size_t area() const { return static_cast<std::size_t>(size().x) * static_cast<std::size_t>(size().y); }
  bool operator==(const PixelRect&) const = default;
};

/// What a film keeps beside radiance.
enum class Aov : std::uint8_t {
  albedo,
  normal,
  depth,
  position,
  object_id,
  sample_count,
  variance,
  denoising  ///< what image/denoise wants: colour and guides of two halves of the samples, and the colour's variance
};
Aov aov(std::string_view name);  ///< throws Error for an unknown name
std::vector<std::string> aov_names();

/// What a denoiser is guided by: the first surface that scatters diffusely or glossily, seen through mirrors and panes.
struct Guide {
  Rgb emission;  ///< the part of the sample's radiance that lamps and sky send here without any such surface
  Rgb albedo;    ///< times what mirrors and glass on the way let through; black in the sky
  Vec3 normal{0};
  float distance = 0;  ///< along the path; 0 in the sky
};

/// The first surface that a camera ray meets.
struct Features {
  Rgb albedo;
  Vec3 normal{0};
  Vec3 position{0};
  float depth = 0;           ///< along the camera's axis; 0 where nothing is hit
  std::uint32_t object = 0;  ///< 1 + index of the object; 0 where nothing is hit
  Guide guide;
};

/// One sample of one pixel, with the weight of the pixel filter.
struct FilmSample {
  Rgb radiance;
  float weight = 1;
  Features features;
};

/// Sums of samples per pixel, in double and in the order of the samples, so that the result does not depend on how they
/// were cut into passes.
class Film {
 public:
  /// `resolution` is that of the whole image, `crop` the part that is kept.
  Film(Vec2i resolution, const PixelRect& crop, std::vector<Aov> aovs);

  Vec2i resolution() const { return resolution_; }
  const PixelRect& crop() const { return crop_; }
  bool keeps_features() const { return !features_.empty(); }

  /// Of the halves of `denoising`: the first `count` samples of a pixel are one, what follows the other; 0, as it is at
  /// first: they take turns. Halves of a sequence of well-distributed points should be well distributed themselves.
  void split_halves_at(std::uint32_t count) { first_half_ = count; }

  /// The means of the guide's emission in both halves; needs the layer `denoising`.
  std::array<Rgb, 2> emission(Vec2i pixel) const;
  bool keeps_denoising() const { return !denoising_.empty(); }
  /// One more sample of the guide's emission alone. Thread-safety is that of add().
  void add_emission(Vec2i pixel, std::size_t half, Rgb emission, float weight);

  /// Not thread-safe for one pixel; different pixels may be added to from different threads.
  void add(Vec2i pixel, const FilmSample& sample);
  std::uint32_t sample_count(Vec2i pixel) const { return pixels_[index(pixel)].count; }
  /// By the filter's weights; where those of a few samples cancel, without them. Black where there is no sample.
  Rgb mean(Vec2i pixel) const;
  /// Of the mean's luminance, from the spread of the samples; infinite for fewer than 2.
  double variance_of_mean(Vec2i pixel) const;
  std::uint64_t total_samples() const;

  /// The mean of two films of the same size, half each, whatever their sample counts; of one alone where the other has
  /// nothing.
  static Film average(const Film& a, const Film& b);

  /// R, G, B and the layers asked for, cropped; black where nothing was sampled. The variance of `denoising` is
  /// infinite where there are fewer than 2 samples.
  Image develop() const;

 private:
  struct Pixel {
    double r = 0, g = 0, b = 0;
    double weight = 0;
    double luminance_squared = 0;  // of weighted samples
    Rgb unweighted{0.0f};          // the sum without the filter's weights
    std::uint32_t count = 0;

    /// Weights have mean 1 but either sign: after few samples of a filter with negative lobes their sum may vanish.
    bool has_weight() const { return weight > 0.1 * count; }
  };
  struct FeatureSums {
    Rgb albedo;
    Vec3 normal{0}, position{0};
    float depth = 0;
    std::uint32_t hits = 0, object = 0;
  };
  /// Weighted sums of N numbers a sample.
  template <std::size_t N>
  struct Sums {
    std::array<double, N> weighted{};
    std::array<float, N> unweighted{};
    double weight = 0;
    std::uint32_t count = 0;
    void add(const Sums& other);
    void add(const std::array<float, N>& values, float weight);
    /// By the weights where they do not cancel, as in Pixel.
    std::array<double, N> mean() const;
  };
  struct DenoisingSums {
    std::array<Sums<10>, 2> halves;   // radiance without the guide's emission, then albedo, normal, distance
    std::array<Sums<3>, 2> emission;  // as many samples, or more
    std::array<double, 3> squared{};  // weighted samples of the first three of `halves`
  };
  static Rgb mean_of(const Pixel& p);
  static void add_denoising(DenoisingSums& to, const FilmSample& sample, std::size_t half);
  static DenoisingSums average_denoising(const DenoisingSums& a, const DenoisingSums& b);
  void write_denoising(Image& image, std::size_t first_channel) const;

  std::size_t index(Vec2i p) const {
    const auto width = static_cast<std::size_t>(crop_.size().x);
    return static_cast<std::size_t>(p.y - crop_.min.y) * width + static_cast<std::size_t>(p.x - crop_.min.x);
  }
  void write_layer(Image& image, Aov layer, std::size_t first_channel) const;

  Vec2i resolution_;
  PixelRect crop_;
  std::vector<Aov> aovs_;
  std::vector<Pixel> pixels_;
  std::vector<FeatureSums> features_;
  std::vector<DenoisingSums> denoising_;
  std::uint32_t first_half_ = 0;
};

}  // namespace lambert

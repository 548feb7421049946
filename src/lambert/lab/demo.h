#pragma once
/// Demonstrations of sampling and of numbers for light: each makes a picture and says numbers that the picture shows.

#include "lambert/draw/drawing.h"
#include "lambert/image/image.h"

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace lambert::lab {

struct LabSettings {
  std::uint64_t seed = 1;
};

struct Shown {
  std::variant<Image, draw::Drawing> picture;  ///< an image in linear light, or a drawing that can be SVG
  std::vector<std::pair<std::string, double>> facts;
};

struct Demo {
  const char *name, *summary;
  Shown (*show)(const LabSettings&);
  bool has_drawing = false;  ///< the picture is a drawing
};

/// All of them, in the order in which they are best looked at.
const std::vector<Demo>& demos();
/// Throws Error for an unknown name.
const Demo& demo(const std::string& name);

Shown show_nyquist(const LabSettings&);
Shown show_detail(const LabSettings&);
Shown show_moire(const LabSettings&);
Shown show_comb(const LabSettings&);
Shown show_pixel(const LabSettings&);
Shown show_jitter(const LabSettings&);

Shown show_patterns(const LabSettings&);
Shown show_spectra(const LabSettings&);
Shown show_radial_spectra(const LabSettings&);
Shown show_best_candidate(const LabSettings&);
Shown show_error(const LabSettings&);

Shown show_quadrature(const LabSettings&);
Shown show_dimensions(const LabSettings&);
Shown show_inversion(const LabSettings&);
Shown show_rejection(const LabSettings&);
Shown show_disk(const LabSettings&);
Shown show_sphere(const LabSettings&);
Shown show_environment(const LabSettings&);
Shown show_noise(const LabSettings&);
Shown show_random_variable(const LabSettings&);

Shown show_precision(const LabSettings&);
Shown show_range(const LabSettings&);

}  // namespace lambert::lab

#include "lambert/lab/demo.h"

#include "lambert/base/error.h"

namespace lambert::lab {

const std::vector<Demo>& demos() {
  static const std::vector<Demo> all{
      {"nyquist", "A sine at four sample spacings, and the sine that the samples show", show_nyquist, true},
      {"detail", "Small things that one sample a pixel misses, and blurring does not bring back", show_detail},
      {"moire", "Two line patterns slid and turned over each other", show_moire},
      {"comb", "Combs of 1.01 pixels: one false tooth, or grey", show_comb},
      {"pixel", "One pixel at 3x3 regular and jittered samples", show_pixel, true},
      {"jitter", "A checkered plane at 1 and 4 samples a pixel, uniform and jittered", show_jitter},
      {"patterns", "256 points of every pattern", show_patterns},
      {"spectra", "Points and periodograms", show_spectra},
      {"radial-spectra", "Power against frequency", show_radial_spectra, true},
      {"best-candidate", "Jittered against best-candidate samples", show_best_candidate},
      {"error", "Error of an edge's coverage against the number of samples", show_error, true},
      {"random-variable", "PDF, CDF and an interval's probability; means and how they add up", show_random_variable,
       true},
      {"quadrature", "Grid sums and Monte Carlo estimates of an integral of one variable", show_quadrature, true},
      {"dimensions", "The same in one, two, four and eight variables", show_dimensions, true},
      {"inversion", "Bins and a power distribution by inversion", show_inversion, true},
      {"rejection", "A disk by rejection", show_rejection, true},
      {"disk", "A disk by warps, one of them wrong", show_disk, true},
      {"sphere", "Directions on sphere and hemisphere", show_sphere, true},
      {"environment", "Directions drawn from a sky", show_environment},
      {"noise", "Four times the samples, half the noise", show_noise},
      {"precision", "What image files keep of light: relative errors over 20 decades", show_precision, true},
      {"range", "The dynamic range of numbers beside that of the real world", show_range, true},
  };
  return all;
}

const Demo& demo(const std::string& name) {
  std::vector<std::string> names;
  for (const Demo& d : demos()) {
    if (d.name == name) return d;
    names.emplace_back(d.name);
  }
  throw Error("unknown demonstration " + unknown_word(name, names));
}

}  // namespace lambert::lab

#include "plot.h"

#include "lambert/draw/plot.h"
#include "lambert/draw/write_drawing.h"

#include <cmath>

namespace lambert::cli {

void plot_response(const std::string& path, const hdr::Response& response) {
  const std::size_t levels = response.levels(), channels = response.exposure.size();
  draw::Plot plot{.title = "Camera response: " + response.name,
                  .x = {.label = "exposure (1 saturates)", .logarithmic = true},
                  .y = {.label = "code", .low = 0, .high = static_cast<double>(levels - 1)}};
  const draw::Colour colours[] = {{209, 36, 47}, {26, 127, 55}, {31, 111, 235}};
  const char* names[] = {"red", "green", "blue"};
  for (std::size_t c = 0; c < channels; ++c) {
    draw::Series series{.name = channels == 3 ? names[c] : "grey", .points = {}};
    if (channels == 3) series.colour = colours[c];
    for (std::size_t z = levels / 256; z < levels; z += levels / 256)
      series.points.push_back({static_cast<double>(response.channel(c)[z]), static_cast<double>(z)});
    plot.series.push_back(std::move(series));
  }
  draw::write_drawing(path, draw::drawn(plot));
}

}  // namespace lambert::cli

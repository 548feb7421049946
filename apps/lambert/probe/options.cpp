#include "verb.h"

#include "../number_range.h"
#include "../outputs.h"
#include "../read_finite.h"

#include "lambert/base/error.h"
#include "lambert/base/log.h"
#include "lambert/base/number.h"
#include "lambert/base/standard_streams.h"
#include "lambert/image/io.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace lambert::cli {

using namespace probe;

namespace {

std::vector<std::string> files_of(const std::string& file) {
  const std::size_t at = file.find("{}");
  if (at == std::string::npos) return {file};
  std::vector<std::string> files;
  for (const CubeFace& face : cube_faces) files.push_back(std::string(file).replace(at, 2, face.name));
  return files;
}

std::string size_text(const Image& image) { return fmt::format("{}x{}", image.width(), image.height()); }

/// Six faces, all square and alike.
std::vector<Image> read_faces(const std::string& file) {
  const std::vector<std::string> files = files_of(file);
  std::vector<Image> faces;
  for (const std::string& face : files) {
    try {
      faces.push_back(read_finite(face));
    } catch (const Error& e) {
      throw Error(fmt::format("{} ({} stands for six faces)", e.what(), file));
    }
    const Image& first = faces.front();
    const Image& i = faces.back();
    if (i.width() != i.height()) throw Error(face + ": expected a square face, got " + size_text(i));
    if (i.width() != first.width())
      throw Error(fmt::format("{}: expected {} as in {}, got {}", face, size_text(first), files.front(), size_text(i)));
    if (i.channels() != first.channels())
      throw Error(fmt::format("{}: expected the channels {} as in {}, got {}", face, fmt::join(first.channels(), " "),
                              files.front(), fmt::join(i.channels(), " ")));
  }
  return faces;
}

}  // namespace

void warn_if_cut(const std::string& file, const Image& photograph, const BallCircle& ball) {
  if (const double part = part_in_picture(photograph, ball); part < 0.999)
    log::warn(fmt::format("{}: {:.0f} % of the ball's outline lies out of the picture: what is missing is black", file,
                          100 * (1 - part)));
}

void add_layout_options(CLI::App& app, LayoutOptions& o, const std::string& flag, const std::string& prefix,
                        const std::string& what) {
  app.add_option(flag, o.layout, what + ": " + fmt::format("{}", fmt::join(layout_names(), ", ")))->type_name("LAYOUT");
  app.add_option("--" + prefix + "lens", o.lens, "Of a fisheye: " + fmt::format("{}", fmt::join(lens_names(), ", ")))
      ->capture_default_str();
  expect_number(app.add_option("--" + prefix + "fov", o.field_of_view, "Full field of view of a fisheye, in degrees")
                    ->capture_default_str(),
                {.expected = "an angle above 0 and at most 360 degrees", .low = 1e-3, .below = 360.001});
  expect_number(app.add_option("--" + prefix + "ball-distance", o.ball_distance,
                               "Of the camera from the mirror ball's centre, in radii (default: far away)"),
                {.expected = "a number of radii above 1", .low = 1.001, .below = 1e6});
}

Layout layout_of(const LayoutOptions& o) {
  Layout result = layout(o.layout);
  if (o.layout == "fisheye") result.projection = fisheye(lens(o.lens), degrees(static_cast<float>(o.field_of_view)));
  if (auto* ball = std::get_if<MirrorBall>(&result.projection); ball && o.ball_distance > 0)
    ball->distance = static_cast<float>(o.ball_distance);
  return result;
}

void add_probe_input(CLI::App& app, ProbeInputOptions& o) {
  app.add_option("file", o.file, "The environment; {} in the name stands for px nx py ny pz nz, six files")
      ->required()
      ->type_name("FILE");
  add_layout_options(app, o.layout, "--from", "", "Layout of the input (default: by its shape)");
  app.add_option("--reflectivity", o.reflectivity, "Of a mirror ball, one number or R,G,B: the input is divided by it")
      ->delimiter(',')
      ->expected(1, 3);
  add_work_options(app, o.work);
}

ProbeInput read_probe(const ProbeInputOptions& o) {
  const bool six = o.file.find("{}") != std::string::npos;
  LayoutOptions options = o.layout;
  if (six && options.layout.empty()) options.layout = "faces";
  if (!options.layout.empty() && (layout_of(options).arrangement == Arrangement::files) != six)
    throw Error(input_name(o.file) + (six ? ": {} in a name stands for six faces; " + options.layout + " is one picture"
                                          : ": " + options.layout + " are six files: expected a name with {} in it"));
  std::vector<Image> pictures;
  if (six)
    pictures = read_faces(o.file);
  else
    pictures.push_back(read_finite(o.file));
  ProbeInput input = named(input_name(o.file), [&] {
    if (options.layout.empty()) options.layout = guess_layout(pictures.front());
    const Layout layout = layout_of(options);
    return ProbeInput{cut(layout, std::move(pictures)), layout.arrangement};
  });
  input.probe = divided(std::move(input.probe), o.reflectivity);
  return input;
}

Probe divided(Probe p, const std::vector<float>& reflectivity) {
  if (reflectivity.empty()) return p;
  const Rgb mirror = rgb_of("--reflectivity", reflectivity);
  if (!(min_component(mirror) > 0)) throw Error("--reflectivity: expected numbers above 0");
  for (Image& chart : p.charts)
    for (int y = 0; y < chart.height(); ++y)
      for (int x = 0; x < chart.width(); ++x) {
        if (chart.has_colour())
          chart.set_rgb(x, y, chart.rgb(x, y) / mirror);
        else
          chart.at(x, y, 0) /= average(mirror);
      }
  return p;
}

void add_rotation_options(CLI::App& app, RotationOptions& o) {
  const NumberRange angle{.expected = "an angle in degrees", .low = -1e5, .below = 1e5};
  expect_number(app.add_option("--yaw", o.yaw, "Degrees about +y: turns what is ahead (-z) to the left (-x)"), angle);
  expect_number(app.add_option("--pitch", o.pitch, "Degrees about +x, before the yaw: turns what is ahead up"), angle);
  expect_number(app.add_option("--roll", o.roll, "Degrees about +z, before the pitch"), angle);
  app.add_option("--matrix", o.matrix, "Nine numbers of a rotation, row by row, instead")->delimiter(',')->expected(9);
}

Mat3 rotation_of(const RotationOptions& o) {
  if (!o.matrix.empty()) {
    std::array<float, 9> rows{};
    std::copy_n(o.matrix.begin(), 9, rows.begin());
    return named("--matrix", [&] { return rotation(rows); });
  }
  const auto angle = [](double a) { return degrees(static_cast<float>(a)); };
  return rotation(angle(o.yaw), angle(o.pitch), angle(o.roll));
}

void check_probes(const std::vector<std::string>& outputs) {
  for (const std::string& output : outputs) check_images(files_of(output));
}

void write_probe(const std::vector<std::string>& outputs, Probe probe, Arrangement arrangement) {
  const std::vector<Image> pictures = arranged(std::move(probe), arrangement);
  for (const std::string& output : outputs)
    if (files_of(output).size() != pictures.size())
      throw Error(output_name(output) + (pictures.size() == 6
                                             ? ": six faces need a name with {} in it"
                                             : ": {} in a name stands for six faces; this layout is one picture"));
  for (const std::string& output : outputs) {
    const std::vector<std::string> files = files_of(output);
    for (std::size_t i = 0; i < pictures.size(); ++i) write_images({files[i]}, pictures[i]);
  }
}

nlohmann::ordered_json json_of(Vec3 v) { return {v.x, v.y, v.z}; }
nlohmann::ordered_json json_of(Rgb c) { return {c.r, c.g, c.b}; }

Vec3 direction_of(const std::string& flag, const std::vector<float>& numbers) {
  const Vec3 d(numbers[0], numbers[1], numbers[2]);
  if (!is_finite(d) || !(length(d) > 0))
    throw Error(
        fmt::format("{}: expected three finite numbers that are not all 0, got '{}'", flag, fmt::join(numbers, ",")));
  return normalize(d);
}

Rgb rgb_of(const std::string& flag, const std::vector<float>& numbers) {
  const bool finite = std::all_of(numbers.begin(), numbers.end(), [](float v) { return std::isfinite(v); });
  if ((numbers.size() != 1 && numbers.size() != 3) || !finite) throw Error(flag + ": expected one number or three");
  if (numbers.size() == 1) return Rgb(numbers[0]);
  return {numbers[0], numbers[1], numbers[2]};
}

}  // namespace lambert::cli

#pragma once
/// What the verbs of `lambert probe` share.

#include "../cli_fwd.h"
#include "../work.h"

#include "lambert/base/error.h"
#include "lambert/image/probe/find_ball.h"
#include "lambert/image/probe/layout.h"
#include "lambert/image/probe/rotation.h"

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <string>
#include <vector>

namespace lambert::cli {

/// A layout and the numbers that some need.
struct LayoutOptions {
  std::string layout, lens = "equidistant";
  double field_of_view = 180;
  double ball_distance = 0;  ///< 0: infinite
};
/// --from, --lens, --fov, --ball-distance, or the same with `prefix` before the last three.
void add_layout_options(CLI::App& app, LayoutOptions& o, const std::string& flag, const std::string& prefix,
                        const std::string& what);
/// Throws Error for an unknown name or numbers out of range.
probe::Layout layout_of(const LayoutOptions& o);

struct ProbeInputOptions {
  std::string file;
  LayoutOptions layout;
  std::vector<float> reflectivity;
  WorkOptions work;
};
void add_probe_input(CLI::App& app, ProbeInputOptions& o);

struct ProbeInput {
  probe::Probe probe;
  probe::Arrangement arrangement;
};
/// Reads FILE (six files where its name holds "{}"), fills texels that are not finite, with a warning, and divides by
/// the reflectivity. Without --from the layout is guessed by shape.
ProbeInput read_probe(const ProbeInputOptions& o);

/// Errors about the contents of a file begin with its name.
template <class F>
auto named(const std::string& file, const F& f) {
  try {
    return f();
  } catch (const Error& e) {
    const std::string what = e.what();
    throw Error(what.starts_with(file) ? what : file + ": " + what);
  }
}
/// Warns when the frame cuts the ball.
void warn_if_cut(const std::string& file, const Image& photograph, const probe::BallCircle& ball);

/// Colours over the reflectivity, if any is given. Throws Error unless it is above 0.
probe::Probe divided(probe::Probe p, const std::vector<float>& reflectivity);

struct RotationOptions {
  double yaw = 0, pitch = 0, roll = 0;
  std::vector<float> matrix;
};
void add_rotation_options(CLI::App& app, RotationOptions& o);
Mat3 rotation_of(const RotationOptions& o);

/// Throws Error when one of them could not be written.
void check_probes(const std::vector<std::string>& outputs);
/// Writes the picture, or the six of files, to each of `outputs`, and prints paths. Throws Error when "{}" stands in a
/// name and should not, or the other way round.
void write_probe(const std::vector<std::string>& outputs, probe::Probe probe, probe::Arrangement arrangement);
nlohmann::ordered_json json_of(Vec3 v);
nlohmann::ordered_json json_of(Rgb c);
/// Of unit length. Throws Error naming the flag unless the three numbers are finite and not all 0.
Vec3 direction_of(const std::string& flag, const std::vector<float>& numbers);
/// Three finite numbers, or one that stands for all three. Throws Error naming the flag.
Rgb rgb_of(const std::string& flag, const std::vector<float>& numbers);

std::function<int()> add_probe_convert(CLI::App& app);
std::function<int()> add_probe_rotate(CLI::App& app);
std::function<int()> add_probe_assemble(CLI::App& app);
std::function<int()> add_probe_irradiance(CLI::App& app);
std::function<int()> add_probe_sh(CLI::App& app);
std::function<int()> add_probe_lights(CLI::App& app);
std::function<int()> add_probe_find_ball(CLI::App& app);
std::function<int()> add_probe_check(CLI::App& app);

}  // namespace lambert::cli

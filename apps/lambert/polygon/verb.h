#pragma once
/// What the verbs of `lambert polygon` share.

#include "../cli_fwd.h"
#include "../work.h"

#include "lambert/draw/picture.h"
#include "lambert/polygon/box.h"
#include "lambert/polygon/formats/file.h"

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <string>
#include <vector>

namespace lambert::cli {

/// Flags of all verbs; each verb offers those that it uses.
struct PolygonOptions {
  std::vector<std::string> files, outputs;
  std::string rule = "even-odd", format, svg, png;
  bool json = false;
  WorkOptions work;
  std::vector<std::string> meshes;  ///< extensions of meshes that -o may name
  bool mesh_written = false;        ///< the result is in a file already
};

/// FILE…, and --rule where `with_rule`.
CLI::Option* add_input_options(CLI::App& app, PolygonOptions& o, bool with_rule = true);
/// -o,--output FILE…, of which "svg:-", "obj:-" and the like are standard output; "-" is for the verb.
/// -o, --to, --svg, --png: for verbs whose result is geometry.
void add_geometry_outputs(CLI::App& app, PolygonOptions& o);
/// -o, --json, --svg, --png: for verbs that print facts.
void add_fact_outputs(CLI::App& app, PolygonOptions& o);

struct PolygonInput {
  std::string name;
  polygon::Features features;
  polygon::FileFormat format = polygon::FileFormat::geojson;
};

/// What of its files a verb works on, beside the x and y of rings.
struct Uses {
  bool lines = false, points = false;
  bool ring_heights = false, line_heights = false;
  bool validity = false;  ///< rings are made valid, which rounds the smallest of sizes that differ too much
};

/// The files, or standard input when there is none or its name is "-". Says on standard error, in a line a file, what
/// of it the verb leaves out, and which coordinates it rounds. Throws Error.
std::vector<PolygonInput> read_inputs(const PolygonOptions& o, Uses uses);
/// All features of all inputs in one collection.
polygon::Features joined(const std::vector<PolygonInput>& inputs);
polygon::FillRule fill_rule(const PolygonOptions& o);

/// Throws Error when -o names a file that is neither geometry, a picture nor a mesh.
void check_geometry_outputs(const PolygonOptions& o);
/// Writes the files that were asked for and prints their paths; prints the geometry itself when no file is for it.
/// The format printed is that of --to, else that of the first input.
void write_geometry(const PolygonOptions& o, polygon::FileFormat like, const polygon::Features& result,
                    const draw::Picture& picture);
/// Prints `text`, or `facts` with --json; -o may name a .json file or a picture.
void write_facts(const PolygonOptions& o, const nlohmann::ordered_json& facts, const std::string& text,
                 const draw::Picture& picture);

/// Name and members of `source`, but for those that its geometry made true ("bbox"): what is cut from it.
polygon::Feature cut_from(const polygon::Feature& source);
/// A collection like `all`, of one feature cut from each of its: add(source, feature) gives it its geometry.
polygon::Features cut_from(const polygon::Features& all,
                           const std::function<void(const polygon::Feature&, polygon::Feature&)>& add);

/// Numbers parted by commas. Throws Error naming the flag and what was expected.
std::vector<double> parse_reals(const std::string& flag, const std::string& text, std::size_t count,
                                const std::string& expected);
/// --at X,Y, which may be given several times, and what it was given.
void add_at_option(CLI::App& app, std::vector<std::string>& at);
std::vector<Vec2d> parse_points(const std::string& flag, const std::vector<std::string>& texts);
/// x0,y0,x1,y1. Throws Error unless x0 <= x1 and y0 <= y1.
polygon::Box2 parse_window(const std::string& flag, const std::string& text);
/// "640x480". Throws Error unless both are from 1 to 16384.
Vec2i parse_size(const std::string& flag, const std::string& text);

/// "3 rings", "1 ring"
std::string counted(std::size_t count, const std::string& noun);
/// "(1, 2.5)"
std::string point_text(Vec2d p);

std::function<int()> add_check(CLI::App& app);
std::function<int()> add_classify(CLI::App& app);
std::function<int()> add_normal(CLI::App& app);
std::function<int()> add_area(CLI::App& app);
std::function<int()> add_contains(CLI::App& app);
std::function<int()> add_pick(CLI::App& app);
std::function<int()> add_clip(CLI::App& app);
std::function<int()> add_union(CLI::App& app);
std::function<int()> add_intersect(CLI::App& app);
std::function<int()> add_difference(CLI::App& app);
std::function<int()> add_xor(CLI::App& app);
std::function<int()> add_trapezoids(CLI::App& app);
std::function<int()> add_convex(CLI::App& app);
std::function<int()> add_triangulate(CLI::App& app);
std::function<int()> add_strips(CLI::App& app);
std::function<int()> add_fill(CLI::App& app);
std::function<int()> add_extrude(CLI::App& app);
std::function<int()> add_revolve(CLI::App& app);
std::function<int()> add_convert(CLI::App& app);

}  // namespace lambert::cli

#pragma once
/// What the verbs of `lambert polygon` share.

#include "lambert/draw/picture.h"
#include "lambert/polygon/formats/file.h"

#include <CLI/App.hpp>
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
  bool mesh_written = false;  ///< the result is in a file already
};

/// FILE…, and --rule where `with_rule`.
CLI::Option* add_input_options(CLI::App& app, PolygonOptions& o, bool with_rule = true);
/// -o, --to, --svg, --png: for verbs whose result is geometry.
void add_geometry_outputs(CLI::App& app, PolygonOptions& o);
/// -o, --json, --svg, --png: for verbs that print facts.
void add_fact_outputs(CLI::App& app, PolygonOptions& o);

struct PolygonInput {
  std::string name;
  polygon::Features features;
  polygon::FileFormat format = polygon::FileFormat::geojson;
};

/// The files, or standard input when there is none or its name is "-". Throws Error.
std::vector<PolygonInput> read_inputs(const PolygonOptions& o);
/// Says on standard error, in a line a file, how many lines and points it holds that a verb which takes what polygons
/// enclose leaves out, and where sizes of coordinates differ so much that the smallest count as 0 in its result.
void note_what_counts_not(const std::vector<PolygonInput>& inputs);
/// All features of all inputs in one collection.
polygon::Features joined(const std::vector<PolygonInput>& inputs);
polygon::FillRule fill_rule(const PolygonOptions& o);

/// Writes the files that were asked for and prints their paths; prints the geometry itself when no file is for it.
/// The format printed is that of --to, else that of the first input.
void write_geometry(const PolygonOptions& o, polygon::FileFormat like, const polygon::Features& result,
                    const draw::Picture& picture);
/// Prints `text`, or `facts` with --json; -o may name a .json file or a picture.
void write_facts(const PolygonOptions& o, const nlohmann::ordered_json& facts, const std::string& text,
                 const draw::Picture& picture);

/// Name and members of `source`, but for those that its geometry made true ("bbox"): what is cut from it.
polygon::Feature cut_from(const polygon::Feature& source);

/// Numbers parted by commas. Throws Error naming the flag and what was expected.
std::vector<double> parse_reals(const std::string& flag, const std::string& text, std::size_t count,
                                const std::string& expected);
/// "640x480". Throws Error unless both are from 1 to 16384.
Vec2i parse_size(const std::string& flag, const std::string& text);

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

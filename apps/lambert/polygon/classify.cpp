#include "places.h"

#include "../command.h"

#include "lambert/polygon/queries/convex.h"
#include "lambert/polygon/queries/normal.h"
#include "lambert/polygon/queries/simple.h"
#include "lambert/polygon/sweep/intersections.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <optional>

namespace lambert::cli {

using namespace polygon;
using namespace draw;

namespace {

const char* word_for(Simplicity::Kind kind) {
  switch (kind) {
    case Simplicity::Kind::simple: return "simple";
    case Simplicity::Kind::too_few: return "too-few";
    case Simplicity::Kind::vertex_twice: return "vertex-twice";
    case Simplicity::Kind::edges_cross: return "edges-cross";
    case Simplicity::Kind::spike: return "spike";
    case Simplicity::Kind::edges_coincide: break;
  }
  return "edges-coincide";
}

/// A ring of space laid into the plane along the dominant axis of its normal.
Ring flattened(const Path& path) {
  if (path.heights.empty()) return path.points;
  const std::vector<Vec3d> vertices = in_space(path);
  const auto normal = newell_normal(vertices);
  return normal ? PlaneProjection(*normal)(vertices) : path.points;
}

/// The first crossing or overlap of edges of two different rings.
struct RingMeeting {
  std::size_t ring_a, edge_a, ring_b, edge_b;
  Vec2d point;
};
std::optional<RingMeeting> rings_cross(const PathPolygon& polygon) {
  std::vector<Segment> edges;
  std::vector<std::pair<std::size_t, std::size_t>> owner;
  for (std::size_t r = 0; r < polygon.size(); ++r) {
    const Ring& ring = polygon[r].points;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      edges.push_back({ring[i], ring[next_index(i, ring.size())]});
      owner.emplace_back(r, i);
    }
  }
  for (const SegmentPair& pair : all_intersections(edges)) {
    const auto [ring_a, edge_a] = owner[pair.first];
    const auto [ring_b, edge_b] = owner[pair.second];
    const SegmentMeeting& m = pair.meeting;
    const bool inside_both = m.t > 0 && m.t < 1 && m.p > 0 && m.p < 1;
    if (ring_a != ring_b && (m.from != m.to || (m.kind == SegmentCase::crossing && inside_both)))
      return RingMeeting{ring_a, edge_a, ring_b, edge_b, m.from};
  }
  return std::nullopt;
}

class Classifier {
 public:
  explicit Classifier(const PolygonOptions& o) : options_(o), inputs_(read_inputs(o, {.ring_heights = true})) {}

  int run() {
    show_inputs(picture_, inputs_);
    for_each_path(inputs_, [&](const PathPlace& place, const Path& path) {
      if (place.ring) ring(place, path);
    });
    write_facts(options_, {{"simple", all_simple_}, {"rings", rings_}}, text_, picture_);
    return all_simple_ ? done : failed;
  }

 private:
  void ring(const PathPlace& place, const Path& path) {
    const Ring flat = flattened(path);
    const Simplicity s = check_simple(flat);
    nlohmann::ordered_json j = place.json();
    j["vertices"] = flat.size();
    j["class"] = word_for(s.kind);
    std::string words = word_for(s.kind);
    if (s.simple()) {
      const int orientation = ring_orientation(flat);
      const std::vector<std::size_t> reflex = reflex_vertices(flat);
      j["orientation"] = orientation > 0 ? "counter-clockwise" : "clockwise";
      j["convex"] = is_convex(flat);
      j["reflex"] = reflex;
      words += is_convex(flat) ? ", convex" : ", " + counted(reflex.size(), "reflex corner");
      words += orientation > 0 ? ", counter-clockwise" : ", clockwise";
    } else {
      all_simple_ = false;
      j["message"] = message_of(s);
      if (s.kind != Simplicity::Kind::too_few) {
        j["first"] = s.first;
        j["second"] = s.second;
        j["point"] = {s.point.x, s.point.y};
        if (path.heights.empty()) witness(s.point);
      }
      words += ": " + message_of(s);
    }
    if (!path.heights.empty()) {
      const std::vector<Vec3d> vertices = in_space(path);
      j["planar"] = is_planar(vertices);
      words += is_planar(vertices) ? ", planar" : ", not planar";
    }
    text_ += place.text() + ": " + words + "\n";
    rings_.push_back(j);
    const PathPolygon& polygon = place.feature_of().polygons[*place.polygon];
    if (*place.ring + 1 == polygon.size() && polygon.size() > 1) rings_of_polygon(place, polygon);
  }

  void rings_of_polygon(const PathPlace& place, const PathPolygon& polygon) {
    const auto m = rings_cross(polygon);
    if (!m) return;
    all_simple_ = false;
    witness(m->point);
    const std::string message = "rings " + std::to_string(m->ring_a) + " and " + std::to_string(m->ring_b) +
                                " cross: edges " + std::to_string(m->edge_a) + " and " + std::to_string(m->edge_b) +
                                " meet at " + point_text(m->point);
    rings_.back()["rings_message"] = message;
    text_ += PathPlace{place.input, place.feature, place.polygon, {}, {}}.text() + ": " + message + "\n";
  }

  void witness(Vec2d p) {
    picture_.points.push_back({.at = p, .colour = alarm, .shape = Picture::Shape::circle, .radius = 8});
    picture_.points.push_back({.at = p, .colour = alarm, .shape = Picture::Shape::cross, .radius = 4});
  }

  const PolygonOptions& options_;
  std::vector<PolygonInput> inputs_;
  Picture picture_{.title = "classify"};
  nlohmann::ordered_json rings_ = nlohmann::json::array();
  std::string text_;
  bool all_simple_ = true;
};

}  // namespace

std::function<int()> add_classify(CLI::App& app) {
  static PolygonOptions options;
  add_input_options(app, options, false);
  add_fact_outputs(app, options);
  app.footer(
      "Classes: simple, too-few, vertex-twice, edges-cross, spike, edges-coincide, each with a witness.\n"
      "Exit status 1 when a ring is not simple or rings of one polygon cross. Rings in space are laid into the plane.");
  return [] { return Classifier(options).run(); };
}

}  // namespace lambert::cli

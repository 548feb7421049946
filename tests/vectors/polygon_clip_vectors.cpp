#include "vectors.h"

#include "lambert/geometry/extrude.h"
#include "lambert/geometry/revolve.h"
#include "lambert/polygon/clip/components.h"
#include "lambert/polygon/clip/half_plane_clip.h"
#include "lambert/polygon/clip/window_clip.h"
#include "lambert/polygon/queries/line_through.h"
#include "lambert/polygon/scan/scan_table.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lambert {
namespace {

using namespace polygon;

Vec2d plane_point(const nlohmann::json& value) { return {value.at(0).get<double>(), value.at(1).get<double>()}; }

Ring ring_of(const nlohmann::json& value) {
  Ring ring;
  for (const auto& vertex : value) ring.push_back(plane_point(vertex));
  return ring;
}

/// From an object of labels and positions.
std::vector<LabelledVertex> labelled(const nlohmann::json& value) {
  std::vector<LabelledVertex> vertices;
  for (const auto& [label, position] : value.items()) vertices.push_back({plane_point(position), label});
  return vertices;
}

void expect_trace(const Vector& v, const ClipTrace& trace) {
  std::vector<std::string> states, order;
  for (const ClipStep& step : trace.steps) states.emplace_back(name_of(step.state));
  for (const LabelledVertex& vertex : trace.ring) order.push_back(vertex.label);
  EXPECT_EQ(states, v.expected.at("states").get<std::vector<std::string>>());
  EXPECT_EQ(order, v.expected.at("order").get<std::vector<std::string>>());
  std::size_t found = 0;
  for (const LabelledVertex& vertex : trace.ring) {
    if (!v.expected.at("coords").contains(vertex.label)) continue;
    ++found;
    v.expect_near(vertex.position.x, v.expected.at("coords").at(vertex.label)[0]);
    v.expect_near(vertex.position.y, v.expected.at("coords").at(vertex.label)[1]);
  }
  EXPECT_EQ(found, v.expected.at("coords").size());
}

const Vector& vector_named(const std::string& id) {
  const auto found = std::find_if(vectors().begin(), vectors().end(), [&](const Vector& v) { return v.id == id; });
  if (found == vectors().end()) throw std::out_of_range(id);
  return *found;
}

/// Of V-PG-36, with which the second trace goes on.
ClipTrace first_trace() { return trace_clip(labelled(vector_named("V-PG-36").input.at("polygon")), keep_y_from(0)); }

// rows: PG-33 PG-34
const CheckOf span_table("V-PG-23", [](const Vector& v) {
  const Ring ring = ring_of(v.input.at("polygon"));
  std::vector<PixelSpan> table = scan_table(Rings{ring});
  std::reverse(table.begin(), table.end());  // the file goes down
  const auto& expected = v.expected.at("spans");
  ASSERT_EQ(table.size(), expected.size());
  int pixels = 0;
  for (std::size_t i = 0; i < table.size(); ++i) {
    EXPECT_EQ(nlohmann::json({table[i].y, table[i].first, table[i].last}), expected[i]);
    pixels += table[i].last - table[i].first + 1;
  }
  EXPECT_EQ(pixels, v.expected.at("pixels_inclusive").get<int>());
  EXPECT_EQ(std::abs(signed_area(ring)), v.expected.at("area").get<double>());
});

// rows: PG-38
const CheckOf extrusion("V-PG-26", [](const Vector& v) {
  const Region region{ring_of(v.input.at("polygon")), {}};
  const SolidCounts counts = extrusion_counts(region);
  EXPECT_EQ(counts.vertices, v.expected.at("vertices").get<std::size_t>());
  EXPECT_EQ(counts.quads, v.expected.at("side_quads").get<std::size_t>());
  EXPECT_EQ(counts.caps, v.expected.at("caps").get<std::size_t>());
  const TriangleMesh mesh = extrude(region, {.along = vec3d(v.input.at("vector"))});
  v.expect_near(mesh.volume(), v.expected.at("volume"));
  v.expect_near(mesh.area(), v.expected.at("surface_area"));
});

// rows: PG-39
const CheckOf revolution("V-PG-27", [](const Vector& v) {
  std::vector<Vec3d> profile;
  for (const Vec2d p : ring_of(v.input.at("profile"))) profile.emplace_back(p, 0);
  Revolution about_y{.axis = {0, 1, 0}, .steps = v.input.at("steps").get<int>()};
  const SolidCounts counts = revolution_counts(profile, about_y);
  EXPECT_EQ(counts.quads, v.expected.at("quads").get<std::size_t>());
  EXPECT_EQ(counts.vertices, v.expected.at("vertices").get<std::size_t>());
  v.expect_near(revolve(profile, about_y).area(), v.expected.at("lateral_area"));
  about_y.steps = 4000;
  v.expect_near(revolve(profile, about_y).area(), v.expected.at("exact_cylinder"));
});

// rows: PG-51 PG-52
const CheckOf clip_trace("V-PG-36", [](const Vector& v) {
  ASSERT_EQ(v.input.at("keep"), "y>=0");
  expect_trace(v, first_trace());
});

// rows: PG-53 PG-54
const CheckOf second_clip_trace("V-PG-37", [](const Vector& v) {
  ASSERT_EQ(v.input.at("keep"), "x<=5");
  const std::vector<LabelledVertex> ring = first_trace().ring;
  std::vector<std::string> order;
  for (const LabelledVertex& vertex : ring) order.push_back(vertex.label);
  ASSERT_EQ(order, v.input.at("order").get<std::vector<std::string>>());
  expect_trace(v, trace_clip(ring, keep_x_to(5), "QP"));
});

// rows: PG-56
const CheckOf clip_components("V-PG-38", [](const Vector& v) {
  ASSERT_EQ(v.input.at("keep"), "y>=2");
  const Rings rings = clip_to_half_plane({ring_of(v.input.at("polygon"))}, keep_y_from(2));
  const Regions pieces = components(rings);
  ASSERT_EQ(pieces.size(), v.expected.at("components").get<std::size_t>());
  for (std::size_t i = 0; i < pieces.size(); ++i) v.expect_near(area(pieces[i]), v.expected.at("component_areas")[i]);
  v.expect_near(area(pieces), v.expected.at("total_area"));
  // Between the arms there is nothing.
  int bridging = 0;
  for (const Ring& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2d a = ring[i], b = ring[next_index(i, ring.size())];
      bridging += a.y == 2 && b.y == 2 && std::min(a.x, b.x) < 4 && std::max(a.x, b.x) > 2;
    }
  EXPECT_EQ(bridging, v.expected.at("bridging_edges_remaining").get<int>());
});

// rows: PG-57 PG-59
const CheckOf inside_segments("V-PG-39", [](const Vector& v) {
  ASSERT_EQ(v.input.at("line"), "y=0");
  const std::vector<LabelledVertex> ring = labelled(v.input.at("polygon"));
  const auto edges = edges_of_new_vertices(trace_clip(ring, keep_y_from(0)));
  const auto& expected = v.expected.at("segments");
  ASSERT_EQ(edges.size(), expected.size());
  Ring positions;
  for (const LabelledVertex& vertex : ring) positions.push_back(vertex.position);
  const LineThrough through = line_through({positions}, {0, 0}, {1, 0});
  ASSERT_EQ(through.inside.size(), expected.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    auto [a, b] = edges[i];
    EXPECT_EQ(a.label + b.label, v.expected.at("names")[i].get<std::string>());
    // The ring's second crossing comes first along the line.
    const LinePiece& piece = through.inside[edges.size() - 1 - i];
    if (a.position.x > b.position.x) std::swap(a, b);
    for (const auto& [low, high] : {std::pair(a.position, b.position), std::pair(piece.from, piece.to)}) {
      v.expect_near(low.x, expected[i][0][0]);
      v.expect_near(low.y, expected[i][0][1]);
      v.expect_near(high.x, expected[i][1][0]);
      v.expect_near(high.y, expected[i][1][1]);
    }
  }
});

// rows: PG-57 PG-59 PG-60
const CheckOf degenerate_lines("V-PG-40", [](const Vector& v) {
  const Ring ring = ring_of(v.input.at("polygon"));
  const auto expect_pieces = [&](const std::vector<LinePiece>& pieces, const nlohmann::json& expected, double y) {
    ASSERT_EQ(pieces.size(), expected.size()) << "y = " << y;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      v.expect_near(pieces[i].from.x, expected[i][0]);
      v.expect_near(pieces[i].to.x, expected[i][1]);
      EXPECT_EQ(pieces[i].from.y, y);
      EXPECT_EQ(pieces[i].to.y, y);
    }
  };
  for (const int y : v.input.at("lines")) {
    const LineThrough through = line_through({ring}, {0, y}, {1, y});
    expect_pieces(through.inside, v.expected.at("interior_segments").at(std::to_string(y)), y);
    expect_pieces(through.edges, v.expected.at("edges_on_line").value(std::to_string(y), nlohmann::json::array()), y);
  }
});

}  // namespace
}  // namespace lambert

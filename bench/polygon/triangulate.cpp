/// Time to triangulate polygons of 1k to 100k vertices, the best of several runs, beside CGAL where it is found.
///
///   bench_triangulate            the table
///   bench_triangulate FOLDER     also writes the polygons there, for triangulate_earcut.py

#include "lambert/polygon/decompose/triangulate.h"
#include "lambert/polygon/decompose/delaunay.h"
#include "lambert/polygon/decompose/ear_clipping.h"
#include "lambert/polygon/test_polygons.h"
#include "outlines.h"
#include "stopwatch.h"
#include "triangulate_cgal.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <string>

namespace {

using namespace lambert;
using namespace lambert::polygon;

/// Milliseconds of processor time.
template <class Work>
double best_time(const Work& work) {
  double best = std::numeric_limits<double>::infinity(), total = 0;
  for (int run = 0; run < 3 || (run < 50 && total < 300); ++run) {
    const bench::Stopwatch watch;
    work();
    const double time = 1e3 * watch.seconds();
    best = std::min(best, time);
    total += time;
  }
  return best;
}

/// First line: where each ring ends; then a vertex a line.
void write(const std::string& path, const FlatRings& rings) {
  std::ofstream file(path);
  file.precision(17);
  for (const std::uint32_t end : rings.ends) file << end << ' ';
  file << '\n';
  for (const Vec2d p : rings.vertices) file << p.x << ' ' << p.y << '\n';
}

/// The triangles must cover the area, or the time means nothing.
bool covers(const std::vector<Triangle>& triangles, const FlatRings& rings, double area) {
  double sum = 0;
  for (const Triangle& t : triangles)
    sum += 0.5 * cross(rings.vertices[t[0]], rings.vertices[t[1]], rings.vertices[t[2]]);
  return std::abs(sum - area) <= 1e-9 * area;
}

void measure(const std::string& name, const Region& region, const std::string& folder) {
  const FlatRings rings = flat(region);
  if (!covers(triangulate(rings), rings, area(region)) || !covers(delaunay(rings), rings, area(region)))
    std::printf("%-8s WRONG AREA\n", name.c_str());
  const double fast = best_time([&] { triangulate(rings); }), best = best_time([&] { delaunay(rings); });
  std::printf("%-8s %8zu %9.3f %9.3f ", name.c_str(), rings.vertices.size(), fast, best);
  if (region.holes.empty())
    std::printf("%9.3f ", best_time([&] { clip_ears(region.outer); }));
  else
    std::printf("%9s ", "-");
#ifdef LAMBERT_HAS_CGAL
  std::printf("%9.3f", best_time([&] { bench::cgal_triangle_count(rings); }));
#else
  std::printf("%9s", "-");
#endif
  std::printf("\n");
  std::fflush(stdout);
  if (!folder.empty()) write(folder + "/" + name + "-" + std::to_string(rings.vertices.size()) + ".txt", rings);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string folder = argc > 1 ? argv[1] : "";
#ifndef LAMBERT_HAS_CGAL
  std::printf("CGAL WAS NOT FOUND: nothing to compare with\n");
#endif
  std::printf("milliseconds, best of several runs\n%-8s %8s %9s %9s %9s %9s\n", "polygon", "vertices", "fast",
              "delaunay", "ears", "CGAL");
  test::Random random(1);
  for (const std::size_t n : {1000, 3000, 10000, 30000, 100000}) {
    measure("star", {test::star(random, n), {}}, folder);
    measure("coast", {coast(n), {}}, folder);
    measure("comb", {test::comb(n / 2), {}}, folder);
    measure("spiral", {test::spiral(n / 2), {}}, folder);
    const auto per_side = static_cast<std::size_t>(std::sqrt(static_cast<double>(n) / 20));
    measure("holes", test::star_with_holes(random, n / 2, per_side, 10), folder);
  }
}

// Unites two files of polygons, cuts the result into triangles and draws it.
#include "lambert/base/error.h"
#include "lambert/base/file.h"
#include "lambert/draw/picture.h"
#include "lambert/draw/svg.h"
#include "lambert/polygon/boolean.h"
#include "lambert/polygon/formats/file.h"
#include "lambert/polygon/triangulate.h"

#include <cstdio>

int main(int argc, char** argv) try {
  using namespace lambert::draw;
  using namespace lambert::polygon;
  if (argc != 4) return 2;
  const Rings a = rings_of(read_features(argv[1])), b = rings_of(read_features(argv[2]));
  const Regions both = unite(a, b);  // valid, whatever the rings were

  Picture picture{.title = "union"};
  std::size_t triangles = 0;
  for (const Region& region : both) {
    triangles += triangulate(region).size();
    picture.areas.push_back({.rings = rings_of(region), .fill = pastel(triangles), .edge = strong(triangles)});
    add_indices(picture, rings_of(region), {});
  }
  lambert::write_atomically(argv[3], svg_text(drawn(picture)));
  std::printf("%zu region, area %.3f, %zu triangles\n", both.size(), area(both), triangles);
} catch (const lambert::Error& e) {
  std::fprintf(stderr, "%s\n", e.what());  // one line: file, line, column, feature, ring, vertex, what was expected
  return 1;
}

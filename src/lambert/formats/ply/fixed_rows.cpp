#include "lambert/formats/ply/fixed_rows.h"

#include "lambert/base/error.h"
#include "lambert/base/parallel.h"
#include "lambert/formats/ply/source.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>

namespace lambert::ply {
namespace {

constexpr std::size_t rows_per_task = 1 << 15;

/// Calls body(first, last) for pieces of [0, count), in parallel.
template <class Body>
void for_pieces(std::size_t count, const Body& body) {
  parallel_for((count + rows_per_task - 1) / rows_per_task,
               [&](std::size_t piece) { body(piece * rows_per_task, std::min(count, (piece + 1) * rows_per_task)); });
}

}  // namespace

void read_fixed_vertices(const char* rows, const Element& e, bool swap, const VertexLayout& layout,
                         TriangleMesh& mesh) {
  struct Column {
    std::size_t slot, offset;
    Type type;
  };
  std::vector<Column> columns;
  std::size_t stride = 0;
  for (std::size_t k = 0; k < e.properties.size(); ++k) {
    if (const auto slot = layout.slot(k)) columns.push_back({*slot, stride, e.properties[k].type});
    stride += size_of(e.properties[k].type);
  }
  for_pieces(e.count, [&](std::size_t first, std::size_t last) {
    std::array<float, slot_count> values = empty_slots;
    for (std::size_t i = first; i < last; ++i) {
      for (const Column& c : columns) {
        values[c.slot] = static_cast<float>(load_as<double>(rows + i * stride + c.offset, c.type, swap));
      }
      layout.store(mesh, i, values);
    }
  });
}

std::optional<TriangleRows> triangle_rows(const Element& e, const char* rows, std::size_t bytes, bool swap) {
  TriangleRows layout;
  bool found = false;
  for (const Property& p : e.properties) {
    if (p.is_list() && (found || !p.is_face_list())) return std::nullopt;
    if (!p.is_list()) {
      layout.stride += size_of(p.type);
      continue;
    }
    found = true;
    layout.count_type = *p.count_type, layout.corner_type = p.type;
    layout.count_offset = layout.stride, layout.corner_offset = layout.stride + size_of(*p.count_type);
    layout.stride = layout.corner_offset + 3 * size_of(p.type);
  }
  if (!found || e.count > bytes / layout.stride) return std::nullopt;
  std::atomic<bool> all_triangles = true;
  for_pieces(e.count, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last && all_triangles; ++i) {
      const char* count = rows + i * layout.stride + layout.count_offset;
      if (load_as<std::int64_t>(count, layout.count_type, swap) != 3) all_triangles = false;
    }
  });
  return all_triangles ? std::optional(layout) : std::nullopt;
}

void read_fixed_triangles(const TriangleRows& layout, const char* rows, std::size_t count, bool swap,
                          const std::string& name, FaceList& faces) {
  std::vector<Triangle>& triangles = faces.triangles();
  const std::size_t before = triangles.size();
  triangles.resize(before + count);
  std::atomic<std::size_t> first_bad = std::numeric_limits<std::size_t>::max();
  for_pieces(count, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const char* corner = rows + i * layout.stride + layout.corner_offset;
      for (std::size_t k = 0; k < 3; ++k, corner += size_of(layout.corner_type)) {
        const auto index = load_as<std::int64_t>(corner, layout.corner_type, swap);
        if (!faces.is_valid(index)) {
          std::size_t known = first_bad;
          while (i < known && !first_bad.compare_exchange_weak(known, i)) {
          }
          return;
        }
        triangles[before + i][k] = static_cast<std::uint32_t>(index);
      }
    }
  });
  if (first_bad < count)
    throw Error(name + ": face " + std::to_string(first_bad) + ": names a vertex that does not exist");
}

}  // namespace lambert::ply

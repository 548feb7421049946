#include "lambert/formats/ply/faces.h"
#include "lambert/formats/ply/fixed_rows.h"
#include "lambert/formats/ply/header.h"
#include "lambert/formats/ply/source.h"
#include "lambert/formats/ply/vertices.h"
#include "lambert/formats/readers.h"

#include <algorithm>
#include <string_view>

namespace lambert {
namespace ply {
namespace {

template <class Source>
std::size_t list_count(Source& source, const Property& p) {
  const std::int64_t count = source.integer(*p.count_type);
  if (count < 0) source.fail("a list has the length " + std::to_string(count));
  return static_cast<std::size_t>(count);
}

template <class Source>
void skip_property(Source& source, const Property& p) {
  source.skip(p.type, p.is_list() ? list_count(source, p) : 1);
}

template <class Source>
void skip_element(Source& source, const Element& e) {
  if (e.properties.empty()) return;
  for (std::size_t i = 0; i < e.count; ++i) {
    for (const Property& p : e.properties) skip_property(source, p);
  }
}

template <class Source>
void read_vertices(Source& source, const Element& e, const VertexLayout& layout, TriangleMesh& mesh) {
  for (std::size_t i = 0; i < e.count; ++i) {
    std::array<float, slot_count> values = empty_slots;
    for (std::size_t k = 0; k < e.properties.size(); ++k) {
      if (const auto slot = layout.slot(k)) {
        values[*slot] = source.real(e.properties[k].type);
      } else {
        skip_property(source, e.properties[k]);
      }
    }
    layout.store(mesh, i, values);
  }
}

template <class Source>
std::uint32_t read_corner(Source& source, Type type, const FaceList& faces, bool strip, std::size_t row) {
  const std::int64_t index = source.integer(type);
  if (strip && index < 0) return FaceList::no_corner;
  if (!faces.is_valid(index)) {
    source.fail("face " + std::to_string(row) + ": there is no vertex " + std::to_string(index));
  }
  return static_cast<std::uint32_t>(index);
}

template <class Source>
void read_faces(Source& source, const Element& e, bool strips, FaceList& faces) {
  std::vector<std::uint32_t> corners;
  if (e.properties.empty()) return;
  for (std::size_t i = 0; i < e.count; ++i) {
    for (const Property& p : e.properties) {
      if (!p.is_face_list()) {
        skip_property(source, p);
        continue;
      }
      corners.clear();
      for (std::size_t n = list_count(source, p); n > 0; --n) {
        corners.push_back(read_corner(source, p.type, faces, strips, i));
      }
      strips ? faces.add_strip(corners) : faces.add_polygon(corners);
    }
  }
}

class Reader {
 public:
  Reader(std::string_view data, const std::string& name, Notes& notes)
      : data_(data), name_(name), notes_(notes), header_(parse_header(data, name)) {}

  TriangleMesh read() {
    const auto vertex = std::find_if(header_.elements.begin(), header_.elements.end(),
                                     [](const Element& e) { return e.name == "vertex"; });
    if (vertex == header_.elements.end()) throw Error(name_ + ": has no 'vertex' element");
    if (vertex->count >= FaceList::no_corner) throw Error({name_, vertex->line, 1}, "has too many vertices");
    const VertexLayout layout(*vertex, name_);
    for (const std::string& p : layout.ignored()) notes_.add("PLY: vertex property '" + p + "' is ignored");
    FaceList faces(vertex->count);
    layout.allocate(mesh_, vertex->count);
    if (header_.encoding == Encoding::ascii) {
      AsciiSource source(data_, header_, name_);
      for (const Element& e : header_.elements) read_element(source, e, &e == &*vertex, layout, faces);
    } else {
      BinarySource source(data_, header_, name_);
      for (const Element& e : header_.elements) {
        if (!read_fixed_element(source, e, &e == &*vertex, layout, faces)) {
          read_element(source, e, &e == &*vertex, layout, faces);
        }
      }
    }
    check_finite(mesh_, name_);
    faces.finish(mesh_);
    if (mesh_.triangles.empty()) throw Error(name_ + ": has no faces");
    mesh_.name = name_;
    return std::move(mesh_);
  }

 private:
  static bool has_faces(const Element& e) { return e.name == "face" || e.name == "tristrips"; }

  template <class Source>
  void read_element(Source& source, const Element& e, bool is_vertex, const VertexLayout& layout, FaceList& faces) {
    if (is_vertex) {
      read_vertices(source, e, layout, mesh_);
    } else if (has_faces(e)) {
      note_face_properties(e);
      read_faces(source, e, e.name == "tristrips", faces);
    } else {
      notes_.add("PLY: element '" + e.name + "' is ignored");
      skip_element(source, e);
    }
  }

  /// False when the rows of `e` differ in size.
  bool read_fixed_element(BinarySource& source, const Element& e, bool is_vertex, const VertexLayout& layout,
                          FaceList& faces) {
    const char* rows = data_.data() + source.offset();
    const std::size_t bytes = data_.size() - source.offset();
    const bool swap = needs_swap(header_.encoding);
    if (is_vertex && !e.has_lists()) {
      source.skip(Type::uint8, e.count * e.minimum_row_bytes(header_.encoding));
      read_fixed_vertices(rows, e, swap, layout, mesh_);
      return true;
    }
    if (e.name != "face") return false;
    const auto triangles = triangle_rows(e, rows, bytes, swap);
    if (!triangles) return false;
    note_face_properties(e);
    source.skip(Type::uint8, e.count * triangles->stride);
    read_fixed_triangles(*triangles, rows, e.count, swap, name_, faces);
    return true;
  }

  void note_face_properties(const Element& e) {
    for (const Property& p : e.properties) {
      if (!p.is_face_list()) notes_.add("PLY: face property '" + p.name + "' is ignored");
    }
  }

  std::string_view data_;
  const std::string& name_;
  Notes& notes_;
  Header header_;
  TriangleMesh mesh_;
};

}  // namespace
}  // namespace ply

TriangleMesh read_ply(std::span<const std::byte> data, const std::string& name, Notes& notes) {
  return ply::Reader({reinterpret_cast<const char*>(data.data()), data.size()}, name, notes).read();
}

}  // namespace lambert

#include "lambert/base/number.h"
#include "lambert/formats/input_file.h"
#include "lambert/formats/obj/lines.h"
#include "lambert/formats/obj/mesh_builder.h"
#include "lambert/formats/obj/mtl_material.h"
#include "lambert/formats/readers.h"

#include <algorithm>
#include <array>
#include <map>
#include <tuple>

namespace lambert {
namespace obj {
namespace {

/// Statements that change nothing here: lines and points, free-form geometry, display attributes.
constexpr std::array<std::string_view, 31> ignored_statements{
    "p",      "l",      "vp",         "cstype",    "deg",   "bmat",  "step", "curv",  "curv2",    "surf",     "parm",
    "trim",   "hole",   "scrv",       "sp",        "end",   "con",   "mg",   "bevel", "c_interp", "d_interp", "lod",
    "usemap", "maplib", "shadow_obj", "trace_obj", "ctech", "stech", "call", "csh",   "vw"};

/// What decides to which surface a face goes.
struct SurfaceKey {
  std::string group, material;
  std::uint32_t smoothing = 0;  ///< 0: flat; not used by faces with normals
  bool has_normals = false;
  auto operator<=>(const SurfaceKey&) const = default;
};

class Reader {
 public:
  Reader(std::string_view text, const std::string& name, const std::filesystem::path& folder, Notes& notes)
      : lines_(text, name), name_(name), folder_(folder), notes_(notes) {}

  SceneGraph read() {
    while (lines_.next(words_)) parse_statement(words_.next());
    if (surfaces_.empty()) throw Error(name_ + ": has no faces");
    SceneGraph graph;
    graph.name = name_;
    for (auto& [key, builder] : surfaces_) add_surface(graph, key, builder);
    return graph;
  }

 private:
  void parse_statement(std::string_view key) {
    if (key == "v") {
      parse_position();
    } else if (key == "vt") {
      const float u = words_.number("a texture coordinate");
      data_.uvs.emplace_back(u, words_.try_number().value_or(0));
    } else if (key == "vn") {
      data_.normals.push_back(parse_vector("a normal"));
    } else if (key == "f" || key == "fo") {
      parse_face();
    } else if (key == "usemtl") {
      set(&SurfaceKey::material, words_.rest());
    } else if (key == "o" || key == "g") {
      set(&SurfaceKey::group, words_.rest());
    } else if (key == "s") {
      parse_smoothing();
    } else if (key == "mtllib") {
      parse_library();
    } else if (!key.empty()) {
      ignore(key);
    }
  }

  void ignore(std::string_view key) {
    const bool is_word = std::all_of(key.begin(), key.end(), [](char c) { return c > ' ' && c <= '~'; });
    if (!is_word || key.size() > 32) words_.fail("'" + printable(key) + "' is no OBJ statement");
    const bool is_known =
        std::find(ignored_statements.begin(), ignored_statements.end(), key) != ignored_statements.end();
    notes_.add((is_known ? "OBJ: '" : "OBJ: the unknown statement '") + std::string(key) + "' is ignored");
  }

  Vec3 parse_vector(const char* what) {
    const float x = words_.number(what), y = words_.number(what);
    return {x, y, words_.number(what)};
  }

  // x y z, then perhaps a weight, or the vertex' colour.
  void parse_position() {
    const Vec3 p = parse_vector("a coordinate");
    if (data_.positions.size() >= no_index) words_.fail("there are too many vertices");
    data_.positions.push_back(p);
    const auto first = words_.try_number(), g = words_.try_number(), b = words_.try_number();
    if (b) data_.colours.resize(data_.positions.size() - 1, Vec4(1));
    if (b || !data_.colours.empty()) data_.colours.push_back(b ? Vec4(*first, *g, *b, 1) : Vec4(1));
  }

  /// Counts from 1, or backwards from the end.
  std::uint32_t parse_index(std::string_view word, std::size_t count, const char* what) const {
    std::int64_t index = 0;
    if (parse_int(word.data(), word.data() + word.size(), index) != word.data() + word.size()) {
      words_.fail(std::string("expected the index of ") + what + ", found '" + printable(word) + "'");
    }
    const auto size = static_cast<std::int64_t>(count);
    if (index == 0 || index > size || index < -size) {
      words_.fail(std::string("there is no ") + what + " " + std::to_string(index) + ": the file has given " +
                  std::to_string(count) + " so far");
    }
    return static_cast<std::uint32_t>(index > 0 ? index - 1 : size + index);
  }

  Corner parse_corner(std::string_view word) const {
    const auto take = [&] {
      const std::size_t slash = std::min(word.find('/'), word.size());
      const std::string_view part = word.substr(0, slash);
      word.remove_prefix(std::min(slash + 1, word.size()));
      return part;
    };
    Corner c;
    c.position = parse_index(take(), data_.positions.size(), "vertex");
    if (const auto uv = take(); !uv.empty()) c.uv = parse_index(uv, data_.uvs.size(), "texture coordinate");
    if (const auto n = take(); !n.empty()) c.normal = parse_index(n, data_.normals.size(), "normal");
    if (!word.empty()) words_.fail("a corner has at most three indices");
    // A zero normal is none.
    if (c.normal != no_index && !(length_squared(data_.normals[c.normal]) > 0)) c.normal = no_index;
    return c;
  }

  void parse_face() {
    face_.clear();
    for (std::string_view word = words_.next(); !word.empty(); word = words_.next())
      face_.push_back(parse_corner(word));
    if (face_.size() < 3) {
      notes_.add("OBJ: faces with fewer than 3 corners are ignored");
      return;
    }
    const bool has_normals =
        std::all_of(face_.begin(), face_.end(), [](const Corner& c) { return c.normal != no_index; });
    if (!has_normals) {
      for (Corner& c : face_) c.normal = no_index;
    }
    if (!builder_ || key_.has_normals != has_normals) {
      key_.has_normals = has_normals;
      SurfaceKey key = key_;
      if (has_normals) key.smoothing = 0;
      builder_ = &surfaces_[key];
    }
    builder_->add_face(face_, data_);
  }

  void set(std::string SurfaceKey::*member, std::string_view value) {
    key_.*member = std::string(value);
    builder_ = nullptr;
  }

  void parse_smoothing() {
    const std::string_view word = words_.next();
    std::int64_t group = 0;
    if (word != "off" && parse_int(word.data(), word.data() + word.size(), group) != word.data() + word.size()) {
      words_.fail("expected a smoothing group or 'off', found '" + printable(word) + "'");
    }
    key_.smoothing = static_cast<std::uint32_t>(group);
    builder_ = nullptr;
  }

  void parse_library() {
    const std::string all(words_.rest());
    std::error_code ignored;
    if (std::filesystem::exists(folder_ / all, ignored)) {
      read_library(all);
      return;
    }
    Words names(all, 0, &name_);
    for (auto file = names.next(); !file.empty(); file = names.next()) read_library(std::string(file));
  }

  void read_library(std::string file) {
    std::replace(file.begin(), file.end(), '\\', '/');
    const std::filesystem::path path = folder_ / file;
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) {
      notes_.add("OBJ: the material library '" + printable(file) + "' is missing");
      return;
    }
    const InputFile content(path);
    parse_mtl(content.text(), path.string(), library_, notes_);
  }

  const ConvertedMaterial& material(SceneGraph& graph, const std::string& name) {
    if (const auto known = materials_.find(name); known != materials_.end()) return known->second;
    const auto found = library_.find(name);
    if (found != library_.end())
      return materials_[name] = add_mtl_material(graph, name, found->second, folder_, notes_);
    if (!name.empty()) notes_.add("OBJ: the material '" + printable(name) + "' is missing: grey instead");
    Material grey;
    grey.name = name.empty() ? "default" : name;
    return materials_[name] = {graph.materials.add(std::move(grey)), std::nullopt};
  }

  void add_surface(SceneGraph& graph, const SurfaceKey& key, MeshBuilder& builder) {
    TriangleMesh mesh = builder.finish(key.smoothing != 0);
    if (mesh.triangles.empty()) return;
    mesh.name = key.group.empty() ? name_ : key.group;
    const ConvertedMaterial& m = material(graph, key.material);
    const NodeId node = graph.add_node(graph.root(), mesh.name);
    Surface surface;
    surface.geometry = graph.add_geometry(std::move(mesh));
    surface.material = m.material;
    surface.emission = m.emission;
    graph.add_surface(node, surface);
  }

  LineReader lines_;
  Words words_;
  const std::string& name_;
  const std::filesystem::path& folder_;
  Notes& notes_;
  VertexData data_;
  std::vector<Corner> face_;
  SurfaceKey key_;
  std::map<SurfaceKey, MeshBuilder> surfaces_;
  MeshBuilder* builder_ = nullptr;
  MtlLibrary library_;
  std::map<std::string, ConvertedMaterial, std::less<>> materials_;
};

}  // namespace
}  // namespace obj

SceneGraph read_obj(std::string_view text, const std::string& name, const std::filesystem::path& folder, Notes& notes) {
  return obj::Reader(text, name, folder, notes).read();
}

}  // namespace lambert

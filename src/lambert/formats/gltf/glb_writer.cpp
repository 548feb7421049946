#include "lambert/base/error.h"
#include "lambert/formats/little_endian.h"
#include "lambert/formats/write_mesh.h"

#include <nlohmann/json.hpp>

#include <limits>
#include <span>

namespace lambert {
namespace {

using Json = nlohmann::ordered_json;

/// The binary chunk, and the views and accessors that name its parts.
class Buffer {
 public:
  template <class T>
  std::size_t add(std::span<const T> items, const char* type, int component, int target) {
    views_.push_back(
        {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", items.size_bytes()}, {"target", target}});
    bytes_.append(reinterpret_cast<const char*>(items.data()), items.size_bytes());
    const std::size_t numbers = items.size() * (std::string_view(type) == "SCALAR" ? 3 : 1);
    accessors_.push_back(
        {{"bufferView", views_.size() - 1}, {"componentType", component}, {"count", numbers}, {"type", type}});
    return accessors_.size() - 1;
  }

  Json& accessor(std::size_t i) { return accessors_[i]; }
  const std::string& bytes() const { return bytes_; }
  void describe(Json& document) const {
    document["accessors"] = accessors_;
    document["bufferViews"] = views_;
    document["buffers"] = {{{"byteLength", bytes_.size()}}};
  }

 private:
  std::string bytes_;
  Json views_ = Json::array(), accessors_ = Json::array();
};

void append_chunk(std::string& out, std::uint32_t type, std::string content, char padding) {
  content.append((4 - content.size() % 4) % 4, padding);
  append_bytes(out, static_cast<std::uint32_t>(content.size()));
  append_bytes(out, type);
  out += content;
}

}  // namespace

std::string glb_of(const TriangleMesh& mesh) {
  constexpr int floats = 5126, unsigned_ints = 5125, vertices = 34962, indices = 34963;
  Json document = {{"asset", {{"version", "2.0"}, {"generator", "lambert"}}}};
  Json mesh_json = Json::object();
  if (!mesh.name.empty()) mesh_json["name"] = mesh.name;
  Buffer buffer;
  if (!mesh.triangles.empty()) {
    Json primitive = {{"material", 0}};
    const std::size_t positions = buffer.add(std::span(mesh.positions), "VEC3", floats, vertices);
    const Bounds3 box = mesh.bounds();
    buffer.accessor(positions)["min"] = {box.min.x, box.min.y, box.min.z};
    buffer.accessor(positions)["max"] = {box.max.x, box.max.y, box.max.z};
    primitive["attributes"]["POSITION"] = positions;
    if (!mesh.normals.empty())
      primitive["attributes"]["NORMAL"] = buffer.add(std::span(mesh.normals), "VEC3", floats, vertices);
    if (!mesh.uvs.empty())
      primitive["attributes"]["TEXCOORD_0"] = buffer.add(std::span(mesh.uvs), "VEC2", floats, vertices);
    primitive["indices"] = buffer.add(std::span(mesh.triangles), "SCALAR", unsigned_ints, indices);
    mesh_json["primitives"] = {primitive};
    document["materials"] = {{{"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", 1}}}}};
    document["meshes"] = {mesh_json};
    document["nodes"] = {{{"mesh", 0}}};
    buffer.describe(document);
  } else {
    document["nodes"] = {Json::object()};
  }
  document["scenes"] = {{{"nodes", {0}}}};
  document["scene"] = 0;

  std::string chunks;
  append_chunk(chunks, 0x4E4F534A, document.dump(), ' ');
  if (!buffer.bytes().empty()) append_chunk(chunks, 0x004E4942, buffer.bytes(), '\0');
  if (chunks.size() > std::numeric_limits<std::uint32_t>::max() - 12)
    throw Error("a mesh of more than 4 GB does not fit a GLB");
  std::string out = "glTF";
  append_bytes(out, std::uint32_t{2});
  append_bytes(out, static_cast<std::uint32_t>(chunks.size() + 12));
  return out + chunks;
}

}  // namespace lambert

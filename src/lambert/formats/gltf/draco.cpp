#include "lambert/formats/gltf/draco.h"

#include "lambert/base/number.h"

#include <draco/compression/decode.h>
#include <draco/compression/point_cloud/point_cloud_decoder.h>
#include <draco/core/varint_decoding.h>
#include <draco/metadata/metadata_decoder.h>

#include <exception>
#include <memory>

namespace lambert::gltf {
namespace {

struct Size {
  std::uint32_t faces = 0, points = 0;
};

/// The counts at the start of the data (Draco bitstream specification, 2.2), which the decoder would believe.
Size announced_size(draco::DecoderBuffer buffer, const JsonView& place) {
  const auto fail = [&] { place.fail("the Draco data are malformed or of an old version"); };
  draco::DracoHeader header;
  if (!draco::PointCloudDecoder::DecodeHeader(&buffer, &header).ok()) fail();
  if (header.encoder_type != draco::TRIANGULAR_MESH) place.fail("the Draco data hold no triangle mesh");
  if (header.version_major != 2 || header.version_minor != 2) fail();
  buffer.set_bitstream_version(
      static_cast<std::uint16_t>(DRACO_BITSTREAM_VERSION(header.version_major, header.version_minor)));
  if (header.flags & METADATA_FLAG_MASK) {
    draco::GeometryMetadata metadata;
    if (!draco::MetadataDecoder().DecodeGeometryMetadata(&buffer, &metadata)) fail();
  }
  Size size;
  bool ok = true;
  if (header.encoder_method == draco::MESH_EDGEBREAKER_ENCODING) {
    std::uint8_t traversal = 0;
    ok = buffer.Decode(&traversal) && draco::DecodeVarint(&size.points, &buffer) &&
         draco::DecodeVarint(&size.faces, &buffer);
  } else {
    ok = draco::DecodeVarint(&size.faces, &buffer) && draco::DecodeVarint(&size.points, &buffer);
  }
  if (!ok) fail();
  return size;
}

DracoMesh::Attribute read_attribute(Document& document, const draco::Mesh& mesh, const JsonView& id,
                                    const Accessor& accessor) {
  const std::size_t unique_id = id.count();
  const draco::PointAttribute* source =
      unique_id > 0xffffffffu ? nullptr : mesh.GetAttributeByUniqueId(static_cast<std::uint32_t>(unique_id));
  if (!source) id.fail("the Draco data have no such attribute");
  DracoMesh::Attribute attribute;
  attribute.components = accessor.components();
  if (source->num_components() != attribute.components) id.fail("has another number of components than its accessor");
  document.budget.charge(mesh.num_points(), attribute.components * sizeof(float), id);
  attribute.floats.resize(mesh.num_points() * attribute.components);
  const bool normalizes = accessor.normalized() && !source->normalized();
  const float scale = normalizes ? normalization(accessor.type()) : 1;
  for (std::uint32_t i = 0; i < mesh.num_points(); ++i) {
    float* out = attribute.floats.data() + i * attribute.components;
    if (!source->ConvertValue<float>(source->mapped_index(draco::PointIndex(i)), out)) id.fail("cannot be converted");
    for (std::size_t c = 0; c < attribute.components; ++c) out[c] *= scale;
  }
  return attribute;
}

std::unique_ptr<draco::Mesh> decode(draco::DecoderBuffer& buffer, const JsonView& place) {
  try {
    auto mesh = draco::Decoder().DecodeMeshFromBuffer(&buffer);
    if (mesh.ok()) return std::move(mesh).value();
    place.fail("the Draco data are malformed: " + printable(mesh.status().error_msg_string()));
  } catch (const std::bad_alloc&) {
    place.fail("the Draco data ask for more memory than there is");
  }
}

}  // namespace

DracoMesh decode_draco(Document& document, const JsonView& primitive) {
  const JsonView json = primitive.extension("KHR_draco_mesh_compression");
  const auto bytes = document.buffers.view(json["bufferView"]).bytes;
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const Size announced = announced_size(buffer, json);
  const std::size_t index_count = document.accessor(primitive["indices"]).count();
  if (3 * std::size_t{announced.faces} > index_count)
    json.fail("the Draco data announce " + std::to_string(announced.faces) + " faces, but the indices are " +
              std::to_string(index_count));
  document.budget.charge(announced.faces, 100, json);
  document.budget.charge(announced.points, 100, json);

  const std::unique_ptr<draco::Mesh> mesh = decode(buffer, json);
  DracoMesh out;
  out.vertex_count = mesh->num_points();
  out.indices.reserve(std::size_t{mesh->num_faces()} * 3);
  for (draco::FaceIndex f(0); f < mesh->num_faces(); ++f)
    for (const draco::PointIndex& p : mesh->face(f)) out.indices.push_back(p.value());
  for (const std::string& name : json["attributes"].keys()) {
    const Accessor accessor = document.accessor(primitive["attributes"][name]);
    out.attributes.emplace(name, read_attribute(document, *mesh, json["attributes"][name], accessor));
  }
  return out;
}

}  // namespace lambert::gltf

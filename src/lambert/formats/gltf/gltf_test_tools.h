#pragma once
/// Small glTF documents, built in memory.

#include "lambert/formats/format_test_tools.h"
#include "lambert/formats/gltf/document.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstring>
#include <span>
#include <type_traits>

namespace lambert::gltf {

/// RFC 4648, 4, with padding.
inline std::string base64(std::string_view bytes) {
  static constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : digits[bits >> (18 - 6 * k) & 63];
  }
  return text;
}

inline std::string as_bytes_of(const auto& numbers) {
  std::string bytes(numbers.size() * sizeof(numbers[0]), '\0');
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

template <class T>
constexpr int component_code() {
  if constexpr (std::is_floating_point_v<T>) return 5126;
  return 5120 + (sizeof(T) == 4 ? 5 : (sizeof(T) == 2 ? 2 : 0) + (std::is_unsigned_v<T> ? 1 : 0));
}

/// A document with one buffer, which becomes a data URI or the binary chunk of a GLB.
class TestDocument {
 public:
  nlohmann::json json = nlohmann::json::parse(R"({"asset": {"version": "2.0"}})");

  nlohmann::json& operator[](const char* member) { return json[member]; }
  /// Sets a member to a piece of JSON.
  TestDocument& set(const char* member, std::string_view text) {
    json[member] = nlohmann::json::parse(text);
    return *this;
  }
  std::size_t view(std::string_view bytes, int stride = 0) {
    buffer_.resize((buffer_.size() + 3) / 4 * 4);
    nlohmann::json v;
    v["buffer"] = 0;
    v["byteOffset"] = buffer_.size();
    v["byteLength"] = bytes.size();
    if (stride != 0) v["byteStride"] = stride;
    buffer_ += bytes;
    json["bufferViews"].push_back(v);
    return json["bufferViews"].size() - 1;
  }
  std::size_t accessor_on(std::size_t view, int code, const char* type, std::size_t count, std::size_t offset = 0) {
    nlohmann::json a;
    a["bufferView"] = view;
    a["byteOffset"] = offset;
    a["componentType"] = code;
    a["type"] = type;
    a["count"] = count;
    json["accessors"].push_back(a);
    return json["accessors"].size() - 1;
  }
  template <class T>
  std::size_t accessor(const char* type, const std::vector<T>& numbers, bool normalized = false) {
    static const std::map<std::string_view, std::size_t> widths{
        {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};
    const std::size_t index =
        accessor_on(view(as_bytes_of(numbers)), component_code<T>(), type, numbers.size() / widths.at(type));
    if (normalized) json["accessors"][index]["normalized"] = true;
    return index;
  }
  std::string text() const {
    nlohmann::json whole = with_buffer();
    if (!buffer_.empty()) whole["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(buffer_);
    return whole.dump();
  }
  std::string glb() const {
    std::string content = with_buffer().dump(), binary = buffer_;
    content.resize((content.size() + 3) / 4 * 4, ' ');
    binary.resize((binary.size() + 3) / 4 * 4);
    return "glTF" + words({2, 28 + content.size() + binary.size(), content.size()}) + "JSON" + content +
           words({binary.size()}) + std::string("BIN\0", 4) + binary;
  }
  /// Little-endian, 32 bits each.
  static std::string words(const std::vector<std::size_t>& values) {
    std::vector<std::uint32_t> narrow(values.begin(), values.end());
    return as_bytes_of(narrow);
  }

 private:
  nlohmann::json with_buffer() const {
    nlohmann::json whole = json;
    if (!buffer_.empty()) whole["buffers"][0]["byteLength"] = buffer_.size();
    return whole;
  }
  std::string buffer_;
};

/// One right triangle in the plane z = 0 that faces +z, shown by node 0.
inline TestDocument triangle_document() {
  TestDocument d;
  d.set("nodes", R"([{"mesh": 0}])").set("meshes", R"([{"primitives": [{"attributes": {}}]}])");
  d["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = d.accessor<float>("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0});
  return d;
}
inline nlohmann::json& primitive(TestDocument& d) { return d["meshes"][0]["primitives"][0]; }

inline SceneGraph read(const std::string& text, Notes& notes, const ReadSettings& settings = {},
                       const std::filesystem::path& folder = {}) {
  return read_gltf(std::as_bytes(std::span(text.data(), text.size())), "t.gltf", folder, settings, notes);
}
inline SceneGraph read(const TestDocument& d, const ReadSettings& settings = {}) {
  Notes notes;
  return read(d.text(), notes, settings);
}
inline std::string refusal(const TestDocument& d, const ReadSettings& settings = {}) {
  return error_of([&] { read(d, settings); });
}
inline Notes notes_of(const TestDocument& d) {
  Notes notes;
  read(d.text(), notes);
  return notes;
}
inline const TriangleMesh& mesh_of(const SceneGraph& graph, std::size_t i = 0) {
  return geometry_as<TriangleMesh>(graph, shown(graph).at(i).surface);
}

/// A document taken apart but not yet read.
struct OpenDocument {
  explicit OpenDocument(const TestDocument& d)
      : text(d.text()), document(std::as_bytes(std::span(text.data(), text.size())), "t.gltf", {}, settings, notes) {}
  std::string text;
  ReadSettings settings;
  Notes notes;
  Document document;
};

}  // namespace lambert::gltf

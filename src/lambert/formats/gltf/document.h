#pragma once
#include "lambert/base/notes.h"
#include "lambert/formats/gltf/accessors.h"
#include "lambert/formats/gltf/budget.h"
#include "lambert/formats/gltf/buffers.h"
#include "lambert/formats/gltf/container.h"
#include "lambert/formats/gltf/json.h"
#include "lambert/formats/read_scene.h"

#include <filesystem>
#include <span>
#include <string>

namespace lambert::gltf {

/// A parsed document and what all parts of the reader share. It must not move: views point into it.
struct Document {
  Document(std::span<const std::byte> data, const std::string& file_name, std::filesystem::path where,
           const ReadSettings& read_settings, Notes& notes_to_fill);
  Document(const Document&) = delete;
  Document& operator=(const Document&) = delete;

  JsonView root() const { return {json, name}; }
  JsonView referred(const char* array, const JsonView& reference) const {
    return gltf::referred(root(), array, reference);
  }
  Accessor accessor(const JsonView& reference) { return {root(), reference, buffers, budget}; }

  std::string name;
  std::filesystem::path folder;  ///< of relative URIs; empty: there are no files
  const ReadSettings& settings;
  Notes& notes;
  Budget budget;
  Container container;
  Json json;
  Buffers buffers;
};

}  // namespace lambert::gltf

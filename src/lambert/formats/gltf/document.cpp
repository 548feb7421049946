#include "lambert/formats/gltf/document.h"

#include <utility>

namespace lambert::gltf {

// tinygltf is not used: it knows no places for errors, decodes all images at once and trusts counts.
Document::Document(std::span<const std::byte> data, const std::string& file_name, std::filesystem::path where,
                   const ReadSettings& read_settings, Notes& notes_to_fill)
    : name(file_name),
      folder(std::move(where)),
      settings(read_settings),
      notes(notes_to_fill),
      container(split_container(data, name)),
      json(parse_json(container.json, name)),
      buffers(root(), container.binary, folder, budget) {
  budget.earn(data.size());
}

}  // namespace lambert::gltf

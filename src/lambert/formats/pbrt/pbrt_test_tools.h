#pragma once
#include "lambert/formats/format_test_tools.h"

namespace lambert {

/// A scene whose world is `world`; `settings` stands before WorldBegin, all on one line, so that the world starts on
/// line 2.
inline SceneGraph read_world(const std::string& world, Notes& notes, const std::string& settings = "",
                             const std::filesystem::path& folder = {}) {
  return read_pbrt(settings + " WorldBegin\n" + world, "s.pbrt", folder, notes);
}
inline SceneGraph read_world(const std::string& world) {
  Notes notes;
  return read_world(world, notes);
}
/// The same, expecting that nothing was ignored.
inline SceneGraph read_whole_world(const std::string& world) {
  Notes notes;
  SceneGraph graph = read_world(world, notes);
  for (const auto& [note, count] : notes.counts()) ADD_FAILURE() << "unexpected note: " << note;
  return graph;
}

}  // namespace lambert

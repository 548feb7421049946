#include "lambert/formats/pbrt/builder.h"
#include "lambert/formats/pbrt/parser.h"
#include "lambert/formats/readers.h"

namespace lambert {

SceneGraph read_pbrt(std::string_view text, const std::string& name, const std::filesystem::path& folder,
                     Notes& notes) {
  SceneGraph graph;
  graph.name = name;
  pbrt::Builder builder(graph, notes, folder);
  pbrt::Parser(builder).parse(text, name);
  return graph;
}

}  // namespace lambert

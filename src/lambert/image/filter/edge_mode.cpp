#include "lambert/image/filter/edge_mode.h"

#include "lambert/base/error.h"

#include <algorithm>

namespace lambert {

std::vector<std::string> edge_mode_names() { return {"repeat", "mirror", "clamp", "black"}; }

EdgeMode edge_mode(std::string_view name) {
  const std::vector<std::string> names = edge_mode_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) throw Error("unknown edge mode " + unknown_word(name, names));
  return static_cast<EdgeMode>(found - names.begin());
}

}  // namespace lambert

#include "lambert/image/formats/exr_names.h"

#include "lambert/image/channels.h"

#include <algorithm>
#include <set>

namespace lambert {
namespace {

std::string part_word(const std::vector<std::string>& part_names, std::size_t part) {
  return part_names[part].empty() ? "part" + std::to_string(part) : part_names[part];
}

}  // namespace

std::size_t main_part(const std::vector<std::string>& part_names) {
  static constexpr std::string_view words[] = {"rgba", "rgb", "beauty", "color"};
  const auto found = std::ranges::find_if(
      part_names, [](const std::string& name) { return std::ranges::find(words, lower(name)) != std::end(words); });
  return found == part_names.end() ? 0 : static_cast<std::size_t>(found - part_names.begin());
}

std::vector<ExrChannel> named_channels(const std::vector<std::string>& part_names,
                                       const std::vector<std::vector<std::string>>& channels) {
  const std::size_t main = main_part(part_names);
  std::set<std::string> taken(channels[main].begin(), channels[main].end());
  std::vector<ExrChannel> result;
  for (std::size_t part = 0; part < channels.size(); ++part) {
    const std::string prefix = part_word(part_names, part) + ".";
    for (const std::string& stored : channels[part]) {
      std::string name = stored;
      if (part != main) {
        if (!name.starts_with(prefix)) name = prefix + name;
        while (!taken.insert(name).second) name = std::to_string(part) + "." + name;
      }
      result.push_back({stored, name, part});
    }
  }
  return result;
}

std::vector<std::size_t> colour_first(const std::vector<std::string>& names) {
  std::vector<std::size_t> order;
  for (const char* first : {"R", "G", "B", "Y", "A"})
    if (const auto at = std::ranges::find(names, first); at != names.end())
      order.push_back(static_cast<std::size_t>(at - names.begin()));
  const std::vector<std::size_t> first = order;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (std::ranges::find(first, i) == first.end()) order.push_back(i);
  return order;
}

}  // namespace lambert

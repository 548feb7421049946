#include "lambert/render/method.h"

#include "lambert/base/error.h"
#include "lambert/render/path/path_method.h"

#include <functional>

namespace lambert {
namespace {

struct Entry {
  const char* name;
  std::function<std::unique_ptr<Method>()> make;
};

/// Every method has its line here; CONTRIBUTING says how to add one.
const std::vector<Entry>& methods() {
  static const std::vector<Entry> table{
      {"path", [] { return std::make_unique<PathMethod>(); }},
  };
  return table;
}

}  // namespace

std::unique_ptr<Method> make_method(std::string_view name) {
  for (const Entry& e : methods())
    if (name == e.name) return e.make();
  throw Error("unknown method " + unknown_word(name, method_names()));
}

std::vector<std::string> method_names() {
  std::vector<std::string> names;
  for (const Entry& e : methods()) names.emplace_back(e.name);
  return names;
}

}  // namespace lambert

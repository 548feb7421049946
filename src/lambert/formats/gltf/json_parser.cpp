#include "lambert/base/json_events.h"
#include "lambert/formats/gltf/json.h"

namespace lambert::gltf {
namespace {

/// Builds the tree from the events of the text.
class Builder : public JsonEvents {
 public:
  Json take() { return std::move(root_); }

  void null(TextRange) override { place() = {}; }
  void boolean(bool b, TextRange) override { place() = {b}; }
  void number(double d, TextRange) override { place() = {d}; }
  void string(std::string s, TextRange) override { place() = {std::move(s)}; }
  void key(std::string k, TextRange) override { key_ = std::move(k); }
  void begin_object(TextRange) override { open({Json::Object{}}); }
  void begin_array(TextRange) override { open({Json::Array{}}); }
  void end_object(TextRange) override { open_.pop_back(); }
  void end_array(TextRange) override { open_.pop_back(); }

 private:
  Json& place() {
    if (open_.empty()) return root_;
    if (auto* array = std::get_if<Json::Array>(&open_.back()->value)) return array->emplace_back();
    return std::get<Json::Object>(open_.back()->value).emplace_back(Json::Member{std::move(key_), {}}).value;
  }
  void open(Json container) {
    Json& at = place();
    at = std::move(container);
    open_.push_back(&at);
  }

  Json root_;
  std::string key_;
  std::vector<Json*> open_;  // stable: a container grows only while it is the last one
};

}  // namespace

Json parse_json(std::string_view text, const std::string& name) {
  Builder builder;
  parse_json_events(text, name, builder);
  return builder.take();
}

}  // namespace lambert::gltf

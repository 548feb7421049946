#include "lambert/image/composite/json_tree.h"

namespace lambert::composite {
namespace {

class Builder final : public JsonEvents {
 public:
  void null(TextRange at) override { add({.at = at}); }
  void boolean(bool value, TextRange at) override {
    add({.kind = JsonKind::boolean, .number = value ? 1.0 : 0.0, .at = at});
  }
  void number(double value, TextRange at) override { add({.kind = JsonKind::number, .number = value, .at = at}); }
  void string(std::string value, TextRange at) override {
    add({.kind = JsonKind::string, .string = std::move(value), .at = at});
  }
  void begin_array(TextRange at) override { open_.push_back({.kind = JsonKind::array, .at = at}); }
  void end_array(TextRange at) override { close(at); }
  void begin_object(TextRange at) override { open_.push_back({.kind = JsonKind::object, .at = at}); }
  void key(std::string name, TextRange at) override { open_.back().keys.emplace_back(std::move(name), at); }
  void end_object(TextRange at) override { close(at); }

  JsonValue root;

 private:
  void add(JsonValue value) {
    if (open_.empty())
      root = std::move(value);
    else
      open_.back().values.push_back(std::move(value));
  }
  void close(TextRange at) {
    JsonValue value = std::move(open_.back());
    open_.pop_back();
    value.at.end = at.end;
    add(std::move(value));
  }
  std::vector<JsonValue> open_;
};

}  // namespace

JsonValue parse_json_tree(std::string_view text, const std::string& name) {
  Builder builder;
  parse_json_events(text, name, builder);
  return std::move(builder.root);
}

}  // namespace lambert::composite

#include "lambert/base/error.h"
#include "lambert/formats/gltf/json.h"
#include "lambert/formats/number.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace lambert::gltf {
namespace {

constexpr std::size_t max_depth = 256;

SourceLocation location_of(std::string_view text, const std::string& name, std::size_t offset) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  const std::size_t line_start = before.rfind('\n') + 1;
  const auto lines = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
  return {name, lines + 1, std::max<std::size_t>(before.size() - line_start, 1)};
}

/// Builds the tree from nlohmann's events.
class Builder {
 public:
  Builder(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  Json take() { return std::move(root_); }

  bool null() { return add({}); }
  bool boolean(bool b) { return add({b}); }
  bool number_integer(std::int64_t i) { return add({static_cast<double>(i)}); }
  bool number_unsigned(std::uint64_t i) { return add({static_cast<double>(i)}); }
  bool number_float(double d, const std::string&) { return add({d}); }
  bool string(std::string& s) { return add({std::move(s)}); }
  bool binary(nlohmann::json::binary_t&) { return false; }
  bool key(std::string& k) {
    key_ = std::move(k);
    return true;
  }
  bool start_object(std::size_t) { return open({Json::Object{}}); }
  bool start_array(std::size_t) { return open({Json::Array{}}); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }

  bool parse_error(std::size_t position, const std::string& token, const nlohmann::json::exception& e) {
    const std::string_view what = e.what();
    const std::size_t expected = what.rfind("; expected ");
    std::string why = what.find("out_of_range") != what.npos ? "this number is too large" : "malformed JSON";
    if (!token.empty()) why += " at '" + printable(token) + "'";
    if (expected != what.npos) why += ": expected " + std::string(what.substr(expected + 11));
    throw Error(location_of(text_, name_, position), why);
  }

 private:
  bool add(Json value) {
    place() = std::move(value);
    return true;
  }
  Json& place() {
    if (open_.empty()) return root_;
    if (auto* array = std::get_if<Json::Array>(&open_.back()->value)) return array->emplace_back();
    return std::get<Json::Object>(open_.back()->value).emplace_back(Json::Member{std::move(key_), {}}).value;
  }
  bool open(Json container) {
    if (open_.size() == max_depth) throw Error(name_ + ": JSON nested deeper than " + std::to_string(max_depth));
    Json& at = place();
    at = std::move(container);
    open_.push_back(&at);
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  std::string_view text_;
  const std::string& name_;
  Json root_;
  std::string key_;
  std::vector<Json*> open_;  // stable: a container grows only while it is the last one
};

}  // namespace

Json parse_json(std::string_view text, const std::string& name) {
  Builder builder(text, name);
  nlohmann::json::sax_parse(text.begin(), text.end(), &builder);
  return builder.take();
}

}  // namespace lambert::gltf

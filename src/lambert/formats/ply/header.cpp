#include "lambert/formats/ply/header.h"

#include "lambert/base/error.h"
#include "lambert/base/number.h"

#include <algorithm>
#include <array>
#include <utility>

namespace lambert::ply {
namespace {

constexpr std::array<std::pair<std::string_view, Type>, 16> type_names{{{"char", Type::int8},
                                                                        {"uchar", Type::uint8},
                                                                        {"short", Type::int16},
                                                                        {"ushort", Type::uint16},
                                                                        {"int", Type::int32},
                                                                        {"uint", Type::uint32},
                                                                        {"float", Type::float32},
                                                                        {"double", Type::float64},
                                                                        {"int8", Type::int8},
                                                                        {"uint8", Type::uint8},
                                                                        {"int16", Type::int16},
                                                                        {"uint16", Type::uint16},
                                                                        {"int32", Type::int32},
                                                                        {"uint32", Type::uint32},
                                                                        {"float32", Type::float32},
                                                                        {"float64", Type::float64}}};
constexpr std::size_t max_line_length = 4096;

class HeaderParser {
 public:
  HeaderParser(std::string_view data, const std::string& name) : data_(data), name_(name) {}

  Header parse() {
    next_line();
    if (next_word() != "ply") fail("not a PLY file: the first line must be 'ply'");
    bool has_format = false;
    for (;;) {
      next_line();
      const std::string_view keyword = next_word();
      if (keyword == "end_header") break;
      if (keyword == "format") {
        parse_format();
        has_format = true;
      } else if (keyword == "element") {
        parse_element();
      } else if (keyword == "property") {
        parse_property();
      } else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info") {
        fail_at_word(
            "unknown header keyword " +
            unknown_word(printable(keyword), {"format", "element", "property", "comment", "obj_info", "end_header"}));
      }
    }
    if (!has_format) fail("the header has no 'format' line");
    header_.data_offset = offset_, header_.data_line = line_number_ + 1;
    check_counts();
    return std::move(header_);
  }

 private:
  [[noreturn]] void fail(const std::string& why) const { throw Error({name_, line_number_, 1}, why); }
  [[noreturn]] void fail_at_word(const std::string& why) const { throw Error({name_, line_number_, column_}, why); }

  void next_line() {
    const std::size_t end = data_.find('\n', offset_);
    ++line_number_;
    if (end == std::string_view::npos || end - offset_ > max_line_length) fail("the header has no 'end_header' line");
    line_ = data_.substr(offset_, end - offset_);
    if (!line_.empty() && line_.back() == '\r') line_.remove_suffix(1);
    offset_ = end + 1;
    position_ = 0;
  }

  std::string_view next_word() {
    position_ = std::min(line_.find_first_not_of(" \t", position_), line_.size());
    column_ = position_ + 1;
    const std::size_t end = std::min(line_.find_first_of(" \t", position_), line_.size());
    const std::string_view word = line_.substr(position_, end - position_);
    position_ = end;
    return word;
  }

  void parse_format() {
    const std::string_view word = next_word();
    if (word == "ascii") {
      header_.encoding = Encoding::ascii;
    } else if (word == "binary_little_endian") {
      header_.encoding = Encoding::little_endian;
    } else if (word == "binary_big_endian") {
      header_.encoding = Encoding::big_endian;
    } else {
      fail_at_word("unknown format " +
                   unknown_word(printable(word), {"ascii", "binary_little_endian", "binary_big_endian"}));
    }
  }

  void parse_element() {
    Element e;
    e.name = printable(next_word());
    e.line = line_number_;
    const std::string_view word = next_word();
    std::int64_t count = 0;
    const char* last = parse_int(word.data(), word.data() + word.size(), count);
    if (last != word.data() + word.size() || count < 0) {
      fail_at_word("expected the number of '" + e.name + "' elements, found '" + printable(word) + "'");
    }
    e.count = static_cast<std::size_t>(count);
    header_.elements.push_back(std::move(e));
  }

  void parse_property() {
    if (header_.elements.empty()) fail("a property must follow an element");
    Property p;
    std::string_view word = next_word();
    if (word == "list") {
      p.count_type = parse_type(next_word());
      if (!is_integer(*p.count_type)) fail_at_word("the count of a list must have an integer type");
      word = next_word();
    }
    p.type = parse_type(word);
    p.name = printable(next_word());
    if (p.name.empty()) fail_at_word("expected the name of the property");
    header_.elements.back().properties.push_back(std::move(p));
  }

  Type parse_type(std::string_view word) const {
    for (const auto& [type_name, type] : type_names) {
      if (type_name == word) return type;
    }
    std::vector<std::string> known;
    for (const auto& entry : type_names) known.emplace_back(entry.first);
    fail_at_word("unknown type " + unknown_word(printable(word), known));
  }

  // Before anything is allocated: a lying count must not cost memory.
  void check_counts() const {
    // The last ascii value needs no separator behind it.
    std::size_t left = data_.size() - offset_ + (header_.encoding == Encoding::ascii ? 1 : 0);
    for (const Element& e : header_.elements) {
      const std::size_t row = e.minimum_row_bytes(header_.encoding);
      if (row > 0 && e.count > left / row) {
        throw Error({name_, e.line, 1}, "promises " + std::to_string(e.count) + " '" + e.name +
                                            "' elements of at least " + std::to_string(row) + " bytes, but only " +
                                            std::to_string(left) + " bytes are left in the file");
      }
      left -= e.count * row;
    }
  }

  std::string_view data_;
  const std::string& name_;
  Header header_;
  std::string_view line_;
  std::size_t offset_ = 0, line_number_ = 0, position_ = 0, column_ = 1;
};

}  // namespace

std::size_t size_of(Type t) {
  constexpr std::array<std::size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(t)];
}

bool Element::has_lists() const {
  return std::any_of(properties.begin(), properties.end(), [](const Property& p) { return p.is_list(); });
}

std::size_t Element::minimum_row_bytes(Encoding e) const {
  std::size_t bytes = 0;
  for (const Property& p : properties) bytes += e == Encoding::ascii ? 2 : size_of(p.count_type.value_or(p.type));
  return bytes;
}

Header parse_header(std::string_view data, const std::string& name) { return HeaderParser(data, name).parse(); }

}  // namespace lambert::ply

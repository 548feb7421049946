#pragma once
/// The header of a PLY file (Turk, "The PLY Polygon File Format", 1994).

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lambert::ply {

enum class Type : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
std::size_t size_of(Type t);
inline bool is_integer(Type t) { return t < Type::float32; }

enum class Encoding : std::uint8_t { ascii, little_endian, big_endian };

struct Property {
  std::string name;
  Type type = Type::float32;
  std::optional<Type> count_type = {};  ///< of lists; always an integer type
  bool is_list() const { return count_type.has_value(); }
  /// The corners of a face or strip.
  bool is_face_list() const {
    return is_list() && is_integer(type) && (name == "vertex_indices" || name == "vertex_index");
  }
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
  std::size_t line = 0;  ///< where the header declares it
  bool has_lists() const;
  /// The least that one row takes in the file: lists empty, ascii values one digit and one separator.
  std::size_t minimum_row_bytes(Encoding e) const;
};

struct Header {
  Encoding encoding = Encoding::ascii;
  std::vector<Element> elements;
  std::size_t data_offset = 0, data_line = 0;  ///< just behind the line "end_header"
};

/// Throws Error with line and column, also when the counts promise more than the file holds.
Header parse_header(std::string_view data, const std::string& name);

}  // namespace lambert::ply

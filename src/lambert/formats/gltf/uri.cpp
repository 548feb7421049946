#include "lambert/formats/gltf/uri.h"

#include "lambert/base/number.h"

#include <array>
#include <cctype>
#include <cstdint>
#include <span>

namespace lambert::gltf {
namespace {

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

/// RFC 3986, 2.1; a '%' without two hexadecimal digits stays as it is.
std::string percent_decoded(std::string_view uri) {
  std::string out;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const int high = i + 2 < uri.size() && uri[i] == '%' ? hex_digit(uri[i + 1]) : -1;
    const int low = high >= 0 ? hex_digit(uri[i + 2]) : -1;
    if (low >= 0) i += 2;
    out += low >= 0 ? static_cast<char>(16 * high + low) : uri[i];
  }
  return out;
}

/// RFC 4648, 4: the value of each digit, 64 for what is none.
constexpr std::array<std::uint8_t, 256> base64_values() {
  std::array<std::uint8_t, 256> values{};
  values.fill(64);
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i < digits.size(); ++i) values[static_cast<unsigned char>(digits[i])] = std::uint8_t(i);
  return values;
}

std::vector<std::byte> decode_base64(std::string_view text, std::size_t offset, const JsonView& place) {
  static constexpr auto values = base64_values();
  const std::size_t length = text.find_last_not_of('=') + 1;
  if (text.size() - length > 2 || length % 4 == 1) place.fail("base64 data ends in the middle of a byte");
  std::vector<std::byte> bytes;
  bytes.reserve(length / 4 * 3 + 2);
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < length; ++i) {
    const std::uint8_t value = values[static_cast<unsigned char>(text[i])];
    if (value == 64)
      place.fail("'" + printable(text.substr(i, 1)) + "' at character " + std::to_string(offset + i) +
                 " is no base64 digit");
    bits = bits << 6 | value;
    const std::size_t have = 6 * (i % 4 + 1) % 8;  // bits beyond whole bytes
    if (i % 4 != 0) bytes.push_back(static_cast<std::byte>(bits >> have & 255));
  }
  return bytes;
}

/// "http:" and the like (RFC 3986, 3.1); a single letter is taken for part of a name.
bool has_scheme(std::string_view uri) {
  const std::size_t colon = uri.find_first_of(":/?#");
  return colon != uri.npos && colon > 1 && uri[colon] == ':' && std::isalpha(static_cast<unsigned char>(uri[0]));
}

}  // namespace

bool is_data_uri(std::string_view uri) { return uri.starts_with("data:"); }

std::vector<std::byte> decode_data_uri(std::string_view uri, const JsonView& place) {
  const std::size_t comma = uri.find(',');
  if (comma == uri.npos) place.fail("a data URI needs a comma before its data");
  const std::string_view content = uri.substr(comma + 1);
  if (uri.substr(0, comma).ends_with(";base64")) return decode_base64(content, comma + 1, place);
  const std::string text = percent_decoded(content);
  const auto bytes = std::as_bytes(std::span(text.data(), text.size()));
  return {bytes.begin(), bytes.end()};
}

std::filesystem::path resolve_uri(const std::string& uri, const std::filesystem::path& folder, const JsonView& place) {
  const std::string shown = "'" + printable(uri) + "'";
  if (has_scheme(uri)) place.fail(shown + " is not on this machine: only relative paths and data URIs are read");
  if (folder.empty()) place.fail("the file " + shown + " cannot be read from here");
  const std::string name = percent_decoded(uri);
  std::error_code error;
  // Names with odd characters are sometimes written as they are.
  for (const std::filesystem::path& path : {folder / name, folder / uri}) {
    if (name.find('\0') == name.npos && std::filesystem::is_regular_file(path, error)) return path;
  }
  place.fail("there is no file " + shown + " in " + folder.string());
}

}  // namespace lambert::gltf

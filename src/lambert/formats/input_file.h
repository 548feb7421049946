#pragma once
#include "lambert/base/file.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace lambert {

/// How much a compressed scene file may grow: a small file must not eat the machine's memory.
inline constexpr std::size_t max_inflated_bytes = std::size_t{1} << 31;

/// Decompresses gzip data (all members), stopping with an Error as soon as the result would exceed `max_bytes`. Throws
/// Error naming `name` and the byte offset for damaged or truncated data.
std::string inflate_gzip(std::span<const std::byte> data, const std::string& name,
                         std::size_t max_bytes = max_inflated_bytes);
bool is_gzip(std::span<const std::byte> data);

/// The content of a file, decompressed when it is gzip (found by its first bytes, not by its name).
class InputFile {
 public:
  explicit InputFile(const std::filesystem::path& path);
  std::string_view text() const { return inflated_ ? std::string_view(*inflated_) : mapped_.text(); }
  std::span<const std::byte> bytes() const { return std::as_bytes(std::span(text().data(), text().size())); }

 private:
  MappedFile mapped_;
  std::optional<std::string> inflated_;
};

}  // namespace lambert

#pragma once
#include "lambert/image/stream.h"

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace lambert {

/// An OpenEXR file of scan lines, encoded as the rows come. Throws Error for an attribute or a depth that it cannot
/// store.
class ExrWriter {
 public:
  /// Into a file, which errors call `name`, or into memory when `path` is empty.
  ExrWriter(const std::filesystem::path& path, const std::string& name, const ImageHeader& header,
            const WriteOptions& options);
  ~ExrWriter();
  ExrWriter(ExrWriter&&) noexcept;

  /// The next rows, a whole number of row_size() floats.
  void write(std::span<const float> rows);
  /// Ends the file; its bytes when it is in memory.
  std::vector<std::byte> finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace lambert

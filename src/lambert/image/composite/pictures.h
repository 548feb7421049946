#pragma once
#include "lambert/image/image.h"
#include "lambert/image/stream.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lambert::composite {

/// The pictures of a tree: images in memory, and files, which are read in bands, with few of them open at a time. What
/// can only be decoded whole is kept in memory up to `most_kept` bytes in all, and beyond that in temporary files.
class Pictures {
 public:
  explicit Pictures(std::size_t most_open = 4, std::size_t most_kept = std::size_t{1} << 28)
      : most_open_(most_open), most_kept_(most_kept) {}
  /// `image` is what expressions call `name`, instead of a file.
  void add(const std::string& name, Image image);
  /// Throws Error naming the file. The header stays where it is as long as this does.
  const ImageHeader& header(const std::string& file);
  /// Some are decoded as their rows are asked for.
  bool any_in_bands() const;
  /// Rows [y0, y1) as ImageReader::read() gives them: where they are in memory, else read into `scratch`, which has
  /// room for them.
  std::span<const float> rows(const std::string& file, int y0, int y1, std::span<float> scratch);

 private:
  struct Entry {
    ImageHeader header;
    std::optional<Image> whole;           ///< of what is not read in bands
    std::unique_ptr<ImageReader> reader;  ///< of what is
    std::shared_ptr<std::FILE> spool;     ///< all rows as floats
    std::uint64_t used = 0;
  };
  Entry& open(const std::string& file);
  void close_oldest(const Entry& but);
  static void spool(Entry& entry);

  std::map<std::string, Entry> entries_;
  std::size_t most_open_, most_kept_, kept_ = 0;
  std::uint64_t clock_ = 0;
};

}  // namespace lambert::composite

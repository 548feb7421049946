#pragma once
#include "lambert/image/stream.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace lambert::composite {

/// The files of a tree, read in bands, with few of them open at a time. What can only be decoded whole is kept in
/// memory up to `most_kept` bytes in all, and beyond that in temporary files.
class Pictures {
 public:
  explicit Pictures(std::size_t most_open = 4, std::size_t most_kept = std::size_t{1} << 28)
      : most_open_(most_open), most_kept_(most_kept) {}
  virtual ~Pictures() = default;
  /// Throws Error naming the file. The header stays where it is as long as this does.
  virtual const ImageHeader& header(const std::string& file);
  /// As ImageReader::read().
  virtual void read(const std::string& file, int y0, int y1, std::span<float> to);

 private:
  struct Entry {
    ImageHeader header;
    bool whole = false;  ///< its reader holds all pixels
    std::unique_ptr<ImageReader> reader;
    std::shared_ptr<std::FILE> spool;  ///< all rows as floats
    std::uint64_t used = 0;
  };
  Entry& open(const std::string& file);
  void close_oldest(const Entry& but);
  void spool(Entry& entry) const;

  std::map<std::string, Entry> entries_;
  std::size_t most_open_, most_kept_, kept_ = 0;
  std::uint64_t clock_ = 0;
};

}  // namespace lambert::composite

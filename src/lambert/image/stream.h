#pragma once
/// Image files in bands of rows, for pictures that need not fit in memory.

#include "lambert/image/image.h"
#include "lambert/image/io.h"

#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace lambert {

/// All of an image but its pixels.
struct ImageHeader {
  Window data, display;
  std::vector<std::string> channels;
  std::map<std::string, std::string> metadata;
  std::map<std::string, Attribute> attributes;
  bool full_floats = false;  ///< colours are stored as full floats, or are more than a half can hold
  int parts = 1;             ///< of the file that was read; more than one have become layers

  std::size_t row_size() const { return static_cast<std::size_t>(data.width) * channels.size(); }  ///< in floats
};
/// `full_floats` where a finite number is beyond the halves.
ImageHeader header_of(const Image& image);
/// All zeros. Throws Error as Image's constructor does.
Image image_of(const ImageHeader& header);

/// Reads what read_image() reads, row by row. OpenEXR files are decoded as they are asked for; of other formats the
/// whole is decoded when the file is opened. Rows count from 0 at the top of the data window, as in Image. Not for
/// several threads at once.
class ImageReader {
 public:
  /// Throws as read_image() does; damage among the pixels may show only in read().
  explicit ImageReader(const std::filesystem::path& path);
  ~ImageReader();
  ImageReader(ImageReader&&) noexcept;
  ImageReader& operator=(ImageReader&&) noexcept;

  const ImageHeader& header() const;
  /// Rows [y0, y1) into `to`, (y1 - y0) row_size() floats, channels interleaved. Any order of bands will do, but from
  /// the top is fastest. Throws Error when the rows are none of the image's or are damaged.
  void read(int y0, int y1, std::span<float> to);
  /// The same as an image, placed where the rows lie on the plane.
  Image band(int y0, int y1);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Writes what write_image() writes, row by row: OpenEXR files as the rows come, other formats at close(). The file
/// appears at close(), whole; without close() nothing does.
class ImageWriter {
 public:
  /// Throws as write_image() does.
  ImageWriter(const std::filesystem::path& path, ImageHeader header, const WriteOptions& options = {});
  ~ImageWriter();
  ImageWriter(ImageWriter&&) noexcept;
  ImageWriter& operator=(ImageWriter&&) noexcept;

  const ImageHeader& header() const;
  int rows_written() const;
  /// The next rows from the top; a whole number of row_size() floats. Throws Error when there are too many.
  void write(std::span<const float> rows);
  /// Throws Error when rows are missing.
  void close();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace lambert

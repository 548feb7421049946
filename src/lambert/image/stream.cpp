#include "lambert/image/stream.h"

#include "lambert/base/error.h"

#include <algorithm>
#include <utility>

namespace lambert {

ImageHeader header_of(const Image& image) {
  return {image.data_window(), image.display_window(), image.channels(), image.metadata, image.attributes};
}

struct ImageReader::State {
  std::filesystem::path path;
  ImageHeader header;
  Image whole;
};

ImageReader::ImageReader(const std::filesystem::path& path) : state_(std::make_unique<State>()) {
  state_->path = path;
  state_->whole = read_image(path);
  state_->header = header_of(state_->whole);
}
ImageReader::~ImageReader() = default;
ImageReader::ImageReader(ImageReader&&) noexcept = default;
ImageReader& ImageReader::operator=(ImageReader&&) noexcept = default;

const ImageHeader& ImageReader::header() const { return state_->header; }

void ImageReader::read(int y0, int y1, std::span<float> to) {
  const ImageHeader& h = header();
  if (y0 < 0 || y1 < y0 || y1 > h.data.height || to.size() != static_cast<std::size_t>(y1 - y0) * h.row_size())
    throw Error(state_->path.string() + ": has no rows " + std::to_string(y0) + " to " + std::to_string(y1));
  std::ranges::copy(state_->whole.pixels().subspan(static_cast<std::size_t>(y0) * h.row_size(), to.size()), to.begin());
}

Image ImageReader::band(int y0, int y1) {
  const ImageHeader& h = header();
  Image image(h.data.width, y1 - y0, h.channels);
  image.place({h.data.x, h.data.y + y0}, h.display);
  image.metadata = h.metadata;
  image.attributes = h.attributes;
  read(y0, y1, image.pixels());
  return image;
}

struct ImageWriter::State {
  std::filesystem::path path;
  ImageHeader header;
  WriteOptions options;
  int rows = 0;
  Image whole;
};

ImageWriter::ImageWriter(const std::filesystem::path& path, ImageHeader header, const WriteOptions& options)
    : state_(std::make_unique<State>()) {
  state_->path = path;
  state_->options = options;
  state_->whole = Image(header.data.width, header.data.height, header.channels);
  state_->whole.place({header.data.x, header.data.y}, header.display);
  state_->whole.metadata = header.metadata;
  state_->whole.attributes = header.attributes;
  state_->header = std::move(header);
  is_radiance_format(path);  // throws for an unknown one
}
ImageWriter::~ImageWriter() = default;
ImageWriter::ImageWriter(ImageWriter&&) noexcept = default;
ImageWriter& ImageWriter::operator=(ImageWriter&&) noexcept = default;

const ImageHeader& ImageWriter::header() const { return state_->header; }
int ImageWriter::rows_written() const { return state_->rows; }

void ImageWriter::write(std::span<const float> rows) {
  const std::size_t size = header().row_size(), count = rows.size() / size;
  if (rows.size() % size != 0 || count > static_cast<std::size_t>(header().data.height - state_->rows))
    throw Error(state_->path.string() + ": more rows than the header says");
  std::ranges::copy(rows,
                    state_->whole.pixels().subspan(static_cast<std::size_t>(state_->rows) * size, rows.size()).begin());
  state_->rows += static_cast<int>(count);
}

void ImageWriter::close() {
  if (state_->rows != header().data.height)
    throw Error(state_->path.string() + ": has " + std::to_string(state_->rows) + " of " +
                std::to_string(header().data.height) + " rows");
  write_image(state_->path, state_->whole, state_->options);
}

}  // namespace lambert

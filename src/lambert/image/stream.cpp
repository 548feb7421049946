#include "lambert/image/stream.h"

#include "lambert/base/error.h"
#include "lambert/base/file.h"
#include "lambert/base/standard_streams.h"
#include "lambert/image/formats/codecs.h"
#include "lambert/image/formats/exr_reader.h"
#include "lambert/image/formats/exr_writer.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

namespace lambert {

namespace {

/// Magnitudes are in the order of their bits; infinities and NaN come last.
bool some_exceed_half(std::span<const float> values) {
  constexpr auto most = std::bit_cast<std::uint32_t>(65504.0f),
                 infinity = std::bit_cast<std::uint32_t>(std::numeric_limits<float>::infinity());
  std::uint32_t some = 0;
  for (const float v : values) {
    const std::uint32_t magnitude = std::bit_cast<std::uint32_t>(v) & 0x7fffffff;
    some |= static_cast<std::uint32_t>((magnitude > most) & (magnitude < infinity));
  }
  return some != 0;
}

}  // namespace

ImageHeader header_of(const Image& image) {
  return {.data = image.data_window(),
          .display = image.display_window(),
          .channels = image.channels(),
          .metadata = image.metadata,
          .attributes = image.attributes,
          .full_floats = some_exceed_half(image.pixels())};
}

Image image_of(const ImageHeader& header) {
  Image image(header.data.width, header.data.height, header.channels);
  image.place({header.data.x, header.data.y}, header.display);
  image.metadata = header.metadata;
  image.attributes = header.attributes;
  return image;
}

struct ImageReader::State {
  std::string name;  // in errors
  std::optional<MappedFile> file;
  std::optional<ExrReader> exr;
  // Of formats that are not read in bands:
  ImageHeader header;
  Image whole;
};

ImageReader::ImageReader(const std::filesystem::path& path) : state_(std::make_unique<State>()) {
  state_->name = input_name(path);
  state_->file.emplace(open_input(path));
  if (is_exr(state_->file->bytes())) {
    state_->exr.emplace(state_->file->bytes(), state_->name);
    return;
  }
  state_->whole = decode_image(state_->file->bytes(), state_->name);
  state_->header = header_of(state_->whole);
  state_->file.reset();
}
ImageReader::~ImageReader() = default;
ImageReader::ImageReader(ImageReader&&) noexcept = default;
ImageReader& ImageReader::operator=(ImageReader&&) noexcept = default;

const ImageHeader& ImageReader::header() const { return state_->exr ? state_->exr->header() : state_->header; }

void ImageReader::read(int y0, int y1, std::span<float> to) {
  const ImageHeader& h = header();
  if (y0 < 0 || y1 < y0 || y1 > h.data.height || to.size() != static_cast<std::size_t>(y1 - y0) * h.row_size())
    throw Error(state_->name + ": has no rows " + std::to_string(y0) + " to " + std::to_string(y1));
  if (state_->exr)
    state_->exr->read(y0, y1, to.data());
  else
    std::ranges::copy(state_->whole.pixels().subspan(static_cast<std::size_t>(y0) * h.row_size(), to.size()),
                      to.begin());
}

Image ImageReader::band(int y0, int y1) {
  ImageHeader h = header();
  h.data.y += y0, h.data.height = y1 - y0;
  Image image = image_of(h);
  read(y0, y1, image.pixels());
  return image;
}

struct ImageWriter::State {
  std::filesystem::path path;
  ImageHeader header;
  WriteOptions options;
  int rows = 0;
  std::optional<AtomicFile> file;
  std::optional<ExrWriter> exr;  // after the file: it is ended before that is removed
  Image whole;                   // of formats that are not written in bands
};

ImageWriter::ImageWriter(const std::filesystem::path& path, ImageHeader header, const WriteOptions& options)
    : state_(std::make_unique<State>()) {
  check_write_options(path, options);
  state_->path = path;
  state_->options = options;
  try {
    if (writes_exr(path)) {
      state_->file.emplace(path);
      state_->exr.emplace(state_->file->temporary(), output_name(path), header, options);
    } else {
      state_->whole = image_of(header);
    }
  } catch (const std::exception&) {
    rethrow_named(output_name(path));
  }
  state_->header = std::move(header);
}
ImageWriter::~ImageWriter() = default;
ImageWriter::ImageWriter(ImageWriter&&) noexcept = default;
ImageWriter& ImageWriter::operator=(ImageWriter&&) noexcept = default;

const ImageHeader& ImageWriter::header() const { return state_->header; }
int ImageWriter::rows_written() const { return state_->rows; }

void ImageWriter::write(std::span<const float> rows) {
  const std::size_t size = header().row_size(), count = rows.size() / size;
  if (rows.size() % size != 0 || count > static_cast<std::size_t>(header().data.height - state_->rows))
    throw Error(output_name(state_->path) + ": more rows than the header says");
  try {
    if (state_->exr)
      state_->exr->write(rows);
    else
      std::ranges::copy(
          rows, state_->whole.pixels().subspan(static_cast<std::size_t>(state_->rows) * size, rows.size()).begin());
  } catch (const std::exception&) {
    rethrow_named(output_name(state_->path));
  }
  state_->rows += static_cast<int>(count);
}

void ImageWriter::close() {
  if (state_->rows != header().data.height)
    throw Error(output_name(state_->path) + ": has " + std::to_string(state_->rows) + " of " +
                std::to_string(header().data.height) + " rows");
  if (!state_->exr) return write_image(state_->path, state_->whole, state_->options);
  try {
    state_->exr->finish();
    state_->exr.reset();
    state_->file->commit();
  } catch (const std::exception&) {
    rethrow_named(output_name(state_->path));
  }
}

}  // namespace lambert

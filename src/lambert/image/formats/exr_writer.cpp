#include "lambert/image/formats/exr_writer.h"

#include "lambert/base/error.h"
#include "lambert/base/parallel.h"
#include "lambert/image/channels.h"
#include "lambert/image/formats/exr_attributes.h"
#include "lambert/image/formats/exr_stream.h"
#include "lambert/image/formats/exr_threads.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfStdIO.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>

namespace lambert {
namespace {

/// What is too large for a half is its largest number; infinities and NaN stay what they are.
half to_half(float v) { return half(std::isfinite(v) ? std::clamp(v, -65504.0f, 65504.0f) : v); }

Imf::Compression stored(Compression c) {
  switch (c) {
    case Compression::none: return Imf::NO_COMPRESSION;
    case Compression::rle: return Imf::RLE_COMPRESSION;
    case Compression::zips: return Imf::ZIPS_COMPRESSION;
    case Compression::zip: return Imf::ZIP_COMPRESSION;
    case Compression::piz: return Imf::PIZ_COMPRESSION;
    case Compression::pxr24: return Imf::PXR24_COMPRESSION;
    case Compression::b44: return Imf::B44_COMPRESSION;
    case Compression::b44a: return Imf::B44A_COMPRESSION;
    case Compression::dwaa: return Imf::DWAA_COMPRESSION;
    case Compression::dwab: return Imf::DWAB_COMPRESSION;
  }
  throw Error("unknown compression");
}

Imf::PixelType stored_type(const std::string& channel, Depth depth) {
  switch (depth) {
    case Depth::automatic: return needs_full_floats(channel) ? Imf::FLOAT : Imf::HALF;
    case Depth::half: return Imf::HALF;
    case Depth::full: return Imf::FLOAT;
    default: throw Error("OpenEXR stores half or float, not 8 or 16 bits");
  }
}

Imath::Box2i box_of(const Window& w) {
  return {Imath::V2i(w.x, w.y), Imath::V2i(w.x + w.width - 1, w.y + w.height - 1)};
}

Imf::Header header_of(const ImageHeader& h, const WriteOptions& options) {
  Imf::Header header(box_of(h.display), box_of(h.data));
  header.compression() = stored(options.compression);
  write_attributes(header, h.metadata, h.attributes);
  for (const std::string& c : h.channels) header.channels().insert(c, Imf::Channel(stored_type(c, options.depth)));
  return header;
}

}  // namespace

struct ExrWriter::State {
  MemoryOutput memory;
  std::ofstream disk_file;
  std::unique_ptr<Imf::StdOFStream> disk;
  std::unique_ptr<Imf::OutputFile> file;
  std::size_t width = 0;
  std::int64_t left = 0;
  std::vector<std::string> channels;
  std::vector<Imf::PixelType> types;
  std::vector<half> halves;  // interleaved, in place of the floats

  void write(std::span<const float> rows);
};

void ExrWriter::State::write(std::span<const float> rows) {
  const std::size_t count = channels.size(), row = width * count, height = rows.size() / row;
  const bool some_halves = std::ranges::find(types, Imf::HALF) != types.end();
  if (some_halves) {
    halves.resize(rows.size());
    parallel_for(height, [&](std::size_t y) {
      for (std::size_t i = y * row; i < (y + 1) * row; ++i) halves[i] = to_half(rows[i]);
    });
  }
  const int y = file->currentScanLine();
  Imf::FrameBuffer frame;
  for (std::size_t c = 0; c < count; ++c) {
    const std::size_t size = types[c] == Imf::HALF ? sizeof(half) : sizeof(float);
    const char* from = types[c] == Imf::HALF ? reinterpret_cast<const char*>(halves.data())
                                             : reinterpret_cast<const char*>(rows.data());
    const std::ptrdiff_t origin =
        left * static_cast<std::ptrdiff_t>(size * count) + std::int64_t{y} * static_cast<std::ptrdiff_t>(size * row);
    frame.insert(channels[c],
                 Imf::Slice(types[c], const_cast<char*>(from) + c * size - origin, size * count, size * row));
  }
  file->setFrameBuffer(frame);
  file->writePixels(static_cast<int>(height));
}

ExrWriter::ExrWriter(const std::filesystem::path& path, const ImageHeader& header, const WriteOptions& options)
    : state_(std::make_unique<State>()) {
  const Imf::Header h = header_of(header, options);
  State& s = *state_;
  s.width = static_cast<std::size_t>(header.data.width);
  s.left = header.data.x;
  s.channels = header.channels;
  for (const std::string& c : s.channels) s.types.push_back(stored_type(c, options.depth));
  if (path.empty()) {
    s.file = std::make_unique<Imf::OutputFile>(s.memory, h, exr_threads());
  } else {
    s.disk_file.open(path, std::ios::binary);
    if (!s.disk_file) throw Error(std::string("cannot write: ") + std::strerror(errno));
    s.disk = std::make_unique<Imf::StdOFStream>(s.disk_file, path.c_str());
    s.file = std::make_unique<Imf::OutputFile>(*s.disk, h, exr_threads());
  }
}
ExrWriter::~ExrWriter() = default;
ExrWriter::ExrWriter(ExrWriter&&) noexcept = default;

void ExrWriter::write(std::span<const float> rows) {
  // In bands, so that what is converted stays small.
  constexpr std::size_t band = 256;
  const std::size_t row = state_->width * state_->channels.size();
  for (std::size_t at = 0; at < rows.size(); at += band * row)
    state_->write(rows.subspan(at, std::min(band * row, rows.size() - at)));
}

std::vector<std::byte> ExrWriter::finish() {
  state_->file.reset();  // writes the table of offsets, and keeps silent when it cannot
  if (state_->disk && !state_->disk_file.flush()) throw Error(std::string("cannot write: ") + std::strerror(errno));
  return std::move(state_->memory.bytes);
}

}  // namespace lambert

#include "lambert/image/formats/exr_writer.h"

#include "lambert/base/error.h"
#include "lambert/base/parallel.h"
#include "lambert/image/channels.h"
#include "lambert/image/formats/exr_attributes.h"
#include "lambert/image/formats/exr_threads.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOpaqueAttribute.h>
#include <ImfOutputFile.h>
#include <ImfStdIO.h>
#include <ImfStringAttribute.h>
#include <ImfVersion.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>

namespace lambert {
namespace {

class MemoryOutput final : public Imf::OStream {
 public:
  MemoryOutput() : OStream("memory") {}
  void write(const char c[], int n) override {
    const auto count = static_cast<std::size_t>(n);
    if (bytes.size() < at_ + count) bytes.resize(at_ + count);
    std::memcpy(bytes.data() + at_, c, count);
    at_ += count;
  }
  std::uint64_t tellp() override { return at_; }
  void seekp(std::uint64_t position) override { at_ = static_cast<std::size_t>(position); }
  std::vector<std::byte> bytes;

 private:
  std::size_t at_ = 0;
};

/// The bytes of one attribute.
class AttributeBytes final : public Imf::IStream {
 public:
  explicit AttributeBytes(std::span<const std::byte> bytes) : IStream("attribute"), bytes_(bytes) {}
  bool read(char c[], int n) override {
    const auto count = static_cast<std::size_t>(n > 0 ? n : 0);
    if (count > bytes_.size() - at_) throw Error("an attribute is too short");
    std::memcpy(c, bytes_.data() + at_, count);
    at_ += count;
    return at_ < bytes_.size();
  }
  std::uint64_t tellg() override { return at_; }
  void seekg(std::uint64_t position) override { at_ = std::min<std::size_t>(position, bytes_.size()); }

 private:
  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
};

void write_attributes(Imf::Header& to, const ImageHeader& from) {
  const auto check = [](const std::string& name, const std::string& type) {
    if (is_exr_layout(name, type)) throw Error("OpenEXR keeps the name '" + name + "' for itself");
  };
  for (const auto& [name, text] : from.metadata) {
    check(name, "string");
    to.insert(name, Imf::StringAttribute(text));
  }
  for (const auto& [name, a] : from.attributes) {
    check(name, a.type);
    const std::vector<std::byte> bytes = exr_bytes(name, a);
    const bool known = Imf::Attribute::knownType(a.type.c_str());
    const std::unique_ptr<Imf::Attribute> attribute(known ? Imf::Attribute::newAttribute(a.type.c_str())
                                                          : new Imf::OpaqueAttribute(a.type.c_str()));
    AttributeBytes in(bytes);
    attribute->readValueFrom(in, static_cast<int>(bytes.size()), Imf::EXR_VERSION);
    to.insert(name, *attribute);
  }
}

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

Imf::PixelType stored_type(const std::string& channel, bool full_floats, Depth depth) {
  switch (depth) {
    case Depth::automatic: return full_floats || needs_full_floats(channel) ? Imf::FLOAT : Imf::HALF;
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
  write_attributes(header, h);
  for (const std::string& c : h.channels)
    header.channels().insert(c, Imf::Channel(stored_type(c, h.full_floats, options.depth)));
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

ExrWriter::ExrWriter(const std::filesystem::path& path, const std::string& name, const ImageHeader& header,
                     const WriteOptions& options)
    : state_(std::make_unique<State>()) {
  const Imf::Header h = header_of(header, options);
  State& s = *state_;
  s.width = static_cast<std::size_t>(header.data.width);
  s.left = header.data.x;
  s.channels = header.channels;
  for (const std::string& c : s.channels) s.types.push_back(stored_type(c, header.full_floats, options.depth));
  if (path.empty()) {
    s.file = std::make_unique<Imf::OutputFile>(s.memory, h, exr_threads());
  } else {
    s.disk_file.open(path, std::ios::binary);
    if (!s.disk_file) throw Error(std::string("cannot write: ") + std::strerror(errno));
    s.disk = std::make_unique<Imf::StdOFStream>(s.disk_file, name.c_str());
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

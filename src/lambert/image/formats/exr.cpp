#include "lambert/base/error.h"
#include "lambert/image/formats/codecs.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <exception>
#include <string_view>

namespace lambert {
namespace {

class MemoryInput final : public Imf::IStream {
 public:
  MemoryInput(Bytes data, const std::string& name) : IStream(name.c_str()), data_(data) {}
  bool read(char c[], int n) override {
    const auto count = static_cast<std::size_t>(std::max(n, 0));
    if (count > data_.size() - at_) decode_error(fileName(), "ends at byte " + std::to_string(data_.size()));
    std::memcpy(c, data_.data() + at_, count);
    at_ += count;
    return at_ < data_.size();
  }
  std::uint64_t tellg() override { return at_; }
  void seekg(std::uint64_t position) override {
    if (position > data_.size()) decode_error(fileName(), "points behind its end");
    at_ = static_cast<std::size_t>(position);
  }

 private:
  Bytes data_;
  std::size_t at_ = 0;
};

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

/// R, G, B, Y, A first, in this order; then the others by name.
std::vector<std::string> ordered_channels(const Imf::ChannelList& list) {
  std::vector<std::string> names, others;
  for (const char* first : {"R", "G", "B", "Y", "A"})
    if (list.findChannel(first)) names.emplace_back(first);
  for (auto c = list.begin(); c != list.end(); ++c)
    if (std::find(names.begin(), names.end(), c.name()) == names.end()) others.emplace_back(c.name());
  names.insert(names.end(), others.begin(), others.end());
  return names;
}

/// What is too large for a half is its largest number; infinities and NaN stay what they are.
half to_half(float v) { return half(std::isfinite(v) ? std::clamp(v, -65504.0f, 65504.0f) : v); }

/// Positions, depths, ids, counts, variances and what is compared with them need all digits of a float; colours do
/// not.
Imf::PixelType stored_type(const std::string& channel) {
  static constexpr const char* precise[] = {"position.", ".id", "samples.", "variance.", "Crypto", "denoising."};
  const bool is_precise = channel == "Z" || std::any_of(std::begin(precise), std::end(precise), [&](const char* part) {
                            return channel.find(part) != std::string::npos;
                          });
  return is_precise ? Imf::FLOAT : Imf::HALF;
}

Image read(Bytes data, const std::string& name) {
  MemoryInput stream(data, name);
  Imf::InputFile file(stream, 1);
  const Imath::Box2i window = file.header().dataWindow(), display = file.header().displayWindow();
  const auto extent = [](int lo, int hi) {
    return static_cast<std::uint64_t>(std::max<std::int64_t>(0, static_cast<std::int64_t>(hi) - lo + 1));
  };
  const std::uint64_t width = extent(window.min.x, window.max.x), height = extent(window.min.y, window.max.y);
  const std::uint64_t shown_width = extent(display.min.x, display.max.x),
                      shown_height = extent(display.min.y, display.max.y);
  // Constant areas compress without bound in principle; in practice by less than this.
  check_image_size(name, width, height, data.size(), 4096);
  check_image_size(name, shown_width, shown_height, data.size() + 4096, 4096);
  const std::vector<std::string> names = ordered_channels(file.header().channels());
  if (names.empty()) decode_error(name, "has no channels");
  for (const std::string& c : names) {
    const Imf::Channel& channel = file.header().channels()[c.c_str()];
    if (channel.xSampling != 1 || channel.ySampling != 1)
      decode_error(name, "channel '" + c + "' is subsampled, which is not supported");
  }

  Image stored(static_cast<int>(width), static_cast<int>(height), names);
  Imf::FrameBuffer frame;
  const std::size_t x_stride = names.size() * sizeof(float), y_stride = x_stride * width;
  // Imf addresses pixel (x, y) at base + x x_stride + y y_stride, with x and y in the data window.
  const std::ptrdiff_t origin =
      window.min.x * static_cast<std::ptrdiff_t>(x_stride) + window.min.y * static_cast<std::ptrdiff_t>(y_stride);
  char* base = reinterpret_cast<char*>(stored.pixels().data()) - origin;
  for (std::size_t c = 0; c < names.size(); ++c)
    frame.insert(names[c], Imf::Slice(Imf::FLOAT, base + c * sizeof(float), x_stride, y_stride));
  file.setFrameBuffer(frame);
  file.readPixels(window.min.y, window.max.y);
  for (auto a = file.header().begin(); a != file.header().end(); ++a)
    if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&a.attribute());
        text && std::string_view(a.name()) != "type")  // says how the file stores its pixels, not what they are
      stored.metadata[a.name()] = text->value();
  if (window == display) return stored;

  // The image is what is displayed: the data window put in its place, black around it.
  Image shown(static_cast<int>(shown_width), static_cast<int>(shown_height), names);
  shown.metadata = stored.metadata;
  for (int y = std::max(window.min.y, display.min.y); y <= std::min(window.max.y, display.max.y); ++y)
    for (int x = std::max(window.min.x, display.min.x); x <= std::min(window.max.x, display.max.x); ++x)
      for (std::size_t c = 0; c < names.size(); ++c)
        shown.at(x - display.min.x, y - display.min.y, c) = stored.at(x - window.min.x, y - window.min.y, c);
  return shown;
}

}  // namespace

Image decode_exr(Bytes data, const std::string& name) {
  try {
    return read(data, name);
  } catch (const std::exception&) {
    rethrow_named(name);
  }
}

std::vector<std::byte> encode_exr(const Image& image) {
  Imf::Header header(image.width(), image.height());
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const auto& [key, value] : image.metadata) header.insert(key, Imf::StringAttribute(value));
  const auto pixels = image.pixels();
  const auto width = static_cast<std::size_t>(image.width()), height = static_cast<std::size_t>(image.height());
  const std::size_t count = image.channel_count();

  // Planes of half floats for the channels that are stored so; float channels are read in place.
  std::vector<std::vector<half>> planes(count);
  Imf::FrameBuffer frame;
  for (std::size_t c = 0; c < count; ++c) {
    const std::string& name = image.channels()[c];
    const Imf::PixelType type = stored_type(name);
    header.channels().insert(name, Imf::Channel(type));
    if (type == Imf::FLOAT) {
      char* base = const_cast<char*>(reinterpret_cast<const char*>(pixels.data() + c));
      frame.insert(name, Imf::Slice(type, base, count * sizeof(float), count * sizeof(float) * width));
      continue;
    }
    planes[c].resize(width * height);
    for (std::size_t i = 0; i < planes[c].size(); ++i) planes[c][i] = to_half(pixels[i * count + c]);
    frame.insert(name, Imf::Slice(type, reinterpret_cast<char*>(planes[c].data()), sizeof(half), sizeof(half) * width));
  }
  MemoryOutput stream;
  {
    Imf::OutputFile file(stream, header, 1);
    file.setFrameBuffer(frame);
    file.writePixels(image.height());
  }
  return std::move(stream.bytes);
}

}  // namespace lambert

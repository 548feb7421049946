#include "lambert/image/formats/exr_reader.h"

#include "lambert/base/error.h"
#include "lambert/base/parallel.h"
#include "lambert/image/channels.h"
#include "lambert/image/formats/exr_attributes.h"
#include "lambert/image/formats/exr_names.h"
#include "lambert/image/formats/exr_threads.h"
#include "lambert/image/primaries.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfPartType.h>
#include <ImfRgbaFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <ImfVersion.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <optional>

namespace lambert {
namespace {

class MemoryInput final : public Imf::IStream {
 public:
  MemoryInput(Bytes data, const std::string& name) : IStream(name.c_str()), data_(data) {}
  bool read(char c[], int n) override {
    const auto count = static_cast<std::size_t>(n > 0 ? n : 0);
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

/// The bytes of one attribute.
class AttributeBytes final : public Imf::OStream {
 public:
  AttributeBytes() : OStream("attribute") {}
  void write(const char c[], int n) override {
    const auto* from = reinterpret_cast<const std::byte*>(c);
    bytes.insert(bytes.end(), from, from + n);
  }
  std::uint64_t tellp() override { return bytes.size(); }
  void seekp(std::uint64_t) override {}
  std::vector<std::byte> bytes;
};

/// Strings into the metadata, other values into the attributes.
void read_attributes(const Imf::Header& from, ImageHeader& to) {
  for (auto a = from.begin(); a != from.end(); ++a) {
    const std::string name = a.name(), type = a.attribute().typeName();
    if (is_exr_layout(name, type)) continue;
    if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&a.attribute())) {
      to.metadata[name] = text->value();
      continue;
    }
    AttributeBytes out;
    a.attribute().writeValueTo(out, Imf::EXR_VERSION);
    const std::string value = exr_text(type, out.bytes);
    if (!is_exr_default(name, value)) to.attributes[name] = {type, value};
  }
}

/// In 64 bits, since corners may lie anywhere in the plane.
struct Box {
  std::int64_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // behind the last
  std::uint64_t width() const { return static_cast<std::uint64_t>(std::max<std::int64_t>(0, x1 - x0)); }
  std::uint64_t height() const { return static_cast<std::uint64_t>(std::max<std::int64_t>(0, y1 - y0)); }
  bool operator==(const Box&) const = default;
};
Box box_of(const Imath::Box2i& b) { return {b.min.x, b.min.y, std::int64_t{b.max.x} + 1, std::int64_t{b.max.y} + 1}; }
Box joined(const Box& a, const Box& b) {
  return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}
Window window_of(const Box& b) {
  return {static_cast<int>(b.x0), static_cast<int>(b.y0), static_cast<int>(b.x1 - b.x0), static_cast<int>(b.y1 - b.y0)};
}

/// Constant areas compress without bound in principle; in practice by less than this.
std::uint64_t most_pixels_per_byte(const Imf::Header& header) {
  const Imf::Compression c = header.compression();
  return c == Imf::DWAA_COMPRESSION || c == Imf::DWAB_COMPRESSION ? 65536 : 4096;
}

struct StoredChannel {
  std::string stored;
  std::size_t target = 0;  // among the image's channels
  int x_sampling = 1, y_sampling = 1;
  bool subsampled() const { return x_sampling != 1 || y_sampling != 1; }
};

/// Where Y, RY and BY are, which are written over by R, G and B.
struct LuminanceChroma {
  std::string layer;  // with its point
  ColourTriple at;
  Vec3d weights;  // of R, G and B in Y
};

struct Part {
  Imf::InputPart file;
  Box box;
  std::vector<StoredChannel> channels;
  std::optional<LuminanceChroma> chroma;
  bool filtered_chroma = false;  // sampled 2x2, which Imf reconstructs
};

struct Conversion {
  ColourTriple at;
  Mat3 matrix;
};

Chromaticities chromaticities_of(const Imf::Header& header) {
  if (!Imf::hasChromaticities(header)) return rec709;
  const Imf::Chromaticities& c = Imf::chromaticities(header);
  const auto xy = [](Imath::V2f v) { return Vec2d(static_cast<double>(v.x), static_cast<double>(v.y)); };
  return {xy(c.red), xy(c.green), xy(c.blue), xy(c.white)};
}

}  // namespace

struct ExrReader::State {
  State(Bytes bytes, const std::string& file_name)
      : data(bytes), name(file_name), stream(bytes, file_name), file(stream, exr_threads()) {
    open();
  }

  Bytes data;
  std::string name;
  MemoryInput stream;
  Imf::MultiPartInputFile file;
  ImageHeader header;
  Box box;
  std::vector<Part> parts;
  std::vector<Conversion> conversions;

  void open();
  void read(int y0, int y1, float* to);
  void read_part(Part& part, std::int64_t first, std::int64_t last, std::int64_t top, float* to);
  void read_subsampled(Part& part, std::int64_t first, std::int64_t last, std::int64_t top, float* to);
  void read_filtered_chroma(Part& part, std::int64_t first, std::int64_t last, std::int64_t top, float* to);
  float* pixel(float* to, std::int64_t x, std::int64_t y, std::int64_t top) const {
    return to + static_cast<std::size_t>(y - top) * header.row_size() +
           static_cast<std::size_t>(x - box.x0) * header.channels.size();
  }
};

namespace {

/// "Y", "RY" and "BY" of a layer without R, G and B are luminance and chroma.
std::optional<std::string> chroma_layer(const Imf::ChannelList& list) {
  for (auto c = list.begin(); c != list.end(); ++c) {
    const std::string stored = c.name();
    if (stored != "RY" && !stored.ends_with(".RY")) continue;
    const std::string layer = stored.substr(0, stored.size() - 2);
    const auto has = [&](const char* n) { return list.findChannel((layer + n).c_str()) != nullptr; };
    if (has("Y") && has("BY") && !has("R") && !has("G") && !has("B")) return layer;
  }
  return std::nullopt;
}

/// The image's name of a stored channel: Y stands for R, RY for G.
std::string shown_name(const std::string& stored, const std::optional<std::string>& layer) {
  if (!layer) return stored;
  if (stored == *layer + "Y") return *layer + "R";
  if (stored == *layer + "RY") return *layer + "G";
  if (stored == *layer + "BY") return *layer + "B";
  return stored;
}

}  // namespace

void ExrReader::State::open() {
  std::vector<std::string> part_names;
  std::vector<std::vector<std::string>> shown;
  std::vector<std::vector<std::string>> stored;
  for (int i = 0; i < file.parts(); ++i) {
    const Imf::Header& h = file.header(i);
    part_names.push_back(file.parts() > 1 && h.hasName() ? h.name() : "");
    if (h.hasType() && Imf::isDeepData(h.type()))
      decode_error(name, "part " + std::to_string(i) + (h.hasName() ? " '" + h.name() + "'" : "") + " is deep (" +
                             h.type() + "): it has lists of samples and not pixels; flatten it first");
    const Box part = box_of(h.dataWindow());
    check_image_size(name, part.width(), part.height(), data.size(), most_pixels_per_byte(h));
    box = i == 0 ? part : joined(box, part);
    const auto layer = chroma_layer(h.channels());
    std::vector<std::string>& names = shown.emplace_back();
    std::vector<std::string>& files = stored.emplace_back();
    for (auto c = h.channels().begin(); c != h.channels().end(); ++c) {
      files.emplace_back(c.name());
      names.push_back(shown_name(c.name(), layer));
    }
  }
  check_image_size(name, box.width(), box.height(), data.size() + 4096, 65536);
  const std::size_t main = main_part(part_names);
  const Imf::Header& h = file.header(static_cast<int>(main));
  const Box display = box_of(h.displayWindow());
  if (display.width() == 0 || display.height() == 0 || display.width() > 1u << 30 || display.height() > 1u << 30)
    decode_error(name,
                 "its display window is " + std::to_string(display.width()) + "x" + std::to_string(display.height()));
  header.data = window_of(box);
  header.display = window_of(display);
  header.parts = file.parts();
  read_attributes(h, header);
  if (file.parts() > 1) header.metadata.erase("name"), header.metadata.erase("view");

  const std::vector<ExrChannel> channels = named_channels(part_names, shown);
  if (channels.empty()) decode_error(name, "has no channels");
  if (box.width() * box.height() > (std::uint64_t{1} << 31) / channels.size())
    decode_error(name, "with " + std::to_string(channels.size()) + " channels is too large");
  std::vector<std::string> names;
  for (const ExrChannel& c : channels) names.push_back(c.name);
  const std::vector<std::size_t> order = colour_first(names);
  std::vector<std::size_t> target(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    header.channels.push_back(names[order[i]]);
    target[order[i]] = i;
  }

  std::size_t next = 0;
  for (int i = 0; i < file.parts(); ++i) {
    const Imf::Header& ph = file.header(i);
    Part& part = parts.emplace_back(Part{Imf::InputPart(file, i), box_of(ph.dataWindow()), {}, {}, false});
    const std::size_t first = next;
    for (const std::string& s : stored[static_cast<std::size_t>(i)]) {
      const Imf::Channel& c = ph.channels()[s.c_str()];
      if (c.xSampling < 1 || c.ySampling < 1) decode_error(name, "channel '" + s + "' is not sampled");
      header.full_floats |= c.type == Imf::FLOAT && !needs_full_floats(header.channels[target[next]]);
      part.channels.push_back({s, target[next++], c.xSampling, c.ySampling});
    }
    const Chromaticities from = chromaticities_of(ph);
    if (const auto layer = chroma_layer(ph.channels())) {
      const auto place = [&](const char* n) {
        const auto& list = stored[static_cast<std::size_t>(i)];
        return target[first + static_cast<std::size_t>(std::ranges::find(list, *layer + n) - list.begin())];
      };
      const glm::dmat3 xyz = rgb_to_xyz(from);
      part.chroma = {*layer, {place("Y"), place("RY"), place("BY")}, {xyz[0].y, xyz[1].y, xyz[2].y}};
      const auto sampling = [&](const char* n, int s) {
        const Imf::Channel& c = ph.channels()[(*layer + n).c_str()];
        return c.xSampling == s && c.ySampling == s;
      };
      part.filtered_chroma = file.parts() == 1 && sampling("Y", 1) && sampling("RY", 2) && sampling("BY", 2);
    }
    if (same_primaries(from, rec709)) continue;
    const Mat3 matrix(to_rec709(from));
    std::vector<std::string> part_channels;
    for (const StoredChannel& c : part.channels) part_channels.push_back(header.channels[c.target]);
    for (const ColourTriple& t : colour_triples(part_channels))
      conversions.push_back(
          {{part.channels[t.r].target, part.channels[t.g].target, part.channels[t.b].target}, matrix});
  }
  if (const auto c = header.attributes.find("chromaticities"); c != header.attributes.end())
    c->second.value = text_of(rec709);
}

void ExrReader::State::read_subsampled(Part& part, std::int64_t first, std::int64_t last, std::int64_t top, float* to) {
  const auto down = [](std::int64_t v, int by) { return (v >= 0 ? v : v - by + 1) / by; };
  for (const StoredChannel& c : part.channels) {
    if (!c.subsampled()) continue;
    // Samples stand at multiples of the sampling: from the one at or before the first pixel.
    const std::int64_t x0 = down(part.box.x0, c.x_sampling), y0 = down(first, c.y_sampling);
    const auto width = static_cast<std::size_t>(down(part.box.x1 - 1, c.x_sampling) - x0 + 1),
               height = static_cast<std::size_t>(down(last - 1, c.y_sampling) - y0 + 1);
    std::vector<float> samples(width * height);
    char* base = reinterpret_cast<char*>(samples.data()) - 4 * (x0 + y0 * static_cast<std::int64_t>(width));
    Imf::FrameBuffer frame;
    frame.insert(c.stored, Imf::Slice(Imf::FLOAT, base, 4, 4 * width, c.x_sampling, c.y_sampling));
    part.file.setFrameBuffer(frame);
    const std::int64_t from = std::max(part.box.y0, y0 * c.y_sampling);
    part.file.readPixels(static_cast<int>(from), static_cast<int>(last - 1));
    for (std::int64_t y = first; y < last; ++y)
      for (std::int64_t x = part.box.x0; x < part.box.x1; ++x)
        pixel(to, x, y, top)[c.target] = samples[static_cast<std::size_t>(down(y, c.y_sampling) - y0) * width +
                                                 static_cast<std::size_t>(down(x, c.x_sampling) - x0)];
  }
}

/// By Imf's own filter, whose results other programs show.
void ExrReader::State::read_filtered_chroma(Part& part, std::int64_t first, std::int64_t last, std::int64_t top,
                                            float* to) {
  MemoryInput again(data, name);
  const std::string layer =
      part.chroma->layer.empty() ? "" : part.chroma->layer.substr(0, part.chroma->layer.size() - 1);
  Imf::RgbaInputFile rgba(again, layer, 1);
  const std::size_t width = static_cast<std::size_t>(part.box.width());
  std::vector<Imf::Rgba> row(width);
  for (std::int64_t y = first; y < last; ++y) {
    rgba.setFrameBuffer(row.data() - part.box.x0, 1, 0);
    rgba.readPixels(static_cast<int>(y));
    for (std::int64_t x = part.box.x0; x < part.box.x1; ++x) {
      const Imf::Rgba& c = row[static_cast<std::size_t>(x - part.box.x0)];
      float* p = pixel(to, x, y, top);
      p[part.chroma->at.r] = c.r, p[part.chroma->at.g] = c.g, p[part.chroma->at.b] = c.b;
    }
  }
}

void ExrReader::State::read_part(Part& part, std::int64_t first, std::int64_t last, std::int64_t top, float* to) {
  const std::size_t x_stride = header.channels.size() * sizeof(float), y_stride = x_stride * box.width();
  // Imf addresses pixel (x, y) at base + x x_stride + y y_stride, with x and y in the data window.
  const std::ptrdiff_t origin =
      box.x0 * static_cast<std::ptrdiff_t>(x_stride) + top * static_cast<std::ptrdiff_t>(y_stride);
  char* base = reinterpret_cast<char*>(to) - origin;
  Imf::FrameBuffer frame;
  for (const StoredChannel& c : part.channels)
    if (!c.subsampled())
      frame.insert(c.stored, Imf::Slice(Imf::FLOAT, base + c.target * sizeof(float), x_stride, y_stride));
  if (frame.begin() != frame.end()) {
    part.file.setFrameBuffer(frame);
    part.file.readPixels(static_cast<int>(first), static_cast<int>(last - 1));
  }
  if (part.filtered_chroma) return read_filtered_chroma(part, first, last, top, to);
  read_subsampled(part, first, last, top, to);
  if (!part.chroma) return;
  const auto& [layer, at, weights] = *part.chroma;
  const Vec3 w(weights);
  for (std::int64_t y = first; y < last; ++y)
    for (std::int64_t x = part.box.x0; x < part.box.x1; ++x) {
      float* p = pixel(to, x, y, top);
      const float luminance = p[at.r], r = (p[at.g] + 1) * luminance, b = (p[at.b] + 1) * luminance;
      p[at.r] = r, p[at.g] = (luminance - r * w.x - b * w.z) / w.y, p[at.b] = b;
    }
}

void ExrReader::State::read(int y0, int y1, float* to) {
  const std::int64_t top = box.y0 + y0, end = box.y0 + y1;
  const std::size_t row = header.row_size(), rows = static_cast<std::size_t>(y1 - y0);
  const bool covered = std::ranges::all_of(parts, [&](const Part& p) { return p.box == box; });
  if (!covered) std::fill_n(to, rows * row, 0.0f);
  for (Part& part : parts) {
    const std::int64_t first = std::max(top, part.box.y0), last = std::min(end, part.box.y1);
    if (first < last) read_part(part, first, last, top, to);
  }
  if (conversions.empty()) return;
  const std::size_t channels = header.channels.size();
  parallel_for(rows, [&](std::size_t y) {
    for (const auto& [at, m] : conversions)
      for (float* p = to + y * row; p != to + (y + 1) * row; p += channels) {
        const Vec3 c = m * Vec3(p[at.r], p[at.g], p[at.b]);
        p[at.r] = c.x, p[at.g] = c.y, p[at.b] = c.z;
      }
  });
}

ExrReader::ExrReader(Bytes data, const std::string& name) {
  try {
    state_ = std::make_unique<State>(data, name);
  } catch (const std::exception&) {
    rethrow_named(name);
  }
}
ExrReader::~ExrReader() = default;
ExrReader::ExrReader(ExrReader&&) noexcept = default;

const ImageHeader& ExrReader::header() const { return state_->header; }

void ExrReader::read(int y0, int y1, float* to) {
  if (y0 >= y1) return;
  try {
    state_->read(y0, y1, to);
  } catch (const std::exception&) {
    rethrow_named(state_->name);
  }
}

}  // namespace lambert

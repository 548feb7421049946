#include "lambert/image/composite/composite.h"

#include "lambert/base/error.h"
#include "lambert/base/parallel.h"
#include "lambert/image/composite/plan.h"
#include "lambert/image/composite/sequence.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace lambert::composite {
namespace {

std::string file_at(const std::string& name, double frame) {
  return name_at_frame(name, static_cast<int>(std::lround(frame)));
}

struct Job {
  ElementPtr root;
  ImageHeader header;
  int band_rows = 64;
};

/// Rows of a band: enough that several threads can decode them, or else few that stay in a cache; and enough that most
/// of what is asked for around it is not asked for twice.
int rows_for(int margin, bool decoding) { return std::clamp((4 * margin + 15) / 16 * 16, decoding ? 64 : 16, 512); }

Job prepare(const Expression& expression, bool extras, Pictures& pictures, const CompositeSettings& settings) {
  Job job{.root = plan(expression, settings.frame, file_at, {.all = extras}, pictures, settings.text, settings.name)};
  const Shape& shape = job.root->shape();
  if (const ImageHeader* source = job.root->source()) {
    job.header.metadata = source->metadata;
    job.header.attributes = source->attributes;
  }
  const std::optional<Window> display = settings.display ? settings.display : shape.display;
  if (!display) throw Error(settings.name + ": no picture says how large the result is; give it a resolution");
  job.header.display = *display;
  job.header.data = shape.data && !is_empty(*shape.data) ? *shape.data : *display;
  const std::uint64_t pixels =
      static_cast<std::uint64_t>(job.header.data.width) * static_cast<std::uint64_t>(job.header.data.height);
  if (pixels > std::uint64_t{1} << 28)
    throw Error(settings.name + ": the result would have " + std::to_string(job.header.data.width) + "x" +
                std::to_string(job.header.data.height) + " pixels; 'crop' the elements");
  job.header.channels = shape.channels;
  if (!shape.has_alpha) job.header.channels.erase(job.header.channels.begin() + alpha_channel);
  for (const FileAt& f : files_at(expression, settings.frame))
    job.header.full_floats |= pictures.header(f.file).full_floats;
  job.band_rows = rows_for(job.root->margin(), pictures.any_in_bands());
  return job;
}

void interleave(const Shape& shape, const Band& band, std::span<float> to) {
  const std::size_t stride = shape.channels.size() - (shape.has_alpha ? 0 : 1), width = band.width();
  parallel_for(static_cast<std::size_t>(band.window().height), [&](std::size_t i) {
    const int y = band.window().y + static_cast<int>(i);
    float* row = to.data() + i * width * stride;
    if (stride == 4 && shape.has_alpha) {
      const auto r = band.row(red_channel, y), g = band.row(green_channel, y), b = band.row(blue_channel, y),
                 a = band.row(alpha_channel, y);
      for (std::size_t x = 0; x < width; ++x)
        row[4 * x] = r[x], row[4 * x + 1] = g[x], row[4 * x + 2] = b[x], row[4 * x + 3] = a[x];
      return;
    }
    std::size_t k = 0;
    for (std::size_t c = 0; c < shape.channels.size(); ++c) {
      if (c == alpha_channel && !shape.has_alpha) continue;
      const auto from = band.row(c, y);
      for (std::size_t x = 0; x < width; ++x) row[x * stride + k] = from[x];
      ++k;
    }
  });
}

/// Calls `take` with band after band.
CompositeReport run(Job& job, const CompositeSettings& settings, BandPool& pool,
                    const std::function<void(const Band&)>& take) {
  CompositeReport report{.data = job.header.data};
  const Window& data = job.header.data;
  try {
    for (int y = 0; y < data.height; y += job.band_rows) {
      const Window region{data.x, data.y + y, data.width, std::min(job.band_rows, data.height - y)};
      Band band = job.root->pull(region, pool);
      take(band);
      pool.give(std::move(band));
      ++report.bands;
      if (settings.progress) settings.progress(static_cast<double>(y + region.height) / data.height);
    }
  } catch (const Stopped&) {
    report.stopped = true;
  }
  report.bytes_in_bands = pool.peak() * sizeof(float);
  return report;
}

}  // namespace

CompositeReport composite_to_files(const Expression& expression, const std::vector<std::filesystem::path>& outputs,
                                   const WriteOptions& options, const CompositeSettings& settings) {
  Pictures pictures;
  const bool extras = std::any_of(outputs.begin(), outputs.end(), [](const auto& path) { return writes_exr(path); });
  Job job = prepare(expression, extras, pictures, settings);
  std::vector<ImageWriter> writers;
  for (const std::filesystem::path& path : outputs) writers.emplace_back(path, job.header, options);
  BandPool pool(settings.stop);
  const CompositeReport report = run(job, settings, pool, [&](const Band& band) {
    Band rows = pool.take(band.window(), job.header.channels.size());
    interleave(job.root->shape(), band, rows.pixels());
    for (ImageWriter& writer : writers) writer.write(rows.pixels());
    pool.give(std::move(rows));
  });
  if (report.stopped) return report;
  for (ImageWriter& writer : writers) writer.close();
  return report;
}

Image composite(const Expression& expression, Pictures& pictures, const CompositeSettings& settings) {
  Job job = prepare(expression, true, pictures, settings);
  Image image(job.header.data.width, job.header.data.height, job.header.channels);
  image.place({job.header.data.x, job.header.data.y}, job.header.display);
  image.metadata = job.header.metadata;
  image.attributes = job.header.attributes;
  BandPool pool(settings.stop);
  run(job, settings, pool, [&](const Band& band) {
    const std::size_t first = static_cast<std::size_t>(band.window().y - job.header.data.y) * job.header.row_size();
    interleave(job.root->shape(), band, image.pixels().subspan(first));
  });
  return image;
}

}  // namespace lambert::composite

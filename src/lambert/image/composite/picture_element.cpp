#include "lambert/image/composite/elements.h"

#include "lambert/base/parallel.h"

#include <algorithm>
#include <utility>

namespace lambert::composite {
namespace {

class PictureElement final : public Element {
 public:
  PictureElement(Pictures& pictures, std::string file, const Wanted& wanted)
      : Element({}), pictures_(&pictures), file_(std::move(file)), header_(&pictures.header(file_)) {
    shape_.data = header_->data;
    shape_.display = header_->display;
    source_ = header_;
    const auto index = [&](std::string_view name) -> std::optional<std::size_t> {
      const auto found = std::find(header_->channels.begin(), header_->channels.end(), name);
      if (found == header_->channels.end()) return std::nullopt;
      return static_cast<std::size_t>(found - header_->channels.begin());
    };
    const bool coloured = index("R") || index("G") || index("B");
    for (const char* name : {"R", "G", "B"}) from_.push_back(index(coloured ? name : "Y"));
    from_.push_back(index("A"));
    shape_.has_alpha = from_[alpha_channel].has_value();
    for (std::size_t c = 0; c < header_->channels.size(); ++c) {
      const std::string& name = header_->channels[c];
      const bool main = name == "R" || name == "G" || name == "B" || name == "A" || (name == "Y" && !coloured);
      if (main || !wanted.has(name)) continue;
      shape_.channels.push_back(name);
      from_.push_back(c);
    }
  }

  Band pull(const Window& region, BandPool& pool) override {
    Band band = pool.take(region, shape_.channels.size());
    const Window inside = covered(shape_, region);
    if (!is_empty(inside)) {
      constexpr int at_once = 64;  // four blocks of ZIP, for as many threads
      const int room = std::min(at_once, header_->data.height);
      Band scratch = pool.take({0, 0, header_->data.width, room}, header_->channels.size());
      for (int y = inside.y; y < inside.y + inside.height;) {
        const int first = y - header_->data.y;
        const int end = std::min(header_->data.y + (first / at_once + 1) * at_once, inside.y + inside.height);
        const float* rows = pictures_->rows(file_, first, end - header_->data.y, scratch.pixels()).data();
        parallel_for(static_cast<std::size_t>(end - y), [&](std::size_t i) {
          unpack(rows + i * header_->row_size(), inside, y + static_cast<int>(i), band);
        });
        y = end;
      }
      pool.give(std::move(scratch));
    }
    clear_outside(shape_, band);
    return band;
  }

 private:
  void unpack(const float* row, const Window& inside, int y, Band& band) const {
    const std::size_t stride = header_->channels.size(), n = static_cast<std::size_t>(inside.width);
    const float* pixels = row + static_cast<std::size_t>(inside.x - header_->data.x) * stride;
    const auto target = [&](std::size_t c) {
      return band.row(c, y).subspan(static_cast<std::size_t>(inside.x - band.window().x), n);
    };
    if (stride == 4 && from_ == std::vector<std::optional<std::size_t>>{0, 1, 2, 3}) {
      float *__restrict r = target(0).data(), *__restrict g = target(1).data(), *__restrict b = target(2).data(),
            *__restrict a = target(3).data();
      for (std::size_t x = 0; x < n; ++x)
        r[x] = pixels[4 * x], g[x] = pixels[4 * x + 1], b[x] = pixels[4 * x + 2], a[x] = pixels[4 * x + 3];
      return;
    }
    for (std::size_t c = 0; c < from_.size(); ++c) {
      const auto to = target(c);
      if (!from_[c]) {
        std::ranges::fill(to, c == alpha_channel ? 1.0f : 0.0f);
        continue;
      }
      const float* at = pixels + *from_[c];
      for (std::size_t x = 0; x < n; ++x) to[x] = at[x * stride];
    }
  }

  Pictures* pictures_;
  std::string file_;
  const ImageHeader* header_;
  std::vector<std::optional<std::size_t>> from_;  // the file's channel for each of the element's
};

}  // namespace

bool Wanted::has(std::string_view name) const {
  return all || std::find(names.begin(), names.end(), name) != names.end();
}

ElementPtr picture(Pictures& pictures, const std::string& file, const Wanted& wanted) {
  return std::make_unique<PictureElement>(pictures, file, wanted);
}

}  // namespace lambert::composite

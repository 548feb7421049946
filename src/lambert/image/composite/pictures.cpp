#include "lambert/image/composite/pictures.h"

#include "lambert/base/error.h"
#include "lambert/base/file.h"
#include "lambert/image/formats/codecs.h"

#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

namespace lambert::composite {
namespace {

std::size_t bytes_of(const ImageHeader& h) {
  return h.row_size() * static_cast<std::size_t>(h.data.height) * sizeof(float);
}

[[noreturn]] void spool_error(const char* what) {
  throw Error(std::string("temporary file: ") + what + ": " + std::strerror(errno));
}

/// All of it, or an Error.
void read_all(int descriptor, std::span<float> to, std::uint64_t offset) {
  char* at = reinterpret_cast<char*>(to.data());
  for (std::size_t left = to.size_bytes(); left > 0;) {
    const ssize_t count = ::pread(descriptor, at, left, static_cast<off_t>(offset));
    if (count <= 0) spool_error("cannot be read");
    at += count, left -= static_cast<std::size_t>(count), offset += static_cast<std::uint64_t>(count);
  }
}

}  // namespace

void Pictures::add(const std::string& name, Image image) {
  Entry& entry = entries_[name];
  entry = {};
  entry.header = header_of(image);
  entry.whole = std::move(image);
}

const ImageHeader& Pictures::header(const std::string& file) {
  const auto found = entries_.find(file);
  return found != entries_.end() ? found->second.header : open(file).header;
}

bool Pictures::any_in_bands() const {
  return std::ranges::any_of(entries_, [](const auto& e) { return !e.second.whole; });
}

std::span<const float> Pictures::rows(const std::string& file, int y0, int y1, std::span<float> scratch) {
  Entry& entry = open(file);
  const std::size_t row = entry.header.row_size(), first = static_cast<std::size_t>(y0) * row,
                    count = static_cast<std::size_t>(y1 - y0) * row;
  if (entry.whole) return std::as_const(*entry.whole).pixels().subspan(first, count);
  const std::span<float> to = scratch.first(count);
  if (entry.reader)
    entry.reader->read(y0, y1, to);
  else
    read_all(::fileno(entry.spool.get()), to, first * sizeof(float));
  return to;
}

Pictures::Entry& Pictures::open(const std::string& file) {
  Entry& entry = entries_[file];
  entry.used = ++clock_;
  if (entry.reader || entry.whole || entry.spool) return entry;
  try {
    if (is_exr(open_input(file).bytes())) {
      entry.reader = std::make_unique<ImageReader>(file);
      entry.header = entry.reader->header();
    } else {
      entry.whole = read_image(file);
      entry.header = header_of(*entry.whole);
    }
  } catch (...) {
    entries_.erase(file);
    throw;
  }
  if (entry.reader)
    close_oldest(entry);
  else if (kept_ + bytes_of(entry.header) > most_kept_)
    spool(entry);
  else
    kept_ += bytes_of(entry.header);
  return entry;
}

void Pictures::close_oldest(const Entry& but) {
  std::size_t open = 0;
  Entry* oldest = nullptr;
  for (auto& [name, entry] : entries_) {
    if (!entry.reader) continue;
    ++open;
    if (&entry != &but && (!oldest || entry.used < oldest->used)) oldest = &entry;
  }
  if (open > most_open_ && oldest) oldest->reader.reset();
}

void Pictures::spool(Entry& entry) {
  entry.spool = std::shared_ptr<std::FILE>(std::tmpfile(), [](std::FILE* f) {
    if (f) std::fclose(f);
  });
  if (!entry.spool) spool_error("cannot be made");
  const std::span<const float> pixels = entry.whole->pixels();
  if (std::fwrite(pixels.data(), sizeof(float), pixels.size(), entry.spool.get()) != pixels.size() ||
      std::fflush(entry.spool.get()) != 0)
    spool_error("cannot be written");
  entry.whole.reset();
}

}  // namespace lambert::composite

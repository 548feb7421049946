#include "lambert/base/file.h"

#include "lambert/base/error.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <utility>

namespace lambert {
namespace fs = std::filesystem;

MappedFile::MappedFile(const fs::path& path) {
  const auto fail = [&](const std::string& why) { throw Error(path.string() + ": " + why); };
  const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (fd < 0) fail(std::string("cannot open: ") + std::strerror(errno));
  struct stat info {};
  if (::fstat(fd, &info) != 0 || !S_ISREG(info.st_mode)) {
    ::close(fd);
    fail("not a regular file");
  }
  size_ = static_cast<std::size_t>(info.st_size);
  void* mapped = size_ ? ::mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, fd, 0) : nullptr;
  const int reason = errno;
  ::close(fd);
  if (mapped == MAP_FAILED) fail(std::string("cannot map: ") + std::strerror(reason));
  data_ = static_cast<const std::byte*>(mapped);
}

MappedFile::~MappedFile() {
  if (data_) ::munmap(const_cast<std::byte*>(data_), size_);
}

MappedFile::MappedFile(MappedFile&& other) noexcept
    : data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0)) {}

void write_atomically(const fs::path& path, const std::function<void(const fs::path&)>& write) {
  // Same folder, so that the rename stays on one file system; same extension, since some writers choose by it.
  const fs::path temporary = path.parent_path() / ("." + path.stem().string() + "." + std::to_string(::getpid()) +
                                                   ".tmp" + path.extension().string());
  std::error_code ignored;
  try {
    write(temporary);
    fs::rename(temporary, path);
  } catch (const fs::filesystem_error& e) {
    fs::remove(temporary, ignored);
    throw Error(path.string() + ": cannot write: " + e.code().message());
  } catch (...) {
    fs::remove(temporary, ignored);
    throw;
  }
}

void write_atomically(const fs::path& path, std::span<const std::byte> bytes) {
  write_atomically(path, [&](const fs::path& temporary) {
    std::ofstream out(temporary, std::ios::binary);
    out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (!out.flush()) throw Error(path.string() + ": cannot write: " + std::strerror(errno));
  });
}

void write_atomically(const fs::path& path, std::string_view text) {
  write_atomically(path, std::as_bytes(std::span(text.data(), text.size())));
}

}  // namespace lambert

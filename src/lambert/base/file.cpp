#include "lambert/base/file.h"

#include "lambert/base/error.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
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

namespace {

[[noreturn]] void cannot_write(const fs::path& path, const std::string& why) {
  throw Error(path.string() + ": cannot write: " + why);
}

/// The file that a write to `path` means: links are followed, even to a file that is not there yet. Throws Error naming
/// `path` when that cannot be a regular file.
fs::path regular_target(const fs::path& path) {
  constexpr int most_links = 40;  // as Linux follows
  std::error_code problem;
  fs::path target = path;
  for (int links = 0; fs::is_symlink(fs::symlink_status(target, problem)); ++links) {
    if (links == most_links) cannot_write(path, "too many symbolic links");
    const fs::path next = fs::read_symlink(target, problem);
    if (problem) cannot_write(path, problem.message());
    target = target.parent_path() / next;
  }
  const fs::file_status status = fs::status(target, problem);
  if (status.type() == fs::file_type::none) cannot_write(path, problem.message());
  if (fs::is_directory(status)) cannot_write(path, "it is a folder");
  if (fs::exists(status) && !fs::is_regular_file(status)) cannot_write(path, "it is not a regular file");
  const fs::path folder = fs::absolute(target).parent_path();
  if (!fs::is_directory(folder, problem)) cannot_write(path, "there is no folder " + folder.string());
  return target;
}

/// In the same folder, so that the rename stays on one file system; short, since the name of `target` may be as long as
/// names can be.
fs::path temporary_beside(const fs::path& target) {
  static std::atomic<unsigned> count{0};
  return target.parent_path() / (".lambert-" + std::to_string(::getpid()) + "-" + std::to_string(count++) + ".tmp");
}

}  // namespace

void check_writable(const fs::path& path) {
  const fs::path temporary = temporary_beside(regular_target(path));
  // No look at permission bits answers for read-only file systems and for root.
  const int fd = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (fd < 0) cannot_write(path, std::strerror(errno));
  ::close(fd);
  std::error_code ignored;
  fs::remove(temporary, ignored);
}

AtomicFile::AtomicFile(const fs::path& path)
    : path_(path), target_(regular_target(path)), temporary_(temporary_beside(target_)) {}

AtomicFile::~AtomicFile() {
  std::error_code ignored;
  if (!temporary_.empty()) fs::remove(temporary_, ignored);
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : path_(std::move(other.path_)),
      target_(std::move(other.target_)),
      temporary_(std::exchange(other.temporary_, fs::path())) {}

void AtomicFile::commit() {
  std::error_code problem;
  fs::rename(temporary_, target_, problem);
  if (problem) cannot_write(path_, problem.message());
  temporary_.clear();
}

void write_atomically(const fs::path& path, const std::function<void(const fs::path&)>& write) {
  AtomicFile file(path);
  try {
    write(file.temporary());
  } catch (const fs::filesystem_error& e) {
    cannot_write(path, e.code().message());
  }
  file.commit();
}

void write_atomically(const fs::path& path, std::span<const std::byte> bytes) {
  write_atomically(path, [&](const fs::path& temporary) {
    std::ofstream out(temporary, std::ios::binary);
    out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (!out.flush()) cannot_write(path, std::strerror(errno));
  });
}

void write_atomically(const fs::path& path, std::string_view text) {
  write_atomically(path, std::as_bytes(std::span(text.data(), text.size())));
}

}  // namespace lambert

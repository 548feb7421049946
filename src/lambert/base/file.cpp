#include "lambert/base/file.h"

#include "lambert/base/error.h"
#include "lambert/base/standard_streams.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <mutex>
#include <set>
#include <utility>
#include <vector>

namespace lambert {
namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const std::string& name, const std::string& what) {
  throw Error(name + ": " + what + ": " + std::strerror(errno));
}

/// An open file, closed with the object.
class Descriptor {
 public:
  explicit Descriptor(int descriptor) : value_(descriptor) {}
  ~Descriptor() {
    if (value_ >= 0) ::close(value_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  operator int() const { return value_; }

 private:
  int value_;
};

}  // namespace

MappedFile::MappedFile(const fs::path& path) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file < 0) fail(path.string(), "cannot open");
  map(file, path.string());
}

void MappedFile::map(int descriptor, const std::string& name) {
  struct stat info {};
  if (::fstat(descriptor, &info) != 0 || !S_ISREG(info.st_mode)) throw Error(name + ": not a regular file");
  size_ = static_cast<std::size_t>(info.st_size);
  void* mapped = size_ ? ::mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, descriptor, 0) : nullptr;
  if (mapped == MAP_FAILED) fail(name, "cannot map");
  data_ = static_cast<const std::byte*>(mapped);
}

MappedFile::~MappedFile() {
  if (data_) ::munmap(const_cast<std::byte*>(data_), size_);
}

MappedFile::MappedFile(MappedFile&& other) noexcept
    : data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0)) {}

namespace {

[[noreturn]] void cannot_write(const fs::path& path, const std::string& why) {
  throw Error(output_name(path) + ": cannot write: " + why);
}

/// The file that a write to `path` means: links are followed, even to a file that is not there yet. Throws Error naming
/// `path` when that cannot be a regular file.
fs::path regular_target(const fs::path& path) {
  if (is_standard_stream(path)) return path;
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

/// A name of its own in `folder`; short, since that of what it becomes may be as long as names can be.
fs::path temporary_in(const fs::path& folder) {
  static std::atomic<unsigned> count{0};
  return folder / (".lambert-" + std::to_string(::getpid()) + "-" + std::to_string(count++) + ".tmp");
}

/// Where what becomes `path` is written: in the same folder, so that the rename stays on one file system.
fs::path temporary_for(const fs::path& path, const fs::path& target) {
  if (!is_standard_stream(path)) return temporary_in(target.parent_path());
  std::error_code problem;
  const fs::path folder = fs::temp_directory_path(problem);
  if (problem) cannot_write(path, "no folder for temporary files: " + problem.message());
  return temporary_in(folder);
}

/// All of `from`, from where it stands.
void copy(int from, const std::string& from_name, int to, const std::string& to_name, std::uint64_t most) {
  std::vector<char> block(std::size_t{1} << 18);
  for (std::uint64_t total = 0;;) {
    const ssize_t count = ::read(from, block.data(), block.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(from_name, "cannot read");
    if (count == 0) return;
    total += static_cast<std::uint64_t>(count);
    if (total > most) throw Error(from_name + ": more than " + std::to_string(most >> 30) + " GB");
    for (ssize_t done = 0; done < count;) {
      const ssize_t written = ::write(to, block.data() + done, static_cast<std::size_t>(count - done));
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) fail(to_name, "cannot write");
      done += written;
    }
  }
}

/// Standard input where it is a file that nothing was read of, else a nameless file with all that it says.
int whole_standard_input() {
  struct stat info {};
  if (::fstat(STDIN_FILENO, &info) == 0 && S_ISREG(info.st_mode) && ::lseek(STDIN_FILENO, 0, SEEK_CUR) == 0)
    return STDIN_FILENO;
  std::error_code problem;
  const fs::path folder = fs::temp_directory_path(problem);
  if (problem) throw Error("standard input: cannot read: no folder for temporary files: " + problem.message());
  const fs::path path = temporary_in(folder);
  const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (file < 0) fail(path.string(), "cannot write");
  ::unlink(path.c_str());
  copy(STDIN_FILENO, "standard input", file, path.string(), std::uint64_t{64} << 30);
  return file;
}

}  // namespace

namespace {

/// The temporaries of the process.
struct Unfinished {
  std::mutex mutex;
  std::set<fs::path> files;
  bool any_finished = false;
};
Unfinished& unfinished() {
  static Unfinished& all = *new Unfinished;  // a signal may come while statics are destroyed
  return all;
}

}  // namespace

bool abandon_files() {
  Unfinished& all = unfinished();
  all.mutex.lock();  // for good
  std::error_code ignored;
  for (const fs::path& file : all.files) fs::remove(file, ignored);
  return all.any_finished;
}

MappedFile open_input(const fs::path& path) {
  if (path != "-") return MappedFile(path);
  static const int input = whole_standard_input();  // open until the process ends
  MappedFile mapped;
  mapped.map(input, input_name(path));
  return mapped;
}

void check_writable(const fs::path& path) {
  const fs::path temporary = temporary_for(path, regular_target(path));
  // No look at permission bits answers for read-only file systems and for root.
  const int fd = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (fd < 0) cannot_write(path, std::strerror(errno));
  ::close(fd);
  std::error_code ignored;
  fs::remove(temporary, ignored);
}

AtomicFile::AtomicFile(const fs::path& path)
    : path_(path), target_(regular_target(path)), temporary_(temporary_for(path_, target_)) {
  const std::lock_guard lock(unfinished().mutex);
  unfinished().files.insert(temporary_);
}

AtomicFile::~AtomicFile() {
  if (temporary_.empty()) return;
  std::error_code ignored;
  fs::remove(temporary_, ignored);
  const std::lock_guard lock(unfinished().mutex);
  unfinished().files.erase(temporary_);
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : path_(std::move(other.path_)),
      target_(std::move(other.target_)),
      temporary_(std::exchange(other.temporary_, fs::path())) {}

void AtomicFile::commit() {
  std::unique_lock lock(unfinished().mutex);
  unfinished().files.erase(temporary_);
  unfinished().any_finished = true;
  if (is_standard_stream(path_)) {
    const Descriptor file(::open(temporary_.c_str(), O_RDONLY | O_CLOEXEC));
    if (file < 0) fail(temporary_.string(), "cannot open");
    ::unlink(std::exchange(temporary_, fs::path()).c_str());  // now, since a reader that goes away ends the process
    lock.unlock();
    return copy(file, output_name(path_), standard_output(), output_name(path_), ~std::uint64_t{0});
  }
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

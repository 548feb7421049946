#pragma once
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace lambert {

/// The bytes of a file, mapped read-only. A file that shrinks while mapped is the one thing this cannot survive.
class MappedFile {
 public:
  /// Throws Error naming the file when it cannot be opened or is not a regular file.
  explicit MappedFile(const std::filesystem::path& path);
  ~MappedFile();
  MappedFile(MappedFile&& other) noexcept;
  MappedFile& operator=(MappedFile&&) = delete;
  std::span<const std::byte> bytes() const { return {data_, size_}; }
  std::string_view text() const { return {reinterpret_cast<const char*>(data_), size_}; }

 private:
  friend MappedFile open_input(const std::filesystem::path& path);
  MappedFile() = default;
  void map(int descriptor, const std::string& name);
  const std::byte* data_ = nullptr;
  std::size_t size_ = 0;
};

/// What a user names as an input: a file, or standard input by "-". That is read to its end when it is first asked for,
/// into a nameless file of the folder for temporary ones unless it is a file already, and is the same each time. Throws
/// Error as MappedFile does, and when there are more than 64 GB of it.
MappedFile open_input(const std::filesystem::path& path);

/// A file that appears at `path` whole or not at all: it is written at temporary(), beside it, and renamed by commit();
/// without that the destructor removes it. A symbolic link stays, its target is written. Of standard output
/// (is_standard_stream()) the temporary lies in the folder for such files and is copied out by commit(). The
/// constructor and commit() throw Error naming `path` when it cannot be written, as when it is a folder or a device.
class AtomicFile {
 public:
  explicit AtomicFile(const std::filesystem::path& path);
  ~AtomicFile();
  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&&) = delete;
  const std::filesystem::path& temporary() const { return temporary_; }
  void commit();

 private:
  std::filesystem::path path_, target_, temporary_;
};

/// Writes `path` whole or not at all: `write` fills a temporary file beside it, which is then renamed over it. On an
/// exception the temporary is removed and `path` is untouched. Throws as AtomicFile does.
void write_atomically(const std::filesystem::path& path,
                      const std::function<void(const std::filesystem::path&)>& write);
void write_atomically(const std::filesystem::path& path, std::span<const std::byte> bytes);
void write_atomically(const std::filesystem::path& path, std::string_view text);

/// For a process that ends before its time, which it must do now: removes what AtomicFile has not committed, and lets
/// no other begin. True when some file was committed before.
bool abandon_files();

/// Throws the Error that write_atomically would, as far as that can be known before: a file is made beside `path` and
/// removed.
void check_writable(const std::filesystem::path& path);

}  // namespace lambert

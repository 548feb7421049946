#include "lambert/base/standard_streams.h"

#include "lambert/base/error.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>

namespace lambert {
namespace {

std::atomic<int> kept{-1};

}  // namespace

bool is_standard_stream(const std::filesystem::path& path) {
  const std::string& name = path.native();
  if (name == "-") return true;
  return name.size() > 2 && name.ends_with(":-") &&
         std::all_of(name.begin(), name.end() - 2, [](unsigned char c) { return std::isalnum(c); });
}

std::string format_extension(const std::filesystem::path& path) {
  const std::string& name = path.native();
  std::string extension = path.extension().native();
  if (is_standard_stream(path)) extension = name == "-" ? "" : "." + name.substr(0, name.size() - 2);
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

std::string input_name(const std::filesystem::path& path) { return path == "-" ? "standard input" : path.string(); }
std::string output_name(const std::filesystem::path& path) {
  return is_standard_stream(path) ? "standard output" : path.string();
}

void reserve_standard_output() {
  if (kept >= 0) throw Error("standard output takes one file, and two outputs name it");
  std::fflush(stdout);
  const int own = ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  if (own < 0 || ::dup2(STDERR_FILENO, STDOUT_FILENO) < 0)
    throw Error(std::string("standard output: cannot write: ") + std::strerror(errno));
  kept = own;
}

int standard_output() { return kept >= 0 ? kept.load() : STDOUT_FILENO; }

}  // namespace lambert

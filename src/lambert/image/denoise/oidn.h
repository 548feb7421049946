#pragma once
/// Open Image Denoise (openimagedenoise.org), where the user's machine has it. Its shared library is loaded at run time
/// through its C interface, versions 1 and 2; nothing of it is needed to build.

#include "lambert/image/denoise/plane.h"
#include "lambert/image/image.h"

#include <memory>
#include <string>

namespace lambert::denoise {

class Oidn {
 public:
  /// The library at `path`, or where the system's loader finds libOpenImageDenoise.so.2 or .1 when it is empty. Null
  /// where there is none, or none with the functions that are needed.
  static std::unique_ptr<Oidn> find(const std::string& path = {});
  /// The message for when find() returned null.
  static std::string not_found(const std::string& path = {});
  ~Oidn();
  Oidn(const Oidn&) = delete;

  /// "oidn" and the name of the library.
  std::string name() const;
  /// The colour of `image` filtered by the filter "RT" on the CPU, guided by albedo and normal where the image has both
  /// or albedo alone. Throws Error with the library's words when it fails.
  Colour denoise(const Image& image) const;

 private:
  struct Functions;
  explicit Oidn(std::unique_ptr<Functions> functions);
  std::unique_ptr<Functions> functions_;
};

}  // namespace lambert::denoise

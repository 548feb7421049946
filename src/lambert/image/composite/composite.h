#pragma once
/// Trees of pictures to pictures.

#include "lambert/image/composite/expression.h"
#include "lambert/image/composite/pictures.h"
#include "lambert/image/io.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace lambert::composite {

struct CompositeSettings {
  int frame = 1;
  /// What is shown, instead of what the pictures say; needed where all is generated.
  std::optional<Window> display;
  std::string name = "expression";       ///< of `text` in errors
  std::string_view text;                 ///< that the expression was read from
  std::function<void(double)> progress;  ///< gets the fraction done, after every band
  std::stop_token stop;                  ///< ends the work early
};

struct CompositeReport {
  Window data;
  int bands = 0;
  std::size_t bytes_in_bands = 0;  ///< the most at one time
  bool stopped = false;            ///< before the end: nothing was written
};

/// Evaluates the tree in bands of rows and writes each file as write_image() would. Memory: a number of bands that
/// grows with the logarithm of the tree's size; a band is 64 rows (16 where nothing is decoded on the way), or more
/// where blurs and edges look far. Extra channels are kept in .exr files, of full floats where an input has them and
/// the options leave the choice. Throws Error; no file is touched then.
CompositeReport composite_to_files(const Expression& expression, const std::vector<std::filesystem::path>& outputs,
                                   const WriteOptions& options = {}, const CompositeSettings& settings = {});

/// The same to an image with all channels; `pictures` may hold images in memory. What was not done when it was stopped
/// is 0.
Image composite(const Expression& expression, Pictures& pictures, const CompositeSettings& settings = {});

}  // namespace lambert::composite

#pragma once
#include "lambert/image/formats/codecs.h"
#include "lambert/image/stream.h"

#include <memory>
#include <string>

namespace lambert {

/// An OpenEXR file in memory (which must outlive this), decoded row by row. Its parts become one image on the smallest
/// window that holds theirs; channels of a part beyond the main one get its name and a point before theirs. Luminance
/// and chroma become R, G and B; other subsampled channels are repeated. Throws Error naming the file.
class ExrReader {
 public:
  ExrReader(Bytes data, const std::string& name);
  ~ExrReader();
  ExrReader(ExrReader&&) noexcept;

  const ImageHeader& header() const;
  /// Rows [y0, y1) from the data window's top into (y1 - y0) row_size() floats, all of which are set.
  void read(int y0, int y1, float* to);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace lambert

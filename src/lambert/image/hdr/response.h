#pragma once
/// The response of a camera: which exposure (radiance times relative_exposure()) stands behind a code. Scaled so that
/// the top code is exposure 1 in every channel: white stays white.

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace lambert::hdr {

struct Response {
  std::string name;  ///< "srgb", "gamma 2.2", "recovered", a file's name
  /// By channel, the exposure of each of the codes 0 … levels - 1: never falling, 0 or above, 1 at the top.
  std::vector<std::vector<float>> exposure;

  std::size_t levels() const { return exposure.front().size(); }
  const std::vector<float>& channel(std::size_t c) const { return exposure[c < exposure.size() ? c : 0]; }
};

/// Names that response_named() knows besides files: "srgb", "linear", "gamma N" (also "gammaN"), "film", "log".
std::vector<std::string> response_names();

/// One of the names above for `channels` channels of `levels` codes, or the response in a CSV file. film: the
/// characteristic curve x^0.9 / (x^0.9 + s) (Naka and Rushton 1966) with s of its own in each channel; log:
/// ln(1 + 1000 x) / ln 1001. Throws Error for an unknown word or an unusable file.
Response response_named(const std::string& word, std::size_t channels, std::size_t levels);

/// Rows of two or four numbers: exposure in [0,1] and the pixel value in [0,1] that it gives in each channel (the first
/// column climbs to 1), or code and the exposure behind it (the first column climbs to above 1). "#" begins a comment.
Response read_response(const std::filesystem::path& path, std::size_t channels, std::size_t levels);

enum class ResponseTable { by_exposure, by_code };
/// The text of such a file. By exposure the rows are k/256 and, below 1/16, 16 to a stop down to 2^-16.
std::string response_csv(const Response& response, ResponseTable table);

/// The code, as a real number in [0, levels - 1], that `exposure` gives; 0 for NaN.
double encode(const std::vector<float>& channel, double exposure);
/// The exposure behind a code that need not be whole.
double decode(const std::vector<float>& channel, double code);

}  // namespace lambert::hdr

#pragma once
/// How long, how wide open and how sensitive: what a photograph's exposure was.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace lambert::hdr {

/// 0 stands for "not known".
struct ExposureSetting {
  double time = 0;      ///< seconds
  double f_number = 0;  ///< focal length over the diameter of the pupil
  double iso = 0;       ///< speed; 100 where not known
  double density = 0;   ///< of a neutral filter before the lens, as a logarithm to base 10
};

struct ListedExposure {
  std::filesystem::path file;  ///< relative names are those beside the list
  ExposureSetting setting;
};

/// The exposure that a scene of radiance 1 gives, up to the camera's constant: t (ISO / 100) / N² 10^-density, with
/// N = 1 where the f-number is not known; the time alone where nothing else is.
double relative_exposure(const ExposureSetting& setting);

/// "1/60", "0.5" or "2.5s" in seconds, above 0. Throws Error "what: …".
double parse_exposure_time(std::string_view word, const std::string& what);

/// One photograph a line: file, time and, if they are known, f-number and ISO; "#" begins a comment. Of a name that
/// ends in .hdrgen the lines are those of pfstools: file, 1/time, f-number, ISO, density. Throws Error with file and
/// line.
std::vector<ListedExposure> read_exposure_list(const std::filesystem::path& path);

/// The exposures of all photographs. Throws Error, naming the file at fault, where a time is missing or some
/// photographs have an f-number (or a speed) and others have none.
std::vector<double> relative_exposures(const std::vector<std::string>& names,
                                       const std::vector<ExposureSetting>& settings);

}  // namespace lambert::hdr

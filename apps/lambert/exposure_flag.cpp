#include "exposure_flag.h"

#include "lambert/base/error.h"
#include "lambert/base/number.h"

#include <cmath>
#include <string_view>

namespace lambert::cli {

void set_exposure(ToneSettings& settings, const std::string& text, const AutoExposure& automatic) {
  std::string_view stops = text;
  const bool by_itself = stops.starts_with("auto");
  if (by_itself) stops.remove_prefix(4);
  float value = 0;
  const bool signed_well = !by_itself || stops.empty() || stops.front() == '+' || stops.front() == '-';
  const bool read = (by_itself && stops.empty()) ||
                    parse_float(stops.data(), stops.data() + stops.size(), value) == stops.data() + stops.size();
  if (!signed_well || !read || !(std::abs(value) <= 100))
    throw Error(
        "--exposure: expected a number of stops between -100 and 100, auto, or auto with stops (auto+1), got '" +
        printable(text) + "'");
  settings.exposure = value;
  if (by_itself) settings.automatic = automatic;
}

}  // namespace lambert::cli

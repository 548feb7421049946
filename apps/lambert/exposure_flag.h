#pragma once
#include "lambert/image/tonemap/tonemap.h"

#include <string>

namespace lambert::cli {

/// What --exposure says: stops ("-1.5"), "auto", or auto with stops added ("auto+1", "auto-0.5"). `automatic` is how it
/// is found. Throws Error naming the flag and the word.
void set_exposure(ToneSettings& settings, const std::string& text, const AutoExposure& automatic = {});

}  // namespace lambert::cli

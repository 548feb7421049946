#include "lambert/image/tonemap/ocio_module.h"

#include <OpenColorIO/OpenColorIO.h>

#include <cstring>
#include <exception>
#include <string>

namespace {

namespace OCIO = OCIO_NAMESPACE;

std::string joined(const std::string& all, const char* name) { return all.empty() ? name : all + ", " + name; }

/// OpenColorIO's own message for an unknown name does not say which ones there are.
void check(const OCIO::ConstConfigRcPtr& config, const std::string& display, const std::string& view) {
  std::string known;
  for (int i = 0; i < config->getNumDisplays(); ++i) {
    if (display == config->getDisplay(i)) break;
    known = joined(known, config->getDisplay(i));
    if (i + 1 == config->getNumDisplays())
      throw OCIO::Exception(("unknown display '" + display + "' (known: " + known + ")").c_str());
  }
  known.clear();
  for (int i = 0; i < config->getNumViews(display.c_str()); ++i) {
    if (view == config->getView(display.c_str(), i)) return;
    known = joined(known, config->getView(display.c_str(), i));
  }
  throw OCIO::Exception(("display '" + display + "' has no view '" + view + "' (known: " + known + ")").c_str());
}

void apply(const LambertOcioTransform& t, float* rgb, long width, long height) {
  const OCIO::ConstConfigRcPtr config = OCIO::GetCurrentConfig();
  const std::string display = *t.display ? t.display : config->getDefaultDisplay();
  const std::string view = *t.view ? t.view : config->getDefaultView(display.c_str());
  check(config, display, view);
  const auto transform = OCIO::DisplayViewTransform::Create();
  transform->setSrc(*t.input ? t.input : OCIO::ROLE_SCENE_LINEAR);
  transform->setDisplay(display.c_str());
  transform->setView(view.c_str());
  OCIO::PackedImageDesc image(rgb, width, height, 3);
  config->getProcessor(transform)->getDefaultCPUProcessor()->apply(image);
}

}  // namespace

int lambert_ocio_apply(const LambertOcioTransform* transform, float* rgb, long width, long height, char* error,
                       unsigned long error_size) {
  try {
    apply(*transform, rgb, width, height);
    return 0;
  } catch (const std::exception& e) {
    std::strncpy(error, e.what(), error_size - 1);
    error[error_size - 1] = '\0';
    return 1;
  }
}

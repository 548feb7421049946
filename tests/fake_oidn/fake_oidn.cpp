// Halves the colour, and remembers what it was asked to do. Refuses images of width 13.
#include <cstddef>
#include <map>
#include <string>

namespace {

struct Picture {
  float* pixels = nullptr;
  std::size_t width = 0, height = 0;
};
std::string calls;
std::map<std::string, Picture> pictures;
bool failed = false;

}  // namespace

extern "C" {

void* oidnNewDevice(int type) {
  calls = "device " + std::to_string(type);
  pictures.clear();
  failed = false;
  return &calls;
}
void oidnCommitDevice(void*) { calls += ", commit"; }
int oidnGetDeviceError(void*, const char** message) {
  *message = failed ? "thirteen is unlucky" : nullptr;
  return failed ? 2 : 0;
}
void oidnReleaseDevice(void*) { calls += ", release device"; }
void* oidnNewFilter(void*, const char* type) {
  calls += std::string(", filter ") + type;
  return &pictures;
}
void oidnSetSharedFilterImage(void*, const char* name, void* pixels, int format, std::size_t width, std::size_t height,
                              std::size_t, std::size_t, std::size_t) {
  calls += std::string(", ") + name + " " + std::to_string(format);
  pictures[name] = {static_cast<float*>(pixels), width, height};
}
void oidnSetFilterBool(void*, const char* name, bool value) {
  calls += std::string(", ") + name + (value ? " on" : " off");
}
void oidnCommitFilter(void*) { calls += ", commit"; }
void oidnExecuteFilter(void*) {
  calls += ", execute";
  const Picture from = pictures["color"], to = pictures["output"];
  failed = from.width == 13;
  for (std::size_t i = 0; i < 3 * from.width * from.height; ++i) to.pixels[i] = 0.5f * from.pixels[i];
}
void oidnReleaseFilter(void*) { calls += ", release filter"; }

const char* fake_oidn_calls() { return calls.c_str(); }
}

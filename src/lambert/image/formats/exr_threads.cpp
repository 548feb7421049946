#include "lambert/image/formats/exr_threads.h"

#include "lambert/base/parallel.h"

#include <ImfThreading.h>

#include <algorithm>

namespace lambert {

int exr_threads() {
  static const int pool = [] {
    const int threads = static_cast<int>(std::min<std::size_t>(thread_count(), 64));
    Imf::setGlobalThreadCount(threads > 1 ? threads : 0);
    return std::max(threads, 1);
  }();
  return std::min(pool, static_cast<int>(std::min<std::size_t>(thread_count(), 64)));
}

}  // namespace lambert

#include "lambert/base/progress.h"

#include "lambert/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <mutex>

namespace lambert {

FractionSink part_of(const FractionSink& whole, double begin, double end) {
  if (!whole) return {};
  return [whole, begin, end](double fraction) { whole(std::lerp(begin, end, fraction)); };
}

void parallel_for(std::size_t count, const FractionSink& progress, const std::function<void(std::size_t)>& body) {
  if (!progress) return parallel_for(count, body);
  const std::size_t step = std::max<std::size_t>(1, count / 100);
  std::mutex mutex;
  std::size_t done = 0;
  parallel_for(count, [&](std::size_t i) {
    body(i);
    const std::lock_guard lock(mutex);
    if (++done % step == 0 || done == count) progress(static_cast<double>(done) / static_cast<double>(count));
  });
}

}  // namespace lambert

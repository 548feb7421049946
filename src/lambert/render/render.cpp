#include "lambert/render/render.h"

#include "lambert/base/error.h"
#include "lambert/base/hash.h"
#include "lambert/render/adaptive.h"
#include "lambert/render/pass.h"

#include <algorithm>
#include <chrono>
#include <mutex>

namespace lambert {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Progress, limits and counts of one call of render().
class Run {
 public:
  Run(const RenderSettings& settings, const ProgressSink& progress, std::stop_token stop, std::uint64_t planned)
      : settings_(settings), progress_(progress), stop_(std::move(stop)), planned_(planned) {}

  std::atomic<std::uint64_t> samples{0}, rays{0};

  /// Asked by all threads, often.
  bool keep_going() {
    report(false);
    return !stopped();
  }
  /// In the first pass, which leaves no pixel black however short the time.
  bool keep_going_without_limit() {
    report(false);
    return !interrupted();
  }
  bool stopped() const { return interrupted() || out_of_time(); }
  bool interrupted() const { return stop_.stop_requested(); }
  bool out_of_time() const { return settings_.time_limit_seconds > 0 && elapsed() >= settings_.time_limit_seconds; }
  double elapsed() const { return seconds_since(start_); }
  void plan(std::uint64_t samples_in_all) { planned_ = samples_in_all; }

  void report(bool last) {
    if (!progress_) return;
    const std::unique_lock lock(reporting_, std::try_to_lock);
    const double now = elapsed();
    if (!lock || (!last && now < next_report_)) return;
    next_report_ = now + 0.1;
    Progress p;
    p.elapsed_seconds = now;
    p.samples = static_cast<double>(samples.load()), p.rays = static_cast<double>(rays.load());
    p.samples_per_second = p.samples / std::max(now, 1e-9), p.rays_per_second = p.rays / std::max(now, 1e-9);
    p.fraction = planned_ ? std::min(1.0, p.samples / static_cast<double>(planned_)) : 0;
    p.remaining_seconds = p.samples > 0 ? (static_cast<double>(planned_) - p.samples) / p.samples_per_second : 0;
    if (const double limit = settings_.time_limit_seconds; limit > 0) {
      p.fraction = std::max(p.fraction, std::min(1.0, now / limit));
      p.remaining_seconds = std::min(p.samples > 0 ? p.remaining_seconds : limit, std::max(0.0, limit - now));
    }
    p.remaining_seconds = std::max(0.0, p.remaining_seconds);
    if (last && !stopped()) p.fraction = 1, p.remaining_seconds = 0;
    progress_(p);
  }

 private:
  const RenderSettings& settings_;
  const ProgressSink& progress_;
  std::stop_token stop_;
  std::uint64_t planned_;
  Clock::time_point start_ = Clock::now();
  std::mutex reporting_;
  double next_report_ = 0;
};

/// Samples per pixel after the pass that follows `done`: first one everywhere, then passes long enough to be efficient.
std::uint32_t next_target(std::uint32_t done, std::uint32_t in_all, int pass_size) {
  const std::uint32_t efficient = pass_size > 0 ? static_cast<std::uint32_t>(pass_size) : std::clamp(done, 1u, 16u);
  const std::uint32_t step = done == 0 ? 1 : efficient;
  return done + std::min(step, in_all - done);
}

PixelRect checked_crop(const RenderSettings& settings, Vec2i resolution) {
  const PixelRect whole{{0, 0}, resolution};
  if (resolution.x <= 0 || resolution.y <= 0) throw Error("the resolution must be positive");
  if (!settings.crop) return whole;
  const PixelRect& c = *settings.crop;
  if (c.min.x < 0 || c.min.y < 0 || c.max.x > resolution.x || c.max.y > resolution.y || c.size().x <= 0 ||
      c.size().y <= 0)
    throw Error("the crop window must be a non-empty part of the image (" + std::to_string(resolution.x) + "x" +
                std::to_string(resolution.y) + ")");
  return c;
}

SamplerSettings sampler_settings(const RenderSettings& s, Vec2i resolution, std::uint64_t seed) {
  // With a time limit nobody knows how many samples there will be: strata and sequences come in rounds.
  const int round = s.time_limit_seconds > 0 ? std::min(s.samples_per_pixel, 256) : s.samples_per_pixel;
  return {s.sampler, static_cast<std::uint32_t>(round), seed, resolution};
}

/// Passes of equal sample counts over all pixels.
Film render_uniform(PassContext context, Film film, const RenderSettings& settings, Run& run, double& first_seconds) {
  const auto in_all = static_cast<std::uint32_t>(settings.samples_per_pixel);
  for (std::uint32_t done = 0; done < in_all && !(done == 0 ? run.interrupted() : run.stopped());) {
    const std::uint32_t target = next_target(done, in_all, settings.pass_size);
    sample_tiles(
        context, film, [&](Vec2i) { return target; },
        [&] { return done == 0 ? run.keep_going_without_limit() : run.keep_going(); });
    if (done == 0) first_seconds = run.elapsed();
    done = target;
  }
  return film;
}

/// Two independent halves; how many samples each half takes is decided by the other's pilot samples alone (see
/// adaptive.h).
Film render_adaptive(PassContext context, const Film& empty, const RenderSettings& settings, Run& run,
                     double& first_seconds) {
  Film a = empty, b = empty;
  PassContext context_b = context;
  context_b.sampler.seed = mix_bits(context.sampler.seed ^ 0x68616c66ull);
  const auto half = static_cast<std::uint32_t>(std::max(1, settings.samples_per_pixel / 2));
  const std::uint32_t pilot = std::min(half, pilot_samples);
  bool first = true;
  const auto go = [&] { return first ? run.keep_going_without_limit() : run.keep_going(); };
  const auto both = [&](std::uint32_t limit, const SampleMap* map_a, const SampleMap* map_b) {
    sample_tiles(
        context, a, [&](Vec2i p) { return map_a ? std::min(limit, map_a->at(p)) : limit; }, go);
    sample_tiles(
        context_b, b, [&](Vec2i p) { return map_b ? std::min(limit, map_b->at(p)) : limit; }, go);
  };
  both(1, nullptr, nullptr);
  first = false;
  first_seconds = run.elapsed();
  both(pilot, nullptr, nullptr);
  if (run.stopped()) return Film::average(a, b);

  const SampleMap map_a = plan_samples(b, settings.target_error, pilot, half);
  const SampleMap map_b = plan_samples(a, settings.target_error, pilot, half);
  run.plan(map_a.total() + map_b.total());
  for (std::uint32_t done = pilot; done < half && !run.stopped();) {
    const std::uint32_t target = next_target(done, half, settings.pass_size);
    both(target, &map_a, &map_b);
    done = target;
  }
  return Film::average(a, b);
}

}  // namespace

RenderResult render(const Scene& scene, const Camera& camera, Method& method, const RenderSettings& settings,
                    const ProgressSink& progress, std::stop_token stop) {
  if (settings.samples_per_pixel < 1) throw Error("samples per pixel must be at least 1");
  if (!(settings.target_error >= 0 && settings.time_limit_seconds >= 0))
    throw Error("limits of error and time must be numbers of at least 0");
  if (settings.target_error > 0 && settings.samples_per_pixel < 2)
    throw Error("a target error needs at least 2 samples per pixel, to judge by their difference");
  const PixelRect crop = checked_crop(settings, camera.resolution);
  Film film(camera.resolution, crop, settings.aovs);
  if (settings.time_limit_seconds == 0)
    film.split_halves_at(static_cast<std::uint32_t>(settings.samples_per_pixel) / 2);
  const FilterSampler filter(settings.filter);
  method.prepare(scene);

  Run run(settings, progress, std::move(stop), crop.area() * static_cast<std::uint64_t>(settings.samples_per_pixel));
  const PassContext context{camera,      method,  filter, sampler_settings(settings, camera.resolution, settings.seed),
                            run.samples, run.rays};
  RenderStatistics statistics;
  film = settings.target_error > 0
             ? render_adaptive(context, film, settings, run, statistics.first_sample_seconds)
             : render_uniform(context, std::move(film), settings, run, statistics.first_sample_seconds);
  if (film.keeps_denoising()) refine_emission(context, film, [&] { return run.keep_going_without_limit(); });
  run.report(true);
  statistics.seconds = run.elapsed();
  statistics.samples = run.samples, statistics.rays = run.rays;
  statistics.interrupted = run.interrupted();
  return {std::move(film), statistics};
}

}  // namespace lambert
